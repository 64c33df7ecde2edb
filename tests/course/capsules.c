/* Exercise narrow-capsule. Oracle: wfShapeDistance (GJK). */
#include "course.h"
#include "weft/narrow.h"
wfReal exCapsuleDistance(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb);
#define exCapsuleDistance(a, xa, b, xb) asked(exCapsuleDistance(a, xa, b, xb))
static wfShape capsule(double half, double radius)
{
    wfShape s;
    expect_result("making a capsule", wfMakeCapsule(wfV2((wfReal)-half, 0), wfV2((wfReal)half, 0), (wfReal)radius, &s), WF_OK);
    return s;
}
static void compare(const char *what, wfShape a, wfTransform xa, wfShape b, wfTransform xb)
{
    wfDistanceResult d;
    double got = (double)exCapsuleDistance(shown(&a), xa, shown(&b), xb);
    expect_result("wfShapeDistance", wfShapeDistance(&a, xa, &b, xb, &d), WF_OK);
    expect_near(what, got, (double)d.distance, 1e-5 * (1 + (double)wfDistance(xa.p, xb.p)));
}
static void random_poses(void)
{
    wfRandom r = course_random(12);
    for (int i = 0; i < 20000; i++) {
        wfShape a = capsule(0.2 + (double)wfRandomReal(&r, 0, 2), 0.05 + (double)wfRandomReal(&r, 0, 1)), b = capsule(0.2 + (double)wfRandomReal(&r, 0, 2), 0.05);
        wfReal x = wfRandomReal(&r, -4, 4), y = wfRandomReal(&r, -4, 4);
        wfTransform xa = wfMakeTransform(wfV2(x, y), wfRandomReal(&r, -3, 3)), xb = wfMakeTransform(wfV2(0, 0), wfRandomReal(&r, -3, 3));
        compare(say("distance in random pose %d", i), a, xa, b, xb);
    }
}
static void parallel(void)
{
    wfShape a = capsule(1, 0.2), b = capsule(2, 0.3);
    for (int i = -8; i <= 8; i++) {
        compare(say("distance of parallel capsules, %g m aside", 0.5 * i), a, wfMakeTransform(wfV2((wfReal)(0.5 * i), 2), 0), b, wfTransformIdentity());
        compare(say("distance on one line, %g m apart", 0.5 * i), a, wfMakeTransform(wfV2((wfReal)(0.5 * i), 0), 0), b, wfTransformIdentity());
    }
}
static void crossed(void)
{
    wfShape a = capsule(2, 0.1), b = capsule(2, 0.1);
    for (int i = 1; i < 12; i++)
        expect_near(say("distance of capsules that cross at %d tenths of a radian", i), (double)exCapsuleDistance(shown(&a), wfMakeTransform(wfV2(0, 0), (wfReal)(0.2 + 0.1 * i)), shown(&b), wfTransformIdentity()), 0, 0);
}
CRITERIA("capsules",
    { "random", 3, "capsules: the distance of the segments pq and rs", "20,000 random poses agree with GJK", random_poses, 0 },
    { "parallel", 2, "capsules: the distance of the segments pq and rs", "parallel and collinear capsules agree with GJK", parallel, 0 },
    { "crossed", 1, "capsules: the distance of the segments pq and rs", "capsules that cross have the distance 0", crossed, 0 })
