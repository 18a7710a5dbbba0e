#include "decomposition.h"

#include <fcntl.h>
#include <scatter/io/file.h>
#include <scatter/io/mesh_file.h>
#include <spawn.h>
#include <spdlog/fmt/fmt.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "lab/scratch_folder.h"
#include "lab/text.h"

namespace scatter::app {
namespace {

namespace fs = std::filesystem;

std::string objOf(const SurfaceMesh& mesh) {
  std::string text;
  for (const Vec3& v : mesh.vertices) text += fmt::format("v {:.9g} {:.9g} {:.9g}\n", v.x, v.y, v.z);
  for (const auto& t : mesh.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

double childSeconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Whether the shell could do it.
bool runInShell(const std::string& command, const fs::path& folder) {
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  std::string shell = "/bin/sh";
  std::string option = "-c";
  std::string text = command;
  char* arguments[]{shell.data(), option.data(), text.data(), nullptr};
  pid_t process = 0;
  const int failure = posix_spawn(&process, shell.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return false;
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// One for each object of the file.
std::vector<ConvexHull> hullsOf(const MeshFile& file) {
  std::vector<ConvexHull> hulls;
  for (const MeshGroup& group : file.groups) {
    if (group.kind != MeshGroupKind::kObject) continue;
    std::set<std::uint32_t> vertices;
    for (const auto& [first, last] : group.runs) {
      for (std::uint32_t i = first; i < last; ++i)
        vertices.insert(file.mesh.triangles[i].begin(), file.mesh.triangles[i].end());
    }
    ConvexHull hull;
    for (const std::uint32_t vertex : vertices) hull.vertices.push_back(file.mesh.vertices[vertex]);
    hulls.push_back(std::move(hull));
  }
  return hulls;
}

/// The box with a corner in `corner` and these edges, which are square.
ConvexPart boxAlong(const Vec3& corner, const Mat3& edges) {
  Mat3 axes(glm::normalize(edges[0]), glm::normalize(edges[1]), glm::normalize(edges[2]));
  if (glm::determinant(axes) < 0.0F) axes[2] = -axes[2];
  const Vec3 half = 0.5F * Vec3(glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2]));
  return {Box{half}, {corner + 0.5F * (edges * Vec3(1.0F)), glm::normalize(glm::quat_cast(axes))}};
}

bool hasCorners(const ConvexPart& box, std::span<const Vec3> corners, float tolerance) {
  const Vec3 half = std::get<Box>(box.shape).halfExtents;
  std::set<int> found;
  for (const Vec3& corner : corners) {
    const Vec3 local = glm::conjugate(box.pose.rotation) * (corner - box.pose.position);
    if (glm::length(glm::abs(local) - half) > tolerance) return false;
    found.insert((local.x > 0.0F ? 1 : 0) + (local.y > 0.0F ? 2 : 0) + (local.z > 0.0F ? 4 : 0));
  }
  return found.size() == corners.size();
}

/// The box that eight points are the corners of, to within what single precision rounds.
std::optional<ConvexPart> boxOf(std::span<const Vec3> corners) {
  constexpr float kRounded = 1e-5F;
  constexpr std::size_t kCorners = 8;
  if (corners.size() != kCorners) return std::nullopt;
  // The edges that leave a corner are three of the ways to the others.
  for (std::size_t i = 1; i < kCorners; ++i) {
    for (std::size_t j = i + 1; j < kCorners; ++j) {
      for (std::size_t k = j + 1; k < kCorners; ++k) {
        const Mat3 edges(corners[i] - corners[0], corners[j] - corners[0], corners[k] - corners[0]);
        const ConvexPart box = boxAlong(corners[0], edges);
        if (hasCorners(box, corners, kRounded * glm::length(edges * Vec3(1.0F)))) return box;
      }
    }
  }
  return std::nullopt;
}

Result<Decomposition> decompositionOf(const std::vector<ConvexHull>& hulls, double seconds) {
  Decomposition result;
  result.seconds = seconds;
  for (const ConvexHull& hull : hulls) {
    const ConvexPart part = boxOf(hull.vertices).value_or(ConvexPart{hull, {}});
    const std::vector<Level> single{Level{{part}}};
    if (LevelSet::create({.name = "part", .levels = single, .hullMargin = 0.0F, .mass = {}}))
      result.level.parts.push_back(part);
  }
  if (result.level.parts.empty()) return fail("gave no part with a volume");
  return result;
}

}  // namespace

Result<Decomposition> decompose(const SurfaceMesh& mesh, const DecompositionDef& definition) {
  const lab::ScratchFolder folder("scatter-parts");
  if (folder.path().empty()) return fail("cannot make a folder in " + fs::temp_directory_path().string());
  if (auto written = writeFile(folder.path() / "mesh.obj", objOf(mesh)); !written)
    return fail(written.error().message);
  std::string line = lab::replaceAll(definition.command, "{mesh}", "mesh.obj");
  line = lab::replaceAll(line, "{hulls}", "hulls.obj");
  line = lab::replaceAll(line, "{parts}", std::to_string(definition.parts));
  line = lab::replaceAll(line, "{vertices}", std::to_string(definition.maxVertices));
  const double before = childSeconds();
  const bool ended =
      runInShell(fmt::format("ulimit -t {}; {}", definition.limitSeconds, line), folder.path());
  const double seconds = childSeconds() - before;
  const auto hulls = scatter::readMesh(folder.path() / "hulls.obj");
  if (!ended || !hulls) return fail(fmt::format("left no hulls after {:.0f} s: {}", seconds, line));
  return decompositionOf(hullsOf(*hulls), seconds);
}

}  // namespace scatter::app
