#include <CLI/CLI.hpp>
#include <cstdint>
#include <cstdio>
#include <string>

#include "SwitchTrial.h"

// A million random switches: what each does to bodies, velocities, energy and contacts, against an exact copy
// of the world that does not switch.

namespace scatter::bench {
namespace {

using test::Situation;
using test::SwitchTally;

struct TrialArguments {
  long switches = 1'000'000;  ///< In all.
  std::uint64_t seed = 1;
  bool unsafe = false;
};

constexpr const char* kRow =
    "%-9s %-5s %8ld %9ld %9ld %9ld %7ld %7ld %6ld %9ld %7ld %8ld %8ld %8ld %7ld %10.3g\n";

SwitchTally runAll(Situation situation, btHybridSwitchingMode mode, long switches,
                   const TrialArguments& arguments) {
  SwitchTally all;
  for (std::uint64_t i = 0; all.switches < switches; ++i) {
    all += test::runSwitchTrial({.situation = situation,
                                 .mode = mode,
                                 .seed = arguments.seed * 1'000'003 + i,
                                 .safetyConditions = !arguments.unsafe});
  }
  return all;
}

// Bodies in contact hardly ever switch as a whole.
long share(Situation situation, bool byPairs, long switches) {
  if (byPairs) return switches * 9 / 50;
  const bool isFree = situation == Situation::kApart || situation == Situation::kMoving;
  return isFree ? switches * 47 / 1000 : switches / 500;
}

int runTrials(const TrialArguments& arguments) {
  std::printf("%-9s %-5s %8s %9s %9s %9s %7s %7s %6s %9s %7s %8s %8s %8s %7s %10s\n", "situation", "mode",
              "moments", "switches", "coarser", "on credit", "unsafe", "deeper", "moved", "velocity",
              "pushed", "restless", "released", "weighed", "gained", "most gain");
  SwitchTally total;
  std::string complaints;
  for (const btHybridSwitchingMode mode : {BT_HYBRID_PAIR_SWITCHING, BT_HYBRID_BODY_SWITCHING}) {
    const bool byPairs = mode == BT_HYBRID_PAIR_SWITCHING;
    for (const Situation situation : test::kSituations) {
      const SwitchTally all =
          runAll(situation, mode, share(situation, byPairs, arguments.switches), arguments);
      std::printf(kRow, nameOf(situation), byPairs ? "pair" : "body", all.moments, all.switches, all.coarser,
                  all.onCredit, all.unsafe, all.deeper, all.moved, all.changedVelocity, all.pushed,
                  all.restless, all.released, all.weighed, all.gained, all.mostGained);
      std::fflush(stdout);
      if (!all.complaint.empty()) complaints += all.complaint + "\n";
      total += all;
    }
  }
  std::printf(kRow, "all", "", total.moments, total.switches, total.coarser, total.onCredit, total.unsafe,
              total.deeper, total.moved, total.changedVelocity, total.pushed, total.restless, total.released,
              total.weighed, total.gained, total.mostGained);
  std::fputs(complaints.c_str(), stdout);
  return total.isClean() ? 0 : 1;
}

}  // namespace
}  // namespace scatter::bench

int main(int argc, char** argv) {
  scatter::bench::TrialArguments arguments;
  CLI::App app(
      "Random switches of levels, each compared with an exact copy of the world that does not switch");
  app.add_option("--switches", arguments.switches, "how many, in all")->check(CLI::PositiveNumber);
  app.add_option("--seed", arguments.seed, "of the random worlds");
  app.add_flag("--unsafe", arguments.unsafe,
               "without the safety conditions, to see that bad switches are noticed");
  CLI11_PARSE(app, argc, argv);
  return scatter::bench::runTrials(arguments);
}
