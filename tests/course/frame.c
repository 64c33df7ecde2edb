/* Exercise coursework-frame. Oracle: the border of the box, computed in double precision. */
#include "course.h"
bool exFrameCast(wfTransform box, wfVec2 half, wfVec2 from, wfVec2 way, wfReal *t, wfVec2 *normal);
#define exFrameCast(box, half, from, way, t, normal) asked_and(exFrameCast(box, half, from, way, t, normal), left(*(t)), left(*(normal)))
static void rays(bool normals)
{
    wfRandom r = course_random(7);
    for (int k = 0; k < 4000; k++) {
        double angle = (double)wfRandomReal(&r, -3, 3), c = cos(angle), s = sin(angle), x = (double)wfRandomReal(&r, -1, 1), y = (double)wfRandomReal(&r, -1, 1);
        wfVec2 half = wfV2(wfRandomReal(&r, WF_R(0.5), 1), wfRandomReal(&r, WF_R(0.5), 1)), n = wfV2(0, 0);
        wfReal direction = wfRandomReal(&r, -3, 3), t = -1;
        wfVec2 from = wfV2((wfReal)(x + 5 * cos((double)direction)), (wfReal)(y + 5 * sin((double)direction)));
        wfVec2 aim = wfV2((wfReal)(x + 0.4 * s), (wfReal)(y + 0.4 * c)), way = wfScale(2, wfSub(aim, from));
        bool met = exFrameCast(wfMakeTransform(wfV2((wfReal)x, (wfReal)y), (wfReal)angle), half, from, way, &t, &n);
        double px = (double)from.x + (double)t * (double)way.x - x, py = (double)from.y + (double)t * (double)way.y - y;
        double u = fabs(c * px + s * py) - (double)half.x, v = fabs(c * py - s * px) - (double)half.y;
        if (!normals) expect_true(say("ray %d meets the box that it is aimed at", k), met);
        if (!normals) expect_near(say("distance of its point from the border, ray %d", k), fmax(u, v), 0, 1e-5);
        double nx = c * (double)n.x + s * (double)n.y, ny = c * (double)n.y - s * (double)n.x;          /* seen from the box */
        if (normals) expect_near(say("length of the normal, ray %d", k), hypot(nx, ny), 1, 1e-5);
        if (normals) expect_at_most(say("normal times way, ray %d", k), (double)wfDot(n, way), 0);
        if (normals) expect_near(say("part of the normal along the side that was met, ray %d", k), u > v ? ny : nx, 0, 1e-3);
    }
}
static void points(void) { rays(false); }
static void normals(void) { rays(true); }
CRITERIA("frame",
    { "points", 1, "frame: cast the ray against the box", "the ray meets the box on its border", points, 0 },
    { "normals", 2, "frame: cast the ray against the box", "the normal is that of the side that was met", normals, 0 })
