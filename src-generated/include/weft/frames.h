/* Weft: include/weft/frames.h, tangled from chapters/methods/36-in-a-game.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_FRAMES_H
#define WEFT_FRAMES_H
#include "weft/world.h"
WF_BEGIN_C

/* Lets so many seconds (0 to 10^6) pass: as many steps as come nearest, at most `most`
 * (>= 1). What is left, half a step or less, counts at the next call; what is more is
 * forgotten. Errors of wfStepWorld: the world is as before the step that failed; _RANGE. */
wfResult wfAdvanceWorld(wfWorld *world, double seconds, int32_t most);
/* Where the time is between the last two states, 0 to 1: for wfPoseBetween. */
wfReal wfStepShare(const wfWorld *world);
/* The share t (0 to 1) of the way from a to b, turning by the short way. */
wfTransform wfPoseBetween(wfTransform a, wfTransform b, wfReal t);
WF_END_C
#endif
