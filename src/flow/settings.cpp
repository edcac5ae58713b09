#include "flow/settings.hpp"

namespace vortree::flow {

std::vector<Key> keys(FlowSettings& flow) {
  return {
      key("nu", flow.nu, chosen({.low = 0, .words = "viscosity must be >= 0"}), "L^2/T",
          "kinematic viscosity, written or by `flow.reynolds`"),
      key("stream", flow.stream, anything, "L/T", "undisturbed velocity [u, v]"),
      key("reynolds", flow.reynolds, positive, "",
          "U D/nu, instead of `flow.nu`: U the speed of the stream or without one the greatest "
          "of the plunge, D twice the body's radius or its chord; of a flow that fills the plane "
          "its speed and wavelength")};
}

std::vector<Key> keys(TimeSettings& time) {
  return {key("dt", time.dt, chosen(positive), "T",
              "the step; one that an accuracy chooses meets the end"),
          key("end", time.end, required(positive), "T",
              "the end of the run, which is at the multiple of a written step that is nearest"),
          key("scheme", time.scheme, "Runge-Kutta of second or of fourth order")};
}

std::vector<Key> keys(OutputSettings& output) {
  return {key("frames", output.frames, chosen(positive), "T",
              "time between two frames, the larger of end/14 and dt in whole steps if not written; "
              "each is that of the nearest step"),
          key("fields", output.fields, not_negative, "T",
              "times of pictures, which need `output.window` and `output.field_spacing`"),
          key("fields_every", output.fields_every, positive, "T",
              "time between two pictures, beside those of `output.fields`: as many as there are "
              "until the end"),
          key("fields_from", output.fields_from, not_negative, "T",
              "the first picture of `output.fields_every`, at the start if not written"),
          key("window", output.window, anything, "L", "[x0, y0, x1, y1] of the pictures"),
          key("field_spacing", output.field_spacing, positive, "L",
              "distance of the points of a picture")};
}

std::vector<Key> keys(ReleaseSettings& tracers) {
  return {
      key("line", tracers.line, anything, "L",
          "[x0, y0, x1, y1]: they begin along this line, from end to end"),
      key("around", tracers.around, positive, "L",
          "instead of `tracers.line`: they begin all around the body as it stands then, so far "
          "from its wall"),
      key("count", tracers.count, {.low = 1, .high = 1e6, .words = "1 to 1000000 were expected"},
          "", "so many of them; a single one begins at the first end of its line"),
      key("from", tracers.from, not_negative, "T", "when they are released"),
      key("every", tracers.every, positive, "T",
          "as many more are released again and again, this long after the last")};
}

}  // namespace vortree::flow
