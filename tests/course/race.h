/* race.h: a race between plain loops and the code under test, for exercises whose answer is a time. Include course.h first. */
#ifndef WEFT_COURSE_RACE_H
#define WEFT_COURSE_RACE_H
/* The processor's own clock ticks too slowly beside the criterion's limit. */
static inline double race_now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; }
/* Seconds of the fastest of nine runs of each. */
static inline void race(void (*slow)(void), void (*fast)(void), double t[2])
{
    t[0] = t[1] = 1e9;
    for (int run = 0; run < 9; run++) {
        double a = race_now();
        slow();
        double b = race_now();
        fast();
        t[0] = fmin(t[0], b - a), t[1] = fmin(t[1], race_now() - b);
    }
}
/* Both run where the code under test is asked, side by side, and their times are its answer; what `fast` has written is left behind it.
   `fast` calls the code by (name), past its macro. Sanitizers, which look at every access, weigh on both as they like: the time is
   asked of the plain build alone. */
static inline void expect_twice_as_fast(void (*slow)(void), void (*fast)(void))
{
    double t[2];
    done(race(slow, fast, t), left(t));
#ifdef __SANITIZE_ADDRESS__
    expect_at_least("how many times as fast", t[0] / t[1], 0);
#else
    expect_at_least("how many times as fast as the plain loops", t[0] / t[1], 2);
#endif
}
#endif
