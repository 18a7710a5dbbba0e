#include <scatter/lab/run_history.h>

#include <algorithm>
#include <cassert>
#include <deque>
#include <map>
#include <utility>

#include "io/growing_file.h"
#include "lab/frame_sampler.h"
#include "recording/block_spill.h"
#include "recording/frame_store.h"
#include "recording/info_coder.h"
#include "recording/recording_encoder.h"

namespace scatter {

namespace {

using recording::BlockKind;
using recording::BlockPlace;
using recording::EncodedBlock;

bool hasRoster(const FrameSample& sample, const std::vector<BodyId>& roster) {
  const auto same = [](const SampledBody& sampled, BodyId body) { return sampled.body == body; };
  return std::equal(sample.bodies.begin(), sample.bodies.end(), roster.begin(), roster.end(), same);
}

/// A sample as it will be read, but exact.
std::shared_ptr<const RecordedFrame> frameOf(const FrameSample& sample, const RecordedFrame* before) {
  auto frame = std::make_shared<RecordedFrame>();
  frame->number = sample.number;
  auto roster = std::make_shared<std::vector<BodyId>>();
  for (const SampledBody& body : sample.bodies) {
    roster->push_back(body.body);
    frame->bodies.push_back({.pose = body.pose, .level = body.level, .asleep = body.asleep});
  }
  frame->roster = before != nullptr && *before->roster == *roster ? before->roster : std::move(roster);
  frame->events = sample.events;
  frame->pairs = sample.pairs;
  frame->values = sample.values;
  return frame;
}

}  // namespace

struct RunHistory::Parts {
  explicit Parts(const HistoryDef& historyDef)
      : def(historyDef),
        encoder(blocks()),
        store([this](const BlockPlace& place) { return spill.read(place); }) {}

  [[nodiscard]] RecordingDef blocks() const {
    RecordingDef blocks;
    blocks.blockFrames = def.blockFrames;
    return blocks;
  }

  void endBlock();
  void trim();
  void writeToFile(const std::string& bytes);
  void noteBodies(const FrameSample& sample);

  HistoryDef def;
  std::unique_ptr<Recording> replayed;

  lab::FrameSampler sampler{/*contacts=*/false};
  FrameSample sample;
  recording::RecordingEncoder encoder;
  std::deque<std::shared_ptr<const RecordedFrame>> recent;  // in no block yet, the newest always
  recording::BlockSpill spill;
  recording::FrameStore store;
  std::vector<std::string> bodyBlocks;

  std::map<BodyId, BodyDef> defs;
  std::map<std::uint64_t, std::vector<BodyId>> gone;  // by the last frame that has them

  std::unique_ptr<GrowingFile> file;
  std::optional<Error> failed;
};

RunHistory::RunHistory(const HistoryDef& def) : parts_(std::make_unique<Parts>(def)) {}

RunHistory::~RunHistory() = default;

Result<std::unique_ptr<RunHistory>> RunHistory::open(const std::filesystem::path& recording) {
  auto opened = Recording::open(recording);
  if (!opened) return tl::unexpected(opened.error());
  auto history = std::make_unique<RunHistory>();
  history->parts_->replayed = std::move(*opened);
  return history;
}

const Recording* RunHistory::replayed() const {
  return parts_->replayed.get();
}

void RunHistory::record(const World& world, std::span<const PairLevel> pairs, const FrameData* data) {
  Parts& parts = *parts_;
  assert(!parts.replayed && (empty() || world.frame() == newest() + 1));
  FrameSample& sample = parts.sample;
  sample.clear();
  parts.sampler.sample(world, data, sample);
  if (parts.def.pairLevels) sample.pairs.assign(pairs.begin(), pairs.end());
  parts.noteBodies(sample);
  // The newest frame stays when its block is full, so that it is exact.
  if (parts.encoder.isEmpty()) parts.recent.clear();
  parts.recent.push_back(frameOf(sample, parts.recent.empty() ? nullptr : parts.recent.back().get()));
  parts.encoder.add(sample);
  if (parts.encoder.isFull()) parts.endBlock();
  parts.trim();
}

void RunHistory::Parts::noteBodies(const FrameSample& added) {
  for (const auto& [body, bodyDef] : added.added) defs.emplace(body, bodyDef);
  if (recent.empty() || hasRoster(added, *recent.back()->roster)) return;
  std::vector<BodyId> left;
  for (const BodyId body : *recent.back()->roster) {
    const bool stays = std::any_of(added.bodies.begin(), added.bodies.end(),
                                   [body](const SampledBody& one) { return one.body == body; });
    if (!stays) left.push_back(body);
  }
  if (!left.empty()) gone.emplace(added.number - 1, std::move(left));
}

void RunHistory::Parts::endBlock() {
  for (EncodedBlock& block : encoder.take()) {
    writeToFile(block.bytes);
    if (block.kind == BlockKind::kBodies) {
      bodyBlocks.push_back(std::move(block.bytes));
    } else {
      store.add(spill.add(block));
    }
  }
}

void RunHistory::Parts::trim() {
  const auto& places = store.places();
  while (!places.empty() && (spill.bytes() > def.bytes || spill.mustDrop())) {
    const std::uint64_t end = places.front().end();
    spill.drop(places.front());
    store.dropFirst();
    // A body that has left does not come back.
    for (auto left = gone.begin(); left != gone.end() && left->first < end; left = gone.erase(left)) {
      for (const BodyId body : left->second) defs.erase(body);
    }
  }
}

void RunHistory::clear() {
  const HistoryDef def = parts_->def;
  parts_ = std::make_unique<Parts>(def);
}

bool RunHistory::empty() const {
  return !parts_->replayed && parts_->recent.empty();
}

std::size_t RunHistory::size() const {
  return empty() ? 0 : static_cast<std::size_t>(newest() - oldest() + 1);
}

std::uint64_t RunHistory::oldest() const {
  assert(!empty());
  if (parts_->replayed) return parts_->replayed->first();
  const auto& places = parts_->store.places();
  return places.empty() ? parts_->recent.front()->number : places.front().first;
}

std::uint64_t RunHistory::newest() const {
  assert(!empty());
  return parts_->replayed ? parts_->replayed->last() : parts_->recent.back()->number;
}

bool RunHistory::has(std::uint64_t frame) const {
  return !empty() && frame >= oldest() && frame <= newest();
}

std::uint64_t RunHistory::bytes() const {
  return parts_->replayed ? parts_->replayed->bytes() : parts_->spill.bytes();
}

const HistoryDef& RunHistory::def() const {
  return parts_->def;
}

void RunHistory::setBytes(std::uint64_t bytes) {
  parts_->def.bytes = bytes;
  parts_->trim();
}

RunHistory::Frame RunHistory::frame(std::uint64_t number) const {
  assert(has(number));
  if (parts_->replayed) {
    auto read = parts_->replayed->frame(number);
    if (!read) read = parts_->replayed->frame(newest());
    return Frame(read ? *read : frameOf({}, nullptr));
  }
  const auto& recent = parts_->recent;
  if (number >= recent.front()->number) {
    return Frame(recent[static_cast<std::size_t>(number - recent.front()->number)]);
  }
  auto read = parts_->store.frame(number);
  return Frame(read ? *read : recent.back());
}

const BodyDef* RunHistory::def(BodyId body) const {
  if (parts_->replayed) return parts_->replayed->def(body);
  const auto known = parts_->defs.find(body);
  return known == parts_->defs.end() ? nullptr : &known->second;
}

void RunHistory::Parts::writeToFile(const std::string& bytes) {
  if (!file || failed) return;
  if (auto written = file->add(bytes); !written) failed = written.error();
}

Result<void> RunHistory::startRecording(const std::filesystem::path& file, const RecordingInfo& info) {
  Parts& parts = *parts_;
  assert(!parts.file && !parts.replayed);
  auto made = GrowingFile::create(file);
  if (!made) return tl::unexpected(made.error());
  parts.failed.reset();
  parts.file = std::move(*made);
  std::string start(recording::kFileStart);
  start += recording::makeBlock(BlockKind::kInfo, 0, 0, recording::encodeInfo(info));
  for (const std::string& bodies : parts.bodyBlocks) start += bodies;
  parts.writeToFile(start);
  for (const BlockPlace& place : parts.store.places()) {
    const auto content = parts.spill.read(place);
    if (!content) parts.failed = content.error();
    if (content)
      parts.writeToFile(recording::makeBlock(BlockKind::kFrames, place.first, place.frames, *content));
  }
  if (!parts.failed) return {};
  const Error error = *parts.failed;
  parts.file.reset();
  return tl::unexpected(error);
}

Result<void> RunHistory::stopRecording(const std::string& stopped) {
  Parts& parts = *parts_;
  if (!parts.file) return {};
  parts.endBlock();
  parts.writeToFile(recording::makeBlock(BlockKind::kEnd, 0, 0, stopped));
  const auto finished = parts.file->finish();
  parts.file.reset();
  if (parts.failed) return tl::unexpected(*std::exchange(parts.failed, std::nullopt));
  return finished;
}

bool RunHistory::isRecording() const {
  return parts_->file != nullptr;
}

std::optional<std::size_t> RunHistory::Frame::find(BodyId body) const {
  const auto& roster = *frame_->roster;
  const auto found = std::find(roster.begin(), roster.end(), body);
  if (found == roster.end()) return std::nullopt;
  return static_cast<std::size_t>(found - roster.begin());
}

}  // namespace scatter
