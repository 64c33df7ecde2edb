/* Weft: dynamics/sparse.h, tangled from chapters/methods/15-direct-contacts.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_SPARSE_H
#define WEFT_SPARSE_H
/* Sparse matrices of small blocks, in double. */
#include "weft/core.h"

/* a sparse matrix of small blocks */
enum { WF_NODE_ROWS = 4, WF_NODE_SQUARE = WF_NODE_ROWS * WF_NODE_ROWS };
typedef struct wfSparseEdge { int32_t to, block, next; } wfSparseEdge;
typedef struct wfSparseLater { int32_t to, block; } wfSparseLater;

/* Nodes of one to four rows, and a block for every two that are joined by an edge. */
typedef struct wfSparse {
    int32_t nodes, bodies;      /* all; the first ones, which may always be eliminated */
    int32_t blocks, room;       /* edges in use, and at most */
    int32_t numbers, most;      /* numbers in the blocks, in use and at most */
    int32_t parts, listed;      /* pieces that hang together; nodes with any edge */
    int32_t *rows;              /* [nodes] */
    int32_t *head, *mark;       /* [nodes] first edge or -1; for marking neighbours */
    int32_t *list;              /* [nodes] those with edges, part by part */
    int32_t *rank, *order;      /* [nodes] when a node is eliminated, or -1; the inverse */
    int32_t *degree, *bucket;   /* [nodes] neighbours left; first node of a degree */
    int32_t *next, *before;     /* [nodes] in its bucket */
    int32_t *start, *part;      /* [nodes + 1] of a node's later neighbours; of a part */
    int32_t *end, *other;       /* [nodes] the bodies on which a node acts, or -1 */
    bool *direct, *ready;       /* [nodes] of a part: it fits; may be eliminated now */
    bool *spent;                /* [nodes] of a body: a node has gone on its account */
    wfSparseEdge *edge;         /* [2 room] */
    wfSparseLater *later;       /* [room] by rank of the earlier node */
    int32_t *at;                /* [room] of a block's numbers */
    double *number;             /* [most] */
    double (*own)[WF_NODE_SQUARE];      /* [nodes] the diagonal, then its inverse */
    double (*size)[WF_NODE_ROWS];       /* [nodes] what pivots are compared with */
    double (*x)[WF_NODE_ROWS];          /* [nodes] right side, then the solution */
} wfSparse;
/* Takes arrays for so many nodes, and all that is left of the pool but `spare' bytes for
   blocks. False: no room. The rows have to be filled in. */
bool wfSparseTake(wfSparse *m, int32_t nodes, int32_t bodies, wfPool *pool, size_t spare);
size_t wfSparseScratch(int32_t nodes, int32_t blocks);
/* An edge between a body and a node that acts on it; its number, or -1: no room. A node has
   at most two. */
int32_t wfSparseJoin(wfSparse *m, int32_t body, int32_t node);
/* Finds the parts and an order for each; lays out the blocks. direct[] tells which fit. */
void wfSparseOrder(wfSparse *m);
/* The numbers of a block, rows of node `row' and columns of the other, row by row. */
double *wfSparseBlock(const wfSparse *m, int32_t block, int32_t row, int32_t column);
/* Zeros, for a part; factors it; solves for x. */
void wfSparseClear(wfSparse *m, int32_t part);
void wfSparseFactor(wfSparse *m, int32_t part);
void wfSparseSolve(wfSparse *m, int32_t part);
#endif
