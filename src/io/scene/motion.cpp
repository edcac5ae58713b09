#include "io/scene/motion.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/keys.hpp"
#include "io/files.hpp"
#include "io/quote.hpp"
#include "io/tables/table.hpp"

namespace vortree::io {
namespace {

using body::Jets;

constexpr double radians = std::numbers::pi / 180;
constexpr int fewest_steps = 1 << 10, most_steps = 1 << 16;
constexpr double met_within = 1e-9;

/// An expression of t.
class Expression {
 public:
  Expression(std::string key, const std::string& text) : key_(std::move(key)), text_(text) {
    refuse_assignment();
    parser_.DefineVar("t", &t_);
    parser_.DefineConst("pi", std::numbers::pi);
    parser_.SetExpr(text);
    at(0);
    if (parser_.GetNumResults() != 1) refuse("one value was expected");
  }
  Expression(const Expression&) = delete;
  Expression& operator=(const Expression&) = delete;

  double at(double t) {
    t_ = t;
    double value = 0;
    try {
      value = parser_.Eval();
    } catch (const mu::ParserError& error) {
      refuse(understood(error));
    }
    if (!std::isfinite(value)) refuse(fmt::format("that is {} at t = {:.6g}", value, t));
    return value;
  }

 private:
  /// What muParser takes as one: it would set t.
  void refuse_assignment() const {
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const bool comparison =
          (i > 0 && std::string_view("=<>!").find(text_[i - 1]) != std::string_view::npos) ||
          text_.compare(i, 2, "==") == 0;
      if (text_[i] == '=' && !comparison) refuse("= sets nothing here; == compares");
    }
  }

  static std::string understood(const mu::ParserError& error) {
    std::string words = error.GetMsg();
    while (words.ends_with('.')) words.pop_back();
    return words + "; an expression of t was expected, as \"0.1*cos(2*pi*t)\"";
  }

  [[noreturn]] void refuse(const std::string& words) const {
    throw Refused(key_, fmt::format("{} is {}: {}", key_, quote(text_), words));
  }

  std::string key_, text_;
  double t_ = 0;
  mu::Parser parser_;
};

std::vector<double> values_of(Expression& expression, double end, int steps) {
  std::vector<double> values;
  for (int i = 0; i <= steps; ++i) values.push_back(expression.at(end * i / steps));
  return values;
}

/// Of what is known at even steps, how far from the expression it is between them.
double missed(Expression& expression, const Jets& known, double end, double largest) {
  const int steps = static_cast<int>(known.value.size()) - 1;
  const double h = end / steps;
  double most = 0;
  for (int i = 0; i < steps; ++i) {
    const double middle = (known.value[i] + known.value[i + 1]) / 2 +
                          5 * h / 32 * (known.first[i] - known.first[i + 1]) +
                          h * h / 64 * (known.second[i] + known.second[i + 1]);
    most = std::max(most, std::abs(middle - expression.at(end * (i + 0.5) / steps)));
  }
  return largest > 0 ? most / largest : 0;
}

double largest_of(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values) most = std::max(most, std::abs(value));
  return most;
}

/// How many even steps one expression asks for.
int steps_for(Expression& expression, double end) {
  for (int steps = fewest_steps; steps < most_steps; steps *= 2) {
    std::vector<double> values = values_of(expression, end, steps);
    const double largest = largest_of(values);
    const Jets known = body::known_evenly(std::move(values), end / steps);
    if (missed(expression, known, end, largest) <= met_within) return steps;
  }
  return most_steps;
}

Jets scaled(Jets jets, double by) {
  for (auto* column : {&jets.value, &jets.first, &jets.second})
    for (double& value : *column) value *= by;
  return jets;
}

body::Course by_expressions(const body::MotionSettings& motion, double end) {
  std::optional<Expression> parts[3];
  int steps = fewest_steps, k = 0;
  for (const auto& [key, text] : {std::pair{"motion.x", motion.x}, std::pair{"motion.y", motion.y},
                                  std::pair{"motion.angle", motion.angle}}) {
    parts[k].emplace(key, text.value_or("0"));
    steps = std::max(steps, steps_for(*parts[k++], end));
  }
  std::array<Jets, 3> of;
  for (int i = 0; i < 3; ++i)
    of[i] = scaled(body::known_evenly(values_of(*parts[i], end, steps), end / steps),
                   i == 2 ? radians : 1);
  std::vector<double> times;
  for (int i = 0; i <= steps; ++i) times.push_back(end * i / steps);
  return {std::move(times), std::move(of), {motion.about[0], motion.about[1]}};
}

/// The rows of a file, which reach from the start to the end.
void refuse_times(const std::vector<double>& t, double end, const std::string& file) {
  const auto refuse = [&](const std::string& words) {
    throw Refused("motion.file", fmt::format("motion.file = {}: {}", quote(file), words));
  };
  if (t.size() < 4) refuse(fmt::format("it has {} rows; a spline needs at least 4", t.size()));
  for (std::size_t i = 0; i < t.size(); ++i)
    if (!std::isfinite(t[i]) || (i > 0 && !(t[i] > t[i - 1])))
      refuse(fmt::format("t of row {} is {}; times that ascend were expected", i + 1, t[i]));
  if (t.front() > 0) refuse(fmt::format("it begins at t = {}; the run begins at 0", t.front()));
  if (t.back() < end * (1 - 1e-9))
    refuse(fmt::format("it ends at t = {}; the run ends at time.end = {}", t.back(), end));
}

std::vector<double> coordinate(const Table& table, std::string_view name, const std::string& file) {
  if (!table.has(name)) return std::vector<double>(table.rows());
  std::vector<double> values = table.column(name);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw Refused("motion.file", fmt::format("motion.file = {}: {} of row {} is {}", quote(file),
                                               name, i + 1, values[i]));
  return values;
}

body::Course by_file(const body::MotionSettings& motion, double end,
                     const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / *motion.file;
  require_regular_file(path);
  const Table table(path);
  if (!table.has("x") && !table.has("y") && !table.has("angle"))
    throw Refused("motion.file", fmt::format("motion.file = {}: it has none of the columns x, y, "
                                             "angle",
                                             quote(*motion.file)));
  std::vector<double> t = table.column("t");
  refuse_times(t, end, *motion.file);
  const auto known = [&](std::string_view name) {
    return body::spline_through(t, coordinate(table, name, *motion.file));
  };
  std::array<Jets, 3> of{known("x"), known("y"), scaled(known("angle"), radians)};
  return {std::move(t), std::move(of), {motion.about[0], motion.about[1]}};
}

}  // namespace

void complete_motion(body::MotionSettings& motion, double end,
                     const std::filesystem::path& folder) {
  if (!motion.given_by_time()) return;
  motion.course = motion.file ? by_file(motion, end, folder) : by_expressions(motion, end);
}

}  // namespace vortree::io
