/* A math header of one's own: Weft's, with a square root that counts how often it is asked.
   Compile the engine with
     -DWF_MATH_HEADER='"counting_math.h"' -Ithis/directory
   A header that has nothing of Weft's must define every name that weft/math_own.h
   declares (Appendix C lists them). */
#ifndef COUNTING_MATH_H
#define COUNTING_MATH_H
#define wfSqrt wfSqrtOfWeft
#include "weft/math_own.h"
#undef wfSqrt
extern long squareRoots;
static inline wfReal wfSqrt(wfReal a)
{
    squareRoots++;
    return wfSqrtOfWeft(a);
}
#endif
