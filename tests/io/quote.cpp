#include "io/quote.hpp"

#include <catch2/catch.hpp>

#include "io/utf8.hpp"

using vortree::io::first_not_utf8;
using vortree::io::printable;
using vortree::io::quote;
using vortree::io::shortened;

TEST_CASE("what a terminal would obey is shown, what it can show is left") {
  CHECK(printable("\x1b[31mred\x07") == "\\x1b[31mred\\x07");
  CHECK(printable("two\nlines\tand a tab") == "two lines and a tab");
  CHECK(printable("Gr\xc3\xb6\xc3\x9f\x65 \xe2\x86\x92 \xf0\x9f\x8c\x80") ==
        "Gr\xc3\xb6\xc3\x9f\x65 \xe2\x86\x92 \xf0\x9f\x8c\x80");
  CHECK(printable("\xc2\x9b"
                  "31m") == "\\xc2\\x9b31m");                // CSI in one character
  CHECK(printable("\xe2\x80\xae") == "\\xe2\\x80\\xae");     // from right to left
  CHECK(printable("gr\xfc\xdf\x65") == "gr\\xfc\\xdf\x65");  // Latin-1
  CHECK(printable(std::string_view("a\0b", 3)) == "a\\x00b");
  CHECK(printable("\xc3") == "\\xc3");
}

TEST_CASE("overlong, surrogate and too large characters are no UTF-8") {
  for (const char* text : {"\xc0\x80", "\xe0\x80\x80", "\xf0\x80\x80\x80", "\xed\xa0\x80",
                           "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\x80", "\xe2\x82"}) {
    CHECK(first_not_utf8(std::string("ab") + text) == 2u);
  }
  CHECK_FALSE(
      first_not_utf8("\xc2\x80\xdf\xbf\xe0\xa0\x80\xed\x9f\xbf\xee\x80\x80\xf4\x8f\xbf\xbf"));
}

TEST_CASE("a long text keeps its beginning, its end and its characters") {
  CHECK(shortened("short", 16) == "short");
  const std::string hundred = std::string(50, 'a') + std::string(50, 'z');
  CHECK(shortened(hundred, 100) == hundred);
  CHECK(shortened(hundred, 25) == "aaaaaaaaaa ... zzzzzzzzzz");
  std::string umlauts;
  for (int i = 0; i < 50; ++i) umlauts += "\xc3\xb6";
  for (std::size_t most = 16; most < 40; ++most) {
    const std::string text = shortened(umlauts, most);
    CHECK(text.size() <= most);
    CHECK_FALSE(first_not_utf8(text));
  }
}

TEST_CASE("between quotes nothing is left that harms a terminal or is no UTF-8") {
  CHECK(quote("tab\t \"\\") == "\"tab\\u0009 \\\"\\\\\"");
  CHECK(quote("\xc2\x9b \xe2\x80\xae \xfc") == "\"\\u009b \\u202e \\ufffd\"");
}
