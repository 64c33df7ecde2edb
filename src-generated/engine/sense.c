/* Weft: engine/sense.c, tangled from chapters/methods/27-continuous-collision.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "engine/step.h"

/* When body i was last struck, share of the step; 0: its way has no corner. */
static wfReal corner_of(const struct wfStep *s, int32_t i)
{
    return s->flightCount > 0 && s->flightOf[i] >= 0 ? s->flights[s->flightOf[i]].since : 0;
}

static wfSweep part_of(wfSweep w, wfReal from, wfReal to)
{
    wfVec2 by = wfSub(w.to, w.from);
    wfReal turn = w.angleTo - w.angleFrom;
    return (wfSweep){ wfAddScaled(w.from, from, by), wfAddScaled(w.from, to, by),
                      w.angleFrom + from * turn, w.angleFrom + to * turn };
}

/* The way of body i between two moments, neither side of its corner. */
static wfSweep way_between(const struct wfStep *s, int32_t i, wfReal from, wfReal to)
{
    const wfBodyState *old = &s->b.state[i], *now = &s->state[i];
    wfReal corner = corner_of(s, i), likely = s->b.head->timeStep * (old->w + now->w) / 2;
    likely = wfClamp(likely, -2 * WF_PI * WF_SWEPT_TURNS, 2 * WF_PI * WF_SWEPT_TURNS);
    wfReal turn = likely + wfWrapAngle(now->angle - old->angle - likely); /* eq:fast-turn */
    wfSweep way = { old->p, now->p, old->angle, old->angle + turn };
    if (!(corner > 0)) return part_of(way, from, to);
    const wfSweep leg = s->flights[s->flightOf[i]].leg;
    if (from >= corner)
        return part_of(leg, (from - corner) / (1 - corner), (to - corner) / (1 - corner));
    way.to = leg.from, way.angleTo = leg.angleFrom;
    return part_of(way, from / corner, to / corner);
}

static wfReal whole_way(const struct wfStep *s, int32_t k)
{
    int32_t i = s->b.bodyOfShape[k];
    wfReal corner = corner_of(s, i);
    wfReal way = corner < 1 ? wfWayOfShape(s, k, way_between(s, i, corner, 1)) : 0;
    return corner > 0 ? way + wfWayOfShape(s, k, way_between(s, i, 0, corner)) : way;
}
static bool parted(const struct wfStep *s, wfPair p, wfTransform xa, wfTransform xb,
                   wfSeparation *out)
{
    return wfSeparate(s->b.head->narrowPhase, &s->b.shapes[p.a], xa, &s->b.shapes[p.b], xb,
                      out) == WF_OK && out->distance > 0;
}

/* Did they meet on these ways, in or out of which they do not overlap? */
static bool met_on(const struct wfStep *s, wfPair p, wfSweep a, wfSweep b)
{
    enum { PICTURES = 10 };
    wfImpact found;
    wfSeparation end;
    if (wfTimeOfImpact(&s->b.shapes[p.a], a, &s->b.shapes[p.b], b, &found) != WF_OK)
        return false;
    if (found.kind == WF_IMPACT_APART) return false;
    wfReal way = wfWayOfShape(s, p.a, a) + wfWayOfShape(s, p.b, b), t = found.t;
    wfReal step = WF_IMPACT_GAP * wfMinR(s->b.materials[p.a].reach,
                                         s->b.materials[p.b].reach) / way;
    for (int i = 0; i < PICTURES && t < 1; i++, t = found.t + step, step *= 2)
        if (!parted(s, p, wfSweepAt(a, t), wfSweepAt(b, t), &end)) return true;
    if (!parted(s, p, wfSweepAt(a, 1), wfSweepAt(b, 1), &end)) return true;
    return wfDot(found.normal, end.normal) < 0;
}

static bool flew_through(const struct wfStep *s, wfPair p)
{
    int32_t i = s->b.bodyOfShape[p.a], j = s->b.bodyOfShape[p.b];
    wfReal first = corner_of(s, i), second = corner_of(s, j);
    wfReal moment[4] = { 0, wfMinR(first, second), wfMaxR(first, second), 1 };
    wfSeparation apart;
    for (int n = 0; n < 2; n++) {               /* what a picture shows is told by that */
        wfBodyState one = n == 0 ? s->b.state[i] : s->state[i];
        wfBodyState two = n == 0 ? s->b.state[j] : s->state[j];
        wfWrapBodyAngle(&one);
        wfWrapBodyAngle(&two);
        if (!parted(s, p, wfBodyTransform(&one), wfBodyTransform(&two), &apart))
            return false;
    }
    for (int n = 0; n < 3; n++)
        if (moment[n] < moment[n + 1]
            && met_on(s, p, way_between(s, i, moment[n], moment[n + 1]),
                      way_between(s, j, moment[n], moment[n + 1]))) return true;
    return false;
}
typedef struct Flown {
    struct wfStep *s;
    int32_t *swift, count;      /* the shapes that went far */
    uint8_t *is;                /* of each shape: is it one of them? */
    int32_t  k;                 /* the shape that looks */
    wfPair  *out;
    int32_t  found, most;
} Flown;

static bool is_shown(const struct wfStep *s, wfPair p)
{
    for (int32_t n = 0; n < s->touchCount; n++)
        if (s->touches[n].a == p.a && s->touches[n].b == p.b) return true;
    return false;
}

static bool may_sense(const struct wfStep *s, wfPair p)
{
    int32_t i = s->b.bodyOfShape[p.a], j = s->b.bodyOfShape[p.b];
    bool may = wfIsSensor(&s->b, p.a) != wfIsSensor(&s->b, p.b) && i != j
            && wfFilterAllows(s->b.filters[p.a], s->b.filters[p.b]);
    if (!may) return false;
    /* who else is not met */
    if (wfIsJoined(s, i, j)) return false;
    const wfCallbacks *hooks = s->hooks;
    if (hooks != NULL && hooks->filter != NULL)
        may = hooks->filter(hooks->context, &s->view, p.a, p.b);
    return may;
}

static void sense_flown(Flown *f, int32_t other)
{
    wfPair p = wfMakePair(f->k, other);
    if (!may_sense(f->s, p) || !flew_through(f->s, p) || is_shown(f->s, p)) return;
    if (f->found < f->most) f->out[f->found] = p;
    f->found++;
}

static bool sense_slow(void *context, int32_t other)
{
    Flown *f = context;
    if (!f->is[other]) sense_flown(f, other);
    return true;
}

/* Lists the shapes that went far; what all others went at most. */
static wfReal find_swift(Flown *f)
{
    const struct wfStep *s = f->s;
    wfReal slack = 0;
    for (int32_t k = 0; k < s->shapeCount; k++) {
        int32_t i = s->b.bodyOfShape[k];
        f->is[k] = 0;
        if (i < 0 || !s->present[i]) continue;
        wfReal way = whole_way(s, k);
        f->is[k] = way > s->b.materials[k].inner;
        if (f->is[k]) f->swift[f->count++] = k;
        else slack = wfMaxR(slack, way);
    }
    return slack;
}

/* A box round all of the way of shape k, and whatever came near from outside. */
static wfRect box_of_way(const struct wfStep *s, int32_t k, wfReal slack)
{
    int32_t i = s->b.bodyOfShape[k];
    wfVec2 from = s->b.state[i].p, to = s->state[i].p, corner = to;
    if (corner_of(s, i) > 0) corner = s->flights[s->flightOf[i]].leg.from;
    wfRect ends = { .min = wfMin2(wfMin2(from, to), corner),
                    .max = wfMax2(wfMax2(from, to), corner) };
    return wfRectGrow(ends, wfLength(s->b.shapes[k].centre) + s->b.materials[k].reach
                            + slack);
}

/* Pairs of a sensor and of what flew through it, up to `most`; how many there are, or -1:
 * no memory. */
int32_t wfFindFlown(struct wfStep *s, wfPair *out, int32_t most)
{
    const wfHeader *head = s->b.head;
    Flown f = { .s = s, .out = out, .most = most };
    f.swift = wfPoolPushArray(&s->scratch, s->shapeCount, int32_t);
    f.is = wfPoolPushArray(&s->scratch, s->shapeCount, uint8_t);
    if (f.swift == NULL || f.is == NULL) return -1;
    wfReal slack = find_swift(&f);
    wfProxies proxies = wfProxiesOf(&s->b, s->bounds, s->flags);
    for (int32_t n = 0; n < f.count; n++) {
        f.k = f.swift[n];
        wfQueryIndex(head->broadPhase, &proxies, s->index, box_of_way(s, f.k, slack),
                     sense_slow, &f);
        for (int32_t m = 0; m < f.count && wfIsSensor(&s->b, f.k); m++)
            sense_flown(&f, f.swift[m]);
    }
    return f.found;
}
