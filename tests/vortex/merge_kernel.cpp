#include "vortex/merge_kernel.hpp"

#include <catch2/catch.hpp>
#include <random>

namespace vortree::vortex::merge_kernel {
namespace {

Blobs cloud(std::size_t n) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  Blobs blobs;
  for (std::size_t i = 0; i < n; ++i)
    blobs.append({unit(random), unit(random)},
                 (unit(random) - 0.4) * std::pow(10, -20 * unit(random)), 0.1 + 0.1 * unit(random));
  return blobs;
}

const Merging merging{.tolerance = 0.5, .reach = 2, .sigma_max = 0.2};

}  // namespace

TEST_CASE("the error of a merger is the same in vectors and alone") {
  const Blobs blobs = cloud(300);
  const Candidates candidates(blobs);
  for (std::uint32_t i = 0; i < blobs.size(); i += 7)
    for (std::uint32_t j = 0; j < blobs.size(); j += Lanes::size()) {
      const Lanes many = error<Lanes>(candidates, i, j, merging);
      for (std::uint32_t k = 0; k < Lanes::size() && j + k < blobs.size(); ++k)
        CHECK(many[k] ==
              Approx(float{error<Lone>(candidates, i, j + k, merging)[0]}).epsilon(1e-5));
    }
}

TEST_CASE("the best partner is the one that a plain search in double finds") {
  const Blobs b = cloud(200);
  const Candidates candidates(b);
  int found = 0;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      const Vec2 d = b.centre(i) - b.centre(j);
      const double d2 = dot(d, d), s = std::min(b.sigma[i], b.sigma[j]);
      const double si = b.sigma[i] * b.sigma[i], sj = b.sigma[j] * b.sigma[j];
      const double gi = b.gamma[i], gj = b.gamma[j], w = gi / (gi + gj);
      const double cost = std::abs(w * gj) * (d2 + std::abs(si - sj)) / (s * s * s);
      if (i == j || gi * gj <= 0 || d2 > 4 * s * s || cost > merging.tolerance) continue;
      if (w * si + (1 - w) * sj + w * (1 - w) * d2 <= 0.04) least = std::min(least, cost);
    }
    Search<Lanes> search(candidates, i, merging);
    search.run(0, 120);
    search.run(120, candidates.size);
    const Choice best = search.best();
    REQUIRE((best.partner == none) == std::isinf(least));
    if (best.partner == none) continue;
    ++found;
    CHECK(best.error == Approx(least).epsilon(1e-4));
  }
  CHECK(found > 50);
}

}  // namespace vortree::vortex::merge_kernel
