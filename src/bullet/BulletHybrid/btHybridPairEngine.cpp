#include "btHybridPairEngine.h"

#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btCompoundCompoundCollisionAlgorithm.h>
#include <LinearMath/btAabbUtil2.h>

using scatter::ChildPair;

btHybridPairEngine::LevelScope::LevelScope(const btHybridPairCall& call, const btHybridPairBodies& bodies)
    : m_result(call.m_result),
      m_before{m_result->getBody0Wrap(), m_result->getBody1Wrap()},
      m_levels{{0, bodies.m_bodies[0]->getShape(), call.m_wraps[0]->getCollisionObject(),
                call.m_wraps[0]->getWorldTransform(), -1, -1},
               {0, bodies.m_bodies[1]->getShape(), call.m_wraps[1]->getCollisionObject(),
                call.m_wraps[1]->getWorldTransform(), -1, -1}}
{
	m_result->setBody0Wrap(&m_levels[0]);
	m_result->setBody1Wrap(&m_levels[1]);
}

btHybridPairEngine::LevelScope::~LevelScope()
{
	m_result->setBody0Wrap(m_before[0]);
	m_result->setBody1Wrap(m_before[1]);
}

void btHybridPairBodies::take(int level, btHybridObjects& objects)
{
	if (level == m_level)
		return;
	for (int i = 0; i < 2; i++)
		m_bodies[i] = objects.getBody(m_objects[i], m_objects[i]->getLevelIn(level));
	m_level = level;
}

const btCollisionObjectWrapper* btHybridPairEngine::getWrap(int body)
{
	if (!m_switches)
		return m_call.m_wraps[body];
	if (!m_scope)
		m_scope.emplace(m_call, m_bodies);
	return m_scope->getWrap(body);
}

const btCollisionShape* btHybridPairEngine::getShapeNow(int body) const
{
	return m_switches ? m_bodies.m_bodies[body]->getShapeNow() : m_call.m_wraps[body]->getCollisionShape();
}

const scatter::PartList::Part& btHybridPairEngine::getPart(int body, int part) const
{
	return m_bodies.m_bodies[body]->getBody().parts().part(part);
}

bool btHybridPairEngine::follow(scatter::pairs::PlacedBodies& bodies)
{
	for (int i = 0; i < 2; i++)
	{
		if (!m_objects.update(m_bodies.m_bodies[i], getShapeNow(i), m_call.m_wraps[i]->getWorldTransform()))
			return false;
		bodies.versions[i] = m_bodies.m_bodies[i]->getVersion();
	}
	bodies.a = &m_bodies.m_bodies[0]->getBody();
	bodies.b = &m_bodies.m_bodies[1]->getBody();
	return true;
}

bool btHybridPairEngine::place(int level, scatter::pairs::PlacedBodies& bodies)
{
	m_scope.reset();
	m_bodies.take(level, m_objects);
	if (!follow(bodies))
		return false;
	m_fallback.release(m_dispatcher);
	return true;
}

btHybridPartBody* btHybridPairEngine::getBody(int body, int level)
{
	btHybridLevelBodies* object = m_bodies.m_objects[body];
	return m_objects.getBody(object, object->getLevelIn(level));
}

std::optional<std::array<int, 2>> btHybridPairEngine::versionsAt(int level)
{
	std::array<int, 2> versions;
	for (int i = 0; i < 2; i++)
	{
		btHybridPartBody* body = getBody(i, level);
		if (!m_objects.refresh(body, m_call.m_wraps[i]->getWorldTransform()))
			return std::nullopt;
		versions[i] = body->getVersion();
	}
	return versions;
}

// Of a shape that is no list any more, the parts that it had.
const scatter::PartList& btHybridPairEngine::partsOf(int body, int level)
{
	btHybridPartBody* parts = getBody(body, level);
	static_cast<void>(m_objects.refresh(parts, m_call.m_wraps[body]->getWorldTransform()));
	return parts->getBody().parts();
}

scatter::Frame btHybridPairEngine::frameOf(int body) const
{
	return btHybridFrameOf(m_call.m_wraps[body]->getWorldTransform());
}

float btHybridPairEngine::pointDistance() const
{
	return gContactBreakingThreshold;
}

void btHybridPairEngine::fallBack()
{
	if (!m_fallback.get())
		m_fallback.set(
		    m_dispatcher->findAlgorithm(m_call.m_wraps[0], m_call.m_wraps[1], 0, BT_CONTACT_POINT_ALGORITHMS));
	m_fallback.get()->processCollision(m_call.m_wraps[0], m_call.m_wraps[1], m_call.m_info, m_call.m_result);
}

// A filter that a program may have set for the children of compounds.
bool btHybridPairEngine::letsThrough(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	const bool isChildA = bodyA.getChildIndex(child.a) >= 0;
	if (isChildA && bodyB.getChildIndex(child.b) >= 0)
		return !gCompoundCompoundChildShapePairCallback ||
		       gCompoundCompoundChildShapePairCallback(bodyA.getChildShape(child.a), bodyB.getChildShape(child.b));
	if (!gCompoundChildShapePairCallback)
		return true;
	// Bullet names the compound's child last.
	return isChildA ? gCompoundChildShapePairCallback(bodyB.getChildShape(child.b), bodyA.getChildShape(child.a))
	                : gCompoundChildShapePairCallback(bodyA.getChildShape(child.a), bodyB.getChildShape(child.b));
}

// The test of the leaves that Bullet's compound algorithms make before a child pair comes into contact.
bool btHybridPairEngine::mayBegin(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	if (!bodyA.hasLeaves() && !bodyB.hasLeaves())
		return true;
	const btTransform& frameA = m_call.m_wraps[0]->getWorldTransform();
	const btTransform& frameB = m_call.m_wraps[1]->getWorldTransform();
	btVector3 minA, maxA, minB, maxB;
	if (bodyA.hasLeaves())
	{
		bodyA.getLeaf(child.a, minA, maxA);
		bodyB.getLeafIn(child.b, frameA.inverseTimes(frameB), minB, maxB);
	}
	else
	{
		bodyA.getChildShape(child.a)->getAabb(frameB.inverseTimes(bodyA.getChildTransform(child.a, frameA)), minA,
		                                      maxA);
		bodyB.getLeaf(child.b, minB, maxB);
	}
	return TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// Of a compound with a tree and one without, in this order, Bullet does not look at the second one's children while the
// leaf of the first one's child does not reach the second: what contacts they have stay.
bool btHybridPairEngine::overlooks(const ChildPair& child) const
{
	const btHybridPartBody& bodyA = *m_bodies.m_bodies[0];
	const btHybridPartBody& bodyB = *m_bodies.m_bodies[1];
	const btCollisionShape* whole = bodyB.getShape();
	if (!bodyA.hasLeaves() || bodyB.hasLeaves() || !whole->isCompound() || mayBegin(child))
		return false;
	btVector3 minA, maxA, minB, maxB;
	const btTransform poseA = bodyA.getChildTransform(child.a, m_call.m_wraps[0]->getWorldTransform());
	bodyA.getChildShape(child.a)->getAabb(poseA, minA, maxA);
	whole->getAabb(m_call.m_wraps[1]->getWorldTransform(), minB, maxB);
	return TestAabbAgainstAabb2(minA, maxA, minB, maxB);
}

// The callback hears of new contacts too, as far as Bullet keeps them.
void btHybridPairEngine::looked(const ChildPair& child)
{
	if (gContactProcessedCallback && !areSpheres(child))
		static_cast<void>(outlasts(child.contact));
}
