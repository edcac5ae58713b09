#include "io/scene/schema.hpp"

namespace vortree::io {

std::vector<Key> keys(SceneFlow& flow) {
  return {key("nu", flow.nu, chosen({.low = 0, .words = "viscosity must be >= 0"}), "L^2/T",
              "kinematic viscosity, written or by `flow.reynolds`"),
          key("stream", flow.stream, anything, "L/T", "undisturbed velocity [u, v]"),
          key("reynolds", flow.reynolds, positive, "",
              "U D/nu, instead of `flow.nu`: U the speed of the stream or without one the greatest "
              "of the plunge, D twice the body's radius or its chord")};
}

std::vector<Key> keys(SceneBody& body) {
  return {
      key("shape", body.shape, "outline of the body"),
      key("radius", body.radius, positive, "L",
          "radius of a circle, half the long axis of an ellipse: both need it"),
      key("across", body.across, positive, "L",
          "half the other axis of an ellipse, which needs it"),
      key("chord", body.chord, positive, "L", "length of the section naca0012, which needs it"),
      key("edge", body.edge, {.low = 1e-4, .high = 0.02, .words = "it must lie in 1e-4 .. 0.02"},
          "chord", "radius of the trailing edge of naca0012, 0.005 if not written"),
      key("incidence", body.incidence,
          {.low = -180, .high = 180, .words = "it must lie in -180 .. 180 degrees"}, "degrees",
          "by how much the long axis or the chord is turned clockwise from x"),
      key("centre", body.centre, anything, "L",
          "place [x, y] of the centre; of naca0012, of the middle of its chord"),
      key("panels", body.panels, {.low = 8, .words = "a body needs at least 8 panels"}, "",
          "wall elements around the body")};
}

std::vector<Key> keys(ScenePlunge& plunge) {
  return {
      key("amplitude", plunge.amplitude, required(positive), "L",
          "the body moves by amplitude cos(2 pi frequency t), without turning"),
      key("frequency", plunge.frequency, required(positive), "1/T", "periods in a unit of time"),
      key("direction", plunge.direction, anything, "",
          "along which it moves, [x, y] of any length but 0")};
}

std::vector<Key> keys(SceneDiffusion& diffusion) {
  return {key("kind", diffusion.kind,
              "how vorticity spreads: cores widen, or they stay and blobs walk at random or "
              "exchange circulation, in free space only")};
}

std::vector<Key> keys(SceneCores& cores) {
  return {key("sigma_0", cores.sigma_0, chosen(positive), "L",
              "core of a blob that is released at the wall, or of an initial blob"),
          key("sigma_max", cores.sigma_max, chosen(positive), "L", "a wider blob splits"),
          key("coarsen_from", cores.coarsen_from, positive, "L",
              "further than this from the body cores, and the tolerance of mergers, may be "
              "(distance/coarsen_from)^(3/4) times as wide")};
}

std::vector<Key> keys(SceneSplitting& splitting) {
  constexpr Rule inside{.low = 0.1,
                        .high = 1,
                        .below_high = true,
                        .words = "it must be >= 0.1 and < 1"};
  return {key("alpha", splitting.alpha, inside, "", "a child has the core alpha sigma"),
          key("children", splitting.children,
              {.low = 3, .high = 64, .words = "a ring has 3 to 64 children"}, "",
              "so many children stand on a ring")};
}

std::vector<Key> keys(SceneMerging& merging) {
  return {key("tolerance", merging.tolerance, not_negative, "L/T",
              "error of velocity that a merger may make; 0: blobs never merge"),
          key("reach", merging.reach, positive, "cores",
              "partners are closer than so many of the smaller core"),
          key("cap", merging.cap, positive, "", "a merged blob has sigma^2 <= cap sigma_max^2"),
          key("box", merging.box, anything, "L",
              "[x0, y0, x1, y1]: blobs that leave it are taken away; `summary.json` says how much "
              "they were")};
}

std::vector<Key> keys(SceneInitial& initial) {
  return {
      key("kind", initial.kind,
          "the vorticity at t = 0: a Gaussian vortex, an elliptic one, a uniform ellipse, two "
          "alike, "
          "two of opposite signs that travel along +y, one times a quadrupole"),
      key("circulation", initial.circulation, required(anything), "L^2/T",
          "of the vortex, or of each of two, the left one if they are opposite"),
      key("core", initial.core, required(positive), "L",
          "width of the vortex, or of each of two; of an ellipse half of it along x; Gaussians are "
          "wider than sigma_0"),
      key("spacing", initial.spacing, positive, "sigma_0",
          "distance of the blobs that the vorticity is cut into"),
      key("centre", initial.centre, anything, "L", "place [x, y] of its centre"),
      key("core_across", initial.core_across, positive, "L",
          "the same along y: gaussian_ellipse and kirchhoff_ellipse need it"),
      key("separation", initial.separation, positive, "L",
          "distance of two vortices along x: corotating_pair and dipole need it"),
      key("perturbation", initial.perturbation, anything, "",
          "a tripole, which needs it, is the vortex times 1 + perturbation (x^2 - y^2)/core^2"),
      key("faintest", initial.faintest,
          {.low = 0, .high = 0.1, .above_low = true, .words = "it must lie between 0 and 0.1"}, "",
          "blobs below this share of the strongest are left out")};
}

std::vector<Key> keys(SceneTime& time) {
  return {key("dt", time.dt, chosen(positive), "T",
              "the step; one that an accuracy chooses meets the end"),
          key("end", time.end, required(positive), "T",
              "the end of the run, which is at the multiple of a written step that is nearest"),
          key("scheme", time.scheme, "Runge-Kutta of second or of fourth order")};
}

std::vector<Key> keys(SceneVelocity& velocity) {
  return {
      key("method", velocity.method,
          "how velocities are summed: by the full FMM, by series of boxes, over all pairs"),
      key("tolerance", velocity.tolerance,
          {.low = 1e-14, .high = 0.1, .words = "it must lie in 1e-14 .. 0.1"}, "",
          "relative error of a velocity sum"),
      key("order", velocity.order,
          {.low = 0, .high = 100, .words = "it must lie in 0 .. 100; 0: from the tolerance"}, "",
          "terms of a series; 0: from the tolerance"),
      key("capacity", velocity.capacity, {.low = 0, .words = "it must be >= 0; 0: chosen"}, "",
          "most blobs in a childless cell; 0: chosen"),
      key("finest_level", velocity.finest_level,
          {.low = 0, .high = 31, .words = "it must lie in 0 .. 31"}, "",
          "deepest level of the tree"),
      key("builder", velocity.builder, "the tree is built from its leaves up, or from its root"),
      key("cores", velocity.cores,
          "core of a pair: the mean (conserves impulse), the source's, or both: each blob moves "
          "with the mean over its own core (conserves the energy of free space)")};
}

std::vector<Key> keys(SceneOutput& output) {
  return {key("frames", output.frames, chosen(positive), "T",
              "time between two frames, the larger of end/14 and dt in whole steps if not written; "
              "each is that of the nearest step"),
          key("fields", output.fields, not_negative, "T",
              "times of pictures, which need `output.window` and `output.field_spacing`"),
          key("window", output.window, anything, "L", "[x0, y0, x1, y1] of the pictures"),
          key("field_spacing", output.field_spacing, positive, "L",
              "distance of the points of a picture")};
}

std::vector<Key> keys(Scene& scene) {
  return {key("title", scene.title, anything, "", "name of the scene"),
          key("seed", scene.seed, not_negative, "", "start of the random numbers"),
          key("method", scene.method, anything, "",
              "what computes the flow; reads the tables of its own: vortex has cores, splitting, "
              "merging, diffusion, initial and velocity"),
          key("accuracy", scene.accuracy,
              {.low = 0, .high = 1, .above_low = true, .words = "it must lie between 0 and 1"}, "",
              "relative error aimed at: chooses what is not written of `cores.sigma_0`, "
              "`cores.sigma_max`, `time.dt`, `merging.*`, `velocity.tolerance` and, beside a body, "
              "`body.panels` and `velocity.cores`")};
}

namespace {

template <class T>
SceneTable always(std::string_view name, bool required, T& table) {
  return {name, required, [] { return true; }, [&table] { return keys(table); }};
}

template <class T>
SceneTable maybe(std::string_view name, std::optional<T>& table) {
  return {name, false, [&table] { return table.has_value(); },
          [&table] { return keys(table ? *table : table.emplace()); }};
}

}  // namespace

std::vector<SceneTable> tables(Scene& scene) {
  return {always("flow", true, scene.flow),        maybe("body", scene.body),
          maybe("plunge", scene.plunge),           always("diffusion", false, scene.diffusion),
          always("cores", false, scene.cores),     always("splitting", false, scene.splitting),
          always("merging", false, scene.merging), maybe("initial", scene.initial),
          always("time", true, scene.time),        always("velocity", false, scene.velocity),
          always("output", false, scene.output),   always("check", false, scene.check)};
}

}  // namespace vortree::io
