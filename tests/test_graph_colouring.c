/* Colours of contacts. What they promise, and that the order within a colour is nobody's business. */
#include "testing.h"
#include "weft/resolve.h"
#include "dynamics/colour.h"

enum { BODIES = 60, MOST = 2000, ROOM = 1 << 20 };
static _Alignas(16) uint8_t memory[ROOM];
static wfBodyState bodies[BODIES];
static wfPair ends[MOST];
static int32_t order[MOST];

static wfPool pool_of(size_t bytes, int rubbish)
{
    wfPool pool;
    memset(memory, rubbish, sizeof memory);
    assert_int_equal(wfPoolInit(&pool, bytes, memory), WF_OK);
    return pool;
}

static bool moves(int32_t i) { return bodies[i].invMass > 0 || bodies[i].invInertia > 0; }

/* Random constraints; every seventh body is fixed, every eleventh can only turn. */
static void random_graph(wfRandom *r, int32_t count)
{
    for (int32_t i = 0; i < BODIES; i++)
        bodies[i] = (wfBodyState){ .invMass = i % 7 && i % 11 ? 1 : 0, .invInertia = i % 7 ? 1 : 0 };
    for (int32_t i = 0; i < count; i++) {
        int32_t a = (int32_t)wfRandomBelow(r, BODIES), b = (int32_t)wfRandomBelow(r, BODIES - 1);
        ends[i] = (wfPair){ a, b < a ? b : b + 1 };
    }
}

/* Every constraint once, ascending within a colour; in a colour no body that moves twice; each has the first colour that
   the constraints before it leave free, so colours never exceed eq:soft-colours. */
static void assert_colouring(const wfColouring *c, int32_t count)
{
    static int32_t colour[MOST], degree[BODIES];
    assert_int_equal(c->first[0], 0);
    assert_int_equal(c->first[WF_COLOURS + 1], count);
    memset(degree, 0, sizeof degree);
    for (int32_t i = 0; i < count; i++) colour[i] = -1, degree[ends[i].a]++, degree[ends[i].b]++;
    for (int32_t k = 0; k <= WF_COLOURS; k++) {
        bool seen[BODIES] = { false };
        for (int32_t at = c->first[k]; at < c->first[k + 1]; at++) {
            int32_t i = c->order[at];
            assert_in_range(i, 0, count - 1);
            assert_int_equal(colour[i], -1);
            colour[i] = k;
            if (at > c->first[k]) assert_true(c->order[at - 1] < i);
            if (k == WF_COLOURS) continue;
            if (moves(ends[i].a)) assert_false(seen[ends[i].a]);
            if (moves(ends[i].b)) assert_false(seen[ends[i].b]);
            seen[ends[i].a] = seen[ends[i].b] = true;
        }
    }
    for (int32_t i = 0; i < count; i++) {
        assert_true(colour[i] >= 0);
        int32_t da = moves(ends[i].a) ? degree[ends[i].a] : 1, db = moves(ends[i].b) ? degree[ends[i].b] : 1;
        assert_in_range(colour[i], 0, da + db - 2);
        uint32_t before = 0;
        for (int32_t k = 0; k < i; k++) {
            bool a = moves(ends[i].a) && (ends[k].a == ends[i].a || ends[k].b == ends[i].a);
            bool b = moves(ends[i].b) && (ends[k].a == ends[i].b || ends[k].b == ends[i].b);
            if ((a || b) && colour[k] < WF_COLOURS) before |= (uint32_t)1 << colour[k];
        }
        uint32_t below = ((uint32_t)1 << colour[i]) - 1;
        assert_true((before & below) == below);
    }
}

TEST(colours_share_no_body)
{
    wfRandom r = random_stream(3);
    for (int round = 0; round < 40; round++) {
        int32_t count = (int32_t)wfRandomBelow(&r, 300);
        random_graph(&r, count);
        wfColouring c = { .order = order };
        wfPool pool = pool_of(wfColourScratch(BODIES, count), round & 1 ? 0xFF : 0);
        assert_int_equal(wfColour(bodies, BODIES, ends, count, &pool, &c), WF_OK);
        assert_int_equal(pool.used, 0);
        assert_colouring(&c, count);
    }
}

/* A hub with a hundred spokes: the first take a colour each, the others are left over, in the order of the list. A floor
   with a hundred things on it needs one colour. */
TEST(what_is_left_over)
{
    for (int fixed = 0; fixed < 2; fixed++) {
        for (int32_t i = 0; i < BODIES; i++) bodies[i] = (wfBodyState){ .invMass = i > 0 || !fixed };
        for (int32_t i = 0; i < 59; i++) ends[i] = i % 2 ? (wfPair){ 0, i + 1 } : (wfPair){ i + 1, 0 };
        wfColouring c = { .order = order };
        wfPool pool = pool_of(wfColourScratch(BODIES, 59), 0xA5);
        assert_int_equal(wfColour(bodies, BODIES, ends, 59, &pool, &c), WF_OK);
        assert_int_equal(c.first[1], fixed ? 59 : 1);
        assert_int_equal(c.first[WF_COLOURS + 1] - c.first[WF_COLOURS], fixed ? 0 : 59 - WF_COLOURS);
        for (int32_t i = 0; i < 59; i++) assert_int_equal(c.order[i], i);
    }
}

TEST(no_memory)
{
    wfRandom r = random_stream(4);
    random_graph(&r, 200);
    for (size_t bytes = 0; bytes < 512; bytes += 16) {
        wfColouring c = { .order = order };
        wfPool pool = pool_of(bytes, 0);
        wfResult result = wfColour(bodies, BODIES, ends, 200, &pool, &c);
        assert_true(result == WF_ERROR_MEMORY || bytes >= 200 + 4 * BODIES);
        assert_int_equal(pool.used, 0);
    }
    wfColouring none = { .order = NULL };
    wfPool pool = pool_of(0, 0);
    assert_int_equal(wfColour(bodies, 0, NULL, 0, &pool, &none), WF_OK);
    assert_int_equal(none.first[WF_COLOURS + 1], 0);
}

/* ---- the same bits, whatever the order within a colour ---- */

static wfContact contacts[MOST], shuffled[MOST];

/* A net of contacts with one or two points each, some apart, some overlapping, with friction and rolling. */
static void random_contacts(wfRandom *r, int32_t count)
{
    random_graph(r, count);
    for (int32_t i = 0; i < BODIES; i++) bodies[i].v = random_v2(r, -1, 1), bodies[i].w = wfRandomReal(r, -1, 1);
    for (int32_t i = 0; i < count; i++) {
        wfReal angle = wfRandomReal(r, -3, 3);
        contacts[i] = (wfContact){ .a = ends[i].a, .b = ends[i].b, .shapeA = i, .friction = WF_R(0.5),
                                   .rollingResistance = i % 3 ? 0 : WF_R(0.01) };
        wfManifold *m = &contacts[i].manifold;
        m->normal = wfV2(wfCos(angle), wfSin(angle));
        m->count = 1 + (int32_t)wfRandomBelow(r, 2);
        for (int32_t k = 0; k < m->count; k++)
            m->points[k] = (wfContactPoint){ .rA = random_v2(r, -1, 1), .rB = random_v2(r, -1, 1),
                .depth = wfRandomReal(r, WF_R(-0.01), WF_R(0.01)), .feature = (uint32_t)k,
                .normalImpulse = wfRandomReal(r, 0, WF_R(0.1)) };
    }
}

static void shuffle_within_colours(wfRandom *r, int32_t count)
{
    wfColouring c = { .order = order };
    wfPool pool = pool_of(ROOM / 2, 0);
    assert_int_equal(wfColour(bodies, BODIES, ends, count, &pool, &c), WF_OK);
    assert_int_equal(c.first[WF_COLOURS + 1] - c.first[WF_COLOURS], 0);
    for (int32_t k = 0; k < WF_COLOURS; k++)
        for (int32_t i = c.first[k + 1] - 1; i > c.first[k]; i--) {
            int32_t with = c.first[k] + (int32_t)wfRandomBelow(r, (uint32_t)(i - c.first[k] + 1)), keep = c.order[i];
            c.order[i] = c.order[with];
            c.order[with] = keep;
        }
    for (int32_t i = 0; i < count; i++) shuffled[i] = contacts[order[i]];
}

/* The list is brought into the order of the colours, shuffled within each. By induction over the colours it is coloured
   as before: a constraint of colour k met one of each lower colour, and still does; those of its own do not touch it. */
TEST(order_within_a_colour_does_not_matter)
{
    wfRandom r = random_stream(5);
    for (int round = 0; round < 30; round++) {
        int32_t count = 90;
        static wfBodyState once[BODIES], twice[BODIES];
        random_contacts(&r, count);
        shuffle_within_colours(&r, count);
        for (int run = 0; run < 2; run++) {
            wfBodyState *state = run ? twice : once;
            memcpy(state, bodies, sizeof bodies);
            wfPool pool = pool_of(ROOM, run ? 0xFF : 0);
            wfSolve in = { .state = state, .bodyCount = BODIES, .contacts = run ? shuffled : contacts,
                .contactCount = count, .h = WF_R(1.0) / 60, .iterations = 2, .substeps = 4, .graphColouring = 1, .scratch = &pool };
            assert_int_equal(wfSolveStep(wfFindSolver("soft"), &in), WF_OK);
        }
        assert_memory_equal(once, twice, sizeof once);
        for (int32_t i = 0; i < count; i++)
            assert_memory_equal(&shuffled[i].manifold, &contacts[shuffled[i].shapeA].manifold, sizeof(wfManifold));
    }
}
