#pragma once

#include <hdf5.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Small owning handles over the HDF5 C API, and the few reads and writes that this program needs.
// HDF5's own printing of its error stack is switched off; a failed call throws h5::Failure, with
// the words of the system if that refused it, which the callers turn into a sentence about their
// file.

namespace vortree::io::h5 {

class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What says nothing against the file: no memory for what is to be read, or the system refused to
/// open or read it. Such a thing must not be taken for damage, which may be dropped.
class NotTheFile : public Failure {
 public:
  using Failure::Failure;
};

/// throws  NotTheFile(what) if the last call failed since the system refused it; not where a
///         damaged file made HDF5 ask for what cannot be
void blame_the_system(std::string_view what);

/// Owns one identifier of any kind (file, group, dataset, space, type, attribute, property list).
class Handle {
 public:
  Handle() = default;
  explicit Handle(hid_t id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() { close(); }

  operator hid_t() const { return id_; }

  /// Gives the identifier back; false if HDF5 could not (a file that cannot be flushed).
  bool close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || H5Idec_ref(id) >= 0;
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

/// Takes what an HDF5 call returned. throws Failure(what) if the call failed.
[[nodiscard]] Handle own(hid_t id, std::string_view what);

/// throws Failure(what) if the call failed
void check(herr_t status, std::string_view what);

/// Gives an identifier back, which may be when HDF5 writes what it stands for. Whoever wrote
/// through a handle ends with this: a destructor could not say that the writing failed.
/// throws Failure(what)
void close(Handle, std::string_view what);

[[nodiscard]] bool is_hdf5(const std::filesystem::path&);

/// Opens a file. throws Failure if it is not HDF5 or cannot be opened.
[[nodiscard]] Handle open_file(const std::filesystem::path&, unsigned flags = H5F_ACC_RDONLY);

/// A new file; an older one is emptied.
[[nodiscard]] Handle create_file(const std::filesystem::path&, hid_t creation = H5P_DEFAULT);

/// Flushes, closes and forces to the disk. throws Failure: what was written is not safe.
void close_file(Handle, const std::filesystem::path&);

/// As vortree::io::replace_file for what `write` makes with HDF5.
/// throws std::runtime_error with the name of the file, if it fails
void replace_file(const std::filesystem::path&,
                  const std::function<void(const std::filesystem::path&)>& write);

/// A group that keeps its links in its own header, whatever the symbol tables of the file are made
/// for: those of a frames file hold thousands of links, which would be a waste in a small group.
[[nodiscard]] Handle create_group(hid_t place, const std::string& name);

/// Adds such a group to a file: filled first, then flushed, and only then linked by its name. A
/// process killed on the way leaves a file without the group, not a file with half of it; a power
/// failure may leave half of it, which its checksum tells.
void append_group(hid_t file, const std::string& name, const std::function<void(hid_t)>& fill);

/// As it was opened.
[[nodiscard]] std::string file_name(hid_t file);

[[nodiscard]] bool has(hid_t place, const std::string& name);
[[nodiscard]] bool has_attribute(hid_t object, const std::string& name);

/// One link of a group: its place in the order HDF5 keeps them, and its name.
struct Link {
  hsize_t index;
  std::string name;
};

/// The first links of a group; those whose name is damaged are left out.
/// throws  Failure if none of them can be read
[[nodiscard]] std::vector<Link> links(hid_t group, hsize_t most = HSIZE_UNDEF);

void write(hid_t place, const std::string& name, std::span<const double>);
void write(hid_t place, const std::string& name, std::span<const std::int64_t>);
void write(hid_t place, const std::string& name, std::span<const std::int32_t>);
/// Row-major [rows][columns].
void write_grid(hid_t place, const std::string& name, std::span<const double>, hsize_t rows,
                hsize_t columns);

/// A dataset of numbers, any shape, as doubles.
/// throws  Failure, a sentence that begins with the name: what hdf5_inside.hpp refuses, a filter
///         that this HDF5 lacks, damage
[[nodiscard]] std::vector<double> read(hid_t place, const std::string& name);
[[nodiscard]] std::vector<double> read_dataset(hid_t set, const std::string& name);

void write_attribute(hid_t object, const std::string& name, double);
void write_attribute(hid_t object, const std::string& name, std::int64_t);
void write_attribute(hid_t object, const std::string& name, std::uint64_t);
void write_attribute(hid_t object, const std::string& name, const std::string&);

[[nodiscard]] double read_double(hid_t object, const std::string& name);
[[nodiscard]] std::int64_t read_integer(hid_t object, const std::string& name);
[[nodiscard]] std::uint64_t read_unsigned(hid_t object, const std::string& name);
[[nodiscard]] std::string read_string(hid_t object, const std::string& name);

}  // namespace vortree::io::h5
