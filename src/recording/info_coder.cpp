#include "recording/info_coder.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "recording/compression.h"
#include "recording/frame_streams.h"

namespace scatter {

std::optional<std::size_t> RecordingInfo::channel(std::string_view name) const {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [name](const auto& one) { return one.name == name; });
  if (found == channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - channels.begin());
}

namespace recording {

namespace {

using Json = nlohmann::json;

constexpr std::array<const char*, 3> kKinds{"real", "integer", "hash"};

std::optional<RecordingInfo> fromJson(const Json& json) {
  RecordingInfo info;
  info.scene = json.at("scene").get<std::string>();
  info.label = json.at("label").get<std::string>();
  info.engine = json.at("engine").get<std::string>();
  info.seed = json.at("seed").get<std::uint64_t>();
  info.framesAsked = json.at("frames_asked").get<std::uint64_t>();
  info.stepSeconds = json.at("step_s").get<double>();
  for (const Json& channel : json.at("channels")) {
    const auto kind = std::find(kKinds.begin(), kKinds.end(), channel.at("kind").get<std::string>());
    if (kind == kKinds.end()) return std::nullopt;
    info.channels.push_back({channel.at("name").get<std::string>(), channel.at("unit").get<std::string>(),
                             static_cast<RecordedKind>(kind - kKinds.begin())});
  }
  for (const auto& [name, note] : json.at("notes").items()) info.notes[name] = note.get<std::string>();
  return info.stepSeconds > 0.0 ? std::optional(std::move(info)) : std::nullopt;
}

}  // namespace

std::string encodeInfo(const RecordingInfo& info) {
  Json channels = Json::array();
  for (const RecordedChannel& channel : info.channels) {
    channels.push_back({{"name", channel.name},
                        {"unit", channel.unit},
                        {"kind", kKinds[static_cast<std::size_t>(channel.kind)]}});
  }
  const Json json{{"scene", info.scene},
                  {"label", info.label},
                  {"engine", info.engine},
                  {"seed", info.seed},
                  {"frames_asked", info.framesAsked},
                  {"step_s", info.stepSeconds},
                  {"channels", std::move(channels)},
                  {"notes", info.notes}};
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::array<std::string_view, 1> streams{text};
  return packStreams(streams);
}

std::optional<RecordingInfo> decodeInfo(std::string_view bytes) {
  const auto streams = unpackStreams(bytes, 1, kMostBlockBytes);
  if (!streams) return std::nullopt;
  const Json json = Json::parse(streams->front(), nullptr, /*allow_exceptions=*/false);
  try {
    return fromJson(json);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace recording

}  // namespace scatter
