/* Weft: include/weft/broad.h, tangled from chapters/engine/11-broad-phase.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_BROAD_H
#define WEFT_BROAD_H
#include "weft/core.h"
#include "weft/math.h"

/* Two proxies that may touch; a < b always.  Report 5.4.2: potential_contact_pair. */
typedef struct wfPair { int32_t a, b; } wfPair;

enum { WF_PROXY_LIVE = 1, WF_PROXY_MOVES = 2 };

/* category: what it is (bits); mask: the categories that it meets; group: if two have the
   same one, > 0: always, < 0: never; 0: no group. */
typedef struct wfFilter { uint64_t category, mask; int32_t group; } wfFilter;

/* Category 1, meets everybody, no group. */
static inline wfFilter wfDefaultFilter(void)
{
    return (wfFilter){ 1, UINT64_MAX, 0 };
}

static inline bool wfFilterAllows(wfFilter a, wfFilter b)
{
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;   /* eq:broad-filter */
}

/* A filter of the user's own: may a and b collide?  Asked with a < b, after all others.  It
   must give the same answer to the same pair during one call. */
typedef bool wfPairFilterFn(const void *context, int32_t a, int32_t b);

/* Stand-ins for shapes: proxy i has bounds[i] (m, world frame, finite, min <= max) and
   flags[i].  One that is not live is not looked at; its bounds may hold anything.  The
   other fields may be NULL: nobody is filtered, nobody has an owner. */
typedef struct wfProxies {
    int32_t count;
    const wfRect *bounds;
    const uint8_t *flags;
    const wfFilter *filters;
    const int32_t *owners;        /* two proxies of the same owner are never a pair */
    wfPairFilterFn *custom;
    const void *context;          /* what custom gets to see */
} wfProxies;

/* Where the pairs go.  The caller gives pairs and capacity; a broad phase sets the rest.
   `tests` is how many box tests it took: work, counted the same on every machine. */
typedef struct wfPairList {
    wfPair *pairs;
    int32_t count, capacity;
    int64_t tests;
} wfPairList;

/* The wanted pairs (wfPairWanted) of proxies whose bounds overlap (touching counts), sorted
   by (a, b).  Trusts its input: wfFindPairs checks it.  Gives scratch back.
   WF_ERROR_FULL: more pairs than out->capacity.  WF_ERROR_MEMORY: scratch too small.
   After an error out->count is 0. */
typedef wfResult wfBroadPhaseFn(const wfProxies *in, wfPool *scratch, wfPairList *out);

/* Bytes of scratch that always suffice for so many proxies and so many pairs. */
typedef size_t wfBroadScratchFn(int32_t proxies, int32_t pairs);

/* A box of half size `half` (m, >= 0; 0: a ray) whose middle moves from `from` (m) by
   t * by (m), 0 <= t <= most. */
typedef struct wfBoxCast { wfVec2 from, by, half; wfReal most; } wfBoxCast;

/* Is shown a proxy of an area; false: enough. */
typedef bool wfVisitFn(void *context, int32_t proxy);
/* Is shown a proxy that the cast may meet.  Returns how far to look from now on: `most` to
   go on as before, less to look less far, a negative number to stop. */
typedef wfReal wfCastVisitFn(void *context, int32_t proxy, wfReal most);
typedef size_t wfRowIndexSizeFn(int32_t proxies);          /* bytes for so many proxies */
/* Makes the index agree with the proxies.  WF_ERROR_MEMORY (bytes or scratch too few): the
   index is as before. */
typedef wfResult wfRowUpdateFn(const wfProxies *in, void *index, size_t bytes,
                               wfPool *scratch);
typedef wfResult wfRowPairsFn(const wfProxies *in, const void *index, wfPool *scratch,
                              wfPairList *out);            /* as wfBroadPhaseFn */
typedef void wfRowQueryFn(const wfProxies *in, const void *index, wfRect area,
                          wfVisitFn *visit, void *context);
typedef void wfRowCastFn(const wfProxies *in, const void *index, const wfBoxCast *cast,
                         wfCastVisitFn *visit, void *context);
/* A box (m) by which an index finds its proxies.  Where it has no border: WF_HUGE. */
typedef struct wfIndexBox {
    wfRect box;
    int32_t depth;                /* steps from the root; -1: of a proxy that has no cell */
    int32_t held;                 /* so many proxies in this box and in none under it */
} wfIndexBox;

/* Is shown a box, each before those under it; false: enough. */
typedef bool wfBoxVisitFn(void *context, const wfIndexBox *box);
typedef void wfRowBoxesFn(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                          void *context);
typedef struct wfBroadPhaseRow {
    const char *name, *text;
    wfBroadPhaseFn *find;
    wfBroadScratchFn *scratch;
    /* all five, or none: then the wrappers scan; find may be NULL if there is an index */
    wfRowIndexSizeFn *indexSize;
    wfRowUpdateFn *update;
    wfRowPairsFn *pairs;
    wfRowQueryFn *query;
    wfRowCastFn *cast;
    wfRowBoxesFn *boxes;              /* may be NULL */
} wfBroadPhaseRow;

extern const wfBroadPhaseRow wfBroadPhaseTable[];
extern const int wfBroadPhaseCount;
int wfFindBroadPhase(const char *name);   /* the row of that name, -1 if there is none */
/* Checks the input, then calls row `method`.  WF_ERROR_NULL, WF_ERROR_UNKNOWN (no such
   row), WF_ERROR_RANGE (a count below 0, or min > max), WF_ERROR_NOT_FINITE, and the row's
   own errors. */
wfResult wfFindPairs(int method, const wfProxies *in, wfPool *scratch, wfPairList *out);

/* Appends {a, b} in order.  False if the list is full. */
bool wfPushPair(wfPairList *list, int32_t a, int32_t b);

/* Sorts pairs of proxies 0..proxies-1 by (a, b) in O(pairs + proxies).  WF_ERROR_MEMORY. */
wfResult wfSortPairs(wfPairList *list, int32_t proxies, wfPool *scratch);

/* The part of wfPairWanted that looks at owners, filters and the custom filter. */
bool wfPairAllowed(const wfProxies *in, int32_t a, int32_t b);

/* True if the pair is worth a box test: both live, one of them moves, and not forbidden by
   owner, filter or custom filter.  Every row asks this before it compares two boxes. */
static inline bool wfPairWanted(const wfProxies *in, int32_t a, int32_t b)
{
    int both = in->flags[a] & in->flags[b], any = in->flags[a] | in->flags[b];
    if (!(both & WF_PROXY_LIVE) || !(any & WF_PROXY_MOVES)) return false;
    return (!in->filters && !in->owners && !in->custom) || wfPairAllowed(in, a, b);
}

/* Writes the live proxies to ids (room for in->count), those that move first, each group in
   rising order.  Returns how many; *movers: how many of them move. */
int32_t wfListLive(const wfProxies *in, int32_t *ids, int32_t *movers);

/* How a row ends: sorts the pairs (room) or empties the list (WF_ERROR_FULL); gives scratch
   back to the mark. */
wfResult wfFinishPairs(bool room, int32_t proxies, wfPool *scratch, size_t mark,
                       wfPairList *out);
size_t wfSortPairsSize(int32_t proxies, int32_t pairs);   /* bytes wfSortPairs takes */

/* For two live proxies of which one moves: one counted box test (eq:broad-overlap), if the
   pair is allowed; appends {a, b} if they overlap.  False: the list is full. */
static inline bool wfOfferPair(const wfProxies *in, wfPairList *out, wfRect ra, int32_t a,
                               wfRect rb, int32_t b)
{
    if ((in->filters || in->owners || in->custom) && !wfPairAllowed(in, a, b)) return true;
    out->tests++;
    return !wfRectOverlap(ra, rb) || wfPushPair(out, a, b);
}
typedef struct wfKeyed { wfReal key; int32_t index; } wfKeyed;

/* Sorts by key, equal keys keep their order; spare has room for n.  No key may be NaN. */
void wfSortKeyed(wfKeyed *items, wfKeyed *spare, int32_t n);
/* Rearranges: items[k] is what it would be if sorted; none before it is greater, none
   behind it smaller.  0 <= k < n. */
void wfSelectKeyed(wfKeyed *items, int32_t n, int32_t k);

/* Square cells.  The cell of a point by eq:broad-cell, kept within the limits. */
typedef struct wfCellRange { int32_t x0, y0, x1, y1; } wfCellRange;  /* ends included */
typedef struct wfCells {
    wfVec2 origin;                /* m */
    wfReal side, perMetre;        /* m, > 0; 1 / side, 1/m */
    wfCellRange limits;
} wfCells;

/* A grid over the world of cells at least so large, of at most `most` cells (>= 4). */
wfCells wfGridCells(wfRect world, wfReal side, int32_t most);
/* Cells without borders: a billion of them to each side of (0, 0). */
wfCells wfHashCells(wfReal side);
wfCellRange wfCellsOf(const wfCells *cells, wfRect r);    /* the cells that r touches */
uint32_t wfHashCell(int32_t x, int32_t y);                /* eq:broad-hash */

enum { WF_BOX_LEAF = 4, WF_BOX_NONE = -1 };    /* so many proxies at most in a leaf */

/* A node of a tree of boxes: the common box of items first .. first + count - 1.  Its left
   child is the node behind it; right is its right child, or WF_BOX_NONE for a leaf. */
typedef struct wfBoxNode { wfRect box; int32_t first, count, right; } wfBoxNode;

typedef struct wfBoxTree {
    const wfProxies *in;
    wfBoxNode *nodes;
    wfKeyed *items;               /* the proxies, those of one node side by side */
    int32_t nodeCount;
} wfBoxTree;

/* Adds a tree over items first .. first + count - 1 (count > 0), returns its root.  There
   must be room for count + 1 nodes. */
int32_t wfBoxTreeBuild(wfBoxTree *tree, int32_t first, int32_t count);

/* A pool over an index's bytes: pushing the row's arrays in order finds their places. */
static inline wfPool wfOpenIndex(const void *index, size_t bytes)
{
    return (wfPool){ .base = (uint8_t *)index, .size = bytes, .used = 0 };
}
size_t wfIndexSize(int method, int32_t proxies);     /* bytes of an index; 0: has none */

/* Makes the index (bytes: as wfIndexSize for at least in->count, aligned to WF_POOL_ALIGN,
   zero at first) agree with the proxies; do it after every change of them.  An index made
   by another method is made anew.  Scratch as the row's scratch() says.  Errors as
   wfFindPairs; WF_ERROR_MEMORY: index or scratch too small, or misaligned.  After an error
   the index is unchanged.  A method without an index does nothing. */
wfResult wfUpdateIndex(int method, const wfProxies *in, void *index, size_t bytes,
                       wfPool *scratch);

/* As wfFindPairs, by an index that agrees with the proxies (or NULL: without one). */
wfResult wfIndexPairs(int method, const wfProxies *in, const void *index, wfPool *scratch,
                      wfPairList *out);
/* Shows every live proxy whose bounds overlap the area (touching counts), each once, in an
   order that depends on the index alone.  index as in wfIndexPairs.  WF_ERROR_NULL,
   _UNKNOWN, _RANGE (min > max), _NOT_FINITE. */
wfResult wfQueryIndex(int method, const wfProxies *in, const void *index, wfRect area,
                      wfVisitFn *visit, void *context);

/* Shows every live proxy whose bounds the moving box meets, each once, roughly from near to
   far.  Generous by eq:broad-pad, never mean.  WF_ERROR_NULL, _UNKNOWN, _NOT_FINITE, _RANGE
   (half or most < 0). */
wfResult wfCastIndex(int method, const wfProxies *in, const void *index,
                     const wfBoxCast *cast, wfCastVisitFn *visit, void *context);

static inline wfBoxCast wfPadCast(wfBoxCast c)                       /* eq:broad-pad */
{
    wfReal e = 4 * WF_EPSILON;          /* first: the sum may overflow, not this */
    wfVec2 pad = wfAdd(wfScale(e, wfAbs2(c.from)), wfScale(e, c.half));
    c.half = wfAdd(c.half, wfAddScaled(pad, e * c.most, wfAbs2(c.by)));
    return c;
}

/* eq:broad-slab for one axis: cuts [*enter, *leave] down to where low <= from + t by and
   from + t by <= high; false if nothing is left */
static inline bool wfCutSlab(wfReal from, wfReal by, wfReal low, wfReal high, wfReal *enter,
                             wfReal *leave)
{
    if (by == 0) return low <= from && from <= high;
    wfReal a = (low - from) / by, b = (high - from) / by;
    *enter = wfMaxR(*enter, by > 0 ? a : b);
    *leave = wfMinR(*leave, by > 0 ? b : a);
    return *enter <= *leave;
}

/* Does the cast meet the box?  *enter: the fraction at which it does (0: at the start). */
static inline bool wfCastMeets(const wfBoxCast *c, wfRect r, wfReal *enter)
{
    wfReal leave = c->most;
    *enter = 0;
    return c->most >= 0
        && wfCutSlab(c->from.x, c->by.x, r.min.x - c->half.x, r.max.x + c->half.x, enter,
                     &leave)
        && wfCutSlab(c->from.y, c->by.y, r.min.y - c->half.y, r.max.y + c->half.y, enter,
                     &leave);
}

/* Shows the proxy if it is met, and shortens the cast.  False: the visitor has enough. */
static inline bool wfOfferCast(const wfProxies *in, wfBoxCast *cast, int32_t proxy,
                               wfCastVisitFn *visit, void *context)
{
    wfReal enter;
    if (!wfCastMeets(cast, in->bounds[proxy], &enter)) return true;
    wfReal most = visit(context, proxy, cast->most);
    if (most < cast->most) cast->most = most;
    return cast->most >= 0;
}
/* Shows the boxes of an index, in an order that depends on the index alone.  Nothing, if
   the method has no index or this one isn't of these proxies.  WF_ERROR_NULL, _UNKNOWN. */
wfResult wfIndexBoxes(int method, const wfProxies *in, const void *index,
                      wfBoxVisitFn *visit, void *context);

enum { WF_BOTTOM_LEFT, WF_BOTTOM_RIGHT, WF_TOP_LEFT, WF_TOP_RIGHT, WF_QUAD_ROOT };
enum { WF_QUAD_NONE = -1, WF_QUAD_MAX_DEPTH = 16, WF_QUAD_BUCKET = 6,
       WF_QUAD_STACK = 3 * WF_QUAD_MAX_DEPTH + 4 };

/* One square of the plane.  Report 5.4.1: quad_tree_node. */
typedef struct wfQuadNode {
    wfVec2 centre, half;          /* m: middle, and half of width and height */
    int32_t parent, child[4];     /* WF_QUAD_NONE: none */
    int32_t sector;               /* which child of its parent it is, or WF_QUAD_ROOT */
    int32_t depth;                /* root 0; WF_QUAD_NONE for a node on the free list */
    int32_t first, count;         /* the proxies in this very node */
    int32_t below;                /* how many proxies are in the nodes under it */
    bool split;                   /* true once its proxies may go down */
} wfQuadNode;

/* Where a proxy is: in which node, and who is before and behind it there (or NONE). */
typedef struct wfQuadLink { int32_t node, next, previous; } wfQuadLink;

typedef struct wfQuadTree {
    wfQuadNode *nodes;            /* [nodeCapacity], node 0 is the root */
    wfQuadLink *links;            /* [proxyCapacity] */
    wfRect *bounds;               /* [proxyCapacity] */
    int32_t nodeCapacity, nodeHigh, freeNode, proxyCapacity;
    int32_t depthLimit, bucket, count;
} wfQuadTree;

/* root: the area that is cut up (boxes may lie outside it); nodes, proxies: how many at
   most; depth: 0..WF_QUAD_MAX_DEPTH; bucket: how many proxies a node holds before it is cut
   (0: every proxy goes to the smallest node that holds it, as in the report). */
typedef struct wfQuadTreeDef {
    wfRect root;
    int32_t proxies, nodes, depth, bucket;
} wfQuadTreeDef;

/* Which pairs are generated: within one node only (the report's rule, which misses pairs);
   also with all nodes above; with the nodes below that the proxy's bounds reach into. */
typedef enum wfQuadReach { WF_QUAD_SAME_NODE, WF_QUAD_CLIMB, WF_QUAD_DESCEND } wfQuadReach;
size_t wfQuadTreeSize(int32_t proxies, int32_t nodes);  /* bytes wfQuadTreeInit takes */
int32_t wfQuadTreeNodes(int32_t proxies);          /* nodes wfQuadTreeBuild reserves */

/* An empty tree in the pool's memory.  WF_ERROR_NULL, _RANGE, _NOT_FINITE, _MEMORY. */
wfResult wfQuadTreeInit(wfQuadTree *tree, wfPool *pool, const wfQuadTreeDef *def);
/* The report's BuildQuadTree: over all live proxies, its root their common bounds. */
wfResult wfQuadTreeBuild(wfQuadTree *tree, wfPool *pool, const wfProxies *proxies);
/* The report's InsertIntoTree.  WF_ERROR_RANGE: no such proxy, already in the tree, or
   min > max; WF_ERROR_NOT_FINITE.  After an error the tree is unchanged. */
wfResult wfQuadTreeInsert(wfQuadTree *tree, int32_t proxy, wfRect bounds);
/* The report's RemoveFromTree.  WF_ERROR_RANGE if the proxy is not in the tree. */
wfResult wfQuadTreeRemove(wfQuadTree *tree, int32_t proxy);
/* Gives a proxy that is in the tree new bounds. */
wfResult wfQuadTreeMove(wfQuadTree *tree, int32_t proxy, wfRect bounds);
/* Appends the pairs by the given rule, unsorted, each once.  Only those that `in` wants;
   NULL: all are live and move.  WF_ERROR_FULL: out->count is 0. */
wfResult wfQuadTreePairs(const wfQuadTree *tree, wfQuadReach reach, const wfProxies *in,
                         wfPairList *out);
int32_t wfQuadTreeNodeOf(const wfQuadTree *tree, int32_t proxy);  /* or WF_QUAD_NONE */
bool wfQuadTreeUses(const wfQuadTree *tree, int32_t node);    /* is it a node in use */
wfRect wfQuadTreeRect(const wfQuadTree *tree, int32_t node);  /* the node's rectangle, m */
/* The sectors from the root to the node, room for WF_QUAD_MAX_DEPTH; returns how many. */
int wfQuadTreePath(const wfQuadTree *tree, int32_t node, int32_t *sectors);
/* The children of a node that the bounds reach into, room for 4; returns how many. */
int wfQuadTreeReach(const wfQuadTree *tree, int32_t node, wfRect bounds, int32_t *reached);
int wfQuadSector(wfVec2 centre, wfRect bounds);   /* the quarter that holds it, or NONE */
/* The row of quadtree.c: its functions trust their input, as those of every row. */
wfBroadScratchFn wfQuadScratch;
wfRowIndexSizeFn wfQuadIndexSize;
wfRowUpdateFn wfQuadUpdate;
wfRowPairsFn wfQuadPairs;
wfRowQueryFn wfQuadQuery;
wfRowCastFn wfQuadCast;
wfRowBoxesFn wfQuadBoxes;
/* The rows of cells.c: trust their input, as every row. */
wfBroadScratchFn wfGridScratch;
wfRowIndexSizeFn wfGridIndexSize;
wfRowUpdateFn wfGridUpdate;
wfRowPairsFn wfGridPairs;
wfRowQueryFn wfGridQuery;
wfRowCastFn wfGridCast;
wfRowBoxesFn wfGridBoxes;
wfBroadScratchFn wfHashScratch;
wfRowIndexSizeFn wfHashIndexSize;
wfRowUpdateFn wfHashUpdate;
wfRowPairsFn wfHashPairs;
wfRowQueryFn wfHashQuery;
wfRowCastFn wfHashCast;
wfRowBoxesFn wfHashBoxes;
/* Finds the pairs, sweeping along x (0), along y (1), or along the axis of wfSweepAxis
   (-1).  Scratch as wfSweepScratch says. */
wfResult wfSweepAlong(int axis, const wfProxies *in, wfPool *scratch, wfPairList *out);
/* The axis, 0 or 1, along which fewer of the n listed boxes should meet. */
int wfSweepAxis(const wfProxies *in, const int32_t *ids, int32_t n);

/* The row of sweep.c: trusts its input. */
wfBroadScratchFn wfSweepScratch;
wfRowIndexSizeFn wfSweepIndexSize;
wfRowUpdateFn wfSweepUpdate;
wfRowPairsFn wfSweepPairs;
wfRowQueryFn wfSweepQuery;
wfRowCastFn wfSweepCast;
wfRowBoxesFn wfSweepBoxes;
/* The row of boxtree.c: trusts its input. */
wfBroadScratchFn wfBoxTreeScratch;
wfRowIndexSizeFn wfBoxTreeIndexSize;
wfRowUpdateFn wfBoxTreeUpdate;
wfRowPairsFn wfBoxTreePairs;
wfRowQueryFn wfBoxTreeQuery;
wfRowCastFn wfBoxTreeCast;
wfRowBoxesFn wfBoxTreeBoxes;

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
    wfPair *near;                 /* leaves whose fat boxes overlap, sorted */
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
wfRowPairsFn wfTreePairs;
wfRowQueryFn wfTreeQuery;
wfRowCastFn wfTreeCast;
wfRowBoxesFn wfTreeBoxes;
#endif
