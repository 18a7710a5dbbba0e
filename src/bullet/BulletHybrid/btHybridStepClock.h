#ifndef BT_HYBRID_STEP_CLOCK_H
#define BT_HYBRID_STEP_CLOCK_H

/// What a step costs.
struct btHybridStepClock
{
	/// Processor time of the calling thread, milliseconds; wall time where there is no such clock.
	static double getThreadMilliseconds();
};

#endif  // BT_HYBRID_STEP_CLOCK_H
