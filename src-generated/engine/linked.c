/* Weft: engine/linked.c, tangled from chapters/methods/27-continuous-collision.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/joints.h"
#include "engine/step.h"

void wfFindLinked(struct wfStep *s)
{
    wfJoints j = wfJointsOf(&s->b);
    const wfHeader *head = s->b.head;
    if (head->jointSlots.count == 0 || head->maxImpacts == 0 || !wfSolverIntegrates(s))
        return;
    if (head->directJoints == WF_JOINTS_ITERATIVE) return;
    s->linked = wfTransient(&s->b, WF_REGION_LINKED);
    memset(s->linked, 0, (size_t)s->count);
    for (int32_t i = 0; i < head->jointSlots.high; i++) {
        if (!wfJointIsLive(&j, i) || (j.joints[i].flags & WF_JOINT_BROKEN)) continue;
        if (!wfJointTable[j.joints[i].kind].holds) continue;
        const int32_t ends[2] = { j.joints[i].a, j.joints[i].b };
        for (int k = 0; k < 2; k++)
            if (ends[k] >= 0 && wfCanMove(&s->state[ends[k]])) s->linked[ends[k]] = 1;
    }
}
