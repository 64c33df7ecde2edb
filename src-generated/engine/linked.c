/* Weft: engine/linked.c, tangled from chapters/methods/27-continuous-collision.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/step.h"
#include "engine/joints.h"

/* Contacts of the last step by which movable bodies pressed each other. */
static void find_pressed(struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    for (int32_t n = head->kept.contacts; n < head->contactCount; n++) {
        const wfContact *c = &s->b.contacts[n];
        wfReal sum = 0;
        if (!wfCanMove(&s->state[c->a]) || !wfCanMove(&s->state[c->b])) continue;
        for (int32_t i = 0; i < c->manifold.count; i++)
            sum += c->manifold.points[i].normalImpulse;
        if (sum > 0) s->linked[c->a] = s->linked[c->b] = WF_PRESSED_WAY;
    }
}

/* find bodies with joints */
static void find_jointed(struct wfStep *s)
{
    wfJoints j = wfJointsOf(&s->b);
    const wfHeader *head = s->b.head;
    if (head->jointSlots.count == 0 || head->directJoints == WF_JOINTS_ITERATIVE) return;
    for (int32_t i = 0; i < head->jointSlots.high; i++) {
        if (!wfJointIsLive(&j, i) || (j.joints[i].flags & WF_JOINT_BROKEN)) continue;
        if (!wfJointTable[j.joints[i].kind].holds) continue;
        const int32_t ends[2] = { j.joints[i].a, j.joints[i].b };
        for (int k = 0; k < 2; k++)
            if (ends[k] >= 0 && wfCanMove(&s->state[ends[k]]))
                s->linked[ends[k]] = WF_LINKED_WAY;
    }
}

void wfFindLinked(struct wfStep *s)
{
    if (s->b.head->maxImpacts == 0 || !s->integrates) return;
    s->linked = wfTransient(&s->b, WF_REGION_LINKED);
    memset(s->linked, 0, (size_t)s->count);
    find_pressed(s);
    /* note bodies with joints */
    find_jointed(s);
}
