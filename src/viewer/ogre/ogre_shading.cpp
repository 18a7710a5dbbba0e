#include "viewer/ogre/ogre_shading.h"

#include <Ogre.h>

#include <glm/matrix.hpp>
#include <string>

namespace scatter::viewer {

namespace {

constexpr const char* kMatrices = R"(
uniform mat4 toClip;
uniform mat4 toCamera;
uniform mat4 normals;
#define turnNormal(normal) ((normals * vec4((normal), 0.0)).xyz)
)";

void addProgram(const std::string& name, const std::string& source, Ogre::GpuProgramType type) {
  const auto program =
      Ogre::HighLevelGpuProgramManager::getSingleton().createProgram(name, Ogre::RGN_DEFAULT, "glsl", type);
  program->setSource(source);
  program->load();
  if (program->hasCompileError())
    OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR, name + " does not compile", "addProgram");
}

Ogre::Pass* makePass(const std::string& name, const std::string& pixelProgram = "Pixel") {
  const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(name, Ogre::RGN_DEFAULT);
  Ogre::Pass* pass = material->getTechnique(0)->getPass(0);
  pass->setVertexProgram(name + "Vertex");
  pass->setFragmentProgram(pixelProgram);
  pass->setPolygonModeOverrideable(false);
  material->load();
  if (material->getSupportedTechniques().empty())
    OGRE_EXCEPT(Ogre::Exception::ERR_RENDERINGAPI_ERROR, "no shaders", "makePass");
  return material->getTechnique(0)->getPass(0);
}

/// Ogre's matrices are stored by rows, OpenGL's by columns.
Ogre::Matrix4 toOgre(const glm::mat4& matrix) {
  Ogre::Matrix4 result;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) result[row][column] = matrix[column][row];
  }
  return result;
}

Ogre::Vector3 toOgre(const Vec3& vector) {
  return {vector.x, vector.y, vector.z};
}

}  // namespace

OgreShading::OgreShading(Ogre::SceneManager& scene) : scene_(scene) {
  addProgram("ItemVertex", std::string(kMatrices) + kItemVertexShader, Ogre::GPT_VERTEX_PROGRAM);
  addProgram("PaintedVertex", std::string("uniform mat4 toClip;\n") + kPaintedVertexShader,
             Ogre::GPT_VERTEX_PROGRAM);
  addProgram("Pixel", kPixelShader, Ogre::GPT_FRAGMENT_PROGRAM);
  item_ = makePass("Item");
  painted_ = makePass("Painted");
  try {
    makeShadowed();
  } catch (const Ogre::Exception&) {
    // A card that can do all the rest has its shadows on the ground.
    shadowed_ = nullptr;
  }
}

void OgreShading::makeShadowed() {
  addProgram("ShadowedVertex", shadowed((std::string(kMatrices) + kItemVertexShader).c_str()),
             Ogre::GPT_VERTEX_PROGRAM);
  addProgram("ShadowedPixel", shadowed(kPixelShader), Ogre::GPT_FRAGMENT_PROGRAM);
  shadowed_ = makePass("Shadowed", "ShadowedPixel");
  shadowMap_ = Ogre::TextureManager::getSingleton().createManual(
      "ShadowMap", Ogre::RGN_DEFAULT, Ogre::TEX_TYPE_2D, ShadowMap::kSize, ShadowMap::kSize, 0,
      Ogre::PF_A8R8G8B8, Ogre::TU_DYNAMIC_WRITE_ONLY_DISCARDABLE);
  Ogre::TextureUnitState* unit = shadowed_->createTextureUnitState();
  unit->setTexture(shadowMap_);
  unit->setTextureFiltering(Ogre::TFO_NONE);
  unit->setTextureAddressingMode(Ogre::TAM_CLAMP);
}

void OgreShading::setCamera(const glm::mat4& view, const glm::mat4& projection, const LightInView& light) {
  view_ = view;
  projection_ = projection;
  for (Ogre::Pass* pass : {item_, shadowed_}) {
    if (pass == nullptr) continue;
    const auto constants = pass->getVertexProgramParameters();
    constants->setNamedConstant("toLight", toOgre(light.toLight));
    constants->setNamedConstant("worldUp", toOgre(light.up));
    constants->setNamedConstant("crowd", Ogre::Vector4(toOgre(light.crowd.center), light.crowd.radius));
    constants->setNamedConstant("crowdShade", light.crowd.shade);
  }
  painted_->getVertexProgramParameters()->setNamedConstant("toClip", toOgre(projection * view));
}

bool OgreShading::setShadows(const ShadowMap& map, const ShadowsInView& shadows) {
  if (shadowed_ == nullptr) return false;
  const auto constants = shadowed_->getVertexProgramParameters();
  constants->setNamedConstant("toShadow", toOgre(shadows.fromCamera));
  constants->setNamedConstant("lift", shadows.lift);
  // Ogre only reads them.
  auto* texels = const_cast<std::uint32_t*>(map.texels().data());
  shadowMap_->getBuffer()->blitFromMemory(
      Ogre::PixelBox(ShadowMap::kSize, ShadowMap::kSize, 1, Ogre::PF_A8R8G8B8, texels));
  return true;
}

void OgreShading::drawItem(Ogre::RenderOperation& operation, const glm::mat4& model, const ItemLook& look,
                           const OgreState& state) {
  Ogre::Pass& pass = state.shadowed ? *shadowed_ : *item_;
  const auto constants = pass.getVertexProgramParameters();
  const glm::mat4 toCamera = view_ * model;
  const glm::mat4 normals(glm::inverse(glm::transpose(glm::mat3(toCamera))));
  constants->setNamedConstant("toClip", toOgre(projection_ * toCamera));
  constants->setNamedConstant("toCamera", toOgre(toCamera));
  constants->setNamedConstant("normals", toOgre(normals));
  constants->setNamedConstant("itemColor",
                              Ogre::Vector4(look.color.r, look.color.g, look.color.b, look.color.a));
  constants->setNamedConstant("itemLook", Ogre::Vector3(look.glow, look.flat, look.twoSided));
  draw(operation, pass, state);
}

void OgreShading::drawPainted(Ogre::RenderOperation& operation, const OgreState& state) {
  draw(operation, *painted_, state);
}

void OgreShading::draw(Ogre::RenderOperation& operation, Ogre::Pass& pass, const OgreState& state) {
  pass.setSceneBlending(state.blended ? Ogre::SBT_TRANSPARENT_ALPHA : Ogre::SBT_REPLACE);
  pass.setDepthCheckEnabled(state.depthTested);
  pass.setDepthWriteEnabled(state.depthWritten);
  pass.setCullingMode(state.culled ? Ogre::CULL_CLOCKWISE : Ogre::CULL_NONE);
  pass.setPolygonMode(state.wireframe ? Ogre::PM_WIREFRAME : Ogre::PM_SOLID);
  pass.setLineWidth(state.lineWidth);
  pass.setPointSize(state.lineWidth);
  Ogre::RenderSystem& system = *Ogre::Root::getSingleton().getRenderSystem();
  scene_._setPass(&pass);
  system.bindGpuProgramParameters(Ogre::GPT_VERTEX_PROGRAM, pass.getVertexProgramParameters(), Ogre::GPV_ALL);
  system._render(operation);
}

}  // namespace scatter::viewer
