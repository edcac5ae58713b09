#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <map>
#include <memory>

#include "app/loop/rows.hpp"
#include "app/program.hpp"
#include "by_vortices.hpp"
#include "checks/checks.hpp"
#include "vortex/solver.hpp"

namespace vortree::test {

/// A finished run that never was: a scene, a report of `rows` steps with what a test puts into its
/// columns as functions of t, other tables, and the verdicts on them.
class MadeUpRun {
 public:
  using Of = std::function<double(double t)>;

  using Files = std::map<std::string, std::string>;

  /// `files` lie beside the scene, and beside the report.
  MadeUpRun(const std::string& text, const std::vector<std::string>& overrides,
            const Files& files = {})
      : folder_(filled(files)),
        scene_(io::parse_scene(text, folder_->write("scene.toml", text), by_vortices(), overrides)),
        scales_(flow::scales_of(scene_)) {}

  MadeUpRun& with(const std::string& column, Of value) {
    columns_[column] = std::move(value);
    return *this;
  }
  MadeUpRun& with(const std::string& column, double value) {
    return with(column, [value](double) { return value; });
  }

  /// blobs  at the end; none: those of the start
  std::vector<checks::Verdict> verdicts(int rows, const vortex::Blobs& blobs = {}) const {
    vortex::Setup setup = vortex::setup_of(case_of(scene_));
    if (blobs.size() > 0) setup.blobs = blobs;
    const vortex::VortexSolver solver(std::move(setup));
    const std::vector<std::string> names = app::Rows(solver, scales_).names();
    std::string report = fmt::format("{}\n", fmt::join(names, ","));
    for (int k = 1; k <= rows; ++k) {
      std::vector<double> row;
      for (const std::string& name : names) {
        const auto given = columns_.find(name);
        const double t = k * scene_.time.dt;
        row.push_back(name == "t"               ? t
                      : name == "T"             ? scales_.T(t)
                      : given == columns_.end() ? 0
                                                : given->second(t));
      }
      report += fmt::format("{}\n", fmt::join(row, ","));
    }
    folder_->write("report.csv", report);
    return checks::verdicts(scene_, folder_->path(), solver, scales_);
  }

  /// The one verdict on what is asked.
  checks::Verdict verdict(int rows, const vortex::Blobs& blobs = {}) const {
    const auto list = verdicts(rows, blobs);
    if (list.size() != 1) throw std::logic_error(fmt::format("{} verdicts", list.size()));
    return list.front();
  }

  const io::Scene& scene() const { return scene_; }
  const flow::Scales& scales() const { return scales_; }
  vortex::Blobs blobs() const { return vortex::setup_of(case_of(scene_)).blobs; }

 private:
  static std::unique_ptr<TemporaryFolder> filled(const Files& files) {
    auto folder = std::make_unique<TemporaryFolder>();
    for (const auto& [name, text] : files) folder->write(name, text);
    return folder;
  }

  std::unique_ptr<TemporaryFolder> folder_;
  io::Scene scene_;
  flow::Scales scales_;
  std::map<std::string, Of> columns_;
};

}  // namespace vortree::test
