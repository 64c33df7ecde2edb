/* Weft: dynamics/colour.c, tangled from chapters/methods/12-graph-colouring.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "dynamics/colour.h"

/* colour constraints */
static uint32_t taken_at(const wfBodyState *state, const uint32_t *taken, int32_t body)
{
    return wfGivesWay(&state[body]) ? taken[body] : 0;
}

static int32_t first_free(uint32_t taken)
{
    int32_t k = 0;
    for (; taken & 1; taken /= 2) k++;
    return k < WF_COLOURS ? k : WF_COLOURS;
}

static void choose_colours(const wfBodyState *state, const wfPair *ends, int32_t count,
                           uint32_t *taken, uint8_t *colour, int32_t *counts)
{
    for (int32_t i = 0; i < count; i++) {
        wfPair p = ends[i];
        uint32_t both = taken_at(state, taken, p.a) | taken_at(state, taken, p.b);
        int32_t k = first_free(both);
        colour[i] = (uint8_t)k;
        counts[k]++;
        if (k == WF_COLOURS) continue;
        taken[p.a] |= (uint32_t)1 << k;
        taken[p.b] |= (uint32_t)1 << k;
    }
}

wfResult wfColour(const wfBodyState *state, int32_t bodies, const wfPair *ends,
                  int32_t count, wfPool *scratch, wfColouring *out)
{
    size_t mark = wfPoolMark(scratch);
    int32_t next[WF_COLOURS + 1] = { 0 }, sum = 0;
    uint32_t *taken = wfPoolPushArray(scratch, bodies, uint32_t);
    uint8_t *colour = wfPoolPushArray(scratch, count, uint8_t);
    bool room = count == 0 || (taken != NULL && colour != NULL);
    if (room && count > 0) {
        memset(taken, 0, (size_t)bodies * sizeof *taken);
        choose_colours(state, ends, count, taken, colour, next);
    }
    for (int32_t k = 0; k <= WF_COLOURS; k++) {
        out->first[k] = sum;
        sum += next[k];
        next[k] = out->first[k];
    }
    out->first[WF_COLOURS + 1] = sum;
    for (int32_t i = 0; room && i < count; i++) out->order[next[colour[i]]++] = i;
    wfPoolRewind(scratch, mark);
    return room ? WF_OK : WF_ERROR_MEMORY;
}

size_t wfColourScratch(int32_t bodies, int32_t constraints)
{
    return (size_t)bodies * sizeof(uint32_t)
         + (size_t)constraints * sizeof(uint8_t) + 2 * WF_POOL_ALIGN;
}
