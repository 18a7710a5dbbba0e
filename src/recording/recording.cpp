#include <scatter/recording/recording.h>

#include <cerrno>
#include <optional>
#include <system_error>
#include <unordered_map>
#include <utility>

#include "recording/block.h"
#include "recording/body_coder.h"
#include "recording/checks.h"
#include "recording/frame_store.h"
#include "recording/info_coder.h"
#include "recording/read_file.h"

namespace scatter {

namespace {

using recording::BlockHeader;
using recording::BlockKind;

// Without the version.
constexpr std::string_view kMark = recording::kFileStart.substr(0, 12);

std::string counted(std::uint64_t bytes) {
  return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
}

}  // namespace

struct Recording::Parts {
  explicit Parts(const std::filesystem::path& path)
      : file(path), store([this](const recording::BlockPlace& place) -> Result<std::string> {
          return file.read(place.where, place.size);
        }) {}

  [[nodiscard]] Result<void> checkStart() const;
  void readBlocks();
  bool take(const BlockHeader& header, std::uint64_t where);
  [[nodiscard]] std::optional<std::string> whole(const BlockHeader& header, std::uint64_t where) const;
  bool takeBodies(const std::string& content);
  void dropTornFrames();

  recording::ReadFile file;
  recording::FrameStore store;
  recording::BodyDecoder decoder;
  std::optional<RecordingInfo> info;
  std::unordered_map<BodyId, BodyDef> defs;
  bool ended = false;
  std::string stopped;
  std::string damage;
  std::uint64_t bytes = 0;
};

Result<void> Recording::Parts::checkStart() const {
  if (!file.isOpen()) {
    return fail("cannot read " + file.path().string() + ": " + std::generic_category().message(errno));
  }
  const std::string start = file.read(0, recording::kFileStart.size());
  if (start.substr(0, kMark.size()) != kMark) {
    return fail(file.path().string() +
                " is no recording of a run; `scatter run SCENE --record FILE` makes one");
  }
  if (start != recording::kFileStart) {
    return fail(file.path().string() + " was written by another version of Scatter; read it with that");
  }
  return {};
}

std::optional<std::string> Recording::Parts::whole(const BlockHeader& header, std::uint64_t where) const {
  std::string content = file.read(where, header.size);
  return content.size() == header.size && recording::hashOf(content) == header.hash
             ? std::optional(std::move(content))
             : std::nullopt;
}

// What comes behind a block that is not whole cannot be found, or would leave a gap.
void Recording::Parts::readBlocks() {
  std::uint64_t where = recording::kFileStart.size();
  bytes = where;
  while (!ended && where < file.size()) {
    const auto header = recording::readHeader(file.read(where, recording::kHeaderBytes));
    const std::uint64_t content = where + recording::kHeaderBytes;
    if (!header || content + header->size > file.size() || !take(*header, content)) break;
    where = content + header->size;
    bytes = where;
  }
  dropTornFrames();
  if (file.size() > bytes) {
    damage = "the last " + counted(file.size() - bytes) + " are no whole block and are left out";
  } else if (!ended) {
    damage = "it has no end: its program was killed, or still runs";
  }
}

bool Recording::Parts::take(const BlockHeader& header, std::uint64_t where) {
  if (header.kind == BlockKind::kFrames) {
    const auto& places = store.places();
    if (header.frames == 0 || (!places.empty() && header.first != places.back().end())) return false;
    store.add({header.first, header.frames, where, header.size, header.hash});
    return true;
  }
  const auto content = whole(header, where);
  if (!content) return false;
  switch (header.kind) {
    case BlockKind::kInfo:
      if (!info) info = recording::decodeInfo(*content);
      return info.has_value();
    case BlockKind::kBodies:
      return takeBodies(*content);
    case BlockKind::kEnd:
      ended = true;
      stopped = *content;
      return true;
    case BlockKind::kFrames:
      break;
  }
  return false;
}

bool Recording::Parts::takeBodies(const std::string& content) {
  auto bodies = decoder.read(content);
  if (!bodies) return false;
  for (auto& [body, def] : *bodies) defs.insert_or_assign(body, std::move(def));
  return true;
}

// A program that is killed, or a machine, may leave a last block whose header is whole.
void Recording::Parts::dropTornFrames() {
  while (!ended && !store.places().empty()) {
    const recording::BlockPlace place = store.places().back();
    if (recording::hashOf(file.read(place.where, place.size)) == place.hash) return;
    store.dropLast();
    bytes = std::min(bytes, place.where - recording::kHeaderBytes);
  }
}

bool Recording::isOne(const std::filesystem::path& file) {
  const recording::ReadFile opened(file);
  return opened.isOpen() && opened.read(0, kMark.size()) == kMark;
}

Recording::Recording(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

Recording::~Recording() = default;

Result<std::unique_ptr<Recording>> Recording::open(const std::filesystem::path& file) {
  auto parts = std::make_unique<Parts>(file);
  if (auto right = parts->checkStart(); !right) return tl::unexpected(right.error());
  parts->readBlocks();
  if (!parts->info || parts->store.places().empty()) {
    return fail(
        file.string() +
        " has no whole frame; its run was killed before the first was written, or the file is damaged");
  }
  return std::unique_ptr<Recording>(new Recording(std::move(parts)));
}

const RecordingInfo& Recording::info() const {
  return *parts_->info;
}

std::uint64_t Recording::first() const {
  return parts_->store.places().front().first;
}

std::uint64_t Recording::last() const {
  return parts_->store.places().back().end() - 1;
}

Result<std::shared_ptr<const RecordedFrame>> Recording::frame(std::uint64_t number) const {
  return parts_->store.frame(number).map_error([this](Error error) {
    error.message = file().string() + ": " + error.message;
    return error;
  });
}

const BodyDef* Recording::def(BodyId body) const {
  const auto found = parts_->defs.find(body);
  return found == parts_->defs.end() ? nullptr : &found->second;
}

std::string Recording::nameOf(BodyId body) const {
  const BodyDef* found = def(body);
  return found != nullptr && !found->name.empty()
             ? found->name
             : "body " + std::to_string(static_cast<std::uint32_t>(body));
}

const std::string& Recording::stopped() const {
  return parts_->stopped;
}

const std::string& Recording::damage() const {
  return parts_->damage;
}

std::uint64_t Recording::bytes() const {
  return parts_->bytes;
}

std::size_t Recording::seekPoints() const {
  return parts_->store.places().size();
}

const std::filesystem::path& Recording::file() const {
  return parts_->file.path();
}

}  // namespace scatter
