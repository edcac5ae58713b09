#include "bench/measures/methods.hpp"

#include <algorithm>
#include <array>

#include "bench/rivals/velocity/grid.hpp"
#include "fmm/direct.hpp"

namespace vortree::bench {
namespace {

template <fmm::SumMethod method>
Account sum_by_plan(const VelocitySum& sum, const fmm::Options& asked, const tree::Phase& phase,
                    Use use) {
  fmm::Options options = asked;
  options.method = method;
  const fmm::Plan plan(sum.blobs, options, phase);
  if (sum.elsewhere)
    plan.velocity(sum.targets, sum.u, sum.v);
  else
    plan.velocity(sum.u, sum.v);
  phase("");

  Account account;
  account.builder = options.builder == fmm::Builder::reverse ? "reverse" : "forward";
  account.tolerance = options.tolerance;
  account.order = plan.order();
  if (use.counted && !sum.elsewhere) account.work = plan.work();
  return account;
}

Account sum_on_grid(const VelocitySum& sum, const fmm::Options& options, const tree::Phase& phase,
                    Use use) {
  const GridOptions grid{.tolerance = options.tolerance, .measured = use.repeated};
  velocity_grid(sum.blobs, sum.targets, grid, sum.u, sum.v, phase);
  phase("");
  Account account;
  account.tolerance = options.tolerance;
  return account;
}

Account sum_directly(const VelocitySum& sum, const fmm::Options&, const tree::Phase& phase, Use) {
  phase("near");
  fmm::velocity_direct(sum.blobs, sum.targets, fmm::Cores::source, sum.u, sum.v);
  phase("");
  const std::uint64_t n = sum.blobs.size(), m = sum.targets.size();
  const std::uint64_t pairs = sum.elsewhere ? n * m : n * (std::max<std::uint64_t>(n, 1) - 1);
  Account account;
  account.work = fmm::Work{};
  (sum.blobs.sigma.empty() ? account.work->bare : account.work->cored) = pairs;
  return account;
}

constexpr std::array table{
    VelocityMethod{
        .name = "fmm", .bare = true, .exact = false, .sum = sum_by_plan<fmm::SumMethod::fmm>},
    VelocityMethod{
        .name = "boxes", .bare = true, .exact = false, .sum = sum_by_plan<fmm::SumMethod::boxes>},
    VelocityMethod{.name = "grid", .bare = false, .exact = false, .sum = sum_on_grid},
    VelocityMethod{.name = "direct", .bare = true, .exact = true, .sum = sum_directly}};

}  // namespace

std::span<const VelocityMethod> methods() {
  return table;
}

}  // namespace vortree::bench
