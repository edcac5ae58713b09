#include "sph/pressure/sliced_rows.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "sph/pressure/sliced_kernel.hpp"

namespace vortree::sph {
namespace {

// Is there anything to refuse? Sums of products with zero tell without a branch.
bool slice_is_sound(const SlicedDoubles& a, std::size_t slice) {
  constexpr std::size_t lanes = SlicedDoubles::lanes;
  const std::size_t first = a.begin[slice] * lanes, last = a.begin[slice + 1] * lanes;
  std::uint32_t largest = 0;
  double zero[lanes] = {};
  for (std::size_t k = first; k < last; k += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      largest = std::max(largest, static_cast<std::uint32_t>(a.index[k + lane]));
      zero[lane] += 0 * a.value[k + lane];
    }
  bool sound = largest < a.rows;
  for (std::size_t lane = 0; lane < lanes && slice * lanes + lane < a.rows; ++lane) {
    const std::size_t i = slice * lanes + lane;
    sound = sound && zero[lane] == 0 && a.width[i] > 0 && a.value[first + lane] != 0 &&
            a.index[first + lane] == static_cast<std::int32_t>(i);
  }
  return sound;
}

}  // namespace

void check(const SlicedDoubles& a) {
  std::size_t sound = a.slices();  // slices before the first that is not
#pragma omp parallel for schedule(static) \
    reduction(min                         \
              : sound) if (a.slices() > kernel::slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice)
    if (!slice_is_sound(a, slice)) sound = std::min(sound, slice);
  if (sound == a.slices()) return;
  const std::size_t first = sound * SlicedDoubles::lanes;
  throw std::invalid_argument("sparse rows: of rows " + std::to_string(first) + " to " +
                              std::to_string(std::min(first + SlicedDoubles::lanes, a.rows) - 1) +
                              " of " + std::to_string(a.rows) +
                              " one has an index or a value that cannot be");
}

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
