#include "messages.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

#include "interrupt.h"

namespace scatter::app {

namespace {

spdlog::logger& logger() {
  static const std::shared_ptr<spdlog::logger> instance = [] {
    auto made =
        std::make_shared<spdlog::logger>("scatter", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    made->set_pattern("scatter: %v");
    made->flush_on(spdlog::level::info);
    return made;
  }();
  return *instance;
}

std::string onOneLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
    text.pop_back();
  }
  for (char& c : text) {
    c = c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  }
  return text;
}

}  // namespace

void printError(const std::string& message) {
  logger().error("{}", onOneLine(message));
}

void printNote(const std::string& message) {
  logger().info("{}", onOneLine(message));
}

void printNotes(const std::vector<std::string>& messages) {
  for (const std::string& message : messages) printNote(message);
}

ExitStatus refuse(const Error& error) {
  printError(error.message);
  return error.kind == ErrorKind::kDiskFull ? ExitStatus::kFailed : ExitStatus::kBadInput;
}

ExitStatus failed(const Error& error) {
  printError(error.message);
  return ExitStatus::kFailed;
}

ExitStatus endedBy(const Error& error, bool started) {
  const ExitStatus status = started ? failed(error) : refuse(error);
  return interruptingSignal() != 0 ? signalStatus() : status;
}

ExitStatus signalStatus() {
  return static_cast<ExitStatus>(static_cast<int>(ExitStatus::kSignalled) + interruptingSignal());
}

}  // namespace scatter::app
