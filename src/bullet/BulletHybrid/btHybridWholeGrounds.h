#ifndef BT_HYBRID_WHOLE_GROUNDS_H
#define BT_HYBRID_WHOLE_GROUNDS_H

#include <memory>
#include <unordered_map>

#include "btHybridGround.h"
#include "pairs/whole_ground.h"

/// The small meshes that bodies are near, each looked up once for all pairs, for as long as one of them has it.
class btHybridWholeGrounds
{
	struct Kept
	{
		btHybridGroundTraits m_traits;
		scatter::pairs::WholeGround m_whole;
	};
	std::unordered_map<const btCollisionShape*, std::weak_ptr<const Kept> > m_kept;

public:
	/// Of a ground that is small; 0 if it has no triangles. isNew: it was looked up now.
	std::shared_ptr<const scatter::pairs::WholeGround> acquire(const btHybridGround& ground, bool& isNew);

	size_t getBytes() const;
};

#endif  // BT_HYBRID_WHOLE_GROUNDS_H
