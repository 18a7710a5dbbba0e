#include "io/collada/levels.h"

#include <pugixml.hpp>
#include <string>
#include <utility>

#include "io/collada/shapes.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

Result<void> readMargin(const ColladaFrame& frame, const pugi::xml_node& levels, LevelSetDef& def) {
  const pugi::xml_attribute attribute = levels.attribute("margin");
  if (!attribute) {
    return {};
  }
  const auto margin = parseNumber(attribute.value());
  if (!margin || !(*margin >= 0.0 && *margin <= ColladaFrame::kMaxLength)) {
    return frame.xml().failAt(levels,
                              "margin " + inQuotes(attribute.value()) + " is not a length of 0 or more");
  }
  def.hullMargin = frame.toMeters(*margin);
  return {};
}

/// `count` is that of all levels; the finest stands outside the element.
Result<void> checkLevelCount(const ColladaFrame& frame, const pugi::xml_node& levels, std::uint32_t found) {
  const auto count = frame.indexAttribute(levels, "count", found);
  if (!count) {
    return tl::unexpected(count.error());
  }
  if (*count != found) {
    return frame.xml().failAt(levels, "should hold " + std::to_string(*count) +
                                          " levels with the body's own shapes, but holds " +
                                          std::to_string(found));
  }
  if (found == 1 && !levels.attribute("count")) {
    return frame.xml().failAt(levels, "has no <level>; list the coarser levels or leave the element out");
  }
  return {};
}

Result<void> readCoarserLevels(const ColladaFrame& frame, const pugi::xml_node& levels, LevelSetDef& def) {
  if (const auto margin = readMargin(frame, levels, def); !margin) {
    return margin;
  }
  std::uint32_t expected = 1;
  for (const pugi::xml_node& node : levels.children("level")) {
    const auto index = frame.indexAttribute(node, "index", 0);
    if (!index) {
      return tl::unexpected(index.error());
    }
    if (*index != expected) {
      return frame.xml().failAt(node, "should have index=\"" + std::to_string(expected) +
                                          "\"; levels are numbered from 1, the coarsest, in order");
    }
    auto level = readShapes(frame, node);
    if (!level) {
      return tl::unexpected(level.error());
    }
    def.levels.push_back(std::move(*level));
    ++expected;
  }
  return checkLevelCount(frame, levels, expected);
}

}  // namespace

pugi::xml_node scatterChild(const pugi::xml_node& parent, const char* name) {
  for (const pugi::xml_node& extra : parent.children("extra")) {
    const pugi::xml_node technique = extra.find_child_by_attribute("technique", "profile", "SCATTER");
    if (const pugi::xml_node child = technique.child(name)) {
      return child;
    }
  }
  return {};
}

pugi::xml_node findLevels(const pugi::xml_node& body) {
  return scatterChild(body, "levels");
}

Result<std::shared_ptr<const LevelSet>> readLevels(const ColladaFrame& frame, const pugi::xml_node& body,
                                                   const std::string& name) {
  LevelSetDef def;
  def.name = name;
  const pugi::xml_node coarser = findLevels(body);
  if (coarser) {
    if (const auto read = readCoarserLevels(frame, coarser, def); !read) {
      return tl::unexpected(read.error());
    }
  }
  auto finest = readShapes(frame, body.child("technique_common"));
  if (!finest) {
    return tl::unexpected(finest.error());
  }
  def.levels.push_back(std::move(*finest));
  auto levels = LevelSet::create(std::move(def));
  if (!levels) {
    return frame.xml().failAt(coarser ? coarser : body, levels.error().message);
  }
  return levels;
}

}  // namespace scatter::io
