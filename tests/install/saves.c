/* saves.c: saves worlds of two sizes to one path, again and again, and loads what is there; others may do the same at the same time. What is
 * loaded is one of the two, whole. A path that is no file, or in no folder, is refused.   saves PATH ROUNDS */
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>
#include <weft/save.h>

enum { FEW = 3, MANY = 400 };

static wfResult make(int count, wfWorld *world)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = MANY;
    wfResult result = wfCreateWorld(&def, world);
    wfBodyDef ball = wfDefaultBodyDef();
    ball.type = WF_DYNAMIC;
    wfMakeCircle(wfV2(0, 0), 0.25f, &ball.shape);
    for (int i = 0; i < count && result == WF_OK; i++) {
        wfBodyId id;
        ball.position = wfV2((wfReal)i, 0);
        result = wfAddBodyToWorld(world, &ball, &id);
    }
    return result;
}

int main(int argc, char **argv)
{
    const char *path = argc > 1 ? argv[1] : "world.weft";
    int rounds = argc > 2 ? atoi(argv[2]) : 100;
    wfWorld world[2], got;
    if (make(FEW, &world[0]) != WF_OK || make(MANY, &world[1]) != WF_OK) return 1;
    for (int i = 0; i < rounds; i++) {
        wfResult result = wfSaveToFile(&world[i % 2], path);
        if (result != WF_OK) { printf("save %d: %s\n", i, wfResultText(result)); return 2; }
        result = wfLoadFromFile(path, &got);
        if (result != WF_OK) { printf("load %d: %s\n", i, wfResultText(result)); return 3; }
        uint64_t hash = wfHashWorld(&got);
        wfDestroyWorld(&got);
        if (hash != wfHashWorld(&world[0]) && hash != wfHashWorld(&world[1])) { printf("load %d is neither of the two\n", i); return 4; }
    }
    if (wfSaveToFile(&world[0], ".") == WF_OK || wfSaveToFile(&world[0], "no-such-folder/world.weft") == WF_OK) return 5;
    wfDestroyWorld(&world[0]);
    wfDestroyWorld(&world[1]);
    return 0;
}
