/* Weft: collision/reuse.c, tangled from chapters/methods/09-manifold-reuse.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/contact.h"

/* remember a manifold */
void wfRememberManifold(wfTransform xa, wfTransform xb, wfReal distance, wfReal within,
                        wfReal allowed, const wfManifold *m, wfManifoldCache *cache)
{
    *cache = (wfManifoldCache){ .apart = wfSub(xb.p, xa.p), .qA = xa.q, .qB = xb.q,
        .distance = distance, .within = within, .allowed = allowed, .known = 1 + m->count };
    wfReal sum = distance + within + cache->apart.x + cache->apart.y;
    for (int32_t i = 0; i < m->count; i++) sum += cache->gap[i] = -m->points[i].depth;
    if (!wfIsFinite(sum)) *cache = (wfManifoldCache){ .known = 0 };
}

/* use a manifold again */
static wfReal turned(wfRot from, wfRot to)
{
    return wfLength(wfV2(to.c - from.c, to.s - from.s));
}

/* How far an arm's end has gone along n since the rotation was `from`, m. */
static wfReal way_of_arm(wfVec2 arm, wfRot from, wfRot to, wfVec2 n)
{
    wfReal c = to.c * from.c + to.s * from.s, s = to.s * from.c - to.c * from.s;
    return s * wfCross(arm, n) + (c - 1) * wfDot(arm, n);
}

bool wfReuseManifold(wfReal reachA, wfTransform xa, wfReal reachB, wfTransform xb,
                     wfReal margin, const wfManifoldCache *cache, wfManifold *m)
{
    wfVec2 way = wfSub(wfSub(xb.p, xa.p), cache->apart);
    wfReal moved = wfLength(way) + reachA * turned(cache->qA, xa.q)
                 + reachB * turned(cache->qB, xb.q);            /* eq:contacts-moved */
    if (cache->known == 0) return false;
    if (cache->distance - moved > margin) {
        *m = (wfManifold){ .normal = wfV2(0, 0) };
        return true;
    }
    if (!(moved <= cache->allowed)) return false;           /* eq:contacts-reuse-limit */
    if (m->count != cache->known - 1 || m->count == 0) return false;
    if (!(margin + moved <= cache->within)) return false;
    for (int32_t i = 0; i < m->count; i++) {
        wfContactPoint *p = &m->points[i];
        wfReal gap = cache->gap[i] + wfDot(m->normal, way)
                   + way_of_arm(p->rB, cache->qB, xb.q, m->normal)
                   - way_of_arm(p->rA, cache->qA, xa.q, m->normal);
        p->depth = -gap;                                    /* eq:contacts-frozen */
        p->point = wfAdd(xa.p, p->rA);
    }
    return true;
}
