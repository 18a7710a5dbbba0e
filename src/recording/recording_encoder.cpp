#include "recording/recording_encoder.h"

namespace scatter::recording {

void RecordingEncoder::add(const FrameSample& frame) {
  for (const auto& [body, def] : frame.added) bodies_.add(body, def);
  frames_.add(frame);
}

bool RecordingEncoder::isFull() const {
  return frames_.frames() >= def_.blockFrames || frames_.bytes() >= def_.blockBytes ||
         frames_.bodyFrames() >= def_.blockBodyFrames;
}

std::vector<EncodedBlock> RecordingEncoder::take() {
  std::vector<EncodedBlock> blocks;
  if (isEmpty()) return blocks;
  const std::uint64_t first = frames_.first();
  const std::uint32_t frames = frames_.frames();
  if (!bodies_.empty()) {
    blocks.push_back({BlockKind::kBodies, first, 0, makeBlock(BlockKind::kBodies, first, 0, bodies_.take())});
  }
  blocks.push_back(
      {BlockKind::kFrames, first, frames, makeBlock(BlockKind::kFrames, first, frames, frames_.take())});
  return blocks;
}

}  // namespace scatter::recording
