#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>
#include <vector>

#include "neighbors/exact_pairs.hpp"
#include "neighbors/row_by_row.hpp"
#include "tree/order/points.hpp"

// Compiled without fused operations: see tree/neighbors/pair_rule.hpp.
namespace vortree::neighbors {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using tree::PairRule;
using Place = bg::model::point<double, 2, bg::cs::cartesian>;
using BoostBox = bg::model::box<Place>;

// Neighbors are nearer than the reach along either axis, and rounding is monotone: no margin. No
// coordinate is beyond, and the packing takes means of sides.
BoostBox box_around(double x, double y, double reach) {
  const double r = std::min(reach, 4 * tree::largest_coordinate);
  return {{x - r, y - r}, {x + r, y + r}};
}

// One tree of places, for whom a particle reaches; one of boxes, for who reaches it.
class RTree : public RowByRow<RTree> {
 public:
  void build(const NeighborJob& job) override {
    std::vector<std::pair<Place, std::int32_t>> places;
    std::vector<std::pair<BoostBox, std::int32_t>> boxes;
    for (std::size_t i = 0; i < job.points.size(); ++i) {
      const double x = job.points.x[i], y = job.points.y[i];
      places.emplace_back(Place(x, y), static_cast<std::int32_t>(i));
      if (job.rule == PairRule::own) continue;
      boxes.emplace_back(box_around(x, y, job.reach[i]), static_cast<std::int32_t>(i));
    }
    places_ = decltype(places_)(places);
    boxes_ = decltype(boxes_)(boxes);
  }

  template <PairRule rule>
  void find(const NeighborJob& job, std::size_t i, std::vector<std::int32_t>& row) const {
    const Place here(job.points.x[i], job.points.y[i]);
    const BoostBox around = box_around(bg::get<0>(here), bg::get<1>(here), job.reach[i]);
    const auto take = [&](std::int32_t number) {
      const auto j = static_cast<std::size_t>(number);
      if (j == i || !is_pair<rule>(job, i, j)) return;
      if (job.listing == tree::Listing::both_ways || keeps(job, i, j)) row.push_back(number);
    };
    places_.query(bgi::intersects(around),
                  boost::make_function_output_iterator([&](const auto& at) { take(at.second); }));
    if constexpr (rule == PairRule::own) return;
    boxes_.query(bgi::intersects(here), boost::make_function_output_iterator([&](const auto& at) {
                   const auto j = static_cast<std::size_t>(at.second);
                   const Place there(job.points.x[j], job.points.y[j]);
                   if (!bg::intersects(there, around)) take(at.second);
                 }));
  }

 private:
  bgi::rtree<std::pair<Place, std::int32_t>, bgi::rstar<16>> places_;
  bgi::rtree<std::pair<BoostBox, std::int32_t>, bgi::rstar<16>> boxes_;
};

}  // namespace

std::unique_ptr<NeighborMethod> make_r_tree() {
  return std::make_unique<RTree>();
}

}  // namespace vortree::neighbors
