#include "io/scene/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <string_view>
#include <vector>

#include "body/extent.hpp"
#include "io/quote.hpp"
#include "io/scene/reference.hpp"
#include "io/scene/schema.hpp"
#include "io/tables/table.hpp"

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
bool lift(const Scene& s) {
  return s.body && s.check.lift_reference;
}
bool single(const Scene& s) {
  return s.body && s.others.empty();
}
bool wake(const Scene& s) {
  return single(s) && s.check.drag_reference;
}
bool wall(const Scene& s) {
  return single(s) && s.check.wall_vorticity_reference;
}
bool front(const Scene& s) {
  return single(s) && s.check.front_pressure_reference;
}
bool moments(const Scene& s) {
  return s.check.moments_reference.has_value();
}
bool at_rest(const Scene& s) {
  return s.plunge && s.flow.stream == Pair{0, 0};
}
bool started(const Scene& s) {
  return single(s) && body::round(*s.body) && !s.plunge && !s.motion && !s.initial &&
         s.flow.stream != Pair{0, 0};
}
bool in_stream(const Scene& s) {
  return s.plunge && s.flow.stream != Pair{0, 0};
}
bool fills_plane(const Scene& s) {
  return s.initial && s.initial->kind->periodic;
}
bool ends(const Scene& s) {
  return !fills_plane(s);
}
bool field(const Scene& s) {
  return s.check.exact == ExactAnswer::lamb_oseen ||
         s.check.exact == ExactAnswer::spinning_cylinder;
}
template <ExactAnswer answer>
bool exact(const Scene& s) {
  return s.check.exact == answer;
}
template <std::optional<double> CheckSettings::*known>
bool beside(const Scene& s) {
  return s.body && s.check.*known;
}
template <std::optional<std::vector<double>> CheckSettings::*known>
bool beside_each(const Scene& s) {
  return !s.others.empty() && s.check.*known;
}

struct Prerequisite {
  std::string_view key;
  std::optional<double> CheckSettings::*asked;
  bool (*held)(const Scene&);
  std::string_view words;
};

using C = CheckSettings;
constexpr std::string_view reference = "[body] and check.drag_reference";
constexpr std::string_view lift_reference = "[body] and check.lift_reference";
constexpr std::string_view known_field = "check.exact = \"lamb_oseen\" or \"spinning_cylinder\"";
constexpr std::string_view known_vortices = "check.exact = \"taylor_green\"";
constexpr std::string_view no_end = "a flow that does not fill the plane";
constexpr std::string_view wake_reference = "a single [body] and check.drag_reference";
constexpr std::string_view wall_reference = "a single [body] and check.wall_vorticity_reference";

constexpr Prerequisite needs[] = {
    {"drag_max", &C::drag_max, drag, reference},
    {"drag_rms", &C::drag_rms, drag, reference},
    {"early_drag_max", &C::early_drag_max, started,
     "a single circle at rest in a flow.stream, and no [initial]"},
    {"bubble_max", &C::bubble_max, wake, wake_reference},
    {"separation_max_deg", &C::separation_max_deg, wake, wake_reference},
    {"wall_vorticity_max", &C::wall_vorticity_max, wall, wall_reference},
    {"wall_vorticity_rms", &C::wall_vorticity_rms, wall, wall_reference},
    {"front_pressure_max", &C::front_pressure_max, front,
     "a single [body] and check.front_pressure_reference"},
    {"lift_error_max", &C::lift_error_max, lift, lift_reference},
    {"lift_error_rms", &C::lift_error_rms, lift, lift_reference},
    {"lift_max", &C::lift_max, body, "[body]"},
    {"routes_max", &C::routes_max, body, "[body]"},
    {"lift_routes_max", &C::lift_routes_max, body, "[body]"},
    {"strouhal_max", &C::strouhal_max, beside<&C::strouhal>, "[body] and check.strouhal"},
    {"mean_drag_max", &C::mean_drag_max, beside<&C::mean_drag>, "[body] and check.mean_drag"},
    {"mean_lift_max", &C::mean_lift_max, beside<&C::mean_lift>, "[body] and check.mean_lift"},
    {"mean_drag_each_max", &C::mean_drag_each_max, beside_each<&C::mean_drag_each>,
     "several bodies and check.mean_drag_each"},
    {"mean_lift_each_max", &C::mean_lift_each_max, beside_each<&C::mean_lift_each>,
     "several bodies and check.mean_lift_each"},
    {"lift_rms_each_max", &C::lift_rms_each_max, beside_each<&C::lift_rms_each>,
     "several bodies and check.lift_rms_each"},
    {"lift_phases_max_deg", &C::lift_phases_max_deg, beside_each<&C::lift_phases_deg>,
     "several bodies and check.lift_phases_deg"},
    {"morison_drag_max", &C::morison_drag_max, beside<&C::morison_drag>,
     "[body] and check.morison_drag"},
    {"morison_mass_max", &C::morison_mass_max, beside<&C::morison_mass>,
     "[body] and check.morison_mass"},
    {"morison_drag_max", &C::morison_drag_max, at_rest, "[plunge] in fluid at rest"},
    {"morison_mass_max", &C::morison_mass_max, at_rest, "[plunge] in fluid at rest"},
    {"theodorsen_max", &C::theodorsen_max, in_stream, "[plunge] and a flow.stream"},
    {"vorticity_max", &C::vorticity_max, field, known_field},
    {"velocity_max", &C::velocity_max, field, known_field},
    {"rotation_max", &C::rotation_max, exact<ExactAnswer::kirchhoff_ellipse>,
     "check.exact = \"kirchhoff_ellipse\""},
    {"merger_max", &C::merger_max, exact<ExactAnswer::corotating_pair>,
     "check.exact = \"corotating_pair\""},
    {"speed_max", &C::speed_max, exact<ExactAnswer::dipole>, "check.exact = \"dipole\""},
    {"quadrupole_max", &C::quadrupole_max, moments, "check.moments_reference"},
    {"separation_max", &C::separation_max, moments, "check.moments_reference"},
    {"circulation_max", &C::circulation_max, ends, no_end},
    {"impulse_max", &C::impulse_max, ends, no_end},
    {"second_moment_max", &C::second_moment_max, ends, no_end},
    {"velocity_rms", &C::velocity_rms, exact<ExactAnswer::taylor_green>, known_vortices},
    {"pressure_rms", &C::pressure_rms, exact<ExactAnswer::taylor_green>, known_vortices},
    {"volume_max", &C::volume_max, fills_plane, known_vortices},
    {"momentum_max", &C::momentum_max, fills_plane, known_vortices},
    {"energy_max", &C::energy_max, free_space, "free space, no [body]"},
};

/// What is known of a flow, and how far off it may be: one is nothing without the other.
struct Known {
  std::string_view key;
  std::optional<double> CheckSettings::*known, CheckSettings::*asked;
};

constexpr Known knowns[] = {{"strouhal", &C::strouhal, &C::strouhal_max},
                            {"mean_drag", &C::mean_drag, &C::mean_drag_max},
                            {"mean_lift", &C::mean_lift, &C::mean_lift_max},
                            {"morison_drag", &C::morison_drag, &C::morison_drag_max},
                            {"morison_mass", &C::morison_mass, &C::morison_mass_max}};

/// The same of each of several bodies, or of each but the first.
struct KnownOfEach {
  std::string_view key;
  std::optional<std::vector<double>> CheckSettings::*known;
  std::string_view bound;
  std::optional<double> CheckSettings::*asked;
  bool first = true;
};

constexpr KnownOfEach knowns_of_each[] = {
    {"mean_drag_each", &C::mean_drag_each, "mean_drag_each_max", &C::mean_drag_each_max},
    {"mean_lift_each", &C::mean_lift_each, "mean_lift_each_max", &C::mean_lift_each_max},
    {"lift_rms_each", &C::lift_rms_each, "lift_rms_each_max", &C::lift_rms_each_max},
    {"lift_phases_deg", &C::lift_phases_deg, "lift_phases_max_deg", &C::lift_phases_max_deg,
     false}};

/// A column of a reference; who asks for one alone has it read for that only.
struct ReferenceColumn {
  std::string_view name;
  std::optional<double> CheckSettings::*asked = nullptr;
};

struct Reference {
  std::string_view key;
  std::optional<std::string> CheckSettings::*written;
  std::vector<ReferenceColumn> columns;  // the first: times
  bool many_at_once = false;             // rows of one time, of places along a wall
};

const std::array references{
    Reference{"check.drag_reference",
              &C::drag_reference,
              {{"T"}, {"C_D"}, {"L_over_D", &C::bubble_max}, {"sep_deg", &C::separation_max_deg}}},
    Reference{"check.lift_reference", &C::lift_reference, {{"T"}, {"C_L"}}},
    Reference{"check.wall_vorticity_reference",
              &C::wall_vorticity_reference,
              {{"T"}, {"theta_deg"}, {"omega_R_over_U"}},
              true},
    Reference{
        "check.front_pressure_reference", &C::front_pressure_reference, {{"T"}, {"cp_front"}}},
    Reference{"check.moments_reference",
              &C::moments_reference,
              {{"t"},
               {"quadrupole_xx", &C::quadrupole_max},
               {"quadrupole_xy", &C::quadrupole_max},
               {"separation", &C::separation_max}}}};

/// Row after row later than the one before.
void require_course(const std::vector<double>& times, std::string_view name, bool many_at_once) {
  for (std::size_t k = 1; k < times.size(); ++k)
    if (!(times[k] > times[k - 1] || (many_at_once && times[k] == times[k - 1])))
      throw InputError(fmt::format("{} = {:g} comes after {} = {:g}: times must increase", name,
                                   times[k], name, times[k - 1]));
}

void require_values(const std::vector<double>& values, std::string_view name) {
  if (std::ranges::none_of(values, [](double value) { return std::isfinite(value); }))
    throw InputError(fmt::format("the column {} has no number", name));
}

/// throws  InputError: no such file, no table, no such column, none of it or in no order
void read_columns(const std::filesystem::path& path, const Reference& reference,
                  const CheckSettings& check) {
  require_reference_file(path);
  const Table table(path);
  for (const auto& [name, asked] : reference.columns)
    if (!asked || check.*asked) require_values(table.column(name), name);
  const std::string_view time = reference.columns.front().name;
  require_course(table.column(time), time, reference.many_at_once);
}

void require_reference(const Document& document, const Scene& scene, const Reference& reference) {
  const std::optional<std::string>& written = scene.check.*reference.written;
  if (!written || lacks_reference(scene, *written)) return;
  try {
    if (written->empty()) throw InputError("the name of a file was expected");
    if (written->find(by_reynolds) != std::string::npos && !scene.flow.reynolds)
      throw InputError(fmt::format("{} needs flow.reynolds", by_reynolds));
    read_columns(reference_path(scene, *written), reference, scene.check);
  } catch (const InputError& broken) {
    document.refuse(reference.key, fmt::format("{} is {}; {}", reference.key,
                                               quote(shortened(*written, 60)), broken.what()));
  }
}

/// As many numbers as there are bodies to be told of, and how far off they may be.
void require_each(const Document& document, const Scene& scene, const KnownOfEach& known) {
  const std::optional<std::vector<double>>& written = scene.check.*known.known;
  if (!written) return;
  const std::string key = fmt::format("check.{}", known.key);
  if (!(scene.check.*known.asked))
    document.refuse(key, fmt::format("{} is written; that needs check.{}, how far off it may be",
                                     key, known.bound));
  const std::size_t bodies = scene.others.size() + 1, expected = bodies - (known.first ? 0 : 1);
  if (bodies > 1 && written->size() != expected)
    document.refuse(
        key, fmt::format("{} is a list of {}; a number of each of {} bodies{} was expected", key,
                         written->size(), bodies, known.first ? "" : " but the first"));
}

}  // namespace

void check_asked(const Document& document, const Scene& scene) {
  for (const Prerequisite& need : needs)
    if (scene.check.*need.asked && !need.held(scene)) {
      const std::string key = fmt::format("check.{}", need.key);
      document.refuse(
          key, fmt::format("{} is {}; that needs {}", key, *(scene.check.*need.asked), need.words));
    }
  for (const Known& known : knowns)
    if (scene.check.*known.known && !(scene.check.*known.asked)) {
      const std::string key = fmt::format("check.{}", known.key);
      document.refuse(key, fmt::format("{} is {}; that needs {}_max, how far off it may be", key,
                                       *(scene.check.*known.known), key));
    }
  for (const KnownOfEach& known : knowns_of_each) require_each(document, scene, known);
  for (const Reference& reference : references) require_reference(document, scene, reference);
}

namespace {

using Number = std::optional<double>;

/// The largest or the mean deviation that is allowed.
Key most(std::string_view name, Number& target, std::string says) {
  return key(name, target, positive, "", std::move(says));
}

/// T = 2 U t/D beside a body, t in free space.
Key from(std::string_view name, Number& target, std::string says) {
  return key(name, target, not_negative, "", std::move(says));
}

Key file(std::string_view name, std::optional<std::string>& target, std::string says) {
  return key(name, target, anything, "", std::move(says));
}

/// A number of each of several bodies.
Key each(std::string_view name, std::optional<std::vector<double>>& target, std::string says) {
  return key(name, target, anything, "", std::move(says));
}

std::vector<Key> against_references(CheckSettings& c) {
  return {
      file("drag_reference", c.drag_reference,
           "CSV file of T and C_D, of L_over_D and sep_deg if they are checked; its place is "
           "as seen from the scene's; `{reynolds}` in the name of a reference is the value of "
           "`flow.reynolds`, and a flow that has no such file is not held against it"),
      most("drag_max", c.drag_max, "drag: largest deviation, relative"),
      most("drag_rms", c.drag_rms, "drag: root mean square of the deviation, relative"),
      from("drag_from", c.drag_from, "drag counts from this T = 2 U t/D on, 0 if not written"),
      file("lift_reference", c.lift_reference,
           "CSV file of T and C_L, which may be that of the drag"),
      most("lift_error_max", c.lift_error_max,
           "lift: largest deviation, relative to the largest lift of the reference at the "
           "times that count"),
      most("lift_error_rms", c.lift_error_rms, "lift: root mean square of the deviation, likewise"),
      from("lift_from", c.lift_from, "lift counts from this T on, 0 if not written"),
      most("early_drag_max", c.early_drag_max,
           "mean drag until T = 0.1 off that of a circle in a sudden stream, which is known by "
           "heart to 0.4 % at any Reynolds number from 20 on: deviation, relative"),
      file("wall_vorticity_reference", c.wall_vorticity_reference,
           "CSV file of T, theta_deg and omega_R_over_U"),
      most("wall_vorticity_max", c.wall_vorticity_max,
           "wall vorticity: largest relative L2 deviation along the wall of any time"),
      most("wall_vorticity_rms", c.wall_vorticity_rms,
           "wall vorticity: root mean square over the times of the same"),
      from("wall_vorticity_from", c.wall_vorticity_from,
           "wall vorticity counts from this T on, 0 if not written"),
      file("front_pressure_reference", c.front_pressure_reference, "CSV file of T and cp_front"),
      most("front_pressure_max", c.front_pressure_max,
           "pressure at the front of the body: largest deviation of C_p, by vortices"),
      from("front_pressure_from", c.front_pressure_from,
           "pressure at the front counts from this T on, 0 if not written"),
      most("bubble_max", c.bubble_max,
           "length of the bubble behind the body: largest deviation, relative"),
      from("bubble_from", c.bubble_from, "the bubble counts from this T on, 0 if not written"),
      key("separation_max_deg", c.separation_max_deg, positive, "degrees",
          "angle of separation: largest deviation"),
      from("separation_from", c.separation_from,
           "the angle counts from this T on, 0 if not written")};
}

std::vector<Key> of_forces(CheckSettings& c) {
  return {
      most("lift_max", c.lift_max, "largest lift coefficient, as it is, by either route"),
      most("routes_max", c.routes_max,
           "drag by impulse against drag by the wall: largest deviation, relative; of a body "
           "that plunges, to the largest drag"),
      from("routes_from", c.routes_from, "the routes count from this T on, 0 if not written"),
      most("lift_routes_max", c.lift_routes_max, "the same of lift, relative to the largest lift")};
}

std::vector<Key> of_free_space(CheckSettings& c) {
  return {key("exact", c.exact,
              "the answer known by heart that the initial flow of this kind, or a circle that "
              "spins in fluid at rest, is held against"),
          most("vorticity_max", c.vorticity_max,
               "vorticity at the end of lamb_oseen or spinning_cylinder: largest deviation, "
               "relative to that at the centre or the wall"),
          most("velocity_max", c.velocity_max,
               "velocity at the end, likewise: largest deviation, relative to the fastest"),
          most("second_moment_max", c.second_moment_max,
               "second moment off what viscosity makes of it: largest deviation, relative to that "
               "at the start"),
          most("circulation_max", c.circulation_max,
               "circulation off that at the start: largest deviation, relative; U D beside a body"),
          most("impulse_max", c.impulse_max,
               "impulse off that at the start and what the stream makes of it: largest deviation, "
               "relative to circulation times core, or U D^2"),
          file("moments_reference", c.moments_reference,
               "CSV file of t and, as they are checked, quadrupole_xx, quadrupole_xy, separation"),
          most("quadrupole_max", c.quadrupole_max,
               "quadrupole off the reference: largest deviation, relative to its largest"),
          most("separation_max", c.separation_max,
               "distance of two vortices off the reference: largest deviation, relative to its "
               "largest"),
          most("rotation_max", c.rotation_max,
               "kirchhoff_ellipse: deviation of the mean rate of turning, relative"),
          most("speed_max", c.speed_max, "dipole: deviation of the distance travelled, relative"),
          most("merger_max", c.merger_max,
               "corotating_pair: core over separation when that has fallen by 1 %, off 0.22"),
          most("energy_max", c.energy_max,
               "energy off that at the start and what viscosity took: largest deviation, relative "
               "to that at the start")};
}

std::vector<Key> of_periodic_flow(CheckSettings& c) {
  return {most("velocity_rms", c.velocity_rms,
               "taylor_green: velocity at the end, root mean square of the deviation over that of "
               "the velocity"),
          most("pressure_rms", c.pressure_rms, "the same of the pressure, less its mean"),
          most("volume_max", c.volume_max,
               "volume of all particles off that of a periodic box: largest deviation, relative"),
          most("momentum_max", c.momentum_max,
               "momentum in a periodic box, which has none: largest, relative to that of all fluid "
               "at the initial speed")};
}

std::vector<Key> of_shedding(CheckSettings& c) {
  return {
      key("strouhal", c.strouhal, positive, "",
          "of a wake that sheds: the highest peak of the lift's spectrum, times D/U; of several "
          "bodies that of each, and the farthest off counts"),
      most("strouhal_max", c.strouhal_max, "deviation from `check.strouhal`, relative"),
      key("mean_drag", c.mean_drag, anything, "",
          "of a wake that sheds, or past a body that plunges: mean drag (thrust: below 0), by "
          "impulse or by SPH at the wall"),
      most("mean_drag_max", c.mean_drag_max,
           "deviation from `check.mean_drag`, relative; as it is if that is 0"),
      key("mean_lift", c.mean_lift, anything, "", "of a wake that sheds: mean lift, likewise"),
      most("mean_lift_max", c.mean_lift_max,
           "deviation from `check.mean_lift`, relative; as it is if that is 0"),
      each("mean_drag_each", c.mean_drag_each, "mean drag of each of several bodies, at the wall"),
      most("mean_drag_each_max", c.mean_drag_each_max,
           "deviation from `check.mean_drag_each`, relative to the largest of them"),
      each("mean_lift_each", c.mean_lift_each, "mean lift, likewise"),
      most("mean_lift_each_max", c.mean_lift_each_max,
           "deviation from `check.mean_lift_each`, likewise; as it is if all are 0"),
      each("lift_rms_each", c.lift_rms_each,
           "root mean square of what the lift of each differs from its mean"),
      most("lift_rms_each_max", c.lift_rms_each_max,
           "deviation from `check.lift_rms_each`, relative to the largest of them"),
      key("lift_phases_deg", c.lift_phases_deg, anything, "degrees",
          "by how much the lift of each body but the first is ahead of that of the first, at the "
          "frequency of that"),
      key("lift_phases_max_deg", c.lift_phases_max_deg, positive, "degrees",
          "deviation from `check.lift_phases_deg`, the short way around"),
      from("shedding_from", c.shedding_from, "the wake counts from this T on, 0 if not written")};
}

std::vector<Key> of_plunge(CheckSettings& c) {
  return {
      key("morison_drag", c.morison_drag, positive, "",
          "of a body that plunges in fluid at rest: C_D of its drag against the velocity"),
      most("morison_drag_max", c.morison_drag_max, "deviation from `check.morison_drag`, relative"),
      key("morison_mass", c.morison_mass, positive, "",
          "the same: C_M of its drag against the acceleration"),
      most("morison_mass_max", c.morison_mass_max, "deviation from `check.morison_mass`, relative"),
      most("theodorsen_max", c.theodorsen_max,
           "of a body that plunges in a stream: what the lift at the plunge's frequency differs "
           "from that of a flat plate, relative"),
      from("plunge_from", c.plunge_from, "whole periods count from this T on, 0 if not written")};
}

std::vector<Key> of_cost(CheckSettings& c) {
  return {most("blobs_max", c.blobs_max, "most blobs that there may be at any step")};
}

}  // namespace

std::vector<Key> keys(CheckSettings& check) {
  std::vector<Key> all;
  for (const auto part : {against_references, of_forces, of_free_space, of_periodic_flow,
                          of_shedding, of_plunge, of_cost})
    for (Key& key : part(check)) all.push_back(std::move(key));
  return all;
}

}  // namespace vortree::io
