#include "sph/pressure/incomplete_lu.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vortree::sph {

void IncompleteLu::sort(const SparseRows& a) {
  const auto n = static_cast<std::int32_t>(a.size());
  start_ = a.start, middle_.resize(a.size());
  index_.resize(a.index.size()), value_.resize(a.value.size());
  std::vector<std::pair<std::int32_t, double>> row;
  for (std::int32_t i = 0; i < n; ++i) {
    row.clear();
    for (std::int32_t k = a.start[i]; k < a.start[i + 1]; ++k)
      row.emplace_back(a.index[k], a.value[k]);
    std::ranges::sort(row, {}, [](const auto& one) { return one.first; });
    std::int32_t k = start_[i];
    for (const auto& [j, value] : row) index_[k] = j, value_[k++] = value;
    middle_[i] = start_[i] + static_cast<std::int32_t>(std::ranges::count_if(
                                 row, [i](const auto& one) { return one.first < i; }));
  }
}

void IncompleteLu::factor(const SparseRows& a) {
  sort(a);
  diagonal_ = a.diagonal;
  reciprocal_.assign(a.size(), 0), place_.assign(a.size(), -1);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(a.size()); ++i) {
    double magnitude = std::abs(a.diagonal[i]);
    for (std::int32_t k = start_[i]; k < start_[i + 1]; ++k) magnitude += std::abs(value_[k]);
    eliminate(i);
    reciprocal_[i] = 1 / pivot(i, magnitude);
    if (a.diagonal[i] * reciprocal_[i] < 0) reciprocal_[i] = -reciprocal_[i];
  }
}

void IncompleteLu::eliminate(std::int32_t i) {
  for (std::int32_t k = start_[i]; k < start_[i + 1]; ++k) place_[index_[k]] = k;
  for (std::int32_t k = start_[i]; k < middle_[i]; ++k) {
    const std::int32_t j = index_[k];
    const double factor = value_[k] *= reciprocal_[j];
    for (std::int32_t l = middle_[j]; l < start_[j + 1]; ++l) {
      const std::int32_t at = place_[index_[l]];
      if (at >= 0) value_[at] -= factor * value_[l];
      if (index_[l] == i) diagonal_[i] -= factor * value_[l];
    }
  }
  for (std::int32_t k = start_[i]; k < start_[i + 1]; ++k) place_[index_[k]] = -1;
}

double IncompleteLu::pivot(std::int32_t i, double magnitude) const {
  constexpr double least = 0.02, instead = 0.3;
  return std::abs(diagonal_[i]) > least * magnitude ? diagonal_[i] : instead * magnitude;
}

void IncompleteLu::solve(std::span<const double> b, std::span<double> x) const {
  const auto n = static_cast<std::int32_t>(start_.size()) - 1;
  for (std::int32_t i = 0; i < n; ++i) {
    double sum = b[i];
    for (std::int32_t k = start_[i]; k < middle_[i]; ++k) sum -= value_[k] * x[index_[k]];
    x[i] = sum;
  }
  for (std::int32_t i = n; i-- > 0;) {
    double sum = x[i];
    for (std::int32_t k = middle_[i]; k < start_[i + 1]; ++k) sum -= value_[k] * x[index_[k]];
    x[i] = sum * reciprocal_[i];
  }
}

}  // namespace vortree::sph
