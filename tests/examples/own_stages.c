/* Uses the rows of 62-own-stages.nw: by their names, like any other. */
#include <stdio.h>
#include <weft/weft.h>

static uint64_t drop_crates(const char *broadPhase, const char *solver, double *lowest)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.advanced.broadPhase = wfFindBroadPhase(broadPhase);
    def.solver = wfFindSolver(solver);
    def.jointCapacity = 0;                  /* this solver keeps contacts only */
    wfWorld world;
    if (wfCreateWorld(&def, &world) != WF_OK) return 0;
    wfBodyDef body = wfDefaultBodyDef();
    wfMakeBox(20, 1, &body.shape);
    body.type = WF_STATIC;
    body.position = wfV2(0, -1);
    wfAddBodyToWorld(&world, &body, NULL);
    body.type = WF_DYNAMIC;
    wfMakeBox(WF_R(0.5), WF_R(0.5), &body.shape);
    for (int i = 0; i < 9; i++) {
        body.position = wfV2((wfReal)(2 * i - 8), (wfReal)(2 + i));
        wfAddBodyToWorld(&world, &body, NULL);
    }
    for (int step = 0; step < 300; step++) wfStepWorld(&world);
    *lowest = 9;
    for (int32_t i = 1; i < wfWorldBodies(&world).count; i++) {
        double y = (double)wfWorldBodies(&world).state[i].p.y;
        if (y < *lowest) *lowest = y;
    }
    uint64_t hash = wfHashWorld(&world);
    wfDestroyWorld(&world);
    return hash;
}

int main(void)
{
    double low, other;
    uint64_t mine = drop_crates("queue", "once", &low);
    uint64_t brute = drop_crates("brute-force", "once", &other);
    bool same = mine == brute && mine != 0;
    printf("the queue finds what brute force finds: %s\n", same ? "yes" : "no");
    printf("crates of 1 m rest %.2f m above the floor\n", low);
    return 0;
}
/* prints:
the queue finds what brute force finds: yes
crates of 1 m rest 0.50 m above the floor
*/
