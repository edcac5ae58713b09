#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tree/base/buffer.hpp"

namespace vortree::sph {

/// A sparse matrix, its rows in slices of 16 that are worked on side by side: place k of row
/// 16 s + lane stands at 16 (begin_s + k) + lane, begin_s <= begin_s + k < begin_(s+1). Shorter
/// rows of a slice are filled up with zeros, for any column that there is.
///
/// width   places of each row; also of those that fill up the last slice
/// source  Kreutzer, Hager, Wellein, Fehske & Bishop, SIAM J. Sci. Comput. 36 (2014): SELL-C
template <class Number>
struct SlicedMatrix {
  static constexpr std::size_t lanes = 16;

  std::size_t rows = 0;
  std::vector<std::int32_t> begin{0}, width;
  tree::Buffer<std::int32_t> index;
  tree::Buffer<Number> value;

  /// Makes room for rows of places(i) places, whose indices and values are still to be written.
  void lay_out(std::size_t n, const auto& places) {
    rows = n;
    const std::size_t count = (n + lanes - 1) / lanes;
    width.assign(count * lanes, 0), begin.assign(count + 1, 0);
    for (std::size_t i = 0; i < n; ++i) {
      width[i] = static_cast<std::int32_t>(places(i));
      begin[i / lanes + 1] = std::max(begin[i / lanes + 1], width[i]);
    }
    for (std::size_t slice = 0; slice < count; ++slice) begin[slice + 1] += begin[slice];
    index.renew(begin[count] * lanes), value.renew(index.size());
  }

  [[nodiscard]] std::size_t slices() const { return begin.size() - 1; }
  /// Rows with those that fill up the last slice: so long are columns.
  [[nodiscard]] std::size_t padded() const { return slices() * lanes; }

  /// Does claim(column, value) hold for a place of a row?
  [[nodiscard]] bool any_of_row(std::size_t i, auto claim) const {
    const std::size_t first = begin[i / lanes] * lanes + i % lanes;
    const std::size_t last = first + width[i] * lanes;
    for (std::size_t k = first; k < last; k += lanes)
      if (claim(static_cast<std::size_t>(index[k]), value[k])) return true;
    return false;
  }

  /// Calls visit(column, value) for the places of a row.
  void for_row(std::size_t i, auto visit) const {
    const std::size_t first = begin[i / lanes] * lanes + i % lanes;
    const std::size_t last = first + width[i] * lanes;
    for (std::size_t k = first; k < last; k += lanes)
      visit(static_cast<std::size_t>(index[k]), value[k]);
  }
};

using SlicedRows = SlicedMatrix<float>;

/// The same in doubles. The first place of a row is that of its diagonal.
using SlicedDoubles = SlicedMatrix<double>;

/// throws  std::invalid_argument with the numbers if an index is outside of 0 .. n - 1, a row does
///         not begin with its diagonal or that is 0, or a value is not finite
void check(const SlicedDoubles& a);

/// Rows that one thread makes at a time.
inline constexpr std::size_t rows_a_piece = 1024;

[[nodiscard]] inline std::size_t row_pieces(std::size_t rows) {
  return (rows + rows_a_piece - 1) / rows_a_piece;
}

/// Slices of a matrix in the making, row after row.
class SlicesPiece {
 public:
  void begin();
  /// Makes sure of so many places for the row at hand.
  void make_room(std::size_t places) {
    if (row_.size() < size_ + places) row_.resize(2 * (size_ + places));
  }
  void add(std::size_t column, float value) {
    row_[size_++] = {static_cast<std::int32_t>(column), value};
  }
  void end_row() {
    ends_[ended_++] = size_;
    if (ended_ == SlicedRows::lanes) end_slice();
  }
  /// Fills up the last slice with empty rows.
  void end() {
    while (ended_ > 0) end_row();
  }

 private:
  friend class RowsMaker;
  struct Place {
    std::int32_t column;
    float value;
  };
  void end_slice();

  std::vector<Place> row_;  // of all rows of the slice at hand
  std::size_t size_ = 0, ends_[SlicedRows::lanes], ended_ = 0;
  std::vector<std::int32_t> slice_widths_, widths_, index_;
  std::vector<float> value_;
};

/// Makes matrices piece by piece, by all threads, and keeps the memory for the next one.
class RowsMaker {
 public:
  /// make(scratch, i, piece) adds the places of row i to a piece; begin() makes the scratch that a
  /// thread keeps from row to row.
  void make(SlicedRows& made, std::size_t rows, auto begin, auto make) {
    if (pieces_.size() < row_pieces(rows)) pieces_.resize(row_pieces(rows));
#pragma omp parallel if (rows > worth_sharing)
    {
      auto scratch = begin();
#pragma omp for schedule(dynamic)
      for (std::size_t p = 0; p < row_pieces(rows); ++p) {
        pieces_[p].begin();
        for (std::size_t i = p * rows_a_piece; i < rows && i < (p + 1) * rows_a_piece; ++i)
          make(scratch, i, pieces_[p]), pieces_[p].end_row();
        pieces_[p].end();
      }
    }
    join(made, rows);
  }

 private:
  static constexpr std::size_t worth_sharing = 4 * rows_a_piece;
  void join(SlicedRows& made, std::size_t rows);

  std::vector<SlicesPiece> pieces_;
};

}  // namespace vortree::sph
