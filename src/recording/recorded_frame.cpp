#include <scatter/recording/recorded_frame.h>

namespace scatter {

void FrameSample::clear() {
  number = 0;
  bodies.clear();
  events.clear();
  pairs.clear();
  contacts.clear();
  values.clear();
  added.clear();
}

std::size_t RecordedFrame::bytes() const {
  return sizeof *this + bodies.capacity() * sizeof(RecordedBody) + events.capacity() * sizeof(LevelEvent) +
         pairs.capacity() * sizeof(PairLevel) + contacts.capacity() * sizeof(RecordedContact) +
         values.capacity() * sizeof(std::uint64_t);
}

}  // namespace scatter
