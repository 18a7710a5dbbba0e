#include "viewer/irrlicht/irrlicht_shading.h"

#include <IGPUProgrammingServices.h>
#include <IMaterialRendererServices.h>
#include <ITexture.h>

#include <cstring>
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
  const auto add = [&](const std::string& vertices, const std::string& pixels, video::E_MATERIAL_TYPE base) {
    return services->addHighLevelShaderMaterial(vertices.c_str(), pixels.c_str(), constants_.get(), base);
  };
  solid_ = add(vertexShader, kPixelShader, video::EMT_SOLID);
  seeThrough_ = add(vertexShader, kPixelShader, video::EMT_TRANSPARENT_VERTEX_ALPHA);
  shadowed_ = add(shadowed(vertexShader.c_str()), shadowed(kPixelShader), video::EMT_SOLID);
  const bool mipMaps = driver.getTextureCreationFlag(video::ETCF_CREATE_MIP_MAPS);
  driver.setTextureCreationFlag(video::ETCF_CREATE_MIP_MAPS, false);
  shadowMap_ = driver.addTexture({ShadowMap::kSize, ShadowMap::kSize}, "shadows", video::ECF_A8R8G8B8);
  driver.setTextureCreationFlag(video::ETCF_CREATE_MIP_MAPS, mipMaps);
}

bool IrrlichtShading::setShadows(const ShadowMap& map, const ShadowsInView& shadows) {
  if (shadowed_ < 0 || shadowMap_ == nullptr) return false;
  constants_->shadows = shadows;
  void* texels = shadowMap_->lock(video::ETLM_WRITE_ONLY);
  if (texels == nullptr) return false;
  std::memcpy(texels, map.texels().data(), map.texels().size() * sizeof(std::uint32_t));
  shadowMap_->unlock();
  return true;
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

video::SMaterial IrrlichtShading::shadowedMaterial(bool twoSided) const {
  video::SMaterial material = this->material(true, false, twoSided);
  material.MaterialType = static_cast<video::E_MATERIAL_TYPE>(shadowed_);
  material.setTexture(0, shadowMap_);
  material.TextureLayer[0].BilinearFilter = false;
  material.TextureLayer[0].TextureWrapU = video::ETC_CLAMP_TO_EDGE;
  material.TextureLayer[0].TextureWrapV = video::ETC_CLAMP_TO_EDGE;
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
  // Materials without shadows do not know these.
  services->setVertexShaderConstant("toShadow", glm::value_ptr(shadows.fromCamera), 16);
  services->setVertexShaderConstant("lift", &shadows.lift, 1);
}

}  // namespace scatter::viewer
