/* Weft: dynamics/columns.h, tangled from chapters/methods/11-stack-solver.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_COLUMNS_H
#define WEFT_COLUMNS_H
/* Trees of contacts, solved at once. */
#include "dynamics/substep.h"

/* What runs down a tree and up again, for one right side of eq:soft-contact-rows. */
typedef struct wfWave {
    wfReal load[3], wrong[3];    /* p: what comes down from above, N s; e */
    wfReal push[3], gain[3];     /* f and D */
} wfWave;

typedef struct wfFold {
    wfReal mass[3][3];           /* of the body and all above it; folded: its inverse */
    wfReal hold[3][3];           /* inverse of S */
} wfFold;

/* What a limb has, and a link has not. */
typedef struct wfTrunk {
    wfFold fold[2];              /* for Gamma of the rigid sweep and of the soft one */
    wfWave extra;                /* of a push at a link */
} wfTrunk;

/* A body that stands on one contact, and on it whatever stands there: a limb of a tree. Or
 * a link: a contact that closes a loop, between two limbs or a limb and the ground. */
typedef struct wfLimb {
    int32_t body, below;         /* below: limb that it stands on; -1: the ground */
    int32_t contact, root;       /* root: the limb of its tree that is on the ground */
    int32_t over;                /* the limb of `body`; another one: this is a link */
    int32_t end, links;          /* of a root: where its limbs end, and its links */
    int32_t points;              /* bits of the points that bear */
    int32_t height;              /* limbs from the ground to this one */
    uint8_t rows, state;
    bool    slides;              /* its foot slips: friction is left to a pass */
    bool    upside;              /* the body is the contact's a */
    bool    given_up;            /* a root with loops: by passes for the rest of the step */
    bool    lands;               /* a root: only its velocities are solved at once */
    int32_t stale[2];            /* a root: those up to this one, counted from it, have not
                                  * the matrices of `points`; -1: all have */
    int32_t came;                /* of a root: the point that was taken in last */
    int32_t answers;             /* of a root: where its part of answer[] begins */
    wfReal  up[3][3], down[3][3];           /* J and G */
    wfReal  ease[3];             /* 1/kg: K of the rows, which Gamma is a share of */
    wfWave  wave;                /* of the tree alone */
    wfTrunk *trunk;              /* a limb's */
    wfReal  at[2];               /* N s: sums that are on their way, sec:soft-careful */
} wfLimb;

typedef struct wfStacks {
    wfLimb  *limb;               /* each after the one that it stands on */
    int32_t  count, room;
    wfTrunk *trunk;              /* of each body, for its limb */
    wfReal  *answer;             /* what pushes at links do to links, sec:soft-again */
    int32_t  answers;
    uint8_t *held;               /* by place in c: is it solved here? */
    bool     linked;             /* some tree has loops */
} wfStacks;

enum { WF_HELD_NOT, WF_HELD_IN_TREE, WF_HELD_IN_LOOP, WF_HELD_ALONE };

/* Finds the trees among the contacts that touch. WF_ERROR_MEMORY. */
wfResult wfFindStacks(const wfSubsteps *s, wfStacks *out);
size_t wfStackScratch(int32_t bodies, int32_t contacts);
/* A gap of no more counts as a touch, m. */
wfReal wfNearGap(const wfSubsteps *s, int32_t contact);
/* Solves all trees: b and gamma / K of eq:soft-follow, how fast overlap is left at most.
 * A tree whose bearing points don't settle is left to passes. */
void wfSolveStacks(const wfSubsteps *s, wfStacks *t, bool soft, wfReal bias,
                   wfReal fastest);
/* Takes back what the sums that were just handed out have too much, eq:soft-memory. */
void wfTakeBackMemory(const wfSubsteps *s, wfStacks *t);
#endif
