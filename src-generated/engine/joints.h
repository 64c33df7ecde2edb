/* Weft: engine/joints.h, tangled from chapters/methods/26-joints-in-a-world.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_ENGINE_JOINTS_H
#define WEFT_ENGINE_JOINTS_H
/* The arrays of the joints. For the engine's own files; not installed. */
#include "engine/block.h"

/* find the arrays of the joints */
typedef struct wfJoints {
    wfSlot *slots;
    wfJoint *joints;
    wfJointId *broken;
} wfJoints;

static inline wfJoints wfJointsOf(const wfBlock *b)
{
    return (wfJoints){ b->jointSlots, b->joints, b->broken };
}

static inline bool wfJointIsLive(const wfJoints *j, int32_t i)
{
    return j->slots[i].next == WF_SLOT_LIVE;
}
#endif
