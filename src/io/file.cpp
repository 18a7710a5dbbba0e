#include <scatter/io/file.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

namespace scatter {
namespace {

constexpr std::size_t kMaxFileSize = std::size_t{1} << 30U;

tl::unexpected<Error> failWith(const std::filesystem::path& path, const char* verb, int code) {
  return fail(path.string() + ": cannot be " + verb + ": " + std::generic_category().message(code));
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

/// 0 or an errno.
int writeAll(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(fd, content.data(), content.size());
    if (written < 0 && errno != EINTR) {
      return errno;
    }
    content.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  return 0;
}

/// 0 or an errno.
int writeAndClose(Descriptor& file, std::string_view content, bool flush) {
  if (const int code = writeAll(file.get(), content); code != 0) {
    return code;
  }
  if (flush && ::fsync(file.get()) != 0) {
    return errno;
  }
  return file.close();
}

std::filesystem::path temporaryBeside(const std::filesystem::path& target) {
  static std::atomic<unsigned> counter{0};
  std::string name(".");
  name.append(target.filename().string()).append(".tmp").append(std::to_string(::getpid()));
  return target.parent_path() / name.append(".").append(std::to_string(counter++));
}

/// Where a write to `path` ends up: behind symbolic links, if it exists.
std::filesystem::path resolve(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path target = std::filesystem::canonical(path, ignored);
  return ignored ? path : target;
}

/// 0 or an errno.
int writeDirectly(const std::filesystem::path& path, std::string_view content) {
  Descriptor file(path, O_WRONLY);
  return file.isOpen() ? writeAndClose(file, content, false) : errno;
}

/// 0 or an errno.
int writeAndRename(const std::filesystem::path& target, std::string_view content) {
  const std::filesystem::path temporary = temporaryBeside(target);
  Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL);
  if (!file.isOpen()) {
    return errno;
  }
  int code = writeAndClose(file, content, true);
  if (code == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) {
    code = errno;
  }
  if (code != 0) {
    ::unlink(temporary.c_str());
  }
  return code;
}

/// 0 or an errno.
int write(const std::filesystem::path& target, std::string_view content) {
  struct stat status {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) {
    return EISDIR;
  }
  return exists && !S_ISREG(status.st_mode) ? writeDirectly(target, content)
                                            : writeAndRename(target, content);
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (!file.isOpen()) {
    return failWith(path, "read", errno);
  }
  std::string content;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(file.get(), buffer.data(), buffer.size());
    if (count == 0) {
      return content;
    }
    if (count < 0 && errno != EINTR) {
      return failWith(path, "read", errno);
    }
    content.append(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    if (content.size() > kMaxFileSize) {
      return fail(path.string() + ": cannot be read: it is larger than 1 GiB");
    }
  }
}

Result<void> writeFile(const std::filesystem::path& path, std::string_view content) {
  if (const int code = write(resolve(path), content); code != 0) {
    return failWith(path, "written", code);
  }
  return {};
}

}  // namespace scatter
