#include <scatter/recording/export.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "command.h"
#include "messages.h"
#include "recording_arguments.h"

namespace scatter::app {

namespace {

struct ExportArguments {
  std::string file;
  std::string out;
  std::optional<std::string> frames;
};

using Write = Result<ExportCounts> (*)(const Recording&, const ExportRange&, const std::filesystem::path&);

Result<Write> writerFor(const std::filesystem::path& file) {
  const std::filesystem::path extension = file.extension();
  if (extension == ".glb" || extension == ".gltf") return &writeGltfAnimation;
  if (extension == ".mcap") return &writeMcap;
  return fail(file.string() + ": the name must end with .glb, .gltf or .mcap, which says the format");
}

ExitStatus exportRecording(const ExportArguments& arguments) {
  const auto write = writerFor(arguments.out);
  if (!write) return refuse(write.error());
  const auto recording = openRecording(arguments.file);
  if (!recording) return refuse(recording.error());
  const auto range = parseFrames(arguments.frames.value_or(":"), **recording);
  if (!range) return refuse(range.error());
  if (range->from > range->to) {
    return refuse({.message = "--frames " + *arguments.frames +
                              ": a file begins with its first frame; write FROM "
                              "and TO the other way around"});
  }
  const auto written = (*write)(**recording, {range->from, range->to, range->step}, arguments.out);
  if (!written) return refuse(written.error());
  fmt::print("{}: {} frames, {} bodies, {:.3g} MB\n", arguments.out, written->frames, written->bodies,
             static_cast<double>(written->bytes) / 1e6);
  return ExitStatus::kOk;
}

}  // namespace

Command addExportCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "export",
      "Write a recorded run for other programs: glTF (.glb, .gltf) for Blender, MCAP (.mcap) for Foxglove");
  auto arguments = std::make_shared<ExportArguments>();
  command->add_option("FILE", arguments->file, "What scatter run --record wrote, whole or cut short")
      ->required();
  command->add_option("OUT", arguments->out, "The file that is written; its name says the format")
      ->required();
  command->add_option("--frames", arguments->frames, "These alone: FROM:TO or FROM:TO:STEP [all]")
      ->type_name("FRAMES");
  return {command, [arguments] { return exportRecording(*arguments); }};
}

}  // namespace scatter::app
