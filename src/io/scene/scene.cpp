#include "io/scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/scene/check.hpp"
#include "io/scene/choice.hpp"
#include "io/scene/document.hpp"
#include "io/scene/reader.hpp"
#include "io/scene/sense.hpp"
#include "io/scene/time.hpp"

namespace vortree::io {
namespace {

constexpr double most_picture_points = 1e8;

double speed_of_stream(const Scene& scene) {
  return std::hypot(scene.flow.stream[0], scene.flow.stream[1]);
}

void check_output(const Document& document, const Scene& scene) {
  const flow::OutputSettings& output = scene.output;
  if (output.frames < scene.time.dt) {
    document.refuse("output.frames", fmt::format("output.frames is {}; it must be >= time.dt = {}",
                                                 output.frames, scene.time.dt));
  }
  if (!output.fields.empty() && !(output.window && output.field_spacing)) {
    document.refuse("output.fields",
                    "output.fields needs output.window and output.field_spacing beside it");
  }
  if (!output.window) return;
  const auto [x0, y0, x1, y1] = *output.window;
  if (!(x0 < x1 && y0 < y1)) {
    document.refuse("output.window",
                    fmt::format("output.window is [{}, {}, {}, {}]; [x0, y0, x1, y1] with x0 < x1 "
                                "and y0 < y1 was expected",
                                x0, y0, x1, y1));
  }
  if (!output.field_spacing) return;
  const double points = (x1 - x0) * (y1 - y0) / (*output.field_spacing * *output.field_spacing);
  if (points > most_picture_points) {
    document.refuse("output.field_spacing",
                    fmt::format("output.field_spacing is {}; that makes a picture of {:.2g} "
                                "points, {:.0e} at most are drawn",
                                *output.field_spacing, points, most_picture_points));
  }
}

/// Widths are those of Gaussians that blobs can make up; what a kind needs is there, and no more.
void check_initial(const Document& document, const vortex::InitialSettings& initial,
                   double sigma_0) {
  using enum vortex::InitialKind;
  const vortex::InitialKind kind = initial.kind;
  if (kind != kirchhoff_ellipse)
    for (const auto& [key, width] : {std::pair{"initial.core", std::optional(initial.core)},
                                     std::pair{"initial.core_across", initial.core_across}})
      if (width && !(*width > sigma_0))
        document.refuse(
            key, fmt::format("{} is {}; it must be > cores.sigma_0 = {}", key, *width, sigma_0));
  const auto belongs = [&](const char* key, const std::optional<double>& value, bool wanted) {
    if (value.has_value() != wanted)
      document.refuse(value ? fmt::format("initial.{}", key) : "initial",
                      fmt::format("initial.kind is {}; that {} the key initial.{}",
                                  quote(word(kind)), wanted ? "needs" : "does not have", key));
  };
  belongs("core_across", initial.core_across,
          kind == gaussian_ellipse || kind == kirchhoff_ellipse);
  belongs("separation", initial.separation, kind == corotating_pair || kind == dipole);
  belongs("perturbation", initial.perturbation, kind == tripole);
}

/// The keys that a shape has.
void check_body(const Document& document, const body::BodySettings& body) {
  const auto belongs = [&](const char* key, const std::optional<double>& value, bool known,
                           bool needed) {
    if (value ? !known : needed)
      document.refuse(value ? fmt::format("body.{}", key) : "body",
                      fmt::format("body.shape is {}; that {} the key body.{}",
                                  quote(word(body.shape)), value ? "does not have" : "needs", key));
  };
  const bool foil = body.shape == body::ShapeKind::naca0012,
             ellipse = body.shape == body::ShapeKind::ellipse;
  belongs("radius", body.radius, !foil, !foil);
  belongs("across", body.across, ellipse, ellipse);
  belongs("chord", body.chord, foil, foil);
  belongs("edge", body.edge, foil, false);
}

void check_plunge(const Document& document, const Scene& scene) {
  if (!scene.body) document.refuse("plunge", "[plunge] is how a body moves; there is no [body]");
  const auto [x, y] = scene.plunge->direction;
  if (x == 0 && y == 0)
    document.refuse("plunge.direction",
                    "plunge.direction is [0, 0]; a direction was expected, as [0, 1]");
}

void check_motion(const Document& document, const Scene& scene) {
  if (!scene.body) document.refuse("motion", "[motion] is how a body moves; there is no [body]");
  if (scene.body->shape != body::ShapeKind::circle)
    document.refuse(
        "motion.spin",
        fmt::format("motion.spin is {}; only a circle can turn in its place, body.shape "
                    "is {}",
                    scene.motion->spin, quote(word(scene.body->shape))));
}

/// An answer known by heart is that of one flow.
void check_exact(const Document& document, const Scene& scene) {
  const ExactAnswer exact = *scene.check.exact;
  const bool spins = scene.motion && !scene.plunge && !scene.initial && speed_of_stream(scene) == 0;
  if (exact == ExactAnswer::spinning_cylinder
          ? spins
          : scene.initial && word(scene.initial->kind) == word(exact))
    return;
  document.refuse(
      "check.exact",
      exact == ExactAnswer::spinning_cylinder
          ? "check.exact is \"spinning_cylinder\"; that needs [motion] in fluid at "
            "rest and without [initial] or [plunge]"
          : fmt::format("check.exact is {0}; that needs the table [initial] of kind {0}",
                        quote(word(exact))));
}

/// What several keys must fulfil together.
void check_together(const Document& document, const Scene& scene) {
  const vortex::CoreSettings& cores = scene.cores;
  if (cores.sigma_max < cores.sigma_0) {
    document.refuse("cores.sigma_max",
                    fmt::format("cores.sigma_max is {}; it must be >= cores.sigma_0 = {}",
                                cores.sigma_max, cores.sigma_0));
  }
  if (scene.initial) check_initial(document, *scene.initial, cores.sigma_0);
  if (scene.body && scene.diffusion.kind != vortex::Diffusion::core_spreading)
    document.refuse("diffusion.kind",
                    fmt::format("diffusion.kind is {}; beside a body vorticity diffuses by "
                                "core_spreading only",
                                quote(word(scene.diffusion.kind))));
  if (by_vortices(scene) && !scene.body && !scene.initial) {
    document.refuse("", "a scene needs [body] or [initial]; without both there is no vorticity");
  }
  if (scene.check.exact) check_exact(document, scene);
  if (const auto& box = scene.merging.box; box && !((*box)[0] < (*box)[2] && (*box)[1] < (*box)[3]))
    document.refuse("merging.box",
                    "merging.box is [x0, y0, x1, y1]; x0 < x1 and y0 < y1 were expected");
  if (scene.cores.coarsen_from && !scene.body)
    document.refuse("cores.coarsen_from",
                    "cores.coarsen_from is a distance from the body; there is no [body]");
  check_output(document, scene);
  check_asked(document, scene);
}

}  // namespace

bool operator==(const Scene& a, const Scene& b) {
  const auto run = [](const Scene& s) {
    return std::tie(s.title, s.seed, s.method, s.accuracy, s.flow, s.diffusion, s.body, s.plunge,
                    s.motion, s.cores, s.splitting, s.merging, s.initial, s.time, s.velocity,
                    s.output, s.check);
  };
  return run(a) == run(b);
}

Scene parse_scene(std::string_view text, const std::filesystem::path& path,
                  std::span<const std::string> overrides) {
  const Document document(text, path, overrides);
  Scene scene = read_scene(document);
  scene.origin = {path, std::string(text), {overrides.begin(), overrides.end()}};
  if (scene.body) check_body(document, *scene.body);
  if (scene.plunge) check_plunge(document, scene);
  if (scene.motion) check_motion(document, scene);
  refuse_senseless(document, scene);
  choose_missing(document, scene);
  check_time(document, scene.time);
  if (scene.output.frames == 0) scene.output.frames = usual_frames(scene.time);
  check_together(document, scene);
  refuse_senseless_choice(document, scene);
  return scene;
}

Scene load_scene(const std::filesystem::path& path, std::span<const std::string> overrides) {
  return parse_scene(read_text(path), path, overrides);
}

bool by_vortices(const Scene& scene) {
  return scene.method == vortices;
}

double length_of(const body::BodySettings& body) {
  return body.chord.value_or(2 * body.radius.value_or(0));
}

double perimeter_of(const body::BodySettings& body) {
  if (body.shape == body::ShapeKind::naca0012) return 2.05 * length_of(body);
  const double a = *body.radius, b = body.across.value_or(a);
  // Ramanujan's second formula: within 4e-4 of any ellipse's.
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  return std::numbers::pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
}

double edge_of(const body::BodySettings& body) {
  return body.edge.value_or(0.005);
}

namespace {

double fastest_plunge(const Scene& scene) {
  if (!scene.plunge) return 0;
  return 2 * std::numbers::pi * scene.plunge->frequency * scene.plunge->amplitude;
}

/// Of the wall along itself.
double spinning_wall(const Scene& scene) {
  return scene.motion ? std::abs(scene.motion->spin) * length_of(*scene.body) / 2 : 0;
}

}  // namespace

double speed_of(const Scene& scene) {
  for (const double speed : {speed_of_stream(scene), fastest_plunge(scene)})
    if (speed > 0) return speed;
  return spinning_wall(scene);
}

double fastest_of(const Scene& scene) {
  return std::hypot(speed_of_stream(scene), fastest_plunge(scene)) + spinning_wall(scene);
}

std::filesystem::path reference_path(const Scene& scene, std::string_view written) {
  return scene.origin.path.parent_path() / written;
}

}  // namespace vortree::io
