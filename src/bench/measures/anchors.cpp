#include "bench/measures/anchors.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "tree/base/memory.hpp"
#include "tree/base/simd.hpp"

namespace vortree::bench {
namespace {

double seconds_of(const auto& work) {
  using Clock = std::chrono::steady_clock;
  double best = 1e30;
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto begin = Clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return best;
}

// Values that the compiler can neither foresee nor drop.
volatile double hidden_factor = 0.999999, hidden_term = 1e-6, sink;

constexpr int rounds = 2'000'000;
// Enough chains to hide the latency of each, few enough for the registers.
#ifdef __AVX512F__
constexpr int chains = 16;
#else
constexpr int chains = 10;
#endif

template <class Vector, class Step>
void run_chains(Vector one, int times, const Step& step) {
  Vector value[chains];
  for (int c = 0; c < chains; ++c) value[c] = one * static_cast<float>(1 + c);
  for (int time = 0; time < times; ++time) {
#pragma GCC unroll 16
    for (int c = 0; c < chains; ++c) value[c] = step(value[c]);
  }
  Vector sum = {};
  for (int c = 0; c < chains; ++c) sum += value[c];
  sink = vortree::sum(sum);
}

constexpr int additions = rounds / 2, divisions = rounds / 16;

void multiply_and_add() {
  const Lanes factor = fill(hidden_factor), term = fill(hidden_term);
  run_chains(fill(1.0), additions, [=](Lanes value) { return value * factor + term; });
}

void divide() {
  const Lanes divisor = fill(hidden_factor);
  run_chains(fill(1.0), divisions, [=](Lanes value) { return value / divisor; });
}

void divide_singles() {
  const Singles divisor = fill(static_cast<float>(hidden_factor));
  run_chains(fill(1.0f), divisions, [=](Singles value) { return value / divisor; });
}

double triad_rate(int threads) {
  const std::size_t n = std::size_t{16} << 20;  // three arrays of 128 MB
  Reals a(n), b(n), c(n);
  const auto work = [&] {
#pragma omp parallel for simd num_threads(threads) schedule(static)
    for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0 * c[i];
  };
  std::ranges::fill(b, 1.0);
  std::ranges::fill(c, 2.0);
  work();
  return 3.0 * sizeof(double) * static_cast<double>(n) / seconds_of(work);
}

double write_rate(int threads) {
  Reals a(std::size_t{16} << 20);
  const double value = hidden_factor;
  const auto work = [&] {
#pragma omp parallel for simd num_threads(threads) schedule(static)
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = value;
  };
  work();
  return sizeof(double) * static_cast<double>(a.size()) / seconds_of(work);
}

double rate(int threads, double operations, void (*work)()) {
  const auto together = [&] {
#pragma omp parallel num_threads(threads)
    work();
  };
  together();
  return threads * operations / seconds_of(together);
}

}  // namespace

Anchors measure_anchors(int threads) {
  constexpr double lanes = lane_count;
  return {.fma = rate(threads, lanes * chains * additions, multiply_and_add),
          .divisions = rate(threads, lanes * chains * divisions, divide),
          .single_divisions = rate(threads, single_count * chains * divisions, divide_singles),
          .triad = triad_rate(threads),
          .write = write_rate(threads)};
}

}  // namespace vortree::bench
