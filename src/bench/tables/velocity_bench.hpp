#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

namespace vortree::bench {

/// quick    smaller sets: two minutes instead of twenty
/// threads  measured beside one thread; 0: as many as OpenMP takes
/// largest  no set has more blobs; 0: 4e6, quick 1e6
struct VelocityBench {
  std::filesystem::path csv;
  bool quick = false;
  int threads = 0;
  std::size_t largest = 0;
};

/// Measures every velocity method that serves: on bare vortices (uniform, ringwake, hard) and on
/// overlapping blobs, for numbers from 100 to 4e6, tolerances from 1e-2 to 1e-13, one thread and
/// several.
///
/// csv      one row a measurement, written as soon as it is made; first lines that begin with #
///          say where the numbers come from and what the machine can do
///   set, n, method, tolerance (empty: none), threads
///   seconds, fastest    median and least of `repeats` sums [s]; memory is warm
///   targets             fewer than n: the times were scaled up from a sum at so many
///   relative_l2, p99, max   errors as in VelocityError, against long double sums at `sampled`
///   cpu                 processor seconds a second during the repeats: fewer than `threads` if
///                       others used the machine, or if threads waited for each other
///   bytes               memory that the first sum added
///   order               terms of the longest series
///   bare, cored         pairs summed one by one; scaled up as the times are
///   near_floor          least seconds that this machine needs for those pairs and for the terms of
///                       box-to-point series, in doubles: half a division a bare pair, 18 fused
///                       operations a cored one, 4 a term
///   tree_floor          least seconds to sort: 120 bytes a blob through memory
///   phases              name=seconds;name=seconds ...
/// say      told one line for each measurement
/// throws   std::runtime_error if the file cannot be written
void velocity_bench(const VelocityBench& job, const std::function<void(std::string_view)>& say);

}  // namespace vortree::bench
