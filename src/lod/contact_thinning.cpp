#include "lod/contact_thinning.h"

namespace scatter::lod {
namespace {

// Eight of a direction bear bodies as all of them do. With four stacks tremble at some centimetres a second,
// and hardly anything is saved in addition.
constexpr ThinningRule kRule{.mostAlike = 8, .leastContacts = 12};

// Of the budget: from where on contacts are spared, before any detail is taken, and from where on not any
// more.
constexpr double kFrom = 0.85;
constexpr double kBack = 0.75;

// Steps in a row in which there must be room before all contacts are shown again: what rests would tremble if
// that went to and fro.
constexpr int kPatience = 30;

// Steps from one look to the next as long as there is nothing to spare: looking goes through all contacts.
constexpr int kTryEvery = 4;

}  // namespace

bool ContactThinning::concerns(int contacts) {
  return contacts >= kRule.leastContacts;
}

double ContactThinning::expected(int contacts) const {
  return spare_.hidden == 0 ? 0.0 : each_ * contacts * spare_.hidden / spare_.contacts;
}

double ContactThinning::settle(double full, double budget, const Find& find) {
  const bool wasThin = spare_.hidden > 0;
  spare_ = {};
  if (!wasThin && (full <= kFrom * budget || --stepsToTry_ > 0)) return 0.0;
  roomySteps_ = full < kBack * budget ? roomySteps_ + 1 : 0;
  if (roomySteps_ >= kPatience) return 0.0;
  spare_ = find(kRule);
  if (spare_.hidden == 0) stepsToTry_ = kTryEvery;
  return each_ * spare_.hidden;
}

}  // namespace scatter::lod
