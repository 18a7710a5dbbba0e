#include <tuple>
#include <unordered_map>
#include <utility>

#include "recording/compression.h"
#include "recording/frame_coder.h"
#include "recording/frame_streams.h"

namespace scatter::recording {

namespace {

using Roster = std::vector<BodyId>;

std::optional<BodyId> bodyOf(std::int64_t id) {
  if (id < 0 || id > 0xFFFFFFFF) return std::nullopt;
  return BodyId{static_cast<std::uint32_t>(id)};
}

float readLength(ByteReader& in, float unit) {
  return static_cast<float>(static_cast<double>(in.difference()) * static_cast<double>(unit));
}

class FrameDecoder {
 public:
  FrameDecoder(const std::vector<std::string>& streams, std::uint32_t frames, const NameKeeper& keepName)
      : structure_(streams[kStructure]),
        positions_(streams[kPositions]),
        rotations_(streams[kRotations]),
        checks_(streams[kChecks]),
        events_(streams[kEvents]),
        contacts_(streams[kContacts]),
        frames_(frames),
        keepName_(keepName) {
    ByteReader values(streams[kValues]);
    channels_ = values.number();
    planes_ = values.take(values.left());
    isWhole_ = !values.failed() && channels_ <= planes_.size() && channels_ * 8 * frames == planes_.size();
  }

  std::optional<std::vector<RecordedFrame>> frames(std::uint64_t first) {
    std::vector<RecordedFrame> frames;
    for (std::uint32_t i = 0; i < frames_ && isWhole_; ++i) {
      RecordedFrame frame;
      frame.number = first + i;
      readRoster(i == 0);
      readBodies(frame);
      readEvents(frame);
      readPairs(frame);
      readContacts(frame);
      frame.values = i == 0 ? std::vector<std::uint64_t>(channels_) : frames.back().values;
      readValues(i, frame.values);
      frames.push_back(std::move(frame));
      for (const ByteReader* stream :
           {&structure_, &positions_, &rotations_, &checks_, &events_, &contacts_}) {
        isWhole_ = isWhole_ && !stream->failed();
      }
    }
    return isWhole_ && structure_.left() == 0 ? std::optional(std::move(frames)) : std::nullopt;
  }

 private:
  struct Track {
    RecordedBody body{};
    PoseTrack pose{};
    bool known = false;
  };

  BodyId readBody(ByteReader& in, std::int64_t before) {
    const auto body = bodyOf(static_cast<std::int64_t>(static_cast<std::uint64_t>(in.difference()) +
                                                       static_cast<std::uint64_t>(before)));
    if (!body) in.setFailed();
    return body.value_or(BodyId{});
  }

  /// Two bodies; `before`: the first one of those before them.
  std::pair<BodyId, BodyId> readTwo(std::int64_t& before) {
    const BodyId a = readBody(contacts_, before);
    before = idOf(a);
    return {a, readBody(contacts_, before)};
  }

  static std::int64_t idOf(BodyId body) {
    return static_cast<std::int64_t>(static_cast<std::uint32_t>(body));
  }

  void readRoster(bool isFirst) {
    const std::uint8_t changed = structure_.byte();
    if (changed == 0) {
      if (isFirst) structure_.setFailed();
      return;
    }
    std::unordered_map<BodyId, Track> known;
    for (std::size_t i = 0; i < tracks_.size(); ++i) known.emplace((*roster_)[i], tracks_[i]);
    auto roster = std::make_shared<Roster>();
    tracks_.clear();
    std::int64_t before = 0;
    for (std::size_t left = structure_.count(); left > 0 && !structure_.failed(); --left) {
      const BodyId body = readBody(structure_, before);
      before = idOf(body);
      roster->push_back(body);
      const auto track = known.find(body);
      tracks_.push_back(track != known.end() ? track->second : Track{});
    }
    roster_ = std::move(roster);
    moved_.assign((tracks_.size() + 7) / 8, 0);
  }

  std::vector<std::size_t> readIndices() {
    std::vector<std::size_t> indices;
    std::uint64_t index = 0;
    for (std::size_t left = structure_.count(); left > 0; --left) {
      index += structure_.number();
      if (structure_.failed() || index >= tracks_.size()) {
        structure_.setFailed();
        return {};
      }
      indices.push_back(static_cast<std::size_t>(index));
    }
    return indices;
  }

  void readBodies(RecordedFrame& frame) {
    bodyFrames_ += tracks_.size();
    if (bodyFrames_ > kMostBodyFrames) structure_.setFailed();
    for (std::uint8_t& bits : moved_) bits = static_cast<std::uint8_t>(bits ^ structure_.byte());
    const std::vector<std::size_t> anew = readIndices();
    const std::vector<std::size_t> changed = readIndices();
    for (const std::size_t i : changed) {
      const std::uint8_t state = structure_.byte();
      tracks_[i].body.level = state & kLargestLevel;
      tracks_[i].body.asleep = (state & kAsleep) != 0;
    }
    if (structure_.failed()) return;
    auto begins = anew.begin();
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      const bool begun = begins != anew.end() && *begins == i;
      if (begun) ++begins;
      readBody(tracks_[i], (moved_[i / 8] & (1U << (i % 8))) != 0, begun);
    }
    frame.roster = roster_;
    frame.bodies.reserve(tracks_.size());
    for (const Track& track : tracks_) frame.bodies.push_back(track.body);
    for (std::uint64_t& hash : frame.hashes) hash = checks_.fixed<std::uint64_t>();
  }

  void readBody(Track& track, bool moved, bool begun) {
    if (!moved) {
      track.pose.rest();
      if (!track.known) structure_.setFailed();
      return;
    }
    if (begun) {
      track.pose.readBegin(positions_, rotations_);
    } else {
      track.pose.read(positions_, rotations_);
    }
    track.known = true;
    track.body.pose = track.pose.last().pose();
    for (std::uint8_t& check : track.body.checks) check = checks_.byte();
  }

  void readEvents(RecordedFrame& frame) {
    std::int64_t before = 0;
    for (std::size_t left = events_.count(6); left > 0 && !events_.failed(); --left) {
      const std::uint8_t kind = events_.byte();
      LevelEvent event;
      event.kind = static_cast<LevelEventKind>(kind & 7U);
      event.scope = static_cast<Scope>((kind >> 3U) & 3U);
      event.onCredit = (kind & 0x20U) != 0;
      event.from = events_.byte();
      event.to = events_.byte();
      const std::uint64_t policy = events_.number();
      if (policy == policies_.size()) policies_.push_back(keepName_(events_.text()));
      event.body = readBody(events_, before);
      event.other = readBody(events_, 0);
      before = idOf(event.body);
      if (policy >= policies_.size() || event.kind > LevelEventKind::kRetracted ||
          event.scope > Scope::kGlobal) {
        events_.setFailed();
        return;
      }
      event.policy = policies_[static_cast<std::size_t>(policy)];
      frame.events.push_back(event);
    }
  }

  void readPairs(RecordedFrame& frame) {
    std::int64_t before = 0;
    for (std::size_t left = contacts_.count(3); left > 0 && !contacts_.failed(); --left) {
      PairLevel pair;
      std::tie(pair.a, pair.b) = readTwo(before);
      pair.level = contacts_.byte();
      frame.pairs.push_back(pair);
    }
  }

  void readContacts(RecordedFrame& frame) {
    std::int64_t before = 0;
    for (std::size_t left = contacts_.count(14); left > 0 && !contacts_.failed(); --left) {
      RecordedContact contact;
      std::tie(contact.a, contact.b) = readTwo(before);
      for (int i = 0; i < 3; ++i) contact.pointA[i] = readLength(contacts_, kRecordedMetres);
      for (int i = 0; i < 3; ++i) contact.normal[i] = readLength(contacts_, kContactNormal);
      contact.distance = readLength(contacts_, kRecordedMetres);
      contact.credit = readLength(contacts_, kRecordedMetres);
      contact.impulse = contacts_.fixed<float>();
      frame.contacts.push_back(contact);
    }
  }

  void readValues(std::size_t row, std::vector<std::uint64_t>& values) const {
    for (std::size_t channel = 0; channel < channels_; ++channel) {
      for (std::size_t byte = 0; byte < 8; ++byte) {
        const auto bits = static_cast<std::uint8_t>(planes_[(channel * 8 + byte) * frames_ + row]);
        values[channel] ^= static_cast<std::uint64_t>(bits) << (8 * byte);
      }
    }
  }

  ByteReader structure_;
  ByteReader positions_;
  ByteReader rotations_;
  ByteReader checks_;
  ByteReader events_;
  ByteReader contacts_;
  std::string_view planes_;
  std::uint64_t channels_ = 0;
  std::uint32_t frames_;
  const NameKeeper& keepName_;
  bool isWhole_ = false;
  std::size_t bodyFrames_ = 0;
  std::shared_ptr<const Roster> roster_;
  std::vector<Track> tracks_;
  std::vector<std::uint8_t> moved_;
  std::vector<std::string_view> policies_;
};

}  // namespace

std::optional<std::vector<RecordedFrame>> decodeFrames(std::string_view bytes, std::uint64_t first,
                                                       std::uint32_t frames, const NameKeeper& keepName) {
  if (frames == 0 || frames > kMostBlockFrames) return std::nullopt;
  const auto streams = unpackStreams(bytes, kStreamCount, kMostBlockBytes);
  return streams ? FrameDecoder(*streams, frames, keepName).frames(first) : std::nullopt;
}

}  // namespace scatter::recording
