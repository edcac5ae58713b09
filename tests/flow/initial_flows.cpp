#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

#include "flow/initial/widths.hpp"

using namespace vortree;
using flow::InitialSettings;

namespace {

constexpr double pi = std::numbers::pi, circulation = -1.5, a = 0.3;
constexpr Vec2 centre{0.7, -0.2};

InitialSettings initial(std::string_view kind, Dimensions numbers = {}) {
  InitialSettings made{.kind = &flow::initial_flow(kind),
                       .circulation = circulation,
                       .core = a,
                       .centre = {0.7, -0.2}};
  for (const auto& [name, value] : numbers) made.numbers.at(name) = value;
  return made;
}

const InitialSettings lamb = initial("lamb_oseen"),
                      gaussian = initial("gaussian_ellipse", {{"core_across", 0.2}}),
                      uniform = initial("kirchhoff_ellipse", {{"core_across", 0.15}}),
                      pair = initial("corotating_pair", {{"separation", 1.2}}),
                      dipole = initial("dipole", {{"separation", 1.2}}),
                      tripole = initial("tripole", {{"perturbation", 0.8}});

/// As the field's papers write it.
double lone(double x, double y) {
  return circulation / (pi * a * a) * std::exp(-(x * x + y * y) / (a * a));
}

/// Largest distance from a closed form, as seen from the centre, on points that meet no edge.
template <class Omega>
double apart(const InitialSettings& initial, Omega exact) {
  double worst = 0;
  for (int j = -17; j <= 17; ++j)
    for (int i = -17; i <= 17; ++i) {
      const double x = 0.071 * i, y = 0.053 * j;
      worst = std::max(worst, std::abs(vorticity(initial, centre + Vec2{x, y}) - exact(x, y)));
    }
  return worst / flow::mean_vorticity(initial);
}

/// The integral over the plane of what is less than 1e-16 beyond 4, by the rule of the middle.
template <class F>
double integral(F f, double h) {
  double sum = 0;
  for (double y = -4 + h / 2; y < 4; y += h)
    for (double x = -4 + h / 2; x < 4; x += h) sum += h * h * f(Vec2{x, y});
  return sum;
}

/// Whose words it refuses, and by which key.
std::string refused(const InitialSettings& initial, double sigma_0 = 0.05) {
  try {
    refuse(initial);
    refuse(initial, sigma_0);
  } catch (const Refused& refusal) {
    return refusal.key + ": " + refusal.what();
  }
  return "";
}

template <class Change>
InitialSettings changed(InitialSettings initial, Change change) {
  change(initial);
  return initial;
}

}  // namespace

TEST_CASE("the vorticity of each kind without cores is its closed form") {
  CHECK(apart(lamb, lone) < 1e-14);
  CHECK(apart(gaussian, [](double x, double y) {
          return circulation / (pi * a * 0.2) * std::exp(-x * x / (a * a) - y * y / 0.04);
        }) < 1e-14);
  CHECK(apart(uniform, [](double x, double y) {
          return std::hypot(x / a, y / 0.15) < 1 ? circulation / (pi * a * 0.15) : 0;
        }) < 1e-14);
  CHECK(apart(pair, [](double x, double y) { return lone(x + 0.6, y) + lone(x - 0.6, y); }) <
        1e-14);
  CHECK(apart(dipole, [](double x, double y) { return lone(x + 0.6, y) - lone(x - 0.6, y); }) <
        1e-14);
  CHECK(apart(tripole, [](double x, double y) {
          return lone(x, y) * (1 + 0.8 * (x * x - y * y) / (a * a));
        }) < 1e-14);
}

TEST_CASE("the weight of each patch adds up to its area, and its vorticity to the circulation") {
  // Smooth ones to round-off; the edge of a uniform ellipse crosses cells, h (a + b) of its area.
  for (const auto& [flow, h, error] :
       {std::tuple{&lamb, 0.05, 1e-12}, std::tuple{&gaussian, 0.05, 1e-12},
        std::tuple{&uniform, 0.005, 0.005 * 0.45 / (0.3 * 0.15)}, std::tuple{&pair, 0.05, 1e-12},
        std::tuple{&dipole, 0.05, 1e-12}, std::tuple{&tripole, 0.05, 1e-12}}) {
    CAPTURE(flow->kind->name);
    double total = 0;
    for (const flow::Patch& patch : flow->kind->patches(*flow)) {
      const double found = integral([&](Vec2 at) { return patch.weight(at, 0, 0); }, h);
      CHECK(found == Approx(patch.area).epsilon(error));
      total += patch.circulation;
    }
    CHECK(integral([&given = *flow](Vec2 at) { return vorticity(given, at); }, h) ==
          Approx(total).epsilon(error).margin(1e-12));
  }
  CHECK(dipole.kind->patches(dipole).front().circulation == circulation);
}

TEST_CASE("no weight beyond the extent of a patch is more than the faintest") {
  for (const InitialSettings* flow : {&lamb, &gaussian, &uniform, &pair, &dipole, &tripole})
    for (const double sigma : {0.0, 0.1})
      for (const double faintest : {1e-12, 1e-3}) {
        CAPTURE(flow->kind->name, sigma, faintest);
        const flow::Patch patch = flow->kind->patches(*flow).front();
        const Vec2 reach = patch.extent(faintest, sigma, sigma);
        for (double t = -3; t <= 3; t += 0.01)
          for (const Vec2 at : {Vec2{1.001 * reach.x, t}, Vec2{t, 1.001 * reach.y}})
            CHECK(std::abs(patch.weight(at, sigma, sigma)) <= faintest);
      }
}

TEST_CASE("widths, extents and counts of initial flows") {
  CHECK(flow::half_widths(lamb).y == a);
  CHECK(flow::half_widths(gaussian).y == 0.2);
  CHECK(flow::least_width(gaussian) == 0.2);
  CHECK(flow::least_width(uniform) == 0.15);
  CHECK(flow::least_width(dipole) == a);
  CHECK(flow::mean_vorticity(lamb) == Approx(1.5 / (pi * a * a)));
  CHECK(flow::mean_vorticity(dipole) == Approx(1.5 / (pi * a * a)));
  CHECK(flow::mean_vorticity(uniform) == Approx(1.5 / (pi * a * 0.15)));
  CHECK(flow::half_extent(lamb).x == Approx(3 * a));
  CHECK(flow::half_extent(gaussian).y == Approx(3 * 0.2));
  CHECK(flow::half_extent(uniform).x == Approx(a));
  CHECK(flow::half_extent(pair).x == Approx(3 * a + 0.6));
  CHECK(flow::half_extent(pair).y == Approx(3 * a));
  CHECK(flow::vortices(tripole) == 1);
  CHECK(flow::vortices(pair) == 2);
  // Cells of the ellipse where the weight is above the faintest, which two vortices have each.
  CHECK(flow::lattice_blobs(lamb, 0.03) ==
        Approx(pi * (a * a - 9e-4) * std::log(1e12) / 9e-4 + 1).epsilon(1e-14));
  CHECK(flow::lattice_blobs(pair, 0.03) == Approx(2 * flow::lattice_blobs(lamb, 0.03)));
  CHECK(flow::lattice_blobs(uniform, 0.01) == Approx(pi * 0.31 * 0.16 / 1e-4));
}

TEST_CASE("settings that make no initial flow are refused word by word, by their key") {
  for (const InitialSettings* good : {&lamb, &gaussian, &uniform, &pair, &dipole, &tripole})
    CHECK(refused(*good) == "");
  CHECK(refused(initial("dipole")) ==
        "initial: initial.kind is \"dipole\"; that needs the key initial.separation");
  CHECK(refused(initial("kirchhoff_ellipse")) ==
        "initial: initial.kind is \"kirchhoff_ellipse\"; that needs the key initial.core_across");
  CHECK(refused(initial("tripole")) ==
        "initial: initial.kind is \"tripole\"; that needs the key initial.perturbation");
  CHECK(refused(initial("lamb_oseen", {{"separation", 1}})) ==
        "initial.separation: initial.kind is \"lamb_oseen\"; that does not have the key "
        "initial.separation");
  CHECK(refused(changed(lamb, [](auto& i) { i.circulation = 0; })) ==
        "initial.circulation: initial.circulation is 0; there would be no vorticity to follow");
  CHECK(refused(changed(lamb, [](auto& i) { i.spacing = 3.5; })) ==
        "initial.spacing: initial.spacing is 3.5; blobs more than 3 cores apart make no vortex; 1 "
        "is right");
}

TEST_CASE("Gaussians as thin as cores, and pairs too near or too far, are refused word by word") {
  for (const InitialSettings* smooth : {&lamb, &gaussian, &pair, &dipole, &tripole})
    CHECK(refused(*smooth, 0.3) ==
          "initial.core: initial.core is 0.3; it must be > cores.sigma_0 = 0.3");
  CHECK(refused(gaussian, 0.2) ==
        "initial.core_across: initial.core_across is 0.2; it must be > cores.sigma_0 = 0.2");
  CHECK(refused(uniform, 1) == "");
  for (const char* kind : {"corotating_pair", "dipole"}) {
    CHECK(refused(initial(kind, {{"separation", 0.04}})) ==
          "initial.separation: initial.separation is 0.04; two vortices are at least a core, "
          "cores.sigma_0 = 0.05, apart");
    CHECK(refused(initial(kind, {{"separation", 5001}})) ==
          "initial.separation: initial.separation is 5001; vortices of cores.sigma_0 = 0.05 can be "
          "5000 apart at most");
  }
}

TEST_CASE("what is hardly meant is doubted in a sentence of the kind's own") {
  const auto doubts = [](const InitialSettings& i, double core) { return i.kind->doubts(i, core); };
  using Words = std::vector<std::string>;
  for (const InitialSettings* good : {&lamb, &gaussian, &uniform, &pair, &dipole, &tripole})
    CHECK(doubts(*good, 0.01).empty());
  CHECK(doubts(uniform, 0.05) == Words{"cores.sigma_0 = 0.05: the vortex's edge is as wide, and "
                                       "its half width is 0.15; 0.015 is right"});
  CHECK(doubts(initial("dipole", {{"separation", 0.5}}), 0.01) ==
        Words{"initial.separation = 0.5: two vortices of width 0.3 so near are one from the start; "
              "1.5 parts them"});
  CHECK(doubts(initial("tripole", {{"perturbation", -3}}), 0.01) ==
        Words{"initial.perturbation = -3: the vortex is less than what perturbs it; 0.1 to 1 is "
              "right"});
}

TEST_CASE("the list of initial flows: names of their own, the first by default, none made up") {
  CHECK(InitialSettings{}.kind == flow::initial_flows().front());
  CHECK(flow::initial_flows().front() == &flow::initial_flow("lamb_oseen"));
  std::set<std::string_view> names;
  for (const flow::InitialFlow* one : flow::initial_flows()) {
    CHECK(names.insert(one->name).second);
    CHECK(&flow::initial_flow(one->name) == one);
  }
  CHECK_THROWS_AS(flow::initial_flow("quadrupole"), std::out_of_range);
}

namespace {

const InitialSettings vortices = [] {
  InitialSettings made{.kind = &flow::initial_flow("taylor_green"), .centre = {0.7, -0.2}};
  made.numbers.at("wavelength") = 0.6, made.numbers.at("speed") = 2.5;
  return made;
}();

}  // namespace

TEST_CASE("vortices of Taylor and Green follow the equations of motion, the same after a period") {
  const double nu = 0.02, h = 1e-4;
  const flow::PeriodicFlow of = flow::periodic_flow(vortices, nu).value();
  CHECK(of.wavelength == 0.6);
  CHECK(of.speed == 2.5);
  const auto difference = [h](auto f, Vec2 by) { return 1 / (2 * h) * (f(h * by) - f(-h * by)); };
  const auto second = [h](auto f, Vec2 by) {
    return 1 / (h * h) * (f(h * by) - 2 * f(Vec2{}) + f(-h * by));
  };
  for (const Vec2 at : {Vec2{0.1, 0.2}, Vec2{-0.33, 0.4}, Vec2{1.2, -0.7}})
    for (const double t : {0.0, 0.3}) {
      const auto u = [&](Vec2 by) { return of.velocity(at + by, t); };
      const auto p = [&](Vec2 by) { return of.pressure(at + by, t); };
      const Vec2 ux = difference(u, {1, 0}), uy = difference(u, {0, 1}), here = u({});
      const Vec2 grad{difference(p, {1, 0}), difference(p, {0, 1})};
      const Vec2 rate = 1 / (2 * h) * (of.velocity(at, t + h) - of.velocity(at, t - h));
      const Vec2 left =
          rate + here.x * ux + here.y * uy + grad - nu * (second(u, {1, 0}) + second(u, {0, 1}));
      // Differences of h err by (2 pi h/L)^2/6 = 2e-7 of terms of U^2 2 pi/L = 65, (2.5 t)-fold.
      CHECK(std::abs(left.x) < 1e-3);
      CHECK(std::abs(left.y) < 1e-3);
      CHECK(std::abs(ux.x + uy.y) < 1e-4);
      CHECK(of.velocity(at + Vec2{0.6, -1.2}, t).x == Approx(here.x).margin(1e-12));
      CHECK(of.pressure(at + Vec2{0.6, -1.2}, t) == Approx(p({})).margin(1e-12));
    }
  double fastest = 0;
  for (double x = 0; x < 0.6; x += 0.01)
    for (double y = 0; y < 0.6; y += 0.01)
      fastest = std::max(fastest, std::abs(of.velocity({0.7 + x, -0.2 + y}, 0).x));
  CHECK(fastest == Approx(2.5).epsilon(1e-3));
}

TEST_CASE("a flow that fills the plane has no circulation and no core, and a vortex needs both") {
  CHECK(refused(vortices) == "");
  CHECK(refused(changed(vortices, [](auto& i) { i.core = 0.1; })) ==
        "initial.core: initial.kind is \"taylor_green\"; that does not have the key initial.core");
  CHECK(refused(changed(vortices, [](auto& i) { i.numbers.at("wavelength").reset(); })) ==
        "initial: initial.kind is \"taylor_green\"; that needs the key initial.wavelength");
  CHECK(refused(changed(lamb, [](auto& i) { i.core.reset(); })) ==
        "initial: [initial] needs the key core");
  CHECK_FALSE(flow::periodic_flow(lamb, 0.1));
}

TEST_CASE("keys of an initial flow in their order, set through their places") {
  InitialSettings made;
  std::vector<std::string_view> names;
  for (const Key& key : keys(made)) names.push_back(key.name);
  CHECK(names == std::vector<std::string_view>{"kind", "circulation", "core", "spacing", "centre",
                                               "core_across", "separation", "perturbation",
                                               "wavelength", "speed", "faintest"});
  CHECK(made == InitialSettings{});
  const std::vector<Key> all = keys(made);
  const OneOf& kind = std::get<OneOf>(all[0].target);
  CHECK(kind.get() == 0u);
  kind.set(4);
  CHECK(made.kind == &flow::initial_flow("dipole"));
  CHECK(kind.words[*kind.get()] == "dipole");
  *std::get<std::optional<double>*>(all[6].target) = 2;
  CHECK(made.number("separation") == 2);
  CHECK_THROWS_WITH(made.number("perturbation"), "no number perturbation of dipole");
}
