#pragma once

#include <scatter/result.h>

#include <filesystem>

namespace scatter {

/// Proves, before a long run, that `folder` can be made or written into, and leaves nothing behind.
[[nodiscard]] Result<void> prepareOutputFolder(const std::filesystem::path& folder);

/// A folder that is filled under a temporary name and then moved to its own, so that nobody finds it half
/// written. If the folder exists, the files move into it one by one, replacing those of the same name.
class StagedFolder {
 public:
  [[nodiscard]] static Result<StagedFolder> create(const std::filesystem::path& folder);

  StagedFolder(StagedFolder&& other) noexcept;
  StagedFolder& operator=(StagedFolder&& other) noexcept;
  ~StagedFolder();  ///< Removes what was not committed.

  /// Where to write.
  [[nodiscard]] const std::filesystem::path& path() const { return staging_; }

  [[nodiscard]] Result<void> commit();

 private:
  StagedFolder(std::filesystem::path folder, std::filesystem::path staging);
  void discard() noexcept;

  std::filesystem::path folder_;
  std::filesystem::path staging_;
};

}  // namespace scatter
