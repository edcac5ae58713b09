#include "base/rounded.hpp"

#include <catch2/catch.hpp>
#include <string>

using namespace vortree;

TEST_CASE("a number is told by so many digits, and on that side of itself that is asked for") {
  CHECK(rounded(39.614427315745644, 3) == "39.6");
  CHECK(rounded_down(0.0745356, 2) == "0.074");
  CHECK(rounded_up(0.0745356, 2) == "0.075");
  CHECK(rounded_down(1234, 2) == "1.2e+03");
  CHECK(rounded_up(0.999, 2) == "1");
  // What has no more digits stays, though its double lies on either side of it.
  for (const double value : {0.2, 0.3, 0.7, 0.03, 1.1, 4.0, 123.0, 1e-300, 1e300}) {
    const std::string told = rounded(value, 3);
    CAPTURE(value);
    CHECK(rounded_down(value, 3) == told);
    CHECK(rounded_up(value, 3) == told);
  }
}
