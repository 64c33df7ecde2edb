/* Weft: include/weft/callbacks.h, tangled from chapters/methods/20-sensors-and-callbacks.nw. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_CALLBACKS_H
#define WEFT_CALLBACKS_H
#include "weft/inspect.h"
WF_BEGIN_C

/* What a hook may look at: the bodies as they are at this moment, the shapes. */
typedef struct wfCallbackView {
    wfBodyView  bodies;
    wfShapeView shapes;
    wfReal      timeStep;      /* s */
} wfCallbackView;
/* What a hook may change about a contact, for this step only. */
typedef struct wfContactSettings {
    int32_t enabled;           /* 0: contact and touch do not exist in this step */
    wfReal  restitution;       /* 0 to 1 */
    wfReal  friction;          /* >= 0 */
    wfReal  staticFriction;    /* >= 0: while nothing slides; below friction: the same */
    wfReal  rollingResistance; /* m, >= 0 */
    wfReal  tangentSpeed;      /* m/s */
} wfContactSettings;

/* Functions of the user's that a step asks; each may be NULL. They must not change the
 * world (WF_ERROR_BUSY if they try) and give the same answer to the same question within a
 * step. */
typedef struct wfCallbacks {
    void *context;             /* handed to both */
    /* May the shapes with these indices meet? Asked after the filters, a < b. */
    bool (*filter)(void *context, const wfCallbackView *view, int32_t a, int32_t b);
    /* Shown every contact before it is solved; `change` holds what will be used. */
    void (*preSolve)(void *context, const wfCallbackView *view, const wfContact *contact,
                     wfContactSettings *change);
} wfCallbacks;
/* wfStepWorld with callbacks (may be NULL). Further errors: WF_ERROR_RANGE and
 * WF_ERROR_NOT_FINITE (a callback gave such a number); WF_ERROR_BUSY (called from one). */
wfResult wfStepWorldWithCallbacks(wfWorld *world, const wfCallbacks *callbacks);
WF_END_C
#endif
