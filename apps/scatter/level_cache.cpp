#include "level_cache.h"

#include <scatter/io/file.h>
#include <scatter/lab/environment.h>
#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/extension.h"

namespace scatter::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRecord = "scatter-levels.json";

/// FNV-1a: tells files apart that nobody made to deceive it.
std::uint64_t hashOf(std::string_view bytes, std::uint64_t seed = 0xcbf29ce484222325U) {
  for (const char byte : bytes) seed = (seed ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  return seed;
}

std::string textOf(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

/// The names of files in the mesh's folder that it mentions, in order.
std::vector<fs::path> mentionedBy(const fs::path& mesh, const std::string& text) {
  std::vector<fs::path> files;
  if (io::lowerExtension(mesh) != ".gltf") return files;
  std::error_code error;
  const fs::path folder = mesh.has_parent_path() ? mesh.parent_path() : ".";
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.is_regular_file(error) && text.find(entry.path().filename().string()) != std::string::npos)
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

LevelCache::LevelCache(fs::path folder) : folder_(std::move(folder)) {
  const Result<std::string> text = readFile(folder_ / kRecord);
  if (!text) return;
  const auto record = nlohmann::json::parse(*text, nullptr, /*allow_exceptions=*/false);
  if (!record.is_object()) return;
  for (const auto& [file, entry] : record.items()) {
    if (!entry.is_object() || !entry.contains("key") || !entry.contains("content")) continue;
    if (!entry["key"].is_string() || !entry["content"].is_string()) continue;
    entries_[file] = {entry["key"].get<std::string>(), entry["content"].get<std::string>()};
  }
}

bool LevelCache::isCurrent(const std::string& file, const std::string& key) const {
  const auto known = entries_.find(file);
  if (known == entries_.end() || known->second.key != key) return false;
  const Result<std::string> bytes = readFile(folder_ / file);
  return bytes && textOf(hashOf(*bytes)) == known->second.content;
}

Result<void> LevelCache::remember(const std::string& file, const std::string& key) {
  const Result<std::string> bytes = readFile(folder_ / file);
  if (!bytes) return fail(bytes.error().message);
  entries_[file] = {key, textOf(hashOf(*bytes))};
  auto record = nlohmann::ordered_json::object();
  for (const auto& [name, entry] : entries_) record[name] = {{"key", entry.key}, {"content", entry.content}};
  return writeFile(folder_ / kRecord, record.dump(2) + "\n");
}

Result<std::string> levelKey(const fs::path& mesh, const std::string& options) {
  const Result<std::string> bytes = readFile(mesh);
  if (!bytes) return fail(bytes.error().message);
  const BuildInfo build = buildInfo();
  std::uint64_t hash = hashOf(options, hashOf(build.commit));
  hash = hashOf(*bytes, hash);
  for (const fs::path& other : mentionedBy(mesh, *bytes)) {
    if (const Result<std::string> more = readFile(other)) hash = hashOf(*more, hash);
  }
  return textOf(hash);
}

}  // namespace scatter::app
