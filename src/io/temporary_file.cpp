#include "io/temporary_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string>

namespace scatter {

namespace {

// What open() would have given a new file; mkstemp() lets only the owner read.
mode_t newFileMode() {
  const mode_t mask = umask(0);
  umask(mask);
  return 0666U & ~mask;
}

}  // namespace

TemporaryFile makeTemporaryBeside(const std::filesystem::path& file) {
  std::string name = (file.parent_path() / ('.' + file.filename().string() + ".XXXXXX")).string();
  const int descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0 && fchmod(descriptor, newFileMode()) != 0) {
    const int code = errno;
    close(descriptor);
    unlink(name.c_str());
    errno = code;
    return {.path = {}, .descriptor = -1};
  }
  return {.path = name, .descriptor = descriptor};
}

}  // namespace scatter
