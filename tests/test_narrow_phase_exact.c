/* Narrow phases on a lattice, where the truth is known exactly. All corners and radii are small multiples of one half,
   so whether cores meet, how far apart they are (a fraction under a root) and whether coats touch is decided in integers. */
#include "testing.h"
#include "shapes.h"
#include "weft/narrow.h"

typedef long long I;
typedef struct Core { int n; I x[WF_MAX_VERTICES], y[WF_MAX_VERTICES]; } Core;
typedef struct Fraction { I num, den; } Fraction;              /* >= 0, den > 0 */

static Core core_of(const wfShape *s, I dx, I dy)
{
    Core c = { .n = s->count > 0 ? s->count : 1 };
    for (int i = 0; i < c.n; i++) {
        wfVec2 v = s->count > 0 ? s->vertices[i] : s->centre;
        c.x[i] = (I)v.x + dx; c.y[i] = (I)v.y + dy;
    }
    return c;
}

static I turn(I ax, I ay, I bx, I by, I cx, I cy) { return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax); }
static I sign(I a) { return (a > 0) - (a < 0); }

static bool on_segment(I ax, I ay, I bx, I by, I px, I py)
{
    return turn(ax, ay, bx, by, px, py) == 0 && (px - ax) * (px - bx) + (py - ay) * (py - by) <= 0;
}

static bool segments_meet(I ax, I ay, I bx, I by, I cx, I cy, I dx, I dy)
{
    if (on_segment(ax, ay, bx, by, cx, cy) || on_segment(ax, ay, bx, by, dx, dy)) return true;
    if (on_segment(cx, cy, dx, dy, ax, ay) || on_segment(cx, cy, dx, dy, bx, by)) return true;
    return sign(turn(ax, ay, bx, by, cx, cy)) * sign(turn(ax, ay, bx, by, dx, dy)) < 0
        && sign(turn(cx, cy, dx, dy, ax, ay)) * sign(turn(cx, cy, dx, dy, bx, by)) < 0;
}

static bool inside(const Core *c, I px, I py)
{
    for (int i = 0; i < c->n; i++) {
        int k = (i + 1) % c->n;
        if (turn(c->x[i], c->y[i], c->x[k], c->y[k], px, py) < 0) return false;
    }
    return c->n > 2;
}

static bool cores_meet(const Core *a, const Core *b)
{
    if (inside(a, b->x[0], b->y[0]) || inside(b, a->x[0], a->y[0])) return true;
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) {
            int k = (i + 1) % a->n, l = (j + 1) % b->n;
            if (segments_meet(a->x[i], a->y[i], a->x[k], a->y[k], b->x[j], b->y[j], b->x[l], b->y[l])) return true;
        }
    return false;
}

static Fraction smaller(Fraction a, Fraction b) { return a.num * b.den <= b.num * a.den ? a : b; }

/* the square of the distance of p from the segment a b */
static Fraction from_segment(I ax, I ay, I bx, I by, I px, I py)
{
    I ex = bx - ax, ey = by - ay, l = ex * ex + ey * ey, t = (px - ax) * ex + (py - ay) * ey, c = ex * (py - ay) - ey * (px - ax);
    if (t <= 0) return (Fraction){ (px - ax) * (px - ax) + (py - ay) * (py - ay), 1 };
    if (t >= l) return (Fraction){ (px - bx) * (px - bx) + (py - by) * (py - by), 1 };
    return (Fraction){ c * c, l };
}

static Fraction distance_sq(const Core *a, const Core *b)
{
    Fraction least = { 1000000, 1 };
    for (int i = 0; i < a->n; i++)
        for (int j = 0; j < b->n; j++) {
            int k = (i + 1) % a->n, l = (j + 1) % b->n;
            least = smaller(least, from_segment(a->x[i], a->y[i], a->x[k], a->y[k], b->x[j], b->y[j]));
            least = smaller(least, from_segment(b->x[j], b->y[j], b->x[l], b->y[l], a->x[i], a->y[i]));
        }
    return least;
}

/* the square of the depth along the best normal of a's edges, for cores that meet */
static Fraction depth_sq(const Core *a, const Core *b, Fraction best)
{
    for (int i = 0; a->n > 1 && i < a->n; i++) {
        int k = (i + 1) % a->n;
        I nx = a->y[k] - a->y[i], ny = a->x[i] - a->x[k], deepest = 0;
        for (int j = 0; j < b->n; j++) {
            I d = nx * (b->x[j] - a->x[i]) + ny * (b->y[j] - a->y[i]);
            deepest = d < deepest ? d : deepest;
        }
        best = smaller(best, (Fraction){ deepest * deepest, nx * nx + ny * ny });
    }
    return best;
}

static double root(Fraction f) { return sqrt((double)f.num / (double)f.den); }

/* All lengths stay below 32 m. */
#define ROUNDING (32 * ((double)WF_EPSILON + 2.3e-16) * 32)
typedef struct Tally { int apart, touching, coats, cores; } Tally;

static void check(const wfShape *a, const wfShape *b, I dx, I dy, Tally *tally)
{
    Core ca = core_of(a, 0, 0), cb = core_of(b, dx, dy);
    wfTransform xa = wfTransformIdentity(), xb = xa;
    xb.p = wfV2((wfReal)dx, (wfReal)dy);
    double coats = (double)(a->radius + b->radius);
    I twice = (I)(2 * coats);
    bool meet = cores_meet(&ca, &cb);
    Fraction d2 = distance_sq(&ca, &cb), deep = depth_sq(&cb, &ca, depth_sq(&ca, &cb, (Fraction){ 1000000, 1 }));
    if (ca.n + cb.n == 2) deep = (Fraction){ 0, 1 };                    /* two points that coincide */
    assert_true(meet || d2.num > 0);
    double truth = meet ? -root(deep) - coats : root(d2) - coats;
    I state = meet ? (twice > 0 || deep.num > 0 ? -1 : 0) : sign(4 * d2.num - twice * twice * d2.den);
    if (state > 0) tally->apart++; else if (state == 0) tally->touching++; else if (meet) tally->cores++; else tally->coats++;
    double tie = (double)WF_AXIS_TIE * fmin((double)wfShapeMaxExtent(a), (double)wfShapeMaxExtent(b));
    for (int row = 0; row < wfNarrowPhaseCount; row++) {
        wfSeparation s;
        bool sat = row == wfFindNarrowPhase("sat");
        assert_ok(wfSeparate(row, a, xa, b, xb, &s));
        if (state != 0) assert_true((s.distance > 0) == (state > 0));
        if (state > 0 && sat && coats == 0) assert_true((double)s.distance <= truth + ROUNDING);
        else assert_near(s.distance, truth, ROUNDING + (sat && state <= 0 ? tie : 0));
        double far = -1e9, near = 1e9;                                  /* what is said must be true along the normal */
        for (int i = 0; i < ca.n; i++) far = fmax(far, (double)s.normal.x * (double)ca.x[i] + (double)s.normal.y * (double)ca.y[i]);
        for (int j = 0; j < cb.n; j++) near = fmin(near, (double)s.normal.x * (double)cb.x[j] + (double)s.normal.y * (double)cb.y[j]);
        assert_near(near - far - coats, s.distance, 2 * ROUNDING);
    }
    wfDistanceResult r;
    assert_ok(wfShapeDistance(a, xa, b, xb, &r));
    assert_near(r.distance, fmax(truth, 0), ROUNDING);
    if (state > 0) assert_true(r.distance > 0);
}

/* Every pair of segments with ends on a grid of 4 by 4: crossing, touching, collinear, parallel, equal, turned round. Bare, and
   with coats of one half each, which touch where the cores are 1 m apart. */
TEST(every_pair_of_segments)
{
    wfShape bare[240], coat[240];
    int n = 0;
    for (int p = 0; p < 16; p++)
        for (int q = 0; q < 16; q++) {
            if (p == q) continue;
            bare[n] = segment(p % 4, p / 4, q % 4, q / 4);
            coat[n++] = capsule(p % 4, p / 4, q % 4, q / 4, 0.5);
        }
    Tally bares = { 0 }, coats = { 0 };
    for (int i = 0; i < n; i += 2)
        for (int j = 0; j < n; j++) {
            check(&bare[i], &bare[j], 0, 0, &bares);
            check(&coat[i], &coat[j], (i / 2 + j) % 3, 0, &coats);
        }
    assert_true(bares.apart > 9000 && bares.touching > 5000 && bares.cores > 1000);
    assert_true(coats.apart > 1000 && coats.touching > 500 && coats.coats > 500 && coats.cores > 9000);
}

static wfShape lattice_shape(wfRandom *r)
{
    wfShape s;
    do {
        wfVec2 v[6];
        int n = 3 + (int)wfRandomBelow(r, 4), kind = (int)wfRandomBelow(r, 6);
        for (int i = 0; i < 6; i++) v[i] = wfV2((wfReal)wfRandomBelow(r, 7) - 3, (wfReal)wfRandomBelow(r, 7) - 3);
        wfReal coat = (wfReal)(1 + wfRandomBelow(r, 4)) / 2;
        wfResult made = kind == 0 ? wfMakeCircle(v[0], coat, &s) : kind == 1 ? wfMakeCapsule(v[0], v[1], coat, &s)
                      : kind == 2 ? wfMakeSegment(v[0], v[1], &s) : kind == 3 ? wfMakeLink(v[2], v[0], v[1], v[3], &s)
                      : kind == 4 ? wfMakePolygon(v, n, &s) : wfMakeRoundedPolygon(v, n, coat, &s);
        if (made == WF_OK) return s;
    } while (1);
}

TEST(pairs_of_every_kind)
{
    wfRandom r = random_stream(121);
    Tally t = { 0 };
    for (int i = 0; i < 60000; i++) {
        wfShape a = lattice_shape(&r), b = lattice_shape(&r);
        check(&a, &b, (I)wfRandomBelow(&r, 13) - 6, (I)wfRandomBelow(&r, 13) - 6, &t);
    }
    print_message("apart %d, touching %d, coats %d, cores %d\n", t.apart, t.touching, t.coats, t.cores);
    assert_true(t.apart > 10000 && t.touching > 600 && t.coats > 5000 && t.cores > 5000);
}
