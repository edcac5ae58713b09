#include "bench/sets/particle_sets.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "base/random.hpp"
#include "tree/order/morton.hpp"

namespace vortree::bench {
namespace {

constexpr std::uint64_t seed = 20181024;

// In [-1, 1).
double unit(std::uint64_t hash) {
  return static_cast<double>(hash >> 11) * (2.0 / 9007199254740992.0) - 1.0;
}

struct Ellipse {
  double middle, a, b;  // on the x axis; half axes
  [[nodiscard]] bool holds(double x, double y) const {
    const double u = (x - middle) / a, v = y / b;
    return u * u + v * v < 1;
  }
};

// Of given areas, drawn out downstream.
std::vector<Ellipse> around_cylinder() {
  std::vector<Ellipse> made;
  for (const double area : {13.659, 10.752, 4.2255, 3.9347}) {
    const double b = std::sqrt(area / (1.5 * std::numbers::pi)), a = 1.5 * b;
    made.push_back({0.25 * a, a, b});
  }
  return made;
}

std::vector<Ellipse> around_foil() {
  std::vector<Ellipse> made;
  for (const double area : {40.0, 20.0, 8.0, 4.5, 1.17, 0.86}) {
    const double b = std::sqrt(area / (2.5 * std::numbers::pi)), a = 2.5 * b;
    made.push_back({0.5 + 0.2 * (a - 0.6), a, b});
  }
  return made;
}

bool inside_cylinder(double x, double y) {
  return x * x + y * y < 0.25;
}

// NACA 0012, chord from 0 to 1.
bool inside_foil(double x, double y) {
  if (x < 0 || x > 1) return false;
  const double half = 0.6 * (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                             0.2843 * x * x * x - 0.1015 * x * x * x * x);
  return std::abs(y) < half;
}

bool nowhere(double, double) {
  return false;
}

// Its lower left corner is (-10, -10).
struct SetLayout {
  double width, height;
  int columns, rows, levels;
  std::vector<Ellipse> ellipses;
  bool (*inside_body)(double x, double y);
};

class Generator {
 public:
  explicit Generator(const SetLayout& layout)
      : layout_(layout), spacing_(layout.width / layout.columns) {}

  ParticleSet run() {
    for (int iy = 0; iy < layout_.rows; ++iy) {
      for (int ix = 0; ix < layout_.columns; ++ix) add(0, ix, iy);
    }
    return std::move(set_);
  }

 private:
  void add(int level, std::int64_t ix, std::int64_t iy) {
    const double dx = spacing_ / static_cast<double>(1 << level);
    const double x = -10 + (static_cast<double>(ix) + 0.5) * dx;
    const double y = -10 + (static_cast<double>(iy) + 0.5) * dx;
    if (level < layout_.levels - 1 && layout_.ellipses[level].holds(x, y)) {
      for (int q = 0; q < 4; ++q) add(level + 1, 2 * ix + (q & 1), 2 * iy + (q >> 1));
      return;
    }
    if (layout_.inside_body(x, y)) return;
    const std::uint64_t place = static_cast<std::uint64_t>(level) << 60 |
                                static_cast<std::uint64_t>(iy) << 30 |
                                static_cast<std::uint64_t>(ix);
    const std::uint64_t one = splitmix64(seed ^ splitmix64(place)), two = splitmix64(one);
    set_.x.push_back(static_cast<float>(x + 0.1 * dx * unit(one)));
    set_.y.push_back(static_cast<float>(y + 0.1 * dx * unit(two)));
    set_.reach.push_back(static_cast<float>(3.9 * dx));
    set_.level.push_back(static_cast<std::uint8_t>(level));
  }

  const SetLayout& layout_;
  double spacing_;
  ParticleSet set_;
};

[[noreturn]] void refuse(std::string_view name) {
  throw std::invalid_argument("no particle set \"" + std::string(name) +
                              "\"; expected uni:n, cyl:L:n (L <= 5) or foil:L:n (L <= 7)");
}

SetLayout parse(std::string_view name) {
  std::vector<int> numbers;
  const std::string_view kind = name.substr(0, name.find(':'));
  for (std::size_t colon = kind.size(); colon < name.size();) {
    const std::size_t next = std::min(name.find(':', colon + 1), name.size());
    int number = 0;
    const auto [end, failed] = std::from_chars(name.data() + colon + 1, name.data() + next, number);
    if (failed != std::errc() || end != name.data() + next || number < 1) refuse(name);
    numbers.push_back(number);
    colon = next;
  }
  if (kind == "uni" && numbers.size() == 1) {
    return {20, 20, numbers[0], numbers[0], 1, {}, nowhere};
  }
  if (numbers.size() != 2) refuse(name);
  SetLayout layout{20, 20, numbers[1], numbers[1], numbers[0], around_cylinder(), inside_cylinder};
  if (kind == "foil") {
    layout = {30, 20, numbers[1], numbers[1] * 2 / 3, numbers[0], around_foil(), inside_foil};
  } else if (kind != "cyl") {
    refuse(name);
  }
  if (layout.levels > static_cast<int>(layout.ellipses.size()) + 1) refuse(name);
  return layout;
}

void permute(ParticleSet& set, const std::vector<std::uint32_t>& order) {
  const auto apply = [&](auto& values) {
    auto old = values;
    for (std::size_t i = 0; i < order.size(); ++i) values[i] = old[order[i]];
  };
  apply(set.x), apply(set.y), apply(set.reach), apply(set.level);
}

void shuffle(std::vector<std::uint32_t>& order) {
  std::uint64_t state = seed;
  for (std::size_t i = order.size(); i > 1; --i) {
    state = splitmix64(state + i);
    std::swap(order[i - 1], order[state % i]);
  }
}

// By Morton codes on a grid of 65536 x 65536.
void sort(std::vector<std::uint32_t>& order, const ParticleSet& set, const SetLayout& layout) {
  const double scale = 65535.0 / std::max(layout.width, layout.height);
  std::vector<tree::MortonKey> key(order.size());
  for (std::size_t i = 0; i < key.size(); ++i) {
    key[i] = tree::encode({static_cast<std::uint32_t>((set.x[i] + 10) * scale),
                           static_cast<std::uint32_t>((set.y[i] + 10) * scale)});
  }
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return key[i]; });
}

}  // namespace

ParticleSet make_particles(std::string_view name, Order order) {
  const SetLayout layout = parse(name);
  ParticleSet set = Generator(layout).run();
  std::vector<std::uint32_t> permutation(set.size());
  std::iota(permutation.begin(), permutation.end(), 0u);
  if (order == Order::shuffled) shuffle(permutation);
  if (order == Order::sorted) sort(permutation, set, layout);
  if (order != Order::made) permute(set, permutation);
  return set;
}

}  // namespace vortree::bench
