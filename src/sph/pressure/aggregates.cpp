#include "sph/pressure/aggregates.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "sph/pressure/sliced_kernel.hpp"

namespace vortree::sph {
namespace {

constexpr float strong = 0.25F, least_beside = 0.2F, least_diagonal = 0.1F;

/// Aggregates in the making. One thread does it: pieces that threads share end aggregates at their
/// borders, which costs half as many iterations again.
class Aggregation {
 public:
  Aggregation(const SlicedRows& a, const RowTies& ties, std::vector<std::int32_t>& of)
      : a_(a), ties_(ties), of_(of) {}

  std::int32_t number() {
    for (std::size_t i = 0; i < a_.rows; ++i) of_[i] = ties_.alone[i] ? alone : nobody;
    for (std::size_t i = 0; i < a_.rows; ++i)
      if (of_[i] == nobody && all_are_free(i)) found(i);
    for (std::size_t i = 0; i < a_.rows; ++i)
      if (of_[i] == nobody) join(i);
    for (std::size_t i = 0; i < a_.rows; ++i)
      if (of_[i] == nobody) found(i);
    for (std::size_t i = 0; i < a_.rows; ++i)
      if (of_[i] <= joined) of_[i] = joined - of_[i];
    return count_;
  }

 private:
  static constexpr std::int32_t alone = -1, nobody = -2, joined = -3;  // joined - k: late, to k

  // Is j, of such a value, a strong neighbor of i, and not alone?
  [[nodiscard]] bool is_strong(std::size_t i, std::size_t j, float value) const {
    return value * ties_.sign[i] > ties_.threshold[i] && of_[j] != alone;
  }

  void for_strong(std::size_t i, auto visit) const {
    a_.for_row(i, [&](std::size_t j, float value) {
      if (is_strong(i, j, value)) visit(j, value * ties_.sign[i]);
    });
  }

  [[nodiscard]] bool all_are_free(std::size_t i) const {
    return !a_.any_of_row(
        i, [&](std::size_t j, float value) { return of_[j] != nobody && is_strong(i, j, value); });
  }

  void found(std::size_t i) {
    for_strong(i, [&](std::size_t j, float) { of_[j] = of_[j] == nobody ? count_ : of_[j]; });
    of_[i] = count_++;
  }

  // To the aggregate that i is strongest to, of those that were founded.
  void join(std::size_t i) {
    float largest = 0;
    for_strong(i, [&](std::size_t j, float strength) {
      if (of_[j] < 0 || strength <= largest) return;
      of_[i] = joined - of_[j], largest = strength;
    });
  }

  const SlicedRows& a_;
  const RowTies& ties_;
  std::vector<std::int32_t>& of_;
  std::int32_t count_ = 0;
};

}  // namespace

void find_ties(const SlicedRows& a, RowTies& ties) {
  for (auto* one : {&ties.threshold, &ties.sign, &ties.inverse}) one->resize(a.padded());
  ties.alone.resize(a.padded());
#pragma omp parallel for schedule(static) if (a.slices() > kernel::slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    for (std::size_t part = 0; part < kernel::slice_parts; ++part) {
      const auto [diagonal, beside, largest] = kernel::rows_in_short(a, slice, part);
      for (int lane = 0; lane < single_count; ++lane) {
        const std::size_t i = slice * SlicedRows::lanes + part * single_count + lane;
        const float size = std::max(std::abs(diagonal[lane]), least_diagonal * beside[lane]);
        ties.threshold[i] = strong * largest[lane];
        ties.sign[i] = diagonal[lane] < 0 ? 1 : -1;
        ties.inverse[i] = size > 0 ? std::copysign(1 / size, diagonal[lane]) : 0;
        ties.alone[i] = beside[lane] <= least_beside * std::abs(diagonal[lane]);
      }
    }
}

RowAggregates aggregate(const SlicedRows& a, const RowTies& ties) {
  RowAggregates made{std::vector<std::int32_t>(a.rows)};
  made.count = static_cast<std::size_t>(Aggregation(a, ties, made.of).number());
  return made;
}

void sum_over(const RowAggregates& aggregates, RowsMaker& maker, SlicedRows& sums) {
  std::vector<std::int32_t> start(aggregates.count + 1), row(aggregates.of.size());
  for (const std::int32_t one : aggregates.of)
    if (one >= 0) ++start[one + 1];
  for (std::size_t i = 0; i < aggregates.count; ++i) start[i + 1] += start[i];
  std::vector<std::int32_t> next = start;
  for (std::size_t i = 0; i < aggregates.of.size(); ++i)
    if (aggregates.of[i] >= 0) row[next[aggregates.of[i]]++] = static_cast<std::int32_t>(i);
  maker.make(
      sums, aggregates.count, [] { return 0; },
      [&](int, std::size_t i, SlicesPiece& piece) {
        piece.make_room(start[i + 1] - start[i]);
        for (std::int32_t k = start[i]; k < start[i + 1]; ++k) piece.add(row[k], 1);
      });
}

}  // namespace vortree::sph
