/* A user puts his own math in the place of Weft's by naming a header. */
#define WF_MATH_HEADER "own_math.h"
#include "testing.h"

TEST(test_own_header_is_used)
{
    assert_int_equal(own_math_calls, 0);
    assert_true(wfSqrt(9) == 3);
    assert_int_equal(own_math_calls, 1);
    assert_true(wfLength(wfV2(3, 4)) == 5);          /* the rest is Weft's */
}
