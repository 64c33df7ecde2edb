/* The engine in a dozen lines makes exactly the error that the chapter derives. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "lab/taste.h"

/* eq:intro-error: s_n = g t^2 / 2 + g t h / 2. Each of the 2n additions rounds a number no larger than the result, so
 * 2n machine epsilons of the result bound the difference. */
static void test_error_is_the_derived_one(void **state)
{
    (void)state;
    const double heights[] = { 9.81, 1.62, 24.79 };
    for (int k = 0; k < 3; k++)
        for (int n = 1; n <= 4096; n = n * 3 + 1)
            for (double t = 0.25; t < 10; t *= 1.7) {
                double g = heights[k], h = t / n;
                double expected = 0.5 * g * t * t + 0.5 * g * t * h;
                double tolerance = (2 * n + 8) * DBL_EPSILON * expected;
                assert_true(fabs(tasteFallBySteps(g, t, n) - expected) <= tolerance);
            }
}

static void test_galileo(void **state)
{
    (void)state;
    assert_true(tasteFallExactly(10, 1) == 5);
    assert_true(tasteFallExactly(10, 2) == 20);
    assert_true(tasteFallExactly(8, 0.5) == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_error_is_the_derived_one),
        cmocka_unit_test(test_galileo),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
