/* Weft: testbed/overlays.h, tangled from chapters/testbed/06-inside-a-step.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef TESTBED_OVERLAYS_H
#define TESTBED_OVERLAYS_H
/* Overlays that look into a step: one pair, or one pass. */
#include "testbed/view.h"

/* What the reader looks at. All zero but for the shapes: the first step of everything. */
typedef struct wfLook {
    int32_t shapeA, shapeB;     /* indices of shapes; -1: none */
    int32_t gjk, clip;          /* how many steps of GJK, of clipping are shown, from 0 */
    int32_t substep, pass;      /* the next step is shown up to here, from 1 */
    float   seen[4];            /* m: what of the view nothing covers; 0: all of it */
} wfLook;

/* The pair at a place: the shape nearest to it, and the shape of another body nearest to
   that one. False, with -1 for both, when the world has no two bodies with shapes. */
bool wfPairAt(const wfWorld *world, wfVec2 place, int32_t *a, int32_t *b);
/* How many steps there are for this pair: 1 or more; 0: this pair has none. */
int32_t wfGjkSteps(const wfWorld *world, const wfLook *look);
int32_t wfClipSteps(const wfWorld *world, const wfLook *look);
/* Passes that the world's solver makes, and substeps. */
int32_t wfStepPasses(const wfWorldDef *def);
int32_t wfStepSubsteps(const wfWorldDef *def);
/* Makes in the scratch a copy of the world that has gone a part of its next step,
   eq:scenes-part. WF_ERROR_MEMORY, and the errors of the step. */
wfResult wfPartOfStep(const wfWorld *world, int32_t substep, int32_t pass, wfPool *scratch,
                      wfWorld *out);

/* Where the contact's edges are after so many cuts (wfClipSteps): in the world, m. False
   for shapes that are not cut. */
typedef struct wfClipView {
    wfVec2 reference[2], incident[2], kept[2];
    wfVec2 normal, side;        /* of the reference edge; along it */
    int32_t count;              /* of kept: 0 to 2 */
} wfClipView;
bool wfClipAt(const wfWorld *world, const wfLook *look, int32_t cuts, wfClipView *out);
/* Draws the overlays of `show' that look into a step. */
void wfDrawLook(const wfWorld *world, uint32_t show, const wfLook *look, wfPool *scratch,
                wfDraw *d);
#endif
