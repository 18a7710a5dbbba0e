#include <imgui.h>

#include <algorithm>
#include <map>
#include <utility>

#include "viewer/drawing/draw_list.h"
#include "viewer/panel_frame.h"
#include "viewer/renderer.h"

namespace scatter::viewer {

namespace {

class NullRenderer final : public Renderer {
 public:
  explicit NullRenderer(const glm::ivec2& size) : panels_(ImGui::CreateContext()), size_(size) {
    ImGui::SetCurrentContext(panels_);
  }
  NullRenderer(const NullRenderer&) = delete;
  NullRenderer& operator=(const NullRenderer&) = delete;
  ~NullRenderer() override { ImGui::DestroyContext(panels_); }

  [[nodiscard]] std::string name() const override { return "null"; }
  [[nodiscard]] bool isSoftware() const override { return false; }

  [[nodiscard]] MeshId addMesh(const MeshData& mesh) override {
    const auto id = MeshId{nextMesh_++};
    meshes_.emplace(id, outlineOf(makeDetails(mesh)));
    return id;
  }

  void removeMesh(MeshId mesh) override { meshes_.erase(mesh); }

  void draw(const Picture& picture, const Panels& panels, Image* shot) override {
    statistics_ = {};
    const auto outline = [this](MeshId mesh) -> const MeshOutline& { return meshes_.at(mesh); };
    for (const View& view : picture.views)
      count(view, listDraws(view, pixelsOf(view.area, size_), outline), outline, statistics_);
    runPanels(panels);
    if (shot != nullptr) {
      const std::size_t bytes = 3 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
      *shot = {size_.x, size_.y, std::vector<std::uint8_t>(bytes)};
    }
  }

  [[nodiscard]] std::vector<InputEvent> pollInput() override { return input_.take(); }

  void inject(const InputEvent& event) override {
    if (event.kind == InputEvent::Kind::kResize) {
      resize(glm::ivec2(event.position));
    } else {
      input_.add(event);
    }
  }

  void setTitle(const std::string& /*title*/) override {}
  [[nodiscard]] glm::ivec2 size() const override { return size_; }

  void resize(const glm::ivec2& size) override {
    size_ = glm::max(size, glm::ivec2(1));
    InputEvent event;
    event.kind = InputEvent::Kind::kResize;
    event.position = glm::vec2(size_);
    input_.add(event);
  }

  [[nodiscard]] const DrawStatistics& statistics() const override { return statistics_; }

 private:
  void runPanels(const Panels& panels) {
    ImGuiIO& io = ImGui::GetIO();
    unsigned char* letters = nullptr;
    int width = 0;
    int height = 0;
    // A frame can only begin once the letters have been drawn.
    io.Fonts->GetTexDataAsAlpha8(&letters, &width, &height);
    beginPanels(input_, size_, 1.0F / 60.0F);
    if (panels) panels();
    ImGui::Render();
    statistics_.panelVertices = static_cast<std::size_t>(ImGui::GetDrawData()->TotalVtxCount);
  }

  ImGuiContext* panels_;
  glm::ivec2 size_;
  InputQueue input_;
  std::map<MeshId, MeshOutline> meshes_;
  std::uint32_t nextMesh_ = 0;
  DrawStatistics statistics_;
};

}  // namespace

Result<std::unique_ptr<Renderer>> makeNullRenderer(const WindowDef& window) {
  auto renderer = std::make_unique<NullRenderer>(glm::max(window.size, glm::ivec2(1)));
  return setUpPanels().map([&]() -> std::unique_ptr<Renderer> { return std::move(renderer); });
}

}  // namespace scatter::viewer
