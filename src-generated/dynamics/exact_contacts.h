/* Weft: dynamics/exact_contacts.h, tangled from chapters/methods/15-direct-contacts.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_EXACT_CONTACTS_H
#define WEFT_EXACT_CONTACTS_H
/* All contacts at once. */
#include "weft/resolve.h"
wfSolverFn wfExactStep;
wfSolverScratchFn wfExactStepScratch;
#endif
