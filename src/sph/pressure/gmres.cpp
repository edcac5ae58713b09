#include "sph/pressure/gmres.hpp"

#include <algorithm>
#include <cmath>

#include "sph/pressure/sparse_rows.hpp"

namespace vortree::sph {
namespace {

using kernel::SlicedColumn;

constexpr std::size_t parts = 16;  // of a sum, whatever the threads

// work(part, first, last) on registers of a column.
void for_parts(std::size_t size, auto work) {
  const std::size_t slices = size / SlicedRows::lanes;
#pragma omp parallel for schedule(static) if (slices > kernel::slices_worth_sharing)
  for (std::size_t part = 0; part < parts; ++part)
    work(part, slices * part / parts * SlicedRows::lanes,
         slices * (part + 1) / parts * SlicedRows::lanes);
}

double dot(const float* a, const float* b, std::size_t first, std::size_t last) {
  Lanes sums{};
  for (std::size_t i = first; i < last; i += single_count) {
    const Singles x = load(a + i), y = load(b + i);
    sums += low(x) * low(y), sums += high(x) * high(y);
  }
  return sum(sums);
}

// (a_k, w) for all a.
std::vector<double> dots(std::span<const SlicedColumn> a, const SlicedColumn& w) {
  std::vector<double> all(parts * a.size()), sums(a.size());
  for_parts(w.size(), [&](std::size_t part, std::size_t first, std::size_t last) {
    for (std::size_t k = 0; k < a.size(); ++k)
      all[part * a.size() + k] = dot(a[k].data(), w.data(), first, last);
  });
  for (std::size_t k = 0; k < all.size(); ++k) sums[k % a.size()] += all[k];
  return sums;
}

// w += sum_k factor_k a_k.
void add(std::span<const SlicedColumn> a, std::span<const double> factor, SlicedColumn& w) {
  for_parts(w.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; i += single_count) {
      Singles sum = load(w.data() + i);
      for (std::size_t k = 0; k < factor.size(); ++k)
        sum += static_cast<float>(factor[k]) * load(a[k].data() + i);
      store(w.data() + i, sum);
    }
  });
}

double norm(const SlicedColumn& a) {
  return std::sqrt(dots({&a, 1}, a)[0]);
}

void put_scaled(std::span<const double> a, double factor, SlicedColumn& made) {
  made.resize(padded(a.size(), SlicedRows::lanes));
#pragma omp parallel for simd schedule(static) if (a.size() > kernel::rows_worth_sharing)
  for (std::size_t i = 0; i < a.size(); ++i) made[i] = static_cast<float>(factor * a[i]);
  for (std::size_t i = a.size(); i < made.size(); ++i) made[i] = 0;
}

void scale(SlicedColumn& a, double factor) {
  for_parts(a.size(), [&](std::size_t, std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) a[i] *= static_cast<float>(factor);
  });
}

double reciprocal(double a) {
  return a > 0 ? 1 / a : 0;
}

}  // namespace

void Gmres::prepare(Multigrid& multigrid, std::span<const double> image) {
  multigrid_ = &multigrid;
  put_scaled(image, 1, image_), image_norm_ = norm(image);
  if (basis_.empty()) basis_.emplace_back();
  put_scaled(image, reciprocal(image_norm_), basis_[0]);
}

// r without its part along A 1, as the first of Krylov's; returns their shares of its norm.
double Gmres::start(std::span<const double> r) {
  scale_ = norm(r);
  triangle_.clear(), along_image_.clear(), cosine_.clear(), sine_.clear();
  if (basis_.size() < 2) basis_.emplace_back();
  Column& rest = basis_[1];
  put_scaled(r, reciprocal(scale_), rest);
  const std::span image(basis_.data(), 1);
  from_image_ = dots(image, rest)[0];
  add(image, std::vector{-from_image_}, rest);
  const double size = norm(rest);
  scale(rest, reciprocal(size));
  right_.assign(1, size);
  return size;
}

void Gmres::iterate() {
  const std::size_t number = triangle_.size();
  if (cycles_.size() == number) cycles_.emplace_back(), basis_.emplace_back();
  Column &z = cycles_[number], &w = basis_[number + 2];
  z.resize(basis_[0].size()), w.resize(z.size());
  multigrid_->cycle(basis_[number + 1], z);
  kernel::for_slices_of_differences(multigrid_->matrix(), z, [&](std::size_t i, Singles sums) {
    store(w.data() + i, sums + load(image_.data() + i) * load(z.data() + i));
  });
  const std::span before(basis_.data(), number + 2);
  std::vector<double> h = dots(before, w);
  std::vector<double> minus = h;
  for (double& one : minus) one = -one;
  add(before, minus, w);
  const double size = norm(w);
  scale(w, reciprocal(size));
  along_image_.push_back(h[0]);
  h.erase(h.begin()), h.push_back(size);
  rotate(h);
}

// Givens: what stands below the diagonal of H goes, and the last of the right side is the residual.
void Gmres::rotate(std::vector<double>& h) {
  const std::size_t last = h.size() - 2;
  for (std::size_t k = 0; k < last; ++k) {
    const double above = cosine_[k] * h[k] + sine_[k] * h[k + 1];
    h[k + 1] = cosine_[k] * h[k + 1] - sine_[k] * h[k];
    h[k] = above;
  }
  const double size = std::hypot(h[last], h[last + 1]), reduced = reciprocal(size);
  cosine_.push_back(h[last] * reduced), sine_.push_back(h[last + 1] * reduced);
  h[last] = size;
  right_.push_back(-sine_[last] * right_[last]);
  right_[last] *= cosine_[last];
  triangle_.push_back(h);
}

std::vector<double> Gmres::least_squares() const {
  std::vector<double> y(triangle_.size());
  for (std::size_t i = y.size(); i-- > 0;) {
    double left = right_[i];
    for (std::size_t k = i + 1; k < y.size(); ++k) left -= triangle_[k][i] * y[k];
    y[i] = triangle_[i][i] > 0 ? left / triangle_[i][i] : 0;
  }
  return y;
}

void Gmres::add_to(std::span<double> x) const {
  std::vector<double> y = least_squares();
  double along = from_image_;
  for (std::size_t k = 0; k < y.size(); ++k) along -= y[k] * along_image_[k];
  const double constant = along * scale_ * reciprocal(image_norm_);
  for (double& one : y) one *= scale_;
#pragma omp parallel for schedule(static) if (x.size() > kernel::rows_worth_sharing)
  for (std::size_t i = 0; i < x.size(); ++i) {
    double sum = constant;
    for (std::size_t k = 0; k < y.size(); ++k) sum += y[k] * cycles_[k][i];
    x[i] += sum;
  }
}

int Gmres::solve(std::span<const double> r, double reduction, int most, std::span<double> x) {
  double left = start(r);
  int iterations = 0;
  for (; iterations < most && left > reduction; ++iterations) {
    iterate();
    left = std::abs(right_.back());
  }
  add_to(x);
  return iterations;
}

}  // namespace vortree::sph
