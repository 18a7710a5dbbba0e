#include "view_launcher.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "command.h"
#include "messages.h"
#include "view_summary.h"

namespace scatter::app {

namespace fs = std::filesystem;

ExitStatus becomeWindow(std::vector<std::string> words) {
  std::error_code error;
  const std::string window =
      (fs::read_symlink("/proc/self/exe", error).parent_path() / kViewProgram).string();
  std::vector<char*> argv{const_cast<char*>(window.c_str())};
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  execv(window.c_str(), argv.data());
  if (errno == ENOENT) {
    printError("the window is not built: there is no " + window +
               "; ./run view builds it, and of Debian packages scatter-view has it");
  } else {
    printError("cannot start " + window + ": " + std::strerror(errno));
  }
  return ExitStatus::kBadInput;
}

Command addViewLauncher(CLI::App& program, std::vector<std::string> words) {
  CLI::App* command = program.add_subcommand(kViewName, kViewSummary);
  command->footer("scatter view --help shows what it takes.");
  return {command, [words = std::move(words)] { return becomeWindow(words); }, true};
}

}  // namespace scatter::app
