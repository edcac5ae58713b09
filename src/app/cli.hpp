#pragma once

namespace vortree::app {

/// The whole program: reads the command line, carries the command out, reports an error as one line
/// on standard error.
///
/// returns  0 done; 1 the command failed; 2 wrong usage or input
int command_line(int argc, char** argv);

}  // namespace vortree::app
