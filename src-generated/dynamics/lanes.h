/* Weft: dynamics/lanes.h, tangled from chapters/methods/12-graph-colouring.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_LANES_H
#define WEFT_LANES_H
/* Several contacts at once. */
#include <string.h>
#include "weft/math.h"

/* numbers in lanes */
#if defined __has_builtin && !defined WF_ONE_LANE
#if __has_builtin(__builtin_shufflevector)
#define WF_HAS_LANES
#endif
#endif

#ifdef WF_HAS_LANES
enum { WF_LANES = 16 / sizeof(wfReal) };
typedef wfReal wfLanes __attribute__((vector_size(16)));
typedef __typeof__((wfLanes){ 0 } > (wfLanes){ 0 }) wfLaneMask;
#define WF_INLINE static inline __attribute__((always_inline))
#else
enum { WF_LANES = 1 };
typedef wfReal wfLanes;
typedef int32_t wfLaneMask;
#define WF_INLINE static inline
#endif

#ifdef WF_HAS_LANES
#ifdef WF_DOUBLE
WF_INLINE wfLanes wfLanesOf(wfReal x) { return (wfLanes){ x, x }; }
#else
WF_INLINE wfLanes wfLanesOf(wfReal x) { return (wfLanes){ x, x, x, x }; }
#endif
WF_INLINE wfLaneMask wfLanesMore(wfLanes a, wfLanes b) { return (wfLaneMask)(a > b); }

WF_INLINE wfLanes wfLanesWhere(wfLaneMask m, wfLanes a)     /* a, and 0 in other lanes */
{
    return (wfLanes)(m & (wfLaneMask)a);
}

WF_INLINE wfLanes wfLanesPick(wfLaneMask m, wfLanes a, wfLanes b)       /* eq:soft-pick */
{
    return (wfLanes)((m & (wfLaneMask)a) | (~m & (wfLaneMask)b));
}

WF_INLINE bool wfAnyLane(wfLaneMask m)
{
    int64_t half[2];
    memcpy(half, &m, sizeof half);
    return (half[0] | half[1]) != 0;
}
#else
WF_INLINE wfLanes wfLanesOf(wfReal x) { return x; }
WF_INLINE wfLaneMask wfLanesMore(wfLanes a, wfLanes b) { return -(a > b); }
WF_INLINE wfLanes wfLanesWhere(wfLaneMask m, wfLanes a) { return m ? a : 0; }
WF_INLINE wfLanes wfLanesPick(wfLaneMask m, wfLanes a, wfLanes b) { return m ? a : b; }
WF_INLINE bool wfAnyLane(wfLaneMask m) { return m != 0; }
#endif

#if defined WF_HAS_LANES && defined __SSE__ && !defined WF_DOUBLE
WF_INLINE wfLanes wfLanesMax(wfLanes a, wfLanes b) { return __builtin_ia32_maxps(a, b); }
WF_INLINE wfLanes wfLanesMin(wfLanes a, wfLanes b) { return __builtin_ia32_minps(a, b); }
#else
WF_INLINE wfLanes wfLanesMax(wfLanes a, wfLanes b)
{
    return wfLanesPick(wfLanesMore(a, b), a, b);
}

WF_INLINE wfLanes wfLanesMin(wfLanes a, wfLanes b)
{
    return wfLanesPick(wfLanesMore(b, a), a, b);
}
#endif

WF_INLINE wfReal *wfLane(wfLanes *v, int32_t lane) { return (wfReal *)v + lane; }
WF_INLINE wfReal wfLaneOf(const wfLanes *v, int32_t i) { return ((const wfReal *)v)[i]; }

/* Four numbers of each thing in a row; turned: the first of each, the second, ... */
typedef struct wfFour { wfLanes v[4]; } wfFour;

#if defined WF_HAS_LANES && !defined WF_DOUBLE
WF_INLINE wfFour wfTurnRound(wfFour r)
{
    wfLanes a = __builtin_shufflevector(r.v[0], r.v[1], 0, 4, 1, 5);
    wfLanes b = __builtin_shufflevector(r.v[0], r.v[1], 2, 6, 3, 7);
    wfLanes c = __builtin_shufflevector(r.v[2], r.v[3], 0, 4, 1, 5);
    wfLanes d = __builtin_shufflevector(r.v[2], r.v[3], 2, 6, 3, 7);
    return (wfFour){ { __builtin_shufflevector(a, c, 0, 1, 4, 5),
                       __builtin_shufflevector(a, c, 2, 3, 6, 7),
                       __builtin_shufflevector(b, d, 0, 1, 4, 5),
                       __builtin_shufflevector(b, d, 2, 3, 6, 7) } };
}

WF_INLINE wfFour wfTurnBack(wfFour r) { return wfTurnRound(r); }
#endif
#if defined WF_HAS_LANES && defined WF_DOUBLE
#define WF_MIX(a, b, i, k) __builtin_shufflevector(r.v[a], r.v[b], i, k)
WF_INLINE wfFour wfTurnRound(wfFour r)
{
    return (wfFour){ { WF_MIX(0, 2, 0, 2), WF_MIX(0, 2, 1, 3),
                       WF_MIX(1, 3, 0, 2), WF_MIX(1, 3, 1, 3) } };
}

WF_INLINE wfFour wfTurnBack(wfFour r)
{
    return (wfFour){ { WF_MIX(0, 1, 0, 2), WF_MIX(2, 3, 0, 2),
                       WF_MIX(0, 1, 1, 3), WF_MIX(2, 3, 1, 3) } };
}
#elif !defined WF_HAS_LANES
WF_INLINE wfFour wfTurnRound(wfFour r) { return r; }
WF_INLINE wfFour wfTurnBack(wfFour r) { return r; }
#endif

/* Four numbers, from `field` on, of the elements who[0], who[1], ... of an array. */
#define WF_GATHER(type, field, array, who) \
    wfGather(array, offsetof(type, field), sizeof(type), who)

WF_INLINE wfFour wfGather(const void *array, size_t offset, size_t size, const int32_t *who)
{
    const uint8_t *at = (const uint8_t *)array + offset;
    const size_t four = 4 * sizeof(wfReal);
    wfFour r;
#if defined WF_HAS_LANES && !defined WF_DOUBLE
    memcpy(&r.v[0], at + size * (size_t)who[0], four);
    memcpy(&r.v[1], at + size * (size_t)who[1], four);
    memcpy(&r.v[2], at + size * (size_t)who[2], four);
    memcpy(&r.v[3], at + size * (size_t)who[3], four);
#else
    memcpy(&r.v[0], at + size * (size_t)who[0], four);
    if (WF_LANES == 2) memcpy(&r.v[2], at + size * (size_t)who[WF_LANES - 1], four);
#endif
    return wfTurnRound(r);
}

WF_INLINE void wfScatter(void *array, size_t offset, size_t size, const int32_t *who,
                         int32_t to, wfFour from)
{
    uint8_t *at = (uint8_t *)array + offset;
    const size_t four = 4 * sizeof(wfReal);
    wfFour r = wfTurnBack(from);
    if (to & 1) memcpy(at + size * (size_t)who[0], &r.v[0], four);
#if defined WF_HAS_LANES && !defined WF_DOUBLE
    if (to & 2) memcpy(at + size * (size_t)who[1], &r.v[1], four);
    if (to & 4) memcpy(at + size * (size_t)who[2], &r.v[2], four);
    if (to & 8) memcpy(at + size * (size_t)who[3], &r.v[3], four);
#else
    if (WF_LANES == 2 && (to & 2))
        memcpy(at + size * (size_t)who[WF_LANES - 1], &r.v[2], four);
#endif
}

/* Contacts of one colour, one in each lane, all with as many points. */
typedef struct wfContactSimd {
    int32_t a[WF_LANES], b[WF_LANES];   /* their bodies */
    int32_t of[WF_LANES];               /* contact of[i] of in->contacts */
    int32_t used, points, first;        /* lanes in use; point[first] and after */
    int32_t movesA, movesB;             /* bits of the lanes whose a, whose b moves */
    bool alone;                         /* contacts of eq:soft-alone */
    wfLanes nx, ny, friction, tangentSpeed;
    wfLanes iA, iB, firm;               /* inverse inertias */
    wfLaneMask bounces;
} wfContactSimd;

/* as in wfPreparedPoint */
typedef struct wfSimdPoint {
    wfLanes nA, nB, tA, tB, massN, massT, now, normal, tangent;
} wfSimdPoint;

typedef struct wfSimdGap { wfLanes gap, upA, upB, told; } wfSimdGap;
#endif
