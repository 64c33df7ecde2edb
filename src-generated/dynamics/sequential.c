/* Weft: dynamics/sequential.c, tangled from chapters/engine/16-sequential.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "dynamics/prepared.h"

/* the passes of sequential impulses */
static void push_contact(const wfSolve *in, wfPrepared *c, wfPairMotion *m, wfReal share,
                         wfReal slop)
{
    for (int32_t i = 0; i < c->count; i++) {
        wfPreparedPoint *p = &c->p[i];
        wfReal u = wfNormalRate(m, p), before = p->normal;
        wfReal deep = -p->gap - slop;                            /* eq:sequential-target */
        wfReal want = p->gap > 0 ? -p->gap / in->h : share * wfMaxR(deep, 0) / in->h;
        p->normal = wfMaxR(before + p->massN * (want - u), 0);   /* eq:sequential-clamp */
        wfPushPoint(m, p, p->normal - before);
    }
}

static void part_contact(const wfSolve *in, wfPrepared *c, wfMoved *moved, wfReal slop)
{
    const wfBodyState *a = &in->state[c->a], *b = &in->state[c->b];
    wfMoved *ma = &moved[c->a], *mb = &moved[c->b];
    for (int32_t i = 0; i < c->count; i++) {
        wfPreparedPoint *p = &c->p[i];
        wfReal deep = -p->gap - slop, before = p->normal;
        if (!(deep > 0)) continue;
        wfReal goal = slop + (1 - in->positionShare) * deep;    /* eq:impulses-goal */
        wfReal push = p->massN * (-wfGapNow(c, p, ma, mb) - goal);
        p->normal = wfMaxR(before + push, 0);                   /* eq:sequential-clamp */
        wfReal j = p->normal - before;                          /* kg m */
        ma->d = wfAddScaled(ma->d, -j * a->invMass, c->n);
        ma->turn -= j * p->nA * a->invInertia;
        mb->d = wfAddScaled(mb->d, j * b->invMass, c->n);
        mb->turn += j * p->nB * b->invInertia;
    }
}

static void move_bodies(const wfSolve *in, const wfMoved *moved)
{
    for (int32_t i = 0; i < in->bodyCount; i++) {
        in->state[i].p = wfAdd(in->state[i].p, moved[i].d);
        in->state[i].angle += moved[i].turn;
    }
}

wfResult wfSequentialPositions(const wfSolve *in)
{
    size_t mark = wfPoolMark(in->scratch);
    wfPrepared *c = wfPoolPushArray(in->scratch, in->contactCount, wfPrepared);
    wfMoved *moved = wfPoolPushArray(in->scratch, in->bodyCount, wfMoved);
    bool room = c != NULL && moved != NULL;
    for (int32_t i = 0; room && i < in->bodyCount; i++) moved[i] = (wfMoved){ .turn = 0 };
    for (int32_t i = 0; room && i < in->contactCount; i++) {
        wfPrepareContact(in, &in->contacts[i], &c[i]);
        c[i].p[0].normal = c[i].p[1].normal = 0;
    }
    for (int32_t pass = 0; room && pass < in->iterations; pass++)
        for (int32_t i = 0; i < in->contactCount; i++)
            part_contact(in, &c[i], moved, in->contacts[i].slop);
    if (room) move_bodies(in, moved);
    wfPoolRewind(in->scratch, mark);
    return room ? WF_OK : WF_ERROR_MEMORY;
}

static void collide_first(const wfSolve *in)
{
    bool some = true;
    for (int32_t pass = 0; some && pass < in->iterations; pass++) {
        some = false;
        for (int32_t i = 0; i < in->contactCount; i++) {
            int32_t at = pass % 2 == 0 ? i : in->contactCount - 1 - i;
            const wfContact *c = &in->contacts[at];
            wfBodyState *a = &in->state[c->a], *b = &in->state[c->b];
            wfTold *told = in->told == NULL ? NULL : &in->told[at];
            if (wfBounce(a, b, c, in->restingSpeed, told)) some = true;
        }
    }
}

static wfResult sequential(const wfSolve *in, wfReal share)
{
    size_t mark = wfPoolMark(in->scratch);
    wfPrepared *c = wfPoolPushArray(in->scratch, in->contactCount, wfPrepared);
    if (c == NULL) return WF_ERROR_MEMORY;
    collide_first(in);
    for (int32_t i = 0; i < in->contactCount; i++) {
        wfPrepareContact(in, &in->contacts[i], &c[i]);
        wfWarmStart(in, &c[i], 1);
    }
    for (int32_t pass = 0; pass < in->iterations; pass++)
        for (int32_t i = 0; i < in->contactCount; i++) {
            wfPairMotion m = wfTakePair(in, &c[i]);
            wfSolveFriction(&c[i], &m);
            push_contact(in, &c[i], &m, share, in->contacts[i].slop);
            wfGivePair(in, &c[i], &m);
            wfPairMotion seen = m;      /* a copy to hand out: m can stay in registers */
            if (pass + 1 == in->iterations) wfJudgeFriction(&c[i], &seen, true);
        }
    for (int32_t i = 0; i < in->contactCount; i++) {
        wfStoreImpulses(&c[i], 1, &in->contacts[i]);
        if (in->told != NULL) wfTellPrepared(&c[i], &in->told[i]);
    }
    wfPoolRewind(in->scratch, mark);
    return WF_OK;
}

wfResult wfSequentialVelocities(const wfSolve *in) { return sequential(in, 0); }

wfResult wfSequentialBaumgarte(const wfSolve *in)
{
    return sequential(in, in->positionShare);
}

wfResult wfNothingLeft(const wfSolve *in)
{
    (void)in;
    return WF_OK;
}

size_t wfSequentialScratch(int32_t bodies, int32_t contacts)
{
    size_t prepared = sizeof(wfPrepared) * (size_t)contacts;
    return prepared + sizeof(wfMoved) * (size_t)bodies + 2 * WF_POOL_ALIGN;
}
