#include "pairs/pair.h"

#include <utility>

namespace scatter::pairs {

void Pair::closeForesight(PairEngine& engine) {
  if (foresight == nullptr) return;
  for (void* manifold : foresight->carried) static_cast<void>(engine.carry(manifold));
  for (void* manifold : foresight->asked) static_cast<void>(engine.outlasts(manifold));
  for (void* manifold : foresight->dropped) engine.release(manifold);
  foresight = nullptr;
}

void Pair::dropContacts(PairEngine& engine) {
  closeForesight(engine);
  for (ChildPair& child : parts.children()) {
    if (child.contact != nullptr) engine.release(child.contact);
    child.contact = nullptr;
  }
  parts.reset(0.0F);
}

void Pair::dropAll(PairEngine& engine) {
  dropContacts(engine);
  held.release(engine);
}

void Pair::renew() {
  PartPair memory = std::move(parts);
  lod::CreditAccount account = std::move(credit.account);
  *this = Pair{};
  memory.reset(0.0F);
  account.close();
  parts = std::move(memory);
  credit.account = std::move(account);
}

}  // namespace scatter::pairs
