#include "btHybridWholeGrounds.h"

#include <utility>

using scatter::pairs::GroundPieces;
using scatter::pairs::WholeGround;

std::shared_ptr<const WholeGround> btHybridWholeGrounds::acquire(const btHybridGround& ground, bool& isNew)
{
	const auto known = m_kept.find(ground.getTraits().m_shape);
	std::shared_ptr<const Kept> kept = known == m_kept.end() ? 0 : known->second.lock();
	isNew = !kept || !(kept->m_traits == ground.getTraits());
	if (isNew)
	{
		GroundPieces pieces;
		ground.collectAll(pieces);
		if (pieces.pieces.empty())
			return 0;
		kept.reset(new Kept{ground.getTraits(), WholeGround(std::move(pieces))});
		std::erase_if(m_kept, [](const auto& other) { return other.second.expired(); });
		m_kept[ground.getTraits().m_shape] = kept;
	}
	return std::shared_ptr<const WholeGround>(kept, &kept->m_whole);
}

size_t btHybridWholeGrounds::getBytes() const
{
	size_t bytes = 0;
	for (const auto& [shape, weak] : m_kept)
		if (const std::shared_ptr<const Kept> kept = weak.lock())
			bytes += kept->m_whole.bytes();
	return bytes;
}
