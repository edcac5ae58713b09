#include "app/cli.hpp"
#include "input.hpp"

using namespace vortree;

// Words, one a line. Nothing is carried out.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::string> words = fuzz::lines_of(fuzz::text_of(data, size));
  std::vector<const char*> arguments{"vortree"};
  for (const std::string& word : words) arguments.push_back(word.c_str());
  const auto wrong = app::objection(static_cast<int>(arguments.size()), arguments.data());
  if (wrong && wrong->empty()) fuzz::fail("no words");
  return 0;
}
