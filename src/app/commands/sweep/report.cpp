#include "app/commands/sweep/report.hpp"

#include "app/commands/sweep/seconds.hpp"
#include "app/commands/sweep/table.hpp"
#include "app/plot.hpp"
#include "app/say.hpp"
#include "io/quote.hpp"

namespace vortree::app {

int report(const std::filesystem::path& folder, const SweepPlan& plan,
           std::span<const Member> members, std::span<const std::string> formats) {
  tell("{}{}", table(plan, members), seconds_to_errors(plan, members));
  plot(folder, "sweep", formats);
  tell("results in {}\n", io::printable(folder.string()));
  const std::string wrong = what_went_wrong(plan, members);
  if (!wrong.empty()) tell("{}\n", io::printable(wrong));
  return wrong.empty() ? 0 : 1;
}

}  // namespace vortree::app
