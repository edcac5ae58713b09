#include <catch2/catch.hpp>

#include "neighbors/methods.hpp"
#include "sph/solver/scene.hpp"

using namespace vortree;
using namespace vortree::sph;
using namespace vortree::sph::test;

namespace {

SphScene by(neighbors::SearchMethod method, double skin) {
  SphScene scene = small_scene();
  scene.set("method", method).set("skin", skin).choose();
  return scene;
}

}  // namespace

TEST_CASE("a flow has the same bits by every method of neighbors and with any skin") {
  const auto plain = small_flow();
  advance(*plain, 2);
  for (const auto& maker : neighbors::makers()) {
    CAPTURE(maker.name());
    const auto other = by(maker.method, 0).begin();
    advance(*other, 2);
    check_same(Told(*other), Told(*plain));
  }
  for (const double skin : {0.2, 0.8, 2.0}) {
    CAPTURE(skin);
    const auto other = by(neighbors::SearchMethod::qcg, skin).begin();
    advance(*other, 2);
    check_same(Told(*other), Told(*plain));
  }
}

TEST_CASE("a flow whose lists are kept is resumed to the same bits, from any step") {
  const SphScene scene = by(neighbors::SearchMethod::linked_list, 1);
  const auto whole = scene.begin();
  for (int step = 0; step < 3; ++step) {
    flow::State state;
    whole->save(state);
    const auto half = scene.begin();
    half->restore(whole->steps(), whole->columns(), state);
    CAPTURE(step);
    check_same(Told(*half), Told(*whole));
    advance(*half, 1), advance(*whole, 1);
    check_same(Told(*half), Told(*whole));
  }
}
