#include "vortex/velocity.hpp"

#include "fmm/direct.hpp"

namespace vortree::vortex {
namespace {

class Planned final : public Velocity {
 public:
  explicit Planned(const fmm::Options& options) : options_(options) {}

  void upon_itself_and(const fmm::Blobs& blobs, tree::Points bare_targets, Velocities& upon_blobs,
                       Velocities& upon_targets) const override {
    const fmm::Plan plan(blobs, options_);
    plan.velocity(upon_blobs.u, upon_blobs.v);
    plan.velocity_bare(bare_targets, upon_targets.u, upon_targets.v);
  }

  void upon_itself_and(const fmm::Blobs& blobs, tree::Points bare_targets, Velocities& upon_blobs,
                       Gradients& at_blobs, Velocities& upon_targets) const override {
    const fmm::Plan plan(blobs, options_);
    plan.velocity_and_gradient(upon_blobs.u, upon_blobs.v, at_blobs.ux, at_blobs.uy, at_blobs.vx);
    plan.velocity_bare(bare_targets, upon_targets.u, upon_targets.v);
  }

  void upon_both(const fmm::Blobs& sources, tree::Points bare_targets, Velocities& bare,
                 tree::Points targets, Velocities& cored) const override {
    const fmm::Plan plan(sources, elsewhere());
    plan.velocity_bare(bare_targets, bare.u, bare.v);
    plan.velocity(fmm::Targets{targets.x, targets.y, {}}, cored.u, cored.v);
  }

  void upon(const fmm::Blobs& sources, tree::Points targets, Velocities& u) const override {
    fmm::Plan(sources, elsewhere()).velocity(fmm::Targets{targets.x, targets.y, {}}, u.u, u.v);
  }

 private:
  /// A point has no core of its own that could enter a mean.
  fmm::Options elsewhere() const {
    fmm::Options options = options_;
    options.cores = fmm::Cores::source;
    return options;
  }

  fmm::Options options_;
};

class DirectSum final : public Velocity {
 public:
  explicit DirectSum(fmm::Cores cores) : cores_(cores) {}

  void upon_itself_and(const fmm::Blobs& blobs, tree::Points bare_targets, Velocities& upon_blobs,
                       Velocities& upon_targets) const override {
    fmm::velocity_direct(blobs, {blobs.x, blobs.y, blobs.sigma}, cores_, upon_blobs.u,
                         upon_blobs.v);
    upon({blobs.x, blobs.y, blobs.gamma, {}}, bare_targets, upon_targets);
  }

  void upon_itself_and(const fmm::Blobs& blobs, tree::Points bare_targets, Velocities& upon_blobs,
                       Gradients& at_blobs, Velocities& upon_targets) const override {
    upon_itself_and(blobs, bare_targets, upon_blobs, upon_targets);
    fmm::gradient_direct(blobs, {blobs.x, blobs.y, blobs.sigma}, cores_, at_blobs.ux, at_blobs.uy,
                         at_blobs.vx);
  }

  void upon_both(const fmm::Blobs& sources, tree::Points bare_targets, Velocities& bare,
                 tree::Points targets, Velocities& cored) const override {
    upon({sources.x, sources.y, sources.gamma, {}}, bare_targets, bare);
    upon(sources, targets, cored);
  }

  void upon(const fmm::Blobs& sources, tree::Points targets, Velocities& u) const override {
    fmm::velocity_direct(sources, {targets.x, targets.y, {}}, fmm::Cores::source, u.u, u.v);
  }

 private:
  fmm::Cores cores_;
};

}  // namespace

std::unique_ptr<Velocity> velocity_by_plan(const fmm::Options& options) {
  return std::make_unique<Planned>(options);
}

std::unique_ptr<Velocity> velocity_by_direct_sum(fmm::Cores cores) {
  return std::make_unique<DirectSum>(cores);
}

}  // namespace vortree::vortex
