#pragma once

// No header of a renderer is included here, and nothing newer than C++17 is used: Irrlicht's headers do not
// compile as C++20.

#include <scatter/math.h>
#include <scatter/result.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/image.h"
#include "viewer/input.h"

namespace scatter::viewer {

/// Red, green, blue and alpha from 0 to 1, as shown (not linear light).
using Color = glm::vec4;

/// Triangles, metres, counter-clockwise seen from outside.
struct MeshData {
  std::vector<Vec3> positions{};
  std::vector<Vec3> normals{};           ///< Unit vectors, one a position.
  std::vector<std::uint32_t> indices{};  ///< Three a triangle.
  std::vector<glm::vec3> colors{};       ///< Multiply an item's colour. None: white.
  std::vector<float> occlusion{};        ///< 0 in the open, 1 where no light comes. None: 0.
  bool twoSided = false;                 ///< Seen from behind too, lit as if from the front.
};

enum class MeshId : std::uint32_t {};

/// A mesh somewhere.
struct Item {
  MeshId mesh{};
  Transform pose{};
  Vec3 scale{1.0F};                     ///< Along the mesh's axes, before the pose.
  Color color{0.8F, 0.8F, 0.8F, 1.0F};  ///< Items with an alpha below 1 are see-through and cast no shadow.
  float glow = 0.0F;                    ///< 0: as lit; 1: in its own colour whatever the light.
  bool wireframe = false;               ///< Edges of triangles only.
  bool castsShadow = true;              ///< If it is neither see-through nor a wireframe.

  /// A ground for shadows, as far as it reaches, if the scenery has none; for one level box in a view.
  bool isFloor = false;
};

struct Line {
  Vec3 from{0.0F};
  Vec3 to{0.0F};
  Color color{1.0F};
};

struct Camera {
  Vec3 eye{0.0F, 0.0F, 10.0F};
  Vec3 target{0.0F};
  Vec3 up{0.0F, 1.0F, 0.0F};  ///< Not along the line of sight.
  float fieldOfView = 0.8F;   ///< Vertical, radians.
  float near = 0.1F;          ///< Metres.
  float far = 2000.0F;        ///< Metres.
};

/// Many items close together, which take each other's light.
struct Crowd {
  Vec3 center{0.0F};
  float radius = 1.0F;  ///< Metres; where the crowd ends.
  float shade = 0.0F;   ///< Share of the light that is missing in the middle.
};

/// What the shadows of items fall on.
enum class Shadows : std::uint8_t { kNothing, kGround, kEverything };

/// What surrounds the items. Up is +y.
struct Scenery {
  glm::vec3 zenith{0.02F, 0.03F, 0.07F};
  glm::vec3 horizon{0.10F, 0.14F, 0.22F};
  glm::vec3 nadir{0.02F, 0.025F, 0.05F};
  bool stars = true;
  Vec3 toLight{0.45F, 0.8F, 0.4F};  ///< Any length but 0.
  std::optional<float> ground{};    ///< Height of a ground with a grid and shadows; none in space.
  glm::vec3 groundColor{0.30F, 0.33F, 0.37F};
  float gridStep = 1.0F;     ///< Metres; every tenth line is stronger.
  float fadeRadius = 40.0F;  ///< Metres from the camera at which ground and grid are lost in haze.
  Crowd crowd{};
  Shadows shadows = Shadows::kGround;
};

/// A part of the window, in shares of its width and height from the top left.
struct Area {
  float left = 0.0F;
  float top = 0.0F;
  float width = 1.0F;
  float height = 1.0F;
};

/// One camera's picture. Views are drawn in order, a later one over an earlier.
struct View {
  Area area{};
  Camera camera{};
  Scenery scenery{};
  std::vector<Item> items{};
  std::vector<Line> lines{};       ///< Hidden by what is nearer.
  std::vector<Line> linesOnTop{};  ///< Always seen.
  float lineWidth = 1.0F;          ///< Pixels.
};

/// All that is to be seen in a window at one time.
struct Picture {
  std::vector<View> views{};
};

/// What the last frame consisted of.
struct DrawStatistics {
  std::size_t items = 0;      ///< Drawn, in all views.
  std::size_t culled = 0;     ///< Left out because no camera sees them.
  std::size_t triangles = 0;  ///< Of items, after the choice of detail; shadows not counted.
  std::size_t shadows = 0;
  std::size_t lines = 0;
  std::size_t panelVertices = 0;  ///< Of Dear ImGui.
};

/// Panels of a frame: calls to Dear ImGui, whose context is current.
using Panels = std::function<void()>;

/// Draws what it is given and remembers nothing but meshes, so that the program owns all state. One thread
/// only.
class Renderer {
 public:
  Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  virtual ~Renderer() = default;

  /// What --renderer calls it.
  [[nodiscard]] virtual std::string name() const = 0;

  /// Whether a processor draws, for want of a graphics card: what costs much for each pixel is better left
  /// out.
  [[nodiscard]] virtual bool isSoftware() const = 0;

  /// Takes a copy. Coarser versions of the mesh are made for items that are small on the screen.
  [[nodiscard]] virtual MeshId addMesh(const MeshData& mesh) = 0;

  /// Items must not name it any more.
  virtual void removeMesh(MeshId mesh) = 0;

  /// Draws a frame, panels over all, and shows it. `shot`, if not null, becomes a copy of it; without a
  /// display, black. Does nothing but run the panels once the window has been closed.
  virtual void draw(const Picture& picture, const Panels& panels, Image* shot = nullptr) = 0;

  /// What has happened since the last call, oldest first. Call it once a frame, before draw().
  [[nodiscard]] virtual std::vector<InputEvent> pollInput() = 0;

  /// Makes the next pollInput() return the event, and the panels see it, as if the user had caused it. A
  /// kResize resizes the window.
  virtual void inject(const InputEvent& event) = 0;

  /// What the window's frame says.
  virtual void setTitle(const std::string& title) = 0;

  /// Of the window's inside, in pixels.
  [[nodiscard]] virtual glm::ivec2 size() const = 0;

  /// Asks for another size; a kResize event tells when it has come.
  virtual void resize(const glm::ivec2& size) = 0;

  [[nodiscard]] virtual const DrawStatistics& statistics() const = 0;
};

struct WindowDef {
  std::string title = "Scatter";
  glm::ivec2 size{1280, 720};
  bool waitForScreen = false;  ///< Whether draw() waits for the screen's next refresh.
  int samples = 0;             ///< Of each pixel, for smooth edges, as far as the display can; 0: one.
};

/// Fail with one line that says what to do if there is no display, or none with OpenGL. At most one renderer
/// may exist at a time.
[[nodiscard]] Result<std::unique_ptr<Renderer>> makeIrrlichtRenderer(const WindowDef& window);
[[nodiscard]] Result<std::unique_ptr<Renderer>> makeOgreRenderer(const WindowDef& window);

/// Draws nothing and needs no display, but runs the panels and counts.
[[nodiscard]] Result<std::unique_ptr<Renderer>> makeNullRenderer(const WindowDef& window);

}  // namespace scatter::viewer
