/* Weft: engine/wake.c, tangled from chapters/methods/05-joints-in-a-world.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "engine/rest.h"
#include "engine/joints.h"

/* rouse sleepers */
void wfRouseIsland(wfBlock *b, const wfRest *r, int32_t i)
{
    while (wfIsAsleep(r, i)) {
        int32_t next = r->ring[i];
        r->flags[i] &= WF_REST_NEVER;
        r->clock[i] = 0;
        r->ring[i] = -1;
        b->head->asleep--;
        i = next;
    }
    b->head->roused = 1;
}

void wfRouse(wfBlock *b, int32_t i)
{
    wfRest r = wfRestOf(b);
    if (r.clock != NULL && i >= 0) r.clock[i] = 0;
    if (b->head->asleep == 0) return;
    if (i < 0)
        for (int32_t k = 0; k < b->head->bodySlots.high; k++) wfRouseIsland(b, &r, k);
    else if (wfIsAsleep(&r, i))
        wfRouseIsland(b, &r, i);
    else if (b->props[i].type != WF_DYNAMIC) {
        for (int32_t k = 0; k < b->head->kept.contacts; k++) {
            const wfContact *c = &b->contacts[k];
            if (c->a == i || c->b == i) wfRouseIsland(b, &r, c->a == i ? c->b : c->a);
        }
        /* by joints and forces, where there are any */
        wfRouseJoined(b, i);
        for (int32_t k = 0; k < b->head->forceSlots.high; k++) {
            const wfForce *f = &b->forces[k];
            if (b->forceSlots[k].next != WF_SLOT_LIVE || (f->a != i && f->b != i)) continue;
            int32_t other = f->a == i ? f->b : f->a;
            if (other < 0 ? f->b == i : wfIsAsleep(&r, other)) wfRouse(b, other);
        }
    }
}

void wfRouseJoined(wfBlock *b, int32_t body)
{
    wfJoints j = wfJointsOf(b);
    for (int32_t i = 0; i < b->head->jointSlots.high; i++) {
        if (!wfJointIsLive(&j, i)) continue;
        int32_t one = j.joints[i].a, two = j.joints[i].b;
        if (one == body && wfSleeps(b, two)) wfRouse(b, two);
        if (two == body && wfSleeps(b, one)) wfRouse(b, one);
    }
}

void wfRouseNear(wfBlock *b, int32_t k)
{
    wfRest r = wfRestOf(b);
    int32_t i = b->owners[k];
    if (b->head->asleep == 0) return;
    b->head->roused = 1;
    if (i < 0 || b->props[i].type == WF_DYNAMIC) return;
    for (int32_t q = 0; q < b->head->shapeSlots.high; q++) {
        int32_t other = b->owners[q];
        if (other < 0 || !wfIsAsleep(&r, other)) continue;
        if (wfRectOverlap(b->bounds[k], b->bounds[q])) wfRouseIsland(b, &r, other);
    }
}

bool wfSleeps(const wfBlock *b, int32_t i)
{
    wfRest r = wfRestOf(b);
    return wfIsAsleep(&r, i);
}

void wfBeginRest(wfBlock *b, int32_t i, int32_t never)
{
    wfRest r = wfRestOf(b);
    if (r.flags == NULL) return;
    r.flags[i] = never ? WF_REST_NEVER : 0;
    r.clock[i] = 0;
    r.ring[i] = r.island[i] = -1;
}
