#pragma once

namespace vortree::app {

/// Lets OpenMP threads that wait for each other sleep instead of spin, unless the environment says
/// otherwise.
///
/// A thread that spins keeps the core from the one it waits for: with other programs on the
/// machine, steps of some thousand blobs took five to seventy times as long. On an idle machine
/// waking costs microseconds.
///
/// argv  of main; the program starts itself once more, since OpenMP reads its environment before
/// main
void sleep_while_waiting(char** argv);

}  // namespace vortree::app
