#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lod/policy.h"

namespace scatter::lod {

// Every policy has a definition, `Def`, with its parameters. `mistake()` says in a few words what is wrong
// between them; empty if nothing. Ranges of single parameters are in policy_catalog.h.

/// Coarse before contact (report, sections 3.4.4 and 4.5): asks for a coarse level for a pair that does not
/// touch yet and whose bodies approach each other, and stands by it through the first steps of the contact.
/// Looks at the velocities of the two centres along the line between them; beside what nothing moves, at the
/// speed.
class ProximityPolicy final : public NamedPolicy<ProximityPolicy> {
 public:
  static constexpr std::string_view kName = "proximity";
  static constexpr Scope kScope = Scope::kLocal;

  struct Def {
    int level = 1;
    float approach = 0.05F;  ///< Metres a second.
    int steps = 15;          ///< Of contact.

    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit ProximityPolicy(const Def& def) : def_(def) {}

  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  Def def_;
};

/// Fast collisions need less detail: the reaction is over before an error is noticed (report, section 3.4.1).
/// Importance falls with the relative speed of the two centres; on request, very fast pairs are coarse
/// (the report's "velocity over a threshold", section 3.4.4).
class SpeedPolicy final : public NamedPolicy<SpeedPolicy> {
 public:
  static constexpr std::string_view kName = "speed";
  static constexpr Scope kScope = Scope::kLocal;

  struct Def {
    float from = 5.0F;    ///< Metres a second.
    float to = 20.0F;     ///< Metres a second.
    float least = 0.1F;   ///< Importance.
    float coarse = 0.0F;  ///< Metres a second; 0: never.
    int level = 1;

    [[nodiscard]] std::string_view mistake() const { return to > from ? "" : R"("to" must be above "from")"; }
  };

  explicit SpeedPolicy(const Def& def) : def_(def) {}

  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  Def def_;
};

/// A viewer has time to look at a contact that lasts, and an object that rests on a gap looks wrong (report,
/// section 3.4.1): importance grows with the number of steps that a pair has been touching.
class ContactTimePolicy final : public NamedPolicy<ContactTimePolicy> {
 public:
  static constexpr std::string_view kName = "contact-time";
  static constexpr Scope kScope = Scope::kLocal;

  struct Def {
    int steps = 60;
    float most = 4.0F;  ///< Importance.

    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit ContactTimePolicy(const Def& def) : def_(def) {}

  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  Def def_;
};

/// "Erroneous collisions in the user's periphery are less likely to be detected" (O'Sullivan and Dingliana;
/// report, section 3.4.1). Looks at the smaller body of a pair: importance grows with its size on screen and
/// falls with the angle between it and the point that the viewer looks at; what is outside of the picture
/// counts least. Says nothing in a situation without a focus.
class FocusPolicy final : public NamedPolicy<FocusPolicy> {
 public:
  static constexpr std::string_view kName = "focus";
  static constexpr Scope kScope = Scope::kLocal;

  struct Def {
    float size = 0.1F;    ///< Radius on screen, in half heights of the picture.
    float angle = 10.0F;  ///< Degrees.
    float least = 0.05F;  ///< Importance.
    float most = 4.0F;    ///< Importance.

    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit FocusPolicy(const Def& def);

  void observe(const Situation& situation) override;
  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  /// A focus, made ready for many pairs.
  struct View {
    Vec3 eye{0.0F};
    Vec3 forward{0.0F};
    float halfHeight = 1.0F;  ///< Of the picture, at distance 1.
  };

  [[nodiscard]] float importance(const View& view, const BodyView& body) const;

  Def def_;
  float clearSlope_;  ///< Of the cone around the line of sight in which all counts in full.
  std::optional<View> view_;
};

/// What the user holds has the user's attention (report, section 3.4.1): pairs with a held body are always at
/// their finest level.
class HeldPolicy final : public NamedPolicy<HeldPolicy> {
 public:
  static constexpr std::string_view kName = "held";
  static constexpr Scope kScope = Scope::kLocal;

  struct Def {
    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit HeldPolicy(const Def& /*def*/) {}

  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;
};

/// The heavier, the more depends on a contact (local knowledge in the report's Figure 3.7): importance grows
/// with the square root of the lighter body's mass, or the heavier one's, against a reference. What nothing
/// moves counts as the heaviest.
class MassPolicy final : public NamedPolicy<MassPolicy> {
 public:
  static constexpr std::string_view kName = "mass";
  static constexpr Scope kScope = Scope::kLocal;

  struct Def {
    float reference = 0.0F;  ///< Kilograms; 0: the median of all bodies that can be moved.
    int heavier = 0;         ///< 1: looks at the heavier body.
    float most = 4.0F;       ///< Importance; the least is its inverse.

    [[nodiscard]] static std::string_view mistake() { return {}; }
  };

  explicit MassPolicy(const Def& def) : def_(def), reference_(def.reference) {}

  void observe(const Situation& situation) override;
  void advise(const Situation& situation, const PairView& pair, Wish& wish) const override;

 private:
  Def def_;
  float reference_;
  std::vector<float> masses_;
};

}  // namespace scatter::lod
