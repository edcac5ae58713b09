#include "bench/tables/velocity_row.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace vortree::bench {
namespace {

// The times of a sum at some targets were scaled up by this; so are its pairs.
double scale(const VelocityRow& row, const Measurement& made) {
  return static_cast<double>(row.n) / static_cast<double>(made.targets);
}

std::string rounded(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : "";
}

template <class Integer>
std::string whole(const std::optional<Integer>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string phases(const Measurement& made) {
  std::vector<std::string> parts;
  for (const auto& [name, seconds] : made.phases)
    parts.push_back(fmt::format("{}={:.4g}", name, seconds));
  return fmt::format("{}", fmt::join(parts, ";"));
}

double seconds_of(const Measurement& made, std::string_view phase) {
  for (const auto& [name, seconds] : made.phases)
    if (name == phase) return seconds;
  return 0.0;
}

}  // namespace

Floors floors(const VelocityRow& row, const Measurement& made, const Anchors& machine) {
  Floors floors;
  if (const auto& work = made.account.work) {
    const double fma = 1.0 / machine.fma, division = 1.0 / machine.divisions;
    const double bare = work->bare_in_floats
                            ? std::max(0.5 / machine.single_divisions, 0.5 * 4.0 * fma)
                            : std::max(0.5 * division, 4.0 * fma);
    const double cored = (work->cored_in_floats ? 0.5 : 1.0) * 18.0 * fma;
    floors.near = scale(row, made) * (static_cast<double>(work->bare) * bare +
                                      static_cast<double>(work->cored) * cored +
                                      static_cast<double>(work->terms) * 4.0 * fma);
  }
  if (made.account.builder) floors.tree = 120.0 * static_cast<double>(row.n) / machine.triad;
  return floors;
}

std::string csv_header() {
  return "set,n,method,tolerance,threads,seconds,fastest,repeats,cpu,targets,relative_l2,p99,max,"
         "sampled,bytes,order,bare,cored,near_floor,tree_floor,phases";
}

std::string csv_line(const VelocityRow& row, const Measurement& made, const Floors& floors) {
  std::optional<double> bare, cored;
  if (const auto& work = made.account.work) {
    bare = scale(row, made) * static_cast<double>(work->bare);
    cored = scale(row, made) * static_cast<double>(work->cored);
  }
  const std::vector<std::string> cells{std::string(row.set),
                                       fmt::format("{}", row.n),
                                       std::string(row.method),
                                       row.tolerance ? fmt::format("{:g}", *row.tolerance) : "",
                                       fmt::format("{}", row.threads),
                                       fmt::format("{:.6g}", made.seconds),
                                       fmt::format("{:.6g}", made.fastest),
                                       fmt::format("{}", made.repeats),
                                       fmt::format("{:.3g}", made.cpu),
                                       fmt::format("{}", made.targets),
                                       fmt::format("{:.4g}", made.error.relative_l2),
                                       fmt::format("{:.4g}", made.error.p99),
                                       fmt::format("{:.4g}", made.error.max),
                                       fmt::format("{}", made.error.targets),
                                       whole(made.bytes),
                                       whole(made.account.order),
                                       rounded(bare),
                                       rounded(cored),
                                       rounded(floors.near),
                                       rounded(floors.tree),
                                       phases(made)};
  return fmt::format("{}", fmt::join(cells, ","));
}

std::string spoken_header() {
  return "set              n  method   asked thr  million/s  ns each     error  near floor";
}

std::string spoken_line(const VelocityRow& row, const Measurement& made, const Floors& floors) {
  const double near = seconds_of(made, "near") + seconds_of(made, "evaluate");
  const auto n = static_cast<double>(row.n);
  return fmt::format(
      "{:9} {:8} {:8} {:>5} {:3} {:10.3g} {:8.0f} {:9.1e} {:>11}{}", row.set, row.n, row.method,
      row.tolerance ? fmt::format("{:.0e}", *row.tolerance) : "-", row.threads,
      1e-6 * n / made.seconds, 1e9 * made.seconds / n, made.error.relative_l2,
      floors.near && near > 0.0 ? fmt::format("{:.0f} %", 100.0 * *floors.near / near) : "-",
      made.targets < row.n ? "  (scaled up)" : "");
}

}  // namespace vortree::bench
