#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace scatter::test {

/// Damages XML files in the ways that editors, exporters and disks do. The same seed, the same damage.
class XmlMutator {
 public:
  explicit XmlMutator(std::uint64_t seed) : random_(seed) {}

  /// One to three mutations.
  [[nodiscard]] std::string mutate(std::string text);

 private:
  [[nodiscard]] std::size_t below(std::size_t limit);
  [[nodiscard]] std::string mutateOnce(std::string text);
  [[nodiscard]] std::string flipByte(std::string text);
  [[nodiscard]] std::string cutRange(std::string text);
  [[nodiscard]] std::string replaceNumber(std::string text);

  /// Removes an element, puts a copy of it into another one, or gives it an attribute of another one, so that
  /// links lead elsewhere or back.
  [[nodiscard]] std::string changeTree(const std::string& text);

  std::mt19937_64 random_;
};

}  // namespace scatter::test
