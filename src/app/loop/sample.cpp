#include "app/loop/sample.hpp"

namespace vortree::app {
namespace {

std::vector<double> axis(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last + 1e-9 * step; ++i) values.push_back(first + i * step);
  return values;
}

}  // namespace

io::Field picture(const flow::Solver& solver, const flow::OutputSettings& output) {
  const auto [x0, y0, x1, y1] = *output.window;
  const double h = *output.field_spacing;
  const std::vector<double> columns = axis(x0, x1, h), rows = axis(y0, y1, h);
  std::vector<double> x, y;
  for (const double b : rows)
    for (const double a : columns) {
      x.push_back(a);
      y.push_back(b);
    }
  flow::Samples found = solver.sample({x, y});
  return {.time = solver.time(),
          .x = columns,
          .y = rows,
          .u = std::move(found.u),
          .v = std::move(found.v),
          .omega = std::move(found.omega),
          .psi = solver.stream_function({x, y}),
          .p = solver.pressure({x, y})};
}

}  // namespace vortree::app
