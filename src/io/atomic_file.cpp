#include "io/atomic_file.h"

#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>
#include <utility>

#include "io/temporary_file.h"
#include "io/write_all.h"

namespace scatter {

namespace {

constexpr std::size_t kBufferBytes = 1U << 16U;

}  // namespace

tl::unexpected<Error> cannotWrite(const std::filesystem::path& file, int errorNumber) {
  const bool full = errorNumber == ENOSPC || errorNumber == EDQUOT || errorNumber == EFBIG;
  return tl::unexpected<Error>({.message = "cannot write " + file.string() + ": " +
                                           std::generic_category().message(errorNumber) +
                                           "; free some space there, or choose another folder",
                                .kind = full ? ErrorKind::kDiskFull : ErrorKind::kInput});
}

Result<std::unique_ptr<AtomicFile>> AtomicFile::create(const std::filesystem::path& file) {
  return makeTemporaryFor(file).map([](TemporaryFile made) {
    return std::unique_ptr<AtomicFile>(
        new AtomicFile(std::move(made.place), std::move(made.path), made.descriptor));
  });
}

AtomicFile::AtomicFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor)
    : file_(std::move(file)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

AtomicFile::~AtomicFile() {
  discard();
}

Result<void> AtomicFile::write(std::string_view text) {
  assert(descriptor_ >= 0);
  buffer_.append(text);
  if (buffer_.size() < kBufferBytes) {
    return {};
  }
  return flush();
}

Result<void> AtomicFile::commit() {
  assert(descriptor_ >= 0);
  if (auto flushed = flush(); !flushed) {
    return flushed;
  }
  if (fsync(descriptor_) != 0) {
    return giveUp(errno);
  }
  // Some file systems report a full disk only here.
  if (close(std::exchange(descriptor_, -1)) != 0 || rename(temporary_.c_str(), file_.c_str()) != 0) {
    return giveUp(errno);
  }
  temporary_.clear();
  return {};
}

Result<void> AtomicFile::flush() {
  if (const int code = writeAll(descriptor_, buffer_); code != 0) {
    return giveUp(code);
  }
  buffer_.clear();
  return {};
}

tl::unexpected<Error> AtomicFile::giveUp(int errorNumber) {
  discard();
  return cannotWrite(file_, errorNumber);
}

void AtomicFile::discard() noexcept {
  if (descriptor_ >= 0) {
    close(std::exchange(descriptor_, -1));
  }
  if (!temporary_.empty()) {
    unlink(temporary_.c_str());
    temporary_.clear();
  }
}

}  // namespace scatter
