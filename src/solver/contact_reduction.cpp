#include "solver/contact_reduction.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace scatter::solver {

namespace {

/// Cosine of 5°: normals of a flat face as detectors find them are nearer to each other than this, those of
/// neighbouring facets of a wheel are not.
constexpr float kAlike = 0.996F;

/// A contact that bore something counts as so much deeper, and as so much further away, than one that did
/// not; and one that is so much deeper than the one that stands for it takes its place. A millimetre is what
/// places of contacts tremble by.
constexpr float kLoyalDepth = 0.001F;
constexpr float kLoyalReach = 1.2F;

/// Squared, metres: nearer than this two contacts are one.
constexpr float kSame2 = 1e-8F;

bool bore(const ReducibleContact& contact) {
  return contact.normal.w > 0.0F;
}

}  // namespace

int ContactReduction::reduce(std::span<ReducibleContact> contacts, int most) {
  cluster(contacts);
  sortByCluster();
  int left = 0;
  for (std::size_t i = 1; i < firsts_.size(); ++i)
    left += choose(contacts, std::span(sorted_).subspan(firsts_[i - 1], firsts_[i] - firsts_[i - 1]), most);
  return left;
}

void ContactReduction::cluster(std::span<const ReducibleContact> contacts) {
  clusters_.clear();
  homes_.clear();
  firsts_.clear();
  for (const ReducibleContact& contact : contacts) {
    const std::size_t home = findCluster(contact.normal);
    if (home == firsts_.size()) addCluster(contact.normal);
    ++firsts_[home];
    homes_.push_back(home);
  }
}

// The first one that is alike; as many as there are, if none is.
std::size_t ContactReduction::findCluster(const Quad& normal) const {
  const LaneVector wanted{lanes(normal.x), lanes(normal.y), lanes(normal.z)};
  for (std::size_t i = 0; i < clusters_.size(); ++i) {
    const int lane = firstOf(dot(clusters_[i], wanted) >= lanes(kAlike));
    if (lane < kLanes) return i * kLanes + static_cast<std::size_t>(lane);
  }
  return firsts_.size();
}

// To a lane without a cluster, which is 0, nothing is alike.
void ContactReduction::addCluster(const Quad& normal) {
  const std::size_t lane = firsts_.size() % kLanes;
  if (lane == 0) clusters_.emplace_back();
  LaneVector& four = clusters_.back();
  four.x[lane] = normal.x;
  four.y[lane] = normal.y;
  four.z[lane] = normal.z;
  firsts_.push_back(0);
}

// From how many contacts each cluster has to where they are, those of a cluster in the order of their
// indices.
void ContactReduction::sortByCluster() {
  std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
  firsts_.push_back(homes_.size());
  sorted_.resize(homes_.size());
  for (std::size_t i = homes_.size(); i-- > 0;) sorted_[--firsts_[homes_[i]]] = static_cast<int>(i);
}

void ContactReduction::gather(std::span<const ReducibleContact> contacts, std::span<const int> members) {
  const auto exists = [&](std::size_t i) { return i < members.size(); };
  const auto at = [&](std::size_t i) -> const ReducibleContact& {
    return contacts[static_cast<std::size_t>(members[i])];
  };
  const auto place = [&](std::size_t i) { return exists(i) ? lanes(at(i).place) : Lanes{}; };
  const auto reach = [&](std::size_t i) { return exists(i) ? (bore(at(i)) ? kLoyalReach : 1.0F) : 0.0F; };
  const Lanes far = lanes(std::numeric_limits<float>::max());
  members_.clear();
  for (std::size_t i = 0; exists(i); i += kLanes) {
    const LaneQuad four = transposed(place(i), place(i + 1), place(i + 2), place(i + 3));
    const Lanes reaches{reach(i), reach(i + 1), reach(i + 2), reach(i + 3)};
    members_.push_back(Members{four.v, reaches, far, {}});
  }
}

// The one that is furthest from all that were chosen so far, `chosen` among them; -1 if all are near.
int ContactReduction::takeNext(int chosen) {
  const Members& home = members_[static_cast<std::size_t>(chosen / kLanes)];
  const int at = chosen % kLanes;
  const LaneVector place{lanes(home.place.x[at]), lanes(home.place.y[at]), lanes(home.place.z[at])};
  const LaneMask chosenLanes{chosen, chosen, chosen, chosen};
  Lanes most = lanes(kSame2);
  LaneMask furthest{-1, -1, -1, -1};
  LaneMask index{0, 1, 2, 3};
  for (Members& four : members_) {
    const LaneVector between = four.place - place;
    const Lanes from2 = dot(between, between);
    const LaneMask isNearer = from2 < four.distance2;
    four.distance2 = isNearer ? from2 : four.distance2;
    four.nearest = isNearer ? chosenLanes : four.nearest;
    const Lanes reach2 = four.distance2 * four.reach;
    const LaneMask isFurther = (reach2 > most) & (four.distance2 > lanes(kSame2));
    most = isFurther ? reach2 : most;
    furthest = isFurther ? index : furthest;
    index += kLanes;
  }
  int best = 0;
  for (int lane = 1; lane < kLanes; ++lane) {
    if (most[lane] > most[best]) best = lane;
  }
  return furthest[best];
}

int ContactReduction::choose(std::span<ReducibleContact> contacts, std::span<const int> members, int most) {
  const auto at = [&](int i) -> ReducibleContact& { return contacts[static_cast<std::size_t>(i)]; };
  const int count = static_cast<int>(members.size());
  if (count <= most) {
    for (const int i : members) at(i).kept = i;
    return count;
  }
  const auto depth = [&](int i) { return (bore(at(i)) ? kLoyalDepth : 0.0F) - at(i).place.w; };
  const auto deepest =
      std::max_element(members.begin(), members.end(), [&](int i, int k) { return depth(i) < depth(k); });
  gather(contacts, members);
  int next = static_cast<int>(deepest - members.begin());
  int chosen = 1;
  for (int further = takeNext(next); further >= 0 && chosen < most; further = takeNext(next), ++chosen)
    next = further;
  settle(contacts, members);
  return chosen;
}

// Those that were chosen stay, but for one that another of those that it stands for is much deeper than.
void ContactReduction::settle(std::span<ReducibleContact> contacts, std::span<const int> members) {
  const auto depth = [&](int member) {
    return -contacts[static_cast<std::size_t>(members[static_cast<std::size_t>(member)])].place.w;
  };
  const int count = static_cast<int>(members.size());
  stands_.assign(members.size(), kNone);
  for (int i = 0; i < count; ++i) {
    int& stands = stands_[static_cast<std::size_t>(nearest(i))];
    const int now = stands == kNone ? nearest(i) : stands;
    const float lead = now == nearest(i) ? kLoyalDepth : 0.0F;
    stands = depth(i) > depth(now) + lead ? i : now;
  }
  for (int i = 0; i < count; ++i) {
    const int kept = stands_[static_cast<std::size_t>(nearest(i))];
    contacts[static_cast<std::size_t>(members[static_cast<std::size_t>(i)])].kept =
        members[static_cast<std::size_t>(kept)];
  }
}

}  // namespace scatter::solver
