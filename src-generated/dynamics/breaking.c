/* Weft: dynamics/breaking.c, tangled from chapters/methods/13-more-joints.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "dynamics/breaking.h"

/* How much too much a joint bore: its load by its strength, 0 if it is strong enough. */
static wfReal overload(const wfJoint *j)
{
    wfReal force = wfLength(j->load), torque = wfAbs(j->twist), most = 0;
    if (j->breakForce > 0 && force > j->breakForce) most = force / j->breakForce;
    if (j->breakTorque > 0 && torque > j->breakTorque)
        most = wfMaxR(most, torque / j->breakTorque);
    return most;
}

static wfReal *overload_of(const wfJointSet *set, int32_t body)
{
    return set->inverse[body] > 0 ? &set->stiffness[body] : NULL;
}

static void note_overload(const wfJointSet *set, int32_t body, wfReal over)
{
    wfReal *most = overload_of(set, body);
    if (most != NULL) *most = wfMaxR(*most, over);
}

void wfBreakWorst(wfJointSet *set)
{
    for (int32_t i = 0; i < set->bodies; i++) set->stiffness[i] = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int32_t i = 0; i < set->count; i++) {
            wfJoint *j = &set->joints[i];
            wfReal over = (j->flags & WF_JOINT_BROKEN) ? 0 : overload(j);
            const wfReal *a = overload_of(set, j->a), *b = overload_of(set, j->b);
            if (!(over > 0)) continue;
            if (pass == 0) note_overload(set, j->a, over), note_overload(set, j->b, over);
            if (pass == 0 || (a != NULL && *a > over) || (b != NULL && *b > over)) continue;
            j->flags |= WF_JOINT_BROKEN;
            memset(j->impulse, 0, sizeof j->impulse);
        }
}
