/* Weft: dynamics/soft.h, tangled from chapters/methods/11-graph-colouring.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_SOFT_H
#define WEFT_SOFT_H
/* Soft contacts. */
#include "dynamics/substep.h"
wfSolverFn wfSoftStep;
wfSolverScratchFn wfSoftScratch;
#endif
