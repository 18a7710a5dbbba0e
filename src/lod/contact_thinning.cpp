#include "lod/contact_thinning.h"

#include <algorithm>
#include <cmath>

namespace scatter::lod {
namespace {

// Eight of a direction bear bodies as all of them do. With four stacks tremble at some centimetres a second,
// and hardly anything is saved in addition.
constexpr ThinningRule kRule{.mostAlike = 8, .leastContacts = 12};

// Of the budget: from where on contacts are spared, before any detail is taken.
constexpr double kFrom = 0.88;

// Of the spare contacts: so many more are hidden than are needed, and twice as many must be too many before
// some are shown again: what rests would tremble if contacts came and went.
constexpr double kMore = 0.05;

// Steps from one look to the next as long as there is nothing to spare: looking goes through all contacts.
constexpr int kTryEvery = 4;

}  // namespace

bool ContactThinning::concerns(int contacts) {
  return contacts >= kRule.leastContacts;
}

double ContactThinning::expected(int contacts) const {
  return spare_.spare == 0 ? 0.0 : each_ * contacts * spare_.spare / spare_.contacts;
}

void ContactThinning::settle(double full, double budget, const Find& find) {
  spare_ = {};
  hidden_ = 0;
  const double excess = full - kFrom * budget;
  if (share_ == 0.0 && (excess <= 0.0 || --stepsToTry_ > 0)) return;
  spare_ = find(kRule);
  if (spare_.spare == 0) {
    share_ = 0.0;
    needs_ = {};
    stepsToTry_ = kTryEvery;
    return;
  }
  adjustShare(std::clamp(excess / mostSaved(), 0.0, 1.0));
  hidden_ = static_cast<int>(std::ceil(share_ * spare_.spare));
}

void ContactThinning::adjustShare(double needed) {
  needs_.add(needed);
  const double most = needs_.at(1.0);
  const bool isTooMuch = most + 2.0 * kMore < share_ || most == 0.0;
  if (needed > share_ || isTooMuch) share_ = most > 0.0 ? std::min(most + kMore, 1.0) : 0.0;
}

}  // namespace scatter::lod
