#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fmm/plan.hpp"

namespace vortree::app {

/// Something that vortices make everywhere, and the names of its columns in a file.
///
/// name   velocity (u, v), gradient (ux, uy, vx: du/dx, du/dy, dv/dx; dv/dy = -du/dx),
///        stream_function (psi), vorticity (omega)
/// sum    into as many columns as there are names, by a plan made of the sources; none of velocity,
///        which every method of bench/measures/methods.hpp sums
struct Quantity {
  using Columns = std::span<std::vector<double>>;
  std::string_view name;
  std::vector<std::string_view> columns;
  void (*sum)(const fmm::Plan& plan, const fmm::Sources& sources, const fmm::Targets& targets,
              double tolerance, Columns columns);
};

[[nodiscard]] std::span<const Quantity> quantities();

/// Those of a list, "velocity,gradient", in the order of quantities().
/// throws  std::invalid_argument for other words, one twice, or none
[[nodiscard]] std::vector<Quantity> quantities_in(std::string_view list);

}  // namespace vortree::app
