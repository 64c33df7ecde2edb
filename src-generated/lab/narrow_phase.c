/* Weft: lab/narrow_phase.c, tangled from chapters/engine/12-narrow-phase.lab.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/narrow.h"
#include "lab/bench.h"

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
typedef struct CoatCase {
    const char *name;
    wfReal coreA[2], coatA, coreB[2], coatB, at[2], degrees;    /* cores: half sizes */
    double exact;
} CoatCase;

static const CoatCase coat_cases[] = {
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

static wfResult coat_shape(const wfReal core[2], wfReal coat, wfShape *out)
{
    wfVec2 end = wfV2(core[0], 0);
    if (core[1] > 0) return wfMakeRoundedBox(core[0], core[1], coat, out);
    if (coat > 0) return wfMakeCapsule(wfNeg(end), end, coat, out);
    return wfMakeSegment(wfNeg(end), end, out);
}

static int measure_narrow_coats(FILE *out)
{
    static const char *const rows[3] = { "sat", "gjk", "voronoi" };
    static const char *const owners[3] = { "nobody", "A", "B" };
    fprintf(out, "case,exact,sat,gjk,voronoi,feature\n");
    for (size_t i = 0; i < sizeof coat_cases / sizeof *coat_cases; i++) {
        const CoatCase *c = &coat_cases[i];
        wfShape a, b;
        wfSeparation s[3];
        if (coat_shape(c->coreA, c->coatA, &a) != WF_OK) return 1;
        if (coat_shape(c->coreB, c->coatB, &b) != WF_OK) return 1;
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
static wfResult regular_polygon(int corners, wfShape *out)
{
    wfVec2 v[WF_MAX_VERTICES];
    for (int i = 0; i < corners; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / (wfReal)corners);
        v[i] = wfV2(q.c, q.s);
    }
    return wfMakePolygon(v, corners, out);
}

typedef struct GjkCount { long pairs, walk, grow; int walkMost, growMost; } GjkCount;

static void count_steps(const wfGjkTrace *t, GjkCount *c)
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
static int measure_narrow_gjk(FILE *out)
{
    wfRandom r;
    wfRandomSeed(&r, 12);
    fprintf(out, "corners,sat_dots,apart_mean,apart_max,apart_dots,overlap_mean,"
                 "epa_mean,epa_max,overlap_dots\n");
    for (int n = 3; n <= WF_MAX_VERTICES; n = n == 3 ? 4 : n * 2) {
        wfShape s;
        GjkCount count[2] = { { 0 }, { 0 } };
        if (regular_polygon(n, &s) != WF_OK) return 1;
        for (int i = 0; i < 20000; i++) {
            /* separate a random pair and count its steps */
            wfGjkTrace t;
            wfSeparation sep;
            wfReal turnA = wfRandomReal(&r, -WF_PI, WF_PI), turnB = wfRandomReal(&r, -WF_PI, WF_PI);
            wfReal x = wfRandomReal(&r, -3, 3), y = wfRandomReal(&r, -3, 3);
            wfTransform xa = wfMakeTransform(wfV2(0, 0), turnA);
            wfTransform xb = wfMakeTransform(wfV2(x, y), turnB);
            if (wfTraceGjk(&s, xa, &s, xb, &sep, &t) != WF_OK) return 1;
            count_steps(&t, &count[sep.distance <= 0]);
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
static void count_flips(const char *row, wfVec2 at, wfReal turn, int shakes, int flips[2])
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
        count_flips("sat", at, wfRadians(pairs[i].degrees), shakes, sat);
        count_flips("gjk", at, wfRadians(pairs[i].degrees), shakes, gjk);
        fprintf(out, "%s,%d,%d,%d,%d,%d\n", pairs[i].name, shakes, sat[0], sat[1], gjk[0],
                gjk[1]);
    }
    return 0;
}
typedef struct HardCase {
    const char *name;
    wfReal halfA[2], halfB[2], at[2], degrees;
    double exact;
} HardCase;

static const HardCase hard_cases[] = {
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

static int measure_narrow_hard(FILE *out)
{
    fprintf(out, "case,exact,sat,gjk,steps,epa\n");
    for (size_t i = 0; i < sizeof hard_cases / sizeof *hard_cases; i++) {
        const HardCase *h = &hard_cases[i];
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
        count_steps(&t, &count);
        fprintf(out, "%s,%.6g,%.6g,%.6g,%ld,%ld\n", h->name, h->exact,
                (double)sat.distance, (double)gjk.distance, count.walk, count.grow);
    }
    return 0;
}

static const wfMeasureRow rows[] = {
    { "narrow-far", "change of a computed depth far from the origin", measure_narrow_far },
    { "narrow-coats", "capsules, segments and rounded boxes in hard poses",
      measure_narrow_coats },
    { "narrow-gjk", "steps and dot products of GJK and EPA", measure_narrow_gjk },
    { "narrow-flips", "changes of normal and owner under noise", measure_narrow_flips },
    { "narrow-hard", "hard cases for narrow phases", measure_narrow_hard },
};
const wfMeasureSet narrow_phase_measurements = WF_ROWS(rows);
