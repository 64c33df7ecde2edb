/* scenes.c: prints the hash of scenes after some steps, a line each: the program that tests/portability/run.sh builds for every
 * platform. It needs no file, no clock and no window.
 *   scenes STEPS [FIRST [COUNT]]        all scenes of the table, or COUNT, from row FIRST on (0 is the first)
 * The exit status is 0 if every scene could be run. */
#include <stdio.h>
#include <stdlib.h>
#include "testbed/scene.h"

int main(int argc, char **argv)
{
    int steps = argc > 1 ? atoi(argv[1]) : 0, first = argc > 2 ? atoi(argv[2]) : 0;
    int count = argc > 3 ? atoi(argv[3]) : wfSceneCount();
    if (steps < 1 || first < 0 || count < 1) {
        fputs("use: scenes STEPS [FIRST [COUNT]]\n", stderr);
        return 2;
    }
    for (int i = first; i < wfSceneCount() && i - first < count; i++) {
        wfSceneReport r = wfWatchScene(wfSceneAt(i), steps);
        /* the hash in halves: not every C library prints 64 bits in the same way */
        printf("%s,%d,%08lx%08lx%s\n", wfSceneAt(i)->name, (int)r.steps, (unsigned long)(r.hash >> 32),
               (unsigned long)(r.hash & 0xffffffffu), r.result == WF_OK ? "" : ",failed");
        fflush(stdout);
    }
    return 0;
}
