#include "io/mesh/isolated_call.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <optional>

#include "io/write_all.h"

#if defined(__SANITIZE_ADDRESS__)
#define SCATTER_LIMITS_MEMORY 0
#else
#define SCATTER_LIMITS_MEMORY 1
#endif

namespace scatter::io {
namespace {

/// Exit statuses of the child.
enum Ending : int { kDone = 0, kOutOfMemory = 3, kThrew = 4, kCannotSend = 5 };

constexpr bool kLimitsMemory = SCATTER_LIMITS_MEMORY != 0;

std::uint64_t ownMemoryBytes() {
  unsigned long long pages = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "re")) {
    if (std::fscanf(file, "%llu", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void limit(__rlimit_resource resource, std::uint64_t value) {
  const rlimit both{value, value};
  setrlimit(resource, &both);
}

Ending answer(const std::function<std::string()>& work, int descriptor) {
  try {
    return writeAll(descriptor, work()) == 0 ? kDone : kCannotSend;
  } catch (const std::bad_alloc&) {
    return kOutOfMemory;
  } catch (...) {
    return kThrew;
  }
}

[[noreturn]] void serve(const std::function<std::string()>& work, const IsolationLimits& limits,
                        int descriptor) {
  if (kLimitsMemory) limit(RLIMIT_AS, ownMemoryBytes() + limits.memoryBytes);
  limit(RLIMIT_CPU, static_cast<std::uint64_t>(limits.processorSeconds));
  limit(RLIMIT_CORE, 0);
  // A crash is the parent's to report, in one line.
  for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGXCPU, SIGPIPE, SIGINT}) {
    std::signal(signal, SIG_DFL);
  }
  _exit(answer(work, descriptor));
}

/// Nothing if there is more of it than the limit.
std::optional<std::string> receive(int descriptor, std::uint64_t limit) {
  std::string bytes;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return bytes;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > limit) return std::nullopt;
  }
}

int waitFor(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string describeEnd(int status, const IsolationLimits& limits) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL) {
      return "took more than " + std::to_string(limits.processorSeconds) + " s or was killed";
    }
    if (signal == SIGINT || signal == SIGTERM) return "was interrupted";
    return std::string("crashed (") + strsignal(signal) + ")";
  }
  switch (WEXITSTATUS(status)) {
    case kOutOfMemory:
      return "ran out of its " + std::to_string(limits.memoryBytes >> 20U) + " MiB of memory";
    case kThrew:
      return "failed without a reason";
    default:
      return "stopped with status " + std::to_string(WEXITSTATUS(status));
  }
}

}  // namespace

Result<std::string> callIsolated(const std::function<std::string()>& work, const IsolationLimits& limits) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0)
    return fail(std::string("could not start: ") + std::strerror(errno));
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    serve(work, limits, ends[1]);
  }
  const int forkError = errno;
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    return fail(std::string("could not start: ") + std::strerror(forkError));
  }
  std::optional<std::string> bytes = receive(ends[0], limits.answerBytes);
  close(ends[0]);
  const int status = waitFor(child);
  if (!bytes) return fail("gave more than " + std::to_string(limits.answerBytes >> 20U) + " MiB");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != kDone) return fail(describeEnd(status, limits));
  return std::move(*bytes);
}

}  // namespace scatter::io
