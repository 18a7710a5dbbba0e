#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/gltf/colliders.h"

namespace scatter::io {

/// Makes document models of the bodies of a file; bodies that are alike share one.
class GltfModels {
 public:
  GltfModels(GltfFile& file, const GltfNodes& nodes, GltfMeshes& meshes,
             const std::optional<SceneNotes>& notes);

  /// Makes or finds the model of a body; nothing, with a warning, if it has no shapes that can be used.
  [[nodiscard]] std::optional<std::size_t> modelOf(const GltfBody& body);

  /// The body's notes, if it still is of the model they name.
  [[nodiscard]] const BodyNotes* notesOf(const GltfBody& body) const;

  /// By the index that modelOf gives; empty where nothing was made.
  [[nodiscard]] std::vector<std::optional<DocumentModel>>& models() { return models_; }

 private:
  [[nodiscard]] bool fits(const GltfBody& body, const ModelNotes& notes) const;
  [[nodiscard]] std::optional<DocumentModel> build(const GltfBody& body, const ModelNotes* notes);
  void takeNotes(const ModelNotes& notes, const std::vector<std::size_t>& used, DocumentModel& model) const;
  void takeValues(const GltfBody& body, const std::vector<std::size_t>& used, DocumentModel& model) const;
  void addLevels(const GltfBody& body, DocumentModel& model);

  GltfFile* file_;
  const GltfNodes* nodes_;
  GltfMeshes* meshes_;
  const std::optional<SceneNotes>* notes_;
  GltfColliders colliders_;
  std::vector<std::optional<DocumentModel>> models_;
  std::map<std::string, std::size_t> known_;  ///< By what a body is made of.
};

/// Kilograms: as given, or of the shapes' masses and densities, or 1.
[[nodiscard]] double documentMass(const DocumentModel& model);

}  // namespace scatter::io
