#pragma once

#include <scatter/lab/experiment.h>
#include <scatter/world/observation.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/debug_views.h"
#include "viewer/scene_view.h"

namespace scatter::viewer {

/// One of the worlds that a window shows.
class Pane {
 public:
  /// Fails as Experiment::create() does. The looks must outlive it.
  [[nodiscard]] static Result<std::unique_ptr<Pane>> create(const RunOptions& options, BodyLooks& looks);

  [[nodiscard]] const std::string& label() const { return experiment_->options().label; }
  [[nodiscard]] Experiment& experiment() { return *experiment_; }
  [[nodiscard]] const Experiment& experiment() const { return *experiment_; }

  /// Shows another scene, in a world of the same kind. Fails as Experiment::open() does; then nothing has
  /// changed. The looks must be cleared after.
  [[nodiscard]] Result<void> open(const std::string& scene);

  /// Looks at the physics as it is now, once for all views and panels of a frame.
  void observe(const ObservationParts& parts);
  [[nodiscard]] const Observation& observed() const { return observed_; }

  /// The frame to be shown: `frame`, or the newest if that is not kept any more.
  [[nodiscard]] Moment moment(std::optional<std::uint64_t> frame, float fraction,
                              std::optional<BodyId> picked) const;

  /// Of the picked body at that moment.
  [[nodiscard]] static std::optional<Vec3> positionOf(const Moment& moment);

  void fill(const Moment& moment, const DebugViewSet& views, const Cutaway& cutaway, View& view);
  [[nodiscard]] std::vector<Actor> actors(const Moment& moment) { return view_.actors(moment); }
  [[nodiscard]] std::vector<Obstacle> obstacles(const Moment& moment) { return view_.obstacles(moment); }

 private:
  Pane(std::unique_ptr<Experiment> experiment, BodyLooks& looks)
      : experiment_(std::move(experiment)), view_(looks) {}

  std::unique_ptr<Experiment> experiment_;
  SceneView view_;
  Observation observed_;
};

}  // namespace scatter::viewer
