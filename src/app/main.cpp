#include <hdf5.h>
#include <malloc.h>

#include "app/cli.hpp"
#include "app/threads.hpp"

namespace {

/// Freed memory stays with the program: a step frees and takes megabytes, and fresh pages of the
/// system cost more than what is computed in them. The benches find it warm, as a flow does.
void keep_freed_memory() {
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, 1 << 26);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  vortree::app::sleep_while_waiting(argv);
  // All files are closed before the end; HDF5's own cleanup crashes if one could not be written.
  H5dont_atexit();
  return vortree::app::command_line(argc, argv);
}
