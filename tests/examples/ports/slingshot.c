/* Rocks on an elastic, let go at two pyramids of bricks: Matter.js's example "Slingshot", 100 px = 1 m, y up.
 * Checked: a rock leaves with the speed of its elastic's energy and flies a parabola; bricks of the pyramid that it is aimed at fall. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

static wfWorld world;
static const wfVec2 anchor = WF_V2(1.7f, 1.25f);
static void must(int ok, const char *what) { if (!ok) { printf("slingshot: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add(int type, wfVec2 at, float density, float w, float h)     /* a box; with h = 0 the rock */
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    wfVec2 corner[8];
    for (int i = 0; i < 8; i++) corner[i] = wfRotate(wfRotation((float)i * WF_PI / 4), wfV2(w, 0));
    must((h > 0 ? wfMakeBox(w / 2, h / 2, &def.shape) : wfMakePolygon(corner, 8, &def.shape)) == WF_OK, "a shape");
    def.type = type;
    def.position = at;
    def.density = density;
    def.friction = 0.3f;
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a body");
    return id;
}

typedef struct Brick { wfBodyId id; wfVec2 home; } Brick;
static void pyramid(Brick *brick, float foot, int columns)
{
    for (int row = 0, n = columns; n > 0; row++, n -= 2)
        for (int i = 0; i < n; i++, brick++) {
            brick->home = wfV2(6.125f + 0.125f * (float)(2 * i - n + 1), foot + 0.4f * (float)row + 0.2f);
            brick->id = add(WF_DYNAMIC, brick->home, 10, 0.25f, 0.4f);
        }
}

static int displaced(const Brick *brick, int n)      /* by more than half of a brick's width */
{
    wfBodyInfo info;
    int count = 0;
    for (int i = 0; i < n; i++) 
        count += wfGetBody(&world, brick[i].id, &info) == WF_OK && wfDistance(info.position, brick[i].home) > 0.125f;
    return count;
}

static wfBodyInfo step(wfBodyId id)
{
    wfBodyInfo info;
    must(wfStepWorld(&world) == WF_OK && wfGetBody(&world, id, &info) == WF_OK, "a step");
    return info;
}

static void shoot(wfVec2 pull, const char *name)
{
    wfBodyId rock = add(WF_DYNAMIC, wfAdd(anchor, pull), 40, 0.2f, 0);
    wfForce elastic = wfSpringToPoint(wfBodyIndex(&world, rock), wfV2(0, 0), anchor, 0, 900, 0);
    wfForceId held;
    must(wfAddForceToWorld(&world, &elastic, &held) == WF_OK, "the elastic");
    wfBodyInfo now = step(rock);
    while (now.position.x < anchor.x + 0.2f) now = step(rock);
    must(wfRemoveForceFromWorld(&world, held) == WF_OK, "let go");
    wfBodyInfo free = now;
    float left = wfLengthSq(wfSub(free.position, anchor)), high = free.position.y - anchor.y - pull.y, t = 0;
    float speed = sqrtf(900 / free.mass * (wfLengthSq(pull) - left) - 2 * 9.81f * high);
    /* A step is w dt = 0.24 of the swing: (w dt)^2 / 3. */
    must(fabsf(wfLength(free.velocity) / speed - 1) < 0.02f, "another speed than that of the energy");
    for (now = step(rock); now.position.x < 4.6f; now = step(rock)) {      /* nothing is in the way so far */
        t += 1.0f / 60;
        wfVec2 parabola = wfAdd(free.position, wfAdd(wfScale(t, free.velocity), wfV2(0, -9.81f * t * t / 2)));
        /* The velocity may be half a step of gravity off. */
        must(t < 1 && wfLength(wfSub(now.position, parabola)) < 9.81f / 60 * t / 2, "no parabola");
    }
    printf("slingshot: at the %s pyramid with %.2f m/s, by the energy %.2f m/s\n", name, wfLength(free.velocity), speed);
    for (int i = 0; i < 60; i++) step(rock);
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    Brick low[25], high[9];
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    add(WF_STATIC, wfV2(3.95f, -0.25f), 1, 8.15f, 0.5f);
    add(WF_STATIC, wfV2(6.1f, 3.25f), 1, 2, 0.2f);
    pyramid(low, 0, 9);
    pyramid(high, 3.35f, 5);
    for (int i = 0; i < 60; i++) must(wfStepWorld(&world) == WF_OK, "a step");
    must(displaced(low, 25) + displaced(high, 9) == 0, "the pyramids do not stand");
    shoot(wfV2(-1, -0.15f), "low");
    int hit = displaced(low, 25);
    must(hit > 0 && displaced(high, 9) == 0, "the low pyramid is not hit alone");
    shoot(wfV2(-0.7f, -0.7f), "high");
    must(displaced(high, 9) > 0, "the high pyramid is not hit");
    printf("slingshot: %d bricks of 25 and %d of 9 displaced\n", hit, displaced(high, 9));
    return wfDestroyWorld(&world);
}
