#pragma once

namespace vortree::app {

/// What a shell or a batch system may have in store, so that it ends in a line or not at all:
///
///   standard input, output or error closed   opened to nowhere, for no file may take their numbers
///   SIGPIPE, SIGXFSZ                         ignored: the write fails and says so
///   an exception that nobody catches         one line and exit code 1 (a thread of a parallel loop
///                                            that finds no memory)
void bear_surroundings();

/// Freed memory stays with the program: a step frees and takes megabytes, and fresh pages of the
/// system cost more than what is computed in them. The benches find it warm, as a flow does. Under
/// a limit to the address space less is taken ahead.
void keep_freed_memory();

}  // namespace vortree::app
