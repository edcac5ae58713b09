#include "io/tables/table.hpp"

#include "input.hpp"

using namespace vortree;

// A reference file, whose first column is asked for, then one that may be there.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::Folder folder;
  const auto path = folder.with("table.csv", data, size);
  fuzz::expect_answer([&] {
    const io::Table table(path);
    if (table.has("T") && table.has("C_D") &&
        table.column("T").size() != table.column("C_D").size()) {
      fuzz::fail("columns of unequal lengths");
    }
    (void)table.column("no column of that name");
  });
  return 0;
}
