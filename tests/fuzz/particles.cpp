#include "io/tables/particles.hpp"

#include <cmath>

#include "input.hpp"

using namespace vortree;

// What is read is what the header promises: equal lengths, finite numbers, cores and reaches >= 0.

namespace {

void require_good(const std::vector<double>& values, std::size_t n, bool needed, bool positive) {
  if (values.size() != n && (needed || !values.empty())) fuzz::fail("unequal lengths");
  for (const double value : values) {
    if (!std::isfinite(value) || (positive && value < 0)) fuzz::fail("a value that is none");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const auto path = folder.with("p.h5", data, size);
  fuzz::expect_answer([&] {
    using enum io::Need;
    const auto p =
        io::read_particles(path, {.gamma = required, .sigma = optional, .reach = optional});
    const std::size_t n = p.x.size();
    require_good(p.x, n, true, false);
    require_good(p.y, n, true, false);
    require_good(p.gamma, n, true, false);
    require_good(p.sigma, n, false, true);
    require_good(p.reach, n, false, true);
  });
  return 0;
}
