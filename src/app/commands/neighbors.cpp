#include "app/commands/neighbors.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "app/commands/sums/origin.hpp"
#include "app/json.hpp"
#include "base/clock.hpp"
#include "base/free_memory.hpp"
#include "base/memory.hpp"
#include "io/files.hpp"
#include "io/tables/particles.hpp"
#include "io/while_reading.hpp"
#include "neighbors/methods.hpp"
#include "tree/cells/home_cells.hpp"
#include "tree/neighbors/crossing_pairs.hpp"

namespace vortree::app {
namespace {

struct Laps {
  std::vector<double> tree, search, total;
};

void search(neighbors::NeighborMethod& method, const neighbors::NeighborJob& job,
            const tree::PeriodicBox& box, tree::PairList& rows, Laps& laps) {
  Stopwatch watch;
  watch.begin("tree");
  method.build(job);
  std::optional<tree::CrossingPairs> crossing;
  if (box.periodic()) crossing.emplace(job.points, job.reach, box);
  watch.begin("search");
  method.search(job, rows);
  if (crossing) crossing->add_to(job.rule, job.listing, rows);
  watch.end();
  laps.tree.push_back(watch.seconds("tree"));
  laps.search.push_back(watch.seconds("search"));
  laps.total.push_back(watch.seconds("tree") + watch.seconds("search"));
}

// 64-bit counts, 32-bit numbers of particles.
io::ParticleFile read_particles(const NeighborsJob& job) {
  const io::WhileReading reading(job.in);
  const auto need = job.reach ? io::Need::optional : io::Need::required;
  auto particles = io::read_particles(job.in, {.reach = need});
  if (job.reach) particles.reach.assign(particles.x.size(), *job.reach);
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
  if (particles.x.size() > most) {
    throw io::InputError(fmt::format("{}: {} particles; at most {} can be listed", job.in.string(),
                                     particles.x.size(), most));
  }
  // Once for all methods.
  try {
    tree::check_particles({particles.x, particles.y}, particles.reach);
    tree::check_inside(job.box, {particles.x, particles.y});
  } catch (const std::invalid_argument& refused) {
    throw io::InputError(fmt::format("{}: {}", job.in.string(), refused.what()));
  }
  return particles;
}

// That a particle takes beyond those of its method if it is near an edge of the box, as all may be:
// a place in a second tree, and in a second list.
constexpr std::size_t crossing_bytes = 100, copied_bytes = sizeof(std::int32_t);

// How many pairs the free memory holds. Who asks the system for more than that is killed without a
// word.
//
// throws  std::runtime_error with numbers, if it does not even hold the particles
std::int64_t room_for_pairs(const NeighborsJob& job, const neighbors::NeighborMaker& maker,
                            std::size_t n, std::uint64_t free) {
  const bool box = job.box.periodic();
  const std::uint64_t taken = n * (maker.particle_bytes + (box ? crossing_bytes : 0));
  if (taken > free) {
    throw std::runtime_error(fmt::format(
        "{}: the neighbors of {} particles take {:.3g} GB besides their pairs; {:.3g} GB are free",
        job.in.string(), n, 1e-9 * static_cast<double>(taken), 1e-9 * static_cast<double>(free)));
  }
  return static_cast<std::int64_t>(std::min<std::uint64_t>(
      (free - taken) / (maker.pair_bytes + (box ? copied_bytes : 0)), INT64_MAX));
}

// throws  std::runtime_error with numbers, if there are more pairs than memory holds
Laps search(const NeighborsJob& job, const neighbors::NeighborMaker& maker,
            const neighbors::NeighborJob& asked, tree::PairList& rows) {
  const auto method = maker.make();
  Laps laps;
  const std::uint64_t free = free_memory();
  rows.most = room_for_pairs(job, maker, asked.points.size(), free);
  try {
    for (int k = 0; k < job.repeat; ++k) search(*method, asked, job.box, rows, laps);
  } catch (const std::length_error& refused) {
    throw std::runtime_error(fmt::format("{}: {}; {:.3g} GB of memory were free", job.in.string(),
                                         refused.what(), 1e-9 * static_cast<double>(free)));
  }
  return laps;
}

std::string_view name_of(tree::PairRule rule) {
  constexpr std::array<std::string_view, 3> names{"max", "mean", "own"};
  return names[static_cast<std::size_t>(rule)];
}

io::Attributes attributes_of(const NeighborsJob& job, std::size_t particles) {
  io::Attributes about = origin_of(job.said, job.in, particles);
  about.emplace_back("method", job.method);
  about.emplace_back("rule", std::string(name_of(job.rule)));
  about.emplace_back("half", std::int64_t{job.half});
  if (job.box.periodic()) {
    about.emplace_back("period_x", job.box.x);
    about.emplace_back("period_y", job.box.y);
  }
  return about;
}

// A line for each entry.
void write_pairs(const NeighborsJob& job, const tree::PairList& rows) {
  std::vector<std::int32_t> particle(rows.index.size());
  for (std::size_t i = 0; i + 1 < rows.start.size(); ++i)
    std::fill(particle.begin() + rows.start[i], particle.begin() + rows.start[i + 1],
              static_cast<std::int32_t>(i));
  const std::array columns{io::ParticleColumn{"i", std::span<const std::int32_t>(particle)},
                           io::ParticleColumn{"j", rows.index.span()}};
  io::write_columns(job.out, columns);
}

void write_rows(const NeighborsJob& job, const tree::PairList& rows) {
  if (io::format_of(job.out) == io::ParticleFormat::csv) return write_pairs(job, rows);
  const std::array columns{io::ParticleColumn{"start", rows.start.span()},
                           io::ParticleColumn{"index", rows.index.span()}};
  io::write_columns(job.out, columns, attributes_of(job, rows.start.size() - 1));
}

}  // namespace

std::vector<std::string> neighbor_methods() {
  std::vector<std::string> names;
  for (const neighbors::NeighborMaker& maker : neighbors::makers()) {
    names.emplace_back(maker.name());
  }
  return names;
}

std::string neighbors(const NeighborsJob& job) {
  if (job.half && job.rule == tree::PairRule::own) {
    throw std::invalid_argument("--half lists each pair once, but rule own is not symmetric");
  }
  const neighbors::NeighborMaker& maker = neighbors::maker_of(job.method);
  Stopwatch files;
  files.begin("io");
  io::require_writable_format(job.out);
  io::require_writable(job.out, std::array{io::file_behind(job.in)});
  const io::ParticleFile particles = read_particles(job);
  files.end();

  const auto listing = job.half ? tree::Listing::once : tree::Listing::both_ways;
  const neighbors::NeighborJob asked{
      {particles.x, particles.y}, particles.reach, job.rule, listing};
  tree::PairList rows;
  const Laps laps = search(job, maker, asked, rows);

  files.begin("io");
  write_rows(job, rows);
  files.end();

  Json report;
  report["n"] = particles.x.size();
  report["method"] = job.method;
  report["builder"] = job.method == "qcg"             ? Json("reverse")
                      : job.method == "leaf-quadtree" ? Json("forward")
                                                      : Json();
  report["threads"] = omp_get_max_threads();
  report["rule"] = name_of(job.rule);
  report["half"] = job.half;
  if (job.box.periodic()) report["periodic"] = {job.box.x, job.box.y};
  report["pairs"] = rows.index.size();
  report["peak_bytes"] = peak_bytes();
  report["seconds"]["tree"] = median(laps.tree);
  report["seconds"]["search"] = median(laps.search);
  report["seconds"]["total"] = median(laps.total);
  report["seconds"]["io"] = files.seconds("io");
  return report.dump();
}

}  // namespace vortree::app
