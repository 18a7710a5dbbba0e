#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

namespace scatter::lod {

/// A change of a pair's level that can be bought.
struct Offer {
  float price = 0.0F;      ///< Benefit for a unit of cost, above 0: what a unit may cost at most.
  float cost = 0.0F;       ///< Units, above 0.
  std::uint32_t pair = 0;  ///< The buyer's number for it.
  std::uint8_t level = 0;  ///< Where it leads.
};

/// The price above which everything is bought. At exactly the price, first come, first served.
class PriceCut {
 public:
  PriceCut() = default;  ///< Everything is bought.
  PriceCut(std::uint32_t key, double room) : key_(key), room_(room) {}

  /// Buys, as long as there is room for it.
  [[nodiscard]] bool take(const Offer& offer) {
    const std::uint32_t key = keyOf(offer.price);
    if (key != key_) return key > key_;
    if (offer.cost > room_) return false;
    room_ -= offer.cost;
    return true;
  }

  /// The leading bits of a positive float are in the order of the numbers: logarithmic buckets, 1/2048 wide.
  static constexpr std::uint32_t kFineBits = 8;
  [[nodiscard]] static std::uint32_t keyOf(float price) {
    constexpr std::uint32_t kDroppedBits = 12;
    assert(price > 0.0F);
    return std::bit_cast<std::uint32_t>(price) >> kDroppedBits;
  }

 private:
  std::uint32_t key_ = 0;
  double room_ = 0.0;  ///< For what costs exactly the price.
};

/// Finds the price at which what is bought fits into a room. Linear in the number of offers: no sort.
class PriceSearch {
 public:
  [[nodiscard]] PriceCut find(std::span<const Offer> offers, double room);

 private:
  std::vector<double> costs_;  ///< By bucket of prices.
};

}  // namespace scatter::lod
