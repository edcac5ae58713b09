#include "bench/tables/neighbor_uses.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "bench/rivals/neighbors/cell_lists.hpp"
#include "bench/sets/particle_sets.hpp"
#include "bench/sets/point_sets.hpp"
#include "provenance/provenance.hpp"
#include "sph/pairs/resolution.hpp"
#include "sph/pairs/sums.hpp"
#include "tree/neighbors/verlet_list.hpp"

namespace vortree::bench {
namespace {

using tree::Listing;
using tree::PairRule;
using Say = std::function<void(std::string_view)>;

class UsesTable {
 public:
  UsesTable(const std::filesystem::path& path, std::string_view header) : path_(path), out_(path) {
    for (const std::string& line : provenance()) write("# " + line);
    write(header);
  }
  void write(std::string_view line) {
    out_ << line << std::endl;
    if (!out_) throw std::runtime_error(path_.string() + ": cannot be written");
  }

 private:
  std::filesystem::path path_;
  std::ofstream out_;
};

template <class Work>
double seconds(const Work& work) {
  Stopwatch watch;
  work();
  return watch.elapsed();
}

// The least of several, for one thing after the other.
template <class Work>
double least_seconds(int repeats, const Work& work) {
  double least = INFINITY;
  for (int k = 0; k < repeats; ++k) least = std::min(least, seconds(work));
  return least;
}

enum class Way { full, half, visitor };

// A smooth field and its gradient.
struct SmoothField {
  static double f(double x, double y) { return std::sin(0.7 * x) * std::cos(0.5 * y); }
  static double x(double x, double y) { return 0.7 * std::cos(0.7 * x) * std::cos(0.5 * y); }
  static double y(double x, double y) { return -0.5 * std::sin(0.7 * x) * std::sin(0.5 * y); }
};

class SphSums {
 public:
  explicit SphSums(const char* name) : set_(make_particles(name, Order::sorted)) {
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const double dx = set_.reach[i] / 3.9;
      mass_.push_back(dx * dx);
      f_.push_back(SmoothField::f(set_.x[i], set_.y[i]));
    }
    for (auto* values : {&rho_, &gx_, &gy_}) values->resize(set_.size());
  }

  [[nodiscard]] std::string row(Way way, const char* words, const Say& say) {
    const Listing listing = way == Way::half ? Listing::once : Listing::both_ways;
    const auto search = [&] {
      search_.place(set_.points(), set_.reach);
      if (way != Way::visitor) search_.list(PairRule::mean, listing, rows_);
    };
    const auto density = [&] {
      way == Way::visitor ? sph::density(sources(), search_, rho_)
                          : sph::density(sources(), rows_, listing, rho_);
    };
    const auto gradient = [&] {
      way == Way::visitor ? sph::gradient(sources(), mass_, f_, search_, gx_, gy_)
                          : sph::gradient(sources(), mass_, f_, rows_, listing, gx_, gy_);
    };
    search();
    const double spent[] = {least_seconds(10, search), least_seconds(10, density),
                            least_seconds(10, gradient)};
    const auto [off, slope_off] = errors();
    const double n = static_cast<double>(set_.size());
    say(fmt::format(
        "density and gradient, {:8} search {:6.1f}  density {:6.1f}  gradient {:6.1f} "
        "ns a particle; errors {:.2e} {:.2e}",
        words, 1e9 * spent[0] / n, 1e9 * spent[1] / n, 1e9 * spent[2] / n, off, slope_off));
    return fmt::format("{},{},{},{:.6g},{:.6g},{:.6g},{:.4g},{:.4g}", words, set_.size(),
                       omp_get_max_threads(), spent[0], spent[1], spent[2], off, slope_off);
  }

 private:
  [[nodiscard]] sph::SmoothedParticles sources() const {
    return {set_.points(), mass_, set_.reach};
  }

  // Relative L2, a support away from the border and from the body.
  [[nodiscard]] std::pair<double, double> errors() const {
    double off = 0, slope_off = 0, slopes = 0, count = 0;
    for (std::size_t i = 0; i < set_.size(); ++i) {
      const double x = set_.x[i], y = set_.y[i], room = set_.reach[i];
      if (std::max(std::abs(x), std::abs(y)) > 10 - room || std::hypot(x, y) < 0.5 + room) continue;
      const double ex = SmoothField::x(x, y), ey = SmoothField::y(x, y);
      off += std::pow(rho_[i] - 1, 2), ++count;
      slope_off += std::pow(gx_[i] - ex, 2) + std::pow(gy_[i] - ey, 2);
      slopes += ex * ex + ey * ey;
    }
    return {std::sqrt(off / count), std::sqrt(slope_off / slopes)};
  }

  ParticleSet set_;
  std::vector<double> mass_, f_, rho_, gx_, gy_;
  tree::Neighbors search_;
  tree::PairList rows_;
};

void measure_sums(const std::filesystem::path& csv, bool small, const Say& say) {
  UsesTable table(csv, "way,n,threads,search,density,gradient,density_error,gradient_error");
  SphSums sums(small ? "cyl:5:17" : "cyl:5:100");
  for (const auto& [way, words] : {std::pair{Way::full, "full"}, std::pair{Way::half, "half"},
                                   std::pair{Way::visitor, "visitor"}}) {
    table.write(sums.row(way, words, say));
  }
}

sph::Particles moving_set(bool small) {
  const ParticleSet set = make_particles(small ? "cyl:3:20" : "cyl:3:100", Order::sorted);
  sph::Particles made;
  for (std::size_t i = 0; i < set.size(); ++i) {
    made.add(set.x[i], set.y[i], set.reach[i] * set.reach[i], set.reach[i]);
  }
  return made;
}

// A vortex carries them around; where it is strongest they are finer.
void advance(sph::Particles& p, int step) {
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double x = p.x[i], y = p.y[i], turn = 0.002 * std::exp(-(x * x + y * y) / 20);
    p.x[i] = x - turn * y, p.y[i] = y + turn * x;
  }
  if (step % 10 != 0) return;
  const double cx = 5 * std::cos(0.001 * step), cy = 5 * std::sin(0.001 * step);
  const auto inside = [&](std::size_t i) { return std::hypot(p.x[i] - cx, p.y[i] - cy) < 2; };
  sph::split(p, [&](std::size_t i) { return p.level(i) == 0 && inside(i); });
  sph::merge(p, [&](std::size_t i) { return !inside(i); });
}

void measure_moving(const std::filesystem::path& csv, bool small, int steps, const Say& say) {
  UsesTable table(csv, "way,n,steps,threads,seconds");
  sph::Particles p = moving_set(small);
  tree::Neighbors kept;
  tree::VerletList skinned(PairRule::max, Listing::both_ways, 0.1);
  tree::PairList rows, narrow;
  double warm = 0, fresh = 0, skin = 0, particles = 0;
  int rebuilt = 0;
  for (int step = 1; step <= steps; ++step) {
    advance(p, step);
    particles += static_cast<double>(p.size());
    warm += seconds([&] {
      kept.place(p.points(), p.reach);
      kept.list(PairRule::max, Listing::both_ways, rows);
    });
    fresh += seconds([&] {
      tree::Neighbors search;
      tree::PairList own;
      search.place(p.points(), p.reach);
      search.list(PairRule::max, Listing::both_ways, own);
    });
    skin += seconds([&] {
      if (!skinned.outdated(p.points(), p.reach)) return;
      skinned.rebuild(p.points(), p.reach);
      ++rebuilt;
    });
  }
  const auto write = [&](std::string_view way, double spent) {
    table.write(fmt::format("{},{:.0f},{},{},{:.6g}", way, particles / steps, steps,
                            omp_get_max_threads(), spent / steps));
    say(fmt::format("moving, {:8} {:6.1f} ns a particle and step", way, 1e9 * spent / particles));
  };
  write("kept", warm), write("scratch", fresh), write("skin", skin);
  say(fmt::format("moving, skin: rebuilt in {} of {} steps", rebuilt, steps));
}

void measure_cells(const std::filesystem::path& csv, std::size_t most, const Say& say) {
  UsesTable table(csv, "dimensions,n,naive,cells,pairs");
  for (const int dimensions : {2, 3}) {
    for (std::size_t n = 250; n <= most; n *= 2) {
      const Coordinates points = random_coordinates(dimensions, n);
      // As many neighbors as a lattice of spacing s has within 2.4 s, twice h = 1.2 s.
      const double spacing = std::pow(static_cast<double>(n), -1.0 / dimensions);
      std::size_t pairs = 0;
      const double naive =
          least_seconds(2, [&] { pairs = neighbors_naive(points, 2.4 * spacing).size(); });
      const double cells = least_seconds(3, [&] {
        pairs = 0;
        for (const auto& list : neighbors_by_cells(points, 2.4 * spacing)) pairs += list.size();
      });
      table.write(fmt::format("{},{},{:.6g},{:.6g},{}", dimensions, n, naive, cells, pairs));
      say(fmt::format("{} dimensions, {:6} points: naive {:9.3f} ms, cells {:8.3f} ms", dimensions,
                      n, 1e3 * naive, 1e3 * cells));
    }
  }
}

}  // namespace

void neighbor_uses(const std::filesystem::path& folder, bool quick, std::size_t largest,
                   const Say& say) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const bool small = largest > 0 && largest < 33170;
  const std::size_t most = quick ? 16'000 : 64'000;
  measure_sums(folder / "sph.csv", small, say);
  measure_moving(folder / "moving.csv", small, quick ? 100 : 1000, say);
  measure_cells(folder / "cells.csv", small ? std::min(largest, most) : most, say);
  omp_set_num_threads(threads);
}

}  // namespace vortree::bench
