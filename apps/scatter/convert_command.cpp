#include <scatter/io/collada.h>
#include <scatter/io/gltf.h>
#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "command.h"
#include "messages.h"

namespace scatter::app {

namespace {

struct Format {
  const char* extension;
  Result<PhysicsDocument> (*read)(const std::filesystem::path& path);
  Result<void> (*write)(const PhysicsDocument& document, const std::filesystem::path& path);
};

constexpr std::array<Format, 3> kFormats{{{".dae", readColladaDocument, writeColladaDocument},
                                          {".gltf", readGltfDocument, writeGltfDocument},
                                          {".glb", readGltfDocument, writeGltfDocument}}};

struct ConvertArguments {
  std::string from;
  std::string to;
};

Result<const Format*> formatOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  for (const Format& format : kFormats) {
    if (extension == format.extension) {
      return &format;
    }
  }
  return fail("cannot tell the format of \"" + file.string() +
              "\"; its name should end in .dae, .gltf or .glb");
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

Result<PhysicsDocument> convertFile(const ConvertArguments& arguments) {
  const auto from = formatOf(arguments.from);
  const auto to = formatOf(arguments.to);
  if (!from || !to) {
    return tl::unexpected(from ? to.error() : from.error());
  }
  std::error_code ignored;
  if (std::filesystem::equivalent(arguments.from, arguments.to, ignored)) {
    return fail("\"" + arguments.from + "\" would be written over itself; choose another name");
  }
  auto document = (*from)->read(arguments.from);
  if (!document) {
    return document;
  }
  for (const std::string& warning : document->warnings) {
    printNote(warning);
  }
  const bool isFiltered =
      std::any_of(document->bodies.begin(), document->bodies.end(),
                  [](const DocumentBody& body) { return body.filter || body.gravityFactor != 1.0F; });
  if (isFiltered && (*to)->write == writeColladaDocument) {
    printNote(arguments.to + ": COLLADA has no collision filters and gravity factors; they are left out");
  }
  if (const auto written = (*to)->write(*document, arguments.to); !written) {
    return tl::unexpected(written.error());
  }
  return document;
}

ExitStatus convert(const ConvertArguments& arguments) {
  const auto document = convertFile(arguments);
  if (!document) {
    return refuse(document.error());
  }
  fmt::print("{}: {}, {}, {}, {}, {}\n", arguments.to, counted(document->bodies.size(), "body", "bodies"),
             counted(document->models.size(), "model", "models"),
             counted(document->joints.size(), "joint", "joints"),
             counted(document->materials.size(), "material", "materials"),
             counted(document->fields.size(), "field", "fields"));
  return ExitStatus::kOk;
}

}  // namespace

Command addConvertCommand(CLI::App& program) {
  auto* command = program.add_subcommand(
      "convert", "Convert a physics file between COLLADA (.dae) and glTF (.gltf, .glb)");
  const auto arguments = std::make_shared<ConvertArguments>();
  command->add_option("FROM", arguments->from, "The file that is read; what is left out of it is named")
      ->required();
  command->add_option("TO", arguments->to, "The file that is written; its name says the format")->required();
  return {command, [arguments] { return convert(*arguments); }};
}

}  // namespace scatter::app
