#include "vortex/adapt/lattice/lay_onto_lattice.hpp"

#include <catch2/catch.hpp>

#include "vortex/adapt/split_wide.hpp"
#include "vortex/strained_flows.hpp"

using namespace vortree;
using vortex::Blobs;
using vortex::Core;
using vortex::Covariance;
using vortex::Deviator;
using vortex::LatticeLevel;
using vortex::LatticeNode;
using vortex::NineNodes;
using vortex::WideBlob;

namespace {

constexpr double sigma_max = 0.05;

/// Blobs of any place, sign, level and strain up to `most`, from the least that is laid to `widest`
/// times its square.
std::vector<WideBlob> wide_blobs(std::size_t n, double most, double widest) {
  test::Uniform uniform(31);
  std::vector<WideBlob> blobs;
  for (std::size_t i = 0; i < n; ++i) {
    const int level = static_cast<int>(4 * uniform());
    const double square = LatticeLevel(sigma_max, level).least() * (1 + (widest - 1) * uniform());
    const Vec2 at{2 * uniform() - 1, 2 * uniform() - 1};
    blobs.push_back({at, 2 * uniform() - 1, {square, test::strain(uniform, square, most)}, level});
  }
  return blobs;
}

Blobs as_blobs(const std::vector<WideBlob>& wide) {
  Blobs blobs;
  for (const WideBlob& b : wide) blobs.append(b.at, b.gamma, b.core);
  return blobs;
}

Blobs laid(const std::vector<WideBlob>& wide) {
  Blobs blobs;
  for (const LatticeNode& node : lay_onto_lattice(wide, sigma_max))
    blobs.append(node.at, node.gamma, Core{LatticeLevel(sigma_max, node.level).square});
  return blobs;
}

/// By level, row and column.
std::vector<LatticeNode> sorted(std::vector<LatticeNode> nodes) {
  std::ranges::sort(nodes, [](const LatticeNode& a, const LatticeNode& b) {
    return std::tuple(a.level, a.at.y, a.at.x) < std::tuple(b.level, b.at.y, b.at.x);
  });
  return nodes;
}

bool same(const LatticeNode& a, const LatticeNode& b) {
  return a.level == b.level && a.at.x == b.at.x && a.at.y == b.at.y && a.gamma == b.gamma;
}

}  // namespace

TEST_CASE("laying any blob, strained or not, keeps circulation, impulse and all second moments") {
  for (const double most : {0.0, 0.5, 0.99})
    for (const double widest : {1.0, 2.0, 10.0}) {
      const auto wide = wide_blobs(2000, most, widest);
      const Blobs before = as_blobs(wide), after = laid(wide);
      // Terms of the sums are up to 2 and 9 a blob; what is left of them is a few units of the
      // last place of their sum.
      const double round_off = 1e-14 * test::strength(before);
      const test::Drift drift =
          test::drift(invariants(before, nullptr), invariants(after, nullptr));
      CHECK(drift.circulation < round_off);
      CHECK(drift.moment < round_off);
      CHECK(drift.second < round_off);
      CHECK(test::difference(test::second_moments(before), test::second_moments(after)) <
            round_off);
    }
}

TEST_CASE("a lone blob keeps them to 1e-13 of its own square, wherever it lies") {
  for (const WideBlob& b : wide_blobs(500, 0.95, 3)) {
    const Blobs after = laid({b});
    double gamma = 0;
    Vec2 moment;
    Covariance v{};
    for (std::size_t i = 0; i < after.size(); ++i) {
      const double g = after.gamma[i] / b.gamma, s2 = after.sigma[i] * after.sigma[i];
      const Vec2 d = after.centre(i) - b.at;
      gamma += g;
      moment += g * d;
      v = {v.nn + g * (s2 / 2 + d.x * d.x), v.nt + g * d.x * d.y, v.tt + g * (s2 / 2 + d.y * d.y)};
    }
    const Covariance own = b.core.covariance({1, 0});
    const double scale = b.core.square;
    CHECK(gamma == Approx(1).epsilon(1e-15));
    CHECK(std::hypot(moment.x, moment.y) < 1e-13 * std::sqrt(scale));
    CHECK(std::abs(v.nn - own.nn) < 1e-13 * scale);
    CHECK(std::abs(v.tt - own.tt) < 1e-13 * scale);
    // covariance({1, 0}) has y as its tangent
    CHECK(std::abs(v.nt - own.nt) < 1e-13 * scale);
  }
}

TEST_CASE("of a round core no share is negative for V from 1/4 to 3/4, and some is beyond") {
  const LatticeLevel level(sigma_max, 0);
  const auto least = [&](double v) {
    const Core core{level.square + 2 * v * level.h * level.h};
    double smallest = INFINITY;
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 40; ++j) {
        const Vec2 at = (level.h / 40) * Vec2{i - 20.0, j - 20.0};
        smallest = std::min(smallest, std::ranges::min(NineNodes(at, core, level).share));
      }
    return smallest;
  };
  const double round_off = 1e-15;
  for (const double v : {0.25, 0.3, 0.5, 0.75}) CHECK(least(v) > -round_off);
  CHECK(least(0.24) < -1e-4);
  CHECK(least(0.76) < -1e-4);
}

TEST_CASE("what is just wide enough is laid by the B-spline: a blob that moves on changes evenly") {
  const LatticeLevel level(sigma_max, 0);
  const Core core{level.least()};
  // From either side of the middle between two nodes.
  const NineNodes left({0.4999999 * level.h, 0}, core, level),
      right({0.5000001 * level.h, 0}, core, level);
  CHECK(right.gx == left.gx + 1);
  for (int b = 0; b < 3; ++b)
    for (int a = 1; a < 3; ++a)
      CHECK(left.share[a + 3 * b] == Approx(right.share[a - 1 + 3 * b]).margin(2e-7));
}

TEST_CASE("mirror images, in either axis, are laid as mirror images to the bit") {
  const auto wide = wide_blobs(2000, 0.9, 2);
  const auto here = sorted(lay_onto_lattice(wide, sigma_max));
  for (const Vec2 mirror : {Vec2{1, -1}, Vec2{-1, 1}}) {
    auto image = wide;
    for (WideBlob& b : image) {
      b.at = {mirror.x * b.at.x, mirror.y * b.at.y};
      b.gamma = -b.gamma;
      b.core.deviator.xy = -b.core.deviator.xy;
    }
    auto there = lay_onto_lattice(image, sigma_max);
    for (LatticeNode& node : there) {
      node.at = {mirror.x * node.at.x + 0.0, mirror.y * node.at.y + 0.0};
      node.gamma = -node.gamma;
    }
    there = sorted(std::move(there));
    REQUIRE(there.size() == here.size());
    CHECK(std::ranges::equal(here, there, same));
  }
}

TEST_CASE("what is opposite and in one place is nothing, to the bit") {
  auto wide = wide_blobs(300, 0.9, 2);
  const std::size_t n = wide.size();
  for (std::size_t i = 0; i < n; ++i) {
    wide.push_back(wide[n - 1 - i]);
    wide.back().gamma = -wide.back().gamma;
  }
  CHECK(lay_onto_lattice(wide, sigma_max).empty());
}

TEST_CASE("a flow 2^20 times as large and 2^30 times as strong is laid alike, to the bit") {
  const auto wide = wide_blobs(1000, 0.9, 2);
  auto larger = wide;
  for (WideBlob& b : larger) {
    b.at = 0x1p20 * b.at;
    b.gamma *= 0x1p30;
    b.core = {0x1p40 * b.core.square, 0x1p40 * b.core.deviator};
  }
  const auto here = lay_onto_lattice(wide, sigma_max);
  auto there = lay_onto_lattice(larger, 0x1p20 * sigma_max);
  for (LatticeNode& node : there) node = {0x1p-20 * node.at, 0x1p-30 * node.gamma, node.level};
  CHECK(std::ranges::equal(here, there, same));
}

TEST_CASE("laying gives the same bits for any number of threads and any order of the blobs") {
  auto wide = wide_blobs(20000, 0.9, 2);
  const auto lay = [&] { return lay_onto_lattice(wide, sigma_max); };
  const auto once = test::with_threads(1, lay);
  CHECK(std::ranges::equal(once, test::with_threads(2, lay), same));
  std::ranges::reverse(wide);
  CHECK(std::ranges::equal(once, lay(), same));
}

TEST_CASE("circulations of any size are laid: only what is 1e-18 of all is lost") {
  for (const double scale : {1e-300, 1e-30, 1.0, 1e30, 1e290}) {
    auto wide = wide_blobs(100, 0, 2);
    for (WideBlob& b : wide) b.gamma *= scale;
    const Blobs before = as_blobs(wide), after = laid(wide);
    double sum = 0;
    for (const double gamma : after.gamma) sum += gamma / scale;
    for (const double gamma : before.gamma) sum -= gamma / scale;
    CHECK(std::abs(sum) < 1e-13);
  }
  CHECK(vortex::lay_onto_lattice({}, sigma_max).empty());
}
