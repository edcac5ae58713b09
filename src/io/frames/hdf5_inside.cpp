#include "io/frames/hdf5_inside.hpp"

#include <fmt/format.h>

#include <array>

#include "base/free_memory.hpp"

namespace vortree::io::h5 {
namespace {

// No filter of HDF5 packs numbers closer than deflate at its best: 1032 to 1.
constexpr hsize_t closest_packed = 1032;

constexpr std::string_view only_inside = "only what the file itself holds is read";

H5L_info_t link_of(hid_t place, const std::string& name) {
  H5L_info_t link{};
  if (H5Lget_info(place, name.c_str(), &link, H5P_DEFAULT) < 0) {
    blame_the_system(name + " cannot be looked for");
    throw Failure(fmt::format("{} cannot be found: the file is damaged", name));
  }
  return link;
}

std::string why_no_dataset(hid_t place, const std::string& name) {
  const H5L_info_t link = link_of(place, name);
  if (link.type == H5L_TYPE_SOFT) {
    return fmt::format("{} is not a dataset, but a link that leads to none in the file", name);
  }
  const Handle object(H5Oopen(place, name.c_str(), H5P_DEFAULT));
  if (object < 0) return name + " cannot be opened: the file is damaged";
  return name + " is not a dataset";
}

void require_stored_inside(hid_t set, const std::string& name) {
  const Handle creation = own(H5Dget_create_plist(set), name + " is damaged");
  if (H5Pget_layout(creation) == H5D_VIRTUAL) {
    throw Failure(
        fmt::format("{} is a virtual dataset, put together from others; {}", name, only_inside));
  }
  if (H5Pget_external_count(creation) > 0) {
    throw Failure(fmt::format("{} keeps its numbers in another, raw file; {}", name, only_inside));
  }
}

/// All its bytes lie in one piece, as they are.
bool in_one_piece(hid_t set, hid_t creation) {
  const H5D_layout_t layout = H5Pget_layout(creation);
  return layout == H5D_COMPACT || (layout == H5D_CONTIGUOUS && H5Dget_storage_size(set) > 0);
}

}  // namespace

void forbid_other_files() {
  if (H5Lis_registered(H5L_TYPE_EXTERNAL) > 0) H5Lunregister(H5L_TYPE_EXTERNAL);
}

Handle open_dataset(hid_t place, const std::string& name) {
  if (link_of(place, name).type >= H5L_TYPE_UD_MIN) {
    throw Failure(fmt::format("{} is a link into another file; {}", name, only_inside));
  }
  Handle set(H5Dopen2(place, name.c_str(), H5P_DEFAULT));
  if (set < 0) {
    blame_the_system(name + " cannot be opened");
    throw Failure(why_no_dataset(place, name));
  }
  require_stored_inside(set, name);
  return set;
}

std::size_t believed_count(hid_t set, const std::string& name) {
  const std::string damaged = name + " is damaged";
  const Handle space = own(H5Dget_space(set), damaged);
  const Handle type = own(H5Dget_type(set), damaged);
  const Handle creation = own(H5Dget_create_plist(set), damaged);
  const hssize_t count = H5Sget_simple_extent_npoints(space);
  const std::size_t width = H5Tget_size(type);
  if (count < 0 || width == 0) throw Failure(damaged);
  const hsize_t bytes = file_bytes(set);
  const hsize_t most = in_one_piece(set, creation) ? bytes : bytes * closest_packed;
  if (static_cast<hsize_t>(count) > most / width) {
    throw Failure(fmt::format("{} claims {} numbers of {} bytes each; the whole file has {} bytes",
                              name, count, width, bytes));
  }
  return static_cast<std::size_t>(count);
}

void require_room(std::size_t count, const std::string& name) {
  const std::uint64_t room = free_memory();
  if (count > room / sizeof(double)) {
    throw NotTheFile(
        fmt::format("{} has {} numbers, {:.3g} GB as doubles; {:.3g} GB of memory are "
                    "free",
                    name, count, 1e-9 * sizeof(double) * static_cast<double>(count),
                    1e-9 * static_cast<double>(room)));
  }
}

std::string why_unreadable(hid_t set, const std::string& name) {
  const Handle creation(H5Dget_create_plist(set));
  const int filters = H5Pget_nfilters(creation);
  for (int i = 0; i < filters; ++i) {
    std::array<char, 64> words{};
    unsigned flags = 0, configuration = 0;
    std::size_t parameters = 0;
    const H5Z_filter_t id = H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &parameters,
                                           nullptr, words.size() - 1, words.data(), &configuration);
    if (id < 0 || H5Zfilter_avail(id) > 0) continue;
    return fmt::format("{} needs the filter {}{}(id {}), which this HDF5 lacks", name, words.data(),
                       words[0] == '\0' ? "" : " ", static_cast<int>(id));
  }
  return name + " cannot be read: the file is damaged";
}

hsize_t file_bytes(hid_t object) {
  const Handle file = own(H5Iget_file_id(object), "the file cannot be asked for its size");
  hsize_t bytes = 0;
  check(H5Fget_filesize(file, &bytes), "the file cannot be asked for its size");
  return bytes;
}

}  // namespace vortree::io::h5
