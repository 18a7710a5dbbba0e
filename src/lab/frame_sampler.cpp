#include "lab/frame_sampler.h"

#include <algorithm>
#include <bit>

namespace scatter::lab {

namespace {

// A clock's digits behind the seventh are noise, which takes room.
std::uint64_t bitsOf(const FrameData& data, ChannelId id) {
  const Channel& channel = data.channel(id);
  if (channel.kind == ChannelKind::kHash) return data.hash(id);
  const double value = data.value(id);
  return std::bit_cast<std::uint64_t>(channel.unit == "ms" ? static_cast<double>(static_cast<float>(value))
                                                           : value);
}

}  // namespace

void FrameSampler::sample(const World& world, const FrameData* data, FrameSample& out) {
  out.number = world.frame();
  const Physics& physics = world.physics();
  const LevelSwitching& switching = physics.switching();
  switching.coarsestLevels(coarsest_);
  out.bodies.reserve(world.objects().size());
  for (const auto& object : world.objects()) {
    const BodyId body = object->body();
    const BodyState state = physics.state(body);
    out.bodies.push_back({.body = body,
                          .level = static_cast<std::uint8_t>(std::clamp(levelOf(switching, body), 0, 127)),
                          .asleep = state.asleep,
                          .pose = state.pose,
                          .bits = physics.stateBits(body)});
    movingBodies_ += !state.asleep && object->def().motion == Motion::kDynamic ? 1U : 0U;
  }
  const auto events = switching.levelEvents();
  out.events.assign(events.begin(), events.end());
  findAdded(world, out);
  if (contacts_) addContacts(world, out);
  if (data == nullptr) return;
  for (std::size_t i = 0; i < data->channels().size(); ++i) {
    out.values.push_back(data->framesBegun() > 0 ? bitsOf(*data, static_cast<ChannelId>(i)) : 0);
  }
}

int FrameSampler::levelOf(const LevelSwitching& switching, BodyId body) const {
  return coarsest_.empty() ? switching.level(body) : coarsest_[static_cast<std::size_t>(body)];
}

void FrameSampler::findAdded(const World& world, FrameSample& out) {
  const auto same = [](const SampledBody& sampled, BodyId body) { return sampled.body == body; };
  if (std::equal(out.bodies.begin(), out.bodies.end(), roster_.begin(), roster_.end(), same)) return;
  roster_.clear();
  for (const auto& object : world.objects()) {
    roster_.push_back(object->body());
    if (known_.insert(object->body()).second) out.added.emplace_back(object->body(), object->def());
  }
}

void FrameSampler::addContacts(const World& world, FrameSample& out) {
  world.physics().diagnostics().observe({.bodies = false, .pairs = true, .contacts = true}, observed_);
  addPairLevels(observed_, out.pairs);
  for (const ObservedContact& contact : observed_.contacts) {
    out.contacts.push_back({.a = contact.a,
                            .b = contact.b,
                            .pointA = contact.pointA,
                            .normal = contact.normal,
                            .distance = contact.distance,
                            .credit = contact.credit,
                            .impulse = contact.impulse});
  }
}

void addPairLevels(const Observation& observed, std::vector<PairLevel>& pairs) {
  for (const ObservedPair& pair : observed.pairs) {
    if (pair.level > 0) {
      pairs.push_back({pair.a, pair.b, static_cast<std::uint8_t>(std::min(pair.level, 255))});
    }
  }
}

std::vector<RecordedChannel> recordedChannels(const FrameData& data) {
  std::vector<RecordedChannel> channels;
  for (const Channel& channel : data.channels()) {
    const RecordedKind kind = channel.kind == ChannelKind::kHash      ? RecordedKind::kHash
                              : channel.kind == ChannelKind::kInteger ? RecordedKind::kInteger
                                                                      : RecordedKind::kReal;
    channels.push_back({channel.name, channel.unit, kind});
  }
  return channels;
}

}  // namespace scatter::lab
