#include <scatter/recording/difference.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace scatter {

namespace {

constexpr std::array<const char*, kStateQuantityCount> kQuantities{"position", "orientation",
                                                                   "linear velocity", "angular velocity"};

// As far as an orientation is from what is stored of it, twice.
constexpr float kLeastTurn = 5e-4F;

bool isSame(const LevelEvent& a, const LevelEvent& b) {
  return a.kind == b.kind && a.scope == b.scope && a.body == b.body && a.from == b.from && a.to == b.to &&
         a.other == b.other && a.onCredit == b.onCredit && a.policy == b.policy;
}

float angleBetween(const Quat& a, const Quat& b) {
  const Quat turn = glm::conjugate(a) * b;
  return 2.0F * std::asin(std::min(1.0F, glm::length(Vec3(turn.x, turn.y, turn.z))));
}

/// Two frames with one number.
class FramePair {
 public:
  FramePair(const Recording& recordingA, const Recording& recordingB, const RecordedFrame& a,
            const RecordedFrame& b)
      : recordingA_(recordingA), recordingB_(recordingB), a_(a), b_(b) {}

  [[nodiscard]] std::optional<RunDifference> difference() {
    for (std::size_t i = 0; i < b_.roster->size(); ++i) inB_.emplace((*b_.roster)[i], i);
    for (std::size_t i = 0; i < a_.roster->size(); ++i) compareBody(i);
    for (const auto& [body, index] : inB_) {
      found_.bodies.push_back({body, recordingB_.nameOf(body), {"presence"}});
    }
    compareEvents();
    findUnplaced();
    if (found_.bodies.empty() && found_.unplaced.empty()) return std::nullopt;
    found_.frame = a_.number;
    return std::move(found_);
  }

 private:
  void compareBody(std::size_t index) {
    const BodyId body = (*a_.roster)[index];
    BodyDifference found{body, recordingA_.nameOf(body), {}};
    const auto other = inB_.find(body);
    if (other == inB_.end()) {
      found.quantities.emplace_back("presence");
    } else {
      compare(a_.bodies[index], b_.bodies[other->second], found);
      inB_.erase(other);
    }
    if (!found.quantities.empty()) found_.bodies.push_back(std::move(found));
  }

  static void compare(const RecordedBody& a, const RecordedBody& b, BodyDifference& found) {
    // One orientation is not stored in one way: it depends on where blocks begin.
    const float turned = angleBetween(a.pose.rotation, b.pose.rotation);
    const std::array<bool, kStateQuantityCount> seen{a.pose.position != b.pose.position, turned > kLeastTurn};
    for (std::size_t i = 0; i < kStateQuantityCount; ++i) {
      if (seen[i] || a.checks[i] != b.checks[i]) found.quantities.emplace_back(kQuantities[i]);
    }
    if (a.level != b.level) found.quantities.emplace_back("level");
    if (a.asleep != b.asleep) found.quantities.emplace_back("sleep");
    found.metres = glm::distance(a.pose.position, b.pose.position);
    found.radians = turned > kLeastTurn ? turned : 0.0F;
  }

  void compareEvents() {
    const auto [a, b] =
        std::mismatch(a_.events.begin(), a_.events.end(), b_.events.begin(), b_.events.end(), isSame);
    if (a == a_.events.end() && b == b_.events.end()) return;
    const BodyId body = a != a_.events.end() ? a->body : b->body;
    const auto known = std::find_if(found_.bodies.begin(), found_.bodies.end(),
                                    [body](const BodyDifference& one) { return one.body == body; });
    if (known != found_.bodies.end()) {
      known->quantities.emplace_back("request");
    } else {
      found_.bodies.push_back({body, recordingA_.nameOf(body), {"request"}});
    }
  }

  // Where bodies come or go, all hashes are other ones.
  void findUnplaced() {
    if (*a_.roster != *b_.roster) return;
    for (std::size_t i = 0; i < kStateQuantityCount; ++i) {
      const auto isNamed = [i](const BodyDifference& one) {
        return std::find(one.quantities.begin(), one.quantities.end(), kQuantities[i]) !=
               one.quantities.end();
      };
      if (a_.hashes[i] != b_.hashes[i] && std::none_of(found_.bodies.begin(), found_.bodies.end(), isNamed)) {
        found_.unplaced.emplace_back(kQuantities[i]);
      }
    }
  }

  const Recording& recordingA_;
  const Recording& recordingB_;
  const RecordedFrame& a_;
  const RecordedFrame& b_;
  std::map<BodyId, std::size_t> inB_;
  RunDifference found_;
};

}  // namespace

Result<RunComparison> compareRecordings(const Recording& a, const Recording& b) {
  RunComparison compared{.first = std::max(a.first(), b.first()), .last = std::min(a.last(), b.last())};
  if (compared.first > compared.last) {
    return fail(a.file().string() + " and " + b.file().string() + " have no frame in common");
  }
  for (std::uint64_t number = compared.first; number <= compared.last; ++number) {
    const auto inA = a.frame(number);
    if (!inA) return tl::unexpected(inA.error());
    const auto inB = b.frame(number);
    if (!inB) return tl::unexpected(inB.error());
    compared.difference = FramePair(a, b, **inA, **inB).difference();
    if (compared.difference) {
      compared.last = number;
      break;
    }
  }
  return compared;
}

}  // namespace scatter
