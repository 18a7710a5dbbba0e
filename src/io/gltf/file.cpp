#include "io/gltf/file.h"

#include <scatter/io/file.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "io/collada/xml_source.h"
#include "io/gltf/base64.h"
#include "io/numbers.h"

namespace scatter::io {
namespace {

static_assert(std::endian::native == std::endian::little,
              "glTF data is little-endian and is copied as it is");

constexpr std::string_view kMagic = "glTF";
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::size_t kMaxBufferBytes = std::size_t{1} << 30U;
constexpr std::size_t kMaxWarnings = 200;

[[noreturn]] void failFile(const std::string& what) {
  throw GltfFailure{what};
}

std::uint32_t readWord(std::string_view bytes, std::size_t offset) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

std::optional<unsigned> hexDigit(char c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  const std::size_t at = kHex.find(static_cast<char>(c | 0x20));
  return at == std::string_view::npos ? std::nullopt : std::optional(static_cast<unsigned>(at));
}

std::string decodePercents(std::string_view uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size()) {
      const auto high = hexDigit(uri[i + 1]);
      const auto low = hexDigit(uri[i + 2]);
      if (high && low) {
        text += static_cast<char>(*high * 16 + *low);
        i += 2;
        continue;
      }
    }
    text += uri[i];
  }
  return text;
}

/// "nodes" and "meshes" are arrays of a "node" and a "mesh".
std::string singular(std::string_view array) {
  return std::string(array.substr(0, array.size() - (array.ends_with("shes") ? 2 : 1)));
}

}  // namespace

void GltfBudget::spend(std::size_t amount, const JsonPlace& place) {
  if (amount > left_) {
    place.fail(
        "is too much: the file has more than thirty million vertices, triangles and pairs of parts in all");
  }
  left_ -= amount;
}

std::size_t levelCost(const std::vector<Level>& levels) {
  constexpr std::size_t kPair = 4;
  std::size_t cost = 0;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    // A level of a million parts is too much on its own, and the product would not overflow.
    cost += kPair * std::min<std::size_t>(levels[i - 1].parts.size(), 1U << 20U) *
            std::min<std::size_t>(levels[i].parts.size(), 1U << 20U);
  }
  return cost;
}

GltfFile::GltfFile(std::string_view bytes, GltfAccess access) : access_(std::move(access)) {
  auto json = JsonDocument::parse(readContainer(bytes));
  if (!json) {
    failFile(json.error().message);
  }
  json_ = std::move(*json);
  const JsonPlace version = root().at("asset").at("version");
  if (version.text().rfind("2.", 0) != 0) {
    version.fail("only glTF 2 is supported");
  }
}

std::string_view GltfFile::readContainer(std::string_view bytes) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunkHeader = 8;
  if (bytes.substr(0, kMagic.size()) != kMagic) {
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    return bytes.substr(bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  }
  if (bytes.size() < kHeader || readWord(bytes, 4) != 2) {
    failFile("is not a GLB file of version 2");
  }
  if (readWord(bytes, 8) > bytes.size()) {
    failFile("the file ends early: " + std::to_string(bytes.size()) + " of " +
             std::to_string(readWord(bytes, 8)) + " bytes are there");
  }
  bytes = bytes.substr(0, readWord(bytes, 8));
  std::optional<std::string_view> json;
  for (std::size_t at = kHeader; at + kChunkHeader <= bytes.size();) {
    const std::size_t length = readWord(bytes, at);
    const std::uint32_t kind = readWord(bytes, at + 4);
    at += kChunkHeader;
    if (length > bytes.size() - at) {
      failFile("a chunk of the GLB file is longer than the file");
    }
    if (!json && kind == kJsonChunk) {
      json = bytes.substr(at, length);
    } else if (json && !binary_ && kind == kBinaryChunk) {
      binary_ = bytes.substr(at, length);
    }
    at += length;
  }
  if (!json) {
    failFile("the GLB file has no JSON chunk");
  }
  return *json;
}

std::size_t GltfFile::count(const char* array) const {
  const auto found = root().find(array);
  return found ? found->size() : 0;
}

JsonPlace GltfFile::entry(const char* array, std::size_t index) const {
  return root().at(array)[index];
}

JsonPlace GltfFile::entry(const char* array, const JsonPlace& reference) const {
  return entry(array, reference.index(count(array), singular(array).c_str()));
}

std::string_view GltfFile::bufferView(const JsonPlace& reference) {
  const JsonPlace view = entry("bufferViews", reference);
  const auto compression =
      access_.decompress ? view.find({"extensions", "EXT_meshopt_compression"}) : std::nullopt;
  if (!compression) {
    return slice(view);
  }
  const std::size_t index = reference.index(count("bufferViews"), "bufferView");
  const auto found = decompressed_.find(index);
  if (found != decompressed_.end()) {
    return found->second;
  }
  return keep(decompressed_, index, access_.decompress(*compression, slice(*compression)), *compression);
}

std::string_view GltfFile::keep(std::map<std::size_t, std::string>& store, std::size_t index,
                                std::string bytes, const JsonPlace& place) {
  bufferBytes_ += bytes.size();
  if (bufferBytes_ > kMaxBufferBytes) {
    place.fail("the buffers of the file are larger than 1 GiB");
  }
  return store.emplace(index, std::move(bytes)).first->second;
}

std::string_view GltfFile::slice(const JsonPlace& view) {
  const std::string_view bytes = buffer(view.at("buffer"));
  const auto offset = view.find("byteOffset");
  const std::uint64_t begin = offset ? offset->count() : 0;
  const std::uint64_t length = view.at("byteLength").count();
  if (begin > bytes.size() || length > bytes.size() - begin) {
    view.fail("reaches beyond the end of its buffer, which has " + std::to_string(bytes.size()) + " bytes");
  }
  return bytes.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(length));
}

std::string_view GltfFile::buffer(const JsonPlace& reference) {
  const JsonPlace place = entry("buffers", reference);
  const std::size_t index = reference.index(count("buffers"), "buffer");
  const std::uint64_t length = place.at("byteLength").count();
  const auto uri = place.find("uri");
  std::string_view bytes;
  if (!uri) {
    if (index != 0 || !binary_) {
      place.fail("has no \"uri\", and the file has no binary chunk for it");
    }
    bytes = *binary_;
  } else {
    const auto found = buffers_.find(index);
    bytes = found != buffers_.end() ? std::string_view(found->second)
                                    : keep(buffers_, index, loadBuffer(*uri), place);
  }
  if (length > bytes.size()) {
    place.fail("should have " + std::to_string(length) + " bytes, but has " + std::to_string(bytes.size()));
  }
  return bytes.substr(0, static_cast<std::size_t>(length));
}

std::string GltfFile::loadBuffer(const JsonPlace& uri) const {
  const std::string text = uri.text();
  if (text.rfind("data:", 0) == 0) {
    const std::size_t comma = text.find(',');
    const std::string_view head = std::string_view(text).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64")) {
      uri.fail("only base64 data is supported here");
    }
    auto bytes = decodeBase64(std::string_view(text).substr(comma + 1));
    if (!bytes) {
      uri.fail("holds damaged base64 data");
    }
    return std::move(*bytes);
  }
  const std::filesystem::path name(decodePercents(text));
  if (!access_.folder || text.find("://") != std::string::npos || name.is_absolute() ||
      name.string().find('\0') != std::string::npos) {
    uri.fail("only data and files beside this one are read");
  }
  const std::filesystem::path path = *access_.folder / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    uri.fail("there is no file " + path.string());
  }
  if (access_.allows && !access_.allows(path)) {
    uri.fail("only data and files beside this one are read");
  }
  auto bytes = readFile(path);
  if (!bytes) {
    uri.fail(bytes.error().message);
  }
  return std::move(*bytes);
}

void GltfFile::warn(const JsonPlace& place, const std::string& what) {
  warn(place.path().empty() ? what : place.path() + ": " + what);
}

void GltfFile::warn(const std::string& what) {
  if (std::find(warnings_.begin(), warnings_.end(), what) != warnings_.end()) {
    return;
  }
  if (warnings_.size() < kMaxWarnings) {
    warnings_.push_back(what);
  } else {
    ++warningsLeftOut_;
  }
}

void GltfFile::warnUnknown(const JsonPlace& place, std::initializer_list<std::string_view> known) {
  for (const std::string& key : place.keys()) {
    if (std::find(known.begin(), known.end(), key) == known.end() && key != "name" && key != "extras" &&
        key != "extensions") {
      warn(place, inQuotes(key) + " is not known here and is ignored");
    }
  }
}

std::vector<std::string> GltfFile::takeWarnings() {
  if (warningsLeftOut_ > 0) {
    warnings_.push_back("and " + std::to_string(warningsLeftOut_) + " warnings more");
  }
  return std::move(warnings_);
}

}  // namespace scatter::io
