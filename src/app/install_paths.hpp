#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vortree::app {

/// Version of the program, as `vortree --version` prints it.
std::string version();

/// The folder that holds cases/ and plots/: the environment's VORTREE_SHARE; else share/vortree
/// beside an installed program; else the source tree from which the program was built.
std::filesystem::path share_folder();

/// The scene files of cases/, sorted by name.
std::vector<std::filesystem::path> scene_files();

/// The scene file that the user means: a path, or the bare name of a case (`cylinder` for
/// cases/cylinder.toml).
///
/// throws  io::InputError that lists the cases, if it is neither
std::filesystem::path find_scene(const std::string& name);

/// The figure scripts plots/*.py whose names begin with `kind`, sorted by name; those that begin
/// with an underscore are parts of others, and a movie or a page is no figure.
std::vector<std::filesystem::path> plot_scripts(std::string_view kind = {});

/// The script that makes a movie.
std::filesystem::path movie_script();

/// The script that makes or serves a page.
std::filesystem::path view_script();

}  // namespace vortree::app
