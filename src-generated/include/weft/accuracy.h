/* Weft: include/weft/accuracy.h, tangled from chapters/methods/35-tolerance.nw. Chapters that add
 * to it: world, looking, sensors-and-callbacks, mouse-joint, world-origin, sleep-in-a-world. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* accuracy.h: how accurate, and for how much: curves of error against work, measured on
   the user's own world, and the choice of settings from them. */
#ifndef WEFT_ACCURACY_H
#define WEFT_ACCURACY_H
#include "weft/world.h"
#include "weft/inspect.h"
#include "weft/modules.h"
#include "weft/settings.h"
#include "weft/material.h"
#include "weft/callbacks.h"
#include "weft/mouse.h"
#include "weft/origin.h"
#include "weft/disable.h"
WF_BEGIN_C

/* A way to step a world: names of rows of the tables that a world has; NULL: as it is. */
typedef struct wfMethodRow {
    const char *name, *text;
    const char *solver, *integrator, *joints;
    int32_t substeps;          /* in a step */
    int32_t passes;            /* over the contacts in a substep; 0: as many as usual */
    int32_t smooth;            /* 1: only for bodies that nothing touches or joins */
    double  substepCost;       /* of a substep, where the rest of a step costs 1 */
} wfMethodRow;
extern const wfMethodRow wfMethodTable[];
extern const int wfMethodCount;

/* One setting, and what it was measured to do. */
typedef struct wfAccuracy {
    int32_t method;            /* row of wfMethodTable */
    int32_t steps;             /* in a frame, >= 1 */
    int32_t failed;            /* 1: a step failed; neither error nor cost mean anything */
    int32_t relaxed;           /* so many bodies make fewer substeps, sec:accuracy-own */
    wfReal  frame;             /* s, > 0 */
    wfReal  error;             /* as a share of the scene's size, estimated, >= 0 */
    double  cost;              /* of a frame: counted, or ms by a clock */
} wfAccuracy;

enum { WF_CURVE_FINEST = 4096, WF_CURVE_POINTS = 128 };
/* How a curve is measured. */
typedef struct wfCurveDef {
    wfReal   frame;            /* s, > 0: what a program shows in one picture */
    int32_t  frames;           /* that are tried, >= 1 */
    int32_t  finest;           /* steps in a frame at most, 2 to WF_CURVE_FINEST */
    wfReal   enough;           /* >= 0: a method's curve ends at such an error */
    double (*now)(void *context);   /* s; NULL: costs are counted, and always the same */
    void    *context;
    wfMemory trial[2];         /* each as the world's; all zero: allocated, and freed */
} wfCurveDef;
/* A second in frames of 1/60 s, up to 128 steps in each, no clock, memory of its own. */
wfCurveDef wfDefaultCurveDef(void);
/* Tries the methods on copies of the world, each with 1, 2, 4, ... steps in a frame, and
 * writes a point for each: eq:accuracy-estimate. The world stays as it is. WF_ERROR_NULL,
 * _BUSY, _RANGE, _NOT_FINITE (see wfCurveDef), _MEMORY, _FULL: more than `capacity` points
 * (WF_CURVE_POINTS suffice for the rows of this chapter; then `points` are written, and
 * *count is not); those of a bad handle. */
wfResult wfMeasureCurve(const wfWorld *world, const wfCurveDef *how, wfAccuracy *points,
                        int32_t capacity, int32_t *count);
/* The cheapest point whose error is at most `tolerance` (> 0, a share of the scene's
 * size). WF_ERROR_TOLERANCE: there is none. WF_ERROR_NULL, _RANGE, _NOT_FINITE. */
wfResult wfChooseSettings(const wfAccuracy *points, int32_t count, wfReal tolerance,
                          wfAccuracy *out);
/* The most accurate point whose cost times `unit` (ms that a cost of 1 takes, > 0; 1 for
 * costs by a clock) is at most `budget` (ms a frame, > 0). WF_ERROR_BUDGET: there is none.
 * WF_ERROR_NULL, _RANGE, _NOT_FINITE. */
wfResult wfChooseForBudget(const wfAccuracy *points, int32_t count, double unit,
                           double budget, wfAccuracy *out);
/* Sets the world to what was chosen: from now on wfStepFrame, or as many steps in a frame
 * as it says. All bodies make all substeps (wfSetBodySubsteps). WF_ERROR_NULL, _UNKNOWN
 * (method), _RANGE, those of wfSetWorldDef. */
wfResult wfUseSettings(wfWorld *world, const wfAccuracy *chosen);
/* Advances the world by a frame: chosen->steps steps. After an error of a step the world
 * is as it was before that step, and wfWorldSteps tells how many were made. */
wfResult wfStepFrame(wfWorld *world, const wfAccuracy *chosen);
/* All of it: measures with wfDefaultCurveDef over a second from now (1000 frames at most)
 * in frames of `frame` seconds, chooses, finds out who can do with fewer substeps, sets.
 * No clock is asked: equal worlds, equal choice. Errors of all three; the world, and *out,
 * are then as they were. */
wfResult wfSetTolerance(wfWorld *world, wfReal frame, wfReal tolerance, wfAccuracy *out);
/* Says that so many substeps suffice for a body, of those that its world makes (>= 0; 0:
 * it needs all). The bodies of an island make as many as the most demanding of them needs,
 * and bodies with joints make all. For the solver "soft". WF_ERROR_STALE_ID, _RANGE,
 * _BUSY. */
wfResult wfSetBodySubsteps(wfWorld *world, wfBodyId id, int32_t substeps);
int32_t wfBodySubsteps(const wfWorld *world, wfBodyId id);     /* 0 for a stale id, too */
WF_END_C
#endif
