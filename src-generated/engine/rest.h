/* Weft: engine/rest.h, tangled from chapters/methods/05-joints-in-a-world.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_ENGINE_REST_H
#define WEFT_ENGINE_REST_H
/* The arrays of rest. For the engine's own files; not installed. */
#include "engine/block.h"

/* find the arrays of rest */
enum { WF_REST_ASLEEP = 1, WF_REST_NEVER = 2, WF_REST_SENT = 4 };

typedef struct wfRest {
    uint8_t *flags;            /* REST_... */
    wfReal  *clock;            /* s: for so long it has been still */
    int32_t *ring;             /* of a sleeper: the next of its island */
    int32_t *island;           /* the smallest index in its island, or -1 */
} wfRest;

static inline wfRest wfRestOf(const wfBlock *b)
{
    if (!wfHas(b->head, WF_NEED_SLEEP)) return (wfRest){ NULL, NULL, NULL, NULL };
    return (wfRest){ b->rest, b->clocks, b->rings, b->islands };
}

static inline bool wfIsAsleep(const wfRest *r, int32_t i)
{
    return r->flags != NULL && (r->flags[i] & WF_REST_ASLEEP) != 0;
}
/* Wakes body i, and with it everybody in its ring. */
void wfRouseIsland(wfBlock *b, const wfRest *r, int32_t i);
#endif
