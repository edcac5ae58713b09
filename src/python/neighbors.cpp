#include "tree/neighbors/neighbors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/free_memory.hpp"
#include "python/bind.hpp"
#include "python/columns.hpp"
#include "python/unlocked.hpp"
#include "python/words.hpp"
#include "tree/base/parallel.hpp"
#include "tree/neighbors/ball_search.hpp"
#include "tree/neighbors/crossing_pairs.hpp"

namespace vortree::python {
namespace {

namespace py = pybind11;
using tree::PairList;

constexpr std::array<std::string_view, 3> rule_words{"max", "mean", "own"};

/// Particles as they were placed, by their numbers.
struct PlacesByNumber {
  std::vector<double> x, y;

  explicit PlacesByNumber(const tree::SortedParticles& placed) : x(placed.size), y(placed.size) {
    for (std::size_t k = 0; k < placed.size; ++k) {
      const auto i = static_cast<std::size_t>(placed.id[k]);
      x[i] = placed.x[k], y[i] = placed.y[k];
    }
  }
};

/// sqrt(dx dx + dy dy), of lengths of any size.
double distance_of(double dx, double dy) {
  const double square = dx * dx + dy * dy;
  if (square >= tree::least_square && square <= tree::largest_square) return std::sqrt(square);
  return std::hypot(dx, dy);
}

/// How many pairs of so many bytes the free memory holds, which is asked only if all of all could
/// be many: who takes more than there is is killed without a word.
std::int64_t room_for_pairs(std::size_t rows, std::size_t points, std::size_t bytes_a_pair) {
  constexpr std::size_t few = std::size_t{1} << 24;
  if (points == 0 || rows < few / points) return std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(free_memory() / bytes_a_pair);
}

tree::Buffer<double> distances_of(const PairList& rows, const PlacesByNumber& at,
                                  const tree::PeriodicBox& box) {
  const double period_x = tree::period_of(box.x), period_y = tree::period_of(box.y);
  tree::Buffer<double> distance;
  distance.renew(rows.index.size());
  const auto write = [&](std::uint32_t i) {
    for (std::int64_t k = rows.start[i]; k < rows.start[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(rows.index[static_cast<std::size_t>(k)]);
      distance[static_cast<std::size_t>(k)] =
          distance_of(tree::nearest_image(at.x[j] - at.x[i], period_x),
                      tree::nearest_image(at.y[j] - at.y[i], period_y));
    }
  };
  tree::share_evenly(tree::all_of(rows.size()), rows.size() > tree::worth_sharing, write);
  return distance;
}

// Rows of two numbers, the smaller first.
tree::Buffer<std::int64_t> pairs_of(const PairList& rows) {
  tree::Buffer<std::int64_t> pairs;
  pairs.renew(2 * rows.index.size());
  std::int64_t* to = pairs.data();
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const std::int64_t j : rows.row(i)) {
      const auto own = static_cast<std::int64_t>(i);
      *to++ = std::min(own, j), *to++ = std::max(own, j);
    }
  return pairs;
}

/// A search that several threads of Python may ask: one after the other, for it uses its memory
/// again.
class SharedSearch {
 public:
  SharedSearch(const NumpyReals& x, const NumpyReals& y, const NumpyReals& reach, double period_x,
               double period_y, int threads)
      : box_{period_x, period_y} {
    place(x, y, reach, threads);
  }

  void place(const NumpyReals& x, const NumpyReals& y, const NumpyReals& reach, int threads) {
    const tree::Points points{values_of(x), values_of(y)};
    const auto reaches = values_of(reach);
    unlocked(threads, [&] {
      const std::lock_guard alone(mutex_);
      std::optional<tree::CrossingPairs> crossing;
      if (box_.periodic()) crossing.emplace(points, reaches, box_);
      search_.place(points, reaches);
      crossing_ = std::move(crossing);
      balls_.reset();
    });
  }

  py::tuple rows(std::string_view rule, bool half, bool distances, int threads) {
    PairList rows;
    tree::Buffer<double> distance;
    const auto listing = half ? tree::Listing::once : tree::Listing::both_ways;
    const std::size_t bytes = bytes_listed + (distances ? sizeof(double) : 0);
    list(rule, listing, bytes, threads, [&](PairList found) {
      if (distances) distance = distances_of(found, PlacesByNumber(search_.placed()), box_);
      rows = std::move(found);
    });
    return py::make_tuple(owning(std::move(rows.start)), owning(std::move(rows.index)),
                          owning(std::move(distance)));
  }

  py::array_t<std::int64_t> pairs(std::string_view rule, int threads) {
    tree::Buffer<std::int64_t> pairs;
    list(rule, tree::Listing::once, bytes_listed + 2 * sizeof(std::int64_t), threads,
         [&](const PairList& found) { pairs = pairs_of(found); });
    return owning(std::move(pairs));
  }

  py::tuple balls(const NumpyReals& x, const NumpyReals& y, const NumpyReals& radius, int threads) {
    const tree::Points places{values_of(x), values_of(y)};
    const auto radii = values_of(radius);
    PairList rows;
    unlocked(threads, [&] {
      const std::lock_guard alone(mutex_);
      if (!balls_) {
        const PlacesByNumber points(search_.placed());
        balls_.emplace(tree::Points{points.x, points.y}, box_);
      }
      rows.most = room_for_pairs(places.size(), size(), bytes_found);
      balls_->list(places, radii, rows);
    });
    return py::make_tuple(owning(std::move(rows.start)), owning(std::move(rows.index)));
  }

  [[nodiscard]] std::size_t size() const { return search_.placed().size; }
  [[nodiscard]] std::size_t bytes() const { return search_.bytes(); }

 private:
  template <class Use>
  void list(std::string_view word, tree::Listing listing, std::size_t bytes_a_pair, int threads,
            const Use& use) {
    const auto rule = chosen<tree::PairRule>("rule", word, rule_words);
    unlocked(threads, [&] {
      const std::lock_guard alone(mutex_);
      PairList found;
      const std::size_t copied = box_.periodic() ? sizeof(std::int32_t) : 0;
      found.most = room_for_pairs(size(), size(), bytes_a_pair + copied);
      search_.list(rule, listing, found);
      if (crossing_) crossing_->add_to(rule, listing, found);
      use(std::move(found));
    });
  }

  // That a pair takes while it is sought and stored: its number, an eighth in hand and some bits;
  // of balls twice, and what a vector takes ahead.
  static constexpr std::size_t bytes_listed = 5, bytes_found = 12;

  std::mutex mutex_;
  tree::PeriodicBox box_;
  tree::Neighbors search_;
  std::optional<tree::CrossingPairs> crossing_;
  std::optional<tree::BallSearch> balls_;
};

}  // namespace

void bind_neighbors(py::module_& core) {
  py::class_<SharedSearch>(core, "Neighbors")
      .def(py::init<const NumpyReals&, const NumpyReals&, const NumpyReals&, double, double, int>())
      .def("place", &SharedSearch::place)
      .def("rows", &SharedSearch::rows)
      .def("pairs", &SharedSearch::pairs)
      .def("balls", &SharedSearch::balls)
      .def_property_readonly("size", &SharedSearch::size)
      .def_property_readonly("nbytes", &SharedSearch::bytes);
}

}  // namespace vortree::python
