#include <imgui.h>

#include "viewer/drawing/projection.h"
#include "viewer/renderer_fixture.h"

namespace scatter::test {
namespace {

/// What a window shows. A metre at the origin is 57.7 pixels.
class RendererPicture : public RendererTest {};
INSTANTIATE_TEST_SUITE_P(All, RendererPicture, testing::ValuesIn(windowedRenderers()), testName);

int brightness(const std::array<int, 3>& pixel) {
  return pixel[0] + pixel[1] + pixel[2];
}

TEST_P(RendererPicture, ShowsARedItemInTheMiddle) {
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kRed));
  const Image shot = shoot(view);
  ASSERT_EQ(shot.width, 640);
  ASSERT_EQ(shot.height, 400);
  EXPECT_EQ(at(shot, 320, 200), kRedPixel);
  EXPECT_EQ(at(shot, 100, 200), kBlackPixel);
}

TEST_P(RendererPicture, NearerItemHidesFartherWhateverTheOrder) {
  const MeshId box = renderer_->addMesh(boxMesh());
  View view = viewFromFront();
  const Item near = shining(box, {0.0F, 0.0F, 2.0F}, kRed);
  const Item far = shining(box, {0.0F, 0.0F, -2.0F}, kGreen, 3.0F);
  view.items = {near, far};
  EXPECT_EQ(at(shoot(view), 320, 200), kRedPixel);
  view.items = {far, near};
  EXPECT_EQ(at(shoot(view), 320, 200), kRedPixel);
  EXPECT_EQ(at(shoot(view), 320, 150), kGreenPixel) << "the far one is larger";
}

TEST_P(RendererPicture, AxesAreRightHanded) {
  const MeshId box = renderer_->addMesh(boxMesh());
  View view = viewFromFront();
  view.items = {shining(box, {2.0F, 0.0F, 0.0F}, kRed), shining(box, {0.0F, 2.0F, 0.0F}, kGreen),
                shining(box, {0.0F, 0.0F, 2.0F}, kBlue)};
  const Image front = shoot(view);
  EXPECT_EQ(at(front, 435, 200), kRedPixel) << "x to the right";
  EXPECT_EQ(at(front, 320, 85), kGreenPixel) << "y up";
  EXPECT_EQ(at(front, 320, 200), kBluePixel) << "z toward the viewer";
  EXPECT_EQ(at(front, 205, 200), kBlackPixel);
  view.camera.eye = {10.0F, 0.0F, 0.0F};
  const Image side = shoot(view);
  EXPECT_EQ(at(side, 205, 200), kBluePixel) << "seen from +x, z is to the left";
  EXPECT_EQ(at(side, 435, 200), kBlackPixel);
}

TEST_P(RendererPicture, TurnsAndScalesItems) {
  View view = viewFromFront();
  Item item = shining(renderer_->addMesh(boxMesh()), {}, kRed);
  item.scale = {4.0F, 0.5F, 0.5F};
  // A quarter turn about z, counter-clockwise as seen: what lay to the right stands.
  item.pose.rotation = glm::angleAxis(0.7853982F, Vec3(0.0F, 0.0F, 1.0F));
  view.items = {item};
  const Image shot = shoot(view);
  EXPECT_EQ(at(shot, 320 + 60, 200 - 60), kRedPixel);
  EXPECT_EQ(at(shot, 320 - 60, 200 + 60), kRedPixel);
  EXPECT_EQ(at(shot, 320 + 60, 200 + 60), kBlackPixel);
}

TEST_P(RendererPicture, CounterClockwiseIsTheFront) {
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(squareMesh()), {}, kRed, 2.0F));
  EXPECT_EQ(at(shoot(view), 320, 200), kRedPixel);
  view.camera.eye.z = -10.0F;
  EXPECT_EQ(at(shoot(view), 320, 200), kBlackPixel);
}

TEST_P(RendererPicture, TwoSidedMeshesAreSeenAndLitFromBehind) {
  viewer::MeshData square = squareMesh();
  square.twoSided = true;
  View view = viewFromFront();
  Item item = shining(renderer_->addMesh(square), {}, Color(1.0F), 2.0F);
  item.glow = 0.0F;
  view.items = {item};
  view.camera.eye.z = -10.0F;
  view.scenery.toLight = {0.0F, 0.0F, -1.0F};
  EXPECT_GT(at(shoot(view), 320, 200)[0], 200);
}

TEST_P(RendererPicture, LightAndOcclusionShade) {
  viewer::MeshData hidden = boxMesh();
  hidden.occlusion.assign(hidden.positions.size(), 0.8F);
  View view = viewFromFront();
  Item item = shining(renderer_->addMesh(boxMesh()), {-2.0F, 0.0F, 0.0F}, Color(1.0F));
  item.glow = 0.0F;
  view.items = {item};
  view.scenery.toLight = {0.0F, 0.0F, 1.0F};
  item.mesh = renderer_->addMesh(hidden);
  item.pose.position.x = 2.0F;
  view.items.push_back(item);
  const Image lit = shoot(view);
  EXPECT_GT(at(lit, 205, 200)[0], at(lit, 435, 200)[0] + 60) << "occlusion darkens";
  view.scenery.toLight = {0.0F, 0.0F, -1.0F};
  EXPECT_GT(at(lit, 205, 200)[0], at(shoot(view), 205, 200)[0] + 60)
      << "the side away from the light is darker";
}

TEST_P(RendererPicture, LightStaysInTheWorldWhenCameraAndItemTurn) {
  View view = viewFromFront();
  view.camera.eye = {7.0F, 3.0F, 7.0F};
  Item item = shining(renderer_->addMesh(boxMesh()), {}, Color(1.0F), 3.0F);
  item.glow = 0.0F;
  item.scale.y = 6.0F;
  item.pose.rotation = glm::angleAxis(1.5707963F, Vec3(0.0F, 1.0F, 0.0F));
  view.items = {item};
  // The sides toward +z and +x are seen to the left and right of the middle.
  view.scenery.toLight = {1.0F, 0.0F, -0.2F};
  const Image fromX = shoot(view);
  EXPECT_GT(at(fromX, 360, 200)[0], at(fromX, 280, 200)[0] + 80);
  view.scenery.toLight = {-0.2F, 0.0F, 1.0F};
  const Image fromZ = shoot(view);
  EXPECT_GT(at(fromZ, 280, 200)[0], at(fromZ, 360, 200)[0] + 80);
}

TEST_P(RendererPicture, MeshColoursMultiply) {
  viewer::MeshData mesh = boxMesh();
  mesh.colors.assign(mesh.positions.size(), glm::vec3(1.0F, 0.0F, 1.0F));
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(mesh), {}, Color(1.0F, 1.0F, 0.0F, 1.0F)));
  EXPECT_EQ(at(shoot(view), 320, 200), kRedPixel);
}

TEST_P(RendererPicture, GhostsLetThroughWhatIsBehindThem) {
  const MeshId square = renderer_->addMesh(squareMesh());
  View view = viewFromFront();
  view.items = {shining(square, {0.0F, 0.0F, 1.0F}, {0.0F, 1.0F, 0.0F, 0.5F}, 2.0F),
                shining(square, {0.0F, 0.0F, 0.0F}, kRed, 2.0F)};
  const auto pixel = at(shoot(view), 320, 200);
  EXPECT_NEAR(pixel[0], 128, 3);
  EXPECT_NEAR(pixel[1], 128, 3);
}

TEST_P(RendererPicture, WireframesAreEmpty) {
  View view = viewFromFront();
  Item item = shining(renderer_->addMesh(squareMesh()), {}, kRed, 3.0F);
  item.wireframe = true;
  view.items = {item};
  const Image shot = shoot(view);
  EXPECT_EQ(at(shot, 300, 250), kBlackPixel);
  int red = 0;
  for (int x = 200; x < 440; ++x) red += at(shot, x, 250) == kRedPixel ? 1 : 0;
  EXPECT_GE(red, 2);
}

TEST_P(RendererPicture, LinesAreHiddenUnlessTheyLieOnTop) {
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kRed));
  view.lineWidth = 3.0F;
  view.lines = {{{-3.0F, 0.0F, -1.0F}, {3.0F, 0.0F, -1.0F}, kGreen}};
  const Image hidden = shoot(view);
  EXPECT_EQ(at(hidden, 320, 200), kRedPixel);
  EXPECT_EQ(at(hidden, 220, 200), kGreenPixel);
  std::swap(view.lines, view.linesOnTop);
  const Image onTop = shoot(view);
  EXPECT_EQ(at(onTop, 320, 200), kGreenPixel);
  EXPECT_EQ(at(onTop, 220, 200), kGreenPixel);
}

TEST_P(RendererPicture, ViewsSideBySideDoNotSpill) {
  const MeshId box = renderer_->addMesh(boxMesh());
  Picture picture;
  for (const Color& color : {kRed, kGreen}) {
    View view = viewFromFront();
    view.area = {color == kRed ? 0.0F : 0.5F, 0.0F, 0.5F, 1.0F};
    view.items.push_back(shining(box, {}, color, 8.0F));
    picture.views.push_back(view);
  }
  const Image shot = shoot(picture);
  for (int y = 0; y < 400; y += 50) {
    EXPECT_EQ(at(shot, 0, y), kRedPixel);
    EXPECT_EQ(at(shot, 319, y), kRedPixel);
    EXPECT_EQ(at(shot, 320, y), kGreenPixel);
    EXPECT_EQ(at(shot, 639, y), kGreenPixel);
  }
}

TEST_P(RendererPicture, ALaterViewLiesOverAnEarlierOne) {
  const MeshId box = renderer_->addMesh(boxMesh());
  Picture picture;
  picture.views.assign(2, viewFromFront());
  picture.views[0].items.push_back(shining(box, {0.0F, 0.0F, 3.0F}, kRed, 8.0F));
  picture.views[1].area = {0.75F, 0.0F, 0.25F, 0.25F};
  picture.views[1].items.push_back(shining(box, {}, kGreen));
  const Image shot = shoot(picture);
  EXPECT_EQ(at(shot, 560, 50), kGreenPixel) << "although it is farther away";
  EXPECT_EQ(at(shot, 490, 10), kBlackPixel);
  EXPECT_EQ(at(shot, 470, 50), kRedPixel);
  EXPECT_EQ(at(shot, 560, 110), kRedPixel);
}

TEST_P(RendererPicture, PointsAppearWhereTheProjectionSays) {
  const MeshId box = renderer_->addMesh(boxMesh());
  View view = viewFromFront();
  view.area = {0.25F, 0.5F, 0.5F, 0.5F};
  view.camera.eye = {3.0F, 4.0F, 8.0F};
  const Vec3 place(1.0F, -0.5F, 0.7F);
  view.items.push_back(shining(box, place, kRed, 0.4F));
  const glm::vec2 pixel = viewer::pixelOf(view, {640, 400}, place).value();
  EXPECT_EQ(at(shoot(view), static_cast<int>(pixel.x), static_cast<int>(pixel.y)), kRedPixel);
}

TEST_P(RendererPicture, SkyFadesFromTheHorizon) {
  View view = viewFromFront();
  view.scenery.horizon = {0.0F, 0.0F, 1.0F};
  const Image shot = shoot(view);
  EXPECT_GT(at(shot, 320, 200)[2], 240);
  EXPECT_LT(at(shot, 320, 5)[2], at(shot, 320, 200)[2] - 50);
}

TEST_P(RendererPicture, StarsAreInSpaceOnly) {
  View view = viewFromFront();
  view.camera.fieldOfView = 1.5F;
  const auto countBright = [](const Image& image) {
    int bright = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) bright += brightness(at(image, x, y)) > 100 ? 1 : 0;
    }
    return bright;
  };
  EXPECT_EQ(countBright(shoot(view)), 0);
  view.scenery.stars = true;
  const int inSpace = countBright(shoot(view));
  EXPECT_GT(inSpace, 10);
  EXPECT_LT(inSpace, 2000);
  view.scenery.ground = -5.0F;
  view.scenery.groundColor = glm::vec3(0.0F);
  view.scenery.gridStep = 0.0F;
  EXPECT_EQ(countBright(shoot(view)), 0);
}

TEST_P(RendererPicture, GroundCarriesShadowsAndHidesWhatIsBelow) {
  const MeshId box = renderer_->addMesh(boxMesh());
  View view = viewFromFront();
  view.camera.eye = {0.0F, 8.0F, 8.0F};
  view.scenery.ground = 0.0F;
  view.scenery.gridStep = 0.0F;
  view.scenery.groundColor = glm::vec3(0.5F);
  view.scenery.toLight = {0.0F, 1.0F, 0.0F};
  view.items = {shining(box, {0.0F, 2.0F, 0.0F}, kRed), shining(box, {2.0F, -1.0F, 0.0F}, kGreen)};
  const Image shot = shoot(view);
  const glm::ivec2 shadow = viewer::pixelOf(view, {640, 400}, {0.0F, 0.0F, 0.0F}).value();
  const glm::ivec2 ground = viewer::pixelOf(view, {640, 400}, {-2.0F, 0.0F, 0.0F}).value();
  const glm::ivec2 below = viewer::pixelOf(view, {640, 400}, {2.0F, -1.0F, 0.0F}).value();
  EXPECT_GT(brightness(at(shot, ground.x, ground.y)), 200);
  EXPECT_LT(brightness(at(shot, shadow.x, shadow.y)), brightness(at(shot, ground.x, ground.y)) - 80);
  EXPECT_EQ(at(shot, below.x, below.y), at(shot, ground.x, ground.y));
  view.scenery.shadows = viewer::Shadows::kNothing;
  EXPECT_EQ(at(shoot(view), shadow.x, shadow.y), at(shot, ground.x, ground.y));
}

TEST_P(RendererPicture, ItemsShadeEachOther) {
  const MeshId box = renderer_->addMesh(boxMesh());
  View view = viewFromFront();
  view.camera.eye = {0.0F, 8.0F, 8.0F};
  view.scenery.toLight = {0.3F, 1.0F, 0.0F};
  Item plate;
  plate.mesh = box;
  plate.color = Color(0.8F, 0.8F, 0.8F, 1.0F);
  plate.pose.position.y = -0.5F;
  plate.scale = {6.0F, 1.0F, 6.0F};
  Item above = plate;
  above.pose.position = {0.6F, 2.0F, 0.0F};
  above.scale = Vec3(1.0F);
  view.items = {plate, above};
  const glm::ivec2 under = viewer::pixelOf(view, {640, 400}, {0.0F, 0.0F, 0.0F}).value();
  const glm::ivec2 beside = viewer::pixelOf(view, {640, 400}, {-1.5F, 0.0F, 0.0F}).value();
  const auto darkening = [&](viewer::Shadows shadows) {
    view.scenery.shadows = shadows;
    const Image shot = shoot(view);
    return brightness(at(shot, beside.x, beside.y)) - brightness(at(shot, under.x, under.y));
  };
  EXPECT_NEAR(darkening(viewer::Shadows::kGround), 0, 30);
  EXPECT_GT(darkening(viewer::Shadows::kEverything), 150);
  EXPECT_NEAR(darkening(viewer::Shadows::kNothing), 0, 30);
  // What is not there any more leaves nothing in the shadows.
  view.items.pop_back();
  EXPECT_NEAR(darkening(viewer::Shadows::kEverything), 0, 30);
}

TEST_P(RendererPicture, PanelsLieOverEverything) {
  Picture picture;
  picture.views.push_back(viewFromFront());
  picture.views[0].items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kRed, 8.0F));
  const Image shot = shoot(picture, [] {
    ImGui::GetForegroundDrawList()->AddRectFilled({100.0F, 50.0F}, {200.0F, 80.0F}, IM_COL32(0, 0, 255, 255));
  });
  EXPECT_EQ(at(shot, 150, 65), kBluePixel);
  EXPECT_EQ(at(shot, 150, 45), kRedPixel);
  EXPECT_EQ(at(shot, 205, 65), kRedPixel);
}

TEST_P(RendererPicture, PanelsShowText) {
  const Image shot = shoot(Picture{}, [] {
    ImGui::GetForegroundDrawList()->AddText({10.0F, 10.0F}, IM_COL32(255, 255, 255, 255), "HHHHHHHH");
  });
  int white = 0;
  for (int x = 10; x < 70; ++x) white += at(shot, x, 16)[0] > 200 ? 1 : 0;
  EXPECT_GE(white, 16) << "two stems and a bar a letter";
  EXPECT_LE(white, 56) << "with gaps";
}

TEST_P(RendererPicture, PanelsLeaveTheNextFrameAsItWas) {
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kRed));
  view.lines = {{{-3.0F, 1.0F, 0.0F}, {3.0F, 1.0F, 0.0F}, kGreen}};
  const Image before = shoot(view);
  (void)shoot(Picture{}, [] { ImGui::ShowMetricsWindow(); });
  EXPECT_EQ(shoot(view).rgb, before.rgb);
}

TEST_P(RendererPicture, ResizedWindowIsFilled) {
  Picture picture;
  picture.views.push_back(viewFromFront());
  picture.views[0].items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kRed));
  (void)shoot(picture);
  renderer_->resize({900, 700});
  const InputEvent event = await(InputEvent::Kind::kResize);
  EXPECT_EQ(event.position, glm::vec2(900.0F, 700.0F));
  const Image shot = shoot(picture);
  ASSERT_EQ(shot.width, 900);
  ASSERT_EQ(shot.height, 700);
  EXPECT_EQ(at(shot, 450, 350), kRedPixel);
  EXPECT_EQ(at(shot, 320, 200), kBlackPixel);
}

TEST_P(RendererPicture, AnotherWindowCanBeOpenedAfterwards) {
  renderer_.reset();
  auto again = viewer::makeRenderer(GetParam(), {});
  ASSERT_TRUE(again.has_value()) << again.error().message;
  renderer_ = std::move(*again);
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kRed));
  EXPECT_EQ(at(shoot(view), 640, 360), kRedPixel);
}

TEST_P(RendererPicture, RemovedMeshesMakeRoom) {
  const MeshId gone = renderer_->addMesh(boxMesh());
  (void)shoot(viewFromFront());
  renderer_->removeMesh(gone);
  View view = viewFromFront();
  view.items.push_back(shining(renderer_->addMesh(boxMesh()), {}, kGreen));
  EXPECT_EQ(at(shoot(view), 320, 200), kGreenPixel);
}

}  // namespace
}  // namespace scatter::test
