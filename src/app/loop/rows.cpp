#include "app/loop/rows.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace vortree::app {
namespace {

const std::string rows_known = "rows known";

std::string saved_name(const std::string& column) {
  return "row " + column;
}

}  // namespace

Rows::Rows(const flow::Solver& solver, const flow::Scales& scales)
    : solver_(solver),
      scales_(scales),
      forces_(scales),
      on_each_(solver.forces_on_each().size(), flow::ForceHistory(scales)) {}

std::vector<std::string> Rows::phases() const {
  std::vector<std::string> list = solver_.phases();
  list.push_back("output");
  return list;
}

std::vector<std::string> Rows::seconds_names() const {
  std::vector<std::string> list{"seconds"};
  for (const std::string& phase : phases()) list.push_back("seconds_" + phase);
  return list;
}

std::vector<std::string> Rows::names() const {
  std::vector<std::string> list{"t", "T"};
  for (const flow::Measures& some : {solver_.measures(), no_force()})
    for (const flow::Measure& one : some) list.push_back(one.name);
  for (const std::string& name : seconds_names()) list.push_back(name);
  return list;
}

flow::Measures Rows::no_force() const {
  const flow::Measures one = flow::ForceHistory::none(solver_.force().has_value());
  flow::Measures all = one;
  for (std::size_t k = 0; k < on_each_.size(); ++k)
    std::ranges::move(flow::ForceHistory::of_body(one, k + 1), std::back_inserter(all));
  return all;
}

/// The coefficients of all forces, at the last or the last but one.
flow::Measures Rows::told(flow::Measures (flow::ForceHistory::*of)() const) const {
  if (forces_.size() == 0) return no_force();
  flow::Measures all = (forces_.*of)();
  for (std::size_t k = 0; k < on_each_.size(); ++k)
    std::ranges::move(flow::ForceHistory::of_body((on_each_[k].*of)(), k + 1),
                      std::back_inserter(all));
  return all;
}

Rows::Row Rows::now(std::vector<double> seconds) const {
  return {solver_.time(), solver_.measures(), std::move(seconds)};
}

std::vector<double> Rows::whole(const Row& row, const flow::Measures& coefficients) const {
  std::vector<double> values{row.t, scales_.T(row.t)};
  for (const flow::Measure& one : row.measures) values.push_back(one.value);
  for (const flow::Measure& one : coefficients) values.push_back(one.value);
  values.insert(values.end(), row.seconds.begin(), row.seconds.end());
  return values;
}

void Rows::add(const std::vector<double>& seconds, const Write& write) {
  const Row before = std::exchange(waiting_, now(seconds));
  known_ = std::min(known_ + 1, 3);
  const auto force = solver_.force();
  if (force) forces_.add(*force);
  const std::vector<flow::Force> each = solver_.forces_on_each();
  for (std::size_t k = 0; k < each.size(); ++k) on_each_[k].add(each[k]);
  if (known_ == 3) write(whole(before, told(&flow::ForceHistory::of_last_but_one)));
}

void Rows::finish(const Write& write) const {
  if (known_ < 2) return;
  write(whole(waiting_, told(&flow::ForceHistory::of_last)));
}

void Rows::save(flow::State& state) const {
  state[rows_known] = {static_cast<double>(known_)};
  const std::vector<std::string> names = seconds_names();
  for (std::size_t k = 0; k < names.size(); ++k)
    state[saved_name(names[k])] = {waiting_.seconds[k]};
  forces_.save(state);
  for (std::size_t k = 0; k < on_each_.size(); ++k)
    on_each_[k].save(state, flow::ForceHistory::named(k));
}

void Rows::restore(const flow::State& state) {
  known_ = static_cast<int>(flow::saved_number(state, rows_known));
  std::vector<double> seconds;
  for (const std::string& name : seconds_names())
    seconds.push_back(flow::saved_number(state, saved_name(name)));
  waiting_ = now(std::move(seconds));
  forces_.restore(state);
  for (std::size_t k = 0; k < on_each_.size(); ++k)
    on_each_[k].restore(state, flow::ForceHistory::named(k));
}

}  // namespace vortree::app
