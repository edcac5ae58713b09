#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

// A type name stands once in the repository, whatever namespace it is in. A helper that wants a
// common word says what it helps with, or nests in it: types inside classes and functions are
// nobody else's business.
namespace {

namespace fs = std::filesystem;

struct Token {
  std::string text;
  int line = 0;
};

/// Words, the marks :: [[ ]], and single characters; without comments, literals and lines for the
/// preprocessor.
std::vector<Token> tokens_of(const std::string& text) {
  static const std::regex pattern(R"re(//[^\n]*|/\*(?:[^*]|\*(?!/))*\*/|#(?:[^\n\\]|\\[^])*)re"
                                  R"re(|R"\((?:[^)]|\)(?!"))*\)"|"(?:[^"\\\n]|\\.)*")re"
                                  R"re(|'(?:[^'\\\n]|\\.)+'|(\w(?:'?\w)*|::|\[\[|\]\]|\S))re",
                                  std::regex::ECMAScript | std::regex::optimize);
  std::vector<Token> tokens;
  int line = 1;
  auto counted = text.begin();
  for (std::sregex_iterator one(text.begin(), text.end(), pattern), end; one != end; ++one) {
    line += static_cast<int>(std::count(counted, (*one)[0].first, '\n'));
    counted = (*one)[0].first;
    if ((*one)[1].matched) tokens.push_back({(*one)[1], line});
  }
  tokens.resize(tokens.size() + 4);  // so that a look ahead finds something
  return tokens;
}

struct Definition {
  std::string name, place;
};

/// Reads the types that a file defines by class, struct, union, enum and using, outside of classes
/// and functions. Not declarations, members defined outside of their class, or specialisations.
class Reader {
 public:
  Reader(std::string file, const std::string& text)
      : file_(std::move(file)), tokens_(tokens_of(text)) {}

  std::vector<Definition> definitions() {
    static const std::set<std::string> begins_type{"class", "struct", "union", "enum"};
    for (; at_ < tokens_.size(); ++at_) {
      if (is("{")) braces_.push_back(std::exchange(opens_namespace_, false));
      if (is("}") && !braces_.empty()) braces_.pop_back();
      if (is(";")) opens_namespace_ = false;
      if (is("namespace")) opens_namespace_ = true;
      if (is("using")) read_alias();
      if (begins_type.contains(tokens_[at_].text)) read_type();
    }
    return found_;
  }

 private:
  bool is(const char* text, std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].text == text;
  }
  void skip_attributes() {
    for (; is("[[") || is("alignas"); ++at_) {
      const char* last = is("[[") ? "]]" : ")";
      while (at_ + 1 < tokens_.size() && !is(last)) ++at_;
    }
  }

  void read_alias() {
    const Token name = tokens_[++at_];
    ++at_;
    skip_attributes();
    if (is("=")) add(name);
    --at_;
  }

  /// A definition has a body, at once or behind what it derives from.
  void read_type() {
    if (is("class", 1) || is("struct", 1)) ++at_;
    ++at_;
    skip_attributes();
    const Token name = tokens_[at_];
    const bool is_final = is("final", 1), derives = is(":", 1 + is_final);
    if (is("{") || is("<", 1) || is("::", 1)) {
      --at_;
      return;
    }
    if (!derives && !is("{", 1 + is_final)) return;
    while (!is("{", 1) && !is(";", 1) && at_ < tokens_.size()) ++at_;
    if (is("{", 1)) add(name);
  }

  void add(const Token& name) {
    if (std::ranges::find(braces_, false) != braces_.end()) return;
    found_.push_back({name.text, file_ + ":" + std::to_string(name.line)});
  }

  std::string file_;
  std::vector<Token> tokens_;
  std::size_t at_ = 0;
  std::vector<bool> braces_;  // those around: does it open a namespace?
  bool opens_namespace_ = false;
  std::vector<Definition> found_;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The places of every type below tree, fmm and src.
std::map<std::string, std::vector<std::string>> all_types() {
  const fs::path root = VORTREE_SOURCE_DIR;
  std::map<std::string, std::vector<std::string>> places;
  for (const char* part : {"tree", "fmm", "src"})
    for (const auto& entry : fs::recursive_directory_iterator(root / part)) {
      const fs::path file = entry.path().lexically_relative(root);
      if (file.extension() != ".hpp" && file.extension() != ".cpp") continue;
      for (const Definition& one : Reader(file.generic_string(), text_of(entry)).definitions())
        places[one.name].push_back(one.place);
    }
  return places;
}

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (const Definition& one : Reader("a.hpp", text).definitions()) names.push_back(one.name);
  return names;
}

}  // namespace

TEST_CASE("a type name is defined once") {
  const auto types = all_types();
  CHECK(types.size() > 400);
  for (const auto& [name, places] : types) {
    for (const std::string& place : places) UNSCOPED_INFO(place);
    INFO(name << " is defined here and there");
    CHECK(places.size() == 1);
  }
}

TEST_CASE("definitions of types are told from all that looks like them") {
  using Names = std::vector<std::string>;
  CHECK(names_in("class A; struct B; enum class C : int; friend class D; struct E e{};").empty());
  CHECK(names_in("struct A {}; class B final : A {}; union C {}; enum D { d }; enum class E {};") ==
        Names{"A", "B", "C", "D", "E"});
  CHECK(
      names_in("using A = int; using B [[gnu::aligned(8)]] = C; using d::E; using namespace f;") ==
      Names{"A", "B"});
  CHECK(names_in("struct alignas(64) [[nodiscard]] A {}; enum class B : int { b };") ==
        Names{"A", "B"});
  CHECK(names_in("template <class T, class U = int> struct A {}; template <> struct A<int> {\n"
                 "  using B = int;\n};") == Names{"A"});
}

TEST_CASE("types inside classes, functions and specialisations do not count, those behind do") {
  using Names = std::vector<std::string>;
  CHECK(names_in("namespace a::b { namespace { struct A { struct B { using C = int; }; }; } }\n"
                 "struct A::D { using E = int; }; using F = int;") == Names{"A", "F"});
  CHECK(names_in("int f() { struct A {}; } struct B { void g() { using C = int; } int h; };\n"
                 "const auto i = [] { struct J {}; }; struct K {};") == Names{"B", "K"});
}

TEST_CASE("comments, literals and macros define nothing, and places count their lines") {
  const auto found = Reader("a.hpp",
                            "// struct A {};\n/* struct B {\n */ #define C struct D { \\\n x\n"
                            "const char* e = \"struct F {}; {\"; char g = '{'; int h = 1'000;\n"
                            "const char* i = R\"(} \" struct J {})\";\nstruct K {};")
                         .definitions();
  REQUIRE(found.size() == 1);
  CHECK(found[0].name == "K");
  CHECK(found[0].place == "a.hpp:7");
}
