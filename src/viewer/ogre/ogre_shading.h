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
  float lineWidth = 1.0F;  ///< Pixels, also of points.
};

/// The two shaders, as passes that draw at once whatever they are given.
class OgreShading {
 public:
  /// Throws Ogre::Exception if they do not compile.
  explicit OgreShading(Ogre::SceneManager& scene);

  void setCamera(const glm::mat4& view, const glm::mat4& projection, const LightInView& light);

  void drawItem(Ogre::RenderOperation& operation, const glm::mat4& model, const ItemLook& look,
                const OgreState& state);
  void drawPainted(Ogre::RenderOperation& operation, const OgreState& state);

 private:
  void draw(Ogre::RenderOperation& operation, Ogre::Pass& pass, const OgreState& state);

  Ogre::SceneManager& scene_;
  Ogre::Pass* item_;
  Ogre::Pass* painted_;
  glm::mat4 view_{1.0F};
  glm::mat4 projection_{1.0F};
};

}  // namespace scatter::viewer
