/* Exercise friction-harmonic. Oracle: double. */
#include "course.h"
#include "weft/resolve.h"
static double mix(double a, double b)
{
    int row = asked(wfFindMix("harmonic-mean"));
    if (row < 0) course_fail("the row in the table of mixing rules", "harmonic-mean", "no row of that name");
    return (double)asked(wfMixTable[row].mix((wfReal)a, (wfReal)b));
}
static void equal(void)
{
    expect_near("the mean of 0.3 and 0.3", mix(0.3, 0.3), 0.3, 1e-6);
    expect_near("the mean of 0.2 and 0.6", mix(0.2, 0.6), 0.3, 1e-6);
    expect_near("the mean of 0.6 and 0.2", mix(0.6, 0.2), 0.3, 1e-6);
}
static void zero(void)
{
    expect_near("the mean of 0 and 0", mix(0, 0), 0, 0);
    expect_near("the mean of 0 and 5", mix(0, 5), 0, 0);
}
static void extremes(void)
{
    double big = sizeof(wfReal) == 4 ? 1e30 : 1e300;
    expect_near("the mean of two very large numbers, as a share", mix(big, big) / big, 1, 1e-5);
    expect_near("the mean of two very small ones, as a share", mix(1 / big, 1 / big) * big, 1, 1e-4);
}
CRITERIA("harmonic",
    { "equal", 1, "harmonic: mix low and high", "it is the harmonic mean, in either order", equal, 0 },
    { "zero", 1, "harmonic: mix low and high", "0 with anything is 0", zero, 0 },
    { "extremes", 1, "harmonic: mix low and high", "neither large nor small numbers break it", extremes, 0 })
