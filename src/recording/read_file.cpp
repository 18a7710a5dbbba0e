#include "recording/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace scatter::recording {

ReadFile::ReadFile(const std::filesystem::path& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)), path_(path) {
  struct stat status {};
  if (descriptor_ < 0) return;
  if (fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode)) {
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
}

ReadFile::~ReadFile() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::string ReadFile::read(std::uint64_t where, std::size_t size) const {
  const std::uint64_t left = size_ - std::min(size_, where);
  return readAt(descriptor_, where, static_cast<std::size_t>(std::min<std::uint64_t>(size, left)));
}

std::string readAt(int descriptor, std::uint64_t where, std::size_t size) {
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = pread(descriptor, bytes.data() + done, size - done, static_cast<off_t>(where + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

}  // namespace scatter::recording
