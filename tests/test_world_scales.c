/* A world does not know how long a metre is. If all lengths and the pull of gravity are multiplied by a power of
   two, which is exact, every body must be where it was, times that power, after every step, to the last bit. What a user
   sets in metres or metres per second is multiplied too; nothing else in the engine may be. */
#include "testing.h"
#include "weft/weft.h"

enum { BODIES = 16, KINDS = 3, STEPS = 240 };

static void add(wfWorld *world, wfBodyDef *def, int type, wfVec2 at, double angle, wfBodyId *id)
{
    def->type = type;
    def->position = at;
    def->angle = (wfReal)angle;
    assert_ok(wfAddBodyToWorld(world, def, id));
}

/* 0: boxes fall into a heap; 1: balls and capsules roll; 2: bodies of two shapes on a smooth chain */
static void build(wfWorld *world, wfReal k, int kind, wfBodyId *id)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, -10 * k);
    assert_ok(wfCreateWorld(&def, world));
    wfBodyDef ground = wfDefaultBodyDef();
    if (kind == 2) {
        wfVec2 points[5];
        wfShape links[4];
        int count;
        for (int i = 0; i < 5; i++) points[i] = wfV2((wfReal)(20 - 10 * i) * k, (wfReal)(i % 2) * k);
        assert_ok(wfMakeChain(points, 5, false, links, 4, &count));
        ground.shape = links[0];
        add(world, &ground, WF_STATIC, wfV2(0, 0), 0, &id[0]);
        for (int i = 1; i < count; i++) {
            wfShapeDef more = wfDefaultShapeDef();
            wfShapeId shape;
            more.shape = links[i];
            assert_ok(wfAddShapeToBody(world, id[0], &more, &shape));
        }
    } else {
        assert_ok(wfMakeBox(20 * k, k, &ground.shape));
        add(world, &ground, WF_STATIC, wfV2(0, -k), 0, &id[0]);
    }
    for (int i = 1; i < BODIES; i++) {
        wfBodyDef b = wfDefaultBodyDef();
        if (kind == 1 && i % 2) assert_ok(wfMakeCircle(wfV2(0, 0), k / 2, &b.shape));
        else if (kind == 1) assert_ok(wfMakeCapsule(wfV2(-k / 2, 0), wfV2(k / 2, 0), k / 4, &b.shape));
        else assert_ok(wfMakeBox(k / 2, k / 4, &b.shape));
        wfVec2 at = wfV2((wfReal)(0.4 * (i % 4)) * k, (wfReal)(1.5 + 1.1 * i) * k);
        add(world, &b, WF_DYNAMIC, at, 0.3 * i, &id[i]);
        if (kind == 2) {
            wfShapeDef ear = wfDefaultShapeDef();
            wfShapeId shape;
            assert_ok(wfMakeCircle(wfV2(k / 2, k / 4), k / 4, &ear.shape));
            assert_ok(wfAddShapeToBody(world, id[i], &ear, &shape));
        }
    }
}

TEST(a_world_has_no_metre)
{
    for (int kind = 0; kind < KINDS; kind++)
        for (int power = -9; power <= 9; power += 18) {
            wfReal k = (wfReal)ldexp(1, power);
            wfWorld one, other;
            wfBodyId here[BODIES], there[BODIES];
            double way = 0;
            build(&one, 1, kind, here);
            build(&other, k, kind, there);
            for (int step = 0; step < STEPS; step++) {
                assert_ok(wfStepWorld(&one));
                assert_ok(wfStepWorld(&other));
                for (int i = 0; i < BODIES; i++) {
                    wfBodyInfo a, b;
                    assert_ok(wfGetBody(&one, here[i], &a));
                    assert_ok(wfGetBody(&other, there[i], &b));
                    if (k * a.position.x != b.position.x || k * a.position.y != b.position.y || a.angle != b.angle)
                        fail_msg("world %d, 2^%d times as large: body %d has gone elsewhere in step %d", kind, power, i, step);
                    way += fabs((double)a.velocity.y);
                }
            }
            assert_true(way > 100);                     /* something happened */
            wfDestroyWorld(&one);
            wfDestroyWorld(&other);
        }
}
