#include "lab/page/contact_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace scatter::lab {

namespace {

constexpr float kTouchingMetres = 0.01F;  // metres
constexpr float kMostPoints = 1.0e7F;

using Pair = std::pair<BodyId, BodyId>;

Pair pairOf(BodyId a, BodyId b) {
  return {std::min(a, b), std::max(a, b)};
}

std::map<Pair, const RecordedContact*> deepestOf(const RecordedFrame& frame) {
  std::map<Pair, const RecordedContact*> deepest;
  for (const RecordedContact& contact : frame.contacts) {
    if (!(contact.distance < kTouchingMetres)) continue;
    const RecordedContact*& known = deepest[pairOf(contact.a, contact.b)];
    if (known == nullptr || contact.distance < known->distance) known = &contact;
  }
  return deepest;
}

}  // namespace

void ContactBlock::addFrame(const RecordedFrame& frame) {
  std::map<Pair, std::uint8_t> levels;
  for (const PairLevel& pair : frame.pairs) levels.emplace(pairOf(pair.a, pair.b), pair.level);
  const auto contacts = deepestOf(frame);
  bytes_.number(contacts.size());
  std::array<std::int64_t, 3> last{};
  for (const auto& [pair, contact] : contacts) {
    const auto level = levels.find(pair);
    bytes_.byte(level != levels.end() ? level->second : 0);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const std::int64_t now =
          std::llround(std::clamp(contact->pointA[axis] / kContactQuantum, -kMostPoints, kMostPoints));
      bytes_.difference(now - last[i]);
      last[i] = now;
    }
  }
}

std::string ContactBlock::take() {
  return bytes_.take();
}

}  // namespace scatter::lab
