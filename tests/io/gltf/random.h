#pragma once

#include <scatter/io/physics_document.h>

#include <cstdint>
#include <random>

namespace scatter::test {

/// Sound documents that use all that a document can say. The same seed, the same documents.
class RandomDocuments {
 public:
  /// With what glTF alone can say of bodies: gravity factors and collision filters.
  explicit RandomDocuments(std::uint64_t seed, bool hasFilters = false)
      : random_(seed), hasFilters_(hasFilters) {}

  [[nodiscard]] PhysicsDocument next();

 private:
  [[nodiscard]] std::size_t below(std::size_t limit);
  [[nodiscard]] bool maybe() { return below(2) == 0; }
  [[nodiscard]] float between(float low, float high);
  [[nodiscard]] Vec3 vector(float largest);
  [[nodiscard]] Transform pose();
  [[nodiscard]] std::string name(const char* kind, std::size_t index);
  [[nodiscard]] VisualMesh mesh();
  [[nodiscard]] ConvexShape convexShape();
  [[nodiscard]] DocumentShape shape(const PhysicsDocument& document, bool convex);
  [[nodiscard]] std::shared_ptr<const LevelSet> levels(const DocumentModel& model);
  [[nodiscard]] DocumentModel model(const PhysicsDocument& document);
  [[nodiscard]] DocumentBody body(const PhysicsDocument& document);
  [[nodiscard]] DocumentJoint joint(const PhysicsDocument& document);
  [[nodiscard]] DocumentLimit limit();
  [[nodiscard]] DocumentMotion motion() { return static_cast<DocumentMotion>(below(3)); }
  [[nodiscard]] std::optional<std::size_t> material(const PhysicsDocument& document);
  [[nodiscard]] std::optional<float> mass();

  std::mt19937_64 random_;
  bool hasFilters_;
};

}  // namespace scatter::test
