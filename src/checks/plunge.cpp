#include "checks/plunge.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "exact/theodorsen.hpp"

namespace vortree::checks {
namespace {

const Reached no_period{.value = {}, .why = "the run ends before a whole period"};

/// The last rows of a report that make up whole periods: [first, last), none if there is not one.
struct Periods {
  std::size_t first = 0, last = 0;
  bool any() const { return last > first; }
};

Periods whole_periods(const io::Scene& scene, const HistoryRows& rows) {
  const Series t = rows.column("t");
  std::size_t from = 0;
  while (from < t.size() && rows.T()[from] < scene.check.plunge_from.value_or(0)) ++from;
  if (t.size() - from < 3) return {};
  const double each = 1 / (scene.plunge->frequency * (t[1] - t[0]));  // rows a period
  const double periods = std::floor((t.size() - from) / each + 1e-6);
  return {t.size() - static_cast<std::size_t>(std::lround(periods * each)), t.size()};
}

/// The component of a coefficient at the frequency of the plunge: its real part goes with the
/// body's place, minus its imaginary part against the body's velocity.
std::complex<double> at_frequency(const Series& t, const Series& values, Periods rows,
                                  double omega) {
  std::complex<double> sum = 0;
  for (std::size_t r = rows.first; r < rows.last; ++r)
    sum += values[r] * std::polar(1.0, -omega * t[r]);
  return 2.0 / static_cast<double>(rows.last - rows.first) * sum;
}

/// In fluid at rest, where drag is the force along the plunge.
void check_morison(std::vector<Verdict>& list, const io::CheckSettings& c, const Series& t,
                   const Series& force, Periods periods, double omega, const flow::Scales& scales) {
  constexpr double pi = std::numbers::pi;
  const auto off = [&](double value, const std::optional<double>& known) -> Reached {
    if (!periods.any()) return no_period;
    return {std::abs(deviation(value, known.value_or(0)))};
  };
  const std::complex<double> f = at_frequency(t, force, periods, omega);
  add(list, "morison_drag_max", c.morison_drag_max,
      [&] { return off(-3 * pi / 8 * f.imag(), c.morison_drag); });
  add(list, "morison_mass_max", c.morison_mass_max, [&] {
    return off(2 * scales.speed * f.real() / (pi * scales.length * omega), c.morison_mass);
  });
}

}  // namespace

void check_plunge(std::vector<Verdict>& list, const Finished& run) {
  const io::Scene& scene = run.scene;
  const flow::Scales& scales = run.scales;
  const HistoryRows& rows = run.rows;
  if (!scene.plunge) return;
  const Periods periods = whole_periods(scene, rows);
  const Series t = rows.column("t");
  const double omega = 2 * std::numbers::pi * scene.plunge->frequency;
  check_morison(list, scene.check, t, rows.column("cd_" + run.solver.route()), periods, omega,
                scales);
  add(list, "theodorsen_max", scene.check.theodorsen_max, [&]() -> Reached {
    if (!periods.any()) return no_period;
    const double half = scales.length / 2;
    const Vec2 amplitude = body::motion_of(scene.plunge, {}).plunge.amplitude;
    const auto plate =
        exact::lift_of_plunge(dot(amplitude, scales.across()) / half, omega * half / scales.speed);
    const auto ours = at_frequency(t, rows.column("cl_impulse"), periods, omega);
    return {share(std::abs(ours - plate), std::abs(plate))};
  });
}

}  // namespace vortree::checks
