#include "btHybridStepClock.h"

#include <LinearMath/btQuickprof.h>
#include <time.h>

double btHybridStepClock::getThreadMilliseconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
	timespec now;
	clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
	return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
#else
	static btClock clock;
	return 1e-3 * double(clock.getTimeMicroseconds());
#endif
}
