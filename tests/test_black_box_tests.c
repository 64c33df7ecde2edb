/* The report's black-box tests come out as expected, and would not if the engine were wrong. */
#include "testing.h"
#include "lab/cases.h"
#include "weft/weft.h"

/* Fewer tries than the book's, so that every build has time for them. */
TEST(as_expected)
{
    for (int32_t i = 0; i < labCaseCount; i++) {
        const labCase *c = &labCases[i];
        double worst = c->worst(c->tries / 10);
        if (!(worst <= c->bound)) fail_msg("%s (%s): off by %g %s, allowed %g", c->id, c->expected, worst, c->unit, c->bound);
    }
}

/* The list is the report's: eight cases in its order, each with a use of its own and a bound that is not a blank cheque. */
TEST(list)
{
    assert_int_equal(labCaseCount, 8);
    for (int32_t i = 0; i < labCaseCount; i++) {
        char id[16];
        snprintf(id, sizeof id, "TC%02d", (int)i + 1);
        assert_string_equal(labCases[i].id, id);
        assert_true(labCases[i].bound >= 0 && labCases[i].bound < 0.0011 && labCases[i].tries >= 10);
        for (int32_t k = 0; k < i; k++) assert_true(labCases[i].worst != labCases[k].worst);
    }
}

/* A case sees the same input each time it is asked: the book's table can be made again. */
TEST(repeatable)
{
    for (int32_t i = 0; i < labCaseCount; i++) {
        double first = labCases[i].worst(5);
        assert_true(first == labCases[i].worst(5));
    }
}

/* Engines that TC04 must not let pass. */
static int finds_nothing(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfManifold *out)
{
    (void)a, (void)xa, (void)b, (void)xb;
    return out->count = 0;
}

static int finds_no_depth(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfManifold *out)
{
    int count = wfCollide(a, xa, b, xb, out);
    for (int i = 0; i < count; i++) out->points[i].depth = WF_R(-0.001);
    return count;
}

static int forgets_circles(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfManifold *out)
{
    bool circles = a->kind == WF_SHAPE_CIRCLE && b->kind == WF_SHAPE_CIRCLE;
    return circles ? finds_nothing(a, xa, b, xb, out) : wfCollide(a, xa, b, xb, out);
}

static int sees_ghosts(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfManifold *out)
{
    int count = wfCollide(a, xa, b, xb, out);
    if (count > 0) return count;
    out->points[0] = (wfContactPoint){ .depth = WF_R(-0.1) };
    return out->count = 1;
}

static int is_beside(const wfShape *a, wfTransform xa, const wfShape *b, wfTransform xb, wfManifold *out)
{
    int count = wfCollide(a, xa, b, xb, out);
    for (int i = 0; i < count; i++) out->points[i].point = wfAddScaled(out->points[i].point, WF_R(1e-4), out->normal);
    return count;
}

TEST(tc04_catches_who_is_wrong)
{
    labCollide *const wrong[] = { finds_nothing, finds_no_depth, forgets_circles, sees_ghosts, is_beside };
    const labCase *c = &labCases[3];
    assert_true(labPoints(c->tries, wfCollide) == c->worst(c->tries));
    assert_true(labPoints(c->tries, wfCollide) <= c->bound);
    for (int i = 0; i < (int)(sizeof wrong / sizeof *wrong); i++)
        if (!(labPoints(c->tries, wrong[i]) > c->bound)) fail_msg("number %d passes", i);
}
