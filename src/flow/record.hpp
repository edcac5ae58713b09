#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "flow/flow_case.hpp"

namespace vortree::flow {

/// What a run measures after each step, as columns of report.csv.
///
/// t, T           time, and U t/R (t where there is no body)
/// blobs          how many
/// circulation    of blobs, those that have left, and body; stays 0 for an impulsive start
/// impulse_x, _y  of blobs and sheet, per unit density
/// second_moment  sum gamma (|X - O|^2 + sigma^2), O the body's centre, or that of the initial
///                vorticity as the stream carries it
/// cd_*, cl_*     drag and lift by the rate of change of impulse, and by the wall sheet (pressure)
///                with the wall vorticity (friction); 0 without a body
/// bubble_length  in diameters; separation_deg from the rear; 0 where a body plunges
/// quadrupole_*, separation, circulation_plus, plus_*   the form of free vorticity, plus is the part
///                that turns anticlockwise (vortex/blobs/moments.hpp); 0 with a body
/// seconds        since the start; then by phase, of this step
struct Record {
  double t = 0, T = 0, blobs = 0, circulation = 0, impulse_x = 0, impulse_y = 0, second_moment = 0,
         cd_impulse = 0, cd_wall = 0, cl_impulse = 0, cl_wall = 0, bubble_length = 0,
         separation_deg = 0, quadrupole_xx = 0, quadrupole_xy = 0, separation = 0,
         circulation_plus = 0, plus_x = 0, plus_y = 0, seconds = 0, seconds_convect = 0,
         seconds_wall = 0, seconds_split = 0, seconds_merge = 0, seconds_output = 0;
  // Behind the columns: forces per unit density, before they become coefficients.
  double pressure_x = 0, pressure_y = 0, friction_x = 0, friction_y = 0;

  static constexpr std::size_t columns = 25, numbers = 29;
  std::array<double, numbers> values() const;
  static Record from(std::span<const double> values);
  static std::vector<std::string> names();  ///< of the columns
};

/// All that can be said of the flow at once; forces by impulse need the neighbors in time.
Record measure(long step, const vortex::Blobs& blobs, const vortex::Wake& wake,
               const FlowCase& flow);

/// Records that wait for the next one, since a force is a rate of change:
///
///   C_D(t_n) = 2/(U^2 D) F_n,   P = (-sum gamma y, sum gamma x),
///                               F by impulse = dP/dt
///                               F by the wall = d/dt(what pressure has given) + friction at t_n
///
/// by the parabola in sqrt(t) through three records, the last record of a run by that which fits
/// the last four best (rate_of_change.hpp), O(dt^2). To a body that plunges both add its area times
/// its acceleration, since they are forces in its own frame (body/motion.hpp).
class History {
 public:
  using Write = std::function<void(const Record&)>;

  explicit History(const FlowCase& flow) : flow_(flow) {}

  void add(const Record& record, const Write& write);
  void finish(const Write& write);

  /// The waiting records, for a checkpoint.
  std::vector<double> saved() const;
  void restore(std::span<const double> values);

 private:
  static constexpr std::size_t most = 4;

  const FlowCase& flow_;
  std::vector<Record> recent_;  // the oldest first
};

}  // namespace vortree::flow
