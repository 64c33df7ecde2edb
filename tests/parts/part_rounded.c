/* needs: rounded */
/* A capsule weighs a rectangle and two half discs; a coat needs the part, and is refused where it should not be. */
#include "part.h"

PART(rounded)
{
    wfShape s;
    OK(wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.5), &s));
    NEAR(wfShapeArea(&s), 2 + 3.14159265 / 4, 1e-5);
    OK(wfCheckShape(&s));
    OK(wfMakeRoundedBox(1, 1, WF_R(0.5), &s));
    NEAR(wfShapeArea(&s), 4 + 4 + 3.14159265 / 4, 1e-5);
    OK(wfMakeSegment(wfV2(0, 0), wfV2(1, 0), &s));
    s.radius = 1;
    CHECK(wfCheckShape(&s) != WF_OK);
    return 0;
}
