#include "io/frames/hdf5.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <new>

#include "io/files.hpp"
#include "io/frames/hdf5_inside.hpp"

namespace vortree::io::h5 {
namespace {

constexpr hsize_t bytes_of_a_link = 8;  // at the least: the address of what it leads to

struct Reason {
  int number = 0;
  std::string words{};
};

extern "C" herr_t find_reason(unsigned, const H5E_error2_t* error, void* found) {
  const std::string_view words = error->desc == nullptr ? "" : error->desc;
  constexpr std::string_view number = "errno = ", message = "error message = '";
  const std::size_t at = words.find(number), from = words.find(message);
  if (at == std::string_view::npos || from == std::string_view::npos) return 0;
  const std::string_view reason = words.substr(from + message.size());
  *static_cast<Reason*>(found) = {std::atoi(words.data() + at + number.size()),
                                  std::string(reason.substr(0, reason.find('\'')))};
  return 1;
}

/// Of the last call that failed: why the system refused it, if it was that.
Reason reason() {
  Reason found;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, find_reason, &found);
  return found;
}

[[noreturn]] void fail(std::string_view what) {
  blame_the_system(what);
  throw Failure(std::string(what));
}

// HDF5 keeps the switch for each thread, so it is thrown with every file, not once.
void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  forbid_other_files();
}

/// Someone who looks at the frames of a running program must not stop it by the lock of a reader.
Handle unlocked() {
  Handle access = own(H5Pcreate(H5P_FILE_ACCESS), "a property list");
  check(H5Pset_file_locking(access, false, true), "a property list");
  return access;
}

Handle small_group() {
  Handle creation = own(H5Pcreate(H5P_GROUP_CREATE), "a property list");
  check(H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED), "a property list");
  // In the header, however many: HDF5 1.10 frees what it has not read where it may not read the
  // tree that it would keep many in.
  check(H5Pset_link_phase_change(creation, 1000, 500), "a property list");
  return creation;
}

void write_values(hid_t place, const std::string& name, hid_t type, const void* values,
                  std::span<const hsize_t> shape) {
  const Handle space = own(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                           "a data space could not be made");
  Handle set = own(
      H5Dcreate2(place, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
  if (values != nullptr) {  // no values: HDF5 takes no empty buffer
    check(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
  }
  close(std::move(set), name);
}

template <class T>
void write_line(hid_t place, const std::string& name, hid_t type, std::span<const T> values) {
  const std::array<hsize_t, 1> shape{values.size()};
  write_values(place, name, type, values.data(), shape);
}

void write_scalar(hid_t object, const std::string& name, hid_t type, const void* value) {
  if (has_attribute(object, name)) check(H5Adelete(object, name.c_str()), name);
  const Handle space = own(H5Screate(H5S_SCALAR), name);
  Handle attribute =
      own(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), name);
  check(H5Awrite(attribute, type, value), name);
  close(std::move(attribute), name);
}

Handle open_scalar(hid_t object, const std::string& name) {
  Handle attribute = own(H5Aopen(object, name.c_str(), H5P_DEFAULT), name);
  const Handle space = own(H5Aget_space(attribute), name);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Failure(name + " is not one value");
  return attribute;
}

template <class T>
T read_number(hid_t object, const std::string& name, hid_t type) {
  const Handle attribute = open_scalar(object, name);
  T value{};
  check(H5Aread(attribute, type, &value), name);
  return value;
}

}  // namespace

void blame_the_system(std::string_view what) {
  const Reason why = reason();
  if (why.number == 0 || why.number == EINVAL || why.number == EOVERFLOW) return;
  throw NotTheFile(fmt::format("{}: {}", what, why.words));
}

Handle own(hid_t id, std::string_view what) {
  if (id < 0) fail(what);
  return Handle(id);
}

void check(herr_t status, std::string_view what) {
  if (status < 0) fail(what);
}

void close(Handle handle, std::string_view what) {
  if (!handle.close()) fail(what);
}

bool is_hdf5(const std::filesystem::path& path) {
  silence();
  return H5Fis_hdf5(path.c_str()) > 0;
}

Handle open_file(const std::filesystem::path& path, unsigned flags) {
  silence();
  std::error_code unknown;
  if (flags == H5F_ACC_RDWR && std::filesystem::file_size(path, unknown) == 0) {
    throw Failure(path.string() + " is empty");  // HDF5 would begin a new file in it
  }
  const Handle access = unlocked();
  // What is added from here on has checked headers: HDF5 itself may crash on a damaged older one.
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST), "a property list");
  return own(H5Fopen(path.c_str(), flags, access), path.string() + " cannot be opened");
}

Handle create_file(const std::filesystem::path& path, hid_t creation) {
  silence();
  return own(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, unlocked()),
             path.string() + " cannot be created");
}

void close_file(Handle file, const std::filesystem::path& path) {
  const std::string what = path.string() + " cannot be written to the end";
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), what);
  close(std::move(file), what);
  const int descriptor = ::open(path.c_str(), O_RDONLY);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced) {
    throw Failure(
        fmt::format("{} cannot be forced to the disk: {}", path.string(), std::strerror(errno)));
  }
}

void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write) {
  try {
    io::replace_file(path, write);
  } catch (const Failure& failure) {
    throw std::runtime_error(
        fmt::format("{} cannot be written ({})", path.string(), failure.what()));
  }
}

Handle create_group(hid_t place, const std::string& name) {
  return own(H5Gcreate2(place, name.c_str(), H5P_DEFAULT, small_group(), H5P_DEFAULT), name);
}

void append_group(hid_t file, const std::string& name, const std::function<void(hid_t)>& fill) {
  Handle group = own(H5Gcreate_anon(file, small_group(), H5P_DEFAULT), name);
  fill(group);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), name);
  check(H5Olink(group, file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT), name);
  close(std::move(group), name);
}

std::string file_name(hid_t file) {
  const ssize_t length = H5Fget_name(file, nullptr, 0);
  if (length <= 0) return "a file";
  std::string name(static_cast<std::size_t>(length) + 1, '\0');
  (void)H5Fget_name(file, name.data(), name.size());
  name.pop_back();
  return name;
}

bool has(hid_t place, const std::string& name) {
  const htri_t found = H5Lexists(place, name.c_str(), H5P_DEFAULT);
  if (found < 0) blame_the_system(name + " cannot be looked for");
  return found > 0;
}

bool has_attribute(hid_t object, const std::string& name) {
  const htri_t found = H5Aexists(object, name.c_str());
  check(found, name);
  return found > 0;
}

std::vector<Link> links(hid_t group, hsize_t most) {
  H5G_info_t info{};
  check(H5Gget_info(group, &info), "the list of names is damaged");
  std::vector<Link> found;
  const hsize_t believed = std::min({info.nlinks, most, file_bytes(group) / bytes_of_a_link});
  for (hsize_t i = 0; i < believed; ++i) {
    const auto name_of = [&](char* text, std::size_t room) {
      return H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, text, room, H5P_DEFAULT);
    };
    const ssize_t length = name_of(nullptr, 0);
    if (length <= 0) blame_the_system("the list of names cannot be read");
    if (length <= 0) continue;
    std::string name(static_cast<std::size_t>(length) + 1, '\0');
    if (name_of(name.data(), name.size()) != length) {
      blame_the_system("the list of names cannot be read");
      continue;
    }
    name.pop_back();
    found.push_back({i, std::move(name)});
  }
  if (found.empty() && believed > 0) throw Failure("the list of names is damaged");
  return found;
}

void write(hid_t place, const std::string& name, std::span<const double> values) {
  write_line(place, name, H5T_NATIVE_DOUBLE, values);
}

void write(hid_t place, const std::string& name, std::span<const std::int64_t> values) {
  write_line(place, name, H5T_NATIVE_INT64, values);
}

void write(hid_t place, const std::string& name, std::span<const std::int32_t> values) {
  write_line(place, name, H5T_NATIVE_INT32, values);
}

void write_grid(hid_t place, const std::string& name, std::span<const double> values, hsize_t rows,
                hsize_t columns) {
  const std::array<hsize_t, 2> shape{rows, columns};
  write_values(place, name, H5T_NATIVE_DOUBLE, values.data(), shape);
}

std::vector<double> read(hid_t place, const std::string& name) {
  return read_dataset(open_dataset(place, name), name);
}

std::vector<double> read_dataset(hid_t set, const std::string& name) {
  const std::size_t count = believed_count(set, name);
  require_room(count, name);
  std::vector<double> values;
  try {
    values.resize(count);
  } catch (const std::bad_alloc&) {
    throw NotTheFile(fmt::format("{} has {} numbers, for which there is no memory", name, count));
  }
  if (values.empty()) return values;
  if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
    blame_the_system(name + " cannot be read");
    throw Failure(why_unreadable(set, name));
  }
  return values;
}

void write_attribute(hid_t object, const std::string& name, double value) {
  write_scalar(object, name, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t object, const std::string& name, std::int64_t value) {
  write_scalar(object, name, H5T_NATIVE_INT64, &value);
}

void write_attribute(hid_t object, const std::string& name, std::uint64_t value) {
  write_scalar(object, name, H5T_NATIVE_UINT64, &value);
}

void write_attribute(hid_t object, const std::string& name, const std::string& value) {
  // Fixed length with the closing zero, so that an empty text has a size too.
  const Handle type = own(H5Tcopy(H5T_C_S1), name);
  check(H5Tset_size(type, value.size() + 1), name);
  check(H5Tset_cset(type, H5T_CSET_UTF8), name);
  write_scalar(object, name, type, value.c_str());
}

double read_double(hid_t object, const std::string& name) {
  return read_number<double>(object, name, H5T_NATIVE_DOUBLE);
}

std::int64_t read_integer(hid_t object, const std::string& name) {
  return read_number<std::int64_t>(object, name, H5T_NATIVE_INT64);
}

std::uint64_t read_unsigned(hid_t object, const std::string& name) {
  return read_number<std::uint64_t>(object, name, H5T_NATIVE_UINT64);
}

std::string read_string(hid_t object, const std::string& name) {
  const Handle attribute = open_scalar(object, name);
  const Handle type = own(H5Aget_type(attribute), name);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) != 0) {
    throw Failure(name + " is not a text of fixed length");
  }
  const std::size_t length = H5Tget_size(type);
  if (length > file_bytes(object)) throw Failure(name + " claims to be longer than the file");
  std::string text(length, '\0');
  check(H5Aread(attribute, type, text.data()), name);
  text.resize(std::char_traits<char>::length(text.c_str()));
  return text;
}

}  // namespace vortree::io::h5
