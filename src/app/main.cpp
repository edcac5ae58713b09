#include "app/cli.hpp"

int main(int argc, char** argv) {
  return vortree::app::command_line(argc, argv);
}
