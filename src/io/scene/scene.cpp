#include "io/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/scene/check.hpp"
#include "io/scene/document.hpp"
#include "io/scene/motion.hpp"
#include "io/scene/reader.hpp"
#include "io/scene/reference.hpp"
#include "io/scene/sizes.hpp"
#include "io/tables/coordinates.hpp"

namespace vortree::io {
namespace {

/// An answer known by heart is that of one flow.
void check_exact(const Document& document, const Scene& scene) {
  const ExactAnswer exact = *scene.check.exact;
  const bool spins = scene.motion && scene.motion->spin != 0 && !scene.motion->given_by_time() &&
                     !scene.plunge && !scene.initial && flow::speed_of_stream(scene) == 0;
  if (exact == ExactAnswer::spinning_cylinder
          ? spins
          : scene.initial && scene.initial->kind->name == word(exact))
    return;
  document.refuse(
      "check.exact",
      exact == ExactAnswer::spinning_cylinder
          ? "check.exact is \"spinning_cylinder\"; that needs motion.spin alone, in fluid at "
            "rest and without [initial] or [plunge]"
          : fmt::format("check.exact is {0}; that needs the table [initial] of kind {0}",
                        quote(word(exact))));
}

void hold_check(const Document& document, const Scene& scene) {
  if (scene.check.exact) check_exact(document, scene);
  check_asked(document, scene);
}

/// The one that computes a scene, which the reader has seen to be there.
auto& method_of(auto& scene) {
  return *std::ranges::find(scene.methods, scene.method,
                            [](const flow::AnyMethod& m) { return m->name(); });
}

/// The points of a body's outline, from the file that it names.
void read_points(const Document& document, const Scene& scene, body::BodySettings& body,
                 std::string_view key) {
  if (!body.file || body.points) return;
  const std::filesystem::path file = scene.origin.path.parent_path() / *body.file;
  try {
    require_reference_file(file);
  } catch (const InputError& error) {
    document.refuse(key, fmt::format("{}: {}", key, error.what()));
  }
  body.points = read_coordinates(file);
}

void read_points(const Document& document, Scene& scene) {
  if (scene.body) read_points(document, scene, *scene.body, flow::key_of_body(scene, 0, "file"));
  for (std::size_t k = 0; k < scene.others.size(); ++k)
    read_points(document, scene, scene.others[k], flow::key_of_body(scene, k + 1, "file"));
}

/// Whether a table, the first of a list, or one of it by its number, has a key.
bool says(const Document& document, std::string_view table, std::string_view key) {
  auto found = document.root().at_path(table);
  if (found.is_array()) found = found[0];
  return found.is_table() && found.as_table()->contains(key);
}

/// The courses of all motions.
void complete_motions(Scene& scene) {
  const std::filesystem::path folder = scene.origin.path.parent_path();
  if (scene.motion) complete_motion(*scene.motion, scene.time.end, folder);
  const auto complete_own = [&](std::size_t number, body::BodySettings& body) {
    try {
      if (body.motion) complete_motion(*body.motion, scene.time.end, folder);
    } catch (const Refused& refused) {
      throw renamed(refused, "motion", flow::key_of_body(scene, number, "motion"));
    }
  };
  if (scene.body) complete_own(0, *scene.body);
  for (std::size_t k = 0; k < scene.others.size(); ++k) complete_own(k + 1, scene.others[k]);
}

/// What a scene leaves out, by its own laws and by those of its method, and what it cannot mean.
void complete(const Document& document, Scene& scene) {
  const flow::Written written = [&](std::string_view table, std::string_view key) {
    return says(document, table, key);
  };
  flow::AnyMethod& own = method_of(scene);
  flow::refuse_senseless(scene);
  complete_motions(scene);
  flow::complete_meetings(scene);
  flow::refuse_rest(scene);
  flow::choose_viscosity(scene, written);
  own->choose(scene, written);
  if (scene.time.dt == 0) throw Refused("time", "[time] needs the key dt");
  scene.origin.step_chosen = !written("time", "dt");
  flow::complete_times(scene);
  hold_check(document, scene);
  own->refuse(scene);
}

}  // namespace

const flow::Method& Scene::computed_by() const {
  return *method_of(*this);
}

bool operator==(const Scene& a, const Scene& b) {
  return resolved(a) == resolved(b);
}

Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                  const flow::Methods& methods, std::span<const std::string> overrides) {
  const Document document(text, path, overrides);
  Scene scene = read_scene(document, methods);
  scene.origin = {path, std::string(text), {overrides.begin(), overrides.end()}};
  read_points(document, scene);
  refuse_sizes(document, scene);
  try {
    complete(document, scene);
  } catch (const Refused& refused) {
    document.refuse(refused.key, refused.what());
  }
  return scene;
}

flow::Case parse_case(std::string_view resolved, const std::filesystem::path& path,
                      const flow::Methods& methods) {
  const Document document(resolved, path, {});
  const Scene scene = read_scene(document, methods);
  refuse_sizes(document, scene);
  try {
    flow::refuse_senseless(scene);
  } catch (const Refused& refused) {
    document.refuse(refused.key, refused.what());
  }
  return scene;
}

Scene load_scene(const std::filesystem::path& path, const flow::Methods& methods,
                 std::span<const std::string> overrides) {
  return parse_scene(read_text(path), path, methods, overrides);
}

}  // namespace vortree::io
