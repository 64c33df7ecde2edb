/* needs: shapes */
/* A box of 2 m by 4 m at 3 kg/m^2: 24 kg, and m (w^2 + h^2) / 12. */
#include "part.h"

PART(shapes)
{
    wfShape box;
    wfMassData mass;
    OK(wfMakeBox(1, 2, &box));
    OK(wfShapeMass(&box, 3, &mass));
    NEAR(mass.mass, 24, 1e-4);
    NEAR(mass.inertia, 40, 1e-3);
    CHECK(wfMakeBox(0, 1, &box) != WF_OK);
    return 0;
}
