#include "fmm/pairs/pair_sums.hpp"

#include "fmm/direct.hpp"

namespace vortree::fmm {
namespace {

std::vector<double> copy(std::span<const double> values) {
  return {values.begin(), values.end()};
}

}  // namespace

PairSums::PairSums(const Sources& sources, const Options& options, const tree::Phase& phase)
    : sources_{copy(sources.x), copy(sources.y), copy(sources.gamma), copy(sources.sigma)},
      cores_(options.cores),
      phase_(phase) {}

Expected PairSums::velocity(std::span<double> u, std::span<double> v) const {
  return velocity(themselves(), u, v);
}

Expected PairSums::velocity_and_gradient(std::span<double> u, std::span<double> v,
                                         std::span<double> ux, std::span<double> uy,
                                         std::span<double> vx) const {
  velocity(u, v);
  return gradient(themselves(), ux, uy, vx);
}

Expected PairSums::velocity(const Targets& targets, std::span<double> u,
                            std::span<double> v) const {
  tell();
  velocity_direct(sources_.view(), targets, cores_, u, v);
  return {};
}

Expected PairSums::velocity_bare(tree::Points targets, std::span<double> u,
                                 std::span<double> v) const {
  tell();
  velocity_direct({sources_.x, sources_.y, sources_.gamma, {}}, {targets.x, targets.y, {}},
                  Cores::source, u, v);
  return {};
}

Expected PairSums::gradient(const Targets& targets, std::span<double> ux, std::span<double> uy,
                            std::span<double> vx) const {
  tell();
  gradient_direct(sources_.view(), targets, cores_, ux, uy, vx);
  return {};
}

Expected PairSums::stream_function(const Targets& targets, std::span<double> psi) const {
  tell();
  stream_function_direct(sources_.view(), targets, cores_, psi);
  return {};
}

Work PairSums::work() const {
  const std::uint64_t n = sources_.x.size();
  return sources_.sigma.empty() ? Work{.bare = n * n} : Work{.cored = n * n};
}

std::size_t PairSums::bytes() const {
  return sizeof(double) * (3 * sources_.x.size() + sources_.sigma.size());
}

}  // namespace vortree::fmm
