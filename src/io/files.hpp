#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace vortree::io {

/// The whole file, or what comes out of a pipe, up to 1 GiB. throws InputError: no such file, a
/// folder, too long, cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path&);

/// Puts the text in place of an older file, in one rename: a reader sees the old or the new one.
/// throws  std::runtime_error if it cannot be written
void write_text(const std::filesystem::path&, std::string_view text);

/// Lets `write` make a file under another name beside `path`, then renames it to `path`. If `write`
/// throws, the older file stays as it was and nothing is left behind.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write);

/// throws  InputError unless there is something of that name, no folder, that can be read
void require_file(const std::filesystem::path&);

/// throws  InputError, too, if it is a device or a pipe, which may have no end
void require_regular_file(const std::filesystem::path&);

/// throws  InputError unless a file of that name can be written: no such folder, no right, ...
void require_writable(const std::filesystem::path&);

}  // namespace vortree::io
