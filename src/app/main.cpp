#include <hdf5.h>

#include "app/cli.hpp"
#include "app/loop/threads.hpp"
#include "app/surroundings.hpp"

int main(int argc, char** argv) {
  vortree::app::bear_surroundings();
  vortree::app::choose_waiting(argv);
  vortree::app::keep_freed_memory();
  // All files are closed before the end; HDF5's own cleanup crashes if one could not be written.
  H5dont_atexit();
  return vortree::app::command_line(argc, argv);
}
