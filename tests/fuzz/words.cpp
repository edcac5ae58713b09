#include <cstdio>
#include <string>

#include "io/scene/schema.hpp"

using namespace vortree::io;

// Prints a dictionary for libFuzzer: the names of tables and keys, and the words of choices.

namespace {

void print(std::string_view word) {
  std::printf("\"%.*s\"\n", static_cast<int>(word.size()), word.data());
}

template <class E>
void print_words() {
  for (const std::string_view word : schema::words_of<E>) print(word);
}

struct Words {
  void operator()(std::string_view key, const auto&, const schema::Rule&) { print(key); }

  template <class T>
  void table(std::string_view name, const T& value, bool) {
    print("[" + std::string(name) + "]");
    schema::walk(value, *this);
  }

  template <class T>
  void table(std::string_view name, const std::optional<T>&, bool required) {
    const T blank{};
    table(name, blank, required);
  }
};

}  // namespace

int main() {
  Words words;
  const Scene scene{};
  schema::walk(scene, words);
  print_words<Shape>();
  print_words<InitialKind>();
  print_words<DiffusionKind>();
  print_words<TimeScheme>();
  print_words<VelocityMethod>();
  print_words<TreeBuilder>();
  print_words<PairCores>();
  print_words<ExactAnswer>();
  for (const char* word :
       {" = ", "[[", "]]", "{", "}", "'", "1e-300", "1e308", "nan", "-inf", "0x7", "1979-05-27",
        "true", "\\x0a---\\x0a", "\\\"\\\"\\\"", "\\xef\\xbb\\xbf"}) {
    print(word);
  }
}
