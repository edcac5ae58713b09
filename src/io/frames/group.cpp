#include "io/frames/group.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <numeric>
#include <span>

#include "io/frames/checksum.hpp"
#include "io/frames/hdf5_inside.hpp"

namespace vortree::io {
namespace {

std::uint64_t checksum(const Frame& frame) {
  Checksum sum;
  sum.add(static_cast<std::uint64_t>(frame.step));
  sum.add(frame.time);
  for (const auto& [name, column] : frame_columns) sum.add(frame.*column);
  for (const auto& [name, values] : frame.state) {
    sum.add(name);
    sum.add(values);
  }
  return sum.value();
}

std::optional<std::int64_t> step_of(std::string_view name) {
  constexpr std::string_view prefix = "frame_";
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  std::int64_t step = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), step);
  if (error != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return step;
}

h5::Handle open_frame(hid_t file, const FramePlace& place) {
  return h5::own(H5Oopen_by_idx(file, ".", H5_INDEX_NAME, H5_ITER_INC, place.index, H5P_DEFAULT),
                 frame_name(place.step) + " cannot be opened");
}

/// Pairs as rows of three components, as programs that draw want them.
std::vector<double> in_space(std::span<const double> x, std::span<const double> y) {
  std::vector<double> rows;
  rows.reserve(3 * x.size());
  for (std::size_t i = 0; i < x.size(); ++i) rows.insert(rows.end(), {x[i], y[i], 0});
  return rows;
}

std::vector<std::int32_t> counted(std::size_t n) {
  std::vector<std::int32_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

/// The columns once more, as frames.xdmf shows them.
void write_view(hid_t group, const Frame& frame) {
  h5::Handle view = h5::create_group(group, "view");
  h5::write_grid(view, "points", in_space(frame.x, frame.y), frame.x.size(), 3);
  h5::write_grid(view, "velocity", in_space(frame.u, frame.v), frame.x.size(), 3);
  h5::write(view, "vertices", counted(frame.x.size()));
  h5::close(std::move(view), "view");
}

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(a, b, {}, std::bit_cast<std::uint64_t, double>,
                            std::bit_cast<std::uint64_t, double>);
}

/// Frames of earlier versions have no view.
bool view_agrees(hid_t group, const Frame& frame) {
  if (!h5::has(group, "view")) return true;
  const h5::Handle view = h5::own(H5Gopen2(group, "view", H5P_DEFAULT), "view");
  const auto numbers = counted(frame.x.size());
  return same_bits(h5::read(view, "points"), in_space(frame.x, frame.y)) &&
         same_bits(h5::read(view, "velocity"), in_space(frame.u, frame.v)) &&
         std::ranges::equal(h5::read(view, "vertices"), numbers);
}

}  // namespace

std::string frame_name(std::int64_t step) {
  return fmt::format("frame_{:06}", step);
}

std::vector<FramePlace> frame_places(hid_t file) {
  std::vector<FramePlace> places;
  for (const auto& [index, name] : h5::links(file)) {
    if (const auto step = step_of(name)) places.push_back({*step, index});
  }
  std::sort(places.begin(), places.end(),
            [](const FramePlace& a, const FramePlace& b) { return a.step < b.step; });
  return places;
}

void write_frame(hid_t file, const Frame& frame) {
  h5::append_group(file, frame_name(frame.step), [&](hid_t group) {
    for (const auto& [name, column] : frame_columns) h5::write(group, name, frame.*column);
    write_view(group, frame);
    h5::Handle state = h5::create_group(group, "state");
    for (const auto& [name, values] : frame.state) h5::write(state, name, values);
    h5::close(std::move(state), "state");
    h5::write_attribute(group, "step", frame.step);
    h5::write_attribute(group, "time", frame.time);
    h5::write_attribute(group, "checksum", checksum(frame));
  });
}

Frame read_frame(hid_t file, const FramePlace& place) {
  const h5::Handle group = open_frame(file, place);
  Frame frame;
  frame.step = h5::read_integer(group, "step");
  frame.time = h5::read_double(group, "time");
  for (const auto& [column, values] : frame_columns) {
    frame.*values = h5::read(group, column);
  }
  const h5::Handle state = h5::own(H5Gopen2(group, "state", H5P_DEFAULT), "state");
  for (const auto& [index, key] : h5::links(state)) frame.state[key] = h5::read(state, key);
  if (frame.step != place.step || h5::read_unsigned(group, "checksum") != checksum(frame)) {
    throw h5::Failure(frame_name(place.step) + " does not agree with its checksum");
  }
  if (!view_agrees(group, frame)) {
    throw h5::Failure(frame_name(place.step) + " does not agree with what is drawn of it");
  }
  return frame;
}

FrameLabel read_label(hid_t file, const FramePlace& place) {
  const h5::Handle group = open_frame(file, place);
  const h5::Handle x = h5::open_dataset(group, "x");
  const h5::Handle space = h5::own(H5Dget_space(x), "x");
  return {.step = place.step,
          .time = h5::read_double(group, "time"),
          .blobs = static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space))};
}

}  // namespace vortree::io
