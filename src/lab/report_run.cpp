#include "lab/report_run.h"

#include <scatter/levels/level_set.h>
#include <scatter/world/world_object.h>

#include <algorithm>
#include <memory>
#include <variant>

namespace scatter::lab {

std::map<BodyId, ReportBody> reportBodies(const World& world) {
  std::map<BodyId, ReportBody> bodies;
  for (const auto& object : world.objects()) {
    ReportBody body{.name = object->name(), .parts = {}};
    if (const auto* levels = std::get_if<std::shared_ptr<const LevelSet>>(&object->def().shape)) {
      for (int level = 1; level <= (*levels)->count(); ++level) {
        body.parts.push_back((*levels)->level(level).parts.size());
      }
    } else {
      body.parts.push_back(1);
    }
    bodies.emplace(object->body(), std::move(body));
  }
  return bodies;
}

double ReportRun::at(std::string_view column, std::uint64_t frame) const {
  return run_.table.values(column).at(frame - 1);
}

std::optional<std::uint64_t> ReportRun::first(std::string_view column, std::uint64_t from,
                                              bool positive) const {
  const auto& values = run_.table.values(column);
  for (std::uint64_t frame = from; frame <= values.size(); ++frame) {
    if ((values[frame - 1] > 0.0) == positive) {
      return frame;
    }
  }
  return std::nullopt;
}

std::optional<std::uint64_t> ReportRun::firstWith(std::string_view column, std::uint64_t from) const {
  return first(column, from, true);
}

std::optional<std::uint64_t> ReportRun::firstWithout(std::string_view column, std::uint64_t from) const {
  return first(column, from, false);
}

std::uint64_t ReportRun::peakFrame(std::string_view column, std::uint64_t first, std::uint64_t last) const {
  const auto& values = run_.table.values(column);
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(first - 1);
  const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min<std::uint64_t>(last, values.size()));
  return static_cast<std::uint64_t>(std::max_element(begin, end) - values.begin()) + 1;
}

std::vector<FrameEvent> ReportRun::events(LevelEventKind kind, std::uint64_t first,
                                          std::uint64_t last) const {
  std::vector<FrameEvent> found;
  for (const FrameEvent& event : run_.events) {
    if (event.event.kind == kind && event.frame >= first && event.frame <= last) {
      found.push_back(event);
    }
  }
  return found;
}

int ReportRun::levelOf(BodyId id, std::uint64_t frame) const {
  int level = static_cast<int>(body(id).parts.size());
  for (const FrameEvent& event : events(LevelEventKind::kSwitched, 1, frame)) {
    if (event.event.body == id) {
      level = event.event.to;
    }
  }
  return level;
}

std::size_t ReportRun::partsOf(BodyId id, std::uint64_t frame) const {
  return body(id).parts.at(static_cast<std::size_t>(levelOf(id, frame)) - 1);
}

std::size_t ReportRun::partPairs(std::uint64_t frame) const {
  std::size_t pairs = 0;
  std::size_t before = 0;
  for (const auto& [id, body] : bodies_) {
    const std::size_t parts = partsOf(id, frame);
    pairs += before * parts;
    before += parts;
  }
  return pairs;
}

bool ReportRun::wasLoadFine(std::uint64_t frame) const {
  const auto pairs = run_.options.physics.switching.loadFinePairs;
  return frame > 1 ? at("narrowphase_pairs", frame - 1) < pairs : pairs > 0;
}

}  // namespace scatter::lab
