#include <scatter/io/mesh_file.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

#include "io/mesh/assimp_mesh.h"
#include "io/mesh/isolated_call.h"

namespace scatter {
namespace {

namespace fs = std::filesystem;

/// Memory that a reader may take: parsed text is far larger than the file.
constexpr std::uint64_t kMemoryPerByte = 256;
constexpr std::uint64_t kLeastMemory = std::uint64_t{1} << 30U;
constexpr std::uint64_t kMostMemory = std::uint64_t{16} << 30U;

/// A reader that still runs after this has lost its way: 20 times what sound files take.
constexpr std::uint64_t kLeastSeconds = 5;
constexpr std::uint64_t kBytesPerSecond = std::uint64_t{1} << 19U;

/// A mesh or an error as bytes, for the way from one process to the other.
class Packer {
 public:
  template <class Value>
  void add(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Value>
  void addAll(const std::vector<Value>& values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    add<std::uint64_t>(values.size());
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value));
  }
  void addText(const std::string& text) { addAll(std::vector<char>(text.begin(), text.end())); }

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what Packer wrote; what is missing comes out as zero or empty.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class Value>
  Value get() {
    Value value{};
    copy(&value, sizeof value);
    return value;
  }
  template <class Value>
  std::vector<Value> getAll() {
    const auto count = get<std::uint64_t>();
    std::vector<Value> values(count <= bytes_.size() / sizeof(Value) ? count : 0);
    if (!values.empty()) copy(values.data(), values.size() * sizeof(Value));
    return values;
  }
  std::string getText() {
    const std::vector<char> characters = getAll<char>();
    return {characters.begin(), characters.end()};
  }

 private:
  void copy(void* target, std::size_t size) {
    if (size > bytes_.size()) return;
    std::memcpy(target, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
};

std::string pack(const Result<MeshFile>& read) {
  Packer packer;
  packer.add(read.has_value());
  if (!read) {
    packer.addText(read.error().message);
    return packer.take();
  }
  packer.addAll(read->mesh.vertices);
  packer.addAll(read->mesh.triangles);
  packer.add(read->pieces);
  packer.add(read->fromFile);
  packer.add<std::uint64_t>(read->groups.size());
  for (const MeshGroup& group : read->groups) {
    packer.add(group.kind);
    packer.addText(group.name);
    packer.addAll(group.runs);
  }
  packer.add<std::uint64_t>(read->warnings.size());
  for (const std::string& warning : read->warnings) packer.addText(warning);
  return packer.take();
}

Result<MeshFile> unpack(std::string_view bytes) {
  Unpacker unpacker(bytes);
  if (!unpacker.get<bool>()) return fail(unpacker.getText());
  MeshFile file;
  file.mesh.vertices = unpacker.getAll<Vec3>();
  file.mesh.triangles = unpacker.getAll<std::array<std::uint32_t, 3>>();
  file.pieces = unpacker.get<int>();
  file.fromFile = unpacker.get<Mat3>();
  for (auto count = unpacker.get<std::uint64_t>(); count > 0; --count) {
    MeshGroup group;
    group.kind = unpacker.get<MeshGroupKind>();
    group.name = unpacker.getText();
    group.runs = unpacker.getAll<std::array<std::uint32_t, 2>>();
    file.groups.push_back(std::move(group));
  }
  for (auto count = unpacker.get<std::uint64_t>(); count > 0; --count) {
    file.warnings.push_back(unpacker.getText());
  }
  return file;
}

std::string extensionOf(const fs::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

std::string listOf(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// Printable, on one line and not too long, whatever the file put into it.
std::string tidy(const std::string& text) {
  constexpr std::size_t kLongest = 240;
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isPlain = byte > 0x20 && byte < 0x7f;
    if (isPlain)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
    if (line.size() >= kLongest) break;
  }
  return line;
}

/// The size of the file in bytes.
Result<std::uint64_t> checkFile(const fs::path& path, const std::string& extension,
                                const MeshOptions& options) {
  const auto& known = meshExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end()) {
    return fail(path.string() + ": is no mesh file by its extension; known are " + listOf(known));
  }
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!error && !fs::is_regular_file(status))
    return fail("cannot read " + path.string() + ": it is no plain file");
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return fail("cannot read " + path.string() + ": " + std::generic_category().message(errno));
  close(file);
  const std::uint64_t size = fs::file_size(path, error);
  if (error) return fail("cannot read " + path.string() + ": " + error.message());
  if (size == 0) return fail(path.string() + ": is empty");
  if (size > options.maxFileBytes) {
    return fail(path.string() + ": is larger than " + std::to_string(options.maxFileBytes >> 20U) +
                " MiB; simplify the mesh first");
  }
  return size;
}

/// Assimp looks for the end of a ply header for ever.
Result<void> checkPlyHeader(const fs::path& path) {
  constexpr std::size_t kLongestHeader = std::size_t{1} << 20U;
  std::ifstream stream(path, std::ios::binary);
  std::string start(kLongestHeader, '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(stream.gcount()));
  const std::size_t end = start.find("end_header");
  const bool isWhole =
      end != std::string::npos && end > 0 && (start[end - 1] == '\n' || start[end - 1] == '\r');
  if (isWhole) return {};
  return fail(path.string() + ": has no line \"end_header\"; is the file damaged?");
}

}  // namespace

const std::vector<std::string>& meshExtensions() {
  static const std::vector<std::string> extensions = [] {
    // Those that most people have come first.
    std::vector<std::string> list{"obj", "stl", "ply", "fbx", "dae", "gltf", "glb"};
    for (const std::string& other : io::assimpExtensions()) {
      if (std::find(list.begin(), list.end(), other) == list.end()) list.push_back(other);
    }
    return list;
  }();
  return extensions;
}

Result<MeshFile> readMesh(const fs::path& path, const MeshOptions& options) {
  const std::string extension = extensionOf(path);
  const Result<std::uint64_t> size = checkFile(path, extension, options);
  if (!size) return fail(size.error().message);
  if (extension == "ply") {
    if (auto sound = checkPlyHeader(path); !sound) return fail(sound.error().message);
  }
  const io::IsolationLimits limits{
      .memoryBytes = std::min(kLeastMemory + kMemoryPerByte * *size, kMostMemory),
      .processorSeconds =
          static_cast<int>(std::min(kLeastSeconds + *size / kBytesPerSecond,
                                    static_cast<std::uint64_t>(std::max(1, options.maxSeconds)))),
      .answerBytes = kLeastMemory};
  const Result<std::string> bytes =
      io::callIsolated([&] { return pack(io::readWithAssimp(path, extension, options)); }, limits);
  const std::string name = path.string() + ": ";
  if (!bytes)
    return fail(name + "cannot be read: the reader " + bytes.error().message + "; is the file damaged?");
  Result<MeshFile> file = unpack(*bytes);
  if (!file) return fail(name + tidy(file.error().message));
  file->name = path.stem().string();
  for (std::string& warning : file->warnings) warning.insert(0, name);
  return file;
}

Result<double> parseUnit(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, double>, 6> kUnits{
      {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"km", 1000.0}, {"in", 0.0254}, {"ft", 0.3048}}};
  for (const auto& [name, metres] : kUnits) {
    if (text == name) return metres;
  }
  double metres = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), metres);
  if (error == std::errc() && stop == text.data() + text.size() && std::isfinite(metres) && metres > 0.0) {
    return metres;
  }
  return fail("unit \"" + std::string(text) +
              "\" is neither a positive number of metres nor one of m, cm, mm, km, in, ft");
}

}  // namespace scatter
