/* Weft: dynamics/ties.h, tangled from chapters/methods/15-direct-contacts.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_TIES_H
#define WEFT_TIES_H
/* What joints lend to a solver of contacts. */
#include "dynamics/sparse.h"
#include "weft/resolve.h"

typedef struct wfTieRow {
    double jA[3], jB[3];        /* rate of x, y and turn of both bodies: eq:joints-rate */
    double target;              /* m/s or rad/s: the rate that it is to have, */
    double give;                /* less this by each N s or N m s: gamma */
    double sum, least, most;    /* N s or N m s: so far; its bounds */
    double noise;               /* m/s or rad/s: how well the joint knows its rate */
    int32_t index;              /* of the joint's rows */
    bool keeps;                 /* its rate is to stay what it is, and not `target` */
    bool idle, weak;            /* it takes no part; it has no say in places */
} wfTieRow;

typedef struct wfTie {
    int32_t a, b, count;        /* bodies; rows */
    int32_t joint;
    bool holds;                 /* rows that hold, or those within bounds */
    wfTieRow row[WF_NODE_ROWS];
} wfTie;

typedef struct wfLending {
    /* How many ties there are; who is tied, and by how many rows at most. ties: NULL, or
     * room for so many. */
    int32_t (*list)(void *context, const wfSolve *in, wfTie *ties);
    /* The rows as they are now; 1/I of the bodies as they see it, in inverse[body][2]. */
    void (*fill)(void *context, const wfSolve *in, wfReal dt, bool soft, wfTie *ties,
                 int32_t count, double (*inverse)[3]);
    /* What they have got, in `sum`; the momentum that all others gave, N s and N m s. */
    void (*take)(void *context, const wfSolve *in, bool soft, const wfTie *ties,
                 int32_t count, double (*given)[3]);
} wfLending;
#endif
