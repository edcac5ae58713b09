#include "io/scene/scene.hpp"

#include "by_vortices.hpp"
#include "input.hpp"

using namespace vortree;

// Lines before the first that is "---" are a scene, those behind it overrides. A scene that is
// accepted must come back from its own print.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input = fuzz::text_of(data, size);
  const std::size_t end = input.find("\n---\n");
  std::vector<std::string> overrides;
  if (end != std::string_view::npos) overrides = fuzz::lines_of(input.substr(end + 5));
  fuzz::expect_answer([&] {
    const io::Scene scene =
        io::parse_scene(input.substr(0, end), "scene.toml", test::by_vortices(), overrides);
    const std::string printed = io::resolved(scene);
    try {
      if (!(io::parse_scene(printed, "scene.toml", scene.methods) == scene))
        fuzz::fail("differs:\n" + printed);
    } catch (const io::InputError& refusal) {
      fuzz::fail(refusal.what() + (":\n" + printed));
    }
  });
  return 0;
}
