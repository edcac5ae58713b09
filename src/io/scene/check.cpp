#include "io/scene/check.hpp"

#include <fmt/format.h>

#include <string_view>

namespace vortree::io {
namespace {

bool body(const Scene& s) {
  return s.body.has_value();
}
bool free_space(const Scene& s) {
  return !s.body;
}
bool drag(const Scene& s) {
  return s.body && s.check.drag_reference;
}
bool wall(const Scene& s) {
  return s.body && s.check.wall_vorticity_reference;
}
bool moments(const Scene& s) {
  return s.check.moments_reference.has_value();
}
bool at_rest(const Scene& s) {
  return s.plunge && s.flow.stream == Vec2{0, 0};
}
bool in_stream(const Scene& s) {
  return s.plunge && s.flow.stream != Vec2{0, 0};
}
template <ExactAnswer answer>
bool exact(const Scene& s) {
  return s.check.exact == answer;
}
template <std::optional<double> SceneCheck::*known>
bool beside(const Scene& s) {
  return s.body && s.check.*known;
}

struct Need {
  std::string_view key;
  std::optional<double> SceneCheck::*asked;
  bool (*held)(const Scene&);
  std::string_view words;
};

using C = SceneCheck;
constexpr std::string_view reference = "[body] and check.drag_reference";
constexpr std::string_view wall_reference = "[body] and check.wall_vorticity_reference";

constexpr Need needs[] = {
    {"drag_max", &C::drag_max, drag, reference},
    {"drag_rms", &C::drag_rms, drag, reference},
    {"bubble_max", &C::bubble_max, drag, reference},
    {"separation_max_deg", &C::separation_max_deg, drag, reference},
    {"wall_vorticity_max", &C::wall_vorticity_max, wall, wall_reference},
    {"wall_vorticity_rms", &C::wall_vorticity_rms, wall, wall_reference},
    {"lift_max", &C::lift_max, body, "[body]"},
    {"routes_max", &C::routes_max, body, "[body]"},
    {"lift_routes_max", &C::lift_routes_max, body, "[body]"},
    {"strouhal_max", &C::strouhal_max, beside<&C::strouhal>, "[body] and check.strouhal"},
    {"mean_drag_max", &C::mean_drag_max, beside<&C::mean_drag>, "[body] and check.mean_drag"},
    {"mean_lift_max", &C::mean_lift_max, beside<&C::mean_lift>, "[body] and check.mean_lift"},
    {"morison_drag_max", &C::morison_drag_max, beside<&C::morison_drag>,
     "[body] and check.morison_drag"},
    {"morison_mass_max", &C::morison_mass_max, beside<&C::morison_mass>,
     "[body] and check.morison_mass"},
    {"morison_drag_max", &C::morison_drag_max, at_rest, "[plunge] in fluid at rest"},
    {"morison_mass_max", &C::morison_mass_max, at_rest, "[plunge] in fluid at rest"},
    {"theodorsen_max", &C::theodorsen_max, in_stream, "[plunge] and a flow.stream"},
    {"vorticity_max", &C::vorticity_max, exact<ExactAnswer::lamb_oseen>,
     "check.exact = \"lamb_oseen\""},
    {"velocity_max", &C::velocity_max, exact<ExactAnswer::lamb_oseen>,
     "check.exact = \"lamb_oseen\""},
    {"rotation_max", &C::rotation_max, exact<ExactAnswer::kirchhoff_ellipse>,
     "check.exact = \"kirchhoff_ellipse\""},
    {"merger_max", &C::merger_max, exact<ExactAnswer::corotating_pair>,
     "check.exact = \"corotating_pair\""},
    {"speed_max", &C::speed_max, exact<ExactAnswer::dipole>, "check.exact = \"dipole\""},
    {"quadrupole_max", &C::quadrupole_max, moments, "check.moments_reference"},
    {"separation_max", &C::separation_max, moments, "check.moments_reference"},
    {"energy_max", &C::energy_max, free_space, "free space, no [body]"},
};

}  // namespace

void check_asked(const Document& document, const Scene& scene) {
  for (const Need& need : needs)
    if (scene.check.*need.asked && !need.held(scene)) {
      const std::string key = fmt::format("check.{}", need.key);
      document.refuse(
          key, fmt::format("{} is {}; that needs {}", key, *(scene.check.*need.asked), need.words));
    }
}

}  // namespace vortree::io
