#include <scatter/io/file.h>
#include <scatter/recording/export.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "io/gltf/build.h"
#include "recording/export/body_surface.h"

namespace scatter {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostBytes = std::size_t{2} << 30U;

/// Where a body is in the frames that are written, without those that say nothing new.
struct Track {
  std::vector<float> times;
  std::vector<Transform> poses;
  bool held = false;  ///< The last pose has been left out of the frames before this one.

  void add(float time, float step, Transform pose) {
    if (!poses.empty()) {
      const Transform last = poses.back();
      if (pose.position == last.position && pose.rotation == last.rotation) {
        held = true;
        return;
      }
      if (held) push(time - step, last);
      // Viewers go the short way from one to the next.
      if (glm::dot(pose.rotation, last.rotation) < 0.0F) pose.rotation = -pose.rotation;
    }
    held = false;
    push(time, pose);
  }

  std::optional<std::pair<float, float>> present{};  ///< From when until when it is there.

 private:
  void push(float time, Transform pose) {
    times.push_back(time);
    poses.push_back(pose);
  }
};

/// A recording as an animation.
class Animation {
 public:
  Animation(const Recording& recording, const ExportRange& range) : recording_(recording), range_(range) {}

  Result<void> read() {
    for (std::uint64_t number = range_.first; number <= range_.last; number += range_.step) {
      const auto frame = recording_.frame(number);
      if (!frame) return tl::unexpected(frame.error());
      add(**frame);
      if (bytes_ > kMostBytes) {
        return fail("the animation is more than 2 GiB; take fewer frames, such as --frames ::10");
      }
    }
    return {};
  }

  [[nodiscard]] std::string file(bool asText) {
    Json channels = Json::array();
    Json samplers = Json::array();
    std::vector<std::size_t> nodes;
    for (const auto& [body, track] : tracks_) {
      const BodyDef* def = recording_.def(body);
      Json node{{"name", recording_.nameOf(body)}};
      if (def != nullptr) {
        if (const auto mesh = meshOf(*def)) node["mesh"] = *mesh;
      }
      io::setPose(node, track.poses.front());
      nodes.push_back(build_.addNode(std::move(node)));
      animate(nodes.back(), track, channels, samplers);
    }
    if (!channels.empty()) {
      build_.addAnimation(
          {{"name", recording_.info().scene}, {"channels", channels}, {"samplers", samplers}});
    }
    build_.setScene(recording_.info().scene, nodes, {{"world", recording_.info().label}});
    return asText ? build_.text() : build_.binary();
  }

  [[nodiscard]] ExportCounts counts() const { return {.frames = frames_, .bodies = tracks_.size()}; }

 private:
  [[nodiscard]] float timeOf(std::uint64_t number) const {
    return static_cast<float>(static_cast<double>(number - range_.first) * recording_.info().stepSeconds);
  }

  void add(const RecordedFrame& frame) {
    const float time = timeOf(frame.number);
    const float step = time - timeOf(frame.number - std::min(range_.step, frame.number - range_.first));
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      Track& track = tracks_[(*frame.roster)[i]];
      const std::size_t before = track.times.size();
      track.add(time, step, frame.bodies[i].pose);
      bytes_ += 32 * (track.times.size() - before);
      track.present = {track.present ? track.present->first : time, time};
    }
    last_ = time;
    ++frames_;
  }

  std::optional<std::size_t> meshOf(const BodyDef& def) {
    const void* model = recording::modelOf(def);
    const Vec3 color = recording::colorOf(def);
    const auto key = std::pair(model, std::array<float, 3>{color.x, color.y, color.z});
    if (const auto known = meshes_.find(key); model != nullptr && known != meshes_.end())
      return known->second;
    const SurfaceMesh surface = recording::surfaceOf(def);
    if (surface.triangles.empty()) return std::nullopt;
    const std::size_t mesh = build_.addMesh({surface.vertices, surface.triangles}, def.name);
    build_.setMeshMaterial(mesh, appearanceOf(key.second));
    if (model != nullptr) meshes_.emplace(key, mesh);
    return mesh;
  }

  std::size_t appearanceOf(const std::array<float, 3>& color) {
    const auto known = appearances_.find(color);
    if (known != appearances_.end()) return known->second;
    const std::size_t made = build_.addAppearance("color " + std::to_string(appearances_.size() + 1),
                                                  Vec3(color[0], color[1], color[2]));
    return appearances_.emplace(color, made).first->second;
  }

  std::size_t timesAt(const std::vector<float>& times) {
    if (const auto known = times_.find(times); known != times_.end()) return known->second;
    const std::size_t made = build_.addNumbers(times, 1);
    // Those that every body has that moves all the time are worth to be looked for.
    if (times.size() == frames_) times_.emplace(times, made);
    return made;
  }

  void animate(std::size_t node, const Track& track, Json& channels, Json& samplers) {
    const auto add = [&](const char* path, const char* interpolation, std::size_t times,
                         const std::vector<float>& numbers, std::size_t each) {
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", node}, {"path", path}}}});
      samplers.push_back(
          {{"input", times}, {"output", build_.addNumbers(numbers, each)}, {"interpolation", interpolation}});
    };
    if (track.poses.size() > 1) {
      std::vector<float> positions;
      std::vector<float> rotations;
      for (const Transform& pose : track.poses) {
        const Vec3& p = pose.position;
        const Quat& q = pose.rotation;
        positions.insert(positions.end(), {p.x, p.y, p.z});
        rotations.insert(rotations.end(), {q.x, q.y, q.z, q.w});
      }
      const std::size_t times = timesAt(track.times);
      add("translation", "LINEAR", times, positions, 3);
      add("rotation", "LINEAR", times, rotations, 4);
    }
    const auto [from, to] = *track.present;
    if (from <= 0.0F && to >= last_) return;
    // glTF can hide nothing, but what is small is not seen.
    std::vector<float> times;
    std::vector<float> sizes;
    const auto size = [&](float time, float scale) {
      times.push_back(time);
      sizes.insert(sizes.end(), {scale, scale, scale});
    };
    if (from > 0.0F) size(0.0F, 0.0F);
    size(from, 1.0F);
    if (to < last_) size(to + timeOf(range_.first + range_.step), 0.0F);
    add("scale", "STEP", build_.addNumbers(times, 1), sizes, 3);
  }

  const Recording& recording_;
  ExportRange range_;
  std::map<BodyId, Track> tracks_;
  float last_ = 0.0F;
  std::uint64_t frames_ = 0;
  std::size_t bytes_ = 0;
  io::GltfBuild build_{/*physics=*/false};
  std::map<std::pair<const void*, std::array<float, 3>>, std::size_t> meshes_;
  std::map<std::array<float, 3>, std::size_t> appearances_;
  std::map<std::vector<float>, std::size_t> times_;
};

}  // namespace

Result<ExportCounts> writeGltfAnimation(const Recording& recording, const ExportRange& range,
                                        const std::filesystem::path& file) {
  Animation animation(recording, range);
  if (auto read = animation.read(); !read) return tl::unexpected(read.error());
  const std::string bytes = animation.file(file.extension() == ".gltf");
  if (auto written = writeFile(file, bytes); !written) return tl::unexpected(written.error());
  ExportCounts counts = animation.counts();
  counts.bytes = bytes.size();
  return counts;
}

}  // namespace scatter
