#pragma once

#include <glm/mat4x4.hpp>
#include <string>

#include "viewer/drawing/shadow_map.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

/// The light of a view, in the camera's axes.
struct LightInView {
  Vec3 toLight{0.0F, 0.0F, 1.0F};  ///< A unit vector.
  Vec3 up{0.0F, 1.0F, 0.0F};       ///< The world's.
  Crowd crowd{};                   ///< Its centre in the camera's axes.
};

[[nodiscard]] LightInView lightOf(const View& view);

/// A shadow map as the shader sees it.
struct ShadowsInView {
  glm::mat4 fromCamera{1.0F};  ///< To ShadowMap::fromWorld().
  float lift = 0.0F;           ///< ShadowMap::lift().
};

[[nodiscard]] ShadowsInView shadowsOf(const View& view, const ShadowMap& map);

/// How the shader sees an item.
struct ItemLook {
  Color color{1.0F};
  float glow = 0.0F;
  float flat = 0.0F;      ///< 1: `color` alone, for shadows.
  float twoSided = 0.0F;  ///< 1: light the side that is seen.
};

/// Light is worked out at the vertices: a key light with a highlight, and an ambient one that is brighter and
/// colder from above, which reaches no vertex that the mesh itself hides, and less inside a crowd. GLSL 1.10,
/// in the camera's axes. gl_Color is the mesh's colour with 1 - occlusion as alpha. Uniforms: toLight,
/// worldUp, crowd (centre, radius), crowdShade, itemColor, itemLook (glow, flat, twoSided). A renderer puts
/// before it what toClip and toCamera (matrices) and turnNormal (a macro, to the camera's axes) are.
extern const char* const kItemVertexShader;

/// In front of the shaders of items: the key light reaches no pixel in a shadow. More uniforms: toShadow,
/// lift (ShadowsInView), and shadowMap, a ShadowMap's texels as red, green and blue, not smoothed.
[[nodiscard]] std::string shadowed(const char* shader);

/// The colour of the vertices, for lines and scenery. Only toClip is needed.
extern const char* const kPaintedVertexShader;

/// For all of them.
extern const char* const kPixelShader;

}  // namespace scatter::viewer
