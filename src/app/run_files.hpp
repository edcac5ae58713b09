#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "app/flow_case.hpp"
#include "app/record.hpp"
#include "io/fields.hpp"
#include "io/frames.hpp"
#include "io/report.hpp"
#include "io/scene.hpp"

namespace vortree::app {

/// What a run writes into its folder on its way; cases/scenes.md says what the files hold. Scene
/// and flow are those of the run, which keeps them.
class RunFiles {
 public:
  RunFiles(const io::Scene& scene, const FlowCase& flow, std::filesystem::path folder);

  /// Starts them, in place of older ones.
  void begin();

  /// The frame to go on from; says on standard error what was lost behind it.
  /// throws  io::InputError if there is none, or if it was run with a scene that differs in more
  ///         than its end, [output] and [check]
  [[nodiscard]] io::Frame last_frame() const;

  /// Goes on behind that frame: what is later is dropped, since it will be made again.
  void resume(long step);

  void row(const Record& record);
  void frame(const io::Frame& frame);
  void field(const io::Field& field);
  /// One row for each panel.
  void wall(double time, std::span<const double> sheet, std::span<const double> vorticity);
  /// In free space; nothing for more than 20 000 blobs, since the sum is over all pairs.
  void energy(double time, const vortex::Blobs& blobs);

 private:
  const io::Scene& scene_;
  const FlowCase& flow_;
  std::filesystem::path folder_;
  std::optional<io::Report> report_, wall_, energy_;
};

}  // namespace vortree::app
