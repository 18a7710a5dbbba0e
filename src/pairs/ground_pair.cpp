#include "pairs/ground_pair.h"

namespace scatter::pairs {

void GroundPair::restart(float threshold, Manifolds& engine) {
  for (const GroundContact& contact : contacts) engine.release(contact.manifold);
  contacts.clear();
  parts.reset(threshold);
  quietUntil = Pair::kAwake;
  isSettled = hasRecycled = false;
  restarted = true;
  foresight = nullptr;
}

void GroundPair::renew() {
  contacts.clear();
  parts.reset(0.0F);
  region.forget();
  passage.forget();
  quietUntil = Pair::kAwake;
  jumps = 0;
  level = landing = 0;
  versions[0] = versions[1] = Pair::kNoParts;
  hasFallenBack = false;
  isTooFine = false;
  isSettled = hasRecycled = restarted = false;
  foresight = nullptr;
}

}  // namespace scatter::pairs
