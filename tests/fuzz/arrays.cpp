#include "particles.hpp"

using namespace vortree;

// A file of numpy's or a table, by its first byte.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  if (size == 0) return 0;
  const char* name = data[0] == 'P' ? "a.npz" : data[0] == 0x93 ? "a.npy" : "a.csv";
  fuzz::expect_particles(folder.with(name, data, size));
  return 0;
}
