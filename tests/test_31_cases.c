/* Chapter 31: the report's black-box tests come out as expected, and would not if the engine were wrong. */
#include "testing.h"
#include "lab/cases.h"
#include "weft/weft.h"

/* Fewer tries than the book's, so that every build has time for them. */
static void as_expected(void **unused)
{
    (void)unused;
    for (int32_t i = 0; i < labCaseCount; i++) {
        const labCase *c = &labCases[i];
        double worst = c->worst(c->tries / 10);
        if (!(worst <= c->bound)) fail_msg("%s (%s): off by %g %s, allowed %g", c->id, c->expected, worst, c->unit, c->bound);
    }
}

/* The list is the report's: eight cases in its order, each with a use of its own and a bound that is not a blank cheque. */
static void list(void **unused)
{
    (void)unused;
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
static void repeatable(void **unused)
{
    (void)unused;
    for (int32_t i = 0; i < labCaseCount; i++) {
        double first = labCases[i].worst(5);
        assert_true(first == labCases[i].worst(5));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(as_expected), cmocka_unit_test(list), cmocka_unit_test(repeatable) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
