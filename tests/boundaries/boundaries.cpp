#include <catch2/catch.hpp>

#include "boundaries/includes.hpp"

using vortree::test::Include;

namespace {

bool allowed(const std::string& file, const std::string& line) {
  const std::vector<Include> includes = vortree::test::includes_in(file, line);
  REQUIRE(includes.size() == 1);
  return vortree::test::objection(includes[0]).empty();
}

}  // namespace

TEST_CASE("includes flow with the stream") {
  int files = 0;
  const std::vector<std::string> objections =
      vortree::test::objections_below(VORTREE_SOURCE_DIR, files);
  for (const std::string& said : objections) UNSCOPED_INFO(said);
  CHECK(objections.empty());
  // A checker that looks into the wrong folder would find nothing wrong either.
  CHECK(files > 20);
}

TEST_CASE("an arrow against the stream is named with file, line and reason") {
  const auto includes = vortree::test::includes_in(
      "tree/build/quadtree.hpp",
      "#pragma once\n\n#include <vector>\n  #  include \"fmm/plan.hpp\"  // far\n");
  REQUIRE(includes.size() == 2);
  CHECK(vortree::test::objection(includes[0]) == "");
  CHECK(vortree::test::objection(includes[1]) ==
        "tree/build/quadtree.hpp:4: includes fmm/plan.hpp: tree must not depend on fmm");
}

TEST_CASE("an include in a comment is no include") {
  CHECK(vortree::test::includes_in("tree/a.hpp", "// #include \"fmm/plan.hpp\"\n").empty());
}

TEST_CASE("tree sees the standard library and itself") {
  CHECK(allowed("tree/a.cpp", "#include <vector>"));
  CHECK(allowed("tree/a.cpp", "#include \"tree/a.hpp\""));
  CHECK(allowed("tree/a.cpp", "#include \"a.hpp\""));
  CHECK_FALSE(allowed("tree/a.cpp", "#include \"vortex/blobs/blobs.hpp\""));
  CHECK_FALSE(allowed("tree/a.cpp", "#include <Eigen/Dense>"));
  CHECK_FALSE(allowed("tree/a.cpp", "#include <hdf5.h>"));
  CHECK_FALSE(allowed("tree/a.cpp", "#include \"../fmm/plan.hpp\""));
  CHECK_FALSE(allowed("tree/a.cpp", "#include <vortree/fmm/plan.hpp>"));
  CHECK_FALSE(allowed("tree/a.cpp", "#include \"src/io/scene/scene.hpp\""));
}

TEST_CASE("fmm sees the tree, and nothing above it") {
  CHECK(allowed("fmm/a.cpp", "#include \"tree/build/quadtree.hpp\""));
  CHECK(allowed("fmm/a.cpp", "#include <omp.h>"));
  CHECK_FALSE(allowed("fmm/a.cpp", "#include \"vortex/blobs/blobs.hpp\""));
  CHECK_FALSE(allowed("fmm/a.cpp", "#include <Eigen/Dense>"));
}

TEST_CASE("vortex and sph never see each other") {
  CHECK(allowed("src/vortex/a.cpp", "#include \"fmm/plan.hpp\""));
  CHECK(allowed("src/vortex/a.cpp", "#include \"body/shape.hpp\""));
  CHECK_FALSE(allowed("src/vortex/a.cpp", "#include \"exact/lamb_oseen.hpp\""));
  CHECK(allowed("src/vortex/a.cpp", "#include <Eigen/LU>"));
  CHECK(allowed("src/sph/a.cpp", "#include \"tree/build/quadtree.hpp\""));
  CHECK_FALSE(allowed("src/vortex/a.cpp", "#include \"sph/pairs/kernels.hpp\""));
  CHECK_FALSE(allowed("src/sph/a.cpp", "#include \"vortex/blobs/blobs.hpp\""));
  CHECK_FALSE(allowed("src/sph/a.cpp", "#include \"../vortex/blobs.hpp\""));
  CHECK(allowed("src/sph/a.cpp", "#include \"fmm/plan.hpp\""));
  CHECK_FALSE(allowed("src/sph/a.cpp", "#include \"io/files.hpp\""));
  CHECK_FALSE(allowed("src/vortex/a.cpp", "#include \"io/scene/scene.hpp\""));
  CHECK_FALSE(allowed("src/vortex/a.cpp", "#include <toml++/toml.h>"));
}

TEST_CASE("exact answers stand alone") {
  CHECK(allowed("src/exact/a.cpp", "#include <cmath>"));
  CHECK_FALSE(allowed("src/exact/a.cpp", "#include \"tree/order/points.hpp\""));
  CHECK_FALSE(allowed("src/exact/a.cpp", "#include \"vortex/blobs/blobs.hpp\""));
}

TEST_CASE("io knows no method, no program and no bench") {
  CHECK(allowed("src/io/a.cpp", "#include \"flow/method.hpp\""));
  CHECK_FALSE(allowed("src/io/a.cpp", "#include \"vortex/settings.hpp\""));
  CHECK_FALSE(allowed("src/flow/a.cpp", "#include \"vortex/settings.hpp\""));
  CHECK_FALSE(allowed("src/io/a.cpp", "#include \"vortex/blobs/blobs.hpp\""));
  CHECK(allowed("src/io/a.cpp", "#include <toml++/toml.h>"));
  CHECK_FALSE(allowed("src/io/a.cpp", "#include \"app/loop/run.hpp\""));
  CHECK_FALSE(allowed("src/io/a.cpp", "#include \"sph/pairs/kernels.hpp\""));
}

TEST_CASE("only commands and the bench itself include the bench") {
  CHECK(allowed("src/app/commands/a.cpp", "#include \"bench/trees.hpp\""));
  CHECK(allowed("src/bench/a.cpp", "#include \"bench/trees.hpp\""));
  for (const std::string part : {"tree", "fmm", "src/vortex", "src/sph", "src/exact", "src/io",
                                 "src/flow", "src/checks", "src/app", "src/app/loop"}) {
    CAPTURE(part);
    CHECK_FALSE(allowed(part + "/a.cpp", "#include \"bench/trees.hpp\""));
  }
}

TEST_CASE("FFTW stays out of everything that gets installed as a library") {
  CHECK(allowed("src/bench/a.cpp", "#include <fftw3.h>"));
  for (const std::string part : {"tree", "fmm", "src/vortex", "src/sph", "src/exact", "src/io"}) {
    CAPTURE(part);
    CHECK_FALSE(allowed(part + "/a.cpp", "#include <fftw3.h>"));
  }
}

TEST_CASE("a folder that nobody has spoken for is an objection") {
  CHECK_FALSE(allowed("src/novelty/a.cpp", "#include <vector>"));
  CHECK_FALSE(allowed("a.cpp", "#include <vector>"));
}
