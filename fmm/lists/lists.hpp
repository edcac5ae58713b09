#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "fmm/geometry/deep_tree.hpp"
#include "tree/base/memory.hpp"

namespace vortree::fmm {

/// No cell.
inline constexpr std::int32_t nobody = -1;

/// Rows of cell numbers, one after the other.
class CellRows {
 public:
  struct Entry {
    std::uint32_t row, cell;
  };

  CellRows() = default;
  /// Entries of a row keep their order, those of one part before those of the next.
  CellRows(std::size_t rows, std::span<const std::span<const Entry>> parts);

  [[nodiscard]] std::span<const std::uint32_t> operator[](std::size_t row) const {
    return std::span(cells_).subspan(first_[row], first_[row + 1] - first_[row]);
  }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(std::uint32_t) * (cells_.capacity() + first_.capacity());
  }

 private:
  Unwritten<std::uint32_t> first_{0}, cells_;
};

/// Who meets whom, and how: the lists of Carrier, Greengard & Rokhlin. With c, b cells of the same
/// tree, b childless,
///
///   U(b)   childless cells that touch b, b itself too      point by point
///   V(c)   children of the colleagues of c's parent that do not touch c        M2L
///   X(c)   childless cells that touch c's parent but not c, none finer than it      P2L
///   W(b)   the cells c with b in X(c)      M2P
///
/// All are read off one table: the nine neighbors of every cell (its colleagues, or where there is
/// none, the coarser childless cell that covers the place), each found from the parent's nine.
///
/// A childless cell of few points meets its X point by point, too: then both belong to each other's
/// U. And two families may refuse to meet by V (and a cell and a childless one by X and W) because
/// a core still shows; then all points of the two are summed one by one.
///
/// source   Carrier, Greengard & Rokhlin, SIAM J. Sci. Stat. Comput. 9 (1988)
class InteractionLists {
 public:
  using Neighbors = std::array<std::int32_t, 9>;
  static constexpr int middle = 4;

  /// True if series serve between two cells that are at least `gap` apart. Symmetric.
  using Hidden = std::function<bool(std::uint32_t a, std::uint32_t b, double gap)>;

  InteractionLists() = default;

  /// few       childless cells of fewer points meet their X point by point
  /// hidden    empty: always
  /// cost      O(cells)
  InteractionLists(const DeepTree& tree, std::uint32_t few, const Hidden& hidden);

  /// The neighbor of c at (dx, dy), each -1 .. 1: entry 3 (dy + 1) + dx + 1. At the middle c
  /// itself, or nobody if an ancestor refuses itself.
  [[nodiscard]] const Neighbors& neighbors(std::uint32_t c) const { return neighbors_[c]; }
  /// The children of c by quadrant, nobody where none is.
  [[nodiscard]] const std::array<std::int32_t, 4>& children(std::uint32_t c) const {
    return children_[c];
  }
  /// May the children of c meet those of its neighbor k by V? True only where both have children.
  [[nodiscard]] bool open(std::uint32_t c, int k) const { return marks_[c] >> k & 1; }
  /// Numbers of the childless cells inside c, by rank in tree.childless().
  [[nodiscard]] tree::Range leaves(std::uint32_t c) const { return leaves_[c]; }

  /// X(c), without those met point by point.
  [[nodiscard]] std::span<const std::uint32_t> x(std::uint32_t c) const { return x_[c]; }
  /// W of the childless cell of a rank.
  [[nodiscard]] std::span<const std::uint32_t> w(std::uint32_t leaf) const { return w_[leaf]; }

  /// `use(cell)` for the members of U(b) but b that pass point by point with b once, both ways:
  /// each pair is said by the finer of the two, or of two equals by the one behind.
  template <class Use>
  void for_each_ahead(std::uint32_t b, Use use) const {
    for_each_near(b, middle + 1, use);
  }
  /// The other members of U(b) but b.
  template <class Use>
  void for_each_behind(std::uint32_t b, Use use) const {
    for (int k = 0; k < middle; ++k) {
      if (equal_leaf(b, neighbors_[b][k])) use(static_cast<std::uint32_t>(neighbors_[b][k]));
    }
    for (const std::uint32_t c : finer_[leaves_[b].first]) use(c);
  }
  /// Cells that refuse to meet c by series: its points and theirs are summed one by one. The other
  /// way is said in their own rows.
  [[nodiscard]] std::span<const std::uint32_t> refused(std::uint32_t c) const {
    return refused_[c];
  }

  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Found;

  void find_kin(const DeepTree& tree);
  void find_neighbors(const DeepTree& tree, const Hidden& hidden);
  void find_neighbors_of(const DeepTree& tree, std::uint32_t c);
  void find_meetings(const DeepTree& tree, std::uint32_t few, const Hidden& hidden);
  void look(const DeepTree& tree, std::uint32_t c, const Hidden& hidden, Found& found) const;

  [[nodiscard]] bool childless(std::int32_t c) const { return marks_[c] >> childless_bit & 1; }
  [[nodiscard]] bool equal_leaf(std::uint32_t b, std::int32_t a) const {
    return a != nobody && childless(a) && level_[a] == level_[b];
  }

  template <class Use>
  void for_each_near(std::uint32_t b, int first_equal, Use use) const {
    const Neighbors& near = neighbors_[b];
    for (int k = 0; k < 9; ++k) {
      const std::int32_t a = near[k];
      if (a == nobody || k == middle || !childless(a)) continue;
      if (level_[a] == level_[b]) {
        if (k >= first_equal) use(static_cast<std::uint32_t>(a));
      } else if (std::find(near.begin(), near.begin() + k, a) == near.begin() + k) {
        use(static_cast<std::uint32_t>(a));
      }
    }
    if (marks_[b] >> sparse_bit & 1) {
      for (const std::uint32_t a : x_met_[b]) use(a);
    }
  }

  static constexpr int childless_bit = 9, leafy_bit = 10, sparse_bit = 11;

  Unwritten<Neighbors> neighbors_;
  Unwritten<std::array<std::int32_t, 4>> children_;
  Unwritten<std::uint16_t> marks_;  // bits: open to neighbors 0 .. 8, and the above
  Unwritten<std::uint8_t> level_;
  Unwritten<tree::Range> leaves_;
  CellRows x_, w_;
  CellRows x_met_;  // X of sparse cells: met point by point
  CellRows finer_;  // by rank: members of U that are finer
  CellRows refused_;
};

}  // namespace vortree::fmm
