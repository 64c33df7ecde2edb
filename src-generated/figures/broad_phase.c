/* Weft: figures/broad_phase.c, tangled from chapters/engine/11-broad-phase.figures.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "weft/broad.h"
#include "weft/dynamic_tree.h"
#include "figures/kit.h"

enum { BROAD_FIGURE_MOST = 40 };
typedef struct BroadFigure {
    wfRect bounds[BROAD_FIGURE_MOST];
    uint8_t flags[BROAD_FIGURE_MOST];
    wfPair pairs[BROAD_FIGURE_MOST * BROAD_FIGURE_MOST];
    _Alignas(WF_POOL_ALIGN) uint8_t scratch[1 << 15];
    wfPool pool;
} BroadFigure;

static void broad_rect(wfDraw *d, wfRect r, float widthPx, int line, int fill)
{
    float x0 = (float)r.min.x, y0 = (float)r.min.y;
    float x1 = (float)r.max.x, y1 = (float)r.max.y;
    figRect(d, x0, y0, x1, y1, widthPx, line, fill);
}

static void broad_pair_lines(wfDraw *d, const BroadFigure *f, int count, int role)
{
    for (int i = 0; i < count; i++) {
        wfVec2 a = wfRectCenter(f->bounds[f->pairs[i].a]);
        wfVec2 b = wfRectCenter(f->bounds[f->pairs[i].b]);
        wfDrawLine(d, WF_XY(a), WF_XY(b), 2, role);
    }
}

static wfProxies broad_figure_world(BroadFigure *f, int n, float w, float h, float size,
                                    uint64_t seed)
{
    wfRandom random;
    wfRandomSeed(&random, seed);
    for (int i = 0; i < n; i++) {
        wfReal x = wfRandomReal(&random, (wfReal)size, (wfReal)(w - size));
        wfReal y = wfRandomReal(&random, (wfReal)size, (wfReal)(h - size));
        wfReal dx = (wfReal)size * wfRandomReal(&random, WF_R(0.5), 1);
        wfReal dy = (wfReal)size * wfRandomReal(&random, WF_R(0.5), 1);
        f->bounds[i] = wfRectCenterDim(wfV2(x, y), wfV2(dx, dy));
        f->flags[i] = WF_PROXY_LIVE | WF_PROXY_MOVES;
    }
    wfPoolInit(&f->pool, sizeof f->scratch, f->scratch);
    wfProxies in = { .count = n, .bounds = f->bounds, .flags = f->flags };
    return in;
}

static void figure_broad_lines(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfProxies world = broad_figure_world(&f, 20, 9, 5, 1.1f, 7);
    wfVec2 half = wfV2(WF_R(0.5), WF_R(0.4));
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    f.bounds[0] = wfRectCenterHalfDim(at, half);
    wfPairList list = { f.pairs, 0, BROAD_FIGURE_MOST * BROAD_FIGURE_MOST, 0 };
    wfFindPairs(wfFindBroadPhase("quad-tree"), &world, &f.pool, &list);
    for (int a = 0; a < world.count; a++)
        for (int b = a + 1; b < world.count; b++)
            wfDrawLine(d, WF_XY(wfRectCenter(f.bounds[a])),
                       WF_XY(wfRectCenter(f.bounds[b])), 0.3f, WF_INK_FAINT);
    for (int i = 0; i < world.count; i++)
        broad_rect(d, f.bounds[i], 1.5f, i ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
    broad_pair_lines(d, &f, list.count, WF_INK_BAD);
}
static void figure_broad_tree(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfQuadTree tree;
    (void)in;
    wfProxies world = broad_figure_world(&f, BROAD_FIGURE_MOST, 8, 8, 0.45f, 5);
    /* draw the boxes together */
    for (int i = 0; i < world.count; i++) {              /* a crowd at the lower left */
        wfVec2 c = wfRectCenter(f.bounds[i]), to = wfV2(c.x * c.x / 8, c.y * c.y / 8);
        wfVec2 by = wfAdd(wfSub(to, c), wfV2(WF_R(0.3), WF_R(0.3)));
        f.bounds[i] = (wfRect){ wfAdd(f.bounds[i].min, by), wfAdd(f.bounds[i].max, by) };
    }
    wfPairList list = { f.pairs, 0, BROAD_FIGURE_MOST * BROAD_FIGURE_MOST, 0 };
    wfQuadTreeDef def = { { wfV2(0, 0), wfV2(8, 8) }, world.count, 120, 5, 2 };
    if (wfQuadTreeInit(&tree, &f.pool, &def) != WF_OK) return;
    for (int i = 0; i < world.count; i++) wfQuadTreeInsert(&tree, i, f.bounds[i]);
    wfQuadTreePairs(&tree, WF_QUAD_DESCEND, NULL, &list);
    for (int n = 0; n < tree.nodeHigh; n++)
        if (wfQuadTreeUses(&tree, n))
            broad_rect(d, wfQuadTreeRect(&tree, n), 1, WF_INK_FAINT, WF_INK_NONE);
    wfDrawLine(d, 4, 0, 4, 8, 1.5f, WF_INK_FAINT);
    wfDrawLine(d, 0, 4, 8, 4, 1.5f, WF_INK_FAINT);
    for (int i = 0; i < world.count; i++)
        broad_rect(d, f.bounds[i], 1.5f,
                   wfQuadTreeNodeOf(&tree, i) ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
    broad_pair_lines(d, &f, list.count, WF_INK_BAD);
}
static void figure_broad_missed(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfQuadTree tree;
    broad_figure_world(&f, 2, 8, 5, 1, 1);
    wfQuadTreeDef def = { { wfV2(0, 0), wfV2(8, 5) }, 2, 40, 2, 0 };
    if (wfQuadTreeInit(&tree, &f.pool, &def) != WF_OK) return;
    for (int i = 0; i < 2; i++) {
        wfVec2 at = wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]);
        f.bounds[i] = wfRectCenterHalfDim(at, wfV2(WF_R(0.7), WF_R(0.5)));
        wfQuadTreeInsert(&tree, i, f.bounds[i]);
    }
    for (int i = 0; i < 2; i++) {
        int32_t node = wfQuadTreeNodeOf(&tree, i);
        if (node) broad_rect(d, wfQuadTreeRect(&tree, node), 1, WF_INK_FAINT, WF_INK_FAINT);
    }
    wfDrawLine(d, 4, 0, 4, 5, 1.5f, WF_INK_FAINT);
    wfDrawLine(d, 0, 2.5f, 8, 2.5f, 1.5f, WF_INK_FAINT);
    broad_rect(d, wfQuadTreeRect(&tree, 0), 1.5f, WF_INK_LINE, WF_INK_NONE);
    /* draw the two boxes and say which pairs each rule finds */
    for (int i = 0; i < 2; i++) {
        int32_t sectors[WF_QUAD_MAX_DEPTH];
        int depth = wfQuadTreePath(&tree, wfQuadTreeNodeOf(&tree, i), sectors);
        broad_rect(d, f.bounds[i], 2, i ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
        wfDrawTextf(d, (float)f.bounds[i].min.x, (float)f.bounds[i].max.y + 0.12f, 13,
                    WF_INK_TEXT, -1, depth ? "level %d" : "root", depth);
    }
    int found[3];
    for (int reach = 0; reach < 3; reach++) {
        wfPairList list = { f.pairs, 0, 4, 0 };
        wfQuadTreePairs(&tree, (wfQuadReach)reach, NULL, &list);
        found[reach] = list.count;
    }
    wfDrawTextf(d, 0.2f, 0.55f, 14, WF_INK_TEXT, -1, "within one node: %d pair%s", found[0],
                found[0] == 1 ? "" : "s");
    wfDrawTextf(d, 0.2f, 0.15f, 14, WF_INK_TEXT, -1, "also above or below: %d pair%s", found[2],
                found[2] == 1 ? "" : "s");
}
/* shades the nodes under n that the bounds reach into */
static void broad_shade(wfDraw *d, const wfQuadTree *tree, int32_t n, wfRect bounds)
{
    int32_t reached[4];
    int count = wfQuadTreeReach(tree, n, bounds, reached);
    for (int i = 0; i < count; i++) {
        if (tree->nodes[reached[i]].below == 0)
            broad_rect(d, wfQuadTreeRect(tree, reached[i]), 1, WF_INK_NONE, WF_INK_FAINT);
        broad_shade(d, tree, reached[i], bounds);
    }
}

static void figure_broad_reach(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfQuadTree tree;
    wfProxies world = broad_figure_world(&f, BROAD_FIGURE_MOST, 8, 8, 0.45f, 9);
    wfQuadTreeDef def = { { wfV2(0, 0), wfV2(8, 8) }, world.count, 120, 5, 1 };
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfRect asker = wfRectCenterHalfDim(at, wfV2(WF_R(0.5), WF_R(0.4)));
    if (wfQuadTreeInit(&tree, &f.pool, &def) != WF_OK) return;
    for (int i = 0; i < world.count; i++) wfQuadTreeInsert(&tree, i, f.bounds[i]);
    broad_shade(d, &tree, 0, asker);
    for (int n = 0; n < tree.nodeHigh; n++)
        broad_rect(d, wfQuadTreeRect(&tree, n), 1, WF_INK_FAINT, WF_INK_NONE);
    for (int i = 0; i < world.count; i++)
        broad_rect(d, f.bounds[i], wfRectOverlap(f.bounds[i], asker) ? 3 : 1.5f,
                   WF_INK_BODY,
                   WF_INK_NONE);
    broad_rect(d, asker, 2.5f, WF_INK_GOOD, WF_INK_NONE);
}

static void figure_broad_grid(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfProxies world = broad_figure_world(&f, 34, 8, 8, 0.9f, 21);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.55), WF_R(0.45)));
    wfRect all = { wfV2(0, 0), wfV2(8, 8) };
    wfCells cells = wfGridCells(all, WF_R(1.3), 100);
    wfCellRange mine = wfCellsOf(&cells, f.bounds[0]);
    /* draw the cells, and fill those of the reader's box */
    for (int32_t y = 0; y <= cells.limits.y1; y++)
        for (int32_t x = 0; x <= cells.limits.x1; x++) {
            bool in_it = x >= mine.x0 && x <= mine.x1 && y >= mine.y0 && y <= mine.y1;
            wfVec2 corner = wfV2((wfReal)x * cells.side, (wfReal)y * cells.side);
            wfRect cell = { corner, wfAdd(corner, wfV2(cells.side, cells.side)) };
            cell.max = wfMin2(cell.max, all.max);
            broad_rect(d, cell, 1, WF_INK_FAINT, in_it ? WF_INK_FAINT : WF_INK_NONE);
        }
    for (int i = 0; i < world.count; i++)
        broad_rect(d, f.bounds[i], i ? 1.5f : 2.5f, i ? WF_INK_BODY : WF_INK_GOOD,
                   WF_INK_NONE);
    wfPairList list = { f.pairs, 0, BROAD_FIGURE_MOST * BROAD_FIGURE_MOST, 0 };
    wfFindPairs(wfFindBroadPhase("grid"), &world, &f.pool, &list);
    int count = 0;                                   /* sorted: those of box 0 come first */
    while (count < list.count && list.pairs[count].a == 0) count++;
    broad_pair_lines(d, &f, count, WF_INK_BAD);
}
enum { BROAD_BLOCKS = 16, BROAD_CELLS = 128 };

/* the cells that some box touches, each once; returns how many */
static int broad_used_cells(const wfProxies *world, const wfCells *cells,
                            int32_t (*used)[2])
{
    int count = 0;
    for (int i = 0; i < world->count; i++) {
        wfCellRange r = wfCellsOf(cells, world->bounds[i]);
        for (int32_t y = r.y0; y <= r.y1; y++)
            for (int32_t x = r.x0; x <= r.x1; x++) {
                int k = 0;
                while (k < count && (used[k][0] != x || used[k][1] != y)) k++;
                if (k < count || count == BROAD_CELLS) continue;
                used[count][0] = x;
                used[count++][1] = y;
            }
    }
    return count;
}

static void figure_broad_hash(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    int32_t used[BROAD_CELLS][2], share[BROAD_BLOCKS] = { 0 };
    wfProxies world = broad_figure_world(&f, 7, 10, 6, 0.8f, 4);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    for (int i = 0; i < world.count; i++) {
        f.bounds[i].min.y += 2;
        f.bounds[i].max.y += 2;
    }
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.4), WF_R(0.3)));
    wfCells cells = wfHashCells(1);
    int count = broad_used_cells(&world, &cells, used), fullest = 0;
    for (int i = 0; i < count; i++)
        share[wfHashCell(used[i][0], used[i][1]) % BROAD_BLOCKS]++;
    for (int k = 0; k < BROAD_BLOCKS; k++) if (share[k] > share[fullest]) fullest = k;
    /* draw the cells, the blocks, and the lines of the fullest block */
    for (int i = 0; i < count; i++) {
        float x = (float)used[i][0], y = (float)used[i][1];
        wfRect cell = { wfV2((wfReal)x, (wfReal)y), wfV2((wfReal)x + 1, (wfReal)y + 1) };
        broad_rect(d, cell, 1, WF_INK_FAINT, WF_INK_NONE);
        if ((int)(wfHashCell(used[i][0], used[i][1]) % BROAD_BLOCKS) != fullest) continue;
        broad_rect(d, cell, 1, WF_INK_FAINT, WF_INK_FAINT);
        wfDrawLine(d, 0.5f + 0.6f * (float)fullest, 1, x + 0.5f, y + 0.5f, 1.2f, WF_INK_BAD);
    }
    for (int k = 0; k < BROAD_BLOCKS; k++) {
        wfReal x = WF_R(0.2) + WF_R(0.6) * (wfReal)k;
        wfRect block = { wfV2(x, WF_R(0.4)), wfV2(x + WF_R(0.6), 1) };
        broad_rect(d, block, 1.5f, WF_INK_LINE, k == fullest ? WF_INK_FAINT : WF_INK_NONE);
        if (share[k])
            wfDrawTextf(d, (float)x + 0.3f, 0.58f, 14, WF_INK_TEXT, 0, "%d", (int)share[k]);
    }
    for (int i = 0; i < world.count; i++)
        broad_rect(d, f.bounds[i], 2, i ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
}
static void figure_broad_sweep(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfKeyed items[BROAD_FIGURE_MOST], spare[BROAD_FIGURE_MOST];
    wfProxies world = broad_figure_world(&f, 16, 10, 5, 0.9f, 3);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    for (int i = 0; i < world.count; i++) {
        f.bounds[i].min.y += 3;
        f.bounds[i].max.y += 3;
    }
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.8), WF_R(0.4)));
    for (int i = 0; i < world.count; i++)
        items[i] = (wfKeyed){ f.bounds[i].min.x, i };
    wfSortKeyed(items, spare, world.count);
    wfRect me = f.bounds[0];
    bool active = false;
    wfDrawDashed(d, (float)me.min.x, 0, (float)me.min.x, 8, 1, WF_INK_FAINT);
    wfDrawDashed(d, (float)me.max.x, 0, (float)me.max.x, 8, 1, WF_INK_FAINT);
    for (int k = 0; k < world.count; k++) {
        /* draw a box and its bar */
        wfRect r = f.bounds[items[k].index];
        bool mine = items[k].index == 0, met = active && items[k].key <= me.max.x;
        int role = mine ? WF_INK_GOOD : met ? WF_INK_ACCENT : WF_INK_BODY;
        float y = 2.75f - 0.17f * (float)k;
        broad_rect(d, r, mine ? 2.5f : 1.5f, role, WF_INK_NONE);
        wfDrawLine(d, (float)r.min.x, y, (float)r.max.x, y, 3.5f, role);
        active = active || mine;
    }
}
static void broad_boxes(wfDraw *d, const wfBoxTree *tree, int32_t n, float widthPx)
{
    const wfBoxNode *node = &tree->nodes[n];
    bool leaf = node->right < 0;
    broad_rect(d, wfRectGrow(node->box, WF_R(0.05)), widthPx,
               leaf ? WF_INK_GOOD : WF_INK_LINE, WF_INK_NONE);
    if (leaf) return;
    broad_boxes(d, tree, n + 1, widthPx * 0.6f);
    broad_boxes(d, tree, node->right, widthPx * 0.6f);
}

static void figure_broad_boxes(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfBoxNode nodes[BROAD_FIGURE_MOST + 1];
    wfKeyed items[BROAD_FIGURE_MOST];
    wfProxies world = broad_figure_world(&f, 28, 8, 8, 0.6f, 8);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.3), WF_R(0.25)));
    for (int i = 0; i < world.count; i++) items[i].index = i;
    wfBoxTree tree = { &world, nodes, items, 0 };
    broad_boxes(d, &tree, wfBoxTreeBuild(&tree, 0, world.count), 4);
    for (int i = 0; i < world.count; i++)
        broad_rect(d, f.bounds[i], 1.5f, i ? WF_INK_BODY : WF_INK_ACCENT,
                   i ? WF_INK_NONE : WF_INK_ACCENT);
}

static void figure_broad_walk(wfDraw *d, const wfFigureInput *in)
{
    enum { STEPS = 8 };
    BroadFigure f;
    wfProxies world = broad_figure_world(&f, 14, 8, 8, 0.9f, 12);
    wfRect all = { wfV2(0, 0), wfV2(8, 8) };
    wfCells cells = wfGridCells(all, 1, 100);
    wfVec2 a = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 b = wfV2((wfReal)in->handle[1][0], (wfReal)in->handle[1][1]);
    wfVec2 way = wfSub(b, a);
    int steps = (int)wfMaxR(wfAbs(way.x), wfAbs(way.y)) + 1;
    for (int k = 0; k < steps; k++) {
        wfVec2 p = wfAddScaled(a, (wfReal)k / (wfReal)steps, way);
        wfVec2 q = wfAddScaled(a, (wfReal)(k + 1) / (wfReal)steps, way);
        wfCellRange r = wfCellsOf(&cells, wfRectMinMax(p, q));
        for (int32_t y = r.y0; y <= r.y1; y++)
            for (int32_t x = r.x0; x <= r.x1; x++)
                broad_rect(d, wfRectMinDim(wfV2((wfReal)x, (wfReal)y), wfV2(1, 1)), 0,
                           WF_INK_NONE, WF_INK_FAINT);
    }
    /* draw the grid, the boxes and the steps of the ray */
    for (int k = 0; k <= STEPS; k++) {
        wfDrawLine(d, (float)k, 0, (float)k, 8, 0.7f, WF_INK_LINE);
        wfDrawLine(d, 0, (float)k, 8, (float)k, 0.7f, WF_INK_LINE);
    }
    wfBoxCast cast = { a, way, wfV2(0, 0), 1 };
    for (int i = 0; i < world.count; i++) {
        wfReal t;
        bool met = wfCastMeets(&cast, f.bounds[i], &t);
        broad_rect(d, f.bounds[i], met ? 3 : 1.5f, met ? WF_INK_BAD : WF_INK_BODY, WF_INK_NONE);
    }
    for (int k = 0; k <= steps; k++) {
        wfVec2 p = wfAddScaled(a, (wfReal)k / (wfReal)steps, way);
        wfDrawPoint(d, WF_XY(p), 6, WF_INK_GOOD);
    }
    wfDrawArrow(d, WF_XY(a), WF_XY(b), 2, WF_INK_GOOD);
}
static void figure_broad_fat(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 tip = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 at = wfV2(WF_R(1.5), WF_R(1.5));
    wfVec2 way = wfScale(WF_R(0.25), wfSub(tip, at));
    wfRect box = wfRectCenterHalfDim(at, wfV2(WF_R(0.8), WF_R(0.6)));
    wfRect fat = wfFatBox(box, way, WF_TREE_RATIO);
    broad_rect(d, fat, 2, WF_INK_GOOD, WF_INK_NONE);
    for (int k = 8; k > 0; k--) {
        wfVec2 by = wfScale((wfReal)k, way);
        wfRect later = { wfAdd(box.min, by), wfAdd(box.max, by) };
        if (!wfRectContains(fat, later)) continue;
        broad_rect(d, later, 0.7f, WF_INK_FAINT, WF_INK_NONE);
    }
    broad_rect(d, box, 2, WF_INK_BODY, WF_INK_FAINT);
    wfDrawArrow(d, WF_XY(at), WF_XY(tip), 2, WF_INK_ACCENT);
}

/* draws the node's box and above it the branches to its children; returns where it is */
static wfVec2 broad_branch(wfDraw *d, const wfTree *t, int32_t n, int level, wfVec2 move)
{
    static const char *const names[] = { "A", "B", "C", "D" };
    const wfTreeNode *node = &t->nodes[n];
    wfRect r = { wfAdd(node->box.min, move), wfAdd(node->box.max, move) };
    wfVec2 here = wfV2((r.min.x + r.max.x) / 2, 5 - (wfReal)level * WF_R(0.9));
    if (node->left == WF_TREE_NONE) {
        broad_rect(d, r, 2, WF_INK_BODY, WF_INK_FAINT);
        wfDrawText(d, (float)here.x, (float)r.min.y + 0.3f, 14, WF_INK_TEXT, 0, names[n]);
        wfDrawPoint(d, WF_XY(here), 7, WF_INK_BODY);
        return here;
    }
    broad_rect(d, wfRectGrow(r, WF_R(0.22) - (wfReal)level / 14), 1.5f,
               level ? WF_INK_ACCENT : WF_INK_LINE, WF_INK_NONE);
    for (int k = 0; k < 2; k++) {
        wfVec2 child = broad_branch(d, t, k ? node->right : node->left, level + 1, move);
        wfDrawLine(d, WF_XY(here), WF_XY(child), 1.5f, WF_INK_LINE);
    }
    wfDrawPoint(d, WF_XY(here), 7, WF_INK_LINE);
    return here;
}

/* inserting would repair the bad tree, so its nodes are written by hand */
enum { ROTATE_BOXES = 4 };

/* a bad tree, made by hand: the first box, and beside it all the rest, and so on */
static void broad_ladder(wfTree *t, const wfRect *boxes, int n)
{
    for (int i = 0; i < n; i++)
        t->nodes[i] = (wfTreeNode){ boxes[i], ROTATE_BOXES + (i < n - 1 ? i : n - 2),
                                    WF_TREE_NONE, WF_TREE_NONE, 1, 1 };
    for (int k = n - 2; k >= 0; k--) {
        int right = k == n - 2 ? n - 1 : ROTATE_BOXES + k + 1;
        t->nodes[ROTATE_BOXES + k] = (wfTreeNode){
            wfRectUnion(boxes[k], t->nodes[right].box),
            k > 0 ? ROTATE_BOXES + k - 1 : WF_TREE_NONE, k, right, n - k, n - k };
    }
    t->head->root = ROTATE_BOXES;
    t->head->freeNode = ROTATE_BOXES + n - 1;
    t->head->count = n;
}
static void figure_broad_rotate(wfDraw *d, const wfFigureInput *in)
{
    _Alignas(WF_POOL_ALIGN) uint8_t block[1024];
    wfRect boxes[ROTATE_BOXES];
    wfTree tree;
    (void)in;
    for (int i = 0; i < ROTATE_BOXES; i++) {
        wfReal x = WF_R(0.5) + WF_R(1.1) * (wfReal)i + (i > 1 ? WF_R(1.2) : 0);
        boxes[i] = wfRectMinDim(wfV2(x, WF_R(0.5)), wfV2(WF_R(0.8), WF_R(0.8)));
    }
    if (wfTreeInit(&tree, block, sizeof block, ROTATE_BOXES) != WF_OK) return;
    broad_ladder(&tree, boxes, ROTATE_BOXES);
    broad_branch(d, &tree, tree.head->root, 0, wfV2(0, 0));
    if (wfTreeInit(&tree, block, sizeof block, ROTATE_BOXES) != WF_OK) return;
    broad_ladder(&tree, boxes, ROTATE_BOXES - 1);
    wfTreeInsert(&tree, ROTATE_BOXES - 1, boxes[ROTATE_BOXES - 1], true);
    broad_branch(d, &tree, tree.head->root, 0, wfV2(WF_R(6.4), 0));
}

static const wfFigureRow rows[] = {
    { "broad-walk", figure_broad_walk, 8.0f, 8.0f, 2, { { 0.4f, 1.3f }, { 7.3f, 5.6f } } },
    { "broad-fat", figure_broad_fat, 6.5f, 3.6f, 1, { { 3.3f, 2.1f } } },
    { "broad-rotate", figure_broad_rotate, 12.6f, 5.4f, 0, { { 0 } } },
    { "broad-reach", figure_broad_reach, 8.0f, 8.0f, 1, { { 4.3f, 5.0f } } },
    { "broad-lines", figure_broad_lines, 9.0f, 5.0f, 1, { { 4.6f, 2.6f } } },
    { "broad-tree", figure_broad_tree, 8.0f, 8.0f, 0, { { 0 } } },
    { "broad-grid", figure_broad_grid, 8.0f, 8.0f, 1, { { 4.1f, 4.0f } } },
    { "broad-hash", figure_broad_hash, 10.0f, 8.0f, 1, { { 7.4f, 5.0f } } },
    { "broad-sweep", figure_broad_sweep, 10.0f, 8.0f, 1, { { 4.2f, 5.6f } } },
    { "broad-boxes", figure_broad_boxes, 8.0f, 8.0f, 1, { { 6.5f, 7.2f } } },
    { "broad-missed", figure_broad_missed, 8.0f, 5.0f, 2,
      { { 4.3f, 3.7f }, { 5.3f, 4.0f } } },
};
const wfFigureSet broad_phase_figures = WF_ROWS(rows);
