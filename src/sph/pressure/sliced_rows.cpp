#include "sph/pressure/sliced_rows.hpp"

#include <algorithm>

namespace vortree::sph {

void SlicesPiece::begin() {
  size_ = ended_ = 0;
  slice_widths_.clear(), widths_.clear(), index_.clear(), value_.clear();
}

void SlicesPiece::end_slice() {
  std::size_t width = 0;
  for (std::size_t lane = 0, from = 0; lane < SlicedRows::lanes; from = ends_[lane++]) {
    widths_.push_back(static_cast<std::int32_t>(ends_[lane] - from));
    width = std::max(width, ends_[lane] - from);
  }
  const std::size_t at = index_.size(), size = at + width * SlicedRows::lanes;
  index_.resize(size, 0), value_.resize(size, 0);
  for (std::size_t lane = 0, k = 0; lane < SlicedRows::lanes; ++lane)
    for (std::size_t to = at + lane; k < ends_[lane]; ++k, to += SlicedRows::lanes)
      index_[to] = row_[k].column, value_[to] = row_[k].value;
  slice_widths_.push_back(static_cast<std::int32_t>(width));
  size_ = ended_ = 0;
}

void RowsMaker::join(SlicedRows& made, std::size_t rows) {
  const std::size_t pieces = row_pieces(rows);
  made.rows = rows;
  made.begin.assign(1, 0), made.width.clear();
  std::vector<std::size_t> start;
  for (std::size_t p = 0; p < pieces; ++p) {
    start.push_back(made.begin.back() * SlicedRows::lanes);
    for (const std::int32_t width : pieces_[p].slice_widths_)
      made.begin.push_back(made.begin.back() + width);
    made.width.insert(made.width.end(), pieces_[p].widths_.begin(), pieces_[p].widths_.end());
  }
  made.index.renew(made.begin.back() * SlicedRows::lanes);
  made.value.renew(made.index.size());
#pragma omp parallel for schedule(static) if (rows > worth_sharing)
  for (std::size_t p = 0; p < pieces; ++p) {
    std::ranges::copy(pieces_[p].index_, made.index.data() + start[p]);
    std::ranges::copy(pieces_[p].value_, made.value.data() + start[p]);
  }
}

}  // namespace vortree::sph
