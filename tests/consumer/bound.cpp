#include <vector>
#include <vortree/body/shapes/circle.hpp>
#include <vortree/vortex/wall/wall.hpp>

/// The sheet of the bare stream past a circle is -2 sin theta; its first moment is -2 pi R^2.
double moment_of_sheet(double radius) {
  const vortree::vortex::Wall wall(vortree::body::circle({0, 0}, radius), 64);
  std::vector<double> slip;
  for (std::size_t i = 0; i < wall.panels(); ++i) slip.push_back(wall.tangent(i).x);
  return wall.first_moment(wall.sheet(slip, 0)).y;
}
