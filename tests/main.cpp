#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

// Digits after the point: a failed bound of 1e-15 is to be read beside what was found.
[[maybe_unused]] static const int digits = Catch::StringMaker<double>::precision = 20;
