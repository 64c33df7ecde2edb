/* Weft: collision/dynamictree.c, tangled from chapters/engine/11-broad-phase.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/dynamic_tree.h"

/* make a box fat */
wfRect wfFatBox(wfRect r, wfVec2 way, wfReal ratio)
{
    wfReal w = wfMaxR(r.max.x - r.min.x, r.max.y - r.min.y);
    wfReal v = wfMaxR(wfAbs(way.x), wfAbs(way.y));
    wfRect fat = wfRectGrow(r, w / 64);
    if (v > 0) {
        wfReal ahead = wfSqrt(wfMinR(v / w, 1) * ratio) * (w / v);   /* eq:broad-fat: f/v */
        wfVec2 by = wfScale(ahead, way);
        fat.min = wfAdd(fat.min, wfMin2(by, wfV2(0, 0)));
        fat.max = wfAdd(fat.max, wfMax2(by, wfV2(0, 0)));
    }
    bool good = wfIsFinite2(fat.min) && wfIsFinite2(fat.max) && wfRectContains(fat, r);
    return good ? fat : r;
}

/* lay out the dynamic tree */
size_t wfTreeSize(int32_t capacity)
{
    size_t n = (size_t)capacity;
    size_t each = 2 * sizeof(wfTreeNode) + sizeof(wfTreePlace);
    return sizeof(wfTreeHead) + n * (each + WF_TREE_NEAR * sizeof(wfPair))
         + 4 * WF_POOL_ALIGN;
}

static wfTree lay_tree(void *block, int32_t capacity)
{
    wfPool pool = wfOpenIndex(block, wfTreeSize(capacity));
    wfTree tree = { .head = wfPoolPushStruct(&pool, wfTreeHead) };
    tree.nodes = wfPoolPushArray(&pool, 2 * (size_t)capacity, wfTreeNode);
    tree.places = wfPoolPushArray(&pool, capacity, wfTreePlace);
    tree.overlaps = wfPoolPushArray(&pool, WF_TREE_NEAR * (size_t)capacity, wfPair);
    return tree;
}

wfTree wfTreeOpen(const void *block)
{
    return lay_tree((void *)block, ((const wfTreeHead *)block)->capacity);
}

static void empty_tree(wfTree *tree, int32_t capacity)
{
    *tree->head = (wfTreeHead){ .capacity = capacity, .root = WF_TREE_NONE,
                                .freeNode = capacity, .nearCount = WF_TREE_NONE };
    for (int32_t n = 0; n < 2 * capacity; n++) {
        bool leaf = n < capacity;
        int32_t next = n + 1 < 2 * capacity ? n + 1 : WF_TREE_NONE;
        tree->nodes[n] = (wfTreeNode){ .parent = leaf ? WF_TREE_OUT : next,
                                       .left = WF_TREE_NONE, .right = WF_TREE_NONE };
    }
}

wfResult wfTreeInit(wfTree *tree, void *block, size_t bytes, int32_t capacity)
{
    if (!tree || !block) return WF_ERROR_NULL;
    if (capacity < 1 || capacity > INT32_MAX / 2) return WF_ERROR_RANGE;
    if (bytes < wfTreeSize(capacity)) return WF_ERROR_MEMORY;
    if ((uintptr_t)block % WF_POOL_ALIGN != 0) return WF_ERROR_MEMORY;
    *tree = lay_tree(block, capacity);
    empty_tree(tree, capacity);
    return WF_OK;
}

/* choose a sibling */
static wfReal outline(wfRect r) { return r.max.x - r.min.x + (r.max.y - r.min.y); }

static bool is_leaf(const wfTreeNode *node) { return node->left == WF_TREE_NONE; }

static wfReal growth(const wfTreeNode *c, wfRect box)                 /* eq:broad-growth */
{
    wfReal joined = outline(wfRectUnion(c->box, box));
    return is_leaf(c) ? joined : joined - outline(c->box) + outline(box);
}

static int32_t choose_sibling(const wfTree *tree, int32_t n, wfRect box)
{
    for (;;) {
        const wfTreeNode *node = &tree->nodes[n];
        if (is_leaf(node)) return n;
        const wfTreeNode *l = &tree->nodes[node->left], *r = &tree->nodes[node->right];
        wfReal gl = growth(l, box), gr = growth(r, box);
        if (wfMinR(gl, gr) > outline(node->box)) return n;     /* eq:broad-descend-rule */
        bool right = gr < gl || (gr == gl && r->leaves < l->leaves);
        n = right ? node->right : node->left;
    }
}

/* puts a node's box and counts right, from its children */
static void refit(wfTree *tree, int32_t n)
{
    wfTreeNode *node = &tree->nodes[n];
    const wfTreeNode *l = &tree->nodes[node->left], *r = &tree->nodes[node->right];
    node->box = wfRectUnion(l->box, r->box);
    node->leaves = l->leaves + r->leaves;
    node->movers = l->movers + r->movers;
}

static void replace_child(wfTree *tree, int32_t parent, int32_t old, int32_t child)
{
    wfTreeNode *node = &tree->nodes[parent];
    if (node->left == old) node->left = child;
    else node->right = child;
    tree->nodes[child].parent = parent;
}

/* how much smaller the group gets if `child`, its sibling, changes places with `out` */
static wfReal swap_gain(const wfTree *tree, int32_t child, int32_t group, int32_t out)
{
    const wfTreeNode *g = &tree->nodes[group];
    int32_t stays = g->left == out ? g->right : g->left;
    wfRect made = wfRectUnion(tree->nodes[child].box, tree->nodes[stays].box);
    return outline(g->box) - outline(made);
}

static void rotate(wfTree *tree, int32_t n)
{
    const wfTreeNode *node = &tree->nodes[n];
    int32_t pair[2] = { node->left, node->right }, child = -1, group = -1, out = -1;
    wfReal best = 0;
    for (int k = 0; k < 2; k++) {
        const wfTreeNode *g = &tree->nodes[pair[1 - k]];
        int32_t inside[2] = { g->left, g->right };
        for (int j = 0; j < 2 && !is_leaf(g); j++) {
            wfReal gain = swap_gain(tree, pair[k], pair[1 - k], inside[j]);
            if (!(gain > best)) continue;
            best = gain, child = pair[k], group = pair[1 - k], out = inside[j];
        }
    }
    if (child < 0) return;
    replace_child(tree, n, child, out);
    replace_child(tree, group, out, child);
    refit(tree, group);
}

static void refit_up(wfTree *tree, int32_t n)
{
    for (; n != WF_TREE_NONE; n = tree->nodes[n].parent) {
        refit(tree, n);
        rotate(tree, n);
    }
}

/* put in and take out */
static void insert_leaf(wfTree *tree, int32_t leaf, int32_t from)
{
    wfTreeHead *h = tree->head;
    wfTreeNode *nodes = tree->nodes;
    if (h->root == WF_TREE_NONE) {
        nodes[leaf].parent = WF_TREE_NONE;
        h->root = leaf;
        return;
    }
    int32_t sibling = choose_sibling(tree, from, nodes[leaf].box);
    int32_t parent = nodes[sibling].parent, made = h->freeNode;
    h->freeNode = nodes[made].parent;
    nodes[made].parent = parent;
    if (parent == WF_TREE_NONE) h->root = made;
    else replace_child(tree, parent, sibling, made);
    nodes[made].left = sibling;
    nodes[made].right = leaf;
    nodes[sibling].parent = made;
    nodes[leaf].parent = made;
    refit_up(tree, made);
}

/* takes a leaf out, returns the node from which on everything has to be put right */
static int32_t unlink_leaf(wfTree *tree, int32_t leaf)
{
    wfTreeHead *h = tree->head;
    wfTreeNode *nodes = tree->nodes;
    int32_t parent = nodes[leaf].parent;
    nodes[leaf].parent = WF_TREE_OUT;
    if (parent == WF_TREE_NONE) {
        h->root = WF_TREE_NONE;
        return WF_TREE_NONE;
    }
    wfTreeNode *p = &nodes[parent];
    int32_t sibling = p->left == leaf ? p->right : p->left, above = p->parent;
    if (above == WF_TREE_NONE) {
        h->root = sibling;
        nodes[sibling].parent = WF_TREE_NONE;
    } else {
        replace_child(tree, above, parent, sibling);
    }
    *p = (wfTreeNode){ .parent = h->freeNode, .left = WF_TREE_NONE, .right = WF_TREE_NONE };
    h->freeNode = parent;
    return above;
}

static void move_leaf(wfTree *tree, int32_t leaf, wfRect box)
{
    int32_t above = unlink_leaf(tree, leaf), from = above;
    tree->nodes[leaf].box = box;
    refit_up(tree, above);
    while (from != WF_TREE_NONE && !wfRectContains(tree->nodes[from].box, box))
        from = tree->nodes[from].parent;
    insert_leaf(tree, leaf, from == WF_TREE_NONE ? tree->head->root : from);
    tree->head->changes++;
}

static bool is_proxy(const wfTree *tree, int32_t proxy)
{
    return proxy >= 0 && proxy < tree->head->capacity;
}

bool wfTreeHolds(const wfTree *tree, int32_t proxy)
{
    return tree && is_proxy(tree, proxy) && tree->nodes[proxy].parent != WF_TREE_OUT;
}

static wfResult check_box(const wfTree *tree, int32_t proxy, wfRect r, bool in)
{
    if (!tree) return WF_ERROR_NULL;
    if (!is_proxy(tree, proxy) || wfTreeHolds(tree, proxy) != in) return WF_ERROR_RANGE;
    if (!wfIsFinite2(r.min) || !wfIsFinite2(r.max)) return WF_ERROR_NOT_FINITE;
    return r.min.x > r.max.x || r.min.y > r.max.y ? WF_ERROR_RANGE : WF_OK;
}

wfResult wfTreeInsert(wfTree *tree, int32_t proxy, wfRect box, bool moves)
{
    wfResult result = check_box(tree, proxy, box, false);
    if (result != WF_OK) return result;
    tree->nodes[proxy] = (wfTreeNode){ .box = box, .left = WF_TREE_NONE,
                                       .right = WF_TREE_NONE, .leaves = 1,
                                       .movers = moves ? 1 : 0 };
    tree->places[proxy] = (wfTreePlace){ box.min, tree->head->step };
    insert_leaf(tree, proxy, tree->head->root);
    if (tree->head->high <= proxy) tree->head->high = proxy + 1;
    tree->head->count++;
    tree->head->changes++;
    return WF_OK;
}

wfResult wfTreeRemove(wfTree *tree, int32_t proxy)
{
    if (!tree) return WF_ERROR_NULL;
    if (!wfTreeHolds(tree, proxy)) return WF_ERROR_RANGE;
    refit_up(tree, unlink_leaf(tree, proxy));
    tree->head->count--;
    tree->head->changes++;
    return WF_OK;
}

wfResult wfTreeMove(wfTree *tree, int32_t proxy, wfRect box)
{
    wfResult result = check_box(tree, proxy, box, true);
    if (result == WF_OK) move_leaf(tree, proxy, box);
    return result;
}

/* climb to the node after another */
static int32_t node_after(const wfTree *tree, int32_t n)
{
    for (int32_t up = tree->nodes[n].parent; up != WF_TREE_NONE;) {
        if (tree->nodes[up].left == n) return tree->nodes[up].right;
        n = up;
        up = tree->nodes[n].parent;
    }
    return WF_TREE_NONE;
}

/* keep near pairs */
static bool is_new(const wfTree *tree, int32_t leaf)
{
    return tree->places[leaf].step == tree->head->step;
}

/* strikes the pairs of leaves that have another box in this step, or are gone */
static void strike_near(wfTree *tree)
{
    int32_t kept = 0;
    for (int32_t i = 0; i < tree->head->nearCount; i++) {
        wfPair p = tree->overlaps[i];
        if (is_new(tree, p.a) || is_new(tree, p.b)) continue;
        if (!wfTreeHolds(tree, p.a) || !wfTreeHolds(tree, p.b)) continue;
        tree->overlaps[kept++] = p;
    }
    tree->head->nearCount = kept;
}

/* adds the near pairs of a leaf; false: no room */
static bool add_near(const wfTree *tree, int32_t leaf, bool allNew, wfPairList *out)
{
    const wfTreeNode *l = &tree->nodes[leaf];
    for (int32_t n = tree->head->root; n != WF_TREE_NONE;) {
        const wfTreeNode *node = &tree->nodes[n];
        bool met = node->movers + l->movers > 0 && wfRectOverlap(node->box, l->box);
        if (met && !is_leaf(node)) {
            n = node->left;
            continue;
        }
        bool mine = n > leaf || (n < leaf && !allNew && !is_new(tree, n));
        if (met && mine && !wfPushPair(out, leaf, n)) return false;
        n = node_after(tree, n);
    }
    return true;
}

static bool merge_near(wfTree *tree, wfPairList *more, int32_t proxies, wfPool *scratch)
{
    size_t mark = wfPoolMark(scratch);
    bool room = wfSortPairs(more, proxies, scratch) == WF_OK;
    wfPair *copy = wfPoolPushArray(scratch, more->count, wfPair);
    room = room && (copy != NULL || more->count == 0);
    int32_t i = tree->head->nearCount - 1, k = room ? more->count - 1 : -1;
    for (int32_t m = 0; m <= k; m++) copy[m] = more->pairs[m];
    for (int32_t to = i + k + 1; k >= 0; to--) {
        bool old = i >= 0 && wfPairPrecedes(copy[k], tree->overlaps[i]);
        tree->overlaps[to] = old ? tree->overlaps[i--] : copy[k--];
    }
    tree->head->nearCount += more->count;
    wfPoolRewind(scratch, mark);
    return room;
}

static void keep_near(wfTree *tree, bool begin, int32_t proxies, wfPool *scratch)
{
    wfTreeHead *h = tree->head;
    if (begin) h->nearCount = 0;
    else strike_near(tree);
    wfPairList more = { .pairs = tree->overlaps + h->nearCount,
                        .capacity = WF_TREE_NEAR * proxies - h->nearCount };
    bool room = true;
    for (int32_t i = 0; room && i < proxies; i++)
        if (wfTreeHolds(tree, i) && (begin || is_new(tree, i)))
            room = add_near(tree, i, begin, &more);
    room = room && merge_near(tree, &more, proxies, scratch);
    h->nearChanges = h->changes;
    if (room) return;
    h->nearCount = WF_TREE_NONE;
    h->nearChanges += h->count;
}

/* update the dynamic tree */
static void update_leaf(wfTree *tree, const wfProxies *in, int32_t i)
{
    wfTreeNode *leaf = &tree->nodes[i];
    bool holds = leaf->parent != WF_TREE_OUT;
    int flags = i < in->count ? in->flags[i] : 0, moves = (flags & WF_PROXY_MOVES) != 0;
    bool stays = holds && (flags & WF_PROXY_LIVE) && leaf->movers == moves;
    if (stays && wfRectContains(leaf->box, in->bounds[i])) return;
    if (holds && !stays) wfTreeRemove(tree, i);
    if (!(flags & WF_PROXY_LIVE)) return;
    wfRect r = in->bounds[i];
    wfTreePlace *place = &tree->places[i], now = { r.min, tree->head->step };
    if (stays) {
        wfReal steps = (wfReal)(now.step - place->step);
        wfVec2 way = wfScale(1 / steps, wfSub(r.min, place->at));
        move_leaf(tree, i, wfFatBox(r, way, WF_TREE_RATIO));
    } else {
        wfTreeInsert(tree, i, wfFatBox(r, wfV2(0, 0), WF_TREE_RATIO), moves);
    }
    *place = now;
}

static int32_t in_use(const wfTree *tree, int32_t proxies)
{
    int32_t high = tree->head->high, most = tree->head->capacity;
    high = high > proxies ? high : proxies;
    return high < most ? high : most;
}

void wfTreeCopy(void *to, const void *from, int32_t proxies)
{
    wfTree old = wfTreeOpen(from), made = lay_tree(to, old.head->capacity);
    int32_t capacity = old.head->capacity, near = old.head->nearCount;
    size_t n = (size_t)in_use(&old, proxies);
    *made.head = *old.head;
    memcpy(made.nodes, old.nodes, n * sizeof *old.nodes);
    memcpy(made.nodes + capacity, old.nodes + capacity, n * sizeof *old.nodes);
    memcpy(made.places, old.places, n * sizeof *old.places);
    memcpy(made.overlaps, old.overlaps,
           (size_t)(near > 0 ? near : 0) * sizeof *old.overlaps);
}

wfResult wfTreeUpdate(const wfProxies *in, void *index, size_t bytes, wfPool *scratch)
{
    size_t each = wfTreeSize(1) - wfTreeSize(0);
    if (bytes < wfTreeSize(1) || bytes < wfTreeSize(in->count)) return WF_ERROR_MEMORY;
    size_t fits = (bytes - wfTreeSize(0)) / each;
    int32_t capacity = fits < INT32_MAX / 2 ? (int32_t)fits : INT32_MAX / 2;
    wfTree tree;
    if (((const wfTreeHead *)index)->capacity == capacity) tree = wfTreeOpen(index);
    else wfTreeInit(&tree, index, bytes, capacity);
    tree.head->step++;
    int64_t before = tree.head->changes;
    bool has = wfTreeHasNear(&tree);
    for (int32_t i = 0, n = in_use(&tree, in->count); i < n; i++) update_leaf(&tree, in, i);
    int64_t changed = tree.head->changes - before;      /* keep near pairs, if it pays */
    bool little = changed * (has ? 4 : 16) <= tree.head->count;
    bool again = tree.head->changes >= tree.head->nearChanges;
    if (!little) tree.head->nearCount = WF_TREE_NONE;
    else if (has ? changed > 0 : again) keep_near(&tree, !has, in->count, scratch);
    return WF_OK;
}

size_t wfTreeIndexSize(int32_t proxies) { return wfTreeSize(proxies > 0 ? proxies : 1); }

/* find pairs in the dynamic tree */
typedef struct TreeWalk {
    const wfProxies *in;
    wfTree tree;
    wfPair *stack;
    int32_t size;
    wfPairList *out;
} TreeWalk;

/* false: the list of pairs is full */
static bool push_nodes(TreeWalk *w, int32_t a, int32_t b)
{
    const wfTreeNode *p = &w->tree.nodes[a], *q = &w->tree.nodes[b];
    if (p->movers + q->movers == 0) return true;
    if (is_leaf(p) && is_leaf(q))
        return wfOfferPair(w->in, w->out, w->in->bounds[a], a, w->in->bounds[b], b);
    w->out->tests++;
    if (wfRectOverlap(p->box, q->box)) w->stack[w->size++] = (wfPair){ a, b };
    return true;
}

static void push_node(TreeWalk *w, int32_t a)
{
    const wfTreeNode *p = &w->tree.nodes[a];
    if (p->movers > 0 && !is_leaf(p)) w->stack[w->size++] = (wfPair){ a, a };
}

static bool split_nodes(TreeWalk *w, int32_t a, int32_t b)
{
    const wfTreeNode *p = &w->tree.nodes[a], *q = &w->tree.nodes[b];
    if (a == b) {
        push_node(w, p->left);
        push_node(w, p->right);
        return push_nodes(w, p->left, p->right);
    }
    if (is_leaf(q) || (!is_leaf(p) && p->leaves >= q->leaves))
        return push_nodes(w, p->left, b) && push_nodes(w, p->right, b);
    return push_nodes(w, a, q->left) && push_nodes(w, a, q->right);
}

static wfResult walk_for_pairs(const wfTree *tree, const wfProxies *in, wfPool *scratch,
                               wfPairList *out)
{
    size_t mark = wfPoolMark(scratch);
    TreeWalk w = { .in = in, .tree = *tree, .out = out };
    w.stack = wfPoolPushArray(scratch, 3 * (size_t)in->count + 8, wfPair);
    if (!w.stack) return WF_ERROR_MEMORY;
    int32_t root = w.tree.head->root;
    if (root != WF_TREE_NONE) push_node(&w, root);
    bool room = true;
    while (room && w.size > 0) {
        wfPair top = w.stack[--w.size];
        room = split_nodes(&w, top.a, top.b);
    }
    wfPoolRewind(scratch, mark);
    return wfFinishPairs(room, in->count, scratch, mark, out);
}

static bool offer_near(const wfTree *tree, const wfProxies *in, wfPairList *out)
{
    bool room = true;
    for (int32_t i = 0; room && i < tree->head->nearCount; i++) {
        int32_t a = tree->overlaps[i].a, b = tree->overlaps[i].b;
        room = wfOfferPair(in, out, in->bounds[a], a, in->bounds[b], b);
    }
    if (!room) out->count = 0;
    return room;
}

wfResult wfTreePairs(const wfProxies *in, const void *index, wfPool *scratch,
                     wfPairList *out)
{
    wfTree tree = wfTreeOpen(index);
    out->count = 0;
    out->tests = 0;
    if (!wfTreeHasNear(&tree)) return walk_for_pairs(&tree, in, scratch, out);
    return offer_near(&tree, in, out) ? WF_OK : WF_ERROR_FULL;
}

size_t wfTreeScratch(int32_t proxies, int32_t pairs)
{
    size_t stack = (3 * (size_t)proxies + 8) * sizeof(wfPair) + WF_POOL_ALIGN;
    size_t sort = wfSortPairsSize(proxies, pairs);
    return wfTreeIndexSize(proxies) + WF_POOL_ALIGN + (stack > sort ? stack : sort);
}

/* the first child of a node for a cast along `by` (0: the left one) */
static int32_t first_child(const wfTree *t, int32_t n, wfVec2 by)
{
    const wfTreeNode *node = &t->nodes[n];
    wfRect l = t->nodes[node->left].box, r = t->nodes[node->right].box;
    wfVec2 apart = wfSub(wfAdd(wfScale(WF_R(0.5), l.min), wfScale(WF_R(0.5), l.max)),
                         wfAdd(wfScale(WF_R(0.5), r.min), wfScale(WF_R(0.5), r.max)));
    return wfDot(apart, by) > 0 ? node->right : node->left;
}

/* the node after n and all that is under it; WF_TREE_NONE at the end */
static int32_t next_node(const wfTree *t, int32_t n, wfVec2 by)
{
    for (;;) {
        int32_t parent = t->nodes[n].parent;
        if (parent == WF_TREE_NONE) return WF_TREE_NONE;
        const wfTreeNode *p = &t->nodes[parent];
        if (first_child(t, parent, by) == n) return p->left == n ? p->right : p->left;
        n = parent;
    }
}

void wfTreeQuery(const wfProxies *in, const void *index, wfRect area, wfVisitFn *visit,
                 void *context)
{
    wfTree t = wfTreeOpen(index);
    for (int32_t n = t.head->root; n != WF_TREE_NONE;) {
        const wfTreeNode *node = &t.nodes[n];
        bool asked = !in->stillAsked || node->movers < node->leaves;
        bool leaf = is_leaf(node), met = asked && wfRectOverlap(node->box, area);
        if (met && !leaf) {
            n = node->left;
            continue;
        }
        if (met && wfRectOverlap(in->bounds[n], area) && !visit(context, n)) return;
        n = node_after(&t, n);
    }
}

void wfTreeCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                wfCastVisitFn *visit, void *context)
{
    wfTree t = wfTreeOpen(index);
    wfBoxCast c = *cast;
    for (int32_t n = t.head->root; n != WF_TREE_NONE;) {
        const wfTreeNode *node = &t.nodes[n];
        wfReal enter;
        bool leaf = is_leaf(node), met = wfCastMeets(&c, node->box, &enter);
        if (met && !leaf) {
            n = first_child(&t, n, c.by);
            continue;
        }
        if (met && !wfOfferCast(in, &c, n, visit, context)) return;
        n = next_node(&t, n, c.by);
    }
}

/* A node's depth is counted on the way up to the root: only a picture asks. */
void wfTreeBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                 void *context)
{
    (void)in;
    wfTree t = wfTreeOpen(index);
    for (int32_t n = t.head->root; n != WF_TREE_NONE;) {
        const wfTreeNode *node = &t.nodes[n];
        wfIndexBox box = { node->box, 0, is_leaf(node) ? 1 : 0 };
        for (int32_t p = node->parent; p != WF_TREE_NONE; p = t.nodes[p].parent)
            box.depth++;
        if (!visit(context, &box)) return;
        n = is_leaf(node) ? node_after(&t, n) : node->left;
    }
}

int32_t wfTreeDepth(const wfTree *tree)
{
    int32_t deepest = 0;
    for (int32_t i = 0; i < tree->head->capacity; i++) {
        int32_t depth = 0, n = tree->nodes[i].parent;
        if (n == WF_TREE_OUT) continue;
        for (; n != WF_TREE_NONE; n = tree->nodes[n].parent) depth++;
        if (depth > deepest) deepest = depth;
    }
    return deepest;
}
