#include "lab/names.h"

namespace scatter::lab {

std::string nameOf(WorldKind kind) {
  return kind == WorldKind::kStandard ? "standard" : "hybrid";
}

std::string nameOf(Policy policy) {
  switch (policy) {
    case Policy::kProximity:
      return "proximity";
    case Policy::kFinest:
      return "finest";
    case Policy::kCoarsest:
      return "coarsest";
    case Policy::kNone:
      return "none";
  }
  return "unknown";
}

std::string nameOf(Narrowphase narrowphase) {
  return narrowphase == Narrowphase::kScatter ? "scatter" : "engine";
}

std::string nameOf(ContactSolver solver) {
  return solver == ContactSolver::kWide ? "wide" : "engine";
}

std::string nameOf(PairMidphase midphase) {
  switch (midphase) {
    case PairMidphase::kWorldBoxes:
      return "world_boxes";
    case PairMidphase::kPartBoxes:
      return "part_boxes";
    case PairMidphase::kNeighbourList:
      return "neighbour_list";
  }
  return "unknown";
}

std::string nameOf(Switching switching) {
  return switching == Switching::kPair ? "pair" : "body";
}

std::string nameOf(LevelEventKind kind) {
  switch (kind) {
    case LevelEventKind::kRequested:
      return "requested";
    case LevelEventKind::kAcknowledged:
      return "acknowledged";
    case LevelEventKind::kBlocked:
      return "blocked";
    case LevelEventKind::kSwitched:
      return "switched";
    case LevelEventKind::kRetracted:
      return "retracted";
  }
  return "unknown";
}

}  // namespace scatter::lab
