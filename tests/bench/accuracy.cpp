#include "bench/accuracy.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace vortree;

TEST_CASE("the error of velocities that are off by a known amount is that amount") {
  // Two vortices of gamma 2 pi at distance 2: each moves the other with 1/2.
  const double gamma = 2 * 3.14159265358979323846;
  const std::vector<double> x{-1, 1}, y{0, 0}, strength{gamma, gamma}, u{0, 0};
  const fmm::Blobs blobs{x, y, strength, {}};
  const fmm::Targets targets{x, y, {}};

  const std::vector<double> off{-0.5, 0.5 + 0.125};
  const bench::Exact exact = bench::exact_velocity(blobs, targets);
  const auto error = bench::velocity_error(exact, u, off);
  CHECK(error.relative_l2 == Approx(0.125 / std::sqrt(0.5)));
  CHECK(error.max == Approx(0.25));
  CHECK(error.targets == 2);

  const std::vector<double> broken{-0.5, NAN};
  CHECK(std::isinf(bench::velocity_error(exact, u, broken).max));
  CHECK(std::isinf(bench::velocity_error(exact, u, broken).relative_l2));

  const std::vector<double> wide{2, 2},
      slow{-0.5 * (1 - std::exp(-1.0)), 0.5 * (1 - std::exp(-1.0))};
  CHECK(bench::velocity_error(bench::exact_velocity({x, y, strength, wide}, targets), u, slow).max <
        1e-15);
}
