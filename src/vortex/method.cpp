#include "vortex/method.hpp"

#include "vortex/choice/choice.hpp"
#include "vortex/choice/cost.hpp"
#include "vortex/choice/refusals.hpp"
#include "vortex/choice/warnings.hpp"
#include "vortex/solver.hpp"

namespace vortree::vortex {

std::unique_ptr<flow::Method> VortexMethod::clone() const {
  return std::make_unique<VortexMethod>(*this);
}

void VortexMethod::choose(flow::Case& of, const flow::Written& written) {
  choose_missing(of, settings_, written);
  cores_written_ = written("cores", "sigma_max");
}

void VortexMethod::refuse(const flow::Case& of) const {
  refuse_senseless({of, settings_});
}

void VortexMethod::refuse_beyond(const flow::Case& of, double memory) const {
  vortex::refuse_beyond({of, settings_}, memory);
}

flow::Warnings VortexMethod::warnings(const flow::Case& of) const {
  flow::Warnings list = vortex::warnings({of, settings_});
  if (cores_written_) doubt_accuracy(list, {of, settings_});
  return list;
}

std::unique_ptr<flow::Solver> VortexMethod::begin(const flow::Case& of, double memory) const {
  Setup setup = setup_of({of, settings_});
  setup.held_blobs = blobs_in(memory);
  return std::make_unique<VortexSolver>(std::move(setup));
}

}  // namespace vortree::vortex
