#include <scatter/lab/touched_memory.h>

#include <sys/mman.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <string>

namespace scatter {

namespace {

constexpr const char* kMarks = "/proc/self/clear_refs";
constexpr const char* kMappings = "/proc/self/smaps";

tl::unexpected<Error> failToCount(const char* file) {
  return fail("cannot count touched memory, as " + std::string(file) +
              " is not there or not allowed: " + std::strerror(errno) + "; it takes Linux with /proc");
}

// "55d0c9a00000-55d0c9a21000 rw-p …": data, not code and constants.
bool isWritable(const std::string& line) {
  const std::size_t blank = line.find(' ');
  return blank != std::string::npos && line.size() > blank + 2 && line[blank + 2] == 'w';
}

// A processor marks a page when it looks up where the page is, and so never one whose place it remembers. It
// forgets all of them where so many pages go at once that it is not told of each.
void forgetPlaces() {
  constexpr std::size_t kBytes = std::size_t{1} << 20U;
  constexpr std::size_t kPage = 4096;
  void* const block = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (block == MAP_FAILED) {
    return;
  }
  auto* const bytes = static_cast<volatile char*>(block);
  for (std::size_t i = 0; i < kBytes; i += kPage) {
    bytes[i] = 1;
  }
  munmap(block, kBytes);
}

}  // namespace

Result<void> TouchedMemory::begin() {
  std::ofstream marks(kMarks);
  // The marks of all pages.
  marks << "1" << std::flush;
  if (!marks) {
    return failToCount(kMarks);
  }
  forgetPlaces();
  return {};
}

Result<std::uint64_t> TouchedMemory::bytes() {
  constexpr const char* kName = "Referenced:";
  std::ifstream mappings(kMappings);
  if (!mappings) {
    return failToCount(kMappings);
  }
  std::uint64_t kilobytes = 0;
  bool counts = false;
  for (std::string line; std::getline(mappings, line);) {
    const std::size_t colon = line.find(':');
    const bool isField = colon != std::string::npos && line.find(' ') > colon;
    if (!isField) {
      counts = isWritable(line);
    } else if (counts && line.starts_with(kName)) {
      kilobytes += std::stoull(line.substr(std::strlen(kName)));
    }
  }
  return kilobytes * 1024;
}

}  // namespace scatter
