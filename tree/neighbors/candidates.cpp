#include "tree/neighbors/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tree/neighbors/exact_distance.hpp"

namespace vortree::tree {

namespace {

// Beyond this, squares of floats are not safe from overflow; fillers are ten times as far.
constexpr float largest_float = 1e17f, nowhere = 1e18f;

// Of a neighbor that is as near as its reach r allows, the distance to the box as a float is less
// than r (1 + 2^-22): the half width makes up for rounded positions. The squares and their sum add
// less than 2^-21, rounded reaches 2^-22: a limit longer by 1e-4 drops nobody. The second number
// makes up for squares that underflow.
constexpr float longer = 1.0001f, least_limit = 1e-37f;

constexpr std::size_t in_registers(std::size_t n) {
  return (n + single_count - 1) / single_count;
}

}  // namespace

Candidates::Frame Candidates::frame(const SortedParticles& placed, Range own, double length) {
  double left = placed.x[own.first], right = left, low = placed.y[own.first], high = low;
  double largest = 0;
  for (std::uint32_t p = own.first; p < own.last; ++p) {
    left = std::min(left, placed.x[p]), right = std::max(right, placed.x[p]);
    low = std::min(low, placed.y[p]), high = std::max(high, placed.y[p]);
    largest = std::max(largest, placed.reach[p]);
  }
  // Any place will do as the middle, and the rounded one is off by as much as coordinates are: the
  // half width is how far the box goes from there. Of positions x, |x - middle| is rounded by three
  // operations in doubles and once to a float, less than (1 + 2^-23); the half width by as much. So
  // a half width that is 2^-20 longer holds all own ones as floats, whatever the coordinates are.
  const double middle_x = left + (right - left) / 2, middle_y = low + (high - low) / 2;
  const auto half = [&](double from, double middle, double to) {
    return static_cast<float>(std::max(middle - from, to - middle) / length * (1 + 0x1p-20));
  };
  return {middle_x,
          middle_y,
          1 / length,
          half(left, middle_x, right),
          half(low, middle_y, high),
          static_cast<float>(largest / length),
          !(largest > 0)};
}

template <PairRule rule>
void Candidates::add_own(const SortedParticles& placed, Range own, const Frame& frame) {
  for (std::uint32_t k = own.first; k < own.last; k += single_count, size_ += single_count) {
    const Singles u = kernel::near_floats(placed.x.data() + k, frame.x, frame.scale);
    const Singles v = kernel::near_floats(placed.y.data() + k, frame.y, frame.scale);
    const Singles r = kernel::near_floats(placed.reach.data() + k, 0, frame.scale);
    store(u_.data() + size_, u);
    store(v_.data() + size_, v);
    store(reach_.data() + size_, rule == PairRule::mean ? 0.5f * r : r * r);
  }
  size_ = own.size();
}

// Those that reach nobody do not look at each other, however many lie in one place.
template <PairRule rule, bool quiet>
void Candidates::add(const SortedParticles& placed, Range others, const Frame& frame) {
  const Singles zero{}, own = fill(kernel::reach_term<rule>(frame.largest));
  Singles farthest = fill(farthest_);
  for (std::uint32_t k = others.first; k < others.last; k += single_count) {
    const Singles u = kernel::near_floats(placed.x.data() + k, frame.x, frame.scale);
    const Singles v = kernel::near_floats(placed.y.data() + k, frame.y, frame.scale);
    Singles r{}, term{};
    if constexpr (rule != PairRule::own) {
      r = kernel::near_floats(placed.reach.data() + k, 0, frame.scale);
      term = rule == PairRule::mean ? 0.5f * r : r * r;
    }
    const Singles du = larger(magnitude(u) - frame.half_u, zero);
    const Singles dv = larger(magnitude(v) - frame.half_v, zero);
    const Singles limit = kernel::threshold<rule>(own, term) * longer + least_limit;
    auto keep = static_cast<kernel::Hits>(kernel::not_above(du * du + dv * dv, limit) &
                                          kernel::first_singles(others.last - k));
    if constexpr (quiet) keep &= kernel::positive(placed.reach.data() + k);
    kept_.push_back(keep);
    if (keep == 0) continue;
    const Singles far = larger(larger(magnitude(u), magnitude(v)), r);
    farthest = larger(farthest, far);
    kernel::store_close(u_.data() + size_, u, keep);
    kernel::store_close(v_.data() + size_, v, keep);
    if constexpr (rule != PairRule::own) kernel::store_close(reach_.data() + size_, term, keep);
    size_ += static_cast<std::size_t>(std::popcount(keep));
  }
  for (int i = 0; i < single_count; ++i) farthest_ = std::max(farthest_, farthest[i]);
}

// Fills the last register with what is near to nobody.
void Candidates::close() {
  registers_ = in_registers(size_);
  for (std::size_t k = size_; k < registers_ * single_count; ++k) {
    u_[k] = v_[k] = nowhere;
    reach_[k] = 0;
  }
}

template <PairRule rule>
void Candidates::gather(const SortedParticles& placed, Range own, std::span<const Range> others,
                        double length) {
  std::size_t room = own.size();
  for (const Range range : others) room += range.size();
  for (Buffer<float>* values : {&u_, &v_, &reach_}) values->renew(room + 2 * single_count);
  placed_ = &placed;
  own_ = own;
  others_.assign(others.begin(), others.end());
  kept_.clear();
  position_.clear();
  size_ = 0;
  const Frame around = frame(placed, own, length);
  farthest_ = around.largest;
  add_own<rule>(placed, own, around);
  for (const Range range : others) {
    around.quiet ? add<rule, true>(placed, range, around) : add<rule, false>(placed, range, around);
  }
  close();
  const float widest = std::max(around.half_u, around.half_v);
  h2_ = widest * widest + 1e-30f;
}

void Candidates::find_positions() {
  position_.resize(own_.size());
  std::iota(position_.begin(), position_.end(), static_cast<std::int32_t>(own_.first));
  const kernel::Hits* set = kept_.data();
  for (const Range range : others_) {
    for (std::uint32_t k = range.first; k < range.last; k += single_count) {
      for (unsigned lanes = *set++; lanes != 0; lanes &= lanes - 1) {
        position_.push_back(static_cast<std::int32_t>(k) + std::countr_zero(lanes));
      }
    }
  }
}

template <PairRule rule>
std::int64_t Candidates::test(std::size_t local, std::size_t first, kernel::Hits* hits) {
  const kernel::Tested tested =
      kernel::test<rule>({u_.data(), v_.data(), reach_.data()}, first, registers_, u_[local],
                         v_[local], reach_[local], kernel::doubt * h2_, hits);
  if (tested.sure && farthest_ < largest_float) return tested.hits;
  if (position_.empty()) find_positions();
  return exact_test(*placed_, rule, own_.first + static_cast<std::uint32_t>(local),
                    std::span(position_).subspan(first * single_count), hits);
}

std::size_t gather_numbers(const Buffer<std::int32_t>& of, Range own, std::span<const Range> others,
                           const kernel::Hits* kept, std::int32_t* to, std::size_t& count) {
  std::copy(of.data() + own.first, of.data() + own.last, to);
  std::int32_t* next = to + own.size();
  const kernel::Hits* set = kept;
  for (const Range range : others) {
    for (std::uint32_t k = range.first; k < range.last; k += single_count, ++set) {
      kernel::store_close(next, load(of.data() + k), *set);
      next += std::popcount(*set);
    }
  }
  count = static_cast<std::size_t>(next - to);
  return static_cast<std::size_t>(set - kept);
}

template void Candidates::gather<PairRule::max>(const SortedParticles&, Range,
                                                std::span<const Range>, double);
template void Candidates::gather<PairRule::mean>(const SortedParticles&, Range,
                                                 std::span<const Range>, double);
template void Candidates::gather<PairRule::own>(const SortedParticles&, Range,
                                                std::span<const Range>, double);
template std::int64_t Candidates::test<PairRule::max>(std::size_t, std::size_t, kernel::Hits*);
template std::int64_t Candidates::test<PairRule::mean>(std::size_t, std::size_t, kernel::Hits*);
template std::int64_t Candidates::test<PairRule::own>(std::size_t, std::size_t, kernel::Hits*);

}  // namespace vortree::tree
