#pragma once

#include "flow/method.hpp"
#include "flow/warnings.hpp"
#include "vortex/settings.hpp"

namespace vortree::vortex {

/// The vortex method as scenes name it, with its tables [diffusion], [cores], [splitting],
/// [merging] and [velocity].
class VortexMethod final : public flow::Method {
 public:
  std::unique_ptr<flow::Method> clone() const override;
  std::unique_ptr<flow::Method> blank() const override { return std::make_unique<VortexMethod>(); }
  std::string_view name() const override { return "vortex"; }
  std::vector<SceneTable> tables() override { return vortex::tables(settings_); }
  void choose(flow::Case& of, const flow::Written& written) override;
  void refuse(const flow::Case& of) const override;
  void refuse_beyond(const flow::Case& of, double memory) const override;
  flow::Warnings warnings(const flow::Case& of) const override;
  std::unique_ptr<flow::Solver> begin(const flow::Case& of, double memory) const override;

  const VortexSettings& settings() const { return settings_; }

 private:
  VortexSettings settings_;
  bool cores_written_ = false;  // in the scene, whatever its accuracy would choose
};

}  // namespace vortree::vortex
