#include "sph/method.hpp"

#include "sph/choice/choice.hpp"
#include "sph/choice/refusals.hpp"
#include "sph/choice/warnings.hpp"
#include "sph/solver.hpp"

namespace vortree::sph {

void SphMethod::choose(flow::Case& of, const flow::Written& written) {
  choose_missing(of, settings_, written);
}

void SphMethod::refuse(const flow::Case& of) const {
  refuse_senseless({of, settings_, neighbors_});
}

void SphMethod::refuse_beyond(const flow::Case& of, double memory) const {
  sph::refuse_beyond({of, settings_, neighbors_}, memory);
}

flow::Warnings SphMethod::warnings(const flow::Case& of) const {
  return sph::warnings({of, settings_, neighbors_});
}

std::unique_ptr<flow::Solver> SphMethod::begin(const flow::Case& of, double) const {
  return std::make_unique<SphSolver>(setup_of({of, settings_, neighbors_}));
}

}  // namespace vortree::sph
