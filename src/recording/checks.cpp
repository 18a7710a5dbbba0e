#include "recording/checks.h"

#include <cstring>

namespace scatter::recording {

namespace {

// How much each of the four bytes of a word adds to the check of the words up to it.
using Tables = std::array<std::array<std::uint8_t, 256>, 4>;

constexpr Tables makeTables() {
  constexpr unsigned kPolynomial = 0x07;
  Tables tables{};
  for (unsigned byte = 0; byte < 256; ++byte) {
    unsigned crc = byte;
    for (auto& table : tables) {
      for (int bit = 0; bit < 8; ++bit) {
        crc = (crc << 1U) ^ ((crc & 0x80U) != 0 ? kPolynomial : 0U);
      }
      crc &= 0xFFU;
      table[byte] = static_cast<std::uint8_t>(crc);
    }
  }
  return tables;
}

constexpr Tables kTables = makeTables();

}  // namespace

std::uint8_t checkOf(std::span<const std::uint32_t> words) {
  std::uint8_t check = 0;
  for (const std::uint32_t word : words) {
    check = static_cast<std::uint8_t>(kTables[3][(word & 0xFFU) ^ check] ^ kTables[2][(word >> 8U) & 0xFFU] ^
                                      kTables[1][(word >> 16U) & 0xFFU] ^ kTables[0][word >> 24U]);
  }
  return check;
}

std::uint64_t hashOf(std::string_view bytes) {
  WordHash hash;
  hash.add(bytes.size());
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t taken = bytes.size() < sizeof word ? bytes.size() : sizeof word;
    std::memcpy(&word, bytes.data(), taken);
    hash.add(word);
    bytes.remove_prefix(taken);
  }
  return hash.value();
}

}  // namespace scatter::recording
