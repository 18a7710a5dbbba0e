#pragma once

#include <vector>

#include "collision/part_pair.h"
#include "collision/part_query.h"
#include "pairs/contact_recycling.h"
#include "pairs/ground_look.h"
#include "pairs/held_contacts.h"

namespace scatter::pairs {

/// Memory that the steps of pairs use in turn, one step at a time; nothing is kept in it from one to the
/// next.
struct StepScratch {
  PairScratch parts{};
  PartQuery query{};
  HeldScratch held{};
  PartPair audit{};  ///< Of a look at the finest level from a coarser one.
  std::vector<int> looked{};

  /// How deep a contact that is held presses the bodies apart, and the parts that it is of.
  struct Press {
    int partA;
    int partB;
    float depth;
  };
  std::vector<Press> presses{};
  GroundScratch ground{};
  RecyclingScratch recycling{};
};

}  // namespace scatter::pairs
