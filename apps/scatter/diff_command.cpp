#include <scatter/recording/difference.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "command.h"
#include "messages.h"
#include "recording_arguments.h"

namespace scatter::app {

namespace {

constexpr std::size_t kShown = 10;

struct DiffArguments {
  std::string a;
  std::string b;
};

std::string amounts(const BodyDifference& body) {
  std::string text;
  if (body.metres > 0.0F) text += fmt::format(", {:.4g} m apart", body.metres);
  if (body.radians > 0.0F) text += fmt::format(", turned by {:.4g} rad", body.radians);
  return text;
}

void print(const BodyDifference& body, const char* start) {
  fmt::print("{}{} (body {}): {}{}\n", start, body.name, static_cast<std::uint32_t>(body.body),
             fmt::join(body.quantities, ", "), amounts(body));
}

void print(const RunDifference& difference) {
  std::size_t shown = 0;
  for (const BodyDifference& body : difference.bodies) {
    if (shown++ < kShown) print(body, "  ");
  }
  if (shown > kShown) fmt::print("  and {} more bodies\n", shown - kShown);
  for (const std::string& quantity : difference.unplaced) {
    fmt::print("  {} of a body that cannot be told: its check is the same by chance\n", quantity);
  }
}

ExitStatus diff(const DiffArguments& arguments) {
  const auto a = openRecording(arguments.a);
  if (!a) return refuse(a.error());
  const auto b = openRecording(arguments.b);
  if (!b) return refuse(b.error());
  if ((*a)->info().scene != (*b)->info().scene) {
    printNote(fmt::format("the scenes are not the same: {} and {}", (*a)->info().scene, (*b)->info().scene));
  }
  const auto compared = compareRecordings(**a, **b);
  if (!compared) return refuse(compared.error());
  if (!compared->difference) {
    fmt::print("the same, bit by bit, in frames {} to {}\n", compared->first, compared->last);
    if ((*a)->last() != (*b)->last()) {
      const Recording& longer = (*a)->last() > (*b)->last() ? **a : **b;
      fmt::print("{} goes on to frame {}\n", longer.file().string(), longer.last());
    }
    return ExitStatus::kOk;
  }
  fmt::print("they part in frame {}, at {:.3f} s", compared->difference->frame,
             static_cast<double>(compared->difference->frame) * (*a)->info().stepSeconds);
  if (compared->last > compared->first) {
    fmt::print("; frames {} to {} are the same, bit by bit", compared->first, compared->last - 1);
  }
  fmt::print(":\n");
  print(*compared->difference);
  return ExitStatus::kFailed;
}

}  // namespace

Command addDiffCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "diff", "Find the first frame, body and quantity in which two recorded runs part");
  command->footer(
      "Exit status: 0 the same in all frames that both have; 1 they part; 2 a file cannot be read.");
  auto arguments = std::make_shared<DiffArguments>();
  command->add_option("A", arguments->a, "What scatter run --record wrote")->required();
  command->add_option("B", arguments->b, "The other one")->required();
  return {command, [arguments] { return diff(*arguments); }};
}

}  // namespace scatter::app
