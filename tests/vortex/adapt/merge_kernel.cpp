#include "vortex/adapt/merge_kernel.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>
#include <random>

#include "vortex/blobs/invariants.hpp"

namespace vortree::vortex::merge_kernel {
namespace {

const Merging merging{.tolerance = 0.5, .reach = 2, .sigma_max = 0.2};
const Limits limits(merging);

using Table = MergeColumns<std::vector<float>>;

Blobs cloud(std::size_t n) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  Blobs blobs;
  for (std::size_t i = 0; i < n; ++i)
    blobs.append({unit(random), unit(random)}, unit(random) * std::pow(10, -20 * unit(random)),
                 0.1 + 0.1 * unit(random));
  return blobs;
}

Table table(const Blobs& blobs) {
  Table t;
  t.resize(blobs.size());
  for (std::size_t i = 0; i < blobs.size(); ++i)
    t.put(i, limits.units, blobs.centre(i), blobs.gamma[i], blobs.sigma[i] * blobs.sigma[i]);
  return t;
}

/// Error of merging blobs i and j as merge_close.hpp has it, in double, in the units of
/// the search.
double plain_error(const Blobs& b, std::size_t i, std::size_t j) {
  const Vec2 d = b.centre(i) - b.centre(j);
  const double d2 = dot(d, d), s = std::min(b.sigma[i], b.sigma[j]);
  const double si = b.sigma[i] * b.sigma[i], sj = b.sigma[j] * b.sigma[j];
  const double w = b.gamma[i] / (b.gamma[i] + b.gamma[j]);
  const double cost = w * b.gamma[j] * (d2 + std::abs(si - sj)) / (s * s * s);
  const bool allowed = d2 <= 4 * s * s && cost <= merging.tolerance &&
                       w * si + (1 - w) * sj + w * (1 - w) * d2 <= 0.04;
  const Limits::Units& units = limits.units;
  return allowed ? cost * units.per_circulation / units.per_length : INFINITY;
}

double least_error(const Blobs& b, std::size_t i) {
  double least = INFINITY;
  for (std::size_t j = 0; j < b.size(); ++j)
    if (j != i) least = std::min(least, plain_error(b, i, j));
  return least;
}

}  // namespace

TEST_CASE("the error of a merger is the same in vectors and alone") {
  const Blobs blobs = cloud(320);
  const Table all = table(blobs);
  for (std::uint32_t i = 0; i < blobs.size(); i += 7)
    for (std::uint32_t j = 0; j < blobs.size(); j += single_count) {
      const Singles many = error(all.lone<Singles>(i), all.lanes<Singles>(j), limits);
      for (std::uint32_t k = 0; k < single_count; ++k)
        CHECK(many[k] ==
              Approx(error(all.lone<float>(i), all.lone<float>(j + k), limits)).epsilon(1e-5));
    }
}

TEST_CASE("those who seek together find the partners that a plain search in double finds") {
  const Blobs b = cloud(200);
  const Table all = table(b);
  int found = 0;
  for (std::uint32_t first = 0; first < b.size(); first += 11) {
    Seekers<Singles> seekers;
    for (std::uint32_t i = first; i < std::min(b.size(), first + std::size_t{11}); ++i)
      if (seekers.size() < single_count) seekers.add(all, i, i);
    seekers.choose(all, limits, [&](auto consider) {
      for (std::uint32_t j = 0; j < b.size(); ++j) consider(j);
    });
    for (std::uint32_t k = 0; k < seekers.size(); ++k) {
      const MergeChoice choice = seekers.choice(k);
      const double least = least_error(b, first + k);
      REQUIRE((choice.partner == none) == std::isinf(least));
      if (choice.partner == none) continue;
      ++found;
      CHECK(choice.error == Approx(least).epsilon(1e-4));
      CHECK(plain_error(b, first + k, choice.partner) == Approx(least).epsilon(1e-4));
    }
  }
  CHECK(found > 50);
}

TEST_CASE("one who seeks alone finds what one who seeks with others finds") {
  const Blobs b = cloud(200);
  Table all = table(b);
  all.resize(b.size() + single_count);
  std::fill(all.x.begin() + b.size(), all.x.end(), never);
  int found = 0;
  for (std::uint32_t i = 0; i < b.size(); ++i) {
    Seekers<float> plain;
    plain.add(all, i, i);
    plain.choose(all, limits, [&](auto consider) {
      for (std::uint32_t j = 0; j < b.size(); ++j) consider(j);
    });
    LoneSeeker alone(all, i);
    for (const auto& [first, last] : {std::pair{0u, 3u}, {3u, 90u}, {90u, 200u}})
      alone.consider(all, first, last, limits);
    const MergeChoice expected = plain.choice(0), choice = alone.choice();
    REQUIRE((choice.partner == none) == (expected.partner == none));
    if (choice.partner == none) continue;
    ++found;
    CHECK(choice.error == Approx(expected.error).epsilon(1e-5));
    CHECK(plain_error(b, i, choice.partner) == Approx(least_error(b, i)).epsilon(1e-4));
  }
  CHECK(found > 50);
}

TEST_CASE("a window leaves no pair that may merge, and conserves what pairs conserve") {
  MergeWindow window;
  const Blobs before = cloud(640);
  AdaptedBlobs adapted = unpack(before, nullptr);
  Blobs after;
  for (std::uint32_t first = 0; first < before.size(); first += MergeWindow::most) {
    std::array<std::uint32_t, MergeWindow::most> members;
    std::iota(members.begin(), members.end(), first);
    const std::size_t left = window.merge(members, adapted.all, {}, limits);
    REQUIRE(left < MergeWindow::most);
    REQUIRE(std::is_sorted(members.begin(), members.begin() + left));
    Blobs kept;
    for (std::uint32_t i : std::span(members).first(left)) {
      const AdaptedBlob& p = adapted.all[i];
      kept.append(p.centre(), p.gamma, std::sqrt(p.square));
      after.append(p.centre(), p.gamma, std::sqrt(p.square));
    }
    for (std::size_t i = 0; i < left; ++i)
      CHECK(least_error(kept, i) > merging.tolerance * (1 - 1e-5));
  }
  const Invariants was = invariants(before, nullptr), is = invariants(after, nullptr);
  CHECK(is.circulation == Approx(was.circulation).epsilon(1e-14));
  CHECK(is.second == Approx(was.second).epsilon(1e-14));
}

TEST_CASE("a merger beside the wall keeps mean and variance of the distance, and all spread") {
  std::vector<AtWall> at_wall{{{0, 0.1}, {0, 1}, 1.2, 0.5, false},
                              {{0, 0.3}, {0, 1}, 1.9, 0.7, false}};
  const double w = 0.25, v = 0.75, both = w * v;
  AdaptedBlob p{0, 1, 1, 0.04, {0.002, 0.001}, 0, 1, 1}, q{2, 1.4, 3, 0.08, {0, -0.003}, 1, 1, 1};
  merge(p, q, at_wall);
  CHECK(p.gamma == 4);
  CHECK(p.x == Approx(1.5));
  CHECK(p.y == Approx(1.3));
  CHECK(p.y + at_wall[0].offset.y == Approx(w * 1.1 + v * 1.7));
  CHECK(at_wall[0].mean == Approx(w * 1.2 + v * 1.9).epsilon(1e-14));
  CHECK(at_wall[0].across == Approx(w * 0.5 + v * 0.7 + both * 0.7 * 0.7).epsilon(1e-14));
  const Covariance merged = p.core().covariance({0, 1});
  CHECK(merged.nn + 1.3 * 1.3 ==
        Approx(w * (0.02 - 0.002 + 1 * 1) + v * (0.04 + 1.4 * 1.4)).epsilon(1e-14));
  CHECK(merged.tt == Approx(w * (0.02 + 0.002) + v * 0.04 + both * 2 * 2).epsilon(1e-14));
  // Along the wall is -x; the tilt is that of folded centroids, 0.6 apart.
  CHECK(merged.nt == Approx(w * -0.001 + v * 0.003 + both * 0.6 * -2).epsilon(1e-14));
  CHECK(at_wall[0].moved);
}

TEST_CASE("a free blob that merges with one beside the wall is so much farther as it lies") {
  std::vector<AtWall> at_wall{{{0, 0.1}, {0, 1}, 1.2, 0.5, false}};
  AdaptedBlob p{0, 1, 1, 0.04, {}, 0, 1, 1}, q{0, 2, 1, 0.04, {}, no_wall, 1, 1};
  AdaptedBlob r = q;
  merge(r, p, at_wall);
  CHECK(at_wall[0].mean == Approx(1.2 + 0.9 / 2).epsilon(1e-14));
  CHECK(at_wall[0].across == Approx(0.5 * (0.5 + 0.02) + 0.9 * 0.9 / 4).epsilon(1e-14));
}

TEST_CASE(
    "blobs on both sides of a plate, whose normals are opposite, merge to one that is finite") {
  std::array<AtWall, 2> at_wall{AtWall{{0, 0.002}, {0, 1}, 0.01, 1e-5, false},
                                AtWall{{0, -0.002}, {0, -1}, 0.012, 1e-5, false}};
  AdaptedBlob above{0.1, 0.01, 1, 1e-4, {}, 0, 1, 1}, below{0.11, -0.01, 2, 1e-4, {}, 1, 1, 1};
  merge(above, below, at_wall);
  CHECK(above.gamma == 3);
  CHECK(above.x == Approx((0.1 + 2 * 0.11) / 3));
  CHECK(above.square > 0);
  CHECK((std::isfinite(above.deviator.xx) && std::isfinite(above.deviator.xy)));
  CHECK((at_wall[0].normal.x == 0 && at_wall[0].normal.y == 1));
  CHECK((std::isfinite(at_wall[0].mean) && std::isfinite(at_wall[0].across)));
}

}  // namespace vortree::vortex::merge_kernel
