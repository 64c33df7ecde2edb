/* Weft: testbed/sleep_scenes.c, tangled from chapters/testbed/13-feature-scenes.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* What rests is left out of the step. */
#include "testbed/maker.h"

/* scenes of sleep */
static void sleeping(wfWorldDef *def) { def->sleep = 1; }

static wfResult build_islands(wfWorld *world)
{
    Maker m = on_ground(world, 9);
    put_wall(&m, -7, 5, 1, WF_R(0.1), 0);
    for (int i = 0; i < 20; i++) {
        wfReal x = WF_R(2.2) * (wfReal)(i / 4) - 4;
        put_box(&m, x, WF_R(0.4) + WF_R(0.8) * (wfReal)(i % 4), WF_R(0.4), WF_R(0.4), 0);
    }
    wfBodyDef b = ball(&m, WF_R(-6.5), WF_R(5.4), WF_R(0.3));
    b.density = 3;
    put(&m, &b);
    return m.result;
}

static void kick_the_last(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    if (wfWorldSteps(world) != 420) return;
    int32_t last = wfBodyCount(world) - 1;
    wfVec2 at = wfWorldBodies(world).state[last].p;
    wfApplyImpulseToBody(world, wfBodyAt(world, last), wfV2(4, 0), at);
}

static wfResult build_support(wfWorld *world)
{
    Maker m = on_ground(world, 8);
    put_wall(&m, 0, WF_R(3.1), 3, WF_R(0.1), 0);               /* body 1: the plank */
    put_wall(&m, WF_R(-2.5), WF_R(1.5), WF_R(0.2), WF_R(1.5), 0);
    put_wall(&m, WF_R(2.5), WF_R(1.5), WF_R(0.2), WF_R(1.5), 0);
    for (int i = 0; i < 12; i++) {
        wfReal x = (wfReal)(i % 3) - 1, y = WF_R(3.6) + WF_R(0.8) * (wfReal)(i / 3);
        put_box(&m, x, y, WF_R(0.45), WF_R(0.4), 0);
    }
    return m.result;
}

static void take_the_plank(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    if (wfWorldSteps(world) == 360) wfRemoveBodyFromWorld(world, wfBodyAt(world, 1));
}

static const wfScene row[] = {
    { .category = "Sleep", .name = "islands", .chapter = "joints-in-a-world",
      .text = "Stacks fall asleep. After 7 s a ball is kicked off its shelf. Who wakes?",
      .define = sleeping, .build = build_islands, .update = kick_the_last,
      VIEW(0, 2.6, 9), SHAPE(1.65),
      .show = WF_SHOW_ISLANDS, PROMISE(-1, 0.2) },
    { .category = "Sleep", .name = "support removed", .chapter = "joints-in-a-world",
      .text = "All sleep; after 6 s the plank under them is gone. Nobody may hang in the air.",
      .define = sleeping, .build = build_support, .update = take_the_plank, VIEW(0, 3, 9),
      .show = WF_SHOW_ISLANDS, PROMISE(0.1, 0.2) },
};
const wfSceneGroup wfSleepScenes = { row, sizeof row / sizeof *row };
