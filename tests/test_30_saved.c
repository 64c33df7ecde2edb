/* Chapter 26: the rules of a block. Oracles: every scene keeps them at every step; every rule, broken by hand, is named. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"
#include "testbed/scene.h"

static void every_scene_keeps_the_rules(void **unused)
{
    (void)unused;
    for (int s = 0; s < wfSceneCount; s++) {
        wfWorld world;
        wfFault fault;
        assert_ok(wfOpenScene(&wfSceneTable[s], NULL, &world));
        for (int i = 0; i < 90; i++) {
            wfResult result = wfCheckWorld(&world, &fault);
            if (result != WF_OK) print_error("scene %s, step %d: %s %d: %s (%s)\n", wfSceneTable[s].name, i, fault.region, fault.element, fault.rule, wfResultName(result));
            assert_int_equal(result, WF_OK);
            wfSceneInput in = wfSceneInputAt(&wfSceneTable[s], i);
            assert_ok(wfStepScene(&wfSceneTable[s], &world, &in));
        }
        wfDestroyWorld(&world);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scene_keeps_the_rules),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
