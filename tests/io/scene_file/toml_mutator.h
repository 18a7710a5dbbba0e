#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace scatter::test {

/// Damages TOML files, the same way for the same seed.
class TomlMutator {
 public:
  explicit TomlMutator(std::uint64_t seed) : random_(seed) {}

  /// One to four mutations.
  [[nodiscard]] std::string mutate(std::string text);

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  void damageBytes(std::string& text);
  void replaceWord(std::string& text, bool number);
  void shuffleLines(std::string& text);
  void repeatPart(std::string& text);

  std::mt19937_64 random_;
};

}  // namespace scatter::test
