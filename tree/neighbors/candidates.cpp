#include "tree/neighbors/candidates.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <type_traits>

#include "tree/neighbors/exact_distance.hpp"

namespace vortree::tree {

namespace {

// Beyond these, squares of floats are not safe from overflow; fillers are ten times as far.
constexpr float largest_float = 1e17f, largest_limit = 1e34f, nowhere = 1e18f;

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
  size_ = 0;
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
//
// Whoever is kept is no farther from the box than its limit allows: limits tell whether squares
// overflow. Pointers and counts are copied: a store of a register might change any member.
template <PairRule rule, bool quiet>
void Candidates::add(const SortedParticles& placed, std::span<const Range> others,
                     const Frame& frame, kernel::Hits* kept) {
  const double *x = placed.x.data(), *y = placed.y.data(), *reach = placed.reach.data();
  float *to_u = u_.data() + size_, *to_v = v_.data() + size_, *to_reach = reach_.data() + size_;
  const Singles zero{}, own = fill(kernel::reach_term<rule>(frame.largest));
  const Frame at = frame;
  Singles longest = kernel::threshold<rule>(own, own);
  std::size_t count = 0;
  for (const Range range : others) {
    for (std::uint32_t k = range.first; k < range.last; k += single_count) {
      const Singles u = kernel::near_floats(x + k, at.x, at.scale);
      const Singles v = kernel::near_floats(y + k, at.y, at.scale);
      Singles term{};
      if constexpr (rule != PairRule::own) {
        const Singles r = kernel::near_floats(reach + k, 0, at.scale);
        term = rule == PairRule::mean ? 0.5f * r : r * r;
      }
      const Singles du = larger(magnitude(u) - at.half_u, zero);
      const Singles dv = larger(magnitude(v) - at.half_v, zero);
      const Singles limit = kernel::threshold<rule>(own, term);
      longest = larger(longest, limit);
      auto keep = static_cast<kernel::Hits>(
          kernel::not_above(du * du + dv * dv, limit * longer + least_limit) &
          kernel::first_singles(range.last - k));
      if constexpr (quiet) keep &= kernel::positive(reach + k);
      *kept++ = keep;
      kernel::store_close(to_u + count, u, keep);
      kernel::store_close(to_v + count, v, keep);
      if constexpr (rule != PairRule::own) kernel::store_close(to_reach + count, term, keep);
      count += static_cast<std::size_t>(std::popcount(keep));
    }
  }
  size_ += count;
  for (int i = 0; i < single_count; ++i) in_floats_ &= longest[i] < largest_limit;
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
                        double length, Unwritten<kernel::Hits>& kept) {
  std::size_t room = own.size() + 2 * single_count, sets = 0;
  for (const Range range : others) room += range.size(), sets += in_registers(range.size());
  for (Buffer<float>* values : {&u_, &v_, &reach_}) values->widen(room);
  const std::size_t before = kept.size();
  kept.resize(before + sets);
  kernel::Hits* to = kept.data() + before;
  placed_ = &placed, own_ = own, others_ = others, kept_ = to;
  position_.clear();
  const Frame around = frame(placed, own, length);
  const float widest = std::max(around.half_u, around.half_v);
  h2_ = widest * widest + 1e-30f;
  in_floats_ = widest < largest_float && std::isfinite(around.scale);
  add_own<rule>(placed, own, around);
  around.quiet ? add<rule, true>(placed, others, around, to)
               : add<rule, false>(placed, others, around, to);
  close();
}

void Candidates::find_positions() {
  position_.resize(own_.size());
  std::iota(position_.begin(), position_.end(), static_cast<std::int32_t>(own_.first));
  const kernel::Hits* set = kept_;
  for (const Range range : others_) {
    for (std::uint32_t k = range.first; k < range.last; k += single_count) {
      for (unsigned lanes = *set++; lanes != 0; lanes &= lanes - 1) {
        position_.push_back(static_cast<std::int32_t>(k) + std::countr_zero(lanes));
      }
    }
  }
}

std::int64_t Candidates::test_exactly(PairRule rule, std::size_t local, std::size_t first,
                                      kernel::Hits* hits) {
  if (position_.empty()) find_positions();
  return exact_test(*placed_, rule, own_.first + static_cast<std::uint32_t>(local),
                    std::span(position_).subspan(first * single_count), hits);
}

// A store of hits might change any member, too: what is needed in the loop is copied before it.
template <PairRule rule>
kernel::Hits* Candidates::test(std::size_t first, std::size_t last, Listing listing,
                               kernel::Hits* hits, std::int64_t* found) {
  static_assert(single_count % at_once == 0, "those tested together begin in one register");
  const kernel::CandidateColumns all{u_.data(), v_.data(), reach_.data()};
  const std::size_t registers = registers_;
  const float slack = kernel::doubt * h2_;
  const bool in_floats = in_floats_;
  const unsigned once = listing == Listing::once ? 1 : 0;
  const auto test_some = [&]<std::size_t count>(std::size_t local,
                                                std::integral_constant<std::size_t, count>) {
    const std::size_t begin = first_register(local, listing), of_one = registers - begin;
    std::array<kernel::Seeker, count> seekers;
    for (std::size_t s = 0; s < count; ++s) {
      seekers[s] = {all.u[local + s], all.v[local + s], all.reach[local + s]};
    }
    const auto told = kernel::test<rule, count>(all, begin, registers, seekers, slack, hits);
    const bool sure = told.sure && in_floats;
    kernel::Hits* set = hits + local / single_count - begin;
    unsigned itself = 1u << local % single_count;
    for (std::size_t s = 0; s < count; ++s, hits += of_one, set += of_one, itself *= 2) {
      std::int64_t passed = told.hits[s];
      if (!sure) passed = test_exactly(rule, local + s, begin, hits);
      const unsigned barred = (itself << once) - once;
      *found++ = passed - std::popcount(*set & barred);
      *set = static_cast<kernel::Hits>(*set & ~barred);
    }
  };
  std::size_t local = first;
  for (; local + at_once <= last; local += at_once) {
    test_some(local, std::integral_constant<std::size_t, at_once>{});
  }
  for (; local < last; ++local) test_some(local, std::integral_constant<std::size_t, 1>{});
  return hits;
}

std::size_t gather_numbers(const Buffer<std::int32_t>& of, Range own, std::span<const Range> others,
                           const kernel::Hits* kept, std::int32_t* to, std::size_t& count) {
  std::copy(of.data() + own.first, of.data() + own.last, to);
  std::int32_t* next = to + own.size();
  const std::int32_t* numbers = of.data();
  const kernel::Hits* set = kept;
  for (const Range range : others) {
    for (std::uint32_t k = range.first; k < range.last; k += single_count) {
      const kernel::Hits lanes = *set++;
      kernel::store_close(next, load(numbers + k), lanes);
      next += std::popcount(lanes);
    }
  }
  count = static_cast<std::size_t>(next - to);
  return static_cast<std::size_t>(set - kept);
}

template void Candidates::gather<PairRule::max>(const SortedParticles&, Range,
                                                std::span<const Range>, double,
                                                Unwritten<kernel::Hits>&);
template void Candidates::gather<PairRule::mean>(const SortedParticles&, Range,
                                                 std::span<const Range>, double,
                                                 Unwritten<kernel::Hits>&);
template void Candidates::gather<PairRule::own>(const SortedParticles&, Range,
                                                std::span<const Range>, double,
                                                Unwritten<kernel::Hits>&);
template kernel::Hits* Candidates::test<PairRule::max>(std::size_t, std::size_t, Listing,
                                                       kernel::Hits*, std::int64_t*);
template kernel::Hits* Candidates::test<PairRule::mean>(std::size_t, std::size_t, Listing,
                                                        kernel::Hits*, std::int64_t*);
template kernel::Hits* Candidates::test<PairRule::own>(std::size_t, std::size_t, Listing,
                                                       kernel::Hits*, std::int64_t*);

}  // namespace vortree::tree
