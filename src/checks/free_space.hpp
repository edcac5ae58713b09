#pragma once

#include "checks/history_rows.hpp"

namespace vortree::checks {

/// What [check] asks of vortices in free space: the field at the end (Lamb-Oseen), turning,
/// merging, travelling, moments against a reference, energy and invariants.
void check_free_space(std::vector<Verdict>& list, const io::Scene& scene,
                      const std::filesystem::path& folder, const flow::Solver& solver,
                      const flow::Scales& scales, const HistoryRows& rows);

}  // namespace vortree::checks
