/* needs: nothing */
/* A least program: a world of particles under gravity, without libc but for what a machine must have. It is linked with the least
   engine to see how large that is, and run to see that it falls as it should. */
#include "weft/weft.h"

static uint64_t permanent[8192], transient[8192];

int least(void);
int least(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ball = wfDefaultBodyDef();
    wfBodyId id;
    wfBodyInfo info;
    def.bodyCapacity = 16;
    def.memory = (wfMemory){ .permanent = permanent, .permanentSize = sizeof permanent,
                             .transient = transient, .transientSize = sizeof transient };
    ball.mass = 1;
    ball.position = wfV2(0, 100);
    if (wfCreateWorld(&def, &world) != WF_OK) return 1;
    if (wfAddBodyToWorld(&world, &ball, &id) != WF_OK) return 2;
    for (int i = 0; i < 60; i++)
        if (wfStepWorld(&world) != WF_OK) return 3;
    if (wfGetBody(&world, id, &info) != WF_OK) return 4;
    wfReal off = info.position.y - (100 - WF_R(9.81) / 2);      /* Galileo's g t^2 / 2 */
    return off < WF_R(1e-3) && off > WF_R(-1e-3) ? 0 : 5;
}
