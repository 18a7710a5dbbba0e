#pragma once

#include <gtest/gtest.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace scatter::test {

struct Outcome {
  int status = -1;  ///< Exit status; 128 + the signal that ended it.
  std::string output;
  std::string errors;
};

/// How to start the program.
struct Start {
  std::vector<std::string> arguments;
  std::filesystem::path folder;                      ///< Where it runs.
  std::map<std::string, std::string> environment{};  ///< On top of this process's.
  std::filesystem::path outputTo{};                  ///< Instead of Outcome::output.
  /// Sends `signal` as soon as this file has so many lines.
  std::filesystem::path interruptOnce{};
  std::size_t lines = 1;
  int signal = SIGINT;
  std::size_t largestFile = 0;  ///< Bytes that fit into a file, as if the disk were full then; 0: any.
  std::filesystem::path program = SCATTER_PROGRAM;  ///< The one that this build made, or a copy of it.
};

/// Runs the scatter program to its end.
[[nodiscard]] Outcome runProgram(const Start& start);

/// Lines without their ends.
[[nodiscard]] std::vector<std::string> linesOf(const std::string& text);
[[nodiscard]] std::string readText(const std::filesystem::path& file);

/// The cells of one column of a CSV file, without its name.
[[nodiscard]] std::vector<std::string> columnOf(const std::filesystem::path& csv, const std::string& name);

/// Gives each test an empty folder to run the program in.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  [[nodiscard]] Outcome scatter(std::vector<std::string> arguments) const {
    return runProgram({.arguments = std::move(arguments), .folder = folder});
  }

  /// Status 2, one line "scatter: …" that holds `part`, and nothing written.
  void expectRefused(const Outcome& outcome, const std::string& part) const;

  std::filesystem::path folder;
};

}  // namespace scatter::test
