// The sheet of the bare stream past a circle is -2 sin theta; its first moment is -2 pi R^2.
#include <cstdio>
#include <vector>
#include <vortree/vortex/wall.hpp>

int main() {
  const vortree::vortex::Wall wall(vortree::vortex::circle({0, 0}, 0.5), 64);
  std::vector<double> slip;
  for (std::size_t i = 0; i < wall.panels(); ++i) slip.push_back(wall.tangent(i).x);
  std::printf("%.6f\n", wall.first_moment(wall.sheet(slip, 0)).y);
}
