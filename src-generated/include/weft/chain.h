/* Weft: include/weft/chain.h, tangled from chapters/methods/20-sensors-and-callbacks.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_CHAIN_H
#define WEFT_CHAIN_H
#include "weft/world.h"
WF_BEGIN_C

/* Hangs the links of wfMakeChain on a body that is not dynamic, all or none, each as `like`
 * says but for the shape; `out` (room for n) may be NULL. Points in the body's frame, m.
 * Errors of wfMakeChain and wfAddShapesToBody; WF_ERROR_RANGE: the body is dynamic. */
wfResult wfAddChainToBody(wfWorld *world, wfBodyId body, const wfVec2 *points, int32_t n,
                          bool loop, const wfShapeDef *like, wfShapeId *out);
WF_END_C
#endif
