#include <scatter/recording/recording_writer.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <ctime>
#include <deque>
#include <iterator>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "io/growing_file.h"
#include "recording/info_coder.h"
#include "recording/recording_encoder.h"

namespace scatter {

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::size_t kMostWaiting = 64;  // frames
constexpr std::size_t kBatch = 16;        // To be woken costs as much as to code a frame of a hundred bodies.
constexpr std::chrono::milliseconds kLongestWait{250};

double cpuSecondsOfThisThread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

class RecordingWriter::Worker {
 public:
  Worker(std::unique_ptr<GrowingFile> file, const RecordingDef& def)
      : file_(std::move(file)), def_(def), encoder_(def), thread_([this] { work(); }) {}

  ~Worker() { close(); }

  FrameSample& next() {
    if (!filling_) filling_ = unused();
    return *filling_;
  }

  Result<void> add() {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return waiting_.size() < kMostWaiting || error_; });
    if (error_) return tl::unexpected(*error_);
    waiting_.push_back(std::move(filling_));
    const bool isTime = waiting_.size() == kBatch;
    lock.unlock();
    if (isTime) work_.notify_one();
    return {};
  }

  // The thread is gone afterwards.
  void close() {
    if (!thread_.joinable()) return;
    {
      const std::scoped_lock lock(mutex_);
      closing_ = true;
    }
    work_.notify_one();
    thread_.join();
  }

  Result<void> finish(const std::string& stopped) {
    close();
    if (error_) return tl::unexpected(*error_);
    const std::string end = recording::makeBlock(recording::BlockKind::kEnd, 0, 0, stopped);
    return file_->add(end).and_then([this] { return file_->finish(); });
  }

  [[nodiscard]] double threadSeconds() const { return seconds_; }

 private:
  std::unique_ptr<FrameSample> unused() {
    const std::scoped_lock lock(mutex_);
    if (unused_.empty()) return std::make_unique<FrameSample>();
    auto frame = std::move(unused_.back());
    unused_.pop_back();
    return frame;
  }

  void work() {
    for (bool last = false; !last;) {
      std::deque<std::unique_ptr<FrameSample>> frames;
      last = takeFrames(frames);
      for (auto& frame : frames) {
        code(*frame);
        frame->clear();
      }
      if (last || isLate()) write();
      seconds_ = cpuSecondsOfThisThread();
      const std::scoped_lock lock(mutex_);
      std::move(frames.begin(), frames.end(), std::back_inserter(unused_));
    }
  }

  // All that wait, maybe none. Whether there will be no more.
  bool takeFrames(std::deque<std::unique_ptr<FrameSample>>& frames) {
    std::unique_lock lock(mutex_);
    work_.wait_for(lock, kLongestWait, [this] { return waiting_.size() >= kBatch || closing_; });
    frames.swap(waiting_);
    const bool last = closing_;
    lock.unlock();
    room_.notify_one();
    return last;
  }

  void code(const FrameSample& frame) {
    if (encoder_.isEmpty()) begun_ = SteadyClock::now();
    encoder_.add(frame);
    if (encoder_.isFull()) write();
  }

  [[nodiscard]] bool isLate() const {
    const std::chrono::duration<double> since = SteadyClock::now() - begun_;
    return !encoder_.isEmpty() && since.count() >= def_.blockSeconds;
  }

  void write() {
    std::string bytes;
    for (const recording::EncodedBlock& block : encoder_.take()) bytes += block.bytes;
    if (bytes.empty() || error_) return;
    if (auto written = file_->add(bytes); !written) {
      {
        const std::scoped_lock lock(mutex_);
        error_ = written.error();
      }
      room_.notify_one();
    }
  }

  std::unique_ptr<GrowingFile> file_;
  RecordingDef def_;
  recording::RecordingEncoder encoder_;
  SteadyClock::time_point begun_{};
  std::unique_ptr<FrameSample> filling_;

  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable room_;
  std::deque<std::unique_ptr<FrameSample>> waiting_;
  std::vector<std::unique_ptr<FrameSample>> unused_;
  std::optional<Error> error_;
  bool closing_ = false;
  std::atomic<double> seconds_ = 0.0;
  std::thread thread_;  // the last, so that all else is there when it starts
};

RecordingWriter::RecordingWriter(std::unique_ptr<Worker> worker) : worker_(std::move(worker)) {}

RecordingWriter::~RecordingWriter() = default;

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path& file,
                                                                 const RecordingInfo& info,
                                                                 const RecordingDef& def) {
  auto growing = GrowingFile::create(file);
  if (!growing) return tl::unexpected(growing.error());
  const std::string start =
      std::string(recording::kFileStart) +
      recording::makeBlock(recording::BlockKind::kInfo, 0, 0, recording::encodeInfo(info));
  if (auto written = (*growing)->add(start); !written) return tl::unexpected(written.error());
  return std::unique_ptr<RecordingWriter>(
      new RecordingWriter(std::make_unique<Worker>(std::move(*growing), def)));
}

FrameSample& RecordingWriter::next() {
  return worker_->next();
}

Result<void> RecordingWriter::add() {
  return worker_->add();
}

Result<void> RecordingWriter::finish(const std::string& stopped) {
  return worker_->finish(stopped);
}

double RecordingWriter::threadSeconds() const {
  return worker_->threadSeconds();
}

}  // namespace scatter
