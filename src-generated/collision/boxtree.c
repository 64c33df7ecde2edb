/* Weft: collision/boxtree.c, tangled from chapters/methods/06-grids-sweeps-trees.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "weft/broad.h"

/* build a tree of boxes */
static wfRect boxAround(const wfBoxTree *tree, int32_t first, int32_t count)
{
    wfRect box = tree->in->bounds[tree->items[first].index];
    for (int32_t i = first + 1; i < first + count; i++)
        box = wfRectUnion(box, tree->in->bounds[tree->items[i].index]);
    return box;
}

int32_t wfBoxTreeBuild(wfBoxTree *tree, int32_t first, int32_t count)
{
    int32_t n = tree->nodeCount++, half = count / 2;
    wfRect box = boxAround(tree, first, count);
    tree->nodes[n] = (wfBoxNode){ box, first, count, WF_BOX_NONE };
    if (count <= WF_BOX_LEAF) return n;
    bool wide = box.max.x - box.min.x >= box.max.y - box.min.y;
    for (int32_t i = first; i < first + count; i++) {
        wfRect r = tree->in->bounds[tree->items[i].index];
        wfVec2 middle = wfAdd(wfScale(0.5f, r.min), wfScale(0.5f, r.max));
        tree->items[i].key = wide ? middle.x : middle.y;
    }
    wfSelectKeyed(tree->items + first, count, half);
    wfBoxTreeBuild(tree, first, half);
    tree->nodes[n].right = wfBoxTreeBuild(tree, first + half, count - half);
    return n;
}

/* find pairs in trees of boxes */
static bool isBoxLeaf(const wfBoxNode *node) { return node->right == WF_BOX_NONE; }

static bool pairsBetween(const wfBoxTree *t, int32_t a, int32_t b, wfPairList *out)
{
    const wfBoxNode *p = &t->nodes[a], *q = &t->nodes[b];
    const wfRect *bounds = t->in->bounds;
    out->tests++;
    if (!wfRectOverlap(p->box, q->box)) return true;
    if (!isBoxLeaf(p) && (isBoxLeaf(q) || p->count >= q->count))
        return pairsBetween(t, a + 1, b, out) && pairsBetween(t, p->right, b, out);
    if (!isBoxLeaf(q))
        return pairsBetween(t, a, b + 1, out) && pairsBetween(t, a, q->right, out);
    for (int32_t i = p->first; i < p->first + p->count; i++) {
        int32_t one = t->items[i].index;
        for (int32_t j = q->first; j < q->first + q->count; j++) {
            int32_t two = t->items[j].index;
            if (!wfOfferPair(t->in, out, bounds[one], one, bounds[two], two)) return false;
        }
    }
    return true;
}

static bool pairsWithin(const wfBoxTree *t, int32_t n, wfPairList *out)
{
    const wfBoxNode *p = &t->nodes[n];
    const wfRect *bounds = t->in->bounds;
    if (!isBoxLeaf(p))
        return pairsWithin(t, n + 1, out) && pairsWithin(t, p->right, out)
            && pairsBetween(t, n + 1, p->right, out);
    for (int32_t i = p->first; i < p->first + p->count; i++) {
        int32_t one = t->items[i].index;
        for (int32_t j = i + 1; j < p->first + p->count; j++) {
            int32_t two = t->items[j].index;
            if (!wfOfferPair(t->in, out, bounds[one], one, bounds[two], two)) return false;
        }
    }
    return true;
}

/* the row of the tree of boxes */
typedef struct BoxHead { int32_t moving, still; } BoxHead;    /* roots, or WF_BOX_NONE */

size_t wfBoxTreeIndexSize(int32_t proxies)
{
    size_t n = (size_t)proxies;
    return sizeof(BoxHead) + n * sizeof(wfKeyed) + (n + 2) * sizeof(wfBoxNode)
         + 3 * WF_POOL_ALIGN;
}

static wfBoxTree openBoxes(const wfProxies *in, const void *index, BoxHead **head)
{
    wfPool pool = wfOpenIndex(index, wfBoxTreeIndexSize(in->count));
    wfBoxTree t = { .in = in };
    *head = wfPoolPushStruct(&pool, BoxHead);
    t.items = wfPoolPushArray(&pool, in->count, wfKeyed);
    t.nodes = wfPoolPushArray(&pool, in->count + 2, wfBoxNode);
    return t;
}

wfResult wfBoxTreeUpdate(const wfProxies *in, void *index, size_t bytes, wfPool *scratch)
{
    BoxHead *head;
    size_t mark = wfPoolMark(scratch);
    if (bytes < wfBoxTreeIndexSize(in->count)) return WF_ERROR_MEMORY;
    int32_t movers = 0, *ids = wfPoolPushArray(scratch, in->count, int32_t);
    if (!ids) return WF_ERROR_MEMORY;
    wfBoxTree t = openBoxes(in, index, &head);
    int32_t live = wfListLive(in, ids, &movers);
    for (int32_t i = 0; i < live; i++) t.items[i].index = ids[i];
    head->moving = head->still = WF_BOX_NONE;
    if (movers > 0) head->moving = wfBoxTreeBuild(&t, 0, movers);
    if (live > movers) head->still = wfBoxTreeBuild(&t, movers, live - movers);
    wfPoolRewind(scratch, mark);
    return WF_OK;
}

wfResult wfBoxTreePairs(const wfProxies *in, const void *index, wfPool *scratch,
                        wfPairList *out)
{
    BoxHead *head;
    wfBoxTree t = openBoxes(in, index, &head);
    out->count = 0;
    out->tests = 0;
    bool anybody = head->moving != WF_BOX_NONE;
    bool room = !anybody || pairsWithin(&t, head->moving, out);
    if (room && anybody && head->still != WF_BOX_NONE)
        room = pairsBetween(&t, head->moving, head->still, out);
    return wfFinishPairs(room, in->count, scratch, wfPoolMark(scratch), out);
}

size_t wfBoxTreeScratch(int32_t proxies, int32_t pairs)
{
    return wfBoxTreeIndexSize(proxies) + WF_POOL_ALIGN + wfSortPairsSize(proxies, pairs);
}

/* ask a tree of boxes */
static bool queryBoxes(const wfBoxTree *t, int32_t n, wfRect area, wfVisitFn *visit,
                       void *context)
{
    const wfBoxNode *node = &t->nodes[n];
    if (!wfRectOverlap(node->box, area)) return true;
    if (!isBoxLeaf(node))
        return queryBoxes(t, n + 1, area, visit, context)
            && queryBoxes(t, node->right, area, visit, context);
    for (int32_t i = node->first; i < node->first + node->count; i++) {
        int32_t p = t->items[i].index;
        if (wfRectOverlap(t->in->bounds[p], area) && !visit(context, p)) return false;
    }
    return true;
}

void wfBoxTreeQuery(const wfProxies *in, const void *index, wfRect area, wfVisitFn *visit,
                    void *context)
{
    BoxHead *head;
    wfBoxTree t = openBoxes(in, index, &head);
    if (head->moving == WF_BOX_NONE || queryBoxes(&t, head->moving, area, visit, context))
        if (head->still != WF_BOX_NONE) queryBoxes(&t, head->still, area, visit, context);
}

static bool castBoxes(const wfBoxTree *t, int32_t n, wfBoxCast *c, wfCastVisitFn *visit,
                      void *context)
{
    const wfBoxNode *node = &t->nodes[n];
    if (!isBoxLeaf(node)) {
        wfReal left, right;
        bool l = wfCastMeets(c, t->nodes[n + 1].box, &left);
        bool r = wfCastMeets(c, t->nodes[node->right].box, &right);
        int32_t first = l && r && right < left ? node->right : n + 1;
        int32_t second = first == n + 1 ? node->right : n + 1;
        return (!l || castBoxes(t, first, c, visit, context))
            && (!r || castBoxes(t, second, c, visit, context));
    }
    for (int32_t i = node->first; i < node->first + node->count; i++)
        if (!wfOfferCast(t->in, c, t->items[i].index, visit, context)) return false;
    return true;
}

void wfBoxTreeCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                   wfCastVisitFn *visit, void *context)
{
    BoxHead *head;
    wfBoxTree t = openBoxes(in, index, &head);
    wfBoxCast c = *cast;
    if (head->still == WF_BOX_NONE || castBoxes(&t, head->still, &c, visit, context))
        if (head->moving != WF_BOX_NONE) castBoxes(&t, head->moving, &c, visit, context);
}

static bool showBoxes(const wfBoxTree *t, int32_t n, int32_t depth, wfBoxVisitFn *visit,
                      void *context)
{
    const wfBoxNode *node = &t->nodes[n];
    bool leaf = isBoxLeaf(node);
    wfIndexBox box = { node->box, depth, leaf ? node->count : 0 };
    return visit(context, &box)
        && (leaf || (showBoxes(t, n + 1, depth + 1, visit, context)
                     && showBoxes(t, node->right, depth + 1, visit, context)));
}

void wfBoxTreeBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                    void *context)
{
    BoxHead *head;
    wfBoxTree t = openBoxes(in, index, &head);
    if (head->moving == WF_BOX_NONE || showBoxes(&t, head->moving, 0, visit, context))
        if (head->still != WF_BOX_NONE) showBoxes(&t, head->still, 0, visit, context);
}
