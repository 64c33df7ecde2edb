/* Weft: lab/time_of_impact.c, tangled from chapters/methods/17-time-of-impact.lab.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include <time.h>
#include "weft/impact.h"
#include "lab/bench.h"

static bool impact_picture(wfReal wall, wfReal radius, wfReal way, bool turnedBack)
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

static bool impact_always(wfReal wall, wfReal radius, wfReal perStep, bool turnedBack)
{
    for (int phase = 1; phase <= 200; phase++)
        if (!impact_picture(wall, radius, perStep * (wfReal)phase / 200, turnedBack))
            return false;
    return true;
}

static double impact_speed(wfReal wall, wfReal radius, bool turnedBack)
{
    wfReal low = 0, high = 1000;
    for (int i = 0; i < 30; i++) {
        wfReal middle = (low + high) / 2;
        if (impact_always(wall, radius, middle / 60, turnedBack)) low = middle;
        else high = middle;
    }
    return (double)low;
}

static int measure_impact_tunnel(FILE *out)
{
    static const double walls[] = { 0.001, 0.01, 0.1, 1 };
    const wfReal radius = WF_R(0.05);
    fprintf(out, "wall,seen,seen_theory,back,back_theory,gap,steps\n");
    for (int i = 0; i < 4; i++) {
        wfReal wall = (wfReal)walls[i], half = WF_R(1e5) / 120;
        double sum = walls[i] + 0.1;
        /* shoot the ball at 100 km/s */
        wfShape w, ball;
        wfImpact hit;
        wfSweep flight = { .from = wfV2(-half, 0), .to = wfV2(half, 0) };
        if (wfMakeBox(wall / 2, 2, &w) != WF_OK) return 1;
        if (wfMakeCircle(wfV2(0, 0), radius, &ball) != WF_OK) return 1;
        wfSweep still = wfSweepStill(wfV2(0, 0), 0);
        if (wfTimeOfImpact(&w, still, &ball, flight, &hit) != WF_OK) return 1;
        if (hit.kind != WF_IMPACT_TOUCH) return 1;
        fprintf(out, "%g,%.2f,%.2f,%.2f,%.2f,%.2f,%d\n", walls[i],
                impact_speed(wall, radius, false), 60 * sum,
                impact_speed(wall, radius, true), 30 * sum, 1000 * (double)hit.distance,
                (int)hit.steps);
    }
    return 0;
}

static bool impact_spin_seen(const wfShape *rod, const wfShape *peg, wfReal perStep)
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
            if (impact_spin_seen(&rod, &peg, middle / 60)) low = middle;
            else high = middle;
        }
        wfReal x = ((wfReal)pegs[i] + WF_R(0.02)) / WF_R(0.8);
        wfReal theory = 2 * wfAtan2(x, wfSqrt(1 - x * x));      /* arcsin */
        fprintf(out, "%g,%.2f,%.2f\n", pegs[i], (double)low, 60 * (double)theory);
    }
    return 0;
}

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
        /* write the gap after this step of each bound */
        for (int how = 0; how < WF_ADVANCE_KINDS; how++) {
            double gap = k < t[how].count ? (double)t[how].steps[k].distance : 0;
            gap -= (double)hit.touching / 2;
            if (gap > 0) fprintf(out, ",%.6f", gap);
            else fprintf(out, ",");
        }
        fprintf(out, "\n");
    }
    return 0;
}
typedef struct ImpactFlight { wfShape a, b; wfSweep sa, sb; } ImpactFlight;

static wfReal impact_shadow(const ImpactFlight *f, wfVec2 n, wfReal t, long *rounds)
{
    ++*rounds;
    wfReal end = wfProject(&f->a, wfSweepAt(f->sa, t), n).max;
    return wfProject(&f->b, wfSweepAt(f->sb, t), n).min - end;
}

/* distances asked for; 0: it says "apart" */
static int impact_bilateral(const ImpactFlight *f, wfReal near, long *rounds)
{
    wfReal t = 0;
    for (int step = 1; step <= WF_IMPACT_STEPS; step++) {
        wfDistanceResult r;
        wfTransform xa = wfSweepAt(f->sa, t), xb = wfSweepAt(f->sb, t);
        if (wfShapeDistance(&f->a, xa, &f->b, xb, &r) != WF_OK) return 0;
        if (r.distance <= near) return step;
        if (impact_shadow(f, r.normal, 1, rounds) > near / 2) return 0;
        /* close in on the wanted gap from both sides */
        wfReal low = t, high = 1, fl = r.distance - near / 2;
        wfReal fh = impact_shadow(f, r.normal, 1, rounds) - near / 2;
        for (int k = 0; k < 50 && fl > near / 4; k++) {
            wfReal at = k % 2 ? (low + high) / 2 : low + (high - low) * fl / (fl - fh);
            wfReal value = impact_shadow(f, r.normal, at, rounds) - near / 2;
            if (value > 0) low = at, fl = value;
            else high = at, fh = value;
        }
        t = low;
    }
    return WF_IMPACT_STEPS;
}

static wfResult impact_body(int kind, wfShape *out)
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

/* two draws in one call would have no fixed order */
static wfVec2 impact_place(wfRandom *r)
{
    wfReal x = wfRandomReal(r, -3, 3);
    return wfV2(x, wfRandomReal(r, -3, 3));
}

static wfSweep impact_sweep(wfRandom *r, wfReal turn)
{
    wfSweep s;
    s.from = impact_place(r);
    s.to = impact_place(r);
    s.angleFrom = wfRandomReal(r, -WF_PI, WF_PI);
    s.angleTo = s.angleFrom + turn * (wfReal)(wfRandomU32(r) & 1 ? 1 : -1);
    return s;
}
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
    int steps = impact_bilateral(f, best->touching, &rounds);
    if (steps == 0) { c->missed++; return 0; }
    c->found++;
    c->both += steps;
    c->rounds += rounds;
    return 0;
}

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
        if (impact_body(row / 4, &f.a) != WF_OK || impact_body(row / 4, &f.b) != WF_OK)
            return 1;
        for (int i = 0; i < 4000; i++) {
            f.sa = impact_sweep(&r, (wfReal)turns[row % 4]);
            f.sb = impact_sweep(&r, (wfReal)turns[row % 4]);
            if (impactCount(&f, &c) != 0) return 1;
        }
        /* write a row of the counts */
        double n = (double)c.touching, m = (double)c.found;
        fprintf(out, "%s,%g,%ld", names[row / 4], turns[row % 4], c.touching);
        for (int how = 0; how < WF_ADVANCE_KINDS; how++)
            fprintf(out, ",%.2f", (double)c.steps[how] / n);
        fprintf(out, ",%d,%ld,%.2f,%.2f,%ld\n", c.most, c.open, (double)c.both / m,
                (double)c.rounds / m, c.missed);
    }
    return 0;
}
enum { IMPACT_FLIGHTS = 1000 };

/* what: 0 the distance, 1 a cast, 2 a time of impact; s in all */
static double impact_clock(const ImpactFlight *f, int what)
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
                if (impact_body(row, &f[i].a) != WF_OK) return 1;
                f[i].b = f[i].a;
                f[i].sa = impact_sweep(&r, what == 3 ? WF_R(0.5) : 0);
                f[i].sb = impact_sweep(&r, what == 3 ? WF_R(0.5) : 0);
            }
            took[what] = impact_clock(f, what == 3 ? 2 : what);
        }
        fprintf(out, "%s,%.0f,%.0f,%.0f,%.0f\n", names[row], took[0], took[1], took[2],
                took[3]);
    }
    return 0;
}

static const wfMeasureRow rows[] = {
    { "impact-tunnel", "speeds at which a ball tunnels, and what the time of impact finds",
      measure_impact_tunnel },
    { "impact-spin", "angular speeds at which a rod passes a peg unseen",
      measure_impact_spin },
    { "impact-convergence", "the gap after each step of the advancement, by the bound",
      measure_impact_convergence },
    { "impact-steps", "distances asked for by times of impact", measure_impact_steps },
    { "impact-time", "what a distance, a cast and a time of impact cost",
      measure_impact_time },
};
const wfMeasureSet time_of_impact_measurements = WF_ROWS(rows);
