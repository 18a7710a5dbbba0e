#pragma once

#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "viewer/renderers.h"
#include "viewer/shapes.h"
#include "viewer/xvfb.h"

namespace scatter::test {

using viewer::Color;
using viewer::Image;
using viewer::InputEvent;
using viewer::Item;
using viewer::Key;
using viewer::MeshId;
using viewer::MouseButton;
using viewer::Picture;
using viewer::View;

inline constexpr Color kRed{1.0F, 0.0F, 0.0F, 1.0F};
inline constexpr Color kGreen{0.0F, 1.0F, 0.0F, 1.0F};
inline constexpr Color kBlue{0.0F, 0.0F, 1.0F, 1.0F};

/// A renderer with a window of 640 by 400 pixels on an X server of its own.
class RendererTest : public testing::TestWithParam<std::string> {
 protected:
  RendererTest() {
    if (GetParam() != "null") server_.emplace();
    viewer::WindowDef window;
    window.size = {640, 400};
    auto made = viewer::makeRenderer(GetParam(), window);
    if (!made) throw std::runtime_error(made.error().message);
    renderer_ = std::move(*made);
  }

  /// Shines in its own colour, so that pixels can be compared exactly.
  [[nodiscard]] static Item shining(MeshId mesh, const Vec3& position, const Color& color,
                                    float size = 1.0F) {
    Item item;
    item.mesh = mesh;
    item.pose.position = position;
    item.scale = Vec3(size);
    item.color = color;
    item.glow = 1.0F;
    return item;
  }

  /// Looks from +z at the origin, from 10 m: the window is 6.9 m high there. A black world.
  [[nodiscard]] static View viewFromFront() {
    View view;
    view.camera.fieldOfView = 2.0F * 0.334F;
    view.scenery.zenith = view.scenery.horizon = view.scenery.nadir = glm::vec3(0.0F);
    view.scenery.stars = false;
    return view;
  }

  [[nodiscard]] Image shoot(const Picture& picture, const viewer::Panels& panels = {}) {
    Image shot;
    (void)renderer_->pollInput();
    renderer_->draw(picture, panels, &shot);
    return shot;
  }

  [[nodiscard]] Image shoot(const View& view) {
    Picture picture;
    picture.views.push_back(view);
    return shoot(picture);
  }

  /// Polls and draws until an event of the kind comes. Fails the test if none does in 200 frames.
  [[nodiscard]] InputEvent await(InputEvent::Kind kind) {
    for (int i = 0; i < 200; ++i) {
      for (const InputEvent& event : renderer_->pollInput()) {
        if (event.kind == kind) return event;
      }
      renderer_->draw({}, {});
    }
    ADD_FAILURE() << "no event came";
    return {};
  }

  std::optional<Xvfb> server_;
  std::unique_ptr<viewer::Renderer> renderer_;
};

/// The colour of a pixel, 0 to 255.
[[nodiscard]] inline std::array<int, 3> at(const Image& image, int x, int y) {
  const std::uint8_t* pixel = image.pixel(x, y);
  return {pixel[0], pixel[1], pixel[2]};
}

inline constexpr std::array<int, 3> kBlackPixel{0, 0, 0};
inline constexpr std::array<int, 3> kRedPixel{255, 0, 0};
inline constexpr std::array<int, 3> kGreenPixel{0, 255, 0};
inline constexpr std::array<int, 3> kBluePixel{0, 0, 255};

/// The renderers of this build that have a window.
[[nodiscard]] inline std::vector<std::string> windowedRenderers() {
  std::vector<std::string> names = viewer::rendererNames();
  names.pop_back();  // null, which is always the last
  return names;
}

[[nodiscard]] inline std::string testName(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace scatter::test
