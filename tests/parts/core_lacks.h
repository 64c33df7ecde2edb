/* core_lacks.h: what the report's cases (lab/cases.c) use and the engine "core" has not. Its worlds were all made for everything, so the
   defaults of a world are the defaults. It has no quad tree, and TC06 asks for nothing else: each call says that it cannot be done. */
#ifndef CORE_LACKS_H
#define CORE_LACKS_H
#include "weft/weft.h"
static inline wfBodyDef core_default_body(const wfWorld *world) { (void)world; return wfDefaultBodyDef(); }
#define wfDefaultBodyDefFor core_default_body
typedef struct wfQuadTree { int nothing; } wfQuadTree;
enum { WF_QUAD_MAX_DEPTH = 1 };
static inline wfResult wfQuadTreeBuild(wfQuadTree *tree, wfPool *pool, const wfProxies *in)
{
    (void)pool, (void)in;
    tree->nothing = 0;
    return WF_ERROR_UNKNOWN;
}
static inline int32_t wfQuadTreeNodeOf(const wfQuadTree *tree, int32_t proxy) { (void)proxy; return tree->nothing - 1; }
static inline int wfQuadTreePath(const wfQuadTree *tree, int32_t node, int32_t *path) { (void)node; path[0] = 0; return tree->nothing; }
static inline wfRect wfQuadTreeRect(const wfQuadTree *tree, int32_t node) { (void)tree, (void)node; return (wfRect){ wfV2(0, 0), wfV2(0, 0) }; }
#endif
