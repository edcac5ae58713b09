// What proves that the search for races works: two programs with one, and one without.
//   race counter   threads add to one number
//   race nowait    threads read what others write, as no barrier stands between
//   race none      the same with the barrier, and a sum by reduction
#include <cstdio>
#include <numeric>
#include <string_view>
#include <vector>

namespace {

constexpr int n = 10'000, threads = 4;

long counted() {
  long count = 0;
#pragma omp parallel for num_threads(threads)
  for (int i = 0; i < n; ++i) ++count;
  return count;
}

long turned_without_barrier() {
  std::vector<int> values(n), turned(n);
#pragma omp parallel num_threads(threads)
  {
#pragma omp for nowait
    for (int i = 0; i < n; ++i) values[i] = i;
#pragma omp for
    for (int i = 0; i < n; ++i) turned[i] = values[n - 1 - i];
  }
  return std::accumulate(turned.begin(), turned.end(), 0L);
}

long turned_with_barrier() {
  std::vector<int> values(n);
  long sum = 0;
#pragma omp parallel num_threads(threads)
  {
#pragma omp for
    for (int i = 0; i < n; ++i) values[i] = i;
#pragma omp for reduction(+ : sum)
    for (int i = 0; i < n; ++i) sum += values[n - 1 - i];
  }
  return sum + std::accumulate(values.begin(), values.end(), 0L);
}

}  // namespace

int main(int, char** argv) {
  const std::string_view which = argv[1];
  std::printf("%ld\n", which == "counter"  ? counted()
                       : which == "nowait" ? turned_without_barrier()
                                           : turned_with_barrier());
}
