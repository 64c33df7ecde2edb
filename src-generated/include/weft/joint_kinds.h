/* Weft: include/weft/joint_kinds.h, tangled from chapters/methods/36-in-a-game.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_JOINT_KINDS_H
#define WEFT_JOINT_KINDS_H
#include "weft/world.h"
WF_BEGIN_C

/* Each is wfDefineJoint for one kind, with its errors: anchors (m) and an axis (any length
 * > 0) in the world; at rest as the bodies are. (A mouse is wfAddMouseJoint.) */
static inline wfResult wfDefineRevoluteJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                             wfVec2 anchor, wfJoint *out)
{
    return wfDefineJoint(world, "revolute", a, b, anchor, anchor, wfV2(0, 0), out);
}

static inline wfResult wfDefineWeldJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                         wfVec2 anchor, wfJoint *out)
{
    return wfDefineJoint(world, "weld", a, b, anchor, anchor, wfV2(0, 0), out);
}

static inline wfResult wfDefineDistanceJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                             wfVec2 anchorA, wfVec2 anchorB, wfJoint *out)
{
    return wfDefineJoint(world, "distance", a, b, anchorA, anchorB, wfV2(0, 0), out);
}

/* A distance joint that may be shorter: `length` (m, >= 0) at most. */
static inline wfResult wfDefineRopeJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                         wfVec2 anchorA, wfVec2 anchorB, wfReal length,
                                         wfJoint *out)
{
    wfResult result = wfDefineDistanceJoint(world, a, b, anchorA, anchorB, out);
    if (result == WF_OK) out->flags = WF_JOINT_LIMITS, out->upper = length;
    return result;
}

static inline wfResult wfDefinePrismaticJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                              wfVec2 anchor, wfVec2 axis, wfJoint *out)
{
    return wfDefineJoint(world, "prismatic", a, b, anchor, anchor, axis, out);
}

/* b is the wheel; it slides along the axis and turns: give it a spring and a motor. */
static inline wfResult wfDefineWheelJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                          wfVec2 anchor, wfVec2 axis, wfJoint *out)
{
    return wfDefineJoint(world, "wheel", a, b, anchor, anchor, axis, out);
}

/* Kind "servo", which pulls b to where it is now as a sees it, once it was given stiffness,
 * damping and motorForce. */
static inline wfResult wfDefineMotorJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                          wfVec2 anchor, wfJoint *out)
{
    return wfDefineJoint(world, "servo", a, b, anchor, anchor, wfV2(0, 0), out);
}

/* The two do not collide, and that is all. */
static inline wfResult wfDefineFilterJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                           wfJoint *out)
{
    return wfDefineJoint(world, "filter", a, b, wfV2(0, 0), wfV2(0, 0), wfV2(0, 0), out);
}

/* Keeps the turn of a + ratio times that of b. The ratio is not 0; above 0 they turn
 * against each other. */
static inline wfResult wfDefineGearJoint(wfWorld *world, wfBodyId a, wfBodyId b,
                                         wfReal ratio, wfJoint *out)
{
    const wfBodyState *state = wfWorldBodies(world).state;
    wfVec2 o = wfV2(0, 0);
    wfResult result = wfDefineJoint(world, "gear", a, b, o, o, o, out);
    if (result == WF_OK) wfSetRatio(out, &state[out->a], &state[out->b], ratio);
    return result;
}
WF_END_C
#endif
