#include "io/write_all.h"

#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <string>
#include <thread>

namespace scatter {
namespace {

/// A pipe, which takes some 64 KiB at a time.
class Pipe {
 public:
  Pipe() { EXPECT_EQ(::pipe(ends_.data()), 0); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    ::close(reading());
    endWriting();
  }

  void endWriting() {
    if (writing() >= 0) ::close(writing());
    ends_[1] = -1;
  }

  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{};
};

/// Signals that do nothing but interrupt system calls, for as long as it lives.
class Interruptions {
 public:
  Interruptions() {
    struct sigaction action {};
    action.sa_handler = [](int) {};
    EXPECT_EQ(::sigaction(SIGUSR1, &action, &before_), 0);
  }
  Interruptions(const Interruptions&) = delete;
  Interruptions& operator=(const Interruptions&) = delete;
  ~Interruptions() { ::sigaction(SIGUSR1, &before_, nullptr); }

 private:
  struct sigaction before_ {};
};

std::string numbers(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::to_string(i) + '\n';
  return text;
}

/// Of a full pipe whose writer waits for room: the first takes it out of a call that has written a part, the
/// others out of calls that have written nothing.
void interrupt(std::thread& writer) {
  constexpr int kTimes = 10;
  for (int i = 0; i < kTimes; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    ::pthread_kill(writer.native_handle(), SIGUSR1);
  }
}

std::string readToTheEnd(int descriptor) {
  std::string all;
  std::array<char, 4096> piece{};
  for (ssize_t count = 1; count > 0;) {
    count = ::read(descriptor, piece.data(), piece.size());
    if (count > 0) all.append(piece.data(), static_cast<std::size_t>(count));
  }
  return all;
}

TEST(WriteAll, WritesOnAfterItWasInterrupted) {
  const Interruptions interruptions;
  Pipe pipe;
  const std::string text = numbers(200000);
  std::atomic<bool> hasRead = false;
  int error = -1;
  std::thread writer([&] {
    error = writeAll(pipe.writing(), text);
    pipe.endWriting();
    while (!hasRead) std::this_thread::yield();
  });
  interrupt(writer);
  const std::string read = readToTheEnd(pipe.reading());
  hasRead = true;
  writer.join();
  EXPECT_EQ(error, 0);
  EXPECT_TRUE(read == text) << "of " << text.size() << " bytes " << read.size() << " have come";
}

TEST(WriteAll, SaysWhatTheSystemSays) {
  EXPECT_EQ(writeAll(-1, "text"), EBADF);
}

TEST(WriteAll, HasNothingToDoWithoutText) {
  EXPECT_EQ(writeAll(-1, ""), 0);
}

}  // namespace
}  // namespace scatter
