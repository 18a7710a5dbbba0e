#include <scatter/lab/run_history.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>
#include <variant>

namespace scatter {

namespace {

constexpr std::uint8_t kAsleep = 0x80;  // beside the level, in one byte
constexpr std::uint8_t kLargestLevel = 0x7F;
constexpr std::size_t kPairBytes = 9;

std::uint8_t stateByte(int level, bool asleep) {
  const int kept = std::clamp(level, 0, static_cast<int>(kLargestLevel));
  return static_cast<std::uint8_t>(kept | (asleep ? kAsleep : 0));
}

std::uint8_t levelByte(int level) {
  return static_cast<std::uint8_t>(std::clamp(level, 0, 255));
}

std::size_t bytesOf(const ConvexPart& part) {
  const auto* hull = std::get_if<ConvexHull>(&part.shape);
  return sizeof(part) + (hull != nullptr ? hull->vertices.size() * sizeof(Vec3) : 0);
}

// What is shared with the world counts for nothing.
std::size_t bytesOf(const BodyDef& def) {
  std::size_t bytes = sizeof(def) + def.name.size();
  if (const auto* hull = std::get_if<ConvexHull>(&def.shape)) {
    bytes += hull->vertices.size() * sizeof(Vec3);
  }
  if (const auto* compound = std::get_if<Compound>(&def.shape)) {
    for (const ConvexPart& part : compound->parts) {
      bytes += bytesOf(part);
    }
  }
  return bytes;
}

// A pair without padding.
void pack(const PairLevel& pair, unsigned char* to) {
  std::memcpy(to, &pair.a, 4);
  std::memcpy(to + 4, &pair.b, 4);
  to[8] = pair.level;
}

PairLevel unpackPair(const unsigned char* from) {
  PairLevel pair;
  std::memcpy(&pair.a, from, 4);
  std::memcpy(&pair.b, from + 4, 4);
  pair.level = from[8];
  return pair;
}

}  // namespace

std::size_t RunHistory::StoredFrame::bytes() const {
  static_assert(sizeof(StoredPose) == 28 && sizeof(StoredEvent) == 12);
  return sizeof(StoredFrame) + poses.capacity() * sizeof(StoredPose) + states.capacity() +
         events.capacity() * sizeof(StoredEvent) + pairs.capacity();
}

RunHistory::RunHistory(const HistoryDef& def) : def_(def) {}

RunHistory::~RunHistory() = default;

void RunHistory::record(const World& world, std::span<const PairLevel> pairs) {
  assert(empty() || world.frame() == newest() + 1);
  StoredFrame frame;
  frame.number = world.frame();
  frame.bodies = rosterOf(world);
  addPoses(world.physics(), frame);
  addEvents(world.physics(), frame);
  if (def_.pairLevels) {
    frame.pairs.resize(pairs.size() * kPairBytes);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pack(pairs[i], &frame.pairs[i * kPairBytes]);
    }
  }
  bytes_ += frame.bytes();
  frames_.push_back(std::move(frame));
  trim();
}

void RunHistory::addPoses(const Physics& physics, StoredFrame& frame) {
  frame.poses.reserve(frame.bodies->size());
  frame.states.reserve(frame.bodies->size());
  for (const BodyId body : *frame.bodies) {
    const BodyState state = physics.state(body);
    const Vec3& p = state.pose.position;
    const Quat& q = state.pose.rotation;
    frame.poses.push_back({p.x, p.y, p.z, q.w, q.x, q.y, q.z});
    frame.states.push_back(stateByte(physics.switching().level(body), state.asleep));
  }
}

void RunHistory::addEvents(const Physics& physics, StoredFrame& frame) {
  const auto events = physics.switching().levelEvents();
  frame.events.reserve(events.size());
  for (const LevelEvent& event : events) {
    frame.events.push_back({.body = static_cast<std::uint32_t>(event.body),
                            .other = static_cast<std::uint32_t>(event.other),
                            .from = levelByte(event.from),
                            .to = levelByte(event.to),
                            .policy = indexOf(event.policy),
                            .kind = static_cast<std::uint8_t>(event.kind),
                            .scope = static_cast<std::uint8_t>(event.scope),
                            .onCredit = static_cast<std::uint8_t>(event.onCredit ? 1 : 0)});
  }
}

void RunHistory::clear() {
  frames_.clear();
  defs_.clear();
  bytes_ = 0;
}

std::uint64_t RunHistory::oldest() const {
  assert(!empty());
  return frames_.front().number;
}

std::uint64_t RunHistory::newest() const {
  assert(!empty());
  return frames_.back().number;
}

bool RunHistory::has(std::uint64_t frame) const {
  return !empty() && frame >= oldest() && frame <= newest();
}

void RunHistory::setBytes(std::size_t bytes) {
  def_.bytes = bytes;
  trim();
}

RunHistory::Frame RunHistory::frame(std::uint64_t number) const {
  assert(has(number));
  return {*this, frames_[static_cast<std::size_t>(number - oldest())]};
}

const BodyDef* RunHistory::def(BodyId body) const {
  const auto known = defs_.find(body);
  return known == defs_.end() ? nullptr : &known->second;
}

std::shared_ptr<const RunHistory::Roster> RunHistory::rosterOf(const World& world) {
  const auto objects = world.objects();
  const auto isBody = [](const std::unique_ptr<WorldObject>& object, BodyId body) {
    return object->body() == body;
  };
  if (!empty() && std::equal(objects.begin(), objects.end(), frames_.back().bodies->begin(),
                             frames_.back().bodies->end(), isBody)) {
    return frames_.back().bodies;
  }
  Roster bodies;
  bodies.reserve(objects.size());
  for (const auto& object : objects) {
    bodies.push_back(object->body());
    if (const auto [known, isNew] = defs_.try_emplace(object->body(), object->def()); isNew) {
      bytes_ += bytesOf(known->second);
    }
  }
  bytes_ += bodies.capacity() * sizeof(BodyId);
  return std::make_shared<const Roster>(std::move(bodies));
}

std::uint8_t RunHistory::indexOf(std::string_view policy) {
  const auto found = std::find(policies_.begin(), policies_.end(), policy);
  const auto index = found - policies_.begin();
  if (found == policies_.end()) {
    assert(policies_.size() < 256);
    policies_.push_back(policy);
  }
  return static_cast<std::uint8_t>(index);
}

void RunHistory::trim() {
  while (bytes_ > def_.bytes && frames_.size() > 1) {
    dropOldest();
  }
}

void RunHistory::dropOldest() {
  const StoredFrame& frame = frames_.front();
  bytes_ -= frame.bytes();
  const auto& next = frames_[1].bodies;
  if (next != frame.bodies) {
    bytes_ -= frame.bodies->capacity() * sizeof(BodyId);
    forgetBodies(*frame.bodies, *next);
  }
  frames_.pop_front();
}

// A body that has left does not come back.
void RunHistory::forgetBodies(const Roster& gone, const Roster& left) {
  for (const BodyId body : gone) {
    const auto known = defs_.find(body);
    if (known != defs_.end() && std::find(left.begin(), left.end(), body) == left.end()) {
      bytes_ -= bytesOf(known->second);
      defs_.erase(known);
    }
  }
}

std::uint64_t RunHistory::Frame::number() const {
  return stored_->number;
}

std::span<const BodyId> RunHistory::Frame::bodies() const {
  return *stored_->bodies;
}

std::optional<std::size_t> RunHistory::Frame::find(BodyId body) const {
  const auto found = std::find(stored_->bodies->begin(), stored_->bodies->end(), body);
  if (found == stored_->bodies->end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - stored_->bodies->begin());
}

Transform RunHistory::Frame::pose(std::size_t index) const {
  const StoredPose& pose = stored_->poses[index];
  return {Vec3(pose.px, pose.py, pose.pz), Quat(pose.qw, pose.qx, pose.qy, pose.qz)};
}

int RunHistory::Frame::level(std::size_t index) const {
  return stored_->states[index] & kLargestLevel;
}

bool RunHistory::Frame::asleep(std::size_t index) const {
  return (stored_->states[index] & kAsleep) != 0;
}

std::size_t RunHistory::Frame::eventCount() const {
  return stored_->events.size();
}

LevelEvent RunHistory::Frame::event(std::size_t index) const {
  const StoredEvent& event = stored_->events[index];
  return {.kind = static_cast<LevelEventKind>(event.kind),
          .scope = static_cast<Scope>(event.scope),
          .body = BodyId{event.body},
          .from = event.from,
          .to = event.to,
          .other = BodyId{event.other},
          .onCredit = event.onCredit != 0,
          .policy = history_->policies_[event.policy]};
}

std::size_t RunHistory::Frame::pairCount() const {
  return stored_->pairs.size() / kPairBytes;
}

PairLevel RunHistory::Frame::pair(std::size_t index) const {
  return unpackPair(&stored_->pairs[index * kPairBytes]);
}

}  // namespace scatter
