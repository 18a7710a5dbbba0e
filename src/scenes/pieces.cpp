#include "scenes/pieces.h"

#include <string>
#include <utility>

#include "scenes/shape_measures.h"

namespace scatter {
namespace {

using Levels = std::shared_ptr<const LevelSet>;

Result<Levels> onePart(const ConvexPart& part, std::string name, float hullMargin) {
  LevelSetDef def;
  def.name = std::move(name);
  def.levels = {Level{{part}}};
  def.hullMargin = hullMargin;
  return LevelSet::create(std::move(def));
}

/// Bodies of one convex shape become a level set of it.
Result<Levels> wholeOf(const BodyDef& def) {
  if (const auto* levels = std::get_if<Levels>(&def.shape)) return *levels;
  ConvexPart part;
  if (const auto* box = std::get_if<Box>(&def.shape)) part.shape = *box;
  if (const auto* sphere = std::get_if<Sphere>(&def.shape)) part.shape = *sphere;
  if (const auto* capsule = std::get_if<Capsule>(&def.shape)) part.shape = *capsule;
  if (const auto* cylinder = std::get_if<Cylinder>(&def.shape)) part.shape = *cylinder;
  if (const auto* hull = std::get_if<ConvexHull>(&def.shape)) part.shape = *hull;
  return onePart(part, def.name, LevelSetDef{}.hullMargin);
}

}  // namespace

Result<Breakable> makePieces(const SceneFileObject& object, const BodyDef& def, float shrink,
                             SceneModels& models) {
  auto whole = wholeOf(def);
  if (!whole) return tl::unexpected(whole.error());
  Breakable breakable;
  breakable.whole = std::move(*whole);
  for (const SceneFileModel& gib : object.gibs) {
    const auto model = models.load(gib);
    if (!model) return tl::unexpected(model.error());
    breakable.gibs.push_back((*model)->levels);
  }
  if (!breakable.gibs.empty()) return breakable;
  const LevelSet& levels = *breakable.whole;
  for (const ConvexPart& part : levels.finest().parts) {
    auto piece = onePart(scaledPart(part, shrink), object.name, levels.hullMargin());
    if (!piece) return tl::unexpected(piece.error());
    breakable.gibs.push_back(std::move(*piece));
  }
  return breakable;
}

}  // namespace scatter
