/* ends.c: prints the hash of each world of tests/ends.h (settings at the ends of their ranges, one by one and in pairs) after some steps,
 * a line each: the second program that tests/portability/run.sh builds for every platform.
 *   ends STEPS [FIRST [COUNT]]
 * A world that cannot be made, filled or stepped has the number of the steps that it made, and a hash with the result in it. */
#include <limits.h>
#include <stdlib.h>
#include "ends.h"

int main(int argc, char **argv)
{
    int steps = argc > 1 ? atoi(argv[1]) : 0, first = argc > 2 ? atoi(argv[2]) : 0;
    int count = argc > 3 ? atoi(argv[3]) : INT_MAX;
    if (steps < 1 || first < 0 || count < 1) {
        fputs("use: ends STEPS [FIRST [COUNT]]\n", stderr);
        return 2;
    }
    EndsNext next = { 0 };
    wfWorldDef def;
    char name[200];
    for (int i = 0; ends_next(&next, &def, name, sizeof name); i++) {
        if (i < first || i - first >= count) continue;
        wfWorld world;
        int made = 0;
        uint64_t hash = 0;
        wfResult result = wfCreateWorld(&def, &world);
        if (result == WF_OK) {
            result = ends_fill(&world);
            while (result == WF_OK && made < steps && (result = wfStepWorld(&world)) == WF_OK) made++;
            hash = wfHashWorld(&world);
            wfDestroyWorld(&world);
        }
        hash = wfHashU32(hash, (uint32_t)result);
        printf("%s,%d,%08lx%08lx\n", name, made, (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
        fflush(stdout);
    }
    return next.pair > ENDS_PAIRS ? 0 : 1;
}
