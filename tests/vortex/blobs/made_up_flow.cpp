#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "flow/initial/gaussian.hpp"
#include "flow/initial/widths.hpp"
#include "vortex/blobs/lattice.hpp"
#include "vortex/wall/vorticity.hpp"

using namespace vortree;

namespace {

/// A vortex with a hole, c = `hollow` from 0 (Gaussian) to 1 (no vorticity in the middle):
///
///   omega = gamma/(pi a^2) exp(-r^2/a^2) (1 - c + c r^2/a^2),
///   weight = exp(-r^2/p^2) (1 - c + c (a^2 r^2/p^2 - sigma^2)/p^2),   p^2 = a^2 - sigma^2
///
/// All that an initial flow has to bring stands here.
const flow::InitialFlow hollow_vortex{
    {"hollow_vortex",
     {{"hollow",
       {.low = 0, .high = 1, .words = "it must lie in 0 .. 1"},
       "",
       "1: no vorticity in the middle"}}},
    "a vortex with a hole",
    [](const flow::InitialSettings& i) {
      const double a = *i.core, c = i.number("hollow");
      return std::vector<flow::Patch>{
          {.circulation = *i.circulation,
           .half = {a, a},
           .area = std::numbers::pi * a * a,
           .weight =
               [=](Vec2 at, double sigma, double) {
                 const double p2 = a * a - sigma * sigma, r2 = dot(at, at);
                 return std::exp(-r2 / p2) * (1 - c + c * (a * a * r2 / p2 - sigma * sigma) / p2);
               },
           .extent =
               [=](double faintest, double sigma, double) {
                 const double reach =
                     std::sqrt(a * a - sigma * sigma) * (std::sqrt(-std::log(faintest)) + 2);
                 return Vec2{reach, reach};
               }}};
    },
    [](const flow::InitialSettings& i, double sigma_0) {
      flow::hold_wider("initial.core", *i.core, sigma_0);
    }};

/// The list with one more line.
std::vector<const flow::InitialFlow*> with_hollow() {
  const flow::InitialFlows known = flow::initial_flows();
  std::vector<const flow::InitialFlow*> all(known.begin(), known.end());
  all.push_back(&hollow_vortex);
  return all;
}

const Key& key(const std::vector<Key>& keys, std::string_view name) {
  return *std::ranges::find(keys, name, &Key::name);
}

/// What a scene would have written.
flow::InitialSettings written(double hollow) {
  const auto known = with_hollow();
  flow::InitialSettings initial;
  const std::vector<Key> keys = flow::keys(initial, known);
  const OneOf& kind = std::get<OneOf>(key(keys, "kind").target);
  kind.set(std::ranges::find(kind.words, "hollow_vortex") - kind.words.begin());
  *std::get<std::optional<double>*>(key(keys, "circulation").target) = 2;
  *std::get<std::optional<double>*>(key(keys, "core").target) = 0.3;
  *std::get<std::optional<double>*>(key(keys, "hollow").target) = hollow;
  return initial;
}

/// Largest error of the blobs' vorticity, relative to the mean, out to two widths.
double error_of(const vortex::Blobs& blobs, const flow::InitialSettings& initial) {
  const Vec2 half = flow::half_extent(initial);
  std::vector<double> x, y;
  for (int j = -12; j <= 12; ++j)
    for (int i = -12; i <= 12; ++i) {
      x.push_back(i * half.x / 18.3);
      y.push_back(j * half.y / 18.9);
    }
  std::vector<double> omega(x.size());
  vortex::vorticity(blobs, nullptr, {x, y}, omega);
  double worst = 0;
  for (std::size_t k = 0; k < x.size(); ++k)
    worst = std::max(worst, std::abs(omega[k] - flow::vorticity(initial, {x[k], y[k]})));
  return worst / flow::mean_vorticity(initial);
}

}  // namespace

TEST_CASE("a made-up initial flow has its key, its limits and its refusals as the others") {
  const flow::InitialSettings initial = written(0.7);
  CHECK(initial.kind == &hollow_vortex);
  CHECK(initial.number("hollow") == 0.7);
  CHECK_NOTHROW(refuse(initial));
  CHECK_NOTHROW(refuse(initial, 0.03));
  CHECK_THROWS_WITH(refuse(initial, 0.3), "initial.core is 0.3; it must be > cores.sigma_0 = 0.3");
  flow::InitialSettings wrong = initial;
  wrong.numbers["hollow"].reset();
  CHECK_THROWS_WITH(refuse(wrong),
                    "initial.kind is \"hollow_vortex\"; that needs the key initial.hollow");
  wrong = initial;
  wrong.numbers["separation"] = 1;
  CHECK_THROWS_WITH(refuse(wrong),
                    "initial.kind is \"hollow_vortex\"; that does not have the key "
                    "initial.separation");
  flow::InitialSettings blank;
  const auto known = with_hollow();
  const std::vector<Key> keys = flow::keys(blank, known);
  CHECK(key(keys, "hollow").says == "hollow_vortex, which needs it: 1: no vorticity in the middle");
  CHECK_FALSE(key(keys, "hollow").rule.holds(1.1));
  CHECK_THAT(key(keys, "kind").says,
             Catch::Matchers::EndsWith("hollow_vortex: a vortex with a hole"));
}

TEST_CASE("a made-up initial flow cut into blobs is itself again, to 3e-4, and has its widths") {
  for (const double hollow : {0.0, 0.7, 1.0}) {
    const flow::InitialSettings initial = written(hollow);
    const vortex::Blobs blobs = vortex::cut({{}, 0.04, 0.04}, initial);
    CAPTURE(hollow);
    CHECK(error_of(blobs, initial) < 3e-4);
    double total = 0;
    for (const double gamma : blobs.gamma) total += gamma;
    CHECK(total == Approx(2).epsilon(1e-14));
  }
  CHECK(flow::least_width(written(1)) == 0.3);
  CHECK(flow::vortices(written(1)) == 1);
  CHECK(flow::lattice_blobs(written(0), 0.04) ==
        Approx(static_cast<double>(vortex::cut({{}, 0.04, 0.04}, written(0)).size())).epsilon(0.1));
}

TEST_CASE("each smooth initial flow cut into blobs is itself again, to 3e-4, pairs too") {
  int smooth = 0;
  for (const flow::InitialFlow* kind : flow::initial_flows()) {
    if (kind->sharp || kind->periodic) continue;
    flow::InitialSettings initial{.kind = kind, .circulation = 2, .core = 0.28};
    for (const Dimension& number : kind->dimensions)
      initial.numbers[number.name] = number.name == "separation" ? 0.9 : 0.2;
    CAPTURE(kind->name);
    CHECK(error_of(vortex::cut({{}, 0.04, 0.04}, initial), initial) < 3e-4);
    ++smooth;
  }
  CHECK(smooth == 5);
}

TEST_CASE("a patch is cut into cores of some width some way apart only") {
  const flow::Patch patch = flow::gaussian(1, 0.3, 0.3);
  CHECK_THROWS_AS(vortex::cut({{}, 0, 0.1}, patch), std::invalid_argument);
  CHECK_THROWS_AS(vortex::cut({{}, 0.1, 0}, patch), std::invalid_argument);
}
