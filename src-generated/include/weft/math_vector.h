/* Weft: include/weft/math_vector.h, tangled from chapters/engine/06-numbers.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* math_vector.h: vectors; math_own.h includes it. Trusts its pointers. */
#ifndef WEFT_MATH_VECTOR_H
#define WEFT_MATH_VECTOR_H
#include "weft/math_real.h"
WF_BEGIN_C

typedef union wfVec2 {
    struct { wfReal x, y; };
    struct { wfReal X, Y; };
    wfReal E[2];
} wfVec2;

#define WF_XY(v) (float)(v).x, (float)(v).y    /* a vector as two arguments, for wfDraw */
#define WF_V2(x, y) { { (x), (y) } }    /* a vector in a list, or for a constant */

static inline wfVec2 wfV2(wfReal x, wfReal y)  { wfVec2 v = { { x, y } }; return v; }
static WF_ONE_COPY wfVec2 wfAdd(wfVec2 a, wfVec2 b) { return wfV2(a.x + b.x, a.y + b.y); }
static inline wfVec2 wfSub(wfVec2 a, wfVec2 b) { return wfV2(a.x - b.x, a.y - b.y); }
static inline wfVec2 wfNeg(wfVec2 a)           { return wfV2(-a.x, -a.y); }
static inline wfVec2 wfScale(wfReal s, wfVec2 a)      { return wfV2(s * a.x, s * a.y); }
static inline wfVec2 wfFromTo(wfVec2 a, wfVec2 b)     { return wfSub(b, a); }
/* a + s b */
static inline wfVec2 wfAddScaled(wfVec2 a, wfReal s, wfVec2 b)
{
    return wfV2(a.x + s * b.x, a.y + s * b.y);
}
static inline wfVec2 wfLerp(wfVec2 a, wfVec2 b, wfReal t)        /* eq:numbers-lerp */
{
    return wfV2((1 - t) * a.x + t * b.x, (1 - t) * a.y + t * b.y);
}
/* eq:numbers-dot and eq:numbers-cross */
static WF_ONE_COPY wfReal wfDot(wfVec2 a, wfVec2 b)  { return a.x * b.x + a.y * b.y; }
static WF_ONE_COPY wfReal wfCross(wfVec2 a, wfVec2 b) { return a.x * b.y - a.y * b.x; }
/* a quarter turn, to the left and to the right */
static WF_ONE_COPY wfVec2 wfPerpCCW(wfVec2 a)         { return wfV2(-a.y, a.x); }
static WF_ONE_COPY wfVec2 wfPerpCW(wfVec2 a)          { return wfV2(a.y, -a.x); }
/* eq:numbers-cross-scalar */
static inline wfVec2 wfCrossSV(wfReal s, wfVec2 v) { return wfV2(-s * v.y, s * v.x); }
static inline wfVec2 wfCrossVS(wfVec2 v, wfReal s) { return wfV2(s * v.y, -s * v.x); }
static inline wfReal wfLengthSq(wfVec2 a)             { return wfDot(a, a); }
static inline wfReal wfDistanceSq(wfVec2 a, wfVec2 b) { return wfLengthSq(wfSub(b, a)); }

static inline bool wfSquareIsSafe(wfReal s)
{
    return s > WF_SQUARE_LOW && s < WF_SQUARE_HIGH;
}

wfReal wfLengthOfMany(const wfReal *e, int n);       /* of n components; see wfLength */
void   wfNormalizeMany(wfReal *e, int n);            /* see wfNormalize */

/* Length. Safe for any finite vector; what is longer than WF_HUGE has the length WF_HUGE.
   Error: 2.5 eps of the length. eq:numbers-length. */
static inline wfReal wfLength(wfVec2 a)
{
    wfReal square = wfLengthSq(a);
    return wfSquareIsSafe(square) ? wfSqrt(square) : wfLengthOfMany(a.E, 2);
}

/* The vector of length 1 with a's direction; zero if a is zero or not finite. */
static inline wfVec2 wfNormalize(wfVec2 a)
{
    wfReal square = wfLengthSq(a);
    if (!wfSquareIsSafe(square)) {
        wfNormalizeMany(a.E, 2);
        return a;
    }
    wfReal length = wfSqrt(square);
    return wfV2(a.x / length, a.y / length);
}

static inline wfReal wfDistance(wfVec2 a, wfVec2 b) { return wfLength(wfSub(b, a)); }
/* component by component */
static inline wfVec2 wfMin2(wfVec2 a, wfVec2 b)
{
    return wfV2(wfMinR(a.x, b.x), wfMinR(a.y, b.y));
}
static inline wfVec2 wfMax2(wfVec2 a, wfVec2 b)
{
    return wfV2(wfMaxR(a.x, b.x), wfMaxR(a.y, b.y));
}
static inline wfVec2 wfAbs2(wfVec2 a)      { return wfV2(wfAbs(a.x), wfAbs(a.y)); }
static inline bool   wfIsFinite2(wfVec2 a) { return wfIsFinite(a.x) && wfIsFinite(a.y); }

typedef union wfVec3 {
    struct { wfReal x, y, z; };
    struct { wfReal X, Y, Z; };
    wfReal E[3];
} wfVec3;

static inline wfVec3 wfV3(wfReal x, wfReal y, wfReal z)
{
    wfVec3 v = { { x, y, z } }; return v;
}
static inline wfVec3 wfNeg3(wfVec3 a) { return wfV3(-a.x, -a.y, -a.z); }
static inline wfVec3 wfScale3(wfReal s, wfVec3 a)
{
    return wfV3(s * a.x, s * a.y, s * a.z);
}
static inline wfVec3 wfAdd3(wfVec3 a, wfVec3 b)
{
    return wfV3(a.x + b.x, a.y + b.y, a.z + b.z);
}
static inline wfVec3 wfSub3(wfVec3 a, wfVec3 b)
{
    return wfV3(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline wfReal wfDot3(wfVec3 a, wfVec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
static inline wfVec3 wfCross3(wfVec3 a, wfVec3 b)                /* eq:numbers-cross3 */
{
    return wfV3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}
static inline wfVec3 wfFromTo3(wfVec3 a, wfVec3 b)     { return wfSub3(b, a); }
static inline wfReal wfLengthSq3(wfVec3 a)             { return wfDot3(a, a); }
static inline wfReal wfLength3(wfVec3 a)               { return wfLengthOfMany(a.E, 3); }
static inline wfVec3 wfNormalize3(wfVec3 a)           { wfNormalizeMany(a.E, 3); return a; }
static inline wfReal wfDistanceSq3(wfVec3 a, wfVec3 b) { return wfLengthSq3(wfSub3(b, a)); }
static inline wfReal wfDistance3(wfVec3 a, wfVec3 b)   { return wfLength3(wfSub3(b, a)); }
static inline bool   wfIsFinite3(wfVec3 a)
{
    return wfIsFinite(a.x) && wfIsFinite(a.y) && wfIsFinite(a.z);
}

typedef union wfVec4 {
    struct { wfReal x, y, z, w; };
    struct { wfReal X, Y, Z, W; };
    wfReal E[4];
} wfVec4;

static inline wfVec4 wfV4(wfReal x, wfReal y, wfReal z, wfReal w)
{
    wfVec4 made = { { x, y, z, w } }; return made;
}
static inline wfVec4 wfAdd4(wfVec4 a, wfVec4 b)
{
    return wfV4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
}
static inline wfVec4 wfSub4(wfVec4 a, wfVec4 b)
{
    return wfV4(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
}

static inline wfVec4 wfScale4(wfReal s, wfVec4 a)
{
    return wfV4(s * a.x, s * a.y, s * a.z, s * a.w);
}
static inline wfReal wfDot4(wfVec4 a, wfVec4 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
static inline wfVec4 wfNeg4(wfVec4 a)                  { return wfScale4(-1, a); }
static inline wfVec4 wfFromTo4(wfVec4 a, wfVec4 b)     { return wfSub4(b, a); }
static inline wfReal wfLengthSq4(wfVec4 a)             { return wfDot4(a, a); }
static inline wfReal wfLength4(wfVec4 a)               { return wfLengthOfMany(a.E, 4); }
static inline wfVec4 wfNormalize4(wfVec4 a)           { wfNormalizeMany(a.E, 4); return a; }
static inline wfReal wfDistanceSq4(wfVec4 a, wfVec4 b) { return wfLengthSq4(wfSub4(b, a)); }
static inline wfReal wfDistance4(wfVec4 a, wfVec4 b)   { return wfLength4(wfSub4(b, a)); }
static inline bool   wfIsFinite4(wfVec4 a)
{
    return wfIsFinite(a.x) && wfIsFinite(a.y) && wfIsFinite(a.z) && wfIsFinite(a.w);
}
WF_END_C
#endif
