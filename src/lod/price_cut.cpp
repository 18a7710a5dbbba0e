#include "lod/price_cut.h"

#include <algorithm>
#include <cstddef>

namespace scatter::lod {
namespace {

constexpr std::uint32_t kFineBuckets = 1U << PriceCut::kFineBits;
constexpr std::uint32_t kCoarseBuckets = 1U << 11U;

double sumOf(std::span<const Offer> offers) {
  double sum = 0.0;
  for (const Offer& offer : offers) sum += static_cast<double>(offer.cost);
  return sum;
}

// The dearest bucket that does not fit any more, and what is left for it; 0 if all fit.
std::uint32_t firstWithoutRoom(std::span<const double> costs, double& room) {
  for (auto bucket = static_cast<std::uint32_t>(costs.size()); bucket-- > 0;) {
    if (costs[bucket] > room) return bucket;
    room -= costs[bucket];
  }
  return 0;
}

}  // namespace

PriceCut PriceSearch::find(std::span<const Offer> offers, double room) {
  room = std::max(room, 0.0);
  // Most often all of them fit, or there is none: to clear the buckets takes longer than to see that.
  if (sumOf(offers) <= room) return {};
  costs_.assign(kCoarseBuckets, 0.0);
  for (const Offer& offer : offers) costs_[PriceCut::keyOf(offer.price) >> PriceCut::kFineBits] += offer.cost;
  const std::uint32_t coarse = firstWithoutRoom(costs_, room);
  if (coarse == 0) return {};

  // Within that bucket, by the next bits.
  costs_.assign(kFineBuckets, 0.0);
  for (const Offer& offer : offers) {
    const std::uint32_t key = PriceCut::keyOf(offer.price);
    if (key >> PriceCut::kFineBits == coarse) costs_[key % kFineBuckets] += offer.cost;
  }
  const std::uint32_t fine = firstWithoutRoom(costs_, room);
  return {(coarse << PriceCut::kFineBits) + fine, room};
}

}  // namespace scatter::lod
