#pragma once

#include <cstdint>

namespace scatter {

/// How the pair algorithm finds the child pairs (a part of one body and a part of the other) that are near.
enum class PairMidphase : std::uint8_t {
  kWorldBoxes,     ///< World bounds of all parts, every step.
  kPartBoxes,      ///< The parts' boxes in the bodies' frames, every step.
  kNeighbourList,  ///< The same with a skin, and only when the skin is used up.
};

/// What PairSteps::recycling is where it is asked for without a number, metres: a twentieth of the distance
/// at which Bullet drops contacts.
inline constexpr float kUsualRecycling = 0.001F;

/// The steps of the pair algorithm, to be left out one by one when measuring what each is worth. None but the
/// two last changes which child pairs are in contact.
struct PairSteps {
  PairMidphase midphase = PairMidphase::kNeighbourList;
  bool motionBound = true;    ///< Skip child pairs that cannot have met since their distance was measured.
  bool cachedAxis = true;     ///< Try the axis that separated a child pair before anything else.
  bool lazyManifolds = true;  ///< A child pair has a manifold only while it has contacts.
  bool ownGjk = true;         ///< Off: the engine's.
  bool warmSimplex = true;    ///< GJK starts from the simplex it ended with.

  /// Contacts of parts that have moved less than this along each other since they were found, metres, and
  /// have turned by less than a degree, are not found anew: they move along with the bodies, with the normals
  /// that they had. (Normals that turn with a body push it further to where it leans: stacks fall over.)
  /// Parts that are apart are looked at when they have moved so far, or a quarter of the distance at which
  /// contacts begin. 0: all contacts are found anew in every step.
  float recycling = 0.0F;

  /// A body whose middle would pass through a triangle of a mesh or a height field in this step gets contacts
  /// before it touches, so that it stops there; one whose middle has passed all the same is taken back to the
  /// side that it came from. Off: thin or fast bodies fall through, or are pushed through, as in Bullet. Not
  /// of links of multi-bodies that are faster than half their radius a step.
  bool passages = true;
};

/// The pair algorithm's work in one step. Exact counts: the same run after run.
struct PairWork {
  int pairs = 0;             ///< Broadphase pairs that came to the pair algorithm.
  int pairsSkipped = 0;      ///< Of those, left at once because neither body has moved enough.
  int rebuilds = 0;          ///< Neighbour lists made anew.
  int childPairs = 0;        ///< Pairs of parts looked at: not those that sleep for a while to come.
  int childPairsAsleep = 0;  ///< Of those, skipped by the motion bound.
  int recycled = 0;          ///< Of those, whose contacts moved along with the bodies.
  int boundsRejected = 0;    ///< Of those, by their world bounds.
  int axisRejected = 0;      ///< Of those, by the cached axis.
  int gjkRuns = 0;
  int gjkIterations = 0;  ///< Those of penetration depths included.
  int detectorRuns = 0;   ///< Child pairs that the engine's own detectors decided.
  int halfSpaceRuns = 0;  ///< Parts near a half-space, that its own algorithm decided.
  int pieces = 0;         ///< Of grounds (triangles, what of a large shape is near a body), looked up anew.
};

}  // namespace scatter
