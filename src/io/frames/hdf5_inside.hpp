#pragma once

#include <string>
#include <vector>

#include "io/frames/hdf5.hpp"

// What keeps the reading of a file inside that file. A dataset may be a link into another file, be
// put together from other files (a virtual dataset) or keep its numbers in a raw file beside: such
// a thing is refused, for the other file may be missing (HDF5 then makes numbers up), be a pipe
// (HDF5 waits for ever) or be nobody's business. A length is held against the file and the memory
// before anything is made room for.

namespace vortree::io::h5 {

/// From now on no link leads HDF5 into another file, whoever follows it.
void forbid_other_files();

/// Opens a dataset whose numbers lie in the file itself.
/// throws  Failure, a sentence that begins with the name: no dataset, a link that leads nowhere or
///         into another file, a virtual dataset, raw storage in another file
[[nodiscard]] Handle open_dataset(hid_t place, const std::string& name);

/// How many numbers an open dataset has.
/// throws  Failure, a sentence with the numbers, if the file is too short to hold so many
[[nodiscard]] std::size_t believed_count(hid_t set, const std::string& name);

/// throws  NotTheFile, a sentence with the numbers, if so many doubles do not fit into the memory
void require_room(std::size_t count, const std::string& name);

/// Why the numbers of a dataset cannot be read, as a sentence: a filter that is not there, or
/// damage.
[[nodiscard]] std::string why_unreadable(hid_t set, const std::string& name);

/// Bytes of the file in which an object lies.
[[nodiscard]] hsize_t file_bytes(hid_t object);

}  // namespace vortree::io::h5
