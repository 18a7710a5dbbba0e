#pragma once

#include <cstddef>
#include <memory_resource>
#include <mutex>

namespace scatter {

/// Memory of many lists that grow and shrink: what one gives back another one takes, so that they need not
/// keep what they needed once, and steps take none of the system once the lists together have had their
/// greatest length. For any number of threads. Gives nothing back to the system before its end.
class ChildMemory final : public std::pmr::memory_resource {
 private:
  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    const std::scoped_lock lock(mutex_);
    return pools_.allocate(bytes, alignment);
  }
  void do_deallocate(void* memory, std::size_t bytes, std::size_t alignment) override {
    const std::scoped_lock lock(mutex_);
    pools_.deallocate(memory, bytes, alignment);
  }
  [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
    return this == &other;
  }

  std::mutex mutex_;
  std::pmr::unsynchronized_pool_resource pools_;
};

}  // namespace scatter
