/* Weft: collision/reuse.c, tangled from chapters/methods/08-manifold-reuse.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "collision/clip.h"

/* remember the reference edge */
static wfReal core_reach(const wfShape *s)
{
    wfReal far = 0;
    for (int32_t i = 0; i < s->count; i++)
        far = wfMaxR(far, wfDistanceSq(s->vertices[i], s->centre));
    return wfSqrt(far);
}

void wfRememberManifold(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                        const wfSeparation *s, wfManifoldCache *cache)
{
    bool edges = a->count > 1 && b->count > 1 && s->owner >= 0;
    if (a->kind == WF_SHAPE_LINK || b->kind == WF_SHAPE_LINK) edges = false;
    bool isB = edges && s->owner == 1;
    cache->relative = isB ? wfRelativePose(xb, xa) : wfRelativePose(xa, xb);
    cache->distance = s->distance;
    cache->reach = core_reach(isB ? a : b);
    cache->allowed = WF_REUSE_SHARE * wfMinR(wfShapeMaxExtent(a), wfShapeMaxExtent(b));
    cache->owner = edges ? s->owner : WF_NO_EDGE;
    cache->edge = edges ? s->edge : WF_NO_EDGE;
}

/* measure how far a pair has moved by eq:contacts-moved */
static wfReal moved_by(const wfManifoldCache *c, const wfShape *incident, wfTransform now)
{
    wfVec2 from = wfApply(c->relative, incident->centre);
    wfVec2 way = wfSub(wfApply(now, incident->centre), from);
    wfVec2 turn = wfV2(now.q.c - c->relative.q.c, now.q.s - c->relative.q.s);
    return wfLength(way) + wfLength(turn) * c->reach;
}

/* use a reference edge again */
static bool clip_again(wfFacing *f, wfReal margin, const wfManifoldCache *cache,
                       wfManifold *out)
{
    wfClipPoint ends[2];
    wfCorners corners;
    if (cache->owner < 0) return false;
    wfFaceEdge(cache->edge, f);
    if (!wfClipIncident(f, ends)) return false;
    wfReal coats = f->ref->radius + f->inc->radius, most = coats + margin;
    bool apart = wfMinR(ends[0].at.y, ends[1].at.y) > 0;
    if (apart && wfFacingCorners(f, ends, &corners)) return false;
    if (!wfEndsTouch(f, ends) && wfDeepestVertex(f).at.y <= coats) return false;
    if (!(ends[0].at.y <= most || ends[1].at.y <= most)) return false;
    *out = (wfManifold){ .normal = wfFacingNormal(f) };
    wfAddEnds(f, ends, margin, out);
    return true;
}

bool wfReuseManifold(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                     wfReal margin, const wfManifoldCache *cache, wfManifold *out)
{
    wfFacing f;
    if (!(cache->allowed > 0)) return false;
    wfFaceShapes(a, xa, b, xb, cache->owner, &f);
    wfReal moved = moved_by(cache, f.inc, f.rel);
    if (cache->distance - moved > margin) {
        *out = (wfManifold){ .normal = wfV2(0, 0) };
        return true;
    }
    if (!(moved <= cache->allowed)) return false;           /* eq:contacts-reuse-limit */
    return clip_again(&f, margin, cache, out);
}
