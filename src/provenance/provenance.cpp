#include "provenance/provenance.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace vortree {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos)
        return line.substr(colon + 2);
  return "unknown processor";
}

std::string system_name() {
  utsname name{};
  return uname(&name) == 0 ? std::string(name.sysname) + " " + name.release : "unknown system";
}

// The commit of the sources, with -dirty if they were changed since; "unknown" outside a checkout.
std::string commit() {
  const std::string line =
      "git -C '" VORTREE_SOURCE_DIR "' describe --always --dirty --abbrev=12 2>/dev/null";
  std::string said;
  if (FILE* answer = popen(line.c_str(), "r")) {
    char word[128];
    if (std::fgets(word, sizeof word, answer)) said = word;
    pclose(answer);
  }
  while (!said.empty() && said.back() == '\n') said.pop_back();
  return said.empty() ? "unknown" : said;
}

std::string now() {
  const std::time_t time = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
  return text;
}

std::string load() {
  double averages[1] = {};
  if (getloadavg(averages, 1) != 1) return "unknown";
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", averages[0]);
  return text;
}

}  // namespace

std::vector<std::string> provenance() {
  return {"machine: " + processor() + ", " + std::to_string(sysconf(_SC_NPROCESSORS_ONLN)) +
              " cores, " + system_name(),
          "compiler: g++ " __VERSION__,
          "flags: " VORTREE_FLAGS,
          "commit: " + commit(),
          "load: " + load() + " before the first measurement",
          "date: " + now()};
}

}  // namespace vortree
