#include "lab/page/page_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "lab/page/contact_block.h"
#include "lab/page/pose_block.h"

namespace scatter::lab {

namespace {

// A browser unpacks a block of so many poses in some milliseconds.
constexpr std::size_t kBlockPoses = 24000;
constexpr std::size_t kMostBlockFrames = 128;

// A page with more is slow to send: frames are left out, and what is between them is the page's guess.
constexpr std::size_t kMostPoses = 2500000;

// Positions are as exact as a thousandth of the scene's smaller bodies, within these bounds. Metres.
constexpr float kFinest = 1.0F / 8192.0F;
constexpr float kCoarsest = 1.0F / 256.0F;

class MotionBuild {
 public:
  MotionBuild(const Recording& recording, PageShapes& shapes, PageBlobs& blobs)
      : recording_(recording), shapes_(shapes), blobs_(blobs) {}

  Result<Json> build() {
    if (auto found = findBodies(); !found) return tl::unexpected(found.error());
    const auto frames = static_cast<std::size_t>(recording_.last() - recording_.first() + 1);
    step_ = std::max<std::size_t>(1, (frames * bodies_.size() + kMostPoses - 1) / kMostPoses);
    blockFrames_ =
        std::clamp<std::size_t>(kBlockPoses / std::max<std::size_t>(1, bodies_.size()), 1, kMostBlockFrames);
    if (auto added = addBlocks(); !added) return tl::unexpected(added.error());
    return Json{{"first", recording_.first()},
                {"last", last_},
                {"step", step_},
                {"quantum", quantum_},
                {"contactQuantum", kContactQuantum},
                {"hasContacts", hasContacts_},
                {"bodies", std::move(descriptions_)},
                {"blocks", std::move(blocks_)},
                {"stopped", recording_.stopped()},
                {"damage", recording_.damage()}};
  }

 private:
  // Bodies may come at any time, and a page wants to know all of them before the first frame.
  Result<void> findBodies() {
    const std::vector<BodyId>* roster = nullptr;
    for (std::uint64_t number = recording_.first(); number <= recording_.last(); ++number) {
      const auto frame = recording_.frame(number);
      if (!frame) return tl::unexpected(frame.error());
      hasContacts_ = hasContacts_ || !(*frame)->contacts.empty();
      if ((*frame)->roster.get() == roster) continue;
      roster = (*frame)->roster.get();
      for (const BodyId body : *roster) addBody(body);
    }
    quantum_ = std::clamp(std::exp2(std::floor(std::log2(smallerSize() / 1000.0F))), kFinest, kCoarsest);
    return {};
  }

  void addBody(BodyId body) {
    if (!bodies_.emplace(body, bodies_.size()).second) return;
    const BodyDef* def = recording_.def(body);
    const PageShapes::Look look = def != nullptr ? shapes_.lookOf(*def) : PageShapes::Look{};
    const int motion = def != nullptr ? static_cast<int>(def->motion) : 0;
    if (def != nullptr && def->motion != Motion::kStatic) sizes_.push_back(sizeOf(*def));
    descriptions_.push_back({recording_.nameOf(body), look.shape, look.levels, motion,
                             Json{look.scale.x, look.scale.y, look.scale.z}});
  }

  static float sizeOf(const BodyDef& def) {
    if (const auto* box = std::get_if<Box>(&def.shape)) {
      return std::min({box->halfExtents.x, box->halfExtents.y, box->halfExtents.z});
    }
    if (const auto* sphere = std::get_if<Sphere>(&def.shape)) return sphere->radius;
    return 1.0F;
  }

  // That a tenth of the bodies is smaller than.
  [[nodiscard]] float smallerSize() {
    if (sizes_.empty()) return 1.0F;
    const auto tenth = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 10);
    std::nth_element(sizes_.begin(), tenth, sizes_.end());
    return std::max(*tenth, kFinest);
  }

  Result<void> addBlocks() {
    std::optional<PoseBlock> poses;
    ContactBlock contacts;
    std::uint64_t first = recording_.first();
    for (std::uint64_t number = first; number <= recording_.last(); number += step_) {
      const auto frame = recording_.frame(number);
      if (!frame) return tl::unexpected(frame.error());
      if (!poses) {
        poses.emplace(bodies_.size());
        first = number;
      }
      fill(**frame, poses->addFrame());
      if (hasContacts_) contacts.addFrame(**frame);
      last_ = number;
      if (poses->frames() == blockFrames_ || number + step_ > recording_.last()) {
        addBlock(first, *poses, contacts);
        poses.reset();
      }
    }
    return {};
  }

  void fill(const RecordedFrame& frame, std::vector<BlockBody>& bodies) const {
    for (std::size_t i = 0; i < frame.bodies.size(); ++i) {
      const RecordedBody& body = frame.bodies[i];
      bodies[bodies_.at((*frame.roster)[i])] = {
          .level = std::max<std::uint8_t>(1, body.level), .asleep = body.asleep, .pose = body.pose};
    }
  }

  void addBlock(std::uint64_t first, const PoseBlock& poses, ContactBlock& contacts) {
    const std::string bytes = poses.encode(quantum_);
    Json block{
        {"first", first}, {"frames", poses.frames()}, {"blob", blobs_.add(bytes)}, {"bytes", bytes.size()}};
    if (hasContacts_) {
      const std::string points = contacts.take();
      block["contacts"] = {{"blob", blobs_.add(points)}, {"bytes", points.size()}};
    }
    blocks_.push_back(std::move(block));
  }

  const Recording& recording_;
  PageShapes& shapes_;
  PageBlobs& blobs_;
  std::map<BodyId, std::size_t> bodies_;
  std::vector<float> sizes_;
  Json descriptions_ = Json::array();
  Json blocks_ = Json::array();
  float quantum_ = kFinest;
  std::size_t step_ = 1;
  std::size_t blockFrames_ = 1;
  std::uint64_t last_ = 0;
  bool hasContacts_ = false;
};

}  // namespace

Result<Json> pageMotion(const Recording& recording, PageShapes& shapes, PageBlobs& blobs) {
  return MotionBuild(recording, shapes, blobs).build();
}

}  // namespace scatter::lab
