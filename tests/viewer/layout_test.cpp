#include "viewer/layout.h"

#include <gtest/gtest.h>

#include <vector>

#include "viewer/panel_scale.h"

namespace scatter::viewer {
namespace {

const std::vector<glm::ivec2> kSizes{{1280, 720},  {1600, 900},  {1920, 1080},
                                     {2560, 1440}, {3840, 2160}, {1280, 1024}};

bool overlap(const Place& a, const Place& b) {
  const auto apart = [](float from, float size, float otherFrom, float otherSize) {
    return from + size <= otherFrom + 1e-3F || otherFrom + otherSize <= from + 1e-3F;
  };
  return !apart(a.corner.x, a.size.x, b.corner.x, b.size.x) &&
         !apart(a.corner.y, a.size.y, b.corner.y, b.size.y);
}

/// All panels, with something picked.
std::vector<Place> panelsOf(const Layout& layout) {
  return {layout.lab(), layout.numbers(true), layout.inspector(), layout.time()};
}

TEST(Layout, WorldsHaveTwoThirdsOfTheWidth) {
  const OpenPanels all;
  for (const glm::ivec2& size : kSizes) {
    for (const std::size_t panes : {1U, 2U}) {
      const Layout layout(size, panes, &all);
      const float width = static_cast<float>(panes) * layout.size().x;
      EXPECT_GE(width, 2.0F / 3.0F * static_cast<float>(size.x)) << size.x;
      EXPECT_GE(layout.size().y, 0.85F * static_cast<float>(size.y)) << size.x;
    }
    EXPECT_FALSE(Layout::isNarrow(size));
  }
  EXPECT_TRUE(Layout::isNarrow({1024, 768}));
}

TEST(Layout, PanelsFitTheWindowAndNothingOverlaps) {
  for (const glm::ivec2& size : kSizes) {
    for (const bool open : {true, false}) {
      const OpenPanels panels{open, open, open};
      const Layout layout(size, 2, &panels);
      std::vector<Place> places = panelsOf(layout);
      if (open) {
        for (std::size_t pane = 0; pane < 2; ++pane) places.push_back({layout.corner(pane), layout.size()});
      }
      for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_GE(places[i].corner.x, 0.0F);
        EXPECT_GE(places[i].corner.y, 0.0F);
        EXPECT_LE(places[i].corner.x + places[i].size.x, static_cast<float>(size.x) + 1e-3F);
        EXPECT_LE(places[i].corner.y + places[i].size.y, static_cast<float>(size.y) + 1e-3F);
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_FALSE(overlap(places[i], places[j])) << size.x << ": " << i << ", " << j;
      }
    }
  }
}

TEST(Layout, WhatIsFoldedGivesItsRoomToTheWorlds) {
  const glm::ivec2 size(1280, 720);
  const OpenPanels none{false, false, false};
  const Layout folded(size, 1, &none);
  EXPECT_EQ(folded.size().x, 1280.0F);
  EXPECT_LT(folded.lab().size.y, 40.0F);
  EXPECT_LT(folded.numbers(false).size.y, 40.0F);
  EXPECT_GT(folded.size().y, 680.0F);
  EXPECT_EQ(Layout(size, 1, nullptr).size().y, 720.0F);
}

TEST(PanelScale, LettersGrowWithTheWindow) {
  EXPECT_EQ(panelScale({1280, 720}), 1.0F);
  EXPECT_EQ(panelScale({640, 400}), 1.0F);
  EXPECT_EQ(panelScale({1920, 1080}), 1.5F);
  EXPECT_EQ(panelScale({2560, 1440}), 2.0F);
  EXPECT_EQ(panelScale({3840, 2160}), 3.0F);
  EXPECT_EQ(panelScale({3840, 720}), 1.0F);
}

}  // namespace
}  // namespace scatter::viewer
