/* Weft: collision/links.c, tangled from chapters/methods/08-rounded-contacts.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "collision/links.h"

/* ask whether a direction is in a fan by eq:contacts-fan */
static bool in_fan(wfVec2 e0, wfVec2 e1, wfVec2 u)
{
    if (wfDot(e0, u) < 0 || wfDot(e1, u) > 0) return false;
    return wfCross(e0, e1) > 0 || wfDot(e0, e1) >= 0;
}

static wfVec2 side_before(const wfShape *link)
{
    return wfSub(link->vertices[0], link->vertices[2]);
}

static wfVec2 side_of(const wfShape *link)
{
    return wfSub(link->vertices[1], link->vertices[0]);
}

static wfVec2 side_after(const wfShape *link)
{
    return wfSub(link->vertices[3], link->vertices[1]);
}

/* say whose a point is by eq:contacts-mine */
enum { NOT_MINE, MY_EDGE, MY_START, MY_END };

/* c: in the frame of the link's body */
static int link_region(const wfShape *link, wfVec2 c)
{
    wfVec2 e = side_of(link);
    wfVec2 fromP = wfSub(c, link->vertices[0]), fromQ = wfSub(c, link->vertices[1]);
    if (wfDot(link->normals[0], fromP) < 0) return NOT_MINE;
    if (wfDot(e, fromP) < 0)
        return in_fan(side_before(link), e, fromP) ? MY_START : NOT_MINE;
    if (wfDot(e, fromQ) > 0)
        return in_fan(e, side_after(link), fromQ) ? MY_END : NOT_MINE;
    return MY_EDGE;
}

/* A link and the shape that meets it, which may come in either order. */
typedef struct LinkPair {
    const wfShape *a, *b, *link, *other;
    wfTransform xa, xb, xl, rel;        /* rel: the other one as the link sees it */
    wfReal margin;
    bool linkIsB;
} LinkPair;

static void link_circle(const LinkPair *l, wfManifold *out)
{
    wfVec2 c = wfApply(l->rel, l->other->centre), u = l->link->normals[0];
    int region = link_region(l->link, c);
    if (region == NOT_MINE) return;
    wfVec2 way = wfSub(c, l->link->vertices[region == MY_END]);
    wfReal gap = region == MY_EDGE ? wfDot(u, way) : wfLength(way);
    if (!(gap - l->other->radius <= l->margin)) return;
    if (region != MY_EDGE) u = wfScale(1 / gap, way);
    u = wfRotate(l->xl.q, u);
    out->normal = l->linkIsB ? wfNeg(u) : u;
    wfCircleContact(l->a, l->xa, l->b, l->xb, l->other->radius - gap, out);
}

/* the joint whose fan has the direction u: 0 or 1, or -1 */
static int joint_of(const wfShape *link, wfVec2 u)
{
    wfVec2 e = side_of(link);
    if (wfDot(link->normals[0], u) < 0) return -1;
    if (in_fan(side_before(link), e, u)) return 0;
    return in_fan(e, side_after(link), u) ? 1 : -1;
}

/* least component of the other core's corners along the link's normal, from the link */
static wfReal gap_of_link(const LinkPair *l)
{
    wfReal least = WF_HUGE;
    for (int32_t k = 0; k < l->other->count; k++) {
        wfVec2 w = wfSub(wfApply(l->rel, l->other->vertices[k]), l->link->vertices[0]);
        least = wfMinR(least, wfDot(l->link->normals[0], w));
    }
    return least;
}

/* the other shape's edge with the greatest gap, or -1: the link itself */
static int32_t choose_edge(const LinkPair *l, wfReal *gap)
{
    wfReal reach = wfMinR(wfShapeMaxExtent(l->link), wfShapeMaxExtent(l->other));
    int32_t edge = -1;
    *gap = gap_of_link(l);
    wfReal best = *gap + WF_AXIS_TIE * reach;                       /* eq:narrow-tie */
    for (int32_t j = 0; j < l->other->count; j++) {
        wfVec2 u = wfNeg(wfRotate(l->rel.q, l->other->normals[j]));
        int joint = joint_of(l->link, u);
        if (joint < 0) continue;
        wfVec2 w = wfApply(l->rel, l->other->vertices[j]);
        wfReal g = wfDot(u, wfSub(w, l->link->vertices[joint]));
        if (g > best) best = *gap = g, edge = j;
    }
    return edge;
}

/* true: the link on the other side of this joint sees the body too */
static bool neighbour_sees(const LinkPair *l, wfVec2 joint, wfVec2 side)
{
    wfReal most = l->other->radius + l->margin;
    wfVec2 centre = wfApply(l->rel, l->other->centre);
    if (wfCross(side, wfSub(centre, joint)) >= 0) return false;
    for (int32_t j = 0; j < l->other->count; j++) {
        wfVec2 way = wfSub(joint, wfApply(l->rel, l->other->vertices[j]));
        if (wfDot(wfRotate(l->rel.q, l->other->normals[j]), way) > most) return false;
    }
    return true;
}

static bool is_neighbours(const LinkPair *l, const wfFacing *f, const wfClipPoint *end)
{
    wfVec2 before = side_before(l->link), e = side_of(l->link), after = side_after(l->link);
    wfVec2 u = wfNeg(wfRotate(l->rel.q, l->other->normals[f->i]));
    if (end->feature == wfFeature(f->refIsB, 0, f->i))
        return wfCross(before, e) > 0 && wfDot(before, u) < 0
            && neighbour_sees(l, l->link->vertices[0], before);
    if (end->feature == wfFeature(f->refIsB, 1, f->i))
        return wfCross(e, after) > 0 && wfDot(after, u) > 0
            && neighbour_sees(l, l->link->vertices[1], after);
    return false;
}

/* true: two corners face each other in the fan of a joint, and made the contact */
static bool link_corner(const LinkPair *l, const wfFacing *f, const wfClipPoint *clipped,
                        wfManifold *out)
{
    wfCorners c;
    if (!wfFacingCorners(f, clipped, &c)) return false;
    bool linkIsRef = f->ref == l->link;
    int32_t corner = linkIsRef ? c.inc : c.ref, joint = linkIsRef ? c.ref : c.inc;
    wfVec2 w = wfApply(l->rel, l->other->vertices[corner]);
    if (link_region(l->link, w) != (joint ? MY_END : MY_START)) return false;
    wfCornerContact(f, &c, l->margin, out);
    return true;
}

/* the reference edge is the other shape's `edge`, or the link's if that is -1 */
static void link_edge(const LinkPair *l, int32_t edge, bool apart, wfManifold *out)
{
    wfClipPoint ends[2];
    int owner = edge < 0 ? l->linkIsB : !l->linkIsB;
    wfFacing f;
    wfFaceEdges(l->a, l->xa, l->b, l->xb, owner, edge < 0 ? 0 : edge, &f);
    wfReal most = l->other->radius + l->margin;
    bool some = wfClipIncident(&f, ends);
    if (apart && link_corner(l, &f, some ? ends : NULL, out)) return;
    out->normal = wfFacingNormal(&f);
    for (int k = 0; some && k < 2; k++) {
        if (ends[k].at.y > most || (edge < 0 && is_neighbours(l, &f, &ends[k]))) continue;
        wfAddClipped(&f, &ends[k], out);
    }
}

/* touch a link */
static void link_core(const LinkPair *l, wfManifold *out)
{
    wfReal gap;
    wfVec2 centre = wfSub(wfApply(l->rel, l->other->centre), l->link->vertices[0]);
    if (wfDot(l->link->normals[0], centre) < 0) return;
    int32_t edge = choose_edge(l, &gap);
    if (!(gap - l->other->radius <= l->margin)) return;
    link_edge(l, edge, gap > 0, out);
    if (out->count == 0 && edge >= 0) link_edge(l, -1, gap > 0, out);
}

void wfLinkContacts(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb,
                    wfReal margin, wfManifold *out)
{
    LinkPair l = { .a = a, .b = b, .link = a, .other = b, .xa = xa, .xb = xb, .xl = xa,
                   .margin = margin };
    if (a->kind == WF_SHAPE_LINK && b->kind == WF_SHAPE_LINK) return;
    if (a->kind != WF_SHAPE_LINK) {
        l.link = b, l.other = a, l.xl = xb;
        l.linkIsB = true;
    }
    l.rel = wfRelativePose(l.xl, l.linkIsB ? xa : xb);
    if (l.other->kind == WF_SHAPE_CIRCLE) link_circle(&l, out);
    else link_core(&l, out);
}
