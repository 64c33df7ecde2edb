/* Weft: include/weft/mouse.h, tangled from chapters/methods/21-mouse-joint.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_MOUSE_H
#define WEFT_MOUSE_H
#include "weft/world.h"
WF_BEGIN_C

/* How fast a hand pulls, 1/s: five swings a second, critically damped; slower if timeStep
 * is long. */
#define WF_MOUSE_JOINT_RATE (2 * WF_PI * 5)
/* A hand that holds a body at a world point: a spring stiff enough to follow and soft
 * enough to be stable at the world's step. Move the hand with wfSetMouseTarget; let go with
 * wfRemoveForceFromWorld. Errors of wfAddForceToWorld; WF_ERROR_RANGE: not a dynamic
 * body. */
wfResult wfAddMouseJoint(wfWorld *world, wfBodyId id, wfVec2 point, wfForceId *out);
wfResult wfSetMouseTarget(wfWorld *world, wfForceId hand, wfVec2 point);
WF_END_C
#endif
