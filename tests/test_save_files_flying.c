/* What flies through sensors, in random worlds: see chapter continuous-collision; here, since a world that was stepped is checked. */
#include "testing.h"
#include "world.h"
#include "shapes.h"
#include "motion.h"
#include "weft/save.h"
#include "weft/weft.h"

static int32_t between(wfRandom *r, int32_t least, int32_t most) { return least + (int32_t)wfRandomBelow(r, (uint32_t)(most - least + 1)); }

/* Worlds with little room and with much, of shapes of all kinds, solid and sensors, anywhere on bodies of any type, slow or fast, turning or
 * not: a step is made, or is told to lack room; nobody leaves a sensor who did not come; the world keeps its rules. */
TEST(segments_and_sensors_fly_anywhere)
{
    wfRandom r = random_stream(17);
    long made = 0;
    for (int n = 0; n < 1000; n++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = between(&r, 1, 16), def.shapeCapacity = def.bodyCapacity * between(&r, 1, 8);
        def.advanced.pairCapacity = between(&r, 1, n % 3 ? 400 : 4), def.advanced.contactCapacity = between(&r, 1, n % 2 ? 300 : 4);
        def.solver = n % wfSolverCount, def.advanced.broadPhase = n / 2 % wfBroadPhaseCount, def.sleep = n % 5 == 0;
        def.timeStep = 1 / wfRandomReal(&r, 30, 480);
        if (n % 4 == 0) def.gravity = wfV2(0, 0);
        wfWorld w = world_with(&def);
        for (int i = 0; i < def.bodyCapacity; i++) {
            wfBodyDef body = wfDefaultBodyDef();
            wfReal pace = i % 3 ? wfExp(wfRandomReal(&r, 0, 9)) : 0;
            wfBodyId id;
            body.type = between(&r, 0, 2), body.position = random_v2(&r, -9, 9);
            if (body.type == WF_STATIC) pace = 0;
            body.velocity = random_v2(&r, -pace, pace), body.angularVelocity = (wfReal)(i % 2) * pace / 9;
            body.shape = random_polygon(&r);
            assert_ok(wfAddBodyToWorld(&w, &body, &id));
            for (int k = def.shapeCapacity / def.bodyCapacity; k > 1; k--) {
                wfShapeDef s = wfDefaultShapeDef();
                s.sensor = between(&r, 0, 1);
                s.shape = random_shape(&r);
                if (k % 2) assert_ok(wfMakeSegment(wfV2(0, -wfRandomReal(&r, 0, 1)), wfV2(wfRandomReal(&r, 0, 1), wfRandomReal(&r, WF_R(0.01), 1)), &s.shape));
                assert_ok(wfAddShapeToBody(&w, id, &s, NULL));
            }
        }
        long inside = 0;
        for (int i = 0; i < 6; i++) {
            wfResult result = wfStepWorld(&w);
            int32_t come, gone;
            if (result == WF_ERROR_FULL) break;
            if (result != WF_OK) fail_msg("world %d, step %d: %s", n, i, wfResultText(result));
            made++;
            wfWorldEvents(&w, WF_SENSOR_BEGIN, &come), wfWorldEvents(&w, WF_SENSOR_END, &gone);
            inside += come - gone;
            assert_true(inside >= 0);
            assert_ok(wfCheckWorld(&w, NULL));
        }
        wfDestroyWorld(&w);
    }
    assert_true(made > 2000);
}
