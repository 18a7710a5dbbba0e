#pragma once

#include <scatter/result.h>

#include <filesystem>
#include <map>
#include <string>

namespace scatter::app {

/// Which files of a folder were made from what, so that they are not made again. The record is the file
/// "scatter-levels.json" in the folder; one that is damaged counts as empty, and files are made anew.
class LevelCache {
 public:
  explicit LevelCache(std::filesystem::path folder);

  /// Whether the file is there, as it was left, and was made from what `key` stands for.
  [[nodiscard]] bool isCurrent(const std::string& file, const std::string& key) const;

  /// Says what the file, as it is there now, was made from, and writes the record.
  [[nodiscard]] Result<void> remember(const std::string& file, const std::string& key);

 private:
  struct Entry {
    std::string key;
    std::string content;  ///< Hash of the file's bytes.
  };

  std::filesystem::path folder_;
  std::map<std::string, Entry> entries_;
};

/// Stands for the bytes of a mesh file, those of the files beside it that a .gltf names, the options in
/// words, and the program that reads them. Fails if the file cannot be read.
[[nodiscard]] Result<std::string> levelKey(const std::filesystem::path& mesh, const std::string& options);

}  // namespace scatter::app
