#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace scatter::recording {

/// The CRC of eight bits with the polynomial x^8 + x^2 + x + 1 of a run of words: words that differ in one
/// bit, in two within 127, or in several within eight never have the same.
[[nodiscard]] std::uint8_t checkOf(std::span<const std::uint32_t> words);

/// A 64-bit hash, fed word by word. Each step can be undone, so that what differs in one word never agrees.
class WordHash {
 public:
  void add(std::uint64_t word) {
    hash_ = (hash_ ^ word) * 0x9e3779b97f4a7c15U;
    hash_ ^= hash_ >> 29U;
  }
  void add(std::span<const std::uint32_t> words) {
    for (const std::uint32_t word : words) add(word);
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// Of bytes, by words of eight.
[[nodiscard]] std::uint64_t hashOf(std::string_view bytes);

}  // namespace scatter::recording
