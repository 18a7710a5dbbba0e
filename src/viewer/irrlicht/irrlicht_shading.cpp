#include "viewer/irrlicht/irrlicht_shading.h"

#include <IGPUProgrammingServices.h>
#include <IMaterialRendererServices.h>

#include <glm/gtc/type_ptr.hpp>
#include <string>

namespace scatter::viewer {

namespace video = irr::video;

namespace {

/// Irrlicht leaves the matrices to OpenGL.
constexpr const char* kMatrices = R"(
#define toClip gl_ModelViewProjectionMatrix
#define toCamera gl_ModelViewMatrix
#define turnNormal(normal) (gl_NormalMatrix * (normal))
)";

}  // namespace

IrrlichtShading::IrrlichtShading(video::IVideoDriver& driver) : constants_(new Constants) {
  video::IGPUProgrammingServices* services = driver.getGPUProgrammingServices();
  if (services == nullptr) return;
  const std::string vertexShader = std::string(kMatrices) + kItemVertexShader;
  const auto add = [&](video::E_MATERIAL_TYPE base) {
    return services->addHighLevelShaderMaterial(vertexShader.c_str(), kPixelShader, constants_.get(), base);
  };
  solid_ = add(video::EMT_SOLID);
  seeThrough_ = add(video::EMT_TRANSPARENT_VERTEX_ALPHA);
}

video::SMaterial IrrlichtShading::material(bool solid, bool wireframe, bool twoSided) const {
  video::SMaterial material;
  material.MaterialType = static_cast<video::E_MATERIAL_TYPE>(solid ? solid_ : seeThrough_);
  material.Lighting = false;
  material.ZWriteEnable = solid;
  material.Wireframe = wireframe;
  // What Irrlicht, being left-handed, calls the front is our back.
  material.BackfaceCulling = false;
  material.FrontfaceCulling = !wireframe && !twoSided;
  return material;
}

void IrrlichtShading::Constants::OnSetConstants(video::IMaterialRendererServices* services,
                                                irr::s32 /*userData*/) {
  const float lookValues[] = {look.glow, look.flat, look.twoSided};
  services->setVertexShaderConstant("toLight", glm::value_ptr(light.toLight), 3);
  services->setVertexShaderConstant("worldUp", glm::value_ptr(light.up), 3);
  const float crowd[] = {light.crowd.center.x, light.crowd.center.y, light.crowd.center.z,
                         light.crowd.radius};
  services->setVertexShaderConstant("crowd", crowd, 4);
  services->setVertexShaderConstant("crowdShade", &light.crowd.shade, 1);
  services->setVertexShaderConstant("itemColor", glm::value_ptr(look.color), 4);
  services->setVertexShaderConstant("itemLook", lookValues, 3);
}

}  // namespace scatter::viewer
