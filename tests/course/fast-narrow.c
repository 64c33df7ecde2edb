/* Exercise coursework-fast-narrow. Oracle: all sides of both, and their time. */
#include "course.h"
#include "race.h"
enum { EX_CORNERS = 8, POLYGONS = 400 };
typedef struct ExPolygon { wfVec2 corner[EX_CORNERS], centre; wfReal radius; } ExPolygon;
bool exFastOverlap(const ExPolygon *a, const ExPolygon *b);
#define exFastOverlap(a, b) asked(exFastOverlap(a, b))
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
static const ExPolygon *heap;
static bool met[2][POLYGONS][POLYGONS / 8];
static void slow(void) { for (int i = 0; i < POLYGONS; i++) for (int j = 0; j < i; j += 8) met[0][i][j / 8] = plain(&heap[i], &heap[j]); }
static void fast(void) { for (int i = 0; i < POLYGONS; i++) for (int j = 0; j < i; j += 8) met[1][i][j / 8] = (exFastOverlap)(&heap[i], &heap[j]); }
static void twice(void)
{
    heap = lay(12, 5);
    expect_twice_as_fast(slow, fast);
    done((void)0, left(met[1]));
    slow();
    expect_true("the answers are the same", memcmp(met[0], met[1], sizeof met[0]) == 0);
}
CRITERIA("fast-narrow",
    { "same", 2, "fast narrow: do a and b overlap", "the same answers", same, 0 },
    { "twice", 2, "fast narrow: do a and b overlap", "at most half the time", twice, 0 })
