#include <scatter/io/file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include "io/atomic_file.h"
#include "io/write_all.h"

namespace scatter {
namespace {

constexpr std::size_t kMaxFileSize = std::size_t{1} << 30U;

tl::unexpected<Error> cannotRead(const std::filesystem::path& path, int code) {
  return fail("cannot read " + path.string() + ": " + std::generic_category().message(code));
}

/// An open file descriptor.
class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags)
      : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }

  [[nodiscard]] bool isOpen() const { return fd_ >= 0; }
  [[nodiscard]] int get() const { return fd_; }

  /// 0 or an errno; some file systems report a full disk only here.
  [[nodiscard]] int close() { return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

 private:
  int fd_;
};

Result<void> writeDirectly(const std::filesystem::path& path, std::string_view content) {
  Descriptor file(path, O_WRONLY);
  if (!file.isOpen()) {
    return cannotWrite(path, errno);
  }
  int code = writeAll(file.get(), content);
  if (code == 0) {
    code = file.close();
  }
  if (code != 0) {
    return cannotWrite(path, code);
  }
  return {};
}

Result<void> writeAndRename(const std::filesystem::path& path, std::string_view content) {
  auto file = AtomicFile::create(path);
  if (!file) {
    return tl::unexpected(file.error());
  }
  if (auto written = (*file)->write(content); !written) {
    return written;
  }
  return (*file)->commit();
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (!file.isOpen()) {
    return cannotRead(path, errno);
  }
  std::string content;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count == 0) {
      return content;
    }
    if (count < 0 && errno != EINTR) {
      return cannotRead(path, errno);
    }
    content.append(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    if (content.size() > kMaxFileSize) {
      return fail("cannot read " + path.string() + ": it is larger than 1 GiB");
    }
  }
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view content) {
  struct stat status {};
  const bool exists = ::stat(path.c_str(), &status) == 0;
  const bool isDevice = exists && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
  return isDevice ? writeDirectly(path, content) : writeAndRename(path, content);
}

}  // namespace scatter
