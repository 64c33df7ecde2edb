/* Exercise coursework-fast-narrow. Oracle: all sides of both, and their time. */
#include "course.h"
enum { EX_CORNERS = 8, POLYGONS = 400 };
typedef struct ExPolygon { wfVec2 corner[EX_CORNERS], centre; wfReal radius; } ExPolygon;
bool exFastOverlap(const ExPolygon *a, const ExPolygon *b);
static ExPolygon polygon[POLYGONS];
static bool side_between(const ExPolygon *a, const ExPolygon *b)
{
    for (int i = 0; i < EX_CORNERS; i++) {
        wfVec2 p = a->corner[i], q = a->corner[(i + 1) % EX_CORNERS], n = wfNormalize(wfPerpCW(wfSub(q, p)));
        wfReal least = WF_HUGE;
        for (int k = 0; k < EX_CORNERS; k++) least = wfMinR(least, wfDot(n, wfSub(b->corner[k], p)));
        if (least > 0) return true;
    }
    return false;
}
static bool plain(const ExPolygon *a, const ExPolygon *b) { return !side_between(a, b) && !side_between(b, a); }
static const ExPolygon *lay(double room, uint64_t seed)
{
    wfRandom r = course_random(seed);
    for (int i = 0; i < POLYGONS; i++) {
        ExPolygon *p = &polygon[i];
        double tall = 0.3 + (double)wfRandomReal(&r, 0, 1), turn = (double)wfRandomReal(&r, -3, 3), x = (double)wfRandomReal(&r, (wfReal)-room, (wfReal)room), y = (double)wfRandomReal(&r, (wfReal)-room, (wfReal)room);
        p->centre = wfV2((wfReal)x, (wfReal)y), p->radius = (wfReal)fmax(1.001, 1.001 * tall);
        for (int k = 0; k < EX_CORNERS; k++) {
            double u = cos(0.785398 * k), v = tall * sin(0.785398 * k);
            p->corner[k] = wfV2((wfReal)(x + cos(turn) * u - sin(turn) * v), (wfReal)(y + sin(turn) * u + cos(turn) * v));
        }
    }
    return shown_many(polygon, POLYGONS);
}
static void same(void)
{
    for (int k = 1; k <= 2; k++) {
        const ExPolygon *given = lay(4 * k, (uint64_t)k);
        for (int i = 0; i < 100; i++)
            for (int j = 0; j < 100; j++) expect_int(say("do the polygons %d and %d overlap", i, j), exFastOverlap(&given[i], &given[j + 100]), plain(&given[i], &given[j + 100]));
    }
}
static volatile int met;
static void all(const ExPolygon *p, bool (*overlap)(const ExPolygon *, const ExPolygon *)) { for (int i = 0; i < POLYGONS; i++) for (int j = 0; j < i; j += 8) met += overlap(&p[i], &p[j]); }
/* Seconds of the fastest of nine runs of each. The processor's own clock ticks too slowly beside the criterion's limit. */
static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec; }
#define RACE(slow, fast, t) do { t[0] = t[1] = 1e9; for (int run = 0; run < 9; run++) { double a = now(); slow; double b = now(); fast; t[0] = fmin(t[0], b - a), t[1] = fmin(t[1], now() - b); } } while (0)
/* Sanitizers, which look at every access, weigh on both as they like: the time is asked of the plain build alone. */
#ifdef __SANITIZE_ADDRESS__
enum { LEAST = 0 };
#else
enum { LEAST = 2 };
#endif

static void twice(void)
{
    const ExPolygon *given = lay(12, 5);
    double t[2];
    RACE(all(given, plain), all(given, exFastOverlap), t);
    expect_at_least("how many times as fast", t[0] / t[1], LEAST);
}
CRITERIA("fast-narrow",
    { "same", 2, "fast narrow: do a and b overlap", "the same answers", same, 0 },
    { "twice", 2, "fast narrow: do a and b overlap", "at most half the time", twice, 0 })
