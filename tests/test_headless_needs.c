/* Needs of scenes: every row of the scene table is run in the world that it was written for, its needs are inferred,
 * and it is run again in a world that has these and no more. */
#include "testing.h"
#include "testbed/scene.h"

enum { STEPS = 240 };
static uint64_t hashes[STEPS];

static bool run_scene(const wfScene *s, wfWorld *world, int step)
{
    wfSceneInput in = wfSceneInputAt(s, step);
    return wfStepScene(s, world, &in) == WF_OK;
}

static size_t size_of(const wfWorld *w) { return w->memory.permanentSize + w->memory.transientSize; }

TEST(a_lean_world_has_the_same_bits)
{
    int leaner = 0;
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        wfWorld rich, lean;
        assert_ok(wfOpenScene(s, NULL, &rich));
        for (int k = 0; k < STEPS; k++) {
            assert_true(run_scene(s, &rich, k));
            hashes[k] = wfHashWorld(&rich);
        }
        wfWorldDef def;
        assert_ok(wfInferModules(&rich, (s->hooks != NULL ? WF_MODULE_HOOKS : 0) | s->asks, &def));
        assert_ok(wfCheckWorldDef(&def, NULL));
        assert_ok(wfCreateWorld(&def, &lean));
        wfResult result = s->build(&lean);
        if (result != WF_OK) fail_msg("%s: cannot be built: %s (needs %x)", s->name, wfResultText(result), (unsigned)def.modules);
        for (int k = 0; k < STEPS; k++) {
            wfSceneInput in = wfSceneInputAt(s, k);
            result = wfStepScene(s, &lean, &in);
            if (result != WF_OK) fail_msg("%s: step %d: %s (needs %x)", s->name, k, wfResultText(result), (unsigned)def.modules);
            if (wfHashWorld(&lean) != hashes[k]) fail_msg("%s: step %d has other bits (needs %x)", s->name, k, (unsigned)def.modules);
        }
        if (size_of(&lean) >= size_of(&rich)) fail_msg("%s: %zu bytes before, %zu now", s->name, size_of(&rich), size_of(&lean));
        if (2 * size_of(&lean) < size_of(&rich)) leaner++;
        wfDestroyWorld(&lean);
        wfDestroyWorld(&rich);
    }
    assert_true(2 * leaner > wfSceneCount());      /* most scenes take less than half of what they were given */
}
