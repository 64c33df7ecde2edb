/* A program in the names of the last release: it compiles and steps with weft/old_names.h. */
#define WF_OLD_FIELDS
#include <stdio.h>
#include <weft/weft.h>
#include <weft/old_names.h>

static void settled(void *context, const wfHookView *view, const wfContact *contact, wfContactChange *change)
{
    (void)context, (void)contact;
    if (view->dt > 0) change->rolling = 0;
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.dt = 1 / (wfReal)64, def.restingSteps = 2, def.columns = 0, def.exactJoints = WF_JOINTS_ONE_BY_ONE, def.impacts = 8;
    def.slop = def.positionShare = 0, def.advanced.contactPeriod = 8;
    if (def.contactPeriod != 8 || def.advanced.slop != 0 || def.advanced.restitutionThreshold != 2) return 7;
    def.needs = wfAllNeeds() & ~(uint32_t)WF_NEED_SLEEP;
    wfWorld world;
    if (wfCreateWorld(&def, &world) != WF_OK) return 1;
    wfBodyDef body = wfDefaultBodyDef();
    body.mass = 1;
    wfBodyId a, b;
    wfForceId hand;
    wfJoint joint;
    wfHooks hooks = { .preSolve = settled };
    if (wfMakeCircle(wfV2(0, 0), 1, &body.shape) != WF_OK || wfAddBodyToWorld(&world, &body, &a) != WF_OK) return 2;
    body.position = wfV2(9, 0);
    if (wfAddBodyToWorld(&world, &body, &b) != WF_OK) return 3;
    if (wfJoinBodies(&world, "revolute", a, b, wfV2(4, 0), wfV2(4, 0), wfV2(1, 0), &joint) != WF_OK || wfGrabBody(&world, a, wfV2(0, 0), &hand) != WF_OK) return 4;
    if (wfStepWorldWith(&world, &hooks) != WF_OK || !wfIsAwake(&world, a)) return 5;
    int32_t touches, hits;
    const wfTouchEvent *event = wfWorldEvents(&world, WF_TOUCH_BEGIN, &touches);
    const wfHit *hit = wfWorldHits(&world, &hits);
    wfFar origin;
    (void)event, (void)hit;
    if (wfToFar(&world, wfV2(0, 0), &origin) != WF_OK || touches != 0 || hits != 0) return 6;
    printf("%.6f\n", wfWorldTime(&world));
    wfDestroyWorld(&world);
    return 0;
}
