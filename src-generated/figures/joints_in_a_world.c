/* Weft: figures/joints_in_a_world.c, tangled from chapters/methods/05-joints-in-a-world.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include "weft/world.h"
#include "figures/kit.h"
static void fast_flight(wfDraw *d, wfReal angle, int rate, int impacts, int role)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfBodyDef b = wfDefaultBodyDef();
    wfBodyId id;
    wfBodyInfo now = { .position = { { WF_R(0.6), WF_R(0.5) } } };
    wfWorld w;
    wd.gravity = wfV2(0, 0);
    wd.dt = WF_R(1.0) / (wfReal)rate;
    wd.solver = wfFindSolver("sequential");
    wd.impacts = impacts;
    if (wfCreateWorld(&wd, &w) != WF_OK) return;
    b.type = WF_STATIC, b.friction = 0, b.restitution = 1;
    /* <build the room of the figure> */
    for (int i = 0; i < 4; i++) {
        b.position = i < 2 ? wfV2(i == 0 ? 0 : 6, WF_R(1.5)) : wfV2(3, i == 2 ? 0 : 3);
        wfMakeBox(i < 2 ? WF_R(0.01) : 3, i < 2 ? WF_R(1.5) : WF_R(0.01), &b.shape);
        wfAddBodyToWorld(&w, &b, NULL);
        if (rate == 60 && impacts > 0) figShape(d, &b.shape,
            wfMakeTransform(b.position, 0), 2, WF_INK_LINE, WF_INK_LINE);
    }
    wfMakeCircle(wfV2(0, 0), WF_R(0.2), &b.shape);
    for (int i = 0; i < 4; i++) {
        b.position = wfV2(WF_R(1.8) + WF_R(2.2) * (wfReal)(i % 2), 1 + (wfReal)(i / 2));
        wfAddBodyToWorld(&w, &b, NULL);
        if (rate == 60 && impacts > 0) figShape(d, &b.shape,
            wfMakeTransform(b.position, 0), 2, WF_INK_LINE, WF_INK_LINE);
    }
    wfRot q = wfRotation(angle);
    wfMakeCircle(wfV2(0, 0), WF_R(0.05), &b.shape);
    b.type = WF_DYNAMIC, b.position = now.position;
    b.velocity = wfV2(60 * q.c, 60 * q.s);
    wfAddBodyToWorld(&w, &b, &id);
    for (int i = 0; i < rate / 4; i++) {
        wfVec2 from = now.position;
        if (wfStepWorld(&w) != WF_OK || wfGetBody(&w, id, &now) != WF_OK) break;
        wfDrawLine(d, WF_XY(from), WF_XY(now.position), rate > 60 ? 1 : 1.6f, role);
        if (rate == 60) wfDrawPoint(d, WF_XY(now.position), 5, role);
    }
    wfDestroyWorld(&w);
}
static void figure_fast_legs(wfDraw *d, const wfFigureInput *in)
{
    wfReal x = (wfReal)in->handle[0][0] - WF_R(0.6);
    wfReal angle = wfAtan2((wfReal)in->handle[0][1] - WF_R(0.5), x);
    wfDrawView(d, -0.3f, -0.3f, 6.3f, 3.3f);
    fast_flight(d, angle, 60, 0, WF_INK_BAD);
    fast_flight(d, angle, 60, 16, WF_INK_GOOD);
    fast_flight(d, angle, 600, 16, WF_INK_TEXT);
}
static wfBodyId joined_box(wfWorld *w, double x, double y, double wide, double high,
                           int32_t type)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id = { 0, 0 };
    def.type = type;
    def.position = wfV2((wfReal)x, (wfReal)y);
    if (wfMakeBox((wfReal)wide, (wfReal)high, &def.shape) == WF_OK)
        wfAddBodyToWorld(w, &def, &id);
    return id;
}

static void joined_pin(wfWorld *w, wfBodyId a, wfBodyId b, double x, double y)
{
    wfVec2 at = wfV2((wfReal)x, (wfReal)y);
    wfJoint j;
    if (wfJoinBodies(w, "revolute", a, b, at, at, wfV2(1, 0), &j) == WF_OK)
        wfAddJointToWorld(w, &j, NULL);
}
static void joined_bridge(wfWorld *w)
{
    wfBodyId left = joined_box(w, -6, -1, 1, 1, WF_STATIC);
    wfBodyId right = joined_box(w, 6, -1, 1, 1, WF_STATIC), last = left;
    for (int i = 0; i < 10; i++) {
        wfBodyId plank = joined_box(w, -4.5 + i, -0.1, 0.48, 0.1, WF_DYNAMIC);
        joined_pin(w, last, plank, -5 + i, -0.1);
        last = plank;
    }
    joined_pin(w, last, right, 5, -0.1);
}
static void joined_cart(wfWorld *w)
{
    wfBodyId body = joined_box(w, -4, 0.75, 0.9, 0.25, WF_DYNAMIC), wheel;
    wfBodyDef def = wfDefaultBodyDef();
    wfMakeCircle(wfV2(0, 0), WF_R(0.35), &def.shape);
    for (int i = 0; i < 2; i++) {
        wfJoint j;
        def.position = wfV2(WF_R(-4.6) + WF_R(1.2) * (wfReal)i, WF_R(0.4));
        wfAddBodyToWorld(w, &def, &wheel);
        if (wfJoinBodies(w, "wheel", body, wheel, def.position, def.position, wfV2(0, 1),
                         &j) != WF_OK) continue;
        wfTuneJoint(&j, 1, 4, WF_R(0.7));
        j.flags |= WF_JOINT_MOTOR;
        j.motorSpeed = -4, j.motorForce = 10;
        wfAddJointToWorld(w, &j, NULL);
    }
}
static void joined_crane(wfWorld *w)
{
    wfBodyId tower = joined_box(w, 8.5, 1.5, 0.3, 3.5, WF_STATIC);
    wfBodyId beam = joined_box(w, 7.2, 4.6, 1.9, 0.15, WF_DYNAMIC);
    wfBodyId load = joined_box(w, 6.4, 2.2, 0.4, 0.4, WF_DYNAMIC);
    wfVec2 root = wfV2(WF_R(8.5), WF_R(4.6)), tip = wfV2(WF_R(5.5), WF_R(4.6));
    wfJoint j;
    if (wfJoinBodies(w, "weld", tower, beam, root, root, wfV2(1, 0), &j) == WF_OK)
        wfAddJointToWorld(w, &j, NULL);
    if (wfJoinBodies(w, "distance", beam, load, tip, wfV2(WF_R(6.4), WF_R(2.6)),
                     wfV2(1, 0), &j) != WF_OK) return;
    j.flags = WF_JOINT_LIMITS, j.upper = j.rest;
    wfAddJointToWorld(w, &j, NULL);
}
static void joined_draw(wfDraw *d, const wfWorld *w)
{
    wfBodyView all = wfWorldBodies(w);
    for (int32_t i = 0; i < all.count; i++) {
        wfShape shape;
        if (wfGetBodyShape(w, wfBodyAt(w, i), &shape) != WF_OK) continue;
        wfBodyInfo info;
        if (wfGetBody(w, wfBodyAt(w, i), &info) != WF_OK) continue;
        wfTransform at = wfMakeTransform(info.position, info.angle);
        int fill = info.type == WF_STATIC ? WF_INK_FAINT : WF_INK_BODY;
        figShape(d, &shape, at, 2, WF_INK_LINE, fill);
    }
    for (int32_t i = 0; i < wfWorldJointPlaces(w); i++) {
        wfJoint j;
        if (wfGetJoint(w, wfJointAt(w, i), &j) != WF_OK) continue;
        wfVec2 a = wfApply(wfBodyTransform(&all.state[j.a]), j.localA);
        wfVec2 b = wfApply(wfBodyTransform(&all.state[j.b]), j.localB);
        wfDrawLine(d, WF_XY(a), WF_XY(b), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(a), 4, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(b), 4, WF_INK_ACCENT);
    }
}
static void figure_joined_machines(wfDraw *d, const wfFigureInput *in)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    (void)in;
    wfDrawView(d, -7.2f, -2.2f, 9.2f, 5.4f);
    def.solver = wfFindSolver("soft");
    if (wfCreateWorld(&def, &world) != WF_OK) return;
    joined_bridge(&world);
    joined_cart(&world);
    joined_crane(&world);
    for (int i = 0; i < 180; i++)
        if (wfStepWorld(&world) != WF_OK) break;
    joined_draw(d, &world);
    wfDestroyWorld(&world);
}
static void sleep_draw(wfDraw *d, const wfWorld *w, wfVec2 shift)
{
    static const int ink[4] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD, WF_INK_BAD };
    wfBodyView all = wfWorldBodies(w);
    for (int32_t i = 0; i < all.count; i++) {
        wfBodyId id = wfBodyAt(w, i);
        wfBodyInfo info;
        wfShape shape;
        if (wfGetBody(w, id, &info) != WF_OK) continue;
        if (wfGetBodyShape(w, id, &shape) != WF_OK) continue;
        wfTransform at = wfMakeTransform(wfAdd(info.position, shift), info.angle);
        int32_t island = wfBodyIsland(w, id);
        bool awake = info.type == WF_DYNAMIC && wfIsAwake(w, id);
        figShape(d, &shape, at, 2, WF_INK_LINE, awake ? ink[island < 0 ? 0 : island % 4]
                 : WF_INK_FAINT);
    }
}
static void figure_sleep_stacks(wfDraw *d, const wfFigureInput *in)
{
    wfWorld w;
    (void)in;
    wfDrawView(d, -4.5f, -0.4f, 14.7f, 5.6f);
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    if (wfCreateWorld(&def, &w) != WF_OK) return;
    joined_box(&w, 0, -0.2, 4.4, 0.2, WF_STATIC);
    for (int i = 0; i < 15; i++)
        joined_box(&w, -2 + 2 * (i / 5), 0.5 + i % 5, 0.5, 0.5, WF_DYNAMIC);
    for (int i = 0; i < 1200; i++) wfStepWorld(&w);
    sleep_draw(d, &w, wfV2(0, 0));
    wfBodyDef ball = wfDefaultBodyDef();
    wfMakeCircle(wfV2(0, 0), WF_R(0.3), &ball.shape);
    ball.position = wfV2(-4, WF_R(3.2));
    ball.velocity = wfV2(8, 1);
    wfAddBodyToWorld(&w, &ball, NULL);
    for (int i = 0; i < 15; i++) wfStepWorld(&w);
    sleep_draw(d, &w, wfV2(WF_R(10.2), 0));
    wfDestroyWorld(&w);
}
static void figure_sleep_floating(wfDraw *d, const wfFigureInput *in)
{
    wfWorld w;
    wfBodyId id[4];
    (void)in;
    wfDrawView(d, -3.2f, -0.4f, 9.2f, 4.4f);
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    if (wfCreateWorld(&def, &w) != WF_OK) return;
    joined_box(&w, 0, -0.2, 2.5, 0.2, WF_STATIC);
    for (int i = 0; i < 4; i++)
        id[i] = joined_box(&w, 0.2 * (i % 2), 0.5 + i, 0.5, 0.5, WF_DYNAMIC);
    for (int i = 0; i < 300; i++) wfStepWorld(&w);
    wfRemoveBodyFromWorld(&w, id[1]);
    sleep_draw(d, &w, wfV2(0, 0));
    for (int i = 0; i < 15; i++) wfStepWorld(&w);
    sleep_draw(d, &w, wfV2(6, 0));
    wfDestroyWorld(&w);
}
static const wfFigureRow rows[] = {
    { "fast-legs", figure_fast_legs, 6.6f, 3.6f, 1, { { 1.5f, 1.0f } } },
    { "joined-machines", figure_joined_machines, 16.4f, 7.6f, 0, {{0}} },
    { "sleep-stacks", figure_sleep_stacks, 19.2f, 6.0f, 0, {{0}} },
    { "sleep-floating", figure_sleep_floating, 12.4f, 4.8f, 0, {{0}} },
};
const wfFigureSet joints_in_a_world_figures = WF_ROWS(rows);
