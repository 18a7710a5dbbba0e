#pragma once

#include <scatter/world/body.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "recording/bytes.h"

namespace scatter::recording {

using NamedBody = std::pair<BodyId, BodyDef>;

/// What bodies are made from, as bytes: what is needed to show them. What several share is written once.
class BodyEncoder {
 public:
  void add(BodyId body, const BodyDef& def);
  [[nodiscard]] bool empty() const { return bodies_ == 0; }

  /// All bodies since the last call, compressed.
  [[nodiscard]] std::string take();

 private:
  std::uint64_t writeModel(const void* key, const std::shared_ptr<const void>& owner,
                           const std::function<void(ByteWriter&)>& write);

  /// Keeps what the key points to, so that nothing else can get its address.
  struct Known {
    std::uint64_t number = 0;
    std::shared_ptr<const void> owner;
  };
  std::map<const void*, Known> known_;
  std::size_t bodies_ = 0;
  ByteWriter out_;
};

/// The other way. All that an encoder gave must be read, in that order.
class BodyDecoder {
 public:
  /// Nothing if the bytes are damaged, or a shape is none.
  [[nodiscard]] std::optional<std::vector<NamedBody>> read(std::string_view bytes);

 private:
  using Model = std::variant<std::shared_ptr<const LevelSet>, std::shared_ptr<const TriangleMesh>,
                             std::shared_ptr<const HeightField>, std::shared_ptr<const SurfaceMesh>>;

  [[nodiscard]] std::optional<Shape> readShape(ByteReader& in) const;
  [[nodiscard]] std::optional<Model> readModel(ByteReader& in);
  [[nodiscard]] std::optional<NamedBody> readBody(ByteReader& in) const;
  template <class T>
  [[nodiscard]] std::shared_ptr<const T> model(std::uint64_t number) const;

  std::vector<Model> models_;
};

}  // namespace scatter::recording
