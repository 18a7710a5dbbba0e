#include "btHybridNarrowphase.h"

#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>

#include "btHybridGroundEngine.h"
#include "btHybridPlanner.h"

btHybridNarrowphase::btHybridNarrowphase(bool switchesPairs)
    : m_users(1), m_depth(0), m_planner(switchesPairs ? new btHybridPlanner : 0)
{
}

btHybridNarrowphase::~btHybridNarrowphase()
{
	delete m_planner;
}

void btHybridNarrowphase::setSwitchesPairs(bool switchesPairs)
{
	btAssert(m_pairs.count() == 0 && (!m_planner || m_planner->countPairs() == 0));
	delete m_planner;
	m_planner = switchesPairs ? new btHybridPlanner : 0;
}

void btHybridNarrowphase::removeUser()
{
	if (--m_users == 0)
		delete this;
}

void btHybridNarrowphase::beginStep()
{
	m_objects.beginStep();
	m_lookahead.begin();
	m_work = btHybridCollisionCounts();
}

void btHybridNarrowphase::takeAhead(const scatter::pairs::StepAhead& step, int planIndex)
{
	m_work += step.work;
	if (planIndex >= 0)
		m_planner->take(planIndex, step.outcome);
}

void btHybridNarrowphase::takeDone(const btHybridStepMemory& memory)
{
	m_work += memory.m_work;
	if (m_planner)
		m_planner->take(memory.m_unplanned);
}

static void count(const scatter::pairs::PairTable& pairs, size_t plannedBytes, btHybridCollisionMemory& memory)
{
	// An algorithm's place in Bullet's pool.
	const size_t algorithmBytes = sizeof(btCompoundCompoundCollisionAlgorithm);
	memory.m_pairs += pairs.count();
	memory.m_pairBytes += size_t(pairs.count()) * (algorithmBytes + sizeof(scatter::pairs::Pair) + plannedBytes);
	for (int i = 0; i < pairs.count(); i++)
	{
		memory.m_childPairs += int(pairs[i].parts.children().size());
		memory.m_childPairBytes += pairs[i].parts.childBytes();
	}
}

static void count(const scatter::pairs::GroundTable& grounds, btHybridCollisionMemory& memory)
{
	const size_t eachBytes = sizeof(btCompoundCompoundCollisionAlgorithm) + sizeof(btHybridGroundBodies) +
	                         sizeof(scatter::pairs::GroundPair);
	memory.m_pairs += grounds.count();
	memory.m_pairBytes += size_t(grounds.count()) * eachBytes;
	for (int i = 0; i < grounds.count(); i++)
	{
		memory.m_pairBytes +=
		    grounds[i].region.bytes() + grounds[i].contacts.capacity() * sizeof(scatter::pairs::GroundContact);
		memory.m_childPairs += int(grounds[i].parts.children().size());
		memory.m_childPairBytes += grounds[i].parts.childBytes();
	}
}

btHybridCollisionMemory btHybridNarrowphase::getMemory() const
{
	btHybridCollisionMemory memory;
	count(m_pairs, btHybridPlanner::bytesOfPair(), memory);
	count(m_plainPairs, 0, memory);
	count(m_grounds, memory);
	m_objects.count(memory);
	memory.m_partBytes += m_wholeGrounds.getBytes();
	return memory;
}

scatter::pairs::StepScratch& btHybridNarrowphase::beginPair()
{
	if (m_depth == m_scratches.size())
		m_scratches.push_back(std::make_unique<scatter::pairs::StepScratch>());
	return *m_scratches[m_depth++];
}

std::vector<btHybridPartBounds>& btHybridNarrowphase::getBounds()
{
	while (m_depth >= m_bounds.size())
		m_bounds.push_back(std::make_unique<std::vector<btHybridPartBounds>>());
	return *m_bounds[m_depth];
}

int btHybridNarrowphase::countDeepPairs(btScalar depth)
{
	btAlignedObjectArray<btHybridLevelBodies*> objects;
	m_planner->findCredited(objects);
	scatter::PartQuery query;
	int count = 0;
	for (int i = 0; i < objects.size(); i += 2)
	{
		const scatter::PartList* parts[2];
		scatter::Frame frames[2];
		for (int k = 0; k < 2; k++)
		{
			parts[k] = &m_objects.getBody(objects[i + k], objects[i + k]->getNumLevels())->getBody().parts();
			frames[k] = btHybridFrameOf(objects[i + k]->getObject()->getWorldTransform());
		}
		count += query.isSeparated(*parts[0], *parts[1], scatter::relativeFrame(frames[0], frames[1]), -depth) ? 0 : 1;
	}
	return count;
}
