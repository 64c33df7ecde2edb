/* Exercise draw-caps. Oracle: the area. */
#include "course.h"
wfReal exFlatCoverage(wfVec2 pixel, wfVec2 a, wfVec2 b, wfReal width);
#define exFlatCoverage(pixel, a, b, width) asked(exFlatCoverage(pixel, a, b, width))
static void area(void)
{
    for (int k = 0; k < 24; k++)
        for (int w = 3; w <= 7; w += 2) {
            double angle = 0.2617993878 * k, sum = 0, length = 20;
            wfVec2 a = wfV2(WF_R(32.3), WF_R(31.8)), b = wfV2((wfReal)(32.3 + length * cos(angle)), (wfReal)(31.8 + length * sin(angle)));
            for (int i = 0; i < 64 * 64; i++) {
                double c = (double)exFlatCoverage(wfV2((wfReal)(i % 64) + WF_R(0.5), (wfReal)(i / 64) + WF_R(0.5)), a, b, (wfReal)w);
                if (!(c >= 0 && c <= 1)) course_failf("a coverage", "from 0 to 1", "%g", c);
                sum += c;
            }
            expect_near(say("ink of a line of 20 by %d pixels at %d degrees", w, 15 * k), sum, length * w, 0.03 * length * w);
        }
}
static void ends(void)
{
    wfVec2 a = wfV2(10, WF_R(20.5)), b = wfV2(30, WF_R(20.5));
    expect_near("coverage in the middle", (double)exFlatCoverage(wfV2(WF_R(20.5), WF_R(20.5)), a, b, 3), 1, 1e-6);
    expect_near("coverage of the first pixel of the line", (double)exFlatCoverage(wfV2(WF_R(10.5), WF_R(20.5)), a, b, 3), 1, 1e-6);
    expect_near("coverage of the pixel before it", (double)exFlatCoverage(wfV2(WF_R(9.5), WF_R(20.5)), a, b, 3), 0, 1e-6);
    expect_near("coverage where the line ends in the middle of a pixel", (double)exFlatCoverage(wfV2(WF_R(30.5), WF_R(20.5)), a, wfV2(WF_R(30.5), WF_R(20.5)), 3), 0.5, 1e-5);
}
CRITERIA("flat-ends",
    { "area", 2, "flat ends: the share of the pixel", "the ink of a line is its area, in all directions", area, 0 },
    { "ends", 2, "flat ends: the share of the pixel", "the line ends where it should", ends, 0 })
