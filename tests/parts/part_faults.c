/* needs: faults */
/* The field, the value and what is allowed are told even of a particle. */
#include <string.h>
#include "part.h"

PART(faults)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 0);
    OK(wfCreateWorld(&def, &world));
    body.mass = -1;
    CHECK(wfAddBodyToWorld(&world, &body, NULL) == WF_ERROR_RANGE);
    CHECK(strcmp(wfLastFault(&world)->text, "wfAddBodyToWorld: def.mass is -1, must be >= 0") == 0);
    body.mass = 1;
    OK(wfAddBodyToWorld(&world, &body, NULL));
    CHECK(wfLastFault(&world)->result == WF_OK);
    wfDestroyWorld(&world);
    return 0;
}
