#include <cstdio>
#include <numbers>
#include <vector>
#include <vortree/fmm/plan.hpp>

int main() {
  const double turn = 2 * std::numbers::pi;
  const std::vector<double> x{-1, 0, 1}, y{0, 0, 0}, gamma{turn, 0, turn};
  std::vector<double> u(3), v(3);
  const vortree::fmm::Plan plan({.x = x, .y = y, .gamma = gamma}, {.tolerance = 1e-9});
  plan.velocity(u, v);
  for (int i = 0; i < 3; ++i) std::printf("%.6f %.6f\n", u[i] + 0.0, v[i]);
}
