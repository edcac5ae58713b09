#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace vortree::io {

/// Owns an open file or folder of the system.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  operator int() const { return number_; }

 private:
  int number_;
};

// `named` is what the error calls the file. All throw std::runtime_error with the system's reason.

void write_whole(const Descriptor&, std::string_view text, const std::filesystem::path& named);

/// Returns when what was written is on the disk.
void force(const Descriptor&, const std::filesystem::path& named);

/// Returns when the names in the folder are on the disk: those that were made, moved or removed.
void force_folder(const std::filesystem::path& folder);

}  // namespace vortree::io
