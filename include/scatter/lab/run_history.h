#pragma once

#include <scatter/recording/recorded_frame.h>
#include <scatter/world/world.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace scatter {

struct HistoryDef {
  /// Of memory that the frames may take. A frame takes 29 bytes for each body, 12 for each level event and 9
  /// for each pair, and about 200: of 300 bodies, 256 MiB hold 30 000 frames, which is 8 minutes, and half of
  /// that if each body is in contact with 7 others and pairs are kept.
  std::size_t bytes = std::size_t{256} << 20U;
  bool pairLevels = false;  ///< Whether record() keeps the pairs that it is given.
};

/// What the loop keeps of a run, so that it can be looked at again: where every body was, its level, whether
/// it slept, and what happened to levels, exactly, frame after frame. When it is full, the oldest frames go.
class RunHistory {
 public:
  explicit RunHistory(const HistoryDef& def = {});
  RunHistory(const RunHistory&) = delete;
  RunHistory& operator=(const RunHistory&) = delete;
  ~RunHistory();

  /// Keeps the world as it is after its last step. Each call follows one step after the call before it; the
  /// first one after clear() may come at any frame. The newest frame is kept even if it alone is too large.
  void record(const World& world, std::span<const PairLevel> pairs = {});
  void clear();

  [[nodiscard]] bool empty() const { return frames_.empty(); }
  [[nodiscard]] std::size_t size() const { return frames_.size(); }  ///< Frames.
  [[nodiscard]] std::uint64_t oldest() const;                        ///< World::frame(); not if empty.
  [[nodiscard]] std::uint64_t newest() const;
  [[nodiscard]] bool has(std::uint64_t frame) const;
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] const HistoryDef& def() const { return def_; }

  /// Changes the bound; the oldest frames go if there are too many now.
  void setBytes(std::size_t bytes);

  class Frame;
  /// From oldest() to newest().
  [[nodiscard]] Frame frame(std::uint64_t number) const;

  /// What a body that any of the frames names was made from, also if it has gone since; else null.
  [[nodiscard]] const BodyDef* def(BodyId body) const;

 private:
  using Roster = std::vector<BodyId>;

  struct StoredPose {
    float px, py, pz;
    float qw, qx, qy, qz;
  };

  struct StoredEvent {
    std::uint32_t body;
    std::uint32_t other;
    std::uint8_t from;
    std::uint8_t to;
    std::uint8_t policy;  // an index
    std::uint8_t kind : 4;
    std::uint8_t scope : 3;
    std::uint8_t onCredit : 1;
  };

  struct StoredFrame {
    std::uint64_t number = 0;
    std::shared_ptr<const Roster> bodies{};  // the frame before's while none comes or goes
    std::vector<StoredPose> poses{};
    std::vector<std::uint8_t> states{};
    std::vector<StoredEvent> events{};
    std::vector<unsigned char> pairs{};

    [[nodiscard]] std::size_t bytes() const;  // without the roster
  };

  [[nodiscard]] std::shared_ptr<const Roster> rosterOf(const World& world);
  static void addPoses(const Physics& physics, StoredFrame& frame);
  void addEvents(const Physics& physics, StoredFrame& frame);
  [[nodiscard]] std::uint8_t indexOf(std::string_view policy);
  void trim();
  void dropOldest();
  void forgetBodies(const Roster& gone, const Roster& left);

  HistoryDef def_;
  std::deque<StoredFrame> frames_;
  std::map<BodyId, BodyDef> defs_;
  std::vector<std::string_view> policies_;
  std::size_t bytes_ = 0;
};

/// One frame, to be read. Valid until the next record(), setBytes() or clear().
class RunHistory::Frame {
 public:
  Frame(const RunHistory& history, const StoredFrame& stored) : history_(&history), stored_(&stored) {}

  [[nodiscard]] std::uint64_t number() const;

  /// In the order in which they were added to the world; the index below counts in it.
  [[nodiscard]] std::span<const BodyId> bodies() const;
  [[nodiscard]] std::optional<std::size_t> find(BodyId body) const;
  [[nodiscard]] Transform pose(std::size_t index) const;
  [[nodiscard]] int level(std::size_t index) const;  ///< As LevelSwitching::level(); at most 127.
  [[nodiscard]] bool asleep(std::size_t index) const;

  [[nodiscard]] std::size_t eventCount() const;
  [[nodiscard]] LevelEvent event(std::size_t index) const;

  [[nodiscard]] std::size_t pairCount() const;
  [[nodiscard]] PairLevel pair(std::size_t index) const;

 private:
  const RunHistory* history_;
  const StoredFrame* stored_;
};

}  // namespace scatter
