#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/camera_pointer.h"
#include "viewer/layout.h"
#include "viewer/level_looks.h"
#include "viewer/levels_viewer.h"
#include "viewer/window_loop.h"

namespace scatter::viewer {

/// The window of a model's levels: a column for each, with its parts above and the gap below.
class LevelsWindow final : public WindowLoop {
 public:
  [[nodiscard]] static Result<std::unique_ptr<LevelsWindow>> create(Renderer& renderer,
                                                                    const LevelsViewerDef& def);

  [[nodiscard]] Result<LevelsViewerReport> run();

 private:
  /// One picture of a level.
  struct Cell {
    std::size_t level = 0;  ///< In LevelLooks::levels().
    bool isGap = false;     ///< Else its parts.
    Area area{};
  };

  LevelsWindow(Renderer& renderer, const LevelsViewerDef& def);

  void addLevels();
  void addLooks();
  void addCamera();
  [[nodiscard]] Result<void> show(std::size_t model);
  void showOrClose(std::size_t model);

  /// It alone, or all; does nothing if the model has no such level.
  void showLevel(std::optional<std::size_t> level);

  [[nodiscard]] Result<void> perform(const ScriptAction& action) override;
  void take(const InputEvent& event) override { pointer_.take(event, renderer_.size().y); }
  void step() override;
  [[nodiscard]] Picture picture() override;
  void showPanels() override;

  void frame();
  [[nodiscard]] Layout layout() const;
  [[nodiscard]] std::vector<Cell> cells() const;
  [[nodiscard]] float aspect() const;
  [[nodiscard]] View view(const Cell& cell) const;
  void addParts(const LevelLook& look, View& view) const;
  void addGaps(const LevelLook& look, View& view) const;

  void showCaption(const Cell& cell) const;
  void showScale(const Cell& cell, float scale) const;
  [[nodiscard]] const ShownModel& model() const { return def_.models[model_]; }

  const LevelsViewerDef& def_;
  CameraPointer pointer_{camera_};
  OpenPanels open_{.lab = false, .numbers = false};

  std::size_t model_ = 0;
  std::vector<std::optional<LevelLooks>> looks_;  ///< Of the models that have been shown.
  std::optional<std::size_t> only_;               ///< The one level that is shown, or all.
  float apart_ = 0.6F;                            ///< How far parts are pulled apart, by their places.
  float framedApart_ = apart_;                    ///< For which the camera is far enough away.
  bool turning_ = true;
  bool oneScale_ = false;
  bool outlines_ = true;
};

}  // namespace scatter::viewer
