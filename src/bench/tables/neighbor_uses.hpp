#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string_view>

namespace vortree::bench {

/// What the lists are for, measured on the five-level cylinder: three tables beside neighbors.csv.
///
/// sph.csv     density and gradient by Wendland C6 through full list, half list and visitor:
///             seconds of search, density, gradient; relative L2 errors where supports are full,
///             against a density of one and the gradient of a smooth field
/// moving.csv  a step of moving particles, some of them splitting and merging: seconds of a search
///             with memory of the step before, of one from scratch, of a list with a skin (its
///             rebuilds shared among the steps it lasts)
/// cells.csv   Kollasch & Santoro's experiment: naive search and cells, in 2 and 3 dimensions
///
/// quick     fewer steps
/// largest   no set has more particles; 0: as many as it likes
void neighbor_uses(const std::filesystem::path& folder, bool quick, std::size_t largest,
                   const std::function<void(std::string_view)>& say);

}  // namespace vortree::bench
