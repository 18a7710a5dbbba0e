#include "viewer/pane.h"

#include <utility>

namespace scatter::viewer {

Result<std::unique_ptr<Pane>> Pane::create(const RunOptions& options, BodyLooks& looks) {
  ExperimentDef def;
  def.run = options;
  def.history.pairLevels = true;
  return Experiment::create(def).map([&](std::unique_ptr<Experiment> experiment) {
    return std::unique_ptr<Pane>(new Pane(std::move(experiment), looks));
  });
}

Result<void> Pane::open(const std::string& scene) {
  return experiment_->open(scene).map([this] {
    view_.forgetKinds();
    observed_.clear();
  });
}

void Pane::observe(const ObservationParts& parts) {
  if (!parts.bodies && !parts.pairs && !parts.contacts) {
    observed_.clear();
  } else {
    experiment_->world().physics().diagnostics().observe(parts, observed_);
  }
}

Moment Pane::moment(std::optional<std::uint64_t> frame, float fraction, std::optional<BodyId> picked) const {
  const RunHistory& history = experiment_->history();
  Moment moment;
  moment.history = &history;
  moment.picked = picked;
  if (frame && history.has(*frame)) {
    moment.frame = *frame;
    return moment;
  }
  moment.frame = history.newest();
  moment.fraction = fraction;
  moment.observed = &observed_;
  return moment;
}

std::optional<Vec3> Pane::positionOf(const Moment& moment) {
  if (!moment.picked) return std::nullopt;
  const RunHistory::Frame frame = moment.history->frame(moment.frame);
  const auto index = frame.find(*moment.picked);
  return index ? std::optional(frame.pose(*index).position) : std::nullopt;
}

void Pane::fill(const Moment& moment, const DebugViewSet& views, const Cutaway& cutaway, View& view) {
  view_.add(moment, views, cutaway, view);
  if (moment.observed != nullptr) addDebugLines(views, experiment_->world(), observed_, view);
}

}  // namespace scatter::viewer
