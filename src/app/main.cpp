#include "app/cli.hpp"
#include "app/threads.hpp"

int main(int argc, char** argv) {
  vortree::app::sleep_while_waiting(argv);
  return vortree::app::command_line(argc, argv);
}
