/* Exercise coursework-cells. Oracle: points of the box, and a count. */
#include "course.h"
typedef struct ExCell { int32_t x, y; } ExCell;
int exCells(wfRect box, wfReal side, ExCell *out, int most);
#define exCells(box, side, out, most) asked_and(exCells(box, side, out, most), left_many(out, most))
static ExCell cells[200];
static wfRect box_of(wfRandom *r)
{
    wfReal x = wfRandomReal(r, -9, 9), y = wfRandomReal(r, -9, 9), w = wfRandomReal(r, 0, 4);
    return wfRectMinDim(wfV2(x, y), wfV2(w, wfRandomReal(r, 0, 4)));
}
static void covers(void)
{
    wfRandom r = course_random(4);
    for (int k = 0; k < 2000; k++) {
        wfRect b = box_of(&r);
        int n = exCells(b, 1, cells, 200);
        for (int i = 0; i < 9; i++) {
            wfVec2 p = wfV2(b.min.x + (wfReal)(i % 3) / 2 * (b.max.x - b.min.x), b.min.y + (wfReal)(i / 3) / 2 * (b.max.y - b.min.y));
            if (i % 3 == 2) p.x = b.max.x;
            if (i / 3 == 2) p.y = b.max.y;
            bool in = false;
            for (int j = 0; j < n && j < 200; j++) in |= cells[j].x == (int32_t)floor((double)p.x) && cells[j].y == (int32_t)floor((double)p.y);
            expect_true(say("the cell of the point (%g, %g) of box %d is listed", (double)p.x, (double)p.y, k), in);
        }
    }
}
static void exact(void)
{
    wfRandom r = course_random(5);
    for (int k = 0; k < 2000; k++) {
        wfRect b = box_of(&r);
        int n = exCells(b, 1, cells, 200), twice = 0;
        int want = (int)(floor((double)b.max.x) - floor((double)b.min.x) + 1) * (int)(floor((double)b.max.y) - floor((double)b.min.y) + 1);
        expect_int(say("cells of box %d", k), n, want);
        for (int i = 0; i < n; i++) for (int j = 0; j < i; j++) twice += cells[i].x == cells[j].x && cells[i].y == cells[j].y;
        expect_int(say("cells of box %d that are listed twice", k), twice, 0);
        expect_int(say("cells of box %d, if there is room for three", k), exCells(b, 1, cells, 3), want < 3 ? want : 3);
    }
}
CRITERIA("cells",
    { "covers", 2, "cells: list the cells from low to high", "every point of a box is in a cell that is listed", covers, 0 },
    { "exact", 1, "cells: list the cells from low to high", "no cell too many, none twice", exact, 0 })
