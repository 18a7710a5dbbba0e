#ifndef BT_HYBRID_REGISTRATION_H
#define BT_HYBRID_REGISTRATION_H

#include <BulletCollision/CollisionDispatch/btCollisionCreateFunc.h>
#include <LinearMath/btAlignedObjectArray.h>

class btCollisionDispatcher;
class btDispatcher;
class btHybridDynamicsWorld;
class btHybridNarrowphase;
struct btCollisionAlgorithmConstructionInfo;
struct btCollisionObjectWrapper;

/// Registers the pair algorithm with a dispatcher, and takes it back at its end. Pair algorithms must not outlive the
/// dispatcher.
class btHybridRegistration
{
	/// Stands in for the create functions of one pair of shape types.
	struct CreateFunc : public btCollisionAlgorithmCreateFunc
	{
		const btHybridRegistration* m_registration;
		btCollisionAlgorithmCreateFunc* m_default;

		virtual btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
		                                                       const btCollisionObjectWrapper* body0Wrap,
		                                                       const btCollisionObjectWrapper* body1Wrap);
	};

	btHybridNarrowphase* m_narrowphase;
	const btHybridDynamicsWorld* m_world;  ///< its hybrids; only an address
	btCollisionDispatcher* m_dispatcher;   ///< 0 if it is not in charge there
	btHybridRegistration* m_next;          ///< of those in charge
	const char* m_mistake;                 ///< why it is not
	btAlignedObjectArray<CreateFunc> m_createFuncs;

	btHybridRegistration(const btHybridRegistration&);
	btHybridRegistration& operator=(const btHybridRegistration&);

	const char* takeCharge(btDispatcher* dispatcher);
	void giveUpCharge();
	bool isForeign(const btCollisionObjectWrapper* wrap) const;
	bool hasPartLists(const btCollisionObjectWrapper* wrap) const;
	bool mayTake(const btCollisionAlgorithmConstructionInfo& info, const btCollisionObjectWrapper* body0Wrap,
	             const btCollisionObjectWrapper* body1Wrap) const;
	int findSideOnGround(const btCollisionObjectWrapper* body0Wrap, const btCollisionObjectWrapper* body1Wrap) const;

public:
	/// For pairs with a hybrid of `world`, and as the narrowphase's settings say; 0: of no world. Uses the narrowphase
	/// as long as it lives.
	btHybridRegistration(btDispatcher* dispatcher, const btHybridDynamicsWorld* world,
	                     btHybridNarrowphase* narrowphase);
	~btHybridRegistration();

	/// 0, or why it is not in charge of the dispatcher's hybrid pairs, and how to mend it.
	const char* getMistake() const
	{
		return m_mistake;
	}
};

#endif  // BT_HYBRID_REGISTRATION_H
