#pragma once

#include <sys/types.h>

#include <string>

namespace scatter::test {

/// An X server without a screen, of its own, so that tests that run at the same time do not meet. DISPLAY
/// names it as long as this lives.
class Xvfb {
 public:
  /// Throws std::runtime_error if there is no Xvfb.
  Xvfb();
  Xvfb(const Xvfb&) = delete;
  Xvfb& operator=(const Xvfb&) = delete;
  ~Xvfb();

 private:
  pid_t process_ = -1;
  std::string before_;
};

}  // namespace scatter::test
