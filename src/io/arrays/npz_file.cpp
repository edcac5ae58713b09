#include "io/arrays/npz_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/arrays/mapped_file.hpp"
#include "io/arrays/npy.hpp"
#include "io/arrays/zip.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

constexpr std::string_view suffix = ".npy";

/// An array of the file, unpacked if it had to be.
struct NpzMember {
  std::string room;
  std::string_view bytes;
  NpyHeader header;
};

class NpzArrays : public ArrayFile {
 public:
  explicit NpzArrays(const std::filesystem::path& path)
      : file_(path), members_(zip_members(file_.bytes())) {}

  std::string_view noun() const override { return "array"; }

  std::vector<std::string> names(std::size_t most) override {
    std::vector<std::string> all;
    for (const ZipMember& member : members_) {
      if (all.size() == most) break;
      const std::string_view name = member.name;
      all.push_back(shortened(
          name.ends_with(suffix) ? name.substr(0, name.size() - suffix.size()) : name, 40));
    }
    return all;
  }

  bool has(const std::string& name) override { return member(name) != members_.end(); }

  ArrayLayout layout(const std::string& name) override {
    const NpyHeader& header = opened(name).header;
    return {.shape = header.shape, .of_integers = header.fields.front().type.kind != 'f'};
  }

  std::vector<double> read(const std::string& name, std::uint64_t column) override {
    const NpzMember& found = opened(name);
    return npy_numbers(found.bytes, found.header, found.header.fields.front(), column);
  }

 private:
  /// Of two of one name the later one, as Python's zipfile has it.
  std::vector<ZipMember>::const_iterator member(const std::string& name) const {
    const std::string wanted = name + std::string(suffix);
    const auto last = std::find_if(members_.rbegin(), members_.rend(),
                                   [&](const ZipMember& one) { return one.name == wanted; });
    return last == members_.rend() ? members_.end() : std::prev(last.base());
  }

  const NpzMember& opened(const std::string& name) {
    const auto [at, fresh] = opened_.try_emplace(name);
    NpzMember& one = at->second;
    if (!fresh) return one;
    try {
      one.bytes = bytes_of(*member(name), file_.bytes(), one.room);
      one.header = read_npy_header(one.bytes);
    } catch (const BadArray& bad) {
      throw BadArray(fmt::format("{}: {}", name, bad.what()));
    }
    if (one.header.of_records)
      throw BadArray(fmt::format("{} has records; an array of numbers was expected", name));
    require_real(one.header.fields.front(), name);
    return one;
  }

  MappedFile file_;
  std::vector<ZipMember> members_;
  std::map<std::string, NpzMember> opened_;
};

}  // namespace

std::unique_ptr<ArrayFile> open_npz(const std::filesystem::path& path) {
  return std::make_unique<NpzArrays>(path);
}

}  // namespace vortree::io
