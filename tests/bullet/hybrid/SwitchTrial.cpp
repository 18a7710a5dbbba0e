#include "SwitchTrial.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "BulletTestWorld.h"
#include "PairTestWorld.h"
#include "RandomShapes.h"

namespace scatter::test {
namespace {

constexpr float kTimeStep = 1.0F / 60;
constexpr float kGravity = 10;
constexpr float kTolerance = 0.002F;  // metres, as in the library's own check
constexpr float kLeastPush = 0.001F;  // metres
constexpr int kWatched = 10;          // steps after a moment at rest

/// Notices what collision detection, and with it switching, does to poses and velocities.
class WatchedWorld : public btHybridDynamicsWorld {
 public:
  using btHybridDynamicsWorld::btHybridDynamicsWorld;

  void performDiscreteCollisionDetection() override {
    remember();
    btHybridDynamicsWorld::performDiscreteCollisionDetection();
    compare();
    if (afterDetection) afterDetection();
  }

  int moved = 0;
  int changedVelocity = 0;
  std::function<void()> afterDetection;  ///< Before contacts are solved.

 private:
  struct Motion {
    btTransform pose;
    btVector3 velocity;
    btVector3 spin;
  };

  [[nodiscard]] static Motion motionOf(const btRigidBody& body) {
    return {body.getWorldTransform(), body.getLinearVelocity(), body.getAngularVelocity()};
  }

  void remember() {
    before_.clear();
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i)
      before_.push_back(motionOf(*m_nonStaticRigidBodies[i]));
  }

  void compare() {
    moved = changedVelocity = 0;
    for (int i = 0; i < m_nonStaticRigidBodies.size(); ++i) {
      const Motion& before = before_[static_cast<std::size_t>(i)];
      const Motion now = motionOf(*m_nonStaticRigidBodies[i]);
      if (!(now.pose == before.pose)) ++moved;
      if (now.velocity != before.velocity || now.spin != before.spin) ++changedVelocity;
    }
  }

  std::vector<Motion> before_;
};

/// Box around parts of a compound, in its frame, with a little room.
btBoxShape* boxAround(RandomShapes& shapes, const btCompoundShape& parts, int first, int end,
                      btVector3& center) {
  btVector3 low(BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT);
  btVector3 high = -low;
  for (int i = first; i < end; ++i) {
    btVector3 partLow, partHigh;
    parts.getChildShape(i)->getAabb(parts.getChildTransform(i), partLow, partHigh);
    low.setMin(partLow);
    high.setMax(partHigh);
  }
  center = (low + high) / 2;
  return shapes.make<btBoxShape>((high - low) * 0.505F);
}

/// The level of boxes around groups of `perBox` parts of a finer one.
btCompoundShape* coarserLevel(RandomShapes& shapes, const btCompoundShape& finer, int perBox) {
  auto* level = shapes.make<btCompoundShape>();
  const int count = finer.getNumChildShapes();
  for (int first = 0; first < count; first += perBox) {
    btVector3 center;
    btBoxShape* box = boxAround(shapes, finer, first, std::min(first + perBox, count), center);
    level->addChildShape(btTransform(btQuaternion::getIdentity(), center), box);
  }
  return level;
}

void makeLevels(RandomShapes& shapes, float size, btHybridLevelSet& levels) {
  Random& random = shapes.random;
  const int parts = 2 + random.index(10);
  btCompoundShape* fine =
      random.chance(0.5F) ? shapes.compound(parts, size) : shapes.plainCompound(parts, size);
  std::vector<btCollisionShape*> coarser{fine};
  const btCompoundShape* last = fine;
  for (int perBox = 2; perBox < 5 && last->getNumChildShapes() > 1 && random.chance(0.8F); ++perBox) {
    btCompoundShape* next = coarserLevel(shapes, *last, perBox);
    coarser.push_back(next);
    last = next;
  }
  if (last->getNumChildShapes() > 1 || coarser.size() == 1) {
    coarser.push_back(coarserLevel(shapes, *last, last->getNumChildShapes()));
  }
  for (auto level = coarser.rbegin(); level != coarser.rend(); ++level)
    RandomShapes::addLevel(levels, *level);
}

/// What a world shows after a step.
struct Shown {
  double energy = 0;   ///< After the step, joules.
  double highest = 0;  ///< The most that there was then and, at rest, in the steps that follow.
  bool isCalm = false;
  bool isPlain = false;  ///< Nothing but switches can make the step differ from its copy's.
  bool hasSwitched = false;
  std::vector<float> places;
  std::vector<float> pushes;  ///< Of every two bodies: how deep their contacts press them apart, metres.

  [[nodiscard]] std::vector<double> flat() const {
    std::vector<double> all{energy, highest, isPlain ? 1.0 : 0.0, hasSwitched ? 1.0 : 0.0};
    all.insert(all.end(), places.begin(), places.end());
    all.insert(all.end(), pushes.begin(), pushes.end());
    return all;
  }

  void take(const std::vector<double>& flat, std::size_t bodies) {
    const auto middle = flat.begin() + 4 + static_cast<std::ptrdiff_t>(3 * bodies);
    energy = flat[0];
    highest = flat[1];
    isPlain = flat[2] > 0;
    hasSwitched = flat[3] > 0;
    places.assign(flat.begin() + 4, middle);
    pushes.assign(middle, flat.end());
  }
};

/// Runs a function in a copy of this process.
class ProcessCopy {
 public:
  explicit ProcessCopy(const std::function<std::vector<double>()>& work) {
    if (pipe(ends_) != 0) fail("pipe");
    std::fflush(nullptr);
    child_ = fork();
    if (child_ < 0) fail("fork");
    if (child_ > 0) {
      close(ends_[1]);
      return;
    }
    const std::vector<double> result = work();
    const char* next = reinterpret_cast<const char*>(result.data());
    for (std::size_t left = result.size() * sizeof(double); left > 0;) {
      const ssize_t written = write(ends_[1], next, left);
      if (written <= 0) _exit(1);
      next += written;
      left -= static_cast<std::size_t>(written);
    }
    _exit(0);
  }

  ProcessCopy(const ProcessCopy&) = delete;
  ProcessCopy& operator=(const ProcessCopy&) = delete;
  ~ProcessCopy() {
    if (child_ > 0) static_cast<void>(wait());
  }

  [[nodiscard]] std::vector<double> wait() {
    std::vector<double> result;
    double value = 0;
    auto* bytes = reinterpret_cast<char*>(&value);
    for (std::size_t have = 0;;) {
      const ssize_t got = read(ends_[0], bytes + have, sizeof value - have);
      if (got <= 0) break;
      have += static_cast<std::size_t>(got);
      if (have < sizeof value) continue;
      result.push_back(value);
      have = 0;
    }
    close(ends_[0]);
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("the copy of the process");
    return result;
  }

 private:
  [[noreturn]] static void fail(const char* what) {
    std::perror(what);
    std::abort();
  }

  int ends_[2] = {0, 0};
  pid_t child_ = 0;
};

/// A moment that is looked at once more, with nothing pressed apart by overlap that was there before it.
struct SecondLook {
  long moment = 0;             ///< 0: none.
  std::vector<bool> switched;  ///< Of every two bodies: they switched, and press as they do.
};

class TrialWorld : public BulletTestWorld<WatchedWorld> {
 public:
  explicit TrialWorld(const SwitchTrialDef& def, const SecondLook& look = {})
      : BulletTestWorld<WatchedWorld>(def.mode),
        def_(def),
        look_(look),
        shapes_(def.seed),
        random_(shapes_.random) {
    world.setGravity(btVector3(0, isStacked() ? -kGravity : 0, 0));
    world.setListener(&log);
    world.getSwitchingInfo().m_proximity = false;
    world.getSwitchingInfo().m_safetyConditions = def.safetyConditions;
    if (isByPairs()) {
      world.getPairSwitchingInfo().m_creditLevel = 1 + random_.index(2);
      world.getPairSwitchingInfo().m_credit = random_.chance(0.9F);
      world.getPairSwitchingInfo().m_safetyConditions = def.safetyConditions;
    }
    hasBudgets_ = random_.chance(0.3F);
    size_ = 0.1F * std::pow(100.0F, random_.unit());
    build();
  }

  ~TrialWorld() { world.setListener(nullptr); }

  SwitchTally run() {
    for (int i = 0; i < def_.moments; ++i) {
      meet();
      const int pause = isAtRest() ? random_.index(4) : 1 + random_.index(5);
      for (int k = 0; k < pause; ++k) plainStep();
    }
    return tally_;
  }

  /// In the last moment.
  [[nodiscard]] bool hasGained() const { return hasGained_; }

 private:
  [[nodiscard]] bool isByPairs() const { return def_.mode == BT_HYBRID_PAIR_SWITCHING; }
  [[nodiscard]] bool isStacked() const { return def_.situation == Situation::kStacked; }
  [[nodiscard]] bool isAtRest() const {
    return def_.situation != Situation::kMoving && def_.situation != Situation::kDeep;
  }

  void build() {
    levels_.resize(2);
    for (btHybridLevelSet& levels : levels_) makeLevels(shapes_, size_ * random_.between(0.6F, 1.4F), levels);
    if (isStacked()) add(0, shape<btBoxShape>(btVector3(20, 1, 20) * size_), btVector3(0, -size_, 0));
    const int count = 4 + random_.index(9);
    for (int i = 0; i < count; ++i) addHybrid(i);
    if (def_.situation != Situation::kDeep) removeOverlapping();
    settle();
  }

  void addHybrid(int i) {
    const btHybridLevelSet& levels = levels_[static_cast<std::size_t>(random_.index(2))];
    const btVector3 cell(static_cast<float>(i % 2), static_cast<float>(i / 2 % 2), static_cast<float>(i / 4));
    const float spread =
        def_.situation == Situation::kDeep ? random_.between(0.2F, 0.5F) : random_.between(0.7F, 1.0F);
    btVector3 place = cell * (spread * size_) + random_.inCube(0.1F * size_);
    if (isStacked())
      place = btVector3(place.x(), (0.8F + 1.1F * static_cast<float>(i)) * size_, place.z()) * 0.9F;
    const float mass = random_.between(0.5F, 50);
    auto definition = info(mass, levels.getLevelShape(levels.getNumLevels()), place);
    definition.m_startWorldTransform.setRotation(random_.rotation());
    auto body = std::make_unique<btHybridRigidBody>(definition, &levels);
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setFriction(random_.unit());
    world.addRigidBody(body.get());
    bodies.push_back(std::move(body));
  }

  void removeOverlapping() {
    for (bool found = true; found;) {
      world.performDiscreteCollisionDetection();
      found = false;
      for (int i = 0; i < dispatcher.getNumManifolds() && !found; ++i) {
        const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
        for (int k = 0; k < manifold.getNumContacts() && !found; ++k) {
          found = manifold.getContactPoint(k).getDistance() < -0.002F * size_;
        }
        const auto* one = const_cast<btCollisionObject*>(manifold.getBody1());
        if (one->isStaticObject()) one = manifold.getBody0();
        if (found) world.removeRigidBody(btRigidBody::upcast(const_cast<btCollisionObject*>(one)));
      }
    }
  }

  // Pulled together, or fallen; then at rest, but for those that are to move.
  void settle() {
    const bool isPulled = def_.situation == Situation::kTouching;
    const int steps = isStacked() ? 150 : isPulled ? 60 : 0;
    for (int i = 0; i < steps; ++i) {
      for (auto& body : bodies) {
        if (body->isStaticObject()) continue;
        body->setDamping(0.5F, 0.5F);
        if (isPulled)
          body->applyCentralForce((center() - body->getWorldTransform().getOrigin()) *
                                  (10 / body->getInvMass()));
      }
      step();
    }
    for (auto& body : bodies) {
      if (body->isStaticObject()) continue;
      body->setDamping(0, 0);
      if (isPulled) {
        body->setLinearVelocity(btVector3(0, 0, 0));
        body->setAngularVelocity(btVector3(0, 0, 0));
      }
      if (def_.situation != Situation::kMoving) continue;
      const btVector3 between = center() - body->getWorldTransform().getOrigin();
      body->setLinearVelocity(between * random_.between(0.2F, 10) + random_.inCube(size_));
      body->setAngularVelocity(random_.inCube(random_.chance(0.2F) ? 10.0F : 1.0F));
    }
    const int lead = def_.situation == Situation::kDeep ? random_.index(4) : 2;
    for (int i = 0; i < lead; ++i) step();
  }

  [[nodiscard]] btVector3 center() const { return btVector3(0.4F, 0.4F, 0.4F) * size_; }

  /// Kinetic and potential, joules.
  [[nodiscard]] double energy() const {
    double sum = 0;
    for (const auto& body : bodies) {
      if (body->isStaticObject() || body->getWorldArrayIndex() < 0) continue;
      const btVector3 spin = body->getAngularVelocity() * body->getWorldTransform().getBasis();
      const btVector3 inverse = body->getInvInertiaDiagLocal();
      sum += 0.5 * static_cast<double>(body->getLinearVelocity().length2() / body->getInvMass());
      for (int axis = 0; axis < 3; ++axis)
        sum += 0.5 * static_cast<double>(spin[axis] * spin[axis] / inverse[axis]);
      if (isStacked()) {
        sum += static_cast<double>(kGravity * body->getWorldTransform().getOrigin().y() / body->getInvMass());
      }
    }
    return sum;
  }

  /// The speed of the fastest point of a body, metres per second.
  [[nodiscard]] float fastest() const {
    float most = 0;
    for (const auto& body : bodies) {
      most = std::max(most, body->getLinearVelocity().length() + size_ * body->getAngularVelocity().length());
    }
    return most;
  }

  [[nodiscard]] std::size_t indexOf(const btCollisionObject* object) const {
    std::size_t index = 0;
    while (bodies[index].get() != object) ++index;
    return index;
  }

  [[nodiscard]] std::size_t pairOf(const btCollisionObject* a, const btCollisionObject* b) const {
    const std::size_t i = indexOf(a);
    const std::size_t k = indexOf(b);
    return std::min(i, k) * bodies.size() + std::max(i, k);
  }

  static bool presses(const btManifoldPoint& point) {
    return (point.m_contactPointFlags & BT_CONTACT_FLAG_HAS_CONTACT_ERP) == 0 || point.m_contactERP > 0;
  }

  [[nodiscard]] Shown show() {
    Shown shown{energy(),
                0.0,
                false,
                isPlain(),
                switchesOfStep() > 0,
                {},
                std::vector<float>(bodies.size() * bodies.size(), 0.0F)};
    for (const auto& body : bodies) {
      for (int axis = 0; axis < 3; ++axis)
        shown.places.push_back(body->getWorldTransform().getOrigin()[axis]);
    }
    forEachPoint([&shown](std::size_t pair, const btManifoldPoint& point) {
      if (presses(point)) shown.pushes[pair] = std::max(shown.pushes[pair], -point.getDistance());
    });
    return shown;
  }

  template <class Use>
  void forEachPoint(Use&& use) {
    for (int i = 0; i < dispatcher.getNumManifolds(); ++i) {
      btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(i);
      const std::size_t pair = pairOf(manifold.getBody0(), manifold.getBody1());
      for (int k = 0; k < manifold.getNumContacts(); ++k) use(pair, manifold.getContactPoint(k));
    }
  }

  // From now on: overlap that pairs which do not switch have now is no error to be reduced.
  void easeOldOverlap(const std::vector<float>& old) {
    world.afterDetection = [this, old] {
      forEachPoint([&](std::size_t pair, btManifoldPoint& point) {
        if (look_.switched[pair] || !(point.getDistance() < 0)) return;
        point.setDistance(std::min(point.getDistance() + old[pair], 0.0F));
      });
    };
  }

  /// After a step of a situation at rest: what the energy does afterwards.
  void watch(Shown& shown) {
    shown.highest = shown.energy;
    for (int i = 0; isAtRest() && i < kWatched; ++i) {
      plainStep();
      shown.highest = std::max(shown.highest, energy());
    }
  }

  void plainStep() {
    step();
    tally_.unsafe += world.getPairStepInfo().unsafeSwitches;
  }

  void giveReasons() {
    const int kind = isByPairs() ? random_.index(hasBudgets_ ? 4 : 3) : 0;
    if (kind == 3) {
      world.setBudgetUnits(static_cast<double>(random_.between(2, 200)));
    } else if (kind == 2) {
      const char* const policies[] = {"speed", "proximity", "coarsest", "load", "group-density"};
      world.removeBudget();
      world.removePolicies();
      world.addPolicy(policies[random_.index(5)]);
    } else {
      const int level = random_.index(4);
      for (int i = 0; i < world.getNumHybrids(); ++i) {
        btHybridRigidBody* body = world.getHybrid(i);
        const int asked =
            level > 0 ? std::min(level, body->getFinestLevel()) : 1 + random_.index(body->getFinestLevel());
        if (random_.chance(0.8F)) world.requestLevel(body, asked);
      }
    }
  }

  void meet() {
    Shown before = show();
    before.isCalm = isAtRest() && !hasBudgets_ && fastest() < 0.05F * size_;
    log.events.clear();
    log.justSwitched.clear();
    hasGained_ = look_.moment > 0;
    if (look_.moment == tally_.moments + 1) easeOldOverlap(before.pushes);
    ProcessCopy copy([this] {
      plainStep();
      Shown shown = show();
      watch(shown);
      return shown.flat();
    });
    giveReasons();
    plainStep();
    const std::vector<btHybridPairEvent> events = log.events;
    const std::vector<btHybridRigidBody*> switched = log.justSwitched;
    tally_.moved += world.moved;
    tally_.changedVelocity += world.changedVelocity;
    Shown now = show();
    watch(now);
    Shown without;
    without.take(copy.wait(), bodies.size());
    // A copy that switches as well, for a reason given before, shows nothing.
    if (count(events, switched) > 0 && now.isPlain && without.isPlain && !without.hasSwitched)
      compare(before, now, without, events, switched);
  }

  long count(const std::vector<btHybridPairEvent>& events, const std::vector<btHybridRigidBody*>& switched) {
    const long before = tally_.switches;
    ++tally_.moments;
    for (const btHybridPairEvent& event : events) {
      if (event.m_kind != BT_HYBRID_PAIR_SWITCHED) continue;
      ++tally_.switches;
      tally_.coarser += event.m_toLevel < event.m_fromLevel ? 1 : 0;
      tally_.onCredit += event.m_onCredit ? 1 : 0;
    }
    if (!isByPairs()) tally_.switches += static_cast<long>(switched.size());
    return tally_.switches - before;
  }

  [[nodiscard]] long switchesOfStep() const {
    if (!isByPairs()) return static_cast<long>(log.justSwitched.size());
    const btHybridPairStepInfo info = world.getPairStepInfo();
    return info.switchesCoarser + info.switchesFiner;
  }

  // A short budget makes pairs keep their contacts of the step before, and puts off looks at the finest
  // shapes, which is made up for when it ends: neither is a switch.
  [[nodiscard]] bool isPlain() const {
    const btHybridPairStepInfo info = world.getPairStepInfo();
    return info.reusedPairs == 0 && (!hasBudgets_ || info.audits == 0);
  }

  void complain(const char* what, double by) {
    if (!tally_.complaint.empty()) return;
    char text[160];
    std::snprintf(text, sizeof text, "%s: %s, seed %llu, moment %ld, by %.3g (size %.2g m)",
                  nameOf(def_.situation), what, static_cast<unsigned long long>(def_.seed), tally_.moments,
                  by, static_cast<double>(size_));
    tally_.complaint = text;
  }

  void comparePush(std::size_t pair, const Shown& before, const Shown& now, const Shown& without) {
    const float by = now.pushes[pair] - std::max(before.pushes[pair], without.pushes[pair]);
    if (!(by > kTolerance)) return;
    ++tally_.deeper;
    complain("deeper", static_cast<double>(by));
  }

  void compare(const Shown& before, const Shown& now, const Shown& without,
               const std::vector<btHybridPairEvent>& events,
               const std::vector<btHybridRigidBody*>& switched) {
    for (const btHybridPairEvent& event : events) {
      if (event.m_kind == BT_HYBRID_PAIR_SWITCHED)
        comparePush(pairOf(event.m_objectA, event.m_objectB), before, now, without);
    }
    for (const btHybridRigidBody* body : switched) {
      for (std::size_t i = 0; !isByPairs() && i < bodies.size(); ++i) {
        if (bodies[i].get() != body) comparePush(pairOf(body, bodies[i].get()), before, now, without);
      }
    }
    comparePlaces(before, now, without);
    compareEnergy(before, now, without, events, switched);
  }

  void compareEnergy(const Shown& before, const Shown& now, const Shown& without,
                     const std::vector<btHybridPairEvent>& events,
                     const std::vector<btHybridRigidBody*>& switched) {
    if (isAtRest() ? !before.isCalm : isDriven(before) || isDriven(without)) return;
    const double most = std::max(before.energy, without.highest);
    const double gained = now.highest - most;
    hasGained_ = gained > noise(most);
    if (without.highest - before.energy > noise(before.energy)) {
      ++tally_.restless;
      return;
    }
    if (hasGained_ && look_.moment == 0 && !gainsAnyway(events, switched)) {
      ++tally_.released;
      return;
    }
    ++tally_.weighed;
    tally_.mostGained = std::max(tally_.mostGained, gained / noise(most));
    if (!hasGained_) return;
    ++tally_.gained;
    complain("energy gained, joules", gained);
  }

  // The trial up to this moment once more: trials are exact.
  [[nodiscard]] bool gainsAnyway(const std::vector<btHybridPairEvent>& events,
                                 const std::vector<btHybridRigidBody*>& switched) const {
    SecondLook look{tally_.moments, std::vector<bool>(bodies.size() * bodies.size())};
    for (const btHybridPairEvent& event : events) {
      if (event.m_kind == BT_HYBRID_PAIR_SWITCHED)
        look.switched[pairOf(event.m_objectA, event.m_objectB)] = true;
    }
    for (const btHybridRigidBody* body : switched) {
      for (const auto& other : bodies) look.switched[pairOf(body, other.get())] = true;
    }
    SwitchTrialDef def = def_;
    def.moments = static_cast<int>(tally_.moments);
    TrialWorld again(def, look);
    static_cast<void>(again.run());
    return again.hasGained();
  }

  // The solver's impulses are good to a ten-thousandth of what is at work, and a pile at rest trembles.
  [[nodiscard]] double noise(double energy) const {
    constexpr double kSpeed = 0.01;     // metres per second
    constexpr double kHeight = 0.0001;  // metres
    double mass = 0;
    for (const auto& body : bodies)
      mass += body->isStaticObject() ? 0.0 : 1 / static_cast<double>(body->getInvMass());
    const double lifted = isStacked() ? static_cast<double>(kGravity) * kHeight : 0.0;
    return 1e-4 * std::abs(energy) + mass * (0.5 * kSpeed * kSpeed + lifted);
  }

  static bool isDriven(const Shown& shown) {
    return *std::max_element(shown.pushes.begin(), shown.pushes.end()) > kTolerance;
  }

  void comparePlaces(const Shown& before, const Shown& now, const Shown& without) {
    if (!before.isCalm) return;
    const auto at = [](const std::vector<float>& places, std::size_t i) {
      return btVector3(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
    };
    float own = 0;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      own = std::max(own, static_cast<float>(at(without.places, i).distance(at(before.places, i))));
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const float by = at(now.places, i).distance(at(without.places, i)) - own;
      if (by > kLeastPush + (isStacked() ? kGravity * kTimeStep * kTimeStep : 0.0F)) {
        ++tally_.pushed;
        complain("pushed", static_cast<double>(by));
      }
    }
  }

  SwitchTrialDef def_;
  SecondLook look_;
  RandomShapes shapes_;
  Random& random_;
  float size_ = 1;
  bool hasBudgets_ = false;  ///< Now and then.
  bool hasGained_ = false;
  std::vector<btHybridLevelSet> levels_;
  PairLog log;
  SwitchTally tally_;
};

}  // namespace

const char* nameOf(Situation situation) {
  const char* const names[] = {"apart", "touching", "deep", "stacked", "moving"};
  return names[static_cast<int>(situation)];
}

SwitchTally& SwitchTally::operator+=(const SwitchTally& other) {
  moments += other.moments;
  switches += other.switches;
  coarser += other.coarser;
  onCredit += other.onCredit;
  unsafe += other.unsafe;
  deeper += other.deeper;
  moved += other.moved;
  changedVelocity += other.changedVelocity;
  pushed += other.pushed;
  gained += other.gained;
  mostGained = std::max(mostGained, other.mostGained);
  restless += other.restless;
  released += other.released;
  weighed += other.weighed;
  if (complaint.empty()) complaint = other.complaint;
  return *this;
}

SwitchTally runSwitchTrial(const SwitchTrialDef& def) {
  TrialWorld world(def);
  return world.run();
}

}  // namespace scatter::test
