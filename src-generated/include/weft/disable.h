/* Weft: include/weft/disable.h, tangled from chapters/methods/28-sleep-in-a-world.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_DISABLE_H
#define WEFT_DISABLE_H
#include "weft/world.h"
WF_BEGIN_C

/* Takes a body out of the world, 0, or puts it back as it is, 1 (else WF_ERROR_RANGE). As
 * long as it is out, nothing meets or moves it, and its joints and forces do nothing; it
 * keeps its id, shapes, joints and velocity. _STALE_ID, _BUSY. */
wfResult wfEnableBody(wfWorld *world, wfBodyId id, int32_t enabled);
bool wfBodyIsEnabled(const wfWorld *world, wfBodyId id);    /* false for a stale id, too */
WF_END_C
#endif
