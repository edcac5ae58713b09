#include <cmath>

#include "input.hpp"
#include "io/tables/particles.hpp"

using namespace vortree;

// A file of numpy's or a table, by its first byte; what is read is what read_particles promises.

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
  if (size == 0) return 0;
  const char* name = data[0] == 'P' ? "a.npz" : data[0] == 0x93 ? "a.npy" : "a.csv";
  const auto path = folder.with(name, data, size);
  fuzz::expect_answer([&] {
    using enum io::Need;
    const auto p =
        io::read_particles(path, {.gamma = optional, .sigma = optional, .reach = optional});
    const std::size_t n = p.x.size();
    require_good(p.x, n, true, false);
    require_good(p.y, n, true, false);
    require_good(p.gamma, n, false, false);
    require_good(p.sigma, n, false, true);
    require_good(p.reach, n, false, true);
  });
  return 0;
}
