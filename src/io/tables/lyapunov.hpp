#pragma once

#include <filesystem>
#include <span>

#include "flow/paths/lyapunov.hpp"
#include "io/tables/particles.hpp"

namespace vortree::io {

/// Writes DIR/lyapunov.h5 and DIR/lyapunov.xdmf, which opens in ParaView; older ones are replaced
/// when the new one is whole.
///
/// A group `lyapunov_<time>` for each time at which tracers begin: the axes x and y and, row-major
/// [y][x], `forward` and `backward` [1/T], as far as there are fields of that time, nan where it is
/// not known; attributes time and, of these two, forward_to and backward_to.
///
/// fields  on one grid; of a time one forward and one backward at most
/// about   attributes of the root: where the numbers come from
/// throws  std::runtime_error if they cannot be written
void write_lyapunov(const std::filesystem::path& dir, std::span<const flow::LyapunovField> fields,
                    const Attributes& about);

}  // namespace vortree::io
