#include "program.h"

#include <scatter/lab/environment.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

#include "interrupt.h"
#include "lab/text.h"
#include "messages.h"
#include "unknown_name.h"

namespace scatter::app {

namespace {

constexpr const char* kFooter =
    "\nscatter COMMAND --help shows what a command takes.\n"
    "Exit status: 0 done; 1 a run or a check failed, or the disk is full; 2 wrong\n"
    "usage or input; 130 interrupted.\n"
    "Models are looked for in the folders of $SCATTER_MODEL_PATH first, scene files\n"
    "in those of $SCATTER_SCENE_PATH.";

/// CLI11 does not break lines.
class TerminalFormatter final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* command, std::string name, CLI::AppFormatMode mode) const override {
    return lab::fitTerminal(CLI::Formatter::make_help(command, std::move(name), mode));
  }
};

std::string version() {
  const BuildInfo build = buildInfo();
  return fmt::format("scatter {} ({}, {})", build.version, build.buildType, build.compiler);
}

bool isOption(std::string_view argument) {
  return argument.size() > 1 && argument.front() == '-';
}

std::vector<std::string> commandNames(const CLI::App& program) {
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_lnames().empty()) {
      names.push_back("--" + option->get_lnames().front());
    }
  }
  return names;
}

// The command or command's command that the arguments name.
const CLI::App& innermost(const CLI::App& program) {
  const auto used = program.get_subcommands();
  return used.empty() ? program : innermost(*used.front());
}

// Such as "scatter bench spread".
std::string fullName(const CLI::App& command) {
  const CLI::App* above = command.get_parent();
  return above == nullptr ? "scatter" : fullName(*above) + " " + command.get_name();
}

// What is left over, said better than by the parser.
std::string describeLeftover(const CLI::App& program) {
  const CLI::App& command = innermost(program);
  for (const std::string& argument : program.remaining(true)) {
    if (isOption(argument)) {
      return unknownName("option", argument, optionNames(command));
    }
  }
  const std::string argument = program.remaining(true).front();
  const std::vector<std::string> below = commandNames(command);
  if (&command != &program && !below.empty()) {
    return unknownName(command.get_name() + " command", argument, below);
  }
  return "unexpected argument \"" + argument + "\"; see " + fullName(command) + " --help";
}

// Nothing if there is a command to execute.
std::optional<ExitStatus> parse(CLI::App& program, int argc, const char* const* argv) {
  const std::vector<std::string> commands = commandNames(program);
  if (argc < 2) {
    printError("a command is needed: " + fmt::format("{}", fmt::join(commands, ", ")) +
               "; see scatter --help");
    return ExitStatus::kBadInput;
  }
  if (!isOption(argv[1]) && std::find(commands.begin(), commands.end(), argv[1]) == commands.end()) {
    printError(unknownName("command", argv[1], commands));
    return ExitStatus::kBadInput;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ExtrasError&) {
    printError(describeLeftover(program));
    return ExitStatus::kBadInput;
  } catch (const CLI::Success& asked) {
    program.exit(asked);
    return ExitStatus::kOk;
  } catch (const CLI::RequiredError& error) {
    printError(std::string(error.what()) + "; see " + fullName(innermost(program)) + " --help");
    return ExitStatus::kBadInput;
  } catch (const CLI::ParseError& error) {
    printError(error.what());
    return ExitStatus::kBadInput;
  }
  return std::nullopt;
}

ExitStatus cannotPrint() {
  printError("cannot write to standard output; is the disk full?");
  return ExitStatus::kFailed;
}

ExitStatus execute(const std::vector<Command>& commands) {
  const auto given = std::find_if(commands.begin(), commands.end(),
                                  [](const Command& command) { return command.arguments->parsed(); });
  if (given == commands.end()) {
    printError("a command is needed; see scatter --help");
    return ExitStatus::kBadInput;
  }
  try {
    return given->execute();
  } catch (const Interrupted&) {
    printError("interrupted before it was finished");
    return signalStatus();
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) {
      return cannotPrint();
    }
    printError(error.what());
    return ExitStatus::kFailed;
  }
}

// A table that went to a full disk is not a success.
ExitStatus checkStandardOutput(ExitStatus status) {
  const bool failed = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
  return failed && status == ExitStatus::kOk ? cannotPrint() : status;
}

// As a shell would take it again.
std::string commandLineOf(int argc, const char* const* argv) {
  std::string line = "scatter";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool plain =
        !argument.empty() && argument.find_first_of(" \t\n'\"\\$`*?&;|<>(){}[]#!~") == std::string::npos;
    line += plain ? " " + argument : " '" + argument + "'";
  }
  return line;
}

}  // namespace

int runProgram(int argc, const char* const* argv, const AddCommands& addCommands) {
  CLI::App program{"Scatter: nested collision levels that switch safely at run time", "scatter"};
  program.footer(kFooter);
  program.formatter(std::make_shared<TerminalFormatter>());
  program.set_version_flag("--version", version(), "Show the version, build and compiler");
  const std::vector<Command> commands = addCommands(program, commandLineOf(argc, argv));
  const auto other = std::find_if(commands.begin(), commands.end(), [&](const Command& command) {
    return command.isAnotherProgram && argc > 1 && command.arguments->get_name() == argv[1];
  });
  if (other != commands.end()) {
    return static_cast<int>(other->execute());
  }
  catchInterrupts();
  const std::optional<ExitStatus> parsed = parse(program, argc, argv);
  return static_cast<int>(checkStandardOutput(parsed ? *parsed : execute(commands)));
}

}  // namespace scatter::app
