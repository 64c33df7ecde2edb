/* Sleep in a world: a sensor that stands still and is put onto a sleeper lets it sleep, whether it is moved there, made there, or one of two
 * shapes that are put there; it tells of the sleeper when that wakes. A solid shape that is put there wakes it. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

static wfWorld crate_asleep(wfBodyId *crate)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = 8, def.shapeCapacity = 16, def.sleep = 1, def.events = 1;
    wfWorld w = { .memory = { .owned = 0 } };
    assert_ok(wfCreateWorld(&def, &w));
    add(&w, floor_def());
    wfBodyDef d = ball_def(0, 0.5, 0.5);
    assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape));
    *crate = add(&w, d);
    for (int i = 0; i < 300; i++) assert_ok(wfStepWorld(&w));
    assert_false(wfBodyIsAwake(&w, *crate));
    return w;
}

static wfBodyId wall(wfWorld *w, double y, bool sensor)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC, d.position = wfV2(0, (wfReal)y);
    wfBodyId id = add(w, d);
    wfShapeDef shape = wfDefaultShapeDef();
    assert_ok(wfMakeBox(1, 1, &shape.shape));
    shape.sensor = sensor;
    assert_ok(wfAddShapeToBody(w, id, &shape, NULL));
    return id;
}

static int32_t told(const wfWorld *w, int kind)
{
    int32_t count;
    wfWorldEvents(w, kind, &count);
    return count;
}

static void a_sensor_put_onto_a_sleeper_lets_it_sleep(void **state)
{
    (void)state;
    for (int how = 0; how < 6; how++) {
        wfBodyId crate;
        wfWorld w = crate_asleep(&crate);
        bool sensor = how < 3;
        wfBodyId id = wall(&w, how % 3 == 1 ? 1 : 50, sensor);          /* made there */
        if (how % 3 == 2) {                                             /* two shapes */
            wfShapeDef second = wfDefaultShapeDef();
            assert_ok(wfMakeCircle(wfV2(0, 0), 1, &second.shape));
            second.sensor = sensor;
            assert_ok(wfAddShapeToBody(&w, id, &second, NULL));
        }
        if (how % 3 != 1) assert_ok(wfSetBodyTransform(&w, id, wfV2(0, 1), 0));
        assert_int_equal(wfBodyIsAwake(&w, crate), !sensor);
        for (int i = 0; sensor && i < 60; i++) {
            assert_ok(wfStepWorld(&w));
            assert_false(wfBodyIsAwake(&w, crate));
        }
        if (sensor) {
            assert_ok(wfWakeBody(&w, crate));
            assert_ok(wfStepWorld(&w));
            assert_int_equal(told(&w, WF_SENSOR_BEGIN), how == 2 ? 2 : 1);
        }
        wfDestroyWorld(&w);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(a_sensor_put_onto_a_sleeper_lets_it_sleep) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
