#include <catch2/catch.hpp>
#include <cmath>

#include "checks/made_up.hpp"
#include "exact/kirchhoff_ellipse.hpp"
#include "exact/vortex_pairs.hpp"

using namespace vortree;
using namespace vortree::test;

namespace {

using Words = std::vector<std::string>;

std::string scene_of(const std::string& kind, const std::string& more = "") {
  return "[flow]\nnu = 1e-4\n[cores]\nsigma_0 = 0.1\nsigma_max = 0.2\n[time]\ndt = 0.1\nend = 10\n"
         "[initial]\nkind = \"" +
         kind + "\"\ncirculation = 2.0\ncore = 0.3\n" + more;
}

}  // namespace

TEST_CASE("the field of a lone vortex is the exact one, or not") {
  for (const char* check : {"vorticity_max", "velocity_max"}) {
    MadeUpRun run(scene_of("lamb_oseen"),
                  {"flow.nu=0", "check.exact=lamb_oseen", std::string("check.") + check + "=0.02"});
    vortex::Blobs blobs = run.blobs();
    CAPTURE(check);
    CHECK(run.verdict(3, blobs).passed());
    for (double& gamma : blobs.gamma) gamma *= 1.04;
    CHECK(run.verdict(3, blobs).missed());
    CHECK(*run.verdict(3, blobs).reached.value == Approx(0.04).epsilon(0.1));
  }
}

TEST_CASE("what free space keeps is kept, or not; opposite vortices have a scale of their own") {
  MadeUpRun circulation(scene_of("lamb_oseen"), {"check.circulation_max=0.01"});
  circulation.with("circulation", 2.0);
  CHECK(circulation.verdict(20).passed());
  CHECK(circulation.with("circulation", [](double t) { return 2 + 0.1 * t; }).verdict(20).missed());

  MadeUpRun impulse(scene_of("lamb_oseen"), {"check.impulse_max=0.01"});
  impulse.with("circulation", 2.0).with("impulse_x", 3.0);
  CHECK(impulse.verdict(20).passed());
  CHECK(impulse.with("impulse_y", [](double t) { return 0.01 * t; }).verdict(20).missed());
  CHECK(*impulse.verdict(20).reached.value == Approx(0.019 / (2.0 * 0.3)));

  MadeUpRun second(scene_of("lamb_oseen"), {"check.second_moment_max=0.01"});
  second.with("circulation", 2.0).with("second_moment", [](double t) {
    return 0.5 + 4e-4 * 2 * t;
  });
  CHECK(*second.verdict(20).reached.value < 1e-12);
  CHECK(second.with("second_moment", 0.5).verdict(200).missed());

  MadeUpRun dipole(scene_of("dipole", "separation = 2.0\n"), {"check.second_moment_max=0.01"});
  dipole.with("circulation_plus", 2.0).with("second_moment", [](double t) {
    return 1e-17 * std::sin(t);
  });
  CHECK(dipole.verdict(20).passed());
  CHECK(dipole.with("second_moment", [](double t) { return 0.1 * t; }).verdict(20).missed());
}

TEST_CASE("the count of blobs stays within what is asked, or not") {
  MadeUpRun run(scene_of("lamb_oseen"), {"check.blobs_max=100"});
  CHECK(run.with("blobs", 100).verdict(5).passed());
  CHECK(run.with("blobs", [](double t) { return t > 0.25 && t < 0.35 ? 101 : 5; })
            .verdict(5)
            .missed());
}

TEST_CASE("an ellipse turns at Kirchhoff's rate, or not") {
  MadeUpRun run(scene_of("kirchhoff_ellipse", "core_across = 0.15\n"),
                {"check.exact=kirchhoff_ellipse", "check.rotation_max=0.02"});
  const double rate = exact::KirchhoffEllipse{2.0, 0.3, 0.15}.rate();
  const auto turning = [&](double factor) {
    return run.with("quadrupole_xx", [=](double t) { return std::cos(2 * factor * rate * t); })
        .with("quadrupole_xy", [=](double t) { return std::sin(2 * factor * rate * t); })
        .verdict(50);
  };
  CHECK(*turning(1).reached.value < 1e-9);
  CHECK(turning(1.01).passed());
  CHECK(turning(0.97).missed());
  CHECK_FALSE(run.verdict(1).reached.value);
}

TEST_CASE(
    "a pair merges when its cores are a known share of its distance; too early, late or never") {
  MadeUpRun run(
      scene_of("corotating_pair", "separation = 2.0\n"),
      {"check.exact=corotating_pair", "check.merger_max=0.02", "flow.nu=0.01", "time.end=100"});
  // The core is 0.22 of 2 at 0.3^2 + 0.04 t = 0.44^2.
  const double onset = (0.44 * 0.44 - 0.09) / 0.04;
  const auto merging = [&](double at) -> MadeUpRun& {
    return run.with("separation", [=](double t) { return t < at ? 2.0 : 1.97; });
  };
  CHECK(merging(onset).verdict(100).passed());
  CHECK(merging(0.5).verdict(100).missed());
  CHECK(merging(2 * onset).verdict(100).missed());
  CHECK_FALSE(merging(1000).verdict(20).reached.value);  // not yet
  CHECK(merging(1000).verdict(100).missed());            // it should have
}

TEST_CASE("a dipole travels as fast as it should from the first row to the last, or not") {
  MadeUpRun run(scene_of("dipole", "separation = 2.0\n"),
                {"check.exact=dipole", "check.speed_max=0.01"});
  const exact::VortexPair pair{2.0, 0.3, 2.0, 1e-4};
  const auto moving = [&](double factor) -> MadeUpRun& {
    return run.with("plus_y", [=](double t) { return factor * pair.travelled(t); });
  };
  CHECK(*moving(1).verdict(3).reached.value < 1e-9);
  CHECK(moving(-1).verdict(30).passed());
  CHECK(moving(1.02).verdict(30).missed());
  CHECK_FALSE(run.verdict(1).reached.value);
}

TEST_CASE("moments are held against a reference at its times within the run, from four rows on") {
  std::string reference = "t,quadrupole_xx,quadrupole_xy,separation\n";
  for (double t = 0; t < 5; t += 0.5)
    reference += fmt::format("{},{},{},{}\n", t, std::cos(t), std::sin(t), 1 + t);
  const auto run = [&](const std::string& check) {
    return MadeUpRun(scene_of("lamb_oseen"),
                     {"check.moments_reference=known.csv", "check." + check + "=0.02"},
                     {{"known.csv", reference}});
  };
  MadeUpRun quadrupole = run("quadrupole_max"), separation = run("separation_max");
  const auto turned = [&](double size, double by) {
    return quadrupole.with("quadrupole_xx", [=](double t) { return size * std::cos(t + by); })
        .with("quadrupole_xy", [=](double t) { return size * std::sin(t + by); })
        .verdict(40);
  };
  CHECK(*turned(1, 0).reached.value < 1e-4);
  CHECK(turned(1.01, 0).passed());
  CHECK(turned(1.05, 0).missed());
  CHECK(turned(1, 0.05).missed());
  CHECK(turned(NAN, 0).missed());
  CHECK(quadrupole.verdict(3).reached.why == "the run ends at T = 0.3");
  CHECK(separation.with("separation", [](double t) { return 1 + t; }).verdict(20).passed());
  CHECK(separation.with("separation", [](double t) { return 1.1 + t; }).verdict(20).missed());
}

TEST_CASE("energy falls as enstrophy and viscosity have it, or not") {
  const auto run = [](double share) {
    std::string table = "t,energy,enstrophy\n";
    for (double t = 0; t < 2; t += 0.1)
      table += fmt::format("{},{},{}\n", t, 0.5 - share * 0.01 * 3 * t, 3);
    return MadeUpRun(scene_of("lamb_oseen"), {"flow.nu=0.01", "check.energy_max=0.01"},
                     {{"energy.csv", table}})
        .verdict(20);
  };
  CHECK(*run(1).reached.value < 1e-12);
  CHECK(run(0.5).missed());
  CHECK(run(NAN).missed());
  CHECK_FALSE(MadeUpRun(scene_of("lamb_oseen"), {"check.energy_max=0.01"},
                        {{"energy.csv", "t,energy,enstrophy\n0,1,1\n"}})
                  .verdict(20)
                  .reached.value);
}
