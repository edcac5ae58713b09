#include <cmath>
#include <cstdint>

#include "fmm/field/field.hpp"
#include "fmm/field/field_kernel.hpp"
#include "fmm/series/expansion_kernel.hpp"

namespace vortree::fmm {
namespace {

/// `act<rows>(first, t)` for all targets, up to four vectors at a time, t = (z - centre)/side.
template <class Act>
void in_frame(const CellFrame& at, const FieldTargets& targets, Act act) {
  const double per_side = 1.0 / at.side;
  by_rows<lane_count>(
      static_cast<int>(padded(targets.size) / lane_count), [&]<int rows>(int first) {
        Complexes t[rows];
        for (int i = 0; i < rows; ++i) {
          const Lanes x = load(targets.x + first + lane_count * i);
          const Lanes y = load(targets.y + first + lane_count * i);
          t[i] = {((x - at.x) - at.x_rest) * per_side, ((y - at.y) - at.y_rest) * per_side};
        }
        act.template operator()<rows>(first, t);
      });
}

void add(double* sum, Lanes value) {
  store(sum, load(sum) + value);
}

}  // namespace

template <class Number>
void FieldGradient::add_multipole(const SeriesView<Number>& multipole, const CellFrame& at,
                                  const FieldTargets& targets) const {
  const PowerSeries slope = multipole_slope(multipole);
  const double per_side = 1.0 / at.side;
  in_frame(at, targets, [&]<int rows>(int first, const Complexes(&t)[rows]) {
    Complexes w[rows], sum[rows];
    for (int i = 0; i < rows; ++i) w[i] = reciprocal(t[i]);
    sum_powers<rows>(slope, w, sum);
    for (int i = 0; i < rows; ++i) {
      const Complexes per_length{w[i].re * per_side, w[i].im * per_side};
      const Complexes strain = per_length * (per_length * sum[i]);
      add(targets.sums[0] + first + lane_count * i, strain.re);
      add(targets.sums[1] + first + lane_count * i, strain.im);
    }
  });
}

template <class Number>
void FieldGradient::add_local(const SeriesView<Number>& local, const CellFrame& at, std::uint32_t,
                              const FieldTargets& targets) const {
  const PowerSeries slope = local_slope(local);
  const double per_side = 1.0 / at.side;
  in_frame(at, targets, [&]<int rows>(int first, const Complexes(&t)[rows]) {
    Complexes sum[rows];
    sum_powers<rows>(slope, t, sum);
    for (int i = 0; i < rows; ++i) {
      add(targets.sums[0] + first + lane_count * i, sum[i].re * per_side * per_side);
      add(targets.sums[1] + first + lane_count * i, sum[i].im * per_side * per_side);
    }
  });
}

template <class Number>
void StreamFunction::add_multipole(const SeriesView<Number>& multipole, const CellFrame& at,
                                   const FieldTargets& targets) const {
  const PowerSeries integral = multipole_integral(multipole);
  const double log_side2 = 2 * std::log(at.side);
  in_frame(at, targets, [&]<int rows>(int first, const Complexes(&t)[rows]) {
    Lanes sum[rows];
    log_of_multipole<rows>(static_cast<double>(multipole.re[0]), log_side2, integral, t, sum);
    for (int i = 0; i < rows; ++i) add(targets.sums[0] + first + lane_count * i, sum[i]);
  });
}

template <class Number>
void StreamFunction::add_local(const SeriesView<Number>& local, const CellFrame& at,
                               std::uint32_t cell, const FieldTargets& targets) const {
  const PowerSeries integral = local_integral(local);
  in_frame(at, targets, [&]<int rows>(int first, const Complexes(&t)[rows]) {
    Lanes sum[rows];
    log_of_local<rows>(integral, t, sum);
    for (int i = 0; i < rows; ++i) {
      add(targets.sums[0] + first + lane_count * i, sum[i] + centres[cell]);
    }
  });
}

using Doubles = SeriesView<double>;
using Floats = SeriesView<float>;
using At = const FieldTargets&;
template void FieldGradient::add_multipole(const Doubles&, const CellFrame&, At) const;
template void FieldGradient::add_multipole(const Floats&, const CellFrame&, At) const;
template void FieldGradient::add_local(const Doubles&, const CellFrame&, std::uint32_t, At) const;
template void FieldGradient::add_local(const Floats&, const CellFrame&, std::uint32_t, At) const;
template void StreamFunction::add_multipole(const Doubles&, const CellFrame&, At) const;
template void StreamFunction::add_multipole(const Floats&, const CellFrame&, At) const;
template void StreamFunction::add_local(const Doubles&, const CellFrame&, std::uint32_t, At) const;
template void StreamFunction::add_local(const Floats&, const CellFrame&, std::uint32_t, At) const;

}  // namespace vortree::fmm
