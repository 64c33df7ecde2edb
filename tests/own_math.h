/* A user's own math header (WF_MATH_HEADER): Weft's, but with a square root that counts its calls. */
#ifndef OWN_MATH_H
#define OWN_MATH_H
#define wfSqrt wfSqrtOfWeft
#include "weft/math_own.h"
#undef wfSqrt
static int own_math_calls;
static inline wfReal wfSqrt(wfReal a) { own_math_calls++; return wfSqrtOfWeft(a); }
#endif
