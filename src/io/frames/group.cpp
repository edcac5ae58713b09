#include "io/frames/group.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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
  for (const flow::Column& column : frame.columns) {
    sum.add(column.name);
    sum.add(column.unit);
    sum.add(column.values);
  }
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

/// "x L, y L, gamma L^2/T": names with their units, in order.
std::string told(const flow::Columns& columns) {
  std::vector<std::string> words;
  for (const flow::Column& column : columns) words.push_back(column.name + " " + column.unit);
  return fmt::format("{}", fmt::join(words, ", "));
}

/// The same read back, without values.
flow::Columns columns_in(std::string_view text) {
  flow::Columns columns;
  while (!text.empty()) {
    const std::string_view one = text.substr(0, text.find(", "));
    const std::size_t gap = std::min(one.find(' '), one.size());
    columns.push_back(
        {std::string(one.substr(0, gap)), std::string(one.substr(std::min(gap + 1, one.size())))});
    text.remove_prefix(std::min(one.size() + 2, text.size()));
  }
  return columns;
}

std::vector<std::string> names_of(const flow::Columns& columns) {
  std::vector<std::string> names;
  for (const flow::Column& column : columns) names.push_back(column.name);
  return names;
}

std::vector<double> in_space(const Frame& frame, std::string_view x, std::string_view y) {
  return in_space(flow::column(frame.columns, x), flow::column(frame.columns, y));
}

bool moves(const Frame& frame) {
  const FrameLabel label = label_of(frame);
  return label.has("u") && label.has("v");
}

/// The columns once more, as frames.xdmf shows them.
void write_view(hid_t group, const Frame& frame) {
  const std::size_t n = frame.particles();
  h5::Handle view = h5::create_group(group, "view");
  h5::write_grid(view, "points", in_space(frame, "x", "y"), n, 3);
  if (moves(frame)) h5::write_grid(view, "velocity", in_space(frame, "u", "v"), n, 3);
  h5::write(view, "vertices", counted(n));
  h5::close(std::move(view), "view");
}

bool same_bits(std::span<const double> a, std::span<const double> b) {
  return std::ranges::equal(a, b, {}, std::bit_cast<std::uint64_t, double>,
                            std::bit_cast<std::uint64_t, double>);
}

bool view_agrees(hid_t group, const Frame& frame) {
  const h5::Handle view = h5::own(H5Gopen2(group, "view", H5P_DEFAULT), "view");
  return same_bits(h5::read(view, "points"), in_space(frame, "x", "y")) &&
         (!moves(frame) || same_bits(h5::read(view, "velocity"), in_space(frame, "u", "v"))) &&
         std::ranges::equal(h5::read(view, "vertices"), counted(frame.particles()));
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
    for (const flow::Column& column : frame.columns) h5::write(group, column.name, column.values);
    write_view(group, frame);
    h5::Handle state = h5::create_group(group, "state");
    for (const auto& [name, values] : frame.state) h5::write(state, name, values);
    h5::close(std::move(state), "state");
    h5::write_attribute(group, "step", frame.step);
    h5::write_attribute(group, "time", frame.time);
    h5::write_attribute(group, "columns", told(frame.columns));
    h5::write_attribute(group, "checksum", checksum(frame));
  });
}

Frame read_frame(hid_t file, const FramePlace& place) {
  const h5::Handle group = open_frame(file, place);
  Frame frame;
  frame.step = h5::read_integer(group, "step");
  frame.time = h5::read_double(group, "time");
  frame.columns = columns_in(h5::read_string(group, "columns"));
  for (flow::Column& column : frame.columns) column.values = h5::read(group, column.name);
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
  return {place.step, h5::read_double(group, "time"),
          static_cast<std::uint64_t>(H5Sget_simple_extent_npoints(space)),
          names_of(columns_in(h5::read_string(group, "columns")))};
}

FrameLabel label_of(const Frame& frame) {
  return {frame.step, frame.time, frame.particles(), names_of(frame.columns)};
}

bool FrameLabel::has(std::string_view name) const {
  return std::ranges::find(columns, name) != columns.end();
}

}  // namespace vortree::io
