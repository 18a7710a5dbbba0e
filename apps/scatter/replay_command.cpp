#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <bit>
#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

#include "command.h"
#include "messages.h"
#include "recording_arguments.h"
#include "view_launcher.h"

namespace scatter::app {

namespace {

struct ReplayArguments {
  std::string file;
  std::optional<std::string> frames;
  std::vector<std::string> bodies;
  bool data = false;
  bool contacts = false;
  bool info = false;
};

void printInfo(const Recording& recording) {
  const RecordingInfo& info = recording.info();
  const auto frames = static_cast<double>(recording.last() - recording.first() + 1);
  fmt::print("{}: {}, {} world, {}, seed {}\nframes {} to {}, {:.2f} s; {:.3g} MB, {} seek points\n",
             recording.file().string(), info.scene, info.label, info.engine, info.seed, recording.first(),
             recording.last(), frames * info.stepSeconds, static_cast<double>(recording.bytes()) / 1e6,
             recording.seekPoints());
  for (const auto& [name, note] : info.notes) fmt::print("{}: {}\n", name, note);
  if (!recording.stopped().empty()) fmt::print("its run is not whole: {}\n", recording.stopped());
}

std::string number(float value) {
  return fmt::format("{:.6g}", value);
}

void printBodies(const Recording& recording, const RecordedFrame& frame,
                 const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
    const RecordedBody& body = frame.bodies[i];
    const std::string name = recording.nameOf((*frame.roster)[i]);
    if (!names.empty() && std::find(names.begin(), names.end(), name) == names.end()) continue;
    const Vec3& p = body.pose.position;
    const Quat& q = body.pose.rotation;
    fmt::print("{},{},{},{},{},{},{},{},{},{},{},{}\n", frame.number,
               static_cast<std::uint32_t>((*frame.roster)[i]), name, number(p.x), number(p.y), number(p.z),
               number(q.w), number(q.x), number(q.y), number(q.z), body.level, body.asleep ? 1 : 0);
  }
}

std::string cell(const RecordedChannel& channel, std::uint64_t bits) {
  if (channel.kind == RecordedKind::kHash) return fmt::format("{:016x}", bits);
  const auto value = std::bit_cast<double>(bits);
  return value != value ? std::string() : fmt::format("{}", value);
}

void printData(const Recording& recording, const RecordedFrame& frame) {
  const auto& channels = recording.info().channels;
  for (std::size_t i = 0; i < std::min(channels.size(), frame.values.size()); ++i) {
    fmt::print("{}{}", i == 0 ? "" : ",", cell(channels[i], frame.values[i]));
  }
  fmt::print("\n");
}

void printContacts(const Recording& recording, const RecordedFrame& frame) {
  for (const RecordedContact& contact : frame.contacts) {
    fmt::print("{},{},{},{},{},{},{},{},{},{},{},{}\n", frame.number, recording.nameOf(contact.a),
               recording.nameOf(contact.b), number(contact.pointA.x), number(contact.pointA.y),
               number(contact.pointA.z), number(contact.normal.x), number(contact.normal.y),
               number(contact.normal.z), number(contact.distance), number(contact.credit),
               number(contact.impulse));
  }
}

void printHeader(const ReplayArguments& arguments, const Recording& recording) {
  if (arguments.data) {
    const char* separator = "";
    for (const RecordedChannel& channel : recording.info().channels) {
      fmt::print("{}{}", std::exchange(separator, ","), channel.name);
    }
    fmt::print("\n");
  } else if (arguments.contacts) {
    fmt::print("frame,a,b,x,y,z,normal_x,normal_y,normal_z,distance,credit,impulse\n");
  } else {
    fmt::print("frame,body,name,x,y,z,qw,qx,qy,qz,level,asleep\n");
  }
}

Result<void> checkBodies(const Recording& recording, const std::vector<std::string>& names,
                         const FrameRange& range) {
  for (const std::string& name : names) {
    bool known = false;
    for (const std::uint64_t number : {range.from, range.to}) {
      const auto frame = recording.frame(number);
      if (!frame) return tl::unexpected(frame.error());
      const auto& roster = *(*frame)->roster;
      known = known || std::any_of(roster.begin(), roster.end(),
                                   [&](BodyId body) { return recording.nameOf(body) == name; });
    }
    if (!known)
      return fail("no body is called \"" + name + "\" in these frames; --frames N shows all of a frame");
  }
  return {};
}

Result<void> printFrames(const ReplayArguments& arguments, const Recording& recording) {
  const auto range = parseFrames(arguments.frames.value_or(":"), recording);
  if (!range) return tl::unexpected(range.error());
  if (auto known = checkBodies(recording, arguments.bodies, *range); !known) return known;
  printHeader(arguments, recording);
  return forEachFrame(recording, *range, [&](const RecordedFrame& frame) -> Result<void> {
    if (arguments.data) {
      printData(recording, frame);
    } else if (arguments.contacts) {
      printContacts(recording, frame);
    } else {
      printBodies(recording, frame, arguments.bodies);
    }
    return {};
  });
}

ExitStatus replay(const ReplayArguments& arguments) {
  const auto recording = openRecording(arguments.file);
  if (!recording) return refuse(recording.error());
  const bool prints = arguments.frames || arguments.data || arguments.contacts || !arguments.bodies.empty();
  if (arguments.info) printInfo(**recording);
  if (prints) {
    if (auto printed = printFrames(arguments, **recording); !printed) return refuse(printed.error());
  }
  return prints || arguments.info ? ExitStatus::kOk : becomeWindow({arguments.file});
}

}  // namespace

Command addReplayCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "replay", "Look at a recorded run again: in the window, or as numbers, forwards and backwards");
  command->footer(
      "Without options the window opens, as with scatter view FILE, which takes more of them.\n"
      "To make a run with a budget again, step by step: scatter run SCENE --replay FRAMES_CSV.");
  auto arguments = std::make_shared<ReplayArguments>();
  command->add_option("FILE", arguments->file, "What scatter run --record wrote, whole or cut short")
      ->required();
  command->add_flag("--info", arguments->info, "Print what it is of, and how long it is");
  command
      ->add_option("--frames", arguments->frames,
                   "Print where bodies are, as CSV: N, FROM:TO or FROM:TO:STEP, backwards if FROM is more")
      ->type_name("FRAMES");
  command->add_option("--body", arguments->bodies, "Of bodies with this name alone")->type_name("NAME");
  CLI::Option* data =
      command->add_flag("--data", arguments->data, "Print the frame data instead, as frames.csv has it");
  command
      ->add_flag("--contacts", arguments->contacts,
                 "Print contact points instead, of runs with --record-contacts")
      ->excludes(data);
  return {command, [arguments] { return replay(*arguments); }};
}

}  // namespace scatter::app
