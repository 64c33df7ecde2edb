/* Exercise shapes-tapered. Oracles: the hull as all disks between the two, sampled; the capsule of chapter 07. */
#include "course.h"
#include "weft/shape.h"
typedef struct ExTapered { wfReal big, small, d; } ExTapered;
wfReal exTaperedArea(const ExTapered *s);
#define exTaperedArea(s) asked(exTaperedArea(s))
wfReal exTaperedCentre(const ExTapered *s);
#define exTaperedCentre(s) asked(exTaperedCentre(s))
bool exTaperedContains(const ExTapered *s, wfVec2 p);
#define exTaperedContains(s, p) asked(exTaperedContains(s, p))
static const ExTapered SHAPES[5] = { { 1, WF_R(0.5), 2 }, { WF_R(0.3), 1, 3 }, { 1, 1, 2 }, { 1, WF_R(0.9), WF_R(0.2) }, { WF_R(0.2), WF_R(0.05), 5 } };

/* The hull is the union of the disks that shrink evenly from one end to the other: find the t at which p is deepest. */
static double depth(const ExTapered *s, double x, double y)
{
    double R = (double)s->big, r = (double)s->small, d = (double)s->d, lo = 0, hi = 1;
    for (int i = 0; i < 45; i++) {
        double a = lo + (hi - lo) / 3, b = hi - (hi - lo) / 3;
        if (R + a * (r - R) - hypot(x - a * d, y) < R + b * (r - R) - hypot(x - b * d, y)) lo = a; else hi = b;
    }
    return R + lo * (r - R) - hypot(x - lo * d, y);
}
static void moments(const ExTapered *s, double *area, double *centre)   /* columns, each from the true half height */
{
    double from = fmin(-(double)s->big, (double)s->d - (double)s->small), to = fmax((double)s->d + (double)s->small, (double)s->big);
    double sum = 0, first = 0, step = (to - from) / 1000, most = fmax((double)s->big, (double)s->small);
    for (int i = 0; i < 1000; i++) {
        double x = from + (i + 0.5) * step, lo = 0, hi = most;
        if (depth(s, x, 0) < 0) continue;
        for (int k = 0; k < 30; k++) { double y = (lo + hi) / 2; if (depth(s, x, y) >= 0) lo = y; else hi = y; }
        sum += 2 * lo * step, first += 2 * lo * step * x;
    }
    *area = sum, *centre = first / sum;
}
static void area(void)
{
    for (int i = 0; i < 5; i++) {
        double a, c;
        moments(&SHAPES[i], &a, &c);
        expect_near(say("area for R, r, d = %g, %g, %g", (double)SHAPES[i].big, (double)SHAPES[i].small, (double)SHAPES[i].d), (double)exTaperedArea(&SHAPES[i]), a, 2e-3 * a);
    }
    wfShape capsule;
    wfMakeCapsule(wfV2(0, 0), wfV2(2, 0), 1, &capsule);
    expect_near("area for R = r, against a capsule", (double)exTaperedArea(&SHAPES[2]), (double)wfShapeArea(&capsule), 1e-5);
}
static void centre(void)
{
    for (int i = 0; i < 5; i++) {
        double a, c;
        moments(&SHAPES[i], &a, &c);
        expect_near(say("centroid for R, r, d = %g, %g, %g", (double)SHAPES[i].big, (double)SHAPES[i].small, (double)SHAPES[i].d), (double)exTaperedCentre(&SHAPES[i]), c, 2e-3);
    }
}
static void inside(void)
{
    wfRandom r = course_random(7);
    for (int i = 0; i < 100000; i++) {
        const ExTapered *s = &SHAPES[i % 5];
        wfReal x = wfRandomReal(&r, -2, 7), y = wfRandomReal(&r, -2, 2);
        double deep = depth(s, (double)x, (double)y);
        if (fabs(deep) < 1e-5) continue;
        bool got = exTaperedContains(s, wfV2(x, y));
        if (got != (deep > 0)) expect_true(say("(%.4f, %.4f) in the shape R, r, d = %g, %g, %g is told rightly", (double)x, (double)y, (double)s->big, (double)s->small, (double)s->d), false);
    }
}
CRITERIA("tapered",
    { "area", 1, "tapered: the area", "the area is right for five shapes, one of them a capsule", area, 0 },
    { "centre", 2, "tapered: the centroid", "the centroid is right", centre, 0 },
    { "inside", 2, "tapered: is p inside?", "a hundred thousand points are told inside or outside rightly", inside, 0 })
