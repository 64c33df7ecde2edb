/* Weft: testbed/performance_scenes.c, tangled from chapters/testbed/12-report-scenes.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* The report's six performance tests. */
#include "testbed/maker.h"
#include "testbed/plots.h"
#define CROWD .update = lift_crowd, .controls = { [WF_UP] = "lift" }

/* scenes of performance */
enum { CROWD_ROW = 40 };

/* Room for so many bodies, of which so many fall. */
static void crowd_room(wfWorldDef *def, int32_t bodies, int32_t falling)
{
    def->bodyCapacity = bodies + 8;
    def->advanced.pairCapacity = 4 * falling;
    def->advanced.contactCapacity = 3 * falling;
}

static void room_for_100(wfWorldDef *def) { crowd_room(def, 100, 100); }
static void room_for_500(wfWorldDef *def) { crowd_room(def, 500, 500); }
static void room_for_1000(wfWorldDef *def) { crowd_room(def, 1000, 1000); }
static void room_for_2000(wfWorldDef *def) { crowd_room(def, 2000, 2000); }
static void room_among_1000(wfWorldDef *def) { crowd_room(def, 2000, 1000); }
static void room_among_2000(wfWorldDef *def) { crowd_room(def, 3000, 1000); }

static void put_bin(Maker *m, wfReal width, wfReal height)
{
    put_wall(m, 0, -1, width / 2 + 2, 1, 0);
    put_wall(m, -width / 2 - 1, height / 2, 1, height / 2, 0);
    put_wall(m, width / 2 + 1, height / 2, 1, height / 2, 0);
}

static void drop_crowd(Maker *m, int32_t count, int32_t firstRow, wfReal apart,
                       wfReal aside)
{
    for (int32_t i = 0; i < count; i++) {
        wfReal column = (wfReal)(i % CROWD_ROW) - WF_R(0.5) * (CROWD_ROW - 1);
        wfReal x = apart * column + aside;
        wfReal y = apart * ((wfReal)(firstRow + i / CROWD_ROW) + WF_R(0.5));
        wfBodyDef b = i % 2 ? ball(m, x, y, WF_R(0.4)) : box(m, x, y, WF_R(0.4), WF_R(0.4));
        b.friction = WF_R(0.6);
        put_ink(m, &b, i / CROWD_ROW % 2 ? WF_INK_BODY : WF_INK_BODY2);
    }
}

static wfResult build_crowd(wfWorld *world, int32_t count)
{
    Maker m = { world, WF_OK };
    put_bin(&m, CROWD_ROW, (wfReal)(count / CROWD_ROW + 10));
    drop_crowd(&m, count, 0, 1, 0);
    return m.result;
}

static wfResult build_100(wfWorld *world) { return build_crowd(world, 100); }
static wfResult build_500(wfWorld *world) { return build_crowd(world, 500); }
static wfResult build_1000(wfWorld *world) { return build_crowd(world, 1000); }
static wfResult build_2000(wfWorld *world) { return build_crowd(world, 2000); }

/* While it is held, all rise as they would fall, each a little to its own side. */
static void lift_crowd(wfWorld *world, const wfSceneInput *in)
{
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 0; i < v.count && (in->held >> WF_UP & 1); i++) {
        wfVec2 by = wfV2(WF_R(0.05) * (wfReal)(i * 7 % 11 - 5) / 2, WF_R(0.33));
        if (!v.alive[i] || !(v.state[i].invMass > 0)) continue;
        by = wfScale(1 / v.state[i].invMass, by);
        wfApplyImpulseToBody(world, wfBodyAt(world, i), by, v.state[i].p);
    }
}

static void put_pegs(Maker *m, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        int32_t row = i / CROWD_ROW, column = i % CROWD_ROW;
        wfBodyDef peg = ball(m, (wfReal)(2 * column - CROWD_ROW + row % 2),
                             (wfReal)(2 * (row + 1)), WF_R(0.2));
        peg.type = WF_STATIC;
        peg.friction = WF_R(0.6);
        put(m, &peg);
    }
}

static wfResult build_among(wfWorld *world, int32_t pegs)
{
    enum { FALLING = 1000 };
    Maker m = { world, WF_OK };
    put_bin(&m, 2 * CROWD_ROW, (wfReal)(2 * pegs / CROWD_ROW + 10));
    put_pegs(&m, pegs);
    drop_crowd(&m, FALLING, (pegs - FALLING) / CROWD_ROW, 2, WF_R(0.3));
    return m.result;
}

static wfResult build_among_1000(wfWorld *world) { return build_among(world, 1000); }
static wfResult build_among_2000(wfWorld *world) { return build_among(world, 2000); }

static const wfScene row[] = {
    { .category = "Performance", .name = "a hundred bodies", .chapter = "performance",
      .text = "The least of the report's six performance tests: boxes and discs in a bin.",
      .define = room_for_100, .build = build_100, CROWD, VIEW(0, 7, 28), PROMISE(0.07, 0.1) },
    { .category = "Performance", .name = "five hundred bodies", .chapter = "performance",
      .text = "Thirteen rows of boxes and discs come down together in a bin.",
      .define = room_for_500, .build = build_500, CROWD, VIEW(0, 10, 30), PROMISE(1.7, 0.25) },
    { .category = "Performance", .name = "a thousand bodies", .chapter = "performance",
      .text = "Twenty-five rows: the lowest are pressed while the highest still fall.",
      .define = room_for_1000, .build = build_1000, CROWD, VIEW(0, 15, 38),
      SHAPE(1.2), PROMISE(7, 0.35) },
    { .category = "Performance", .name = "two thousand bodies", .chapter = "performance",
      .text = "The most at once. Does it run smoothly? Lift them, and watch the curve of time.",
      .define = room_for_2000, .build = build_2000, CROWD, .curves = 1 << WF_PLOT_TIME,
      VIEW(0, 25, 58), SHAPE(0.8), PROMISE(28, 0.5) },
    { .category = "Performance", .name = "a thousand among pegs", .chapter = "performance",
      .text = "1,000 fall among 1,000 that stand still, from where they stand.",
      .define = room_among_1000, .build = build_among_1000, VIEW(0, 27, 66),
      PROMISE(14, 0.3) },
    { .category = "Performance", .name = "a thousand on pegs", .chapter = "performance",
      .text = "1,000 fall among 2,000 that stand still and cost next to nothing.",
      .define = room_among_2000, .build = build_among_2000, VIEW(0, 52, 116),
      PROMISE(30, 0.3) },
};
const wfSceneGroup wfPerformanceScenes = { row, sizeof row / sizeof *row };
