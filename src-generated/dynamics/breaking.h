/* Weft: dynamics/breaking.h, tangled from chapters/methods/13-more-joints.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_BREAKING_H
#define WEFT_BREAKING_H
#include "dynamics/jointwork.h"

/* After the loads of a step are known: breaks what was overloaded. */
void wfBreakWorst(wfJointSet *set);
#endif
