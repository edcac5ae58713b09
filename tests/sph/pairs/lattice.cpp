#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>

#include "papers.hpp"
#include "sph/pairs/sums.hpp"

using namespace vortree;
using sph::Kernel;
using tree::Listing;

namespace {

using Values = std::vector<double>;

// Particles of one reach at the corners of squares, and the row of the one in their middle.
class Lattice {
 public:
  static constexpr double x0 = 0.3, y0 = 0.7;  // the middle

  Lattice(double spacing, double reach, Kernel kernel) : kernel_(kernel) {
    const int most = static_cast<int>(std::ceil(reach / spacing));
    for (int i = -most; i <= most; ++i) {
      for (int j = -most; j <= most; ++j)
        x_.push_back(x0 + spacing * i), y_.push_back(y0 + spacing * j);
    }
    volume_.assign(x_.size(), spacing * spacing), reach_.assign(x_.size(), reach);
    list_middle();
  }

  // Of particles that carry f.
  double density(double (*f)(double, double)) const {
    Values mass = volume_, rho(x_.size());
    for (std::size_t i = 0; i < mass.size(); ++i) mass[i] *= f(x_[i], y_[i]);
    sph::density({{x_, y_}, mass, reach_, kernel_}, rows_, Listing::both_ways, rho);
    return rho[middle()];
  }

  std::pair<double, double> gradient(double (*f)(double, double)) const {
    Values at(x_.size()), gx(x_.size()), gy(x_.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = f(x_[i], y_[i]);
    sph::gradient({{x_, y_}, volume_, reach_, kernel_}, volume_, at, rows_, Listing::both_ways, gx,
                  gy);
    return {gx[middle()], gy[middle()]};
  }

 private:
  std::size_t middle() const { return x_.size() / 2; }

  void list_middle() {
    const std::size_t n = x_.size();
    rows_.start.renew(n + 1), rows_.index.renew(n - 1);
    for (std::size_t i = 0; i <= n; ++i)
      rows_.start[i] = i <= middle() ? 0 : static_cast<std::int64_t>(n - 1);
    std::size_t k = 0;
    for (std::size_t j = 0; j < n; ++j)
      if (j != middle()) rows_.index[k++] = static_cast<std::int32_t>(j);
  }

  Kernel kernel_;
  Values x_, y_, volume_, reach_;
  tree::PairList rows_;
};

double one(double, double) {
  return 1;
}

double wave(double x, double y) {
  return std::sin(x) * std::cos(0.8 * y);
}

double along_x(double x, double) {
  return x;
}

// What gradients come to as h goes to 0: half the integral of -r dW/dr over the disc, which is one
// less pi s^2 W at the edge s. All kernels but gaussian are zero there.
double limit(Kernel kernel) {
  const double s = sph::support(kernel);
  const double edge = test::printed(kernel, std::nextafter(s, 0.0), s).value(s);
  return 1 - std::numbers::pi * s * s * edge;
}

double density_off(const Lattice& lattice, Kernel) {
  return std::abs(lattice.density(one) - 1);
}

double gradient_off(const Lattice& lattice, Kernel kernel) {
  return std::abs(lattice.gradient(along_x).first - limit(kernel));
}

// The order in the reach of what a lattice of spacing one is off, from reaches of 8 to 16 to those
// of 16 to 32. On the way from one to two times a reach, waves in it go through all phases.
double order_of(double (*off)(const Lattice&, Kernel), Kernel kernel, double p) {
  const auto worst = [&](double from) {
    double most = 0;
    for (double reach = from; reach < 2 * from; reach += 0.125)
      most = std::max(most, off(Lattice(1, reach, kernel), kernel) * std::pow(reach, p));
    return most;
  };
  return p + std::log2(worst(8) / worst(16));
}

// What density and gradient of a wave come to, off what they do as h goes to 0.
std::pair<double, double> off(Kernel kernel, double h) {
  constexpr double x = Lattice::x0, y = Lattice::y0;
  const double support = sph::support(kernel), per_reach = 48;  // spacings in a reach
  const Lattice lattice(support * h / per_reach, support * h, kernel);
  const auto [gx, gy] = lattice.gradient(wave);
  return {std::abs(lattice.density(wave) - wave(x, y)),
          std::hypot(gx - limit(kernel) * std::cos(x) * std::cos(0.8 * y),
                     gy + limit(kernel) * 0.8 * std::sin(x) * std::sin(0.8 * y))};
}

}  // namespace

// How smooth a kernel is: r^n at the middle, for the least odd n; (s - r)^m at a radius s, for the
// least m.
struct Smoothness {
  double n, m;
};

TEST_CASE("on a lattice every kernel adds up to one, with the order of its smoothness") {
  constexpr double flat = INFINITY;
  const std::map<Kernel, Smoothness> smoothness{
      {Kernel::wendland_c2, {3, 4}}, {Kernel::wendland_c4, {5, 6}},
      {Kernel::wendland_c6, {7, 8}}, {Kernel::cubic_spline, {3, 3}},
      {Kernel::gaussian, {flat, 0}}, {Kernel::quintic_spline, {5, 5}},
      {Kernel::quadratic, {1, 2}},   {Kernel::bell, {3, 3}}};
  REQUIRE(smoothness.size() == sph::every_kernel.size());
  for (const auto& [kernel, smooth] : smoothness) {
    const double p = std::min(smooth.n + 2, smooth.m + 1.5);
    const double of_slope = std::min(smooth.n + 2, smooth.m + 0.5);
    CAPTURE(sph::name_of(kernel));
    // Middle and edge are half an order apart, and where the weaker one still counts it shows.
    CHECK(order_of(density_off, kernel, p) == Approx(p).margin(0.15));
    CHECK(order_of(gradient_off, kernel, of_slope) > of_slope - 0.25);
  }
}

TEST_CASE("with every kernel, density and gradient of a smooth field are of second order in h") {
  // The next term is of fourth order, a tenth of h^2 as large. A reach of 48 spacings leaves of
  // quadratic's cusp a thirtieth of the error, less of others'.
  for (const Kernel kernel : sph::every_kernel) {
    const auto [rho, slope] = off(kernel, 0.16);
    const auto [rho_half, slope_half] = off(kernel, 0.08);
    CAPTURE(sph::name_of(kernel), rho, rho_half, slope, slope_half);
    CHECK(std::log2(rho / rho_half) == Approx(2).margin(0.05));
    CHECK(std::log2(slope / slope_half) == Approx(2).margin(0.05));
  }
}
