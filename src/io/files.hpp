#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "io/descriptor.hpp"

// All that the program writes goes through here. Only a regular file is ever replaced, and only
// when the new one is whole: a reader, a kill or a power failure sees the old or the new one. A
// symbolic link is followed, also to a file that is not there yet: the link stays, its target is
// replaced.

namespace vortree::io {

/// The whole file, or what comes out of a pipe, up to 1 GiB. throws InputError: no such file, a
/// folder, too long, cannot be read.
[[nodiscard]] std::string read_text(const std::filesystem::path&);

/// throws  std::runtime_error if it cannot be written
void write_text(const std::filesystem::path&, std::string_view text);

/// The same where there is nothing of that name yet. Of several writers at once, on whatever
/// machines, one comes first; a reader finds nothing or the whole text.
/// returns  false: there is something, which stays
[[nodiscard]] bool write_new_text(const std::filesystem::path&, std::string_view text);

/// As write_text, but for power failures: for what can be made again from other files.
void write_derived_text(const std::filesystem::path&, std::string_view text);

/// Lets `write` make a file under another name beside `path`, then renames it to `path`. If `write`
/// throws, the older file stays as it was and nothing is left behind.
void replace_file(const std::filesystem::path& path,
                  const std::function<void(const std::filesystem::path&)>& write);

/// Removes an output of an earlier run; a symbolic link stays, its target goes.
void remove_file(const std::filesystem::path&);

/// An output that is there already, to be continued. throws InputError
[[nodiscard]] Descriptor open_to_append(const std::filesystem::path&);

/// throws  InputError unless there is something of that name, no folder, that can be read
void require_file(const std::filesystem::path&);

/// throws  InputError, too, if it is a device or a pipe, which may have no end
void require_regular_file(const std::filesystem::path&);

/// throws  InputError if there is something of that name that no output may replace: a folder, a
///         device, a pipe, a file without the right to write, or one of `inputs` by whatever link
///         or spelling
void require_replaceable(const std::filesystem::path&,
                         std::span<const std::filesystem::path> inputs = {});

/// throws  InputError unless a file of that name can be written: also no such folder, no right, ...
void require_writable(const std::filesystem::path&,
                      std::span<const std::filesystem::path> inputs = {});

/// Where links lead in the end, whether or not there is anything.
[[nodiscard]] std::filesystem::path target_of(const std::filesystem::path&);

/// Whether what stands there, by whatever links, is of the suffix of its name: a figure by a link
/// is a figure, a table is none.
[[nodiscard]] bool keeps_suffix(const std::filesystem::path&);

/// The folder of a file; "." for a bare name.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path&);

}  // namespace vortree::io
