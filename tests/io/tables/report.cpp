#include "io/tables/report.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "io/sandbox.hpp"
#include "io/tables/table.hpp"

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

TEST_CASE("a resumed report equals one that was never broken off, wherever it was cut") {
  const Sandbox box;
  const auto path = box / "report.csv";
  std::vector<TableMark> marks;
  {
    Report report(path, columns);
    marks.push_back(report.mark());
    for (int step = 0; step <= 5; ++step) {
      add(report, 0.1 * step);
      marks.push_back(report.mark());
    }
  }
  const std::string whole = text_of(path);
  const std::size_t from = GENERATE(0, 1, 3, 6);
  for (std::size_t cut = 0; cut <= whole.size(); ++cut) {
    box.write("report.csv", whole.substr(0, cut));
    auto report = Report::resume(path, columns, marks[from]);
    REQUIRE(report.has_value() == (cut >= marks[from].bytes));
    if (!report) continue;
    for (std::size_t step = from; step <= 5; ++step) {
      add(*report, 0.1 * static_cast<double>(step));
    }
    REQUIRE(text_of(path) == whole);
    CHECK(report->mark() == marks.back());
  }
}

TEST_CASE("a report whose rows are missing, doubled, shuffled or altered does not go on") {
  const Sandbox box;
  const auto path = box / "report.csv";
  const std::string header = "t,T,blobs\n", a = "0,0,0\n", b = "0.5,1,500000\n", c = "1,2,1e+06\n";
  std::vector<double> rows;
  TableMark mark;
  {
    Report report(path, columns);
    for (const double t : {0.0, 0.5, 1.0}) add(report, t);
    rows = report.take_rows();
    CHECK(report.take_rows().empty());
    mark = report.mark();
  }
  REQUIRE(text_of(path) == header + a + b + "1,2,1000000\n");
  CHECK(mark.rows == 3);
  CHECK(mark_of_rows(columns, rows) == mark);
  const std::string last = "1,2,1000000\n";
  for (const std::string& text :
       {std::string(), header, header + a + last, header + a + b + b + last, header + b + a + last,
        header + a + b + "1,2,1000001\n", header + a + b + c, a + b + last, header + a + b + "\n\n",
        header + a + b + last.substr(0, 11) + " ", header + "0,0,0 " + b + last}) {
    CAPTURE(text);
    box.write("report.csv", text);
    CHECK_FALSE(Report::resume(path, columns, mark));
    CHECK(text_of(path) == text);
  }
  std::filesystem::remove(path);
  CHECK_FALSE(Report::resume(path, columns, mark));
  CHECK(Report(path, columns, rows).mark() == mark);
  CHECK(text_of(path) == header + a + b + last);
}

TEST_CASE("a mark comes back from numbers, to the last bit") {
  const TableMark mark{.rows = 7, .bytes = 1ULL << 40, .checksum = 0xfedcba9876543211ULL};
  CHECK(mark_of(as_numbers(mark)) == mark);
  CHECK_FALSE(mark_of(std::vector<double>{1, 2, 3}));
  CHECK_FALSE(mark_of(std::vector<double>{1, 2, std::nan(""), 3}));
}

TEST_CASE("a report that someone removes, replaces or changes meanwhile says so at once") {
  const Sandbox box;
  const auto path = box / "report.csv";
  Report report(path, columns);
  add(report, 0.5);
  SECTION("removed") {
    std::filesystem::remove(path);
  }
  SECTION("replaced") {
    std::filesystem::rename(box.write("other.csv", text_of(path)), path);
  }
  SECTION("emptied") {
    box.write("report.csv", "");
  }
  SECTION("lengthened") {
    std::ofstream(path, std::ios::app) << "1,2,3\n";
  }
  CHECK_THROWS_WITH(add(report, 1), Catch::Matchers::Contains("by someone else"));
  CHECK_THROWS_WITH(report.force(), Catch::Matchers::Contains("by someone else"));
}

TEST_CASE("a report does not go on under other columns") {
  const Sandbox box;
  const auto path = box.write("report.csv", "t,speed\n0,1\n");
  TableMark mark;
  for (const char* line : {"t,speed", "0,1"}) mark.add(line);
  CHECK(refusal([&] { (void)Report::resume(path, columns, mark); }) ==
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
