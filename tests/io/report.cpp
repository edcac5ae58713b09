#include "io/report.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "io/json.hpp"
#include "io/table.hpp"
#include "sandbox.hpp"

using namespace vortree::io;

namespace {

const std::vector<std::string> columns{"t", "T", "blobs"};

void add(Report& report, double t) {
  report.row(std::vector<double>{t, 2 * t, 1e6 * t});
}

}  // namespace

TEST_CASE("a report reads back to the same doubles") {
  const Sandbox box;
  const std::vector<double> hard{0.1, 1.0 / 3, -1e-308, 4.9e-324, 1.7976931348623157e308, -0.0};
  {
    Report report(box / "report.csv", {"a", "b", "c", "d", "e", "f"});
    report.row(hard);
  }
  const Table table(box / "report.csv");
  REQUIRE(table.rows() == 1);
  CHECK(table.names() == std::vector<std::string>{"a", "b", "c", "d", "e", "f"});
  for (std::size_t i = 0; i < hard.size(); ++i) {
    const double value = table.column(table.names()[i])[0];
    CHECK(std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(hard[i]));
  }
}

TEST_CASE("every row of a report is in the file as soon as it is written") {
  const Sandbox box;
  Report report(box / "report.csv", columns);
  CHECK(text_of(box / "report.csv") == "t,T,blobs\n");
  add(report, 0.5);
  CHECK(text_of(box / "report.csv") == "t,T,blobs\n0.5,1,500000\n");
}

TEST_CASE("a resumed report equals one that was never broken off") {
  const Sandbox box;
  const auto path = box / "report.csv";
  std::string whole;
  {
    Report report(path, columns);
    for (int step = 0; step <= 5; ++step) add(report, 0.1 * step);
    whole = text_of(path);
  }
  const std::size_t cut = GENERATE(0, 5, 9, 10, 11, 13, 20, 35, 1000);
  const int kept = GENERATE(-1, 0, 2, 5);
  box.write("report.csv", whole.substr(0, cut));
  // The frame resumed from is never later than the rows that were written after it.
  const std::string lines = whole.substr(0, whole.substr(0, cut).rfind('\n') + 1);
  const auto ends = static_cast<int>(std::count(lines.begin(), lines.end(), '\n'));
  const int written = std::max(ends, 1) - 2;  // the last row; -1 if there is but the header
  const int from = std::min(kept, written);
  Report report = Report::resume(path, columns, 0.1 * from);
  for (int step = from + 1; step <= 5; ++step) add(report, 0.1 * step);
  CHECK(text_of(path) == whole);
}

TEST_CASE("a report does not go on under other columns") {
  const Sandbox box;
  const auto path = box.write("report.csv", "t,speed\n0,1\n");
  CHECK(refusal([&] { (void)Report::resume(path, columns, 1); }) ==
        path.string() + ":1: the columns are t,speed; a report with t,T,blobs cannot go on there");
  CHECK(text_of(path) == "t,speed\n0,1\n");
}

TEST_CASE("a report refuses a row of the wrong length and a folder that is not there") {
  const Sandbox box;
  Report report(box / "report.csv", columns);
  CHECK_THROWS_AS(report.row(std::vector<double>{1, 2}), std::invalid_argument);
  const auto nowhere = box / "none/report.csv";
  CHECK(refusal([&] { Report(nowhere, columns); }) ==
        nowhere.string() + " cannot be written in the folder " + nowhere.parent_path().string() +
            ": No such file or directory");
}

TEST_CASE("a table is numbers under names, whatever stands around them") {
  const Sandbox box;
  const Table table(
      box.write("a.csv", "# made by hand\n\n T , C_D\r\n0.1, 1.5\n# more\n 2 ,\n3,nan"));
  CHECK(table.rows() == 3);
  CHECK(table.has("C_D"));
  CHECK_FALSE(table.has("C"));
  CHECK(table.column("T") == std::vector<double>{0.1, 2, 3});
  CHECK(table.column("C_D")[0] == 1.5);
  CHECK(std::isnan(table.column("C_D")[1]));
  CHECK(std::isnan(table.column("C_D")[2]));
}

TEST_CASE("a broken table is refused with its line") {
  const Sandbox box;
  const auto read = [&](std::string_view text) {
    const auto path = box.write("a.csv", text);
    const std::string sentence = refusal([&] { (void)Table(path).column("T"); });
    return sentence.substr(path.string().size());
  };
  CHECK(read("") == " is empty; a line of column names was expected");
  CHECK(read("# only words\n") == " is empty; a line of column names was expected");
  CHECK(read("T,C\n1,2\n3\n") == ":3: 1 cells; 2 columns were expected");
  CHECK(read("T,C\n1,2x\n") == ":2: C is \"2x\"; a number was expected");
  CHECK(read("t,C\n1,2\n") == ": there is no column T; the file has t, C");
  CHECK(refusal([&] { (void)Table(box / "none.csv"); }) ==
        (box / "none.csv").string() + ": no such file");
}

TEST_CASE("JSON keeps the order in which it was told, on a line and on a page") {
  Json json;
  json["n"] = 1000;
  json["method"] = "boxes \"quoted\" \\ \n";
  json["seconds"]["tree"] = 0.1;
  json["seconds"]["total"] = 1e-7;
  json["error"] = std::numeric_limits<double>::quiet_NaN();
  json["steps"] = Json::array({1, Json::array({}), true});
  json["nothing"];
  json["n"] = std::uint64_t{18446744073709551615u};
  CHECK(json.line() ==
        R"({"n": 18446744073709551615, "method": "boxes \"quoted\" \\ \u000a", )"
        R"("seconds": {"tree": 0.1, "total": 1e-07}, "error": null, "steps": [1, [], true], )"
        R"("nothing": null})");
  const Sandbox box;
  Json small;
  small["a"] = Json::array({1, 2});
  small["b"]["c"] = false;
  write_json(box / "summary.json", small);
  CHECK(text_of(box / "summary.json") == R"({
  "a": [
    1,
    2
  ],
  "b": {
    "c": false
  }
}
)");
  CHECK_THROWS_AS(small["b"]["c"]["d"], std::logic_error);
}
