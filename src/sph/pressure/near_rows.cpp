#include "sph/pressure/near_rows.hpp"

#include <array>
#include <vector>

#include "sph/pressure/sliced_kernel.hpp"

namespace vortree::sph {
namespace {

/// In the sum of magnitudes beside the diagonal. Measured against the largest of them, a pair that
/// nearly meets would tear all other ties.
constexpr float small = 0.02F;
constexpr std::size_t lanes = SlicedRows::lanes;

/// What becomes of a slice: the least magnitude that stays, how many places do, the diagonal, and
/// the factor of all others.
struct NearSlice {
  std::array<float, lanes> least, diagonal, factor;
  std::array<std::int32_t, lanes> count;
};

NearSlice look_at(const SlicedRows& a, std::size_t slice) {
  NearSlice of;
  for (std::size_t part = 0; part < kernel::slice_parts; ++part) {
    const std::size_t at = part * single_count, step = lanes;
    const std::size_t first = a.begin[slice] * lanes + at, last = a.begin[slice + 1] * lanes;
    Singles all{}, kept{}, gone{};
    SingleBits count{};
    for (std::size_t k = first + step; k < last; k += step)
      all += magnitude(load(a.value.data() + k));
    const Singles least = small * all;
    for (std::size_t k = first + step; k < last; k += step) {
      const Singles value = load(a.value.data() + k);
      const SingleBits stays = magnitude(value) > least;
      kept += select(stays, value, Singles{}), gone += select(stays, Singles{}, value);
      count -= stays;
    }
    const Singles factor = select(
        kept != Singles{}, 1.0F + gone / select(kept != Singles{}, kept, fill(1.0F)), fill(1.0F));
    store(of.least.data() + at, least), store(of.count.data() + at, count);
    store(of.factor.data() + at, factor);
    store(of.diagonal.data() + at, load(a.value.data() + first) + gone + (1.0F - factor) * kept);
  }
  return of;
}

/// No branch asks whether a value stays: that could not be foreseen. One that does not is written
/// over by the next, or by what fills up the row.
void write(const SlicedRows& a, std::size_t slice, const NearSlice& of, SlicedRows& near,
           std::vector<std::int32_t>& index, std::vector<float>& value) {
  const std::size_t first = a.begin[slice] * lanes, last = a.begin[slice + 1] * lanes;
  const std::size_t width = near.begin[slice + 1] - near.begin[slice];
  index.resize((width + 1) * lanes), value.resize((width + 1) * lanes);
  std::array<std::size_t, lanes> at;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    index[lane] = a.index[first + lane], value[lane] = of.diagonal[lane];
    at[lane] = lanes + lane;
  }
  for (std::size_t k = first + lanes; k < last; k += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const float one = a.value[k + lane];
      index[at[lane]] = a.index[k + lane], value[at[lane]] = one * of.factor[lane];
      at[lane] += std::abs(one) > of.least[lane] ? lanes : 0;
    }
  for (std::size_t lane = 0; lane < lanes; ++lane)
    for (std::size_t k = at[lane]; k < width * lanes; k += lanes)
      index[k] = a.index[first + lane], value[k] = 0;
  const std::size_t to = near.begin[slice] * lanes;
  std::copy_n(index.data(), width * lanes, near.index.data() + to);
  std::copy_n(value.data(), width * lanes, near.value.data() + to);
}

}  // namespace

void near_rows(const SlicedRows& a, SlicedRows& near) {
  std::vector<NearSlice> of(a.slices());
#pragma omp parallel for schedule(static) if (a.slices() > kernel::slices_worth_sharing)
  for (std::size_t slice = 0; slice < a.slices(); ++slice) of[slice] = look_at(a, slice);
  near.lay_out(a.rows, [&](std::size_t i) { return 1 + of[i / lanes].count[i % lanes]; });
#pragma omp parallel if (a.slices() > kernel::slices_worth_sharing)
  {
    std::vector<std::int32_t> index;
    std::vector<float> value;
#pragma omp for schedule(static)
    for (std::size_t slice = 0; slice < a.slices(); ++slice)
      write(a, slice, of[slice], near, index, value);
  }
}

}  // namespace vortree::sph
