#include "app/commands/plot.hpp"

#include "app/folder/older_run.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "io/input_error.hpp"

namespace vortree::app {

void plot_folder(const std::string& folder, std::span<const std::string> formats) {
  if (lacks_outline(folder))
    say("warning: {}/outline.csv is missing: no figures of the flow around the body; vortree run "
        "with --resume makes it again",
        folder);
  if (!plot(folder, {}, formats))
    throw io::InputError(folder + ": nothing to draw; the folder of a run or a bench was expected");
}

}  // namespace vortree::app
