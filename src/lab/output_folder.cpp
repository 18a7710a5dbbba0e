#include <scatter/io/file.h>
#include <scatter/lab/output_folder.h>

#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

namespace scatter {

namespace fs = std::filesystem;

namespace {

tl::unexpected<Error> cannotUse(const fs::path& folder, const std::string& why,
                                ErrorKind kind = ErrorKind::kInput) {
  return tl::unexpected<Error>(
      {.message = "cannot write into folder " + folder.string() + ": " + why + "; choose another folder",
       .kind = kind});
}

ErrorKind kindOf(int errorNumber) {
  return errorNumber == ENOSPC || errorNumber == EDQUOT ? ErrorKind::kDiskFull : ErrorKind::kInput;
}

// A new folder NAME.XXXXXX in `parent`; empty, with errno set, on failure.
fs::path makeTemporaryFolder(const fs::path& parent, const std::string& name) {
  std::string path = (parent / ("." + name + ".XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) {
    return {};
  }
  return path;
}

// Where files for `folder` can be staged on the same file system: in it, or else in the nearest folder
// above that exists.
fs::path nearestExisting(fs::path folder) {
  std::error_code error;
  folder = fs::absolute(folder, error).lexically_normal();
  while (!fs::exists(folder, error) && folder.has_relative_path()) {
    folder = folder.parent_path();
  }
  return folder;
}

std::error_code moveInto(const fs::path& from, const fs::path& to) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(from, error)) {
    const fs::path target = to / entry.path().filename();
    if (entry.is_directory() && fs::is_directory(target)) {
      error = moveInto(entry.path(), target);
    } else {
      fs::rename(entry.path(), target, error);
    }
    if (error) {
      break;
    }
  }
  return error;
}

// mkdtemp() lets only the owner in.
void openToReaders(const fs::path& folder) {
  const mode_t mask = umask(0);
  umask(mask);
  std::error_code ignored;
  fs::permissions(folder, static_cast<fs::perms>(0777U & ~mask), ignored);
}

}  // namespace

Result<void> prepareOutputFolder(const fs::path& folder) {
  const auto staged = StagedFolder::create(folder);
  if (!staged) {
    return tl::unexpected(staged.error());
  }
  if (auto probed = writeFile(staged->path() / "probe", "probe\n"); !probed) {
    return cannotUse(folder, "nothing can be written there", probed.error().kind);
  }
  return {};
}

Result<StagedFolder> StagedFolder::create(const fs::path& folder) {
  if (folder.empty()) {
    return fail("the output folder has no name; give one");
  }
  const fs::path existing = nearestExisting(folder);
  std::error_code error;
  if (!fs::is_directory(existing, error)) {
    return cannotUse(folder, existing.string() + " is not a folder");
  }
  fs::path staging = makeTemporaryFolder(existing, "scatter-unfinished");
  if (staging.empty()) {
    const int code = errno;
    return cannotUse(folder, std::generic_category().message(code), kindOf(code));
  }
  openToReaders(staging);
  return StagedFolder(folder, std::move(staging));
}

StagedFolder::StagedFolder(fs::path folder, fs::path staging)
    : folder_(std::move(folder)), staging_(std::move(staging)) {}

StagedFolder::StagedFolder(StagedFolder&& other) noexcept
    : folder_(std::move(other.folder_)), staging_(std::exchange(other.staging_, {})) {}

StagedFolder& StagedFolder::operator=(StagedFolder&& other) noexcept {
  discard();
  folder_ = std::move(other.folder_);
  staging_ = std::exchange(other.staging_, {});
  return *this;
}

StagedFolder::~StagedFolder() {
  discard();
}

Result<void> StagedFolder::commit() {
  std::error_code error;
  if (fs::is_directory(folder_, error)) {
    error = moveInto(staging_, folder_);
  } else {
    const fs::path target = fs::absolute(folder_, error).lexically_normal();
    const fs::path named = target.has_filename() ? target : target.parent_path();
    fs::create_directories(named.parent_path(), error);
    if (!error) {
      fs::rename(staging_, named, error);
    }
  }
  if (error) {
    return cannotUse(folder_, error.message(), kindOf(error.value()));
  }
  discard();
  return {};
}

void StagedFolder::discard() noexcept {
  if (!staging_.empty()) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    staging_.clear();
  }
}

}  // namespace scatter
