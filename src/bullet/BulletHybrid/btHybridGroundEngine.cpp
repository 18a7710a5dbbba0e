#include "btHybridGroundEngine.h"

#include <BulletCollision/CollisionDispatch/btCollisionConfiguration.h>
#include <BulletCollision/CollisionDispatch/btCompoundCollisionAlgorithm.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btAabbUtil2.h>

#include "btHybridDetectors.h"

using scatter::ChildPair;
using scatter::pairs::GroundPieces;

namespace
{
btVector3 vector(const scatter::Vec3& v)
{
	return btVector3(v.x, v.y, v.z);
}

/// A part of a body and a piece of its ground as Bullet's algorithms see them. The piece is a triangle, or the whole
/// shape.
class Meeting
{
	btTransform m_transform;  ///< of the part
	btTriangleShape m_triangle;
	btCollisionObjectWrapper m_part;
	btCollisionObjectWrapper m_piece;

public:
	Meeting(const btCollisionObjectWrapper* body, const btHybridPartBody* parts, const btCollisionObjectWrapper* ground,
	        const GroundPieces& pieces, const ChildPair& child)
	    : m_transform(parts->getChildTransform(child.b, body->getWorldTransform())),
	      m_part(body, parts->getChildShape(child.b), body->getCollisionObject(), m_transform, -1,
	             parts->getChildIndex(child.b)),
	      m_piece(0, ground->getCollisionShape(), ground->getCollisionObject(), ground->getWorldTransform(), -1, -1)
	{
		if (pieces.kind != scatter::PartKind::kTriangle || pieces.pieces.empty())
			return;
		const GroundPieces::Piece& piece = pieces.pieces[child.a];
		const auto points = pieces.pointsOf(piece);
		for (int i = 0; i < 3; i++)
			m_triangle.m_vertices1[i] = vector(points[size_t(i)]);
		m_triangle.setMargin(pieces.margin);
		m_piece.m_shape = &m_triangle;
		m_piece.m_partId = piece.part;
		m_piece.m_index = piece.index;
	}

	const btCollisionObjectWrapper& part() const
	{
		return m_part;
	}
	const btCollisionObjectWrapper& piece() const
	{
		return m_piece;
	}
};

/// Tells a manifold result which part of the body and which piece of the ground are at work, as Bullet's algorithms do,
/// for as long as it lives.
class MeetingScope
{
	btManifoldResult* m_result;
	const btCollisionObjectWrapper* m_before[2];

public:
	MeetingScope(btManifoldResult* result, int side, const Meeting& meeting, btPersistentManifold* manifold)
	    : m_result(result), m_before{result->getBody0Wrap(), result->getBody1Wrap()}
	{
		const btCollisionObjectWrapper* wraps[2] = {&meeting.part(), &meeting.piece()};
		if (side == 1)
			btSwap(wraps[0], wraps[1]);
		m_result->setBody0Wrap(wraps[0]);
		m_result->setBody1Wrap(wraps[1]);
		m_result->setShapeIdentifiersA(wraps[0]->m_partId, wraps[0]->m_index);
		m_result->setShapeIdentifiersB(wraps[1]->m_partId, wraps[1]->m_index);
		m_result->setPersistentManifold(manifold);
	}
	~MeetingScope()
	{
		m_result->setPersistentManifold(0);
		m_result->setBody0Wrap(m_before[0]);
		m_result->setBody1Wrap(m_before[1]);
	}
};

/// Keeps the last contact that a detector adds.
struct OneContact : public btManifoldResult
{
	btVector3 m_normal;
	btVector3 m_point;
	btScalar m_distance;
	bool m_isFound;

	OneContact(const btCollisionObjectWrapper* wrap0, const btCollisionObjectWrapper* wrap1,
	           btPersistentManifold* manifold)
	    : btManifoldResult(wrap0, wrap1), m_normal(0, 0, 0), m_point(0, 0, 0), m_distance(0), m_isFound(false)
	{
		setPersistentManifold(manifold);
	}
	virtual void addContactPoint(const btVector3& normalOnBInWorld, const btVector3& pointInWorld, btScalar depth)
	{
		m_normal = normalOnBInWorld;
		m_point = pointInWorld;
		m_distance = depth;
		m_isFound = true;
	}
};
}  // namespace

scatter::Vec3 btHybridWayAhead(const btCollisionObject* body, const btCollisionObject* ground, btScalar timeStep)
{
	const btRigidBody* moving = btRigidBody::upcast(body);
	if (!moving)
		return scatter::Vec3(0);
	btVector3 velocity = moving->getLinearVelocity();
	if (const btRigidBody* carrier = btRigidBody::upcast(ground))
		velocity -=
		    carrier->getVelocityInLocalPoint(moving->getCenterOfMassPosition() - carrier->getCenterOfMassPosition());
	return btHybridVec3(timeStep * (velocity * ground->getWorldTransform().getBasis()));
}

void btHybridGroundBodies::take(int level, btHybridObjects& objects)
{
	if (level == m_level)
		return;
	m_body = objects.getBody(m_object, m_object->getLevelIn(level));
	m_level = level;
}

btHybridGroundEngine::btHybridGroundEngine(btCollisionDispatcher* dispatcher, btHybridObjects& objects,
                                           btHybridGroundBodies& bodies, const btHybridGroundCall& call,
                                           btHybridFallback& fallback, std::vector<btHybridPartBounds>& parts)
    : btHybridManifolds(dispatcher, call.m_body, call.m_ground),
      m_objects(objects),
      m_bodies(bodies),
      m_call(call),
      m_fallback(fallback),
      m_levelWrap(0, call.m_body->getCollisionShape(), call.m_body->getCollisionObject(),
                  call.m_body->getWorldTransform(), -1, -1),
      m_isBounded(false),
      m_parts(parts)
{
}

bool btHybridGroundEngine::follow(scatter::pairs::PlacedBody& body)
{
	btHybridPartBody* parts = m_bodies.m_body;
	const btCollisionShape* shape = m_bodies.m_switches ? parts->getShapeNow() : m_call.m_body->getCollisionShape();
	if (!m_objects.update(parts, shape, m_call.m_body->getWorldTransform()))
		return false;
	body.body = &parts->getBody();
	body.version = parts->getVersion();
	m_bodies.m_ground.follow(m_call.m_ground->getCollisionShape(), parts->getBody().parts().radius());
	return m_bodies.m_ground.getKind() != BT_HYBRID_NO_GROUND;
}

bool btHybridGroundEngine::place(int level, scatter::pairs::PlacedBody& body)
{
	m_bodies.take(level, m_objects);
	if (!follow(body))
		return false;
	m_parts.assign(size_t(body.body->parts().count()), btHybridPartBounds());
	if (m_bodies.m_switches)
		m_levelWrap.m_shape = m_bodies.m_body->getShape();
	m_fallback.release(m_dispatcher);
	return true;
}

scatter::Frame btHybridGroundEngine::groundFrame() const
{
	return btHybridFrameOf(m_call.m_ground->getWorldTransform());
}

scatter::Vec3 btHybridGroundEngine::wayAhead() const
{
	return btHybridWayAhead(m_call.m_body->getCollisionObject(), m_call.m_ground->getCollisionObject(),
	                        m_call.m_info.m_timeStep);
}

int btHybridGroundEngine::groundVersion()
{
	return m_bodies.m_ground.getVersion();
}

float btHybridGroundEngine::groundMargin() const
{
	return m_bodies.m_ground.getMargin();
}

std::optional<scatter::pairs::HalfSpace> btHybridGroundEngine::halfSpace() const
{
	if (m_bodies.m_ground.getKind() != BT_HYBRID_HALF_SPACE)
		return std::nullopt;
	const btStaticPlaneShape* plane = static_cast<const btStaticPlaneShape*>(m_call.m_ground->getCollisionShape());
	return scatter::pairs::HalfSpace{btHybridVec3(plane->getPlaneNormal()), plane->getPlaneConstant()};
}

bool btHybridGroundEngine::collect(const scatter::Vec3& low, const scatter::Vec3& high, GroundPieces& pieces)
{
	return m_bodies.m_ground.collect(vector(low), vector(high), pieces);
}

float btHybridGroundEngine::reach(const scatter::Vec3& direction) const
{
	return m_bodies.m_ground.getReach(vector(direction));
}

// The dispatcher itself would find this algorithm again.
bool btHybridGroundEngine::fallBack()
{
	const btCollisionObjectWrapper* wraps[2] = {m_call.m_body, m_call.m_ground};
	if (m_bodies.m_side == 1)
		btSwap(wraps[0], wraps[1]);
	if (!m_fallback.get())
	{
		btCollisionAlgorithmConstructionInfo info;
		info.m_dispatcher1 = m_dispatcher;
		btCollisionConfiguration* configuration = m_dispatcher->getCollisionConfiguration();
		btCollisionAlgorithmCreateFunc* create = configuration->getCollisionAlgorithmCreateFunc(
		    wraps[0]->getCollisionShape()->getShapeType(), wraps[1]->getCollisionShape()->getShapeType());
		m_fallback.set(create->CreateCollisionAlgorithm(info, wraps[0], wraps[1]));
	}
	m_fallback.get()->processCollision(wraps[0], wraps[1], m_call.m_info, m_call.m_result);
	btManifoldArray manifolds;
	m_fallback.getManifolds(manifolds);
	for (int i = 0; i < manifolds.size(); i++)
		if (manifolds[i]->getNumContacts() > 0)
			return true;
	return false;
}

// The callback hears of new contacts too, as far as Bullet keeps them; its algorithm for planes leaves that to the next
// step.
void btHybridGroundEngine::looked(void* manifold)
{
	if (gContactProcessedCallback && m_bodies.m_ground.getKind() != BT_HYBRID_HALF_SPACE)
		static_cast<void>(outlasts(manifold));
}

btTransform btHybridGroundEngine::getPartTransform(int part) const
{
	return m_bodies.m_body->getChildTransform(part, m_call.m_body->getWorldTransform());
}

void btHybridGroundEngine::boundGround()
{
	if (m_isBounded)
		return;
	m_isBounded = true;
	const btCollisionShape* ground = m_call.m_ground->getCollisionShape();
	const btTransform& pose = m_call.m_ground->getWorldTransform();
	ground->getAabb(pose, m_groundMin[0], m_groundMax[0]);
	ground->getAabb(m_call.m_body->getWorldTransform().inverse() * pose, m_groundMin[1], m_groundMax[1]);
}

const btHybridPartBounds& btHybridGroundEngine::getBounds(int part)
{
	btHybridPartBounds& bounds = m_parts[part];
	if (bounds.m_isKnown)
		return bounds;
	bounds.m_isKnown = true;
	bounds.m_mayBegin = letsMeet(part);
	if (!bounds.m_mayBegin || m_bodies.m_ground.getKind() == BT_HYBRID_HALF_SPACE)
		return bounds;
	bounds.m_mayBegin = meetsInWorld(part) && meetsLeaf(part);
	const btTransform inGround = m_call.m_ground->getWorldTransform().inverse() * getPartTransform(part);
	m_bodies.m_body->getChildShape(part)->getAabb(inGround, bounds.m_min, bounds.m_max);
	const btVector3 margin(groundMargin(), groundMargin(), groundMargin());
	bounds.m_min -= margin;
	bounds.m_max += margin;
	return bounds;
}

// A filter that a program may have set for the children of compounds.
bool btHybridGroundEngine::letsMeet(int part) const
{
	if (!gCompoundChildShapePairCallback || m_bodies.m_body->getChildIndex(part) < 0)
		return true;
	return gCompoundChildShapePairCallback(m_call.m_ground->getCollisionShape(), m_bodies.m_body->getChildShape(part));
}

// The tests of the bounds that Bullet makes before a child of a compound meets another shape: in the world, and of its
// leaf.
bool btHybridGroundEngine::meetsInWorld(int part)
{
	boundGround();
	btVector3 partMin, partMax;
	m_bodies.m_body->getChildShape(part)->getAabb(getPartTransform(part), partMin, partMax);
	return TestAabbAgainstAabb2(partMin, partMax, m_groundMin[0], m_groundMax[0]);
}

bool btHybridGroundEngine::meetsLeaf(int part)
{
	if (!m_bodies.m_body->hasLeaves())
		return true;
	boundGround();
	btVector3 leafMin, leafMax;
	m_bodies.m_body->getLeaf(part, leafMin, leafMax);
	return TestAabbAgainstAabb2(leafMin, leafMax, m_groundMin[1], m_groundMax[1]);
}

// Bullet's compounds drop what a child has found once its bounds are apart from the other shape.
bool btHybridGroundEngine::keeps(int part)
{
	return m_bodies.m_ground.getKind() == BT_HYBRID_HALF_SPACE || meetsInWorld(part);
}

// Of a mesh only the triangles whose bounds meet those of the part, widened by the mesh's margin.
bool btHybridGroundEngine::mayMeet(const GroundPieces& pieces, const ChildPair& child)
{
	const btHybridPartBounds& bounds = getBounds(child.b);
	if (!bounds.m_mayBegin || m_bodies.m_ground.getKind() != BT_HYBRID_TRIANGLES)
		return bounds.m_mayBegin;
	const auto points = pieces.pointsOf(pieces.pieces[child.a]);
	const btVector3 corners[3] = {vector(points[0]), vector(points[1]), vector(points[2])};
	return TestTriangleAgainstAabb2(corners, bounds.m_min, bounds.m_max);
}

void btHybridGroundEngine::add(void* manifold, const GroundPieces& pieces, const ChildPair& child,
                               const scatter::PartContact& contact, const scatter::Frame& frame)
{
	const Meeting meeting(&m_levelWrap, m_bodies.m_body, m_call.m_ground, pieces, child);
	btPersistentManifold* to = btHybridContacts::at(manifold);
	const MeetingScope scope(m_call.m_result, m_bodies.m_side, meeting, to);
	// The manifold's second body is the ground, whichever comes first in the pair.
	const scatter::Vec3 onGround = contact.pointB - contact.axis * contact.distance;
	// Of a body that is about to come so far, Bullet takes no contact as far away, and drops it in the next step.
	const btScalar usual = to->getContactBreakingThreshold();
	to->setContactBreakingThreshold(btMax(usual, btScalar(contact.distance)));
	m_call.m_result->addContactPoint(vector(frame.rotate(contact.axis)), vector(frame(onGround)), contact.distance);
	to->setContactBreakingThreshold(usual);
}

bool btHybridGroundEngine::find(void* manifold, const GroundPieces& pieces, const ChildPair& child,
                                const scatter::Frame& frame, scatter::PartContact& contact)
{
	const Meeting meeting(&m_levelWrap, m_bodies.m_body, m_call.m_ground, pieces, child);
	OneContact found(&meeting.part(), &meeting.piece(), btHybridContacts::at(manifold));
	btHybridDetect(m_dispatcher, &meeting.part(), &meeting.piece(), btHybridContacts::at(manifold), m_call.m_info,
	               &found);
	if (!found.m_isFound || found.m_distance > threshold())
		return false;
	contact.distance = found.m_distance;
	contact.axis = frame.rotateBack(btHybridVec3(found.m_normal));
	contact.pointB = frame.toLocal(btHybridVec3(found.m_point)) + contact.axis * contact.distance;
	return true;
}

void btHybridGroundEngine::detect(void* manifold, const GroundPieces& pieces, const ChildPair& child)
{
	const Meeting meeting(&m_levelWrap, m_bodies.m_body, m_call.m_ground, pieces, child);
	const MeetingScope scope(m_call.m_result, m_bodies.m_side, meeting, btHybridContacts::at(manifold));
	btHybridDetect(m_dispatcher, &meeting.part(), &meeting.piece(), btHybridContacts::at(manifold), m_call.m_info,
	               m_call.m_result);
}
