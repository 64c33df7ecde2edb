/* Weft: collision/quadtree.c, tangled from chapters/engine/11-broad-phase.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/broad.h"

/* find the quarter that holds a box by eq:broad-sector */
int wfQuadSector(wfVec2 centre, wfRect r)
{
    int sector;
    if (r.max.x < centre.x) sector = 0;
    else if (r.min.x > centre.x) sector = 1;
    else return WF_QUAD_NONE;
    if (r.max.y < centre.y) return sector;
    if (r.min.y > centre.y) return sector + 2;
    return WF_QUAD_NONE;
}

/* make and free nodes of the quad tree */
static int32_t takeNode(wfQuadTree *tree)
{
    int32_t n = tree->freeNode;
    if (n != WF_QUAD_NONE) tree->freeNode = tree->nodes[n].parent;
    else if (tree->nodeHigh < tree->nodeCapacity) n = tree->nodeHigh++;
    return n;
}

static void clearNode(wfQuadNode *node, wfVec2 centre, wfVec2 half)
{
    *node = (wfQuadNode){ .centre = centre, .half = half, .parent = WF_QUAD_NONE,
                          .sector = WF_QUAD_ROOT, .first = WF_QUAD_NONE };
    for (int s = 0; s < 4; s++) node->child[s] = WF_QUAD_NONE;
}

static void giveNode(wfQuadTree *tree, int32_t n)
{
    wfQuadNode *node = &tree->nodes[n];
    tree->nodes[node->parent].child[node->sector] = WF_QUAD_NONE;
    node->depth = WF_QUAD_NONE;
    node->parent = tree->freeNode;
    tree->freeNode = n;
}

static int32_t childOf(wfQuadTree *tree, int32_t parent, int sector)
{
    wfQuadNode *up = &tree->nodes[parent];
    if (up->child[sector] != WF_QUAD_NONE) return up->child[sector];
    int32_t n = takeNode(tree);
    if (n == WF_QUAD_NONE) return n;
    wfVec2 half = wfScale(0.5f, up->half);
    wfVec2 step = wfV2(sector & 1 ? half.x : -half.x, sector & 2 ? half.y : -half.y);
    clearNode(&tree->nodes[n], wfAdd(up->centre, step), half);
    tree->nodes[n].parent = parent;
    tree->nodes[n].sector = sector;
    tree->nodes[n].depth = up->depth + 1;
    up->child[sector] = n;
    return n;
}

/* link and unlink a proxy */
static void addBelow(wfQuadTree *tree, int32_t n, int32_t by)
{
    for (n = tree->nodes[n].parent; n != WF_QUAD_NONE; n = tree->nodes[n].parent)
        tree->nodes[n].below += by;
}

static void linkProxy(wfQuadTree *tree, int32_t n, int32_t proxy)
{
    wfQuadNode *node = &tree->nodes[n];
    tree->links[proxy] = (wfQuadLink){ n, node->first, WF_QUAD_NONE };
    if (node->first != WF_QUAD_NONE) tree->links[node->first].previous = proxy;
    node->first = proxy;
    node->count++;
    addBelow(tree, n, 1);
}

static void unlinkProxy(wfQuadTree *tree, int32_t proxy)
{
    wfQuadLink link = tree->links[proxy];
    wfQuadNode *node = &tree->nodes[link.node];
    if (link.previous != WF_QUAD_NONE) tree->links[link.previous].next = link.next;
    else node->first = link.next;
    if (link.next != WF_QUAD_NONE) tree->links[link.next].previous = link.previous;
    node->count--;
    addBelow(tree, link.node, -1);
    tree->links[proxy].node = WF_QUAD_NONE;
}

/* insert into the quad tree */
static void insertUnder(wfQuadTree *tree, int32_t n, int32_t proxy);

static void splitNode(wfQuadTree *tree, int32_t n)
{
    tree->nodes[n].split = true;
    for (int32_t next, p = tree->nodes[n].first; p != WF_QUAD_NONE; p = next) {
        next = tree->links[p].next;
        if (wfQuadSector(tree->nodes[n].centre, tree->bounds[p]) == WF_QUAD_NONE) continue;
        unlinkProxy(tree, p);
        insertUnder(tree, n, p);
    }
}

static void insertUnder(wfQuadTree *tree, int32_t n, int32_t proxy)
{
    while (tree->nodes[n].split) {
        int sector = wfQuadSector(tree->nodes[n].centre, tree->bounds[proxy]);
        if (sector == WF_QUAD_NONE) break;
        int32_t child = childOf(tree, n, sector);
        if (child == WF_QUAD_NONE) break;
        n = child;
    }
    linkProxy(tree, n, proxy);
    const wfQuadNode *node = &tree->nodes[n];
    if (!node->split && node->count > tree->bucket && node->depth < tree->depthLimit)
        splitNode(tree, n);
}

static wfResult checkBounds(const wfQuadTree *tree, int32_t proxy, wfRect r)
{
    if (!tree) return WF_ERROR_NULL;
    if (proxy < 0 || proxy >= tree->proxyCapacity) return WF_ERROR_RANGE;
    if (!wfIsFinite2(r.min) || !wfIsFinite2(r.max)) return WF_ERROR_NOT_FINITE;
    return r.min.x > r.max.x || r.min.y > r.max.y ? WF_ERROR_RANGE : WF_OK;
}

wfResult wfQuadTreeInsert(wfQuadTree *tree, int32_t proxy, wfRect bounds)
{
    wfResult result = checkBounds(tree, proxy, bounds);
    if (result != WF_OK) return result;
    if (tree->links[proxy].node != WF_QUAD_NONE) return WF_ERROR_RANGE;
    tree->bounds[proxy] = bounds;
    tree->count++;
    insertUnder(tree, 0, proxy);
    return WF_OK;
}

/* remove from the quad tree */
static void freeEmptyNodes(wfQuadTree *tree, int32_t n)
{
    for (;;) {
        wfQuadNode *node = &tree->nodes[n];
        int32_t parent = node->parent;
        if (node->below == 0 && node->count <= tree->bucket) node->split = false;
        if (parent == WF_QUAD_NONE || node->count > 0 || node->below > 0) return;
        giveNode(tree, n);
        n = parent;
    }
}

wfResult wfQuadTreeRemove(wfQuadTree *tree, int32_t proxy)
{
    int32_t n = wfQuadTreeNodeOf(tree, proxy);
    if (n == WF_QUAD_NONE) return WF_ERROR_RANGE;
    unlinkProxy(tree, proxy);
    freeEmptyNodes(tree, n);
    tree->count--;
    return WF_OK;
}

wfResult wfQuadTreeMove(wfQuadTree *tree, int32_t proxy, wfRect bounds)
{
    wfResult result = checkBounds(tree, proxy, bounds);
    if (result == WF_OK) result = wfQuadTreeRemove(tree, proxy);
    return result != WF_OK ? result : wfQuadTreeInsert(tree, proxy, bounds);
}

/* make the quad tree */
static wfResult checkDef(const wfQuadTreeDef *def)
{
    if (def->proxies < 0 || def->nodes < 1) return WF_ERROR_RANGE;
    if (def->depth < 0 || def->depth > WF_QUAD_MAX_DEPTH) return WF_ERROR_RANGE;
    if (def->bucket < 0) return WF_ERROR_RANGE;
    wfRect r = def->root;
    if (!wfIsFinite2(r.min) || !wfIsFinite2(r.max)) return WF_ERROR_NOT_FINITE;
    return r.min.x > r.max.x || r.min.y > r.max.y ? WF_ERROR_RANGE : WF_OK;
}

static void setUpTree(wfQuadTree *tree, const wfQuadTreeDef *def)
{
    tree->nodeCapacity = def->nodes;
    tree->proxyCapacity = def->proxies;
    tree->depthLimit = def->depth;
    tree->bucket = def->bucket;
    tree->nodeHigh = 1;
    tree->freeNode = WF_QUAD_NONE;
    wfVec2 low = wfScale(0.5f, def->root.min), high = wfScale(0.5f, def->root.max);
    clearNode(&tree->nodes[0], wfAdd(low, high), wfSub(high, low));
    for (int32_t i = 0; i < def->proxies; i++) tree->links[i].node = WF_QUAD_NONE;
}

wfResult wfQuadTreeInit(wfQuadTree *tree, wfPool *pool, const wfQuadTreeDef *def)
{
    if (!tree || !pool || !def) return WF_ERROR_NULL;
    wfResult result = checkDef(def);
    if (result != WF_OK) return result;
    size_t mark = wfPoolMark(pool);
    wfQuadTree made = { 0 };
    made.nodes = wfPoolPushArray(pool, (size_t)def->nodes, wfQuadNode);
    made.links = wfPoolPushArray(pool, (size_t)def->proxies, wfQuadLink);
    made.bounds = wfPoolPushArray(pool, (size_t)def->proxies, wfRect);
    if (!made.nodes || !made.links || !made.bounds) {
        wfPoolRewind(pool, mark);
        return WF_ERROR_MEMORY;
    }
    setUpTree(&made, def);
    *tree = made;
    return WF_OK;
}

size_t wfQuadTreeSize(int32_t proxies, int32_t nodes)
{
    size_t n = (size_t)proxies;
    return sizeof(wfQuadNode) * (size_t)nodes + (sizeof(wfQuadLink) + sizeof(wfRect)) * n
         + 3 * WF_POOL_ALIGN;
}

int32_t wfQuadTreeNodes(int32_t proxies)
{
    return proxies + 4 * WF_QUAD_MAX_DEPTH;
}

static wfRect commonBounds(const wfProxies *in)
{
    wfRect all = { { { 0, 0 } }, { { 0, 0 } } };
    bool first = true;
    for (int32_t i = 0; i < in->count; i++) {
        if (!(in->flags[i] & WF_PROXY_LIVE)) continue;
        all = first ? in->bounds[i] : wfRectUnion(all, in->bounds[i]);
        first = false;
    }
    return all;
}

wfResult wfQuadTreeBuild(wfQuadTree *tree, wfPool *pool, const wfProxies *in)
{
    if (!tree || !pool || !in) return WF_ERROR_NULL;
    wfQuadTreeDef def = { commonBounds(in), in->count, wfQuadTreeNodes(in->count),
                          WF_QUAD_MAX_DEPTH, WF_QUAD_BUCKET };
    wfResult result = wfQuadTreeInit(tree, pool, &def);
    for (int32_t i = 0; result == WF_OK && i < in->count; i++)
        if (in->flags[i] & WF_PROXY_LIVE) result = wfQuadTreeInsert(tree, i, in->bounds[i]);
    return result;
}

/* look at the quad tree */
int32_t wfQuadTreeNodeOf(const wfQuadTree *tree, int32_t proxy)
{
    if (!tree || proxy < 0 || proxy >= tree->proxyCapacity) return WF_QUAD_NONE;
    return tree->links[proxy].node;
}

bool wfQuadTreeUses(const wfQuadTree *tree, int32_t node)
{
    return node >= 0 && node < tree->nodeHigh && tree->nodes[node].depth != WF_QUAD_NONE;
}

wfRect wfQuadTreeRect(const wfQuadTree *tree, int32_t node)
{
    const wfQuadNode *n = &tree->nodes[node];
    wfRect r = { wfSub(n->centre, n->half), wfAdd(n->centre, n->half) };
    return r;
}

int wfQuadTreePath(const wfQuadTree *tree, int32_t node, int32_t *sectors)
{
    int depth = tree->nodes[node].depth;
    for (int i = depth; i > 0; node = tree->nodes[node].parent)
        sectors[--i] = tree->nodes[node].sector;
    return depth;
}

/* find pairs in the quad tree */
static bool offerPair(const wfQuadTree *tree, const wfProxies *in, int32_t a, int32_t b,
                      wfPairList *out)
{
    if (in && !wfPairWanted(in, a, b)) return true;
    out->tests++;
    if (!wfRectOverlap(tree->bounds[a], tree->bounds[b])) return true;
    return wfPushPair(out, a, b);
}

/* offers proxy a together with each proxy of a list */
static bool offerList(const wfQuadTree *tree, const wfProxies *in, int32_t a,
                      int32_t first, wfPairList *out)
{
    for (int32_t b = first; b != WF_QUAD_NONE; b = tree->links[b].next)
        if (!offerPair(tree, in, a, b, out)) return false;
    return true;
}

static bool pairsAbove(const wfQuadTree *tree, const wfProxies *in, int32_t a,
                       wfPairList *out)
{
    int32_t n = tree->nodes[tree->links[a].node].parent;
    for (; n != WF_QUAD_NONE; n = tree->nodes[n].parent)
        if (!offerList(tree, in, a, tree->nodes[n].first, out)) return false;
    return true;
}

int wfQuadTreeReach(const wfQuadTree *tree, int32_t n, wfRect r, int32_t *reached)
{
    const wfQuadNode *node = &tree->nodes[n];
    /* eq:broad-reach */
    bool across[] = { r.min.x < node->centre.x, r.max.x > node->centre.x };
    bool along[] = { r.min.y < node->centre.y, r.max.y > node->centre.y };
    int count = 0;
    for (int s = 0; s < 4; s++)
        if (node->child[s] != WF_QUAD_NONE && across[s & 1] && along[s >> 1])
            reached[count++] = node->child[s];
    return count;
}

static bool pairsBelow(const wfQuadTree *tree, const wfProxies *in, int32_t a,
                       wfPairList *out)
{
    int32_t stack[WF_QUAD_STACK];
    wfRect r = tree->bounds[a];
    int size = wfQuadTreeReach(tree, tree->links[a].node, r, stack);
    while (size > 0) {
        int32_t n = stack[--size];
        if (!offerList(tree, in, a, tree->nodes[n].first, out)) return false;
        size += wfQuadTreeReach(tree, n, r, stack + size);
    }
    return true;
}

wfResult wfQuadTreePairs(const wfQuadTree *tree, wfQuadReach reach, const wfProxies *in,
                         wfPairList *out)
{
    if (!tree || !out) return WF_ERROR_NULL;
    bool room = true;
    for (int32_t n = 0; room && n < tree->nodeHigh; n++) {
        if (!wfQuadTreeUses(tree, n)) continue;
        int32_t a = tree->nodes[n].first;
        for (; room && a != WF_QUAD_NONE; a = tree->links[a].next) {
            room = offerList(tree, in, a, tree->links[a].next, out);
            if (room && reach == WF_QUAD_CLIMB) room = pairsAbove(tree, in, a, out);
            if (room && reach == WF_QUAD_DESCEND) room = pairsBelow(tree, in, a, out);
        }
    }
    if (room) return WF_OK;
    out->count = 0;
    return WF_ERROR_FULL;
}

/* the row of the quad tree */
size_t wfQuadIndexSize(int32_t proxies)
{
    return sizeof(wfQuadTree) + wfQuadTreeSize(proxies, wfQuadTreeNodes(proxies));
}

static wfQuadTree openTree(const wfProxies *in, const void *index)
{
    wfPool pool = wfOpenIndex(index, wfQuadIndexSize(in->count));
    wfQuadTree tree = *wfPoolPushStruct(&pool, wfQuadTree);
    tree.nodes = wfPoolPushArray(&pool, tree.nodeCapacity, wfQuadNode);
    tree.links = wfPoolPushArray(&pool, tree.proxyCapacity, wfQuadLink);
    tree.bounds = wfPoolPushArray(&pool, tree.proxyCapacity, wfRect);
    return tree;
}

wfResult wfQuadUpdate(const wfProxies *in, void *index, size_t bytes, wfPool *scratch)
{
    (void)scratch;
    wfPool pool = wfOpenIndex(index, bytes);
    wfQuadTree *head = wfPoolPushStruct(&pool, wfQuadTree), tree;
    if (!head) return WF_ERROR_MEMORY;
    wfResult result = wfQuadTreeBuild(&tree, &pool, in);
    if (result != WF_OK) return result;
    tree.nodes = NULL, tree.links = NULL, tree.bounds = NULL;
    *head = tree;
    return WF_OK;
}

wfResult wfQuadPairs(const wfProxies *in, const void *index, wfPool *scratch,
                     wfPairList *out)
{
    wfQuadTree tree = openTree(in, index);
    out->count = 0;
    out->tests = 0;
    wfResult result = wfQuadTreePairs(&tree, WF_QUAD_DESCEND, in, out);
    if (result == WF_OK) result = wfSortPairs(out, in->count, scratch);
    if (result != WF_OK) out->count = 0;
    return result;
}

size_t wfQuadScratch(int32_t proxies, int32_t pairs)
{
    return wfQuadIndexSize(proxies) + wfSortPairsSize(proxies, pairs) + WF_POOL_ALIGN;
}

void wfQuadQuery(const wfProxies *in, const void *index, wfRect area, wfVisitFn *visit,
                 void *context)
{
    wfQuadTree t = openTree(in, index);
    int32_t stack[WF_QUAD_STACK];
    int size = 1;
    stack[0] = 0;
    while (size > 0) {
        int32_t n = stack[--size];
        for (int32_t p = t.nodes[n].first; p != WF_QUAD_NONE; p = t.links[p].next)
            if (wfRectOverlap(t.bounds[p], area) && !visit(context, p)) return;
        size += wfQuadTreeReach(&t, n, area, stack + size);
    }
}

typedef struct QuadPlace { int32_t node; wfRect region; } QuadPlace;

/* puts the children whose regions the cast meets on the stack, the nearest last */
static int castReach(const wfQuadTree *t, QuadPlace at, const wfBoxCast *cast,
                     QuadPlace *stack)
{
    const wfQuadNode *node = &t->nodes[at.node];
    int nearest = (cast->by.x < 0) | (cast->by.y < 0) << 1, count = 0;
    for (int k = 3; k >= 0; k--) {
        int s = nearest ^ k;
        QuadPlace down = { node->child[s], at.region };
        if (down.node == WF_QUAD_NONE) continue;
        if (s & 1) down.region.min.x = node->centre.x;
        else down.region.max.x = node->centre.x;
        if (s & 2) down.region.min.y = node->centre.y;
        else down.region.max.y = node->centre.y;
        wfReal enter;
        if (wfCastMeets(cast, down.region, &enter)) stack[count++] = down;
    }
    return count;
}

void wfQuadCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                wfCastVisitFn *visit, void *context)
{
    wfQuadTree t = openTree(in, index);
    wfBoxCast c = *cast;
    wfRect all = { wfV2(-WF_HUGE, -WF_HUGE), wfV2(WF_HUGE, WF_HUGE) };
    QuadPlace stack[WF_QUAD_STACK] = { { 0, all } };
    int size = 1;
    while (size > 0) {
        QuadPlace at = stack[--size];
        for (int32_t p = t.nodes[at.node].first; p != WF_QUAD_NONE; p = t.links[p].next)
            if (!wfOfferCast(in, &c, p, visit, context)) return;
        size += castReach(&t, at, &c, stack + size);
    }
}

void wfQuadBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                 void *context)
{
    wfQuadTree t = openTree(in, index);
    int32_t stack[WF_QUAD_STACK] = { 0 };
    for (int size = 1; size > 0;) {
        int32_t n = stack[--size];
        const wfQuadNode *node = &t.nodes[n];
        wfIndexBox box = { wfQuadTreeRect(&t, n), node->depth, node->count };
        if (!visit(context, &box)) return;
        for (int k = 3; k >= 0; k--)
            if (node->child[k] != WF_QUAD_NONE) stack[size++] = node->child[k];
    }
}
