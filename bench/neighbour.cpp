// Works in memory until it is stopped: what another program on the machine does to one that is measured.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

/// Marsaglia's xorshift: every access is somewhere else, and none waits for another one.
class Walk {
 public:
  explicit Walk(long megabytes) : words_(static_cast<std::size_t>(megabytes) * (std::size_t{1} << 17U), 1) {}

  void work() {
    constexpr int kAccesses = 1 << 20;
    for (int i = 0; i < kAccesses; ++i) {
      at_ ^= at_ << 13U;
      at_ ^= at_ >> 7U;
      at_ ^= at_ << 17U;
      words_[at_ % words_.size()] += at_;
    }
  }

 private:
  std::vector<std::uint64_t> words_;
  std::uint64_t at_ = 88172645463325252U;
};

}  // namespace

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  const long megabytes = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 256;
  const double seconds = argc > 2 ? std::strtod(argv[2], nullptr) : 0.0;
  if (argc > 3 || megabytes < 1 || !(seconds >= 0.0)) {
    std::fprintf(
        stderr,
        "usage: neighbour [MEGABYTES [SECONDS]]\nreads and writes so much memory here and there [256], "
        "all the time, or by turns for so many seconds and not\n");
    return 2;
  }
  Walk walk(megabytes);
  const std::chrono::duration<double> part(seconds);
  for (volatile bool goesOn = true; goesOn;) {
    const auto begin = Clock::now();
    do {
      walk.work();
    } while (Clock::now() - begin < part);
    std::this_thread::sleep_for(part);
  }
  return 0;
}
