#include "io/temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "io/atomic_file.h"

namespace scatter {

namespace {

// What open() would have given a new file; mkstemp() lets only the owner read.
mode_t newFileMode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666U & ~mask;
}

Result<std::filesystem::path> findPlaceOf(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) {
    return file;
  }
  if (S_ISDIR(status.st_mode)) {
    return cannotWrite(file, EISDIR);
  }
  if (!S_ISREG(status.st_mode)) {
    return fail("cannot write " + file.string() + ": it is a device or a pipe; choose the name of a file");
  }
  std::error_code error;
  const std::filesystem::path place = std::filesystem::canonical(file, error);
  return error ? file : place;
}

}  // namespace

Result<TemporaryFile> makeTemporaryFor(const std::filesystem::path& file) {
  auto place = findPlaceOf(file);
  if (!place) {
    return tl::unexpected(place.error());
  }
  std::string name = (place->parent_path() / ('.' + place->filename().string() + ".XXXXXX")).string();
  const int descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor < 0) {
    return cannotWrite(file, errno);
  }
  if (fchmod(descriptor, newFileMode()) != 0) {
    const int code = errno;
    close(descriptor);
    unlink(name.c_str());
    return cannotWrite(file, code);
  }
  return TemporaryFile{.place = std::move(*place), .path = name, .descriptor = descriptor};
}

}  // namespace scatter
