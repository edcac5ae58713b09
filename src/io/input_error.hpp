#pragma once

#include <stdexcept>

namespace vortree::io {

/// Something the user wrote or named is wrong: a scene, an override, a particle file, an output
/// folder.
///
/// what()  one line that can be shown as it stands: where (`file`, `file:line` or `command line:
///         key=value`), what was found, what was expected. The program prints it and leaves with
///         exit code 2. A failure that is nobody's input (disk full in the middle of a run) is a
///         plain std::runtime_error.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace vortree::io
