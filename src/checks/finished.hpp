#pragma once

#include <filesystem>
#include <vector>

#include "checks/history_rows.hpp"

namespace vortree::checks {

/// A run that has come to its end, as checks see it.
///
/// folder  where it has left its tables
/// solver  the flow at the end
/// rows    of report.csv
struct Finished {
  const io::Scene& scene;
  std::filesystem::path folder;
  const flow::Solver& solver;
  flow::Scales scales;
  HistoryRows rows;
};

/// What a flow comes to that is to be held against a reference of its Reynolds number, if there is
/// none.
inline Reached without_reference() {
  return {.value = {}, .why = "there is no reference for this Reynolds number"};
}

/// Adds a verdict for each thing that the scene asks and this check knows.
using Check = void (*)(std::vector<Verdict>& list, const Finished& run);

}  // namespace vortree::checks
