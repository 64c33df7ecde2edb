/* Weft: collision/boxtree.c, tangled from chapters/methods/06-grids-sweeps-trees.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "weft/broad.h"

/* build a tree of boxes */
static wfRect box_around(const wfBoxTree *tree, int32_t first, int32_t count)
{
    wfRect box = tree->in->bounds[tree->items[first].index];
    for (int32_t i = first + 1; i < first + count; i++)
        box = wfRectUnion(box, tree->in->bounds[tree->items[i].index]);
    return box;
}

int32_t wfBoxTreeBuild(wfBoxTree *tree, int32_t first, int32_t count)
{
    int32_t n = tree->nodeCount++, half = count / 2;
    wfRect box = box_around(tree, first, count);
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
static bool is_box_leaf(const wfBoxNode *node) { return node->right == WF_BOX_NONE; }

static bool pairs_between(const wfBoxTree *t, int32_t a, int32_t b, wfPairList *out)
{
    const wfBoxNode *p = &t->nodes[a], *q = &t->nodes[b];
    const wfRect *bounds = t->in->bounds;
    out->tests++;
    if (!wfRectOverlap(p->box, q->box)) return true;
    if (!is_box_leaf(p) && (is_box_leaf(q) || p->count >= q->count))
        return pairs_between(t, a + 1, b, out) && pairs_between(t, p->right, b, out);
    if (!is_box_leaf(q))
        return pairs_between(t, a, b + 1, out) && pairs_between(t, a, q->right, out);
    for (int32_t i = p->first; i < p->first + p->count; i++) {
        int32_t one = t->items[i].index;
        for (int32_t j = q->first; j < q->first + q->count; j++) {
            int32_t two = t->items[j].index;
            if (!wfOfferPair(t->in, out, bounds[one], one, bounds[two], two)) return false;
        }
    }
    return true;
}

static bool pairs_within(const wfBoxTree *t, int32_t n, wfPairList *out)
{
    const wfBoxNode *p = &t->nodes[n];
    const wfRect *bounds = t->in->bounds;
    if (!is_box_leaf(p))
        return pairs_within(t, n + 1, out) && pairs_within(t, p->right, out)
            && pairs_between(t, n + 1, p->right, out);
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

static wfBoxTree open_boxes(const wfProxies *in, const void *index, BoxHead **head)
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
    wfBoxTree t = open_boxes(in, index, &head);
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
    wfBoxTree t = open_boxes(in, index, &head);
    out->count = 0;
    out->tests = 0;
    bool anybody = head->moving != WF_BOX_NONE;
    bool room = !anybody || pairs_within(&t, head->moving, out);
    if (room && anybody && head->still != WF_BOX_NONE)
        room = pairs_between(&t, head->moving, head->still, out);
    return wfFinishPairs(room, in->count, scratch, wfPoolMark(scratch), out);
}

size_t wfBoxTreeScratch(int32_t proxies, int32_t pairs)
{
    return wfBoxTreeIndexSize(proxies) + WF_POOL_ALIGN + wfSortPairsSize(proxies, pairs);
}

/* ask a tree of boxes */
static bool query_boxes(const wfBoxTree *t, int32_t n, wfRect area, wfVisitFn *visit,
                        void *context)
{
    const wfBoxNode *node = &t->nodes[n];
    if (!wfRectOverlap(node->box, area)) return true;
    if (!is_box_leaf(node))
        return query_boxes(t, n + 1, area, visit, context)
            && query_boxes(t, node->right, area, visit, context);
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
    wfBoxTree t = open_boxes(in, index, &head);
    if (head->moving == WF_BOX_NONE || query_boxes(&t, head->moving, area, visit, context))
        if (head->still != WF_BOX_NONE) query_boxes(&t, head->still, area, visit, context);
}

static bool cast_boxes(const wfBoxTree *t, int32_t n, wfBoxCast *c, wfCastVisitFn *visit,
                       void *context)
{
    const wfBoxNode *node = &t->nodes[n];
    if (!is_box_leaf(node)) {
        wfReal left, right;
        bool l = wfCastMeets(c, t->nodes[n + 1].box, &left);
        bool r = wfCastMeets(c, t->nodes[node->right].box, &right);
        int32_t first = l && r && right < left ? node->right : n + 1;
        int32_t second = first == n + 1 ? node->right : n + 1;
        return (!l || cast_boxes(t, first, c, visit, context))
            && (!r || cast_boxes(t, second, c, visit, context));
    }
    for (int32_t i = node->first; i < node->first + node->count; i++)
        if (!wfOfferCast(t->in, c, t->items[i].index, visit, context)) return false;
    return true;
}

void wfBoxTreeCast(const wfProxies *in, const void *index, const wfBoxCast *cast,
                   wfCastVisitFn *visit, void *context)
{
    BoxHead *head;
    wfBoxTree t = open_boxes(in, index, &head);
    wfBoxCast c = *cast;
    if (head->still == WF_BOX_NONE || cast_boxes(&t, head->still, &c, visit, context))
        if (head->moving != WF_BOX_NONE) cast_boxes(&t, head->moving, &c, visit, context);
}

static bool show_boxes(const wfBoxTree *t, int32_t n, int32_t depth, wfBoxVisitFn *visit,
                       void *context)
{
    const wfBoxNode *node = &t->nodes[n];
    bool leaf = is_box_leaf(node);
    wfIndexBox box = { node->box, depth, leaf ? node->count : 0 };
    return visit(context, &box)
        && (leaf || (show_boxes(t, n + 1, depth + 1, visit, context)
                     && show_boxes(t, node->right, depth + 1, visit, context)));
}

void wfBoxTreeBoxes(const wfProxies *in, const void *index, wfBoxVisitFn *visit,
                    void *context)
{
    BoxHead *head;
    wfBoxTree t = open_boxes(in, index, &head);
    if (head->moving == WF_BOX_NONE || show_boxes(&t, head->moving, 0, visit, context))
        if (head->still != WF_BOX_NONE) show_boxes(&t, head->still, 0, visit, context);
}
