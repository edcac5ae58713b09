#pragma once

#include "flow/method.hpp"
#include "sph/settings.hpp"

namespace vortree::sph {

/// Incompressible SPH of variable resolution as scenes name it, with its tables [sph] and
/// [neighbors].
class SphMethod final : public flow::Method {
 public:
  std::unique_ptr<flow::Method> clone() const override {
    return std::make_unique<SphMethod>(*this);
  }
  std::unique_ptr<flow::Method> blank() const override { return std::make_unique<SphMethod>(); }
  std::string_view name() const override { return "sph"; }
  std::vector<SceneTable> tables() override {
    return {table("sph", settings_), table("neighbors", neighbors_)};
  }
  void choose(flow::Case& of, const flow::Written& written) override;
  void refuse(const flow::Case& of) const override;
  void refuse_beyond(const flow::Case& of, double memory) const override;
  flow::Warnings warnings(const flow::Case& of) const override;
  std::unique_ptr<flow::Solver> begin(const flow::Case& of, double memory) const override;

  const SphSettings& settings() const { return settings_; }

 private:
  SphSettings settings_;
  NeighborSettings neighbors_;
};

}  // namespace vortree::sph
