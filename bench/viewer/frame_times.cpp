// How long a renderer takes to draw a frame: bench_viewer_frames RENDERER ITEMS [FRAMES] [MESH] [PICTURE.png]
// [SHADOWS] SHADOWS: 0 on nothing, 1 on a ground, 2 on everything
#include <scatter/io/mesh_file.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <string>

#include "viewer/drawing/surface_shading.h"
#include "viewer/image_file.h"
#include "viewer/mesh_occlusion.h"
#include "viewer/renderers.h"

namespace {

using namespace scatter;
using namespace scatter::viewer;

/// A rock of 2400 triangles, 3 m across.
MeshData rock() {
  constexpr std::uint32_t kAround = 40;
  constexpr std::uint32_t kUp = 31;
  MeshData mesh;
  for (std::uint32_t i = 0; i <= kUp; ++i) {
    const float polar = glm::pi<float>() * static_cast<float>(i) / kUp;
    for (std::uint32_t j = 0; j < kAround; ++j) {
      const float angle = glm::two_pi<float>() * static_cast<float>(j) / kAround;
      const Vec3 direction(std::sin(polar) * std::cos(angle), std::cos(polar),
                           std::sin(polar) * std::sin(angle));
      const float radius = 1.5F + 0.2F * std::sin(5.0F * angle) * std::sin(polar) * std::sin(7.0F * polar);
      mesh.positions.push_back(radius * direction);
      mesh.normals.push_back(direction);
    }
  }
  for (std::uint32_t i = 0; i < kUp; ++i) {
    for (std::uint32_t j = 0; j < kAround; ++j) {
      const std::uint32_t next = (j + 1) % kAround;
      const std::uint32_t a = i * kAround + j;
      const std::uint32_t b = i * kAround + next;
      const std::uint32_t c = a + kAround;
      const std::uint32_t d = b + kAround;
      if (i > 0) mesh.indices.insert(mesh.indices.end(), {a, b, c});
      if (i + 1 < kUp) mesh.indices.insert(mesh.indices.end(), {b, d, c});
    }
  }
  return mesh;
}

/// Items in a ball, whose density is that of a scene drawn to one point, seen whole.
Picture ballOf(std::size_t items, MeshId mesh) {
  Picture picture;
  View& view = picture.views.emplace_back();
  const float reach = 4.0F * std::cbrt(static_cast<float>(items));
  view.camera.eye = {0.6F * reach, 0.5F * reach, 2.2F * reach};
  for (std::size_t i = 0; i < items; ++i) {
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(items);
    const float angle = 2.399963F * static_cast<float>(i);
    const float height = 1.0F - 2.0F * std::fmod(share * 7.0F, 1.0F);
    const float width = std::sqrt(1.0F - height * height);
    Item item;
    item.mesh = mesh;
    item.pose.position =
        reach * std::cbrt(share) * Vec3(width * std::cos(angle), height, width * std::sin(angle));
    item.pose.rotation = glm::angleAxis(angle, glm::normalize(Vec3(1.0F, share, 0.3F)));
    item.color = Color(0.5F + 0.4F * share, 0.75F - 0.3F * share, 0.6F, 1.0F);
    view.items.push_back(item);
  }
  return picture;
}

int complain(const std::string& message) {
  std::fprintf(stderr, "%s\n", message.c_str());
  return 2;
}

int run(Renderer& renderer, const MeshData& mesh, std::size_t items, int frames, const std::string& file,
        Shadows shadows) {
  Picture picture = ballOf(items, renderer.addMesh(mesh));
  picture.views[0].scenery.shadows = shadows;
  std::vector<double> times;
  Image shot;
  const std::clock_t before = std::clock();
  for (int i = 0; i < frames; ++i) {
    (void)renderer.pollInput();
    for (Item& item : picture.views[0].items) item.pose.position.y += 0.001F;
    const auto start = std::chrono::steady_clock::now();
    renderer.draw(picture, {}, i + 1 == frames && !file.empty() ? &shot : nullptr);
    times.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  const double cpu = 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / frames;
  // The first frame uploads the meshes, the last may read the picture back.
  std::sort(times.begin() + 1, times.end() - 1);
  const auto at = [&](double share) {
    return times[1 + static_cast<std::size_t>(share * static_cast<double>(frames - 3))];
  };
  std::printf(
      "%s: %zu items of %zu triangles, %zu triangles drawn, %d frames: median %.2f ms, p95 %.2f ms, first "
      "%.2f ms, processor time %.2f ms a frame\n",
      renderer.name().c_str(), items, mesh.indices.size() / 3, renderer.statistics().triangles, frames,
      at(0.5), at(0.95), times.front(), cpu);
  if (file.empty()) return 0;
  if (auto written = writePng(shot, file); !written) return complain(written.error().message);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3)
    return complain("usage: bench_viewer_frames RENDERER ITEMS [FRAMES] [MESH] [PICTURE.png] [SHADOWS]");
  const int frames = std::max(4, argc > 3 ? std::atoi(argv[3]) : 200);
  auto renderer = makeRenderer(argv[1], {});
  if (!renderer) return complain(renderer.error().message);
  MeshData mesh = rock();
  if (argc > 4 && *argv[4] != '\0') {
    auto read = readMesh(argv[4]);
    if (!read) return complain(read.error().message);
    mesh = shadeSurface(read->mesh);
  }
  mesh.occlusion = bakeOcclusion(mesh);
  return run(**renderer, mesh, static_cast<std::size_t>(std::max(1, std::atoi(argv[2]))), frames,
             argc > 5 ? argv[5] : "",
             static_cast<Shadows>(argc > 6 ? std::clamp(std::atoi(argv[6]), 0, 2) : 1));
}
