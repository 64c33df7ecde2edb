/* A student's module and setting are in a world, in a save of it, and in its text. */
#include <stdio.h>
#include <string.h>
#include "weft/weft.h"

int main(int argc, char **argv)
{
    if (argc < 2) return 1;
    wfWorldDef def = wfDefaultWorldDef(), kept;
    wfWorld world, again;
    if (def.bumperForce != 2 || !(def.modules & WF_MODULE_BUMPERS)) return 2;
    def.bumperForce = 3;
    if (wfCreateWorld(&def, &world) != WF_OK) return 3;
    if (wfSaveToFile(&world, argv[1]) != WF_OK || wfLoadFromFile(argv[1], &again) != WF_OK) return 4;
    if (wfGetWorldDef(&again, &kept) != WF_OK || kept.bumperForce != 3) return 5;
    if (wfHashWorld(&world) != wfHashWorld(&again)) return 6;
    wfDestroyWorld(&again);
    wfDestroyWorld(&world);
    def.bumperForce = 0;
    return wfCreateWorld(&def, &world) == WF_ERROR_RANGE ? 0 : 7;
}
