#pragma once

#include <span>
#include <string>
#include <vector>

namespace vortree::checks {

/// Orders between neighbors of a sweep, p_i = log(e_i/e_{i-1})/log(h_i/h_{i-1}); NaN for the first,
/// and wherever a value or an error is not positive and finite, or two values or two errors agree.
///
/// h, e  a value of the swept key and an error for each run; as many of one as of the other
std::vector<double> orders(std::span<const double> h, std::span<const double> e);

/// The one order that fits all: the slope of log e against log h by least squares. NaN for fewer
/// than two usable pairs, and where all errors agree.
double fitted_order(std::span<const double> h, std::span<const double> e);

/// Columns of words set right-justified under their headings, two blanks apart, a line a row.
/// rows  each as long as `headings`
std::string text_table(std::span<const std::string> headings,
                       std::span<const std::vector<std::string>> rows);

}  // namespace vortree::checks
