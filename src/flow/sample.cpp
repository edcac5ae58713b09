#include "flow/sample.hpp"

#include "vortex/wall/vorticity.hpp"

namespace vortree::flow {
namespace {

std::vector<double> axis(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last + 1e-9 * step; ++i) values.push_back(first + i * step);
  return values;
}

}  // namespace

io::Field picture(double time, const io::SceneOutput& output, const vortex::Blobs& blobs,
                  const FlowCase& flow) {
  const auto [x0, y0, x1, y1] = *output.window;
  const double h = *output.field_spacing;
  io::Field field{
      .time = time, .x = axis(x0, x1, h), .y = axis(y0, y1, h), .u = {}, .v = {}, .omega = {}};
  std::vector<double> x, y;
  for (double b : field.y)
    for (double a : field.x) {
      x.push_back(a);
      y.push_back(b);
    }
  const body::Shape* shape = flow.wall ? &flow.wall->shape() : nullptr;
  const Vec2 origin = flow.origin.at(time);
  x = flow::moved(std::move(x), -origin.x);
  y = flow::moved(std::move(y), -origin.y);
  vortex::Velocities u = vortex::velocity_at({x, y}, blobs, flow.problem);
  field.omega.resize(x.size());
  vortex::vorticity(blobs, shape, {x, y}, field.omega);
  for (std::size_t k = 0; shape && k < x.size(); ++k)
    if (shape->nearest({x[k], y[k]}).distance < 0) u.u[k] = u.v[k] = 0;
  field.u = flow::moved(std::move(u.u), flow.origin.drift.x);
  field.v = flow::moved(std::move(u.v), flow.origin.drift.y);
  return field;
}

}  // namespace vortree::flow
