#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "io/input_error.hpp"
#include "io/quote.hpp"

namespace vortree::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The lines of a text.
inline std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines(1);
  for (const char c : text) {
    if (c == '\n') {
      lines.emplace_back();
    } else {
      lines.back() += c;
    }
  }
  return lines;
}

/// A folder of this process, gone with it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "vortree-fuzz-XXXXXX").string();
    if (!mkdtemp(name.data())) std::abort();
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::filesystem::path with(const char* name, const std::uint8_t* data,
                                           std::size_t size) const {
    std::ofstream(path_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path_ / name;
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

[[noreturn]] inline void fail(const std::string& words) {
  std::fprintf(stderr, "wrong: %s\n", words.c_str());
  std::abort();
}

/// A refusal is one line that can be read and is not without end.
inline void require_sentence(std::string_view words) {
  if (words.empty()) fail("no words");
  if (words.size() > 1000) fail("too many words: " + std::string(words));
}

/// Reads; what is refused must be refused in a sentence, with InputError.
template <class Read>
void expect_answer(Read&& read) {
  try {
    read();
  } catch (const io::InputError& refusal) {
    require_sentence(refusal.what());
  }
}

}  // namespace vortree::fuzz
