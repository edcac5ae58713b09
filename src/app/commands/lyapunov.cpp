#include "app/commands/lyapunov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "app/folder/older_run.hpp"
#include "app/folder/output_folder.hpp"
#include "app/install_paths.hpp"
#include "app/methods/methods.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "flow/paths/lyapunov.hpp"
#include "io/files.hpp"
#include "io/frames/frames.hpp"
#include "io/quote.hpp"
#include "io/scene/scene.hpp"
#include "io/tables/fields.hpp"
#include "io/tables/lyapunov.hpp"
#include "io/while_reading.hpp"
#include "provenance/provenance.hpp"

namespace vortree::app {
namespace {

namespace fs = std::filesystem;

constexpr double most_tracers = 1e7;       // four paths each: some GB
constexpr double close = 0.1;              // spacings from a place to the tracers beside it
constexpr double doubtful_in_time = 0.01;  // of the velocity
constexpr double shortest_window = 0.01;   // in times between pictures

/// What a folder without pictures lacks.
constexpr std::string_view wanted =
    "a run with output.fields_every (or output.fields), output.window and output.field_spacing "
    "leaves pictures";

void require_pairs(const LyapunovJob& job) {
  if (job.from.size() != job.to.size())
    throw io::InputError(fmt::format("--from has {} times and --to {}; they are pairs",
                                     job.from.size(), job.to.size()));
  std::set<std::pair<double, bool>> seen;
  for (std::size_t k = 0; k < job.from.size(); ++k) {
    const double from = job.from[k], to = job.to[k];
    if (from == to) throw io::InputError(fmt::format("--from {0} --to {0}: no time between", from));
    if (!seen.emplace(from, to > from).second)
      throw io::InputError(fmt::format("--from {}: given twice {} in time", from,
                                       to > from ? "forward" : "backward"));
  }
}

/// A time that is written with a dozen digits may be the last of the pictures, or the first.
void meet(double& t, double picture) {
  if (std::abs(t - picture) <= 1e-9 * picture) t = picture;
}

/// Over a window that is no more than rounding, exponents are rounding.
void require_lasting(const LyapunovJob& job, double between_pictures) {
  for (std::size_t k = 0; k < job.from.size(); ++k)
    if (std::abs(job.to[k] - job.from[k]) < shortest_window * between_pictures)
      throw io::InputError(fmt::format(
          "--from {} --to {}: pictures are {:.2g} apart; a window of {:.2g} is the least that they "
          "tell of",
          job.from[k], job.to[k], between_pictures, shortest_window * between_pictures));
}

/// The times of all pictures; there are enough, and each window lies within.
std::vector<double> times_of(LyapunovJob& job) {
  const std::string file = (job.folder / "fields.h5").string();
  std::vector<double> times = io::field_times(job.folder);
  if (times.empty() && fs::exists(file))
    throw io::InputError(
        fmt::format("{}: no picture can be read there; the file is damaged, and the same run with "
                    "--overwrite makes it anew",
                    file));
  if (times.empty())
    throw io::InputError(fmt::format("{}: no pictures there; {}", job.folder.string(), wanted));
  if (times.size() < flow::least_pictures)
    throw io::InputError(
        fmt::format("{}: {} picture{}, and {} are the least that tell of paths; {}", file,
                    times.size(), times.size() == 1 ? "" : "s", flow::least_pictures, wanted));
  for (auto* list : {&job.from, &job.to})
    for (double& t : *list) {
      meet(t, times.front());
      meet(t, times.back());
      if (!(times.front() <= t && t <= times.back()))
        throw io::InputError(fmt::format("{}: its pictures are from t = {} to {}; {} {} is outside",
                                         file, times.front(), times.back(),
                                         list == &job.from ? "--from" : "--to", t));
    }
  require_lasting(job, (times.back() - times.front()) / static_cast<double>(times.size() - 1));
  return times;
}

/// The grid of a picture, which is even.
flow::PictureGrid grid_of(const io::Field& field, const std::string& file) {
  if (field.x.size() < 4 || field.y.size() < 4)
    throw io::InputError(fmt::format("{}: pictures of {} x {} points; 4 x 4 are the least", file,
                                     field.x.size(), field.y.size()));
  return {.first = {field.x.front(), field.y.front()},
          .spacing = (field.x.back() - field.x.front()) / static_cast<double>(field.x.size() - 1),
          .columns = static_cast<int>(field.x.size()),
          .rows = static_cast<int>(field.y.size())};
}

flow::VelocityPicture picture_of(const io::Field& field) {
  flow::VelocityPicture made{field.time, std::vector<Vec2>(field.u.size())};
  for (std::size_t k = 0; k < made.velocity.size(); ++k)
    made.velocity[k] = {field.u[k], field.v[k]};
  return made;
}

/// Pictures on one grid.
struct PicturesOfRun {
  flow::PictureGrid grid;
  flow::VelocityPictures pictures;
};

/// Those around the windows, with two more on either side for the cubics in time.
PicturesOfRun pictures_of(const LyapunovJob& job, const std::vector<double>& times) {
  const auto [from_low, from_high] = std::ranges::minmax(job.from);
  const auto [to_low, to_high] = std::ranges::minmax(job.to);
  const auto low = std::ranges::upper_bound(times, std::min(from_low, to_low)) - times.begin();
  const auto high = std::ranges::upper_bound(times, std::max(from_high, to_high)) - times.begin();
  const auto n = std::ssize(times);
  const auto first = std::clamp<std::ptrdiff_t>(low - 3, 0, n - 4),
             last = std::clamp<std::ptrdiff_t>(high + 2, first + 4, n);
  const std::string file = (job.folder / "fields.h5").string();
  PicturesOfRun found;
  std::vector<double> x, y;
  for (auto k = first; k < last; ++k) {
    const io::Field field = io::read_field(job.folder, times[k]);
    if (k == first) found.grid = grid_of(field, file), x = field.x, y = field.y;
    if (field.x != x || field.y != y || field.u.size() != found.grid.points() ||
        field.v.size() != found.grid.points())
      throw io::InputError(fmt::format("{}: the pictures of t = {} and {} are on different grids",
                                       file, times[first], times[k]));
    found.pictures.push_back(picture_of(field));
  }
  return found;
}

void warn_of_few(const PicturesOfRun& of, const fs::path& folder) {
  const auto lost = flow::lost_between(of.pictures);
  if (lost && *lost > doubtful_in_time)
    say("warning: {}/fields.h5: between its pictures some {:.1g} % of the velocity is lost; "
        "output.fields_every = {:.2g} would lose a sixteenth of that",
        folder.string(), 100 * *lost,
        (of.pictures.back().time - of.pictures.front().time) / 2 /
            static_cast<double>(of.pictures.size() - 1));
}

void warn_of_unknown(const std::vector<flow::LyapunovField>& fields) {
  for (const flow::LyapunovField& field : fields)
    if (std::ranges::all_of(field.exponent, [](double one) { return std::isnan(one); }))
      say("warning: t = {} to {}: nothing is known, as every tracer has left the pictures or met "
          "the body; a shorter window, a larger output.window or a smaller --spacing knows more",
          field.from, field.to);
}

flow::PictureGrid tracers_of(const LyapunovJob& job, const flow::PictureGrid& window) {
  const double spacing = job.spacing.value_or(window.spacing), in_one = window.spacing / spacing,
               tracers = in_one * in_one * static_cast<double>(window.points());
  if (tracers > most_tracers)
    throw io::InputError(
        fmt::format("--spacing {}: that makes {:.2g} tracers, {:.0e} at most are followed", spacing,
                    tracers, most_tracers));
  return flow::tracers_within(window, spacing);
}

/// What the flow is, and what made the numbers.
io::Attributes about(const io::RunInfo& info) {
  io::Attributes all{{"version", version()}, {"scene", info.scene}, {"resolved", info.resolved}};
  for (const std::string& line : provenance()) {
    const auto colon = line.find(": ");
    if (colon != std::string::npos) all.emplace_back(line.substr(0, colon), line.substr(colon + 2));
  }
  return all;
}

std::string line(const flow::LyapunovField& field, const fs::path& folder) {
  double most = -INFINITY;
  std::size_t known = 0;
  for (const double one : field.exponent)
    if (!std::isnan(one)) ++known, most = std::max(most, one);
  const double share = static_cast<double>(known) / static_cast<double>(field.exponent.size());
  return fmt::format("t = {} {} to {}: {} tracers, {:.0f} % known{}; results in {}\n", field.from,
                     field.to > field.from ? "forward" : "back", field.to, field.exponent.size(),
                     100 * share, known ? fmt::format(", largest exponent {:.4g}", most) : "",
                     io::printable((folder / "lyapunov.h5").string()));
}

/// Beside a wall velocities are made of the wall's place, which is known as it is at the start.
void refuse_turning(const flow::Case& flow, const fs::path& folder) {
  if (flow.motion && (flow.motion->angle || flow.motion->file))
    throw io::InputError(
        fmt::format("{}: its body turns by motion.angle or motion.file; Lyapunov "
                    "exponents are told around bodies that do not",
                    folder.string()));
  for (const body::BodySettings& body : flow::every_body(flow))
    if (body.motion && body.motion->given_by_time())
      throw io::InputError(fmt::format(
          "{}: its bodies move against each other; Lyapunov exponents are told around bodies that "
          "do not",
          folder.string()));
}

}  // namespace

std::string lyapunov(const LyapunovJob& asked) {
  LyapunovJob job = asked;
  require_pairs(job);
  require_frames(job.folder);
  const OutputFolder alone(job.folder);
  for (const char* name : {"lyapunov.h5", "lyapunov.xdmf", "lyapunov.png"})
    io::require_writable(job.folder / name,
                         std::array{job.folder / "fields.h5", job.folder / "frames.h5"});
  const fs::path frames = job.folder / "frames.h5";
  const io::WhileReading reading(job.folder / "fields.h5");
  const io::RunInfo info = io::info_of_frames(frames);
  const flow::Case flow = io::parse_case(info.resolved, frames, methods());
  refuse_turning(flow, job.folder);
  const std::vector<double> times = times_of(job);
  const PicturesOfRun of = pictures_of(job, times);
  const flow::PictureGrid tracers = tracers_of(job, of.grid);
  warn_of_few(of, job.folder);

  const flow::VelocityAnywhere velocity(of.grid, flow::bodies_of(flow));
  std::vector<flow::LyapunovField> fields;
  std::string lines;
  for (std::size_t k = 0; k < job.from.size(); ++k) {
    fields.push_back(flow::lyapunov(of.pictures, velocity, tracers, close * tracers.spacing,
                                    job.from[k], job.to[k]));
    lines += line(fields.back(), job.folder);
  }
  io::remove_file(job.folder / "lyapunov.png");  // of other exponents
  io::write_lyapunov(job.folder, fields, about(info));
  warn_of_unknown(fields);
  plot(job.folder, "lyapunov");
  return lines;
}

}  // namespace vortree::app
