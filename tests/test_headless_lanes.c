/* Every scene, several contacts at once: a twin takes its contacts one by one and must have the same bits. */
#include "testing.h"
#include "world.h"
#include "testbed/scene.h"

enum { STEPS = 60 };

static void assert_same_contacts(const wfScene *scene, const wfWorld *a, const wfWorld *b)
{
    int32_t n = 0, m = 0;
    const wfContact *one = wfWorldContacts(a, &n), *two = wfWorldContacts(b, &m);
    assert_int_equal(n, m);
    for (int32_t i = 0; i < n; i++)
        for (int32_t k = 0; k < one[i].manifold.count; k++)
            if (memcmp(&one[i].manifold.points[k], &two[i].manifold.points[k], offsetof(wfContactPoint, feature)) != 0)
                fail_msg("%s: point %d of contact %d differs", scene->name, (int)k, (int)i);
}

TEST(every_scene_has_the_same_bits_with_and_without)
{
    int wide = 0;
    for (int s = 0; s < wfSceneCount(); s++) {
        const wfScene *scene = wfSceneAt(s);
        wfWorld lanes, plain;
        wfWorldDef def;
        assert_ok(wfOpenScene(scene, NULL, &lanes));
        assert_ok(wfOpenScene(scene, NULL, &plain));
        assert_ok(wfGetWorldDef(&plain, &def));
        wide += def.advanced.enableSimd && def.advanced.graphColouring && def.solver == wfFindSolver("soft");
        def.advanced.enableSimd = 0;
        assert_ok(wfSetWorldDef(&plain, &def));
        for (int i = 0; i < STEPS; i++) {
            wfSceneInput in = wfSceneInputAt(scene, i);
            assert_ok(wfStepScene(scene, &lanes, &in));
            assert_ok(wfStepScene(scene, &plain, &in));
            if (wfHashWorld(&lanes) != wfHashWorld(&plain)) fail_msg("%s, step %d: another hash", scene->name, i);
        }
        assert_same_contacts(scene, &lanes, &plain);
        wfDestroyWorld(&lanes);
        wfDestroyWorld(&plain);
    }
    assert_true(wide > wfSceneCount() / 2);       /* or nothing was compared */
}
