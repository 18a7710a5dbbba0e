#pragma once

#include <IShaderConstantSetCallBack.h>
#include <IVideoDriver.h>

#include "viewer/drawing/shading.h"
#include "viewer/irrlicht/irrlicht_pointer.h"

namespace scatter::viewer {

/// The materials that items are drawn with.
class IrrlichtShading {
 public:
  explicit IrrlichtShading(irr::video::IVideoDriver& driver);

  /// False if the driver cannot run the shader.
  [[nodiscard]] bool isReady() const { return solid_ >= 0 && seeThrough_ >= 0; }

  /// Where shadows of items fall on items. False if the driver cannot do that.
  [[nodiscard]] bool setShadows(const ShadowMap& map, const ShadowsInView& shadows);

  void setLight(const LightInView& light) { constants_->light = light; }

  /// What the next items that are drawn look like.
  void setLook(const ItemLook& look) { constants_->look = look; }

  /// For an item: culling, wireframe and blending are set.
  [[nodiscard]] irr::video::SMaterial material(bool solid, bool wireframe, bool twoSided) const;

  /// The same for an item that shadows fall on, after setShadows().
  [[nodiscard]] irr::video::SMaterial shadowedMaterial(bool twoSided) const;

 private:
  /// Hands light and look to the shader whenever Irrlicht draws with it.
  struct Constants final : irr::video::IShaderConstantSetCallBack {
    void OnSetConstants(irr::video::IMaterialRendererServices* services, irr::s32 userData) override;

    LightInView light{};
    ItemLook look{};
    ShadowsInView shadows{};
  };

  IrrlichtPointer<Constants> constants_;
  irr::s32 solid_ = -1;
  irr::s32 seeThrough_ = -1;
  irr::s32 shadowed_ = -1;
  irr::video::ITexture* shadowMap_ = nullptr;  ///< The driver's.
};

}  // namespace scatter::viewer
