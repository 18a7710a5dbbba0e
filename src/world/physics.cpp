#include <scatter/world/physics.h>

namespace scatter {

namespace {

/// Has no state, so that all engines may share it, whatever thread they are in.
LevelSwitching& noSwitching() {
  static LevelSwitching none;
  return none;
}

}  // namespace

LevelSwitching& Physics::switching() {
  return noSwitching();
}

const LevelSwitching& Physics::switching() const {
  return noSwitching();
}

const PhysicsDiagnostics& Physics::diagnostics() const {
  static const PhysicsDiagnostics none;
  return none;
}

}  // namespace scatter
