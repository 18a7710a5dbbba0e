#include <GL/gl.h>
#include <X11/XKBlib.h>
#include <X11/Xlib.h>
#include <backends/imgui_impl_opengl2.h>
#include <imgui.h>
#include <irrlicht.h>

#include <algorithm>
#include <cstring>
#include <glm/common.hpp>
#include <utility>

#include "viewer/display.h"
#include "viewer/irrlicht/irrlicht_input.h"
#include "viewer/irrlicht/irrlicht_painter.h"
#include "viewer/irrlicht/irrlicht_pointer.h"
#include "viewer/panel_frame.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

namespace {

class IrrlichtRenderer final : public Renderer {
 public:
  explicit IrrlichtRenderer(const WindowDef& window);
  IrrlichtRenderer(const IrrlichtRenderer&) = delete;
  IrrlichtRenderer& operator=(const IrrlichtRenderer&) = delete;
  ~IrrlichtRenderer() override;

  /// Once, before anything else. Fails if there is no OpenGL that can do what is needed.
  [[nodiscard]] Result<void> open(const WindowDef& window);

  [[nodiscard]] std::string name() const override { return "irrlicht"; }
  [[nodiscard]] bool isSoftware() const override;
  [[nodiscard]] MeshId addMesh(const MeshData& mesh) override { return painter_->addMesh(mesh); }
  void removeMesh(MeshId mesh) override { painter_->removeMesh(mesh); }
  void draw(const Picture& picture, const Panels& panels, Image* shot) override;
  [[nodiscard]] std::vector<InputEvent> pollInput() override;
  void inject(const InputEvent& event) override;
  void setTitle(const std::string& title) override;
  [[nodiscard]] glm::ivec2 size() const override;
  void resize(const glm::ivec2& size) override;
  [[nodiscard]] const DrawStatistics& statistics() const override { return statistics_; }

 private:
  void drawPanels(const Panels& panels);
  void readBack(Image& shot) const;
  [[nodiscard]] Display* display() const;
  [[nodiscard]] Window windowId() const;

  InputQueue input_;
  IrrlichtInput receiver_{input_};
  IrrlichtPointer<irr::IrrlichtDevice> device_;
  std::unique_ptr<IrrlichtPainter> painter_;
  ImGuiContext* panels_ = nullptr;
  FrameClock clock_;
  glm::ivec2 knownSize_{0};
  bool isClosed_ = false;
  bool hadFocus_ = false;
  DrawStatistics statistics_;
};

IrrlichtRenderer::IrrlichtRenderer(const WindowDef& window) {
  irr::SIrrlichtCreationParameters parameters;
  parameters.DriverType = irr::video::EDT_OPENGL;
  parameters.WindowSize = {static_cast<irr::u32>(std::max(1, window.size.x)),
                           static_cast<irr::u32>(std::max(1, window.size.y))};
  parameters.Bits = 32;
  parameters.ZBufferBits = 24;
  parameters.Stencilbuffer = false;
  parameters.AntiAlias = static_cast<irr::u8>(window.samples);
  parameters.Vsync = window.waitForScreen;
  parameters.EventReceiver = &receiver_;
  parameters.LoggingLevel = irr::ELL_NONE;
  device_.reset(irr::createDeviceEx(parameters));
}

IrrlichtRenderer::~IrrlichtRenderer() {
  if (panels_ != nullptr) {
    ImGui_ImplOpenGL2_Shutdown();
    ImGui::DestroyContext(panels_);
  }
  painter_.reset();
  if (device_) device_->closeDevice();
}

Result<void> IrrlichtRenderer::open(const WindowDef& window) {
  if (!device_)
    return fail("the display has no OpenGL window for us; install libgl1-mesa-dri, or use --renderer null");
  painter_ = std::make_unique<IrrlichtPainter>(*device_->getVideoDriver());
  if (!painter_->isReady())
    return fail(
        "the display's OpenGL has no shaders (GLSL 1.10); install libgl1-mesa-dri, or use --renderer null");
  setTitle(window.title);
  device_->setResizable(true);
  // A key that is held is one that goes down many times, not up and down.
  XkbSetDetectableAutoRepeat(display(), True, nullptr);
  panels_ = ImGui::CreateContext();
  ImGui::SetCurrentContext(panels_);
  ImGui_ImplOpenGL2_Init();
  knownSize_ = size();
  return setUpPanels();
}

bool IrrlichtRenderer::isSoftware() const {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name != nullptr && isSoftwareRenderer(name);
}

void IrrlichtRenderer::draw(const Picture& picture, const Panels& panels, Image* shot) {
  statistics_ = {};
  irr::video::IVideoDriver& driver = *device_->getVideoDriver();
  driver.beginScene(true, true, irr::video::SColor(255, 0, 0, 0));
  for (const View& view : picture.views) painter_->draw(view, size(), statistics_);
  painter_->finish(size());
  drawPanels(panels);
  // Once the frame is shown its pixels are no longer ours.
  if (shot != nullptr) readBack(*shot);
  driver.endScene();
}

void IrrlichtRenderer::drawPanels(const Panels& panels) {
  ImGui_ImplOpenGL2_NewFrame();
  beginPanels(input_, size(), clock_.next());
  if (panels) panels();
  ImGui::Render();
  ImGui_ImplOpenGL2_RenderDrawData(ImGui::GetDrawData());
  statistics_.panelVertices = static_cast<std::size_t>(ImGui::GetDrawData()->TotalVtxCount);
}

void IrrlichtRenderer::readBack(Image& shot) const {
  shot.width = size().x;
  shot.height = size().y;
  const std::size_t row = 3 * static_cast<std::size_t>(shot.width);
  const auto rows = static_cast<std::size_t>(shot.height);
  shot.rgb.resize(row * rows);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, shot.width, shot.height, GL_RGB, GL_UNSIGNED_BYTE, shot.rgb.data());
  // OpenGL's first row is the lowest.
  for (std::size_t y = 0; y < rows / 2; ++y) {
    std::uint8_t* upper = &shot.rgb[y * row];
    std::swap_ranges(upper, upper + row, &shot.rgb[(rows - 1 - y) * row]);
  }
}

std::vector<InputEvent> IrrlichtRenderer::pollInput() {
  const bool isOpen = device_->run();
  if (size() != knownSize_) {
    knownSize_ = size();
    InputEvent event;
    event.kind = InputEvent::Kind::kResize;
    event.position = glm::vec2(knownSize_);
    input_.add(event);
  }
  const bool hasFocus = device_->isWindowFocused();
  if (hadFocus_ && !hasFocus) input_.releaseAll();
  hadFocus_ = hasFocus;
  if (!isOpen && !std::exchange(isClosed_, true)) {
    InputEvent event;
    event.kind = InputEvent::Kind::kClose;
    input_.add(event);
  }
  return input_.take();
}

void IrrlichtRenderer::inject(const InputEvent& event) {
  if (event.kind == InputEvent::Kind::kResize) {
    resize(glm::ivec2(event.position));
  } else {
    input_.add(event);
  }
}

void IrrlichtRenderer::setTitle(const std::string& title) {
  // Irrlicht's own call takes wide letters, and names of files are UTF-8.
  nameWindow(display(), windowId(), title);
}

glm::ivec2 IrrlichtRenderer::size() const {
  const auto& size = device_->getVideoDriver()->getScreenSize();
  return {static_cast<int>(size.Width), static_cast<int>(size.Height)};
}

void IrrlichtRenderer::resize(const glm::ivec2& size) {
  // Irrlicht has no call for it.
  XResizeWindow(display(), windowId(), static_cast<unsigned>(std::max(1, size.x)),
                static_cast<unsigned>(std::max(1, size.y)));
  XSync(display(), False);
}

Display* IrrlichtRenderer::display() const {
  return static_cast<Display*>(device_->getVideoDriver()->getExposedVideoData().OpenGLLinux.X11Display);
}

Window IrrlichtRenderer::windowId() const {
  return device_->getVideoDriver()->getExposedVideoData().OpenGLLinux.X11Window;
}

}  // namespace

Result<std::unique_ptr<Renderer>> makeIrrlichtRenderer(const WindowDef& window) {
  const auto display = openDisplay();
  if (!display) return tl::unexpected<Error>(display.error());
  auto renderer = std::make_unique<IrrlichtRenderer>(window);
  if (auto opened = renderer->open(window); !opened) return tl::unexpected<Error>(opened.error());
  return std::unique_ptr<Renderer>(std::move(renderer));
}

}  // namespace scatter::viewer
