#include "recording/body_coder.h"

#include <cmath>
#include <functional>

#include "recording/compression.h"
#include "recording/frame_streams.h"

namespace scatter::recording {

namespace {

// What follows: a body, or something that bodies share.
enum Entry : std::uint8_t { kBody, kLevelSet, kTriangleMesh, kHeightField, kSurfaceMesh };

using Levels = std::shared_ptr<const LevelSet>;
using Triangles = std::shared_ptr<const TriangleMesh>;
using Heights = std::shared_ptr<const HeightField>;

template <class... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

void writePoints(const std::vector<Vec3>& points, ByteWriter& out) {
  out.number(points.size());
  for (const Vec3& point : points) out.fixed(point);
}

std::vector<Vec3> readPoints(ByteReader& in) {
  std::vector<Vec3> points(in.count(sizeof(Vec3)));
  for (Vec3& point : points) point = in.fixed<Vec3>();
  return points;
}

void writePose(const Transform& pose, ByteWriter& out) {
  out.fixed(pose.position);
  for (int i = 0; i < 4; ++i) out.fixed(pose.rotation[i]);
}

Transform readPose(ByteReader& in) {
  Transform pose;
  pose.position = in.fixed<Vec3>();
  for (int i = 0; i < 4; ++i) pose.rotation[i] = in.fixed<float>();
  return pose;
}

void writeConvex(const ConvexShape& shape, ByteWriter& out) {
  out.byte(static_cast<std::uint8_t>(shape.index()));
  std::visit(Overloaded{[&](const Box& box) { out.fixed(box.halfExtents); },
                        [&](const Sphere& sphere) { out.fixed(sphere.radius); },
                        [&](const ConvexHull& hull) { writePoints(hull.vertices, out); },
                        [&](const auto& round) {
                          out.fixed(round.radius);
                          out.fixed(round.halfHeight);
                        }},
             shape);
}

ConvexShape readConvex(ByteReader& in, std::uint8_t kind) {
  switch (kind) {
    case 0:
      return Box{in.fixed<Vec3>()};
    case 1:
      return Sphere{in.fixed<float>()};
    case 2: {
      const auto radius = in.fixed<float>();
      return Capsule{radius, in.fixed<float>()};
    }
    case 3: {
      const auto radius = in.fixed<float>();
      return Cylinder{radius, in.fixed<float>()};
    }
    case 4:
      return ConvexHull{readPoints(in)};
    default:
      in.setFailed();
      return Sphere{};
  }
}

void writeParts(const std::vector<ConvexPart>& parts, ByteWriter& out) {
  out.number(parts.size());
  for (const ConvexPart& part : parts) {
    writeConvex(part.shape, out);
    writePose(part.pose, out);
  }
}

std::vector<ConvexPart> readParts(ByteReader& in) {
  std::vector<ConvexPart> parts;
  for (std::size_t left = in.count(33); left > 0 && !in.failed(); --left) {
    ConvexPart part;
    part.shape = readConvex(in, in.byte());
    part.pose = readPose(in);
    parts.push_back(std::move(part));
  }
  return parts;
}

void writeLevels(const LevelSet& levels, ByteWriter& out) {
  out.text(levels.name());
  out.fixed(levels.hullMargin());
  out.fixed(levels.mass());
  out.number(static_cast<std::uint64_t>(levels.count()));
  for (int level = 1; level <= levels.count(); ++level) writeParts(levels.level(level).parts, out);
}

Levels readLevels(ByteReader& in) {
  LevelSetDef def;
  def.name = in.text();
  def.hullMargin = in.fixed<float>();
  def.mass = in.fixed<MassProperties>();
  for (std::size_t left = in.count(); left > 0 && !in.failed(); --left) def.levels.push_back({readParts(in)});
  if (in.failed()) return nullptr;
  // They were proven to nest when they were made, which takes long.
  const NestingUnchecked unchecked;
  auto levels = LevelSet::create(std::move(def));
  return levels ? *levels : nullptr;
}

template <class Mesh>
void writeMesh(const Mesh& mesh, ByteWriter& out) {
  writePoints(mesh.vertices, out);
  out.number(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) out.number(corner);
  }
}

template <class Mesh>
std::shared_ptr<const Mesh> readMesh(ByteReader& in) {
  auto mesh = std::make_shared<Mesh>();
  mesh->vertices = readPoints(in);
  mesh->triangles.resize(in.count(3));
  for (auto& triangle : mesh->triangles) {
    for (std::uint32_t& corner : triangle) {
      const std::uint64_t number = in.number();
      if (number >= mesh->vertices.size()) in.setFailed();
      corner = static_cast<std::uint32_t>(number);
    }
  }
  return in.failed() ? nullptr : mesh;
}

void writeHeights(const HeightField& field, ByteWriter& out) {
  out.number(field.columns);
  out.number(field.rows);
  out.fixed(field.spacingX);
  out.fixed(field.spacingZ);
  for (const float height : field.heights) out.fixed(height);
}

Heights readHeights(ByteReader& in) {
  auto field = std::make_shared<HeightField>();
  const std::uint64_t columns = in.number();
  const std::uint64_t rows = in.number();
  field->spacingX = in.fixed<float>();
  field->spacingZ = in.fixed<float>();
  const std::size_t most = in.left() / sizeof(float);
  if (columns < 2 || rows < 2 || columns > most || rows > most / columns) return nullptr;
  field->columns = static_cast<std::uint32_t>(columns);
  field->rows = static_cast<std::uint32_t>(rows);
  field->heights.resize(static_cast<std::size_t>(columns * rows));
  for (float& height : field->heights) height = in.fixed<float>();
  return field;
}

bool isPlausible(float length) {
  return std::isfinite(length) && length >= 0.0F && length < 1e9F;
}

bool arePlausible(const std::vector<Vec3>& points) {
  for (const Vec3& point : points) {
    for (int i = 0; i < 3; ++i) {
      if (!isPlausible(std::abs(point[i]))) return false;
    }
  }
  return true;
}

bool isPlausible(const ConvexShape& shape) {
  return std::visit(
      Overloaded{
          [](const Box& box) { return arePlausible({box.halfExtents}); },
          [](const Sphere& sphere) { return isPlausible(sphere.radius); },
          [](const ConvexHull& hull) { return hull.vertices.size() >= 4 && arePlausible(hull.vertices); },
          [](const auto& round) { return isPlausible(round.radius) && isPlausible(round.halfHeight); }},
      shape);
}

bool arePlausible(const std::vector<ConvexPart>& parts) {
  for (const ConvexPart& part : parts) {
    if (!isPlausible(part.shape) || !arePlausible({part.pose.position})) return false;
  }
  return !parts.empty();
}

Shape anyShape(ConvexShape shape) {
  return std::visit([](auto& convex) { return Shape(std::move(convex)); }, shape);
}

// Beside the convex ones, which have their index.
enum ShapeKind : std::uint8_t { kPlane = 5, kCompound, kModel };

}  // namespace

std::uint64_t BodyEncoder::writeModel(const void* key, const std::shared_ptr<const void>& owner,
                                      const std::function<void(ByteWriter&)>& write) {
  const auto [known, isNew] = known_.try_emplace(key, Known{known_.size(), owner});
  if (isNew) write(out_);
  return known->second.number;
}

void BodyEncoder::add(BodyId body, const BodyDef& def) {
  const auto shared = [this](const auto& model, Entry entry, const auto& write) {
    return writeModel(model.get(), model, [&](ByteWriter& out) {
      out.byte(entry);
      write(*model, out);
    });
  };
  // What is shared comes before the body, whose entry names it.
  std::uint64_t model = 0;
  if (const auto* levels = std::get_if<Levels>(&def.shape)) model = shared(*levels, kLevelSet, writeLevels);
  if (const auto* mesh = std::get_if<Triangles>(&def.shape)) {
    model = shared(*mesh, kTriangleMesh, writeMesh<TriangleMesh>);
  }
  if (const auto* field = std::get_if<Heights>(&def.shape))
    model = shared(*field, kHeightField, writeHeights);
  std::uint64_t mesh = 0;
  if (def.mesh) mesh = 1 + shared(def.mesh, kSurfaceMesh, writeMesh<SurfaceMesh>);

  out_.byte(kBody);
  out_.number(static_cast<std::uint32_t>(body));
  out_.text(def.name);
  out_.byte(static_cast<std::uint8_t>(def.motion));
  out_.fixed(def.mass);
  out_.number(mesh);
  std::visit(
      Overloaded{[&](const Plane& plane) {
                   out_.byte(kPlane);
                   out_.fixed(plane.normal);
                   out_.fixed(plane.offset);
                 },
                 [&](const Compound& compound) {
                   out_.byte(kCompound);
                   writeParts(compound.parts, out_);
                 },
                 [&](const Levels&) { out_.byte(kModel); }, [&](const Triangles&) { out_.byte(kModel); },
                 [&](const Heights&) { out_.byte(kModel); },
                 [&](const auto& convex) { writeConvex(convex, out_); }},
      def.shape);
  if (def.shape.index() >= Shape(Triangles{}).index()) out_.number(model);
  ++bodies_;
}

std::string BodyEncoder::take() {
  const std::array<std::string_view, 1> streams{out_.view()};
  std::string packed = packStreams(streams);
  out_.clear();
  bodies_ = 0;
  return packed;
}

template <class T>
std::shared_ptr<const T> BodyDecoder::model(std::uint64_t number) const {
  const auto* found = number < models_.size()
                          ? std::get_if<std::shared_ptr<const T>>(&models_[static_cast<std::size_t>(number)])
                          : nullptr;
  return found == nullptr ? nullptr : *found;
}

std::optional<Shape> BodyDecoder::readShape(ByteReader& in) const {
  const std::uint8_t kind = in.byte();
  if (kind == kPlane) {
    Plane plane;
    plane.normal = in.fixed<Vec3>();
    plane.offset = in.fixed<float>();
    return arePlausible({plane.normal, Vec3(plane.offset)}) ? std::optional<Shape>(plane) : std::nullopt;
  }
  if (kind == kCompound) {
    Compound compound{readParts(in)};
    return arePlausible(compound.parts) ? std::optional<Shape>(std::move(compound)) : std::nullopt;
  }
  if (kind == kModel) {
    const std::uint64_t number = in.number();
    if (auto levels = model<LevelSet>(number)) return levels;
    if (auto mesh = model<TriangleMesh>(number)) return mesh;
    if (auto field = model<HeightField>(number)) return field;
    return std::nullopt;
  }
  ConvexShape convex = readConvex(in, kind);
  return isPlausible(convex) ? std::optional(anyShape(std::move(convex))) : std::nullopt;
}

std::optional<NamedBody> BodyDecoder::readBody(ByteReader& in) const {
  NamedBody body;
  body.first = BodyId{static_cast<std::uint32_t>(in.number())};
  BodyDef& def = body.second;
  def.name = in.text();
  const std::uint8_t motion = in.byte();
  def.motion = static_cast<Motion>(motion);
  def.mass = in.fixed<float>();
  const std::uint64_t mesh = in.number();
  auto shape = readShape(in);
  if (mesh > 0) def.mesh = model<SurfaceMesh>(mesh - 1);
  if (in.failed() || !shape || motion > static_cast<std::uint8_t>(Motion::kDynamic) ||
      (mesh > 0 && !def.mesh)) {
    return std::nullopt;
  }
  def.shape = std::move(*shape);
  return body;
}

std::optional<BodyDecoder::Model> BodyDecoder::readModel(ByteReader& in) {
  const auto some = [](auto model) { return model ? std::optional<Model>(std::move(model)) : std::nullopt; };
  const auto plausible = [&](auto mesh) {
    return some(mesh && arePlausible(mesh->vertices) ? std::move(mesh) : nullptr);
  };
  switch (in.byte()) {
    case kLevelSet:
      return some(readLevels(in));
    case kTriangleMesh:
      return plausible(readMesh<TriangleMesh>(in));
    case kHeightField:
      return some(readHeights(in));
    case kSurfaceMesh:
      return plausible(readMesh<SurfaceMesh>(in));
    default:
      return std::nullopt;
  }
}

std::optional<std::vector<NamedBody>> BodyDecoder::read(std::string_view bytes) {
  const auto streams = unpackStreams(bytes, 1, kMostBlockBytes);
  if (!streams) return std::nullopt;
  std::vector<NamedBody> bodies;
  for (ByteReader in(streams->front()); in.left() > 0;) {
    ByteReader ahead = in;
    if (ahead.byte() == kBody) {
      in.byte();
      auto body = readBody(in);
      if (!body) return std::nullopt;
      bodies.push_back(std::move(*body));
    } else {
      auto model = readModel(in);
      if (!model || in.failed()) return std::nullopt;
      models_.push_back(std::move(*model));
    }
  }
  return bodies;
}

}  // namespace scatter::recording
