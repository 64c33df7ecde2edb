/* Weft: dynamics/colour.h, tangled from chapters/methods/12-graph-colouring.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_COLOUR_H
#define WEFT_COLOUR_H
/* Constraints in colours that share no body. */
#include "weft/resolve.h"
#include "weft/broad.h"

enum { WF_COLOURS = 24 };

/* Colour k has the constraints order[first[k]] .. order[first[k + 1] - 1], in ascending
 * order; colour WF_COLOURS is what is left over. */
typedef struct wfColouring {
    int32_t *order;
    int32_t  first[WF_COLOURS + 2];
} wfColouring;

size_t wfColourScratch(int32_t bodies, int32_t constraints);
/* Colours constraints by the bodies that they join; out->order has room for them. Depends
 * on the list, and on who can move. WF_ERROR_MEMORY; all scratch is given back. */
wfResult wfColour(const wfBodyState *state, int32_t bodies, const wfPair *ends,
                  int32_t count, wfPool *scratch, wfColouring *out);
#endif
