#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbors/exact_pairs.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::neighbors {
namespace {

using tree::PairRule;

// Khorasanizade & Sousa 2019, section 2.1: cells as wide as the largest reach, the particles of
// each chained; every cell looks into itself and four of its neighbors, so that each pair is met
// once.
class LinkedList : public NeighborMethod {
 public:
  void build(const NeighborJob& job) override {
    lay_cells(job);
    head_.assign(static_cast<std::size_t>(columns_) * rows_, -1);
    next_.resize(job.points.size());
    for (std::size_t i = 0; i < next_.size(); ++i) {
      std::int32_t& head = head_[cell_of(job.points.x[i], job.points.y[i])];
      next_[i] = head;
      head = static_cast<std::int32_t>(i);
    }
  }

  void search(const NeighborJob& job, tree::PairList& rows) override {
    first_.clear(), second_.clear();
    length_.assign(job.points.size(), 0);
    with_rule(job.rule, [&]<PairRule rule> { find_pairs<rule>(job, rows); });
    write(rows);
  }

 private:
  void lay_cells(const NeighborJob& job) {
    columns_ = rows_ = 1;
    if (job.points.size() == 0) return;
    const auto [left, right] = std::ranges::minmax(job.points.x);
    const auto [low, high] = std::ranges::minmax(job.points.y);
    const double n = static_cast<double>(job.points.size());
    const double largest = std::ranges::max(job.reach), extent = std::max(right - left, high - low);
    // No more cells than particles, where reaches are short; wide enough for rounding.
    side_ = std::max({largest * (1 + 1e-9), extent * (1 + 1e-9) / std::ceil(std::sqrt(n)), 1e-300});
    left_ = left, low_ = low;
    columns_ = static_cast<int>((right - left) / side_) + 1;
    rows_ = static_cast<int>((high - low) / side_) + 1;
  }

  [[nodiscard]] std::size_t cell_of(double x, double y) const {
    return static_cast<std::size_t>((y - low_) / side_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>((x - left_) / side_);
  }

  template <PairRule rule>
  void find_pairs(const NeighborJob& job, const tree::PairList& rows) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        for (std::int32_t i = head(column, row); i >= 0; i = next_[i]) {
          const auto pairs = static_cast<std::int64_t>(first_.size());
          if (pairs > rows.most) rows.refuse(pairs);
          test<rule>(job, i, next_[i]);
          test<rule>(job, i, head(column + 1, row));
          for (int c = column - 1; c <= column + 1; ++c) test<rule>(job, i, head(c, row + 1));
        }
      }
    }
  }

  [[nodiscard]] std::int32_t head(int column, int row) const {
    if (column < 0 || column >= columns_ || row >= rows_) return -1;
    return head_[static_cast<std::size_t>(row) * columns_ + column];
  }

  // Particle i with j and all that are chained to it.
  template <PairRule rule>
  void test(const NeighborJob& job, std::int32_t i, std::int32_t j) {
    for (; j >= 0; j = next_[j]) {
      const bool forth = is_pair<rule>(job, i, j);
      const bool back = rule == PairRule::own ? is_pair<rule>(job, j, i) : forth;
      if (job.listing == tree::Listing::once) {
        if (forth) keeps(job, i, j) ? add(i, j) : add(j, i);
        continue;
      }
      if (forth) add(i, j);
      if (back) add(j, i);
    }
  }

  void add(std::int32_t i, std::int32_t j) {
    first_.push_back(i);
    second_.push_back(j);
    ++length_[i];
  }

  // From the list of pairs to rows.
  void write(tree::PairList& rows) {
    const std::size_t n = length_.size();
    rows.start.renew(n + 1);
    rows.start[0] = 0;
    for (std::size_t i = 0; i < n; ++i) rows.start[i + 1] = rows.start[i] + length_[i];
    rows.make_room(static_cast<std::int64_t>(first_.size()));
    for (std::size_t k = 0; k < first_.size(); ++k) {
      const auto i = static_cast<std::size_t>(first_[k]);
      rows.index[static_cast<std::size_t>(rows.start[i + 1] - length_[i]--)] = second_[k];
    }
  }

  double side_ = 1, left_ = 0, low_ = 0;
  int columns_ = 1, rows_ = 1;
  std::vector<std::int32_t> head_, next_, first_, second_;
  std::vector<std::int64_t> length_;
};

}  // namespace

std::unique_ptr<NeighborMethod> make_linked_list() {
  return std::make_unique<LinkedList>();
}

}  // namespace vortree::neighbors
