/* The engine in a dozen lines makes exactly the error that the chapter derives. */
#include <float.h>
#include "testing.h"
#include "lab/taste.h"

/* eq:intro-error: s_n = g t^2 / 2 + g t h / 2. Each of the 2n additions rounds a number no larger than the result, so
 * 2n machine epsilons of the result bound the difference. */
TEST(test_error_is_the_derived_one)
{
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

TEST(test_galileo)
{
    assert_true(tasteFallExactly(10, 1) == 5);
    assert_true(tasteFallExactly(10, 2) == 20);
    assert_true(tasteFallExactly(8, 0.5) == 1);
}
