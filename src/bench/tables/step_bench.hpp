#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measures/step_measure.hpp"
#include "flow/scales.hpp"
#include "flow/solver.hpp"

namespace vortree::bench {

/// quick    fewer steps, less often
/// threads  measured beside one thread; 0: as many as OpenMP takes
struct StepBench {
  std::filesystem::path csv;
  bool quick = false;
  int threads = 0;
};

/// One way to go on from a state: a name, and who makes the Solver.
struct StepVariant {
  std::string name;
  std::function<std::unique_ptr<flow::Solver>()> begin;
};

/// What is measured: a flow, and the ways to go on with it.
///
/// panels  of the wall; 0 without one
/// scales  by which drag is told
struct StepFlow {
  std::string name;
  int panels = 0;
  flow::Scales scales{};
  FlowState from{};
  std::vector<StepVariant> variants{};
};

/// Measures what a step of a flow costs, phase by phase, by every variant from one state on: the
/// same few steps again and again (bench/measures/step_measure.hpp).
///
/// flows    each made when its turn comes
/// csv      after lines that begin with # as in velocity.csv, for each flow, variant and number of
///          threads a row a phase (those of the method, and output: what is measured after a step),
///          and one of the whole step, called step:
///   flow, variant, threads, phase
///   ns                  a blob and step: seconds of the phase over all blobs of all steps, as they
///                       are when a step has ended. Those of the phases add up to that of the step
///   share               of the step
///   seconds             a step
///   blobs               after a step, in the mean
///   panels, steps, repeats
///   particle_steps      a second; from here on of the step alone
///   drag                during the first step, by the method's own route: of all variants the same
///                       but for the tolerance of the velocities; empty without a body
///   counts              name=number;name=number ...: Solver::counts(), a step in the mean
/// say      told one line for each variant and number of threads
/// throws   std::runtime_error if the file cannot be written; what a Solver throws
void step_bench(const StepBench& job, std::span<const std::function<StepFlow()>> flows,
                const std::function<void(std::string_view)>& say);

}  // namespace vortree::bench
