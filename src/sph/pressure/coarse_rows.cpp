#include "sph/pressure/coarse_rows.hpp"

#include <vector>

namespace vortree::sph {
namespace {

constexpr float smoothing = 0.66F;

/// Sums for numbered places, of which few are used at a time. No branch asks whether one is: that
/// could not be foreseen.
class SparseSum {
 public:
  explicit SparseSum(std::size_t places) : sum_(places), is_used_(places), used_(places + 1) {}

  void add(std::size_t place, float value) {
    used_[count_] = static_cast<std::uint32_t>(place);
    count_ += 1 - is_used_[place];
    is_used_[place] = 1;
    sum_[place] += value;
  }
  [[nodiscard]] std::size_t count() const { return count_; }

  /// Shows all sums, and forgets them.
  void take(auto visit) {
    for (std::size_t k = 0; k < count_; ++k) {
      const std::size_t place = used_[k];
      visit(place, sum_[place]);
      sum_[place] = 0, is_used_[place] = 0;
    }
    count_ = 0;
  }

 private:
  std::vector<float> sum_;
  std::vector<unsigned char> is_used_;
  std::vector<std::uint32_t> used_;
  std::size_t count_ = 0;
};

/// The strong neighbors of a row that are in aggregates, and the sum of their values.
class StrongNeighbors {
 public:
  struct Neighbor {
    std::int32_t aggregate;
    float value;
  };

  void find(const SlicedRows& a, const RowTies& ties, const std::vector<std::int32_t>& of,
            std::size_t i) {
    const float sign = ties.sign[i], threshold = ties.threshold[i];
    if (all_.size() <= static_cast<std::size_t>(a.width[i])) all_.resize(2 * a.width[i] + 2);
    count_ = 0, sum_ = 0;
    a.for_row(i, [&](std::size_t j, float value) {
      const bool is_strong = value * sign > threshold;
      all_[count_] = {of[j], value};
      sum_ += is_strong ? value : 0;
      count_ += is_strong && of[j] >= 0;
    });
  }
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.begin() + count_; }
  [[nodiscard]] float sum() const { return sum_; }

 private:
  std::vector<Neighbor> all_;
  std::ptrdiff_t count_ = 0;
  float sum_ = 0;
};

}  // namespace

void interpolate(const SlicedRows& a, const RowTies& ties, const RowAggregates& aggregates,
                 RowsMaker& maker, SlicedRows& p) {
  struct Scratch {
    SparseSum row;
    StrongNeighbors strong;
  };
  const auto add_row = [&](Scratch& at, std::size_t i, SlicesPiece& piece) {
    if (aggregates.of[i] < 0) return;
    at.strong.find(a, ties, aggregates.of, i);
    const float w = at.strong.sum() != 0 ? smoothing : 0;
    at.row.add(static_cast<std::size_t>(aggregates.of[i]), 1 - w);
    for (const auto& [aggregate, value] : at.strong)
      at.row.add(static_cast<std::size_t>(aggregate), w / at.strong.sum() * value);
    piece.make_room(at.row.count());
    at.row.take([&](std::size_t j, float value) { piece.add(j, value); });
  };
  maker.make(
      p, a.rows,
      [&] {
        return Scratch{SparseSum(aggregates.count), {}};
      },
      add_row);
}

void coarse_rows(const SlicedRows& a, const SlicedRows& sums, const SlicedRows& p, RowsMaker& maker,
                 SlicedRows& coarse) {
  struct Scratch {
    SparseSum fine, coarse;
  };
  const auto add_row = [&](Scratch& row, std::size_t i, SlicesPiece& piece) {
    sums.for_row(i, [&](std::size_t k, float) {
      a.for_row(k, [&](std::size_t j, float value) { row.fine.add(j, value); });
    });
    row.fine.take([&](std::size_t j, float value) {
      p.for_row(j, [&](std::size_t g, float part) { row.coarse.add(g, value * part); });
    });
    piece.make_room(row.coarse.count());
    row.coarse.take([&](std::size_t j, float value) { piece.add(j, value); });
  };
  const auto scratch = [&] { return Scratch{SparseSum(a.rows), SparseSum(sums.rows)}; };
  maker.make(coarse, sums.rows, scratch, add_row);
}

}  // namespace vortree::sph
