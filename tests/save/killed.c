/* killed.c: saves a world that changes, again and again, until somebody kills it; or sees whether the file is whole.
 *   killed save PATH     never ends by itself; after each save that succeeded, prints the world's steps to stderr
 *   killed check PATH    0: a world that keeps its rules; its steps are printed */
#include <stdio.h>
#include <string.h>
#include "weft/weft.h"

static int save(const char *path)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    if (wfCreateWorld(&def, &world) != WF_OK) return 1;
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    wfMakeBox(50, 1, &d.shape);
    wfAddBodyToWorld(&world, &d, NULL);
    d.type = WF_DYNAMIC;
    wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape);
    for (int i = 0; i < 200; i++) {
        d.position = wfV2((wfReal)(i % 20), (wfReal)(2 + i / 20));
        wfAddBodyToWorld(&world, &d, NULL);
    }
    for (;;) {
        if (wfStepWorld(&world) != WF_OK) return 1;
        wfResult result = wfSaveToFile(&world, path);
        if (result != WF_OK) {
            fprintf(stderr, "killed: %s\n", wfResultText(result));
            return 1;
        }
        fprintf(stderr, "%llu\n", (unsigned long long)wfWorldSteps(&world));
    }
}

static int check(const char *path)
{
    wfWorld world;
    wfResult result = wfLoadFromFile(path, &world);
    if (result != WF_OK) {
        printf("%s: %s\n", path, wfResultText(result));
        return 1;
    }
    result = wfCheckWorld(&world, NULL);
    printf("%llu\n", (unsigned long long)wfWorldSteps(&world));
    wfDestroyWorld(&world);
    return result != WF_OK;
}

int main(int argc, char **argv)
{
    if (argc == 3 && strcmp(argv[1], "save") == 0) return save(argv[2]);
    if (argc == 3 && strcmp(argv[1], "check") == 0) return check(argv[2]);
    fprintf(stderr, "killed: save PATH, or check PATH\n");
    return 2;
}
