#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "io/input_error.hpp"

namespace vortree::io {

/// The bytes of a file, fetched by the system as they are looked at.
class MappedFile {
 public:
  /// throws  InputError: no such file, no regular one, no right to read it
  explicit MappedFile(const std::filesystem::path&);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  [[nodiscard]] std::string_view bytes() const {
    return {static_cast<const char*>(first_), length_};
  }

 private:
  void* first_ = nullptr;
  std::size_t length_ = 0;
};

}  // namespace vortree::io
