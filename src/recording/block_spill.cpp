#include "recording/block_spill.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "recording/read_file.h"

namespace scatter::recording {

namespace {

int makeNamelessFile() {
  const char* folder = std::getenv("TMPDIR");
  // Not /tmp, which is memory on many machines.
  std::string name =
      std::string(folder != nullptr && *folder != '\0' ? folder : "/var/tmp") + "/scatter-XXXXXX";
  const int descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor >= 0) unlink(name.c_str());
  return descriptor;
}

}  // namespace

BlockSpill::~BlockSpill() {
  if (descriptor_ >= 0) close(descriptor_);
}

BlockPlace BlockSpill::add(const EncodedBlock& block) {
  const BlockHeader header = readHeader(block.bytes).value_or(BlockHeader{});
  const BlockPlace place{block.first, block.frames, size_ + kHeaderBytes, header.size, header.hash};
  bytes_ += header.size;
  // Once the disk is full, all that comes is kept in memory.
  if (!memory_.empty() || !write(block.bytes)) {
    memory_.emplace(block.first, block.bytes.substr(kHeaderBytes));
    memoryBytes_ += header.size;
  }
  return place;
}

bool BlockSpill::write(const std::string& bytes) {
  if (!std::exchange(tried_, true)) descriptor_ = makeNamelessFile();
  std::size_t done = 0;
  while (descriptor_ >= 0 && done < bytes.size()) {
    const ssize_t put =
        pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(size_ + done));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    done += static_cast<std::size_t>(put);
  }
  if (descriptor_ < 0) return false;
  size_ += bytes.size();
  return true;
}

Result<std::string> BlockSpill::read(const BlockPlace& place) const {
  if (const auto kept = memory_.find(place.first); kept != memory_.end()) return kept->second;
  return readAt(descriptor_, place.where, place.size);
}

void BlockSpill::drop(const BlockPlace& place) {
  bytes_ -= place.size;
  if (const auto kept = memory_.find(place.first); kept != memory_.end()) {
    memoryBytes_ -= kept->second.size();
    memory_.erase(kept);
    return;
  }
  // Where holes cannot be made, the file is as large as all that was in it.
  [[maybe_unused]] const int ignored = fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                                                 static_cast<off_t>(place.where - kHeaderBytes),
                                                 static_cast<off_t>(place.size + kHeaderBytes));
}

}  // namespace scatter::recording
