#pragma once

#include <scatter/io/physics_document.h>
#include <scatter/result.h>
#include <scatter/world/body.h>

#include <set>
#include <string>
#include <vector>

namespace scatter {

/// What a world leaves out of a document, a line each, without repetitions.
class DocumentWarnings {
 public:
  /// `file` is what the lines begin with.
  explicit DocumentWarnings(std::string file) : file_(std::move(file)) {}

  void add(const std::string& what);
  [[nodiscard]] const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::string file_;
  std::set<std::string> known_;
  std::vector<std::string> lines_;
};

/// The bodies of a document as a world takes them. A static body whose shapes a world keeps apart becomes
/// several.
struct DocumentBodies {
  std::vector<BodyDef> defs;
  std::vector<std::size_t> first;  ///< In `defs`, of each of the document's bodies.
};

/// Fails on a body of which nothing can be made; the message names it.
[[nodiscard]] Result<DocumentBodies> makeDocumentBodies(const PhysicsDocument& document,
                                                        DocumentWarnings& warnings);

}  // namespace scatter
