#pragma once

#include <OgrePrerequisites.h>
#include <OgreRenderOperation.h>

#include <glm/mat4x4.hpp>

#include "viewer/drawing/shading.h"

namespace scatter::viewer {

/// How something is drawn with the shader for items or the one for painted meshes.
struct OgreState {
  bool blended = false;
  bool depthTested = true;
  bool depthWritten = true;
  bool culled = false;  ///< Backs are not seen.
  bool wireframe = false;
  bool shadowed = false;   ///< An item that shadows fall on, after setShadows().
  float lineWidth = 1.0F;  ///< Pixels, also of points.
};

/// The shaders, as passes that draw at once whatever they are given.
class OgreShading {
 public:
  /// Throws Ogre::Exception if they do not compile.
  explicit OgreShading(Ogre::SceneManager& scene);

  void setCamera(const glm::mat4& view, const glm::mat4& projection, const LightInView& light);

  /// Where shadows of items fall on items, for the camera that is set. False if the card cannot do that.
  [[nodiscard]] bool setShadows(const ShadowMap& map, const ShadowsInView& shadows);

  void drawItem(Ogre::RenderOperation& operation, const glm::mat4& model, const ItemLook& look,
                const OgreState& state);
  void drawPainted(Ogre::RenderOperation& operation, const OgreState& state);

 private:
  void makeShadowed();
  void draw(Ogre::RenderOperation& operation, Ogre::Pass& pass, const OgreState& state);

  Ogre::SceneManager& scene_;
  Ogre::Pass* item_;
  Ogre::Pass* shadowed_ = nullptr;
  Ogre::TexturePtr shadowMap_;
  Ogre::Pass* painted_;
  glm::mat4 view_{1.0F};
  glm::mat4 projection_{1.0F};
};

}  // namespace scatter::viewer
