#include "fmm/adaptive/far_field.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "fmm/losses/expected.hpp"
#include "fmm/series/expansion_kernel.hpp"
#include "fmm/series/lattice_order.hpp"
#include "tree/base/parallel.hpp"

namespace vortree::fmm {
namespace {

constexpr int places = 36;  // children of nine families

/// Points as they come: gamma is null for targets.
struct LeafPoints {
  const double *x, *y, *gamma;
  std::size_t size;
};

LeafPoints points_of(const Leaves& leaves, std::uint32_t leaf) {
  const std::uint32_t first = leaves.start[leaf];
  return {&leaves.points.x[first], &leaves.points.y[first], &leaves.gamma[first],
          leaves.size[leaf]};
}

/// `use(points, first)` for some of the points at a time, in the frame of a cell.
template <class Number, class Use>
void in_frame(const LeafPoints& some, const CellFrame& frame, Use use) {
  LatticePoints<Number> points;
  constexpr int n = LatticePoints<Number>::n;
  const double per_side = 1 / frame.side;
  for (std::size_t first = 0; first < some.size; first += points_a_series) {
    points.size = static_cast<int>(std::min<std::size_t>(some.size - first, points_a_series));
    points.vectors = (points.size + n - 1) / n;
    const double *x = some.x + first, *y = some.y + first;
    const int whole = static_cast<int>(padded(static_cast<std::size_t>(points.size)));
    for (int j = 0; j < whole; ++j) {
      points.x[j] = static_cast<Number>(((x[j] - frame.x) - frame.x_rest) * per_side);
      points.y[j] = static_cast<Number>(((y[j] - frame.y) - frame.y_rest) * per_side);
      points.gamma[j] = static_cast<Number>(some.gamma == nullptr ? 0.0 : some.gamma[first + j]);
    }
    for (int j = whole; j < points.vectors * n; ++j) {
      points.x[j] = points.x[whole - 1], points.y[j] = points.y[whole - 1], points.gamma[j] = 0;
    }
    use(points, first);
  }
}

}  // namespace

/// A vector of families of one level, their series side by side.
template <class Number>
struct FarField<Number>::Families {
  static constexpr int lanes = VectorOf<Number>::count;
  using Complexes = ComplexLanes<Number>;
  using Room = Unwritten<Complexes>;

  explicit Families(int order, int padded)
      : series(static_cast<std::size_t>((places + 1) * padded)),
        child(static_cast<std::size_t>(padded)),
        parent(static_cast<std::size_t>(padded)),
        work(static_cast<std::size_t>(4 * order)),
        nothing(2 * static_cast<std::size_t>(padded), 0),
        zero(static_cast<std::size_t>(padded)) {
    std::ranges::fill(zero, Complexes{});
    std::ranges::fill(child, Complexes{});
    std::ranges::fill(parent, Complexes{});
  }

  const std::uint32_t* parents = nullptr;
  int size = 0;
  Room series, child, parent, work;
  std::vector<Number> nothing;  // the series of a cell that is not there
  Room zero;                    // the same, side by side
};

template <class Number>
FarField<Number>::FarField(const Stage& stage, TranslationTables<Number> tables)
    : tables_(std::move(tables)),
      padded_(static_cast<int>(
          padded(static_cast<std::size_t>(tables_.order), VectorOf<Number>::count))) {
  const auto cells = stage.tree.cells();
  multipoles_.resize(cells.size() * stride());
  charges_.resize(cells.size());
  charge_weights_.resize(static_cast<std::size_t>(padded_), 0);
  for (int k = 0; k < std::min(tables_.order, LatticeOrder::most_known); ++k) {
    charge_weights_[k] = static_cast<Number>(1 / mean_power(k));
  }
  const auto childless = stage.tree.childless();
  tree::share_evenly(tree::all_of(childless.size()), childless.size() > tree::series_worth_sharing,
                     [&](std::uint32_t leaf) { add_points(stage, childless[leaf]); });
  Families spare(tables_.order, padded_);
  for (int level = stage.tree.depth() - 1; level >= 0; --level) {
    for_each_batch(stage, level, tree::upward_worth_sharing, spare,
                   [&](Families& families) { add_children(stage, families); });
  }
}

/// `use(families)` for all parents of a level, a vector of them at a time; of one thread in the
/// spare room.
template <class Number>
template <class Use>
void FarField<Number>::for_each_batch(const Stage& stage, int level, std::size_t worth_sharing,
                                      Families& spare, const Use& use) {
  constexpr std::size_t lanes = Families::lanes;
  const tree::Range range = stage.tree.level(level);
  std::vector<std::uint32_t> parents;
  for (std::uint32_t c = range.first; c < range.last; ++c) {
    if (!stage.tree.cells()[c].childless()) parents.push_back(c);
  }
  const std::size_t batches = (parents.size() + lanes - 1) / lanes;
  const auto take = [&](std::uint32_t b, Families& families) {
    families.parents = &parents[b * lanes];
    families.size = static_cast<int>(std::min(lanes, parents.size() - b * lanes));
    use(families);
  };
  if (batches <= worth_sharing) {
    for (std::uint32_t b = 0; b < batches; ++b) take(b, spare);
  } else {
    tree::share_in_turn(
        tree::all_of(batches), 1, true, [&] { return Families(tables_.order, padded_); }, take);
  }
}

template <class Number>
void FarField<Number>::add_points(const Stage& stage, std::uint32_t cell) {
  Number* series = multipole(cell);
  std::fill_n(series, stride(), Number{0});
  const CellFrame& at = stage.tree.frame(cell);
  in_frame<Number>(points_of(stage.leaves, stage.lists.leaves(cell).first), at,
                   [&](const LatticePoints<Number>& points, std::size_t) {
                     by_rows<LatticePoints<Number>::n>(points.vectors, [&]<int rows>(int i) {
                       p2m_rows<Number, rows>(points.x + i, points.y + i, points.gamma + i, padded_,
                                              series);
                     });
                   });
  const tree::Range places = stage.leaves.places(stage.lists.leaves(cell));
  charges_[cell].squares =
      sum_of_squares(std::span(stage.leaves.gamma).subspan(places.first, places.size()));
  set_effective_charge(cell);
}

template <class Number>
void FarField<Number>::set_effective_charge(std::uint32_t cell) {
  const Number* re = multipole(cell);
  charges_[cell].effective = effective_charge(re, re + padded_, charge_weights_.data(), padded_);
}

template <class Number>
void FarField<Number>::add_children(const Stage& stage, Families& families) {
  constexpr int lanes = Families::lanes;
  std::ranges::fill(families.parent, ComplexLanes<Number>{});
  Number* to[lanes] = {};
  for (int i = 0; i < families.size; ++i) to[i] = multipole(families.parents[i]);
  for (int q = 0; q < 4; ++q) {
    const Number* from[lanes];
    for (int i = 0; i < lanes; ++i) {
      const std::int32_t child =
          i < families.size ? stage.lists.children(families.parents[i])[q] : nobody;
      from[i] = child == nobody ? families.nothing.data() : multipole(child);
    }
    gather_series<Number>(from, padded_, families.child.data());
    add_child<Number>(tables_, q, families.child.data(), families.work.data(),
                      families.parent.data());
  }
  scatter_series<Number>(families.parent.data(), padded_, to);
  for (int i = 0; i < families.size; ++i) {
    const std::uint32_t parent = families.parents[i];
    const tree::Range children = stage.tree.cells()[parent].children;
    for (std::uint32_t k = children.first; k < children.last; ++k) {
      charges_[parent].squares += charges_[k].squares;
    }
    set_effective_charge(parent);
  }
}

template <class Number>
void FarField<Number>::descend(const Stage& stage) {
  locals_.resize(stage.tree.cells().size() * stride());
  std::fill_n(locals_.begin(), std::min(stride(), locals_.size()), Number{0});
  Families spare(tables_.order, padded_);
  for (int level = 0; level < stage.tree.depth(); ++level) {
    for_each_batch(stage, level, tree::downward_worth_sharing, spare,
                   [&](Families& families) { meet_families(stage, families); });
    const tree::Range below = stage.tree.level(level + 1);
    tree::share_in_turn(below, 64, below.size() > tree::series_worth_sharing,
                        [&](std::uint32_t c) { add_far(stage, c); });
  }
}

template <class Number>
void FarField<Number>::meet_families(const Stage& stage, Families& families) {
  constexpr int lanes = Families::lanes;
  const InteractionLists& lists = stage.lists;
  const Number* from[lanes];
  bool present[places];
  for (int place = 0; place < places; ++place) {
    const int near = place / 4, quadrant = place % 4;
    present[place] = false;
    for (int i = 0; i < lanes; ++i) {
      from[i] = families.nothing.data();
      if (i >= families.size || !lists.open(families.parents[i], near)) continue;
      const std::int32_t family = lists.neighbors(families.parents[i])[near];
      const std::int32_t child = lists.children(family)[quadrant];
      if (child == nobody) continue;
      from[i] = multipole(child);
      present[place] = true;
    }
    if (present[place]) {
      gather_series<Number>(from, padded_, families.series.data() + place * padded_);
    }
  }
  for (int i = 0; i < lanes; ++i) {
    from[i] = i < families.size ? local(families.parents[i]) : families.nothing.data();
  }
  gather_series<Number>(from, padded_, families.parent.data());
  for (int q = 0; q < 4; ++q) {
    Number* to[lanes];
    bool any = false;
    for (int i = 0; i < lanes; ++i) {
      const std::int32_t child =
          i < families.size ? lists.children(families.parents[i])[q] : nobody;
      to[i] = child == nobody ? nullptr : local(child);
      any = any || to[i] != nullptr;
    }
    if (!any) continue;
    shift_to_child<Number>(tables_, q, families.parent.data(), families.work.data(),
                           families.child.data());
    for (int o = 0; o < orbit_count; ++o) {
      const ComplexLanes<Number>* sources[4];
      bool some = false;
      for (int m = 0; m < 4; ++m) {
        const int place = orbit_places[q][o][m];
        const bool there = place >= 0 && present[place];
        sources[m] = there ? families.series.data() + place * padded_ : families.zero.data();
        some = some || there;
      }
      if (some) {
        add_orbit<Number>(tables_, o, sources, families.work.data(), families.child.data());
      }
    }
    scatter_series<Number>(families.child.data(), padded_, to);
  }
}

template <class Number>
void FarField<Number>::add_far(const Stage& stage, std::uint32_t cell) {
  const auto far = stage.lists.x(cell);
  if (far.empty()) return;
  const CellFrame& at = stage.tree.frame(cell);
  for (const std::uint32_t b : far) {
    in_frame<Number>(points_of(stage.leaves, stage.lists.leaves(b).first), at,
                     [&](const LatticePoints<Number>& points, std::size_t) {
                       by_rows<LatticePoints<Number>::n>(points.vectors, [&]<int rows>(int i) {
                         p2l_rows<Number, rows>(points.x + i, points.y + i, points.gamma + i,
                                                padded_, local(cell));
                       });
                     });
  }
}

namespace {

/// `rows_of` adds side f in lengths of the cell at some vectors of targets.
template <class Number, class RowsOf>
void add_at(const CellFrame& frame, const NearTargets& targets, RowsOf rows_of) {
  constexpr int n = LatticePoints<Number>::n;
  const double per_side = 1 / frame.side;
  in_frame<Number>({targets.x, targets.y, nullptr, targets.size}, frame,
                   [&](const LatticePoints<Number>& points, std::size_t first) {
                     alignas(64) Number u[points_a_series], v[points_a_series];
                     std::fill_n(u, n * points.vectors, Number{0});
                     std::fill_n(v, n * points.vectors, Number{0});
                     by_rows<n>(points.vectors, [&]<int rows>(int i) {
                       rows_of.template operator()<rows>(points.x + i, points.y + i, u + i, v + i);
                     });
                     for (int j = 0; j < points.size; ++j) {
                       targets.u[first + j] += static_cast<double>(u[j]) * per_side;
                       targets.v[first + j] += static_cast<double>(v[j]) * per_side;
                     }
                   });
}

}  // namespace

template <class Number>
void FarField<Number>::l2p(const Stage& stage, std::uint32_t cell,
                           const NearTargets& targets) const {
  add_at<Number>(stage.tree.frame(cell), targets,
                 [&]<int rows>(const Number* x, const Number* y, Number* u, Number* v) {
                   l2p_rows<Number, rows>(local(cell), padded_, tables_.order, x, y, u, v);
                 });
}

template <class Number>
void FarField<Number>::m2p(const Stage& stage, std::uint32_t cell,
                           const NearTargets& targets) const {
  add_at<Number>(stage.tree.frame(cell), targets,
                 [&]<int rows>(const Number* x, const Number* y, Number* u, Number* v) {
                   m2p_rows<Number, rows>(multipole(cell), padded_, tables_.order, x, y, u, v);
                 });
}

template class FarField<double>;
template class FarField<float>;

}  // namespace vortree::fmm
