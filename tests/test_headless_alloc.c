/* Every scene: once it is open, nothing is allocated any more. */
#include "testing.h"
#include "own_malloc.h"
#include "testbed/scene.h"

TEST(no_scene_allocates)
{
    if (!OWN_MALLOC) skip();
    for (int s = 0; s < wfSceneCount(); s++) {
        wfWorld world;
        const wfScene *scene = wfSceneAt(s);
        size_t before = calls;
        assert_ok(wfOpenScene(scene, NULL, &world));
        assert_int_equal(calls, before + 2);            /* the two chunks */
        for (int i = 0; i < 120; i++) {
            wfSceneInput in = wfSceneInputAt(scene, i);
            assert_ok(wfStepScene(scene, &world, &in));
        }
        if (calls != before + 2) fail_msg("%s allocates while it runs", scene->name);
        wfDestroyWorld(&world);
    }
    fail_at = 0;
    assert_true(live < 1000);
}
