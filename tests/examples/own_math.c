/* What does a question cost in square roots? Compiled with counting_math.h, as is Weft. */
#include <stdio.h>
#include <weft/collision.h>

long squareRoots;

int main(void)
{
    wfShape box, ball;
    wfMakeBox(1, 1, &box);
    wfMakeCircle(wfV2(0, 0), 1, &ball);
    wfTransform a = wfTransformIdentity(), b = wfMakeTransform(wfV2(1, 0), 0);
    bool overlap = true;

    squareRoots = 0;
    wfOverlap(&box, a, &ball, b, &overlap);
    printf("%s: %s square roots\n", overlap ? "together" : "apart",
           squareRoots > 0 ? "some" : "no");
    squareRoots = 0;
    (void)wfSqrt(2);
    printf("and %ld for the square root of 2\n", squareRoots);
    return 0;
}
/* prints:
together: some square roots
and 1 for the square root of 2
*/
