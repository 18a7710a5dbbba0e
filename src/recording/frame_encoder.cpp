#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

#include "recording/checks.h"
#include "recording/compression.h"
#include "recording/frame_coder.h"
#include "recording/frame_streams.h"

namespace scatter::recording {

namespace {

std::uint8_t stateByte(const SampledBody& body) {
  return static_cast<std::uint8_t>(std::min(body.level, kLargestLevel) | (body.asleep ? kAsleep : 0U));
}

std::int64_t idOf(BodyId body) {
  return static_cast<std::int64_t>(static_cast<std::uint32_t>(body));
}

std::uint8_t levelByte(int level) {
  return static_cast<std::uint8_t>(std::clamp(level, 0, 255));
}

std::array<std::uint8_t, kStateQuantityCount> checksOf(const StateBits& bits) {
  return {checkOf(bits.position), checkOf(bits.orientation), checkOf(bits.linearVelocity),
          checkOf(bits.angularVelocity)};
}

void writeLength(float length, float unit, ByteWriter& out) {
  const double units = static_cast<double>(length) / static_cast<double>(unit);
  out.difference(
      std::isfinite(units) ? static_cast<std::int64_t>(std::nearbyint(std::clamp(units, -1e15, 1e15))) : 0);
}

}  // namespace

void FrameEncoder::add(const FrameSample& frame) {
  assert(frames_ == 0 || frame.number == first_ + frames_);
  if (frames_ == 0) first_ = frame.number;
  writeRoster(frame);
  writeBodies(frame);
  writeHashes(frame);
  writeEvents(frame);
  writePairs(frame);
  writeContacts(frame);
  values_.push_back(frame.values);
  bodyFrames_ += frame.bodies.size();
  ++frames_;
}

void FrameEncoder::writeRoster(const FrameSample& frame) {
  const auto same = [](const SampledBody& body, const Track& track) { return body.body == track.body; };
  const bool stays = frames_ > 0 && std::equal(frame.bodies.begin(), frame.bodies.end(), tracks_.begin(),
                                               tracks_.end(), same);
  structure_.byte(stays ? 0 : 1);
  if (stays) return;
  std::unordered_map<BodyId, Track> known;
  for (Track& track : tracks_) known.emplace(track.body, track);
  tracks_.clear();
  structure_.number(frame.bodies.size());
  std::int64_t before = 0;
  for (const SampledBody& body : frame.bodies) {
    structure_.difference(idOf(body.body) - before);
    before = idOf(body.body);
    const auto track = known.find(body.body);
    tracks_.push_back(track != known.end() ? track->second : Track{.body = body.body});
  }
  movedBefore_.assign((tracks_.size() + 7) / 8, 0);
}

// Which bodies have moved comes before how; of those that must be told anew, too.
void FrameEncoder::writeBodies(const FrameSample& frame) {
  moved_.assign(movedBefore_.size(), 0);
  std::vector<std::size_t> anew;
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    Track& track = tracks_[i];
    const SampledBody& body = frame.bodies[i];
    if (const std::uint8_t state = stateByte(body); !track.known || state != track.state) {
      track.state = state;
      changed.push_back(i);
    }
    if (track.known && body.bits == track.bits) {
      track.pose.rest();
      continue;
    }
    moved_[i / 8] = static_cast<std::uint8_t>(moved_[i / 8] | (1U << (i % 8)));
    if (!track.known || !track.pose.write(body.pose, positions_, rotations_)) {
      track.pose.begin(body.pose, positions_, rotations_);
      anew.push_back(i);
    }
    track.known = true;
    track.bits = body.bits;
    track.checks = checksOf(body.bits);
    for (const std::uint8_t check : track.checks) checks_.byte(check);
  }
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    structure_.byte(static_cast<std::uint8_t>(moved_[i] ^ movedBefore_[i]));
  }
  std::swap(moved_, movedBefore_);
  const auto writeIndices = [this](const std::vector<std::size_t>& indices) {
    structure_.number(indices.size());
    std::size_t next = 0;
    for (const std::size_t index : indices) structure_.number(index - std::exchange(next, index));
  };
  writeIndices(anew);
  writeIndices(changed);
  for (const std::size_t i : changed) structure_.byte(tracks_[i].state);
}

void FrameEncoder::writeHashes(const FrameSample& frame) {
  std::array<WordHash, kStateQuantityCount> hashes;
  for (const SampledBody& body : frame.bodies) {
    hashes[0].add(body.bits.position);
    hashes[1].add(body.bits.orientation);
    hashes[2].add(body.bits.linearVelocity);
    hashes[3].add(body.bits.angularVelocity);
  }
  for (const WordHash& hash : hashes) checks_.fixed(hash.value());
}

void FrameEncoder::writeEvents(const FrameSample& frame) {
  events_.number(frame.events.size());
  std::int64_t before = 0;
  for (const LevelEvent& event : frame.events) {
    events_.byte(static_cast<std::uint8_t>(static_cast<unsigned>(event.kind) |
                                           (static_cast<unsigned>(event.scope) << 3U) |
                                           (event.onCredit ? 0x20U : 0U)));
    events_.byte(levelByte(event.from));
    events_.byte(levelByte(event.to));
    const std::uint64_t policy = indexOf(event.policy);
    events_.number(policy);
    if (policy == policies_.size()) {
      events_.text(event.policy);
      policies_.push_back(event.policy);
    }
    events_.difference(idOf(event.body) - before);
    events_.difference(idOf(event.other));
    before = idOf(event.body);
  }
}

std::uint64_t FrameEncoder::indexOf(std::string_view policy) {
  return static_cast<std::uint64_t>(std::find(policies_.begin(), policies_.end(), policy) -
                                    policies_.begin());
}

void FrameEncoder::writeTwo(BodyId a, BodyId b, std::int64_t& before) {
  contacts_.difference(idOf(a) - before);
  contacts_.difference(idOf(b) - idOf(a));
  before = idOf(a);
}

void FrameEncoder::writePairs(const FrameSample& frame) {
  contacts_.number(frame.pairs.size());
  std::int64_t before = 0;
  for (const PairLevel& pair : frame.pairs) {
    writeTwo(pair.a, pair.b, before);
    contacts_.byte(pair.level);
  }
}

void FrameEncoder::writeContacts(const FrameSample& frame) {
  contacts_.number(frame.contacts.size());
  std::int64_t before = 0;
  for (const RecordedContact& contact : frame.contacts) {
    writeTwo(contact.a, contact.b, before);
    for (int i = 0; i < 3; ++i) writeLength(contact.pointA[i], kRecordedMetres, contacts_);
    for (int i = 0; i < 3; ++i) writeLength(contact.normal[i], kContactNormal, contacts_);
    writeLength(contact.distance, kRecordedMetres, contacts_);
    writeLength(contact.credit, kRecordedMetres, contacts_);
    contacts_.fixed(contact.impulse);
  }
}

// What a channel's numbers have in common with those of the frame before becomes zero, and bytes of the same
// weight lie side by side.
std::string FrameEncoder::planesOfValues() const {
  ByteWriter planes;
  const std::size_t channels = values_.empty() ? 0 : values_.front().size();
  planes.number(channels);
  for (std::size_t channel = 0; channel < channels; ++channel) {
    for (unsigned shift = 0; shift < 64; shift += 8) {
      std::uint64_t before = 0;
      for (const auto& row : values_) {
        const std::uint64_t now = channel < row.size() ? row[channel] : 0;
        planes.byte(static_cast<std::uint8_t>((now ^ before) >> shift));
        before = now;
      }
    }
  }
  return planes.take();
}

std::size_t FrameEncoder::bytes() const {
  const std::size_t values = values_.empty() ? 0 : values_.size() * values_.front().size() * 8;
  return structure_.size() + positions_.size() + rotations_.size() + checks_.size() + events_.size() +
         contacts_.size() + values;
}

std::string FrameEncoder::take() {
  const std::string values = planesOfValues();
  std::array<std::string_view, kStreamCount> streams;
  streams[kStructure] = structure_.view();
  streams[kPositions] = positions_.view();
  streams[kRotations] = rotations_.view();
  streams[kChecks] = checks_.view();
  streams[kEvents] = events_.view();
  streams[kContacts] = contacts_.view();
  streams[kValues] = values;
  std::string packed = packStreams(streams);
  for (ByteWriter* stream : {&structure_, &positions_, &rotations_, &checks_, &events_, &contacts_}) {
    stream->clear();
  }
  tracks_.clear();
  policies_.clear();
  values_.clear();
  frames_ = 0;
  bodyFrames_ = 0;
  return packed;
}

}  // namespace scatter::recording
