#include "apps/program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace scatter::test {

namespace {

namespace fs = std::filesystem;

fs::path makeFolder() {
  std::string name = (fs::temp_directory_path() / "scatter-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("cannot make " + name);
  }
  return name;
}

void openAs(int descriptor, const fs::path& file) {
  const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (opened < 0 || dup2(opened, descriptor) < 0) {
    _exit(125);
  }
}

// In the child: never returns.
[[noreturn]] void becomeProgram(const Start& start, const fs::path& output, const fs::path& errors) {
  openAs(STDOUT_FILENO, output);
  openAs(STDERR_FILENO, errors);
  if (chdir(start.folder.c_str()) != 0) {
    _exit(125);
  }
  if (start.largestFile > 0) {
    const rlimit limit{start.largestFile, start.largestFile};
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  for (const auto& [name, value] : start.environment) {
    setenv(name.c_str(), value.c_str(), 1);
  }
  std::vector<std::string> words{start.program.string()};
  words.insert(words.end(), start.arguments.begin(), start.arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) {
    pointers.push_back(word.data());
  }
  pointers.push_back(nullptr);
  execv(start.program.c_str(), pointers.data());
  _exit(126);
}

bool hasLines(const fs::path& file, std::size_t lines) {
  const std::string text = fs::exists(file) ? readText(file) : "";
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) >= lines;
}

bool hasEnded(pid_t process) {
  siginfo_t info{};
  waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT);
  return info.si_pid == process;
}

void interruptOnce(const Start& start, pid_t process) {
  while (!hasLines(start.interruptOnce, start.lines) && !hasEnded(process)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  kill(process, start.signal);
}

}  // namespace

Outcome runProgram(const Start& start) {
  const fs::path scratch = makeFolder();
  const fs::path output = start.outputTo.empty() ? scratch / "output" : start.outputTo;
  const fs::path errors = scratch / "errors";
  const pid_t process = fork();
  if (process == 0) {
    becomeProgram(start, output, errors);
  }
  if (!start.interruptOnce.empty()) {
    interruptOnce(start, process);
  }
  int status = 0;
  waitpid(process, &status, 0);
  Outcome outcome;
  outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.output = start.outputTo.empty() ? readText(output) : "";
  outcome.errors = readText(errors);
  fs::remove_all(scratch);
  return outcome;
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string readText(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> columnOf(const fs::path& csv, const std::string& name) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : linesOf(readText(csv))) {
    std::istringstream stream(line);
    rows.emplace_back();
    for (std::string cell; std::getline(stream, cell, ',');) {
      rows.back().push_back(cell);
    }
  }
  std::vector<std::string> column;
  if (rows.empty()) {
    return column;
  }
  const auto found = std::find(rows[0].begin(), rows[0].end(), name);
  const auto index = static_cast<std::size_t>(found - rows[0].begin());
  for (std::size_t row = 1; row < rows.size(); ++row) {
    column.push_back(rows[row].at(index));
  }
  return column;
}

ProgramTest::ProgramTest() : folder(makeFolder()) {}

ProgramTest::~ProgramTest() {
  fs::remove_all(folder);
}

void ProgramTest::expectRefused(const Outcome& outcome, const std::string& part) const {
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.output, "");
  const auto lines = linesOf(outcome.errors);
  ASSERT_EQ(lines.size(), 1U) << outcome.errors;
  EXPECT_THAT(lines[0], testing::StartsWith("scatter: "));
  EXPECT_THAT(lines[0], testing::HasSubstr(part));
  EXPECT_TRUE(fs::is_empty(folder)) << "something was left behind";
}

}  // namespace scatter::test
