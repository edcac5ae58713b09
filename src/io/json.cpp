#include "io/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "io/files.hpp"
#include "io/quote.hpp"

namespace vortree::io {
namespace {

/// Writes a value; a negative indent keeps all on one line.
struct Writer {
  std::string text;
  int indent;

  void gap(char open_or_comma) {
    text += open_or_comma;
    if (indent >= 0) text += '\n' + std::string(2 * indent, ' ');
    if (indent < 0 && open_or_comma == ',') text += ' ';
  }

  template <class Items, class Item>
  void enclosed(char open, const Items& items, char close, Item&& item) {
    const int outside = indent;
    if (indent >= 0) ++indent;
    char before = open;
    for (const auto& one : items) {
      gap(std::exchange(before, ','));
      item(one);
    }
    indent = outside;
    if (items.empty()) text += open;
    if (indent >= 0 && !items.empty()) text += '\n' + std::string(2 * indent, ' ');
    text += close;
  }

  void operator()(std::monostate) { text += "null"; }
  void operator()(bool value) { text += value ? "true" : "false"; }
  void operator()(double value) {
    text += std::isfinite(value) ? fmt::format("{}", value) : "null";
  }
  void operator()(std::int64_t value) { text += fmt::format("{}", value); }
  void operator()(std::uint64_t value) { text += fmt::format("{}", value); }
  void operator()(const std::string& value) { text += quote(value); }
  void operator()(const Json::Elements& elements) {
    enclosed('[', elements, ']', [&](const Json& json) { json.visit(*this); });
  }
  void operator()(const Json::Members& members) {
    enclosed('{', members, '}', [&](const auto& member) {
      text += quote(member.first) + ": ";
      member.second.visit(*this);
    });
  }
};

}  // namespace

Json Json::array(Elements elements) {
  Json json;
  json.value_ = std::move(elements);
  return json;
}

Json& Json::operator[](std::string_view name) {
  if (std::holds_alternative<std::monostate>(value_)) value_ = Members{};
  if (!std::holds_alternative<Members>(value_)) {
    throw std::logic_error(fmt::format("a JSON value with a member {} must be an object", name));
  }
  auto& members = std::get<Members>(value_);
  for (auto& [known, value] : members) {
    if (known == name) return value;
  }
  return members.emplace_back(std::string(name), Json{}).second;
}

std::string Json::line() const {
  Writer writer{.text = {}, .indent = -1};
  visit(writer);
  return writer.text;
}

std::string Json::page() const {
  Writer writer{.text = {}, .indent = 0};
  visit(writer);
  return writer.text + '\n';
}

void write_json(const std::filesystem::path& path, const Json& json) {
  write_text(path, json.page());
}

}  // namespace vortree::io
