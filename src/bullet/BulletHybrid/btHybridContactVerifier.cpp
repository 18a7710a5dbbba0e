#include "btHybridContactVerifier.h"

#include <BulletCollision/BroadphaseCollision/btCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btConcaveShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <LinearMath/btAabbUtil2.h>

#include "btHybridGround.h"
#include "btHybridParts.h"
#include "btHybridProvenDistance.h"
#include "btHybridSilence.h"

namespace
{
// Points that Bullet was given before the step are told from those that it has found in it by their age.
const int c_givenAge = 1 << 20;

// What the tolerances at which both GJKs stop make of a threshold, and of a distance between cores.
const double c_ofThreshold = 1e-4;
const double c_ofCores = 1e-6;

enum Verdict
{
	DIFFERENT,
	DOUBTFUL,
	BULLET_ERRS
};

btScalar largestComponent(const btVector3& v)
{
	const btVector3 positive = v.absolute();
	return positive[positive.maxAxis()];
}

// False for anything that is not a number.
bool overlap(const btVector3& minA, const btVector3& maxA, const btVector3& minB, const btVector3& maxB, btScalar slack)
{
	for (int axis = 0; axis < 3; axis++)
		if (!(minA[axis] <= maxB[axis] + slack && minB[axis] <= maxA[axis] + slack))
			return false;
	return true;
}

/// A convex child at its world pose.
struct ComparedChild
{
	const btCollisionObject* m_object;
	const btConvexShape* m_shape;
	btTransform m_transform;
	btVector3 m_min;
	btVector3 m_max;
	btVector3 m_leafMin;  ///< in its compound's tree, if it has one
	btVector3 m_leafMax;
	bool m_hasLeaf;
	btScalar m_rounding;  ///< metres: what single precision may lose on the way to a distance or a bound

	ComparedChild(const btCollisionObject* object, int index)
	    : m_object(object), m_transform(object->getWorldTransform()), m_hasLeaf(false)
	{
		const btCollisionShape* shape = object->getCollisionShape();
		if (index >= 0)
		{
			const btCompoundShape* compound = static_cast<const btCompoundShape*>(shape);
			m_transform = m_transform * compound->getChildTransform(index);
			shape = compound->getChildShape(index);
			m_hasLeaf = compound->getDynamicAabbTree() != 0;
			shape->getAabb(compound->getChildTransform(index), m_leafMin, m_leafMax);
		}
		m_shape = static_cast<const btConvexShape*>(shape);
		shape->getAabb(m_transform, m_min, m_max);
		const btVector3& origin = object->getWorldTransform().getOrigin();
		const btScalar reach = largestComponent(m_min) + largestComponent(m_max) + largestComponent(origin) +
		                       largestComponent(m_transform.getOrigin() - origin);
		m_rounding = btScalar(4) * SIMD_EPSILON * reach;
	}
};

bool areBoth(int type, const btConvexShape* a, const btConvexShape* b)
{
	return a->getShapeType() == type && b->getShapeType() == type;
}

const btCollisionShape* childShape(const btCollisionObject* object, int index)
{
	const btCollisionShape* shape = object->getCollisionShape();
	return index < 0 ? shape : static_cast<const btCompoundShape*>(shape)->getChildShape(index);
}

bool areSpheres(const btHybridChildKey& key)
{
	return childShape(key.m_bodies[0], key.m_children[0])->getShapeType() == SPHERE_SHAPE_PROXYTYPE &&
	       childShape(key.m_bodies[1], key.m_children[1])->getShapeType() == SPHERE_SHAPE_PROXYTYPE;
}

// The test of the leaves in Bullet's compound algorithms.
bool leavesOverlap(const ComparedChild& a, const ComparedChild& b, btScalar slack)
{
	if (!a.m_hasLeaf && !b.m_hasLeaf)
		return true;
	if (!a.m_hasLeaf)
		return leavesOverlap(b, a, slack);
	const btTransform bInA = a.m_object->getWorldTransform().inverse() * b.m_object->getWorldTransform();
	btVector3 lower, upper;
	if (b.m_hasLeaf)
		btTransformAabb(b.m_leafMin, b.m_leafMax, btScalar(0), bInA, lower, upper);
	else
		b.m_object->getCollisionShape()->getAabb(bInA, lower, upper);
	return overlap(a.m_leafMin, a.m_leafMax, lower, upper, slack);
}

bool hasNewPoint(const btPersistentManifold* bullets)
{
	for (int i = 0; bullets && i < bullets->getNumContacts(); i++)
		if (bullets->getContactPoint(i).getLifeTime() < c_givenAge)
			return true;
	return false;
}

// Whether rounding may decide if the midphase lets a child pair through.
bool isMidphaseDoubtful(const ComparedChild& a, const ComparedChild& b)
{
	const btScalar slack = a.m_rounding + b.m_rounding;
	if (overlap(a.m_min, a.m_max, b.m_min, b.m_max, slack) != overlap(a.m_min, a.m_max, b.m_min, b.m_max, -slack))
		return true;
	return leavesOverlap(a, b, slack) != leavesOverlap(a, b, -slack);
}

Verdict judgeDistance(const ComparedChild& a, const ComparedChild& b, btScalar threshold, bool isMissed,
                      const btPersistentManifold* bullets)
{
	const btHybridProvenDistance distance(a.m_shape, a.m_transform, b.m_shape, b.m_transform);
	const double slack =
	    c_ofThreshold * double(threshold) + c_ofCores * distance.m_cores + double(a.m_rounding) + double(b.m_rounding);
	if (distance.m_atMost - distance.m_atLeast > slack)
		return DIFFERENT;
	const bool isNear = distance.m_atMost < double(threshold) - slack;
	const bool isFar = distance.m_atLeast > double(threshold) + slack;
	if (!isNear && !isFar)
		return DOUBTFUL;
	// One finds what is there, or the other what is not.
	return (isMissed ? isFar && hasNewPoint(bullets) : isNear) ? BULLET_ERRS : DIFFERENT;
}

/// The triangles of a mesh that Bullet's midphase lets a part meet: surely, or if rounding wants it.
struct NearTriangles : public btTriangleCallback
{
	const ComparedChild& m_part;
	btTransform m_mesh;
	btScalar m_margin;
	btVector3 m_min;  ///< of the part, in the mesh's frame, widened as Bullet does
	btVector3 m_max;
	double m_slack;
	double m_sure;   ///< the least distance that is proven to be no more, of those that are sure
	double m_maybe;  ///< the least distance that is proven to be no less, of all

	NearTriangles(const ComparedChild& part, const btTransform& mesh, btScalar margin)
	    : m_part(part), m_mesh(mesh), m_margin(margin), m_slack(0), m_sure(1e30), m_maybe(1e30)
	{
		part.m_shape->getAabb(mesh.inverse() * part.m_transform, m_min, m_max);
		m_min -= btVector3(margin, margin, margin);
		m_max += btVector3(margin, margin, margin);
	}
	virtual void processTriangle(btVector3* corners, int, int)
	{
		const btVector3 rounding(m_part.m_rounding, m_part.m_rounding, m_part.m_rounding);
		if (!TestTriangleAgainstAabb2(corners, m_min - rounding, m_max + rounding))
			return;
		btTriangleShape triangle(corners[0], corners[1], corners[2]);
		triangle.setMargin(m_margin);
		const btHybridProvenDistance distance(m_part.m_shape, m_part.m_transform, &triangle, m_mesh);
		m_slack = btMax(m_slack, c_ofCores * distance.m_cores);
		m_maybe = btMin(m_maybe, distance.m_atLeast);
		if (TestTriangleAgainstAabb2(corners, m_min + rounding, m_max - rounding))
			m_sure = btMin(m_sure, distance.m_atMost);
	}
};

// Bullet's contacts of a sphere and a triangle leave out the mesh's margin, so that distances say nothing of them.
Verdict judgeOnMesh(const ComparedChild& part, const btCollisionObject* ground, btScalar threshold, bool isMissed,
                    const btPersistentManifold* bullets)
{
	if (part.m_shape->getShapeType() == SPHERE_SHAPE_PROXYTYPE)
		return DIFFERENT;
	const btConcaveShape* mesh = static_cast<const btConcaveShape*>(ground->getCollisionShape());
	NearTriangles near(part, ground->getWorldTransform(), mesh->getMargin());
	const btVector3 wide(2 * threshold, 2 * threshold, 2 * threshold);
	mesh->processAllTriangles(&near, near.m_min - wide, near.m_max + wide);
	const double slack = c_ofThreshold * double(threshold) + near.m_slack + 2 * double(part.m_rounding);
	const bool isNear = near.m_sure < double(threshold) - slack;
	const bool isFar = near.m_maybe > double(threshold) + slack;
	if (!isNear && !isFar)
		return DOUBTFUL;
	return (isMissed ? isFar && hasNewPoint(bullets) : isNear) ? BULLET_ERRS : DIFFERENT;
}

Verdict judgeOnPlane(const ComparedChild& part, const btCollisionObject* ground, btScalar threshold)
{
	const btStaticPlaneShape* plane = static_cast<const btStaticPlaneShape*>(ground->getCollisionShape());
	const btTransform inPlane = ground->getWorldTransform().inverse() * part.m_transform;
	const btVector3 lowest =
	    inPlane(part.m_shape->localGetSupportingVertex(-plane->getPlaneNormal() * inPlane.getBasis()));
	const btScalar distance = plane->getPlaneNormal().dot(lowest) - plane->getPlaneConstant();
	const btScalar slack = btScalar(c_ofThreshold) * threshold + 2 * part.m_rounding;
	return btFabs(distance - threshold) <= slack ? DOUBTFUL : DIFFERENT;
}

bool isGround(const btCollisionObject* object)
{
	return object->getCollisionShape()->isConcave();
}

Verdict judge(const btHybridChildKey& key, const btPersistentManifold* ours, const btPersistentManifold* bullets)
{
	for (int i = 0; i < 2; i++)
	{
		const btCollisionObject* ground = key.m_bodies[i];
		if (!isGround(ground))
			continue;
		const ComparedChild part(key.m_bodies[1 - i], key.m_children[1 - i]);
		const btScalar threshold = (ours ? ours : bullets)->getContactBreakingThreshold();
		if (ground->getCollisionShape()->getShapeType() == STATIC_PLANE_PROXYTYPE)
			return judgeOnPlane(part, ground, threshold);
		return judgeOnMesh(part, ground, threshold, !ours, bullets);
	}
	const ComparedChild a(key.m_bodies[0], key.m_children[0]);
	const ComparedChild b(key.m_bodies[1], key.m_children[1]);
	const bool isMissed = !ours;
	const btScalar slack = a.m_rounding + b.m_rounding;
	if (isMidphaseDoubtful(a, b))
		return DOUBTFUL;
	if (!isMissed && !overlap(a.m_min, a.m_max, b.m_min, b.m_max, slack))
		return DIFFERENT;
	if (areBoth(SPHERE_SHAPE_PROXYTYPE, a.m_shape, b.m_shape))
	{
		const btScalar radii = a.m_shape->getMargin() + b.m_shape->getMargin();
		return btFabs(a.m_transform.getOrigin().distance(b.m_transform.getOrigin()) - radii) <= slack ? DOUBTFUL
		                                                                                              : DIFFERENT;
	}
	if (areBoth(BOX_SHAPE_PROXYTYPE, a.m_shape, b.m_shape))
		return DIFFERENT;
	return judgeDistance(a, b, (isMissed ? bullets : ours)->getContactBreakingThreshold(), isMissed, bullets);
}

// Of keys that are sorted.
bool contains(const btAlignedObjectArray<btHybridChildKey>& sorted, const btHybridChildKey& key)
{
	int first = 0;
	int last = sorted.size();
	while (first < last)
	{
		const int middle = first + (last - first) / 2;
		if (btHybridChildKey::less(sorted[middle], key))
			first = middle + 1;
		else
			last = middle;
	}
	return first < sorted.size() && !btHybridChildKey::less(key, sorted[first]);
}

// The triangle of a mesh that a point is on is not a child: Bullet has one manifold for all of the mesh.
int childOf(const btCollisionObject* object, int index)
{
	return object->getCollisionShape()->isCompound() ? index : -1;
}

bool isNested(const btCollisionShape* shape)
{
	const btCompoundShape* compound = shape->isCompound() ? static_cast<const btCompoundShape*>(shape) : 0;
	for (int i = 0; compound && i < compound->getNumChildShapes(); i++)
		if (compound->getChildShape(i)->isCompound())
			return true;
	return false;
}

btHybridMissedContact describe(const btHybridChildKey& key, const btPersistentManifold* manifold)
{
	btHybridMissedContact contact;
	contact.m_bodyA = key.m_bodies[0];
	contact.m_bodyB = key.m_bodies[1];
	contact.m_childA = key.m_children[0];
	contact.m_childB = key.m_children[1];
	contact.m_distance = BT_LARGE_FLOAT;
	for (int i = 0; i < manifold->getNumContacts(); i++)
		contact.m_distance = btMin(contact.m_distance, manifold->getContactPoint(i).getDistance());
	return contact;
}

btManifoldPoint swapped(const btManifoldPoint& point)
{
	btManifoldPoint other = point;
	other.m_localPointA = point.m_localPointB;
	other.m_localPointB = point.m_localPointA;
	other.m_positionWorldOnA = point.m_positionWorldOnB;
	other.m_positionWorldOnB = point.m_positionWorldOnA;
	other.m_normalWorldOnB = -point.m_normalWorldOnB;
	other.m_index0 = point.m_index1;
	other.m_index1 = point.m_index0;
	return other;
}

void givePoints(const btHybridChildManifold& from, const btHybridChildManifold& to)
{
	for (int i = 0; i < from.m_manifold->getNumContacts(); i++)
	{
		btManifoldPoint point = from.m_manifold->getContactPoint(i);
		if (from.m_swapped != to.m_swapped)
			point = swapped(point);
		// The program's, and given back once.
		point.m_userPersistentData = 0;
		point.m_lifeTime = c_givenAge;
		to.m_manifold->addManifoldPoint(point, true);
	}
}
}  // namespace

btHybridContactVerifier::btHybridContactVerifier() : m_parallel(0)
{
}

btHybridContactVerifier::~btHybridContactVerifier()
{
	reset();
}

// The callbacks are those of all worlds, which may be on other threads: nothing is taken away for nothing.
void btHybridContactVerifier::reset()
{
	if (m_parallel)
	{
		const btHybridSilence silence;
		delete m_parallel;
	}
	m_parallel = 0;
	m_extras.clear();
	m_report = btHybridContactReport();
}

// Only those of the narrowphase: Bullet's continuous detection predicts contacts that no algorithm knows.
void btHybridContactVerifier::collectOurs(btCollisionWorld* world)
{
	m_ours.resizeNoInitialize(0);
	btManifoldArray manifolds;
	btBroadphasePairArray& pairs = world->getBroadphase()->getOverlappingPairCache()->getOverlappingPairArray();
	for (int i = 0; i < pairs.size(); i++)
	{
		const btCollisionObject* a = static_cast<const btCollisionObject*>(pairs[i].m_pProxy0->m_clientObject);
		const btCollisionObject* b = static_cast<const btCollisionObject*>(pairs[i].m_pProxy1->m_clientObject);
		if (!pairs[i].m_algorithm || m_parallel->getFate(a, b) < btHybridParallelWorld::HAS_OTHERS)
			continue;
		manifolds.resize(0);
		pairs[i].m_algorithm->getAllContactManifolds(manifolds);
		for (int k = 0; k < manifolds.size(); k++)
		{
			if (manifolds[k]->getNumContacts() == 0)
				continue;
			const btManifoldPoint& point = manifolds[k]->getContactPoint(0);
			const btCollisionObject* body0 = manifolds[k]->getBody0();
			const btCollisionObject* body1 = manifolds[k]->getBody1();
			m_ours.push_back(btHybridChildManifold(manifolds[k], body0, body1, childOf(body0, point.m_index0),
			                                       childOf(body1, point.m_index1)));
		}
	}
	if (m_ours.size() > 1)
		m_ours.quickSort(btHybridChildManifold::less);
}

void btHybridContactVerifier::begin(const btHybridPlanner* planner, btCollisionWorld* world)
{
	const btHybridSilence silence;
	if (!m_parallel)
		m_parallel = new btHybridParallelWorld(world);
	m_parallel->setPlanner(planner);
	m_parallel->follow();
	collectOurs(world);
	sharePoints();
}

void btHybridContactVerifier::sharePoints()
{
	m_unshared.resizeNoInitialize(0);
	m_parallel->getManifolds(m_bullets);
	for (int i = 0; i < m_bullets.size(); i++)
		m_bullets[i].m_manifold->clearManifold();
	for (int i = 0; i < m_ours.size(); i++)
	{
		if (const btHybridChildManifold* bullets = btHybridChildManifold::find(m_bullets, m_ours[i].m_key))
			givePoints(m_ours[i], *bullets);
		else
			m_unshared.push_back(m_ours[i].m_key);
	}
}

void btHybridContactVerifier::finish(btCollisionWorld* world, bool reports)
{
	// A listener has started it anew in the midst of the step.
	if (!m_parallel)
		return;
	const btHybridSilence silence;
	m_parallel->step();
	collectOurs(world);
	m_parallel->getManifolds(m_bullets);
	// What is extra now is extra again in the next step, even if that is not reported.
	btHybridContactReport ignored;
	btHybridContactReport& report = reports ? m_report : ignored;
	report.m_lastMissed.resize(0);
	report.m_lastExtra.resize(0);
	compare(report);
	report.m_steps++;
}

// Whether the pair was looked at in this step, and is made of convex children, or of those and a ground.
bool btHybridContactVerifier::isCompared(const btHybridChildKey& key) const
{
	for (int i = 0; i < 2; i++)
	{
		const btCollisionShape* shape = key.m_bodies[i]->getCollisionShape();
		const btCollisionShape* other = key.m_bodies[1 - i]->getCollisionShape();
		if (btHybridGround::maybe(shape->getShapeType()) && shape->isConcave() && other->isCompound())
			continue;
		// The children of compounds in compounds are not told apart.
		if (isNested(shape) || !btHybridParts::isPartList(shape) || (shape->isCompound() && key.m_children[i] < 0))
			return false;
	}
	return m_parallel->getFate(key.m_bodies[0], key.m_bodies[1]) == btHybridParallelWorld::LOOKED_AT_FINEST;
}

void btHybridContactVerifier::compare(btHybridContactReport& report)
{
	btAlignedObjectArray<btHybridChildKey> extrasBefore;
	extrasBefore.copyFromArray(m_extras);
	m_extras.resizeNoInitialize(0);
	for (int i = 0; i < m_bullets.size(); i++)
	{
		const btPersistentManifold* bullets = m_bullets[i].m_manifold;
		if (!isCompared(m_bullets[i].m_key))
			continue;
		report.m_childPairs++;
		if (bullets->getNumContacts() == 0)
			continue;
		const btHybridChildManifold* ours = btHybridChildManifold::find(m_ours, m_bullets[i].m_key);
		if (ours)
			report.m_expected++;
		else
			takeDifference(m_bullets[i].m_key, 0, bullets, report);
	}
	for (int i = 0; i < m_ours.size(); i++)
	{
		const btPersistentManifold* ours = m_ours[i].m_manifold;
		if (!isCompared(m_ours[i].m_key))
			continue;
		const btHybridChildManifold* known = btHybridChildManifold::find(m_bullets, m_ours[i].m_key);
		const btPersistentManifold* bullets = known ? known->m_manifold : 0;
		const bool isThere = bullets && bullets->getNumContacts() > 0;
		// Two spheres have one point, which is new in every step.
		if (isThere && !(areSpheres(m_ours[i].m_key) && ours->getNumContacts() > bullets->getNumContacts()))
			continue;
		const bool isUnknown = contains(m_unshared, m_ours[i].m_key) && !contains(extrasBefore, m_ours[i].m_key);
		if (isUnknown)
			report.m_doubtful++;
		else
			takeDifference(m_ours[i].m_key, ours, bullets, report);
	}
}

void btHybridContactVerifier::takeDifference(const btHybridChildKey& key, const btPersistentManifold* ours,
                                             const btPersistentManifold* bullets, btHybridContactReport& report)
{
	const Verdict verdict = judge(key, ours, bullets);
	if (verdict != DIFFERENT)
	{
		(verdict == DOUBTFUL ? report.m_doubtful : report.m_bulletErrs)++;
		return;
	}
	if (ours)
	{
		m_extras.push_back(key);
		report.m_extra++;
		report.m_lastExtra.push_back(describe(key, ours));
		return;
	}
	report.m_expected++;
	report.m_missed++;
	report.m_lastMissed.push_back(describe(key, bullets));
}
