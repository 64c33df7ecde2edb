/* Weft: include/weft/spring.h, tangled from chapters/methods/36-in-a-game.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_SPRING_H
#define WEFT_SPRING_H
#include "weft/world.h"
WF_BEGIN_C

/* Gives a joint that was defined so a spring (WF_JOINT_SPRING) by which its two bodies, as
 * they are now and alone, swing at `frequency` (Hz, > 0) with the damping ratio `ratio`
 * (>= 0; 1: no swing). Errors of wfAddJointToWorld, not FULL; _RANGE; _UNKNOWN: this kind
 * has no spring; _MASS: neither body gives way. */
wfResult wfTuneJointSpring(wfWorld *world, wfJoint *joint, wfReal frequency, wfReal ratio);
WF_END_C
#endif
