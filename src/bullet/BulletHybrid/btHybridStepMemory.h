#ifndef BT_HYBRID_STEP_MEMORY_H
#define BT_HYBRID_STEP_MEMORY_H

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>

#include <memory>
#include <mutex>
#include <vector>

#include "btHybridPartBounds.h"
#include "pairs/foresee.h"
#include "pairs/pair_plan.h"
#include "pairs/step_scratch.h"

struct btDispatcherInfo;

/// What steps of pairs that are made ahead share.
struct btHybridAhead
{
	scatter::pairs::BoundsLocks m_locks;
	std::mutex m_meshes;  ///< of who asks a ground for its pieces
	const btDispatcherInfo* m_info;
	bool m_mayStep;  ///< nobody listens to contacts
	bool m_mayAdd;   ///< nor to new ones, of objects that ask for it
};

/// Memory of one thread that finds out about pairs before their steps, or makes these.
struct btHybridStepMemory
{
	scatter::pairs::ForesightScratch m_foresight;
	scatter::pairs::StepScratch m_step;
	std::vector<btHybridPartBounds> m_bounds;

	/// Of pairs that are done with.
	scatter::PairWork m_work;
	scatter::pairs::UnplannedPairs m_unplanned;

	double m_milliseconds;  ///< that it has been at work in this step

	btHybridStepMemory() : m_milliseconds(0), m_used(0)
	{
	}

	/// A manifold without points that no dispatcher knows of, good until reset().
	btPersistentManifold* standIn(const btCollisionObject* a, const btCollisionObject* b, btScalar breakingThreshold);

	void reset()
	{
		m_foresight.used = m_foresight.stepsUsed = 0;
		m_used = 0;
		m_milliseconds = 0;
		m_work = scatter::PairWork();
		m_unplanned = scatter::pairs::UnplannedPairs();
	}

private:
	std::vector<std::unique_ptr<btPersistentManifold>> m_standIns;
	size_t m_used;

	btHybridStepMemory(const btHybridStepMemory&);
	btHybridStepMemory& operator=(const btHybridStepMemory&);
};

#endif  // BT_HYBRID_STEP_MEMORY_H
