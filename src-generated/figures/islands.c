/* Weft: figures/islands.c, tangled from chapters/methods/18-islands.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/island.h"
#include "figures/kit.h"

enum { ISLAND_DISCS = 27 };

typedef struct islandDisc { float x, y, r; } islandDisc;

static void islands_lay(islandDisc disc[ISLAND_DISCS], const float handle[2])
{
    int n = 0;
    disc[n++] = (islandDisc){ handle[0], handle[1], 1.0f };
    for (int heap = 0; heap < 4; heap++)
        for (int row = 0; row < 3; row++)
            for (int i = 0; i + row < 3; i++)
                disc[n++] = (islandDisc){ 2.2f + 4.1f * (float)heap + 0.8f * (float)i
                    + 0.4f * (float)row, 0.7f + 0.693f * (float)row, 0.4f };
    disc[n++] = (islandDisc){ 0.6f, 0.7f, 0.4f };
    disc[n++] = (islandDisc){ 17.6f, 0.7f, 0.4f };
}

static bool islands_touch(islandDisc a, islandDisc b)
{
    float x = a.x - b.x, y = a.y - b.y, reach = (a.r + b.r) * 1.01f;
    return x * x + y * y <= reach * reach;
}

static void figure_islands_heaps(wfDraw *d, const wfFigureInput *in)
{
    static const int ink[5] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD, WF_INK_BAD,
                                WF_INK_FAINT };
    islandDisc disc[ISLAND_DISCS];
    int32_t parent[ISLAND_DISCS];
    uint8_t moves[ISLAND_DISCS];
    union { uint64_t align[2]; uint8_t bytes[1024]; } room[2] = { { { 0 } } };
    uint8_t *base = room[0].bytes + (16 - (uintptr_t)room % 16) % 16;
    wfPool pool;
    wfIslands islands;
    islands_lay(disc, in->handle[0]);
    wfMakeSets(parent, ISLAND_DISCS);
    memset(moves, 1, sizeof moves);
    for (int a = 0; a < ISLAND_DISCS; a++)
        for (int b = a + 1; b < ISLAND_DISCS; b++)
            if (islands_touch(disc[a], disc[b])) wfUnionSets(parent, a, b);
    if (wfPoolInit(&pool, sizeof room - 16, base) != WF_OK) return;
    if (wfGatherIslands(parent, moves, ISLAND_DISCS, &pool, &islands) != WF_OK) return;
    /* draw the discs of the islands */
    wfDrawLine(d, 0, 0.3f, 18.2f, 0.3f, 2, WF_INK_LINE);
    for (int i = 0; i < ISLAND_DISCS; i++)
        wfDrawCircle(d, disc[i].x, disc[i].y, disc[i].r, 1.5f, WF_INK_LINE,
                     ink[islands.island[i] % 5]);
    for (int a = 0; a < ISLAND_DISCS; a++)
        for (int b = a + 1; b < ISLAND_DISCS; b++)
            if (islands_touch(disc[a], disc[b]))
                wfDrawLine(d, disc[a].x, disc[a].y, disc[b].x, disc[b].y, 1.5f, WF_INK_LINE);
}
static const wfFigureRow rows[] = {
    { "islands-heaps", figure_islands_heaps, 18.2f, 4.2f, 1, { { 9.15f, 1.3f } } },
};
const wfFigureSet islands_figures = WF_ROWS(rows);
