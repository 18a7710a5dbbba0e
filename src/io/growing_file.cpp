#include "io/growing_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <string>
#include <utility>

#include "io/atomic_file.h"
#include "io/temporary_file.h"
#include "io/write_all.h"

namespace scatter {

Result<std::unique_ptr<GrowingFile>> GrowingFile::create(const std::filesystem::path& file) {
  return makeTemporaryFor(file).map([](TemporaryFile made) {
    return std::unique_ptr<GrowingFile>(
        new GrowingFile(std::move(made.place), std::move(made.path), made.descriptor));
  });
}

GrowingFile::GrowingFile(std::filesystem::path file, std::filesystem::path temporary, int descriptor)
    : file_(std::move(file)), temporary_(std::move(temporary)), descriptor_(descriptor) {}

GrowingFile::~GrowingFile() {
  close(descriptor_);
  if (!temporary_.empty()) {
    unlink(temporary_.c_str());
  }
}

Result<void> GrowingFile::add(std::string_view text) {
  sizeBefore_ = size_;
  if (text.empty()) {
    return {};
  }
  int code = writeAll(descriptor_, text);
  if (code == 0 && !temporary_.empty()) {
    code = rename(temporary_.c_str(), file_.c_str()) == 0 ? 0 : errno;
  }
  size_ += static_cast<off_t>(text.size());
  if (code != 0) {
    dropLast();
    return cannotWrite(file_, code);
  }
  temporary_.clear();
  return {};
}

void GrowingFile::dropLast() noexcept {
  size_ = sizeBefore_;
  // What cannot be cut off stays as a last line without an end, which readers leave out.
  [[maybe_unused]] const int ignored = ftruncate(descriptor_, size_);
  lseek(descriptor_, size_, SEEK_SET);
}

Result<void> GrowingFile::finish() {
  if (fsync(descriptor_) != 0) {
    return cannotWrite(file_, errno);
  }
  return {};
}

}  // namespace scatter
