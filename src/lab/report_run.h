#pragma once

#include <scatter/lab/run.h>
#include <scatter/world/world.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scatter::lab {

/// What a story needs to know of a body.
struct ReportBody {
  std::string name;
  std::vector<std::size_t> parts;  ///< Of each level, the coarsest first; one entry without levels.
};

[[nodiscard]] std::map<BodyId, ReportBody> reportBodies(const World& world);

/// A run of a report test, with what a story asks of it. Frames count from 1. The run must outlive it.
class ReportRun {
 public:
  ReportRun(const Run& run, std::map<BodyId, ReportBody> bodies) : run_(run), bodies_(std::move(bodies)) {}

  [[nodiscard]] const Run& run() const { return run_; }
  [[nodiscard]] const std::map<BodyId, ReportBody>& bodies() const { return bodies_; }
  [[nodiscard]] const ReportBody& body(BodyId id) const { return bodies_.at(id); }
  [[nodiscard]] std::uint64_t frames() const { return run_.table.frames(); }

  /// The value of a column in a frame.
  [[nodiscard]] double at(std::string_view column, std::uint64_t frame) const;

  /// The first frame from `from` on in which the column holds, or holds not, more than zero.
  [[nodiscard]] std::optional<std::uint64_t> firstWith(std::string_view column, std::uint64_t from) const;
  [[nodiscard]] std::optional<std::uint64_t> firstWithout(std::string_view column, std::uint64_t from) const;

  /// The first frame with the column's highest value in these frames, both included.
  [[nodiscard]] std::uint64_t peakFrame(std::string_view column, std::uint64_t first,
                                        std::uint64_t last) const;

  /// Events of a kind in these frames, both included.
  [[nodiscard]] std::vector<FrameEvent> events(LevelEventKind kind, std::uint64_t first,
                                               std::uint64_t last) const;
  [[nodiscard]] std::vector<FrameEvent> events(LevelEventKind kind) const {
    return events(kind, 1, frames());
  }

  /// The parts of a body's level after the events of a frame.
  [[nodiscard]] std::size_t partsOf(BodyId id, std::uint64_t frame) const;

  /// The level after the last event.
  [[nodiscard]] int lastLevelOf(BodyId id) const { return levelOf(id, frames()); }

  /// Pairs of parts of different bodies, at the levels that they have after the events of a frame.
  [[nodiscard]] std::size_t partPairs(std::uint64_t frame) const;

  /// Whether the world was told in a frame that the load is fine.
  [[nodiscard]] bool wasLoadFine(std::uint64_t frame) const;

 private:
  [[nodiscard]] int levelOf(BodyId id, std::uint64_t frame) const;
  [[nodiscard]] std::optional<std::uint64_t> first(std::string_view column, std::uint64_t from,
                                                   bool positive) const;

  const Run& run_;
  std::map<BodyId, ReportBody> bodies_;
};

}  // namespace scatter::lab
