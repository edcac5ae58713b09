#include "app/loop/threads.hpp"

#include <catch2/catch.hpp>

#include "app/program.hpp"

using vortree::app::SharedCores;
using namespace vortree::test;

namespace {

/// Seconds with all threads and with fewer, in looks of 0.1 s, where threads wait for such a share
/// of the time if all are there.
struct Share {
  double all = 0, fewer = 0;
};

Share run(SharedCores& cores, int most, double seconds, double waiting) {
  Share share;
  int threads = cores.threads(0, 0);
  for (double t = 0; t < seconds; t += 0.1) {
    (threads == most ? share.all : share.fewer) += 0.1;
    threads = cores.threads(0.1, threads == most ? 0.1 * most * waiting : 0);
  }
  return share;
}

}  // namespace

TEST_CASE("of more threads than processors could ever run there is a warning, and fewer") {
  const TemporaryFolder here;
  for (const std::string line : {"OMP_NUM_THREADS=100000 '" VORTREE_PROGRAM "' cases",
                                 "'" VORTREE_PROGRAM "' run lamb_oseen time.end=0.02 "
                                 "'output.fields=[]' --threads 4096"}) {
    const Outcome done = shell(line, here);
    CAPTURE(line, done.err);
    CHECK(done.code == 0);
    CHECK(done.err.find(" threads are wanted, of ") != std::string::npos);
  }
}

TEST_CASE("threads stay where nothing else runs, and where there is but one") {
  for (const int most : {1, 2, 8}) {
    SharedCores cores(most);
    CHECK(run(cores, most, 10, 0.05).fewer == 0);
  }
  SharedCores alone(1);
  CHECK(alone.threads(1, 0.9) == 1);
}

TEST_CASE("among other programs threads go, are tried ever more rarely, and come back with rest") {
  SharedCores cores(2);
  const Share first = run(cores, 2, 10, 0.4), later = run(cores, 2, 200, 0.4);
  CHECK(first.fewer > 0.9 * 10);
  CHECK(later.fewer > 0.99 * 200);
  CHECK(later.all > 0);
  const Share rest = run(cores, 2, 200, 0.01);
  CHECK(rest.all > 0.6 * 200);
  CHECK(run(cores, 2, 10, 0.01).fewer == 0);
  SharedCores many(8);
  CHECK(many.threads(0.1, 0.4) == 4);
}

namespace {

/// A report without the columns of what it took.
std::string flow_in(const fs::path& report) {
  std::istringstream lines(text_of(report));
  std::string line, kept, cell;
  std::vector<bool> is_flow;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (is_flow.size() == k) is_flow.push_back(!cell.starts_with("seconds"));
      if (is_flow[k]) kept += cell + ',';
    }
    kept += '\n';
  }
  return kept;
}

}  // namespace

TEST_CASE("a flow has the same bits however its threads wait, and how many there are") {
  const TemporaryFolder here;
  std::string first;
  for (const std::string way :
       {"OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1", "OMP_WAIT_POLICY=passive OMP_NUM_THREADS=2",
        "GOMP_SPINCOUNT=1000 OMP_NUM_THREADS=2"}) {
    const Outcome done =
        shell("env -u OMP_WAIT_POLICY " + way +
                  " '" VORTREE_PROGRAM
                  "' run cylinder_re550_quick time.end=0.3 'output.fields=[]' --out '" +
                  (here / "run").string() + "' --overwrite",
              here);
    CAPTURE(way, done.err);
    REQUIRE(done.code == 0);
    const std::string flow = flow_in(here / "run" / "report.csv");
    if (first.empty()) first = flow;
    CHECK(flow.size() > 1000);
    CHECK((flow == first));
  }
}
