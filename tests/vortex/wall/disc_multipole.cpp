#include "vortex/wall/disc_multipole.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "fmm/direct.hpp"
#include "vortex/flows.hpp"

using namespace vortree;

TEST_CASE(
    "outside its disc a multipole has the vortices' velocity, to 1e-10 of what they could do") {
  const vortex::Blobs blobs = test::cloud(300, 0, 0);
  const tree::Points at{blobs.x, blobs.y};
  const vortex::Disc disc(at);
  const vortex::DiscMultipole multipole(disc, at, blobs.gamma);
  double strength = 0;
  for (double g : blobs.gamma) strength += std::abs(g);

  std::vector<double> x, y;
  std::vector<std::uint32_t> served;
  bench::Uniform uniform(3);
  for (std::uint32_t k = 0; k < 2000; ++k) {
    const double r = std::pow(100, uniform()) * 0.5, phi = 2 * std::numbers::pi * uniform();
    x.push_back(r * std::cos(phi));
    y.push_back(r * std::sin(phi));
    if (disc.serves({x[k], y[k]})) served.push_back(k);
  }
  CHECK(served.size() > 1600);
  CHECK(served.size() < 2000);

  vortex::Velocities fast(x.size()), plain(x.size());
  multipole.add_velocity({x, y}, served, fast);
  fmm::velocity_direct({blobs.x, blobs.y, blobs.gamma, {}}, {x, y, {}}, fmm::Cores::source, plain.u,
                       plain.v);
  double worst = 0;
  for (std::uint32_t k : served)
    worst = std::max(
        worst, std::hypot(fast.u[k] - plain.u[k], fast.v[k] - plain.v[k]) * std::hypot(x[k], y[k]));
  CHECK(worst < 1e-10 * strength / (2 * std::numbers::pi));
  for (std::uint32_t k = 0; k < x.size(); ++k)
    if (!disc.serves({x[k], y[k]})) REQUIRE((fast.u[k] == 0 && fast.v[k] == 0));
}
