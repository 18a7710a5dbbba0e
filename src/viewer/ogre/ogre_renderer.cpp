#include <Ogre.h>
#include <OgreImGuiOverlay.h>
#include <OgreOverlayManager.h>
#include <OgreOverlaySystem.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "viewer/display.h"
#include "viewer/ogre/ogre_input.h"
#include "viewer/ogre/ogre_painter.h"
#include "viewer/panel_frame.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

namespace {

class OgreRenderer final : public Renderer {
 public:
  OgreRenderer() = default;
  OgreRenderer(const OgreRenderer&) = delete;
  OgreRenderer& operator=(const OgreRenderer&) = delete;
  ~OgreRenderer() override;

  /// Once, before anything else. Throws Ogre::Exception.
  [[nodiscard]] Result<void> open(const WindowDef& window);

  [[nodiscard]] std::string name() const override { return "ogre"; }
  [[nodiscard]] bool isSoftware() const override {
    return isSoftwareRenderer(root_->getRenderSystem()->getCapabilities()->getDeviceName());
  }
  [[nodiscard]] MeshId addMesh(const MeshData& mesh) override { return painter_->addMesh(mesh); }
  void removeMesh(MeshId mesh) override { painter_->removeMesh(mesh); }
  void draw(const Picture& picture, const Panels& panels, Image* shot) override;
  [[nodiscard]] std::vector<InputEvent> pollInput() override;
  void inject(const InputEvent& event) override;
  [[nodiscard]] glm::ivec2 size() const override;
  void resize(const glm::ivec2& size) override { windowInput_->resize(size); }
  void setTitle(const std::string& title) override { windowInput_->setTitle(title); }
  [[nodiscard]] const DrawStatistics& statistics() const override { return statistics_; }

 private:
  void openWindow(const WindowDef& window);
  void openPanels();
  void runPanels(const Panels& panels);
  void readBack(Image& shot) const;

  // In the order in which they are made; the destructor goes backward.
  std::unique_ptr<Ogre::LogManager> log_;
  std::unique_ptr<Ogre::Root> root_;
  std::unique_ptr<Ogre::OverlaySystem> overlays_;
  std::unique_ptr<OgrePainter> painter_;
  Ogre::RenderWindow* window_ = nullptr;
  Ogre::SceneManager* scene_ = nullptr;
  Ogre::Viewport* view_ = nullptr;    ///< Moved to each view in turn.
  Ogre::Viewport* panels_ = nullptr;  ///< The whole window.
  InputQueue input_;
  std::unique_ptr<OgreInput> windowInput_;
  FrameClock clock_;
  glm::ivec2 knownSize_{0};
  DrawStatistics statistics_;
};

OgreRenderer::~OgreRenderer() {
  painter_.reset();
  if (scene_ != nullptr) root_->destroySceneManager(scene_);
  overlays_.reset();
  root_.reset();
  log_.reset();
}

Result<void> OgreRenderer::open(const WindowDef& window) {
  log_ = std::make_unique<Ogre::LogManager>();
  log_->createLog("", true, false, true);
  root_ = std::make_unique<Ogre::Root>("", "", "");
  root_->loadPlugin(SCATTER_OGRE_PLUGIN_DIR "/RenderSystem_GL");
  root_->setRenderSystem(root_->getAvailableRenderers().at(0));
  root_->initialise(false);
  overlays_ = std::make_unique<Ogre::OverlaySystem>();
  openWindow(window);
  scene_ = root_->createSceneManager();
  scene_->addRenderQueueListener(overlays_.get());
  openPanels();
  if (auto ready = setUpPanels(); !ready) return ready;
  painter_ = std::make_unique<OgrePainter>(*scene_);
  knownSize_ = size();
  return {};
}

void OgreRenderer::openWindow(const WindowDef& window) {
  Ogre::NameValuePairList parameters;
  parameters["FSAA"] = std::to_string(window.samples);
  parameters["vsync"] = window.waitForScreen ? "true" : "false";
  window_ = root_->createRenderWindow(window.title, static_cast<unsigned>(std::max(1, window.size.x)),
                                      static_cast<unsigned>(std::max(1, window.size.y)), false, &parameters);
  window_->setAutoUpdated(false);
  _XDisplay* display = nullptr;
  unsigned long id = 0;
  window_->getCustomAttribute("XDISPLAY", &display);
  window_->getCustomAttribute("WINDOW", &id);
  windowInput_ = std::make_unique<OgreInput>(display, id, input_);
}

void OgreRenderer::openPanels() {
  view_ = window_->addViewport(nullptr, 0);
  panels_ = window_->addViewport(scene_->createCamera("panels"), 1);
  panels_->setClearEveryFrame(false);
  panels_->setShadowsEnabled(false);
  panels_->setSkiesEnabled(false);
  // Its context is made here and current from now on. The overlay manager owns it.
  auto* overlay = new Ogre::ImGuiOverlay;
  Ogre::OverlayManager::getSingleton().addOverlay(overlay);
  overlay->setZOrder(300);
}

void OgreRenderer::draw(const Picture& picture, const Panels& panels, Image* shot) {
  statistics_ = {};
  Ogre::RenderSystem& system = *root_->getRenderSystem();
  window_->_beginUpdate();
  // A frame can only begin in a viewport.
  system._setViewport(panels_);
  system._beginFrame();
  if (picture.views.empty()) {
    system.clearFrameBuffer(Ogre::FBT_COLOUR | Ogre::FBT_DEPTH, Ogre::ColourValue::Black);
  }
  for (const View& view : picture.views) painter_->draw(view, *view_, size(), statistics_);
  system._endFrame();
  runPanels(panels);
  window_->_updateViewport(panels_);
  statistics_.panelVertices = static_cast<std::size_t>(ImGui::GetDrawData()->TotalVtxCount);
  window_->_endUpdate();
  // Once the frame is shown its pixels are no longer ours.
  if (shot != nullptr) readBack(*shot);
  window_->swapBuffers();
}

void OgreRenderer::runPanels(const Panels& panels) {
  // The overlay draws the letters when it is first shown, and a frame can only begin after that.
  Ogre::OverlayManager::getSingleton().getByName("ImGuiOverlay")->show();
  beginPanels(input_, size(), clock_.next());
  if (panels) panels();
}

void OgreRenderer::readBack(Image& shot) const {
  shot.width = size().x;
  shot.height = size().y;
  shot.rgb.resize(3 * static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height));
  const Ogre::Box box(0, 0, window_->getWidth(), window_->getHeight());
  window_->copyContentsToMemory(box, Ogre::PixelBox(box, Ogre::PF_BYTE_RGB, shot.rgb.data()),
                                Ogre::RenderTarget::FB_BACK);
}

std::vector<InputEvent> OgreRenderer::pollInput() {
  windowInput_->poll();
  window_->windowMovedOrResized();
  if (size() != knownSize_) {
    knownSize_ = size();
    InputEvent event;
    event.kind = InputEvent::Kind::kResize;
    event.position = glm::vec2(knownSize_);
    input_.add(event);
  }
  return input_.take();
}

void OgreRenderer::inject(const InputEvent& event) {
  if (event.kind == InputEvent::Kind::kResize) {
    resize(glm::ivec2(event.position));
  } else {
    input_.add(event);
  }
}

glm::ivec2 OgreRenderer::size() const {
  return {static_cast<int>(window_->getWidth()), static_cast<int>(window_->getHeight())};
}

}  // namespace

Result<std::unique_ptr<Renderer>> makeOgreRenderer(const WindowDef& window) {
  const auto display = openDisplay();
  if (!display) return tl::unexpected<Error>(display.error());
  try {
    auto renderer = std::make_unique<OgreRenderer>();
    if (auto opened = renderer->open(window); !opened) return tl::unexpected<Error>(opened.error());
    return std::unique_ptr<Renderer>(std::move(renderer));
  } catch (const Ogre::Exception& problem) {
    return fail("Ogre cannot open a window: " + problem.getDescription() +
                "; use --renderer irrlicht or null");
  }
}

}  // namespace scatter::viewer
