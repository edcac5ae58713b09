#include "checks/checks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "checks/at_wall.hpp"
#include "checks/finished.hpp"
#include "checks/forces.hpp"
#include "checks/free_space.hpp"
#include "checks/periodic_flow.hpp"
#include "checks/plunge.hpp"
#include "checks/shedding.hpp"
#include "checks/spin.hpp"

namespace vortree::checks {
namespace {

void check_count(std::vector<Verdict>& list, const Finished& run) {
  add(list, "blobs_max", run.scene.check.blobs_max, [&] {
    const Series count = run.rows.column(run.solver.particle() + "s");
    return run.rows.largest({}, [&](std::size_t r) { return count[r]; });
  });
}

/// All that there are, in the order in which a run tells them.
constexpr Check all[] = {check_drag,       check_lift,           check_early_drag,
                         check_forces,     check_shedding,       check_plunge,
                         check_spin,       check_wall_vorticity, check_front_pressure,
                         check_lamb_oseen, check_kirchhoff,      check_merger,
                         check_dipole,     check_moments,        check_energy,
                         check_invariants, check_periodic_flow,  check_count};

}  // namespace

std::vector<Verdict> verdicts(const io::Scene& scene, const std::filesystem::path& folder,
                              const flow::Solver& solver, const flow::Scales& scales) {
  const Finished run{scene, folder, solver, scales, HistoryRows(folder / "report.csv")};
  std::vector<Verdict> list;
  for (const Check check : all) check(list, run);
  return list;
}

namespace {

std::string text(const Verdict& v) {
  if (!std::isfinite(*v.reached.value)) return fmt::format("{} is not finite (missed)", v.what);
  return fmt::format("{} {:.3g} of {:.3g}{}", v.what, *v.reached.value, v.asked,
                     v.missed() ? " (missed)" : "");
}

/// `a, b (the run ends at T = 1)`, one after the other for each reason.
std::string not_reached(std::span<const Verdict> verdicts) {
  std::vector<std::string> whys, names;
  for (const Verdict& v : verdicts) {
    if (v.reached.value) continue;
    const auto known = std::ranges::find(whys, v.reached.why) - whys.begin();
    if (known == std::ssize(whys)) {
      whys.push_back(v.reached.why);
      names.push_back(v.what);
    } else {
      names[static_cast<std::size_t>(known)] += ", " + v.what;
    }
  }
  for (std::size_t k = 0; k < whys.size(); ++k) names[k] += fmt::format(" ({})", whys[k]);
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

std::string verdict_line(std::span<const Verdict> verdicts) {
  if (verdicts.empty()) return "nothing to check";
  std::vector<std::string> words;
  for (const Verdict& v : verdicts)
    if (v.reached.value) words.push_back(text(v));
  const std::string missing = not_reached(verdicts);
  if (words.empty()) return "nothing of the check was reached: " + missing;
  const bool missed = std::ranges::any_of(verdicts, &Verdict::missed);
  return fmt::format("check {}: {}{}{}", missed ? "FAILED" : "passed", fmt::join(words, ", "),
                     missing.empty() ? "" : "; not reached: ", missing);
}

}  // namespace vortree::checks
