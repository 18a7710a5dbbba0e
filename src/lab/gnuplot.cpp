#include "lab/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace scatter::lab {

namespace {

constexpr const char* kMissing =
    "figures need the program gnuplot, which cannot be run; install the package gnuplot-nox "
    "(apt-get install gnuplot-nox)";

// What a spawned program does with its files; frees itself.
class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  posix_spawn_file_actions_t* get() { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

std::string readToEnd(int descriptor) {
  std::string text;
  std::array<char, 4096> buffer{};
  for (;;) {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) {
      continue;
    }
    if (count <= 0) {
      return text;
    }
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

int waitFor(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string onOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool space = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!space) {
      line += c;
    } else if (!line.empty() && line.back() != ' ') {
      line += ' ';
    }
  }
  return line;
}

// Starts the program with its error output in a pipe; returns errno's value, 0 for success.
int spawn(const std::vector<std::string>& arguments, const std::filesystem::path& folder, int output,
          pid_t& process) {
  FileActions actions;
  posix_spawn_file_actions_addchdir_np(actions.get(), folder.c_str());
  posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(actions.get(), output, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(actions.get(), output, STDERR_FILENO);
  std::vector<std::string> copies{"gnuplot"};
  copies.insert(copies.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& copy : copies) {
    pointers.push_back(copy.data());
  }
  pointers.push_back(nullptr);
  return posix_spawnp(&process, "gnuplot", actions.get(), nullptr, pointers.data(), environ);
}

}  // namespace

Result<void> runGnuplot(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    return fail(std::string("cannot run gnuplot: ") + std::strerror(errno));
  }
  pid_t process = 0;
  const int error = spawn(arguments, folder, ends[1], process);
  close(ends[1]);
  const std::string output = error == 0 ? readToEnd(ends[0]) : std::string();
  close(ends[0]);
  if (error != 0) {
    return fail(kMissing);
  }
  const int status = waitFor(process);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return fail("gnuplot could not draw the figures: " + onOneLine(output));
  }
  return {};
}

}  // namespace scatter::lab
