/* needs: energy */
/* What falls freely keeps the sum of its energies: m v^2 / 2 + m g y. */
#include "part.h"

PART(energy)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = part_particle(0, 10);
    double kinetic, potential;
    OK(wfCreateWorld(&def, &world));
    OK(wfAddBodyToWorld(&world, &body, NULL));
    CHECK(part_steps(&world, 60) == 0);
    OK(wfWorldEnergy(&world, &kinetic, &potential));
    NEAR(kinetic, 9.81 * 9.81 / 2, 1e-2);
    NEAR(kinetic + potential, 98.1, 1e-2);
    wfDestroyWorld(&world);
    return 0;
}
