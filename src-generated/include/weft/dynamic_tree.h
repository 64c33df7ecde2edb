/* Weft: include/weft/dynamic_tree.h, tangled from chapters/engine/11-broad-phase.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_DYNAMIC_TREE_H
#define WEFT_DYNAMIC_TREE_H
/* dynamic_tree.h: the row "dynamic-tree" of the broad phases by itself. Trusts its
   pointers. */
#include "weft/broad.h"
WF_BEGIN_C

enum { WF_TREE_NONE = -1, WF_TREE_OUT = -2, WF_TREE_RATIO = 4, WF_TREE_NEAR = 8 };

/* A node: nodes 0 .. capacity - 1 are the leaves of the proxies of these numbers, the
   others hold two children. */
typedef struct wfTreeNode {
    wfRect box;                   /* of a leaf the box it was given, else its children's */
    int32_t parent;               /* WF_TREE_NONE: the root; WF_TREE_OUT: not in the tree */
    int32_t left, right;          /* WF_TREE_NONE: a leaf */
    int32_t leaves, movers;       /* under it or it itself; how many of them move */
} wfTreeNode;

/* When and where a proxy was put in, to see how fast it moves. */
typedef struct wfTreePlace { wfVec2 at; uint32_t step; } wfTreePlace;

typedef struct wfTreeHead {
    int32_t capacity;             /* 0: not set up yet */
    int32_t root, freeNode, count;
    uint32_t step;                /* how often the tree was updated */
    int32_t high;                 /* greater than all proxies that were ever in it */
    int64_t changes;              /* how many boxes were put in, taken out or moved */
    int64_t nearChanges;          /* `changes` when the list of near pairs was made, or
                                     when it may be tried again */
    int32_t nearCount;            /* of near pairs; WF_TREE_NONE: there is no list */
} wfTreeHead;

/* Where the parts of the block are; made by wfTreeOpen. */
typedef struct wfTree {
    wfTreeHead *head;
    wfTreeNode *nodes;
    wfTreePlace *places;
    wfPair *overlaps;             /* leaves whose fat boxes overlap, sorted */
} wfTree;
size_t wfTreeSize(int32_t capacity);    /* bytes of a tree for proxies 0 .. capacity - 1 */
/* An empty tree in a block (aligned to WF_POOL_ALIGN; it may be moved and copied).
   WF_ERROR_NULL, _RANGE (capacity < 1), _MEMORY. */
wfResult wfTreeInit(wfTree *tree, void *block, size_t bytes, int32_t capacity);
wfTree wfTreeOpen(const void *block);   /* of a block that wfTreeInit has set up */

/* Puts a proxy in with a box (m).  WF_ERROR_NULL; _RANGE: no such proxy, already in the
   tree, or min > max; _NOT_FINITE.  After an error the tree is unchanged. */
wfResult wfTreeInsert(wfTree *tree, int32_t proxy, wfRect box, bool moves);
wfResult wfTreeRemove(wfTree *tree, int32_t proxy);    /* WF_ERROR_RANGE: it is not in it */
wfResult wfTreeMove(wfTree *tree, int32_t proxy, wfRect box);   /* another box */
bool wfTreeHolds(const wfTree *tree, int32_t proxy);
/* A box with a margin for one that moves by `way` (m) in a step, by eq:broad-fat. */
wfRect wfFatBox(wfRect box, wfVec2 way, wfReal ratio);
int32_t wfTreeDepth(const wfTree *tree);   /* steps from the root to the deepest leaf */
/* Is the list of near pairs that of the boxes as they are? */
static inline bool wfTreeHasNear(const wfTree *tree)
{
    const wfTreeHead *h = tree->head;
    return h->nearCount >= 0 && h->nearChanges == h->changes;
}
/* The row of dynamictree.c: trusts its input. */
wfBroadScratchFn wfTreeScratch;
wfRowIndexSizeFn wfTreeIndexSize;
wfRowUpdateFn wfTreeUpdate;
wfRowCopyFn wfTreeCopy;
wfRowPairsFn wfTreePairs;
wfRowQueryFn wfTreeQuery;
wfRowCastFn wfTreeCast;
wfRowBoxesFn wfTreeBoxes;
WF_END_C
#endif
