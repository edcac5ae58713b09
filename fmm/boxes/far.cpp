#include "fmm/boxes/far.hpp"

#include <algorithm>

#include "fmm/losses/near_errors.hpp"
#include "fmm/series/multipole_kernel.hpp"
#include "fmm/series/multipole_single_kernel.hpp"

namespace vortree::fmm {
namespace {

/// Sources are not all in line with the targets, and terms are chosen for the nearest of those: the
/// squared loss is so many times less than order.hpp bounds it by
/// (tests/fmm/losses/cancelling.cpp).
constexpr double in_line2 = 25;

/// Cells whose length is less than this part of the batch's leave the range of floats.
constexpr double least_length = 1e-12;

/// `add` for as many targets at once as registers hold, then for the rest.
template <int lanes, class Add>
void in_rows(std::size_t count, Add add) {
  std::size_t i = 0;
  for (; i + 4 * lanes <= count; i += 4 * lanes) add.template operator()<4>(i);
  switch ((count - i) / lanes) {
    case 3:
      return add.template operator()<3>(i);
    case 2:
      return add.template operator()<2>(i);
    case 1:
      return add.template operator()<1>(i);
    default:
      return;
  }
}

void add_double(const CellShapes& shapes, const Multipoles& multipoles, SeriesCell met,
                Batch& batch) {
  const M2pSource source{shapes.x[met.cell],
                         shapes.y[met.cell],
                         scale(shapes, met.cell),
                         multipoles.real(met.cell),
                         multipoles.imaginary(met.cell),
                         met.terms};
  in_rows<lane_count>(padded(batch.size), [&]<int rows>(std::size_t i) {
    m2p_rows<rows>(source, &batch.x[i], &batch.y[i], &batch.u[i], &batch.v[i]);
  });
}

}  // namespace

Lost lost_by_series(const Multipoles& multipoles, const Acceptance& acceptance,
                    std::span<const SeriesCell> series, int derivative) {
  const bool in_floats = multipoles.in_single() && derivative == 0;
  const double terms = multipoles.order();
  Lost lost;
  for (const SeriesCell met : series) {
    const Charge& charge = multipoles.charge(met.cell);
    double per_square = met.per_distance2;
    if (derivative > 0) per_square *= met.per_distance2;
    if (derivative < 0) per_square = 4 / (terms * terms);
    lost += {charge.effective * per_square, charge.squares * per_square};
  }
  return {acceptance.lost2 / in_line2 * lost.series,
          in_floats ? float_rounding2 * lost.rounding : 0.0};
}

void FarSums::take_single(const Batch& batch) {
  const double half = std::max(batch.box.half_x, batch.box.half_y);
  size_ = half > 0.0 ? half : 1.0;
  x_.resize(batch.x.size()), y_.resize(batch.y.size());
  for (std::size_t i = 0; i < x_.size(); ++i) {
    x_[i] = static_cast<float>((batch.x[i] - batch.box.x) / size_);
    y_[i] = static_cast<float>((batch.y[i] - batch.box.y) / size_);
  }
}

void FarSums::add(const CellShapes& shapes, const Multipoles& multipoles,
                  std::span<const SeriesCell> series, Batch& batch) {
  if (!multipoles.in_single()) {
    for (const SeriesCell met : series) add_double(shapes, multipoles, met, batch);
    return;
  }
  take_single(batch);
  for (const SeriesCell met : series) {
    const double h = scale(shapes, met.cell);
    if (h < least_length * size_) {
      add_double(shapes, multipoles, met, batch);
      continue;
    }
    const M2pSingleSource source{static_cast<float>((shapes.x[met.cell] - batch.box.x) / size_),
                                 static_cast<float>((shapes.y[met.cell] - batch.box.y) / size_),
                                 static_cast<float>(h / size_),
                                 1.0 / h,
                                 multipoles.single(met.cell),
                                 multipoles.single(met.cell) + multipoles.order(),
                                 met.terms};
    in_rows<single_count>(batch.x.size(), [&]<int rows>(std::size_t i) {
      m2p_single_rows<rows>(source, &x_[i], &y_[i], &batch.u[i], &batch.v[i]);
    });
  }
}

}  // namespace vortree::fmm
