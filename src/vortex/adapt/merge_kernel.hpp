#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "tree/base/simd.hpp"
#include "vortex/adapt/adaptation.hpp"
#include "vortex/adapt/merge_close.hpp"

namespace vortree::vortex::merge_kernel {

// What follows is written once for V, a register full of floats (Singles) or one, its plain twin.

template <class V>
inline constexpr std::size_t lanes_of = sizeof(V) / sizeof(float);
template <class V>
using Chosen = decltype(V{} < V{});

template <class V>
[[gnu::always_inline]] inline V everywhere(float value) {
  return value - V{};
}
template <class V>
[[gnu::always_inline]] inline V load_from(const float* from) {
  if constexpr (std::is_same_v<V, float>)
    return *from;
  else
    return load(from);
}
inline void store(float* to, float a) {
  *to = a;
}
inline float larger(float a, float b) {
  return a > b ? a : b;
}
inline float smaller(float a, float b) {
  return a < b ? a : b;
}
inline float select(bool condition, float a, float b) {
  return condition ? a : b;
}
inline float magnitude(float a) {
  return std::abs(a);
}
using vortree::larger, vortree::smaller, vortree::magnitude, vortree::select, vortree::store;

constexpr float never = std::numeric_limits<float>::infinity();
constexpr std::uint32_t none = ~0u;

/// The partner with which merging costs least.
struct MergeChoice {
  std::uint32_t partner = none;
  float error = never;
};

/// What a choice of partners looks at, in single precision: a choice to seven digits is as good,
/// and twice as many fit a vector.
struct Limits {
  /// Lengths are looked at in widest cores, circulations in tolerances times that, to a power of
  /// two: single precision has too few exponents for the units of every scene.
  struct Units {
    double per_length = 1, per_circulation = 1;

    explicit Units(const Merging& merging)
        : per_length(std::exp2(-std::ilogb(merging.sigma_max))),
          per_circulation(per_length * std::exp2(-std::ilogb(merging.tolerance))) {}
  };

  Units units;
  float tolerance, reach2, widest2;

  explicit Limits(const Merging& merging)
      : units(merging),
        tolerance(static_cast<float>(merging.tolerance * units.per_circulation / units.per_length)),
        reach2(static_cast<float>(merging.reach * merging.reach)),
        widest2(static_cast<float>(std::pow(merging.sigma_max * units.per_length, 2))) {}
};

template <class V>
struct Traits {
  V x, y, gamma, square, inverse_cube, widening2;
};

/// Error of merging a with b, and where merge_close.hpp allows it but for the tolerance: for blobs
/// of like sign, whose gamma are both given as positive.
template <class V>
struct Price {
  V error;
  Chosen<V> within;
};
template <class V>
[[gnu::always_inline]] inline Price<V> price(const Traits<V>& a, const Traits<V>& b,
                                             const Limits& limits) {
  const V dx = a.x - b.x, dy = a.y - b.y;
  const V d2 = dx * dx + dy * dy;
  const V w = a.gamma / (a.gamma + b.gamma);
  const V unlike = a.square - b.square;
  const V cost = w * b.gamma * (d2 + magnitude(unlike)) * larger(a.inverse_cube, b.inverse_cube);
  const V wide = b.square + w * (unlike + (1.0f - w) * d2);
  const Chosen<V> near = d2 <= limits.reach2 * smaller(a.square, b.square);
  const Chosen<V> narrow = wide <= limits.widest2 * smaller(a.widening2, b.widening2);
  return {cost, Chosen<V>(near & narrow)};
}

/// The error where it is allowed, `never` elsewhere.
template <class V>
[[gnu::always_inline]] inline V error(const Traits<V>& a, const Traits<V>& b,
                                      const Limits& limits) {
  const auto [cost, within] = price(a, b, limits);
  const Chosen<V> allowed = within & (cost <= limits.tolerance);
  return select(allowed, cost, everywhere<V>(never));
}

/// Traits in columns.
template <class Column>
struct MergeColumns {
  Column x, y, gamma, square, inverse_cube, widening2;

  void resize(std::size_t n) {
    for (Column* column : {&x, &y, &gamma, &square, &inverse_cube, &widening2}) column->resize(n);
  }
  /// How many times the widest core, and the tolerance.
  struct Times {
    float widest = 1, tolerance = 1;
  };

  /// gamma must be positive; too small a one vanishes in single precision, and is kept above it. A
  /// wider tolerance is an error as many times smaller.
  void put(std::size_t k, const Limits::Units& units, Vec2 at, double g, double s2,
           Times times = {}) {
    x[k] = static_cast<float>(at.x * units.per_length);
    y[k] = static_cast<float>(at.y * units.per_length);
    gamma[k] = std::max(static_cast<float>(g * units.per_circulation), 1e-30f);
    square[k] = static_cast<float>(s2 * units.per_length * units.per_length);
    inverse_cube[k] = 1 / (square[k] * std::sqrt(square[k]) * times.tolerance);
    widening2[k] = times.widest * times.widest;
  }
  void copy(std::size_t to, const auto& from, std::size_t k) {
    x[to] = from.x[k];
    y[to] = from.y[k];
    gamma[to] = from.gamma[k];
    square[to] = from.square[k];
    inverse_cube[to] = from.inverse_cube[k];
    widening2[to] = from.widening2[k];
  }
  /// The one at k, in all lanes.
  template <class V>
  Traits<V> lone(std::size_t k) const {
    const auto of = [k](const Column& column) { return everywhere<V>(column[k]); };
    return {of(x), of(y), of(gamma), of(square), of(inverse_cube), of(widening2)};
  }
  /// Those from k on, one a lane.
  template <class V>
  Traits<V> lanes(std::size_t k) const {
    const auto from = [k](const Column& column) { return load_from<V>(&column[k]); };
    return {from(x), from(y), from(gamma), from(square), from(inverse_cube), from(widening2)};
  }
};

/// Blobs that look for partners together, one a lane.
template <class V>
class Seekers {
 public:
  static constexpr std::size_t most = lanes_of<V>;

  std::size_t size() const { return size_; }

  void add(const auto& columns, std::size_t k, std::uint32_t number) {
    numbers_[size_] = tag(number);
    mine_.copy(size_++, columns, k);
  }

  /// Hands a function that considers one more candidate, given by number, to `all`, which is to
  /// call it for every candidate. Among equals, the first is chosen.
  void choose(const auto& columns, const Limits& limits, const auto& all) {
    for (std::size_t k = size_; k < most; ++k) {
      mine_.copy(k, mine_, 0);
      numbers_[k] = numbers_[0];
    }
    const Traits<V> seekers = mine_.template lanes<V>(0);
    const V own = load_from<V>(numbers_.data());
    V least = everywhere<V>(std::nextafter(limits.tolerance, never));
    V partner = everywhere<V>(tag(none));
    all([&](std::uint32_t number) {
      const auto [e, within] = price(seekers, columns.template lone<V>(number), limits);
      const V candidate = everywhere<V>(tag(number));
      const Chosen<V> better = within & (e < least) & (own != candidate);
      least = select(better, e, least);
      partner = select(better, candidate, partner);
    });
    store(errors_.data(), least);
    store(partners_.data(), partner);
  }

  MergeChoice choice(std::size_t k) const {
    const std::uint32_t partner = number(partners_[k]);
    return partner != none ? MergeChoice{partner, errors_[k]} : MergeChoice{};
  }

 private:
  // Numbers travel in vectors of float as the bits of floats above 1, where none is denormal.
  static float tag(std::uint32_t number) { return std::bit_cast<float>(number + 0x3f800000u); }
  static std::uint32_t number(float tag) { return std::bit_cast<std::uint32_t>(tag) - 0x3f800000u; }

  MergeColumns<std::array<float, most>> mine_;
  std::array<float, most> numbers_, errors_, partners_;
  std::size_t size_ = 0;
};

/// The partner of blob `own` among the candidates in runs of columns, a vector of them at a time;
/// the same as Seekers choose, but for candidates beyond a run's end, which count, too. Columns
/// must go on for a vector's more places, whose x is `never`.
class LoneSeeker {
 public:
  LoneSeeker(const auto& columns, std::uint32_t own)
      : mine_(columns.template lone<Singles>(own)), own_(own) {}

  void consider(const auto& columns, std::uint32_t first, std::uint32_t last,
                const Limits& limits) {
    for (; first < last; first += single_count) {
      Singles e = error(mine_, columns.template lanes<Singles>(first), limits);
      if (own_ - first < single_count) e[own_ - first] = never;
      if (where(e < least_.error) != 0) take(e, first);
    }
  }

  MergeChoice choice() const { return least_; }

 private:
  void take(Singles e, std::uint32_t first) {
    for (std::uint32_t k = 0; k < single_count; ++k)
      if (e[k] < least_.error) least_ = {first + k, e[k]};
  }

  Traits<Singles> mine_;
  std::uint32_t own_;
  MergeChoice least_;
};

/// Like signed blobs that merge among each other, at most so many at once.
class MergeWindow {
 public:
  static constexpr std::size_t most = 32;

  /// Merges pairs of mutual choice until there is none. `members` are numbers of blobs; those that
  /// are left come first, in their order, and are counted.
  std::size_t merge(std::span<std::uint32_t> members, std::span<AdaptedBlob> adapted,
                    std::span<AtWall> at_wall, const Limits& limits);

 private:
  using Set = std::uint32_t;  // a bit each
  using Number = std::uint8_t;
  static constexpr Number nobody = 0xff;

  void look_at(std::span<const std::uint32_t> members, std::span<const AdaptedBlob> adapted,
               const Limits& limits);
  void choose(const Limits& limits);
  void offer();
  Set pair_up();

  MergeColumns<std::array<float, most>> traits_;
  std::array<float, most> error_;
  std::array<Number, most> partner_;
  Set alive_, seeking_, chose_;
};

/// Merges q into p.
void merge(AdaptedBlob& p, const AdaptedBlob& q, std::span<AtWall> at_wall);

}  // namespace vortree::vortex::merge_kernel
