#pragma once

#include <scatter/world/collision.h>
#include <scatter/world/fidelity.h>
#include <scatter/world/observation.h>

namespace scatter {

/// What a debugger or a measurement is told of a world, beyond what every step counts. What is not
/// overridden tells nothing.
class PhysicsDiagnostics {
 public:
  PhysicsDiagnostics() = default;
  PhysicsDiagnostics(const PhysicsDiagnostics&) = delete;
  PhysicsDiagnostics& operator=(const PhysicsDiagnostics&) = delete;
  virtual ~PhysicsDiagnostics() = default;

  /// Fills `out` with what `parts` ask for, and empties the rest. Changes nothing in the world. The state is
  /// that after the last step and the calls since. An engine that cannot tell leaves `out` empty.
  virtual void observe(const ObservationParts& /*parts*/, Observation& out) const { out.clear(); }

  /// How true the contacts are to the finest shapes, now. Slow; call outside of what is timed. Changes
  /// nothing.
  [[nodiscard]] virtual FidelitySample measureFidelity() const { return {}; }

  /// Empty unless PhysicsDef::collision asks for verification.
  [[nodiscard]] virtual ContactReport contactReport() const { return {}; }

  /// All zero without the pair algorithm.
  [[nodiscard]] virtual CollisionMemory collisionMemory() const { return {}; }
};

}  // namespace scatter
