#include "viewer/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

namespace scatter::viewer {
namespace {

Color ofHue(float hue, float saturation, float value) {
  const auto channel = [&](float shift) {
    const float wave = std::abs(std::fmod(hue + shift, 1.0F) * 6.0F - 3.0F) - 1.0F;
    return value * (1.0F - saturation * (1.0F - std::clamp(wave, 0.0F, 1.0F)));
  };
  return {channel(0.0F), channel(2.0F / 3.0F), channel(1.0F / 3.0F), 1.0F};
}

}  // namespace

Color levelColor(int level, int levelCount) {
  const float share =
      levelCount > 1 ? static_cast<float>(level - 1) / static_cast<float>(levelCount - 1) : 1.0F;
  return ofHue(0.36F * std::clamp(share, 0.0F, 1.0F), 0.75F, 0.95F);
}

Color costColor(float units) {
  static constexpr std::array<Color, 5> kColors{{{0.20F, 0.28F, 0.55F, 1.0F},
                                                 {0.20F, 0.65F, 0.45F, 1.0F},
                                                 {0.95F, 0.80F, 0.25F, 1.0F},
                                                 {0.95F, 0.25F, 0.15F, 1.0F},
                                                 {1.00F, 0.95F, 0.95F, 1.0F}}};
  const float scale = std::log(std::max(units, kLeastCost) / kLeastCost) / std::log(kMostCost / kLeastCost);
  const float at = std::min(scale, 1.0F) * static_cast<float>(kColors.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), kColors.size() - 2);
  return glm::mix(kColors[below], kColors[below + 1], at - static_cast<float>(below));
}

Color distinctColor(std::uint64_t number) {
  const float hue = std::fmod(0.58F + 0.61803399F * static_cast<float>(number % 4096), 1.0F);
  return ofHue(hue, 0.45F, number % 2 == 0 ? 0.85F : 0.70F);
}

Color gapColor(float share) {
  static constexpr std::array<glm::vec3, 5> kStops{{{0.16F, 0.30F, 0.72F},
                                                    {0.13F, 0.62F, 0.70F},
                                                    {0.42F, 0.75F, 0.30F},
                                                    {0.97F, 0.82F, 0.22F},
                                                    {0.86F, 0.16F, 0.12F}}};
  const float place = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kStops.size() - 1);
  const auto stop = std::min(static_cast<std::size_t>(place), kStops.size() - 2);
  return {glm::mix(kStops[stop], kStops[stop + 1], place - static_cast<float>(stop)), 1.0F};
}

}  // namespace scatter::viewer
