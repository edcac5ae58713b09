#include "particles.hpp"

using namespace vortree;

// A file of HDF5.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  fuzz::expect_particles(folder.with("p.h5", data, size));
  return 0;
}
