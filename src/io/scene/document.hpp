#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace vortree::io {

/// A parsed TOML text with the overrides of the command line laid over it, which remembers where
/// each key came from so that errors can say it.
class Document {
 public:
  /// An override that is a table sets its keys one by one and leaves the others of that table. One
  /// of a key in a list of tables is for each of them, body.panels=200, or for one,
  /// body[1].panels=200.
  /// throws  InputError: empty, not TOML (with the line), an override that cannot be understood
  Document(std::string_view text, std::filesystem::path path,
           std::span<const std::string> overrides);

  [[nodiscard]] const toml::table& root() const { return root_; }

  /// Throws the InputError `place: words`. key is dotted ("flow.nu"), or a table, or empty for the
  /// whole file. The place is the override that set it, or its line, or else that of what it is in:
  /// an array, a table, the file.
  [[noreturn]] void refuse(std::string_view key, std::string_view words) const;

 private:
  void lay_over(const std::string& override);
  void lay_over(const std::string& key, const toml::node& value, const std::string& override);
  void set(toml::table& in, const std::string& within, std::string_view key,
           const toml::node& value);
  void set_in_list(toml::node& list, const std::string& name, std::string_view number,
                   std::string_view key, const toml::node& value);
  [[nodiscard]] std::string place(std::string_view key) const;

  std::filesystem::path path_;
  toml::table root_;
  std::map<std::string, std::string, std::less<>> overrides_;  // dotted key -> as it was typed
};

/// "a string", "an integer", "a table", ...
[[nodiscard]] std::string_view kind_of(const toml::node&);

}  // namespace vortree::io
