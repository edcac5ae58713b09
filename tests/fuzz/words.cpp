#include <cstdio>
#include <string>

#include "by_vortices.hpp"
#include "io/scene/schema.hpp"

using namespace vortree::io;

// Prints a dictionary for libFuzzer: the names of tables and keys, and the words of choices.

namespace {

void print(std::string_view word) {
  std::printf("\"%.*s\"\n", static_cast<int>(word.size()), word.data());
}

void print(const std::vector<vortree::Key>& keys) {
  for (const vortree::Key& key : keys) {
    print(key.name);
    if (const auto* choice = std::get_if<vortree::OneOf>(&key.target))
      for (const std::string_view word : choice->words) print(word);
  }
}

}  // namespace

int main() {
  Scene scene = blank_scene(vortree::test::by_vortices());
  print(keys(scene));
  for (const vortree::SceneTable& table : tables(scene)) {
    print("[" + std::string(table.name) + "]");
    print(table.keys());
  }
  for (const char* word :
       {" = ", "[[", "]]", "{", "}", "'", "1e-300", "1e308", "nan", "-inf", "0x7", "1979-05-27",
        "true", "\\x0a---\\x0a", "\\\"\\\"\\\"", "\\xef\\xbb\\xbf"}) {
    print(word);
  }
}
