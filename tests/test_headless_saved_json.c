/* What was saved can be loaded: every scene that is shipped, in files and in the table. At many moments of a run it keeps the rules
 * of a block, is saved, is loaded, and goes on as if nothing had been. Oracle: the world that was not saved.
 * (Random needs: test_save_and_replay.c.) */
#include "testing.h"
#include <dirent.h>
#include "weft/json.h"
#include "weft/save.h"
#include "testbed/scene.h"

enum { STEPS = 60, EVERY = 7 };

static void assert_same(const char *name, int i, const wfWorld *a, const wfWorld *b)
{
    wfDifference d;
    wfResult result = wfCompareWorlds(a, b, &d);
    if (result == WF_ERROR_DIFFERENT) fail_msg("%s, step %d: %s %d: %s (byte %zu): %.17g, %.17g", name, i, d.region, (int)d.element, d.field, d.byte, d.one, d.two);
    if (result != WF_OK || wfHashWorld(a) != wfHashWorld(b)) fail_msg("%s, step %d: %s, or another hash", name, i, wfResultName(result));
}

static void step(const wfScene *scene, wfWorld *world, int i)
{
    if (scene == NULL) {
        assert_ok(wfStepWorld(world));
        return;
    }
    wfSceneInput in = wfSceneInputAt(scene, i);
    assert_ok(wfStepScene(scene, world, &in));
}

/* scene NULL: a world that needs nobody's hand */
static void is_saved_and_loaded(const char *name, const wfScene *scene, wfWorld *world)
{
    wfFault fault;
    for (int i = 0; i < STEPS; i++) {
        wfWorld loaded = { .memory = { .owned = 0 } };
        if (wfCheckWorld(world, &fault) != WF_OK) fail_msg("%s, step %d: %s %d: %s", name, i, fault.region, (int)fault.element, fault.rule);
        if (i % EVERY == 0) {
            size_t size = wfSaveSize(world);
            void *bytes = malloc(size);
            assert_non_null(bytes);
            assert_ok(wfSaveToBytes(world, bytes, size, &size));
            wfResult result = wfLoadFromBytes(bytes, size, NULL, &loaded);
            if (result != WF_OK) fail_msg("%s, step %d: what was saved cannot be loaded: %s", name, i, wfResultName(result));
            free(bytes);
            assert_same(name, i, world, &loaded);
            step(scene, &loaded, i);
        }
        step(scene, world, i);
        if (loaded.memory.permanent != NULL) assert_same(name, i, world, &loaded);
        wfDestroyWorld(&loaded);
    }
    wfDestroyWorld(world);
}

TEST(every_scene_of_the_table)
{
    for (int i = 0; i < wfSceneCount(); i++) {
        wfWorld world;
        assert_ok(wfOpenScene(wfSceneAt(i), NULL, &world));
        is_saved_and_loaded(wfSceneAt(i)->name, wfSceneAt(i), &world);
    }
}

TEST(every_scene_in_a_file)
{
    static char text[1 << 16];
    int files = 0;
    DIR *folder = opendir("testbed/scenes");
    if (folder == NULL) fail_msg("no folder testbed/scenes: tests run in the root of the project");
    for (struct dirent *entry; (entry = readdir(folder)) != NULL;) {
        const char *end = strrchr(entry->d_name, '.');
        char path[400];
        wfWorld world;
        wfTextError error;
        if (end == NULL || strcmp(end, ".json") != 0 || strstr(entry->d_name, ".schema.") != NULL) continue;
        snprintf(path, sizeof path, "testbed/scenes/%s", entry->d_name);
        FILE *f = fopen(path, "rb");
        assert_non_null(f);
        size_t n = fread(text, 1, sizeof text, f);
        fclose(f);
        assert_true(n < sizeof text);
        if (wfReadScene(text, n, NULL, &world, NULL, &error) != WF_OK) fail_msg("%s: %s: %s", path, error.where, error.what);
        is_saved_and_loaded(path, NULL, &world);
        files++;
    }
    closedir(folder);
    assert_true(files >= 7);
}
