#include "lod/price_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "lod/fake_engine.h"

namespace scatter::lod {
namespace {

using testing::Random;

std::vector<Offer> randomOffers(Random& random, int count) {
  std::vector<Offer> offers;
  for (int i = 0; i < count; ++i) {
    offers.push_back({static_cast<float>(0.001 + random.exponential() * random.exponential()),
                      static_cast<float>(0.01 + random.exponential())});
  }
  return offers;
}

/// What is bought, dearest price first.
double spend(const std::vector<Offer>& offers, PriceCut cut) {
  double total = 0.0;
  for (const Offer& offer : offers) total += cut.take(offer) ? offer.cost : 0.0;
  return total;
}

TEST(PriceSearch, BuysEverythingIfThereIsRoom) {
  Random random(1);
  const std::vector<Offer> offers = randomOffers(random, 100);
  PriceSearch search;
  PriceCut cut = search.find(offers, 1e6);
  for (const Offer& offer : offers) EXPECT_TRUE(cut.take(offer));
}

TEST(PriceSearch, BuysNothingWithoutRoom) {
  Random random(1);
  const std::vector<Offer> offers = randomOffers(random, 100);
  PriceSearch search;
  EXPECT_EQ(spend(offers, search.find(offers, 0.0)), 0.0);
  EXPECT_EQ(spend(offers, search.find(offers, -5.0)), 0.0);
}

TEST(PriceSearch, TakesAnEmptyMarket) {
  PriceSearch search;
  EXPECT_TRUE(search.find({}, 1.0).take({1.0F, 1.0F}));
}

TEST(PriceSearch, IsAsGoodAsSorting) {
  Random random(2);
  PriceSearch search;
  for (int i = 0; i < 300; ++i) {
    std::vector<Offer> offers = randomOffers(random, 1 + static_cast<int>(random.uniform(0.0, 400.0)));
    double all = 0.0;
    for (const Offer& offer : offers) all += offer.cost;
    const double room = all * random.uniform(0.0, 1.1);
    PriceCut cut = search.find(offers, room);
    double spent = 0.0;
    double benefit = 0.0;
    for (const Offer& offer : offers) {
      if (!cut.take(offer)) continue;
      spent += offer.cost;
      benefit += offer.cost * offer.price;
    }
    EXPECT_LE(spent, room * (1.0 + 1e-6));

    // Greedy until the first that does not fit.
    std::sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) { return a.price > b.price; });
    double left = room;
    double best = 0.0;
    for (const Offer& offer : offers) {
      if (offer.cost > left) break;
      left -= offer.cost;
      best += offer.cost * offer.price;
    }
    EXPECT_GE(benefit, best * (1.0 - 1e-3));
  }
}

TEST(PriceSearch, OfEqualsTheFirstOnesAreBought) {
  const std::vector<Offer> offers(10, Offer{0.5F, 2.0F});
  PriceSearch search;
  PriceCut cut = search.find(offers, 7.0);
  std::vector<bool> taken;
  for (const Offer& offer : offers) taken.push_back(cut.take(offer));
  EXPECT_EQ(taken, (std::vector<bool>{true, true, true, false, false, false, false, false, false, false}));
}

}  // namespace
}  // namespace scatter::lod
