/* Weft: lab/lab.c, tangled from chapters/04-design.nw. Chapters that add to it: 05-memory,
 * 06-numbers, 07-shapes, 08-bodies, 09-forces, 10-integration, 11-broad-phase, 12-narrow-phase,
 * 13-contacts, 14-impulses, 15-friction, 16-sequential, 17-soft, 18-joints, 19-exact, 20-compound,
 * 21-time-of-impact, 22-islands, 23-events-and-queries, 24-world, 25-joints-in-a-world,
 * 26-save-and-replay, 27-platform, 28-drawing, 30-scenes, 32-performance, 35-price-list. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include <stdio.h>
#include <string.h>
#include "lab/lab.h"
/* <headers of the measurements> */
#include "weft/draw.h"
/* <headers of the measurements> */
#include "lab/toy_heap.h"
/* <headers of the measurements> */
#include <stdlib.h>
#include <time.h>
/* <headers of the measurements> */
#include "weft/math.h"
/* <headers of the measurements> */
#include <math.h>
/* <headers of the measurements> */
#include "weft/shape.h"
/* <headers of the measurements> */
#include "weft/body.h"
/* <headers of the measurements> */
#include "weft/force.h"
/* <headers of the measurements> */
#include "weft/force.h"
#include "weft/integrate.h"
/* <headers of the measurements> */
#include "weft/broad.h"
/* <headers of the measurements> */
#include "weft/body.h"
#include "weft/integrate.h"
#include "weft/shape.h"
/* <headers of the measurements> */
#include "weft/narrow.h"
/* <headers of the measurements> */
#include "weft/contact.h"
/* <headers of the measurements> */
#include "weft/resolve.h"
/* <headers of the measurements> */
#include "weft/contact.h"
#include "weft/narrow.h"
#include "weft/resolve.h"
/* <headers of the measurements> */
#include <math.h>
/* <headers of the measurements> */
#include "weft/joint.h"
/* <headers of the measurements> */
#include "weft/contact.h"
#include "weft/narrow.h"
#include "weft/resolve.h"
/* <headers of the measurements> */
#include "weft/exact.h"
/* <headers of the measurements> */
#include "weft/compound.h"
/* <headers of the measurements> */
#include <math.h>
#include <time.h>
#include "lab/outlines.h"
/* <headers of the measurements> */
#include "weft/impact.h"
/* <headers of the measurements> */
#include "weft/island.h"
/* <headers of the measurements> */
#include "weft/events.h"
#include "weft/query.h"
/* <headers of the measurements> */
#include "weft/world.h"
/* <headers of the measurements> */
#include "weft/world.h"
/* <headers of the measurements> */
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "engine/image.h"
#include "weft/save.h"
/* <headers of the measurements> */
#include "weft/json.h"
/* <headers of the measurements> */
#include "testbed/platform.h"
#include "weft/integrate.h"
/* <headers of the measurements> */
#include <time.h>
#include "testbed/raster.h"
/* <headers of the measurements> */
#include "testbed/classics.h"
/* <headers of the measurements> */
#include <stdlib.h>
#include <time.h>
#include "engine/step.h"
#include "lab/loads.h"
/* <headers of the measurements> */
#include "dynamics/colour.h"
/* <headers of the measurements> */
#include <time.h>

/* <measurements> */
static int measure_design_list(FILE *out)
{
    _Alignas(8) static unsigned char memory[4096];
    static const float box[8] = { 0, 0, 1, 0, 1, 1, 0, 1 };
    wfDraw d;
    wfDrawInit(&d, memory, sizeof memory);
    fprintf(out, "command,bytes\n");
    /* <write the bytes that each kind of command takes> */
    wfDrawPoint(&d, 0, 0, 4, WF_INK_LINE);
    fprintf(out, "point,%zu\n", wfDrawBytes(&d));
    wfDrawReset(&d);
    wfDrawLine(&d, 0, 0, 1, 1, 1, WF_INK_LINE);
    fprintf(out, "line,%zu\n", wfDrawBytes(&d));
    wfDrawReset(&d);
    wfDrawCircle(&d, 0, 0, 1, 1, WF_INK_LINE, WF_INK_BODY);
    fprintf(out, "circle,%zu\n", wfDrawBytes(&d));
    wfDrawReset(&d);
    wfDrawPolygon(&d, box, 4, 1, WF_INK_LINE, WF_INK_BODY);
    fprintf(out, "polygon of 4 corners,%zu\n", wfDrawBytes(&d));
    wfDrawReset(&d);
    wfDrawText(&d, 0, 0, 13, WF_INK_TEXT, 0, "separation");
    fprintf(out, "text of 10 letters,%zu\n", wfDrawBytes(&d));
    return d.overflow + d.refused;
}
/* <measurements> */
static int measure_memory_holes(FILE *out)
{
    static ToyHeap heap;
    heap = (ToyHeap){ .requests = 0 };
    fprintf(out, "step,free cells,longest hole,failures so far\n");
    for (int step = 1; step <= 400; step++) {
        int longest;
        toy_step(&heap, step);
        toy_find(&heap, 1, &longest);
        if (step % 4 == 0)
            fprintf(out, "%d,%d,%d,%d\n", step, toy_free(&heap), longest, heap.failed);
    }
    return 0;
}
/* <measurements> */
enum { MEMORY_REQUESTS = 1000, MEMORY_ROUNDS = 400 };

static double seconds_of_malloc(size_t size)
{
    static void *volatile block[MEMORY_REQUESTS];
    clock_t start = clock();
    for (int round = 0; round < MEMORY_ROUNDS; round++) {
        for (int i = 0; i < MEMORY_REQUESTS; i++) block[i] = malloc(size);
        for (int i = 0; i < MEMORY_REQUESTS; i++) free(block[i]);
    }
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}

static double seconds_of_pool(wfPool *pool, size_t size)
{
    static void *volatile block[MEMORY_REQUESTS];
    clock_t start = clock();
    for (int round = 0; round < MEMORY_ROUNDS; round++) {
        size_t mark = wfPoolMark(pool);
        for (int i = 0; i < MEMORY_REQUESTS; i++) block[i] = wfPoolPush(pool, size, 8);
        wfPoolRewind(pool, mark);
    }
    return block[0] ? (double)(clock() - start) / CLOCKS_PER_SEC : 0;
}
/* <measurements> */
static int measure_memory_time(FILE *out)
{
    wfMemory memory;
    wfPool pool;
    if (wfAllocateMemory(&memory, 4096 * MEMORY_REQUESTS, 0) != WF_OK) return 1;
    wfPoolInit(&pool, memory.permanentSize, memory.permanent);
    fprintf(out, "bytes,malloc and free (ns),pool (ns)\n");
    for (size_t size = 16; size <= 4096; size *= 2) {
        double per = 1e9 / ((double)MEMORY_REQUESTS * MEMORY_ROUNDS);
        fprintf(out, "%zu,%.1f,%.1f\n", size, seconds_of_malloc(size) * per,
                seconds_of_pool(&pool, size) * per);
    }
    wfFreeMemory(&memory);
    return 0;
}
/* <measurements> */
static float next_float(float x)
{
    union { float real; uint32_t bits; } u = { x };
    u.bits++;
    return u.real;
}

static int measure_numbers_gap(FILE *out)
{
    fprintf(out, "distance (m),gap (m),slowest speed (m/s)\n");
    for (int i = 0; i <= 7; i++) {
        float x = 1;
        for (int k = 0; k < i; k++) x *= 10;
        double gap = (double)next_float(x) - (double)x;
        fprintf(out, "%.0f,%.1e,%.1e\n", (double)x, gap, gap / 2 * 60);
    }
    return 0;
}
/* <measurements> */
static float reduced_in_floats(float x)              /* what goes wrong first */
{
    float half_pi = 1.57079632679f, n = floorf(x / half_pi + 0.5f);
    return x - n * half_pi;
}

static double sine_error_in_floats(float x)
{
    double quarter = floor((double)x / 1.5707963267948966 + 0.5);
    double r = (double)reduced_in_floats(x), pick = quarter - 4 * floor(quarter / 4);
    double s = pick < 1 ? sin(r) : pick < 2 ? cos(r) : pick < 3 ? -sin(r) : -cos(r);
    return fabs(s - sin((double)x));
}
/* <measurements> */
static int measure_numbers_sine(FILE *out)
{
    wfRandom r;
    wfRandomSeed(&r, 1);
    fprintf(out, "largest angle,reduced in floats,wfSin\n");
    for (int half = 0; half <= 12; half++) {
        float top = half & 1 ? 3.1622777f : 1;
        for (int k = 0; k < half / 2; k++) top *= 10;
        double naive = 0, ours = 0;
        for (int i = 0; i < 20000; i++) {
            float x = (float)wfRandomReal(&r, 0, (wfReal)top);
            naive = fmax(naive, sine_error_in_floats(x));
            ours = fmax(ours, fabs((double)(float)wfSin((wfReal)x) - sin((double)x)));
        }
        fprintf(out, "%.0f,%.3g,%.3g\n", (double)top, naive, ours);
    }
    return 0;
}
/* <measurements> */
static int measure_numbers_drift(FILE *out)
{
    wfRot step = wfRotation(wfRadians(1)), plain = wfRotIdentity(), kept = plain;
    int done = 0;
    fprintf(out, "products,error of the length,normalised each time\n");
    for (int n = 10; n <= 1000000; n *= 10) {
        for (; done < n; done++) {
            plain = wfRotMul(step, plain);
            kept = wfRotNormalize(wfRotMul(step, kept));
        }
        double a = hypot((double)plain.c, (double)plain.s);
        double b = hypot((double)kept.c, (double)kept.s);
        fprintf(out, "%d,%.2g,%.2g\n", n, fabs(a - 1), fabs(b - 1));
    }
    return 0;
}
/* <measurements> */
typedef double NumbersTimed(double x);
static double timed_our_sine(double x)  { return (double)wfSin((wfReal)x); }
static double timed_your_sine(double x) { return (double)sinf((float)x); }
static double timed_our_atan(double x)  { return (double)wfAtan2((wfReal)x, 3); }
static double timed_your_atan(double x) { return (double)atan2f((float)x, 3); }
static double timed_our_exp(double x)   { return (double)wfExp((wfReal)-x); }
static double timed_your_exp(double x)  { return (double)expf((float)-x); }

static double nanoseconds_per_call(NumbersTimed *f)
{
    enum { CALLS = 2000000 };
    volatile double sink;
    double sum = 0;
    clock_t start = clock();
    for (int i = 0; i < CALLS; i++) sum += f((double)i * (10.0 / CALLS));
    sink = sum;
    (void)sink;
    return (double)(clock() - start) / CLOCKS_PER_SEC * 1e9 / CALLS;
}
/* <measurements> */
static int measure_numbers_time(FILE *out)
{
    fprintf(out, "function,ours (ns),C library (ns)\n");
    fprintf(out, "sine,%.1f,%.1f\n", nanoseconds_per_call(timed_our_sine),
            nanoseconds_per_call(timed_your_sine));
    fprintf(out, "arc tangent,%.1f,%.1f\n", nanoseconds_per_call(timed_our_atan),
            nanoseconds_per_call(timed_your_atan));
    fprintf(out, "exponential,%.1f,%.1f\n", nanoseconds_per_call(timed_our_exp),
            nanoseconds_per_call(timed_your_exp));
    return 0;
}
/* <measurements> */
/* <build a hull by turns, with a tolerance in metres> */
static int add_by_turn(wfVec2 *ring, int count, int least, wfVec2 p, double tolerance)
{
    while (count > least) {
        wfVec2 a = ring[count - 2], b = ring[count - 1];
        wfVec2 chord = wfNormalize(wfSub(p, a));
        if ((double)wfCross(wfSub(b, a), chord) > tolerance) break;
        count--;
    }
    ring[count] = p;
    return count + 1;
}

static int hull_by_turns(const wfVec2 *sorted, int n, double tolerance)
{
    wfVec2 ring[128];
    int count = 0, least = 1;
    for (int i = 0; i < n; i++)
        count = add_by_turn(ring, count, least, sorted[i], tolerance);
    least = count;
    for (int i = n - 2; i >= 0; i--)
        count = add_by_turn(ring, count, least, sorted[i], tolerance);
    return count - 1;
}

static int measure_shapes_flat(FILE *out)
{
    static const wfReal sizes[] = { 0.001f, 1, 1000, 100000 };
    fprintf(out, "size,none,metres,share\n");
    for (int s = 0; s < 4; s++) {
        wfReal size = sizes[s];
        wfVec2 p[60], hull[60];
        /* <put a littered polygon into an array, sorted> */
        int n = 0;
        for (int i = 0; i < 12; i++) {
            wfRot from = wfRotation(0.1f + WF_PI * (wfReal)i / 6);
            wfRot to = wfRotation(0.1f + WF_PI * (wfReal)(i + 1) / 6);
            wfVec2 a = wfV2(size / 2 * from.c, size / 2 * from.s);
            wfVec2 b = wfV2(size / 2 * to.c, size / 2 * to.s);
            for (int k = 0; k < 5; k++) p[n++] = wfLerp(a, b, (wfReal)k / 5);
        }
        for (int i = 1; i < n; i++)
            for (int k = i; k > 0 && p[k].x < p[k - 1].x; k--) {
                wfVec2 swap = p[k];
                p[k] = p[k - 1];
                p[k - 1] = swap;
            }
        fprintf(out, "%g,%d,%d,%d\n", (double)size, hull_by_turns(p, n, 0),
                hull_by_turns(p, n, 1e-4), wfConvexHull(p, n, hull));
    }
    return 0;
}
/* <measurements> */
/* <measure mass far from the origin, the wrong way> */
static double naive_inertia(const wfVec2 *p, int n, double *area)
{
    wfReal a = 0, j = 0;
    wfVec2 moment = wfV2(0, 0);
    for (int i = 0; i < n; i++) {
        wfVec2 u = p[i], v = p[(i + 1) % n];
        wfReal cross = wfCross(u, v);
        a += cross / 2;
        moment = wfAddScaled(moment, cross / 6, wfAdd(u, v));
        j += cross * (wfLengthSq(u) + wfDot(u, v) + wfLengthSq(v)) / 12;
    }
    *area = (double)a;
    return (double)(j - wfLengthSq(moment) / a);    /* J - A |c|^2 */
}

static double relative(double got, double want)
{
    return got > want ? got / want - 1 : 1 - got / want;
}

static int measure_shapes_far(FILE *out)
{
    /* <prepare the far rectangle and its true numbers> */
    static const wfReal x[4] = { 0, 1.4375f, 1.4375f, 0 };
    static const wfReal y[4] = { 0, 0, 0.6875f, 0.6875f };
    const double w = 1.4375, h = 0.6875;
    const double area = w * h, inertia = area * (w * w + h * h) / 12;
    fprintf(out, "distance,naive area,naive inertia,engine area,engine inertia\n");
    for (int far = 1; far <= 1000; far *= 10) {
        wfVec2 p[4];
        wfShape s;
        wfMassData d;
        double a;
        wfVec2 away = wfV2((wfReal)far, (wfReal)far);
        for (int i = 0; i < 4; i++) p[i] = wfAdd(away, wfV2(x[i], y[i]));
        double j = naive_inertia(p, 4, &a);
        if (wfMakePolygon(p, 4, &s) != WF_OK || wfShapeMass(&s, 1, &d) != WF_OK) return 1;
        /* <print the four relative errors> */
        fprintf(out, "%d,%.2g,%.2g,%.2g,%.2g\n", far, relative(a, area), relative(j, inertia),
                relative((double)d.area, area), relative((double)d.inertia, inertia));
    }
    return 0;
}
/* <measurements> */
static int measure_shapes_capsule(FILE *out)
{
    fprintf(out, "corners,area,inertia\n");
    wfShape capsule, polygon;
    wfMassData want, got;
    if (wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), 1, &capsule) != WF_OK) return 1;
    if (wfShapeMass(&capsule, 1, &want) != WF_OK) return 1;
    for (int n = 4; n <= WF_MAX_VERTICES; n += 4) {
        wfVec2 p[WF_MAX_VERTICES];
        for (int i = 0; i < n; i++) {
            int end = i < n / 2, k = end ? i : i - n / 2;
            wfReal turn = WF_PI * (wfReal)k / (wfReal)(n / 2 - 1) - WF_PI / 2;
            wfRot q = wfRotation(end ? turn : turn + WF_PI);
            p[i] = wfV2(q.c + (end ? 1 : -1), q.s);
        }
        if (wfMakePolygon(p, n, &polygon) != WF_OK) return 1;
        if (wfShapeMass(&polygon, 1, &got) != WF_OK) return 1;
        fprintf(out, "%d,%.3f,%.3f\n", n, (double)(got.area / want.area),
                (double)(got.inertia / want.inertia));
    }
    return 0;
}
/* <measurements> */
static int measure_bodies_sizes(FILE *out)
{
    fprintf(out, "structure,bytes\n");
    fprintf(out, "state (hot),%zu\n", sizeof(wfBodyState));
    fprintf(out, "sums of force and torque,%zu\n", sizeof(wfBodyForces));
    fprintf(out, "properties (cold),%zu\n", sizeof(wfBodyProps));
    fprintf(out, "shape (cold),%zu\n", sizeof(wfShape));
    return 0;
}
/* <measurements> */
static int measure_bodies_damping(FILE *out)
{
    static const int steps[] = { 2, 4, 8, 20, 60, 120, 480 };
    const wfReal c = 3, total = 2;
    fprintf(out, "step,one minus ch,one over one plus ch,exponential,exact\n");
    for (int i = 0; i < 7; i++) {
        wfReal h = total / (wfReal)steps[i], minus = 1, over = 1;
        wfBodyState s = { .v = { { 1, 0 } } };
        for (int k = 0; k < steps[i]; k++) {
            minus *= 1 - c * h;                                 /* eq:bodies-euler */
            over /= 1 + c * h;
            wfDampVelocity(&s, c, 0, h);
        }
        fprintf(out, "%.4g,%.4g,%.4g,%.4g,%.4g\n", (double)h, (double)minus, (double)over,
                (double)s.v.x, (double)wfExp(-c * total));
    }
    return 0;
}
/* <measurements> */
/* <float a box by one of three rules> */
enum { FLOAT_SIGN, FLOAT_DEPTH, FLOAT_EXACT, FLOAT_RULES };

/* A box of 1.2 m by 0.6 m and density 1 in water of density 2 below y = 0; g = 10. */
static wfBodyState float_begin(wfShape *box)
{
    wfMassData data = { .mass = 1, .inertia = 1 };
    if (wfMakeBox(0.6f, 0.3f, box) == WF_OK) (void)wfShapeMass(box, 1, &data);
    return (wfBodyState){ .p = { { 0, 0.5f } }, .angle = 0.5f, .invMass = 1 / data.mass,
                          .invInertia = 1 / data.inertia };
}

static void float_step(int rule, const wfShape *box, wfBodyState *b, wfReal h)
{
    wfBodyProps props = wfDefaultBodyProps();
    wfBodyForces sum = { .torque = 0 };
    wfForce f[2] = { wfGravity(wfV2(0, -10)), wfBuoyancy(0, 2, 10, 4) };
    wfReal full = 20 * wfShapeArea(box);  /* the lift when all is under water */
    props.shape = 0;
    wfBodyView view = { .count = 1, .state = b, .props = &props, .shapes = box };
    wfAccumulateForces(f, rule == FLOAT_EXACT ? 2 : 1, &view, 0, &sum);
    if (rule == FLOAT_SIGN && b->p.y < 0) sum.force.y += full;
    if (rule == FLOAT_DEPTH) sum.force.y += full * wfClamp(0.5f - b->p.y / WF_R(0.6), 0, 1);
    b->v = wfAddScaled(b->v, h * b->invMass, sum.force);
    b->w += h * b->invInertia * sum.torque;
    b->p = wfAddScaled(b->p, h, b->v);
    b->angle += h * b->w;
}

/* Rounded to thousandths, and a zero without a sign. */
static double thousandths(wfReal x)
{
    return (double)(long)((double)x * 1000 + (x < 0 ? -0.5 : 0.5)) / 1000;
}

static int measure_forces_float(FILE *out)
{
    static const char *const name[FLOAT_RULES] = { "centre under water",
                                                   "depth of the centre",
                                                   "exact with drag" };
    fprintf(out, "rule,time,height,tilt,speed\n");
    for (int rule = 0; rule < FLOAT_RULES; rule++) {
        wfShape box;
        wfBodyState b = float_begin(&box);
        for (int i = 1; i <= 1800; i++) {
            float_step(rule, &box, &b, WF_R(1.0) / 60);
            if (i == 60 || i == 300 || i == 1800)
                fprintf(out, "%s,%d,%.3f,%.3f,%.3f\n", name[rule], i / 60,
                        thousandths(b.p.y), thousandths(b.angle),
                        thousandths(wfLength(b.v)));
        }
    }
    return 0;
}
/* <measurements> */
/* The area of a unit circle's part below the depth d = root^2 from its lowest point. */
static double sliver_area(double root)
{
    double d = root * root, binomial = 1, power = 1, sum = 0;
    for (int k = 0; k < 60; k++) {
        sum += binomial * power / (2 * k + 3);
        binomial *= (0.5 - k) / (k + 1);
        power *= -d / 2;
    }
    return 4 * 1.4142135623730951 * root * d * sum;
}

static int measure_forces_sliver(FILE *out)
{
    wfShape ball;
    if (wfMakeCircle(wfV2(0, 0), 1, &ball) != WF_OK) return 1;
    fprintf(out, "depth,naive,engine,centre,true\n");
    double root = 0.5;
    for (int k = 1; k <= 12; k++, root /= 2) {
        wfReal u = (wfReal)(1 - root * root), sine = wfSqrt((1 - u) * (1 + u));
        wfReal area = wfAtan2(sine, u) - sine * u;      /* as it stands in the formula */
        wfReal centre = area == 0 ? 0 : 2 * sine * sine * sine / (3 * area);
        wfSubmerged part = wfSubmergedPart(&ball, wfMakeTransform(wfV2(0, 0), 0), -u);
        double truth = sliver_area(root), s = (double)sine;
        fprintf(out, "%.2e,%.1e,%.1e,%.4f,%.4f\n", root * root, (double)area / truth - 1,
                (double)part.area / truth - 1, (double)centre, 2 * s * s * s / 3 / truth);
    }
    return 0;
}
/* <measurements> */
/* exp(re) (cos(im) + i sin(im)) by its power series; good to 1e-12 for |re|, |im| <= 10. */
static void orbit_exp(double re, double im, double *cosine, double *sine)
{
    double x = 1, y = 0;
    *cosine = 1, *sine = 0;
    for (int k = 1; k < 80; k++) {
        double nx = (x * re - y * im) / k;
        y = (x * im + y * re) / k;
        x = nx;
        *cosine += x, *sine += y;
    }
}

static void exact_spring(double t, double *x, double *y)
{
    orbit_exp(0, t, x, y);
    *y *= 0.5;
}
/* <measurements> */
static void exact_orbit(double t, double *x, double *y)  /* Kepler: E - e sin E = t */
{
    double e = 0.3, ecc = t, c, s;
    for (int i = 0; i < 50; i++) {
        orbit_exp(0, ecc, &c, &s);
        ecc -= (ecc - e * s - t) / (1 - e * c);
    }
    orbit_exp(0, ecc, &c, &s);
    *x = c - e;
    *y = 0.95393920141694565 * s;                               /* sqrt(1 - e^2) */
}

static void exact_drag(double t, double *x, double *y)
{
    double q, none;
    orbit_exp(-2 * t, 0, &q, &none);
    *x = 3 * (1 - q) / 2;
    *y = -5 * t + 5 * (1 - q) / 2;
}
/* <measurements> */
typedef struct MotionProblem {
    const char *name;
    double span;                                    /* s */
    wfBodyState start;
    void (*exact)(double t, double *x, double *y);
    wfForce forces[2];
    int forceCount;
} MotionProblem;

enum { MOTION_PROBLEMS = 3 };

static void motion_problems(MotionProblem *out)
{
    wfVec2 o = wfV2(0, 0);
    out[0] = (MotionProblem){ "spring", 10,
        { .p = { { 1, 0 } }, .v = { { 0, 0.5f } }, .invMass = 1 },
        exact_spring, { wfSpringToPoint(0, o, o, 0, 1, 0) }, 1 };
    out[1] = (MotionProblem){ "orbit", 5,
        { .p = { { WF_R(0.7), 0 } }, .v = { { 0, WF_R(1.3627702877384937) } },
          .invMass = 1 },
        exact_orbit, { wfPointGravity(o, 1, 0) }, 1 };
    out[2] = (MotionProblem){ "drag", 1.7, { .v = { { 3, 0 } }, .invMass = 1 },
        exact_drag, { wfGravity(wfV2(0, -10)), wfDrag(2, 0) }, 2 };
}
/* <measurements> */
typedef struct MotionRun {
    const MotionProblem *problem;
    wfBodyState body;
    wfBodyProps props;
    long evaluations;
    _Alignas(WF_POOL_ALIGN) uint8_t scratch[2048];
} MotionRun;

static void motion_forces(void *context, const wfBodyState *state, int count, wfReal time,
                          wfBodyForces *out)
{
    MotionRun *run = context;
    wfBodyView view = { .count = count, .state = state, .props = &run->props };
    run->evaluations++;
    wfAccumulateForces(run->problem->forces, run->problem->forceCount, &view, time, out);
}

static void motion_begin(MotionRun *run, const MotionProblem *problem)
{
    run->problem = problem;
    run->body = problem->start;
    run->props = wfDefaultBodyProps();
    run->evaluations = 0;
}
/* <measurements> */
static wfResult motion_step(MotionRun *run, int row, double time, double h)
{
    wfPool pool;
    wfResult result = wfPoolInit(&pool, sizeof run->scratch, run->scratch);
    wfIntegration in = { .state = &run->body, .count = 1, .time = (wfReal)time,
                         .h = (wfReal)h, .forces = motion_forces, .context = run,
                         .scratch = &pool };
    return result == WF_OK ? wfIntegrate(row, &in) : result;
}
/* <measurements> */
/* The error at the end of so many steps; negative if a step failed. */
static double motion_error(MotionRun *run, const MotionProblem *problem, int row, int steps)
{
    double h = problem->span / steps, x, y;
    motion_begin(run, problem);
    for (int i = 0; i < steps; i++)
        if (motion_step(run, row, i * h, h) != WF_OK) return -1;
    problem->exact(problem->span, &x, &y);
    wfReal dx = (wfReal)((double)run->body.p.x - x);
    wfReal dy = (wfReal)((double)run->body.p.y - y);
    return (double)wfLength(wfV2(dx, dy));
}
/* <measurements> */
static int measure_integrators_order(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    motion_problems(problem);
    fprintf(out, "problem,method,steps,h,evaluations,error\n");
    for (int p = 0; p < MOTION_PROBLEMS; p++)
        for (int row = 0; row < wfIntegratorCount; row++)
            for (int steps = 8; steps <= 65536; steps *= 2) {
                double e = motion_error(&run, &problem[p], row, steps);
                /* no convergence, or far off: not on the plot */
                if (e < 0 || e > 10) continue;
                fprintf(out, "%s,%s,%d,%.6e,%ld,%.4e\n", problem[p].name,
                        wfIntegratorTable[row].name, steps, problem[p].span / steps,
                        run.evaluations, e);
            }
    return 0;
}
/* <measurements> */
static double motion_log2(double x)  /* 2 atanh((x - 1)/(x + 1)) / ln 2, x > 0 */
{
    int n = 0;
    for (; x >= 2; x /= 2) n++;
    for (; x < 1; x *= 2) n--;
    double q = (x - 1) / (x + 1), power = q, sum = 0;
    for (int k = 1; k < 60; k += 2, power *= q * q) sum += power / k;
    return n + 2 * sum / 0.69314718055994531;
}

/* The slope of log error over log h, fitted to the steps with errors of least to 0.03. */
static double motion_slope(MotionRun *run, const MotionProblem *problem, int row,
                           double least)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int steps = 4; steps <= 65536; steps *= 2) {
        double e = motion_error(run, problem, row, steps);
        if (e >= 0 && e < least) break;
        if (e < 0 || e > 0.03) continue;
        double x = -motion_log2(steps), y = motion_log2(e);
        n++, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return n < 2 ? 0 : (n * sxy - sx * sy) / (n * sxx - sx * sx);
}
/* <measurements> */
static int measure_integrators_slopes(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    double least = 200 * (double)WF_EPSILON;
    if (least < 1e-10) least = 1e-10;       /* what the reference is good for, in double */
    motion_problems(problem);
    fprintf(out, "method,order,spring,orbit,drag\n");
    for (int row = 0; row < wfIntegratorCount; row++) {
        fprintf(out, "%s,%d", wfIntegratorTable[row].name, wfIntegratorTable[row].order);
        for (int p = 0; p < MOTION_PROBLEMS; p++)
            fprintf(out, ",%.2f", motion_slope(&run, &problem[p], row, least));
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static double motion_energy(const MotionRun *run)
{
    wfBodyView view = { .count = 1, .state = &run->body, .props = &run->props };
    return (double)wfKineticEnergy(&run->body)
         + (double)wfForceEnergy(run->problem->forces, run->problem->forceCount, &view);
}

/* The largest relative error of the energy during one turn. */
static double motion_turn(MotionRun *run, int row, int steps, double start)
{
    double worst = 0;
    for (int i = 0; i < steps; i++) {
        if (motion_step(run, row, 0, 6.2831853071795865 / steps) != WF_OK) return -1;
        double e = motion_energy(run) / start - 1;
        worst = e > worst ? e : -e > worst ? -e : worst;
    }
    return worst;
}
/* <measurements> */
static int measure_integrators_energy(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    motion_problems(problem);
    fprintf(out, "method,turn,error\n");
    for (int row = 0; row < wfIntegratorCount; row++) {
        motion_begin(&run, &problem[1]);
        double start = motion_energy(&run);
        for (int turn = 1, next = 1; turn <= 1000; turn++) {
            double e = motion_turn(&run, row, 60, start);
            if (turn < next) continue;
            if (e >= 0) fprintf(out, "%s,%d,%.4e\n", wfIntegratorTable[row].name, turn, e);
            next = next + next / 3 + 1;
        }
    }
    return 0;
}
/* <measurements> */
static int measure_integrators_midpoint(FILE *out)
{
    static MotionRun run;
    MotionProblem problem[MOTION_PROBLEMS];
    static const double h[] = { 0.1, 0.25, 0.5, 1, 1.5, 2, 3, 10, 100, 1000 };
    int row = wfFindIntegrator("implicit-midpoint");
    motion_problems(problem);
    fprintf(out, "omega_h,evaluations,failed,energy\n");
    for (int i = 0; i < 10; i++) {
        motion_begin(&run, &problem[0]);
        double start = motion_energy(&run), worst = 0;
        int failed = 0;
        for (int k = 0; k < 1000; k++) {
            if (motion_step(&run, row, 0, h[i]) != WF_OK) failed++;
            double e = motion_energy(&run) / start - 1;
            worst = e > worst ? e : -e > worst ? -e : worst;
        }
        fprintf(out, "%g,%.1f,%d,%.2g\n", h[i], (double)run.evaluations / 1000, failed,
                worst);
    }
    return 0;
}
/* <measurements> */
enum { BROAD_MOST = 100000, BROAD_PAIRS = 1 << 20, BROAD_SCENES = 5, BROAD_FRAMES = 8 };
enum { BROAD_FREE = 10000 };                     /* so many circles fly freely */
static const char *const broadScenes[] = { "uniform", "mixed", "clustered", "tower",
                                           "crowd" };

typedef struct BroadWorld {
    wfRect bounds[BROAD_MOST];
    uint8_t flags[BROAD_MOST];
    wfPair pairs[BROAD_PAIRS], others[BROAD_PAIRS];
    _Alignas(WF_POOL_ALIGN) uint8_t scratch[1 << 25], index[1 << 25];
    wfRect frames[BROAD_FRAMES][BROAD_MOST];             /* the same boxes, moving on */
    wfBodyState states[BROAD_FREE];
} BroadWorld;

static BroadWorld *broadWorld(void)      /* one for all measurements: it is large */
{
    static BroadWorld world;
    return &world;
}
/* <measurements> */
static void fillBroadWorld(BroadWorld *world, int n, int scene, int frame)
{
    wfRandom random;
    wfRandomSeed(&random, 11);
    wfReal side = 2 * wfSqrt((wfReal)n);
    for (int i = 0; i < n; i++) {
        wfReal x = wfRandomReal(&random, 0, side), y = wfRandomReal(&random, 0, side);
        wfReal w = wfRandomReal(&random, WF_R(0.5), WF_R(1.5));
        wfReal vx = wfRandomReal(&random, -1, 1), vy = wfRandomReal(&random, -1, 1);
        wfReal t = (wfReal)frame / 60;
        world->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
        /* <place box i of the scene> */
        if (scene == 1) w = WF_R(0.3) / wfRandomReal(&random, WF_R(0.02), 1);
        if (scene == 2) {
            wfRandom place;
            wfRandomSeed(&place, 1000 + (uint64_t)i / 50);
            x = 5 * x / side + wfRandomReal(&place, 0, 7 * side) + wfRandomReal(&random, 0, 5);
            y = 5 * y / side + wfRandomReal(&place, 0, 7 * side) + wfRandomReal(&random, 0, 5);
        }
        if (scene == 3) {
            x = x / (10 * side);
            y = (wfReal)i;
            w = 1;
        }
        if (scene == 4) {
            x = x / 2;
            y = y / 2;
            w = WF_R(0.6);
            if (i % 10 == 0) world->flags[i] = WF_PROXY_LIVE;                /* a pillar */
        }
        if (scene != 3 && (world->flags[i] & WF_PROXY_MOVES)) x += vx * t, y += vy * t;
        world->bounds[i] = wfRectCenterDim(wfV2(x, y), wfV2(w, w));
    }
    if (scene != 3) return;
    world->bounds[0] = wfRectMinMax(wfV2(-10, -1), wfV2(10, WF_R(0.5)));     /* a floor */
    world->flags[0] = WF_PROXY_LIVE;
}
/* <measurements> */
/* how many tests a rule of the quad tree takes, or -1; *pairs: how many pairs it finds */
static int64_t countByTree(BroadWorld *world, int n, wfQuadReach reach, int *pairs)
{
    wfProxies in = { .count = n, .bounds = world->bounds, .flags = world->flags };
    wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
    wfPool pool;
    wfQuadTree tree;
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return -1;
    if (wfQuadTreeBuild(&tree, &pool, &in) != WF_OK) return -1;
    if (reach == WF_QUAD_SAME_NODE) {
        /* <build the report's tree, which has no buckets> */
        wfQuadTreeDef def = { wfQuadTreeRect(&tree, 0), n, 8 * n, WF_QUAD_MAX_DEPTH, 0 };
        wfPoolReset(&pool);
        if (wfQuadTreeInit(&tree, &pool, &def) != WF_OK) return -1;
        for (int i = 0; i < n; i++) wfQuadTreeInsert(&tree, i, world->bounds[i]);
    }
    if (wfQuadTreePairs(&tree, reach, &in, &list) != WF_OK) return -1;
    *pairs = list.count;
    return list.tests;
}
/* <measurements> */
static int64_t countByRow(BroadWorld *world, int row, int n, wfPair *to, int *pairs)
{
    wfProxies in = { .count = n, .bounds = world->bounds, .flags = world->flags };
    wfPairList list = { to, 0, BROAD_PAIRS, 0 };
    wfPool pool;
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return -1;
    if (wfFindPairs(row, &in, &pool, &list) != WF_OK) return -1;
    *pairs = list.count;
    return list.tests;
}
/* <measurements> */
enum { BROAD_OTHERS = 5, BROAD_COLUMNS = 4 + BROAD_OTHERS };
static const char *const broadOthers[] = { "grid", "spatial-hash", "sweep-and-prune",
                                           "aabb-tree", "dynamic-tree" };

/* <measurements> */
/* fills the columns; false if a method failed or found other pairs */
static bool countBroadTests(BroadWorld *world, int n, int64_t *now, int *pairs, int *report)
{
    int found[BROAD_COLUMNS] = { 0 };
    wfProxies in = { .count = n, .bounds = world->bounds, .flags = world->flags };
    wfPairList list = { world->others, 0, BROAD_PAIRS, 0 };
    wfPool pool;
    bool same = true;
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return false;
    if (wfSweepAlong(0, &in, &pool, &list) != WF_OK) return false;
    now[BROAD_COLUMNS - 1] = list.tests;
    found[BROAD_COLUMNS - 1] = list.count;
    if (countByTree(world, n, WF_QUAD_SAME_NODE, report) < 0) return false;
    now[1] = countByTree(world, n, WF_QUAD_CLIMB, &found[1]);
    now[2] = countByTree(world, n, WF_QUAD_DESCEND, &found[2]);
    now[0] = countByRow(world, wfFindBroadPhase("brute-force"), n, world->pairs, &found[0]);
    for (int k = 0; k < BROAD_OTHERS; k++) {
        int row = wfFindBroadPhase(broadOthers[k]);
        now[3 + k] = countByRow(world, row, n, world->others, &found[3 + k]);
        size_t bytes = (size_t)found[0] * sizeof *world->pairs;
        same = same && memcmp(world->pairs, world->others, bytes) == 0;
    }
    for (int k = 1; k < BROAD_COLUMNS; k++)
        same = same && found[k] == found[0] && now[k] >= 0;
    *pairs = found[0];
    return same;
}
/* <measurements> */
static int measureBroadScene(FILE *out, BroadWorld *world, int scene)
{
    int64_t before[BROAD_COLUMNS] = { 0 }, now[BROAD_COLUMNS];
    for (int n = 10; n <= 5120; n *= 2) {
        int pairs = 0, report = 0;
        fillBroadWorld(world, n, scene, 0);
        if (!countBroadTests(world, n, now, &pairs, &report)) return 1;
        fprintf(out, "%s,%d,%d,%d", broadScenes[scene], n, pairs, report);
        for (int k = 0; k < BROAD_COLUMNS; k++) {
            fprintf(out, ",%lld,", (long long)now[k]);
            if (before[k]) fprintf(out, "%.2f", (double)now[k] / (double)before[k]);
            before[k] = now[k];
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static int measure_broad_pairs(FILE *out)
{
    int failed = 0;
    fprintf(out, "scene,n,pairs,report,brute,brute_growth,climb,climb_growth,"
                 "descend,descend_growth,grid,grid_growth,hash,hash_growth,"
                 "sweep,sweep_growth,boxes,boxes_growth,dynamic,dynamic_growth,"
                 "sweep_x,sweep_x_growth\n");
    for (int scene = 0; scene < BROAD_SCENES && !failed; scene++)
        failed = measureBroadScene(out, broadWorld(), scene);
    return failed;
}
/* <measurements> */
static void fillBroadFrames(BroadWorld *world, int n, int scene)
{
    for (int frame = BROAD_FRAMES - 1; frame >= 0; frame--) {
        fillBroadWorld(world, n, scene, frame);
        memcpy(world->frames[frame], world->bounds, (size_t)n * sizeof *world->bounds);
    }
}

/* the frames forth and back: 0 1 2 ... 6 7 6 ... 1 0 1 ... */
static const wfRect *broadFrame(const BroadWorld *world, int call)
{
    int k = call % (2 * BROAD_FRAMES - 2);
    return world->frames[k < BROAD_FRAMES ? k : 2 * BROAD_FRAMES - 2 - k];
}
/* <measurements> */
/* updates the index, if the row has one, and finds the pairs */
static bool stepBroadRow(BroadWorld *world, int row, const wfProxies *in, wfPairList *list)
{
    wfPool pool;
    size_t bytes = wfIndexSize(row, in->count);
    void *index = bytes > 0 ? world->index : NULL;
    if (bytes > sizeof world->index) return false;
    return wfPoolInit(&pool, sizeof world->scratch, world->scratch) == WF_OK
        && wfUpdateIndex(row, in, index, bytes, &pool) == WF_OK
        && wfIndexPairs(row, in, index, &pool, list) == WF_OK;
}
/* <measurements> */
/* the time of one step in s, by row, in batches that last a millisecond; -1: failed */
static double timeBroadRow(BroadWorld *world, int row, int n, int *pairs)
{
    enum { RUNS = 7 };
    double seconds[RUNS];
    int batch = 1, calls = 0;
    memset(world->index, 0, 2 * WF_POOL_ALIGN);           /* a new index */
    for (int run = -1; run < RUNS;) {                     /* one run to warm up */
        clock_t start = clock();
        for (int i = 0; i < batch; i++) {
            wfProxies in = { .count = n, .bounds = broadFrame(world, calls++),
                             .flags = world->flags };
            wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
            if (!stepBroadRow(world, row, &in, &list)) return -1;
            *pairs = list.count;
        }
        double took = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (run < 0 && took < 0.001 && batch < 1 << 20) { batch *= 2; continue; }
        int k = run++;
        for (; k > 0 && seconds[k - 1] > took / batch; k--) seconds[k] = seconds[k - 1];
        if (k >= 0) seconds[k] = took / batch;
    }
    return seconds[RUNS / 2];
}

/* <measurements> */
/* the time of one box test of brute force, s */
static double timeBoxTest(BroadWorld *world)
{
    int pairs, row = wfFindBroadPhase("brute-force");
    fillBroadFrames(world, 1000, 0);
    return timeBroadRow(world, row, 1000, &pairs) / (500.0 * 999);
}
/* <measurements> */
enum { BROAD_ROWS = 64 };                /* more rows than the table will ever have */

static int timeBroadScene(FILE *out, BroadWorld *world, int scene)
{
    double last[BROAD_ROWS] = { 0 }, before[BROAD_ROWS] = { 0 }, now[BROAD_ROWS];
    for (int n = 10; n <= BROAD_MOST; n *= 10) {
        int pairs = 0;
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            now[row] = 0;                /* left out: it would take too long */
            bool slow = before[row] > 0 && last[row] * last[row] / before[row] > 4e8;
            if (slow || (n > 100 && last[row] <= 0)) continue;
            double unit = timeBoxTest(world);
            fillBroadFrames(world, n, scene);
            double took = timeBroadRow(world, row, n, &pairs);
            if (took < 0) return 1;
            now[row] = took / (0.5 * (unit + timeBoxTest(world)));
        }
        fprintf(out, "%s,%d,%d", broadScenes[scene], n, pairs);
        for (int row = 0; row < wfBroadPhaseCount; row++) {
            /* <write the time of a row and its exponent> */
            double each = now[row] / n;
            if (now[row] > 0) fprintf(out, each < 100 ? ",%.1f," : ",%.0f,", each);
            else fprintf(out, ",,");
            if (now[row] > 0 && last[row] > 0)                    /* eq:broad-exponent */
                fprintf(out, "%.2f", log10(now[row] / last[row]));
            before[row] = last[row];
            last[row] = now[row];
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static int measure_broad_time(FILE *out)
{
    int failed = 0;
    fprintf(out, "scene,n,pairs");
    for (int row = 0; row < wfBroadPhaseCount; row++)
        fprintf(out, ",%s,%s growth", wfBroadPhaseTable[row].name,
                wfBroadPhaseTable[row].name);
    fprintf(out, "\n");
    for (int scene = 0; scene < BROAD_SCENES && !failed; scene++)
        failed = timeBroadScene(out, broadWorld(), scene);
    return failed;
}
/* <measurements> */
static void noForces(void *context, const wfBodyState *state, int count, wfReal time,
                     wfBodyForces *out)
{
    (void)context, (void)state, (void)time;
    memset(out, 0, (size_t)count * sizeof *out);
}

static void fillFree(BroadWorld *world)
{
    wfRandom random;
    wfRandomSeed(&random, 5);
    for (int i = 0; i < BROAD_FREE; i++) {
        wfReal x = wfRandomReal(&random, 0, 400), y = wfRandomReal(&random, 0, 400);
        wfReal vx = wfRandomReal(&random, -5, 5), vy = wfRandomReal(&random, -5, 5);
        world->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
        world->states[i] = (wfBodyState){ .p = wfV2(x, y), .v = wfV2(vx, vy), .invMass = 1,
                                          .invInertia = 1 };
    }
    memset(world->index, 0, 2 * WF_POOL_ALIGN);
}
/* <measurements> */
/* moves all circles on by a sixtieth of a second and finds their boxes */
static bool moveFree(BroadWorld *world, const wfShape *circle)
{
    wfPool pool;
    wfIntegration in = { world->states, BROAD_FREE, 0, 1 / WF_R(60.0), noForces, NULL,
                         &pool };
    if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK
        || wfIntegrate(wfFindIntegrator("symplectic-euler"), &in) != WF_OK) return false;
    for (int i = 0; i < BROAD_FREE; i++)
        world->bounds[i] = wfShapeBounds(circle, wfBodyTransform(&world->states[i]));
    return true;
}
/* <measurements> */
/* medians of the times of moving and of the broad phase, in s; false if it failed */
static bool timeFree(BroadWorld *world, int row, double *move, double *find, int *pairs)
{
    enum { RUNS = 61, BEFORE = 10 };
    double moves[RUNS], finds[RUNS];
    wfProxies in = { .count = BROAD_FREE, .bounds = world->bounds, .flags = world->flags };
    wfShape circle;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.5), &circle) != WF_OK) return false;
    fillFree(world);
    for (int run = -BEFORE; run < RUNS; run++) {
        wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
        clock_t start = clock();
        if (!moveFree(world, &circle)) return false;
        clock_t middle = clock();
        if (!stepBroadRow(world, row, &in, &list)) return false;
        clock_t end = clock();
        *pairs = list.count;
        /* <enter both times in rising order> */
        double a = (double)(middle - start) / CLOCKS_PER_SEC;
        double b = (double)(end - middle) / CLOCKS_PER_SEC;
        if (run < 0) continue;
        int j = run, k = run;
        for (; j > 0 && moves[j - 1] > a; j--) moves[j] = moves[j - 1];
        for (; k > 0 && finds[k - 1] > b; k--) finds[k] = finds[k - 1];
        moves[j] = a;
        finds[k] = b;
    }
    *move = moves[RUNS / 2];
    *find = finds[RUNS / 2];
    return true;
}
/* <measurements> */
static int measure_broad_free(FILE *out)
{
    BroadWorld *world = broadWorld();
    fprintf(out, "method,pairs,move,broad,step,tests\n");
    for (int row = 1; row < wfBroadPhaseCount; row++) {
        double move = 0, find = 0, unit = timeBoxTest(world);
        int pairs = 0;
        if (!timeFree(world, row, &move, &find, &pairs)) return 1;
        unit = 0.5 * (unit + timeBoxTest(world));
        fprintf(out, "%s,%d,%.2f,%.2f,%.2f,%.0f\n", wfBroadPhaseTable[row].name, pairs,
                1e3 * move, 1e3 * find, 1e3 * (move + find),
                (move + find) / BROAD_FREE / unit);
    }
    return 0;
}
/* <measurements> */
/* moves the circles once; returns how many left their boxes and got new ones */
static int64_t flyOn(BroadWorld *world, wfTree *tree, int n, int step, wfReal ratio)
{
    int64_t changes = 0;
    for (int i = 0; i < n; i++) {
        const wfBodyState *b = &world->states[i];
        wfVec2 way = wfScale(1 / WF_R(60.0), b->v), half = wfV2(WF_R(0.5), WF_R(0.5));
        wfRect r = wfRectCenterHalfDim(wfAddScaled(b->p, (wfReal)step, way), half);
        world->bounds[i] = r;
        wfRect fat = wfFatBox(r, way, ratio);
        if (!wfTreeHolds(tree, i)) wfTreeInsert(tree, i, fat, true);
        else if (wfRectContains(tree->nodes[i].box, r)) continue;
        else if (wfTreeMove(tree, i, fat) == WF_OK) changes++;
    }
    return changes;
}
/* <measurements> */
static int measure_broad_fat(FILE *out)
{
    enum { FLYERS = 2000, STEPS = 100 };
    BroadWorld *world = broadWorld();
    wfProxies in = { .count = FLYERS, .bounds = world->bounds, .flags = world->flags };
    fprintf(out, "ratio,changes,tests\n");
    for (double ratio = 0.25; ratio <= 64; ratio *= 2) {
        wfTree tree;
        int64_t changes = 0, tests = 0;
        fillFree(world);
        /* <fly with this ratio and count> */
        if (wfTreeInit(&tree, world->index, sizeof world->index, FLYERS) != WF_OK) return 1;
        for (int step = -STEPS; step < STEPS; step++) {          /* the first half is not counted */
            wfPool pool;
            wfPairList list = { world->pairs, 0, BROAD_PAIRS, 0 };
            int64_t changed = flyOn(world, &tree, FLYERS, step, (wfReal)ratio);
            if (wfPoolInit(&pool, sizeof world->scratch, world->scratch) != WF_OK) return 1;
            if (wfTreePairs(&in, world->index, &pool, &list) != WF_OK) return 1;
            if (step < 0) continue;
            changes += changed;
            tests += list.tests;
        }
        fprintf(out, "%g,%.1f,%.0f\n", ratio, (double)changes / STEPS,
                (double)tests / STEPS);
    }
    return 0;
}
/* <measurements> */
static int measure_narrow_far(FILE *out)
{
    wfShape a, b;
    wfMakeBox(1, 1, &a);
    wfMakeBox(WF_R(0.75), WF_R(0.5), &b);
    wfReal world0 = 0, relative0 = 0;
    fprintf(out, "distance,world,relative\n");
    for (int32_t far = 0; far <= 1 << 20; far = far ? far * 4 : 16) {
        wfReal x = (wfReal)far;
        wfTransform xa = wfMakeTransform(wfV2(x, x), WF_R(0.2));
        wfTransform xb = wfMakeTransform(wfV2(x + 1, x + WF_R(0.75)), WF_R(0.5));
        wfSeparation s;
        if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return 1;
        wfProjection pa = wfProject(&a, xa, s.normal), pb = wfProject(&b, xb, s.normal);
        wfReal world = wfAxisEscape(pa, pb);
        if (!far) world0 = world, relative0 = s.distance;
        fprintf(out, "%d,%.3g,%.3g\n", (int)far, (double)wfAbs(world - world0),
                (double)wfAbs(s.distance - relative0));
    }
    return 0;
}
/* <measurements> */
typedef struct CoatCase {
    const char *name;
    wfReal coreA[2], coatA, coreB[2], coatB, at[2], degrees;    /* cores: half sizes */
    double exact;
} CoatCase;

static const CoatCase coatCases[] = {
    { "rounded squares: corner to corner", { 1, 1 }, 0.5f, { 1, 1 }, 0.5f, { 2.8f, 2.8f },
      0, 0.131371 },
    { "rounded squares: face to face", { 1, 1 }, 0.5f, { 1, 1 }, 0.5f, { 2.9f, 1 }, 0,
      -0.1 },
    { "capsules: end to end", { 1, 0 }, 0.5f, { 1, 0 }, 0.25f, { 3, 0 }, 0, 0.25 },
    { "capsules: one in the other's line", { 1, 0 }, 0.5f, { 1, 0 }, 0.25f, { 1, 0 }, 0,
      -0.75 },
    { "capsules: crossed", { 1, 0 }, 0.5f, { 1, 0 }, 0.25f, { 0, 0.25f }, 90, -1.5 },
    { "capsules: side by side", { 1, 0 }, 0.5f, { 2, 0 }, 0.25f, { 1, -1 }, 0, 0.25 },
    { "segment through a square", { 1, 1 }, 0, { 3, 0 }, 0, { 0, 0.75f }, 0, -0.25 },
    { "segments that meet in a T", { 1, 0 }, 0, { 1, 0 }, 0, { 0.5f, 1 }, 90, 0 },
};
/* <measurements> */
static wfResult coatShape(const wfReal core[2], wfReal coat, wfShape *out)
{
    wfVec2 end = wfV2(core[0], 0);
    if (core[1] > 0) return wfMakeRoundedBox(core[0], core[1], coat, out);
    if (coat > 0) return wfMakeCapsule(wfNeg(end), end, coat, out);
    return wfMakeSegment(wfNeg(end), end, out);
}
/* <measurements> */
static int measure_narrow_coats(FILE *out)
{
    static const char *const rows[3] = { "sat", "gjk", "voronoi" };
    static const char *const owners[3] = { "nobody", "A", "B" };
    fprintf(out, "case,exact,sat,gjk,voronoi,feature\n");
    for (size_t i = 0; i < sizeof coatCases / sizeof *coatCases; i++) {
        const CoatCase *c = &coatCases[i];
        wfShape a, b;
        wfSeparation s[3];
        if (coatShape(c->coreA, c->coatA, &a) != WF_OK) return 1;
        if (coatShape(c->coreB, c->coatB, &b) != WF_OK) return 1;
        wfTransform xa = wfTransformIdentity();
        wfVec2 place = wfV2(c->at[0], c->at[1]);
        wfTransform xb = wfMakeTransform(place, wfRadians(c->degrees));
        for (int k = 0; k < 3; k++)
            if (wfSeparate(wfFindNarrowPhase(rows[k]), &a, xa, &b, xb, &s[k]) != WF_OK)
                return 1;
        fprintf(out, "%s,%.6g,%.5f,%.5f,%.5f,%s\n", c->name, c->exact,
                (double)s[0].distance + 0.0, (double)s[1].distance, (double)s[2].distance,
                owners[s[0].owner + 1]);
    }
    return 0;
}
/* <measurements> */
static wfResult regularPolygon(int corners, wfShape *out)
{
    wfVec2 v[WF_MAX_VERTICES];
    for (int i = 0; i < corners; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / (wfReal)corners);
        v[i] = wfV2(q.c, q.s);
    }
    return wfMakePolygon(v, corners, out);
}

typedef struct GjkCount { long pairs, walk, grow; int walkMost, growMost; } GjkCount;

static void countSteps(const wfGjkTrace *t, GjkCount *c)
{
    int walk = 0;
    while (walk < t->count && t->steps[walk].phase == WF_GJK_WALK) walk++;
    int grow = t->count - walk;
    c->pairs++;
    c->walk += walk;
    c->grow += grow;
    if (walk > c->walkMost) c->walkMost = walk;
    if (grow > c->growMost) c->growMost = grow;
}
/* <measurements> */
static int measure_narrow_gjk(FILE *out)
{
    wfRandom r;
    wfRandomSeed(&r, 12);
    fprintf(out, "corners,sat_dots,apart_mean,apart_max,apart_dots,overlap_mean,"
                 "epa_mean,epa_max,overlap_dots\n");
    for (int n = 3; n <= WF_MAX_VERTICES; n = n == 3 ? 4 : n * 2) {
        wfShape s;
        GjkCount count[2] = { { 0 }, { 0 } };
        if (regularPolygon(n, &s) != WF_OK) return 1;
        for (int i = 0; i < 20000; i++) {
            /* <separate a random pair and count its steps> */
            wfGjkTrace t;
            wfSeparation sep;
            wfReal turnA = wfRandomReal(&r, -WF_PI, WF_PI), turnB = wfRandomReal(&r, -WF_PI, WF_PI);
            wfReal x = wfRandomReal(&r, -3, 3), y = wfRandomReal(&r, -3, 3);
            wfTransform xa = wfMakeTransform(wfV2(0, 0), turnA);
            wfTransform xb = wfMakeTransform(wfV2(x, y), turnB);
            if (wfTraceGjk(&s, xa, &s, xb, &sep, &t) != WF_OK) return 1;
            countSteps(&t, &count[sep.distance <= 0]);
        }
        const GjkCount *apart = &count[0], *over = &count[1];
        double pairs = (double)apart->pairs, overs = (double)over->pairs;
        fprintf(out, "%d,%d,%.2f,%d,%.0f,%.2f,%.2f,%d,%.0f\n", n, 2 * n * n,
                (double)apart->walk / pairs, apart->walkMost,
                (double)apart->walk / pairs * 2 * n, (double)over->walk / overs,
                (double)over->grow / overs, over->growMost,
                (double)(over->walk + over->grow) / overs * 2 * n);
    }
    return 0;
}
/* <measurements> */
static void countFlips(const char *row, wfVec2 at, wfReal turn, int shakes, int flips[2])
{
    wfRandom r;
    wfShape box;
    wfSeparation was = { .owner = WF_NO_EDGE };
    wfRandomSeed(&r, 7);
    wfMakeBox(1, 1, &box);
    for (int i = 0; i < shakes; i++) {
        wfReal dx = wfRandomReal(&r, -WF_R(1e-6), WF_R(1e-6));
        wfReal dy = wfRandomReal(&r, -WF_R(1e-6), WF_R(1e-6));
        wfReal dturn = wfRandomReal(&r, -WF_R(1e-6), WF_R(1e-6));
        wfTransform xa = wfMakeTransform(wfV2(0, 0), 0);
        wfTransform xb = wfMakeTransform(wfAdd(at, wfV2(dx, dy)), turn + dturn);
        wfSeparation s;
        if (wfSeparate(wfFindNarrowPhase(row), &box, xa, &box, xb, &s) != WF_OK) return;
        flips[0] += i > 0 && wfDistance(s.normal, was.normal) > WF_R(0.01);
        flips[1] += i > 0 && s.owner != was.owner;
        was = s;
    }
}
/* <measurements> */
static int measure_narrow_flips(FILE *out)
{
    static const struct { const char *name; wfReal x, y, degrees; } pairs[] = {
        { "box on box", 0, WF_R(1.9), 0 }, { "corner in corner", WF_R(1.9), WF_R(1.9), 0 },
        { "one in the other", 0, 0, 0 }, { "corner on face", 0, WF_R(2.3), 45 },
    };
    fprintf(out, "pair,shakes,sat_normal,sat_owner,gjk_normal,gjk_owner\n");
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        int sat[2] = { 0 }, gjk[2] = { 0 }, shakes = 1000;
        wfVec2 at = wfV2(pairs[i].x, pairs[i].y);
        countFlips("sat", at, wfRadians(pairs[i].degrees), shakes, sat);
        countFlips("gjk", at, wfRadians(pairs[i].degrees), shakes, gjk);
        fprintf(out, "%s,%d,%d,%d,%d,%d\n", pairs[i].name, shakes, sat[0], sat[1], gjk[0],
                gjk[1]);
    }
    return 0;
}
/* <measurements> */
typedef struct HardCase {
    const char *name;
    wfReal halfA[2], halfB[2], at[2], degrees;
    double exact;
} HardCase;

static const HardCase hardCases[] = {
    { "faces touch", { 1, 1 }, { 1, 1 }, { 2, 0 }, 0, 0 },
    { "corners touch", { 1, 1 }, { 1, 1 }, { 2, 2 }, 0, 0 },
    { "coincident", { 1, 1 }, { 1, 1 }, { 0, 0 }, 0, -2 },
    { "nested", { 2, 1 }, { WF_R(0.25), WF_R(0.25) }, { 1, WF_R(0.25) }, 0, -1 },
    { "needle through a box", { 1, WF_R(1e-4) }, { 1, 1 }, { WF_R(0.5), WF_R(0.25) }, 0,
      -0.7501 },
    { "needle beside a needle", { 1, WF_R(1e-4) }, { 1, WF_R(1e-4) }, { 0, WF_R(5e-4) }, 0,
      3e-4 },
    { "edges parallel but for 0.1 mrad", { 1, 1 }, { 1, 1 }, { 0, WF_R(2.5) },
      WF_R(5.729578e-3), 0.4999 },
    { "corner to corner", { 1, 1 }, { 1, 1 }, { 5, 6 }, 0, 5 },
    { "1 mm over 1 km", { 500, 1 }, { WF_R(5e-4), WF_R(5e-4) }, { 3, WF_R(1.001) }, 0,
      5e-4 },
    { "1 mm into 1 km", { 500, 1 }, { WF_R(5e-4), WF_R(5e-4) }, { 3, 1 }, 0, -5e-4 },
};
/* <measurements> */
static int measure_narrow_hard(FILE *out)
{
    fprintf(out, "case,exact,sat,gjk,steps,epa\n");
    for (size_t i = 0; i < sizeof hardCases / sizeof *hardCases; i++) {
        const HardCase *h = &hardCases[i];
        wfShape a, b;
        wfSeparation sat, gjk;
        wfGjkTrace t;
        GjkCount count = { 0 };
        if (wfMakeBox(h->halfA[0], h->halfA[1], &a) != WF_OK) return 1;
        if (wfMakeBox(h->halfB[0], h->halfB[1], &b) != WF_OK) return 1;
        wfTransform xa = wfMakeTransform(wfV2(0, 0), 0);
        wfTransform xb = wfMakeTransform(wfV2(h->at[0], h->at[1]), wfRadians(h->degrees));
        if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &sat) != WF_OK) return 1;
        if (wfTraceGjk(&a, xa, &b, xb, &gjk, &t) != WF_OK) return 1;
        countSteps(&t, &count);
        fprintf(out, "%s,%.6g,%.6g,%.6g,%ld,%ld\n", h->name, h->exact,
                (double)sat.distance, (double)gjk.distance, count.walk, count.grow);
    }
    return 0;
}
/* <measurements> */
/* the middle of the points of a manifold along x, weighted by their depths */
static wfReal contactMiddle(const wfManifold *m)
{
    wfReal sum = 0, weight = 0;
    for (int i = 0; i < m->count; i++) {
        sum += m->points[i].depth * m->points[i].armB.x;
        weight += m->points[i].depth;
    }
    return weight > 0 ? sum / weight : 0;
}
/* <measurements> */
static int measure_contacts_tilt(FILE *out)
{
    wfShape ground, box;
    wfMakeBox(5, 1, &ground);
    wfMakeBox(1, 1, &box);
    fprintf(out, "tilt,report_points,report_x,points,x\n");
    for (int step = 0; step <= 16; step++) {
        wfReal tilt = WF_R(0.25) * (wfReal)step;
        wfTransform xg = wfMakeTransform(wfV2(0, 0), 0);
        wfTransform xb = wfMakeTransform(wfV2(0, WF_R(1.97)), wfRadians(tilt));
        wfManifold m;
        wfCollide(&ground, xg, &box, xb, &m);
        bool edges = tilt <= WF_R(0.5);
        wfVec2 down = wfRotateInv(xb.q, wfV2(0, -1));
        wfVec2 low = wfRotate(xb.q, box.vertices[wfShapeSupport(&box, down)]);
        fprintf(out, "%.2f,%d,%.3f,%d,%.3f\n", (double)tilt, edges ? 2 : 1,
                edges ? 0.0 : (double)low.x, m.count, (double)contactMiddle(&m));
    }
    return 0;
}
/* <measurements> */
/* <find contacts the report's way> */
/* the two middle ones of the different values among n; false if there are too few */
static bool reportMiddle(wfReal *v, int n, wfReal equal, wfReal middle[2])
{
    for (int i = 1; i < n; i++)
        for (int k = i; k > 0 && v[k] < v[k - 1]; k--) {
            wfReal swap = v[k];
            v[k] = v[k - 1];
            v[k - 1] = swap;
        }
    int m = 1;
    for (int i = 1; i < n; i++) if (v[i] - v[m - 1] > equal) v[m++] = v[i];
    if (m < 2) return false;
    middle[0] = v[m / 2 - 1];
    middle[1] = v[m / 2];
    return true;
}
/* <find contacts the report's way> */
typedef struct ReportPoint { wfVec2 point, counterpart; bool ofB; } ReportPoint;

static int reportEdges(const wfVec2 *corners, const wfSeparation *s, ReportPoint *out)
{
    wfReal across[8], along[8], n2[2], t2[2], equal = 0;
    wfVec2 n = s->normal, t = wfPerpCCW(n);
    int count = 0;
    for (int i = 0; i < 8; i++) {
        across[i] = wfDot(n, corners[i]);
        along[i] = wfDot(t, corners[i]);
    }
    if (!reportMiddle(across, 8, equal, n2) || !reportMiddle(along, 8, equal, t2)) return 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 8 && count < 4; i++) {
            wfReal x = wfDot(t, corners[i]);
            bool end = wfAbs(x - t2[0]) <= equal || wfAbs(x - t2[1]) <= equal;
            if (!end || wfAbs(wfDot(n, corners[i]) - n2[k]) > equal) continue;
            wfReal way = i < 4 ? s->distance : -s->distance;
            out[count++] = (ReportPoint){ corners[i], wfAddScaled(corners[i], way, n),
                                          i >= 4 };
        }
    return count;
}
/* <find contacts the report's way> */
static int reportVertex(const wfVec2 *corners, wfVec2 fromAToB, const wfSeparation *s,
                        ReportPoint *out)
{
    bool ofB = s->owner != 1;           /* A has the edge, so B has the vertex */
    wfVec2 into = ofB ? wfNeg(s->normal) : s->normal;
    wfVec2 centres = wfNormalize(ofB ? wfNeg(fromAToB) : fromAToB);
    const wfVec2 *c = corners + (ofB ? 4 : 0);
    int best = 0;
    for (int i = 1; i < 4; i++) if (wfDot(into, c[i]) > wfDot(into, c[best])) best = i;
    out[0] = (ReportPoint){ c[best], wfAddScaled(c[best], s->distance, centres), ofB };
    return 1;
}

static int reportContacts(const wfShape *a, wfTransform xa, const wfShape *b,
                          wfTransform xb, const wfSeparation *s, ReportPoint *out)
{
    wfVec2 corners[8], turn = wfV2(wfDot(wfV2(xa.q.c, xa.q.s), wfV2(xb.q.c, xb.q.s)),
                                   wfCross(wfV2(xa.q.c, xa.q.s), wfV2(xb.q.c, xb.q.s)));
    for (int i = 0; i < 4; i++) {
        corners[i] = wfApply(xa, a->vertices[i]);
        corners[i + 4] = wfApply(xb, b->vertices[i]);
    }
    wfReal tilt = wfMinR(wfAbs(turn.x), wfAbs(turn.y));
    if (tilt < WF_R(0.0087)) return reportEdges(corners, s, out);      /* half a degree */
    return reportVertex(corners, wfSub(xb.p, xa.p), s, out);
}

/* distance of p from the outline of a box */
static wfReal reportOff(const wfShape *s, wfTransform xf, wfVec2 p)
{
    wfVec2 c = wfApplyInv(xf, p), half = wfSub(s->vertices[2], s->centre);
    wfReal x = wfAbs(c.x) - half.x, y = wfAbs(c.y) - half.y;
    if (x <= 0 && y <= 0) return wfMinR(wfAbs(x), wfAbs(y));
    return wfLength(wfV2(wfMaxR(x, 0), wfMaxR(y, 0)));
}

static void reportPlace(wfRandom *r, int kind, wfTransform *xa, wfTransform *xb)
{
    wfReal turn = kind == 0 ? 0 : wfRandomReal(r, -1, 1), depth = WF_R(0.02);
    wfReal tilt = kind == 2 ? wfRandomReal(r, WF_R(0.1), WF_R(0.6)) : 0;
    if (kind == 3) tilt = wfRandomReal(r, WF_R(-0.008), WF_R(0.008));
    wfReal x = wfRandomReal(r, WF_R(-2.5), WF_R(2.5));
    wfRot q = wfRotation(tilt);
    wfReal low = WF_R(0.5) * (q.c + wfAbs(q.s));
    *xa = wfMakeTransform(wfV2(0, 0), turn);
    wfTransform over = { wfV2(x, WF_R(0.5) + low - depth), q };
    *xb = wfTransformMul(*xa, over);
}
/* <measurements> */
static int measure_contacts_report(FILE *out)
{
    static const char *const names[4] = { "upright", "both turned", "corner on a plank",
                                          "tilted within the tolerance" };
    wfRandom r;
    wfShape plank, box;
    wfRandomSeed(&r, 56);
    wfMakeBox(3, WF_R(0.5), &plank);
    wfMakeBox(WF_R(0.5), WF_R(0.5), &box);
    fprintf(out, "placement,none,off,worst,ours\n");
    for (int kind = 0; kind < 4; kind++) {
        int none = 0, points = 0, off = 0;
        wfReal worst = 0, ours = 0;
        for (int i = 0; i < 2000; i++) {
            /* <judge both ways on one pair> */
            wfTransform xa, xb;
            wfSeparation s;
            wfManifold m;
            ReportPoint found[4];
            reportPlace(&r, kind, &xa, &xb);
            if (wfSeparate(wfFindNarrowPhase("sat"), &plank, xa, &box, xb, &s) != WF_OK) return 1;
            int n = reportContacts(&plank, xa, &box, xb, &s, found);
            none += n == 0;
            for (int k = 0; k < n; k++) {
                wfReal d = reportOff(found[k].ofB ? &plank : &box, found[k].ofB ? xa : xb,
                                     found[k].counterpart) / wfAbs(s.distance);
                worst = wfMaxR(worst, d);
                off += d > WF_R(0.1);
                points++;
            }
            wfMakeManifold(&plank, xa, &box, xb, &s, &m);
            for (int k = 0; k < m.count; k++) {
                wfVec2 ahead = wfAddScaled(m.points[k].point, m.points[k].depth / 2, m.normal);
                wfVec2 back = wfAddScaled(m.points[k].point, -m.points[k].depth / 2, m.normal);
                ours = wfMaxR(ours, reportOff(&plank, xa, ahead) / -s.distance);
                ours = wfMaxR(ours, reportOff(&box, xb, back) / -s.distance);
            }
        }
        fprintf(out, "%s,%.1f,%.1f,%.2g,%.2g\n", names[kind], none / 20.0,
                points ? 100.0 * off / points : 0.0, (double)worst, (double)ours);
    }
    return 0;
}
/* <measurements> */
/* <slide over tiles> */
enum { SLIDE_NEAR = 8, SLIDE_PASSES = 64 };
#define SLIDE_TILE WF_R(0.5)
#define SLIDE_SPEED WF_R(4.7)

typedef struct Slide {
    wfShape tile, shape;
    wfBodyState body;
    wfReal friction;
    wfManifold near[SLIDE_NEAR];        /* of tile i at index i % SLIDE_NEAR */
} Slide;

static void slideCollide(Slide *s)
{
    int32_t first = (int32_t)(s->body.p.x / SLIDE_TILE) - SLIDE_NEAR / 2 + 1;
    wfTransform xb = wfBodyTransform(&s->body);
    for (int32_t i = first; i < first + SLIDE_NEAR; i++) {
        wfManifold now, *m = &s->near[(uint32_t)i % SLIDE_NEAR];
        wfTransform xt = wfMakeTransform(wfV2((wfReal)i * SLIDE_TILE, 0), 0);
        wfCollide(&s->tile, xt, &s->shape, xb, &now);
        wfKeepImpulses(m, &now);
        *m = now;
    }
}
/* <slide over tiles> */
/* changes the impulse so far by what makes the velocity along d zero, within limits */
static void slidePush(Slide *s, wfVec2 d, const wfContactPoint *c, wfReal *sum,
                      wfReal low, wfReal high)
{
    wfReal arm = wfCross(c->armB, d), j = *sum;
    wfReal k = s->body.invMass + arm * arm * s->body.invInertia;
    wfReal u = wfDot(wfVelocityAt(&s->body, c->point), d);
    *sum = wfMaxR(low, wfMinR(high, j - u / k));
    wfApplyImpulse(&s->body, wfScale(*sum - j, d), c->point);
}

static void slideSolve(Slide *s)
{
    for (int pass = 0; pass < SLIDE_PASSES; pass++)
        for (int i = 0; i < SLIDE_NEAR; i++)
            for (int k = 0; k < s->near[i].count; k++) {
                wfContactPoint *c = &s->near[i].points[k];
                wfVec2 n = s->near[i].normal;
                wfReal most = s->friction * c->normalImpulse;
                slidePush(s, wfPerpCW(n), c, &c->tangentImpulse, -most, most);
                slidePush(s, n, c, &c->normalImpulse, 0, WF_HUGE);
            }
}
/* <slide over tiles> */
/* steps for as long as 1000 tiles take; returns the greatest vertical speed, m/s */
static wfReal slideAlong(Slide *s)
{
    wfReal h = WF_R(1.0) / 60, most = 0;
    int steps = (int)(1010 * SLIDE_TILE / (SLIDE_SPEED * h));
    for (int step = 0; step < steps; step++) {
        s->body.v.y -= WF_R(9.81) * h;
        slideCollide(s);
        for (int i = 0; i < SLIDE_NEAR; i++)
            for (int k = 0; k < s->near[i].count; k++) {
                wfContactPoint *c = &s->near[i].points[k];
                wfVec2 n = s->near[i].normal, t = wfPerpCW(n);
                wfVec2 j = wfScale(c->normalImpulse, n);
                j = wfAddScaled(j, c->tangentImpulse, t);
                wfApplyImpulse(&s->body, j, c->point);
            }
        slideSolve(s);
        s->body.p = wfAddScaled(s->body.p, h, s->body.v);
        s->body.angle += h * s->body.w;
        most = wfMaxR(most, wfAbs(s->body.v.y));
    }
    return most;
}
/* <slide over tiles> */
static const char *const slideBodies[] = {
    "box", "rounded box", "hexagon", "capsule lying", "circle", "circle rolling" };

static void slideShape(int body, wfShape *s)
{
    wfVec2 p[6];
    for (int i = 0; i < 6; i++) {
        wfRot q = wfRotation(WF_PI * (wfReal)i / 3);
        p[i] = wfV2(q.c * WF_R(0.4), q.s * WF_R(0.4));
    }
    switch (body) {
    case 0: wfMakeBox(WF_R(0.6), WF_R(0.3), s); break;
    case 1: wfMakeRoundedBox(WF_R(0.5), WF_R(0.2), WF_R(0.1), s); break;
    case 2: wfMakePolygon(p, 6, s); break;
    case 3: wfMakeCapsule(wfV2(WF_R(-0.4), 0), wfV2(WF_R(0.4), 0), WF_R(0.2), s); break;
    default: wfMakeCircle(wfV2(0, 0), WF_R(0.3), s); break;
    }
}
/* <slide over tiles> */
static void slideTile(int kind, wfShape *s)
{
    wfReal l = SLIDE_TILE;
    if (kind == 0) wfMakeOrientedBox(wfV2(l / 2, -l / 2), l / 2, l / 2, 0, s);
    if (kind == 1) wfMakeSegment(wfV2(l, 0), wfV2(0, 0), s);
    if (kind == 2) wfMakeLink(wfV2(2 * l, 0), wfV2(l, 0), wfV2(0, 0), wfV2(-l, 0), s);
}
/* <slide over tiles> */
static void slideStart(Slide *s, int body, int kind)
{
    wfMassData mass;
    *s = (Slide){ .friction = 0 };
    slideShape(body, &s->shape);
    slideTile(kind, &s->tile);
    wfShapeMass(&s->shape, 1, &mass);
    wfRect bounds = wfShapeBounds(&s->shape, wfMakeTransform(wfV2(0, 0), 0));
    s->body.p = wfV2(5, -bounds.min.y - WF_R(0.002));
    s->body.v = wfV2(SLIDE_SPEED, 0);
    s->body.invMass = 1 / mass.mass;
    s->body.invInertia = 1 / mass.inertia;
    if (body == 5) {
        s->friction = 1;
        s->body.w = -SLIDE_SPEED / s->shape.radius;
    }
}

static int measure_contacts_tiles(FILE *out)
{
    fprintf(out, "body,boxes,boxes_tiles,segments,segments_tiles,links,links_tiles\n");
    for (int body = 0; body < 6; body++) {
        fprintf(out, "%s", slideBodies[body]);
        for (int kind = 0; kind < 3; kind++) {
            Slide s;
            slideStart(&s, body, kind);
            wfReal most = slideAlong(&s);
            int tiles = (int)((s.body.p.x - 5) / SLIDE_TILE);
            fprintf(out, ",%.2g,%d", (double)most, tiles < 1000 ? tiles : 1000);
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
/* <wander about> */
typedef struct Wander {
    wfShape a, b;
    wfTransform xa, xb;
    wfReal reach;
} Wander;

static void wanderShape(wfRandom *r, wfShape *s)
{
    wfVec2 p[8];
    do {
        for (int i = 0; i < 8; i++) {
            wfReal x = wfRandomReal(r, -1, 1);
            p[i] = wfV2(x, wfRandomReal(r, -1, 1));
        }
    } while (wfMakePolygon(p, 8, s) != WF_OK);
}
/* <wander about> */
/* a pair that overlaps by at most a twentieth of the smaller reach */
static void wanderStart(wfRandom *r, Wander *w)
{
    wfSeparation s;
    wanderShape(r, &w->a);
    wanderShape(r, &w->b);
    w->reach = wfMinR(wfShapeReach(&w->a), wfShapeReach(&w->b));
    w->xa = wfMakeTransform(wfV2(0, 0), wfRandomReal(r, -3, 3));
    wfReal x = wfRandomReal(r, -1, 1);
    w->xb = wfMakeTransform(wfV2(x, wfRandomReal(r, -1, 1)), wfRandomReal(r, -3, 3));
    if (wfSeparate(wfFindNarrowPhase("sat"), &w->a, w->xa, &w->b, w->xb, &s) != WF_OK)
        return;
    wfReal out = -s.distance - WF_R(0.05) * w->reach * wfRandomReal(r, 0, 1);
    w->xb.p = wfAddScaled(w->xb.p, out, s.normal);
}
/* <wander about> */
static void wanderOn(wfRandom *r, Wander *w, wfReal share)
{
    wfReal x = wfRandomReal(r, -share, share) * w->reach;
    wfReal y = wfRandomReal(r, -share, share) * w->reach;
    w->xb.p = wfAdd(w->xb.p, wfV2(x, y));
    w->xb.q = wfRotMul(w->xb.q, wfRotation(wfRandomReal(r, -share, share)));
}

static wfReal deepestOf(const wfManifold *m)
{
    wfReal most = 0;
    for (int i = 0; i < m->count; i++) most = wfMaxR(most, m->points[i].depth);
    return most;
}
/* <wander about> */
/* the share of steps that used a manifold again; *worst: how much too deep, by the reach */
static double wanderAll(wfReal share, wfReal step, double *worst)
{
    wfRandom r;
    int reused = 0, all = 0, sat = wfFindNarrowPhase("sat");
    wfRandomSeed(&r, 13);
    for (int pair = 0; pair < 400; pair++) {
        Wander w;
        wfManifoldCache cache = { .owner = WF_NO_EDGE };
        wanderStart(&r, &w);
        for (int i = 0; i < 50; i++) {
            /* <go on a step, and compare a manifold used again with a fresh one> */
            wfSeparation s;
            wfManifold fresh, again;
            wanderOn(&r, &w, step);
            if (wfSeparate(sat, &w.a, w.xa, &w.b, w.xb, &s) != WF_OK) return -1;
            wfMakeManifold(&w.a, w.xa, &w.b, w.xb, &s, &fresh);
            all += i > 0;
            if (wfReuseManifold(&w.a, w.xa, &w.b, w.xb, 0, &cache, &again)) {
                double error = (double)((deepestOf(&again) - deepestOf(&fresh)) / w.reach);
                if (error > *worst) *worst = error;
                reused++;
            } else {
                wfRememberManifold(&w.a, w.xa, &w.b, w.xb, &s, &cache);
                cache.allowed = share * w.reach;
            }
        }
    }
    return (double)reused / all;
}

static int measure_contacts_reuse(FILE *out)
{
    fprintf(out, "share,rest,slow,brisk,worst,bound\n");
    for (int parts = 4096; parts >= 16; parts /= 4) {
        wfReal share = 1 / (wfReal)parts;
        double worst = 0;
        double rest = wanderAll(share, WF_R(0.00001), &worst);
        double slow = wanderAll(share, WF_R(0.001), &worst);
        double brisk = wanderAll(share, WF_R(0.01), &worst);
        fprintf(out, "1/%d,%.1f,%.1f,%.1f,%.2g,%.2g\n", parts, 100 * rest, 100 * slow,
                100 * brisk, worst, (double)(2 * share + WF_AXIS_TIE));
    }
    return 0;
}
/* <measurements> */
enum { REUSE_POSES = 64, REUSE_ROUNDS = 2000 };

/* way 0: fresh; 1: used again; 2: tried in vain, then fresh and remembered */
static double reuseBatch(const wfShape *a, const wfShape *b, const wfTransform *xb, int way)
{
    wfManifoldCache cache = { .owner = WF_NO_EDGE }, far;
    wfTransform xa = wfMakeTransform(wfV2(0, 0), 0);
    wfSeparation s;
    wfManifold m;
    int sat = wfFindNarrowPhase("sat"), points = 0;
    wfSeparate(sat, a, xa, b, xb[0], &s);
    wfRememberManifold(a, xa, b, xb[0], &s, &cache);
    far = cache;
    far.relative.p.y += 1;
    clock_t start = clock();
    for (int i = 0; i < REUSE_POSES * REUSE_ROUNDS; i++) {
        const wfTransform *x = &xb[i % REUSE_POSES];
        /* <make the manifold this way> */
        if (way == 1 && wfReuseManifold(a, xa, b, *x, 0, &cache, &m)) {
            points += m.count;
            continue;
        }
        if (way == 2 && wfReuseManifold(a, xa, b, *x, 0, &far, &m)) return -1;
        wfSeparate(sat, a, xa, b, *x, &s);
        wfMakeManifold(a, xa, b, *x, &s, &m);
        if (way == 2) wfRememberManifold(a, xa, b, *x, &s, &cache);
        points += m.count;
    }
    double took = (double)(clock() - start) / CLOCKS_PER_SEC;
    return points ? took / (REUSE_POSES * REUSE_ROUNDS) * 1e9 : -1;
}
/* <measurements> */
static void reusePair(FILE *out, const char *name, const wfShape *a, const wfShape *b)
{
    wfTransform xb[REUSE_POSES];
    wfRandom r;
    double best[3] = { 1e9, 1e9, 1e9 };
    wfRect under = wfShapeBounds(a, wfMakeTransform(wfV2(0, 0), 0));
    wfRect over = wfShapeBounds(b, wfMakeTransform(wfV2(0, 0), 0));
    wfRandomSeed(&r, 14);
    for (int i = 0; i < REUSE_POSES; i++) {
        wfReal x = WF_R(0.1) + wfRandomReal(&r, WF_R(-0.0005), WF_R(0.0005));
        wfReal y = under.max.y - over.min.y - WF_R(0.003);
        xb[i] = wfMakeTransform(wfV2(x, y), wfRandomReal(&r, WF_R(-0.0005), WF_R(0.0005)));
    }
    for (int batch = 0; batch < 7; batch++)
        for (int way = 0; way < 3; way++) {
            double took = reuseBatch(a, b, xb, way);
            if (took < best[way]) best[way] = took;
        }
    int n = a->count, m = b->count;
    fprintf(out, "%s,%d,%d,%.0f,%.0f,%.2f,%.0f\n", name, 2 * n * m + n + m + m + 6,
            m + 6, best[0], best[1], best[0] / best[1], best[2]);
}
/* <measurements> */
static void roundShape(int n, wfShape *s)
{
    wfVec2 p[WF_MAX_VERTICES];
    for (int i = 0; i < n; i++) {
        wfReal turn = 2 * WF_PI * ((wfReal)i + WF_R(0.5)) / (wfReal)n - WF_PI / 2;
        wfRot q = wfRotation(turn);
        p[i] = wfV2(q.c, q.s);
    }
    wfMakePolygon(p, n, s);
}

static int measure_contacts_reuse_time(FILE *out)
{
    wfShape box, pill, eight, sixteen;
    wfMakeBox(1, 1, &box);
    wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.5), &pill);
    roundShape(8, &eight);
    roundShape(16, &sixteen);
    fprintf(out, "pair,fresh_dots,reuse_dots,fresh,reuse,ratio,vain\n");
    reusePair(out, "box on capsule", &box, &pill);
    reusePair(out, "box on box", &box, &box);
    reusePair(out, "8 corners on box", &eight, &box);
    reusePair(out, "8 corners on 8", &eight, &eight);
    reusePair(out, "16 corners on 16", &sixteen, &sixteen);
    return 0;
}
/* <measurements> */
enum { LAB_BOXES = 16 };
typedef struct labPile {
    wfShape     floor, box;
    wfBodyState state[LAB_BOXES + 1];       /* the floor first, then the boxes from below */
    wfContact   contact[LAB_BOXES];
    _Alignas(16) uint8_t memory[sizeof(wfVec2) * (LAB_BOXES + 1)];
    wfReal      restitution, h;
} labPile;

static void lab_start_pile(labPile *pile, int boxes, wfReal restitution)
{
    memset(pile, 0, sizeof *pile);
    wfMakeBox(10, 1, &pile->floor);
    wfMakeBox(WF_R(0.5), WF_R(0.5), &pile->box);
    pile->state[0].p = wfV2(0, -1);
    for (int i = 1; i <= boxes; i++)
        pile->state[i] = (wfBodyState){ .p = wfV2(0, (wfReal)i - WF_R(0.5)), .invMass = 1,
                                        .invInertia = 6 };
    pile->restitution = restitution;
    pile->h = WF_R(1.0) / 60;
}
/* <measurements> */
static wfReal lab_touch(labPile *pile, int boxes, int *contacts)
{
    wfReal deepest = 0;
    *contacts = 0;
    for (int i = 0; i < boxes; i++) {
        const wfShape *below = i == 0 ? &pile->floor : &pile->box;
        wfContact c = { .a = i, .b = i + 1, .restitution = pile->restitution,
                        .slop = WF_R(0.005) };
        wfCollide(below, wfBodyTransform(&pile->state[i]), &pile->box,
                  wfBodyTransform(&pile->state[i + 1]), &c.manifold);
        for (int k = 0; k < c.manifold.count; k++)
            deepest = wfMaxR(deepest, c.manifold.points[k].depth);
        if (c.manifold.count > 0) pile->contact[(*contacts)++] = c;
    }
    return deepest;
}
/* <measurements> */
static wfReal lab_step_pile(labPile *pile, int boxes, const char *solver, int passes,
                            wfReal restingSteps)
{
    wfVec2 g = wfV2(0, WF_R(-9.81));
    wfPool scratch;
    int contacts;
    wfPoolInit(&scratch, sizeof pile->memory, pile->memory);
    for (int i = 1; i <= boxes; i++) {
        wfBodyState *s = &pile->state[i];
        s->v = wfAddScaled(s->v, pile->h, g);
        s->p = wfAddScaled(s->p, pile->h, s->v);
        s->angle += pile->h * s->w;
    }
    wfReal deepest = lab_touch(pile, boxes, &contacts);
    wfSolve solve = { .state = pile->state, .bodyCount = boxes + 1,
        .contacts = pile->contact, .contactCount = contacts, .h = pile->h,
        .iterations = passes,
        .restingSpeed = wfRestingSpeed(g, pile->h, restingSteps),
        .positionShare = WF_R(0.4), .scratch = &scratch };
    wfSolveVelocities(wfFindSolver(solver), &solve);
    wfSolvePositions(wfFindSolver(solver), &solve);
    return deepest;
}
/* <measurements> */
static int measure_impulses_rest(FILE *out)
{
    static labPile bounce, rest;
    lab_start_pile(&bounce, 1, WF_R(0.8));
    lab_start_pile(&rest, 1, WF_R(0.8));
    fprintf(out, "time,every contact bounces,slow contacts rest\n");
    for (int i = 0; i <= 120; i++) {
        wfReal a = wfShapeBounds(&bounce.box, wfBodyTransform(&bounce.state[1])).min.y;
        wfReal b = wfShapeBounds(&rest.box, wfBodyTransform(&rest.state[1])).min.y;
        fprintf(out, "%.4f,%.5f,%.5f\n", i / 60.0, 1000 * (double)a, 1000 * (double)b);
        lab_step_pile(&bounce, 1, "impulse-by-point", 8, 0);
        lab_step_pile(&rest, 1, "impulse", 8, 2);
    }
    return 0;
}
/* <measurements> */
static wfReal spin_of_flat_landing(const char *solver, int passes)
{
    wfBodyState s[2] = { { .invMass = 0 }, { .p = wfV2(0, WF_R(0.5)), .v = wfV2(0, -1),
                                             .invMass = 1, .invInertia = 6 } };
    wfContact c = { .a = 0, .b = 1, .manifold = { .normal = wfV2(0, 1), .count = 2 } };
    _Alignas(16) uint8_t memory[64];
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    c.manifold.points[0].point = wfV2(WF_R(-0.5), 0);
    c.manifold.points[1].point = wfV2(WF_R(0.5), 0);
    wfSolve solve = { .state = s, .bodyCount = 2, .contacts = &c, .contactCount = 1, .h = 1,
                      .iterations = passes, .scratch = &scratch };
    wfSolveVelocities(wfFindSolver(solver), &solve);
    return s[1].w;
}
/* <measurements> */
static int measure_impulses_spin(FILE *out)
{
    fprintf(out, "passes,one after the other,both together\n");
    for (int passes = 1; passes <= 8; passes++) {
        wfReal apart = spin_of_flat_landing("impulse-by-point", passes);
        wfReal together = spin_of_flat_landing("impulse", passes);
        fprintf(out, "%d,%.6f,%.6f\n", passes, (double)apart, (double)together);
    }
    return 0;
}
/* <measurements> */
static int measure_impulses_energy(FILE *out)
{
    wfVec2 point = wfV2(WF_R(0.4), WF_R(0.7)), n = wfV2(WF_R(0.6), WF_R(0.8));
    fprintf(out, "restitution,energy left,e squared\n");
    for (int i = 0; i <= 20; i++) {
        wfReal e = (wfReal)i / 20;
        wfBodyState a = { .p = wfV2(0, 0), .v = wfV2(2, 1), .w = WF_R(-1.5), .invMass = 1,
                          .invInertia = 6 };
        wfBodyState b = { .p = wfV2(1, WF_R(1.5)), .v = wfV2(-1, -2), .w = 2,
                          .invMass = WF_R(0.5), .invInertia = 2 };
        double u = (double)wfRelativeNormalVelocity(&a, &b, point, n);
        double approach = u * u / 2 * (double)wfEffectiveMass(&a, &b, point, n);
        double before = (double)wfKineticEnergy(&a) + (double)wfKineticEnergy(&b);
        wfResolvePoint(&a, &b, point, n, e);
        double after = (double)wfKineticEnergy(&a) + (double)wfKineticEnergy(&b);
        double left = 1 - (before - after) / approach;
        fprintf(out, "%.2f,%.4f,%.4f\n", (double)e, left, (double)(e * e));
    }
    return 0;
}
/* <measurements> */
static void lab_rest_of_stack(int boxes, int passes, double *depth, double *speed)
{
    static labPile pile;
    lab_start_pile(&pile, boxes, 0);
    *depth = *speed = 0;
    for (int i = 0; i < 600; i++) {
        double deepest = (double)lab_step_pile(&pile, boxes, "impulse", passes, 2);
        if (deepest > *depth) *depth = deepest;
        if (i < 540) continue;
        for (int k = 1; k <= boxes; k++) {
            double v = (double)wfLength(pile.state[k].v);
            if (v > *speed) *speed = v;
        }
    }
}
/* <measurements> */
static int measure_impulses_stack(FILE *out)
{
    static const int passes[3] = { 1, 8, 64 };
    fprintf(out, "boxes,depth 1 pass (mm),depth 8,depth 64,"
                 "speed 1 pass (mm/s),speed 8,speed 64\n");
    for (int boxes = 1; boxes <= LAB_BOXES; boxes++) {
        double depth[3], speed[3];
        for (int k = 0; k < 3; k++)
            lab_rest_of_stack(boxes, passes[k], &depth[k], &speed[k]);
        fprintf(out, "%d,%.3f,%.3f,%.3f,%.3f,%.3f,%.3f\n", boxes, 1000 * depth[0],
                1000 * depth[1], 1000 * depth[2], 1000 * speed[0], 1000 * speed[1],
                1000 * speed[2]);
    }
    return 0;
}
/* <measurements> */
enum { BENCH_BODIES = 404, BENCH_CONTACTS = 2048 };
typedef struct labBench {
    wfShape      shape[BENCH_BODIES];
    wfBodyState  state[BENCH_BODIES];
    wfBodyForces force[BENCH_BODIES];
    wfReal       restitution[BENCH_BODIES], friction[BENCH_BODIES], rolling[BENCH_BODIES];
    wfReal       sticking[BENCH_BODIES];
    wfContact    contact[BENCH_CONTACTS], before[BENCH_CONTACTS];
    int          count, contacts, solver, passes, substeps, columns;
    wfFine      *fine;
    wfVec2       gravity;
    wfReal       h, restingSteps, recoverySteps, slop, share;
    wfReal       period, damping;    /* of soft contacts; 0: what is usual */
    _Alignas(16) uint8_t memory[1 << 20];
} labBench;

static void bench_start(labBench *b, const char *solver, double hertz)
{
    memset(b, 0, sizeof *b);
    b->solver = wfFindSolver(solver);
    b->passes = 8;
    b->substeps = 4;
    b->gravity = wfV2(0, WF_R(-9.81));
    b->h = (wfReal)(1 / hertz);
    b->restingSteps = 2;
    b->recoverySteps = 24;
    b->columns = 1;
    b->slop = WF_R(0.005);
    b->share = WF_R(0.4);
}
/* <measurements> */
static int bench_add(labBench *b, wfShape shape, double x, double y, double mass, double mu)
{
    int i = b->count++;
    b->shape[i] = shape;
    b->friction[i] = (wfReal)mu;
    b->state[i] = (wfBodyState){ .p = wfV2((wfReal)x, (wfReal)y) };
    if (!(mass > 0)) return i;
    wfVec2 corner = wfShapeBounds(&shape, wfMakeTransform(wfV2(0, 0), 0)).max;
    double inertia = mass * (double)wfLengthSq(corner) / 3;
    if (shape.kind == WF_SHAPE_CIRCLE)
        inertia = mass * (double)(shape.radius * shape.radius) / 2;
    b->state[i].invMass = (wfReal)(1 / mass);
    b->state[i].invInertia = (wfReal)(1 / inertia);
    return i;
}

static int bench_box(labBench *b, double x, double y, double w, double h, double mass,
                     double mu)
{
    wfShape box;
    wfMakeBox((wfReal)(w / 2), (wfReal)(h / 2), &box);
    return bench_add(b, box, x, y, mass, mu);
}

static int bench_disc(labBench *b, double x, double y, double r, double mass, double mu)
{
    wfShape disc;
    wfMakeCircle(wfV2(0, 0), (wfReal)r, &disc);
    return bench_add(b, disc, x, y, mass, mu);
}
/* <measurements> */
static void bench_pair(labBench *b, int i, int k, wfReal margin)
{
    wfTransform xi = wfBodyTransform(&b->state[i]), xk = wfBodyTransform(&b->state[k]);
    wfSeparation s;
    wfRect near = wfShapeBounds(&b->shape[i], xi);
    near.min = wfSub(near.min, wfV2(margin, margin));
    near.max = wfAdd(near.max, wfV2(margin, margin));
    if (!wfRectOverlap(near, wfShapeBounds(&b->shape[k], xk))) return;
    wfContact c = { .a = i, .b = k, .slop = b->slop,
        .restitution = wfMixRestitution(b->restitution[i], b->restitution[k]),
        .friction = wfMixFriction(b->friction[i], b->friction[k]),
        .staticFriction = wfMixFriction(b->sticking[i], b->sticking[k]),
        .rolling = wfMixRolling(b->rolling[i], b->rolling[k]) };
    if (wfSeparate(0, &b->shape[i], xi, &b->shape[k], xk, &s) != WF_OK) return;
    wfMakeManifoldWithin(&b->shape[i], xi, &b->shape[k], xk, &s, margin, &c.manifold);
    if (c.manifold.count > 0 && b->contacts < BENCH_CONTACTS) b->contact[b->contacts++] = c;
}

static void bench_touch(labBench *b, wfReal margin)
{
    int old = b->contacts;
    memcpy(b->before, b->contact, (size_t)old * sizeof *b->before);
    b->contacts = 0;
    for (int i = 0; i < b->count; i++)
        for (int k = i + 1; k < b->count; k++)
            if (b->state[i].invMass > 0 || b->state[k].invMass > 0)
                bench_pair(b, i, k, margin);
    /* <hand the impulses of the last step on> */
    (void)old;      /* nothing is remembered yet */
    /* <hand the impulses of the last step on> */
    int at = 0;
    for (int n = 0; n < b->contacts; n++) {
        wfContact *c = &b->contact[n];
        while (at < old && (b->before[at].a < c->a ||
                            (b->before[at].a == c->a && b->before[at].b < c->b))) at++;
        if (at < old && b->before[at].a == c->a && b->before[at].b == c->b)
            wfCarryImpulses(&b->before[at], c);
    }
}
/* <measurements> */
static wfSolve bench_solve(labBench *b, wfPool *scratch)
{
    wfPoolInit(scratch, sizeof b->memory, b->memory);
    return (wfSolve){ .state = b->state, .bodyCount = b->count, .contacts = b->contact,
        .contactCount = b->contacts, .h = b->h, .iterations = b->passes,
        .restingSpeed = wfRestingSpeed(b->gravity, b->h, b->restingSteps),
        .recoverySpeed = wfRestingSpeed(b->gravity, b->h, b->recoverySteps),
        .positionShare = b->share, .forces = b->force, .substeps = b->substeps,
        .columns = b->columns, .contactPeriod = b->period, .contactDamping = b->damping,
        .fine = b->fine, .scratch = scratch };
}

static void bench_fly(labBench *b)
{
    for (int i = 0; i < b->count; i++) {
        wfBodyState *s = &b->state[i];
        wfVec2 a = s->invMass > 0 ? b->gravity : wfV2(0, 0);
        s->p = wfAddScaled(wfAddScaled(s->p, b->h, s->v), b->h * b->h / 2, a);
        s->v = wfAddScaled(s->v, b->h, a);
        s->angle += b->h * s->w;
    }
}
/* <measurements> */
static wfReal bench_margin(const labBench *b)
{
    wfReal fastest = 0;
    for (int i = 0; i < b->count; i++) {
        wfReal v = wfLength(b->state[i].v) + wfAbs(b->state[i].w);
        fastest = wfMaxR(fastest, v);
    }
    return 2 * b->h * (fastest + b->h * wfLength(b->gravity)) + WF_R(0.02);
}

static void bench_step(labBench *b)
{
    wfPool scratch;
    const wfSolverRow *row = &wfSolverTable[b->solver];
    if (row->step == NULL) bench_fly(b);
    bench_touch(b, strncmp(row->name, "impulse", 7) == 0 ? 0 : bench_margin(b));
    for (int i = 0; i < b->count; i++)
        if (b->state[i].invMass > 0)
            b->force[i].force = wfScale(1 / b->state[i].invMass, b->gravity);
    wfSolve solve = bench_solve(b, &scratch);
    if (row->step != NULL) wfSolveStep(b->solver, &solve);
    else if (wfSolveVelocities(b->solver, &solve) == WF_OK)
        wfSolvePositions(b->solver, &solve);
}

static void bench_run(labBench *b, int steps)
{
    for (int i = 0; i < steps; i++) bench_step(b);
}
/* <measurements> */
static int measure_friction_roll(FILE *out)
{
    static labBench b;
    bench_start(&b, "impulse-friction", 60);
    bench_box(&b, 0, -1, 100, 2, 0, 0.3);
    int disc = bench_disc(&b, 0, 0.5, 0.5, 1, 0.3);
    b.state[disc].v.x = 4;
    fprintf(out, "time,speed,rim speed\n");
    for (int i = 0; i <= 60; i++) {
        double v = (double)b.state[disc].v.x, rim = -0.5 * (double)b.state[disc].w;
        fprintf(out, "%.4f,%.4f,%.4f\n", i / 60.0, v, rim);
        bench_step(&b);
    }
    return 0;
}
/* <measurements> */
static int measure_friction_violin(FILE *out)
{
    static labBench b;
    const double k = 20, speed = 0.1, g = 9.81;
    bench_start(&b, "impulse-friction", 240);
    bench_box(&b, 0, -1, 200, 2, 0, 0.4);
    int box = bench_box(&b, 0, 0.5, 2, 1, 1, 0.4);
    b.sticking[0] = b.sticking[box] = WF_R(0.6);
    b.state[0].v.x = (wfReal)speed;
    b.state[box].invInertia = 0;
    fprintf(out, "time,place,sticks from,to\n");
    for (int i = 0; i <= 240 * 16; i++) {
        double x = (double)b.state[box].p.x;
        if (i % 12 == 0)
            fprintf(out, "%.3f,%.4f,%.4f,%.4f\n", i / 240.0, x, 0.2 * g / k, 0.6 * g / k);
        b.gravity.x = (wfReal)(-k * x);
        bench_step(&b);
        b.state[0].p.x = 0;
    }
    return 0;
}
/* <measurements> */
static int measure_friction_stop(FILE *out)
{
    static labBench b;
    fprintf(out, "hertz,distance,error,predicted\n");
    for (int hertz = 30; hertz <= 480; hertz *= 2) {
        bench_start(&b, "impulse-friction", hertz);
        bench_box(&b, 0, -1, 200, 2, 0, 0.5);
        int box = bench_box(&b, 0, 0.5, 4, 1, 1, 0.5);
        bench_run(&b, hertz / 2);
        double start = (double)b.state[box].p.x, want = 100 / (2 * 0.5 * 9.81);
        b.state[box].v.x = 10;
        bench_run(&b, 3 * hertz);
        double far = (double)b.state[box].p.x - start;
        fprintf(out, "%d,%.4f,%.3f,%.3f\n", hertz, far, 100 * (far / want - 1),
                100 * 0.5 * 10 / hertz / want);
    }
    return 0;
}
/* <measurements> */
static double creep_on_slope(const char *solver, double steep)
{
    static labBench b;
    double angle = atan(0.5 * steep);
    bench_start(&b, solver, 60);
    b.gravity = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
    bench_box(&b, 0, -1, 200, 2, 0, 0.5);
    int box = bench_box(&b, 0, 0.5, 1, 1, 1, 0.5);
    bench_run(&b, 600);
    return (double)b.state[box].p.x;
}

static int measure_friction_creep(FILE *out)
{
    fprintf(out, "steepness,crept (m),predicted (m)\n");
    for (int i = 0; i <= 19; i++) {
        double steep = 0.05 * i, sine = sin(atan(0.5 * steep));
        double crept = creep_on_slope("impulse-friction", steep);
        fprintf(out, "%.2f,%.4f,%.4f\n", steep, crept, 10 * 0.5 * 9.81 * sine / 60);
    }
    return 0;
}
/* <measurements> */
static void lab_stack(labBench *b, const char *solver, int boxes)
{
    bench_start(b, solver, 60);
    bench_box(b, 0, -1, 40, 2, 0, 0.6);
    for (int i = 0; i < boxes; i++) bench_box(b, 0, i + 0.5, 1, 1, 1, 0.6);
}

static int measure_sequential_stack(FILE *out)
{
    static labBench b;
    static const char *const solver[3] = { "impulse-friction", "sequential-baumgarte",
                                           "sequential" };
    fprintf(out, "solver,sunk,lean,speed\n");
    for (int s = 0; s < 3; s++) {
        lab_stack(&b, solver[s], 10);
        bench_run(&b, 1200);
        double fastest = 0;
        for (int i = 1; i <= 10; i++)
            fastest = fmax(fastest, (double)wfLength(b.state[i].v));
        double sunk = 9500 - 1000 * (double)b.state[10].p.y;
        fprintf(out, "%s,%.0f,%.0f,%.1f\n", solver[s], sunk,
                1000 * fabs((double)b.state[10].p.x), 1000 * fastest);
    }
    return 0;
}
/* <measurements> */
enum { CHAIN = 10 };
static double chain_error(int passes, bool warm)
{
    static wfBodyState state[CHAIN + 1];
    static wfContact contact[CHAIN];
    static _Alignas(16) uint8_t memory[1 << 13];
    double heavier[CHAIN], worst = 0;
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    for (int i = 0; i <= CHAIN; i++)
        state[i] = (wfBodyState){ .v = wfV2(0, i > 0 ? -1 : 0), .invMass = i > 0 };
    state[CHAIN].invMass = 1 / WF_R(1.05);
    for (int i = 0; i < CHAIN; i++) {
        contact[i] = (wfContact){ .a = i, .b = i + 1 };
        contact[i].manifold = (wfManifold){ .normal = wfV2(0, 1), .count = 1 };
        contact[i].manifold.points[0].normalImpulse = warm ? (wfReal)(CHAIN - i) : 0;
        heavier[i] = CHAIN - i + 0.05;
    }
    wfSolve in = { .state = state, .bodyCount = CHAIN + 1, .contacts = contact, .h = 1,
                   .contactCount = CHAIN, .iterations = passes, .scratch = &scratch };
    wfSolveVelocities(wfFindSolver("sequential"), &in);
    for (int i = 0; i < CHAIN; i++)
        worst = fmax(worst, fabs((double)contact[i].manifold.points[0].normalImpulse
                                 - heavier[i]));
    return worst / heavier[0];
}
/* <measurements> */
static int measure_sequential_convergence(FILE *out)
{
    double shrink = cos(3.14159265358979 / (2 * CHAIN));
    fprintf(out, "passes,from nothing,from the last step,predicted\n");
    for (int passes = 4; passes <= 256; passes += 4)
        fprintf(out, "%d,%.3e,%.3e,%.3e\n", passes, chain_error(passes, false),
                chain_error(passes, true), pow(shrink, 2 * passes));
    return 0;
}
/* <measurements> */
static double leap(const char *solver, double depth)
{
    static labBench b;
    double top = 0, rest = 0.5 - 0.005;
    bench_start(&b, solver, 60);
    bench_box(&b, 0, -1, 40, 2, 0, 0.6);
    int box = bench_box(&b, 0, 0.5 - depth, 1, 1, 1, 0.6);
    for (int i = 0; i < 120; i++) {
        bench_step(&b);
        top = fmax(top, (double)b.state[box].p.y - rest);
    }
    return 1000 * top;
}

static int measure_sequential_pop(FILE *out)
{
    fprintf(out, "depth,predicted,baumgarte,split\n");
    for (int mm = 10; mm <= 160; mm *= 2) {
        double speed = 0.4 * (mm - 5) * 60 / 1000;
        fprintf(out, "%d,%.1f,%.1f,%.1f\n", mm, 1000 * speed * speed / (2 * 9.81),
                leap("sequential-baumgarte", mm / 1000.0), leap("sequential", mm / 1000.0));
    }
    return 0;
}
/* <measurements> */
static int measure_sequential_creep(FILE *out)
{
    fprintf(out, "steepness,friction,sequential,predicted\n");
    for (int i = 1; i <= 5; i++) {
        double steep = i < 5 ? 0.2 * i : 0.95, sine = sin(atan(0.5 * steep));
        fprintf(out, "%.2f,%.4f,%.4f,%.4f\n", steep,
                creep_on_slope("impulse-friction", steep),
                creep_on_slope("sequential", steep), 10 * 0.5 * 9.81 * sine / 60);
    }
    return 0;
}
/* <measurements> */
static labBench *bouncing_ball(const char *solver, double height)
{
    static labBench b;
    bench_start(&b, solver, 60);
    b.passes = strcmp(solver, "soft") == 0 ? 1 : 8;
    int floor = bench_box(&b, 0, -1, 40, 2, 0, 0.5);
    int ball = bench_disc(&b, 0, 0.5 + height, 0.5, 1, 0.5);
    b.restitution[floor] = b.restitution[ball] = 1;
    return &b;
}

static double ball_energy(const labBench *b)
{
    const wfBodyState *s = &b->state[1];
    return (double)wfKineticEnergy(s) + 9.81 * ((double)s->p.y - 0.5);
}
/* <measurements> */
/* the change of energy after so many bounces, as a share */
static double after_bounces(const char *solver, double height, int bounces, wfFine *fine)
{
    labBench *b = bouncing_ball(solver, height);
    double start = ball_energy(b);
    b->fine = fine;
    for (int steps = 0; bounces > 0 && steps < 6000000; steps++) {
        bool down = b->state[1].v.y < 0;
        bench_step(b);
        if (down && b->state[1].v.y > 0) bounces--;
    }
    double rest = fine == NULL ? 0 : (double)b->state[1].v.y * (double)fine[1].v.y
                                     + 9.81 * (double)fine[1].p.y;
    return (ball_energy(b) + rest) / start - 1;
}
/* <measurements> */
static int measure_soft_bounce(FILE *out)
{
    static const char *const solver[3] = { "impulse-friction", "sequential", "soft" };
    double energy[3][61];
    for (int s = 0; s < 3; s++) {
        labBench *b = bouncing_ball(solver[s], 1.2345);
        double start = ball_energy(b);
        for (int i = 0; i <= 60; i++) {
            energy[s][i] = ball_energy(b) / start;
            bench_run(b, 30);
        }
    }
    fprintf(out, "time,resolver with friction,sequential,soft\n");
    for (int i = 0; i <= 60; i++)
        fprintf(out, "%.1f,%.5f,%.5f,%.5f\n", i / 2.0, energy[0][i], energy[1][i],
                energy[2][i]);
    return 0;
}

static int measure_soft_bounces(FILE *out)
{
    fprintf(out, "height,energy,kept\n");
    for (int i = 0; i < 5; i++) {
        double height = 0.5 + 0.7317 * i;
        wfFine fine[2] = { { .w = 0 } };
        fprintf(out, "%.3f,%.0f,%.4f\n", height,
                1e6 * after_bounces("soft", height, 10000, NULL),
                1e6 * after_bounces("soft", height, 10000, fine));
    }
    return 0;
}
/* <measurements> */
static double slide_error(const char *solver, int passes)
{
    static labBench b;
    bench_start(&b, solver, 60);
    b.passes = passes;
    bench_box(&b, 0, -1, 200, 2, 0, 0.5);
    int box = bench_box(&b, 0, 0.5, 4, 1, 1, 0.5);
    bench_run(&b, 60);
    double start = (double)b.state[box].p.x;
    b.state[box].v.x = 10;
    bench_run(&b, 180);
    return ((double)b.state[box].p.x - start) * 9.81 / 100 - 1;
}

static double roll_error(const char *solver, int passes)
{
    static labBench b;
    double angle = 20 * 3.14159265358979 / 180, want = 9.81 * sin(angle) * 2 / 3 * 2;
    bench_start(&b, solver, 60);
    b.passes = passes;
    b.gravity = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
    bench_box(&b, 0, -1, 200, 2, 0, 0.6);
    int disc = bench_disc(&b, 0, 0.5, 0.5, 1, 0.6);
    bench_run(&b, 120);
    return (double)b.state[disc].p.x / want - 1;
}
/* <measurements> */
/* how far a box creeps between the fifth and the tenth second, m */
static double late_creep(const char *solver, int passes, double steep)
{
    static labBench b;
    double angle = atan(0.5 * steep);
    bench_start(&b, solver, 60);
    b.passes = passes;
    b.gravity = wfV2((wfReal)(9.81 * sin(angle)), (wfReal)(-9.81 * cos(angle)));
    bench_box(&b, 0, -1, 200, 2, 0, 0.5);
    int box = bench_box(&b, 0, 0.5, 1, 1, 1, 0.5);
    bench_run(&b, 300);
    double start = (double)b.state[box].p.x;
    bench_run(&b, 300);
    return (double)b.state[box].p.x - start;
}
/* <measurements> */
static int measure_soft_compare(FILE *out)
{
    static const char *const solver[3] = { "impulse-friction", "sequential", "soft" };
    static const char *const what[4] = { "slide (%)", "roll (%)", "creep (mm)",
                                         "bounce (%)" };
    double got[4][3];
    for (int s = 0; s < 3; s++) {
        int passes = s == 2 ? 1 : 8;
        got[0][s] = 100 * slide_error(solver[s], passes);
        got[1][s] = 100 * roll_error(solver[s], passes);
        got[2][s] = 1000 * fabs(late_creep(solver[s], passes, 0.95));
        got[3][s] = 100 * after_bounces(solver[s], 1.2345, 100, NULL);
    }
    fprintf(out, "what,impulse,sequential,soft\n");
    for (int i = 0; i < 4; i++)
        fprintf(out, "%s,%.4f,%.4f,%.4f\n", what[i], got[i][0], got[i][1], got[i][2]);
    return 0;
}
/* <measurements> */
static double slip_error(void)
{
    double low = 0.9, high = 1.1;
    for (int i = 0; i < 14; i++) {
        double middle = (low + high) / 2;
        if (late_creep("soft", 1, middle) > 0.001) high = middle;
        else low = middle;
    }
    return (atan(0.5 * low) - atan(0.5)) * 180 / 3.14159265358979;
}
/* <measurements> */
static int measure_soft_squash(FILE *out)
{
    static labBench b;
    fprintf(out, "substeps,sunk,predicted,speed\n");
    for (int substeps = 4; substeps <= 256; substeps *= 2) {
        lab_stack(&b, "soft", 20);
        b.substeps = substeps;
        b.passes = 1;
        b.columns = 0;
        bench_run(&b, 1200);
        double fastest = 0;
        double dt = WF_CONTACT_PERIOD / (60.0 * substeps * 2 * 3.14159265358979);
        for (int i = 1; i <= 20; i++)
            fastest = fmax(fastest, (double)wfLength(b.state[i].v));
        double sunk = 19500 - 1000 * (double)b.state[20].p.y;
        fprintf(out, "%d,%.3f,%.3f,%.3f\n", substeps, sunk,
                1000 * 9.81 / 2 * (2.5 * 20 + 5 * 190) * dt * dt, 1000 * fastest);
    }
    return 0;
}
/* <measurements> */
static int measure_soft_passes(FILE *out)
{
    static labBench b;
    static const double how[7][3] = { { 1, 4, 10 }, { 2, 4, 10 }, { 2, 4, 5 }, { 1, 6, 20 },
                                      { 1, 6, 10 }, { 1, 6, 5 }, { 1, 8, 10 } };
    fprintf(out, "passes,period,damping,sunk,fastest\n");
    for (int k = 0; k < 7; k++) {
        double fastest = 0;
        bench_start(&b, "soft", 60);
        b.passes = (int)how[k][0];
        b.period = (wfReal)how[k][1];
        b.damping = (wfReal)how[k][2];
        bench_box(&b, 0, -1, 40, 2, 0, 0.6);
        for (int row = 0; row < 20; row++)
            for (int i = 0; i < 20 - row; i++)
                bench_box(&b, (i - (19 - row) / 2.0) * 1.05, row + 0.5, 1, 1, 1, 0.6);
        bench_run(&b, 300);
        for (int i = 1; i < b.count; i++)
            fastest = fmax(fastest, (double)wfLength(b.state[i].v));
        fprintf(out, "%.0f,%.0f,%.0f,%.1f,%.2f\n", how[k][0], how[k][1], how[k][2],
                19500 - 1000 * (double)b.state[b.count - 1].p.y, 1000 * fastest);
    }
    return 0;
}
/* <measurements> */
static void lab_tower(labBench *b, int boxes, uint32_t random)
{
    bench_start(b, "soft", 60);
    b->passes = 1;
    bench_box(b, 0, -1, 40, 2, 0, 0.6);
    for (int i = 0; i < boxes; i++) {
        random = random * 1664525u + 1013904223u;
        double aside = 0.01 * ((double)(random >> 8) / 8388608 - 1);
        bench_box(b, aside, i + 0.5, 1, 1, 1, 0.6);
    }
}

static bool tower_stays(labBench *b)
{
    const wfBodyState *first = &b->state[b->count - 1];
    double top = (double)first->p.y, aside = (double)first->p.x;
    for (int i = 0; i < 1200; i++) {
        bench_step(b);
        const wfBodyState *now = &b->state[b->count - 1];
        if (fabs((double)now->p.x - aside) > 1 || fabs((double)now->p.y - top) > 0.1 * top)
            return false;
    }
    return true;
}
/* <measurements> */
static bool passes_hold(int boxes, int substeps)
{
    static labBench b;
    lab_tower(&b, boxes, 7);
    b.substeps = substeps;
    b.columns = 0;
    return tower_stays(&b);
}
/* <measurements> */
static int measure_soft_tower(FILE *out)
{
    fprintf(out, "substeps,predicted,stands\n");
    for (int substeps = 4; substeps <= 16; substeps += 4) {
        double omega = 2 * 3.14159265358979 * 60 * substeps / WF_CONTACT_PERIOD;
        int low = 10, high = 90;
        while (high - low > 1) {
            int middle = (low + high) / 2;
            if (passes_hold(middle, substeps)) low = middle;
            else high = middle;
        }
        double boxes = pow(0.784 * omega * omega / 9.81, 1.0 / 3);
        fprintf(out, "%d,%.1f,%d\n", substeps, boxes, low);
    }
    return 0;
}
/* <measurements> */
static int measure_soft_columns(FILE *out)
{
    static labBench b;
    fprintf(out, "boxes,seed,sunk,aside,fastest\n");
    for (int boxes = 25; boxes <= 200; boxes *= 2)
        for (uint32_t seed = 7; seed < (boxes == 200 ? 9u : 8u); seed++) {
            lab_tower(&b, boxes, seed);
            double from = (double)b.state[boxes].p.x, fastest = 0;
            bool stays = tower_stays(&b);
            for (int i = 1; i <= boxes; i++)
                fastest = fmax(fastest, (double)wfLength(b.state[i].v));
            if (!stays) fprintf(out, "%d,%u,falls,,\n", boxes, (unsigned)seed);
            else fprintf(out, "%d,%u,%.2f,%.2f,%.2f\n", boxes, (unsigned)seed,
                         1000 * (boxes - 0.5 - (double)b.state[boxes].p.y),
                         1000 * ((double)b.state[boxes].p.x - from), 1000 * fastest);
        }
    return 0;
}
/* <measurements> */
static double heavy_sinks(double ratio, int columns)
{
    static labBench b;
    double low = 1.5;
    bench_start(&b, "soft", 60);
    b.passes = 1;
    b.columns = columns;
    bench_box(&b, 0, -1, 40, 2, 0, 0.6);
    bench_box(&b, 0, 0.5, 1, 1, 1, 0.6);
    int heavy = bench_box(&b, 0, 1.5, 1, 1, ratio, 0.6);
    for (int i = 0; i < 600; i++) {
        bench_step(&b);
        low = fmin(low, (double)b.state[heavy].p.y);
    }
    return 1.5 - low;
}
/* <measurements> */
static int measure_soft_heavy(FILE *out)
{
    fprintf(out, "ratio,passes,columns\n");
    for (double ratio = 10; ratio < 2e6; ratio *= 10)
        fprintf(out, "%.0f,%.1f,%.2f\n", ratio, 1000 * heavy_sinks(ratio, 0),
                1000 * heavy_sinks(ratio, 1));
    return 0;
}
/* <measurements> */
/* Boxes born in one place: fastest velocity, fastest motion, m/s; deepest overlap, m. */
static void lab_spawn(double steps, double *peak, double *way, double *deep)
{
    static labBench b;
    *peak = *way = *deep = 0;
    bench_start(&b, "soft", 60);
    b.passes = 1;
    b.recoverySteps = (wfReal)steps;
    bench_box(&b, 0, -20, 400, 40, 0, 0.6);
    for (int i = 0; i < 60; i++) bench_box(&b, 0, 2, 1, 1, 1, 0.6);
    for (int k = 0; k < 600; k++) {
        static wfVec2 was[64];
        for (int i = 1; i < b.count; i++) was[i] = b.state[i].p;
        bench_step(&b);
        for (int i = 1; i < b.count; i++) {
            wfVec2 moved = wfSub(b.state[i].p, was[i]);
            *peak = fmax(*peak, (double)wfLength(b.state[i].v));
            *way = fmax(*way, 60 * (double)wfLength(moved));
        }
    }
    for (int i = 0; i < b.contacts; i++)
        for (int k = 0; k < b.contact[i].manifold.count; k++)
            *deep = fmax(*deep, (double)b.contact[i].manifold.points[k].depth);
}
/* <measurements> */
static int measure_soft_spawn(FILE *out)
{
    fprintf(out, "setting,peak,moved,overlap\n");
    for (int steps = 0; steps <= 48; steps = steps == 0 ? 12 : 2 * steps) {
        double peak, way, deep;
        lab_spawn(steps, &peak, &way, &deep);
        fprintf(out, "%d,%.1f,%.1f,%.1f\n", steps, peak, way, 1000 * deep);
    }
    return 0;
}
/* <measurements> */
static int measure_soft_target(FILE *out)
{
    fprintf(out, "what,got\n");
    fprintf(out, "slide: error of the distance (%%),%.4f\n", 100 * slide_error("soft", 1));
    fprintf(out, "slip angle: error (degrees),%.4f\n", slip_error());
    fprintf(out, "creep at 95 %% of it in 5 s (mm),%.4f\n",
            1000 * fabs(late_creep("soft", 1, 0.95)));
    fprintf(out, "roll: error of the distance (%%),%.4f\n", 100 * roll_error("soft", 1));
    return 0;
}
/* <measurements> */
enum { JOINTS_MOST = 24 };

typedef struct labChain {
    wfBodyState state[JOINTS_MOST];
    wfBodyForces forces[JOINTS_MOST];
    wfJoint joint[JOINTS_MOST];
    wfJointStep step;
    wfPool pool;
    _Alignas(WF_POOL_ALIGN) unsigned char memory[1 << 18];
} labChain;

/* Boxes of 1 m and 1 kg in a row below body 0, the last one of `load' kg. */
static void labMakeChain(labChain *c, int links, double load, int substeps, int passes)
{
    memset(c, 0, sizeof *c);
    for (int i = 1; i <= links; i++) {
        wfReal m = i == links ? (wfReal)load : 1;
        c->state[i] = (wfBodyState){ .p = wfV2(0, WF_R(0.5) - (wfReal)i), .invMass = 1 / m,
                                     .invInertia = 6 / m };
        c->forces[i].force = wfV2(0, WF_R(-9.81) * m);
        c->joint[i - 1] = wfHinge(i - 1, &c->state[i - 1], i, &c->state[i],
                                  wfV2(0, (wfReal)(1 - i)));
    }
    wfPoolInit(&c->pool, sizeof c->memory, c->memory);
    c->step = (wfJointStep){ .state = c->state, .bodyCount = links + 1, .joints = c->joint,
        .jointCount = links, .forces = c->forces, .h = WF_R(1.0) / 60, .substeps = substeps,
        .passes = passes, .period = WF_JOINT_PERIOD, .damping = WF_JOINT_DAMPING,
        .give = WF_JOINT_GIVE, .scratch = &c->pool };
}
/* <measurements> */
/* How far the load is below its place, m: the last value and, in *worst, the greatest. */
static double labHang(labChain *c, int steps, double *worst)
{
    int links = c->step.jointCount;
    double off = 0;
    *worst = 0;
    for (int i = 0; i < steps; i++) {
        if (wfStepJoints(&c->step) != WF_OK) off = 1e9;
        else off = 0.5 - links - (double)c->state[links].p.y;
        if (!(fabs(off) < 1e3)) off = 1e9;              /* flown off, or no number at all */
        if (fabs(off) > *worst) *worst = fabs(off);
        if (off > 1e8) break;
    }
    return off;
}
/* <measurements> */
static int measure_joints_chain(FILE *out)
{
    fprintf(out, "substeps,load 1,load 10,load 100,load 1000\n");
    for (int substeps = 1; substeps <= 64; substeps *= 2) {
        fprintf(out, "%d", substeps);
        for (int load = 1; load <= 1000; load *= 10) {
            labChain chain;
            double worst;
            labMakeChain(&chain, 20, load, substeps, 1);
            fprintf(out, ",%.3g", labHang(&chain, 1200, &worst) / 20);
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static int measure_joints_rigid(FILE *out)
{
    fprintf(out, "links,load,passes,rigid,soft\n");
    for (int links = 1; links <= 8; links *= 2)
        for (int load = 1; load <= 100; load *= 100)
            for (int passes = 1; passes <= 8; passes *= 8) {
                fprintf(out, "%d,%d,%d", links, load, passes);
                for (int soft = 0; soft < 2; soft++) {
                    labChain chain;
                    double worst;
                    labMakeChain(&chain, links, load, 4, passes);
                    if (!soft) chain.step.period = 0;
                    labHang(&chain, 600, &worst);
                    if (worst < 1e8) fprintf(out, ",%.2g", worst);
                    else fprintf(out, ",-");
                }
                fprintf(out, "\n");
            }
    return 0;
}
/* <measurements> */
static double labMean(double a, double b)       /* Gauss's arithmetic-geometric mean */
{
    for (int i = 0; i < 40; i++) {
        double mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return a;
}

static double labSwingEnergy(const wfBodyState *s)
{
    double x = (double)s->v.x, y = (double)s->v.y, w = (double)s->w;
    return (x * x + y * y) / 2 + w * w / 2 / (double)s->invInertia + 9.81 * (double)s->p.y;
}
/* <measurements> */
static void labSwing(FILE *out, int substeps)
{
    labChain c;
    double mean = 0, gap = 0, first = 0, last = 0;
    int turns = -1;
    labMakeChain(&c, 1, 1, substeps, 1);
    c.state[1].p = wfV2(1, 0);
    c.joint[0] = wfHinge(0, &c.state[0], 1, &c.state[1], wfV2(0, 0));
    for (int i = 0; i < 3600; i++) {
        double before = (double)c.state[1].w, now;
        wfStepJoints(&c.step);
        now = (double)c.state[1].w;
        gap = fmax(gap, fabs((double)wfLength(c.state[1].p) - 1));
        if (i >= 3000) mean += labSwingEnergy(&c.state[1]) / 600;
        if (!(before < 0 && now >= 0)) continue;        /* it turns round on the left */
        last = (i + 1 - now / (now - before)) / 60;
        if (turns++ < 0) first = last;
    }
    double inertia = 1 + 1 / 6.0, exact = 2 * 3.14159265358979 * sqrt(inertia / 9.81);
    exact /= labMean(1, sqrt(0.5));
    fprintf(out, "%d,%.3f,%.4f,%.2g\n", substeps, -100 * mean / 9.81,
            100 * ((last - first) / turns / exact - 1), 1000 * gap);
}
/* <measurements> */
static int measure_joints_pendulum(FILE *out)
{
    fprintf(out, "substeps,energy,period,gap\n");
    for (int substeps = 1; substeps <= 32; substeps *= 2) labSwing(out, substeps);
    return 0;
}
/* <measurements> */
static bool labSpringsSurvive(double k, int rate)
{
    double y[12] = { 0 }, v[12] = { 0 }, h = 1.0 / rate;
    for (int i = 1; i <= 10; i++) y[i] = i == 10 ? 1e-3 : 0;       /* off their places */
    for (int step = 0; step < 10 * rate; step++) {
        for (int i = 1; i <= 10; i++) {
            double pull = k * (y[i - 1] - y[i]) + (i < 10 ? k * (y[i + 1] - y[i]) : 0);
            v[i] += h * pull;
        }
        for (int i = 1; i <= 10; i++) y[i] += h * v[i];
        if (!(fabs(y[10]) < 1)) return false;
    }
    return true;
}
/* <measurements> */
static int measure_joints_spring(FILE *out)
{
    fprintf(out, "rate,stiffness,spring,joint\n");
    for (int rate = 60; rate <= 960; rate *= 4) {
        double low = 1, high = 1e9, worst;
        for (int i = 0; i < 60; i++) {
            double middle = sqrt(low * high);
            if (labSpringsSurvive(middle, rate)) low = middle;
            else high = middle;
        }
        labChain chain;
        labMakeChain(&chain, 10, 1, 1, 1);
        chain.step.h = 1 / (wfReal)rate;
        double joint = labHang(&chain, 20 * rate, &worst);
        fprintf(out, "%d,%.0f,%.2f,%.2g\n", rate, low, 100 * 9.81 * 55 / low / 10,
                100 * joint / 10);
    }
    return 0;
}
/* <measurements> */
typedef struct labPeer { const char *engine, *theirs, *kind, *set; int32_t flags; } labPeer;

static const labPeer labPeers[] = {
    { "Box2D 2 and 3", "distance", "distance", "", 0 },
    { "Box2D 3", "distance with spring and limits", "distance", "stiffness and upper",
      WF_JOINT_SPRING | WF_JOINT_LIMITS },
    { "Box2D 2 and 3", "revolute", "revolute", "", 0 },
    { "Box2D 2 and 3", "revolute with motor and limits", "revolute",
      "motorSpeed and lower and upper",
      WF_JOINT_MOTOR | WF_JOINT_LIMITS },
    { "Box2D 3", "revolute with spring", "revolute", "stiffness", WF_JOINT_SPRING },
    { "Box2D 2 and 3", "prismatic", "prismatic", "", 0 },
    { "Box2D 2", "pulley", "pulley", "groundA and groundB and ratio", 0 },
    { "Box2D 2", "gear of two revolutes", "gear", "ratio", 0 },
    { "Box2D 2", "gear of prismatic and revolute", "rack", "ratio", 0 },
    { "Box2D 2", "gear of two prismatics", "linkage", "ratio", 0 },
    { "Box2D 2 and 3", "mouse", "hand", "groundB and motorForce", 0 },
    { "Box2D 2 and 3", "wheel", "wheel", "stiffness and motorSpeed",
      WF_JOINT_SPRING | WF_JOINT_MOTOR },
    { "Box2D 2 and 3", "weld", "weld", "", 0 },
    { "Box2D 2 and 3", "weld that gives", "weld", "stiffness", WF_JOINT_SPRING },
    { "Box2D 2", "friction", "friction", "motorForce and ratio", 0 },
    { "Box2D 2", "rope", "distance", "upper", WF_JOINT_LIMITS },
    { "Box2D 2 and 3", "motor", "servo", "stiffness and motorForce", 0 },
    { "Box2D 3", "filter (null)", "filter", "", 0 },
    { "Chipmunk", "pin", "distance", "", 0 },
    { "Chipmunk", "slide", "distance", "lower and upper", WF_JOINT_LIMITS },
    { "Chipmunk", "pivot", "revolute", "", 0 },
    { "Chipmunk", "groove", "wheel", "lower and upper", WF_JOINT_LIMITS },
    { "Chipmunk", "damped spring", "distance", "stiffness and damping", WF_JOINT_SPRING },
    { "Chipmunk", "damped rotary spring", "turn", "stiffness and damping",
      WF_JOINT_SPRING },
    { "Chipmunk", "rotary limit", "turn", "lower and upper", WF_JOINT_LIMITS },
    { "Chipmunk", "ratchet", "ratchet", "ratio (a tooth)", 0 },
    { "Chipmunk", "gear", "gear", "ratio", 0 },
    { "Chipmunk", "simple motor", "turn", "motorSpeed and motorForce", WF_JOINT_MOTOR },
    { "", "winch", "distance", "upper and negative motorSpeed",
      WF_JOINT_MOTOR | WF_JOINT_LIMITS },
};
/* <measurements> */
static int measure_joints_peers(FILE *out)
{
    fprintf(out, "engine,joint,kind,set,hold,limit,drive,spring\n");
    for (size_t i = 0; i < sizeof labPeers / sizeof *labPeers; i++) {
        const labPeer *p = &labPeers[i];
        wfBodyState s[2] = { { .p = wfV2(0, 0) }, { .p = wfV2(2, 1), .invMass = 1 } };
        wfJointRow row[WF_JOINT_ROWS];
        int count[5] = { 0 };
        if (wfFindJoint(p->kind) < 0) return 1;
        wfJoint j = wfMakeJoint(p->kind, 0, &s[0], 1, &s[1], s[0].p, s[1].p, wfV2(1, 0));
        j.flags = p->flags;
        j.stiffness = 1, j.motorForce = 1, j.lower = -1, j.upper = 3;
        if (wfCheckJoint(&j) != WF_OK) return 1;
        wfBuildJoint(&j, &s[0], &s[1], row);
        for (int k = 0; k < WF_JOINT_ROWS; k++) count[row[k].law]++;
        fprintf(out, "%s,%s,%s,%s", p->engine[0] ? p->engine : "-", p->theirs, p->kind,
                p->set[0] ? p->set : "-");
        fprintf(out, ",%d,%d,%d,%d\n", count[WF_ROW_HOLD], count[WF_ROW_LIMIT],
                count[WF_ROW_DRIVE], count[WF_ROW_SPRING]);
    }
    return 0;
}
/* <measurements> */
enum { TALL_BODIES = 1010, TALL_CONTACTS = 2100 };
typedef struct labTall {
    wfShape      shape[TALL_BODIES];
    wfBodyState  state[TALL_BODIES];
    wfBodyForces force[TALL_BODIES];
    wfContact    contact[TALL_CONTACTS], before[TALL_CONTACTS];
    int          count, contacts, reach;
    wfReal       friction;
    wfSolveReport report;
    _Alignas(16) uint8_t memory[1 << 24];
} labTall;
static labTall tall;

static int tall_add(const wfShape *shape, wfVec2 at, double mass, double inertia)
{
    int i = tall.count++;
    tall.shape[i] = *shape;
    tall.state[i] = (wfBodyState){ .p = at };
    tall.force[i] = (wfBodyForces){ .torque = 0 };
    if (!(mass > 0)) return i;
    tall.state[i].invMass = (wfReal)(1 / mass);
    tall.state[i].invInertia = (wfReal)(1 / inertia);
    tall.force[i].force = wfV2(0, (wfReal)(-9.81 * mass));
    return i;
}

static int tall_box(double x, double y, double w, double h, double mass)
{
    wfShape box;
    wfMakeBox((wfReal)(w / 2), (wfReal)(h / 2), &box);
    return tall_add(&box, wfV2((wfReal)x, (wfReal)y), mass, mass * (w * w + h * h) / 12);
}

static void tall_start(int reach)
{
    memset(&tall, 0, sizeof tall);
    tall.reach = reach;
    tall.friction = WF_R(0.6);
    tall_box(0, -1, 1000, 2, 0);
}
/* <measurements> */
static void tall_pair(int i, int k)
{
    wfSeparation s;
    wfTransform xi = wfBodyTransform(&tall.state[i]), xk = wfBodyTransform(&tall.state[k]);
    wfRect a = wfShapeBounds(&tall.shape[i], xi), b = wfShapeBounds(&tall.shape[k], xk);
    wfVec2 margin = wfV2(WF_R(0.02), WF_R(0.02));
    a.min = wfSub(a.min, margin), a.max = wfAdd(a.max, margin);
    if (!wfRectOverlap(a, b) || tall.contacts == TALL_CONTACTS) return;
    wfContact c = { .a = i, .b = k, .friction = tall.friction };
    if (wfSeparate(0, &tall.shape[i], xi, &tall.shape[k], xk, &s) != WF_OK) return;
    wfMakeManifoldWithin(&tall.shape[i], xi, &tall.shape[k], xk, &s, margin.x, &c.manifold);
    if (c.manifold.count > 0) tall.contact[tall.contacts++] = c;
}

static void tall_touch(void)
{
    int had = tall.contacts, at = 0;
    memcpy(tall.before, tall.contact, (size_t)had * sizeof *tall.before);
    tall.contacts = 0;
    for (int i = 0; i < tall.count; i++) {
        int last = i == 0 && tall.reach > 1 ? tall.count - 1 : i + tall.reach;
        for (int k = i + 1; k < tall.count && k <= last; k++) tall_pair(i, k);
    }
    for (int n = 0; n < tall.contacts; n++) {
        wfContact *c = &tall.contact[n];
        while (at < had && (tall.before[at].a < c->a ||
                            (tall.before[at].a == c->a && tall.before[at].b < c->b))) at++;
        if (at < had && tall.before[at].a == c->a && tall.before[at].b == c->b)
            wfCarryImpulses(&tall.before[at], c);
    }
}
/* <measurements> */
static wfSolve tall_solve(wfPool *scratch, int passes)
{
    wfPoolInit(scratch, sizeof tall.memory, tall.memory);
    return (wfSolve){ .state = tall.state, .bodyCount = tall.count,
        .contacts = tall.contact, .contactCount = tall.contacts, .h = WF_R(1.0) / 60,
        .iterations = passes, .positionShare = WF_R(0.4), .forces = tall.force,
        .substeps = 4, .scratch = scratch, .report = &tall.report };
}

/* the fastest body after so many steps, m/s; those that fall apart are fast */
static double tall_run(int steps)
{
    double fastest = 0;
    for (int i = 0; i < steps; i++) {
        wfPool scratch;
        tall_touch();
        wfSolve in = tall_solve(&scratch, 1);
        if (wfSolveStep(wfFindSolver("exact"), &in) != WF_OK) return 1e9;
    }
    for (int i = 0; i < tall.count; i++)
        fastest = fmax(fastest, (double)wfLength(tall.state[i].v));
    return fastest;
}
/* <measurements> */
static void tall_tower(int boxes, double top)
{
    uint32_t random = 7;
    tall_start(1);
    for (int i = 0; i < boxes; i++) {
        random = random * 1664525u + 1013904223u;
        double aside = 0.01 * ((double)(random >> 8) / 8388608 - 1);
        tall_box(aside, i + 0.5, 1, 1, i == boxes - 1 ? top : 1);
    }
}

static void tall_pyramid(int base)
{
    tall_start(2 * base);
    for (int y = 0; y < base; y++)
        for (int x = 0; x < base - y; x++)
            tall_box(1.05 * x + 0.525 * y, y + 0.5, 1, 1, 1);
}

/* planks of 1 m, each farther out than the one below, by so much of what is possible */
static void tall_overhang(int planks, double share)
{
    double x = 0;
    tall_start(2);
    tall.reach = 1;
    for (int i = 0; i < planks; i++) {
        if (i > 0) x += share / 2 / (planks - i);
        tall_box(x, 0.2 * i + 0.1, 1, 0.2, 1);
    }
}
/* <measurements> */
static void tall_arch(int stones, double thickness)
{
    double r = 10, part = 3.14159265358979 / stones;
    tall_start(2);
    tall.friction = 1;
    for (int i = 0; i < stones; i++) {
        wfVec2 corner[4], middle = wfV2(0, 0);
        wfShape stone;
        wfMassData mass;
        for (int k = 0; k < 4; k++) {
            double angle = part * (k < 2 ? i : i + 1);
            double at = r * (1 + (k == 0 || k == 3 ? -thickness : thickness) / 2);
            corner[k] = wfV2((wfReal)(at * cos(angle)), (wfReal)(at * sin(angle)));
            middle = wfAddScaled(middle, WF_R(0.25), corner[k]);
        }
        for (int k = 0; k < 4; k++) corner[k] = wfSub(corner[k], middle);
        if (wfMakePolygon(corner, 4, &stone) != WF_OK) return;
        if (wfShapeMass(&stone, 1, &mass) != WF_OK) return;
        /* <move the stone's origin to its centre of mass> */
        for (int k = 0; k < 4; k++) corner[k] = wfSub(corner[k], mass.centre);
        if (wfMakePolygon(corner, 4, &stone) != WF_OK) return;
        tall_add(&stone, wfAdd(middle, mass.centre), (double)mass.mass,
                 (double)mass.inertia);
    }
}
/* <measurements> */
static double tall_error(void)
{
    double worst = 0;
    for (int i = 0; i < tall.contacts; i++) {
        const wfContact *c = &tall.contact[i];
        const wfBodyState *a = &tall.state[c->a], *b = &tall.state[c->b];
        for (int k = 0; k < c->manifold.count; k++) {
            const wfContactPoint *p = &c->manifold.points[k];
            wfVec2 n = c->manifold.normal, t = wfContactTangent(n);
            double kn = (double)wfInverseEffectiveMass(a, b, p->point, n);
            double kt = (double)wfInverseEffectiveMass(a, b, p->point, t);
            double un = (double)wfRelativeNormalVelocity(a, b, p->point, n);
            double ut = (double)wfRelativeNormalVelocity(a, b, p->point, t);
            double jn = (double)p->normalImpulse, jt = (double)p->tangentImpulse;
            double limit = (double)c->friction * jn, want = jt - ut / kt;
            want = fmax(-limit, fmin(limit, want));
            worst = fmax(worst, fabs(jn - fmax(0, jn - un / kn)) * kn);
            worst = fmax(worst, fabs(jt - want) * kt);
        }
    }
    return worst;
}

/* The error of sequential impulses after so many passes from nothing, as a share. */
static double tall_passes(int passes)
{
    wfPool scratch;
    double before;
    tall.contacts = 0;
    tall_touch();
    for (int i = 1; i < tall.count; i++) {
        tall.state[i].v = wfV2(0, WF_R(-9.81) / 480);
        tall.state[i].w = 0;
    }
    before = tall_error();
    wfSolve in = tall_solve(&scratch, passes);
    wfSolveVelocities(wfFindSolver("sequential"), &in);
    return tall_error() / before;
}
/* <measurements> */
static int measure_exact_course(FILE *out)
{
    wfPool scratch;
    fprintf(out, "count,one by one,all at once\n");
    tall_tower(200, 1);
    tall_touch();
    wfSolve in = tall_solve(&scratch, 1);
    if (wfSolveStep(wfFindSolver("exact"), &in) != WF_OK) return 1;
    wfSolveReport r = tall.report;
    for (int i = 0; i <= 200; i += i < 10 ? 1 : 10) {
        tall_tower(200, 1);
        fprintf(out, "%d,%.3g", i, i > 0 ? tall_passes(i) : 1.0);
        if (i > r.longest || i >= WF_REPORT_COURSE) fprintf(out, ",\n");
        else fprintf(out, ",%.3g\n", (double)(r.course[i] / r.course[0]));
    }
    return 0;
}
/* <measurements> */
static void tall_scene(int scene)
{
    if (scene < 3) tall_tower(scene == 0 ? 10 : scene == 1 ? 100 : 1000, 1);
    if (scene == 3) tall_tower(10, 1e6);
    if (scene == 4) tall_pyramid(10);
    if (scene == 5) tall_arch(20, 0.12);
    if (scene == 6) tall_overhang(10, 0.99);
}

static int measure_exact_systems(FILE *out)
{
    static const char *const name[7] = { "tower of 10", "tower of 100", "tower of 1000",
        "tower of 10 with 1000 t on top", "pyramid of base 10", "arch of 20 stones",
        "overhang of 10 planks" };
    fprintf(out, "scene,rows,blocks,systems,passes\n");
    for (int scene = 0; scene < 7; scene++) {
        wfPool scratch;
        int rows = 0, passes = 1;
        tall_scene(scene);
        tall_touch();
        for (int i = 0; i < tall.contacts; i++) rows += tall.contact[i].manifold.count + 1;
        wfSolve in = tall_solve(&scratch, 1);
        if (wfSolveStep(wfFindSolver("exact"), &in) != WF_OK) return 1;
        fprintf(out, "%s,%d,%d,%d", name[scene], rows, tall.report.blocks,
                tall.report.longest);
        for (; passes < 20000; passes *= 2) {
            tall_scene(scene);
            if (tall_passes(passes) < 1e-3) break;
        }
        if (passes < 20000) fprintf(out, ",%d\n", passes);
        else fprintf(out, ",-\n");
    }
    return 0;
}
/* <measurements> */
/* The greatest (rising) or least share for which what is built still stands after 10 s. */
static double tall_limit(bool arch, double falls, double stands)
{
    for (int i = 0; i < 8; i++) {
        double middle = (falls + stands) / 2;
        if (arch) tall_arch(20, middle);
        else tall_overhang(10, middle);
        wfVec2 at = tall.state[10].p;
        tall_run(600);
        if ((double)wfDistance(at, tall.state[10].p) < 0.01) stands = middle;
        else falls = middle;
    }
    return stands;
}

static double tall_sinks(double ratio)
{
    tall_tower(2, ratio);
    wfVec2 at = tall.state[2].p;
    tall_run(600);
    return 1000 * (double)wfDistance(at, tall.state[2].p);
}
/* <measurements> */
static int measure_exact_target(FILE *out)
{
    fprintf(out, "what,got\n");
    tall_tower(1000, 1);
    wfVec2 at = tall.state[1000].p;
    double fastest = tall_run(1200);
    fprintf(out, "tower of 1000 boxes after 20 s: top has moved (mm),%.3g\n",
            1000 * (double)wfDistance(at, tall.state[1000].p));
    fprintf(out, "its fastest box (m/s),%.1g\n", fastest);
    for (double ratio = 1e3; ratio < 2e6; ratio *= 1e3)
        fprintf(out, "%.0f kg on 1 kg: moved (mm),%.3g\n", ratio, tall_sinks(ratio));
    fprintf(out, "thinnest arch of 20 stones (of its radius),%.4f\n",
            tall_limit(true, 0.1, 0.12));
    fprintf(out, "greatest overhang of 10 planks (of the harmonic one),%.4f\n",
            tall_limit(false, 1.03, 0.97));
    fprintf(out, "slide: error of the distance (%%),%.4f\n", 100 * slide_error("exact", 1));
    fprintf(out, "creep at 95 %% of the slip angle in 5 s (mm),%.4f\n",
            1000 * fabs(late_creep("exact", 1, 0.95)));
    fprintf(out, "roll: error of the distance (%%),%.4f\n", 100 * roll_error("exact", 1));
    return 0;
}
/* <measurements> */
static double tall_energy(void)
{
    double sum = 0;
    for (int i = 1; i < tall.count; i++) {
        if (!(tall.state[i].invMass > 0)) continue;
        sum += (double)wfKineticEnergy(&tall.state[i]);
        sum -= (double)(tall.force[i].force.y * tall.state[i].p.y);
    }
    return sum;
}

static void tall_heap(double friction)
{
    uint32_t random = 7;
    double number[4];
    tall_start(60);
    tall.friction = (wfReal)friction;
    tall_box(-4, 5, 2, 14, 0);
    tall_box(4, 5, 2, 14, 0);
    for (int i = 0; i < 40; i++) {
        for (int k = 0; k < 4; k++) {
            random = random * 1664525u + 1013904223u;
            number[k] = (double)(random >> 8) / 16777216;
        }
        int box = tall_box(4 * number[0] - 2, 1 + 0.9 * i, 0.5 + 0.5 * number[1],
                           0.5 + 0.5 * number[2], 1);
        tall.state[box].angle = (wfReal)(6 * number[3]);
    }
}
/* <measurements> */
static int measure_exact_heap(FILE *out)
{
    fprintf(out, "friction,problems,systems,unsolved,worst,rise\n");
    for (int mu = 0; mu <= 8; mu += 4) {
        int problems = 0, systems = 0, unsolved = 0;
        double worst = 0, rise = 0;
        tall_heap(mu / 10.0);
        double energy = tall_energy();
        for (int i = 0; i < 300; i++) {
            tall_run(1);
            problems += tall.report.solved + tall.report.unsolved;
            systems += tall.report.iterations;
            unsolved += tall.report.unsolved;
            if (tall.report.unsolved > 0) worst = fmax(worst, (double)tall.report.residual);
            rise = fmax(rise, tall_energy() - energy);
            energy = tall_energy();
        }
        fprintf(out, "%.1f,%d,%.2f,%d,%.2g,%.2g\n", mu / 10.0, problems,
                (double)systems / problems, unsolved, 1000 * worst, 1000 * rise);
    }
    return 0;
}
/* <measurements> */
static double labWidestGap(const labChain *c)
{
    double widest = 0;
    for (int i = 0; i < c->step.jointCount; i++) {
        const wfJoint *j = &c->joint[i];
        wfVec2 a = wfApply(wfBodyTransform(&c->state[j->a]), j->localA);
        wfVec2 b = wfApply(wfBodyTransform(&c->state[j->b]), j->localB);
        widest = fmax(widest, (double)wfDistance(a, b));
    }
    return widest;
}
/* <measurements> */
/* Turns a chain about its first hinge, rad. */
static void labTurnChain(labChain *c, double angle)
{
    wfRot q = wfRotation((wfReal)angle);
    for (int i = 1; i < c->step.bodyCount; i++) {
        c->state[i].p = wfRotate(q, c->state[i].p);
        c->state[i].angle = (wfReal)angle;
    }
    for (int i = 0; i < c->step.jointCount; i++) {
        wfJoint *j = &c->joint[i];
        wfVec2 at = wfApply(wfBodyTransform(&c->state[j->b]), j->localB);
        *j = wfHinge(j->a, &c->state[j->a], j->b, &c->state[j->b], at);
    }
}

static double labChainEnergy(const labChain *c)
{
    double sum = 0;
    for (int i = 1; i < c->step.bodyCount; i++)
        sum += (double)wfKineticEnergy(&c->state[i])
             + 9.81 * (double)c->state[i].p.y / (double)c->state[i].invMass;
    return sum;
}
/* <measurements> */
typedef struct labSwings { labChain c; double first, level; int32_t unsolved; } labSwings;
static _Alignas(WF_POOL_ALIGN) unsigned char labSwingRoom[1 << 18];
/* how: 0 one by one, 1 rigidly and with many passes, 2 all at once */
static void labMakeSwing(labSwings *s, int how, int links, double load, double degrees,
                         int substeps)
{
    labMakeChain(&s->c, links, load, substeps, how == 1 ? 400 : 1);
    s->level = -labChainEnergy(&s->c);
    labTurnChain(&s->c, degrees * 3.14159265358979 / 180);
    s->first = labChainEnergy(&s->c);
    wfPoolInit(&s->c.pool, sizeof labSwingRoom, labSwingRoom);
    if (how == 1) s->c.step.period = 0;
    s->c.step.unsolved = &s->unsolved;
    if (how == 2) s->c.step.prepare = wfExactJoints;
}

/* The gain of energy so far, %. */
static double labSwingGain(labSwings *s)
{
    return 100 * (labChainEnergy(&s->c) - s->first) / s->level;
}
/* <measurements> */
static int measure_exact_swing(FILE *out)
{
    static labSwings s[3];
    bool over[3] = { false, false, false };
    for (int how = 0; how < 3; how++) labMakeSwing(&s[how], how, 20, 1000, 60, 4);
    fprintf(out, "time,one by one,rigidly 400 passes,all at once\n");
    for (int i = 0; i <= 600; i++) {
        for (int how = 0; how < 3 && i > 0; how++)
            if (!over[how]) over[how] = wfStepJoints(&s[how].c.step) != WF_OK;
        if (i % 6 != 0) continue;
        fprintf(out, "%.1f", i / 60.0);
        for (int how = 0; how < 3; how++) {
            double gain = over[how] ? 1e9 : labSwingGain(&s[how]);
            over[how] = over[how] || !(gain < 100);
            if (over[how]) fprintf(out, ",");
            else fprintf(out, ",%.2f", 100 + gain);
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static int measure_exact_swings(FILE *out)
{
    static const double degrees[] = { 10, 60, 80, 90, 120, 150 };
    fprintf(out, "amplitude,substeps,one,all,gain,unsolved\n");
    for (int n = 0; n < 8; n++) {
        double angle = n < 6 ? degrees[n] : 60, end[2], most = 0;
        int substeps = n < 6 ? 4 : n == 6 ? 2 : 8, lost = 0;
        for (int how = 0; how < 2; how++) {
            static labSwings s;
            labMakeSwing(&s, 2 * how, 20, 1000, angle, substeps);
            for (int i = 0; i < 3600; i++) {
                if (wfStepJoints(&s.c.step) != WF_OK) return 1;
                double gain = labSwingGain(&s);
                if (how == 1) most = fmax(most, gain), lost += s.unsolved;
            }
            end[how] = labSwingGain(&s);
        }
        fprintf(out, "%g,%d,%.1f,%.3g,%.2g,%d\n", angle, substeps, end[0], end[1], most,
                lost);
    }
    return 0;
}
/* <measurements> */
static double labPendulum(double give, int substeps, double *period)
{
    static labSwings s;
    double first = 0, last = 0, mean = 0;
    int turns = -1;
    labMakeSwing(&s, 2, 1, 1, 90, substeps);
    s.c.state[1].p = wfV2(1, 0);
    s.c.joint[0] = wfHinge(0, &s.c.state[0], 1, &s.c.state[1], wfV2(0, 0));
    s.c.step.give = (wfReal)give;
    for (int i = 0; i < 3600; i++) {
        double before = (double)s.c.state[1].w;
        wfStepJoints(&s.c.step);
        double now = (double)s.c.state[1].w;
        if (i >= 3000) mean += labSwingEnergy(&s.c.state[1]) / 600;
        if (!(before < 0 && now >= 0)) continue;
        last = (i + 1 - now / (now - before)) / 60;
        if (turns++ < 0) first = last;
    }
    *period = (last - first) / turns;
    return 1e6 * mean / 9.81;
}

static int measure_exact_pendulum(FILE *out)
{
    double exact = 2 * 3.14159265358979 * sqrt((1 + 1 / 6.0) / 9.81), period, free;
    exact /= labMean(1, sqrt(0.5));
    fprintf(out, "substeps,energy,period,free\n");
    for (int substeps = 1; substeps <= 32; substeps *= 2) {
        free = labPendulum(0, substeps, &period);
        double energy = labPendulum((double)WF_JOINT_GIVE, substeps, &period);
        fprintf(out, "%d,%.1f,%.4f,%.1f\n", substeps, energy, 100 * (period / exact - 1),
                free);
    }
    return 0;
}
/* <measurements> */
static int measure_exact_gap(FILE *out)
{
    fprintf(out, "load,one by one,all at once\n");
    for (double load = 1; load <= 10000; load *= 10) {
        fprintf(out, "%g", load);
        for (int exact = 0; exact < 2; exact++) {
            static labChain c;
            static _Alignas(WF_POOL_ALIGN) unsigned char room[1 << 18];
            double widest = 0;
            labMakeChain(&c, 20, load, 4, exact ? 2 : 1);
            wfPoolInit(&c.pool, sizeof room, room);
            if (exact) c.step.prepare = wfExactJoints;
            for (int i = 0; i < 300; i++) {
                if (wfStepJoints(&c.step) != WF_OK) return 1;
                widest = fmax(widest, labWidestGap(&c));
            }
            fprintf(out, ",%.2g", fmax(widest, 1e-7));
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static double labTimeChain(int links, int how)
{
    static labSwings s;
    static wfExactCount count;
    double best = 1e9;
    for (int n = 0; n < 5; n++) {
        labMakeSwing(&s, how == 1 ? 2 : 0, links, 1, 60, 4);
        clock_t start = clock();
        for (int i = 0; i < 50; i++) {
            wfPoolInit(&s.c.pool, sizeof labSwingRoom, labSwingRoom);
            if (how < 2) wfStepJoints(&s.c.step);
            else wfCountExact(s.c.joint, links, s.c.state, links + 1, &s.c.pool, &count);
        }
        best = fmin(best, (double)(clock() - start) / CLOCKS_PER_SEC / 50);
    }
    return 1e6 * best;
}

static int measure_exact_time(FILE *out)
{
    fprintf(out, "machine,joints,one,all,order\n");
    for (int links = 5; links <= 20; links *= 2)
        fprintf(out, "chain,%d,%.1f,%.1f,%.2f\n", links, labTimeChain(links, 0),
                labTimeChain(links, 1), labTimeChain(links, 2));
    return 0;
}
/* <measurements> */
static void labTie(wfJoint *joint, int *count, int a, int b)
{
    joint[(*count)++] = (wfJoint){ .kind = wfFindJoint("revolute"), .a = a, .b = b,
                                   .ratio = 1, .axis = wfV2(1, 0) };
}

static int labMachine(int kind, int n, wfJoint *joint, wfBodyState *state, int *bodies)
{
    int joints = 0, side = 4;
    while (side * side < n / 2) side *= 2;
    *bodies = kind == 3 ? side * side : n + 1;
    for (int i = 0; i < *bodies; i++)
        state[i] = (wfBodyState){ .invMass = i > 0, .invInertia = i > 0 };
    for (int i = 1; i < *bodies && kind != 3; i++) {
        int to = kind == 1 ? (i - 1) / 2 : kind == 4 ? 1 : i - 1;
        if (i != to) labTie(joint, &joints, to, i);
    }
    if (kind == 2) labTie(joint, &joints, *bodies - 1, 0);
    if (kind == 2) state[0] = (wfBodyState){ .invMass = 1, .invInertia = 1 };
    for (int i = 0; i < side * side && kind == 3; i++) {
        if (i % side + 1 < side) labTie(joint, &joints, i, i + 1);
        if (i + side < side * side) labTie(joint, &joints, i, i + side);
    }
    return joints;
}
/* <measurements> */
static int measure_exact_cost(FILE *out)
{
    static const char *const name[] = { "chain", "tree", "ring", "net", "wheel" };
    fprintf(out, "machine,joints,blocks,fill,pairs\n");
    for (int kind = 0; kind < 5; kind++)
        for (int n = 16; n <= (kind == 4 ? 16 : 256); n *= 4) {
            static wfJoint joint[600];
            static wfBodyState state[600];
            static _Alignas(WF_POOL_ALIGN) unsigned char room[1 << 20];
            wfExactCount count;
            wfPool pool;
            int bodies = 0, joints = labMachine(kind, n, joint, state, &bodies);
            wfPoolInit(&pool, sizeof room, room);
            wfResult result = wfCountExact(joint, joints, state, bodies, &pool, &count);
            if (result != WF_OK) fprintf(out, "%s,%d,-,-,-\n", name[kind], joints);
            else fprintf(out, "%s,%d,%d,%d,%lld\n", name[kind], joints, count.blocks,
                         count.fill, (long long)count.pairs);
        }
    return 0;
}
/* <measurements> */
/* <take a part away by subtraction, the wrong way> */
static wfMassData subtract_part(wfMassData all, wfMassData part)
{
    wfMassData rest;
    rest.mass = all.mass - part.mass;
    rest.area = all.area - part.area;
    wfVec2 arm = wfSub(part.centre, all.centre);
    rest.centre = wfAddScaled(all.centre, -(part.mass / rest.mass), arm);
    rest.inertia = all.inertia - wfInertiaAbout(&part, all.centre)
                 - rest.mass * wfDistanceSq(rest.centre, all.centre);
    return rest;
}

static int measure_compound_remove(FILE *out)
{
    fprintf(out, "cargo,mass,centre,inertia,again\n");
    for (int cargo = 1; cargo <= 10000000; cargo *= 10) {
        wfShape small, large;
        wfMassData part[2], all, rest, again;
        if (wfMakeBox(WF_R(0.3), WF_R(0.2), &small) != WF_OK) return 1;
        if (wfMakeOrientedBox(wfV2(2, 1), 1, WF_R(0.7), WF_R(0.3), &large) != WF_OK)
            return 1;
        if (wfShapeMassOf(&small, 1, &part[0]) != WF_OK) return 1;
        if (wfShapeMassOf(&large, (wfReal)cargo, &part[1]) != WF_OK) return 1;
        if (wfCombineMasses(part, 2, &all) != WF_OK) return 1;
        if (wfCombineMasses(part, 1, &again) != WF_OK) return 1;
        rest = subtract_part(all, part[1]);
        /* <print what is left of the small box> */
        double centre = (double)wfDistance(rest.centre, part[0].centre);
        double inertia = (double)(rest.inertia / part[0].inertia) - 1;
        double error = (double)(again.inertia / part[0].inertia) - 1;
        fprintf(out, "%d,%.2g,%.2g,%.2g,%.2g\n", cargo, (double)rest.mass - 1, centre, inertia,
                error);
    }
    return 0;
}
/* <measurements> */
enum { OUTLINE_MOST = 1600, OUTLINES_EACH = 100 };
static wfVec2 outlineCorners[OUTLINE_MOST];
static wfShape outlineShapes[OUTLINE_MOST];
static _Alignas(16) uint8_t outlineBytes[OUTLINE_MOST * 128];
static const char *const outlineKind[] = { "star", "tangle" };

static wfPool outlineMake(wfRandom *r, int kind, int n)
{
    wfPool pool;
    wfPoolInit(&pool, sizeof outlineBytes, outlineBytes);
    if (kind == 0) random_star(r, n, outlineCorners);
    else random_tangle(r, n, outlineCorners);
    return pool;
}

static int outlineReflex(const wfMesh *m)
{
    int reflex = 0, n = m->cornerCount;
    for (int i = 0; i < n; i++) {
        wfVec2 before = m->corners[(i + n - 1) % n], after = m->corners[(i + 1) % n];
        reflex += wfOrientation(before, m->corners[i], after) < 0;
    }
    return reflex;
}
/* <measurements> */
/* sums over many outlines: reflex corners, pieces without and with flips, shapes, bound */
static int countPieces(int kind, int n, int sum[5], double *worst)
{
    wfRandom r;
    wfRandomSeed(&r, (uint64_t)n);
    for (int k = 0; k < OUTLINES_EACH; k++) {
        wfPool pool = outlineMake(&r, kind, n);
        wfMesh m;
        int count = 0;
        if (wfCutEars(outlineCorners, n, &pool, &m) != WF_OK) return 1;
        int reflex = outlineReflex(&m), least = (reflex + 1) / 2 + 1;
        int plain = wfMergeMesh(&m);
        wfPoolReset(&pool);
        if (wfCutEars(outlineCorners, n, &pool, &m) != WF_OK) return 1;
        wfFlipMesh(&m);
        int pieces = wfMergeMesh(&m);
        wfPoolReset(&pool);
        if (wfDecompose(outlineCorners, n, outlineShapes, OUTLINE_MOST, &count, &pool))
            return 1;
        const int add[5] = { reflex, plain, pieces, count, least };
        for (int i = 0; i < 5; i++) sum[i] += add[i];
        if (pieces > *worst * least) *worst = (double)pieces / least;
    }
    return 0;
}
/* <measurements> */
static int measure_compound_pieces(FILE *out)
{
    fprintf(out, "kind,corners,triangles,reflex,ears,flips,shapes,least,worst\n");
    for (int kind = 0; kind < 2; kind++)
        for (int n = 10; n <= 160; n *= 2) {
            int sum[5] = { 0 };
            double worst = 0;
            if (countPieces(kind, n, sum, &worst)) return 1;
            fprintf(out, "%s,%d,%d", outlineKind[kind], n, n - 2);
            for (int i = 0; i < 5; i++)
                fprintf(out, ",%.1f", (double)sum[i] / OUTLINES_EACH);
            fprintf(out, ",%.2f\n", worst);
        }
    return 0;
}
/* <measurements> */
static double timeOrientation(int n)
{
    int sum = 0;
    clock_t start = clock();
    for (int k = 0; k < 2000000; k++)
        sum += wfOrientation(outlineCorners[k % n], outlineCorners[k * 7 % n],
                             outlineCorners[k * 3 % n]);
    double took = (double)(clock() - start) / CLOCKS_PER_SEC / 2000000;
    return sum > 2000000 ? -1 : took;                   /* so that the sum is needed */
}

/* the shortest of five runs, each of so many calls that it lasts, s; -1: failed */
static double timeDecompose(int n, wfPool *pool)
{
    int count, calls = 200000 / (n * n) + 1;
    double best = 1e9;
    for (int run = 0; run < 5; run++) {
        clock_t start = clock();
        for (int i = 0; i < calls; i++)
            if (wfDecompose(outlineCorners, n, outlineShapes, OUTLINE_MOST, &count, pool))
                return -1;
        double took = (double)(clock() - start) / CLOCKS_PER_SEC / calls;
        if (took < best) best = took;
    }
    return best;
}
/* <measurements> */
static int measure_compound_time(FILE *out)
{
    double last[2] = { 0 };
    wfRandom r;
    wfRandomSeed(&r, 20);
    fprintf(out, "corners,star,star growth,tangle,tangle growth\n");
    for (int n = 25; n <= OUTLINE_MOST; n *= 2) {
        fprintf(out, "%d", n);
        for (int kind = 0; kind < 2; kind++) {
            wfPool pool = outlineMake(&r, kind, n);
            double took = timeDecompose(n, &pool) / timeOrientation(n);
            if (took < 0) return 1;
            fprintf(out, ",%.0f,", took);
            if (last[kind] > 0) fprintf(out, "%.2f", log2(took / last[kind]));
            last[kind] = took;
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
static bool impactPicture(wfReal wall, wfReal radius, wfReal way, bool turnedBack)
{
    wfShape w, ball;
    wfSeparation s;
    if (wfMakeBox(wall / 2, 2, &w) != WF_OK) return false;
    if (wfMakeCircle(wfV2(0, 0), radius, &ball) != WF_OK) return false;
    wfTransform xb = wfMakeTransform(wfV2(way - wall / 2 - radius, 0), 0);
    int sat = wfFindNarrowPhase("sat");
    if (wfSeparate(sat, &w, wfTransformIdentity(), &ball, xb, &s) != WF_OK) return false;
    return s.distance <= 0 && (!turnedBack || s.normal.x < 0);
}

static bool impactAlways(wfReal wall, wfReal radius, wfReal perStep, bool turnedBack)
{
    for (int phase = 1; phase <= 200; phase++)
        if (!impactPicture(wall, radius, perStep * (wfReal)phase / 200, turnedBack))
            return false;
    return true;
}
/* <measurements> */
static double impactSpeed(wfReal wall, wfReal radius, bool turnedBack)
{
    wfReal low = 0, high = 1000;
    for (int i = 0; i < 30; i++) {
        wfReal middle = (low + high) / 2;
        if (impactAlways(wall, radius, middle / 60, turnedBack)) low = middle;
        else high = middle;
    }
    return (double)low;
}
/* <measurements> */
static int measure_impact_tunnel(FILE *out)
{
    static const double walls[] = { 0.001, 0.01, 0.1, 1 };
    const wfReal radius = WF_R(0.05);
    fprintf(out, "wall,seen,seen_theory,back,back_theory,gap,steps\n");
    for (int i = 0; i < 4; i++) {
        wfReal wall = (wfReal)walls[i], half = WF_R(1e5) / 120;
        double sum = walls[i] + 0.1;
        /* <shoot the ball at 100 km/s> */
        wfShape w, ball;
        wfImpact hit;
        wfSweep flight = { .from = wfV2(-half, 0), .to = wfV2(half, 0) };
        if (wfMakeBox(wall / 2, 2, &w) != WF_OK) return 1;
        if (wfMakeCircle(wfV2(0, 0), radius, &ball) != WF_OK) return 1;
        wfSweep still = wfSweepStill(wfV2(0, 0), 0);
        if (wfTimeOfImpact(&w, still, &ball, flight, &hit) != WF_OK) return 1;
        if (hit.kind != WF_IMPACT_TOUCH) return 1;
        fprintf(out, "%g,%.2f,%.2f,%.2f,%.2f,%.2f,%d\n", walls[i],
                impactSpeed(wall, radius, false), 60 * sum,
                impactSpeed(wall, radius, true), 30 * sum, 1000 * (double)hit.distance,
                (int)hit.steps);
    }
    return 0;
}
/* <measurements> */
static bool impactSpinSeen(const wfShape *rod, const wfShape *peg, wfReal perStep)
{
    wfTransform xp = wfMakeTransform(wfV2(WF_R(0.8), 0), 0);
    wfSeparation s;
    for (int phase = 0; phase < 200; phase++) {
        bool seen = false;
        wfReal angle = -WF_R(1.2) + perStep * (wfReal)phase / 200;
        for (; angle < WF_R(1.2) && !seen; angle += perStep) {
            wfTransform xr = wfMakeTransform(wfV2(0, 0), angle);
            int sat = wfFindNarrowPhase("sat");
            if (wfSeparate(sat, rod, xr, peg, xp, &s) != WF_OK) return false;
            seen = s.distance <= 0;
        }
        if (!seen) return false;
    }
    return true;
}
/* <measurements> */
static int measure_impact_spin(FILE *out)
{
    static const double pegs[] = { 0.01, 0.05, 0.2 };
    fprintf(out, "peg,seen,seen_theory\n");
    for (int i = 0; i < 3; i++) {
        wfShape rod, peg;
        if (wfMakeBox(1, WF_R(0.02), &rod) != WF_OK) return 1;
        if (wfMakeCircle(wfV2(0, 0), (wfReal)pegs[i], &peg) != WF_OK) return 1;
        wfReal low = 0, high = 60;
        for (int k = 0; k < 20; k++) {
            wfReal middle = (low + high) / 2;
            if (impactSpinSeen(&rod, &peg, middle / 60)) low = middle;
            else high = middle;
        }
        wfReal x = ((wfReal)pegs[i] + WF_R(0.02)) / WF_R(0.8);
        wfReal theory = 2 * wfAtan2(x, wfSqrt(1 - x * x));      /* arcsin */
        fprintf(out, "%g,%.2f,%.2f\n", pegs[i], (double)low, 60 * (double)theory);
    }
    return 0;
}
/* <measurements> */
static int measure_impact_convergence(FILE *out)
{
    wfShape ground, box;
    wfImpact hit;
    wfImpactTrace t[WF_ADVANCE_KINDS];
    wfSweep still = wfSweepStill(wfV2(0, -1), 0);
    wfSweep fall = { .from = wfV2(-2, 2), .to = wfV2(1, WF_R(0.3)),
                     .angleFrom = WF_R(0.8), .angleTo = WF_R(3.3) };
    if (wfMakeBox(10, 1, &ground) != WF_OK) return 1;
    if (wfMakeBox(WF_R(0.5), WF_R(0.5), &box) != WF_OK) return 1;
    for (int how = 0; how < WF_ADVANCE_KINDS; how++)
        if (wfTraceImpact(&ground, still, &box, fall, how, &hit, &t[how]) != WF_OK)
            return 1;
    fprintf(out, "step,plain,along,disc,curve\n");
    for (int k = 0; k < t[WF_ADVANCE_PLAIN].count; k++) {
        fprintf(out, "%d", k + 1);
        for (int how = 0; how < WF_ADVANCE_KINDS; how++) {
            double gap = k < t[how].count ? (double)t[how].steps[k].distance : 0;
            gap -= (double)hit.near / 2;
            if (gap > 0) fprintf(out, ",%.6f", gap);
            else fprintf(out, ",");
        }
        fprintf(out, "\n");
    }
    return 0;
}
/* <measurements> */
typedef struct ImpactFlight { wfShape a, b; wfSweep sa, sb; } ImpactFlight;

static wfReal impactShadow(const ImpactFlight *f, wfVec2 n, wfReal t, long *rounds)
{
    ++*rounds;
    wfReal end = wfProject(&f->a, wfSweepAt(f->sa, t), n).max;
    return wfProject(&f->b, wfSweepAt(f->sb, t), n).min - end;
}

/* distances asked for; 0: it says "apart" */
static int impactBilateral(const ImpactFlight *f, wfReal near, long *rounds)
{
    wfReal t = 0;
    for (int step = 1; step <= WF_IMPACT_STEPS; step++) {
        wfDistanceResult r;
        wfTransform xa = wfSweepAt(f->sa, t), xb = wfSweepAt(f->sb, t);
        if (wfShapeDistance(&f->a, xa, &f->b, xb, &r) != WF_OK) return 0;
        if (r.distance <= near) return step;
        if (impactShadow(f, r.normal, 1, rounds) > near / 2) return 0;
        /* <close in on the wanted gap from both sides> */
        wfReal low = t, high = 1, fl = r.distance - near / 2;
        wfReal fh = impactShadow(f, r.normal, 1, rounds) - near / 2;
        for (int k = 0; k < 50 && fl > near / 4; k++) {
            wfReal at = k % 2 ? (low + high) / 2 : low + (high - low) * fl / (fl - fh);
            wfReal value = impactShadow(f, r.normal, at, rounds) - near / 2;
            if (value > 0) low = at, fl = value;
            else high = at, fh = value;
        }
        t = low;
    }
    return WF_IMPACT_STEPS;
}
/* <measurements> */
static wfResult impactBody(int kind, wfShape *out)
{
    wfVec2 v[WF_MAX_VERTICES];
    switch (kind) {
    case 0: return wfMakeCircle(wfV2(0, 0), WF_R(0.5), out);
    case 1: return wfMakeBox(WF_R(0.5), WF_R(0.5), out);
    case 2: return wfMakeBox(1, WF_R(0.05), out);
    case 3: return wfMakeCapsule(wfV2(-WF_R(0.4), 0), wfV2(WF_R(0.4), 0), WF_R(0.2), out);
    default:
        for (int i = 0; i < WF_MAX_VERTICES; i++) {
            wfRot q = wfRotation(2 * WF_PI * (wfReal)i / WF_MAX_VERTICES);
            v[i] = wfV2(WF_R(0.5) * q.c, WF_R(0.5) * q.s);
        }
        return wfMakePolygon(v, WF_MAX_VERTICES, out);
    }
}
/* <measurements> */
/* two draws in one call would have no fixed order */
static wfVec2 impactPlace(wfRandom *r)
{
    wfReal x = wfRandomReal(r, -3, 3);
    return wfV2(x, wfRandomReal(r, -3, 3));
}

static wfSweep impactSweep(wfRandom *r, wfReal turn)
{
    wfSweep s;
    s.from = impactPlace(r);
    s.to = impactPlace(r);
    s.angleFrom = wfRandomReal(r, -WF_PI, WF_PI);
    s.angleTo = s.angleFrom + turn * (wfReal)(wfRandomU32(r) & 1 ? 1 : -1);
    return s;
}
/* <measurements> */
typedef struct ImpactCount {
    long touching, steps[WF_ADVANCE_KINDS], both, rounds, missed, found, open;
    int most;
} ImpactCount;

static int impactCount(const ImpactFlight *f, ImpactCount *c)
{
    wfImpact hit[WF_ADVANCE_KINDS];
    wfImpactTrace trace;
    long rounds = 0;
    for (int how = 0; how < WF_ADVANCE_KINDS; how++)
        if (wfTraceImpact(&f->a, f->sa, &f->b, f->sb, how, &hit[how], &trace) != WF_OK)
            return 1;
    const wfImpact *best = &hit[WF_ADVANCE_CURVE];
    if (best->kind == WF_IMPACT_UNFINISHED) c->open++;
    if (best->kind != WF_IMPACT_TOUCH || best->t <= 0) return 0;
    c->touching++;
    for (int how = 0; how < WF_ADVANCE_KINDS; how++) c->steps[how] += hit[how].steps;
    if (best->steps > c->most) c->most = best->steps;
    int steps = impactBilateral(f, best->near, &rounds);
    if (steps == 0) { c->missed++; return 0; }
    c->found++;
    c->both += steps;
    c->rounds += rounds;
    return 0;
}
/* <measurements> */
static int measure_impact_steps(FILE *out)
{
    static const char *const names[5] = { "two circles", "two boxes", "two rods",
                                          "two capsules", "two 16-gons" };
    static const double turns[4] = { 0, 0.5, 3, 30 };
    fprintf(out, "pair,turn,touching,plain,along,disc,curve,most,open,bilateral,rounds,"
                 "missed\n");
    for (int row = 0; row < 20; row++) {
        if (row > 0 && row < 4) continue;       /* for circles a turn is nothing */
        wfRandom r;
        ImpactCount c = { .most = 0 };
        ImpactFlight f;
        wfRandomSeed(&r, 21);
        if (impactBody(row / 4, &f.a) != WF_OK || impactBody(row / 4, &f.b) != WF_OK)
            return 1;
        for (int i = 0; i < 4000; i++) {
            f.sa = impactSweep(&r, (wfReal)turns[row % 4]);
            f.sb = impactSweep(&r, (wfReal)turns[row % 4]);
            if (impactCount(&f, &c) != 0) return 1;
        }
        /* <write a row of the counts> */
        double n = (double)c.touching, m = (double)c.found;
        fprintf(out, "%s,%g,%ld", names[row / 4], turns[row % 4], c.touching);
        for (int how = 0; how < WF_ADVANCE_KINDS; how++)
            fprintf(out, ",%.2f", (double)c.steps[how] / n);
        fprintf(out, ",%d,%ld,%.2f,%.2f,%ld\n", c.most, c.open, (double)c.both / m,
                (double)c.rounds / m, c.missed);
    }
    return 0;
}
/* <measurements> */
enum { IMPACT_FLIGHTS = 1000 };

/* what: 0 the distance, 1 a cast, 2 a time of impact; s in all */
static double impactClock(const ImpactFlight *f, int what)
{
    double least = 1e9;
    for (int batch = 0; batch < 9; batch++) {
        clock_t start = clock();
        for (int i = 0; i < IMPACT_FLIGHTS; i++) {
            const ImpactFlight *p = &f[i];
            wfTransform xa = wfSweepAt(p->sa, 0), xb = wfSweepAt(p->sb, 0);
            wfVec2 by = wfSub(p->sa.to, p->sa.from);
            wfDistanceResult d;
            wfCast c;
            wfImpact hit;
            if (what == 0) wfShapeDistance(&p->a, xa, &p->b, xb, &d);
            if (what == 1) wfCastShape(&p->a, xa, by, &p->b, xb, &c);
            if (what == 2) wfTimeOfImpact(&p->a, p->sa, &p->b, p->sb, &hit);
        }
        double took = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (took < least) least = took;
    }
    return 1e9 * least / IMPACT_FLIGHTS;
}
/* <measurements> */
static int measure_impact_time(FILE *out)
{
    static const char *const names[5] = { "two circles", "two boxes", "two rods",
                                          "two capsules", "two 16-gons" };
    static ImpactFlight f[IMPACT_FLIGHTS];
    fprintf(out, "pair,distance,cast,straight,turning\n");
    for (int row = 0; row < 5; row++) {
        double took[4] = { 0 };
        for (int what = 0; what < 4; what++) {
            wfRandom r;
            wfRandomSeed(&r, 21);
            for (int i = 0; i < IMPACT_FLIGHTS; i++) {
                if (impactBody(row, &f[i].a) != WF_OK) return 1;
                f[i].b = f[i].a;
                f[i].sa = impactSweep(&r, what == 3 ? WF_R(0.5) : 0);
                f[i].sb = impactSweep(&r, what == 3 ? WF_R(0.5) : 0);
            }
            took[what] = impactClock(f, what == 3 ? 2 : what);
        }
        fprintf(out, "%s,%.0f,%.0f,%.0f,%.0f\n", names[row], took[0], took[1], took[2],
                took[3]);
    }
    return 0;
}
/* <measurements> */
typedef struct islandRun {
    int32_t *parent;
    double arrows, searches;
    bool halve;
} islandRun;

static int32_t island_search(islandRun *r, int32_t i)
{
    int32_t root = i;
    for (; r->parent[root] != root; root = r->parent[root]) r->arrows++;
    r->searches++;
    return r->halve ? wfRootOf(r->parent, i) : root;
}

static void island_edge(islandRun *r, int32_t a, int32_t b)
{
    int32_t p = island_search(r, a), q = island_search(r, b);
    if (p != q) wfUnite(r->parent, p, q);
}

static uint32_t island_random(uint32_t *seed, uint32_t below)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (uint32_t)(((uint64_t)*seed * below) >> 32);
}
/* <measurements> */
static void island_wall(islandRun *r, int32_t n, bool shuffled)
{
    int32_t w = 1;
    uint32_t seed = 1;
    while (w * w < n) w++;
    int32_t *name = malloc(sizeof *name * (size_t)(w * w));
    if (name == NULL) return;
    for (int32_t i = 0; i < w * w; i++) {
        int32_t j = shuffled ? (int32_t)island_random(&seed, (uint32_t)i + 1) : i;
        name[i] = i;
        name[i] = name[j];
        name[j] = i;
    }
    for (int32_t i = 0; i < w * w; i++) {
        if (i % w + 1 < w) island_edge(r, name[i], name[i + 1]);
        if (i + w < w * w) island_edge(r, name[i], name[i + w]);
    }
    free(name);
}
/* <measurements> */
static int32_t island_deepest(const islandRun *r, int32_t *depth, int32_t n)
{
    int32_t best = n - 1;
    for (int32_t i = 0; i < n; i++) {
        depth[i] = r->parent[i] == i ? 0 : depth[r->parent[i]] + 1;
        if (depth[i] > depth[best]) best = i;
    }
    return best;
}

static void island_worst(islandRun *r, int32_t n)
{
    int32_t low = n / 2, *depth = malloc(sizeof *depth * (size_t)n);
    if (depth == NULL) return;
    for (int32_t half = 1; half < n - low; half *= 2)
        for (int32_t at = low; at + half < n; at += 2 * half)
            wfUnite(r->parent, at, at + half);
    r->arrows = r->searches = 0;
    for (int32_t top = low - 1; top >= 0; top--) {
        wfUnite(r->parent, top, top + 1);
        depth[n - 1] = 0;
        island_search(r, r->halve ? island_deepest(r, depth, n) : n - 1);
    }
    free(depth);
}
/* <measurements> */
static double island_arrows(int kind, int32_t n, bool halve)
{
    islandRun r = { .parent = malloc(sizeof(int32_t) * 4 * (size_t)n), .halve = halve };
    uint32_t seed = 7;
    if (r.parent == NULL) return 0;
    wfPlant(r.parent, 4 * n);
    if (kind == 0)
        for (int32_t i = 0; i < 2 * n; i++) {
            uint32_t a = island_random(&seed, (uint32_t)n);
            island_edge(&r, (int32_t)a, (int32_t)island_random(&seed, (uint32_t)n));
        }
    if (kind == 1 || kind == 2) island_wall(&r, n, kind == 2);
    if (kind == 3) island_worst(&r, n);
    free(r.parent);
    return r.arrows / r.searches;
}

static int measure_islands_steps(FILE *out)
{
    fprintf(out, "bodies,random,grid,grid_random,worst,plain\n");
    for (int32_t n = 100; n <= 10000; n *= 10)
        fprintf(out, "%d,%.2f,%.2f,%.2f,%.1f,%.0f\n", n, island_arrows(0, n, true),
                island_arrows(1, n, true), island_arrows(2, n, true),
                island_arrows(3, n, true), island_arrows(3, n, false));
    return 0;
}
/* <measurements> */
/* <a pool that calls back> */
enum { POOL_BALLS = 4 };
typedef struct PoolGame {
    wfSlots list;
    wfSlot slots[POOL_BALLS];
    int name[POOL_BALLS], names;             /* every ball has a name of its own */
} PoolGame;

static void poolNew(PoolGame *g)
{
    int32_t i = wfSlotTake(&g->list, g->slots);
    if (i >= 0) g->name[i] = g->names++;
}

/* the user's function: ball b is in the pocket */
static void poolPocketed(PoolGame *g, int32_t b)
{
    wfSlotGive(&g->list, g->slots, b, g->slots[b].generation);
    poolNew(g);
}

static void poolStart(PoolGame *g)
{
    *g = (PoolGame){ .names = 0 };
    wfSlotsInit(&g->list, g->slots, POOL_BALLS);
    for (int i = 0; i < POOL_BALLS; i++) poolNew(g);
}
/* <measurements> */
static int measure_queries_callback(FILE *out)
{
    static const wfPair pairs[] = { { 0, 2 }, { 2, 3 } };
    PoolGame called, read;
    poolStart(&called);
    poolStart(&read);
    PoolGame truth = called;
    fprintf(out, "pair,truth,called,read\n");
    for (int i = 0; i < 2; i++) {
        int a = pairs[i].a, b = pairs[i].b;
        fprintf(out, "%d and %d,balls %d and %d,balls %d and %d,balls %d and %d\n", a, b,
                truth.name[a], truth.name[b], called.name[a], called.name[b],
                read.name[a], read.name[b]);
        if (a == 0) poolPocketed(&called, b);        /* in the middle of the step */
    }
    for (int i = 0; i < 2; i++)
        if (pairs[i].a == 0) poolPocketed(&read, pairs[i].b);       /* after it */
    return read.name[2] == called.name[2] ? 0 : 1;
}
/* <measurements> */
static int measure_queries_flutter(FILE *out)
{
    enum { STEPS = 100000 };
    fprintf(out, "margin,begins,formula,seconds\n");
    for (int k = 0; k <= 5; k++) {
        wfRandom r;
        wfReal margin = (wfReal)k / 5;
        int begins = 0;
        bool touching = false;
        wfRandomSeed(&r, 23);
        for (int step = 0; step < STEPS; step++) {
            bool now = wfTouchesNow(touching, wfRandomReal(&r, -1, 1), margin);
            begins += now && !touching;
            touching = now;
        }
        double mu = (double)margin, formula = 0.5 * (1 - mu) / (2 - mu) * STEPS;
        fprintf(out, "%.1f,%d,%.0f,%.2g\n", mu, begins, formula, STEPS / 60.0 / begins);
    }
    return 0;
}
/* <measurements> */
enum { QUERY_MOST = 10000, QUERY_ASKED = 200, QUERY_KINDS = 5 };
static const char *const queryNames[QUERY_KINDS] = {
    "ray of 4 m", "long ray", "long ray; all hits", "area", "nearest"
};

typedef struct QueryLab {
    wfShape shapes[QUERY_MOST];
    wfTransform places[QUERY_MOST];
    wfRect bounds[QUERY_MOST];
    uint8_t flags[QUERY_MOST];
    wfRayHit hits[QUERY_MOST];
    _Alignas(WF_POOL_ALIGN) uint8_t index[1 << 23], scratch[1 << 24];
    wfQueryWork work;
    wfShapeSet set;
} QueryLab;
/* <measurements> */
static QueryLab *queryLab(void)
{
    static QueryLab lab;
    return &lab;
}

static wfTransform queryPlace(const void *context, int32_t shape)
{
    return ((const QueryLab *)context)->places[shape];
}
/* <measurements> */
static void fillQueryLab(QueryLab *lab, int32_t n)
{
    static const wfVec2 three[3] = { { { -WF_R(0.4), -WF_R(0.3) } },
                                     { { WF_R(0.4), -WF_R(0.3) } }, { { 0, WF_R(0.4) } } };
    wfRandom r;
    wfRandomSeed(&r, 23);
    wfReal side = 2 * wfSqrt((wfReal)n);
    for (int32_t i = 0; i < n; i++) {
        wfShape *s = &lab->shapes[i];
        if (i % 4 == 0) wfMakeCircle(wfV2(0, 0), WF_R(0.5), s);
        if (i % 4 == 1) wfMakeBox(WF_R(0.5), WF_R(0.5), s);
        if (i % 4 == 2)
            wfMakeCapsule(wfV2(-WF_R(0.5), 0), wfV2(WF_R(0.5), 0), WF_R(0.3), s);
        if (i % 4 == 3) wfMakeRoundedPolygon(three, 3, WF_R(0.2), s);
        wfReal x = wfRandomReal(&r, 0, side), y = wfRandomReal(&r, 0, side);
        lab->places[i] = wfMakeTransform(wfV2(x, y), wfRandomReal(&r, -WF_PI, WF_PI));
        lab->bounds[i] = wfShapeBounds(s, lab->places[i]);
        lab->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
    }
    lab->set = (wfShapeSet){ .proxies = { .count = n, .bounds = lab->bounds,
                                          .flags = lab->flags },
                             .shapes = lab->shapes, .place = queryPlace,
                             .context = lab, .work = &lab->work };
}
/* <measurements> */
static int chooseQueryMethod(QueryLab *lab, int method)
{
    wfPool scratch;
    size_t bytes = wfIndexSize(method, lab->set.proxies.count);
    lab->set.method = method;
    lab->set.index = NULL;
    if (bytes == 0) return 0;
    if (bytes > sizeof lab->index) return 1;
    memset(lab->index, 0, bytes);
    wfPoolInit(&scratch, sizeof lab->scratch, lab->scratch);
    lab->set.index = lab->index;
    return wfUpdateIndex(method, &lab->set.proxies, lab->index, bytes, &scratch) != WF_OK;
}
/* <measurements> */
static wfResult askQuery(QueryLab *lab, int kind, wfRandom *r)
{
    static int32_t shapes[QUERY_MOST];
    int32_t count;
    wfClosest c;
    wfReal side = 2 * wfSqrt((wfReal)lab->set.proxies.count);
    wfReal x = wfRandomReal(r, 0, side), y = wfRandomReal(r, 0, side);
    wfRot q = wfRotation(wfRandomReal(r, -WF_PI, WF_PI));
    wfRay ray = { wfV2(x, y), wfScale(kind == 0 ? 4 : side, wfV2(q.c, q.s)) };
    wfRect area = wfRectCenterHalfDim(ray.from, wfV2(1, 1));
    if (kind < 2) return wfSetCastRay(&lab->set, ray, NULL, lab->hits);
    if (kind == 2)
        return wfSetCastRayAll(&lab->set, ray, NULL, lab->hits, QUERY_MOST, &count);
    if (kind == 3)
        return wfSetOverlapArea(&lab->set, area, NULL, shapes, QUERY_MOST, &count);
    return wfSetClosest(&lab->set, ray.from, side, NULL, &c);
}
/* <measurements> */
/* the same two hundred questions for every method; shapes looked at per question, or -1 */
static double askQueries(QueryLab *lab, int kind)
{
    wfRandom r;
    wfRandomSeed(&r, 32);
    lab->work = (wfQueryWork){ 0, 0 };
    for (int i = 0; i < QUERY_ASKED; i++)
        if (askQuery(lab, kind, &r) != WF_OK) return -1;
    return (double)lab->work.tested / QUERY_ASKED;
}

static void queryHeader(FILE *out)
{
    fprintf(out, "query,n");
    for (int m = 0; m < wfBroadPhaseCount; m++)
        fprintf(out, ",%s", wfBroadPhaseTable[m].name);
    fprintf(out, "\n");
}
/* <measurements> */
static int measure_queries_work(FILE *out)
{
    QueryLab *lab = queryLab();
    queryHeader(out);
    for (int32_t n = 100; n <= QUERY_MOST; n *= 10) {
        fillQueryLab(lab, n);
        for (int kind = 0; kind < QUERY_KINDS; kind++) {
            fprintf(out, "%s,%d", queryNames[kind], (int)n);
            for (int m = 0; m < wfBroadPhaseCount; m++) {
                if (chooseQueryMethod(lab, m)) return 1;
                fprintf(out, ",%.1f", askQueries(lab, kind));
            }
            fprintf(out, "\n");
        }
    }
    return 0;
}
/* <measurements> */
/* s for the two hundred questions: median of five, in batches of a millisecond or more */
static double timeQueries(QueryLab *lab, int kind)
{
    enum { RUNS = 5 };
    double seconds[RUNS];
    for (int run = 0, batch = 1; run < RUNS;) {
        clock_t start = clock();
        for (int i = 0; i < batch; i++) askQueries(lab, kind);
        double took = (double)(clock() - start) / CLOCKS_PER_SEC;
        if (run == 0 && took < 0.001 && batch < 1 << 16) { batch *= 2; continue; }
        int k = run++;
        for (; k > 0 && seconds[k - 1] > took / batch; k--) seconds[k] = seconds[k - 1];
        seconds[k] = took / batch;
    }
    return seconds[RUNS / 2];
}
/* <measurements> */
static int measure_queries_time(FILE *out)
{
    QueryLab *lab = queryLab();
    queryHeader(out);
    for (int32_t n = 100; n <= QUERY_MOST; n *= 10) {
        fillQueryLab(lab, n);
        for (int kind = 0; kind < QUERY_KINDS; kind++) {
            chooseQueryMethod(lab, wfFindBroadPhase("brute-force"));
            double scan = timeQueries(lab, kind);
            fprintf(out, "%s,%d", queryNames[kind], (int)n);
            for (int m = 0; m < wfBroadPhaseCount; m++) {
                if (chooseQueryMethod(lab, m)) return 1;
                fprintf(out, ",%.3g", 100 * timeQueries(lab, kind) / scan);
            }
            fprintf(out, "\n");
        }
    }
    return 0;
}
/* <measurements> */
/* eq:queries-school for a circle of radius 1 about the origin; -1: missed */
static wfReal schoolFraction(wfRay ray)
{
    wfVec2 m = wfNeg(ray.from);
    wfReal a = wfDot(ray.by, ray.by), b = wfDot(ray.by, m), c = wfDot(m, m) - 1;
    wfReal under = b * b - a * c;
    return under < 0 ? -1 : (b - wfSqrt(under)) / a;
}

/* how far a place on the ray is off the circle, m */
static double offCircle(wfRay ray, wfReal t)
{
    double x = (double)ray.from.x + (double)t * (double)ray.by.x;
    double y = (double)ray.from.y + (double)t * (double)ray.by.y;
    double square = x * x + y * y - 1;                     /* (d - 1)(d + 1) */
    return (square < 0 ? -square : square) / 2;
}
/* <measurements> */
static int measure_queries_school(FILE *out)
{
    enum { RAYS = 1000 };
    wfShape ball;
    wfRandom r;
    wfRandomSeed(&r, 3);
    wfMakeCircle(wfV2(0, 0), 1, &ball);
    fprintf(out, "distance,school,missed,ours,lost\n");
    for (wfReal far = 10; far <= 1000000; far *= 10) {
        double school = 0, ours = 0;
        int missed = 0, lost = 0;
        for (int i = 0; i < RAYS; i++) {
            /* <aim a ray at the ball and hit it by both formulas> */
            wfRot q = wfRotation(wfRandomReal(&r, -WF_PI, WF_PI));
            wfReal aside = wfRandomReal(&r, -WF_R(0.8), WF_R(0.8));
            wfVec2 from = wfScale(far, wfV2(q.c, q.s)), target = wfScale(aside, wfV2(-q.s, q.c));
            wfRay ray = { from, wfScale(2, wfSub(target, from)) };
            wfRayHit hit;
            if (wfRayShape(&ball, wfTransformIdentity(), ray, &hit) != WF_OK) return 1;
            wfReal t = schoolFraction(ray);
            double off = offCircle(ray, t), mine = offCircle(ray, hit.fraction);
            missed += t < 0;
            lost += hit.shape == WF_NO_SHAPE;
            if (t >= 0 && off > school) school = off;
            if (hit.shape != WF_NO_SHAPE && mine > ours) ours = mine;
        }
        fprintf(out, "%g,%.2g,%.1f,%.2g,%.1f\n", (double)far, school,
                100.0 * missed / RAYS, ours, 100.0 * lost / RAYS);
    }
    return 0;
}
/* <measurements> */
enum { HEAP_BODIES = 400, HEAP_WIDE = 20, HEAP_SETTLE = 400, HEAP_BATCH = 20 };

static wfResult heap_shape(int corners, wfShape *out)
{
    wfVec2 v[WF_MAX_VERTICES];
    if (corners == 2)
        return wfMakeCapsule(wfV2(-WF_R(0.3), 0), wfV2(WF_R(0.3), 0), WF_R(0.2), out);
    if (corners == 4) return wfMakeBox(WF_R(0.4), WF_R(0.4), out);
    for (int i = 0; i < corners; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / (wfReal)corners);
        v[i] = wfV2(WF_R(0.45) * q.c, WF_R(0.45) * q.s);
    }
    return wfMakePolygon(v, corners, out);
}

/* a floor, two walls, and bodies in rows, each a little out of line */
static wfResult fill_heap(wfWorld *world, int corners)
{
    wfRandom r;
    wfResult result = WF_OK;
    wfRandomSeed(&r, 24);
    for (int i = 0; i < HEAP_BODIES + 3 && result == WF_OK; i++) {
        wfBodyDef b = wfDefaultBodyDef();
        int k = i - 3;
        if (i == 0) result = wfMakeBox(30, 1, &b.shape);
        else if (i < 3) result = wfMakeBox(1, 60, &b.shape);
        else result = heap_shape(corners, &b.shape);
        b.type = i < 3 ? WF_STATIC : WF_DYNAMIC;
        b.position = i == 0 ? wfV2(0, -1) : wfV2(i == 1 ? -12 : 12, 60);
        wfReal aside = wfRandomReal(&r, -WF_R(0.2), WF_R(0.2));
        if (i > 2)
            b.position = wfV2((wfReal)(k % HEAP_WIDE) - WF_R(9.5) + aside,
                              (wfReal)(k / HEAP_WIDE) + WF_R(0.6));
        if (result == WF_OK) result = wfAddBodyToWorld(world, &b, NULL);
    }
    for (int i = 0; i < HEAP_SETTLE && result == WF_OK; i++) result = wfStepWorld(world);
    return result;
}
/* <measurements> */
static int measure_world_reuse(FILE *out)
{
    static const int corners[] = { 2, 4, 8, 16 };
    static const char *const names[] = { "capsules", "boxes", "8 corners", "16 corners" };
    fprintf(out, "bodies,contacts,fresh,reuse,gain\n");
    for (int row = 0; row < 4; row++) {
        wfWorld world[2];
        double least[2] = { 1e9, 1e9 };
        int32_t contacts = 0;
        for (int reuse = 0; reuse < 2; reuse++) {
            wfWorldDef def = wfDefaultWorldDef();
            def.reuse = reuse;
            def.bodyCapacity = HEAP_BODIES + 3;
            if (wfCreateWorld(&def, &world[reuse]) != WF_OK) return 1;
            if (fill_heap(&world[reuse], corners[row]) != WF_OK) return 1;
        }
        for (int batch = 0; batch < 18; batch++) {
            clock_t start = clock();
            for (int i = 0; i < HEAP_BATCH; i++) wfStepWorld(&world[batch & 1]);
            double took = 1e3 * (double)(clock() - start) / CLOCKS_PER_SEC / HEAP_BATCH;
            if (took < least[batch & 1]) least[batch & 1] = took;
        }
        wfWorldContacts(&world[1], &contacts);
        fprintf(out, "%s,%d,%.2f,%.2f,%.0f\n", names[row], (int)contacts, least[0],
                least[1], 100 * (1 - least[1] / least[0]));
        for (int reuse = 0; reuse < 2; reuse++) wfDestroyWorld(&world[reuse]);
    }
    return 0;
}
/* <measurements> */
static double apex_after_bounce(double drop, double dt)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wd.dt = (wfReal)dt;
    wd.bodyCapacity = 2;
    wd.solver = wfFindSolver("impulse");
    wd.slop = 0;
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), ball = wfDefaultBodyDef();
    wfBodyId id;
    wfBodyInfo info = { .velocity = { { 0, 0 } } };
    if (wfCreateWorld(&wd, &world) != WF_OK) return 0;
    ground.type = WF_STATIC;
    ground.position.y = -1;
    ground.restitution = 1;
    wfMakeBox(5, 1, &ground.shape);
    wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape);
    ball.position.y = (wfReal)drop + WF_R(0.5);
    wfAddBodyToWorld(&world, &ground, NULL);
    wfAddBodyToWorld(&world, &ball, &id);
    /* <step until the ball has bounced and its apex is known> */
    double top = 0;
    bool bounced = false;
    for (int i = 0; i < 100000 && !(bounced && info.velocity.y < 0); i++) {
        wfStepWorld(&world);
        wfGetBody(&world, id, &info);
        bounced = bounced || info.velocity.y > 0;
        double above = (double)info.position.y - 0.5, up = (double)info.velocity.y;
        if (bounced && up > 0) top = above + up * up / (2 * 9.81);  /* where it will turn */
    }
    wfDestroyWorld(&world);
    return top;
}
/* <measurements> */
static int measure_world_bounce(FILE *out)
{
    fprintf(out, "steps per second,dt,worst error of the apex\n");
    for (int rate = 30; rate <= 3840; rate *= 2) {
        double worst = 0;
        for (int i = 0; i < 40; i++) {
            double drop = 1.8 + 0.01 * i;
            double error = apex_after_bounce(drop, 1.0 / rate) / drop - 1;
            if (error < 0) error = -error;
            if (error > worst) worst = error;
        }
        fprintf(out, "%d,%.7f,%.6f\n", rate, 1.0 / rate, worst);
    }
    return 0;
}
/* <measurements> */
enum { FAR_SLIDE, FAR_ROLL, FAR_SWING, FAR_THINGS };

static bool build_far(wfVec2 o, wfWorld *world, wfBodyId id[FAR_THINGS])
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfBodyDef ground = wfDefaultBodyDef(), box, disk, ball;
    if (wfCreateWorld(&wd, world) != WF_OK) return false;
    ground.type = WF_STATIC;
    ground.position = wfAdd(o, wfV2(0, -1));
    wfMakeBox(60, 1, &ground.shape);
    wfAddBodyToWorld(world, &ground, NULL);
    box = disk = ball = wfDefaultBodyDef();
    wfMakeBox(WF_R(0.5), WF_R(0.5), &box.shape);
    box.position = wfAdd(o, wfV2(0, WF_R(0.5)));
    box.velocity = wfV2(5, 0);
    wfMakeCircle(wfV2(0, 0), WF_R(0.5), &disk.shape);
    disk.position = wfAdd(o, wfV2(-20, WF_R(0.5)));
    disk.velocity = wfV2(-2, 0);
    disk.angularVelocity = 4;
    wfMakeCircle(wfV2(0, 0), WF_R(0.25), &ball.shape);
    ball.position = wfAdd(o, wfV2(20, 5));
    bool made = wfAddBodyToWorld(world, &box, &id[FAR_SLIDE]) == WF_OK
             && wfAddBodyToWorld(world, &disk, &id[FAR_ROLL]) == WF_OK
             && wfAddBodyToWorld(world, &ball, &id[FAR_SWING]) == WF_OK;
    if (!made) return false;
    wfForce spring = wfSpringToPoint(wfBodyIndex(world, id[FAR_SWING]), wfV2(0, 0),
                                     wfAdd(o, wfV2(18, 8)), 2, 4, 0);
    return wfAddForceToWorld(world, &spring, NULL) == WF_OK;
}
/* <measurements> */
static void run_far(double distance, bool hasOrigin, double way[FAR_THINGS][2])
{
    wfWorld world;
    wfBodyId id[FAR_THINGS];
    wfBodyInfo from[FAR_THINGS], to;
    wfFar far = { distance, -0.3 * distance };
    wfVec2 o = hasOrigin ? wfV2(0, 0) : wfV2((wfReal)far.x, (wfReal)far.y);
    memset(way, 0, FAR_THINGS * sizeof *way);
    if (!build_far(o, &world, id)) return;
    if (hasOrigin) wfSetWorldOrigin(&world, far);
    for (int i = 0; i < FAR_THINGS; i++) wfGetBody(&world, id[i], &from[i]);
    for (int step = 0; step < 300; step++) wfStepWorld(&world);
    for (int i = 0; i < FAR_THINGS; i++) {
        wfGetBody(&world, id[i], &to);
        way[i][0] = (double)to.position.x - (double)from[i].position.x;
        way[i][1] = (double)to.position.y - (double)from[i].position.y;
    }
    wfDestroyWorld(&world);
}

static double far_error(double a[2], double b[2])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
}
/* <measurements> */
static int measure_world_far(FILE *out)
{
    double home[FAR_THINGS][2], way[FAR_THINGS][2], error[FAR_THINGS];
    run_far(0, false, home);
    fprintf(out, "distance (m),gap (m),slide (m),roll (m),swing (m),with origin (m)\n");
    for (int power = -1; power <= 12; power++) {
        double distance = power < 0 ? 0 : pow(10, power);
        double gap = (double)WF_EPSILON, worst = 0;
        for (double d = 2; d <= distance; d *= 2) gap *= 2;     /* eq:numbers-gap */
        run_far(distance, false, way);
        for (int i = 0; i < FAR_THINGS; i++) error[i] = far_error(way[i], home[i]);
        run_far(distance, true, way);
        for (int i = 0; i < FAR_THINGS; i++)
            worst = fmax(worst, far_error(way[i], home[i]));
        fprintf(out, "%g,%.2g,%.2g,%.2g,%.2g,%.2g\n", distance, gap, error[FAR_SLIDE],
                error[FAR_ROLL], error[FAR_SWING], worst);
    }
    return 0;
}
/* <measurements> */
static int measure_world_far_double(FILE *out)
{
    if (sizeof(wfReal) == sizeof(double)) return measure_world_far(out);
    fprintf(stderr, "weft-lab: this one has floats; take build/double/bin/weft-lab\n");
    return 1;
}
/* <measurements> */
static int measure_world_flight(FILE *out)
{
    static const double limit[3] = { 1e30, 1000, 10 };          /* m */
    wfWorldDef wd = wfDefaultWorldDef();
    wfBodyDef def = wfDefaultBodyDef();
    wfWorld world[3];
    wfBodyId id[3];
    wd.gravity = wfV2(0, 0);
    def.mass = 1;
    def.velocity = wfV2(1000, 0);
    for (int k = 0; k < 3; k++)
        if (wfCreateWorld(&wd, &world[k]) != WF_OK ||
            wfAddBodyToWorld(&world[k], &def, &id[k]) != WF_OK) return 1;
    fprintf(out, "time (s),way (m),at rest (m),within 1000 m (m),within 10 m (m)\n");
    for (int second = 1, step = 0; second <= 1200; second++) {
        for (; step < 60 * second; step++)
            for (int k = 0; k < 3; k++) {
                wfBodyInfo info;
                wfGetBody(&world[k], id[k], &info);
                wfCentreWorld(&world[k], info.position, (wfReal)limit[k], NULL);
                wfStepWorld(&world[k]);
            }
        /* <say how far the probes are from where they must be> */
        bool asked = second == 1 || second == 10 || second == 60 || second % 300 == 0;
        double way = 1000.0 * (double)wd.dt * step;
        if (asked) fprintf(out, "%d,%.0f", second, way);
        for (int k = 0; k < 3 && asked; k++) {
            wfFar at = { 0, 0 };
            wfFarPosition(&world[k], id[k], &at);
            fprintf(out, ",%.2g", fabs(at.x - way));
        }
        if (asked) fprintf(out, "\n");
    }
    for (int k = 0; k < 3; k++) wfDestroyWorld(&world[k]);
    return 0;
}
/* <measurements> */
enum { NEEDS_BODIES = 1000 };

static void name_needs(uint32_t needs, char text[64])
{
    text[0] = 0;
    for (int i = 0; i < wfNeedCount; i++) {
        if (!(needs & wfNeedTable[i].bit)) continue;
        if (text[0] != 0) strcat(text, " or ");
        strcat(text, wfNeedTable[i].name);
    }
}

static int measure_world_pays(FILE *out)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfRegion region[WF_REGION_COUNT];
    bool done[WF_REGION_COUNT] = { false };
    def.bodyCapacity = NEEDS_BODIES;
    if (wfWorldRegions(&def, region) != WF_OK) return 1;
    fprintf(out, "for,permanent,transient\n");
    for (int i = 0; i < WF_REGION_SCRATCH; i++) {
        size_t bytes[2] = { 0, 0 };
        char text[64] = "every body";
        uint32_t serves = wfRegionServes(i).needs;
        for (int k = i; k < WF_REGION_SCRATCH && !done[i]; k++) {
            if (done[k] || wfRegionServes(k).needs != serves) continue;
            bytes[region[k].chunk] += region[k].count * region[k].each;
            if (k > i) done[k] = true;
        }
        if (done[i]) continue;
        if (serves != 0) name_needs(serves, text);
        fprintf(out, "%s,%.1f,%.1f\n", text, (double)bytes[0] / NEEDS_BODIES,
                (double)bytes[1] / NEEDS_BODIES);
    }
    fprintf(out, "scratch of the stages,0.0,%.1f\n",
            (double)region[WF_REGION_SCRATCH].count / NEEDS_BODIES);
    return 0;
}
/* <measurements> */
static const struct { const char *name; uint32_t needs; } profile_table[] = {
    { "drops", 0 },
    { "drops that are pushed", WF_NEED_PUSHES },
    { "drops on springs, in wind", WF_NEED_FORCES | WF_NEED_DAMPING },
    { "shapes that fly and turn", WF_NEED_ROTATION | WF_NEED_SHAPES },
    { "the same, asked by rays", WF_NEED_ROTATION | WF_NEED_QUERIES },
    { "crates", WF_NEED_ROTATION | WF_NEED_CONTACTS | WF_NEED_FRICTION },
    { "crates, with events", WF_NEED_ROTATION | WF_NEED_FRICTION | WF_NEED_EVENTS },
};
enum { PROFILES = sizeof profile_table / sizeof *profile_table };

static int measure_world_needs(FILE *out)
{
    fprintf(out, "profile,permanent,transient,stages\n");
    for (int p = 0; p <= PROFILES; p++) {
        wfWorldDef def = wfDefaultWorldDef();
        size_t size[2];
        int stages = 0;
        def.bodyCapacity = NEEDS_BODIES;
        if (p < PROFILES) def.needs = profile_table[p].needs;
        if (wfWorldSize(&def, &size[0], &size[1]) != WF_OK) return 1;
        wfWorld world;
        if (wfCreateWorld(&def, &world) != WF_OK) return 1;
        for (int i = 0; i < wfStageCount; i++) {
            wfStageReport r;
            if (wfExplainStage(&world, i, &r) == WF_OK) stages += r.runs;
        }
        wfDestroyWorld(&world);
        fprintf(out, "%s,%.0f,%.0f,%d of %d\n",
                p < PROFILES ? profile_table[p].name : "all needs",
                (double)size[0] / NEEDS_BODIES, (double)size[1] / NEEDS_BODIES, stages,
                wfStageCount);
    }
    return 0;
}
/* <measurements> */
static wfResult fill_fountain(wfWorld *world)
{
    wfResult result = WF_OK;
    for (int i = 0; i < NEEDS_BODIES && result == WF_OK; i++) {
        wfBodyDef drop = wfDefaultBodyDefFor(world);
        drop.mass = 1;
        drop.position = wfV2((wfReal)(i % 40), 0);
        drop.velocity = wfV2((wfReal)(i % 7) - 3, WF_R(5.0) + (wfReal)(i % 11));
        result = wfAddBodyToWorld(world, &drop, NULL);
    }
    return result;
}

static double time_fountain(const wfWorldDef *def)
{
    wfWorld world;
    double least = 1e9;
    if (wfCreateWorld(def, &world) != WF_OK) return 0;
    if (fill_fountain(&world) != WF_OK) return 0;
    for (int batch = 0; batch < 20; batch++) {
        clock_t start = clock();
        for (int i = 0; i < 50; i++) wfStepWorld(&world);
        double took = (double)(clock() - start) / CLOCKS_PER_SEC / 50 / NEEDS_BODIES;
        if (took < least) least = took;
    }
    wfDestroyWorld(&world);
    return 1e9 * least;
}
/* <measurements> */
static int measure_world_needs_time(FILE *out)
{
    double usual = 0;
    static const char *const name[] = { "all needs", "all needs, integrator",
                                        "drops with substeps", "drops" };
    fprintf(out, "profile,ns,ratio\n");
    for (int p = 0; p < 4; p++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.bodyCapacity = NEEDS_BODIES;
        if (p == 1) def.solver = wfFindSolver("impulse");
        if (p >= 2) def.needs = p == 2 ? WF_NEED_SUBSTEPS : 0;
        double ns = time_fountain(&def);
        if (p == 0) usual = ns;
        fprintf(out, "%s,%.1f,%.2f\n", name[p], ns, ns / usual);
    }
    return 0;
}
/* <measurements> */
static wfResult fill_drops(wfWorld *world, int corners)
{
    (void)corners;
    return fill_fountain(world);
}

static int infer_row(FILE *out, const char *name, wfResult fill(wfWorld *, int),
                     int corners)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world[2];
    uint64_t hash[2];
    double kB[2];
    def.bodyCapacity = NEEDS_BODIES;
    for (int k = 0; k < 2; k++) {
        if (wfCreateWorld(&def, &world[k]) != WF_OK) return 1;
        if (fill(&world[k], corners) != WF_OK) return 1;
        for (int i = 0; i < HEAP_SETTLE; i++)
            if (wfStepWorld(&world[k]) != WF_OK) return 1;
        hash[k] = wfHashWorld(&world[k]);
        const wfMemory *m = &world[k].memory;
        kB[k] = (double)(m->permanentSize + m->transientSize) / 1024;
        if (wfInferNeeds(&world[k], 0, &def) != WF_OK) return 1;
    }
    fprintf(out, "%s,%.0f,%.0f,", name, kB[0], kB[1]);
    for (int i = 0, first = 1; i < wfNeedCount; i++) {
        if (!(def.needs & wfNeedTable[i].bit)) continue;
        fprintf(out, "%s%s", first ? "" : " ", wfNeedTable[i].name);
        first = 0;
    }
    fprintf(out, "\n");
    for (int k = 0; k < 2; k++) wfDestroyWorld(&world[k]);
    return hash[0] != hash[1];
}

static int measure_world_inferred(FILE *out)
{
    fprintf(out, "scene,before,after,needs\n");
    return infer_row(out, "a fountain of 1000 drops", fill_drops, 0)
        || infer_row(out, "a heap of 400 boxes", fill_heap, 4)
        || infer_row(out, "a heap of 400 capsules", fill_heap, 2);
}
/* <measurements> */
static void explain_cell(FILE *out, const wfStageReport *r)
{
    char text[64] = "always";
    if (r->because != 0) name_needs(r->because, text);
    if (r->runs) fprintf(out, ",%s,%zu", text, r->bytes);
    else fprintf(out, ",- (%s),0", text);
}

static int measure_world_explain(FILE *out)
{
    wfWorldDef drops = wfDefaultWorldDef(), crates = wfDefaultWorldDef();
    wfWorld world[2];
    drops.bodyCapacity = crates.bodyCapacity = NEEDS_BODIES;
    drops.needs = 0;
    crates.needs = WF_NEED_ROTATION | WF_NEED_CONTACTS | WF_NEED_FRICTION;
    if (wfCreateWorld(&drops, &world[0]) != WF_OK) return 1;
    if (wfCreateWorld(&crates, &world[1]) != WF_OK) return 1;
    fprintf(out, "stage,fountain,fountain_bytes,crates,crates_bytes\n");
    for (int i = 0; i < wfStageCount; i++) {
        fprintf(out, "%s", wfStageTable[i].name);
        for (int k = 0; k < 2; k++) {
            wfStageReport r;
            if (wfExplainStage(&world[k], i, &r) != WF_OK) return 1;
            explain_cell(out, &r);
        }
        fprintf(out, "\n");
    }
    for (int k = 0; k < 2; k++) wfDestroyWorld(&world[k]);
    return 0;
}
/* <measurements> */
static int measure_world_layout(FILE *out)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfRegion region[WF_REGION_COUNT];
    def.bodyCapacity = 3;
    def.forceCapacity = 1;
    if (wfWorldRegions(&def, region) != WF_OK) return 1;
    fprintf(out, "chunk,array,offset,elements,bytes each,end\n");
    for (int i = 0; i <= WF_REGION_NEW_HITS; i++) {
        const wfRegion *r = &region[i];
        if (i > WF_REGION_HITS && r->chunk == 0) continue;  /* of later chapters */
        fprintf(out, "%s,%s,%zu,%zu,%zu,%zu\n", r->chunk == 0 ? "permanent" : "transient",
                r->name, r->offset, r->count, r->each, r->offset + r->count * r->each);
    }
    return 0;
}
/* <measurements> */
typedef struct FastShot {
    const char *solver;
    int kind, wall, impacts;    /* wall: 0 stands, 1 is dynamic and light, 2 heavy */
    double speed, spin;
} FastShot;

static void fast_bullet(int kind, wfBodyDef *def)
{
    wfReal r = WF_R(0.05);
    *def = wfDefaultBodyDef();
    if (kind == 0) wfMakeCircle(wfV2(0, 0), r, &def->shape);
    if (kind == 1) wfMakeBox(r, r, &def->shape);
    if (kind == 2) wfMakeCapsule(wfV2(-r, 0), wfV2(r, 0), r / 2, &def->shape);
    if (kind == 3) wfMakeBox(4 * r, r / 4, &def->shape);
}

static wfWorldDef fast_world(const char *solver, int bodies, int impacts)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    def.bodyCapacity = bodies;
    def.solver = wfFindSolver(solver);
    def.impacts = impacts;
    return def;
}
/* <measurements> */
static int fast_through(const FastShot *s, int phase)
{
    wfWorldDef wd = fast_world(s->solver, 2, s->impacts);
    wfBodyDef sheet = wfDefaultBodyDef(), bullet;
    wfBodyInfo a, b;
    wfBodyId ids[2];
    wfWorld w;
    int through = 0;
    double step = s->speed / 60;
    if (wfCreateWorld(&wd, &w) != WF_OK) return 0;
    wfMakeBox(WF_R(0.01), 50, &sheet.shape);
    sheet.type = s->wall == 0 ? WF_STATIC : WF_DYNAMIC;
    if (s->wall == 1) sheet.mass = WF_R(0.04), sheet.fixedRotation = 1;
    fast_bullet(s->kind, &bullet);
    bullet.position = wfV2((wfReal)(-1.5 * step - 1 - step * phase / 20),
                           WF_R(0.01) * (wfReal)phase);
    bullet.angle = WF_R(0.1) * (wfReal)phase;
    bullet.velocity = wfV2((wfReal)s->speed, 0);
    bullet.angularVelocity = (wfReal)s->spin;
    wfAddBodyToWorld(&w, &sheet, &ids[0]);
    wfAddBodyToWorld(&w, &bullet, &ids[1]);
    for (int i = 0; i < 6; i++) {
        if (wfStepWorld(&w) != WF_OK) break;
        wfGetBody(&w, ids[0], &a), wfGetBody(&w, ids[1], &b);
        wfVec2 at = wfRotateInv(wfRotation(a.angle), wfSub(b.position, a.position));
        if (at.x > 0 && wfAbs(at.y) < 50) through = 1;
    }
    wfDestroyWorld(&w);
    return through;
}
/* <measurements> */
static int fast_count(FastShot s)
{
    int sum = 0;
    for (s.kind = 0; s.kind < 4; s.kind++)
        for (int phase = 0; phase < 20; phase++) sum += fast_through(&s, phase);
    return sum;
}

static int measure_fast_tunnel(FILE *out)
{
    static const double speeds[6] = { 10, 100, 300, 1000, 1e4, 1e5 };
    static const double spins[3] = { 0, 1000, 10000 };
    fprintf(out, "speed,seq_static,seq_dynamic,soft_static,soft_dynamic,on\n");
    for (int i = 0; i < 6; i++) {
        FastShot s = { .speed = speeds[i] };
        int on = 0;
        fprintf(out, "%g", s.speed);
        for (int k = 0; k < 4; k++) {
            s.solver = k < 2 ? "sequential" : "soft", s.wall = k % 2;
            fprintf(out, ",%d", fast_count(s));
        }
        s.impacts = 16;
        for (int k = 0; k < wfSolverCount * 9; k++) {
            s.solver = wfSolverTable[k / 9].name, s.wall = k / 3 % 3, s.spin = spins[k % 3];
            on += fast_count(s);
        }
        fprintf(out, ",%d\n", on);
    }
    return 0;
}
/* <measurements> */
static double fast_ghost(double gap, int impacts)
{
    double worst = 0;
    for (int phase = 0; phase < 20; phase++) {
        wfWorldDef wd = fast_world("soft", 2, impacts);
        wfBodyDef post = wfDefaultBodyDef(), bullet;
        wfBodyId id;
        wfBodyInfo b;
        wfWorld w;
        if (wfCreateWorld(&wd, &w) != WF_OK) return 0;
        wfMakeBox(WF_R(0.1), 1, &post.shape);
        post.type = WF_STATIC;
        fast_bullet(0, &bullet);
        bullet.position = wfV2(-8 - WF_R(0.25) * (wfReal)phase, (wfReal)(1.05 + gap));
        bullet.velocity = wfV2(300, 0);
        wfAddBodyToWorld(&w, &post, NULL);
        wfAddBodyToWorld(&w, &bullet, &id);
        for (int i = 0; i < 6; i++) wfStepWorld(&w);
        wfGetBody(&w, id, &b);
        double change = (double)wfDistance(b.velocity, bullet.velocity);
        if (change > worst) worst = change;
        wfDestroyWorld(&w);
    }
    return worst;
}

static int measure_fast_ghost(FILE *out)
{
    static const double gaps[5] = { 0.001, 0.003, 0.01, 0.03, 0.1 };
    fprintf(out, "gap,off,on\n");
    for (int i = 0; i < 5; i++)
        fprintf(out, "%g,%.1f,%.1f\n", 1000 * gaps[i], fast_ghost(gaps[i], 0),
                fast_ghost(gaps[i], 16));
    return 0;
}
/* <measurements> */
static double fast_way(double speed, int impacts)
{
    wfWorldDef wd = fast_world("soft", 3, impacts);
    wfBodyDef wall = wfDefaultBodyDef(), ball;
    wfFastReport report;
    wfBodyId id;
    wfBodyInfo b;
    wfWorld w;
    double rooms = 0;
    if (wfCreateWorld(&wd, &w) != WF_OK) return 0;
    wfMakeBox(WF_R(0.1), 1, &wall.shape);
    wall.type = WF_STATIC, wall.restitution = 1, wall.friction = 0;
    for (int side = -1; side <= 1; side += 2) {
        wall.position = wfV2(WF_R(0.6) * (wfReal)side, 0);
        wfAddBodyToWorld(&w, &wall, NULL);
    }
    fast_bullet(0, &ball);
    ball.restitution = 1, ball.friction = 0;
    ball.velocity = wfV2((wfReal)speed, 0);
    wfAddBodyToWorld(&w, &ball, &id);
    bool right = true;
    for (int i = 0; i < 60; i++) {
        wfStepWorld(&w);
        wfGetFastReport(&w, &report);
        wfGetBody(&w, id, &b);
        bool now = b.velocity.x > 0, turned = now != right;
        rooms += report.impacts + ((report.impacts % 2 != 0) != turned ? 1 : 0);
        right = now;
    }
    double x = b.velocity.x > 0 ? (double)b.position.x : -(double)b.position.x;
    wfDestroyWorld(&w);
    return 0.9 * rooms + x;
}

static int measure_fast_stop(FILE *out)
{
    static const double speeds[5] = { 11, 31, 97, 311, 701 };
    fprintf(out, "speed,one,theory,all\n");
    for (int i = 0; i < 5; i++) {
        double v = speeds[i], mean = v / (1 + v / 60 / (2 * 0.9)), most = 0.9 * 60;
        fprintf(out, "%g,%.1f,%.1f,%.1f\n", v, 100 * fast_way(v, 1) / v,
                100 * (mean < most ? mean : most) / v, 100 * fast_way(v, 16) / v);
    }
    return 0;
}
/* <measurements> */
static void fast_room(wfWorld *w, wfReal half)
{
    wfBodyDef wall = wfDefaultBodyDef();
    wall.type = WF_STATIC, wall.restitution = 1;
    for (int i = 0; i < 4; i++) {
        wfReal at = (i % 2 ? 1 : -1) * (half + 1);
        wall.position = i < 2 ? wfV2(at, 0) : wfV2(0, at);
        wfMakeBox(i < 2 ? 1 : half + 2, i < 2 ? half + 2 : 1, &wall.shape);
        wfAddBodyToWorld(w, &wall, NULL);
    }
}

static void fast_crowd(wfWorld *w, int count, bool bullets)
{
    wfRandom r;
    wfRandomSeed(&r, 25);
    for (int i = 0; i < count; i++) {
        wfBodyDef b = wfDefaultBodyDef();
        int side = bullets ? 32 : 60;
        wfReal radius = bullets ? WF_R(0.1) : WF_R(0.5), pitch = bullets ? 3 : WF_R(1.02);
        wfMakeCircle(wfV2(0, 0), radius, &b.shape);
        b.position = wfV2(pitch * ((wfReal)(i % side) - (wfReal)side / 2),
                          pitch * (wfReal)(i / side) - WF_R(49.4));
        if (bullets) {
            wfRot q = wfRotation(wfRandomReal(&r, -WF_PI, WF_PI));
            b.velocity = wfV2(300 * q.c, 300 * q.s);
            b.restitution = 1;
        }
        wfAddBodyToWorld(w, &b, NULL);
    }
}
/* <measurements> */
/* ms for a step; below 0: refused */
static double fast_clock(int count, bool bullets, int impacts, wfFastReport *sum)
{
    wfWorldDef wd = fast_world("soft", count + 4, impacts);
    wfFastReport now;
    wfWorld w;
    bool good = true;
    int steps = bullets ? 20 : 40;
    if (!bullets) wd.gravity = wfV2(0, WF_R(-9.81));
    if (wfCreateWorld(&wd, &w) != WF_OK) return -1;
    fast_room(&w, 50);
    fast_crowd(&w, count, bullets);
    wfStepWorld(&w);
    clock_t start = clock();
    for (int i = 0; i < steps && good; i++) {
        good = wfStepWorld(&w) == WF_OK;
        wfGetFastReport(&w, &now);
        sum->bodies += now.bodies, sum->impacts += now.impacts;
    }
    double took = 1000 * (double)(clock() - start) / CLOCKS_PER_SEC / steps;
    sum->bodies /= steps, sum->impacts /= steps;
    wfDestroyWorld(&w);
    return good ? took : -1;
}
/* <measurements> */
static int measure_fast_cost(FILE *out)
{
    static const int counts[4] = { 5000, 10, 100, 1000 };
    fprintf(out, "scene,off,on,fast,impacts\n");
    for (int i = 0; i < 4; i++) {
        wfFastReport sum = { 0, 0, 0 }, none = { 0, 0, 0 };
        double off = fast_clock(counts[i], i > 0, 0, &none);
        double on = fast_clock(counts[i], i > 0, 16, &sum);
        fprintf(out, "%s of %d,", i == 0 ? "a heap" : "bullets", counts[i]);
        if (off < 0) fprintf(out, "--,");
        else fprintf(out, "%.3f,", off);
        fprintf(out, "%.3f,%d,%d\n", on, (int)sum.bodies, (int)sum.impacts);
    }
    return 0;
}
/* <measurements> */
static void sleep_world(wfWorld *w, int32_t sleep, int32_t bodies, double share)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = sleep;
    def.sleepShare = (wfReal)share;
    def.bodyCapacity = bodies + 4;
    if (wfCreateWorld(&def, w) != WF_OK) exit(1);
}

static wfBodyId sleep_box(wfWorld *w, int32_t type, double x, double y, double wide,
                          double high)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id = { 0, 0 };
    def.type = type;
    def.position = wfV2((wfReal)x, (wfReal)y);
    if (wfMakeBox((wfReal)wide, (wfReal)high, &def.shape) == WF_OK)
        wfAddBodyToWorld(w, &def, &id);
    return id;
}

static double sleep_step_ms(wfWorld *w, int steps)
{
    clock_t start = clock();
    for (int i = 0; i < steps; i++) wfStepWorld(w);
    return 1000.0 * (double)(clock() - start) / CLOCKS_PER_SEC / steps;
}
/* <measurements> */
static void sleep_stacks(wfWorld *w, int32_t sleep, int32_t bodies)
{
    sleep_world(w, sleep, bodies, 0.04);
    sleep_box(w, WF_STATIC, 0, -1, 2.0 * bodies, 1);
    for (int32_t i = 0; i < bodies; i++)
        sleep_box(w, WF_DYNAMIC, 2.0 * (i / 10), 0.5 + i % 10, 0.5, 0.5);
    for (int i = 0; i < 100; i++) wfStepWorld(w);
}

static int measure_sleep_time(FILE *out)
{
    fprintf(out, "bodies,awake,asleep,ratio,one,one_ratio\n");
    for (int32_t bodies = 1000; bodies <= 10000; bodies *= 10) {
        wfWorld on, off;
        sleep_stacks(&off, 0, bodies);
        double awake = sleep_step_ms(&off, 20);
        wfDestroyWorld(&off);
        sleep_stacks(&on, 1, bodies);
        if (wfWorldRest(&on).asleep != bodies) return 1;
        double asleep = sleep_step_ms(&on, 1000);
        wfBodyDef ball = wfDefaultBodyDef();
        wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape);
        ball.position = wfV2(-20, WF_R(0.5));
        ball.velocity = wfV2(-5, 0);
        wfAddBodyToWorld(&on, &ball, NULL);
        double one = sleep_step_ms(&on, 300);
        fprintf(out, "%d,%.3g,%.3g,%.0f,%.3g,%.0f\n", bodies, awake, asleep,
                awake / asleep, one, awake / one);
        wfDestroyWorld(&on);
    }
    return 0;
}
/* <measurements> */
static void sleep_pile(wfWorld *w, int32_t sleep, double share, bool balls)
{
    sleep_world(w, sleep, 110, share);
    sleep_box(w, WF_STATIC, 0, -1, 20, 1);
    sleep_box(w, WF_STATIC, -5, 8, 0.5, 10);
    sleep_box(w, WF_STATIC, 5, 8, 0.5, 10);
    for (int i = 0; i < 100; i++) {
        double x = -3.5 + 0.7 * (i * 7 % 11), y = 1 + 0.3 * i;
        wfBodyDef ball = wfDefaultBodyDef();
        ball.position = wfV2((wfReal)x, (wfReal)y);
        wfMakeCircle(wfV2(0, 0), WF_R(0.35), &ball.shape);
        if (balls && i % 3 == 0) wfAddBodyToWorld(w, &ball, NULL);
        else sleep_box(w, WF_DYNAMIC, x, y, 0.3, 0.3);
    }
}

/* the time until all sleep, s, and how far the farthest is from where it would be, m */
static void sleep_try(double share, bool balls, double *time, double *way)
{
    wfWorld on, off;
    *time = *way = 0;
    sleep_pile(&on, 1, share, balls);
    sleep_pile(&off, 0, share, balls);
    for (int i = 0; i < 1000; i++) {
        if (*time == 0 && wfWorldRest(&on).asleep == 100) *time = i / 60.0;
        wfStepWorld(&on);
        wfStepWorld(&off);
    }
    wfBodyView a = wfWorldBodies(&on), b = wfWorldBodies(&off);
    for (int32_t i = 0; i < a.count; i++) {
        double apart = (double)wfDistance(a.state[i].p, b.state[i].p);
        if (apart > *way) *way = apart;
    }
    wfDestroyWorld(&on);
    wfDestroyWorld(&off);
}
/* <measurements> */
static int measure_sleep_share(FILE *out)
{
    static const double share[3] = { 0.01, 0.04, 0.08 };
    fprintf(out, "share,rate,time,way,time_balls\n");
    for (int k = 0; k < 3; k++) {
        double time[2], way[2];
        for (int balls = 0; balls < 2; balls++)
            sleep_try(share[k], balls != 0, &time[balls], &way[balls]);
        fprintf(out, "%.2f,%.1f,%.1f,%.1f,%.1f\n", share[k],
                share[k] * sqrt(2.0) * 300 / 0.5, time[0], 1000 * way[0], time[1]);
    }
    return 0;
}
/* <measurements> */
static void save_wall(wfWorld *world, wfReal x, wfReal y, wfReal halfWidth,
                      wfReal halfHeight)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    d.position = wfV2(x, y);
    wfMakeBox(halfWidth, halfHeight, &d.shape);
    wfAddBodyToWorld(world, &d, NULL);
}

/* n boxes that fall between two walls, or n balls that roll on a floor. */
static wfResult save_scene(int n, bool spread, bool sleep, wfWorld *out)
{
    wfWorldDef def = wfDefaultWorldDef();
    int wide = spread ? n : (int)wfSqrt((wfReal)n);
    wfReal half = WF_R(0.45) * (wfReal)wide + 1;
    def.bodyCapacity = n + 3;
    def.sleep = sleep;
    wfResult result = wfCreateWorld(&def, out);
    if (result != WF_OK) return result;
    save_wall(out, 0, -1, half + 2, 1);
    save_wall(out, -half - 1, half, 1, 2 * half);
    save_wall(out, half + 1, half, 1, 2 * half);
    for (int i = 0; i < n && result == WF_OK; i++) {
        wfBodyDef d = wfDefaultBodyDef();
        wfReal shift = (wfReal)(i / wide % 2) * WF_R(0.3);
        d.position = wfV2(WF_R(0.9) * ((wfReal)(i % wide) - (wfReal)(wide - 1) / 2) + shift,
                          WF_R(0.4) + WF_R(0.9) * (wfReal)(i / wide));
        d.velocity = wfV2(spread ? (wfReal)(i % 7 - 3) : 0, 0);
        if (spread) wfMakeCircle(wfV2(0, 0), WF_R(0.4), &d.shape);
        else wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape);
        result = wfAddBodyToWorld(out, &d, NULL);
    }
    return result;
}
/* <measurements> */
static size_t save_changed(const wfWorld *a, const wfWorld *b)
{
    wfBlock one, two;
    wfImage before, now;
    size_t blocks = 0;
    if (wfOpenBlock(a, &one) != WF_OK || wfOpenBlock(b, &two) != WF_OK) return 0;
    if (wfImageOfBlock(&one, &before) != WF_OK) return 0;
    if (wfImageOfBlock(&two, &now) != WF_OK) return 0;
    for (int i = 0; i < WF_REGION_COUNT; i++)
        for (size_t at = 0; at < now.bytes[i]; at += 64) {
            size_t size = now.bytes[i] - at < 64 ? now.bytes[i] - at : 64;
            bool same = at + size <= before.bytes[i]
                     && memcmp(before.at[i] + at, now.at[i] + at, size) == 0;
            blocks += !same;
        }
    return blocks;
}

static int measure_save_rewind(FILE *out)
{
    static const struct { const char *name; int steps; bool spread, sleep; } row[] = {
        { "pile that falls", 60, false, false },
        { "pile at rest (awake)", 900, false, false },
        { "pile asleep", 1500, false, true },
        { "balls that roll", 60, true, false } };
    fprintf(out, "scene,whole,blocks,every60\n");
    for (int k = 0; k < 4; k++) {
        wfWorld world, before;
        size_t whole = 0, changed = 0;
        enum { STEPS = 10 };
        if (save_scene(1000, row[k].spread, row[k].sleep, &world) != WF_OK) return 1;
        for (int i = 0; i < row[k].steps; i++)
            if (wfStepWorld(&world) != WF_OK) return 1;
        for (int i = 0; i < STEPS; i++) {
            if (wfCloneWorld(&world, NULL, &before) != WF_OK) return 1;
            if (wfStepWorld(&world) != WF_OK) return 1;
            whole += wfSnapshotSize(&world);
            changed += 72 * save_changed(&before, &world);
            wfDestroyWorld(&before);
        }
        fprintf(out, "%s,%zu,%zu,%zu\n", row[k].name, whole / STEPS, changed / STEPS,
                whole / STEPS / 60);
        wfDestroyWorld(&world);
    }
    return 0;
}
/* <measurements> */
typedef struct SaveTimes { double copy, snapshot, restore, compare, save; } SaveTimes;

static double save_seconds(clock_t from)
{
    return (double)(clock() - from) / CLOCKS_PER_SEC;
}

static void keep_least(double *least, double seconds)
{
    if (*least <= 0 || seconds < *least) *least = seconds;
}

static void save_round(wfWorld *world, wfWorld *twin, uint8_t *bytes, uint8_t *copy,
                       size_t size, int times, SaveTimes *t)
{
    size_t got;
    void *(*volatile copier)(void *, const void *, size_t) = memcpy;
    clock_t start = clock();
    for (int i = 0; i < times; i++) copier(copy, bytes, size);
    keep_least(&t->copy, save_seconds(start));
    start = clock();
    for (int i = 0; i < times; i++) wfSnapshotWorld(world, bytes, size, &got);
    keep_least(&t->snapshot, save_seconds(start));
    start = clock();
    for (int i = 0; i < times; i++) wfRestoreWorld(twin, bytes, size);
    keep_least(&t->restore, save_seconds(start));
    start = clock();
    for (int i = 0; i < times; i++) wfCompareWorlds(world, twin, NULL);
    keep_least(&t->compare, save_seconds(start));
    start = clock();
    size_t room = wfSaveSize(world);
    for (int i = 0; i < times / 16 + 1; i++) wfSaveToBytes(world, bytes, room, &got);
    keep_least(&t->save, save_seconds(start) * times / (times / 16 + 1));
}
/* <measurements> */
static int measure_snapshot_time(FILE *out)
{
    fprintf(out, "bodies,bytes,memcpy,snapshot,restore,compare,save\n");
    for (int n = 10; n <= 10000; n *= 10) {
        wfWorld world, twin;
        SaveTimes t = { .copy = 0 };
        if (save_scene(n, false, false, &world) != WF_OK) return 1;
        for (int i = 0; i < 60; i++)
            if (wfStepWorld(&world) != WF_OK) return 1;
        size_t size = wfSnapshotSize(&world), room = wfSaveSize(&world) + 64;
        uint8_t *bytes = calloc(1, room), *copy = calloc(1, room);
        if (!bytes || !copy || wfCloneWorld(&world, NULL, &twin) != WF_OK) return 1;
        int times = (int)(4000000 / size) + 1;
        for (int round = 0; round < 40; round++)
            save_round(&world, &twin, bytes, copy, size, times, &t);
        fprintf(out, "%d,%zu,%.2f,%.2f,%.2f,%.2f,%.2f\n", n, size,
                (double)size * times / t.copy * 1e-9, t.copy / t.snapshot,
                t.copy / t.restore, t.copy / t.compare, t.copy / t.save);
        free(bytes);
        free(copy);
        wfDestroyWorld(&world);
        wfDestroyWorld(&twin);
    }
    return 0;
}
/* <measurements> */
static int save_by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static int measure_rollback_time(FILE *out)
{
    enum { FRAMES = 8, ROUNDS = 31 };
    static const struct { const char *name; int steps; bool spread; } row[] = {
        { "balls that roll", 60, true }, { "pile that falls", 30, false },
        { "pile at rest (awake)", 900, false } };
    fprintf(out, "scene,restore,steps,share\n");
    for (int k = 0; k < 3; k++) {
        wfWorld world;
        double back[ROUNDS], again[ROUNDS];
        if (save_scene(1000, row[k].spread, false, &world) != WF_OK) return 1;
        for (int i = 0; i < row[k].steps; i++) wfStepWorld(&world);
        size_t size = wfSnapshotSize(&world);
        void *bytes = malloc(size);
        if (bytes == NULL || wfSnapshotWorld(&world, bytes, size, &size) != WF_OK) return 1;
        for (int round = 0; round < ROUNDS; round++) {
            clock_t start = clock();
            if (wfRestoreWorld(&world, bytes, size) != WF_OK) return 1;
            back[round] = save_seconds(start);
            for (int i = 0; i < FRAMES; i++)
                if (wfStepWorld(&world) != WF_OK) return 1;
            again[round] = save_seconds(start) - back[round];
        }
        qsort(back, ROUNDS, sizeof *back, save_by_size);
        qsort(again, ROUNDS, sizeof *again, save_by_size);
        double ms = 1e3 * back[ROUNDS / 2], steps = 1e3 * again[ROUNDS / 2];
        fprintf(out, "%s,%.3f,%.2f,%.0f\n", row[k].name, ms, steps, (ms + steps) * 6);
        free(bytes);
        wfDestroyWorld(&world);
    }
    return 0;
}
/* <measurements> */
#ifndef WF_NO_JSON
enum { DRIFT_BODIES = 40 };

static bool drift_add(wfWorld *world, int32_t type, double x, double y, double size,
                      bool round)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = type;
    d.position = wfV2((wfReal)x, (wfReal)y);
    wfResult made = round ? wfMakeCircle(wfV2(0, 0), (wfReal)size, &d.shape)
        : wfMakeBox((wfReal)size, type == WF_STATIC ? 1 : (wfReal)size, &d.shape);
    return made == WF_OK && wfAddBodyToWorld(world, &d, NULL) == WF_OK;
}

static bool drift_hang(wfWorld *world, int32_t i)
{
    wfJoint j;
    wfBodyId a = wfBodyAt(world, i), b = wfBodyAt(world, i + 1);
    wfVec2 at = wfV2((wfReal)i, 10);
    return wfJoinBodies(world, "revolute", a, b, at, at, wfV2(1, 0), &j) == WF_OK
        && wfAddJointToWorld(world, &j, NULL) == WF_OK;
}
/* <measurements> */
static bool drift_build(int kind, wfWorld *world)
{
    wfWorldDef def = wfDefaultWorldDef();
    if (wfCreateWorld(&def, world) != WF_OK) return false;
    bool good = true;
    if (kind == 0) good = drift_add(world, WF_STATIC, 0, 10, 0.1, true);
    else good = drift_add(world, WF_STATIC, 0, -1, 20, false);
    for (int i = 0; kind == 0 && i < 8 && good; i++)
        good = drift_add(world, WF_DYNAMIC, i + 1, 10, 0.2, true) && drift_hang(world, i);
    for (int i = 0; kind == 1 && i < 8 && good; i++)
        good = drift_add(world, WF_DYNAMIC, 0, 0.5 + i, 0.5, false);
    for (int i = 0; kind > 1 && i < DRIFT_BODIES && good; i++)
        good = drift_add(world, WF_DYNAMIC, 1.05 * (i % 5) + 0.1 * (i / 5),
                         (kind == 2 ? 0.5 : 4) + 1.1 * (i / 5), 0.5, kind == 2);
    for (int i = 0; i < 120 && good; i++) good = wfStepWorld(world) == WF_OK;
    return good;
}

static double drift_between(const wfWorld *one, const wfWorld *two)
{
    wfBodyView a = wfWorldBodies(one), b = wfWorldBodies(two);
    double most = 0;
    for (int32_t i = 0; i < a.count; i++) {
        double d = (double)wfLength(wfSub(a.state[i].p, b.state[i].p));
        if (d > most) most = d;
    }
    return most;
}
/* <measurements> */
static bool drift_row(FILE *out, const char *name, int kind)
{
    static const int after[] = { 0, 1, 10, 100, 600 };
    wfWorld one, two;
    char *text = NULL;
    int32_t contacts, made = 0;
    bool good = drift_build(kind, &one) && wfWriteScene(&one, NULL, &text) == WF_OK
             && wfReadScene(text, strlen(text), NULL, &two, NULL, NULL) == WF_OK;
    if (!good) return false;
    wfWorldContacts(&one, &contacts);
    fprintf(out, "%s,%d,%.1f", name, (int)contacts, (double)strlen(text) / 1000);
    for (size_t i = 0; i < sizeof after / sizeof *after; i++) {
        for (; made < after[i] && good; made++)
            good = wfStepWorld(&one) == WF_OK && wfStepWorld(&two) == WF_OK;
        fprintf(out, ",%.2g", 1000 * drift_between(&one, &two));
    }
    fprintf(out, "\n");
    wfFreeText(text);
    wfDestroyWorld(&one);
    wfDestroyWorld(&two);
    return good;
}
#endif
/* <measurements> */
static int measure_text_drift(FILE *out)
{
#ifdef WF_NO_JSON
    (void)out;
    return 1;
#else
    fprintf(out, "world,contacts,text (KB),0 steps (mm),1 step,10 steps,100 steps,"
                 "600 steps\n");
    return !(drift_row(out, "a chain swings", 0)
          && drift_row(out, "a tower stands", 1)
          && drift_row(out, "forty discs roll apart", 2)
          && drift_row(out, "forty boxes tumble", 3));
#endif
}
/* <measurements> */
/* The length of frame k on machine 0 (fast), 1 (plain), 2 (busy), in seconds. */
static double platform_frame(int machine, wfRandom *random, double time)
{
    double jitter = (double)wfRandomReal(random, -1, 1);
    if (machine == 0)
        return (1 + 0.1 * jitter) / 144;
    double frame = (1 + 0.3 * jitter) / 60;
    double next = (double)(int)(time + 0.5) + 0.5;      /* the busy machine's next hiccup */
    return machine == 2 && time < next && time + frame >= next ? 0.15 : frame;
}

static void platform_spring(void *context, const wfBodyState *state, int count, wfReal time,
                            wfBodyForces *out)
{
    (void)context, (void)time;
    for (int i = 0; i < count; i++)             /* omega = 20 rad/s for a mass of 1 kg */
        wfApplyForceToCentre(&out[i], wfScale(-400, state[i].p));
}
/* <measurements> */
static wfResult platform_step(wfBodyState *body, double h)
{
    uint8_t bytes[1024];
    wfPool scratch;
    wfPoolInit(&scratch, sizeof bytes, bytes);
    wfIntegration in = { .state = body, .count = 1, .h = (wfReal)h,
                         .forces = platform_spring, .scratch = &scratch };
    return wfIntegratorTable[wfFindIntegrator("symplectic-euler")].step(&in);
}
/* <measurements> */
static int measure_platform_variable_step(FILE *out)
{
    fprintf(out, "machine,time,from_the_clock,fixed\n");
    for (int machine = 0; machine < 3; machine++) {
        wfRandom random;
        wfRandomSeed(&random, 27);
        wfBodyState loose = { .p = { { 1, 0 } }, .invMass = 1 }, fixed = loose;
        step_clock clock = { 0 };
        double time = 0;
        while (time < 4) {
            double frame = platform_frame(machine, &random, time);
            time += frame;
            platform_step(&loose, frame);
            int n = step_clock_advance(&clock, frame, 1.0 / 120, 1000);
            while (n-- > 0)
                platform_step(&fixed, 1.0 / 120);
            fprintf(out, "%d,%.5f,%.5f,%.5f\n", machine, time, (double)loose.p.x,
                    (double)fixed.p.x);
        }
    }
    return 0;
}
/* <measurements> */
/* The ink of shape k, moved by (x, y), in a picture of 32 x 32 pixels. */
static double drawing_ink(int k, float size, float x, float y, bool jagged)
{
    static wfCoverRow row;
    double sum = 0;
    const float from[2] = { 6 + x, 9 + y }, to[2] = { 22 + x, 17 + y };
    const float s = size / 10;
    const float triangle[6] = { 6 + x, -(6 + y), 6 + x + 18 * s, -(9 + y),
                                6 + x + 7 * s, -(6 + y + 17 * s) };
    wfCoverBegin(&row, 0, 0, 32);
    for (row.y = 0; row.y < 32; row.y++) {
        if (k == 0) wfCoverLine(&row, from, to, 0.5f * size);
        if (k == 1) wfCoverDisc(&row, 14 + x, 14 + y, size);
        if (k == 2) wfCoverRing(&row, 14 + x, 14 + y, 10, 0.5f * size);
        if (k == 3) wfCoverPolygon(&row, (wfPixelMap){ 1, 0, 0 }, triangle, 3);
        for (int32_t i = row.low; i < row.high; i++)
            sum += jagged ? (row.at[i] >= 0.5f) : (double)row.at[i];
        wfCoverClear(&row);
    }
    return sum;
}
/* <measurements> */
static double drawing_area(int k, double size)
{
    const double pi = 3.14159265358979;
    double s = size / 10, length = 17.88854382;
    switch (k) {
    case 0: return size * length + pi * size * size / 4;
    case 1: return pi * size * size;
    case 2: return 2 * pi * 10 * size;
    default: return 0.5 * (18 * s * 17 * s - 7 * s * 3);
    }
}
/* <measurements> */
static int measure_drawing_coverage(FILE *out)
{
    static const struct { const char *name; int kind; float size; } shape[] = {
        { "line", 0, 1 }, { "line", 0, 2 }, { "disc", 1, 1 }, { "disc", 1, 5 },
        { "ring", 2, 1 }, { "ring", 2, 2 }, { "triangle", 3, 5 }, { "triangle", 3, 10 },
    };
    fprintf(out, "shape,size,area,mean,off,jagged\n");
    for (size_t n = 0; n < sizeof shape / sizeof *shape; n++) {
        double area = drawing_area(shape[n].kind, (double)shape[n].size);
        double mean = 0, off = 0, jagged = 0;
        for (int place = 0; place < 256; place++) {
            float x = (float)(place % 16) / 16, y = (float)(place / 16) / 16;
            double smooth = drawing_ink(shape[n].kind, shape[n].size, x, y, false);
            double rough = drawing_ink(shape[n].kind, shape[n].size, x, y, true);
            mean += smooth / 256;
            /* <keep the largest distance from the area> */
            double a = smooth > area ? smooth - area : area - smooth;
            double b = rough > area ? rough - area : area - rough;
            off = a > off ? a : off;
            jagged = b > jagged ? b : jagged;
        }
        fprintf(out, "%s,%g,%.2f,%.2f,%.2f,%.2f\n", shape[n].name, (double)shape[n].size,
                area, mean, off, jagged);
    }
    return 0;
}
/* <measurements> */
static double drawing_seconds(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* n boxes and n circles of a given half size (px) in even rows. */
static void drawing_bodies(wfDraw *d, int n, float half)
{
    wfDrawReset(d);
    wfDrawView(d, 0, 0, 1280, 720);
    for (int i = 0; i < n; i++) {
        float x = 10 + (float)(i % 40) * 31.3f, y = 10 + (float)(i / 40) * 13.7f, h = half;
        float box[8] = { x - h, y - 0.8f * h, x + 0.9f * h, y - h,
                         x + h, y + 0.8f * h, x - 0.9f * h, y + h };
        wfDrawPolygon(d, box, 4, 1.5f, WF_INK_BODY, WF_INK_BODY);
        wfDrawCircle(d, x + 15.3f, y, h, 1.5f, WF_INK_BODY2, WF_INK_BODY2);
    }
}
/* <measurements> */
static int measure_drawing_time(FILE *out)
{
    enum { WIDE = 1280, HIGH = 720, FRAMES = 20 };
    _Alignas(8) static unsigned char memory[1 << 20];
    static uint32_t pixels[WIDE * HIGH];
    frame_buffer picture = { pixels, WIDE, HIGH, WIDE, 1 };
    wfDraw d;
    wfDrawInit(&d, memory, sizeof memory);
    fprintf(out, "bodies,half,ms\n");
    for (int n = 0; n <= 2000; n = n == 0 ? 500 : 2 * n)
        for (int half = 4; half <= 8; half += 4) {
            double least = 1;
            drawing_bodies(&d, n / 2, (float)half);
            for (int frame = 0; frame < FRAMES; frame++) {
                double start = drawing_seconds();
                wfClearFrame(&picture, wfLightPalette.mark[WF_INK_PAPER]);
                wfRenderList(&d, NULL, &wfLightPalette, &picture);
                double seconds = drawing_seconds() - start;
                if (seconds < least) least = seconds;
            }
            fprintf(out, "%d,%d,%.3f\n", n, half, 1000 * least);
        }
    return d.overflow + d.refused;
}
/* <measurements> */
/* What takes the exact solver half a minute and more. */
static bool is_dear(const wfClassic *c)
{
    static const char *const name[4] = { "cards", "bounce", "fine-bounce", "coincident" };
    for (int i = 0; i < 4; i++)
        if (strcmp(c->name, name[i]) == 0) return true;
    return false;
}

static int measure_figures_arch(FILE *out)
{
    wfWorldDef how = wfDefaultWorldDef();
    static const int32_t passes[3] = { 1, 8, 30 };
    how.columns = 1;
    fprintf(out, "substeps,1 pass,8 passes,30 passes\n");
    for (how.substeps = 4; how.substeps <= 16; how.substeps *= 2) {
        fprintf(out, "%d", (int)how.substeps);
        for (int i = 0; i < 3; i++) {
            how.iterations = passes[i];
            fprintf(out, ",%.4f", wfRunClassic("arch", &how));
        }
        fprintf(out, "\n");
    }
    return 0;
}

static int measure_figures_classics(FILE *out)
{
    wfWorldDef how = wfDefaultWorldDef(), exact = how;
    exact.solver = wfFindSolver("exact");
    fprintf(out, "scene,aim,default,exact\n");
    for (int i = 0; i < wfClassicCount; i++) {
        const wfClassic *c = &wfClassicTable[i];
        fprintf(out, "%s,%s,%.4g,", c->what, c->aim, c->run(&how));
        if (exact.solver < 0 || is_dear(c)) fprintf(out, "-\n");
        else fprintf(out, "%.4g\n", c->run(&exact));
    }
    return 0;
}
/* <measurements> */
enum { PERF_BEFORE = 300, PERF_RUNS = 201, PERF_STAGES = 64 };

typedef struct PerfTimes {
    double step;                    /* ms: the median */
    double stage[PERF_STAGES];      /* ms: means */
    int32_t contacts;
} PerfTimes;

/* one step as wfStepWorld makes it, with a clock between the stages */
static wfResult timed_step(wfWorld *world, double *stage)
{
    struct wfStep step = { .hooks = NULL };
    wfResult result = wfChangeBlock(world, &step.b);
    clock_t at = clock();
    for (int i = 0; i < wfStageCount && result == WF_OK; i++) {
        result = wfStageTable[i].run(&step);
        clock_t now = clock();
        stage[i] += 1e3 * (double)(now - at) / CLOCKS_PER_SEC;
        at = now;
    }
    return result;
}

static int compare_doubles(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
/* <measurements> */
static wfResult time_load(const labLoad *load, int32_t passes, int32_t lanes,
                          PerfTimes *out)
{
    static double times[PERF_RUNS];
    wfWorldDef def = labLoadDef(load);
    wfWorld world;
    def.iterations = passes;                    /* 0: as many as the solver likes */
    def.lanes = lanes;
    *out = (PerfTimes){ .step = 0 };
    wfResult result = wfCreateWorld(&def, &world);
    if (result != WF_OK) return result;
    result = load->build(&world);
    for (int i = -PERF_BEFORE; i < PERF_RUNS && result == WF_OK; i++) {
        double none[PERF_STAGES] = { 0 }, *stage = i < 0 ? none : out->stage;
        clock_t start = clock();
        result = timed_step(&world, stage);
        if (i >= 0) times[i] = 1e3 * (double)(clock() - start) / CLOCKS_PER_SEC;
    }
    wfWorldContacts(&world, &out->contacts);
    wfDestroyWorld(&world);
    qsort(times, PERF_RUNS, sizeof *times, compare_doubles);
    out->step = times[PERF_RUNS / 2];
    for (int i = 0; i < PERF_STAGES; i++) out->stage[i] /= PERF_RUNS;
    return result;
}
/* <measurements> */
static int measure_performance_stages(FILE *out)
{
    PerfTimes t[LAB_LOADS];
    for (int i = 0; i < LAB_LOADS; i++)
        if (time_load(&labLoads[i], 0, 1, &t[i]) != WF_OK) return 1;
    fprintf(out, "stage,pile,pyramid,grid\n");
    for (int k = 0; k < wfStageCount && k < PERF_STAGES; k++) {
        double most = 0;
        for (int i = 0; i < LAB_LOADS; i++)
            if (t[i].stage[k] > most) most = t[i].stage[k];
        if (most < 0.005) continue;
        fprintf(out, "%s,%.2f,%.2f,%.2f\n", wfStageTable[k].name, t[0].stage[k],
                t[1].stage[k], t[2].stage[k]);
    }
    fprintf(out, "median of the step,%.2f,%.2f,%.2f\n", t[0].step, t[1].step, t[2].step);
    fprintf(out, "contacts,%d,%d,%d\n", (int)t[0].contacts, (int)t[1].contacts,
            (int)t[2].contacts);
    return 0;
}
/* <measurements> */
static int measure_performance_passes(FILE *out)
{
    fprintf(out, "passes,pile,pyramid,grid\n");
    for (int32_t passes = 1; passes <= 8; passes *= passes == 2 ? 4 : 2) {
        PerfTimes t[LAB_LOADS];
        for (int i = 0; i < LAB_LOADS; i++)
            if (time_load(&labLoads[i], passes, 1, &t[i]) != WF_OK) return 1;
        fprintf(out, "%d,%.2f,%.2f,%.2f\n", (int)passes, t[0].step, t[1].step, t[2].step);
    }
    return 0;
}
/* <measurements> */
static int measure_performance_lanes(FILE *out)
{
    int velocities = 0;
    while (strcmp(wfStageTable[velocities].name, "velocities") != 0) velocities++;
    fprintf(out, "lanes,what,pile,pyramid,grid\n");
    for (int32_t lanes = 0; lanes < 2; lanes++) {
        const char *how = lanes ? "several at once" : "one by one";
        PerfTimes t[LAB_LOADS];
        for (int i = 0; i < LAB_LOADS; i++)
            if (time_load(&labLoads[i], 0, lanes, &t[i]) != WF_OK) return 1;
        fprintf(out, "%s,velocities,%.2f,%.2f,%.2f\n", how, t[0].stage[velocities],
                t[1].stage[velocities], t[2].stage[velocities]);
        fprintf(out, "%s,step,%.2f,%.2f,%.2f\n", how, t[0].step, t[1].step, t[2].step);
    }
    return 0;
}
/* <measurements> */
/* how many colours the contacts of a world take, 0 if that cannot be said */
static int32_t colours_of(const wfWorld *world)
{
    static _Alignas(WF_POOL_ALIGN) uint8_t memory[1 << 20];
    static int32_t order[1 << 14];
    int32_t count = 0, found = 0;
    wfPool pool;
    wfBodyView bodies = wfWorldBodies(world);
    const wfContact *contacts = wfWorldContacts(world, &count);
    wfSolve in = { .state = (wfBodyState *)bodies.state, .bodyCount = bodies.count,
                   .contacts = (wfContact *)contacts, .contactCount = count,
                   .scratch = &pool };
    if (count > 1 << 14 || wfPoolInit(&pool, sizeof memory, memory) != WF_OK) return 0;
    wfColouring c = { .order = order };
    wfPair *ends = wfPoolPushArray(&pool, count, wfPair);
    for (int32_t i = 0; ends != NULL && i < count; i++)
        ends[i] = (wfPair){ contacts[i].a, contacts[i].b };
    if (ends == NULL || wfColour(in.state, in.bodyCount, ends, count, &pool, &c) != WF_OK)
        return 0;
    for (int32_t k = 0; k <= WF_COLOURS; k++) found += c.first[k + 1] > c.first[k];
    return found;
}
/* <measurements> */
static int one_colouring(FILE *out, int32_t colours, int32_t passes)
{
    wfWorldDef def = labLoadDef(&labLoads[1]);
    wfWorld world;
    enum { BASE = 30 };
    double fastest = 0;
    def.colours = colours;
    def.iterations = passes;
    def.bodyCapacity = BASE * (BASE + 1) / 2 + 1;
    if (wfCreateWorld(&def, &world) != WF_OK) return 1;
    wfResult result = labPyramid(&world, BASE);
    for (int i = 0; i < 600 && result == WF_OK; i++) result = wfStepWorld(&world);
    wfBodyView v = wfWorldBodies(&world);
    for (int32_t i = 1; i < v.count; i++) {
        double speed = (double)wfLength(v.state[i].v);
        if (speed > fastest) fastest = speed;
    }
    double sunk = BASE - 0.5 - (double)v.state[v.count - 1].p.y;
    fprintf(out, "%s,%d,%d,%.1f,%.2f\n", colours ? "by colours" : "of the list",
            (int)passes, (int)colours_of(&world), 1e3 * sunk, 1e3 * fastest);
    wfDestroyWorld(&world);
    return result != WF_OK;
}

static int measure_performance_colours(FILE *out)
{
    fprintf(out, "order,passes,colours,top,fastest\n");
    for (int32_t passes = 1; passes <= 4; passes *= 2)
        for (int32_t colours = 0; colours < 2; colours++)
            if (one_colouring(out, colours, passes) != 0) return 1;
    return 0;
}
/* <measurements> */
typedef struct PriceRow {
    const char *what;
    void (*off)(wfWorldDef *def);
} PriceRow;

static void price_nothing(wfWorldDef *def) { (void)def; }
static void price_exact(wfWorldDef *def) { def->exactJoints = WF_JOINTS_ONE_BY_ONE; }
static void price_impacts(wfWorldDef *def) { def->impacts = 0; }
static void price_reuse(wfWorldDef *def) { def->reuse = 0; }
static void price_columns(wfWorldDef *def) { def->columns = 0; }
static void price_substeps(wfWorldDef *def) { def->substeps = 1; }

static const PriceRow price_rows[] = {
    { "nothing", price_nothing }, { "exact joints", price_exact },
    { "impacts of fast bodies", price_impacts },
    { "contacts used again", price_reuse }, { "columns", price_columns },
    { "all substeps but one", price_substeps },
};
enum { PRICE_ROWS = sizeof price_rows / sizeof *price_rows };

/* Row `i` of the list: settings, and behind them the needs one by one. Switches off in
 * *def what the row says, and whatever cannot be without it. */
static const char *price_off(int i, wfWorldDef *def)
{
    if (i < PRICE_ROWS) price_rows[i].off(def);
    if (i < PRICE_ROWS) return price_rows[i].what;
    const wfNeedRow *need = &wfNeedTable[i - PRICE_ROWS];
    for (int k = 0; k < wfNeedCount; k++)
        if (wfCloseNeeds(wfNeedTable[k].bit) & need->bit) def->needs &= ~wfNeedTable[k].bit;
    return need->name;
}
/* <measurements> */
static bool price_size(int row, int32_t bodies, double size[2])
{
    wfWorldDef def = wfDefaultWorldDef();
    size_t permanent, transient;
    def.bodyCapacity = bodies;
    def.forceCapacity = def.jointCapacity = bodies;
    price_off(row, &def);
    if (!(def.needs & WF_NEED_FORCES)) def.forceCapacity = 0;
    if (!(def.needs & WF_NEED_JOINTS)) def.jointCapacity = 0;
    bool good = wfWorldSize(&def, &permanent, &transient) == WF_OK;
    if (good) size[0] = (double)permanent, size[1] = (double)transient;
    return good;
}

static int measure_price_world(FILE *out)
{
    double all[2] = { 0, 0 };
    fprintf(out, "what,permanent,transient\n");
    for (int i = 0; i < PRICE_ROWS + wfNeedCount; i++) {
        wfWorldDef def = wfDefaultWorldDef();
        double one[2], two[2];
        if (!price_size(i, 1000, one) || !price_size(i, 2000, two)) continue;
        for (int k = 0; k < 2; k++) two[k] = (two[k] - one[k]) / 1000 - all[k];
        fprintf(out, "%s,%.0f,%.0f\n", price_off(i, &def), two[0], two[1]);
        for (int k = 0; k < 2 && i == 0; k++) all[k] = two[k];
    }
    return 0;
}
/* <measurements> */
enum { PRICE_BODIES = 1000, PRICE_SETTLE = 600, PRICE_STEPS = 101 };

static bool price_wall(wfWorld *world, double x, double y, double w, double h)
{
    wfBodyDef d = wfDefaultBodyDefFor(world);
    d.type = WF_STATIC;
    d.position = wfV2((wfReal)x, (wfReal)y);
    if (wfMakeBox((wfReal)w, (wfReal)h, &d.shape) != WF_OK) return false;
    return wfAddBodyToWorld(world, &d, NULL) == WF_OK;
}

static bool price_discs(wfWorld *world, bool heap)
{
    wfWorldDef def;
    bool good = wfGetWorldDef(world, &def) == WF_OK;
    bool shaped = (def.needs & WF_NEED_SHAPES) != 0;
    wfBodyDef d = wfDefaultBodyDefFor(world);
    if (shaped) good = good && wfMakeCircle(wfV2(0, 0), WF_R(0.5), &d.shape) == WF_OK;
    else d.mass = 1, good = good && !heap;
    double apart = heap ? 1.01 : 3;
    for (int i = 0; i < PRICE_BODIES - 3 && good; i++) {
        double x = apart * (i % 25 + (i / 25 % 2) * 0.5), y = 0.5 + apart * (i / 25);
        d.position = wfV2((wfReal)x, (wfReal)y);
        good = wfAddBodyToWorld(world, &d, NULL) == WF_OK;
    }
    if (!heap || !good) return good;
    return price_wall(world, 12, -1, 30, 1) && price_wall(world, -2, 50, 1, 50)
        && price_wall(world, 27, 50, 1, 50);
}
/* <measurements> */
static int price_compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double price_step(int row, bool heap)
{
    static double times[PRICE_STEPS];
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    def.bodyCapacity = PRICE_BODIES;
    price_off(row, &def);
    if (heap && !(def.needs & WF_NEED_CONTACTS)) return -1;
    if (wfCreateWorld(&def, &world) != WF_OK) return -1;
    bool good = price_discs(&world, heap);
    for (int i = heap ? -PRICE_SETTLE : -1; i < PRICE_STEPS && good; i++) {
        clock_t start = clock();
        good = wfStepWorld(&world) == WF_OK;
        if (i >= 0) times[i] = (double)(clock() - start) / CLOCKS_PER_SEC;
    }
    wfDestroyWorld(&world);
    qsort(times, PRICE_STEPS, sizeof *times, price_compare);
    return good ? 1e9 * times[PRICE_STEPS / 2] / PRICE_BODIES : -1;
}

static int measure_price_time(FILE *out)
{
    fprintf(out, "what,rest,fall\n");
    for (int i = 0; i < PRICE_ROWS + wfNeedCount; i++) {
        wfWorldDef def = wfDefaultWorldDef();
        double rest = price_step(i, true), fall = price_step(i, false);
        fprintf(out, "%s,", price_off(i, &def));
        if (rest >= 0) fprintf(out, "%.0f", rest);
        fprintf(out, ",%.0f\n", fall);
    }
    return 0;
}
/* <measurements> */
/* A world with a level floor whose upper side is y = 0. */
static bool price_floor(const wfWorldDef *def, wfReal friction, wfWorld *world)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    d.friction = friction;
    d.position = wfV2(0, -1);
    if (wfMakeBox(50, 1, &d.shape) != WF_OK) return false;
    if (wfCreateWorld(def, world) != WF_OK) return false;
    return wfAddBodyToWorld(world, &d, NULL) == WF_OK;
}

/* Adds a body of that definition, steps, and tells about it. */
static wfBodyInfo price_watch(wfWorld *world, const wfBodyDef *d, int steps)
{
    wfBodyInfo info = { .type = -1 };
    wfBodyId id;
    bool good = wfAddBodyToWorld(world, d, &id) == WF_OK;
    for (int i = 0; i < steps && good; i++) good = wfStepWorld(world) == WF_OK;
    if (good) wfGetBody(world, id, &info);
    wfDestroyWorld(world);
    return info;
}
/* <measurements> */
static double price_slide(bool on)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef d = wfDefaultBodyDef();
    wfReal mu = on ? WF_R(0.5) : 0;
    d.friction = mu;
    d.position = wfV2(-20, WF_R(0.1));
    d.velocity = wfV2(5, 0);
    if (wfMakeBox(1, WF_R(0.1), &d.shape) != WF_OK) return -1;
    if (!price_floor(&def, mu, &world)) return -1;
    double way = (double)price_watch(&world, &d, 180).position.x + 20;
    return fabs(way * 2 * 0.5 * 9.81 / 25 - 1);
}
/* <measurements> */
static double price_bounce(bool on)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef d = wfDefaultBodyDef();
    wfBodyInfo info;
    wfBodyId id;
    double high = 0;
    d.restitution = on ? WF_R(0.8) : 0;
    d.position = wfV2(0, WF_R(5.5));
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.5), &d.shape) != WF_OK) return -1;
    if (!price_floor(&def, WF_R(0.5), &world)) return -1;
    if (wfAddBodyToWorld(&world, &d, &id) != WF_OK) return -1;
    for (int i = 0; i < 180; i++) {
        if (wfStepWorld(&world) != WF_OK) return -1;
        if (wfGetBody(&world, id, &info) != WF_OK) return -1;
        if (i > 75 && (double)info.position.y > high) high = (double)info.position.y;
    }
    wfDestroyWorld(&world);
    return fabs((high - 0.5) / (0.64 * 5) - 1);
}
/* <measurements> */
static double price_roll(bool on)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef d = wfDefaultBodyDef();
    double slope = 0.17364817766693, t = 2;
    def.gravity = wfV2((wfReal)(9.81 * slope), WF_R(-9.661));
    d.fixedRotation = !on;
    d.friction = on ? WF_R(0.5) : 0;
    d.position = wfV2(0, WF_R(0.5));
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.5), &d.shape) != WF_OK) return -1;
    if (!price_floor(&def, d.friction, &world)) return -1;
    double way = (double)price_watch(&world, &d, (int)(60 * t)).position.x;
    return fabs(way / (9.81 * slope * 2 / 3 * t * t / 2) - 1);
}
/* <measurements> */
static double price_shoot(bool on)
{
    int through = 0;
    for (int k = 0; k < 20; k++) {
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld world;
        wfBodyDef sheet = wfDefaultBodyDef(), d = wfDefaultBodyDef();
        def.gravity = wfV2(0, 0);
        def.solver = wfFindSolver("sequential");
        def.impacts = on ? 16 : 0;
        sheet.type = WF_STATIC;
        sheet.position = wfV2(10, 0);
        d.velocity = wfV2((wfReal)(300 + 50 * k), 0);
        if (wfMakeBox(WF_R(0.01), 1, &sheet.shape) != WF_OK) return -1;
        if (wfMakeCircle(wfV2(0, 0), WF_R(0.025), &d.shape) != WF_OK) return -1;
        if (wfCreateWorld(&def, &world) != WF_OK) return -1;
        if (wfAddBodyToWorld(&world, &sheet, NULL) != WF_OK) return -1;
        through += price_watch(&world, &d, 12).position.x > 10;
    }
    return through / 20.0;
}
/* <measurements> */
enum { PRICE_LINKS = 20 };

static double price_chain(int substeps, int together)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef d = wfDefaultBodyDef();
    wfBodyId id[PRICE_LINKS + 1];
    wfBodyInfo info;
    wfJoint joint;
    double worst = 0;
    def.substeps = substeps;
    def.exactJoints = together;
    bool good = wfMakeCircle(wfV2(0, 0), WF_R(0.1), &d.shape) == WF_OK
             && wfCreateWorld(&def, &world) == WF_OK;
    for (int i = 0; i <= PRICE_LINKS && good; i++) {
        wfVec2 at = wfV2((wfReal)(i - 1), 0);
        d.type = i == 0 ? WF_STATIC : WF_DYNAMIC;
        d.position = wfV2((wfReal)i, 0);
        good = wfAddBodyToWorld(&world, &d, &id[i]) == WF_OK;
        if (i == 0 || !good) continue;
        good = wfJoinBodies(&world, "distance", id[i - 1], id[i], at, d.position,
                            wfV2(1, 0), &joint) == WF_OK
            && wfAddJointToWorld(&world, &joint, NULL) == WF_OK;
    }
    for (int step = 0; step < 300 && good; step++) {
        wfVec2 from = wfV2(0, 0);
        double length = 0;
        good = wfStepWorld(&world) == WF_OK;
        for (int i = 1; i <= PRICE_LINKS && good; i++) {
            good = wfGetBody(&world, id[i], &info) == WF_OK;
            length += (double)wfDistance(from, info.position);
            from = info.position;
        }
        worst = fmax(worst, fabs(length - PRICE_LINKS));
    }
    wfDestroyWorld(&world);
    return good ? 1e3 * worst : -1;
}

static double price_substeps_of(bool on)
{
    return price_chain(on ? 4 : 1, WF_JOINTS_ONE_BY_ONE);
}

static double price_together(bool on)
{
    return price_chain(4, on ? WF_JOINTS_TOGETHER : WF_JOINTS_ONE_BY_ONE);
}
/* <measurements> */
static int measure_price_buys(FILE *out)
{
    static const struct { const char *need, *what; double (*error)(bool on); } rows[] = {
        { "friction", "way that a box slides", price_slide },
        { "restitution", "height of a bounce", price_bounce },
        { "rotation", "way of a disc on a slope", price_roll },
        { "fast", "bullets that get through a sheet", price_shoot },
        { "four substeps", "how much longer a chain gets (mm)", price_substeps_of },
        { "exact joints", "the same", price_together },
    };
    fprintf(out, "need,what,without,with\n");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        fprintf(out, "%s,%s,%.3g,%.3g\n", rows[i].need, rows[i].what, rows[i].error(false),
                rows[i].error(true));
    return 0;
}

const wfMeasureRow wfMeasureTable[] = {
    /* <rows of the measurement table> */
    { "design-list", "bytes that one drawing command takes, by kind", measure_design_list },
    /* <rows of the measurement table> */
    { "memory-holes", "a first-fit heap of 600 cells: free cells and longest hole",
      measure_memory_holes },
    /* <rows of the measurement table> */
    { "memory-time", "malloc and free against a pool, ns per request", measure_memory_time },
    /* <rows of the measurement table> */
    { "numbers-gap", "the gap between floats far from the origin", measure_numbers_gap },
    /* <rows of the measurement table> */
    { "numbers-sine", "largest error of the sine by size of the angle", measure_numbers_sine },
    /* <rows of the measurement table> */
    { "numbers-drift", "length of a rotation after many products", measure_numbers_drift },
    /* <rows of the measurement table> */
    { "numbers-time", "time per call of the elementary functions", measure_numbers_time },
    /* <rows of the measurement table> */
    { "shapes-flat", "corners found in a polygon of 12, by size and kind of tolerance",
      measure_shapes_flat },
    /* <rows of the measurement table> */
    { "shapes-far", "relative errors of area and inertia, by distance from the origin",
      measure_shapes_far },
    /* <rows of the measurement table> */
    { "shapes-capsule", "area and inertia of polygons in the place of a capsule",
      measure_shapes_capsule },
    /* <rows of the measurement table> */
    { "bodies-sizes", "bytes that one body takes, by structure", measure_bodies_sizes },
    /* <rows of the measurement table> */
    { "bodies-damping", "speed after 2 s of damping at 3/s, by method and step",
      measure_bodies_damping },
    /* <rows of the measurement table> */
    { "forces-sliver", "a ball that dips into the water: area as written and as computed",
      measure_forces_sliver },
    { "forces-float", "a box dropped into water by three rules of buoyancy",
      measure_forces_float },
    /* <rows of the measurement table> */
    { "integrators-order", "error against step and evaluations, by problem and method",
      measure_integrators_order },
    { "integrators-slopes", "the order of each method, measured on three problems",
      measure_integrators_slopes },
    { "integrators-energy", "largest error of the energy in a turn of an orbit",
      measure_integrators_energy },
    { "integrators-midpoint", "what the implicit midpoint method needs and keeps on a spring",
      measure_integrators_midpoint },
    /* <rows of the measurement table> */
    { "broad-pairs", "box tests that each broad phase takes, by number of boxes",
      measure_broad_pairs },
    /* <rows of the measurement table> */
    { "broad-time", "time for each box in box tests of brute force, and growth exponents",
      measure_broad_time },
    /* <rows of the measurement table> */
    { "broad-free-time", "ms for a step of 10,000 free circles: moving, boxes, broad phase",
      measure_broad_free },
    /* <rows of the measurement table> */
    { "broad-fat", "changes of the dynamic tree and box tests, by the width of the margin",
      measure_broad_fat },
    /* <rows of the measurement table> */
    { "narrow-far", "change of a computed depth far from the origin", measure_narrow_far },
    /* <rows of the measurement table> */
    { "narrow-coats", "capsules, segments and rounded boxes in hard poses",
      measure_narrow_coats },
    /* <rows of the measurement table> */
    { "narrow-gjk", "steps and dot products of GJK and EPA", measure_narrow_gjk },
    { "narrow-flips", "changes of normal and owner under noise", measure_narrow_flips },
    { "narrow-hard", "hard cases for narrow phases", measure_narrow_hard },
    /* <rows of the measurement table> */
    { "contacts-tilt", "contact points under a tilted box, by angles and by clipping",
      measure_contacts_tilt },
    /* <rows of the measurement table> */
    { "contacts-report", "the report's contact points for two boxes, judged",
      measure_contacts_report },
    /* <rows of the measurement table> */
    { "contacts-tiles", "greatest vertical speed of bodies that slide over 1000 tiles",
      measure_contacts_tiles },
    /* <rows of the measurement table> */
    { "contacts-reuse", "manifolds used again while pairs wander, and the error",
      measure_contacts_reuse },
    { "contacts-reuse-time", "time of a manifold, fresh and used again",
      measure_contacts_reuse_time },
    /* <rows of the measurement table> */
    { "impulses-rest", "height (mm) of a box put at rest on a floor, e = 0.8, 60 Hz",
      measure_impulses_rest },
    { "impulses-spin", "spin (rad/s) of a box that lands flat, by passes and solver",
      measure_impulses_spin },
    { "impulses-energy", "share of the approach energy left after a bounce, by restitution",
      measure_impulses_energy },
    { "impulses-stack", "overlap and speed of boxes stacked for ten seconds, by passes",
      measure_impulses_stack },
    /* <rows of the measurement table> */
    { "friction-roll", "speed (m/s) and rim speed of a disc that slides and begins to roll",
      measure_friction_roll },
    { "friction-violin", "a block on a belt, held by a spring: where it is, by time",
      measure_friction_violin },
    { "friction-stop", "how far a box slides from 10 m/s, by steps per second",
      measure_friction_stop },
    { "friction-creep", "how far a box creeps down a slope in ten seconds, by steepness",
      measure_friction_creep },
    /* <rows of the measurement table> */
    { "sequential-stack", "ten boxes on each other for 20 s, by solver",
      measure_sequential_stack },
    { "sequential-convergence", "error of the impulses under ten boxes, by passes",
      measure_sequential_convergence },
    { "sequential-pop", "how high a box leaps that is found in the floor",
      measure_sequential_pop },
    { "sequential-creep", "how far a box creeps down a slope in ten seconds, two solvers",
      measure_sequential_creep },
    /* <rows of the measurement table> */
    { "soft-compare", "sliding, rolling, creeping and bouncing, by solver",
      measure_soft_compare },
    { "soft-squash", "how far twenty boxes sink, by substeps", measure_soft_squash },
    { "soft-bounce", "energy of a bouncing ball, e = 1, by solver", measure_soft_bounce },
    { "soft-bounces", "energy after 10,000 bounces, by height", measure_soft_bounces },
    { "soft-tower", "the tallest tower that passes hold, by substeps", measure_soft_tower },
    { "soft-columns", "towers solved at once", measure_soft_columns },
    { "soft-passes", "a pyramid by passes, period and damping", measure_soft_passes },
    { "soft-heavy", "heavy on light, by passes and at once", measure_soft_heavy },
    { "soft-spawn", "sixty boxes born in one place", measure_soft_spawn },
    { "soft-target", "what the default solver reaches", measure_soft_target },
    /* <rows of the measurement table> */
    { "joints-peers", "how the joints of other engines are made", measure_joints_peers },
    { "joints-spring", "a chain on the stiffest springs that survive, and on joints",
      measure_joints_spring },
    { "joints-rigid", "a loaded chain aimed rigidly and softly", measure_joints_rigid },
    { "joints-chain", "how far a loaded chain is stretched, by substeps",
      measure_joints_chain },
    { "joints-pendulum", "energy, period and gap of a pendulum, by substeps",
      measure_joints_pendulum },
    /* <rows of the measurement table> */
    { "exact-heap", "systems, failures and energy of a heap, by friction", measure_exact_heap },
    { "exact-course", "error of the impulses in a cold tower, by passes and by systems",
      measure_exact_course },
    { "exact-systems", "systems and passes that cold scenes take", measure_exact_systems },
    { "exact-target", "what the solver of all contacts reaches", measure_exact_target },
    /* <rows of the measurement table> */
    { "exact-gap", "the widest gap in a loaded chain, one by one and all at once",
      measure_exact_gap },
    { "exact-swing", "energy of a swinging chain with a ton at its end, by method",
      measure_exact_swing },
    { "exact-swings", "the same for a minute, by amplitude", measure_exact_swings },
    { "exact-pendulum", "energy and period of a pendulum, solved exactly",
      measure_exact_pendulum },
    { "exact-time", "time of a step of chains, one by one and all at once (clock)",
      measure_exact_time },
    { "exact-cost", "blocks and fill of the matrices of some machines",
      measure_exact_cost },
    /* <rows of the measurement table> */
    { "compound-remove", "errors after a part is put on and taken off by subtraction",
      measure_compound_remove },
    /* <rows of the measurement table> */
    { "compound-pieces", "pieces of random outlines, by corners", measure_compound_pieces },
    /* <rows of the measurement table> */
    { "compound-time", "time to cut an outline, in orientation tests", measure_compound_time },
    /* <rows of the measurement table> */
    { "impact-tunnel", "speeds at which a ball tunnels, and what the time of impact finds",
      measure_impact_tunnel },
    { "impact-spin", "angular speeds at which a rod passes a peg unseen",
      measure_impact_spin },
    { "impact-convergence", "the gap after each step of the advancement, by the bound",
      measure_impact_convergence },
    { "impact-steps", "distances asked for by times of impact", measure_impact_steps },
    { "impact-time", "what a distance, a cast and a time of impact cost", measure_impact_time },
    /* <rows of the measurement table> */
    { "islands-steps", "arrows followed per search of union-find, by the number of bodies",
      measure_islands_steps },
    /* <rows of the measurement table> */
    { "queries-callback", "who is told to touch, by callback and by array",
      measure_queries_callback },
    { "queries-flutter", "begins of a resting contact, by margin", measure_queries_flutter },
    { "queries-school", "a ball hit from far away, by two formulas", measure_queries_school },
    { "queries-work", "shapes looked at per question, by broad phase", measure_queries_work },
    { "queries-time", "time of a question, in percent of a scan's", measure_queries_time },
    /* <rows of the measurement table> */
    { "world-reuse-time", "ms for a step of a heap at rest, manifolds fresh and used again",
      measure_world_reuse },
    /* <rows of the measurement table> */
    { "world-bounce", "relative error of the apex after one bounce, e = 1, by step",
      measure_world_bounce },
    /* <rows of the measurement table> */
    { "world-far", "by how much a scene far away goes wrong, in floats", measure_world_far },
    { "world-far-double", "the same, by a lab compiled with doubles",
      measure_world_far_double },
    { "world-flight", "where a fast probe is, by how the origin moves along",
      measure_world_flight },
    /* <rows of the measurement table> */
    { "world-pays", "bytes a body in a default world for 1000, by what they are for",
      measure_world_pays },
    { "world-needs", "bytes a body and stages of worlds that are made for more and more",
      measure_world_needs },
    { "world-needs-time", "ns a body and step of 1000 drops, by needs",
      measure_world_needs_time },
    { "world-inferred", "kB of worlds before and after their needs were inferred",
      measure_world_inferred },
    { "world-explain", "stages of two worlds: for which needs, and how many bytes",
      measure_world_explain },
    /* <rows of the measurement table> */
    { "world-layout", "where each array lies in a world of three bodies and one force",
      measure_world_layout },
    /* <rows of the measurement table> */
    { "fast-tunnel", "bullets that get through a sheet, by speed", measure_fast_tunnel },
    { "fast-ghost", "how a bullet is deflected by a corner that it passes",
      measure_fast_ghost },
    { "fast-stop", "the way of a ball between two walls, waiting and going on",
      measure_fast_stop },
    { "fast-cost-time", "what a step costs with and without fast bodies", measure_fast_cost },
    /* <rows of the measurement table> */
    { "sleep-time", "ms of a step with all awake, all asleep, and one awake",
      measure_sleep_time },
    { "sleep-share", "when a pile sleeps, and how far it would have gone, by the limit",
      measure_sleep_share },
    /* <rows of the measurement table> */
    { "save-rewind", "bytes for a step of the past: whole, differences, every 60th",
      measure_save_rewind },
    { "snapshot-time", "snapshot, restore, compare and save against memcpy",
      measure_snapshot_time },
    { "rollback-time", "going back by eight frames and simulating them again",
      measure_rollback_time },
    /* <rows of the measurement table> */
    { "text-drift", "a world and what is read from its text, so many steps later",
      measure_text_drift },
    /* <rows of the measurement table> */
    { "platform-variable-step",
      "a spring on three machines, stepped by the clock and by a fixed step",
      measure_platform_variable_step },
    /* <rows of the measurement table> */
    { "drawing-coverage", "ink against area, smooth and jagged", measure_drawing_coverage },
    { "drawing-time", "milliseconds to draw a frame of 1280 x 720", measure_drawing_time },
    /* <rows of the measurement table> */
    { "figures-arch", "thinnest arch that stands, by substeps and passes",
      measure_figures_arch },
    { "figures-classics", "what the classic scenes reach with default settings",
      measure_figures_classics },
    /* <rows of the measurement table> */
    { "performance-stages-time", "ms for each stage of a step in three heavy scenes",
      measure_performance_stages },
    { "performance-passes-time", "ms for a step of three heavy scenes, by passes",
      measure_performance_passes },
    /* <rows of the measurement table> */
    { "performance-lanes-time", "ms for three heavy scenes, contacts one by one and in lanes",
      measure_performance_lanes },
    /* <rows of the measurement table> */
    { "performance-colours", "a pyramid with contacts in the order of the list and by colours",
      measure_performance_colours },
    /* <rows of the measurement table> */
    { "price-world", "bytes a body, and what is saved by each thing switched off",
      measure_price_world },
    { "price-time", "ns a body and step, with each thing switched off", measure_price_time },
    /* <rows of the measurement table> */
    { "price-buys", "errors of experiments whose end is known, with and without a need",
      measure_price_buys },
};
const int wfMeasureCount = (int)(sizeof wfMeasureTable / sizeof *wfMeasureTable);

/* <find a measurement> */
int wfFindMeasurement(const char *name)
{
    for (int i = 0; i < wfMeasureCount; i++)
        if (strcmp(wfMeasureTable[i].name, name) == 0) return i;
    return -1;
}

int wfMeasurementIsTimed(const char *name)
{
    size_t n = strlen(name);
    return n > 5 && strcmp(name + n - 5, "-time") == 0;
}
