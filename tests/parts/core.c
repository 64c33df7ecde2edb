/* core.c: scenes for the engine "core", and the hash of each after some seconds, as a table: the golden hashes of core
   (tests/golden/core.csv, core-double.csv). With IN_THE_WHOLE the whole engine makes the same table, so that core is known not to be another
   engine but a part of it. Whatever core has takes part: every solver, forces, friction, restitution, events, rays. */
#include <stdio.h>
#include <string.h>
#include "weft/weft.h"

static int failed;
static void need(int good, const char *what) { if (!good) { fprintf(stderr, "core.c: %s\n", what); failed = 1; } }

static wfBodyId add(wfWorld *w, int32_t type, wfShape shape, double x, double y, double turn)
{
    wfBodyDef d = wfDefaultBodyDef();
    wfBodyId id = { 0 };
    d.type = type;
    d.shape = shape;
    d.position = wfV2((wfReal)x, (wfReal)y);
    d.angle = (wfReal)turn;
    need(wfAddBodyToWorld(w, &d, &id) == WF_OK, "a body was refused");
    return id;
}
static wfShape box(double w, double h) { wfShape s = { 0 }; need(wfMakeBox((wfReal)w / 2, (wfReal)h / 2, &s) == WF_OK, "no box"); return s; }
static wfShape ball(double r) { wfShape s = { 0 }; need(wfMakeCircle(wfV2(0, 0), (wfReal)r, &s) == WF_OK, "no ball"); return s; }
static wfShape wedge(void)
{
    const wfVec2 p[] = { wfV2(-1, 0), wfV2(1, 0), wfV2(0, 1) };
    wfShape s = { 0 };
    need(wfMakePolygon(p, 3, &s) == WF_OK, "no wedge");
    return s;
}
static void ground(wfWorld *w) { add(w, WF_STATIC, box(60, 2), 0, -1, 0); }
static void bin(wfWorld *w) { ground(w); add(w, WF_STATIC, box(1, 12), -6, 6, 0); add(w, WF_STATIC, box(1, 12), 6, 6, 0); }

static void fall(wfWorld *w) { add(w, WF_DYNAMIC, box(1, 2), 0, 50, 0.3); }
static void stack(wfWorld *w) { ground(w); for (int i = 0; i < 10; i++) add(w, WF_DYNAMIC, box(1, 1), 0.01 * (i % 3), 0.5 + i, 0); }
static void pyramid(wfWorld *w)
{
    ground(w);
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 8 - row; i++) add(w, WF_DYNAMIC, box(0.9, 0.9), i - 0.5 * (7 - row), 0.45 + 0.9 * row, 0);
}
static void pour(wfWorld *w)
{
    wfRandom r;
    bin(w);
    wfRandomSeed(&r, 7);
    for (int i = 0; i < 60; i++) {
        double x = (double)wfRandomReal(&r, -4, 4), turn = (double)wfRandomReal(&r, 0, 6);
        add(w, WF_DYNAMIC, i % 3 == 0 ? ball(0.4) : i % 3 == 1 ? box(0.8, 0.6) : wedge(), x, 2 + i * 0.5, turn);
    }
}
static void slope(wfWorld *w)
{
    add(w, WF_STATIC, box(40, 1), 0, 0, -0.3);
    for (int i = 0; i < 5; i++) add(w, WF_DYNAMIC, i % 2 ? ball(0.5) : box(1, 1), -10 + 3 * i, 5, -0.3);
}
static void bounce(wfWorld *w)
{
    ground(w);
    for (int i = 0; i < 6; i++) {
        wfBodyDef d = wfDefaultBodyDef();
        d.shape = ball(0.3);
        d.position = wfV2((wfReal)i, 4);
        d.restitution = (wfReal)i / 5;
        d.linearDamping = WF_R(0.05) * (wfReal)(i % 2);
        need(wfAddBodyToWorld(w, &d, NULL) == WF_OK, "a ball was refused");
    }
}
static void springs(wfWorld *w)
{
    wfBodyId last = add(w, WF_STATIC, ball(0.1), 0, 10, 0);
    ground(w);
    for (int i = 1; i < 5; i++) {
        wfBodyId next = add(w, WF_DYNAMIC, box(0.5, 0.5), i, 10, 0);
        wfForce f = wfSpring(wfBodyIndex(w, last), wfV2(0, 0), wfBodyIndex(w, next), wfV2(0, 0), 1, 200, 2);
        need(wfAddForceToWorld(w, &f, NULL) == WF_OK, "a spring was refused");
        last = next;
    }
    wfForce drag = wfDrag(WF_R(0.1), WF_R(0.01));
    need(wfAddForceToWorld(w, &drag, NULL) == WF_OK, "a drag was refused");
}

static const struct { const char *name; void (*build)(wfWorld *w); int steps; } scene[] = {
    { "fall", fall, 120 }, { "stack", stack, 600 }, { "pyramid", pyramid, 300 }, { "pour", pour, 600 }, { "slope", slope, 300 },
    { "bounce", bounce, 600 }, { "springs", springs, 600 },
};

/* The state, what was told of touches on the way, and what rays and areas answer at the end. */
static uint64_t played(int k, int solver, int integrator)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    int32_t count, told = 0, shapes[8], found = 0;
    wfRayHit hit = { .shape = WF_NO_SHAPE };
    def.solver = solver;
#ifdef IN_THE_WHOLE                /* the whole engine, with what core has not switched off: the same bits */
    def.advanced.graphColouring = def.advanced.enableSimd = def.advanced.stackSolver = def.advanced.reuseManifolds = def.maxImpacts = 0;
#endif
    if (integrator >= 0) def.integrator = integrator;
    need(wfCreateWorld(&def, &w) == WF_OK, "no world");
    scene[k].build(&w);
    for (int i = 0; i < scene[k].steps; i++) {
        need(wfStepWorld(&w) == WF_OK, "a step failed");
        wfWorldEvents(&w, WF_CONTACT_BEGIN, &count);
        told += count;
        wfWorldEvents(&w, WF_CONTACT_END, &count);
        told += 1000 * count;
    }
    need(wfWorldCastRay(&w, (wfRay){ wfV2(-20, WF_R(0.5)), wfV2(40, WF_R(0.1)) }, NULL, &hit) == WF_OK, "no ray");
    need(wfWorldOverlapArea(&w, (wfRect){ wfV2(-2, 0), wfV2(2, 2) }, NULL, shapes, 8, &found) == WF_OK, "no area");
    uint64_t h = wfHashWorld(&w);
    h = h * 31 + (uint64_t)told;
    h = h * 31 + (uint64_t)(hit.shape + 1);
    h = h * 31 + (uint64_t)found;
    wfDestroyWorld(&w);
    return h;
}

int main(void)
{
    printf("scene,method,steps,hash\n");
    for (int k = 0; k < (int)(sizeof scene / sizeof *scene); k++)
        for (int s = 0; s < wfSolverCount; s++)
            if (strcmp(wfSolverTable[s].name, "exact") != 0) printf("%s,%s,%d,%016llx\n", scene[k].name, wfSolverTable[s].name, scene[k].steps, (unsigned long long)played(k, s, -1));
    for (int i = 0; i < wfIntegratorCount; i++)
        if (strcmp(wfIntegratorTable[i].name, "implicit-midpoint") != 0) printf("springs,%s,600,%016llx\n", wfIntegratorTable[i].name, (unsigned long long)played(6, wfFindSolver("impulse"), i));
    return failed;
}
