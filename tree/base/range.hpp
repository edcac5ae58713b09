#pragma once

#include <cstdint>

namespace vortree::tree {

/// A half-open run [first, last) of points in Morton order, or of cells in level order.
struct Range {
  std::uint32_t first = 0, last = 0;
  [[nodiscard]] std::uint32_t size() const { return last - first; }
  [[nodiscard]] bool empty() const { return first == last; }
  bool operator==(const Range&) const = default;
};

}  // namespace vortree::tree
