/* Weft: dynamics/force.c, tangled from chapters/09-forces.nw. Chapters that add to it: 24-world. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/force.h"

/* <choose the bodies that a force acts on> */
static bool feels(const wfBodyView *bodies, int32_t i)
{
    if (i < 0 || i >= bodies->count || (bodies->alive && !bodies->alive[i])) return false;
    return bodies->state[i].invMass > 0 || bodies->state[i].invInertia > 0;
}

static int32_t first_of(const wfForce *f) { return f->a < 0 ? 0 : f->a; }

static int32_t end_of(const wfForce *f, const wfBodyView *bodies)
{
    return f->a < 0 ? bodies->count : f->a + 1;
}

static wfReal mass_of(const wfBodyView *bodies, int32_t i)
{
    wfReal inverse = bodies->state[i].invMass;
    return inverse > 0 ? 1 / inverse : 0;
}
/* <choose the bodies that a force acts on> */
static bool is_there(const wfBodyView *bodies, int32_t i)
{
    return i >= 0 && i < bodies->count && (!bodies->alive || bodies->alive[i]);
}

static int32_t first_shape(const wfBodyView *bodies, int32_t i)
{
    return bodies->shapes ? bodies->props[i].shape : -1;
}

static int32_t shape_after(const wfBodyView *bodies, int32_t k)
{
    return bodies->next ? bodies->next[k] : -1;
}
/* <force generators> */
static void gravity_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                          wfBodyForces *out)
{
    (void)time;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        wfReal weight = mass_of(bodies, i) * bodies->props[i].gravityScale;
        /* eq:force-gravity */
        wfApplyForceToCentre(&out[i], wfScale(weight, f->gravity.g));
    }
}

/* <force generators> */
static wfReal gravity_energy(const wfForce *f, const wfBodyView *bodies)
{
    wfReal sum = 0;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        wfReal weight = mass_of(bodies, i) * bodies->props[i].gravityScale;
        /* eq:force-gravity-energy */
        sum -= weight * wfDot(f->gravity.g, bodies->state[i].p);
    }
    return sum;
}
/* <force generators> */
static wfVec2 attractor(const wfForce *f, const wfBodyView *bodies)
{
    return f->b < 0 ? f->point.centre : bodies->state[f->b].p;
}

static bool is_pulled(const wfForce *f, const wfBodyView *bodies, int32_t i)
{
    return feels(bodies, i) && i != f->b && (f->b < 0 || is_there(bodies, f->b));
}

static void point_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                        wfBodyForces *out)
{
    (void)time;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!is_pulled(f, bodies, i)) continue;
        /* <pull body i to the centre by eq:force-point> */
        wfVec2 r = wfSub(bodies->state[i].p, attractor(f, bodies));
        wfReal s = wfLength(wfV2(wfLength(r), f->point.softening));
        if (s == 0) continue;  /* right in the centre: no direction */
        wfReal pull = mass_of(bodies, i) * f->point.strength / (s * s);
        wfVec2 force = wfScale(-pull, wfScale(1 / s, r));
        wfApplyForceToCentre(&out[i], force);
        if (f->b >= 0) wfApplyForceToCentre(&out[f->b], wfNeg(force));
    }
}
/* <force generators> */
static wfReal point_energy(const wfForce *f, const wfBodyView *bodies)
{
    wfReal sum = 0;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!is_pulled(f, bodies, i)) continue;
        /* <add the energy of body i by eq:force-point-energy> */
        wfVec2 r = wfSub(bodies->state[i].p, attractor(f, bodies));
        wfReal s = wfLength(wfV2(wfLength(r), f->point.softening));
        if (s > 0) sum -= mass_of(bodies, i) * f->point.strength / s;
    }
    return sum;
}

static wfResult point_check(const wfForce *f)
{
    return f->point.softening >= 0 ? WF_OK : WF_ERROR_RANGE;
}

static void point_move(wfForce *f, wfVec2 by)
{
    if (f->b < 0) f->point.centre = wfSub(f->point.centre, by);
}
/* <force generators> */
typedef struct Stretch {
    bool there;                 /* both ends exist                              */
    wfVec2 a, b;                /* m: the ends, world                           */
    wfVec2 along;               /* unit, from b to a; zero if they coincide     */
    wfReal length, rate;        /* m, m/s                                       */
} Stretch;

static Stretch stretch_of(const wfForce *f, const wfBodyView *bodies)
{
    Stretch s = { .there = is_there(bodies, f->a) && (f->b < 0 || is_there(bodies, f->b)) };
    if (!s.there) return s;
    const wfBodyState *a = &bodies->state[f->a];
    s.a = wfApply(wfBodyTransform(a), f->spring.localA);
    s.b = f->spring.localB;
    wfVec2 v = wfVelocityAt(a, s.a);
    if (f->b >= 0) {
        s.b = wfApply(wfBodyTransform(&bodies->state[f->b]), f->spring.localB);
        v = wfSub(v, wfVelocityAt(&bodies->state[f->b], s.b));
    }
    /* <measure the stretch by eq:force-stretch> */
    wfVec2 d = wfSub(s.a, s.b);
    s.length = wfLength(d);
    s.along = wfNormalize(d);
    s.rate = wfDot(v, s.along);
    return s;
}
/* <force generators> */
static void pull_ends(const wfForce *f, const wfBodyView *bodies, const Stretch *s,
                      wfReal tension, wfBodyForces *out)
{
    wfVec2 force = wfScale(-tension, s->along);
    if (feels(bodies, f->a)) wfApplyForce(&out[f->a], &bodies->state[f->a], force, s->a);
    if (f->b >= 0 && feels(bodies, f->b))
        wfApplyForce(&out[f->b], &bodies->state[f->b], wfNeg(force), s->b);
}

static wfReal tension_of(const wfForce *f, const Stretch *s)
{
    return f->spring.stiffness * (s->length - f->spring.rest) + f->spring.damping * s->rate;
}

static void spring_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                         wfBodyForces *out)
{
    (void)time;
    Stretch s = stretch_of(f, bodies);
    if (s.there) pull_ends(f, bodies, &s, tension_of(f, &s), out);  /* eq:force-spring */
}
/* <force generators> */
static wfReal spring_energy(const wfForce *f, const wfBodyView *bodies)
{
    Stretch s = stretch_of(f, bodies);
    if (!s.there) return 0;
    /* eq:force-spring-energy */
    return f->spring.stiffness * wfSquare(s.length - f->spring.rest) / 2;
}

static wfResult spring_check(const wfForce *f)
{
    if (f->a < 0 || f->a == f->b || f->spring.rest < 0) return WF_ERROR_RANGE;
    return f->spring.stiffness >= 0 && f->spring.damping >= 0 ? WF_OK : WF_ERROR_RANGE;
}

static void spring_move(wfForce *f, wfVec2 by)
{
    if (f->b < 0) f->spring.localB = wfSub(f->spring.localB, by);
}
/* <force generators> */
static void bungee_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                         wfBodyForces *out)
{
    (void)time;
    Stretch s = stretch_of(f, bodies);
    if (!s.there || s.length <= f->spring.rest) return;
    pull_ends(f, bodies, &s, wfMaxR(0, tension_of(f, &s)), out);  /* eq:force-bungee */
}

static wfReal bungee_energy(const wfForce *f, const wfBodyView *bodies)
{
    Stretch s = stretch_of(f, bodies);
    return s.there && s.length > f->spring.rest ? spring_energy(f, bodies) : 0;
}
/* <force generators> */
static void drag_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                       wfBodyForces *out)
{
    (void)time;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        wfVec2 v = bodies->state[i].v;
        wfReal c = f->drag.linear + f->drag.quadratic * wfLength(v);
        wfApplyForceToCentre(&out[i], wfScale(-c, v));                  /* eq:force-drag */
    }
}

static wfResult drag_check(const wfForce *f)
{
    return f->drag.linear >= 0 && f->drag.quadratic >= 0 ? WF_OK : WF_ERROR_RANGE;
}
/* <force generators> */
/* <cut a polygon at the surface> */
/* Corners of what is below y = depth, of a polygon turned by q about its centre. */
static int cut_polygon(const wfShape *shape, wfRot q, wfReal depth, wfVec2 *out)
{
    int n = 0;
    wfVec2 a = wfRotate(q, wfSub(shape->vertices[shape->count - 1], shape->centre));
    for (int i = 0; i < shape->count; i++) {
        wfVec2 b = wfRotate(q, wfSub(shape->vertices[i], shape->centre));
        if ((a.y < depth) != (b.y < depth)) {
            wfReal t = (depth - a.y) / (b.y - a.y);     /* eq:force-cut */
            out[n++] = wfV2(a.x + t * (b.x - a.x), depth);
        }
        if (b.y < depth) out[n++] = b;
        a = b;
    }
    return n;
}
/* <sum the moments of a polygon> */
/* Area, centroid and second moment by @eq:force-moments, all about corner 0 first. */
static wfSubmerged polygon_moments(const wfVec2 *p, int n)
{
    wfSubmerged s = { .area = 0 };
    wfVec2 first = { { 0, 0 } };
    wfReal second = 0;
    for (int i = 1; i + 1 < n; i++) {
        wfVec2 a = wfSub(p[i], p[0]), b = wfSub(p[i + 1], p[0]);
        wfReal area = wfCross(a, b) / 2;
        s.area += area;
        first = wfAddScaled(first, area / 3, wfAdd(a, b));
        second += area / 6 * (wfDot(a, a) + wfDot(a, b) + wfDot(b, b));
    }
    if (!(s.area > 0)) return s;
    wfVec2 c = wfScale(1 / s.area, first);
    s.inertia = wfMaxR(0, second - s.area * wfLengthSq(c));
    s.centre = wfAdd(p[0], c);
    return s;
}
/* <sum the moments of a polygon> */
static wfSubmerged submerged_polygon(const wfShape *shape, wfRot q, wfReal depth)
{
    wfVec2 p[2 * WF_MAX_VERTICES];
    int n = cut_polygon(shape, q, depth, p);
    return polygon_moments(p, n);
}
/* <cut a circle at the surface> */
/* <half of x minus sin x, without cancellation> */
/* For small x by @eq:force-x-minus-sine, 10 terms of which reach a double's rounding. */
static wfReal half_x_minus_sine(wfReal x)
{
    if (x > 1) return (x - wfSin(x)) / 2;
    wfReal term = x * x * x / 12, sum = 0;
    for (int k = 1; k <= 10; k++) {
        sum += term;
        term *= -x * x / (wfReal)((2 * k + 2) * (2 * k + 3));
    }
    return sum;
}

/* what an arc of the angle 2 half cuts off, seen from the circle's centre, the arc below */
static wfSubmerged circle_segment(wfReal r, wfReal half, wfReal sine, wfReal u)
{
    wfSubmerged s = { .area = 0 };
    wfReal g = half_x_minus_sine(2 * half);
    s.area = r * r * g;                                 /* eq:force-segment-area */
    if (!(s.area > 0)) return s;
    wfReal c = 2 * r * sine * sine * sine / (3 * g);    /* eq:force-segment-centre */
    wfReal polar = r * r * r * r * (g / 2 + sine * sine * sine * u / 3);
    s.centre = wfV2(0, -wfMinR(c, r));
    s.inertia = wfMaxR(0, polar - s.area * c * c);      /* eq:force-segment-inertia */
    return s;
}

static wfSubmerged submerged_circle(wfReal r, wfReal depth)
{
    wfReal u = wfClamp(-depth / r, -1, 1);  /* cosine of half the wetted angle */
    wfReal sine = wfSqrt((1 - u) * (1 + u));
    return circle_segment(r, wfAtan2(sine, u), sine, u);
}
/* <cut a coat at the surface> */
/* The part of a coated shape that is under water, piece by piece. */
typedef struct Pieces {
    wfReal radius, depth;
    int corners, caps;
    wfVec2 ring[6 * WF_MAX_VERTICES];
    wfSubmerged cap[3 * WF_MAX_VERTICES + 1];   /* and, at the end, the polygon */
} Pieces;
/* <cut a coat at the surface> */
/* the directions u0, u1 of an arc, and those between them in which the surface cuts it */
static int cut_arc(const Pieces *p, wfVec2 v, wfVec2 u0, wfVec2 u1, wfVec2 out[4])
{
    wfReal k = (p->depth - v.y) / p->radius;
    int n = 0;
    out[n++] = u0;
    if (wfAbs(k) < 1) {
        wfReal x = wfSqrt((1 - k) * (1 + k));
        wfVec2 cut[2] = { wfV2(x, k), wfV2(-x, k) };
        for (int i = 0; i < 2; i++)                     /* eq:force-arc */
            if (wfCross(u0, cut[i]) > 0 && wfCross(cut[i], u1) > 0) out[n++] = cut[i];
        bool swapped = n == 3 && wfCross(out[1], out[2]) < 0;
        if (swapped) out[1] = cut[1], out[2] = cut[0];
    }
    out[n++] = u1;
    return n;
}
/* <cut a coat at the surface> */
static void add_arc(Pieces *p, wfVec2 v, wfVec2 u0, wfVec2 u1)
{
    wfVec2 u[4];
    int n = cut_arc(p, v, u0, u1, u);
    for (int i = 0; i + 1 < n; i++) {
        wfReal half = wfAtan2(wfCross(u[i], u[i + 1]), wfDot(u[i], u[i + 1])) / 2;
        wfRot turn = wfRotation(half);
        wfVec2 middle = wfRotate(turn, u[i]);
        if (!(v.y + p->radius * middle.y < p->depth)) continue;
        wfSubmerged cap = circle_segment(p->radius, half, turn.s, turn.c);
        cap.centre = wfAddScaled(v, 0 - cap.centre.y, middle);
        if (cap.area > 0) p->cap[p->caps++] = cap;
        p->ring[p->corners++] = wfAddScaled(v, p->radius, u[i]);
        p->ring[p->corners++] = wfAddScaled(v, p->radius, u[i + 1]);
    }
}
/* <cut a coat at the surface> */
static void add_edge(Pieces *p, wfVec2 a, wfVec2 b)
{
    if ((a.y < p->depth) == (b.y < p->depth)) return;   /* the arcs have its ends */
    wfReal t = (p->depth - a.y) / (b.y - a.y);          /* eq:force-cut */
    p->ring[p->corners++] = wfV2(a.x + t * (b.x - a.x), p->depth);
}
/* <cut a coat at the surface> */
static wfSubmerged sum_pieces(const wfSubmerged *piece, int n)
{
    wfSubmerged sum = { .area = 0 };
    wfVec2 moment = wfV2(0, 0);
    for (int i = 0; i < n; i++) {
        sum.area += piece[i].area;
        moment = wfAddScaled(moment, piece[i].area, piece[i].centre);
    }
    if (!(sum.area > 0)) return sum;
    sum.centre = wfScale(1 / sum.area, moment);
    for (int i = 0; i < n; i++)
        sum.inertia += piece[i].inertia
                     + piece[i].area * wfDistanceSq(piece[i].centre, sum.centre);
    return sum;
}
/* <cut a coat at the surface> */
static wfSubmerged submerged_coat(const wfShape *shape, wfRot q, wfReal depth)
{
    Pieces p = { .radius = shape->radius, .depth = depth };
    for (int i = 0; i < shape->count; i++) {
        int before = (i + shape->count - 1) % shape->count, next = (i + 1) % shape->count;
        wfVec2 v = wfRotate(q, wfSub(shape->vertices[i], shape->centre));
        wfVec2 w = wfRotate(q, wfSub(shape->vertices[next], shape->centre));
        wfVec2 n = wfRotate(q, shape->normals[i]);
        add_arc(&p, v, wfRotate(q, shape->normals[before]), n);
        add_edge(&p, wfAddScaled(v, p.radius, n), wfAddScaled(w, p.radius, n));
    }
    p.cap[p.caps++] = polygon_moments(p.ring, p.corners);
    return sum_pieces(p.cap, p.caps);
}

wfSubmerged wfSubmergedPart(const wfShape *shape, wfTransform placed, wfReal surfaceY)
{
    wfSubmerged none = { .area = 0, .centre = placed.p };
    if (!shape || shape->kind == WF_SHAPE_NONE) return none;
    wfVec2 centre = wfApply(placed, shape->centre);
    wfReal depth = surfaceY - centre.y;  /* of the shape's centre, upwards negative */
    none.centre = centre;
    bool coat = shape->radius > 0;
    wfSubmerged s = none;
    if (shape->kind == WF_SHAPE_CIRCLE) s = submerged_circle(shape->radius, depth);
    else if (coat) s = submerged_coat(shape, placed.q, depth);
    else if (shape->count > 2) s = submerged_polygon(shape, placed.q, depth);
    if (!(s.area > 0)) return none;
    s.centre = wfAdd(centre, s.centre);
    return s;
}
/* <force generators> */
/* <lift and brake one part> */
static void float_part(const wfForce *f, const wfBodyState *b, const wfSubmerged *s,
                       wfBodyForces *out)
{
    wfReal mass = f->buoyancy.density * s->area;  /* of the fluid that had to make room */
    wfReal rate = f->buoyancy.drag;
    wfVec2 lift = wfV2(0, mass * f->buoyancy.g);             /* eq:force-archimedes */
    wfApplyForce(out, b, lift, s->centre);
    wfVec2 drag = wfScale(-rate * mass, wfVelocityAt(b, s->centre));
    wfApplyForce(out, b, drag, s->centre);                   /* eq:force-water-drag */
    wfApplyTorque(out, -rate * f->buoyancy.density * s->inertia * b->w);
}

static void buoyancy_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                           wfBodyForces *out)
{
    (void)time;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        const wfBodyState *b = &bodies->state[i];
        wfTransform placed = wfBodyTransform(b);
        for (int32_t k = first_shape(bodies, i); k >= 0; k = shape_after(bodies, k)) {
            wfSubmerged s = wfSubmergedPart(&bodies->shapes[k], placed,
                                            f->buoyancy.surfaceY);
            if (s.area > 0) float_part(f, b, &s, &out[i]);
        }
    }
}
/* <force generators> */
static wfReal buoyancy_energy(const wfForce *f, const wfBodyView *bodies)
{
    wfReal sum = 0;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        wfTransform placed = wfBodyTransform(&bodies->state[i]);
        for (int32_t k = first_shape(bodies, i); k >= 0; k = shape_after(bodies, k)) {
            wfSubmerged s = wfSubmergedPart(&bodies->shapes[k], placed,
                                            f->buoyancy.surfaceY);
            wfReal depth = f->buoyancy.surfaceY - s.centre.y;
            /* eq:force-water-energy */
            sum += f->buoyancy.density * s.area * f->buoyancy.g * depth;
        }
    }
    return sum;
}

static wfResult buoyancy_check(const wfForce *f)
{
    if (f->buoyancy.density < 0 || f->buoyancy.g < 0) return WF_ERROR_RANGE;
    return f->buoyancy.drag >= 0 ? WF_OK : WF_ERROR_RANGE;
}

static void buoyancy_move(wfForce *f, wfVec2 by) { f->buoyancy.surfaceY -= by.y; }
/* <force generators> */
wfReal wfSeenWidth(const wfShape *shape, wfTransform placed, wfVec2 direction,
                   wfVec2 *middle)
{
    if (middle) *middle = placed.p;
    if (!shape || shape->kind == WF_SHAPE_NONE) return WF_PARTICLE_WIDTH;
    wfVec2 centre = wfApply(placed, shape->centre), side = wfPerpCCW(direction);
    wfReal low = 0, high = 0;                           /* a circle's core: its centre */
    for (int i = 0; i < shape->count; i++) {
        wfVec2 corner = wfRotate(placed.q, wfSub(shape->vertices[i], shape->centre));
        wfReal x = wfDot(side, corner);
        low = i == 0 ? x : wfMinR(low, x);
        high = i == 0 ? x : wfMaxR(high, x);
    }
    low -= shape->radius;
    high += shape->radius;
    if (middle) *middle = wfAddScaled(centre, (low + high) / 2, side);
    return high - low;                                  /* eq:force-width */
}
/* <force generators> */
static wfReal body_width(const wfBodyView *bodies, int32_t i, wfVec2 direction,
                         wfVec2 *middle)
{
    const wfBodyState *b = &bodies->state[i];
    wfTransform placed = wfBodyTransform(b);
    int32_t k = first_shape(bodies, i);
    const wfShape *first = k < 0 ? NULL : &bodies->shapes[k];
    wfReal width = wfSeenWidth(first, placed, direction, middle);
    if (k < 0 || shape_after(bodies, k) < 0) return width;
    wfVec2 side = wfPerpCCW(direction);
    wfReal low = wfDot(side, wfSub(*middle, b->p)) - width / 2, high = low + width;
    for (k = shape_after(bodies, k); k >= 0; k = shape_after(bodies, k)) {
        width = wfSeenWidth(&bodies->shapes[k], placed, direction, middle);
        wfReal x = wfDot(side, wfSub(*middle, b->p));
        low = wfMinR(low, x - width / 2);
        high = wfMaxR(high, x + width / 2);
    }
    *middle = wfAddScaled(b->p, (low + high) / 2, side);
    return high - low;
}
/* <force generators> */
static wfReal blast_profile(const wfForce *f, wfReal time)
{
    wfReal x = (time - f->explosion.start) / f->explosion.duration;
    if (!(x > 0 && x < 1)) return 0;
    /* eq:force-blast-time */
    return 2 * wfSquare(wfSin(WF_PI * x)) / f->explosion.duration;
}

static void explosion_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                            wfBodyForces *out)
{
    wfReal now = f->explosion.strength * blast_profile(f, time);
    for (int32_t i = first_of(f); now != 0 && i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        const wfBodyState *b = &bodies->state[i];
        wfVec2 r = wfSub(b->p, f->explosion.centre), away = wfNormalize(r), middle;
        wfReal fall = 1 - wfLength(r) / f->explosion.radius;
        if (!(fall > 0)) continue;
        wfReal width = body_width(bodies, i, away, &middle);
        wfReal push = now * fall * fall * width;                        /* eq:force-blast */
        wfApplyForce(&out[i], b, wfScale(push, away), middle);
    }
}
/* <force generators> */
static wfResult explosion_check(const wfForce *f)
{
    return f->explosion.radius > 0 && f->explosion.duration > 0 ? WF_OK : WF_ERROR_RANGE;
}

static void explosion_move(wfForce *f, wfVec2 by)
{
    f->explosion.centre = wfSub(f->explosion.centre, by);
}
/* <force generators> */
static void wind_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                       wfBodyForces *out)
{
    (void)time;
    for (int32_t i = first_of(f); i < end_of(f, bodies); i++) {
        if (!feels(bodies, i)) continue;
        const wfBodyState *b = &bodies->state[i];
        wfVec2 u = wfSub(f->wind.velocity, b->v), middle;
        wfReal width = body_width(bodies, i, wfNormalize(u), &middle);
        wfReal c = f->wind.coefficient * width * wfLength(u);
        wfApplyForce(&out[i], b, wfScale(c, u), middle);                /* eq:force-wind */
    }
}

static wfResult wind_check(const wfForce *f)
{
    return f->wind.coefficient >= 0 ? WF_OK : WF_ERROR_RANGE;
}
/* <force generators> */
static void hand_apply(const wfForce *f, const wfBodyView *bodies, wfReal time,
                       wfBodyForces *out)
{
    (void)time;
    if (!is_there(bodies, f->a) || !feels(bodies, f->a)) return;
    const wfBodyState *s = &bodies->state[f->a];
    wfVec2 point = wfApply(wfBodyTransform(s), f->hand.local);
    wfVec2 pull = wfScale(f->hand.stiffness, wfSub(f->hand.target, point));
    wfVec2 force = wfAddScaled(pull, -f->hand.damping, wfVelocityAt(s, point));
    wfApplyForce(&out[f->a], s, force, point);              /* eq:world-hand */
    wfApplyTorque(&out[f->a], -f->hand.spin * s->w);
}

static wfResult hand_check(const wfForce *f)
{
    if (f->a < 0 || f->b != -1) return WF_ERROR_RANGE;
    bool good = f->hand.stiffness >= 0 && f->hand.damping >= 0 && f->hand.spin >= 0;
    return good ? WF_OK : WF_ERROR_RANGE;
}

static void hand_move(wfForce *f, wfVec2 by)
{
    f->hand.target = wfSub(f->hand.target, by);
}
/* <the force table> */
const wfForceRow wfForceTable[] = {
    /* <rows of the force table> */
    [WF_FORCE_GRAVITY] = { .name = "gravity", .text = "the same acceleration for all",
        .params = 2, .apply = gravity_apply,
        /* <the energy of gravity> */
        /* which not every engine has to add up */
        /* <the energy of gravity> */
        .energy = gravity_energy,
        .steady = true,
    },
    /* <rows of the force table> */
    [WF_FORCE_POINT_GRAVITY] = { "point-gravity", "a pull to a point as the inverse square",
        4, point_apply, point_energy, point_check, true, point_move },
    [WF_FORCE_SPRING] = { "spring", "Hooke's law between two points, damped",
        7, spring_apply, spring_energy, spring_check, true, spring_move },
    [WF_FORCE_BUNGEE] = { "bungee", "a spring that only pulls",
        7, bungee_apply, bungee_energy, spring_check, true, spring_move },
    [WF_FORCE_DRAG] = { "drag", "resistance as the speed and as its square",
        2, drag_apply, NULL, drag_check, true, NULL },
    [WF_FORCE_BUOYANCY] = { "buoyancy", "the lift and the resistance of a fluid",
        4, buoyancy_apply, buoyancy_energy, buoyancy_check, true, buoyancy_move },
    [WF_FORCE_EXPLOSION] = { "explosion", "a push away from a point that lasts a while",
        6, explosion_apply, NULL, explosion_check, false, explosion_move },
    [WF_FORCE_WIND] = { "wind", "moving air pushes what stands in its way",
        3, wind_apply, NULL, wind_check, true, NULL },
    /* <rows of the force table> */
    { "hand", "a spring and a brake that hold a point of a body at a point of the world",
        7, hand_apply, NULL, hand_check, true, hand_move },
};
const int wfForceKinds = (int)(sizeof wfForceTable / sizeof *wfForceTable);

int wfFindForce(const char *name)
{
    for (int i = 0; name && i < wfForceKinds; i++)
        if (strcmp(wfForceTable[i].name, name) == 0) return i;
    return -1;
}
/* <make forces> */
wfForce wfGravity(wfVec2 g)
{
    return (wfForce){ .kind = WF_FORCE_GRAVITY, .a = -1, .b = -1, .gravity = { g } };
}

/* <make forces> */
wfForce wfPointGravity(wfVec2 centre, wfReal strength, wfReal softening)
{
    return (wfForce){ .kind = WF_FORCE_POINT_GRAVITY, .a = -1, .b = -1,
                      .point = { centre, strength, softening } };
}

wfForce wfSpring(int32_t a, wfVec2 localA, int32_t b, wfVec2 localB, wfReal rest,
                 wfReal stiffness, wfReal damping)
{
    return (wfForce){ .kind = WF_FORCE_SPRING, .a = a, .b = b,
                      .spring = { localA, localB, rest, stiffness, damping } };
}

wfForce wfSpringToPoint(int32_t a, wfVec2 localA, wfVec2 point, wfReal rest,
                        wfReal stiffness, wfReal damping)
{
    return wfSpring(a, localA, -1, point, rest, stiffness, damping);
}
/* <make forces> */
wfForce wfBungee(int32_t a, wfVec2 localA, int32_t b, wfVec2 localB, wfReal rest,
                 wfReal stiffness, wfReal damping)
{
    wfForce f = wfSpring(a, localA, b, localB, rest, stiffness, damping);
    f.kind = WF_FORCE_BUNGEE;
    return f;
}
/* <make forces> */
wfForce wfDrag(wfReal linear, wfReal quadratic)
{
    return (wfForce){ .kind = WF_FORCE_DRAG, .a = -1, .b = -1,
                      .drag = { linear, quadratic } };
}

wfForce wfBuoyancy(wfReal surfaceY, wfReal density, wfReal g, wfReal drag)
{
    return (wfForce){ .kind = WF_FORCE_BUOYANCY, .a = -1, .b = -1,
                      .buoyancy = { surfaceY, density, g, drag } };
}

wfForce wfExplosion(wfVec2 centre, wfReal strength, wfReal radius, wfReal start,
                    wfReal duration)
{
    return (wfForce){ .kind = WF_FORCE_EXPLOSION, .a = -1, .b = -1,
                      .explosion = { centre, strength, radius, start, duration } };
}

wfForce wfWind(wfVec2 velocity, wfReal coefficient)
{
    return (wfForce){ .kind = WF_FORCE_WIND, .a = -1, .b = -1,
                      .wind = { velocity, coefficient } };
}
/* <check a force> */
wfResult wfCheckForce(const wfForce *f)
{
    if (!f) return WF_ERROR_NULL;
    if (f->kind < 0 || f->kind >= wfForceKinds) return WF_ERROR_UNKNOWN;
    const wfForceRow *row = &wfForceTable[f->kind];
    if (f->a < -1 || f->b < -1) return WF_ERROR_RANGE;
    for (int i = 0; i < row->params; i++)
        if (!wfIsFinite(f->param[i])) return WF_ERROR_NOT_FINITE;
    return row->check ? row->check(f) : WF_OK;
}
/* <add up forces> */
void wfAccumulateForces(const wfForce *forces, int n, const wfBodyView *bodies, wfReal time,
                        wfBodyForces *out)
{
    for (int i = 0; i < n; i++)
        wfForceTable[forces[i].kind].apply(&forces[i], bodies, time, out);
}

/* <add up forces> */
wfReal wfForceEnergy(const wfForce *forces, int n, const wfBodyView *bodies)
{
    wfReal sum = 0;
    for (int i = 0; i < n; i++) {
        const wfForceRow *row = &wfForceTable[forces[i].kind];
        if (row->energy) sum += row->energy(&forces[i], bodies);
    }
    return sum;
}
