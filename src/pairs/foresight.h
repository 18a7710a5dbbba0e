#pragma once

#include <cstdint>
#include <vector>

#include "collision/part_pair.h"
#include "pairs/pair_plan.h"

namespace scatter::pairs {

/// What a look at two parts has found out that needs no engine.
struct ChildLook {
  enum class State : std::uint8_t {
    kToldApart,    ///< By the axis that told them apart before.
    kBoundsApart,  ///< Their world bounds do not overlap.
    kMeasured,     ///< `verdict` is known, and `contact`.
    kExcused,      ///< They are on credit, and the contacts that are held are good.
    kOpen,         ///< It depends on the contacts that they have.
  };
  State state = State::kOpen;
  ChildVerdict verdict = ChildVerdict::kApart;
  PartContact contact{};
};

/// Tells the engine, in this order, what became of manifolds in a step that was made ahead.
struct ManifoldNote {
  void* manifold;
  bool isNew;  ///< It stands in for one that the engine is to make; otherwise it is to be released.
};

/// The step of a pair that was made ahead, beside other pairs: all that is left is to tell others of it.
struct StepAhead {
  PairOutcome outcome{};
  PairWork work{};
  std::vector<ManifoldNote> notes{};
};

/// What is found out about a pair before its step, beside other pairs, by foresee(): its neighbours and the
/// distances of its parts. Its step does the rest, to the same bits as if it had done everything.
struct Foresight {
  bool isAwake = false;    ///< What PartPair::advance() returned.
  bool isSettled = false;  ///< Nothing touches or is going to: the look at the pair has been ended, too.
  bool isDone = false;     ///< All contacts have been moved along, and no others are to be found.
  PairWork work{};         ///< What it took.
  bool recycles = false;   ///< Contacts that are not stale move along with the bodies.
  std::vector<void*> carried{};    ///< All contacts, if so, before anything was looked for.
  std::vector<void*> dropped{};    ///< Contacts of child pairs that are no neighbours any more.
  std::vector<void*> asked{};      ///< Of these, and of others that are none, whether they last was asked.
  std::vector<int> awake{};        ///< The child pairs that are to be looked at.
  std::vector<ChildLook> looks{};  ///< One for each of them.
};

}  // namespace scatter::pairs
