/* Weft: include/weft/integrate.h, tangled from chapters/engine/10-integration.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* integrate.h: the ways to take bodies and forces from time t to time t + h. */
#ifndef WEFT_INTEGRATE_H
#define WEFT_INTEGRATE_H
#include "weft/body.h"
#include "weft/core.h"
WF_BEGIN_C

/* Adds to out[i] the force (N) and torque (N m) on each body in these states at this time
   (s). The integrator has set out to zero. It may be called several times a step, with
   states that are only tried. */
typedef void wfForceEval(void *context, const wfBodyState *state, int count, wfReal time,
                         wfBodyForces *out);

typedef struct wfIntegration {
    wfBodyState *state;     /* all bodies; moved on by the step */
    int32_t count;          /* how many */
    wfReal time, h;         /* s: where the step begins, how long it is; h < 0 goes back */
    wfForceEval *forces;
    void *context;          /* handed to forces */
    wfPool *scratch;        /* room for the row's scratch(count) bytes; given back */
} wfIntegration;

/* Moves every body by h. A body whose invMass (invInertia) is 0 keeps its velocity (its
   spin), whatever pushes it, and moves with it. WF_ERROR_MEMORY: scratch too small.
   WF_ERROR_NO_CONVERGENCE: an implicit method found no solution; h is too long. After an
   error the states are as before. */
typedef wfResult wfIntegratorFn(const wfIntegration *in);
typedef size_t wfIntegratorScratchFn(int32_t count);     /* bytes of scratch that suffice */

typedef struct wfIntegratorRow {
    const char *name, *text;
    int order;              /* the error after a given time shrinks as h^order */
    bool symplectic;        /* keeps phase-space area, if forces depend on places alone */
    int evaluations;        /* of the forces in one step; 0: as many as it takes */
    wfIntegratorFn *step;
    wfIntegratorScratchFn *scratch;
} wfIntegratorRow;

extern const wfIntegratorRow wfIntegratorTable[];
extern const int wfIntegratorCount;
int wfFindIntegrator(const char *name);  /* the row of that name, -1 if there is none */
/* Checks the input, then does the step of row `method`. WF_ERROR_UNKNOWN (no such row),
   _NULL, _RANGE (count < 0), _NOT_FINITE (h or time), and the row's own errors. */
wfResult wfIntegrate(int method, const wfIntegration *in);
WF_END_C
#endif
