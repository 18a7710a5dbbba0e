#include "lod/contact_ladder.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace scatter::lod {
namespace {

// Eight of a direction bear bodies as all of them do, four nearly so: fewer tip over on uneven ground.
constexpr std::array kRungs{ContactRung{8, 32}, ContactRung{4, 12}};
constexpr int kHighest = static_cast<int>(kRungs.size());

// Of the budget. The first rung comes before any detail is taken, as it costs the eye nothing; the second
// only where the step would not fit otherwise.
constexpr double kFirst = 0.85;
constexpr double kFirstBack = 0.75;
constexpr double kSecond = 0.97;
constexpr double kSecondBack = 0.85;

// Steps in a row in which there must be room before contacts are shown again: bodies that settle would
// tremble if the choice changed to and fro.
constexpr int kPatience = 30;

// Steps from one look to the next as long as there is nothing to spare: looking goes through all contacts.
constexpr int kTryEvery = 4;

const ContactRung& at(int rung) {
  return kRungs[static_cast<std::size_t>(rung - 1)];
}

}  // namespace

bool ContactLadder::concerns(int contacts) const {
  return contacts >= at(std::max(rung_, 1)).leastContacts;
}

double ContactLadder::expected(int contacts) const {
  if (rung_ == 0 || spare_.contacts == 0) return 0.0;
  return each_ * contacts * spare_.hidden / spare_.contacts;
}

double ContactLadder::take(int rung, const Find& find) {
  rung_ = rung;
  spare_ = rung > 0 ? find(at(rung)) : SpareContacts{};
  return each_ * spare_.hidden;
}

double ContactLadder::settle(double full, double budget, const Find& find) {
  if (rung_ == 0 && (full <= kFirst * budget || --stepsToTry_ > 0)) return 0.0;
  double saved = take(rung_ > 0 ? rung_ : 1, find);
  if (rung_ < kHighest && full - saved > kSecond * budget) saved = take(rung_ + 1, find);
  const double load = rung_ == kHighest ? full - saved : full;
  const bool isLoose = load < (rung_ == kHighest ? kSecondBack : kFirstBack) * budget;
  looseSteps_ = isLoose ? looseSteps_ + 1 : 0;
  if (spare_.hidden == 0) {
    stepsToTry_ = kTryEvery;
    return take(0, find);
  }
  if (looseSteps_ < kPatience) return saved;
  looseSteps_ = 0;
  const int before = rung_;
  saved = take(before - 1, find);
  return full - saved <= kSecondBack * budget ? saved : take(before, find);
}

}  // namespace scatter::lod
