/* Weft: lab/figures.c, tangled from chapters/engine/04-design.nw. Chapters that add to it: memory,
 * numbers, shapes, bodies, forces, integration, broad-phase, narrow-phase, contacts, impulses,
 * friction, sequential, soft, joints, exact, compound, time-of-impact, islands, events-and-queries,
 * world, joints-in-a-world, save-and-replay, platform, drawing, scenes, accuracy, primer. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "lab/lab.h"
/* <headers of the figures> */
#include "weft/draw.h"
/* <headers of the figures> */
#include "weft/core.h"
#include "lab/toy_heap.h"
/* <headers of the figures> */
#include "weft/math.h"
/* <headers of the figures> */
#include "weft/shape.h"
/* <headers of the figures> */
#include "weft/body.h"
/* <headers of the figures> */
#include "weft/force.h"
/* <headers of the figures> */
#include <string.h>
#include "weft/force.h"
#include "weft/integrate.h"
/* <headers of the figures> */
#include "weft/broad.h"
/* <headers of the figures> */
#include "weft/narrow.h"
/* <headers of the figures> */
#include "weft/contact.h"
/* <headers of the figures> */
#include "weft/resolve.h"
/* <headers of the figures> */
#include "weft/resolve.h"
/* <headers of the figures> */
#include "weft/resolve.h"
/* <headers of the figures> */
#include "weft/contact.h"
#include "weft/resolve.h"
/* <headers of the figures> */
#include "weft/joint.h"
/* <headers of the figures> */
#include "weft/contact.h"
#include "weft/narrow.h"
#include "weft/resolve.h"
/* <headers of the figures> */
#include "weft/compound.h"
#include "lab/outlines.h"
/* <headers of the figures> */
#include "weft/impact.h"
/* <headers of the figures> */
#include "weft/island.h"
/* <headers of the figures> */
#include "weft/events.h"
#include "weft/query.h"
/* <headers of the figures> */
#include "weft/world.h"
/* <headers of the figures> */
#include "weft/world.h"
/* <headers of the figures> */
#include "engine/image.h"
#include "weft/save.h"
/* <headers of the figures> */
#include "testbed/platform.h"
/* <headers of the figures> */
#include "weft/math.h"
#include "testbed/raster.h"
/* <headers of the figures> */
#include "testbed/hand.h"
#include "testbed/scene.h"
#include "testbed/view.h"
/* <headers of the figures> */
#include "testbed/layout.h"
/* <headers of the figures> */
#include "testbed/camera.h"
/* <headers of the figures> */
#include "lab/taste.h"

/* <figures> */
static void design_box(wfDraw *d, float x, float y, float w, float h, int role,
                       const char *title, const char *below)
{
    float corners[8] = { x, y, x + w, y, x + w, y + h, x, y + h }, middle = x + 0.5f * w;
    wfDrawPolygon(d, corners, 4, 1.5f, role, role);
    wfDrawText(d, middle, y + 0.5f * h + (below ? 0.03f : -0.08f), 14, WF_INK_TEXT, 0,
               title);
    if (below) wfDrawText(d, middle, y + 0.5f * h - 0.25f, 11, WF_INK_TEXT, 0, below);
}
/* <figures> */
static void figure_design_components(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    design_box(d, 2.3f, 4.1f, 3.4f, 0.9f, WF_INK_ACCENT, "engine", "worlds, and the step");
    design_box(d, 0.1f, 2.2f, 3.2f, 0.9f, WF_INK_BODY, "collision", "what touches what");
    design_box(d, 4.7f, 2.2f, 3.2f, 0.9f, WF_INK_BODY, "dynamics", "what moves, and why");
    design_box(d, 0.9f, 0.2f, 2.7f, 0.9f, WF_INK_FAINT, "math", "vectors, sine, chance");
    design_box(d, 4.4f, 0.2f, 2.7f, 0.9f, WF_INK_FAINT, "core", "memory, errors, the pen");
    wfDrawArrow(d, 3.2f, 4.1f, 2.0f, 3.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 4.8f, 4.1f, 6.0f, 3.1f, 1.5f, WF_INK_LINE);
    wfDrawDashed(d, 4.7f, 2.65f, 3.4f, 2.65f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 3.5f, 2.65f, 3.3f, 2.65f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 4.0f, 2.75f, 11, WF_INK_TEXT, 0, "contacts");
    wfDrawArrow(d, 1.7f, 2.2f, 2.0f, 1.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 2.6f, 2.2f, 5.1f, 1.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 5.4f, 2.2f, 2.9f, 1.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 6.3f, 2.2f, 6.0f, 1.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 3.6f, 0.65f, 4.4f, 0.65f, 1.5f, WF_INK_LINE);
}
/* <figures> */
static void figure_design_rows(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int body = 0; body < 6; body++)
        for (int field = 0; field < 8; field++) {
            bool wanted = field == 2 || field == 3;  /* the velocity */
            int role = wanted ? WF_INK_ACCENT : WF_INK_FAINT;
            float apart = 0.2f * (float)(8 * body + field);
            float sorted = 0.2f * (float)(6 * (field / 2 * 2) + 2 * body + field % 2);
            for (int row = 0; row < 2; row++) {
                float x = 0.2f + (row == 0 ? apart : sorted), y = row == 0 ? 1.7f : 0.5f;
                float cell[8] = { x, y, x + 0.2f, y, x + 0.2f, y + 0.45f, x, y + 0.45f };
                wfDrawPolygon(d, cell, 4, 0.75f, role, role);
            }
        }
    wfDrawText(d, 0.2f, 2.28f, 12, WF_INK_TEXT, -1, "one object after the other");
    wfDrawText(d, 0.2f, 1.08f, 12, WF_INK_TEXT, -1,
               "sorted by use: places, velocities, ...");
    /* <mark the lines of memory> */
    for (int line = 0; line < 3; line++) {  /* a line of memory is 16 fields of 4 bytes */
        float x = 0.2f + 3.2f * (float)line;
        wfDrawLine(d, x, 0.3f, x + 3.2f, 0.3f, 1, WF_INK_LINE);
        wfDrawLine(d, x, 0.2f, x, 0.4f, 1, WF_INK_LINE);
        wfDrawLine(d, x + 3.2f, 0.2f, x + 3.2f, 0.4f, 1, WF_INK_LINE);
        wfDrawText(d, x + 1.6f, 0.05f, 11, WF_INK_TEXT, 0, "64 bytes");
    }
}
/* <figures> */
static const float design_bodies[4][3] = {  /* x, y, radius */
    { 0.75f, 1.0f, 0.5f }, { 1.55f, 1.45f, 0.45f }, { 0.75f, 2.45f, 0.35f },
    { 1.9f, 2.35f, 0.5f },
};

static bool design_overlap(const float *a, const float *b)
{
    float dx = a[0] - b[0], dy = a[1] - b[1], reach = a[2] + b[2];
    return dx * dx <= reach * reach && dy * dy <= reach * reach;
}

static void design_pairs(wfDraw *d, float x, float y)
{
    for (int i = 0; i < 4; i++)
        for (int j = i + 1; j < 4; j++)
            if (design_overlap(design_bodies[i], design_bodies[j])) {
                wfDrawTextf(d, x, y, 14, WF_INK_TEXT, 0, "(%d, %d)", i, j);
                y -= 0.35f;
            }
}
/* <figures> */
static void figure_design_zone(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int i = 0; i < 4; i++) {
        const float *b = design_bodies[i];
        float x = b[0] + 3.5f, y = b[1], r = b[2];
        float box[8] = { x - r, y - r, x + r, y - r, x + r, y + r, x - r, y + r };
        wfDrawCircle(d, b[0], y, r, 1.5f, WF_INK_BODY, WF_INK_BODY);
        wfDrawArrow(d, b[0], y, b[0] + 0.35f - 0.1f * (float)i, y + 0.3f, 1.5f,
                    WF_INK_ACCENT);
        wfDrawPolygon(d, box, 4, 1.5f, WF_INK_LINE, WF_INK_NONE);
        wfDrawTextf(d, x, y - 0.06f, 12, WF_INK_TEXT, 0, "%d", i);
    }
    design_pairs(d, 7.3f, 2.0f);
    wfDrawText(d, 1.25f, 0.1f, 12, WF_INK_TEXT, 0, "bodies");
    wfDrawText(d, 4.75f, 0.1f, 12, WF_INK_TEXT, 0, "boxes");
    wfDrawText(d, 7.3f, 0.1f, 12, WF_INK_TEXT, 0, "pairs");
    wfDrawArrow(d, 2.6f, 1.8f, 3.5f, 1.8f, 2, WF_INK_LINE);
    wfDrawArrow(d, 6.0f, 1.8f, 6.8f, 1.8f, 2, WF_INK_LINE);
    wfDrawText(d, 3.05f, 1.95f, 12, WF_INK_TEXT, 0, "zone");
    wfDrawText(d, 6.4f, 2.05f, 12, WF_INK_TEXT, 0, "broad");
    wfDrawText(d, 6.4f, 1.5f, 12, WF_INK_TEXT, 0, "phase");
}
/* <figures> */
static void figure_design_pipeline(wfDraw *d, const wfFigureInput *in)
{
    static const char *const stage[7] = { "forces", "integration", "bounds", "broad phase",
                                          "narrow phase", "contacts", "impulses" };
    (void)in;
    design_box(d, 0.3f, 3.7f, 3.0f, 0.8f, WF_INK_BODY, "wfCreateWorld", "once");
    design_box(d, 0.3f, 2.3f, 3.0f, 0.8f, WF_INK_BODY, "wfAddBodyToWorld", "at any time");
    design_box(d, 0.3f, 0.9f, 3.0f, 0.8f, WF_INK_ACCENT, "wfStepWorld", "again and again");
    wfDrawArrow(d, 1.8f, 3.7f, 1.8f, 3.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 1.8f, 2.3f, 1.8f, 1.7f, 1.5f, WF_INK_LINE);
    const float loop[8] = { 1.8f, 0.9f, 1.8f, 0.5f, 0.1f, 0.5f, 0.1f, 1.3f };
    wfDrawPolyline(d, loop, 4, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.1f, 1.3f, 0.3f, 1.3f, 1.5f, WF_INK_LINE);
    wfDrawDashed(d, 3.3f, 1.7f, 4.6f, 4.75f, 1, WF_INK_FAINT);
    wfDrawDashed(d, 3.3f, 0.9f, 4.6f, 0.3f, 1, WF_INK_FAINT);
    for (int i = 0; i < 7; i++) {
        float y = 4.3f - 0.65f * (float)i;
        design_box(d, 4.7f, y, 2.6f, 0.45f, WF_INK_FAINT, stage[i], NULL);
        if (i < 6) wfDrawArrow(d, 6.0f, y, 6.0f, y - 0.2f, 1, WF_INK_LINE);
    }
}
/* <figures> */
static void figure_design_tables(wfDraw *d, const wfFigureInput *in)
{
    static const char *const row[4] = { "explicit-euler", "verlet", "rk4", "mine" };
    (void)in;
    design_box(d, 0.2f, 2.1f, 2.6f, 1.0f, WF_INK_BODY, "chapter 10", "integration");
    design_box(d, 0.2f, 0.4f, 2.6f, 1.0f, WF_INK_ACCENT, "your chapter", "in chapters/");
    wfDrawText(d, 5.6f, 3.3f, 12, WF_INK_TEXT, 0, "rows of the integrator table");
    for (int i = 0; i < 4; i++) {
        float y = 2.5f - 0.6f * (float)i;
        int role = i < 3 ? WF_INK_BODY : WF_INK_ACCENT;
        design_box(d, 4.4f, y, 2.4f, 0.6f, role, row[i], NULL);
        wfDrawTextf(d, 4.2f, y + 0.22f, 12, WF_INK_TEXT, 1, "%d", i);
    }
    wfDrawArrow(d, 2.8f, 2.6f, 3.9f, 2.6f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 2.8f, 0.95f, 3.9f, 0.95f, 1.5f, WF_INK_ACCENT);
    wfDrawArrow(d, 6.8f, 2.6f, 7.4f, 2.6f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 6.8f, 1.9f, 7.4f, 1.9f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 6.8f, 1.2f, 7.4f, 1.2f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 7.5f, 2.55f, 12, WF_INK_TEXT, -1, "menu");
    wfDrawText(d, 7.5f, 1.85f, 12, WF_INK_TEXT, -1, "tests");
    wfDrawText(d, 7.5f, 1.15f, 12, WF_INK_TEXT, -1, "lab");
}
/* <figures> */
static void figure_design_testbed(wfDraw *d, const wfFigureInput *in)
{
    static const char *const name[4] = { "SDL2", "headless", "web page", "Win32" };
    (void)in;
    for (int i = 0; i < 4; i++)
        design_box(d, 0.2f, 3.0f - 0.85f * (float)i, 2.2f, 0.6f,
                   WF_INK_BODY, name[i], NULL);
    design_box(d, 5.2f, 1.2f, 2.6f, 1.4f, WF_INK_ACCENT, "the game", "update and render");
    wfDrawLine(d, 2.7f, 3.6f, 2.7f, 0.4f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 2.7f, 2.3f, 5.2f, 2.3f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 5.2f, 1.5f, 2.7f, 1.5f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 3.95f, 2.42f, 12, WF_INK_TEXT, 0, "memory, input");
    wfDrawText(d, 3.95f, 1.62f, 12, WF_INK_TEXT, 0, "pixels");
}
/* <figures> */
static void figure_design_backends(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    design_box(d, 0.2f, 2.2f, 2.2f, 0.8f, WF_INK_BODY, "a figure", "of a chapter");
    design_box(d, 0.2f, 0.8f, 2.2f, 0.8f, WF_INK_BODY, "an overlay", "of the testbed");
    design_box(d, 3.3f, 1.5f, 1.8f, 0.8f, WF_INK_ACCENT, "list", "of commands");
    design_box(d, 6.0f, 2.7f, 2.2f, 0.8f, WF_INK_FAINT, "SVG", "book, HTML and PDF");
    design_box(d, 6.0f, 1.5f, 2.2f, 0.8f, WF_INK_FAINT, "pixels", "testbed, PNG");
    design_box(d, 6.0f, 0.3f, 2.2f, 0.8f, WF_INK_FAINT, "live page", "SVG again");
    wfDrawArrow(d, 2.4f, 2.6f, 3.3f, 2.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 2.4f, 1.2f, 3.3f, 1.7f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 5.1f, 2.1f, 6.0f, 3.1f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 5.1f, 1.9f, 6.0f, 1.9f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 5.1f, 1.7f, 6.0f, 0.7f, 1.5f, WF_INK_LINE);
}
/* <figures> */
static void design_bytes(wfDraw *d, size_t from, size_t length, int role, float y)
{
    float a = 0.2f + 0.027f * (float)from, b = a + 0.027f * (float)length;
    float box[8] = { a, y, b, y, b, y + 0.6f, a, y + 0.6f };
    wfDrawPolygon(d, box, 4, 1, role, role);
}

static void figure_design_list(wfDraw *d, const wfFigureInput *in)
{
    static const int role[5] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_ACCENT, WF_INK_GOOD,
                                 WF_INK_BAD };
    _Alignas(8) unsigned char memory[320];
    const float triangle[6] = { 0, 0, 1, 0, 0, 1 };
    wfDraw list;
    (void)in;
    wfDrawInit(&list, memory, sizeof memory);
    wfDrawLine(&list, 0, 0, 1, 1, 1, WF_INK_LINE);
    wfDrawCircle(&list, 0, 0, 1, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawText(&list, 0, 0, 13, WF_INK_TEXT, 0, "a text");
    wfDrawPolygon(&list, triangle, 3, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawPoint(&list, 0, 0, 4, WF_INK_LINE);
    /* <draw where the commands and payloads of the list lie> */
    float y = 0.5f;
    design_bytes(d, 0, sizeof memory, WF_INK_FAINT, y);
    size_t end = sizeof memory, step = sizeof(wfDrawCommand);
    for (int i = 0; i < list.count; i++) {
        const wfDrawCommand *c = wfDrawAt(&list, i);
        design_bytes(d, (size_t)i * step, step, role[i], y);
        design_bytes(d, c->data, end - c->data, role[i], y);
        end = c->data;
    }
    wfDrawTextf(d, 0.2f, 1.25f, 12, WF_INK_TEXT, -1, "%d commands of %zu bytes", list.count,
                step);
    wfDrawText(d, 8.84f, 1.25f, 12, WF_INK_TEXT, 1, "points and letters");
    wfDrawText(d, 5.2f, 0.73f, 12, WF_INK_TEXT, 0, "free");
    wfDrawArrow(d, 3.5f, 0.8f, 4.2f, 0.8f, 1, WF_INK_LINE);
    wfDrawArrow(d, 6.9f, 0.8f, 6.2f, 0.8f, 1, WF_INK_LINE);
}
/* <figures> */
static void figure_bar(wfDraw *d, float x, float y, float w, float h, int fill)
{
    float corners[8] = { x, y, x + w, y, x + w, y + h, x, y + h };
    wfDrawPolygon(d, corners, 4, 1, WF_INK_LINE, fill);
}

static void figure_memory_holes(wfDraw *d, const wfFigureInput *in)
{
    static ToyHeap heap;
    int longest, row = 60;
    heap = (ToyHeap){ .requests = 0 };
    for (int step = 1; step <= 200 + (int)(4 * in->time); step++) toy_step(&heap, step);
    toy_find(&heap, 1, &longest);
    int best = toy_find(&heap, longest, &longest);
    /* <draw the toy heap in rows of cells> */
    for (int i = 0; i < TOY_CELLS; i++) {
        float x = 0.3f + 0.15f * (float)(i % row), y = 4.6f - 0.42f * (float)(i / row);
        int id = heap.owner[i], j = i + 1;
        while (j % row != 0 && heap.owner[j] == id && j != best && j != best + longest) j++;
        int fill = id == 0 ? WF_INK_NONE : id % 2 ? WF_INK_BODY : WF_INK_BODY2;
        if (i >= best && i < best + longest) fill = WF_INK_ACCENT;
        figure_bar(d, x, y, 0.15f * (float)(j - i), 0.34f, fill);
        i = j - 1;
    }
    wfDrawTextf(d, 0.3f, 0.2f, 14, WF_INK_TEXT, -1, "free: %d of %d cells", toy_free(&heap),
                TOY_CELLS);
    wfDrawTextf(d, 9.3f, 0.2f, 14, WF_INK_ACCENT, 1, "longest hole: %d", longest);
}
/* <figures> */
static void figure_memory_pool(wfDraw *d, const wfFigureInput *in)
{
    static _Alignas(16) uint8_t bytes[48];
    static const struct { const char *name; size_t size, align; int fill; } push[] = {
        { "char[5]", 5, 1, WF_INK_BODY }, { "double", 8, 8, WF_INK_BODY2 },
        { "int32_t[2]", 8, 4, WF_INK_BODY }, { "flag", 1, 1, WF_INK_BODY2 },
    };
    wfPool pool;
    size_t mark = 0;
    (void)in;
    wfPoolInit(&pool, sizeof bytes, bytes);
    figure_bar(d, 0.3f, 1.5f, 9.6f, 0.8f, WF_INK_NONE);
    for (int i = 0; i < 4; i++) {
        /* <push one thing and draw its bytes> */
        size_t before = pool.used;
        uint8_t *p = wfPoolPush(&pool, push[i].size, push[i].align);
        float x = 0.3f + 0.2f * (float)(p - pool.base), w = 0.2f * (float)push[i].size;
        float gap = 0.3f + 0.2f * (float)before;
        for (float g = gap; g < x - 0.05f; g += 0.2f)
            wfDrawLine(d, g, 1.5f, g + 0.2f, 2.3f, 1, WF_INK_FAINT);
        figure_bar(d, x, 1.5f, w, 0.8f, push[i].fill);
        wfDrawText(d, i < 3 ? x + w / 2 : x, 2.45f, 13, WF_INK_TEXT, i < 3 ? 0 : -1, push[i].name);
        wfDrawTextf(d, x, 1.22f, 12, WF_INK_TEXT, 0, "%d", (int)(p - pool.base));
        if (i == 1) mark = wfPoolMark(&pool);
    }
    /* <draw the mark and the end of the used bytes> */
    float at = 0.3f + 0.2f * (float)mark, end = 0.3f + 0.2f * (float)pool.used;
    wfDrawArrow(d, at, 0.5f, at, 1.1f, 2, WF_INK_ACCENT);
    wfDrawText(d, at, 0.25f, 13, WF_INK_ACCENT, 0, "mark");
    wfDrawArrow(d, end, 0.5f, end, 1.1f, 2, WF_INK_LINE);
    wfDrawText(d, end, 0.25f, 13, WF_INK_TEXT, 0, "used");
    wfDrawText(d, 9.9f, 0.25f, 13, WF_INK_TEXT, 1, "size");
    wfDrawArrow(d, 9.9f, 0.5f, 9.9f, 1.1f, 2, WF_INK_LINE);
    wfDrawTextf(d, 0.5f * (end + 9.9f), 1.82f, 13, WF_INK_TEXT, 0, "free: %d bytes",
                (int)wfPoolRoom(&pool));
}
/* <figures> */
static void figure_memory_slots(wfDraw *d, const wfFigureInput *in)
{
    wfSlot slot[6];
    wfSlots s;
    (void)in;
    wfSlotsInit(&s, slot, 6);
    for (int i = 0; i < 5; i++) wfSlotTake(&s, slot);
    wfSlotGive(&s, slot, 3, 1);
    wfSlotGive(&s, slot, 1, 1);
    for (int i = 0; i < s.capacity; i++) {
        float x = 0.4f + 1.5f * (float)i;
        bool live = slot[i].next == WF_SLOT_LIVE;
        figure_bar(d, x, 1.6f, 1.3f, 1.0f, live ? WF_INK_BODY : WF_INK_NONE);
        wfDrawTextf(d, x + 0.65f, 2.72f, 13, WF_INK_TEXT, 0, "%d", i);
        wfDrawText(d, x + 0.65f, 2.2f, 12, WF_INK_TEXT, 0,
                   live ? "taken" : i < s.high ? "free" : "untouched");
        wfDrawTextf(d, x + 0.65f, 1.8f, 12, WF_INK_TEXT, 0, "gen %u",
                    (unsigned)slot[i].generation);
    }
    /* <draw the free list and an old name> */
    float from = 0.9f;
    wfDrawText(d, 0.9f, 0.55f, 13, WF_INK_TEXT, 0, "firstFree");
    for (int32_t i = s.firstFree; i != WF_SLOT_END; i = slot[i].next) {
        float x = 1.05f + 1.5f * (float)i;
        float path[6] = { from, from < 1 ? 0.85f : 1.55f, from + 0.4f, 1.0f, x - 0.35f, 1.0f };
        wfDrawPolyline(d, path, 3, 1.5f, WF_INK_LINE);
        wfDrawArrow(d, x - 0.35f, 1.0f, x, 1.55f, 1.5f, WF_INK_LINE);
        from = x + 0.2f;
    }
    bool alive = wfSlotAlive(&s, slot, 1, 1);
    wfDrawTextf(d, 2.55f, 3.55f, 13, alive ? WF_INK_GOOD : WF_INK_BAD, 0,
                "old name (1, gen 1): %s", alive ? "alive" : "stale");
    wfDrawArrow(d, 2.55f, 3.45f, 2.55f, 3.0f, 1.5f, WF_INK_BAD);
}
/* <figures> */
static void figure_vector(wfDraw *d, wfVec2 from, wfVec2 v, int role, const char *name)
{
    wfVec2 tip = wfAdd(from, v), label = wfAddScaled(tip, WF_R(0.22), wfNormalize(v));
    wfDrawArrow(d, WF_XY(from), WF_XY(tip), 2, role);
    wfDrawText(d, (float)label.x, (float)label.y - 0.07f, 15, role, 0, name);
}

static wfVec2 figure_handle(const wfFigureInput *in, int i, wfVec2 origin)
{
    return wfSub(wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]), origin);
}
/* <figures> */
static void figure_numbers_cross(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(1.5f, 0.8f), a = figure_handle(in, 0, o), b = figure_handle(in, 1, o);
    wfVec2 p = wfAdd(o, a), q = wfAdd(p, b), s = wfAdd(o, b);
    float corners[8] = { WF_XY(o), WF_XY(p), WF_XY(q), WF_XY(s) };
    wfReal area = wfCross(a, b);
    wfDrawPolygon(d, corners, 4, 1, WF_INK_FAINT, area >= 0 ? WF_INK_GOOD : WF_INK_BAD);
    figure_vector(d, o, a, WF_INK_BODY, "a");
    figure_vector(d, o, b, WF_INK_BODY2, "b");
    figure_vector(d, o, wfScale(WF_R(0.5), wfPerpCCW(a)), WF_INK_FAINT, "left of a");
    wfVec2 middle = wfLerp(o, q, WF_R(0.55));
    wfDrawTextf(d, WF_XY(middle), 15, WF_INK_TEXT, 0, "a \xc3\x97 b = %.2f", (double)area);
}
/* <figures> */
static void figure_numbers_projection(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(0.8f, 0.6f), a = figure_handle(in, 0, o), b = figure_handle(in, 1, o);
    wfVec2 u = wfNormalize(b), foot = wfAddScaled(o, wfDot(a, u), u), tip = wfAdd(o, a);
    wfVec2 label = wfAddScaled(wfLerp(o, foot, WF_R(0.5)), WF_R(0.25), wfPerpCW(u));
    wfDrawLine(d, WF_XY(o), WF_XY(foot), 6, WF_INK_ACCENT);
    wfDrawDashed(d, WF_XY(tip), WF_XY(foot), 1, WF_INK_LINE);
    figure_vector(d, o, a, WF_INK_BODY, "a");
    figure_vector(d, o, b, WF_INK_BODY2, "b");
    wfDrawTextf(d, (float)label.x, (float)label.y - 0.08f, 14, WF_INK_ACCENT, 0, "%.2f",
                (double)wfDot(a, u));
    wfDrawTextf(d, 5.8f, 3.6f, 14, WF_INK_TEXT, 1, "a \xc2\xb7 b = %.2f",
                (double)wfDot(a, b));
}
/* <figures> */
static void figure_arc(wfDraw *d, wfVec2 centre, wfReal radius, wfReal from, wfReal to,
                       int role)
{
    enum { POINTS = 33 };
    float xy[2 * POINTS];
    for (int i = 0; i < POINTS; i++) {
        wfRot q = wfRotation(from + (to - from) * (wfReal)i / (POINTS - 1));
        wfVec2 p = wfAddScaled(centre, radius, wfV2(q.c, q.s));
        xy[2 * i] = (float)p.x;
        xy[2 * i + 1] = (float)p.y;
    }
    wfDrawPolyline(d, xy, POINTS, 1.5f, role);
}
/* <figures> */
static void figure_numbers_rotation(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(2.5f, 0.6f), v = figure_handle(in, 0, o);
    wfReal angle = wfAtan2(v.y, v.x);
    wfMat22 m = wfMat22RotationRad(angle);
    wfVec2 p = wfV2(m.E11, m.E21), q = wfV2(m.E12, m.E22);
    figure_vector(d, o, wfV2(2, 0), WF_INK_FAINT, "");
    figure_vector(d, o, wfV2(0, 2), WF_INK_FAINT, "");
    figure_vector(d, o, wfScale(2, p), WF_INK_BODY, "");
    figure_vector(d, o, wfScale(2, q), WF_INK_BODY2, "");
    figure_arc(d, o, 2, 0, angle, WF_INK_FAINT);
    figure_arc(d, o, 2, WF_PI / 2, WF_PI / 2 + angle, WF_INK_FAINT);
    wfVec2 a = wfAddScaled(o, WF_R(2.15), p), b = wfAddScaled(o, WF_R(2.3), q);
    wfDrawTextf(d, WF_XY(a), 14, WF_INK_BODY, -1, "(%.2f, %.2f)", (double)p.x, (double)p.y);
    wfDrawTextf(d, WF_XY(b), 14, WF_INK_BODY2, b.x < o.x ? 1 : 0, "(%.2f, %.2f)",
                (double)q.x, (double)q.y);
    figure_arc(d, o, WF_R(0.6), 0, angle, WF_INK_ACCENT);
    wfDrawTextf(d, 3.25f, 0.75f, 14, WF_INK_ACCENT, -1, "%.0f\xc2\xb0",
                (double)wfDegrees(angle));
}
/* <figures> */
static void figure_numbers_quarters(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(2.4f, 2.1f), v = figure_handle(in, 0, o);
    wfReal angle = wfAtan2(v.y, v.x);
    wfReal near = wfFloor(angle / (WF_PI / 2) + WF_R(0.5)) * (WF_PI / 2);
    wfDrawCircle(d, WF_XY(o), 1.7f, 1, WF_INK_LINE, WF_INK_NONE);
    for (int k = 0; k < 4; k++) {
        wfMat22 turn = wfMat22RotationDeg((wfReal)(45 + 90 * k));
        wfVec2 end = wfAdd(o, wfMat22MulV(turn, wfV2(WF_R(1.7), 0)));
        wfDrawDashed(d, WF_XY(o), WF_XY(end), 1, WF_INK_FAINT);
    }
    wfRot q = wfRotation(angle), n = wfRotation(near);
    figure_vector(d, o, wfScale(WF_R(1.7), wfV2(n.c, n.s)), WF_INK_BODY, "");
    figure_vector(d, o, wfScale(WF_R(1.7), wfV2(q.c, q.s)), WF_INK_ACCENT, "");
    figure_arc(d, o, 1, near, angle, WF_INK_ACCENT);
    wfDrawTextf(d, 4.9f, 3.6f, 14, WF_INK_ACCENT, 1, "x = %.3f", (double)angle);
    wfDrawTextf(d, 4.9f, 3.3f, 14, WF_INK_BODY, 1, "n = %.0f",
                (double)(near / (WF_PI / 2)));
    wfDrawTextf(d, 4.9f, 3.0f, 14, WF_INK_TEXT, 1, "r = %.3f", (double)(angle - near));
}
/* <figures> */
static void figure_numbers_lattice(wfDraw *d, const wfFigureInput *in)
{
    enum { CORNERS = 48 };
    float slide = (in->handle[0][0] - 0.4f) / 4.2f;
    int power = 17 + (int)(5 * (slide < 0 ? 0 : slide > 1 ? 1 : slide) + 0.5f);
    volatile float centre = 1.5f * (float)(1 << power), x, y;
    float gap = (float)(1 << power) / 8388608.0f, xy[2 * CORNERS];
    for (float gy = -1.5f; gap >= 0.05f && gy <= 1.5f; gy += gap)
        for (float gx = -1.5f; gx <= 1.5f; gx += gap)
            wfDrawPoint(d, 2.5f + gx, 2.3f + gy, 3, WF_INK_FAINT);
    for (int i = 0; i < CORNERS; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / CORNERS);
        x = centre + (float)q.c;
        y = centre + (float)q.s;
        xy[2 * i] = 2.5f + (x - centre);
        xy[2 * i + 1] = 2.3f + (y - centre);
    }
    wfDrawCircle(d, 2.5f, 2.3f, 1, 1, WF_INK_FAINT, WF_INK_NONE);
    wfDrawPolygon(d, xy, CORNERS, 2, WF_INK_ACCENT, WF_INK_BODY);
    /* <label the lattice> */
    wfDrawLine(d, 0.4f, 0.45f, 4.6f, 0.45f, 1, WF_INK_FAINT);
    wfDrawPoint(d, 0.4f + 4.2f * (float)(power - 17) / 5, 0.45f, 9, WF_INK_LINE);
    wfDrawTextf(d, 2.5f, 0.12f, 14, WF_INK_TEXT, 0, "%.0f km from the origin: gap %.3g m",
                (double)centre / 1000, (double)gap);
}
/* <figures> */
static void figure_numbers_transform(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 o = wfV2(0.4f, 0.4f), p = figure_handle(in, 0, o);
    wfVec2 axis = wfSub(figure_handle(in, 1, o), p), v = wfV2(WF_R(1.3), WF_R(0.8));
    wfTransform t = wfMakeTransform(p, wfAtan2(axis.y, axis.x));
    static const float box[4][2] = {
        { -0.7f, -0.5f }, { 1.8f, -0.5f }, { 1.8f, 1.1f }, { -0.7f, 1.1f }
    };
    float xy[8];
    for (int i = 0; i < 4; i++) {
        wfVec2 c = wfAdd(o, wfApply(t, wfV2((wfReal)box[i][0], (wfReal)box[i][1])));
        xy[2 * i] = (float)c.x;
        xy[2 * i + 1] = (float)c.y;
    }
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, WF_INK_BODY);
    /* <draw the axes and the point of the transform> */
    wfVec2 at = wfAdd(o, p), w = wfApply(t, v), middle = wfAddScaled(o, WF_R(0.5), p);
    figure_vector(d, o, wfV2(WF_R(1.0), 0), WF_INK_LINE, "x");
    figure_vector(d, o, wfV2(0, WF_R(1.0)), WF_INK_LINE, "y");
    figure_vector(d, at, wfRotate(t.q, wfV2(1, 0)), WF_INK_BODY2, "");
    figure_vector(d, at, wfRotate(t.q, wfV2(0, 1)), WF_INK_BODY2, "");
    figure_vector(d, o, p, WF_INK_FAINT, "");
    figure_vector(d, at, wfRotate(t.q, v), WF_INK_ACCENT, "");
    wfDrawText(d, (float)middle.x, (float)middle.y + 0.12f, 15, WF_INK_TEXT, 0, "p");
    wfDrawTextf(d, 0.2f, 3.85f, 14, WF_INK_BODY2, -1, "in the body: (%.2f, %.2f)",
                (double)v.x, (double)v.y);
    wfDrawTextf(d, 0.2f, 3.5f, 14, WF_INK_TEXT, -1, "in the world: (%.2f, %.2f)",
                (double)w.x, (double)w.y);
}
/* <figures> */
static void figure_ring(wfDraw *d, const wfVec2 *ring, int count, float widthPx, int line,
                        int fill)
{
    float xy[2 * WF_RIM_POINTS];
    for (int i = 0; i < count; i++) {
        xy[2 * i] = (float)ring[i].x;
        xy[2 * i + 1] = (float)ring[i].y;
    }
    wfDrawPolygon(d, xy, count, widthPx, line, fill);
}

/* <figures> */
static void figure_shape(wfDraw *d, const wfShape *s, wfTransform at, float widthPx,
                         int line, int fill)
{
    wfVec2 ring[WF_RIM_POINTS];
    wfVec2 centre = wfApply(at, s->centre);
    int n = wfShapeOutline(s, at, ring);
    if (s->kind == WF_SHAPE_CIRCLE)
        wfDrawCircle(d, WF_XY(centre), (float)s->radius, widthPx, line, fill);
    else if (n > 2) figure_ring(d, ring, n, widthPx, line, fill);
    else if (n == 2) wfDrawLine(d, WF_XY(ring[0]), WF_XY(ring[1]), widthPx, line);
}

static wfVec2 figure_handle_at(const wfFigureInput *in, int i)
{
    return wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]);
}
/* <figures> */
static void figure_shapes_bounds(wfDraw *d, const wfFigureInput *in)
{
    static const wfVec2 points[5] = { { { -1.5f, -0.5f } }, { { 1.3f, -0.6f } },
        { { 1.6f, 0.1f } }, { { 0.5f, 0.6f } }, { { -1.4f, 0.3f } } };
    wfVec2 p = wfV2(3, 2.2f), arm = wfSub(figure_handle_at(in, 0), p);
    wfTransform at = wfMakeTransform(p, wfAtan2(arm.y, arm.x));
    wfShape s, box;
    if (wfMakePolygon(points, 5, &s) != WF_OK) return;
    if (wfMakeOrientedBox(wfV2(0.05f, 0), 1.55f, 0.6f, 0, &box) != WF_OK) return;
    wfRect r = wfShapeBounds(&s, at);
    wfVec2 upright[4] = { r.min, wfV2(r.max.x, r.min.y), r.max, wfV2(r.min.x, r.max.y) };
    wfDrawCircle(d, WF_XY(p), (float)wfShapeExtent(&s), 1.5f, WF_INK_BODY2, WF_INK_NONE);
    figure_ring(d, upright, 4, 1.5f, WF_INK_ACCENT, WF_INK_NONE);
    figure_shape(d, &box, at, 1.5f, WF_INK_GOOD, WF_INK_NONE);
    figure_shape(d, &s, at, 2, WF_INK_LINE, WF_INK_BODY);
    wfDrawPoint(d, WF_XY(p), 6, WF_INK_LINE);
    /* <name the bounds in the figure> */
    wfDrawText(d, 0.1f, 0.2f, 13, WF_INK_BODY2, -1, "bounding circle");
    wfDrawText(d, 3, 0.2f, 13, WF_INK_ACCENT, 0, "axis-aligned bounds");
    wfDrawText(d, 5.9f, 0.2f, 13, WF_INK_GOOD, 1, "oriented box");
}
/* <figures> */
static void figure_shapes_hull(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 points[20], hull[20];
    wfRandom r;
    int n = 0;
    wfRandomSeed(&r, 7);
    for (int i = 0; i < in->handleCount; i++) points[n++] = figure_handle_at(in, i);
    while (n < 20) {
        wfReal x = wfRandomReal(&r, 2.6f, 5.2f);
        points[n++] = wfV2(x, wfRandomReal(&r, 1.6f, 3.4f));
    }
    int corners = wfConvexHull(points, n, hull);
    if (corners > 0 && corners <= WF_MAX_VERTICES)
        figure_ring(d, hull, corners, 2, WF_INK_LINE, WF_INK_BODY);
    for (int i = 0; i < n; i++) wfDrawPoint(d, WF_XY(points[i]), 5, WF_INK_TEXT);
    for (int i = 0; i < corners; i++) {
        wfDrawPoint(d, WF_XY(hull[i]), 8, WF_INK_ACCENT);
        wfVec2 label = wfLerp(wfV2(4, 2.5f), hull[i], 1.12f);
        label.y -= 0.08f;
        wfDrawTextf(d, WF_XY(label), 13, WF_INK_ACCENT, 0, "%d", i);
    }
}
/* <figures> */
static wfReal standing_height(const wfShape *s, wfReal tilt)
{
    return 0 - wfShapeBounds(s, wfMakeTransform(wfV2(0, 0), tilt)).min.y;
}

static void figure_rocking(wfDraw *d, const wfShape *s, float x, wfReal tilt,
                           const char *name)
{
    wfReal h = standing_height(s, tilt), most = WF_R(0.8);
    wfTransform at = wfMakeTransform(wfV2((wfReal)x, WF_R(0.3) + h), tilt);
    float curve[2 * 121];
    for (int i = 0; i < 121; i++) {
        wfReal angle = most * ((wfReal)i / 60 - 1);
        curve[2 * i] = x + 1.25f * (float)(angle / most);
        curve[2 * i + 1] = 1.2f + 3.2f * (float)standing_height(s, angle);
    }
    wfDrawLine(d, x - 1.5f, 0.3f, x + 1.5f, 0.3f, 2, WF_INK_LINE);
    figure_shape(d, s, at, 2, WF_INK_BODY, WF_INK_BODY);
    wfDrawPoint(d, WF_XY(at.p), 5, WF_INK_LINE);
    wfDrawPolyline(d, curve, 121, 2, WF_INK_ACCENT);
    float now = x + 1.25f * (float)(tilt / most);
    wfDrawPoint(d, now, 1.2f + 3.2f * (float)h, 7, WF_INK_LINE);
    wfDrawText(d, x, 5.6f, 14, WF_INK_TEXT, 0, name);
}
/* <figures> */
static void figure_shapes_rock(wfDraw *d, const wfFigureInput *in)
{
    static const char *const name[3] = { "box", "rounded box", "capsule" };
    wfReal most = WF_R(0.8), drag = figure_handle_at(in, 0).x - WF_R(1.7);
    wfReal tilt = wfClamp(drag * most / WF_R(1.25), -most, most);
    wfShape s[3];
    if (wfMakeBox(0.5f, 1, &s[0]) != WF_OK) return;
    if (wfMakeRoundedBox(0.3f, 0.8f, 0.2f, &s[1]) != WF_OK) return;
    if (wfMakeCapsule(wfV2(0, -0.5f), wfV2(0, 0.5f), 0.5f, &s[2]) != WF_OK) return;
    for (int i = 0; i < 3; i++) {
        float x = 1.7f + 3.3f * (float)i;
        figure_rocking(d, &s[i], x, tilt, name[i]);
        wfReal up = standing_height(&s[i], tilt + WF_R(0.01));
        wfReal down = standing_height(&s[i], tilt - WF_R(0.01));
        float foot = x - (float)((up - down) / WF_R(0.02));         /* eq:shapes-rock */
        wfDrawPoint(d, foot, 0.3f, 9, WF_INK_ACCENT);
    }
}
/* <figures> */
static void figure_shapes_tiles(wfDraw *d, const wfFigureInput *in)
{
    wfShape tile, crate;
    wfVec2 p = figure_handle_at(in, 0);
    if (wfMakeBox(1.9f, 0.6f, &tile) != WF_OK) return;
    if (wfMakeBox(0.9f, 0.7f, &crate) != WF_OK) return;
    wfTransform left = wfMakeTransform(wfV2(2.1f, 0.8f), 0);
    wfTransform right = wfMakeTransform(wfV2(5.9f, 0.8f), 0);
    wfRect c = wfShapeBounds(&crate, wfMakeTransform(p, 0));
    wfRect t = wfShapeBounds(&tile, right);
    figure_shape(d, &tile, left, 2, WF_INK_LINE, WF_INK_BODY);
    figure_shape(d, &tile, right, 2, WF_INK_LINE, WF_INK_BODY);
    figure_shape(d, &crate, wfMakeTransform(p, 0), 2, WF_INK_BODY2, WF_INK_NONE);
    wfReal up = t.max.y - c.min.y, back = c.max.x - t.min.x;
    if (up <= 0 || back <= 0) return;
    bool bump = back < up;
    wfVec2 corner = wfV2(c.max.x, c.min.y);
    wfVec2 above = wfAddScaled(corner, up, wfV2(0, 1));
    wfVec2 behind = wfAddScaled(corner, -back, wfV2(1, 0));
    wfDrawArrow(d, WF_XY(corner), WF_XY(above), bump ? 1.5f : 4, WF_INK_GOOD);
    wfDrawArrow(d, WF_XY(corner), WF_XY(behind), bump ? 4 : 1.5f, WF_INK_BAD);
    wfDrawText(d, 4, 3.2f, 14, bump ? WF_INK_BAD : WF_INK_GOOD, 0,
               bump ? "the tile's side: a bump" : "the tile's top: all is well");
}
/* <figures> */
static void figure_sector(wfDraw *d, wfVec2 at, wfVec2 from, wfReal turn, wfReal r,
                          int role)
{
    wfVec2 fan[14];
    fan[0] = at;
    for (int k = 0; k <= 12; k++) {
        wfRot q = wfRotation(turn * (wfReal)k / 12);
        fan[k + 1] = wfAddScaled(at, r, wfRotate(q, from));
    }
    figure_ring(d, fan, 14, 1.5f, WF_INK_LINE, role);
}
/* <figures> */
static void figure_shapes_steiner(wfDraw *d, const wfFigureInput *in)
{
    static const wfVec2 fixed[2] = { { { 1.3f, 1.3f } }, { { 4.2f, 1.2f } } };
    wfVec2 points[3] = { fixed[0], fixed[1], figure_handle_at(in, 0) };
    wfVec2 disk = wfV2(7.3f, 2.4f);
    wfShape s;
    if (wfMakeRoundedPolygon(points, 3, 0.8f, &s) != WF_OK) return;
    figure_ring(d, s.vertices, s.count, 2, WF_INK_LINE, WF_INK_BODY);
    for (int i = 0; i < s.count; i++) {
        wfVec2 a = s.vertices[i], b = s.vertices[(i + 1) % s.count];
        wfVec2 n = s.normals[i], before = s.normals[(i + s.count - 1) % s.count];
        wfVec2 strip[4] = { a, wfAddScaled(a, s.radius, n), wfAddScaled(b, s.radius, n),
                            b };
        wfReal turn = wfAtan2(wfCross(before, n), wfDot(before, n));
        figure_ring(d, strip, 4, 1.5f, WF_INK_LINE, WF_INK_BODY2);
        figure_sector(d, a, before, turn, s.radius, WF_INK_GOOD);
        figure_sector(d, disk, before, turn, s.radius, WF_INK_GOOD);
    }
    wfDrawPoint(d, WF_XY(s.centre), 7, WF_INK_ACCENT);
    wfDrawText(d, (float)disk.x, 1.15f, 14, WF_INK_TEXT, 0, "all sectors");
}
/* <figures> */
static void figure_shapes_green(wfDraw *d, const wfFigureInput *in)
{
    static const wfVec2 points[5] = { { { 3.2f, 1.6f } }, { { 5.8f, 1.2f } },
        { { 7.2f, 2.8f } }, { { 5.6f, 4.4f } }, { { 3.4f, 3.9f } } };
    wfVec2 o = figure_handle_at(in, 0);
    wfShape s;
    if (wfMakePolygon(points, 5, &s) != WF_OK) return;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < s.count; i++) {
            wfVec2 fan[3] = { o, s.vertices[i], s.vertices[(i + 1) % s.count] };
            bool positive = wfCross(wfSub(fan[1], o), wfSub(fan[2], o)) > 0;
            int role = positive ? WF_INK_GOOD : WF_INK_BAD;
            if (positive == (pass == 0)) figure_ring(d, fan, 3, 1, role, role);
        }
    figure_ring(d, s.vertices, s.count, 2.5f, WF_INK_LINE, WF_INK_NONE);
    /* <mark origin, area and centroid in the figure> */
    wfDrawPoint(d, WF_XY(o), 8, WF_INK_LINE);
    wfDrawText(d, (float)o.x - 0.15f, (float)o.y - 0.3f, 14, WF_INK_TEXT, 1, "o");
    wfDrawPoint(d, WF_XY(s.centre), 7, WF_INK_LINE);
    wfDrawText(d, (float)s.centre.x + 0.15f, (float)s.centre.y, 14, WF_INK_TEXT, -1, "c");
    wfDrawTextf(d, 7.8f, 0.3f, 14, WF_INK_TEXT, 1, "A = %.2f", (double)wfShapeArea(&s));
}
/* <figures> */
static void figure_shapes_axis(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 q = figure_handle_at(in, 0);
    wfShape s;
    wfMassData m;
    if (wfMakeOrientedBox(wfV2(4.6f, 2.7f), 1.8f, 0.8f, 0.3f, &s) != WF_OK) return;
    if (wfShapeMassOf(&s, 3, &m) != WF_OK) return;
    figure_shape(d, &s, wfTransformIdentity(), 2, WF_INK_LINE, WF_INK_BODY);
    wfDrawDashed(d, WF_XY(q), WF_XY(m.centre), 1.5f, WF_INK_ACCENT);
    wfVec2 middle = wfLerp(q, m.centre, 0.5f);
    wfDrawText(d, (float)middle.x, (float)middle.y + 0.15f, 14, WF_INK_ACCENT, 0, "d");
    wfDrawPoint(d, WF_XY(m.centre), 8, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(q), 8, WF_INK_ACCENT);
    wfDrawText(d, (float)m.centre.x + 0.15f, (float)m.centre.y, 14, WF_INK_TEXT, -1, "c");
    wfDrawText(d, (float)q.x - 0.15f, (float)q.y, 14, WF_INK_TEXT, 1, "q");
    wfDrawTextf(d, 0.3f, 0.3f, 14, WF_INK_TEXT, -1, "m = 3 kg, about c: %.2f kg m²",
                (double)m.inertia);
    wfDrawTextf(d, 7.8f, 0.3f, 14, WF_INK_ACCENT, 1, "about q: %.2f kg m²",
                (double)wfInertiaAbout(&m, q));
}
/* <figures> */
static void figure_bodies_velocity(wfDraw *d, const wfFigureInput *in)
{
    wfShape plate;
    wfBodyState s = { .p = { { 4, 2.6f } }, .angle = 0.2f, .w = 0.9f };
    s.v = wfScale(2.5f, wfSub(figure_handle_at(in, 0), s.p));
    if (wfMakeBox(2.4f, 1.2f, &plate) != WF_OK) return;
    wfTransform at = wfBodyTransform(&s);
    figure_shape(d, &plate, at, 2, WF_INK_LINE, WF_INK_BODY);
    for (int i = -2; i <= 2; i++)
        for (int j = -1; j <= 1; j++) {
            wfVec2 x = wfApply(at, wfV2((wfReal)i, (wfReal)j * 0.9f));
            wfVec2 tip = wfAddScaled(x, 0.4f, wfVelocityAt(&s, x));
            bool centre = i == 0 && j == 0;
            wfDrawArrow(d, WF_XY(x), WF_XY(tip), centre ? 3 : 1.5f,
                        centre ? WF_INK_ACCENT : WF_INK_LINE);
        }
    wfVec2 still = wfAddScaled(s.p, 1 / s.w, wfPerpCCW(s.v));
    wfDrawCircle(d, WF_XY(still), 0.12f, 2, WF_INK_GOOD, WF_INK_NONE);
    wfVec2 rest = wfVelocityAt(&s, still);
    wfDrawTextf(d, 0.3f, 0.25f, 14, WF_INK_GOOD, -1, "speed at the ring: %.1f m/s",
                (double)wfLength(rest));
}
/* <figures> */
static void figure_bodies_lever(wfDraw *d, const wfFigureInput *in)
{
    wfShape plate;
    wfBodyForces sums = { .torque = 0 };
    wfBodyState s = { .p = { { 3.4f, 2.4f } }, .angle = 0.15f };
    wfVec2 x = figure_handle_at(in, 0), force = wfV2(0.9f, 1.5f);
    wfVec2 along = wfNormalize(force);
    wfVec2 foot = wfAddScaled(x, wfDot(wfSub(s.p, x), along), along);
    if (wfMakeBox(2, 0.9f, &plate) != WF_OK) return;
    wfApplyForce(&sums, &s, force, x);
    figure_shape(d, &plate, wfBodyTransform(&s), 2, WF_INK_LINE, WF_INK_BODY);
    wfDrawDashed(d, WF_XY(wfAddScaled(x, -2.5f, along)), WF_XY(wfAddScaled(x, 2.6f, along)),
                 1, WF_INK_FAINT);
    wfDrawLine(d, WF_XY(s.p), WF_XY(foot), 2, WF_INK_GOOD);
    wfDrawArrow(d, WF_XY(s.p), WF_XY(x), 1.5f, WF_INK_LINE);
    wfDrawArrow(d, WF_XY(x), WF_XY(wfAdd(x, force)), 2.5f, WF_INK_ACCENT);
    /* <name the parts of the lever> */
    wfVec2 middle = wfLerp(s.p, x, 0.5f), tip = wfAdd(x, force);
    wfDrawPoint(d, WF_XY(s.p), 7, WF_INK_LINE);
    wfDrawText(d, (float)middle.x, (float)middle.y + 0.15f, 14, WF_INK_TEXT, 0, "r");
    wfDrawText(d, (float)tip.x + 0.15f, (float)tip.y - 0.1f, 14, WF_INK_ACCENT, -1, "F");
    wfDrawTextf(d, 0.3f, 0.3f, 14, WF_INK_GOOD, -1, "arm %.2f m",
                (double)wfDistance(s.p, foot));
    wfDrawTextf(d, 3.7f, 0.3f, 14, WF_INK_ACCENT, 0, "force %.2f N", (double)wfLength(force));
    wfDrawTextf(d, 6.8f, 0.3f, 14, WF_INK_TEXT, 1, "torque %.2f N m", (double)sums.torque);
}
/* <figures> */
static void figure_bodies_blows(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfMassData m;
    wfBodyProps props = wfDefaultBodyProps();
    wfReal t = 0.3f + (wfReal)in->time;
    if (wfMakeBox(0.85f, 0.35f, &box) != WF_OK || wfShapeMass(&box, 2, &m) != WF_OK) return;
    for (int i = 0; i < 5; i++) {
        wfBodyState s = { .p = { { 1.1f + 2.1f * (wfReal)i, 0.9f } } };
        wfVec2 hit = wfAdd(s.p, wfV2(0.08f * (wfReal)i, -0.35f));
        if (wfSetMass(&s, &props, m.mass, m.inertia) != WF_OK) return;
        figure_shape(d, &box, wfBodyTransform(&s), 1, WF_INK_FAINT, WF_INK_NONE);
        wfDrawArrow(d, (float)hit.x, (float)hit.y - 0.5f, WF_XY(hit), 2.5f, WF_INK_ACCENT);
        wfApplyImpulse(&s, wfV2(0, 12), hit);
        s.p = wfAddScaled(s.p, t, s.v);
        s.angle += t * s.w;
        figure_shape(d, &box, wfBodyTransform(&s), 2, WF_INK_LINE, WF_INK_BODY);
        wfVec2 nose = wfApply(wfBodyTransform(&s), wfV2(0.85f, 0));
        wfDrawLine(d, WF_XY(s.p), WF_XY(nose), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(s.p), 5, WF_INK_LINE);
        wfDrawTextf(d, (float)s.p.x, 3.75f, 13, WF_INK_TEXT, 0, "%.1f rad/s", (double)s.w);
    }
}
/* <figures> */
static void forces_arrow(wfDraw *d, wfVec2 at, wfVec2 force, wfReal scale, int ink)
{
    wfVec2 end = wfAddScaled(at, scale, force);
    if (wfDistance(at, end) > 0.03f) wfDrawArrow(d, WF_XY(at), WF_XY(end), 2.5f, ink);
}

static void forces_shape(wfDraw *d, const wfShape *s, wfTransform at, int ink)
{
    float xy[2 * WF_RIM_POINTS];
    wfVec2 rim[WF_RIM_POINTS], centre = wfApply(at, s->centre);
    int n = wfShapeOutline(s, at, rim);
    for (int i = 0; i < n; i++) {
        xy[2 * i] = (float)rim[i].x;
        xy[2 * i + 1] = (float)rim[i].y;
    }
    if (s->kind == WF_SHAPE_CIRCLE)
        wfDrawCircle(d, WF_XY(centre), (float)s->radius, 2, WF_INK_LINE, ink);
    else
        wfDrawPolygon(d, xy, n, 2, WF_INK_LINE, ink);
}
/* <figures> */
/* The sums of force and torque on the bodies of a figure. */
static void forces_sum(const wfForce *f, int n, const wfBodyState *state,
                       const wfShape *shapes, int count, wfBodyForces *out)
{
    wfBodyProps props[4];
    for (int i = 0; i < count; i++) {
        props[i] = wfDefaultBodyProps();
        props[i].shape = shapes ? i : -1;
        out[i] = (wfBodyForces){ .torque = 0 };
    }
    wfBodyView view = { .count = count, .state = state, .props = props, .shapes = shapes };
    wfAccumulateForces(f, n, &view, 0, out);
}
/* <figures> */
static void figure_forces_point(wfDraw *d, const wfFigureInput *in)
{
    wfForce f[2];
    for (int k = 0; k < 2; k++) {
        wfVec2 c = wfV2((wfReal)in->handle[k][0], (wfReal)in->handle[k][1]);
        f[k] = wfPointGravity(c, k ? 1 : 3, WF_R(0.3));
    }
    for (int i = 0; i < 13; i++)
        for (int j = 0; j < 8; j++) {
            wfReal x = WF_R(0.4) + WF_R(0.6) * (wfReal)i;
            wfBodyState b = { .p = { { x, WF_R(0.4) + WF_R(0.6) * (wfReal)j } },
                              .invMass = 1 };
            wfBodyForces sum;
            forces_sum(f, 2, &b, NULL, 1, &sum);
            wfReal root = wfSqrt(wfSqrt(wfLength(sum.force)));  /* or the far ones vanish */
            wfVec2 end = wfAddScaled(b.p, WF_R(0.4) * root, wfNormalize(sum.force));
            wfDrawPoint(d, WF_XY(b.p), 3, WF_INK_FAINT);
            wfDrawArrow(d, WF_XY(b.p), WF_XY(end), 1.5f, WF_INK_BODY);
        }
    for (int k = 0; k < 2; k++)
        wfDrawCircle(d, WF_XY(f[k].point.centre), k ? 0.17f : 0.3f, 2, WF_INK_LINE,
                     WF_INK_ACCENT);
}
/* <figures> */
static void figure_forces_spring(wfDraw *d, const wfFigureInput *in)
{
    wfShape shape[2];
    wfBodyState b[2] = { { .angle = WF_R(0.4), .invMass = 1, .invInertia = 1 },
                         { .invMass = 1, .invInertia = 1 } };
    wfBodyForces sum[2];
    for (int i = 0; i < 2; i++)
        b[i].p = wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]);
    if (wfMakeBox(0.8f, 0.5f, &shape[0]) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), 0.5f, &shape[1]) != WF_OK) return;
    wfForce f = wfSpring(0, wfV2(0.8f, 0.5f), 1, wfV2(-0.5f, 0), 2, 1, 0);
    forces_sum(&f, 1, b, shape, 2, sum);
    wfVec2 end[2] = { wfApply(wfBodyTransform(&b[0]), f.spring.localA),
                      wfApply(wfBodyTransform(&b[1]), f.spring.localB) };
    for (int i = 0; i < 2; i++)
        forces_shape(d, &shape[i], wfBodyTransform(&b[i]), WF_INK_BODY);
    /* <draw the spring as a zigzag> */
    wfVec2 along = wfSub(end[1], end[0]), side = wfPerpCCW(wfNormalize(along));
    float zig[2 * 18];
    for (int k = 0; k < 18; k++) {
        wfReal t = k == 0 ? 0 : k == 17 ? 1 : ((wfReal)k - WF_R(0.5)) / 16;
        wfReal out = k == 0 || k == 17 ? 0 : k & 1 ? WF_R(0.12) : WF_R(-0.12);
        wfVec2 p = wfAddScaled(wfAddScaled(end[0], t, along), out, side);
        zig[2 * k] = (float)p.x, zig[2 * k + 1] = (float)p.y;
    }
    wfDrawPolyline(d, zig, 18, 1.5f, WF_INK_LINE);
    for (int i = 0; i < 2; i++) {
        forces_arrow(d, end[i], sum[i].force, WF_R(0.7), WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(b[i].p), 5, WF_INK_LINE);
        wfDrawTextf(d, (float)b[i].p.x, (float)b[i].p.y - 1.2f, 13, WF_INK_TEXT, 0,
                    "torque %+.2f", (double)sum[i].torque);
    }
}
/* <figures> */
static void figure_forces_float(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfBodyForces sum;
    wfVec2 p = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 arm = wfSub(wfV2((wfReal)in->handle[1][0], (wfReal)in->handle[1][1]), p);
    wfBodyState b = { .p = p, .angle = wfAtan2(arm.y, arm.x), .invMass = WF_R(0.25),
                      .invInertia = 1 };
    if (wfMakeBox(1.6f, 0.8f, &box) != WF_OK) return;
    wfForce f = wfBuoyancy(2, 2, 1, 0);
    forces_sum(&f, 1, &b, &box, 1, &sum);
    wfSubmerged wet = wfSubmergedPart(&box, wfBodyTransform(&b), 2);
    float water[8] = { 0, 0, 7, 0, 7, 2, 0, 2 };
    wfDrawPolygon(d, water, 4, 1, WF_INK_FAINT, WF_INK_BODY);
    forces_shape(d, &box, wfBodyTransform(&b), WF_INK_PAPER);
    /* <draw the submerged part> */
    float part[4 * WF_MAX_VERTICES];
    int n = 0;
    wfVec2 from = wfApply(wfBodyTransform(&b), box.vertices[3]);
    for (int i = 0; i < 4; i++) {
        wfVec2 to = wfApply(wfBodyTransform(&b), box.vertices[i]);
        wfVec2 cross = wfLerp(from, to, from.y == to.y ? 0 : (2 - from.y) / (to.y - from.y));
        if ((from.y < 2) != (to.y < 2)) part[n++] = (float)cross.x, part[n++] = 2;
        if (to.y < 2) part[n++] = (float)to.x, part[n++] = (float)to.y;
        from = to;
    }
    if (n >= 6) wfDrawPolygon(d, part, n / 2, 1, WF_INK_GOOD, WF_INK_GOOD);
    forces_arrow(d, p, wfV2(0, -4), WF_R(0.35), WF_INK_LINE);
    forces_arrow(d, wet.centre, sum.force, WF_R(0.35), WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(p), 7, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(wet.centre), 7, WF_INK_GOOD);
    wfDrawTextf(d, 0.15f, 3.7f, 13, WF_INK_TEXT, -1, "under water: %.2f of %.2f m²",
                (double)wet.area, (double)wfShapeArea(&box));
    wfDrawTextf(d, 0.15f, 3.35f, 13, WF_INK_TEXT, -1, "torque %+.2f", (double)sum.torque);
}
/* <figures> */
static void figure_forces_coat(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfVec2 rim[WF_RIM_POINTS];
    wfTransform at = wfMakeTransform(wfV2((wfReal)in->handle[0][0],
                                          (wfReal)in->handle[0][1]), WF_R(0.5));
    if (wfMakeRoundedBox(1.1f, 0.35f, 0.6f, &box) != WF_OK) return;
    wfSubmerged wet = wfSubmergedPart(&box, at, 2);
    float water[8] = { 0, 0, 7, 0, 7, 2, 0, 2 };
    wfDrawPolygon(d, water, 4, 1, WF_INK_FAINT, WF_INK_BODY);
    forces_shape(d, &box, at, WF_INK_PAPER);
    float part[4 * WF_RIM_POINTS];
    int n = wfShapeOutline(&box, at, rim), corners = 0;
    /* <cut the rim at y = 2> */
    for (int i = 0; i < n; i++) {
        wfVec2 a = rim[i], b = rim[(i + 1) % n];
        if (a.y < 2) part[2 * corners] = (float)a.x, part[2 * corners++ + 1] = (float)a.y;
        if ((a.y < 2) == (b.y < 2)) continue;
        wfVec2 cut = wfLerp(a, b, (2 - a.y) / (b.y - a.y));
        part[2 * corners] = (float)cut.x, part[2 * corners++ + 1] = (float)cut.y;
    }
    if (corners > 2) wfDrawPolygon(d, part, corners, 1, WF_INK_GOOD, WF_INK_GOOD);
    /* <draw the chords of the arcs under water> */
    for (int i = 0; i < box.count; i++) {
        wfVec2 v = wfApply(at, box.vertices[i]);
        wfVec2 from = wfRotate(at.q, box.normals[(i + box.count - 1) % box.count]);
        wfVec2 to = wfRotate(at.q, box.normals[i]);
        from = wfAddScaled(v, box.radius, from);
        to = wfAddScaled(v, box.radius, to);
        if (from.y >= 2 && to.y >= 2) continue;
        if (from.y > 2 || to.y > 2) {           /* the surface cuts the arc */
            wfReal k = (2 - v.y) / box.radius, x = wfSqrt(1 - k * k);
            wfVec2 cut = wfAddScaled(v, box.radius, wfV2(from.y > 2 ? -x : x, k));
            if (from.y > 2) from = cut; else to = cut;
        }
        wfDrawLine(d, WF_XY(from), WF_XY(to), 1.5f, WF_INK_LINE);
    }
    wfDrawPoint(d, WF_XY(wet.centre), 7, WF_INK_LINE);
    wfDrawTextf(d, 0.15f, 3.7f, 13, WF_INK_TEXT, -1, "under water: %.2f of %.2f m²",
                (double)wet.area, (double)wfShapeArea(&box));
}
/* <figures> */
/* <float a box by one of three rules> */
enum { FLOAT_SIGN, FLOAT_DEPTH, FLOAT_EXACT, FLOAT_RULES };

/* A box of 1.2 m by 0.6 m and density 1 in water of density 2 below y = 0; g = 10. */
static wfBodyState float_begin(wfShape *box)
{
    wfMassData data = { .mass = 1, .inertia = 1 };
    if (wfMakeBox(0.6f, 0.3f, box) == WF_OK) (void)wfShapeMass(box, 1, &data);
    return (wfBodyState){ .p = { { 0, 0.5f } }, .angle = 0.5f, .invMass = 1 / data.mass,
                          .invInertia = 1 / data.inertia };
}
/* <float a box by one of three rules> */
static void float_step(int rule, const wfShape *box, wfBodyState *b, wfReal h)
{
    wfBodyProps props = wfDefaultBodyProps();
    wfBodyForces sum = { .torque = 0 };
    wfForce f[2] = { wfGravity(wfV2(0, -10)), wfBuoyancy(0, 2, 10, 4) };
    wfReal full = 20 * wfShapeArea(box);  /* the lift when all is under water */
    props.shape = 0;
    wfBodyView view = { .count = 1, .state = b, .props = &props, .shapes = box };
    wfAccumulateForces(f, rule == FLOAT_EXACT ? 2 : 1, &view, 0, &sum);
    if (rule == FLOAT_SIGN && b->p.y < 0) sum.force.y += full;
    if (rule == FLOAT_DEPTH) sum.force.y += full * wfClamp(0.5f - b->p.y / WF_R(0.6), 0, 1);
    b->v = wfAddScaled(b->v, h * b->invMass, sum.force);
    b->w += h * b->invInertia * sum.torque;
    b->p = wfAddScaled(b->p, h, b->v);
    b->angle += h * b->w;
}

static void figure_forces_float_time(wfDraw *d, const wfFigureInput *in)
{
    static const int ink[FLOAT_RULES] = { WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD };
    enum { STEPS = 480 };
    (void)in;
    wfDrawArrow(d, 0.3f, 3.6f, 9.8f, 3.6f, 1, WF_INK_FAINT);
    wfDrawArrow(d, 0.3f, 0.9f, 9.8f, 0.9f, 1, WF_INK_FAINT);
    for (int rule = 0; rule < FLOAT_RULES; rule++) {
        static float height[2 * STEPS], tilt[2 * STEPS];
        wfShape box;
        wfBodyState b = float_begin(&box);
        /* <record height and tilt of a box that floats> */
        for (int i = 0; i < STEPS; i++) {
            height[2 * i] = tilt[2 * i] = 0.3f + 9.2f * (float)i / STEPS;
            height[2 * i + 1] = 3.6f + 1.6f * (float)b.p.y;
            tilt[2 * i + 1] = 0.9f + 1.6f * (float)b.angle;
            float_step(rule, &box, &b, WF_R(1.0) / 60);
        }
        wfDrawPolyline(d, height, STEPS, 2, ink[rule]);
        wfDrawPolyline(d, tilt, STEPS, 2, ink[rule]);
    }
    wfDrawText(d, 0.3f, 4.85f, 13, WF_INK_TEXT, -1, "height");
    wfDrawText(d, 0.3f, 1.95f, 13, WF_INK_TEXT, -1, "tilt");
    wfDrawText(d, 9.8f, 0.55f, 13, WF_INK_TEXT, 1, "8 s");
}
/* <figures> */
static void figure_forces_wind(wfDraw *d, const wfFigureInput *in)
{
    static const wfVec2 point[4] = { { { -1.2f, -0.7f } }, { { 0.9f, -0.7f } },
        { { 0.9f, -0.2f } }, { { -1.2f, 1.1f } } };
    wfShape s;
    wfBodyForces sum;
    wfVec2 at = wfV2(4.2f, 2.2f);
    wfVec2 wind = wfSub(at, wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]));
    if (wfMakePolygon(point, 4, &s) != WF_OK) return;
    wfShapeMove(&s, wfNeg(s.centre));
    wfBodyState b = { .p = at, .invMass = 1, .invInertia = 1 };
    wfForce f = wfWind(wind, WF_R(0.1));
    forces_sum(&f, 1, &b, &s, 1, &sum);
    wfVec2 middle, u = wfNormalize(wind), side = wfPerpCCW(u);
    wfReal width = wfSeenWidth(&s, wfBodyTransform(&b), u, &middle);
    /* <draw the streams that arrive> */
    for (int k = -2; k <= 2; k++) {
        wfVec2 to = wfAddScaled(middle, width * (wfReal)k / 4, side);
        wfVec2 from = wfAddScaled(to, WF_R(-3.2), u);
        wfVec2 stop = wfAddScaled(to, -1.5f, u);
        wfDrawArrow(d, WF_XY(from), WF_XY(stop), 1.2f, WF_INK_FAINT);
        if (k == 2 || k == -2) wfDrawDashed(d, WF_XY(stop), WF_XY(to), 1, WF_INK_FAINT);
    }
    forces_shape(d, &s, wfBodyTransform(&b), WF_INK_BODY);
    forces_arrow(d, middle, sum.force, WF_R(0.8), WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(middle), 6, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(at), 6, WF_INK_LINE);
    wfDrawTextf(d, 7.8f, 0.2f, 13, WF_INK_TEXT, 1, "width %.2f m, torque %+.2f",
                (double)width, (double)sum.torque);
}
/* <figures> */
/* The pulse at t seconds, of 1 N s in all: kind 0 as a box, 1 as the engine has it. */
static wfReal blast_level(int kind, wfReal t)
{
    wfForce f = wfExplosion(wfV2(0, -1), 4, 2, -t, 1);
    wfBodyState particle = { .p = { { 0, 0 } }, .invMass = 1 };
    wfBodyForces sum;
    if (kind == 0) return t > 0 && t < 1 ? 1 : 0;
    forces_sum(&f, 1, &particle, NULL, 1, &sum);
    return sum.force.y;
}
/* <figures> */
static void figure_forces_blast(wfDraw *d, const wfFigureInput *in)
{
    wfReal step = WF_R(0.4), phase = ((wfReal)in->handle[0][0] - WF_R(0.8)) / 3;
    phase -= step * wfFloor(phase / step);
    for (int kind = 0; kind < 2; kind++) {
        float left = 0.8f + 4.6f * (float)kind, curve[2 * 65];
        wfReal sum = 0;
        for (int i = 0; i <= 64; i++) {
            wfReal t = ((wfReal)i + WF_R(0.5)) / 65;
            curve[2 * i] = left + 3 * (float)t;
            curve[2 * i + 1] = 0.8f + 1.1f * (float)blast_level(kind, t);
        }
        /* <draw what an integrator sees of the pulse> */
        for (wfReal t = phase - step; t < WF_R(1.2); t += step) {
            wfReal level = blast_level(kind, t);
            float x = left + 3 * (float)t, y = 0.8f + 1.1f * (float)level;
            float next = x + 3 * (float)step;
            float bar[8] = { x, 0.8f, next, 0.8f, next, y, x, y };
            if (level > 0) wfDrawPolygon(d, bar, 4, 1, WF_INK_BODY, WF_INK_BODY);
            wfDrawLine(d, x, 0.65f, x, 0.8f, 2, WF_INK_ACCENT);
            sum += step * level;
        }
        wfDrawPolyline(d, curve, 65, 2.5f, WF_INK_LINE);
        wfDrawArrow(d, left - 0.6f, 0.8f, left + 3.8f, 0.8f, 1, WF_INK_FAINT);
        wfDrawTextf(d, left + 1.5f, 3.3f, 14, kind ? WF_INK_GOOD : WF_INK_BAD, 0,
                    "impulse %.2f", (double)sum);
    }
    wfDrawPoint(d, in->handle[0][0], in->handle[0][1], 9, WF_INK_ACCENT);
}
/* <figures> */
static void orbit_pull(void *context, const wfBodyState *state, int count, wfReal time,
                       wfBodyForces *out)
{
    wfBodyProps props = wfDefaultBodyProps();
    wfBodyView view = { .count = count, .state = state, .props = &props };
    wfAccumulateForces(context, 1, &view, time, out);
}

/* Moves a body under one force by so many steps of h; its places go to xy, unless that is
   NULL. Returns the number of places. */
static int figure_path(const char *method, wfBodyState *body, wfForce *force, double h,
                       int steps, float *xy)
{
    _Alignas(WF_POOL_ALIGN) uint8_t bytes[2048];
    wfPool pool;
    if (wfPoolInit(&pool, sizeof bytes, bytes) != WF_OK) return 0;
    wfIntegration in = { .state = body, .count = 1, .h = (wfReal)h, .forces = orbit_pull,
                         .context = force, .scratch = &pool };
    for (int n = 0; n <= steps; n++) {
        if (xy) xy[2 * n] = (float)body->p.x, xy[2 * n + 1] = (float)body->p.y;
        if (n < steps && wfIntegrate(wfFindIntegrator(method), &in) != WF_OK) return n + 1;
    }
    return steps + 1;
}
/* <figures> */
static void figure_int_orbits(wfDraw *d, const wfFigureInput *in)
{
    /* <the methods that fly, and their colours> */
    static const char *const method[4] = { "rk4", "explicit-euler", "symplectic-euler",
                                           "verlet" };
    static const int ink[4] = { WF_INK_FAINT, WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD };
    wfVec2 sun = wfV2(4, 2.6f);
    wfVec2 start = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 r = wfSub(start, sun);
    wfReal reach = wfLength(r), speed = wfSqrt(WF_R(1.1) / wfMaxR(reach, WF_R(0.1)));
    wfBodyState body = { .p = start, .v = wfScale(speed, wfPerpCCW(wfNormalize(r))),
                         .invMass = 1 };
    wfForce pull = wfPointGravity(sun, 1, 0);
    double turn = 6.2831853 / (double)wfSqrt(wfSquare(2 / reach - speed * speed)
                                             * wfAbs(2 / reach - speed * speed));
    for (int k = 0; k < 4; k++) {
        static float xy[2 * 2002];
        int fine = k == 0 ? 16 : 1;
        wfBodyState planet = body;
        int steps = k == 0 ? 640 : 120;
        int n = figure_path(method[k], &planet, &pull, turn / 40 / fine, steps, xy);
        /* <draw the path, and a dot for each step> */
        if (n >= 2) wfDrawPolyline(d, xy, n, k == 0 ? 3 : 1.5f, ink[k]);
        if (k == 0) continue;
        for (int i = 0; i < n; i++) wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3, ink[k]);
        wfDrawText(d, 7.8f, 0.32f * (float)k - 0.1f, 13, ink[k], 1, method[k]);
    }
    wfDrawPoint(d, WF_XY(sun), 14, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(start), 8, WF_INK_LINE);
}
/* <figures> */
/* 2 to the power u, 0 <= u <= 8: whole powers, and between them by 2^(1/2), 2^(1/4) ... */
static wfReal two_to(wfReal u)
{
    wfReal out = 1, root = 2;
    for (; u >= 1; u -= 1) out *= 2;
    for (int k = 0; k < 12; k++) {
        root = wfSqrt(root);
        u *= 2;
        if (u >= 1) out *= root, u -= 1;
    }
    return out;
}
/* <figures> */
/* The line with the handle; returns its place, 0 at the left end to 1 at the right. */
static wfReal handle_line(wfDraw *d, const wfFigureInput *in, const char *left,
                          const char *right)
{
    float x = in->handle[0][0] < 1 ? 1 : in->handle[0][0] > 7 ? 7 : in->handle[0][0];
    wfDrawLine(d, 1, 0.3f, 7, 0.3f, 1.5f, WF_INK_LINE);
    wfDrawPoint(d, x, 0.3f, 9, WF_INK_LINE);
    wfDrawText(d, 0.9f, 0.25f, 11, WF_INK_TEXT, 1, left);
    wfDrawText(d, 7.1f, 0.25f, 11, WF_INK_TEXT, -1, right);
    return (wfReal)(x - 1) / 6;
}

static wfReal step_line(wfDraw *d, const wfFigureInput *in)
{
    return handle_line(d, in, "short", "long");
}
/* <figures> */
static void figure_int_step(wfDraw *d, const wfFigureInput *in)
{
    static const char *const method[3] = { "explicit-euler", "symplectic-euler", "rk4" };
    static const int ink[3] = { WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD };
    static float xy[2 * 1202];
    wfVec2 sun = wfV2(4, WF_R(2.9));
    int a_turn = (int)(400 / two_to(6 * step_line(d, in)));     /* 400 down to 6 */
    wfForce pull = wfPointGravity(sun, 1, 0);
    wfDrawPoint(d, WF_XY(sun), 14, WF_INK_LINE);
    for (int k = 0; k < 3; k++) {
        wfBodyState planet = { .p = wfV2(5, WF_R(2.9)), .v = wfV2(0, WF_R(1.0488)),
                               .invMass = 1 };
        double turn = 6.2831853 / 0.8538;   /* 0.9^(3/2): half axis 1 / 0.9 */
        int n = figure_path(method[k], &planet, &pull, turn / a_turn, 3 * a_turn, xy);
        for (int i = 0; i < n; i++)         /* what is thrown out is cut off */
            if (!(xy[2 * i] > -4 && xy[2 * i] < 12 && xy[2 * i + 1] > -4 &&
                  xy[2 * i + 1] < 10))
                n = i;
        if (n >= 2) wfDrawPolyline(d, xy, n, 1.5f, ink[k]);
        for (int i = 0; i < n && a_turn < 100; i++)
            wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3, ink[k]);
        wfDrawText(d, 7.8f, 5.2f - 0.3f * (float)k, 13, ink[k], 1, method[k]);
    }
    wfDrawTextf(d, 4, 0.5f, 13, WF_INK_TEXT, 0, "%d steps a turn", a_turn);
}
/* <figures> */
static void figure_int_step_spring(wfDraw *d, const wfFigureInput *in)
{
    static const char *const method[5] = { "explicit-euler", "symplectic-euler", "verlet",
                                           "rk4", "implicit-midpoint" };
    static const int ink[5] = { WF_INK_BAD, WF_INK_ACCENT, WF_INK_BODY2, WF_INK_GOOD,
                                WF_INK_BODY };
    static float xy[2 * 402];
    wfReal h = WF_R(0.0625) * two_to(6 * step_line(d, in));     /* 1/16 to 4 */
    int steps = (int)(20 / h);
    wfForce spring = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, 1, 0);
    wfDrawLine(d, 0.5f, 2.9f, 7.5f, 2.9f, 1, WF_INK_FAINT);
    for (int k = 0; k < 5; k++) {
        wfBodyState body = { .p = wfV2(1, 0), .invMass = 1 };
        /* <draw how far it is over time> */
        int n = figure_path(method[k], &body, &spring, (double)h, steps, xy);
        for (int i = 0; i < n; i++) {
            float y = 2.9f + xy[2 * i];
            xy[2 * i + 1] = y;
            xy[2 * i] = 0.5f + 7 * (float)h / 20 * (float)i;
            if (!(y > 0.7f && y < 5.1f)) n = i;
        }
        if (n >= 2) wfDrawPolyline(d, xy, n, 1.5f, ink[k]);
        for (int i = 0; i < n && steps < 100; i++)
            wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 3, ink[k]);
        wfDrawText(d, 1.6f * (float)k + 0.1f, 5.25f, 11, ink[k], -1, method[k]);
    }
    wfDrawTextf(d, 4, 0.5f, 13, WF_INK_TEXT, 0, "step times omega: %.2f", (double)h);
}
/* <figures> */
static void figure_int_patch(wfDraw *d, const char *method, wfVec2 patch, int steps,
                             int ink)
{
    enum { N = 48 };
    float xy[2 * N];
    wfForce pull = wfSpringToPoint(0, wfV2(0, 0), wfV2(0, 0), 0, 1, 0);
    for (int i = 0; i < N; i++) {
        wfReal s, c;
        wfSinCos((wfReal)i * (2 * WF_PI / N), &s, &c);
        wfBodyState b = { .p = { { patch.x + WF_R(0.35) * c, 0 } }, .invMass = 1,
                          .v = { { patch.y + WF_R(0.35) * s, 0 } } };
        bool exact = strcmp(method, "rk4") == 0;
        figure_path(method, &b, &pull, exact ? 0.05 : 0.4, exact ? 8 * steps : steps, NULL);
        xy[2 * i] = 4 + (float)b.p.x;
        xy[2 * i + 1] = 2.6f + (float)b.v.x;
    }
    wfDrawPolygon(d, xy, N, 2, ink, steps == 0 ? WF_INK_BODY : WF_INK_NONE);
}
/* <figures> */
static void figure_int_area(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 at = wfV2((wfReal)in->handle[0][0] - 4, (wfReal)in->handle[0][1] - WF_R(2.6));
    wfDrawArrow(d, 0.6f, 2.6f, 7.4f, 2.6f, 1, WF_INK_FAINT);
    wfDrawArrow(d, 4, 0.2f, 4, 5, 1, WF_INK_FAINT);
    wfDrawText(d, 7.4f, 2.25f, 13, WF_INK_TEXT, 1, "place");
    wfDrawText(d, 4.15f, 4.8f, 13, WF_INK_TEXT, -1, "velocity");
    wfDrawCircle(d, 4, 2.6f, (float)wfLength(at), 1, WF_INK_FAINT, WF_INK_NONE);
    figure_int_patch(d, "rk4", at, 0, WF_INK_LINE);
    for (int steps = 4; steps <= 12; steps += 4) {
        figure_int_patch(d, "rk4", at, steps, WF_INK_FAINT);
        figure_int_patch(d, "symplectic-euler", at, steps, WF_INK_ACCENT);
        if (steps <= 8) figure_int_patch(d, "explicit-euler", at, steps, WF_INK_BAD);
    }
}
/* <figures> */
static float figure_curve(float x)
{
    return 0.55f + 1.5f * x * (1.9f - x) + 0.35f * x * x * x;
}

/* What rule `kind' puts in the place of the curve, at x in [0, 1]. */
static float figure_rule(int kind, float x)
{
    float a = figure_curve(0), m = figure_curve(0.5f), b = figure_curve(1);
    if (kind == 0) return a;
    if (kind == 1) return a + (b - a) * x;
    if (kind == 2) return m;
    return a * (1 - x) * (1 - 2 * x) + 4 * m * x * (1 - x) - b * x * (1 - 2 * x);
}
/* <figures> */
static void figure_int_quadrature(wfDraw *d, const wfFigureInput *in)
{
    static const char *const name[4] = { "rectangle", "trapezoid", "midpoint", "parabola" };
    (void)in;
    for (int k = 0; k < 4; k++) {
        enum { N = 32 };
        float left = 0.4f + 2.4f * (float)k;
        float area[2 * (N + 3)], gap[4 * (N + 1)], curve[2 * (N + 1)];
        for (int i = 0; i <= N; i++) {
            float x = (float)i / N, at = left + 1.8f * x;
            curve[2 * i] = at, curve[2 * i + 1] = 0.5f + figure_curve(x);
            area[2 * i] = at, area[2 * i + 1] = 0.5f + figure_rule(k, x);
            memcpy(&gap[2 * i], &curve[2 * i], 2 * sizeof(float));
            memcpy(&gap[2 * (2 * N + 1 - i)], &area[2 * i], 2 * sizeof(float));
        }
        area[2 * (N + 1)] = left + 1.8f, area[2 * (N + 1) + 1] = 0.5f;
        area[2 * (N + 2)] = left, area[2 * (N + 2) + 1] = 0.5f;
        wfDrawPolygon(d, area, N + 3, 1, WF_INK_BODY, WF_INK_BODY);
        wfDrawPolygon(d, gap, 2 * (N + 1), 1, WF_INK_BAD, WF_INK_BAD);
        wfDrawPolyline(d, curve, N + 1, 2.5f, WF_INK_LINE);
        wfDrawArrow(d, left - 0.1f, 0.5f, left + 2.1f, 0.5f, 1, WF_INK_FAINT);
        wfDrawText(d, left + 0.9f, 0.12f, 13, WF_INK_TEXT, 0, name[k]);
    }
}
/* <figures> */
enum { BROAD_FIGURE_MOST = 40 };
typedef struct BroadFigure {
    wfRect bounds[BROAD_FIGURE_MOST];
    uint8_t flags[BROAD_FIGURE_MOST];
    wfPair pairs[BROAD_FIGURE_MOST * BROAD_FIGURE_MOST];
    _Alignas(WF_POOL_ALIGN) uint8_t scratch[1 << 15];
    wfPool pool;
} BroadFigure;

static void broadRect(wfDraw *d, wfRect r, float widthPx, int line, int fill)
{
    float x0 = (float)r.min.x, y0 = (float)r.min.y;
    float x1 = (float)r.max.x, y1 = (float)r.max.y;
    float xy[8] = { x0, y0, x1, y0, x1, y1, x0, y1 };
    wfDrawPolygon(d, xy, 4, widthPx, line, fill);
}

static void broadPairLines(wfDraw *d, const BroadFigure *f, int count, int role)
{
    for (int i = 0; i < count; i++) {
        wfVec2 a = wfRectCenter(f->bounds[f->pairs[i].a]);
        wfVec2 b = wfRectCenter(f->bounds[f->pairs[i].b]);
        wfDrawLine(d, WF_XY(a), WF_XY(b), 2, role);
    }
}
/* <figures> */
static wfProxies broadFigureWorld(BroadFigure *f, int n, float w, float h, float size,
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
/* <figures> */
static void figure_broad_lines(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfProxies world = broadFigureWorld(&f, 20, 9, 5, 1.1f, 7);
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
        broadRect(d, f.bounds[i], 1.5f, i ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
    broadPairLines(d, &f, list.count, WF_INK_BAD);
}
/* <figures> */
static void figure_broad_tree(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfQuadTree tree;
    (void)in;
    wfProxies world = broadFigureWorld(&f, BROAD_FIGURE_MOST, 8, 8, 0.45f, 5);
    /* <draw the boxes together> */
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
            broadRect(d, wfQuadTreeRect(&tree, n), 1, WF_INK_FAINT, WF_INK_NONE);
    wfDrawLine(d, 4, 0, 4, 8, 1.5f, WF_INK_FAINT);
    wfDrawLine(d, 0, 4, 8, 4, 1.5f, WF_INK_FAINT);
    for (int i = 0; i < world.count; i++)
        broadRect(d, f.bounds[i], 1.5f,
                  wfQuadTreeNodeOf(&tree, i) ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
    broadPairLines(d, &f, list.count, WF_INK_BAD);
}
/* <figures> */
static void figure_broad_missed(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfQuadTree tree;
    broadFigureWorld(&f, 2, 8, 5, 1, 1);
    wfQuadTreeDef def = { { wfV2(0, 0), wfV2(8, 5) }, 2, 40, 2, 0 };
    if (wfQuadTreeInit(&tree, &f.pool, &def) != WF_OK) return;
    for (int i = 0; i < 2; i++) {
        wfVec2 at = wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]);
        f.bounds[i] = wfRectCenterHalfDim(at, wfV2(WF_R(0.7), WF_R(0.5)));
        wfQuadTreeInsert(&tree, i, f.bounds[i]);
    }
    for (int i = 0; i < 2; i++) {
        int32_t node = wfQuadTreeNodeOf(&tree, i);
        if (node) broadRect(d, wfQuadTreeRect(&tree, node), 1, WF_INK_FAINT, WF_INK_FAINT);
    }
    wfDrawLine(d, 4, 0, 4, 5, 1.5f, WF_INK_FAINT);
    wfDrawLine(d, 0, 2.5f, 8, 2.5f, 1.5f, WF_INK_FAINT);
    broadRect(d, wfQuadTreeRect(&tree, 0), 1.5f, WF_INK_LINE, WF_INK_NONE);
    /* <draw the two boxes and say which pairs each rule finds> */
    for (int i = 0; i < 2; i++) {
        int32_t sectors[WF_QUAD_MAX_DEPTH];
        int depth = wfQuadTreePath(&tree, wfQuadTreeNodeOf(&tree, i), sectors);
        broadRect(d, f.bounds[i], 2, i ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
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
/* <figures> */
/* shades the nodes under n that the bounds reach into */
static void broadShade(wfDraw *d, const wfQuadTree *tree, int32_t n, wfRect bounds)
{
    int32_t reached[4];
    int count = wfQuadTreeReach(tree, n, bounds, reached);
    for (int i = 0; i < count; i++) {
        if (tree->nodes[reached[i]].below == 0)
            broadRect(d, wfQuadTreeRect(tree, reached[i]), 1, WF_INK_NONE, WF_INK_FAINT);
        broadShade(d, tree, reached[i], bounds);
    }
}
/* <figures> */
static void figure_broad_reach(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfQuadTree tree;
    wfProxies world = broadFigureWorld(&f, BROAD_FIGURE_MOST, 8, 8, 0.45f, 9);
    wfQuadTreeDef def = { { wfV2(0, 0), wfV2(8, 8) }, world.count, 120, 5, 1 };
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfRect asker = wfRectCenterHalfDim(at, wfV2(WF_R(0.5), WF_R(0.4)));
    if (wfQuadTreeInit(&tree, &f.pool, &def) != WF_OK) return;
    for (int i = 0; i < world.count; i++) wfQuadTreeInsert(&tree, i, f.bounds[i]);
    broadShade(d, &tree, 0, asker);
    for (int n = 0; n < tree.nodeHigh; n++)
        broadRect(d, wfQuadTreeRect(&tree, n), 1, WF_INK_FAINT, WF_INK_NONE);
    for (int i = 0; i < world.count; i++)
        broadRect(d, f.bounds[i], wfRectOverlap(f.bounds[i], asker) ? 3 : 1.5f, WF_INK_BODY,
                  WF_INK_NONE);
    broadRect(d, asker, 2.5f, WF_INK_GOOD, WF_INK_NONE);
}
/* <figures> */
static void figure_broad_grid(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfProxies world = broadFigureWorld(&f, 34, 8, 8, 0.9f, 21);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.55), WF_R(0.45)));
    wfRect all = { wfV2(0, 0), wfV2(8, 8) };
    wfCells cells = wfGridCells(all, WF_R(1.3), 100);
    wfCellRange mine = wfCellsOf(&cells, f.bounds[0]);
    /* <draw the cells, and fill those of the reader's box> */
    for (int32_t y = 0; y <= cells.limits.y1; y++)
        for (int32_t x = 0; x <= cells.limits.x1; x++) {
            bool in_it = x >= mine.x0 && x <= mine.x1 && y >= mine.y0 && y <= mine.y1;
            wfVec2 corner = wfV2((wfReal)x * cells.side, (wfReal)y * cells.side);
            wfRect cell = { corner, wfAdd(corner, wfV2(cells.side, cells.side)) };
            cell.max = wfMin2(cell.max, all.max);
            broadRect(d, cell, 1, WF_INK_FAINT, in_it ? WF_INK_FAINT : WF_INK_NONE);
        }
    for (int i = 0; i < world.count; i++)
        broadRect(d, f.bounds[i], i ? 1.5f : 2.5f, i ? WF_INK_BODY : WF_INK_GOOD,
                  WF_INK_NONE);
    wfPairList list = { f.pairs, 0, BROAD_FIGURE_MOST * BROAD_FIGURE_MOST, 0 };
    wfFindPairs(wfFindBroadPhase("grid"), &world, &f.pool, &list);
    int count = 0;                                   /* sorted: those of box 0 come first */
    while (count < list.count && list.pairs[count].a == 0) count++;
    broadPairLines(d, &f, count, WF_INK_BAD);
}
/* <figures> */
enum { BROAD_BLOCKS = 16, BROAD_CELLS = 128 };

/* the cells that some box touches, each once; returns how many */
static int broadUsedCells(const wfProxies *world, const wfCells *cells, int32_t (*used)[2])
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
/* <figures> */
static void figure_broad_hash(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    int32_t used[BROAD_CELLS][2], share[BROAD_BLOCKS] = { 0 };
    wfProxies world = broadFigureWorld(&f, 7, 10, 6, 0.8f, 4);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    for (int i = 0; i < world.count; i++) {
        f.bounds[i].min.y += 2;
        f.bounds[i].max.y += 2;
    }
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.4), WF_R(0.3)));
    wfCells cells = wfHashCells(1);
    int count = broadUsedCells(&world, &cells, used), fullest = 0;
    for (int i = 0; i < count; i++)
        share[wfHashCell(used[i][0], used[i][1]) % BROAD_BLOCKS]++;
    for (int k = 0; k < BROAD_BLOCKS; k++) if (share[k] > share[fullest]) fullest = k;
    /* <draw the cells, the blocks, and the lines of the fullest block> */
    for (int i = 0; i < count; i++) {
        float x = (float)used[i][0], y = (float)used[i][1];
        wfRect cell = { wfV2((wfReal)x, (wfReal)y), wfV2((wfReal)x + 1, (wfReal)y + 1) };
        broadRect(d, cell, 1, WF_INK_FAINT, WF_INK_NONE);
        if ((int)(wfHashCell(used[i][0], used[i][1]) % BROAD_BLOCKS) != fullest) continue;
        broadRect(d, cell, 1, WF_INK_FAINT, WF_INK_FAINT);
        wfDrawLine(d, 0.5f + 0.6f * (float)fullest, 1, x + 0.5f, y + 0.5f, 1.2f, WF_INK_BAD);
    }
    for (int k = 0; k < BROAD_BLOCKS; k++) {
        wfReal x = WF_R(0.2) + WF_R(0.6) * (wfReal)k;
        wfRect block = { wfV2(x, WF_R(0.4)), wfV2(x + WF_R(0.6), 1) };
        broadRect(d, block, 1.5f, WF_INK_LINE, k == fullest ? WF_INK_FAINT : WF_INK_NONE);
        if (share[k])
            wfDrawTextf(d, (float)x + 0.3f, 0.58f, 14, WF_INK_TEXT, 0, "%d", (int)share[k]);
    }
    for (int i = 0; i < world.count; i++)
        broadRect(d, f.bounds[i], 2, i ? WF_INK_BODY : WF_INK_ACCENT, WF_INK_NONE);
}
/* <figures> */
static void figure_broad_sweep(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfKeyed items[BROAD_FIGURE_MOST], spare[BROAD_FIGURE_MOST];
    wfProxies world = broadFigureWorld(&f, 16, 10, 5, 0.9f, 3);
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
        /* <draw a box and its bar> */
        wfRect r = f.bounds[items[k].index];
        bool mine = items[k].index == 0, met = active && items[k].key <= me.max.x;
        int role = mine ? WF_INK_GOOD : met ? WF_INK_ACCENT : WF_INK_BODY;
        float y = 2.75f - 0.17f * (float)k;
        broadRect(d, r, mine ? 2.5f : 1.5f, role, WF_INK_NONE);
        wfDrawLine(d, (float)r.min.x, y, (float)r.max.x, y, 3.5f, role);
        active = active || mine;
    }
}
/* <figures> */
static void broadBoxes(wfDraw *d, const wfBoxTree *tree, int32_t n, float widthPx)
{
    const wfBoxNode *node = &tree->nodes[n];
    bool leaf = node->right < 0;
    broadRect(d, wfRectGrow(node->box, WF_R(0.05)), widthPx,
              leaf ? WF_INK_GOOD : WF_INK_LINE, WF_INK_NONE);
    if (leaf) return;
    broadBoxes(d, tree, n + 1, widthPx * 0.6f);
    broadBoxes(d, tree, node->right, widthPx * 0.6f);
}
/* <figures> */
static void figure_broad_boxes(wfDraw *d, const wfFigureInput *in)
{
    BroadFigure f;
    wfBoxNode nodes[BROAD_FIGURE_MOST + 1];
    wfKeyed items[BROAD_FIGURE_MOST];
    wfProxies world = broadFigureWorld(&f, 28, 8, 8, 0.6f, 8);
    wfVec2 at = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    f.bounds[0] = wfRectCenterHalfDim(at, wfV2(WF_R(0.3), WF_R(0.25)));
    for (int i = 0; i < world.count; i++) items[i].index = i;
    wfBoxTree tree = { &world, nodes, items, 0 };
    broadBoxes(d, &tree, wfBoxTreeBuild(&tree, 0, world.count), 4);
    for (int i = 0; i < world.count; i++)
        broadRect(d, f.bounds[i], 1.5f, i ? WF_INK_BODY : WF_INK_ACCENT,
                  i ? WF_INK_NONE : WF_INK_ACCENT);
}
/* <figures> */
static void figure_broad_walk(wfDraw *d, const wfFigureInput *in)
{
    enum { STEPS = 8 };
    BroadFigure f;
    wfProxies world = broadFigureWorld(&f, 14, 8, 8, 0.9f, 12);
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
                broadRect(d, wfRectMinDim(wfV2((wfReal)x, (wfReal)y), wfV2(1, 1)), 0,
                          WF_INK_NONE, WF_INK_FAINT);
    }
    /* <draw the grid, the boxes and the steps of the ray> */
    for (int k = 0; k <= STEPS; k++) {
        wfDrawLine(d, (float)k, 0, (float)k, 8, 0.7f, WF_INK_LINE);
        wfDrawLine(d, 0, (float)k, 8, (float)k, 0.7f, WF_INK_LINE);
    }
    wfBoxCast cast = { a, way, wfV2(0, 0), 1 };
    for (int i = 0; i < world.count; i++) {
        wfReal t;
        bool met = wfCastMeets(&cast, f.bounds[i], &t);
        broadRect(d, f.bounds[i], met ? 3 : 1.5f, met ? WF_INK_BAD : WF_INK_BODY, WF_INK_NONE);
    }
    for (int k = 0; k <= steps; k++) {
        wfVec2 p = wfAddScaled(a, (wfReal)k / (wfReal)steps, way);
        wfDrawPoint(d, WF_XY(p), 6, WF_INK_GOOD);
    }
    wfDrawArrow(d, WF_XY(a), WF_XY(b), 2, WF_INK_GOOD);
}
/* <figures> */
static void figure_broad_fat(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 tip = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 at = wfV2(WF_R(1.5), WF_R(1.5));
    wfVec2 way = wfScale(WF_R(0.25), wfSub(tip, at));
    wfRect box = wfRectCenterHalfDim(at, wfV2(WF_R(0.8), WF_R(0.6)));
    wfRect fat = wfFatBox(box, way, WF_TREE_RATIO);
    broadRect(d, fat, 2, WF_INK_GOOD, WF_INK_NONE);
    for (int k = 8; k > 0; k--) {
        wfVec2 by = wfScale((wfReal)k, way);
        wfRect later = { wfAdd(box.min, by), wfAdd(box.max, by) };
        if (!wfRectContains(fat, later)) continue;
        broadRect(d, later, 0.7f, WF_INK_FAINT, WF_INK_NONE);
    }
    broadRect(d, box, 2, WF_INK_BODY, WF_INK_FAINT);
    wfDrawArrow(d, WF_XY(at), WF_XY(tip), 2, WF_INK_ACCENT);
}
/* <figures> */
/* draws the node's box and above it the branches to its children; returns where it is */
static wfVec2 broadBranch(wfDraw *d, const wfTree *t, int32_t n, int level, wfVec2 move)
{
    static const char *const names[] = { "A", "B", "C", "D" };
    const wfTreeNode *node = &t->nodes[n];
    wfRect r = { wfAdd(node->box.min, move), wfAdd(node->box.max, move) };
    wfVec2 here = wfV2((r.min.x + r.max.x) / 2, 5 - (wfReal)level * WF_R(0.9));
    if (node->left == WF_TREE_NONE) {
        broadRect(d, r, 2, WF_INK_BODY, WF_INK_FAINT);
        wfDrawText(d, (float)here.x, (float)r.min.y + 0.3f, 14, WF_INK_TEXT, 0, names[n]);
        wfDrawPoint(d, WF_XY(here), 7, WF_INK_BODY);
        return here;
    }
    broadRect(d, wfRectGrow(r, WF_R(0.22) - (wfReal)level / 14), 1.5f,
              level ? WF_INK_ACCENT : WF_INK_LINE, WF_INK_NONE);
    for (int k = 0; k < 2; k++) {
        wfVec2 child = broadBranch(d, t, k ? node->right : node->left, level + 1, move);
        wfDrawLine(d, WF_XY(here), WF_XY(child), 1.5f, WF_INK_LINE);
    }
    wfDrawPoint(d, WF_XY(here), 7, WF_INK_LINE);
    return here;
}
/* <figures> */
enum { ROTATE_BOXES = 4 };

/* a bad tree, made by hand: the first box, and beside it all the rest, and so on */
static void broadLadder(wfTree *t, const wfRect *boxes, int n)
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
/* <figures> */
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
    broadLadder(&tree, boxes, ROTATE_BOXES);
    broadBranch(d, &tree, tree.head->root, 0, wfV2(0, 0));
    if (wfTreeInit(&tree, block, sizeof block, ROTATE_BOXES) != WF_OK) return;
    broadLadder(&tree, boxes, ROTATE_BOXES - 1);
    wfTreeInsert(&tree, ROTATE_BOXES - 1, boxes[ROTATE_BOXES - 1], true);
    broadBranch(d, &tree, tree.head->root, 0, wfV2(WF_R(6.4), 0));
}
/* <figures> */
static void narrowShape(wfDraw *d, const wfShape *s, wfTransform xf, int line, int fill)
{
    float xy[2 * WF_RIM_POINTS];
    wfVec2 c = wfApply(xf, s->centre), rim[WF_RIM_POINTS];
    int n = wfShapeOutline(s, xf, rim);
    for (int i = 0; i < n; i++) {
        xy[2 * i] = (float)rim[i].x;
        xy[2 * i + 1] = (float)rim[i].y;
    }
    if (s->kind == WF_SHAPE_CIRCLE)
        wfDrawCircle(d, WF_XY(c), (float)s->radius, 2, line, fill);
    else if (n > 2)
        wfDrawPolygon(d, xy, n, 2, line, fill);
    else if (n == 2)
        wfDrawLine(d, xy[0], xy[1], xy[2], xy[3], 2, line);
}
/* <figures> */
static void narrowSegment(wfDraw *d, wfVec2 from, wfVec2 to, float widthPx, int role)
{
    wfDrawLine(d, WF_XY(from), WF_XY(to), widthPx, role);
}

static wfVec2 narrowHandle(const wfFigureInput *in, int i)
{
    return wfV2((wfReal)in->handle[i][0], (wfReal)in->handle[i][1]);
}
/* <figures> */
/* the shadows of a and b on an axis through `at`; green if they are apart */
static void narrowShadows(wfDraw *d, const wfShape *a, wfTransform xa, const wfShape *b,
                          wfTransform xb, wfVec2 axis, wfVec2 at, bool best)
{
    wfProjection pa = wfProject(a, xa, axis), pb = wfProject(b, xb, axis);
    wfReal o = wfDot(axis, at);
    wfVec2 side = wfScale(WF_R(0.1), wfPerpCCW(axis));
    wfReal low = wfMinR(pa.min, pb.min) - o, high = wfMaxR(pa.max, pb.max) - o;
    bool apart = wfAxisOverlap(a, xa, b, xb, axis) < 0;
    narrowSegment(d, wfAddScaled(at, low - WF_R(0.3), axis),
                  wfAddScaled(at, high + WF_R(0.3), axis), best ? 2.5f : 1,
                  apart ? WF_INK_GOOD : best ? WF_INK_LINE : WF_INK_FAINT);
    wfVec2 pa0 = wfAdd(at, side), pb0 = wfSub(at, side);
    narrowSegment(d, wfAddScaled(pa0, pa.min - o, axis), wfAddScaled(pa0, pa.max - o, axis),
                  5, WF_INK_BODY);
    narrowSegment(d, wfAddScaled(pb0, pb.min - o, axis), wfAddScaled(pb0, pb.max - o, axis),
                  5, WF_INK_BODY2);
}
/* <figures> */
static void figure_narrow_shadows(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfMakeBox(WF_R(1.3), WF_R(0.8), &a);
    wfMakeBox(WF_R(0.9), WF_R(0.7), &b);
    wfTransform xa = wfMakeTransform(wfV2(WF_R(4.2), WF_R(3.4)), 0);
    wfTransform xb = wfMakeTransform(narrowHandle(in, 0), WF_R(0.6));
    wfSeparation s;
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return;
    bool apart = s.distance > 0;
    narrowShape(d, &a, xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &b, xb, WF_INK_BODY2, WF_INK_BODY2);
    wfVec2 places[4] = { wfV2(0, WF_R(0.4)), wfV2(WF_R(0.4), 0), wfV2(WF_R(8.7), WF_R(4.2)),
                         wfV2(WF_R(1.6), WF_R(4.6)) };
    for (int i = 0; i < 4; i++) {
        /* <draw the shadows on axis i> */
        wfReal turn = (wfReal)(i & 1) * WF_PI / 2 + (i > 1 ? WF_R(0.6) : 0);
        wfVec2 axis = wfRotate(wfRotation(turn), wfV2(1, 0));
        narrowShadows(d, &a, xa, &b, xb, axis, places[i],
                      wfAbs(wfDot(axis, s.normal)) > WF_R(0.999));
    }
    wfReal way = apart ? WF_R(0.7) : wfMaxR(-s.distance, WF_R(0.2));
    wfVec2 tip = wfAddScaled(xb.p, way, s.normal);
    wfDrawArrow(d, WF_XY(xb.p), WF_XY(tip), 2.5f, apart ? WF_INK_GOOD : WF_INK_ACCENT);
    wfDrawTextf(d, 8.7f, 6.0f, 14, WF_INK_TEXT, 1,
                apart ? "apart by %.2f m" : "depth %.2f m", (double)wfAbs(s.distance));
}
/* <figures> */
static void narrowInterval(wfDraw *d, wfProjection p, float y, int role, const char *name)
{
    wfDrawLine(d, (float)p.min, y, (float)p.max, y, 6, role);
    wfDrawTextf(d, (float)p.min - 0.15f, y - 0.07f, 13, WF_INK_TEXT, 1, "%s", name);
}

static void figure_narrow_nested(wfDraw *d, const wfFigureInput *in)
{
    wfProjection a = { 1, 7 }, b = { WF_R(4.2), WF_R(5.8) };
    (void)in;
    wfReal shared = wfMinR(a.max, b.max) - wfMaxR(a.min, b.min), out = wfAxisEscape(a, b);
    const wfReal by[3] = { 0, shared, out };
    const char *const text[3] = { "as they are", "moved by what they share",
                                  "moved by the way out" };
    for (int i = 0; i < 3; i++) {
        float y = 3.6f - 1.5f * (float)i;
        wfProjection moved = { b.min + by[i], b.max + by[i] };
        bool free = moved.min >= a.max;
        wfDrawText(d, 0.6f, y + 0.35f, 13, WF_INK_TEXT, -1, text[i]);
        narrowInterval(d, a, y, WF_INK_BODY, "A");
        int role = i == 0 ? WF_INK_BODY2 : free ? WF_INK_GOOD : WF_INK_BAD;
        narrowInterval(d, moved, y - 0.3f, role, "B");
    }
}
/* <figures> */
static void figure_narrow_false(wfDraw *d, const wfFigureInput *in)
{
    wfShape a;
    wfMakeBox(1, 1, &a);
    wfTransform xa = wfMakeTransform(wfV2(WF_R(3.2), WF_R(3.4)), 0);
    wfTransform xb = wfMakeTransform(narrowHandle(in, 0), WF_PI / 4);
    wfReal r = wfSqrt(WF_R(0.5));
    narrowShape(d, &a, xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &a, xb, WF_INK_BODY2, WF_INK_BODY2);
    narrowShadows(d, &a, xa, &a, xb, wfV2(1, 0), wfV2(0, WF_R(0.3)), false);
    narrowShadows(d, &a, xa, &a, xb, wfV2(0, 1), wfV2(WF_R(0.5), 0), false);
    narrowShadows(d, &a, xa, &a, xb, wfV2(r, r), wfV2(WF_R(6.8), WF_R(3.5)), true);
}
/* <figures> */
/* colours an edge by whose normal it has; +1 A's turned round, -1 B's */
static int narrowEdgeRole(const wfShape *hull, int i, const wfShape *a, wfTransform xa)
{
    for (int k = 0; k < a->count; k++)
        if (wfDot(hull->normals[i], wfRotate(xa.q, a->normals[k])) < -WF_R(0.9999))
            return WF_INK_BODY;
    return WF_INK_BODY2;
}

static void narrowDifference(wfDraw *d, const wfShape *a, wfTransform xa, const wfShape *b,
                             wfTransform xb, wfVec2 origin)
{
    wfVec2 points[WF_MAX_VERTICES * WF_MAX_VERTICES];
    int n = 0;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            points[n++] = wfSub(wfApply(xb, b->vertices[j]), wfApply(xa, a->vertices[i]));
    wfShape hull;
    if (wfMakePolygon(points, n, &hull) != WF_OK) return;
    for (int i = 0; i < hull.count; i++)
        narrowSegment(d, wfAdd(origin, hull.vertices[i]),
                      wfAdd(origin, hull.vertices[i + 1 < hull.count ? i + 1 : 0]), 2.5f,
                      narrowEdgeRole(&hull, i, a, xa));
    wfDrawPoint(d, WF_XY(origin), 7, WF_INK_LINE);
}
/* <figures> */
static void figure_narrow_minkowski(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfVec2 corners[3] = { wfV2(-WF_R(0.8), -WF_R(0.6)), wfV2(1, -WF_R(0.4)),
                          wfV2(-WF_R(0.2), 1) };
    wfMakeBox(WF_R(0.9), WF_R(0.7), &a);
    if (wfMakePolygon(corners, 3, &b) != WF_OK) return;
    wfTransform xa = wfMakeTransform(wfV2(WF_R(1.6), WF_R(2.2)), WF_R(0.2));
    wfTransform xb = wfMakeTransform(narrowHandle(in, 0), 0);
    wfVec2 origin = wfV2(WF_R(5.4), WF_R(2.2));
    wfSeparation s;
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return;
    narrowShape(d, &a, xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &b, xb, WF_INK_BODY2, WF_INK_BODY2);
    narrowDifference(d, &a, xa, &b, xb, origin);
    wfVec2 tip = wfAddScaled(origin, s.distance, s.normal);
    wfVec2 move = wfAddScaled(xb.p, -s.distance, s.normal);
    wfDrawArrow(d, WF_XY(origin), WF_XY(tip), 2.5f, WF_INK_ACCENT);
    wfDrawArrow(d, WF_XY(xb.p), WF_XY(move), 2.5f, WF_INK_ACCENT);
    wfDrawText(d, 5.52f, 1.95f, 13, WF_INK_TEXT, -1, "0");
}
/* <figures> */
static void figure_narrow_tie(wfDraw *d, const wfFigureInput *in)
{
    wfShape a;
    wfMakeBox(1, 1, &a);
    wfTransform xa = wfMakeTransform(wfV2(2, WF_R(1.6)), 0);
    wfTransform xb = wfMakeTransform(narrowHandle(in, 0), 0);
    wfSeparation s;
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &a, xb, &s) != WF_OK) return;
    narrowShape(d, &a, xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &a, xb, WF_INK_BODY2, WF_INK_BODY2);
    const wfVec2 ways[2] = { wfV2(1, 0), wfV2(0, 1) };
    for (int i = 0; i < 2; i++) {
        wfReal by = wfAxisEscape(wfProject(&a, xa, ways[i]), wfProject(&a, xb, ways[i]));
        wfVec2 tip = wfAddScaled(xb.p, by, ways[i]);
        bool chosen = wfDot(s.normal, ways[i]) > WF_R(0.5);
        wfDrawArrow(d, WF_XY(xb.p), WF_XY(tip), chosen ? 3 : 1.5f,
                    chosen ? WF_INK_ACCENT : WF_INK_LINE);
        wfDrawTextf(d, (float)tip.x + 0.1f, (float)tip.y + 0.1f, 13, WF_INK_TEXT, -1,
                    "%.4f m", (double)by);
    }
}
/* <figures> */
static void figure_narrow_regions(wfDraw *d, const wfFigureInput *in)
{
    wfShape p, c;
    wfVec2 corners[5] = { wfV2(-WF_R(1.4), -WF_R(0.8)), wfV2(WF_R(0.9), -WF_R(1.1)),
                          wfV2(WF_R(1.6), WF_R(0.2)), wfV2(WF_R(0.3), WF_R(1.2)),
                          wfV2(-WF_R(1.2), WF_R(0.7)) };
    wfTransform xp = wfMakeTransform(wfV2(WF_R(3.4), WF_R(2.6)), 0);
    wfTransform xc = wfMakeTransform(narrowHandle(in, 0), 0);
    wfSeparation s;
    if (wfMakePolygon(corners, 5, &p) != WF_OK) return;
    wfMakeCircle(wfV2(0, 0), WF_R(0.55), &c);
    /* <draw the borders of the regions> */
    for (int i = 0; i < p.count; i++) {
        wfVec2 v = wfApply(xp, p.vertices[i]);
        wfVec2 after = wfAddScaled(v, 6, p.normals[i]);
        wfVec2 before = wfAddScaled(v, 6, p.normals[i ? i - 1 : p.count - 1]);
        wfDrawDashed(d, WF_XY(v), WF_XY(after), 1, WF_INK_FAINT);
        wfDrawDashed(d, WF_XY(v), WF_XY(before), 1, WF_INK_FAINT);
    }
    narrowShape(d, &p, xp, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &c, xc, WF_INK_BODY2, WF_INK_NONE);
    if (wfSeparate(wfFindNarrowPhase("sat"), &p, xp, &c, xc, &s) != WF_OK) return;
    wfVec2 foot = wfAddScaled(xc.p, -(s.distance + c.radius), s.normal);
    wfVec2 tip = wfAddScaled(foot, 1, s.normal);
    wfDrawArrow(d, WF_XY(foot), WF_XY(tip), 2.5f, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(foot), 8, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1,
                s.distance > 0 ? "apart by %.2f m" : "depth %.2f m",
                (double)wfAbs(s.distance));
}
/* <figures> */
static void narrowCore(wfDraw *d, const wfShape *s, wfTransform xf, int role)
{
    for (int i = 0; i < s->count; i++)
        narrowSegment(d, wfApply(xf, s->vertices[i]),
                      wfApply(xf, s->vertices[i + 1 < s->count ? i + 1 : 0]), 2.5f, role);
}
/* <figures> */
static void figure_narrow_coats(wfDraw *d, const wfFigureInput *in)
{
    static const char *const whose[3] = { "nobody's edge: corner to corner, or end",
                                          "an edge of the box", "an edge of the capsule" };
    wfShape a, b;
    wfSeparation s;
    if (wfMakeRoundedBox(WF_R(1.3), WF_R(0.8), WF_R(0.4), &a) != WF_OK) return;
    wfVec2 end = wfV2(WF_R(0.9), 0);
    if (wfMakeCapsule(wfNeg(end), end, WF_R(0.5), &b) != WF_OK) return;
    wfTransform xa = wfMakeTransform(wfV2(3, WF_R(2.6)), WF_R(0.15));
    wfTransform xb = wfMakeTransform(narrowHandle(in, 0), WF_R(0.9));
    if (wfSeparate(wfFindNarrowPhase("sat"), &a, xa, &b, xb, &s) != WF_OK) return;
    narrowShape(d, &a, xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &b, xb, WF_INK_BODY2, WF_INK_BODY2);
    narrowCore(d, &a, xa, WF_INK_LINE);
    narrowCore(d, &b, xb, WF_INK_LINE);
    /* <draw the way from core to core> */
    wfShape coreA = a, coreB = b;
    wfDistanceResult r;
    coreA.radius = coreB.radius = 0;
    if (wfShapeDistance(&coreA, xa, &coreB, xb, &r) != WF_OK) return;
    if (r.distance > 0) wfDrawArrow(d, WF_XY(r.pointA), WF_XY(r.pointB), 2.5f, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.65f, 14, WF_INK_TEXT, -1, s.distance > 0 ? "apart by %.2f m"
                : "depth %.2f m", (double)wfAbs(s.distance));
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "normal: %s", whose[s.owner + 1]);
}
/* <figures> */
typedef struct GjkPanel { wfVec2 origin; wfReal scale; } GjkPanel;

static wfVec2 onPanel(GjkPanel p, wfVec2 v) { return wfAddScaled(p.origin, p.scale, v); }

static void gjkSimplex(wfDraw *d, GjkPanel at, const wfVec2 *v, int n, float px, int role)
{
    float xy[6];
    for (int i = 0; i < n; i++) {
        wfVec2 p = onPanel(at, v[i]);
        xy[2 * i] = (float)p.x;
        xy[2 * i + 1] = (float)p.y;
        wfDrawPoint(d, WF_XY(p), 7, role);
    }
    if (n == 2) wfDrawLine(d, xy[0], xy[1], xy[2], xy[3], px, role);
    if (n == 3) wfDrawPolygon(d, xy, 3, px, role, WF_INK_NONE);
}
/* <figures> */
/* the outline of B - A, for the reader; the engine does not make it */
static void gjkOutline(wfDraw *d, GjkPanel at, const wfShape *a, const wfShape *b,
                       wfTransform rel)
{
    wfVec2 points[WF_MAX_VERTICES * WF_MAX_VERTICES];
    int n = 0;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            points[n++] = wfSub(wfApply(rel, b->vertices[j]), a->vertices[i]);
    wfShape hull;
    if (wfMakePolygon(points, n, &hull) != WF_OK) return;
    for (int i = 0; i < hull.count; i++)
        narrowSegment(d, onPanel(at, hull.vertices[i]),
                      onPanel(at, hull.vertices[i + 1 < hull.count ? i + 1 : 0]), 1.5f,
                      WF_INK_FAINT);
    wfDrawPoint(d, WF_XY(at.origin), 6, WF_INK_LINE);
}
/* <figures> */
/* the two shapes at the left; the relative pose of B, or false */
static bool gjkPair(wfDraw *d, const wfFigureInput *in, wfShape *a, wfShape *b,
                    wfTransform *xa, wfTransform *xb)
{
    wfVec2 round[8], five[5];
    for (int i = 0; i < 8; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / 8 + WF_R(0.5));
        round[i] = wfV2(WF_R(1.4) * q.c, q.s);
    }
    for (int i = 0; i < 5; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / 5);
        five[i] = wfV2(q.c, WF_R(0.8) * q.s);
    }
    if (wfMakePolygon(round, 8, a) != WF_OK || wfMakePolygon(five, 5, b) != WF_OK)
        return false;
    *xa = wfMakeTransform(wfV2(WF_R(1.7), 3), 0);
    *xb = wfMakeTransform(narrowHandle(in, 0), 0);
    narrowShape(d, a, *xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, b, *xb, WF_INK_BODY2, WF_INK_BODY2);
    return true;
}
/* <figures> */
static void gjkEmpty(wfDraw *d, const char *text)
{
    wfDrawText(d, 8.8f, 3.6f, 14, WF_INK_TEXT, 0, text);
}
/* <figures> */
static void figure_narrow_gjk(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfTransform xa, xb;
    wfSeparation s;
    wfGjkTrace t;
    wfDistanceResult r;
    if (!gjkPair(d, in, &a, &b, &xa, &xb)) return;
    if (wfTraceGjk(&a, xa, &b, xb, &s, &t) != WF_OK) return;
    if (wfShapeDistance(&a, xa, &b, xb, &r) != WF_OK) return;
    narrowSegment(d, r.pointA, r.pointB, 2, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(r.pointA), 7, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(r.pointB), 7, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.8f, 14, WF_INK_TEXT, -1, "distance %.3f m", (double)r.distance);
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "answers: %d", (int)r.iterations);
    for (int k = 0; k < 4 && k < t.count; k++) {
        if (t.steps[k].phase != WF_GJK_WALK) break;
        wfReal x = WF_R(5.9) + WF_R(4.4) * (wfReal)(k % 2);
        GjkPanel at = { wfV2(x, k < 2 ? WF_R(4.4) : WF_R(0.6)), WF_R(0.8) };
        /* <draw the simplex of step k> */
        const wfGjkStep *step = &t.steps[k];
        gjkOutline(d, at, &a, &b, wfRelativePose(xa, xb));
        gjkSimplex(d, at, step->points, step->count, 2.5f, WF_INK_ACCENT);
        wfVec2 nearest = onPanel(at, step->nearest);
        if (step->count < 3) wfDrawArrow(d, WF_XY(nearest), WF_XY(at.origin), 1.5f, WF_INK_GOOD);
        wfDrawTextf(d, (float)at.origin.x + 0.2f, (float)at.origin.y - 0.1f, 15, WF_INK_TEXT, -1,
                    "%d", k + 1);
    }
}
/* <figures> */
/* the polygon before step k: the hull of GJK's last simplex and of all answers before it */
static void gjkRing(wfDraw *d, GjkPanel at, const wfGjkTrace *t, int first, int k)
{
    wfVec2 points[3 + WF_GJK_STEPS];
    int n = 0;
    wfShape hull;
    const wfGjkStep *last = &t->steps[first - 1];
    for (int i = 0; i < last->count; i++) points[n++] = last->points[i];
    for (int i = 0; i < k && n < 3 + WF_GJK_STEPS; i++)
        points[n++] = t->steps[first + i].points[2];
    if (wfMakePolygon(points, n, &hull) != WF_OK) return;
    for (int i = 0; i < hull.count; i++)
        narrowSegment(d, onPanel(at, hull.vertices[i]),
                      onPanel(at, hull.vertices[i + 1 < hull.count ? i + 1 : 0]), 2,
                      WF_INK_LINE);
}
/* <figures> */
static void figure_narrow_epa(wfDraw *d, const wfFigureInput *in)
{
    wfShape a, b;
    wfTransform xa, xb;
    wfSeparation s;
    wfGjkTrace t;
    if (!gjkPair(d, in, &a, &b, &xa, &xb)) return;
    if (wfTraceGjk(&a, xa, &b, xb, &s, &t) != WF_OK) return;
    int first = 0;
    while (first < t.count && t.steps[first].phase == WF_GJK_WALK) first++;
    if (first == t.count) { gjkEmpty(d, "apart: nothing to grow"); return; }
    wfVec2 tip = wfAddScaled(xb.p, -s.distance, s.normal);
    wfDrawArrow(d, WF_XY(xb.p), WF_XY(tip), 2.5f, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.8f, 14, WF_INK_TEXT, -1, "depth %.3f m", -(double)s.distance);
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "answers: %d + %d", first,
                t.count - first);
    int shown = t.count - first;
    for (int k = 0; k < shown; k++) {
        if (k > 2 && k < shown - 1) continue;               /* three and the last */
        int place = k < 3 ? k : 3;
        wfReal x = WF_R(6.4) + WF_R(4.6) * (wfReal)(place % 2);
        GjkPanel at = { wfV2(x, place < 2 ? WF_R(5.3) : WF_R(1.6)), WF_R(0.8) };
        /* <draw the polygon of step k> */
        gjkOutline(d, at, &a, &b, wfRelativePose(xa, xb));
        gjkRing(d, at, &t, first, k);
        const wfGjkStep *step = &t.steps[first + k];
        gjkSimplex(d, at, step->points, 2, 3.5f, WF_INK_ACCENT);
        wfVec2 answer = onPanel(at, step->points[2]);
        wfDrawCircle(d, WF_XY(answer), 0.1f, 2, WF_INK_GOOD, WF_INK_NONE);
        if (k == shown - 1) {
            wfVec2 way = onPanel(at, wfRotateInv(xa.q, wfScale(s.distance, s.normal)));
            wfDrawArrow(d, WF_XY(at.origin), WF_XY(way), 1.5f, WF_INK_GOOD);
        }
        wfDrawTextf(d, (float)at.origin.x - 1.4f, (float)at.origin.y - 1.3f, 15, WF_INK_TEXT, 0,
                    "%d", k + 1);
    }
}
/* <figures> */
static void figure_narrow_simplex(wfDraw *d, const wfFigureInput *in)
{
    wfShape triangle, dot;
    wfVec2 corners[3] = { wfV2(-WF_R(1.6), -WF_R(0.9)), wfV2(WF_R(1.7), -WF_R(0.7)),
                          wfV2(WF_R(0.1), WF_R(1.3)) };
    wfVec2 origin = narrowHandle(in, 0), place = wfV2(WF_R(3.4), WF_R(2.4));
    wfSeparation s;
    wfGjkTrace t;
    if (wfMakePolygon(corners, 3, &triangle) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.01), &dot) != WF_OK) return;
    wfTransform xd = wfMakeTransform(origin, 0), xt = wfMakeTransform(place, 0);
    for (int i = 0; i < 3; i++) {
        wfVec2 v = wfApply(xt, triangle.vertices[i]);
        wfVec2 after = wfAddScaled(v, 6, triangle.normals[i]);
        wfVec2 before = wfAddScaled(v, 6, triangle.normals[i ? i - 1 : 2]);
        wfDrawDashed(d, WF_XY(v), WF_XY(after), 1, WF_INK_FAINT);
        wfDrawDashed(d, WF_XY(v), WF_XY(before), 1, WF_INK_FAINT);
    }
    narrowShape(d, &triangle, xt, WF_INK_BODY, WF_INK_BODY);
    if (wfTraceGjk(&dot, xd, &triangle, xt, &s, &t) != WF_OK) return;
    /* <draw what is kept of the simplex> */
    int last = 0;
    while (last + 1 < t.count && t.steps[last + 1].phase == WF_GJK_WALK) last++;
    const wfGjkStep *kept = &t.steps[last];
    GjkPanel at = { origin, 1 };
    gjkSimplex(d, at, kept->points, kept->count, 4, WF_INK_ACCENT);
    wfVec2 nearest = onPanel(at, kept->nearest);
    if (kept->count < 3) wfDrawArrow(d, WF_XY(origin), WF_XY(nearest), 2, WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(origin), 8, WF_INK_LINE);
    static const char *const names[4] = { "", "a corner", "an edge", "the whole triangle" };
    wfDrawTextf(d, 0.2f, 0.2f, 14, WF_INK_TEXT, -1, "keeps %s", names[kept->count]);
}
/* <figures> */
/* the points of a manifold, with a rod from surface to surface */
static void contactPoints(wfDraw *d, const wfManifold *m, int role)
{
    for (int i = 0; i < m->count; i++) {
        const wfContactPoint *c = &m->points[i];
        wfVec2 ahead = wfAddScaled(c->point, c->depth / 2, m->normal);
        wfVec2 back = wfAddScaled(c->point, -c->depth / 2, m->normal);
        narrowSegment(d, ahead, back, 2, role);
        wfDrawPoint(d, WF_XY(c->point), 7, role);
    }
}

static void contactPair(wfDraw *d, const wfShape *a, wfTransform xa, const wfShape *b,
                        wfTransform xb)
{
    wfManifold m;
    narrowShape(d, a, xa, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, b, xb, WF_INK_BODY2, WF_INK_BODY2);
    wfCollide(a, xa, b, xb, &m);
    contactPoints(d, &m, WF_INK_ACCENT);
}
/* <figures> */
static void figure_contacts_kinds(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const char *const names[4] = { "vertex, edge", "edge, edge", "vertex, vertex",
                                          "circle" };
    static const wfReal places[4][3] = { { WF_R(1.5), WF_R(2.64), WF_R(0.7) },
                                         { WF_R(4.6), WF_R(2.4), 0 },
                                         { WF_R(8.52), WF_R(2.75), WF_PI / 4 },
                                         { WF_R(10.5), WF_R(2.3), 0 } };
    wfShape ground, box, ball;
    wfMakeBox(WF_R(1.15), WF_R(0.7), &ground);
    wfMakeBox(WF_R(0.7), WF_R(0.7), &box);
    wfMakeCircle(wfV2(0, 0), WF_R(0.7), &ball);
    for (int i = 0; i < 4; i++) {
        wfReal x = WF_R(1.5) + 3 * (wfReal)i;
        wfTransform xg = wfMakeTransform(wfV2(x, WF_R(1.2)), 0);
        wfTransform xb = wfMakeTransform(wfV2(places[i][0], places[i][1]), places[i][2]);
        contactPair(d, &ground, xg, i == 3 ? &ball : &box, xb);
        wfDrawText(d, (float)x, 0.1f, 14, WF_INK_TEXT, 0, names[i]);
    }
}
/* <figures> */
static void figure_contacts_report(wfDraw *d, const wfFigureInput *in)
{
    wfShape plank, box;
    (void)in;
    wfMakeBox(WF_R(2.2), WF_R(0.6), &plank);
    wfMakeBox(1, WF_R(0.7), &box);
    wfTransform left = wfMakeTransform(wfV2(WF_R(2.4), 1), 0);
    wfTransform right = wfMakeTransform(wfV2(WF_R(7.4), 1), 0);
    wfTransform flat = wfMakeTransform(wfV2(WF_R(2.4), WF_R(2.22)), wfRadians(3));
    wfTransform corner = wfMakeTransform(wfV2(WF_R(8.7), WF_R(2.42)), WF_R(0.8));
    contactPair(d, &plank, left, &box, flat);
    contactPair(d, &plank, right, &box, corner);
    wfManifold m;
    wfCollide(&plank, left, &box, flat, &m);
    contactPoints(d, &m, WF_INK_GOOD);
    int deepest = m.points[1].depth > m.points[0].depth;
    wfDrawCircle(d, WF_XY(m.points[deepest].point), 0.22f, 2, WF_INK_BAD, WF_INK_NONE);
    /* <draw the counterpart of the corner, by centres and by the normal> */
    wfCollide(&plank, right, &box, corner, &m);
    wfReal depth = m.points[0].depth;
    wfVec2 vertex = wfAddScaled(m.points[0].point, -depth / 2, m.normal);
    wfVec2 centres = wfNormalize(wfSub(right.p, corner.p));
    wfVec2 wrong = wfAddScaled(vertex, -depth, centres);
    wfVec2 good = wfAddScaled(vertex, depth, m.normal);
    narrowSegment(d, corner.p, right.p, 0.7f, WF_INK_FAINT);
    narrowSegment(d, vertex, wrong, 2, WF_INK_BAD);
    narrowSegment(d, vertex, good, 2, WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(wrong), 7, WF_INK_BAD);
    wfDrawPoint(d, WF_XY(good), 7, WF_INK_GOOD);
    wfDrawPoint(d, WF_XY(vertex), 5, WF_INK_LINE);
}
/* <figures> */
static void figure_contacts_clip(wfDraw *d, const wfFigureInput *in)
{
    wfShape table, body;
    wfVec2 corners[5] = { wfV2(-1, -WF_R(0.9)), wfV2(WF_R(1.1), -WF_R(0.9)),
                          wfV2(WF_R(1.3), WF_R(0.3)), wfV2(WF_R(0.1), 1),
                          wfV2(-WF_R(1.2), WF_R(0.3)) };
    wfMakeBox(WF_R(2.2), WF_R(0.9), &table);
    if (wfMakePolygon(corners, 5, &body) != WF_OK) return;
    wfTransform xt = wfMakeTransform(wfV2(3, WF_R(1.5)), 0);
    wfTransform xb = wfMakeTransform(narrowHandle(in, 0), WF_R(0.12));
    contactPair(d, &table, xt, &body, xb);
    wfManifold m;
    if (!wfCollide(&table, xt, &body, xb, &m)) return;
    for (int i = -1; i <= 1; i += 2) {
        wfVec2 end = wfV2(3 + WF_R(2.2) * (wfReal)i, WF_R(2.4));
        wfDrawDashed(d, (float)end.x, 0.2f, (float)end.x, 4.8f, 1, WF_INK_LINE);
    }
    wfDrawLine(d, 0.8f, 2.4f, 5.2f, 2.4f, 3, WF_INK_LINE);
    for (int i = 0; i < m.count; i++) {
        /* <write the name of contact point i> */
        wfVec2 p = m.points[i].point;
        uint32_t f = m.points[i].feature;
        wfDrawTextf(d, (float)p.x + 0.12f, (float)p.y + 0.05f, 12, WF_INK_TEXT, -1, "%d", i + 1);
        wfDrawTextf(d, 1, 1.5f - 0.4f * (float)i, 12, WF_INK_TEXT, -1,
                    "%d: corner %u of %c on edge %u, %.2f m", i + 1, f >> 8 & 255,
                    f >> 16 ? 'B' : 'A', f & 255, (double)m.points[i].depth);
    }
}
/* <figures> */
static void contactShape(wfDraw *d, const wfShape *s, wfTransform xf, int line, int fill)
{
    wfVec2 rim[WF_RIM_POINTS];
    float xy[2 * WF_RIM_POINTS];
    int n = wfShapeOutline(s, xf, rim);
    for (int i = 0; i < n; i++) {
        xy[2 * i] = (float)rim[i].x;
        xy[2 * i + 1] = (float)rim[i].y;
    }
    if (n > 2) wfDrawPolygon(d, xy, n, 1.5f, line, fill);
    else wfDrawPolyline(d, xy, n, 2.5f, line);
}

static void contactCore(wfDraw *d, const wfShape *s, wfTransform xf, int role)
{
    for (int i = 0; i < s->count; i++) {
        wfVec2 to = s->vertices[(i + 1) % s->count];
        narrowSegment(d, wfApply(xf, s->vertices[i]), wfApply(xf, to), 1.5f, role);
    }
}
/* <figures> */
static void figure_contacts_coats(wfDraw *d, const wfFigureInput *in)
{
    static const char *const steps[3] = { "the cores' edges", "cut", "coats put on" };
    wfShape table, pill;
    wfMakeRoundedBox(WF_R(1.5), WF_R(0.5), WF_R(0.3), &table);
    wfMakeCapsule(wfV2(-1, 0), wfV2(1, 0), WF_R(0.45), &pill);
    for (int i = 0; i < 3; i++) {
        wfReal x = WF_R(2.2) + 5 * (wfReal)i;
        wfTransform xt = wfMakeTransform(wfV2(x, WF_R(1.4)), 0);
        wfVec2 at = wfV2(x - WF_R(2.2) + narrowHandle(in, 0).x, narrowHandle(in, 0).y);
        wfTransform xp = wfMakeTransform(at, WF_R(0.06));
        bool last = i == 2;
        contactShape(d, &table, xt, last ? WF_INK_BODY : WF_INK_FAINT,
                     last ? WF_INK_BODY : WF_INK_NONE);
        contactShape(d, &pill, xp, last ? WF_INK_BODY2 : WF_INK_FAINT,
                     last ? WF_INK_BODY2 : WF_INK_NONE);
        contactCore(d, &table, xt, WF_INK_BODY);
        contactCore(d, &pill, xp, WF_INK_BODY2);
        /* <draw this step of the clipping> */
        wfManifold m;
        wfCollide(&table, xt, &pill, xp, &m);
        wfVec2 left = wfV2(x - WF_R(1.5), WF_R(1.9)), right = wfV2(x + WF_R(1.5), WF_R(1.9));
        narrowSegment(d, left, right, 3, WF_INK_LINE);
        wfVec2 up = wfV2(0, WF_R(1.6));
        for (int k = 0; k < 2 && i < 2; k++) {
            wfVec2 foot = k ? right : left, top = wfAdd(foot, up);
            wfDrawDashed(d, WF_XY(foot), WF_XY(top), 1, WF_INK_LINE);
        }
        if (i == 0) narrowSegment(d, wfApply(xp, pill.vertices[0]), wfApply(xp, pill.vertices[1]),
                                  3, WF_INK_ACCENT);
        wfVec2 ends[2] = { wfV2(0, 0), wfV2(0, 0) };
        for (int k = 0; k < m.count; k++) {         /* back from halfway to the core's end */
            wfReal back = pill.radius - m.points[k].depth / 2;
            ends[k] = wfAddScaled(m.points[k].point, back, m.normal);
            if (i == 1) wfDrawPoint(d, WF_XY(ends[k]), 7, WF_INK_ACCENT);
        }
        if (i == 1 && m.count == 2) narrowSegment(d, ends[0], ends[1], 3, WF_INK_ACCENT);
        if (last) contactPoints(d, &m, WF_INK_ACCENT);
        wfDrawText(d, (float)x, 0.1f, 14, WF_INK_TEXT, 0, steps[i]);
    }
}
/* <figures> */
static void figure_contacts_margin(wfDraw *d, const wfFigureInput *in)
{
    wfShape floor, box;
    wfSeparation s;
    wfManifold m;
    (void)in;
    wfMakeBox(WF_R(3.8), WF_R(0.4), &floor);
    wfMakeBox(WF_R(1.2), WF_R(0.7), &box);
    wfTransform xf = wfMakeTransform(wfV2(4, WF_R(0.5)), 0);
    wfTransform xb = wfMakeTransform(wfV2(4, WF_R(1.67)), WF_R(0.09));
    wfReal margin = WF_R(0.35);
    float band[8] = { 0.2f, 0.9f, 7.8f, 0.9f, 7.8f, 1.25f, 0.2f, 1.25f };
    narrowShape(d, &floor, xf, WF_INK_BODY, WF_INK_BODY);
    wfDrawPolygon(d, band, 4, 1, WF_INK_NONE, WF_INK_FAINT);
    narrowShape(d, &box, xb, WF_INK_BODY2, WF_INK_BODY2);
    if (wfSeparate(wfFindNarrowPhase("sat"), &floor, xf, &box, xb, &s) != WF_OK) return;
    wfMakeManifoldWithin(&floor, xf, &box, xb, &s, margin, &m);
    for (int k = 0; k < m.count; k++) {
        wfManifold one = { .normal = m.normal, .count = 1, .points = { m.points[k] } };
        bool gap = m.points[k].depth < 0;
        contactPoints(d, &one, gap ? WF_INK_GOOD : WF_INK_ACCENT);
        wfDrawTextf(d, (float)m.points[k].point.x, 0.3f, 13, WF_INK_TEXT, 0,
                    gap ? "gap %.2f m" : "depth %.2f m", (double)wfAbs(m.points[k].depth));
    }
}
/* <figures> */
/* one floor of tiles and a box that enters the next one; red: a normal of an inner edge */
static void ghostFloor(wfDraw *d, float x0, bool links, wfVec2 at)
{
    wfShape box, tile;
    wfReal x = (wfReal)x0;
    wfMakeBox(WF_R(0.9), WF_R(0.6), &box);
    wfTransform xb = wfMakeTransform(wfAdd(at, wfV2(x, 0)), 0);
    for (int i = 0; i < 4; i++) {
        wfReal left = WF_R(0.3) + WF_R(1.3) * (wfReal)i, right = left + WF_R(1.3);
        wfTransform xt = wfMakeTransform(wfV2(x, WF_R(1.2)), 0);
        wfVec2 p = wfV2(right, 0), q = wfV2(left, 0), along = wfV2(WF_R(1.3), 0);
        wfVec2 middle = wfV2(left + WF_R(0.65), WF_R(-0.35));
        if (links) wfMakeLink(wfAdd(p, along), p, q, wfSub(q, along), &tile);
        else wfMakeOrientedBox(middle, WF_R(0.65), WF_R(0.35), 0, &tile);
        contactShape(d, &tile, xt, WF_INK_BODY, WF_INK_BODY);
        if (links) wfDrawPoint(d, WF_XY(wfApply(xt, p)), 6, WF_INK_BODY);
    }
    contactShape(d, &box, xb, WF_INK_BODY2, WF_INK_BODY2);
    /* <draw what each tile thinks> */
    for (int i = 0; i < 4; i++) {
        wfReal left = WF_R(0.3) + WF_R(1.3) * (wfReal)i, right = left + WF_R(1.3);
        wfTransform xt = wfMakeTransform(wfV2(x, WF_R(1.2)), 0);
        wfVec2 p = wfV2(right, 0), q = wfV2(left, 0), along = wfV2(WF_R(1.3), 0);
        wfVec2 middle = wfV2(left + WF_R(0.65), WF_R(-0.35));
        wfManifold m;
        if (links) wfMakeLink(wfAdd(p, along), p, q, wfSub(q, along), &tile);
        else wfMakeOrientedBox(middle, WF_R(0.65), WF_R(0.35), 0, &tile);
        wfCollide(&tile, xt, &box, xb, &m);
        for (int k = 0; k < m.count; k++) {
            wfVec2 from = m.points[k].point, to = wfAddScaled(from, WF_R(0.7), m.normal);
            int role = m.normal.y > WF_R(0.9) ? WF_INK_GOOD : WF_INK_BAD;
            wfDrawArrow(d, WF_XY(from), WF_XY(to), 2.5f, role);
        }
    }
}
/* <figures> */
static void figure_contacts_ghost(wfDraw *d, const wfFigureInput *in)
{
    ghostFloor(d, 0, false, narrowHandle(in, 0));
    ghostFloor(d, 6, true, narrowHandle(in, 0));
    wfDrawText(d, 2.9f, 0.05f, 14, WF_INK_TEXT, 0, "boxes");
    wfDrawText(d, 8.9f, 0.05f, 14, WF_INK_TEXT, 0, "links");
}
/* <figures> */
/* the fan between two unit normals, as a slice of radius r about `at` */
static void gaussFan(wfDraw *d, wfVec2 at, wfVec2 from, wfVec2 to, wfReal r)
{
    float xy[2 * 14];
    xy[0] = (float)at.x;
    xy[1] = (float)at.y;
    wfReal turn = wfAtan2(wfCross(from, to), wfDot(from, to));
    for (int i = 0; i <= 12; i++) {
        wfVec2 u = wfRotate(wfRotation(turn * (wfReal)i / 12), from);
        xy[2 * i + 2] = (float)(at.x + r * u.x);
        xy[2 * i + 3] = (float)(at.y + r * u.y);
    }
    wfDrawPolygon(d, xy, 14, 1, WF_INK_ACCENT, WF_INK_ACCENT);
}
/* <figures> */
static void gaussLink(wfDraw *d, const wfShape *l, wfVec2 round)
{
    wfVec2 n = l->normals[0], far = wfAddScaled(round, WF_R(1.3), n);
    wfVec2 tip = wfAddScaled(l->centre, WF_R(0.9), n);
    wfVec2 after = wfPerpCW(wfNormalize(wfSub(l->vertices[3], l->vertices[1])));
    if (wfCross(n, after) > WF_R(0.001)) {
        gaussFan(d, l->vertices[1], n, after, WF_R(0.9));
        gaussFan(d, round, n, after, WF_R(1.3));
    }
    narrowSegment(d, l->vertices[0], l->vertices[1], 3, WF_INK_LINE);
    wfDrawArrow(d, WF_XY(l->centre), WF_XY(tip), 2, WF_INK_GOOD);
    wfDrawArrow(d, WF_XY(round), WF_XY(far), 2, WF_INK_GOOD);
}
/* <figures> */
static void figure_contacts_gauss(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 round = wfV2(WF_R(10.4), WF_R(1.7));
    wfVec2 p[7] = { wfV2(10, WF_R(0.6)), wfV2(WF_R(8.2), WF_R(1.0)), narrowHandle(in, 0),
                    narrowHandle(in, 1), narrowHandle(in, 2), wfV2(WF_R(0.4), WF_R(1.2)),
                    wfV2(-1, WF_R(1.2)) };
    float solid[2 * 7] = { 0.4f, 0.1f, 8.2f, 0.1f };
    for (int i = 1; i <= 5; i++) {
        solid[2 * i + 2] = (float)p[i].x;
        solid[2 * i + 3] = (float)p[i].y;
    }
    wfDrawPolygon(d, solid, 7, 1, WF_INK_NONE, WF_INK_BODY);
    wfDrawCircle(d, WF_XY(round), 1.3f, 1, WF_INK_FAINT, WF_INK_NONE);
    for (int i = 1; i < 5; i++) {
        wfShape link;
        wfVec2 after = i < 4 ? p[i + 2] : wfSub(wfScale(2, p[5]), p[4]);
        wfVec2 before = i > 1 ? p[i - 1] : wfSub(wfScale(2, p[1]), p[2]);
        if (wfMakeLink(before, p[i], p[i + 1], after, &link) == WF_OK)
            gaussLink(d, &link, round);
    }
}
/* <figures> */
static void impulse_arrow(wfDraw *d, wfVec2 at, wfVec2 v, float width, int role)
{
    wfVec2 tip = wfAdd(at, v);
    if (wfLengthSq(v) > WF_R(1e-4)) wfDrawArrow(d, WF_XY(at), WF_XY(tip), width, role);
}
/* <figures> */
static void figure_impulses_discs(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 hit = wfV2((wfReal)in->handle[0][0], (wfReal)in->handle[0][1]);
    wfVec2 b0 = wfV2(5, WF_R(2.5));
    wfVec2 n = wfNormalize(wfSub(b0, hit)), a0 = wfAddScaled(b0, WF_R(-1.6), n);
    wfBodyState a = { .p = a0, .v = wfV2(2, 0), .invMass = 1, .invInertia = 2 };
    wfBodyState b = { .p = b0, .invMass = WF_R(0.6), .invInertia = 1 };
    wfVec2 p = wfLerp(a0, b0, WF_R(0.5));
    wfDrawCircle(d, WF_XY(a0), 0.8f, 1.5f, WF_INK_LINE, WF_INK_BODY);
    wfDrawCircle(d, WF_XY(b0), 0.8f, 1.5f, WF_INK_LINE, WF_INK_BODY2);
    impulse_arrow(d, wfSub(a0, a.v), a.v, 1.5f, WF_INK_FAINT);
    wfVec2 label = wfAdd(wfSub(a0, a.v), wfV2(0, WF_R(0.15)));
    wfDrawText(d, WF_XY(label), 12, WF_INK_TEXT, -1, "before");
    wfReal j = wfResolvePoint(&a, &b, p, n, WF_R(0.8));
    impulse_arrow(d, a0, a.v, 3, WF_INK_LINE);
    impulse_arrow(d, b0, b.v, 3, WF_INK_LINE);
    impulse_arrow(d, p, wfScale(WF_R(0.3) * j, n), 3, WF_INK_ACCENT);
    wfDrawPoint(d, WF_XY(p), 6, WF_INK_TEXT);
    wfDrawTextf(d, 0.2f, 0.25f, 12, WF_INK_TEXT, -1, "impulse %.2f N s", (double)j);
}
/* <figures> */
static void impulse_outline(wfDraw *d, const wfShape *shape, wfTransform xf,
                            int line, int fill)
{
    float xy[2 * WF_MAX_VERTICES];
    for (int i = 0; i < shape->count; i++) {
        wfVec2 v = wfApply(xf, shape->vertices[i]);
        xy[2 * i] = (float)v.x;
        xy[2 * i + 1] = (float)v.y;
    }
    wfDrawPolygon(d, xy, shape->count, 1.5f, line, fill);
}
/* <figures> */
static void figure_impulses_corner(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfReal angle = wfClamp((wfReal)in->handle[0][0] / 4 - WF_R(0.5), WF_R(0.05), WF_R(1.5));
    wfMakeBox(1, WF_R(0.6), &box);
    wfBodyState floor = { .invMass = 0 };
    wfBodyState s = { .angle = angle, .v = wfV2(0, -1), .invMass = 1,
                      .invInertia = WF_R(2.2) };
    s.p.x = 3;
    s.p.y = WF_R(0.6) - wfShapeBounds(&box, wfBodyTransform(&s)).min.y;
    wfVec2 n = wfV2(0, 1), p = wfApply(wfBodyTransform(&s), box.vertices[0]);
    /* <draw the corner's velocities before and after> */
    wfDrawLine(d, 0.2f, 0.6f, 5.8f, 0.6f, 2, WF_INK_LINE);
    impulse_outline(d, &box, wfBodyTransform(&s), WF_INK_LINE, WF_INK_BODY);
    wfDrawDashed(d, WF_XY(s.p), WF_XY(p), 1.5f, WF_INK_FAINT);
    wfDrawPoint(d, WF_XY(s.p), 6, WF_INK_TEXT);
    wfVec2 beside = wfAdd(p, wfV2(WF_R(-0.12), 0));
    impulse_arrow(d, wfSub(beside, wfVelocityAt(&s, p)), wfVelocityAt(&s, p), 2, WF_INK_BAD);
    wfReal j = wfResolvePoint(&floor, &s, p, n, WF_R(0.5));
    impulse_arrow(d, wfAdd(p, wfV2(WF_R(-0.3), 0)), wfVelocityAt(&s, p), 2, WF_INK_GOOD);
    impulse_arrow(d, p, wfScale(2 * j, n), 3, WF_INK_ACCENT);
    wfDrawTextf(d, 5.8f, 3.3f, 12, WF_INK_TEXT, 1, "impulse %.2f N s", (double)j);
    wfDrawTextf(d, 5.8f, 3.0f, 12, WF_INK_TEXT, 1, "spin after %.2f rad/s", (double)s.w);
}
/* <figures> */
static void impulses_true_bounces(wfDraw *d, wfReal e)
{
    wfReal g = WF_R(9.81), v = 0, y = 1, begin = 0;
    float xy[2 * 161];
    for (int i = 0; i <= 160; i++) {
        wfReal t = (wfReal)i / 80 - begin, at = y + (v - g * t / 2) * t;
        if (at < 0) {                                   /* on from the next bounce */
            wfReal land = (v + wfSqrt(v * v + 2 * g * y)) / g;
            v = e * (g * land - v);
            begin += land, t -= land, y = 0, at = (v - g * t / 2) * t;
        }
        xy[2 * i] = 0.5f + 7 * (float)i / 160;
        xy[2 * i + 1] = 1 + 3.4f * (float)wfMaxR(at, 0);
    }
    wfDrawPolyline(d, xy, 161, 1, WF_INK_LINE);
}
/* <figures> */
static void figure_impulses_step(wfDraw *d, const wfFigureInput *in)
{
    const wfReal e = WF_R(0.8), g = WF_R(9.81);
    wfReal h = two_to(5 * step_line(d, in)) / 240;          /* 1/240 s to 1/7.5 s */
    wfBodyState floor = { .invMass = 0 }, ball = { .p = wfV2(0, 1), .invMass = 1 };
    float before[2] = { 0.5f, 4.4f };
    wfDrawLine(d, 0.3f, 1, 7.7f, 1, 2, WF_INK_LINE);
    impulses_true_bounces(d, e);
    for (wfReal t = h; t < 2; t += h) {
        ball.v.y -= g * h;
        ball.p.y += h * ball.v.y;
        if (ball.p.y < 0) wfResolvePoint(&floor, &ball, ball.p, wfV2(0, 1), e);
        float now[2] = { 0.5f + 3.5f * (float)t, 1 + 3.4f * (float)ball.p.y };
        if (now[1] > 0.5f) wfDrawLine(d, before[0], before[1], now[0], now[1], 1.5f,
                                      WF_INK_ACCENT);
        if (h > WF_R(0.012)) wfDrawPoint(d, now[0], now[1], 5, WF_INK_ACCENT);
        before[0] = now[0], before[1] = now[1];
    }
    wfDrawTextf(d, 4, 4.75f, 13, WF_INK_TEXT, 0, "step of 1/%.0f s", (double)(1 / h));
}
/* <figures> */
static void figure_friction_cone(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 foot = wfV2(4, WF_R(0.8)), n = wfV2(0, 1);
    wfReal mu = WF_R(0.35), speed = (wfReal)in->handle[0][0] - foot.x, up = WF_R(2.4);
    wfBodyState ground = { .p = wfV2(4, 0) };
    wfBodyState disc = { .p = wfV2(4, 2), .v = wfV2(speed, -2), .invMass = 1,
                         .invInertia = WF_R(1.4) };
    wfDrawLine(d, 0.2f, 0.8f, 7.8f, 0.8f, 2, WF_INK_LINE);
    wfDrawCircle(d, WF_XY(disc.p), 1.2f, 1.5f, WF_INK_LINE, WF_INK_BODY);
    for (int side = -1; side <= 1; side += 2) {
        wfVec2 border = wfAdd(foot, wfV2((wfReal)side * mu * up, up));
        wfDrawDashed(d, WF_XY(foot), WF_XY(border), 1.5f, WF_INK_LINE);
    }
    wfVec2 before = wfV2(disc.p.x + speed / 2, disc.p.y - 1);
    wfDrawArrow(d, WF_XY(disc.p), WF_XY(before), 1.5f, WF_INK_FAINT);
    wfReal jn = wfResolvePoint(&ground, &disc, foot, n, 0);
    wfReal want = -wfRelativeNormalVelocity(&ground, &disc, foot, wfContactTangent(n))
                  * wfEffectiveMass(&ground, &disc, foot, wfContactTangent(n));
    wfReal jt = wfRubPoint(&ground, &disc, foot, n, mu * jn, 0);
    /* <draw the impulses of the cone> */
    wfVec2 sticks = wfAdd(foot, wfV2(want, jn)), gets = wfAdd(foot, wfV2(jt, jn));
    wfDrawDashed(d, WF_XY(sticks), WF_XY(gets), 1, WF_INK_BAD);
    wfDrawPoint(d, WF_XY(sticks), 6, WF_INK_BAD);
    wfDrawArrow(d, WF_XY(foot), WF_XY(gets), 3, WF_INK_ACCENT);
    wfDrawTextf(d, 0.2f, 0.35f, 12, WF_INK_TEXT, -1, "normal %.2f N s", (double)jn);
    wfDrawTextf(d, 2.9f, 0.35f, 12, WF_INK_TEXT, -1, "to stick %.2f", (double)want);
    wfDrawTextf(d, 5.2f, 0.35f, 12, WF_INK_TEXT, -1, "friction %.2f", (double)jt);
}
/* <figures> */
static wfContact path_contact(wfBodyState *state, wfReal j0, wfReal j1)
{
    wfContact c = { .a = 0, .b = 1, .manifold = { .normal = wfV2(0, 1), .count = 2 } };
    wfReal j[2] = { j0, j1 };
    state[0] = (wfBodyState){ .invMass = 0 };
    state[1] = (wfBodyState){ .p = wfV2(0, WF_R(0.5)), .v = wfV2(0, -2), .w = WF_R(-0.9),
                              .invMass = 1, .invInertia = WF_R(2.5) };
    for (int i = 0; i < 2; i++) {
        wfContactPoint *p = &c.manifold.points[i];
        p->point = wfV2((wfReal)i - WF_R(0.5), 0);
        p->armA = p->point;
        p->armB = wfSub(p->point, state[1].p);
        p->normalImpulse = j[i];
    }
    return c;
}
/* <figures> */
/* the two impulses after so many passes that may only push */
static wfVec2 path_pushed(int passes)
{
    wfBodyState state[2];
    wfContact c = path_contact(state, 0, 0);
    wfReal j[2] = { 0, 0 };
    for (int i = 0; i < 2 * passes; i++) {
        wfVec2 p = c.manifold.points[i % 2].point;
        j[i % 2] += wfResolvePoint(&state[0], &state[1], p, c.manifold.normal, 0);
    }
    return wfV2(j[0], j[1]);
}
/* <figures> */
/* Did the engine do it? If not, whoever shows the figure is told. */
static bool figure_ok(wfDraw *d, wfResult result)
{
    if (result != WF_OK) d->refused++;
    return result == WF_OK;
}

/* the same with sums that are clamped, from a beginning */
static wfVec2 path_after(wfDraw *d, int passes, wfReal j0, wfReal j1)
{
    wfBodyState state[2];
    _Alignas(16) uint8_t memory[1024];
    wfContact c = path_contact(state, j0, j1);
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    wfSolve in = { .state = state, .bodyCount = 2, .contacts = &c, .contactCount = 1,
                   .h = 1, .iterations = passes, .scratch = &scratch };
    figure_ok(d, wfSolveVelocities(wfFindSolver("sequential"), &in));
    return wfV2(c.manifold.points[0].normalImpulse, c.manifold.points[1].normalImpulse);
}
/* <figures> */
static wfVec2 path_place(wfVec2 j)
{
    return wfV2(WF_R(0.6) + WF_R(2.6) * j.x, WF_R(0.6) + WF_R(2.6) * j.y);
}

static void path_line(wfDraw *d, int corner)
{
    wfBodyState state[2];
    wfContact c = path_contact(state, 0, 0);
    wfVec2 n = c.manifold.normal, here = c.manifold.points[corner].point;
    wfReal u = wfRelativeNormalVelocity(&state[0], &state[1], here, n), gain[2];
    for (int i = 0; i < 2; i++) {
        wfBodyState kicked = state[1];
        wfApplyImpulse(&kicked, n, c.manifold.points[i].point);
        gain[i] = wfRelativeNormalVelocity(&state[0], &kicked, here, n) - u;
    }
    /* <find the ends of the line> */
    wfVec2 from = wfV2((-u - WF_R(0.1) * gain[1]) / gain[0], WF_R(0.1));
    wfVec2 to = wfV2((-u - WF_R(1.5) * gain[1]) / gain[0], WF_R(1.5));
    if (corner == 1) {
        from = wfV2(0, -u / gain[1]);
        to = wfV2(WF_R(2.1), (-u - WF_R(2.1) * gain[0]) / gain[1]);
    }
    wfVec2 a = path_place(from), b = path_place(to);
    wfDrawLine(d, WF_XY(a), WF_XY(b), 1.5f, corner ? WF_INK_BODY2 : WF_INK_BODY);
    float x = corner == 1 ? 4.2f : (float)a.x + 0.2f, y = corner == 1 ? 3.3f : (float)a.y;
    wfDrawText(d, x, y, 12, WF_INK_TEXT, -1, corner ? "right at rest" : "left at rest");
}
/* <figures> */
static void path_draw(wfDraw *d, bool sums, wfReal j0, wfReal j1, int role)
{
    wfVec2 before = path_place(wfV2(j0, j1));
    wfDrawPoint(d, WF_XY(before), 7, role);
    for (int passes = 1; passes <= 12; passes++) {
        wfVec2 j = sums ? path_after(d, passes, j0, j1) : path_pushed(passes);
        wfVec2 corner = path_place(wfV2(j.x, j.y)), turn = wfV2(corner.x, before.y);
        wfDrawLine(d, WF_XY(before), WF_XY(turn), 1.5f, role);
        wfDrawLine(d, WF_XY(turn), WF_XY(corner), 1.5f, role);
        wfDrawPoint(d, WF_XY(corner), 5, role);
        before = corner;
    }
}
/* <figures> */
static void figure_sequential_path(wfDraw *d, const wfFigureInput *in)
{
    wfReal j0 = wfMaxR(((wfReal)in->handle[0][0] - WF_R(0.6)) / WF_R(2.6), 0);
    wfReal j1 = wfMaxR(((wfReal)in->handle[0][1] - WF_R(0.6)) / WF_R(2.6), 0);
    wfDrawArrow(d, 0.6f, 0.6f, 6.4f, 0.6f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.6f, 0.6f, 0.6f, 5.0f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 6.4f, 0.25f, 12, WF_INK_TEXT, 1, "impulse at the left corner");
    wfDrawText(d, 0.75f, 4.8f, 12, WF_INK_TEXT, -1, "impulse at the right corner");
    path_line(d, 0);
    path_line(d, 1);
    path_draw(d, true, j0, j1, WF_INK_GOOD);
    path_draw(d, false, 0, 0, WF_INK_BAD);
}
/* <figures> */
/* The impulses under n boxes after so many passes, in units of a box's weight in a step. */
static void tower_passes(wfDraw *d, int n, int passes, wfReal *impulse, wfReal *sink)
{
    static _Alignas(16) uint8_t memory[1 << 15];
    wfBodyState state[9] = { { .invMass = 0 } };
    wfContact c[8] = { { .a = 0 } };
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    for (int i = 0; i < n; i++) {
        /* <put a box that falls on the tower, and a contact below it> */
        wfVec2 at = wfV2(0, (wfReal)i);
        state[i + 1] = (wfBodyState){ .p = wfV2(0, (wfReal)i + WF_R(0.5)), .v = wfV2(0, -1),
                                      .invMass = 1 };
        c[i] = (wfContact){ .a = i, .b = i + 1,
                            .manifold = { .normal = wfV2(0, 1), .count = 1 } };
        c[i].manifold.points[0].point = at;
        c[i].manifold.points[0].armA = wfSub(at, state[i].p);
        c[i].manifold.points[0].armB = wfSub(at, state[i + 1].p);
    }
    wfSolve in = { .state = state, .bodyCount = n + 1, .contacts = c, .contactCount = n,
                   .h = 1, .iterations = passes, .scratch = &scratch };
    figure_ok(d, wfSolveVelocities(wfFindSolver("sequential"), &in));
    for (int i = 0; i < n; i++) {
        impulse[i] = c[i].manifold.points[0].normalImpulse;
        sink[i] = -state[i + 1].v.y;
    }
}
/* <figures> */
static void figure_sequential_passes(wfDraw *d, const wfFigureInput *in)
{
    enum { BOXES = 8 };
    wfReal impulse[BOXES], sink[BOXES];
    int passes = (int)two_to(7 * handle_line(d, in, "few", "many"));
    tower_passes(d, BOXES, passes, impulse, sink);
    for (int i = 0; i < BOXES; i++) {
        float y = 0.75f + 0.5f * (float)i, low = y - 0.55f * (float)sink[i];
        float box[8] = { 1, low, 1.9f, low, 1.9f, low + 0.46f, 1, low + 0.46f };
        float wide = 0.55f * (float)impulse[i];
        float bar[8] = { 3, y + 0.08f, 3 + wide, y + 0.08f, 3 + wide, y + 0.38f, 3,
                         y + 0.38f };
        wfDrawPolygon(d, box, 4, 1.5f, WF_INK_BODY, WF_INK_BODY);
        if (wide > 0) wfDrawPolygon(d, bar, 4, 1, WF_INK_ACCENT, WF_INK_ACCENT);
        float x = 3 + 0.55f * (float)(BOXES - i);
        wfDrawLine(d, x, y, x, y + 0.46f, 2, WF_INK_LINE);
    }
    wfDrawTextf(d, 4, 5.1f, 13, WF_INK_TEXT, 0, passes == 1 ? "%d pass" : "%d passes",
                passes);
    wfDrawText(d, 1.45f, 4.85f, 11, WF_INK_TEXT, 0, "sinking");
    wfDrawText(d, 7.6f, 4.3f, 11, WF_INK_TEXT, 1, "impulse below (line: needed)");
}
/* <figures> */
static void bounce_figure_step(wfDraw *d, wfBodyState *state, wfContact *c, int row)
{
    wfReal h = WF_R(0.1), g = WF_R(-9.81);
    _Alignas(16) static uint8_t memory[1 << 14];
    wfBodyForces force[2] = { { .torque = 0 }, { .force = wfV2(0, g) } };
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    if (wfSolverTable[row].step == NULL) {
        state[1].p = wfAdd(wfAddScaled(state[1].p, h, state[1].v), wfV2(0, g * h * h / 2));
        state[1].v.y += g * h;
    }
    wfContactPoint *p = &c->manifold.points[0];
    p->depth = WF_R(0.2) - state[1].p.y;
    p->point = wfV2(state[1].p.x, 0);
    p->armA = p->point;
    p->armB = wfV2(0, WF_R(-0.2));
    bool near = wfSolverTable[row].step != NULL || p->depth >= 0;
    wfSolve in = { .state = state, .bodyCount = 2, .contacts = c, .contactCount = near,
                   .h = h, .iterations = 1, .forces = force, .substeps = 1,
                   .positionShare = WF_R(0.4), .scratch = &scratch };
    if (wfSolverTable[row].step != NULL) figure_ok(d, wfSolveStep(row, &in));
    else if (figure_ok(d, wfSolveVelocities(row, &in)))
        figure_ok(d, wfSolvePositions(row, &in));
}
/* <figures> */
static void bounce_figure_path(wfDraw *d, const char *solver, wfReal top, int role)
{
    wfBodyState state[2] = { { .invMass = 0 }, { .p = wfV2(WF_R(0.3), top),
        .v = wfV2(WF_R(1.2), 0), .invMass = 1, .invInertia = 50 } };
    wfContact c = { .a = 0, .b = 1, .restitution = 1,
                    .manifold = { .normal = wfV2(0, 1), .count = 1 } };
    c.manifold.points[0].feature = WF_FEATURE_CIRCLE;
    for (int i = 0; i < 60; i++) {
        wfVec2 from = state[1].p;
        bounce_figure_step(d, state, &c, wfFindSolver(solver));
        wfDrawLine(d, WF_XY(from), WF_XY(state[1].p), 1.5f, role);
        wfDrawPoint(d, WF_XY(from), 4, role);
    }
}

static void figure_soft_path(wfDraw *d, const wfFigureInput *in)
{
    wfReal top = wfClamp((wfReal)in->handle[0][1], WF_R(0.6), WF_R(2.5));
    wfDrawLine(d, 0.1f, 0.02f, 7.7f, 0.02f, 2, WF_INK_LINE);
    wfDrawDashed(d, 0.1f, (float)top, 7.7f, (float)top, 1, WF_INK_LINE);
    bounce_figure_path(d, "impulse-friction", top, WF_INK_BAD);
    bounce_figure_path(d, "soft", top, WF_INK_GOOD);
}
/* <figures> */
enum { SAG_BOXES = 10 };

static void sag_step(wfDraw *d, wfBodyState *state, wfContact *c, int substeps)
{
    _Alignas(16) static uint8_t memory[1 << 15];
    wfBodyForces force[SAG_BOXES + 1] = { { .torque = 0 } };
    wfPool scratch;
    wfPoolInit(&scratch, sizeof memory, memory);
    for (int i = 0; i < SAG_BOXES; i++) {
        wfContactPoint *p = &c[i].manifold.points[0];
        p->depth = 1 - (state[i + 1].p.y - state[i].p.y);
        p->point = wfAdd(state[i].p, wfV2(0, WF_R(0.5)));
        p->armA = wfV2(0, WF_R(0.5));
        p->armB = wfSub(p->point, state[i + 1].p);
        force[i + 1].force = wfV2(0, WF_R(-9.81));
    }
    wfSolve in = { .state = state, .bodyCount = SAG_BOXES + 1, .contacts = c,
                   .contactCount = SAG_BOXES, .h = WF_R(1.0) / 60, .iterations = 1,
                   .forces = force, .substeps = substeps, .scratch = &scratch };
    figure_ok(d, wfSolveStep(wfFindSolver("soft"), &in));
}
/* <figures> */
static void sag_tower(wfDraw *d, wfBodyState *state, int substeps)
{
    wfContact c[SAG_BOXES];
    for (int i = 0; i <= SAG_BOXES; i++)
        state[i] = (wfBodyState){ .p = wfV2(0, (wfReal)i - WF_R(0.5)), .invMass = i > 0 };
    for (int i = 0; i < SAG_BOXES; i++)
        c[i] = (wfContact){ .a = i, .b = i + 1,
                            .manifold = { .normal = wfV2(0, 1), .count = 1 } };
    for (int i = 0; i < 480; i++) sag_step(d, state, c, substeps);
}
/* <figures> */
static void figure_soft_sag(wfDraw *d, const wfFigureInput *in)
{
    wfBodyState state[SAG_BOXES + 1];
    int substeps = (int)two_to(4 * handle_line(d, in, "1", "16"));
    float give = (float)WF_CONTACT_PERIOD / (60 * (float)substeps * 2 * (float)WF_PI);
    float sunk = 0, foot = 0.75f, side = 0.42f;
    sag_tower(d, state, substeps);
    wfDrawLine(d, 1.5f, foot, 6.5f, foot, 2, WF_INK_LINE);
    for (int i = 0; i < SAG_BOXES; i++) {
        float fall = (float)i + 0.5f - (float)state[i + 1].p.y;
        float low = foot + side * ((float)i - 10 * fall), top = low + side;
        float box[8] = { 3, low, 3.42f, low, 3.42f, top, 3, top };
        sunk += 9.81f * give * give * (float)((i ? 2 : 1) * (SAG_BOXES - i));
        float line = foot + side * ((float)i + 1 - 10 * sunk);  /* eq:soft-squash */
        wfDrawPolygon(d, box, 4, 1.5f, WF_INK_BODY, WF_INK_NONE);
        wfDrawLine(d, 3.5f, line, 4.1f, line, 1.5f, WF_INK_ACCENT);
    }
    wfDrawTextf(d, 4, 5.25f, 13, WF_INK_TEXT, 0,
                substeps == 1 ? "%d substep" : "%d substeps", substeps);
    wfDrawTextf(d, 4.4f, 2.8f, 13, WF_INK_TEXT, -1, "the top has sunk by %.1f mm",
                1000 * (double)(WF_R(9.5) - state[SAG_BOXES].p.y));
    wfDrawTextf(d, 4.4f, 2.4f, 13, WF_INK_ACCENT, -1, "by the formula %.1f mm",
                1000 * (double)sunk);
}
/* <figures> */
static void gather_square(wfDraw *d, float left, bool turned, const char *title)
{
    static const char *const name[4] = { "vx", "vy", "w", "1/m" };
    static const int ink[4] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD, WF_INK_BAD };
    wfDrawText(d, left + 2, 4.75f, 12, WF_INK_TEXT, 0, title);
    for (int row = 0; row < 4; row++)
        for (int column = 0; column < 4; column++) {
            int body = turned ? column : row, number = turned ? row : column;
            float x = left + (float)column, y = 3.55f - (float)row;
            const float l = x + 0.06f, r = x + 0.94f, low = y + 0.12f, top = y + 0.88f;
            const float box[8] = { l, low, r, low, r, top, l, top };
            wfDrawPolygon(d, box, 4, 1.5f, ink[body], WF_INK_NONE);
            wfDrawText(d, x + 0.5f, y + 0.38f, 12, WF_INK_TEXT, 0, name[number]);
        }
}
/* <figures> */
static void figure_soft_gather(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    gather_square(d, 1.7f, false, "as they are loaded");
    gather_square(d, 8.1f, true, "as they are used");
    wfDrawArrow(d, 6.1f, 2.5f, 7.7f, 2.5f, 2, WF_INK_LINE);
    for (int row = 0; row < 4; row++) {
        static const char *const body[4] = { "body 5", "body 9", "body 2", "body 7" };
        float y = 3.9f - (float)row;
        wfDrawText(d, 1.5f, y, 12, WF_INK_TEXT, 1, body[row]);
    }
}
/* <figures> */
static void joints_box(wfDraw *d, const wfBodyState *s, float wide, float high, int ink)
{
    float xy[8];
    for (int i = 0; i < 4; i++) {
        float x = i == 0 || i == 3 ? -wide : wide, y = i < 2 ? -high : high;
        wfVec2 p = wfApply(wfBodyTransform(s), wfV2((wfReal)x, (wfReal)y));
        xy[2 * i] = (float)p.x, xy[2 * i + 1] = (float)p.y;
    }
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, ink);
}

static void joints_arc(wfDraw *d, wfVec2 at, int ink)
{
    for (int i = 0; i < 9; i++) {
        wfReal a = WF_R(0.4) + WF_R(0.25) * (wfReal)i, r = WF_R(0.34);
        wfVec2 p = wfRotate(wfRotation(a), wfV2(r, 0));
        wfVec2 q = wfRotate(wfRotation(a + WF_R(0.25)), wfV2(r, 0));
        p = wfAdd(at, p), q = wfAdd(at, q);
        wfDrawLine(d, WF_XY(p), WF_XY(q), 2, ink);
    }
}
/* <figures> */
static void joints_rows(wfDraw *d, const wfJoint *j, const wfBodyState *s)
{
    static const int inks[] = { WF_INK_FAINT, WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD,
                                WF_INK_BODY2 };
    wfJointRow row[WF_JOINT_ROWS] = { { .law = WF_ROW_OFF } };
    wfBuildJoint(j, &s[0], &s[1], row);
    wfVec2 a = wfApply(wfBodyTransform(&s[0]), j->localA);
    wfVec2 b = wfApply(wfBodyTransform(&s[1]), j->localB);
    wfDrawLine(d, WF_XY(a), WF_XY(b), 1, WF_INK_FAINT);
    for (int i = 0; i < WF_JOINT_ROWS; i++) {
        if (row[i].law == WF_ROW_OFF) continue;
        wfVec2 end = wfAddScaled(b, WF_R(0.55), row[i].jB);
        if (wfLengthSq(row[i].jB) > 0)
            wfDrawArrow(d, WF_XY(b), WF_XY(end), 2, inks[row[i].law]);
        else
            joints_arc(d, s[1].p, inks[row[i].law]);
    }
    wfDrawPoint(d, WF_XY(a), 5, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(b), 5, WF_INK_LINE);
}
/* <figures> */
static void figure_joints_kinds(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int k = 0; k < wfJointKinds; k++) {
        float x = 3.1f * (float)(k % 4), y = 2.6f * (float)(3 - k / 4);
        wfBodyState s[2] = { { .p = wfV2((wfReal)x + WF_R(0.8), (wfReal)y + WF_R(0.9)) },
            { .p = wfV2((wfReal)x + WF_R(2.1), (wfReal)y + WF_R(1.1)),
              .angle = WF_R(0.3) } };
        const char *name = wfJointTable[k].name;
        bool pinned = k == wfFindJoint("revolute") || k == wfFindJoint("weld");
        wfVec2 middle = wfV2((wfReal)x + WF_R(1.5), (wfReal)y + WF_R(0.95));
        wfJoint j = pinned ? wfMakeJoint(name, 0, s, 1, s + 1, middle, middle, wfV2(1, 0))
                           : wfMakeJoint(name, 0, s, 1, s + 1, s[0].p, s[1].p, wfV2(1, 0));
        if (k == wfFindJoint("pulley") || k == wfFindJoint("hand"))
            j.groundA = wfAdd(s[0].p, wfV2(0, 1)), j.groundB = wfAdd(s[1].p, wfV2(0, 1));
        j.stiffness = 1;
        if (k == wfFindJoint("turn") || k == wfFindJoint("wheel")) j.flags = WF_JOINT_MOTOR;
        joints_box(d, &s[0], 0.55f, 0.3f, WF_INK_BODY);
        joints_box(d, &s[1], 0.5f, 0.25f, WF_INK_BODY2);
        joints_rows(d, &j, s);
        wfDrawText(d, x + 1.5f, y + 0.1f, 13, WF_INK_TEXT, 0, name);
    }
}
/* <figures> */
static void figure_joints_aim(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 p = wfV2(2, 0);
    const wfReal h = WF_R(0.35);
    (void)in;
    wfDrawView(d, -2.6f, -0.6f, 3.0f, 3.0f);
    wfDrawCircle(d, 0, 0, 2, 1, WF_INK_FAINT, -1);
    /* <go along the tangent five times> */
    for (int i = 0; i < 5; i++) {                   /* the rate held: along the tangent */
        wfVec2 q = wfAddScaled(p, 2 * h, wfPerpCCW(wfNormalize(p)));
        wfDrawArrow(d, WF_XY(p), WF_XY(q), 2, WF_INK_BAD);
        p = q;
    }
    wfBodyState s[2] = { { .invMass = 0 },
                         { .p = wfV2(2, 0), .v = wfV2(0, 2), .invMass = 1 } };
    _Alignas(WF_POOL_ALIGN) unsigned char memory[16384];
    wfPool pool;
    wfJoint j = wfRod(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(2, 0));
    wfPoolInit(&pool, sizeof memory, memory);
    wfJointStep step = { .state = s, .bodyCount = 2, .joints = &j, .jointCount = 1, .h = h,
                         .substeps = 1, .passes = 4, .scratch = &pool };
    for (int i = 0; i < 5; i++) {
        p = s[1].p;
        if (!figure_ok(d, wfStepJoints(&step))) return;
        wfDrawArrow(d, WF_XY(p), WF_XY(s[1].p), 2, WF_INK_GOOD);
    }
    wfDrawPoint(d, 0, 0, 6, WF_INK_LINE);
}
/* <figures> */
static wfVec2 joints_on_spring(wfBodyState *s, wfReal h)
{
    wfReal length = wfLength(s->p);
    wfVec2 pull = wfScale(-9810 * (length - 2) / length, s->p);
    s->v = wfAddScaled(s->v, h, wfAdd(pull, wfV2(0, WF_R(-9.81))));
    return s->p = wfAddScaled(s->p, h, s->v);
}
/* <figures> */
static void joints_path(wfDraw *d, bool spring, wfReal h, int ink)
{
    static _Alignas(16) uint8_t memory[1 << 14];
    wfBodyState s[2] = { { .invMass = 0 }, { .p = wfV2(2, 0), .invMass = 1 } };
    wfBodyForces forces[2] = { { .torque = 0 }, { .force = wfV2(0, WF_R(-9.81)) } };
    wfJoint rod = wfRod(0, &s[0], 1, &s[1], wfV2(0, 0), wfV2(2, 0));
    wfPool pool;
    wfPoolInit(&pool, sizeof memory, memory);
    wfJointStep step = { .state = s, .bodyCount = 2, .joints = &rod, .jointCount = 1,
        .forces = forces, .h = h, .substeps = 1, .passes = 1, .period = WF_JOINT_PERIOD,
        .damping = WF_JOINT_DAMPING, .give = WF_JOINT_GIVE, .scratch = &pool };
    for (wfReal t = 0; t < WF_R(1.4); t += h) {
        wfVec2 p = s[1].p;
        if (spring) joints_on_spring(&s[1], h);
        else if (!figure_ok(d, wfStepJoints(&step))) return;
        wfVec2 q = s[1].p;
        if (!(wfAbs(q.x) < WF_R(3.9) && q.y > WF_R(-2.9) && q.y < WF_R(2.2))) return;
        wfDrawLine(d, 4 + (float)p.x, 3.5f + (float)p.y, 4 + (float)q.x, 3.5f + (float)q.y,
                   1.5f, ink);
        if (h > WF_R(0.012)) wfDrawPoint(d, 4 + (float)q.x, 3.5f + (float)q.y, 5, ink);
    }
}
/* <figures> */
static void figure_joints_step(wfDraw *d, const wfFigureInput *in)
{
    wfReal h = two_to(5 * step_line(d, in)) / 480;          /* 1/480 s to 1/15 s */
    wfDrawPoint(d, 4, 3.5f, 9, WF_INK_LINE);
    joints_path(d, true, h, WF_INK_BAD);
    joints_path(d, false, h, WF_INK_GOOD);
    wfDrawTextf(d, 4, 0.5f, 13, WF_INK_TEXT, 0, "step of 1/%.0f s", (double)(1 / h));
    wfDrawText(d, 7.8f, 5.2f, 13, WF_INK_GOOD, 1, "a joint");
    wfDrawText(d, 7.8f, 4.9f, 13, WF_INK_BAD, 1, "a stiff spring");
}
/* <figures> */
enum { ARCH_STONES = 15 };
typedef struct figArch {
    wfShape      shape[ARCH_STONES + 1];
    wfBodyState  state[ARCH_STONES + 1];
    wfBodyForces force[ARCH_STONES + 1];
    wfContact    contact[2 * ARCH_STONES];
    int          contacts;
    _Alignas(16) uint8_t memory[1 << 17];
} figArch;
/* <figures> */
static void arch_stone(figArch *f, int i, wfReal r, wfReal thickness)
{
    wfReal part = WF_PI / ARCH_STONES;
    wfVec2 corner[4];
    wfMassData mass;
    for (int k = 0; k < 4; k++) {
        wfRot q = wfRotation(part * (wfReal)(k < 2 ? i - 1 : i));
        wfReal at = r * (1 + (k == 0 || k == 3 ? -thickness : thickness) / 2);
        corner[k] = wfScale(at, wfV2(q.c, q.s));
    }
    if (wfMakePolygon(corner, 4, &f->shape[i]) != WF_OK) return;
    if (wfShapeMass(&f->shape[i], 1, &mass) != WF_OK) return;
    for (int k = 0; k < 4; k++) corner[k] = wfSub(corner[k], mass.centre);
    wfMakePolygon(corner, 4, &f->shape[i]);
    f->state[i] = (wfBodyState){ .p = mass.centre, .invMass = 1 / mass.mass,
                                 .invInertia = 1 / mass.inertia };
    f->force[i].force = wfV2(0, WF_R(-9.81) * mass.mass);
}
/* <figures> */
static void arch_touch(figArch *f)
{
    f->contacts = 0;
    for (int i = 0; i <= ARCH_STONES; i++)
        for (int k = i + 1; k <= ARCH_STONES; k++) {
            wfSeparation s;
            wfTransform xi = wfBodyTransform(&f->state[i]);
            wfTransform xk = wfBodyTransform(&f->state[k]);
            wfContact c = { .a = i, .b = k, .friction = 1 };
            bool near = k == i + 1 || (i == 0 && k == ARCH_STONES);
            if (!near || wfSeparate(0, &f->shape[i], xi, &f->shape[k], xk, &s) != WF_OK)
                continue;
            wfMakeManifoldWithin(&f->shape[i], xi, &f->shape[k], xk, &s, WF_R(0.05),
                                 &c.manifold);
            if (c.manifold.count > 0) f->contact[f->contacts++] = c;
        }
}
/* <figures> */
static void arch_step(wfDraw *d, figArch *f)
{
    wfPool scratch;
    wfPoolInit(&scratch, sizeof f->memory, f->memory);
    arch_touch(f);
    wfSolve in = { .state = f->state, .bodyCount = ARCH_STONES + 1, .contacts = f->contact,
                   .contactCount = f->contacts, .h = WF_R(1.0) / 60, .iterations = 1,
                   .positionShare = WF_R(0.4), .forces = f->force, .substeps = 4,
                   .scratch = &scratch };
    figure_ok(d, wfSolveStep(wfFindSolver("exact"), &in));
}
/* <figures> */
static void figure_exact_arch(wfDraw *d, const wfFigureInput *in)
{
    static figArch f;
    wfReal thickness = wfClamp((wfReal)in->handle[0][1] - 3, WF_R(0.06), WF_R(0.4));
    f = (figArch){ .contacts = 0 };
    wfDrawView(d, -4.0f, -0.4f, 4.0f, 4.0f);
    wfMakeBox(8, WF_R(0.5), &f.shape[0]);
    f.state[0].p = wfV2(0, WF_R(-0.5));
    for (int i = 1; i <= ARCH_STONES; i++) arch_stone(&f, i, 3, thickness);
    for (int i = 0; i < 30; i++) arch_step(d, &f);
    wfDrawLine(d, -3.9f, 0, 3.9f, 0, 2, WF_INK_LINE);
    for (int i = 1; i <= ARCH_STONES; i++)
        forces_shape(d, &f.shape[i], wfBodyTransform(&f.state[i]), WF_INK_BODY);
    for (int i = 0; i < f.contacts; i++) {
        /* <draw where the line of thrust goes through this joint of the arch> */
        const wfManifold *m = &f.contact[i].manifold;
        wfReal sum = 0;
        wfVec2 at = wfV2(0, 0);
        for (int k = 0; k < m->count; k++) {
            sum += m->points[k].normalImpulse;
            at = wfAddScaled(at, m->points[k].normalImpulse, m->points[k].point);
        }
        if (!(sum > 0)) continue;
        at = wfScale(1 / sum, at);
        wfDrawPoint(d, WF_XY(at), 6, WF_INK_BAD);
    }
}
/* <figures> */
enum { COMPOUND_MOST = 64 };

typedef struct CompoundFigure {
    wfVec2 corners[COMPOUND_MOST];
    wfShape shapes[COMPOUND_MOST];
    int n, count;
    wfMesh mesh;
    wfPool pool;
    _Alignas(16) uint8_t bytes[COMPOUND_MOST * 128];
} CompoundFigure;

static void compoundOpen(CompoundFigure *f, const float *xy, int n, wfVec2 at)
{
    wfPoolInit(&f->pool, sizeof f->bytes, f->bytes);
    f->n = n;
    f->count = 0;
    for (int i = 0; i < n; i++)
        f->corners[i] = wfAdd(at, wfV2((wfReal)xy[2 * i], (wfReal)xy[2 * i + 1]));
}
/* <figures> */
static void compoundOutline(wfDraw *d, const CompoundFigure *f, float widthPx, int role)
{
    float xy[2 * COMPOUND_MOST];
    for (int i = 0; i < f->n; i++) {
        xy[2 * i] = (float)f->corners[i].x;
        xy[2 * i + 1] = (float)f->corners[i].y;
    }
    wfDrawPolygon(d, xy, f->n, widthPx, role, WF_INK_NONE);
}
/* <figures> */
static void compoundShapes(wfDraw *d, CompoundFigure *f)
{
    wfTransform here = wfTransformIdentity();
    wfPoolReset(&f->pool);
    if (wfDecompose(f->corners, f->n, f->shapes, COMPOUND_MOST, &f->count, &f->pool))
        f->count = 0;
    for (int i = 0; i < f->count; i++)
        figure_shape(d, &f->shapes[i], here, 1, WF_INK_BODY, WF_INK_BODY);
    compoundOutline(d, f, 2, f->count ? WF_INK_LINE : WF_INK_BAD);
}
/* <figures> */
/* the pieces of the mesh, the first `most` half-edges of it, filled */
static void compoundMesh(wfDraw *d, const CompoundFigure *f, int32_t most)
{
    int32_t ring[COMPOUND_MOST];
    float xy[2 * COMPOUND_MOST];
    for (int32_t h = 0; h < most; h++) {
        int32_t n = wfMeshRing(&f->mesh, h, ring);
        for (int32_t i = 0; i < n; i++) {
            xy[2 * i] = (float)f->mesh.corners[ring[i]].x;
            xy[2 * i + 1] = (float)f->mesh.corners[ring[i]].y;
        }
        if (n > 2) wfDrawPolygon(d, xy, n, 1, WF_INK_BODY, WF_INK_BODY);
    }
    compoundOutline(d, f, 2, WF_INK_LINE);
}
/* <figures> */
static const float COMPOUND_U[16] = { -1.3f, 0, 1.3f, 0, 1.3f, 2.2f,
    0.8f, 2.2f, 0.8f, 0.5f, -0.8f, 0.5f, -0.8f, 2.2f, -1.3f, 2.2f };

/* the ball, and the way out of it if it overlaps one of the shapes */
static void compoundBall(wfDraw *d, const wfShape *shapes, int count, wfVec2 at)
{
    wfShape ball;
    wfTransform here = wfTransformIdentity();
    int role = WF_INK_GOOD;
    wfMakeCircle(at, WF_R(0.35), &ball);
    for (int i = 0; i < count; i++) {
        wfSeparation s;
        if (wfSeparate(0, &shapes[i], here, &ball, here, &s) != WF_OK) continue;
        if (s.distance >= 0) continue;
        wfVec2 free = wfAddScaled(at, -s.distance, s.normal);
        wfDrawArrow(d, WF_XY(at), WF_XY(free), 2.5f, WF_INK_BAD);
        role = WF_INK_BAD;
    }
    wfDrawCircle(d, WF_XY(at), 0.35f, 2, role, role);
}
/* <figures> */
static void figure_compound_hull(wfDraw *d, const wfFigureInput *in)
{
    CompoundFigure f;
    wfShape hull;
    wfVec2 ball = figure_handle_at(in, 0), over = wfAdd(ball, wfV2(4, 0));
    compoundOpen(&f, COMPOUND_U, 8, wfV2(2, WF_R(0.7)));
    if (wfMakePolygon(f.corners, 8, &hull) != WF_OK) return;
    figure_shape(d, &hull, wfTransformIdentity(), 1, WF_INK_BAD, WF_INK_BODY);
    compoundOutline(d, &f, 2, WF_INK_LINE);
    compoundBall(d, &hull, 1, ball);
    compoundOpen(&f, COMPOUND_U, 8, wfV2(6, WF_R(0.7)));
    compoundShapes(d, &f);
    compoundBall(d, f.shapes, f.count, over);
    wfDrawTextf(d, 2, 0.25f, 13, WF_INK_TEXT, 0, "hull: area %.2f",
                (double)wfShapeArea(&hull));
    wfMassData m;
    if (wfShapesMass(f.shapes, f.count, 1, &m) != WF_OK) return;
    wfDrawTextf(d, 6, 0.25f, 13, WF_INK_TEXT, 0, "%d pieces: area %.2f", f.count,
                (double)m.area);
}
/* <figures> */
static void figure_compound_l(wfDraw *d, const wfFigureInput *in)
{
    wfShape plank[2];
    wfMassData part[2], all;
    wfVec2 at[2] = { wfV2(WF_R(2.2), WF_R(2.1)), figure_handle_at(in, 0) };
    if (wfMakeOrientedBox(at[0], WF_R(0.4), WF_R(1.6), 0, &plank[0]) != WF_OK) return;
    if (wfMakeOrientedBox(at[1], 1, WF_R(0.4), 0, &plank[1]) != WF_OK) return;
    for (int i = 0; i < 2; i++)
        if (wfShapeMass(&plank[i], 1, &part[i]) != WF_OK) return;
    if (wfCombineMasses(part, 2, &all) != WF_OK) return;
    for (int i = 0; i < 2; i++) {
        int role = i ? WF_INK_BODY2 : WF_INK_BODY;
        figure_shape(d, &plank[i], wfTransformIdentity(), 2, WF_INK_LINE, role);
        wfDrawDashed(d, WF_XY(part[i].centre), WF_XY(all.centre), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(part[i].centre), 6, WF_INK_LINE);
        /* <write what a plank adds to the inertia> */
        double moved = (double)(wfInertiaAbout(&part[i], all.centre) - part[i].inertia);
        wfDrawTextf(d, 7.8f, 3.4f - 0.5f * (float)i, 14, role, 1, "own %.2f, moved %.2f",
                    (double)part[i].inertia, moved);
    }
    wfDrawPoint(d, WF_XY(all.centre), 11, WF_INK_ACCENT);
    wfDrawTextf(d, 7.8f, 2.2f, 14, WF_INK_ACCENT, 1, "sum: %.2f kg m²",
                (double)all.inertia);
}
/* <figures> */
static void figure_compound_sign(wfDraw *d, const wfFigureInput *in)
{
    enum { SIDE = 20 };
    static const int role[3] = { WF_INK_BODY2, WF_INK_LINE, WF_INK_BODY };
    wfVec2 a = wfV2(12, 12), b = wfV2(24, 24);
    (void)in;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int column = i % SIDE, row = i / SIDE;
        wfReal step = WF_EPSILON / 2, half = WF_R(0.5);
        wfVec2 c = wfV2(half + step * (wfReal)column, half + step * (wfReal)row);
        wfReal rounded = wfCross(wfSub(b, a), wfSub(c, a));
        float x = 0.3f + 0.16f * (float)column, y = 0.4f + 0.16f * (float)row;
        wfDrawPoint(d, x, y, 6, role[(rounded > 0) - (rounded < 0) + 1]);
        wfDrawPoint(d, x + 3.8f, y, 6, role[wfOrientation(a, b, c) + 1]);
    }
    wfDrawText(d, 1.8f, 0.05f, 13, WF_INK_TEXT, 0, "rounded");
    wfDrawText(d, 5.6f, 0.05f, 13, WF_INK_TEXT, 0, "exact");
}
/* <figures> */
static const float COMPOUND_PIKE[22] = { 0, 0.2f, 0.9f, 0, 1.3f, 0.6f,
    2.1f, 0.1f, 2.6f, 0.9f, 2.2f, 1.6f, 2.5f, 2.4f, 1.4f, 2,
    1, 2.6f, 0.2f, 2.2f, 0.7f, 1.2f };

static void figure_compound_ears(wfDraw *d, const wfFigureInput *in)
{
    static const int cuts[4] = { 1, 3, 6, 9 };
    CompoundFigure f;
    (void)in;
    for (int panel = 0; panel < 4; panel++) {
        wfReal x = WF_R(0.2) + 3 * (wfReal)panel;
        compoundOpen(&f, COMPOUND_PIKE, 11, wfV2(x, WF_R(0.3)));
        if (wfCutEars(f.corners, f.n, &f.pool, &f.mesh) != WF_OK) return;
        compoundMesh(d, &f, 3 * cuts[panel]);
        for (int k = 0; k < cuts[panel]; k++) {
            wfVec2 middle = wfV2(0, 0);
            for (int i = 3 * k; i < 3 * k + 3; i++)
                middle = wfAddScaled(middle, WF_R(0.33333333333333),
                                     f.mesh.corners[f.mesh.edges[i].from]);
            wfDrawTextf(d, (float)middle.x, (float)middle.y - 0.06f, 11, WF_INK_TEXT, 0,
                        "%d", k + 1);
        }
    }
}
/* <figures> */
static void figure_compound_merge(wfDraw *d, const wfFigureInput *in)
{
    static const float fish[24] = { 0, 0.4f, 1.1f, 0.3f, 2, 0,
        3.1f, 0.5f, 3.6f, 0.1f, 3.5f, 2, 3, 1.3f, 2.2f, 2,
        1.3f, 1.5f, 0.9f, 2.2f, 0.3f, 1.9f, 0.6f, 1.1f };
    CompoundFigure f;
    wfVec2 moved = wfSub(figure_handle_at(in, 0), wfV2(WF_R(0.2), WF_R(0.5)));
    for (int panel = 0; panel < 3; panel++) {
        wfVec2 at = wfV2(WF_R(0.2) + 4 * (wfReal)panel, WF_R(0.5));
        compoundOpen(&f, fish, 12, at);
        f.corners[6] = wfAdd(at, moved);
        if (wfCutEars(f.corners, f.n, &f.pool, &f.mesh) != WF_OK) return;
        int32_t pieces = f.n - 2;
        if (panel > 0) wfFlipMesh(&f.mesh);
        if (panel > 1) pieces = wfMergeMesh(&f.mesh);
        compoundMesh(d, &f, f.mesh.edgeCount);
        wfDrawTextf(d, (float)at.x + 1.8f, 0.1f, 13, WF_INK_TEXT, 0, "%d pieces",
                    (int)pieces);
    }
}
/* <figures> */
static int compoundWheel(float *xy, int teeth, int perTooth, const float *radius)
{
    int n = teeth * perTooth;
    for (int i = 0; i < n; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / (wfReal)n + WF_PI / 2);
        xy[2 * i] = radius[i % perTooth] * (float)q.c;
        xy[2 * i + 1] = radius[i % perTooth] * (float)q.s;
    }
    return n;
}
/* <figures> */
static void figure_compound_gallery(wfDraw *d, const wfFigureInput *in)
{
    static const float W[26] = { -1, 1, -0.6f, -1, -0.25f, -1, 0, 0.1f,
        0.25f, -1, 0.6f, -1, 1, 1, 0.65f, 1, 0.4f, -0.3f,
        0.18f, 0.7f, -0.18f, 0.7f, -0.4f, -0.3f, -0.65f, 1 };
    static const float star[2] = { 1, 0.4f }, gear[4] = { 1, 1, 0.72f, 0.72f };
    CompoundFigure f;
    float wheel[2 * COMPOUND_MOST];
    wfRandom r;
    (void)in;
    compoundOpen(&f, wheel, compoundWheel(wheel, 5, 2, star), wfV2(WF_R(1.3), WF_R(1.3)));
    compoundShapes(d, &f);
    compoundOpen(&f, wheel, compoundWheel(wheel, 9, 4, gear), wfV2(4, WF_R(1.3)));
    compoundShapes(d, &f);
    compoundOpen(&f, W, 13, wfV2(WF_R(6.7), WF_R(1.3)));
    compoundShapes(d, &f);
    /* <draw a tangle of thirty corners> */
    wfRandomSeed(&r, 4);
    f.n = 30;
    random_tangle(&r, f.n, f.corners);
    for (int i = 0; i < f.n; i++)
        f.corners[i] = wfAdd(wfV2(WF_R(9.4), WF_R(1.3)), f.corners[i]);
    compoundShapes(d, &f);
}
/* <figures> */
static void compoundChain(wfDraw *d, const wfVec2 *p, int n, bool loop)
{
    wfShape links[COMPOUND_MOST];
    int count;
    if (wfMakeChain(p, n, loop, links, COMPOUND_MOST, &count) != WF_OK) return;
    for (int i = 0; i < count; i++) {
        const wfShape *s = &links[i];
        wfVec2 tick = wfAddScaled(s->centre, WF_R(0.18), s->normals[0]);
        wfDrawLine(d, WF_XY(s->vertices[0]), WF_XY(s->vertices[1]), 2.5f, WF_INK_LINE);
        wfDrawLine(d, WF_XY(s->centre), WF_XY(tick), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(s->vertices[0]), 6, WF_INK_LINE);
        wfDrawPoint(d, WF_XY(s->vertices[1]), 6, WF_INK_LINE);
    }
    if (loop) return;
    const wfShape *last = &links[count - 1];
    wfDrawDashed(d, WF_XY(p[0]), WF_XY(links[0].vertices[2]), 1.5f, WF_INK_FAINT);
    wfDrawDashed(d, WF_XY(p[n - 1]), WF_XY(last->vertices[3]), 1.5f, WF_INK_FAINT);
}
/* <figures> */
static void figure_compound_chain(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 ground[7] = { wfV2(WF_R(7.2), 1), wfV2(WF_R(6.2), WF_R(0.8)),
        wfV2(WF_R(5.2), WF_R(1.3)), wfV2(4, WF_R(0.7)), wfV2(3, WF_R(0.7)),
        wfV2(2, WF_R(1.2)), wfV2(WF_R(0.9), 1) };
    wfVec2 island[6];
    ground[2] = figure_handle_at(in, 0);
    for (int i = 0; i < 6; i++) {
        wfRot q = wfRotation(WF_PI * (wfReal)i / 3);
        island[i] = wfV2(4 + q.c * (i % 2 ? 1 : WF_R(0.8)), WF_R(2.8) + WF_R(0.7) * q.s);
    }
    compoundChain(d, ground, 7, false);
    compoundChain(d, island, 6, true);
}
/* <figures> */
static void figure_impact_tunnel(wfDraw *d, const wfFigureInput *in)
{
    wfShape wall, ball;
    wfVec2 step = wfV2(WF_R(20.0) / 60 * 5, 0);
    (void)in;
    if (wfMakeBox(WF_R(0.1), WF_R(0.6), &wall) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.25), &ball) != WF_OK) return;
    for (int row = 0; row < 2; row++) {
        wfReal y = row == 0 ? WF_R(2.2) : WF_R(0.8);
        wfSweep still = wfSweepStill(wfV2(WF_R(4.75), y), 0);
        wfVec2 p = wfV2(WF_R(0.6), y);
        narrowShape(d, &wall, wfSweepAt(still, 0), WF_INK_LINE, WF_INK_LINE);
        for (int i = 0; i < 5; i++) {
            wfSweep flight = { .from = p, .to = wfAdd(p, step) };
            wfImpact hit = { .t = 1 };
            if (row == 1) wfTimeOfImpact(&wall, still, &ball, flight, &hit);
            int role = row == 1 && p.x > 4 ? WF_INK_GOOD
                     : row == 0 && p.x > 5 ? WF_INK_BAD : WF_INK_BODY;
            narrowShape(d, &ball, wfSweepAt(flight, 0), role, role);
            if (hit.t <= 0 || (row == 1 && p.x > 4)) break;
            p = wfSweepAt(flight, hit.t).p;
        }
    }
}
/* <figures> */
/* a body at several moments of its sweep, the later the fainter */
static void impactGhosts(wfDraw *d, const wfShape *s, wfSweep sweep, int count, int role)
{
    for (int i = 0; i <= count; i++) {
        wfReal t = (wfReal)i / (wfReal)count;
        narrowShape(d, s, wfSweepAt(sweep, t), role, WF_INK_NONE);
    }
}
/* <figures> */
static void figure_impact_rod(wfDraw *d, const wfFigureInput *in)
{
    wfShape rod, peg;
    wfImpact hit;
    wfVec2 middle = wfV2(WF_R(2.6), WF_R(2.3));
    if (wfMakeBox(2, WF_R(0.12), &rod) != WF_OK) return;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.2), &peg) != WF_OK) return;
    wfSweep turn = { middle, middle, WF_R(0.15), WF_R(0.15) + WF_PI };
    wfSweep still = wfSweepStill(narrowHandle(in, 0), 0);
    impactGhosts(d, &rod, turn, 10, WF_INK_FAINT);
    narrowShape(d, &rod, wfSweepAt(turn, 0), WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, &peg, wfSweepAt(still, 0), WF_INK_BODY2, WF_INK_BODY2);
    wfDrawPoint(d, WF_XY(middle), 7, WF_INK_LINE);
    if (wfTimeOfImpact(&rod, turn, &peg, still, &hit) != WF_OK) return;
    if (hit.kind == WF_IMPACT_TOUCH)
        narrowShape(d, &rod, wfSweepAt(turn, hit.t), WF_INK_ACCENT, WF_INK_NONE);
    wfDrawTextf(d, 4.9f, 0.5f, 14, WF_INK_TEXT, -1, "t = %.3f", (double)hit.t);
    wfDrawTextf(d, 4.9f, 0.15f, 14, WF_INK_TEXT, -1, "steps: %d", (int)hit.steps);
}
/* <figures> */
static bool impactFlight(wfVec2 to, wfShape *ground, wfShape *box, wfSweep *still,
                         wfSweep *flight)
{
    *still = wfSweepStill(wfV2(4, WF_R(0.4)), 0);
    *flight = (wfSweep){ wfV2(WF_R(1.2), WF_R(4.1)), to, WF_R(0.8), WF_R(3.3) };
    return wfMakeBox(WF_R(3.8), WF_R(0.4), ground) == WF_OK
        && wfMakeBox(WF_R(0.7), WF_R(0.7), box) == WF_OK;
}
/* <figures> */
static void figure_impact_steps(wfDraw *d, const wfFigureInput *in)
{
    wfShape ground, box;
    wfSweep still, flight;
    wfImpact hit;
    wfImpactTrace t;
    if (!impactFlight(narrowHandle(in, 0), &ground, &box, &still, &flight)) return;
    if (wfTraceImpact(&ground, still, &box, flight, WF_ADVANCE_ALONG, &hit, &t) != WF_OK)
        return;
    narrowShape(d, &ground, wfSweepAt(still, 0), WF_INK_LINE, WF_INK_FAINT);
    wfDrawDashed(d, WF_XY(flight.from), WF_XY(flight.to), 1, WF_INK_FAINT);
    narrowShape(d, &box, wfSweepAt(flight, 1), WF_INK_FAINT, WF_INK_NONE);
    for (int k = 0; k < t.count; k++) {
        wfTransform xb = wfSweepAt(flight, t.steps[k].t);
        bool last = k + 1 == t.count;
        narrowShape(d, &box, xb, last ? WF_INK_ACCENT : WF_INK_BODY,
                    k == 0 ? WF_INK_BODY : WF_INK_NONE);
        if (k < 4) wfDrawTextf(d, WF_XY(xb.p), 14, WF_INK_TEXT, 0, "%d", k + 1);
    }
    wfDrawTextf(d, 7.9f, 4.2f, 14, WF_INK_TEXT, 1, "steps: %d", (int)hit.steps);
}
/* <figures> */
/* a graph in the rectangle from `at`, 8 wide: t from 0 to 1, gap from 0 to `most` */
typedef struct ImpactGraph { float x, y, high, most; } ImpactGraph;

static float graphX(const ImpactGraph *g, wfReal t) { return g->x + 8 * (float)t; }
static float graphY(const ImpactGraph *g, wfReal v)
{
    return g->y + g->high * (float)v / g->most;
}

static void impactCurve(wfDraw *d, const ImpactGraph *g, const wfShape *a, wfSweep sa,
                        const wfShape *b, wfSweep sb)
{
    float xy[2 * 161];
    int n = 0;
    wfDistanceResult r;
    for (int i = 0; i <= 160; i++) {
        wfReal t = (wfReal)i / 160;
        if (wfShapeDistance(a, wfSweepAt(sa, t), b, wfSweepAt(sb, t), &r) != WF_OK) return;
        if (r.distance <= 0) break;
        xy[n++] = graphX(g, t);
        xy[n++] = graphY(g, r.distance);
    }
    wfDrawPolyline(d, xy, n / 2, 2, WF_INK_BODY);
}
/* <figures> */
static void impactSawtooth(wfDraw *d, const ImpactGraph *g, const wfImpactTrace *t,
                           wfReal goal)
{
    for (int k = 0; k < t->count; k++) {
        const wfImpactStep *s = &t->steps[k];
        float x = graphX(g, s->t), y = graphY(g, s->distance);
        wfDrawPoint(d, x, y, 6, WF_INK_ACCENT);
        if (k + 1 == t->count) break;
        float next = graphX(g, t->steps[k + 1].t), foot = graphY(g, goal);
        wfDrawLine(d, x, y, next, foot, 1.5f, WF_INK_ACCENT);
        wfDrawDashed(d, next, foot, next, graphY(g, t->steps[k + 1].distance), 1,
                     WF_INK_FAINT);
    }
}
/* <figures> */
static void figure_impact_graph(wfDraw *d, const wfFigureInput *in)
{
    wfShape ground, box;
    wfSweep still, flight;
    wfImpact hit;
    wfImpactTrace t;
    (void)in;
    if (!impactFlight(wfV2(WF_R(6.2), WF_R(1.3)), &ground, &box, &still, &flight)) return;
    for (int row = 0; row < 2; row++) {
        ImpactGraph g = { 0.9f, row == 0 ? 3.6f : 0.6f, 2.4f, 2.8f };
        int how = row == 0 ? WF_ADVANCE_PLAIN : WF_ADVANCE_CURVE;
        if (wfTraceImpact(&ground, still, &box, flight, how, &hit, &t) != WF_OK) return;
        wfDrawArrow(d, g.x, g.y, g.x + 8.3f, g.y, 1, WF_INK_LINE);
        wfDrawArrow(d, g.x, g.y, g.x, g.y + 2.6f, 1, WF_INK_LINE);
        wfDrawText(d, g.x + 8.25f, g.y - 0.35f, 14, WF_INK_TEXT, 1, "time t");
        wfDrawText(d, g.x + 0.15f, g.y + 2.4f, 14, WF_INK_TEXT, -1, "gap");
        impactCurve(d, &g, &ground, still, &box, flight);
        impactSawtooth(d, &g, &t, hit.near / 2);
        wfDrawTextf(d, g.x + 8.2f, g.y + 2.1f, 14, WF_INK_TEXT, 1, "steps: %d", t.count);
    }
}
/* <figures> */
static void figure_impact_bound(wfDraw *d, const wfFigureInput *in)
{
    wfShape box;
    wfVec2 n = wfV2(0, -1), centre = wfV2(2, WF_R(2.6));
    (void)in;
    if (wfMakeBox(WF_R(1.3), WF_R(0.7), &box) != WF_OK) return;
    wfTransform xb = wfMakeTransform(centre, WF_R(0.45));
    narrowShape(d, &box, xb, WF_INK_BODY, WF_INK_BODY);
    for (int i = 0; i < box.count; i++) {
        wfVec2 corner = wfApply(xb, box.vertices[i]), arm = wfSub(corner, centre);
        wfVec2 speed = wfScale(WF_R(0.6), wfPerpCW(arm));
        wfReal part = wfDot(speed, n);
        wfVec2 tip = wfAdd(corner, speed), along = wfAddScaled(corner, part, n);
        narrowSegment(d, centre, corner, 1, WF_INK_FAINT);
        wfDrawArrow(d, WF_XY(corner), WF_XY(tip), 1.5f, WF_INK_LINE);
        wfDrawArrow(d, WF_XY(corner), WF_XY(along), 2.5f,
                    part > 0 ? WF_INK_BAD : WF_INK_GOOD);
    }
    wfDrawPoint(d, WF_XY(centre), 7, WF_INK_LINE);
    wfDrawArrow(d, 3.9f, 1.3f, 3.9f, 0.5f, 2.5f, WF_INK_ACCENT);
    wfDrawText(d, 4.05f, 0.75f, 15, WF_INK_TEXT, -1, "n");
    /* <draw the disc and its shadow> */
    wfTransform xd = wfMakeTransform(wfV2(WF_R(6.6), WF_R(2.6)), WF_R(0.45));
    wfReal extent = wfShapeExtent(&box), h = 0;
    for (int i = 0; i < box.count; i++)
        h = wfMaxR(h, wfDot(n, wfRotate(xd.q, box.vertices[i])));
    wfDrawCircle(d, WF_XY(xd.p), (float)extent, 1, WF_INK_FAINT, WF_INK_NONE);
    narrowShape(d, &box, xd, WF_INK_BODY, WF_INK_BODY);
    wfDrawPoint(d, WF_XY(xd.p), 7, WF_INK_LINE);
    float x = 8.7f, y = (float)xd.p.y;
    wfDrawDashed(d, 5.0f, y - (float)h, x + 0.3f, y - (float)h, 1, WF_INK_FAINT);
    wfDrawDashed(d, 5.0f, y - (float)extent, x + 0.3f, y - (float)extent, 1, WF_INK_FAINT);
    wfDrawDashed(d, (float)xd.p.x, y, x + 0.3f, y, 1, WF_INK_FAINT);
    wfDrawArrow(d, x, y, x, y - (float)h, 2, WF_INK_BODY);
    wfDrawArrow(d, x, y - (float)h, x, y - (float)extent, 2, WF_INK_BAD);
    wfDrawText(d, x + 0.15f, y - 0.6f * (float)h, 14, WF_INK_TEXT, -1, "h");
    wfDrawText(d, x + 0.15f, y - 0.5f * (float)(h + extent) - 0.05f, 14, WF_INK_TEXT, -1,
               "e - h");
}
/* <figures> */
static const double impactParabolas[3][2] = { { 0.667, -0.5 }, { 1.107, 0.6 },
                                              { 2.787, 2.0 } };

static double impactParabola(int i, double s)
{
    return impactParabolas[i][0] - impactParabolas[i][1] * s - 0.7 * s * s;
}

static int impactLowest(double s)
{
    int best = 0;
    for (int i = 1; i < 3; i++)
        if (impactParabola(i, s) < impactParabola(best, s)) best = i;
    return best;
}
/* <figures> */
static void impactParabolaLine(wfDraw *d, int i, int role, float width)
{
    float xy[2 * 81];
    int n = 0;
    for (int k = 0; k <= 80; k++) {
        double s = 1.6 * k / 80, v = impactParabola(i < 0 ? impactLowest(s) : i, s);
        if (v < -1.6) break;
        xy[n++] = (float)(0.7 + 4 * s);
        xy[n++] = (float)(1.6 + 0.8 * v);
    }
    wfDrawPolyline(d, xy, n / 2, width, role);
}
/* <figures> */
static void figure_impact_curve(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int i = 0; i < 3; i++) impactParabolaLine(d, i, WF_INK_BODY, 1.2f);
    impactParabolaLine(d, -1, WF_INK_LINE, 3);
    wfDrawArrow(d, 0.4f, 1.6f, 7.6f, 1.6f, 1, WF_INK_LINE);
    wfDrawText(d, 7.7f, 1.52f, 14, WF_INK_TEXT, -1, "s");
    double s = 1.6;
    for (int round = 0; round < 4; round++) {
        int i = impactLowest(s);
        double m = impactParabolas[i][1], c = impactParabolas[i][0];
        double root = 2 * c / (m + (double)wfSqrt((wfReal)(m * m + 2.8 * c)));
        if (m < 0) root = ((double)wfSqrt((wfReal)(m * m + 2.8 * c)) - m) / 1.4;
        float x = (float)(0.7 + 4 * s), to = (float)(0.7 + 4 * root);
        wfDrawPoint(d, x, 1.6f, 7, round == 0 ? WF_INK_LINE : WF_INK_ACCENT);
        if (root >= s) break;
        float y = 1.45f - 0.28f * (float)round;
        wfDrawArrow(d, x, y, to, y, 1.5f, WF_INK_ACCENT);
        s = root;
    }
}
/* <figures> */
/* a body, its inner copy, and where both are stopped */
static void impactStopped(wfDraw *d, const wfShape *body, const wfShape *inner,
                          wfSweep sweep, const wfObstacle *list, int count)
{
    wfStop stop;
    if (wfStopAtFirst(body, sweep, list, count, 1, &stop) != WF_OK) return;
    wfTransform first = wfSweepAt(sweep, 0), last = wfSweepAt(sweep, stop.t);
    int role = stop.obstacle == WF_NO_OBSTACLE ? WF_INK_GOOD : WF_INK_ACCENT;
    for (int i = 0; i < count; i++)
        narrowShape(d, list[i].shape, wfSweepAt(list[i].sweep, 0), WF_INK_LINE,
                    WF_INK_FAINT);
    narrowShape(d, body, first, WF_INK_BODY, WF_INK_NONE);
    narrowShape(d, inner, first, WF_INK_BODY, WF_INK_BODY);
    narrowShape(d, body, last, role, WF_INK_NONE);
    narrowShape(d, inner, last, role, role);
    wfDrawArrow(d, WF_XY(first.p), WF_XY(last.p), 1.5f, WF_INK_LINE);
}
/* <figures> */
static void figure_impact_core(wfDraw *d, const wfFigureInput *in)
{
    wfShape tile, crate, inner;
    (void)in;
    if (wfMakeBox(WF_R(1.5), WF_R(0.25), &tile) != WF_OK) return;
    if (wfMakeBox(WF_R(0.6), WF_R(0.6), &crate) != WF_OK) return;
    wfReal half = WF_R(0.6) * WF_IMPACT_INNER;
    if (wfMakeBox(half, half, &inner) != WF_OK) return;
    wfObstacle tiles[3] = {
        { &tile, wfSweepStill(wfV2(WF_R(1.6), WF_R(0.4)), 0) },
        { &tile, wfSweepStill(wfV2(WF_R(4.6), WF_R(0.4)), 0) },
        { &tile, wfSweepStill(wfV2(WF_R(8.2), WF_R(0.4)), 0) } };
    wfSweep slide = { .from = wfV2(WF_R(1.3), WF_R(1.24)),
                      .to = wfV2(WF_R(4.9), WF_R(1.24)) };
    wfSweep push = { .from = wfV2(WF_R(7.4), WF_R(1.2)), .to = wfV2(19, -WF_R(0.2)) };
    impactStopped(d, &crate, &inner, slide, tiles, 2);
    impactStopped(d, &crate, &inner, push, tiles + 2, 1);
}
/* <figures> */
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
/* <figures> */
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
    wfPlant(parent, ISLAND_DISCS);
    memset(moves, 1, sizeof moves);
    for (int a = 0; a < ISLAND_DISCS; a++)
        for (int b = a + 1; b < ISLAND_DISCS; b++)
            if (islands_touch(disc[a], disc[b])) wfUnite(parent, a, b);
    if (wfPoolInit(&pool, sizeof room - 16, base) != WF_OK) return;
    if (wfGatherIslands(parent, moves, ISLAND_DISCS, &pool, &islands) != WF_OK) return;
    /* <draw the discs of the islands> */
    wfDrawLine(d, 0, 0.3f, 18.2f, 0.3f, 2, WF_INK_LINE);
    for (int i = 0; i < ISLAND_DISCS; i++)
        wfDrawCircle(d, disc[i].x, disc[i].y, disc[i].r, 1.5f, WF_INK_LINE,
                     ink[islands.island[i] % 5]);
    for (int a = 0; a < ISLAND_DISCS; a++)
        for (int b = a + 1; b < ISLAND_DISCS; b++)
            if (islands_touch(disc[a], disc[b]))
                wfDrawLine(d, disc[a].x, disc[a].y, disc[b].x, disc[b].y, 1.5f, WF_INK_LINE);
}
/* <figures> */
enum { QUERY_SHAPES = 7 };
typedef struct QueryFigure {
    wfShape shapes[QUERY_SHAPES];
    wfTransform places[QUERY_SHAPES];
    wfRect bounds[QUERY_SHAPES];
    uint8_t flags[QUERY_SHAPES];
    wfShapeSet set;
} QueryFigure;

static wfTransform queryFigurePlace(const void *context, int32_t i)
{
    return ((const QueryFigure *)context)->places[i];
}
/* <figures> */
static void queryShape(wfDraw *d, const wfShape *s, wfTransform xf)
{
    wfVec2 rim[WF_RIM_POINTS];
    float xy[2 * WF_RIM_POINTS];
    int n = wfShapeOutline(s, xf, rim);
    for (int i = 0; i < n; i++) {
        xy[2 * i] = (float)rim[i].x;
        xy[2 * i + 1] = (float)rim[i].y;
    }
    if (n > 2) wfDrawPolygon(d, xy, n, 2, WF_INK_BODY, WF_INK_BODY);
    else if (n == 2) wfDrawLine(d, xy[0], xy[1], xy[2], xy[3], 3, WF_INK_BODY);
}
/* <figures> */
static void queryScene(QueryFigure *f)
{
    static const wfReal places[QUERY_SHAPES][3] = {
        { WF_R(2.1), WF_R(5.4), 0 }, { 6, WF_R(6.0), WF_R(0.5) }, { WF_R(10.3), 5, 1 },
        { WF_R(9.6), WF_R(2.1), WF_R(0.6) }, { WF_R(1.6), WF_R(1.9), WF_R(1.1) },
        { WF_R(4.3), WF_R(0.9), 0 }, { WF_R(4.3), WF_R(0.9), 0 }
    };
    wfVec2 five[5];
    for (int i = 0; i < 5; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / 5);
        five[i] = wfV2(WF_R(0.7) * q.c, WF_R(0.7) * q.s);
    }
    /* <one shape of each kind> */
    wfMakeCircle(wfV2(0, 0), WF_R(0.8), &f->shapes[0]);
    wfMakeBox(1, WF_R(0.45), &f->shapes[1]);
    wfMakeRoundedPolygon(five, 5, WF_R(0.35), &f->shapes[2]);
    wfMakeCapsule(wfV2(-WF_R(0.8), 0), wfV2(WF_R(0.8), 0), WF_R(0.4), &f->shapes[3]);
    wfMakeSegment(wfV2(-1, 0), wfV2(1, 0), &f->shapes[4]);
    /* <two links of a chain, one seen from behind> */
    wfVec2 chain[4] = { wfV2(4, WF_R(0.2)), wfV2(WF_R(2.7), WF_R(0.6)), wfV2(1, WF_R(0.2)),
                        wfV2(0, 1) };
    wfMakeLink(chain[0], chain[2], chain[1], chain[0], &f->shapes[5]);       /* turned round */
    wfMakeLink(chain[1], chain[2], chain[3], wfV2(-1, 1), &f->shapes[6]);
    f->set = (wfShapeSet){ .proxies = { .count = QUERY_SHAPES, .bounds = f->bounds,
                                        .flags = f->flags },
                           .shapes = f->shapes, .place = queryFigurePlace, .context = f };
    for (int i = 0; i < QUERY_SHAPES; i++) {
        f->places[i] = wfMakeTransform(wfV2(places[i][0], places[i][1]), places[i][2]);
        f->bounds[i] = wfShapeBounds(&f->shapes[i], f->places[i]);
        f->flags[i] = WF_PROXY_LIVE;
    }
}
/* <figures> */
static void figure_queries_fan(wfDraw *d, const wfFigureInput *in)
{
    enum { RAYS = 90 };
    QueryFigure f;
    wfVec2 from = narrowHandle(in, 0);
    queryScene(&f);
    for (int i = 0; i < RAYS; i++) {
        wfRot q = wfRotation(2 * WF_PI * (wfReal)i / RAYS);
        wfRay ray = { from, wfScale(20, wfV2(q.c, q.s)) };
        wfRayHit hit;
        if (wfSetCastRay(&f.set, ray, NULL, &hit) != WF_OK) return;
        bool free = hit.shape == WF_NO_SHAPE;
        wfVec2 end = wfAddScaled(from, free ? WF_R(0.6) : hit.fraction, ray.by);
        narrowSegment(d, from, end, 1, free ? WF_INK_FAINT : WF_INK_ACCENT);
        if (free) continue;
        narrowSegment(d, hit.point, wfAddScaled(hit.point, WF_R(0.25), hit.normal), 1.5f,
                      WF_INK_GOOD);
    }
    for (int i = 0; i < QUERY_SHAPES; i++) queryShape(d, &f.shapes[i], f.places[i]);
    wfDrawPoint(d, WF_XY(from), 8, WF_INK_LINE);
}
/* <figures> */
static void figure_queries_closest(wfDraw *d, const wfFigureInput *in)
{
    QueryFigure f;
    wfVec2 p = narrowHandle(in, 0);
    wfClosest best;
    queryScene(&f);
    if (wfSetClosest(&f.set, p, 100, NULL, &best) != WF_OK) return;
    for (int i = 0; i < QUERY_SHAPES; i++) {
        wfClosest c;
        queryShape(d, &f.shapes[i], f.places[i]);
        if (wfClosestPoint(&f.shapes[i], f.places[i], p, &c) != WF_OK) return;
        int role = i == best.shape ? WF_INK_GOOD : WF_INK_ACCENT;
        narrowSegment(d, p, c.point, i == best.shape ? 2.5f : 1.2f, role);
        wfDrawPoint(d, WF_XY(c.point), 7, role);
        wfVec2 label = wfLerp(c.point, p, WF_R(0.3));
        wfDrawTextf(d, (float)label.x + 0.1f, (float)label.y + 0.18f, 13, WF_INK_TEXT, -1,
                    "%.2f", (double)c.distance);
    }
    wfDrawLine(d, (float)p.x - 0.15f, (float)p.y, (float)p.x + 0.15f, (float)p.y, 2,
               WF_INK_LINE);
    wfDrawLine(d, (float)p.x, (float)p.y - 0.15f, (float)p.x, (float)p.y + 0.15f, 2,
               WF_INK_LINE);
}
/* <figures> */
static void figure_queries_disk(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 from = narrowHandle(in, 0), c = wfV2(6, WF_R(2.3));
    wfRay ray = { from, wfV2(8, WF_R(0.5)) };
    wfShape ball;
    wfRayHit hit;
    wfMakeCircle(wfV2(0, 0), WF_R(1.6), &ball);
    wfVec2 u = wfNormalize(ray.by), m = wfSub(c, from);
    wfVec2 near = wfAddScaled(from, wfDot(u, m), u);
    wfDrawCircle(d, WF_XY(c), 1.6f, 2, WF_INK_BODY, WF_INK_BODY);
    wfDrawArrow(d, WF_XY(from), WF_XY(wfAdd(from, ray.by)), 2, WF_INK_LINE);
    wfDrawDashed(d, WF_XY(near), WF_XY(c), 1.5f, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(from), 7, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(c), 6, WF_INK_LINE);
    wfDrawPoint(d, WF_XY(near), 7, WF_INK_LINE);
    wfVec2 half = wfLerp(from, near, WF_R(0.45)), side = wfLerp(near, c, WF_R(0.5));
    /* <name the lengths and points of the ray at a disk> */
    wfDrawText(d, (float)half.x, (float)half.y + 0.15f, 16, WF_INK_TEXT, 0, "s");
    wfDrawText(d, (float)side.x + 0.12f, (float)side.y - 0.1f, 16, WF_INK_TEXT, -1, "h");
    wfDrawText(d, (float)c.x + 0.1f, (float)c.y + 0.15f, 16, WF_INK_TEXT, -1, "c");
    wfDrawText(d, (float)from.x - 0.1f, (float)from.y - 0.35f, 16, WF_INK_TEXT, 0, "o");
    if (wfRayShape(&ball, (wfTransform){ c, wfRotIdentity() }, ray, &hit) != WF_OK) return;
    if (hit.shape == WF_NO_SHAPE) return;
    narrowSegment(d, hit.point, near, 4, WF_INK_ACCENT);
    narrowSegment(d, hit.point, c, 1.2f, WF_INK_FAINT);
    wfDrawPoint(d, WF_XY(hit.point), 8, WF_INK_ACCENT);
    wfDrawText(d, (float)c.x - 0.6f, (float)c.y - 0.35f, 16, WF_INK_TEXT, 0, "r");
}
/* <figures> */
static void figure_queries_corner(wfDraw *d, const wfFigureInput *in)
{
    static const wfReal rays[3][4] = { { WF_R(3.7), WF_R(5.2), WF_R(1.2), -WF_R(2.4) },
                                       { WF_R(4.2), WF_R(5.1), WF_R(2.2), -WF_R(2.2) },
                                       { WF_R(6.6), WF_R(2.4), -4, -WF_R(0.5) } };
    wfVec2 corners[3] = { wfV2(-2, WF_R(0.2)), wfV2(4, WF_R(0.2)), wfV2(4, 3) };
    wfShape s;
    wfTransform id = wfTransformIdentity();
    (void)in;
    if (wfMakeRoundedPolygon(corners, 3, 1, &s) != WF_OK) return;
    queryShape(d, &s, id);
    for (int i = 0; i < 3; i++) {
        int j = i < 2 ? i + 1 : 0;
        narrowSegment(d, s.vertices[i], s.vertices[j], 1, WF_INK_LINE);
        wfVec2 from = wfAdd(s.vertices[i], s.normals[i]);
        wfVec2 along = wfPerpCCW(s.normals[i]), to = wfAdd(s.vertices[j], s.normals[i]);
        from = wfAddScaled(from, -3, along);
        to = wfAddScaled(to, 3, along);
        wfDrawDashed(d, WF_XY(from), WF_XY(to), 1, WF_INK_FAINT);
    }
    for (int i = 0; i < 3; i++) {
        wfRay ray = { wfV2(rays[i][0], rays[i][1]), wfV2(rays[i][2], rays[i][3]) };
        /* <draw the ray and where it enters> */
        wfRayHit hit;
        if (wfRayShape(&s, id, ray, &hit) != WF_OK) return;
        wfVec2 end = wfAddScaled(ray.from, hit.fraction, ray.by);
        bool met = hit.shape != WF_NO_SHAPE;
        wfDrawArrow(d, WF_XY(ray.from), WF_XY(end), 2, met ? WF_INK_ACCENT : WF_INK_LINE);
        if (met) wfDrawArrow(d, WF_XY(hit.point), WF_XY(wfAdd(hit.point, hit.normal)), 1.5f,
                             WF_INK_GOOD);
    }
}
/* <figures> */
enum { TIMELINE_STEPS = 12, TIMELINE_ROWS = 4 };
static const wfPair timelinePairs[TIMELINE_ROWS] = {
    { 0, 1 }, { 1, 3 }, { 2, 4 }, { 3, 5 }
};
static const char *const timelineTouches[TIMELINE_ROWS] = {
    ".#####...##.", "...######...", "..###ooooo..", "......######"
};
/* <figures> */
/* the touches of a step; '#' and 'o' are two owners of the same index */
static int32_t timelineList(int step, wfTouch *out)
{
    int32_t n = 0;
    for (int row = 0; row < TIMELINE_ROWS; row++) {
        char c = timelineTouches[row][step];
        if (c == '.') continue;
        out[n++] = (wfTouch){ .a = timelinePairs[row].a, .b = timelinePairs[row].b,
                              .stampB = c == 'o' };
    }
    return n;
}

static float timelineY(const wfTouch *t)
{
    int row = 0;
    while (row < TIMELINE_ROWS - 1 && timelinePairs[row].a != t->a) row++;
    return 3.3f - 0.8f * (float)row;
}
/* <figures> */
/* draws the bars of the touches that stay, or the dots of those that begin and end */
static void timelineDraw(wfDraw *d, bool dots)
{
    wfTouch old[TIMELINE_ROWS], now[TIMELINE_ROWS], list[3][TIMELINE_ROWS];
    int32_t before = 0;
    for (int step = 0; step < TIMELINE_STEPS; step++) {
        float x = 1.6f + 0.8f * (float)step;
        int32_t n = timelineList(step, now);
        wfTouchEvents e = { { list[0], 0, TIMELINE_ROWS }, { list[1], 0, TIMELINE_ROWS },
                            { list[2], 0, TIMELINE_ROWS } };
        if (wfCompareTouches(old, before, now, n, &e) != WF_OK) return;
        /* <draw the events of the step> */
        for (int32_t i = 0; !dots && i < e.stay.count; i++)
            wfDrawLine(d, x - 0.8f, timelineY(&list[1][i]), x, timelineY(&list[1][i]), 5,
                       WF_INK_BODY);
        for (int32_t i = 0; dots && i < e.end.count; i++)
            wfDrawCircle(d, x - 0.35f, timelineY(&list[2][i]), 0.11f, 2, WF_INK_BAD, WF_INK_PAPER);
        for (int32_t i = 0; dots && i < e.begin.count; i++)
            wfDrawCircle(d, x, timelineY(&list[0][i]), 0.11f, 2, WF_INK_GOOD, WF_INK_GOOD);
        memcpy(old, now, sizeof old);
        before = n;
    }
}
/* <figures> */
static void figure_queries_timeline(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int step = 0; step < TIMELINE_STEPS; step++) {
        float x = 1.6f + 0.8f * (float)step;
        wfDrawDashed(d, x, 0.5f, x, 3.7f, 1, WF_INK_FAINT);
        wfDrawTextf(d, x, 0.1f, 13, WF_INK_TEXT, 0, "%d", step);
    }
    for (int row = 0; row < TIMELINE_ROWS; row++)
        wfDrawTextf(d, 0.2f, 3.22f - 0.8f * (float)row, 14, WF_INK_TEXT, -1, "%d and %d",
                    (int)timelinePairs[row].a, (int)timelinePairs[row].b);
    timelineDraw(d, false);
    timelineDraw(d, true);
}
/* <figures> */
static void figure_world_block(wfDraw *d, const wfFigureInput *in)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfRegion region[WF_REGION_COUNT];
    size_t size[2];
    (void)in;
    if (wfWorldRegions(&def, region) != WF_OK) return;
    if (wfWorldSize(&def, &size[0], &size[1]) != WF_OK) return;
    float scale = 5.2f / (float)(size[0] > size[1] ? size[0] : size[1]);
    float label[2] = { 9, 9 };
    for (int i = 0; i < WF_REGION_COUNT; i++) {
        const wfRegion *r = &region[i];
        /* <draw one array of the block> */
        float x = 0.2f + 5.6f * (float)r->chunk, bytes = (float)(r->count * r->each);
        float top = 5.5f - scale * (float)r->offset, bottom = top - scale * bytes;
        float box[8] = { x, bottom, x + 1, bottom, x + 1, top, x, top };
        float middle = (top + bottom) / 2 - 0.06f, limit = label[r->chunk] - 0.27f;
        wfDrawPolygon(d, box, 4, 1, WF_INK_LINE, r->chunk == 0 ? WF_INK_BODY : WF_INK_BODY2);
        if (top - bottom < 0.052f) continue;  /* less than a hundredth */
        label[r->chunk] = middle < limit ? middle : limit;
        wfDrawLine(d, x + 1, (top + bottom) / 2, x + 1.4f, label[r->chunk] + 0.06f, 0.7f,
                   WF_INK_FAINT);
        wfDrawTextf(d, x + 1.5f, label[r->chunk], 11, WF_INK_TEXT, -1, "%s: %zu x %zu bytes",
                    r->name, r->count, r->each);
    }
    for (int k = 0; k < 2; k++)
        wfDrawTextf(d, 0.2f + 5.6f * (float)k, 5.8f, 13, WF_INK_TEXT, -1, "%s, %zu kB",
                    k == 0 ? "permanent" : "transient", (size[k] + 512) / 1024);
}
/* <figures> */
static void figure_world_three(wfDraw *d, const wfFigureInput *in)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfRegion region[WF_REGION_COUNT];
    size_t size[2];
    (void)in;
    def.bodyCapacity = 3;
    def.forceCapacity = 1;
    if (wfWorldRegions(&def, region) != WF_OK) return;
    if (wfWorldSize(&def, &size[0], &size[1]) != WF_OK) return;
    const wfRegion *last = &region[WF_REGION_HITS];
    size_t all = last->offset + last->count * last->each;
    float scale = 5.5f / (float)all, y = 8.25f;
    for (int i = 0; i <= WF_REGION_HITS; i++, y -= 0.35f) {
        const wfRegion *r = &region[i];
        size_t next = i < WF_REGION_HITS ? region[i + 1].offset : all;
        /* <draw one array of the small block> */
        size_t used = r->count * r->each;
        float x0 = 2.1f + scale * (float)r->offset, x1 = x0 + scale * (float)used;
        float x2 = 2.1f + scale * (float)next;
        float box[8] = { x0, y, x1, y, x1, y + 0.24f, x0, y + 0.24f };
        float pad[8] = { x1, y, x2, y, x2, y + 0.24f, x1, y + 0.24f };
        wfDrawPolygon(d, box, 4, 1, WF_INK_LINE, WF_INK_BODY);
        if (next > r->offset + used) wfDrawPolygon(d, pad, 4, 1, WF_INK_LINE, WF_INK_ACCENT);
        wfDrawLine(d, x2, y, x2, y - 0.11f, 0.7f, WF_INK_FAINT);
        wfDrawText(d, 1.9f, y + 0.05f, 10, WF_INK_TEXT, 1, r->name);
        wfDrawTextf(d, 10.5f, y + 0.05f, 10, WF_INK_TEXT, 1, "at %zu: %zu x %zu", r->offset,
                    r->count, r->each);
    }
    wfDrawTextf(d, 10.5f, 0.06f, 12, WF_INK_TEXT, 1, "%zu bytes in all", all);
}
/* <figures> */
static void draw_places(wfDraw *d, const wfWorld *world, wfBodyId old, float y,
                        const char *text, const char *const name[3])
{
    wfDrawText(d, 0.1f, y + 0.35f, 12, WF_INK_TEXT, -1, text);
    for (int i = 0; i < 3; i++) {
        wfBodyId id = wfBodyAt(world, i);
        float x = 2.5f + 1.5f * (float)i;
        float box[8] = { x, y, x + 1.3f, y, x + 1.3f, y + 0.9f, x, y + 0.9f };
        wfDrawPolygon(d, box, 4, 1.2f, WF_INK_LINE,
                      id.index != 0 ? WF_INK_BODY : WF_INK_PAPER);
        wfDrawText(d, x + 0.65f, y + 0.52f, 13, WF_INK_TEXT, 0,
                   id.index != 0 ? name[i] : "free");
        if (id.index != 0)
            wfDrawTextf(d, x + 0.65f, y + 0.16f, 11, WF_INK_TEXT, 0, "id (%u, %u)",
                        (unsigned)id.index, (unsigned)id.generation);
    }
    bool valid = wfBodyIsValid(world, old);
    wfDrawTextf(d, 7.3f, y + 0.35f, 12, valid ? WF_INK_GOOD : WF_INK_BAD, -1,
                "(%u, %u): %s", (unsigned)old.index, (unsigned)old.generation,
                valid ? "valid" : "refused");
}
/* <figures> */
static void figure_world_ids(wfDraw *d, const wfFigureInput *in)
{
    const char *const before[3] = { "A", "B", "C" }, *const after[3] = { "A", "D", "C" };
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef particle = wfDefaultBodyDef();
    wfBodyId id[3];
    wfWorld world;
    (void)in;
    def.bodyCapacity = 3;
    particle.mass = 1;
    if (wfCreateWorld(&def, &world) != WF_OK) return;
    for (int i = 0; i < 3; i++) wfAddBodyToWorld(&world, &particle, &id[i]);
    draw_places(d, &world, id[1], 2.5f, "three added", before);
    wfRemoveBodyFromWorld(&world, id[1]);
    draw_places(d, &world, id[1], 1.3f, "B removed", before);
    wfAddBodyToWorld(&world, &particle, NULL);
    draw_places(d, &world, id[1], 0.1f, "D added", after);
    wfDestroyWorld(&world);
}
/* <figures> */
static void figure_world_stages(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -1.7f, 0, 15.7f, 12.3f);
    float pitch = 12.2f / (float)wfStageCount, high = 0.7f * pitch;
    for (int i = 0; i < wfStageCount; i++) {
        const wfStageRow *s = &wfStageTable[i];
        float y = pitch * (float)(wfStageCount - 1 - i) + 0.1f, mid = y + high / 2;
        float box[8] = { 5.6f, y, 8.4f, y, 8.4f, y + high, 5.6f, y + high };
        wfDrawPolygon(d, box, 4, 1.2f, WF_INK_LINE, WF_INK_BODY);
        wfDrawText(d, 7.0f, mid - 0.1f, 11, WF_INK_TEXT, 0, s->name);
        wfDrawText(d, 5.3f, mid - 0.1f, 11, WF_INK_TEXT, 1, s->reads);
        wfDrawArrow(d, 5.35f, mid, 5.58f, mid, 1, WF_INK_FAINT);
        wfDrawText(d, 8.75f, mid - 0.1f, 11, WF_INK_TEXT, -1, s->writes);
        if (s->writes[0] != 0) wfDrawArrow(d, 8.42f, mid, 8.7f, mid, 1, WF_INK_FAINT);
        if (i > 0)
            wfDrawArrow(d, 7.0f, y + pitch, 7.0f, y + high, 1.2f, WF_INK_ACCENT);
    }
}
/* <figures> */
static void fast_flight(wfDraw *d, wfReal angle, int rate, int impacts, int role)
{
    wfWorldDef wd = wfDefaultWorldDef();
    wfBodyDef b = wfDefaultBodyDef();
    wfBodyId id;
    wfBodyInfo now = { .position = { { WF_R(0.6), WF_R(0.5) } } };
    wfWorld w;
    wd.gravity = wfV2(0, 0);
    wd.dt = WF_R(1.0) / (wfReal)rate;
    wd.solver = wfFindSolver("sequential");
    wd.impacts = impacts;
    if (wfCreateWorld(&wd, &w) != WF_OK) return;
    b.type = WF_STATIC, b.friction = 0, b.restitution = 1;
    /* <build the room of the figure> */
    for (int i = 0; i < 4; i++) {
        b.position = i < 2 ? wfV2(i == 0 ? 0 : 6, WF_R(1.5)) : wfV2(3, i == 2 ? 0 : 3);
        wfMakeBox(i < 2 ? WF_R(0.01) : 3, i < 2 ? WF_R(1.5) : WF_R(0.01), &b.shape);
        wfAddBodyToWorld(&w, &b, NULL);
        if (rate == 60 && impacts > 0) forces_shape(d, &b.shape,
            wfMakeTransform(b.position, 0), WF_INK_LINE);
    }
    wfMakeCircle(wfV2(0, 0), WF_R(0.2), &b.shape);
    for (int i = 0; i < 4; i++) {
        b.position = wfV2(WF_R(1.8) + WF_R(2.2) * (wfReal)(i % 2), 1 + (wfReal)(i / 2));
        wfAddBodyToWorld(&w, &b, NULL);
        if (rate == 60 && impacts > 0) forces_shape(d, &b.shape,
            wfMakeTransform(b.position, 0), WF_INK_LINE);
    }
    wfRot q = wfRotation(angle);
    wfMakeCircle(wfV2(0, 0), WF_R(0.05), &b.shape);
    b.type = WF_DYNAMIC, b.position = now.position;
    b.velocity = wfV2(60 * q.c, 60 * q.s);
    wfAddBodyToWorld(&w, &b, &id);
    for (int i = 0; i < rate / 4; i++) {
        wfVec2 from = now.position;
        if (wfStepWorld(&w) != WF_OK || wfGetBody(&w, id, &now) != WF_OK) break;
        wfDrawLine(d, WF_XY(from), WF_XY(now.position), rate > 60 ? 1 : 1.6f, role);
        if (rate == 60) wfDrawPoint(d, WF_XY(now.position), 5, role);
    }
    wfDestroyWorld(&w);
}
/* <figures> */
static void figure_fast_legs(wfDraw *d, const wfFigureInput *in)
{
    wfReal x = (wfReal)in->handle[0][0] - WF_R(0.6);
    wfReal angle = wfAtan2((wfReal)in->handle[0][1] - WF_R(0.5), x);
    wfDrawView(d, -0.3f, -0.3f, 6.3f, 3.3f);
    fast_flight(d, angle, 60, 0, WF_INK_BAD);
    fast_flight(d, angle, 60, 16, WF_INK_GOOD);
    fast_flight(d, angle, 600, 16, WF_INK_TEXT);
}
/* <figures> */
static wfBodyId joined_box(wfWorld *w, double x, double y, double wide, double high,
                           int32_t type)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id = { 0, 0 };
    def.type = type;
    def.position = wfV2((wfReal)x, (wfReal)y);
    if (wfMakeBox((wfReal)wide, (wfReal)high, &def.shape) == WF_OK)
        wfAddBodyToWorld(w, &def, &id);
    return id;
}

static void joined_pin(wfWorld *w, wfBodyId a, wfBodyId b, double x, double y)
{
    wfVec2 at = wfV2((wfReal)x, (wfReal)y);
    wfJoint j;
    if (wfJoinBodies(w, "revolute", a, b, at, at, wfV2(1, 0), &j) == WF_OK)
        wfAddJointToWorld(w, &j, NULL);
}
/* <figures> */
static void joined_bridge(wfWorld *w)
{
    wfBodyId left = joined_box(w, -6, -1, 1, 1, WF_STATIC);
    wfBodyId right = joined_box(w, 6, -1, 1, 1, WF_STATIC), last = left;
    for (int i = 0; i < 10; i++) {
        wfBodyId plank = joined_box(w, -4.5 + i, -0.1, 0.48, 0.1, WF_DYNAMIC);
        joined_pin(w, last, plank, -5 + i, -0.1);
        last = plank;
    }
    joined_pin(w, last, right, 5, -0.1);
}
/* <figures> */
static void joined_cart(wfWorld *w)
{
    wfBodyId body = joined_box(w, -4, 0.75, 0.9, 0.25, WF_DYNAMIC), wheel;
    wfBodyDef def = wfDefaultBodyDef();
    wfMakeCircle(wfV2(0, 0), WF_R(0.35), &def.shape);
    for (int i = 0; i < 2; i++) {
        wfJoint j;
        def.position = wfV2(WF_R(-4.6) + WF_R(1.2) * (wfReal)i, WF_R(0.4));
        wfAddBodyToWorld(w, &def, &wheel);
        if (wfJoinBodies(w, "wheel", body, wheel, def.position, def.position, wfV2(0, 1),
                         &j) != WF_OK) continue;
        wfTuneJoint(&j, 1, 4, WF_R(0.7));
        j.flags |= WF_JOINT_MOTOR;
        j.motorSpeed = -4, j.motorForce = 10;
        wfAddJointToWorld(w, &j, NULL);
    }
}
/* <figures> */
static void joined_crane(wfWorld *w)
{
    wfBodyId tower = joined_box(w, 8.5, 1.5, 0.3, 3.5, WF_STATIC);
    wfBodyId beam = joined_box(w, 7.2, 4.6, 1.9, 0.15, WF_DYNAMIC);
    wfBodyId load = joined_box(w, 6.4, 2.2, 0.4, 0.4, WF_DYNAMIC);
    wfVec2 root = wfV2(WF_R(8.5), WF_R(4.6)), tip = wfV2(WF_R(5.5), WF_R(4.6));
    wfJoint j;
    if (wfJoinBodies(w, "weld", tower, beam, root, root, wfV2(1, 0), &j) == WF_OK)
        wfAddJointToWorld(w, &j, NULL);
    if (wfJoinBodies(w, "distance", beam, load, tip, wfV2(WF_R(6.4), WF_R(2.6)),
                     wfV2(1, 0), &j) != WF_OK) return;
    j.flags = WF_JOINT_LIMITS, j.upper = j.rest;
    wfAddJointToWorld(w, &j, NULL);
}
/* <figures> */
static void joined_draw(wfDraw *d, const wfWorld *w)
{
    wfBodyView all = wfWorldBodies(w);
    for (int32_t i = 0; i < all.count; i++) {
        wfShape shape;
        if (wfGetBodyShape(w, wfBodyAt(w, i), &shape) != WF_OK) continue;
        wfBodyInfo info;
        if (wfGetBody(w, wfBodyAt(w, i), &info) != WF_OK) continue;
        wfTransform at = wfMakeTransform(info.position, info.angle);
        forces_shape(d, &shape, at, info.type == WF_STATIC ? WF_INK_FAINT : WF_INK_BODY);
    }
    for (int32_t i = 0; i < wfWorldJointPlaces(w); i++) {
        wfJoint j;
        if (wfGetJoint(w, wfJointAt(w, i), &j) != WF_OK) continue;
        wfVec2 a = wfApply(wfBodyTransform(&all.state[j.a]), j.localA);
        wfVec2 b = wfApply(wfBodyTransform(&all.state[j.b]), j.localB);
        wfDrawLine(d, WF_XY(a), WF_XY(b), 1.5f, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(a), 4, WF_INK_ACCENT);
        wfDrawPoint(d, WF_XY(b), 4, WF_INK_ACCENT);
    }
}
/* <figures> */
static void figure_joined_machines(wfDraw *d, const wfFigureInput *in)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    (void)in;
    wfDrawView(d, -7.2f, -2.2f, 9.2f, 5.4f);
    def.solver = wfFindSolver("soft");
    if (wfCreateWorld(&def, &world) != WF_OK) return;
    joined_bridge(&world);
    joined_cart(&world);
    joined_crane(&world);
    for (int i = 0; i < 180; i++)
        if (wfStepWorld(&world) != WF_OK) break;
    joined_draw(d, &world);
    wfDestroyWorld(&world);
}
/* <figures> */
static void sleep_draw(wfDraw *d, const wfWorld *w, wfVec2 shift)
{
    static const int ink[4] = { WF_INK_BODY, WF_INK_BODY2, WF_INK_GOOD, WF_INK_BAD };
    wfBodyView all = wfWorldBodies(w);
    for (int32_t i = 0; i < all.count; i++) {
        wfBodyId id = wfBodyAt(w, i);
        wfBodyInfo info;
        wfShape shape;
        if (wfGetBody(w, id, &info) != WF_OK) continue;
        if (wfGetBodyShape(w, id, &shape) != WF_OK) continue;
        wfTransform at = wfMakeTransform(wfAdd(info.position, shift), info.angle);
        int32_t island = wfBodyIsland(w, id);
        bool awake = info.type == WF_DYNAMIC && wfIsAwake(w, id);
        forces_shape(d, &shape, at, awake ? ink[island < 0 ? 0 : island % 4]
                                          : WF_INK_FAINT);
    }
}
/* <figures> */
static void figure_sleep_stacks(wfDraw *d, const wfFigureInput *in)
{
    wfWorld w;
    (void)in;
    wfDrawView(d, -4.5f, -0.4f, 14.7f, 5.6f);
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    if (wfCreateWorld(&def, &w) != WF_OK) return;
    joined_box(&w, 0, -0.2, 4.4, 0.2, WF_STATIC);
    for (int i = 0; i < 15; i++)
        joined_box(&w, -2 + 2 * (i / 5), 0.5 + i % 5, 0.5, 0.5, WF_DYNAMIC);
    for (int i = 0; i < 1200; i++) wfStepWorld(&w);
    sleep_draw(d, &w, wfV2(0, 0));
    wfBodyDef ball = wfDefaultBodyDef();
    wfMakeCircle(wfV2(0, 0), WF_R(0.3), &ball.shape);
    ball.position = wfV2(-4, WF_R(3.2));
    ball.velocity = wfV2(8, 1);
    wfAddBodyToWorld(&w, &ball, NULL);
    for (int i = 0; i < 15; i++) wfStepWorld(&w);
    sleep_draw(d, &w, wfV2(WF_R(10.2), 0));
    wfDestroyWorld(&w);
}
/* <figures> */
static void figure_sleep_floating(wfDraw *d, const wfFigureInput *in)
{
    wfWorld w;
    wfBodyId id[4];
    (void)in;
    wfDrawView(d, -3.2f, -0.4f, 9.2f, 4.4f);
    wfWorldDef def = wfDefaultWorldDef();
    def.sleep = 1;
    if (wfCreateWorld(&def, &w) != WF_OK) return;
    joined_box(&w, 0, -0.2, 2.5, 0.2, WF_STATIC);
    for (int i = 0; i < 4; i++)
        id[i] = joined_box(&w, 0.2 * (i % 2), 0.5 + i, 0.5, 0.5, WF_DYNAMIC);
    for (int i = 0; i < 300; i++) wfStepWorld(&w);
    wfRemoveBodyFromWorld(&w, id[1]);
    sleep_draw(d, &w, wfV2(0, 0));
    for (int i = 0; i < 15; i++) wfStepWorld(&w);
    sleep_draw(d, &w, wfV2(6, 0));
    wfDestroyWorld(&w);
}
/* <figures> */
static bool save_pile(wfWorld *world)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef d = wfDefaultBodyDef();
    def.bodyCapacity = 400;
    d.type = WF_STATIC;
    d.position = wfV2(0, -1);
    if (wfMakeBox(30, 1, &d.shape) != WF_OK) return false;
    if (wfCreateWorld(&def, world) != WF_OK) return false;
    wfAddBodyToWorld(world, &d, NULL);
    d.type = WF_DYNAMIC;
    wfMakeBox(WF_R(0.5), WF_R(0.5), &d.shape);
    for (int i = 0; i < 200; i++) {
        d.position = wfV2((wfReal)(i % 20 - 10) * WF_R(1.1), WF_R(0.5) + (wfReal)(i / 20));
        wfAddBodyToWorld(world, &d, NULL);
    }
    for (int i = 0; i < 60; i++) wfStepWorld(world);
    return true;
}
/* <figures> */
static void figure_save_used(wfDraw *d, const wfFigureInput *in)
{
    wfWorld world;
    wfBlock b;
    wfImage image;
    (void)in;
    if (!save_pile(&world) || wfOpenBlock(&world, &b) != WF_OK) return;
    float y = 4.9f;
    size_t all = 0, counts = 0;
    bool good = wfImageOfBlock(&b, &image) == WF_OK;
    for (int i = 0; i < WF_REGION_KEPT && good; i++) {
        uint64_t end = i + 1 < WF_REGION_KEPT ? b.head->offset[i + 1] : b.head->bytes;
        size_t room = (size_t)(end - b.head->offset[i]);
        all += room, counts += image.bytes[i];
        if (room < 20000) continue;
        /* <draw a region and what of it counts> */
        float full = 6.2e-6f * (float)room, part = 6.2e-6f * (float)image.bytes[i];
        figure_bar(d, 2.2f, y, full, 0.34f, WF_INK_NONE);
        if (part > 0) figure_bar(d, 2.2f, y, part, 0.34f, WF_INK_BODY);
        wfDrawText(d, 2.05f, y + 0.1f, 12, WF_INK_TEXT, 1, wfRegionTable[i].name);
        wfDrawTextf(d, 2.35f + full, y + 0.1f, 11, WF_INK_TEXT, -1, "%d of %d kB",
                    (int)(image.bytes[i] / 1000), (int)(room / 1000));
        y -= 0.47f;
    }
    wfDrawTextf(d, 9.8f, 0.15f, 13, WF_INK_TEXT, 1, "all: %d of %d kB",
                (int)(counts / 1000), (int)(all / 1000));
    wfDestroyWorld(&world);
}
/* <figures> */
static void figure_save_ring(wfDraw *d, const wfFigureInput *in)
{
    static _Alignas(16) uint8_t bytes[72000];
    enum { LAST = 15 };
    wfRewind ring;
    wfWorld world;
    uint64_t oldest, newest;
    (void)in;
    wfWorldDef def = wfDefaultWorldDef();
    if (wfCreateWorld(&def, &world) != WF_OK) return;
    wfRewindInit(&ring, bytes, sizeof bytes);
    figure_bar(d, 0.3f, 1.2f, 9.4f, 0.8f, WF_INK_NONE);
    /* <let a world grow and keep it at each step> */
    for (int i = 0; i <= LAST; i++) {
        wfBodyDef ball = wfDefaultBodyDef();
        wfMakeCircle(wfV2(0, 0), 1, &ball.shape);
        ball.position = wfV2((wfReal)(5 * i), 0);
        wfAddBodyToWorld(&world, &ball, NULL);
        wfRewindKeep(&ring, &world);
        wfStepWorld(&world);
    }
    wfRewind walk = ring;
    while (wfRewindReach(&walk, &oldest, &newest) == WF_OK) {
        /* <draw the newest snapshot of the ring and go one back> */
        float scale = 9.4f / (float)sizeof bytes, x = 0.3f + scale * (float)walk.newest;
        size_t size;
        bool first = newest == LAST, last = oldest == newest;
        if (wfRewindTo(&walk, &world, newest) != WF_OK) break;
        size = wfSnapshotSize(&world);
        figure_bar(d, x, 1.2f, scale * (float)size, 0.8f, first ? WF_INK_ACCENT : WF_INK_BODY);
        wfDrawTextf(d, x + scale * (float)size / 2, 1.52f, 12, WF_INK_TEXT, 0, "%d", (int)newest);
        if (first) wfDrawText(d, x, 0.75f, 12, WF_INK_TEXT, -1, "newest");
        if (last) wfDrawText(d, x, 2.25f, 12, WF_INK_TEXT, -1, "oldest");
        if (last || newest == 0 || wfRewindTo(&walk, &world, newest - 1) != WF_OK) break;
    }
    wfDestroyWorld(&world);
}
/* <figures> */
enum { JOURNAL_BALL, JOURNAL_STEPS, JOURNAL_KICK, JOURNAL_TURN };

/* Does one thing to a world, `number` times if it is a step. */
static wfResult journal_do(wfWorld *world, wfJournal *j, int what, int number)
{
    wfBodyId ship = wfBodyAt(world, 0);
    wfInput in = { .kind = WF_INPUT_ADD_BODY, .index = ship.index,
                   .generation = ship.generation };
    wfResult result = WF_OK;
    if (what == JOURNAL_BALL) in.body = wfDefaultBodyDef();
    if (what == JOURNAL_BALL) result = wfMakeCircle(wfV2(0, 0), 1, &in.body.shape);
    if (what == JOURNAL_BALL) in.body.position = wfV2((wfReal)(3 * number), 0);
    if (what == JOURNAL_KICK) in.kind = WF_INPUT_IMPULSE, in.with.by = wfV2(1, 0);
    if (what == JOURNAL_TURN) in.kind = WF_INPUT_GRAVITY, in.with.by = wfV2(0, 10);
    if (result == WF_OK && what != JOURNAL_STEPS) return wfGiveInput(world, j, &in, NULL);
    for (int i = 0; i < number && result == WF_OK; i++)
        result = wfStepNoted(world, j, NULL);
    return result;
}
/* <figures> */
static void figure_save_journal(wfDraw *d, const wfFigureInput *in)
{
    static _Alignas(16) uint8_t bytes[4096];
    /* <what the player of the figure does> */
    static const struct { const char *name; int what, number, ink; } row[] = {
        { "a ball", JOURNAL_BALL, 0, WF_INK_BODY },
        { "another ball", JOURNAL_BALL, 1, WF_INK_BODY },
        { "20 steps", JOURNAL_STEPS, 20, WF_INK_NONE },
        { "kick", JOURNAL_KICK, 0, WF_INK_ACCENT },
        { "30 steps", JOURNAL_STEPS, 30, WF_INK_NONE },
        { "gravity", JOURNAL_TURN, 0, WF_INK_BODY2 },
        { "10 steps", JOURNAL_STEPS, 10, WF_INK_NONE } };
    enum { ROWS = sizeof row / sizeof *row };
    size_t end[ROWS + 1] = { 0 };
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfJournal j;
    (void)in;
    wfJournalInit(&j, bytes, sizeof bytes, 0);
    if (wfCreateWorld(&def, &world) != WF_OK) return;
    for (int i = 0; i < ROWS; i++) {
        if (journal_do(&world, &j, row[i].what, row[i].number) != WF_OK) break;
        end[i + 1] = j.used;
    }
    /* <draw the entries of the journal> */
    float scale = 5.4f / (float)end[1];
    for (int i = 0; i < ROWS; i++) {
        float y = 3.5f - 0.5f * (float)i, w = scale * (float)(end[i + 1] - end[i]);
        figure_bar(d, 2.4f, y, w, 0.36f, row[i].ink);
        wfDrawText(d, 2.2f, y + 0.1f, 13, WF_INK_TEXT, 1, row[i].name);
        wfDrawTextf(d, 2.55f + w, y + 0.1f, 13, WF_INK_TEXT, -1, "%d bytes",
                    (int)(end[i + 1] - end[i]));
    }
    wfDrawTextf(d, 9.8f, 0.5f, 13, WF_INK_TEXT, 1, "all: %d bytes", (int)j.used);
    wfDestroyWorld(&world);
}
/* <figures> */
static float ruler_x(double value) { return 0.4f + 9.2f * (float)((value - 1000) / 6e-4); }

static void ruler_ticks(wfDraw *d, double step, float y, float length)
{
    wfDrawLine(d, 0.3f, y, 9.7f, y, 1, WF_INK_LINE);
    for (int i = 0; i * step <= 6.001e-4; i++) {
        float x = ruler_x(1000 + i * step);
        wfDrawLine(d, x, y - length / 2, x, y + length / 2, 1.2f, WF_INK_LINE);
    }
}
/* <figures> */
/* The nearest decimal: so many units above 1000. */
static int decimal(double x, double unit) { return (int)((x - 1000) / unit + 0.5); }

static void figure_save_digits(wfDraw *d, const wfFigureInput *in)
{
    float float1000 = 1000, step = 1.0f / 16384;        /* 2^(9 - 23): floats near 1000 */
    (void)in;
    ruler_ticks(d, 1e-4, 2.9f, 0.24f);
    ruler_ticks(d, (double)step, 1.7f, 0.3f);
    ruler_ticks(d, 1e-5, 0.5f, 0.14f);
    for (int i = 0; i < 10; i++) {
        double x = (double)(float1000 + (float)i * step);
        /* <join a float to its two decimals> */
        int eight = decimal(x, 1e-4), nine = decimal(x, 1e-5);
        bool shared = decimal(x - (double)step, 1e-4) == eight ||
                      decimal(x + (double)step, 1e-4) == eight;
        float width = shared ? 2.0f : 1.2f;
        int ink = shared ? WF_INK_BAD : WF_INK_BODY;
        wfDrawLine(d, ruler_x(x), 1.7f, ruler_x(1000 + eight * 1e-4), 2.9f, width, ink);
        wfDrawLine(d, ruler_x(x), 1.7f, ruler_x(1000 + nine * 1e-5), 0.5f, 1.2f, WF_INK_GOOD);
        wfDrawPoint(d, ruler_x(x), 1.7f, 5, WF_INK_LINE);
    }
    wfDrawText(d, 0.3f, 3.2f, 12, WF_INK_TEXT, -1, "8 digits: 0.0001 apart");
    wfDrawText(d, 9.7f, 1.95f, 12, WF_INK_TEXT, 1, "floats: 0.000061 apart");
    wfDrawText(d, 0.3f, 0.1f, 12, WF_INK_TEXT, -1, "9 digits: 0.00001 apart");
}
/* <figures> */
static void platform_box(wfDraw *d, float x, float y, float w, float h, int fill,
                         const char *name)
{
    float xy[] = { x, y, x + w, y, x + w, y + h, x, y + h };
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, fill);
    wfDrawText(d, x + w / 2, y + h / 2 - 0.1f, 14, WF_INK_TEXT, 0, name);
}
/* <figures> */
static void figure_platform_service(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const char *const layers[] = { "SDL2", "headless", "web", "Win32" };
    static const char *const values[] = { "game_memory", "game_input", "frame_buffer" };
    for (int i = 0; i < 4; i++)
        platform_box(d, 0.2f, 0.3f + 0.95f * (float)i, 1.9f, 0.7f,
                     i == 3 ? WF_INK_BODY : WF_INK_FAINT, layers[3 - i]);
    wfDrawDashed(d, 4.5f, 0, 4.5f, 4.3f, 2, WF_INK_LINE);
    platform_box(d, 6.1f, 0.3f, 2.6f, 3.55f, WF_INK_BODY2, "");
    wfDrawText(d, 7.4f, 3.3f, 14, WF_INK_TEXT, 0, "the game");
    platform_box(d, 6.5f, 0.65f, 1.8f, 1.6f, WF_INK_PAPER, "engine");
    for (int i = 0; i < 3; i++) {
        float y = 2.9f - 0.8f * (float)i;
        if (i < 2) wfDrawArrow(d, 2.3f, y, 5.9f, y, 2, WF_INK_ACCENT);
        else wfDrawArrow(d, 5.9f, y, 2.3f, y, 2, WF_INK_ACCENT);
        wfDrawText(d, 4.35f, y + 0.12f, 13, WF_INK_TEXT, 1, values[i]);
    }
    wfDrawText(d, 4.5f, 4.4f, 13, WF_INK_TEXT, 0, "game_update_and_render");
}
/* <figures> */
static void figure_platform_clock(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const float frames[] = { 1.3f, 0.9f, 2.3f, 0.4f, 1.8f };
    step_clock clock = { 0 };
    float time = 0.4f, done = 0.4f;
    wfDrawText(d, 0.4f, 2.75f, 14, WF_INK_TEXT, -1, "frames");
    wfDrawText(d, 0.4f, 0.1f, 14, WF_INK_TEXT, -1, "steps");
    for (int i = 0; i < 5; i++) {
        float next = time + frames[i];
        float bar[] = { time, 1.9f, next, 1.9f, next, 2.5f, time, 2.5f };
        wfDrawPolygon(d, bar, 4, 1.5f, WF_INK_LINE, i % 2 ? WF_INK_FAINT : WF_INK_BODY);
        int n = step_clock_advance(&clock, (double)frames[i], 1, STEP_CLOCK_MOST);
        for (; n > 0; n--, done += 1) {
            float step[] = { done, 0.5f, done + 1, 0.5f, done + 1, 1.1f, done, 1.1f };
            wfDrawPolygon(d, step, 4, 1.5f, WF_INK_LINE,
                          i % 2 ? WF_INK_FAINT : WF_INK_BODY);
        }
        /* <draw what is left in the accumulator> */
        wfDrawDashed(d, next, 1.1f, next, 1.9f, 1, WF_INK_FAINT);
        if (clock.left > 0.01) {
            float y = 1.25f + 0.1f * (float)(i % 2);
            wfDrawLine(d, done, y, next, y, 3, WF_INK_ACCENT);
            wfDrawTextf(d, next + 0.05f, 1.55f, 12, WF_INK_ACCENT, -1, "%.1f", clock.left);
        }
        time = next;
    }
}
/* <figures> */
static void platform_spiral(wfDraw *d, double cost, int32_t most, int role,
                            const char *name)
{
    float xy[2 * 11];
    step_clock clock = { 0 };
    double frame = 6;                               /* the hiccup */
    int k = 0;
    for (; k < 11; k++) {
        int32_t n = step_clock_advance(&clock, frame, 1, most);
        if (n > 23) break;
        frame = n * cost > 1 ? n * cost : 1;
        xy[2 * k] = 1 + 0.7f * (float)k;
        xy[2 * k + 1] = 0.6f + 0.2f * (float)n;
        wfDrawPoint(d, xy[2 * k], xy[2 * k + 1], 6, role);
    }
    wfDrawPolyline(d, xy, k, 2, role);
    wfDrawText(d, xy[2 * k - 2] + 0.15f, xy[2 * k - 1] + 0.08f, 13, role, -1, name);
}
/* <figures> */
static void figure_platform_spiral(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawArrow(d, 0.9f, 0.6f, 9.2f, 0.6f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.9f, 0.6f, 0.9f, 5.6f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 9.2f, 0.15f, 13, WF_INK_TEXT, 1, "frame");
    wfDrawText(d, 1.05f, 5.35f, 13, WF_INK_TEXT, -1, "steps made in it");
    for (int n = 0; n <= 20; n += 4) {
        wfDrawLine(d, 0.82f, 0.6f + 0.2f * (float)n, 0.9f, 0.6f + 0.2f * (float)n, 1.5f,
                   WF_INK_LINE);
        wfDrawTextf(d, 0.7f, 0.52f + 0.2f * (float)n, 12, WF_INK_TEXT, 1, "%d", n);
    }
    platform_spiral(d, 1.4, 1000, WF_INK_BAD, "c = 1.4 h, no bound");
    platform_spiral(d, 1.4, STEP_CLOCK_MOST, WF_INK_ACCENT, "c = 1.4 h, bound 8");
    platform_spiral(d, 0.6, STEP_CLOCK_MOST, WF_INK_GOOD, "c = 0.6 h");
}
/* <figures> */
static void drawing_square(wfDraw *d, float x, float y, float side, int line, int role)
{
    float a = x - 0.5f * side, b = x + 0.5f * side;
    float c = y - 0.5f * side, e = y + 0.5f * side;
    float corners[8] = { a, c, b, c, b, e, a, e };
    wfDrawPolygon(d, corners, 4, line == WF_INK_NONE ? 0 : 0.75f, line, role);
}

/* A row's coverage at the height y of the figure, from x on: one unit is one pixel. */
static void drawing_row(wfDraw *d, const wfCoverRow *row, float x, float y, int role,
                        bool on_off)
{
    for (int32_t i = 0; i < row->width; i++) {
        float share = on_off ? (row->at[i] >= 0.5f) : row->at[i];
        float side = (float)wfSqrt(share), cx = x + (float)i + 0.5f;
        drawing_square(d, cx, y + 0.5f, 1, WF_INK_FAINT, WF_INK_NONE);
        if (side > 0.02f) drawing_square(d, cx, y + 0.5f, side, WF_INK_NONE, role);
    }
}
/* <figures> */
static void figure_drawing_jagged(wfDraw *d, const wfFigureInput *in)
{
    static wfCoverRow row;
    float from[2] = { in->handle[0][0], in->handle[0][1] };
    float to[2] = { in->handle[1][0], in->handle[1][1] };
    wfCoverBegin(&row, 0, 0, 14);
    for (row.y = 0; row.y < 9; row.y++) {
        wfCoverLine(&row, from, to, 0.8f);
        drawing_row(d, &row, 0.5f, (float)row.y + 0.5f, WF_INK_LINE, true);
        drawing_row(d, &row, 15.5f, (float)row.y + 0.5f, WF_INK_LINE, false);
        wfCoverClear(&row);
    }
    for (float x = 0.5f; x < 16; x += 15)
        wfDrawLine(d, from[0] + x, from[1] + 0.5f, to[0] + x, to[1] + 0.5f, 1,
                   WF_INK_ACCENT);
}
/* <figures> */
static void figure_drawing_distance(wfDraw *d, const wfFigureInput *in)
{
    wfVec2 a = wfV2(in->handle[0][0], in->handle[0][1]);
    wfVec2 b = wfV2(in->handle[1][0], in->handle[1][1]), along = wfSub(b, a);
    wfReal squared = wfMaxR(wfLengthSq(along), WF_R(1e-6)), half = WF_R(1.2);
    wfVec2 side = wfScale(half, wfPerpCCW(wfNormalize(along)));
    wfDrawCircle(d, WF_XY(a), (float)half, 1, WF_INK_LINE, WF_INK_FAINT);
    wfDrawCircle(d, WF_XY(b), (float)half, 1, WF_INK_LINE, WF_INK_FAINT);
    const float body[8] = { WF_XY(wfAdd(a, side)), WF_XY(wfAdd(b, side)),
                            WF_XY(wfSub(b, side)), WF_XY(wfSub(a, side)) };
    wfDrawPolygon(d, body, 4, 0, WF_INK_NONE, WF_INK_FAINT);
    wfDrawLine(d, body[0], body[1], body[2], body[3], 1, WF_INK_LINE);
    wfDrawLine(d, body[4], body[5], body[6], body[7], 1, WF_INK_LINE);
    for (int i = 0; i < 11 * 7; i++) {
        wfVec2 p = wfV2((wfReal)(i % 11) + 0.5f, (wfReal)(i / 11) + 0.5f);
        wfReal t = wfClamp(wfDot(wfSub(p, a), along) / squared, 0, 1);
        wfVec2 nearest = wfAddScaled(a, t, along);
        bool inside = wfDistance(p, nearest) <= half;
        wfDrawLine(d, WF_XY(p), WF_XY(nearest), 0.75f, inside ? WF_INK_BODY : WF_INK_FAINT);
        wfDrawPoint(d, WF_XY(p), 4, inside ? WF_INK_BODY : WF_INK_FAINT);
    }
    wfDrawLine(d, WF_XY(a), WF_XY(b), 2, WF_INK_ACCENT);
}
/* <figures> */
static void figure_drawing_polygon(wfDraw *d, const wfFigureInput *in)
{
    static wfCoverRow row;
    float corners[6], flipped[6];
    for (int k = 0; k < 6; k++) {
        corners[k] = in->handle[k / 2][k % 2];
        flipped[k] = k % 2 ? -corners[k] : corners[k];
    }
    wfCoverBegin(&row, 0, 0, 14);
    for (row.y = 0; row.y < 10; row.y++) {
        wfCoverPolygon(&row, (wfPixelMap){ 1, 0, 0 }, flipped, 3);
        drawing_row(d, &row, 0, (float)row.y, WF_INK_LINE, false);
        wfCoverClear(&row);
    }
    wfDrawPolygon(d, corners, 3, 1.5f, WF_INK_ACCENT, WF_INK_NONE);
}
/* <figures> */
static void figure_drawing_edge(wfDraw *d, const wfFigureInput *in)
{
    static wfCoverRow row;
    float xa = in->handle[0][0] - 0.5f, xb = in->handle[1][0] - 0.5f, before = 0;
    float area[8] = { xa, 0, 60, 0, 60, -1, xb, -1 };
    wfCoverBegin(&row, 0, 0, 9);
    wfCoverPolygon(&row, (wfPixelMap){ 1, 0, 0 }, area, 4);
    for (int i = 0; i < 9; i++) {
        float x = 1 + (float)i, step = row.at[i] - before, bar = 1.2f * step;
        drawing_square(d, x, 2.6f, 1, WF_INK_FAINT, WF_INK_NONE);
        wfDrawTextf(d, x, 3.25f, 11, WF_INK_TEXT, 0, "%.2f", (double)row.at[i]);
        float box[8] = { x - 0.3f, 0.6f, x + 0.3f, 0.6f, x + 0.3f, 0.6f + bar, x - 0.3f,
                         0.6f + bar };
        if (step > 0) wfDrawPolygon(d, box, 4, 1, WF_INK_ACCENT, WF_INK_ACCENT);
        wfDrawTextf(d, x, 0.25f, 11, WF_INK_TEXT, 0, "%.2f", (double)step);
        before = row.at[i];
    }
    float cut = 9.5f, shape[8] = { xa + 0.5f, 2.1f, cut, 2.1f, cut, 3.1f, xb + 0.5f, 3.1f };
    wfDrawPolygon(d, shape, 4, 0, WF_INK_NONE, WF_INK_BODY);
    wfDrawArrow(d, xa + 0.5f, 2.1f, xb + 0.5f, 3.1f, 2, WF_INK_ACCENT);
    for (int i = 0; i < 9; i++) drawing_square(d, 1 + (float)i, 2.6f, 1, WF_INK_FAINT,
                                               WF_INK_NONE);
    wfDrawText(d, 0.5f, 3.55f, 12, WF_INK_TEXT, -1, "coverage right of the edge");
    wfDrawText(d, 0.5f, 1.75f, 12, WF_INK_TEXT, -1, "its changes, as they are stored");
}
/* <figures> */
static void drawing_axes(wfDraw *d, float x, float y, float w, float h, const char *along,
                         const char *up)
{
    wfDrawArrow(d, x, y, x + w, y, 1, WF_INK_LINE);
    wfDrawArrow(d, x, y, x, y + h, 1, WF_INK_LINE);
    wfDrawText(d, x + 0.5f * w, y - 0.65f, 12, WF_INK_TEXT, 0, along);
    wfDrawText(d, x + 0.12f, y + h - 0.05f, 12, WF_INK_TEXT, -1, up);
}

static float drawing_corner(float u)                      /* eq:draw-corner */
{
    float side = u < 0 ? -u : u, left = 0.70710678f - side;
    float part = left > 0 ? left * left : 0;
    return u < 0 ? 1 - part : part;
}
/* <figures> */
static void figure_drawing_error(wfDraw *d, const wfFigureInput *in)
{
    float exact[2 * 81], near[2 * 81];
    (void)in;
    for (int i = 0; i <= 80; i++) {
        float u = -1 + (float)i / 40, ramp = u < -0.5f ? 1 : u > 0.5f ? 0 : 0.5f - u;
        exact[2 * i] = near[2 * i] = 3.9f + 3 * u;
        exact[2 * i + 1] = 0.9f + 3 * drawing_corner(u);
        near[2 * i + 1] = 0.9f + 3 * ramp;
    }
    drawing_axes(d, 0.7f, 0.9f, 6.6f, 3.5f, "distance of the centre from the edge (px)",
                 "coverage");
    /* <draw the two curves and their greatest gap by eq:draw-error> */
    float u = 0.20710678f, x = 3.9f + 3 * u;
    wfDrawPolyline(d, near, 81, 1.5f, WF_INK_BODY);
    wfDrawPolyline(d, exact, 81, 1.5f, WF_INK_ACCENT);
    wfDrawDashed(d, x, 0.9f, x, 2.7f, 1, WF_INK_FAINT);
    wfDrawTextf(d, x + 0.1f, 2.4f, 12, WF_INK_TEXT, -1, "gap %.4f",
                (double)(0.5f - u - drawing_corner(u)));
    wfDrawLine(d, 5.0f, 3.9f, 5.4f, 3.9f, 2, WF_INK_ACCENT);
    wfDrawText(d, 5.5f, 3.83f, 12, WF_INK_TEXT, -1, "exact");
    wfDrawLine(d, 5.0f, 3.5f, 5.4f, 3.5f, 2, WF_INK_BODY);
    wfDrawText(d, 5.5f, 3.43f, 12, WF_INK_TEXT, -1, "from distance");
    for (int k = -1; k <= 1; k++) {
        wfDrawLine(d, 3.9f + 3 * (float)k, 0.85f, 3.9f + 3 * (float)k, 0.95f, 1, WF_INK_LINE);
        wfDrawTextf(d, 3.9f + 3 * (float)k, 0.58f, 11, WF_INK_TEXT, 0,
                    k < 0 ? "\u2212%d" : "%d", k * k);
    }
}
/* <figures> */
static void figure_drawing_blend(wfDraw *d, const wfFigureInput *in)
{
    float light[2 * 41], bytes[2 * 41];
    (void)in;
    for (int i = 0; i <= 40; i++) {
        uint8_t a[4] = { 0, 0, 0, 255 }, b[4] = { 0, 0, 0, 255 };
        const wfInk white = { 255, 255, 255, 255 };
        float share = (float)i / 40;
        wfBlend(a, white, share);
        wfBlendLetter(b, white, share);
        light[2 * i] = bytes[2 * i] = 0.7f + 5 * share;
        light[2 * i + 1] = 0.9f + 3.2f * (float)a[0] / 255;
        bytes[2 * i + 1] = 0.9f + 3.2f * (float)b[0] / 255;
    }
    drawing_axes(d, 0.7f, 0.9f, 5.4f, 3.7f, "share of white", "byte");
    wfDrawPolyline(d, bytes, 41, 1.5f, WF_INK_BODY);
    wfDrawPolyline(d, light, 41, 1.5f, WF_INK_ACCENT);
    wfDrawText(d, 2.0f, 3.35f, 12, WF_INK_ACCENT, 1, "as light");
    wfDrawText(d, 4.1f, 2.5f, 12, WF_INK_BODY, -1, "as bytes");
    wfDrawText(d, 0.6f, 4.05f, 11, WF_INK_TEXT, 1, "255");
    wfDrawText(d, 5.7f, 0.58f, 11, WF_INK_TEXT, 0, "1");
    wfDrawText(d, 0.6f, 0.58f, 11, WF_INK_TEXT, 0, "0");
}
/* <figures> */
static void figure_drawing_roles(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    for (int role = 0; role < WF_INK_COUNT; role++) {
        float x = 0.6f + (float)role, y = 1;
        drawing_square(d, x, y, 0.8f, role == WF_INK_PAPER ? WF_INK_FAINT : role, role);
        wfDrawText(d, x, 0.2f, 13, role == WF_INK_PAPER ? WF_INK_TEXT : role, 0,
                   wfInkName(role));
    }
}
/* <figures> */
static void figure_drawing_stages(wfDraw *d, const wfFigureInput *in)
{
    static const char *const title[5] = { "list", "commands", "stencils", "rows",
                                          "picture" };
    static const char *const below[5] = { "of the pen", "one by one", "what shape?",
                                          "how much?", "mixed in" };
    (void)in;
    for (int i = 0; i < 5; i++) {
        float x = 0.1f + 2.1f * (float)i;
        int role = i < 2 ? WF_INK_BODY : i < 4 ? WF_INK_ACCENT : WF_INK_GOOD;
        design_box(d, x, 0.2f, 1.75f, 1.1f, role, title[i], below[i]);
        if (i < 4) wfDrawArrow(d, x + 1.75f, 0.75f, x + 2.1f, 0.75f, 1.5f, WF_INK_LINE);
    }
    wfDrawDashed(d, 4.12f, 0.05f, 4.12f, 1.5f, 1, WF_INK_FAINT);
}
/* <figures> */
static void draw_scene(wfDraw *d, const char *name, int steps, uint32_t show)
{
    static _Alignas(WF_POOL_ALIGN) uint8_t bytes[256 * 1024];
    const wfScene *scene = wfSceneAt(wfFindScene(name));
    wfSceneInput in = wfSceneInputAt(scene, 0);
    wfWorld world;
    wfPool scratch;
    wfPoolInit(&scratch, sizeof bytes, bytes);
    if (wfOpenScene(scene, NULL, &world) != WF_OK) return;
    for (int step = 0; step < steps; step++) {
        in = wfSceneInputAt(scene, step);
        wfStepScene(scene, &world, &in);
    }
    wfDrawWorld(&world, show, &scratch, d);
    if (scene->draw) scene->draw(&world, d, &in);
    wfDestroyWorld(&world);
}
/* <figures> */
static void figure_scenes_wall(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -10, -0.6f, 8, 6);
    draw_scene(d, "ball and wall", 100, 0);
}

static void figure_scenes_axis(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -6.2f, -4.2f, 6.2f, 4.2f);
    draw_scene(d, "TC03 separating axis", 400, 0);
}

static void figure_scenes_tree(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -10.2f, 4.4f, 0.4f, 11.2f);
    draw_scene(d, "TC06 quad tree", 200, WF_SHOW_TREE);
}
/* <figures> */
static void figure_scenes_integrators(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -2.2f, -7.2f, 10.4f, 2.2f);
    draw_scene(d, "integrators", 1199, 0);
}

static void figure_scenes_buoyancy(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -8.2f, -5.1f, 8.2f, 2.1f);
    draw_scene(d, "buoyancy", 2000, 0);
}
/* <figures> */
/* The part of a scene's world that a tile shows: from (x, y) on, so many metres wide. */
typedef struct SceneTile { const char *name; int steps; float x, y, wide; } SceneTile;
typedef struct TilePlace {
    float x, y, wide, high, scale;
    const SceneTile *tile;
} TilePlace;

static float between(float x, float least, float most)
{
    return x < least ? least : x > most ? most : x;
}

/* Brings a command's points into the tile; false when all of them are off one side. */
static bool tile_points(const TilePlace *p, const float *from, int32_t count, float *to)
{
    bool right = false, left = false, above = false, below = false;
    for (int32_t i = 0; i < count; i++) {
        float x = (from[2 * i] - p->tile->x) * p->scale;
        float y = (from[2 * i + 1] - p->tile->y) * p->scale;
        right |= x >= 0, left |= x <= p->wide, above |= y >= 0, below |= y <= p->high;
        to[2 * i] = p->x + between(x, 0, p->wide);
        to[2 * i + 1] = p->y + between(y, 0, p->high);
    }
    return right && left && above && below;
}
/* <figures> */
static void copy_command(wfDraw *d, const wfDraw *from, int i, const TilePlace *p)
{
    const wfDrawCommand *c = wfDrawAt(from, i);
    float xy[2 * 64], size = 0.7f * c->size;
    int role = c->line == WF_INK_NONE ? c->fill : c->line;
    if (c->count > 64 || !tile_points(p, wfDrawPoints(from, c), c->count, xy))
        return;
    switch ((wfDrawKind)c->kind) {
    case WF_DRAW_POINT: wfDrawPoint(d, xy[0], xy[1], size, role); break;
    case WF_DRAW_LINE: wfDrawLine(d, xy[0], xy[1], xy[2], xy[3], size, c->line); break;
    case WF_DRAW_ARROW: wfDrawArrow(d, xy[0], xy[1], xy[2], xy[3], size, c->line); break;
    case WF_DRAW_DASHED: wfDrawDashed(d, xy[0], xy[1], xy[2], xy[3], size, c->line); break;
    case WF_DRAW_CIRCLE:
        wfDrawCircle(d, xy[0], xy[1], p->scale * c->radius, size, c->line, c->fill); break;
    case WF_DRAW_POLYGON: wfDrawPolygon(d, xy, c->count, size, c->line, c->fill); break;
    case WF_DRAW_POLYLINE: wfDrawPolyline(d, xy, c->count, size, c->line); break;
    case WF_DRAW_TEXT:
        wfDrawText(d, xy[0], xy[1], size, role, c->anchor,
                   wfDrawString(from, c));
        break;
    default: break;
    }
}
/* <figures> */
static void draw_gallery(wfDraw *d, const SceneTile *tile, int count, int columns)
{
    static _Alignas(WF_POOL_ALIGN) uint8_t bytes[512 * 1024];
    const float wide = 4, high = 2.5f, across = 4.3f, down = 3.2f;
    float top = down * (float)((count + columns - 1) / columns) - 2.6f;
    for (int i = 0; i < count; i++) {
        TilePlace p = { 0.05f + across * (float)(i % columns),
                        top - down * (float)(i / columns),
                        wide, high, wide / tile[i].wide, &tile[i] };
        float frame[] = { p.x, p.y, p.x + wide, p.y, p.x + wide, p.y + high,
                          p.x, p.y + high };
        wfDraw own;
        wfDrawInit(&own, bytes, sizeof bytes);
        draw_scene(&own, tile[i].name, tile[i].steps,
                   wfSceneAt(wfFindScene(tile[i].name))->show);
        for (int k = 0; k < own.count; k++)
            copy_command(d, &own, k, &p);
        wfDrawPolygon(d, frame, 4, 1, WF_INK_FAINT, WF_INK_NONE);
        wfDrawTextf(d, p.x + wide / 2, p.y - 0.36f, 11, WF_INK_TEXT, 0, "%s, step %d",
                    tile[i].name, tile[i].steps);
    }
}
/* <figures> */
static void figure_scenes_motion(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "free fall", 85, -5.2f, -0.7f, 15.4f },
        { "spring and orbit", 100, -6, -4.6f, 14.7f }
    };
    (void)in;
    draw_gallery(d, tile, 2, 2);
}

static void figure_scenes_forces(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "bungee", 75, -8, -4.2f, 16 }, { "spring net", 110, -7.2f, -4, 14.4f },
        { "wind", 120, -7.5f, -1, 15 }, { "explosion", 85, -8, -1, 16 }
    };
    (void)in;
    draw_gallery(d, tile, 4, 2);
}
/* <figures> */
static void figure_scenes_joints(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "bridge", 120, -8, -0.6f, 16 }, { "weak bridge", 64, -8, -0.6f, 16 },
        { "cart", 240, -3.6f, -1.6f, 11 }, { "crane", 420, -7.5f, -0.6f, 15 },
        { "springs", 60, -7.2f, -2.6f, 14.4f }, { "ragdolls", 62, -5.6f, -0.6f, 11.2f }
    };
    (void)in;
    draw_gallery(d, tile, 6, 2);
}
/* <figures> */
static void figure_scenes_collision(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "bouncing circles", 100, -7, -1, 14 }, { "cradle", 75, -7, -4.4f, 14 },
        { "stack of boxes", 300, -6, -0.8f, 12 }, { "pyramid", 150, -6, -0.8f, 12 },
        { "shapes", 60, -8, -1.2f, 16 }, { "shapes", 300, -8, -1.2f, 16 }
    };
    (void)in;
    draw_gallery(d, tile, 6, 2);
}

static void figure_scenes_classics(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "card house", 300, -5.2f, -0.5f, 10.4f }, { "arch", 300, -6.2f, -0.8f, 12.4f },
        { "dominoes", 120, -8, -2.5f, 16 }, { "hung cradle", 70, -4.8f, 0.4f, 9.6f },
        { "tumbler", 300, -7.2f, -0.4f, 14.4f },
        { "Galton board", 700, -9.4f, -0.4f, 18.8f }
    };
    (void)in;
    draw_gallery(d, tile, 6, 2);
}
/* <figures> */
static void figure_scenes_solvers(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -2.6f, -12, 12.6f, 4.6f);
    draw_scene(d, "solvers", 149, 0);
}

static void figure_scenes_fast(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "bullets", 24, -8, -1.4f, 16 }, { "bullet room", 60, -8, -1.2f, 16 },
        { "fan", 200, -13, -1.5f, 26 }
    };
    (void)in;
    draw_gallery(d, tile, 3, 3);
}
/* <figures> */
static void figure_scenes_cases(wfDraw *d, const wfFigureInput *in)
{
    static const SceneTile tile[] = {
        { "TC01 masses", 200, -6, -1.2f, 12 }, { "TC02 arms", 200, -6, -1.2f, 12 },
        { "TC04 contact points", 150, -6.2f, -3.9f, 12.4f },
        { "TC05 colours", 150, -6.2f, -3.9f, 12.4f },
        { "TC07 pairs", 200, -10.2f, -1.3f, 20.4f },
        { "TC08 positional correction", 150, -6.2f, -3.9f, 12.4f }
    };
    (void)in;
    draw_gallery(d, tile, 6, 2);
}
/* <figures> */
/* A rectangle of the interface: units from the upper left corner, y down. */
static void window_box(wfDraw *d, const camera *c, float x, float y, float w, float h,
                       int fill)
{
    float a[2], b[2];
    camera_pick(c, x, y + h, a);
    camera_pick(c, x + w, y, b);
    float xy[] = { a[0], a[1], b[0], a[1], b[0], b[1], a[0], b[1] };
    wfDrawPolygon(d, xy, 4, 0.8f, WF_INK_FAINT, fill);
}
/* <figures> */
static void window_text(wfDraw *d, const camera *c, float x, float y, int role, int anchor,
                        const char *text)
{
    float a[2];
    camera_pick(c, x, y, a);
    wfDrawText(d, a[0], a[1], 5.6f, role, anchor, text);
}

static void window_mark(wfDraw *d, const camera *c, float x, float y, const char *letter)
{
    float a[2];
    camera_pick(c, x, y, a);
    wfDrawCircle(d, a[0], a[1], 20 / camera_scale(c), 1, WF_INK_ACCENT, WF_INK_ACCENT);
    camera_pick(c, x, y + 9, a);
    wfDrawText(d, a[0], a[1], 11, WF_INK_TEXT, 0, letter);
}
/* <figures> */
static void window_list(wfDraw *d, const camera *c, const char *open)
{
    float y = LIST_TOP;
    window_box(d, c, 0, 0, LIST_WIDTH, 700, WF_INK_PAPER);
    for (int i = 0; i < wfSceneCount() && i < 23; i++) {
        const wfScene *s = wfSceneAt(i);
        if (i == 0 || strcmp(s->category, wfSceneAt(i - 1)->category) != 0) {
            window_text(d, c, 10, y + 14, WF_INK_ACCENT, -1, s->category);
            y += ROW;
        }
        if (strcmp(s->name, open) == 0)
            window_box(d, c, 8, y, LIST_WIDTH - 16, ROW, WF_INK_ACCENT);
        window_text(d, c, 16, y + 14, WF_INK_TEXT, -1, s->name);
        y += ROW;
    }
    for (int i = 0; i < wfOverlayCount; i++) {
        float x = i % 2 ? LIST_WIDTH / 2 + 4 : 12;
        if (!wfOverlayTable[i].key) continue;           /* of the panel "See" */
        y = 700 - LIST_BOTTOM + 27 + (float)(i / 2 * ROW);
        window_box(d, c, x, y + 3, 12, 12, WF_INK_PAPER);
        window_text(d, c, x + 17, y + 14, WF_INK_TEXT, -1, wfOverlayTable[i].name);
    }
}
/* <figures> */
static void figure_scenes_window(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const char *const button[] = {
        "List", "Tools", "Pause", "Step", "Reset", "Previous", "Next", "Home", "Dark",
        "Keys", "Settings", "Hand", "Place", "Draw", "Pin", "Connect", "Lasso", "Delete",
        "Probe" };
    const wfScene *s = wfSceneAt(wfFindScene("shapes"));
    camera c = { (float)s->viewX, (float)s->viewY, (float)s->viewHeight, LIST_WIDTH, HEAD,
                 1100 - LIST_WIDTH, 700 - HEAD - FOOT - TIME_BAR };
    float view[4];
    camera_window(&c, 1100, 700, view);
    wfDrawView(d, view[0], view[1], view[2], view[3]);
    draw_scene(d, s->name, 100, 0);
    window_box(d, &c, -2, -2, 1104, HEAD, WF_INK_PAPER);
    window_box(d, &c, -2, 700 - FOOT + 2, 1104, FOOT, WF_INK_PAPER);
    window_list(d, &c, s->name);
    /* <draw the buttons of the bar> */
    for (int i = 0; i < 19; i++) {
        float x = 224 + 62 * (float)(i % 11), y = 10 + BAR_ROW * (float)(i / 11);
        window_box(d, &c, x, y, 56, 24, WF_INK_PAPER);
        window_text(d, &c, x + 28, y + 17, WF_INK_TEXT, 0, button[i]);
    }
    window_text(d, &c, 224, HEAD - 32, WF_INK_TEXT, -1, s->name);
    window_text(d, &c, 224, HEAD - 12, WF_INK_TEXT, -1, s->text);
    window_text(d, &c, 224, 675, WF_INK_TEXT, -1, "running, step 100, 1.67 s, ...");
    window_box(d, &c, 1, 1, 1098, 698, WF_INK_NONE);
    /* <mark the parts of the window by letters> */
    static const struct { const char *letter; float x, y; } mark[] = {
        { "A", 170, 200 }, { "B", 188, 582 }, { "C", 922, 22 }, { "D", 680, 96 },
        { "E", 650, 180 }, { "F", 470, 674 }
    };
    for (int i = 0; i < 6; i++)
        window_mark(d, &c, mark[i].x, mark[i].y, mark[i].letter);
}
/* <figures> */
static void camera_rect(wfDraw *d, float x, float y, float w, float h, int line, int fill)
{
    float xy[] = { x, y, x + w, y, x + w, y + h, x, y + h };
    wfDrawPolygon(d, xy, 4, 1.5f, line, fill);
}

/* The picture: 5 x 3.4 units of the figure, its upper left corner at (6.4, 4.2), y down. */
static void camera_mark(wfDraw *d, const camera *c, float x, float y, const char *w,
                        const char *p)
{
    float pixel[2];
    camera_see(c, x, y, pixel);
    wfDrawPoint(d, x, y, 7, WF_INK_ACCENT);
    wfDrawText(d, x + 0.12f, y + 0.12f, 14, WF_INK_TEXT, -1, w);
    wfDrawPoint(d, 6.4f + pixel[0], 4.2f - pixel[1], 7, WF_INK_ACCENT);
    wfDrawText(d, 6.52f + pixel[0], 4.32f - pixel[1], 14, WF_INK_TEXT, -1, p);
}
/* <figures> */
static void figure_scenes_camera(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    camera c = { 2.7f, 2.4f, 2, 1, 0.5f, 4, 2.5f };
    float a[2], b[2];
    camera_pick(&c, 1, 3, a);
    camera_pick(&c, 5, 0.5f, b);
    wfDrawArrow(d, 0.3f, 0.5f, 5.6f, 0.5f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.3f, 0.5f, 0.3f, 4.6f, 1.5f, WF_INK_LINE);
    camera_rect(d, a[0], a[1], b[0] - a[0], b[1] - a[1], WF_INK_BODY, WF_INK_BODY);
    camera_rect(d, 6.4f, 0.8f, 5, 3.4f, WF_INK_LINE, WF_INK_NONE);
    camera_rect(d, 6.4f, 0.8f, 1, 3.4f, WF_INK_FAINT, WF_INK_FAINT);
    camera_rect(d, 7.4f, 1.2f, 4, 2.5f, WF_INK_BODY, WF_INK_BODY);
    camera_mark(d, &c, 2.7f, 2.4f, "c", "o");
    camera_mark(d, &c, 3.6f, 2.9f, "w", "p");
    wfDrawText(d, 5.6f, 0.15f, 13, WF_INK_TEXT, 1, "x (m)");
    wfDrawText(d, 0.45f, 4.5f, 13, WF_INK_TEXT, -1, "y (m)");
    wfDrawArrow(d, 6.4f, 4.4f, 8, 4.4f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 8.1f, 4.33f, 13, WF_INK_TEXT, -1, "x (pixels)");
    wfDrawArrow(d, 6.2f, 4.2f, 6.2f, 2.6f, 1.5f, WF_INK_LINE);
    wfDrawText(d, 6.1f, 2.25f, 13, WF_INK_TEXT, 0, "y");
}
/* <figures> */
static void draw_pull(wfDraw *d, float zeta, int role, const char *name, float ty)
{
    const float h = 1.0f / 60, omega = 8;
    float x = -1, v = 0, xy[2 * 91];
    for (int i = 0; i <= 90; i++) {
        xy[2 * i] = 0.8f + 4.5f * (float)i * h;
        xy[2 * i + 1] = 3 + 2.2f * x;
        float k = h * omega;
        v = (v - k * omega * x) / (1 + 2 * zeta * k + k * k);
        x += h * v;
    }
    wfDrawPolyline(d, xy, 91, 2, role);
    wfDrawLine(d, 5.2f, ty + 0.08f, 5.6f, ty + 0.08f, 2, role);
    wfDrawText(d, 5.7f, ty, 13, WF_INK_TEXT, -1, name);
}
/* <figures> */
static void figure_scenes_hand(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawArrow(d, 0.8f, 0.4f, 8, 0.4f, 1.5f, WF_INK_LINE);
    wfDrawArrow(d, 0.8f, 0.4f, 0.8f, 4.2f, 1.5f, WF_INK_LINE);
    wfDrawDashed(d, 0.8f, 3, 7.8f, 3, 1.5f, WF_INK_FAINT);
    wfDrawText(d, 0.7f, 2.93f, 13, WF_INK_TEXT, 1, "mouse");
    wfDrawText(d, 0.7f, 0.73f, 13, WF_INK_TEXT, 1, "body");
    for (int i = 1; i <= 3; i++)
        wfDrawTextf(d, 0.8f + 2.25f * (float)i, 0.05f, 13, WF_INK_TEXT, 0, "%.1f s",
                    0.5 * i);
    draw_pull(d, 0.5f, WF_INK_BAD, "half the critical damping", 1.9f);
    draw_pull(d, 1, WF_INK_GOOD, "critical", 1.5f);
    draw_pull(d, 2, WF_INK_ACCENT, "twice", 1.1f);
}
/* <figures> */
static void tape_box(wfDraw *d, float x, float y, float w, int fill, const char *name)
{
    float xy[] = { x, y, x + w, y, x + w, y + 0.7f, x, y + 0.7f };
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, fill);
    wfDrawText(d, x + w / 2, y + 0.25f, 13, WF_INK_TEXT, 0, name);
}
/* <figures> */
static void figure_scenes_tape(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    /* <what the journal of the figure holds> */
    static const struct { const char *name; float wide; int fill; } part[] = {
        { "snapshot", 2, WF_INK_FAINT }, { "impulse", 1.5f, WF_INK_BODY },
        { "spin", 1.5f, WF_INK_BODY }, { "3 steps", 1.5f, WF_INK_BODY2 },
        { "add body", 1.5f, WF_INK_BODY }, { "2 steps", 1.5f, WF_INK_BODY2 } };
    static const int mark[] = { 3, 4, 4, 5, 6 };        /* the journal's parts before it */
    float end[7] = { 0.2f };
    for (int i = 0; i < 6; i++) {
        tape_box(d, end[i], 2.2f, part[i].wide, part[i].fill, part[i].name);
        end[i + 1] = end[i] + part[i].wide;
    }
    for (int k = 0; k < 5; k++) {
        float x = 2.4f + 1.5f * (float)k;
        char name[20] = "note 0";
        name[5] = (char)('1' + k);
        tape_box(d, x, 0.3f, 1.2f, WF_INK_PAPER, name);
        wfDrawArrow(d, x + 0.6f, 1, end[mark[k]], 2.15f, 1.5f, WF_INK_ACCENT);
    }
    wfDrawText(d, 0.2f, 3.1f, 13, WF_INK_TEXT, -1, "journal");
    wfDrawText(d, 0.2f, 0.55f, 13, WF_INK_TEXT, -1, "a note a step");
}
/* <figures> */
typedef struct ChoiceLine {
    const char *name;
    float start, order;
    int role, label;            /* where its name stands */
} ChoiceLine;
enum { CHOICE_LINES = 3 };
static const ChoiceLine choice_line[CHOICE_LINES] = {
    { "order 1", -0.2f, 1, WF_INK_BODY2, 24 }, { "order 2", 0.6f, 2, WF_INK_BODY, 26 },
    { "order 4", 3.2f, 4, WF_INK_LINE, 1 },
};

static float choice_rounding(float work) { return -6.6f + 0.5f * work; }

static float choice_error(const ChoiceLine *l, float work)
{
    float error = l->start - l->order * work, least = choice_rounding(work);
    return error > least ? error : least;
}

static float choice_x(float work) { return 0.9f + 1.4f * work; }
static float choice_y(float error) { return 4.6f + 0.55f * error; }
/* <figures> */
/* The work at which the line comes down to the error; negative: it never does. */
static float choice_work(const ChoiceLine *l, float error)
{
    float work = (l->start - error) / l->order;
    if (work < 0) work = 0;
    return choice_error(l, work) > error + 1e-4f || work > 4 ? -1 : work;
}

static void choice_axes(wfDraw *d)
{
    wfDrawArrow(d, choice_x(0), choice_y(-7.5f), choice_x(4.1f), choice_y(-7.5f), 1.5f,
                WF_INK_LINE);
    wfDrawArrow(d, choice_x(0), choice_y(-7.5f), choice_x(0), choice_y(0.6f), 1.5f,
                WF_INK_LINE);
    wfDrawText(d, choice_x(4.1f), choice_y(-8.0f), 12, WF_INK_TEXT, 1, "log work");
    wfDrawText(d, choice_x(0) + 0.15f, choice_y(0.4f), 12, WF_INK_TEXT, -1, "log error");
    wfDrawDashed(d, choice_x(0), choice_y(choice_rounding(0)), choice_x(4),
                 choice_y(choice_rounding(4)), 1.2f, WF_INK_FAINT);
    wfDrawText(d, choice_x(3.9f), choice_y(-5.2f), 12, WF_INK_FAINT, 1, "rounding");
}
/* <figures> */
static void figure_accuracy_choice(wfDraw *d, const wfFigureInput *in)
{
    float error = (in->handle[0][1] - 4.6f) / 0.55f, best = -1;
    int chosen = -1;
    choice_axes(d);
    /* <draw each method's line and find the cheapest> */
    for (int i = 0; i < CHOICE_LINES; i++) {
        const ChoiceLine *l = &choice_line[i];
        float xy[2 * 41], work = choice_work(l, error);
        for (int k = 0; k <= 40; k++) {
            float at = l->order > 3 ? 0.75f + 3.25f * (float)k / 40 : 4 * (float)k / 40;
            xy[2 * k] = choice_x(at), xy[2 * k + 1] = choice_y(choice_error(l, at));
        }
        wfDrawPolyline(d, xy, 41, 2, l->role);
        wfDrawText(d, xy[2 * l->label] + 0.12f, xy[2 * l->label + 1] + 0.05f, 12, l->role,
                   -1, l->name);
        if (work < 0) continue;
        wfDrawPoint(d, choice_x(work), choice_y(error), 6, l->role);
        if (chosen < 0 || work < best) chosen = i, best = work;
    }
    wfDrawDashed(d, choice_x(0), choice_y(error), choice_x(4), choice_y(error), 1.5f,
                 WF_INK_ACCENT);
    if (chosen < 0) {
        wfDrawText(d, choice_x(2), choice_y(error) + 0.12f, 13, WF_INK_BAD, 0, "refused");
        return;
    }
    wfDrawCircle(d, choice_x(best), choice_y(error), 0.13f, 2, WF_INK_GOOD, WF_INK_NONE);
    wfDrawDashed(d, choice_x(best), choice_y(error), choice_x(best), choice_y(-7.5f), 1.2f,
                 WF_INK_GOOD);
}
/* <figures> */
static void figure_primer_pipeline(wfDraw *d, const wfFigureInput *in)
{
    static const char *const stage[5] = { "forces", "integration", "broad phase",
                                          "narrow phase", "resolution" };
    static const char *const passed[4] = { "force, torque", "places", "pairs", "contacts" };
    (void)in;
    for (int i = 0; i < 5; i++) {
        float x = 0.2f + 2.75f * (float)i;
        float box[8] = { x, 0.8f, x + 2.25f, 0.8f, x + 2.25f, 1.7f, x, 1.7f };
        wfDrawPolygon(d, box, 4, 1.5f, WF_INK_LINE, WF_INK_BODY);
        wfDrawText(d, x + 1.125f, 1.18f, 11, WF_INK_TEXT, 0, stage[i]);
        if (i == 4) break;
        wfDrawArrow(d, x + 2.28f, 1.25f, x + 2.72f, 1.25f, 1.5f, WF_INK_ACCENT);
        wfDrawText(d, x + 2.5f, 1.95f, 11, WF_INK_TEXT, 0, passed[i]);
    }
    /* <lead the velocities and places back to the first stage> */
    wfDrawLine(d, 12.3f, 0.75f, 12.3f, 0.35f, 1.5f, WF_INK_ACCENT);
    wfDrawLine(d, 12.3f, 0.35f, 1.3f, 0.35f, 1.5f, WF_INK_ACCENT);
    wfDrawArrow(d, 1.3f, 0.35f, 1.3f, 0.75f, 1.5f, WF_INK_ACCENT);
    wfDrawText(d, 6.8f, 0.08f, 11, WF_INK_TEXT, 0, "velocities and places, the next step");
}
/* <figures> */
enum { CRATE_POINTS = 9, CRATE_SPRINGS = 20 };

static void build_crate(wfVec2 centre, wfBodyState *point, wfForce *spring)
{
    int n = 0;
    for (int i = 0; i < CRATE_POINTS; i++) {
        wfVec2 place = wfV2(0.5f * (wfReal)(i % 3 - 1), 0.5f * (wfReal)(i / 3 - 1));
        point[i] = (wfBodyState){ .p = wfAdd(centre, place), .invMass = CRATE_POINTS };
    }
    for (int i = 0; i < CRATE_POINTS; i++)
        for (int j = i + 1; j < CRATE_POINTS; j++) {
            wfReal rest = wfDistance(point[i].p, point[j].p);
            if (rest > 0.9f) continue;
            spring[n++] = wfSpring(i, wfV2(0, 0), j, wfV2(0, 0), rest, 500, 0);
        }
}
/* <figures> */
static void pull_crate(void *springs, const wfBodyState *point, int count, wfReal time,
                       wfBodyForces *out)
{
    wfBodyProps props[CRATE_POINTS];
    for (int i = 0; i < CRATE_POINTS; i++) props[i] = wfDefaultBodyProps();
    wfBodyView view = { .count = count, .state = point, .props = props };
    wfAccumulateForces(springs, CRATE_SPRINGS, &view, time, out);
}

static void move_crate(wfBodyState *point, wfForce *springs, int steps)
{
    _Alignas(WF_POOL_ALIGN) uint8_t bytes[4096];
    wfPool pool;
    if (wfPoolInit(&pool, sizeof bytes, bytes) != WF_OK) return;
    wfIntegration in = { .state = point, .count = CRATE_POINTS, .h = 1 / (wfReal)256,
                         .forces = pull_crate, .context = springs, .scratch = &pool };
    for (int n = 0; n < steps; n++)
        if (wfIntegrate(wfFindIntegrator("verlet"), &in) != WF_OK) return;
}

/* <figures> */
static void draw_crate(wfDraw *d, const wfBodyState *point, const wfForce *spring, int role)
{
    for (int i = 0; i < CRATE_SPRINGS; i++)
        wfDrawLine(d, WF_XY(point[spring[i].a].p), WF_XY(point[spring[i].b].p), 1.5f, role);
    for (int i = 0; i < CRATE_POINTS; i++) wfDrawPoint(d, WF_XY(point[i].p), 7, role);
}
/* <figures> */
static void figure_intro_crates(wfDraw *d, const wfFigureInput *in)
{
    static const int after[3] = { 0, 150, 150 };
    wfBodyState point[CRATE_POINTS], rigid = { .p = { { 7.5f, 2 } }, .invMass = 1 };
    wfForce spring[CRATE_SPRINGS];
    wfVec2 blow = wfV2(3, 0), arm = wfV2(-0.5f, 0.5f);
    wfShape box;
    wfReal inertia = 0;
    build_crate(wfV2(1.6f, 2), point, spring);
    /* <sum the inertia of the nine points> */
    for (int i = 0; i < CRATE_POINTS; i++)
        inertia += wfDistanceSq(point[i].p, point[4].p) / CRATE_POINTS;
    rigid.invInertia = 1 / inertia;
    if (wfMakeBox(0.5f, 0.5f, &box) != WF_OK) return;
    for (int k = 0; k < 3; k++) {
        int steps = after[k] + (k == 2 ? (int)(64 * in->time) : 0);
        if (k > 0) move_crate(point, spring, steps);
        rigid.p = wfAddScaled(rigid.p, (wfReal)steps / 256, rigid.v);
        rigid.angle += (wfReal)steps / 256 * rigid.w;
        /* <draw both crates and strike them once> */
        wfTransform at = wfBodyTransform(&rigid);
        draw_crate(d, point, spring, k == 2 ? WF_INK_LINE : WF_INK_FAINT);
        figure_shape(d, &box, at, k == 2 ? 2 : 1.5f, k == 2 ? WF_INK_LINE : WF_INK_FAINT,
                     k == 2 ? WF_INK_BODY : WF_INK_NONE);
        if (k > 0) continue;
        wfVec2 left = wfAdd(point[4].p, arm), right = wfAdd(rigid.p, arm);
        wfDrawArrow(d, (float)left.x - 0.7f, (float)left.y, WF_XY(left), 2.5f, WF_INK_ACCENT);
        wfDrawArrow(d, (float)right.x - 0.7f, (float)right.y, WF_XY(right), 2.5f, WF_INK_ACCENT);
        wfApplyImpulse(&point[6], blow, point[6].p);
        wfApplyImpulse(&rigid, blow, right);
        wfDrawText(d, 3.3f, 0.25f, 14, WF_INK_TEXT, 0, "mass aggregate");
        wfDrawText(d, 9.2f, 0.25f, 14, WF_INK_TEXT, 0, "rigid body");
    }
}
/* <figures> */
static void figure_intro_fall(wfDraw *d, const wfFigureInput *in)
{
    static const int ink[3] = { WF_INK_BAD, WF_INK_ACCENT, WF_INK_GOOD };
    const float left = 1, top = 6, perSecond = 3, perMetre = 0.215f;
    float xy[2 * 65];
    (void)in;
    /* <draw the axes of time and fall> */
    wfDrawArrow(d, left, top, left + 2.2f * perSecond, top, 1, WF_INK_LINE);
    wfDrawArrow(d, left, top, left, 0.3f, 1, WF_INK_LINE);
    for (int i = 1; i <= 2; i++)
        wfDrawTextf(d, left + perSecond * (float)i, top + 0.12f, 13, WF_INK_TEXT, 0, "%d s", i);
    for (int i = 1; i <= 2; i++) {
        float y = top - perMetre * 10 * (float)i;
        wfDrawDashed(d, left, y, left + 2 * perSecond, y, 1, WF_INK_FAINT);
        wfDrawTextf(d, left - 0.12f, y - 0.06f, 13, WF_INK_TEXT, 1, "%d m", 10 * i);
    }
    for (int k = 0, n = 4; k < 3; k++, n *= 2) {
        for (int i = 0; i <= n; i++) {
            double t = 2.0 * i / n, s = i > 0 ? tasteFallBySteps(9.81, t, i) : 0;
            xy[2 * i] = left + perSecond * (float)t;
            xy[2 * i + 1] = top - perMetre * (float)s;
        }
        wfDrawPolyline(d, xy, n + 1, 1.5f, ink[k]);
        for (int i = 0; i <= n; i++) wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 5, ink[k]);
        wfDrawTextf(d, xy[2 * n] + 0.15f, xy[2 * n + 1] - 0.08f, 13, ink[k], -1,
                    "%d steps: %.2f m", n, tasteFallBySteps(9.81, 2, n));
    }
    /* <draw Galileo's curve> */
    for (int i = 0; i <= 64; i++) {
        xy[2 * i] = left + perSecond * (float)i / 32;
        xy[2 * i + 1] = top - perMetre * (float)tasteFallExactly(9.81, i / 32.0);
    }
    wfDrawPolyline(d, xy, 65, 2.5f, WF_INK_LINE);
    wfDrawTextf(d, xy[128] + 0.15f, xy[129] - 0.02f, 13, WF_INK_TEXT, -1,
                "Galileo: %.2f m", tasteFallExactly(9.81, 2));
}
/* <figures> */
static void draw_analytic_oracle(wfDraw *d)
{
    wfBodyState ball = { .p = { { 0.3f, 0.9f } }, .v = { { 1.7f, 3.6f } }, .invMass = 1 };
    wfForce weight = wfGravity(wfV2(0, -5));
    wfVec2 start = ball.p, v = ball.v;
    float xy[2 * 33];
    for (int i = 0; i <= 32; i++) {
        float t = 1.4f * (float)i / 32;
        xy[2 * i] = (float)start.x + (float)v.x * t;
        xy[2 * i + 1] = (float)start.y + (float)v.y * t - 2.5f * t * t;
    }
    wfDrawPolyline(d, xy, 33, 2, WF_INK_ACCENT);
    int n = figure_path("verlet", &ball, &weight, 0.2, 7, xy);
    for (int i = 0; i < n; i++) wfDrawPoint(d, xy[2 * i], xy[2 * i + 1], 8, WF_INK_LINE);
    wfDrawText(d, 1.5f, 0.2f, 14, WF_INK_TEXT, 0, "analytic");
}

/* <figures> */
static void draw_algebraic_oracle(wfDraw *d)
{
    wfVec2 o = wfV2(4.6f, 1.3f), arrow = wfV2(1.15f, 0.25f);
    wfRot turn = wfRotation(WF_PI / 3);
    wfVec2 turned = wfRotate(turn, arrow), back = wfRotateInv(turn, turned);
    wfDrawCircle(d, WF_XY(wfAdd(o, back)), 0.14f, 2, WF_INK_GOOD, WF_INK_NONE);
    wfDrawArrow(d, WF_XY(o), WF_XY(wfAdd(o, turned)), 2, WF_INK_FAINT);
    wfDrawArrow(d, WF_XY(o), WF_XY(wfAdd(o, arrow)), 2.5f, WF_INK_ACCENT);
    wfDrawText(d, 4.9f, 2.55f, 13, WF_INK_TEXT, -1, "turned");
    wfDrawText(d, 5.95f, 1.2f, 13, WF_INK_GOOD, -1, "and back");
    wfDrawText(d, 5.1f, 0.2f, 14, WF_INK_TEXT, 0, "algebraic");
}
/* <figures> */
static void draw_box_with_word(wfDraw *d, float x, float y, float width, const char *word)
{
    float box[8] = { x, y, x + width, y, x + width, y + 0.6f, x, y + 0.6f };
    wfDrawPolygon(d, box, 4, 1.5f, WF_INK_LINE, WF_INK_BODY);
    wfDrawText(d, x + width / 2, y + 0.22f, 12, WF_INK_TEXT, 0, word);
}

static void figure_req_oracles(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    draw_analytic_oracle(d);
    draw_algebraic_oracle(d);
    draw_box_with_word(d, 8.1f, 2.2f, 2.2f, "slow, obvious");
    draw_box_with_word(d, 8.1f, 0.8f, 2.2f, "fast, clever");
    wfDrawText(d, 7.4f, 1.74f, 13, WF_INK_TEXT, 0, "input");
    wfDrawArrow(d, 7.5f, 2, 8.0f, 2.4f, 1.5f, WF_INK_ACCENT);
    wfDrawArrow(d, 7.5f, 1.6f, 8.0f, 1.2f, 1.5f, WF_INK_ACCENT);
    wfDrawArrow(d, 10.4f, 2.4f, 10.9f, 2, 1.5f, WF_INK_ACCENT);
    wfDrawArrow(d, 10.4f, 1.2f, 10.9f, 1.6f, 1.5f, WF_INK_ACCENT);
    wfDrawText(d, 11.1f, 1.74f, 13, WF_INK_TEXT, 0, "equal?");
    wfDrawText(d, 9.2f, 0.2f, 14, WF_INK_TEXT, 0, "differential");
}

const wfFigureRow wfFigureTable[] = {
    /* <rows of the figure table> */
    { "design-components", figure_design_components, 8.0f, 5.1f, 0, {{0}} },
    { "design-rows", figure_design_rows, 10.0f, 2.5f, 0, {{0}} },
    { "design-zone", figure_design_zone, 8.2f, 3.1f, 0, {{0}} },
    { "design-pipeline", figure_design_pipeline, 7.5f, 4.9f, 0, {{0}} },
    { "design-tables", figure_design_tables, 8.3f, 3.6f, 0, {{0}} },
    { "design-testbed", figure_design_testbed, 8.0f, 3.8f, 0, {{0}} },
    { "design-backends", figure_design_backends, 8.4f, 3.7f, 0, {{0}} },
    { "design-list", figure_design_list, 9.04f, 1.6f, 0, {{0}} },
    /* <rows of the figure table> */
    { "memory-holes", figure_memory_holes, 9.6f, 5.1f, 0, {{0}} },
    /* <rows of the figure table> */
    { "memory-pool", figure_memory_pool, 10.2f, 2.9f, 0, {{0}} },
    /* <rows of the figure table> */
    { "memory-slots", figure_memory_slots, 9.6f, 3.9f, 0, {{0}} },
    /* <rows of the figure table> */
    { "numbers-cross", figure_numbers_cross, 6.0f, 4.0f, 2, { {4.2f, 1.3f}, {2.4f, 2.9f} } },
    { "numbers-projection", figure_numbers_projection, 6.0f, 4.0f, 2,
      { {2.6f, 3.2f}, {5.2f, 1.5f} } },
    /* <rows of the figure table> */
    { "numbers-rotation", figure_numbers_rotation, 6.0f, 3.4f, 1, { {4.2f, 1.6f} } },
    /* <rows of the figure table> */
    { "numbers-quarters", figure_numbers_quarters, 5.0f, 4.2f, 1, { {1.5f, 3.6f} } },
    /* <rows of the figure table> */
    { "numbers-lattice", figure_numbers_lattice, 5.0f, 3.9f, 1, { {4.6f, 0.45f} } },
    /* <rows of the figure table> */
    { "numbers-transform", figure_numbers_transform, 6.0f, 4.2f, 2,
      { {2.6f, 1.5f}, {3.6f, 2.0f} } },
    /* <rows of the figure table> */
    { "shapes-bounds", figure_shapes_bounds, 6.0f, 4.2f, 1, { { 4.4f, 3.1f } } },
    /* <rows of the figure table> */
    { "shapes-hull", figure_shapes_hull, 8.0f, 5.0f, 8,
      { { 1.0f, 2.2f }, { 2.4f, 0.7f }, { 5.8f, 0.6f }, { 7.0f, 2.4f }, { 6.0f, 4.2f },
        { 3.4f, 4.5f }, { 1.7f, 3.9f }, { 5.7f, 2.4f } } },
    /* <rows of the figure table> */
    { "shapes-rock", figure_shapes_rock, 10.0f, 5.9f, 1, { { 2.1f, 2.7f } } },
    /* <rows of the figure table> */
    { "shapes-tiles", figure_shapes_tiles, 8.0f, 3.6f, 1, { { 3.3f, 1.75f } } },
    /* <rows of the figure table> */
    { "shapes-steiner", figure_shapes_steiner, 8.6f, 5.2f, 1, { { 2.2f, 3.9f } } },
    /* <rows of the figure table> */
    { "shapes-green", figure_shapes_green, 8.0f, 5.0f, 1, { { 1.0f, 0.9f } } },
    /* <rows of the figure table> */
    { "shapes-axis", figure_shapes_axis, 8.0f, 5.0f, 1, { { 1.3f, 1.4f } } },
    /* <rows of the figure table> */
    { "bodies-velocity", figure_bodies_velocity, 8.0f, 5.4f, 1, { { 4.4f, 2.66f } } },
    /* <rows of the figure table> */
    { "bodies-lever", figure_bodies_lever, 7.0f, 5.2f, 1, { { 4.9f, 2.9f } } },
    /* <rows of the figure table> */
    { "bodies-blows", figure_bodies_blows, 10.6f, 4.1f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "forces-point", figure_forces_point, 8.0f, 5.0f, 2, { { 2.8f, 2.6f }, { 6.0f, 3.1f } } },
    /* <rows of the figure table> */
    { "forces-spring", figure_forces_spring, 8.0f, 4.0f, 2,
      { { 1.7f, 1.6f }, { 6.2f, 2.7f } } },
    /* <rows of the figure table> */
    { "forces-float", figure_forces_float, 7.0f, 4.0f, 2, { { 3.5f, 2.1f }, { 5.0f, 2.7f } } },
    /* <rows of the figure table> */
    { "forces-coat", figure_forces_coat, 7.0f, 4.0f, 1, { { 3.5f, 1.95f } } },
    /* <rows of the figure table> */
    { "forces-float-time", figure_forces_float_time, 10.0f, 5.2f, 0, { { 0, 0 } } },
    /* <rows of the figure table> */
    { "forces-wind", figure_forces_wind, 8.0f, 4.2f, 1, { { 1.0f, 2.4f } } },
    /* <rows of the figure table> */
    { "forces-blast", figure_forces_blast, 10.0f, 3.7f, 1, { { 1.1f, 0.4f } } },
    /* <rows of the figure table> */
    { "int-orbits", figure_int_orbits, 8.0f, 5.2f, 1, { { 5.0f, 2.6f } } },
    /* <rows of the figure table> */
    { "int-step", figure_int_step, 8.0f, 5.5f, 1, { { 4.6f, 0.3f } } },
    { "int-step-spring", figure_int_step_spring, 8.0f, 5.5f, 1, { { 4.2f, 0.3f } } },
    /* <rows of the figure table> */
    { "int-area", figure_int_area, 8.0f, 5.2f, 1, { { 5.2f, 2.6f } } },
    /* <rows of the figure table> */
    { "int-quadrature", figure_int_quadrature, 10.0f, 3.0f, 0, { { 0, 0 } } },
    /* <rows of the figure table> */
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
    { "broad-missed", figure_broad_missed, 8.0f, 5.0f, 2, { { 4.3f, 3.7f }, { 5.3f, 4.0f } } },
    /* <rows of the figure table> */
    { "narrow-shadows", figure_narrow_shadows, 9.0f, 6.4f, 1, { { 5.5f, 4.4f } } },
    { "narrow-nested", figure_narrow_nested, 10.0f, 4.4f, 0, { { 0 } } },
    { "narrow-false", figure_narrow_false, 8.0f, 7.0f, 1, { { 5.0f, 5.2f } } },
    { "narrow-minkowski", figure_narrow_minkowski, 9.5f, 5.0f, 1, { { 2.7f, 2.7f } } },
    { "narrow-tie", figure_narrow_tie, 5.0f, 4.6f, 1, { { 3.4f, 3.0f } } },
    { "narrow-coats", figure_narrow_coats, 8.0f, 6.1f, 1, { { 5.9f, 4.7f } } },
    { "narrow-regions", figure_narrow_regions, 7.0f, 5.2f, 1, { { 5.2f, 3.4f } } },
    /* <rows of the figure table> */
    { "narrow-simplex", figure_narrow_simplex, 7.0f, 4.8f, 1, { { 5.2f, 3.4f } } },
    { "narrow-gjk", figure_narrow_gjk, 14.2f, 7.6f, 1, { { 3.3f, 4.7f } } },
    { "narrow-epa", figure_narrow_epa, 13.6f, 7.4f, 1, { { 2.5f, 3.5f } } },
    /* <rows of the figure table> */
    { "contacts-coats", figure_contacts_coats, 14.6f, 3.9f, 1, { { 3.1f, 2.48f } } },
    { "contacts-margin", figure_contacts_margin, 8.0f, 2.8f, 0, { { 0 } } },
    { "contacts-ghost", figure_contacts_ghost, 12.0f, 3.0f, 1, { { 2.07f, 1.72f } } },
    { "contacts-gauss", figure_contacts_gauss, 12.0f, 3.6f, 3,
      { { 5.9f, 1.9f }, { 4.2f, 0.8f }, { 2.2f, 2.1f } } },
    { "contacts-kinds", figure_contacts_kinds, 12.0f, 3.9f, 0, { { 0 } } },
    { "contacts-report", figure_contacts_report, 10.0f, 4.0f, 0, { { 0 } } },
    { "contacts-clip", figure_contacts_clip, 7.0f, 5.0f, 1, { { 4.5f, 3.05f } } },
    /* <rows of the figure table> */
    { "impulses-discs", figure_impulses_discs, 8.0f, 4.6f, 1, { { 3.6f, 1.9f } } },
    /* <rows of the figure table> */
    { "impulses-corner", figure_impulses_corner, 6.0f, 3.6f, 1, { { 4.0f, 0.3f } } },
    /* <rows of the figure table> */
    { "impulses-step", figure_impulses_step, 8.0f, 5.0f, 1, { { 4.6f, 0.3f } } },
    /* <rows of the figure table> */
    { "friction-cone", figure_friction_cone, 8.0f, 3.6f, 1, { { 6.6f, 1.0f } } },
    /* <rows of the figure table> */
    { "sequential-path", figure_sequential_path, 6.8f, 5.2f, 1, { { 5.2f, 3.6f } } },
    /* <rows of the figure table> */
    { "sequential-passes", figure_sequential_passes, 8.0f, 5.4f, 1, { { 3.6f, 0.3f } } },
    /* <rows of the figure table> */
    { "soft-gather", figure_soft_gather, 12.4f, 5.2f, 0, {{0}} },
    { "soft-sag", figure_soft_sag, 8.0f, 5.6f, 1, { { 1.2f, 0.3f } } },
    { "soft-path", figure_soft_path, 7.8f, 3.2f, 1, { { 0.3f, 2.2f } } },
    /* <rows of the figure table> */
    { "joints-kinds", figure_joints_kinds, 12.4f, 10.4f, 0, {{0}} },
    /* <rows of the figure table> */
    { "joints-aim", figure_joints_aim, 5.6f, 3.6f, 0, {{0}} },
    /* <rows of the figure table> */
    { "joints-step", figure_joints_step, 8.0f, 5.6f, 1, { { 5.4f, 0.3f } } },
    /* <rows of the figure table> */
    { "exact-arch", figure_exact_arch, 8.0f, 4.4f, 1, { { 0.0f, 3.13f } } },
    /* <rows of the figure table> */
    { "compound-hull", figure_compound_hull, 8.0f, 3.6f, 1, { { 2.15f, 2.2f } } },
    { "compound-l", figure_compound_l, 8.0f, 4.1f, 1, { { 3.6f, 0.9f } } },
    { "compound-sign", figure_compound_sign, 7.5f, 3.8f, 0, { { 0 } } },
    { "compound-ears", figure_compound_ears, 12.0f, 3.2f, 0, { { 0 } } },
    { "compound-merge", figure_compound_merge, 12.0f, 3.0f, 1, { { 3.2f, 1.8f } } },
    { "compound-gallery", figure_compound_gallery, 10.8f, 2.6f, 0, { { 0 } } },
    { "compound-chain", figure_compound_chain, 8.0f, 4.0f, 1, { { 5.2f, 1.3f } } },
    /* <rows of the figure table> */
    { "impact-tunnel", figure_impact_tunnel, 8.4f, 3.0f, 0, { { 0 } } },
    { "impact-rod", figure_impact_rod, 6.4f, 4.6f, 1, { { 3.5f, 3.4f } } },
    { "impact-steps", figure_impact_steps, 8.2f, 5.4f, 1, { { 6.2f, 1.3f } } },
    { "impact-graph", figure_impact_graph, 9.6f, 6.4f, 0, { { 0 } } },
    { "impact-bound", figure_impact_bound, 9.8f, 4.6f, 0, { { 0 } } },
    { "impact-curve", figure_impact_curve, 8.2f, 4.1f, 0, { { 0 } } },
    { "impact-core", figure_impact_core, 9.8f, 2.3f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "islands-heaps", figure_islands_heaps, 18.2f, 4.2f, 1, { { 9.15f, 1.3f } } },
    /* <rows of the figure table> */
    { "queries-fan", figure_queries_fan, 12.0f, 7.2f, 1, { { 5.6f, 3.6f } } },
    { "queries-disk", figure_queries_disk, 9.4f, 4.4f, 1, { { 0.8f, 0.7f } } },
    { "queries-closest", figure_queries_closest, 12.0f, 7.2f, 1, { { 5.6f, 3.4f } } },
    { "queries-corner", figure_queries_corner, 7.2f, 5.6f, 0, { { 0 } } },
    { "queries-timeline", figure_queries_timeline, 11.0f, 4.0f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "world-block", figure_world_block, 11.4f, 6.1f, 0, {{0}} },
    /* <rows of the figure table> */
    { "world-three", figure_world_three, 10.7f, 8.6f, 0, {{0}} },
    /* <rows of the figure table> */
    { "world-ids", figure_world_ids, 9.6f, 3.6f, 0, {{0}} },
    /* <rows of the figure table> */
    { "world-stages", figure_world_stages, 17.4f, 12.3f, 0, {{0}} },
    /* <rows of the figure table> */
    { "fast-legs", figure_fast_legs, 6.6f, 3.6f, 1, { { 1.5f, 1.0f } } },
    /* <rows of the figure table> */
    { "joined-machines", figure_joined_machines, 16.4f, 7.6f, 0, {{0}} },
    /* <rows of the figure table> */
    { "sleep-stacks", figure_sleep_stacks, 19.2f, 6.0f, 0, {{0}} },
    { "sleep-floating", figure_sleep_floating, 12.4f, 4.8f, 0, {{0}} },
    /* <rows of the figure table> */
    { "save-used", figure_save_used, 10.0f, 5.4f, 0, {{0}} },
    /* <rows of the figure table> */
    { "save-ring", figure_save_ring, 10.0f, 2.7f, 0, {{0}} },
    /* <rows of the figure table> */
    { "save-journal", figure_save_journal, 10.0f, 4.2f, 0, {{0}} },
    /* <rows of the figure table> */
    { "save-digits", figure_save_digits, 10.0f, 3.5f, 0, {{0}} },
    /* <rows of the figure table> */
    { "platform-service", figure_platform_service, 8.9f, 4.8f, 0, { { 0 } } },
    { "platform-clock", figure_platform_clock, 8.1f, 3.1f, 0, { { 0 } } },
    { "platform-spiral", figure_platform_spiral, 11.2f, 5.8f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "drawing-stages", figure_drawing_stages, 10.35f, 1.6f, 0, {{0}} },
    { "drawing-distance", figure_drawing_distance, 11.0f, 7.0f, 2,
      {{2.3f, 2.1f}, {8.6f, 4.9f}} },
    { "drawing-roles", figure_drawing_roles, 9.2f, 1.6f, 0, {{0}} },
    { "drawing-jagged", figure_drawing_jagged, 30.0f, 10.0f, 2, {{1.2f, 1.7f}, {12.6f, 6.9f}} },
    { "drawing-edge", figure_drawing_edge, 10.0f, 3.9f, 2, {{3.7f, 2.1f}, {5.2f, 3.1f}} },
    { "drawing-polygon", figure_drawing_polygon, 14.0f, 10.0f, 3,
      {{1.5f, 1.2f}, {12.7f, 3.4f}, {5.2f, 9.1f}} },
    { "drawing-error", figure_drawing_error, 7.6f, 4.7f, 0, {{0}} },
    { "drawing-blend", figure_drawing_blend, 6.4f, 4.9f, 0, {{0}} },
    /* <rows of the figure table> */
    { "scenes-tape", figure_scenes_tape, 10, 3.5f, 0, { { 0 } } },
    { "scenes-wall", figure_scenes_wall, 18, 6.6f, 0, { { 0 } } },
    { "scenes-window", figure_scenes_window, 11, 7, 0, { { 0 } } },
    { "scenes-motion", figure_scenes_motion, 8.4f, 3.2f, 0, { { 0 } } },
    { "scenes-forces", figure_scenes_forces, 8.4f, 6.4f, 0, { { 0 } } },
    { "scenes-classics", figure_scenes_classics, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-solvers", figure_scenes_solvers, 15.2f, 16.6f, 0, { { 0 } } },
    { "scenes-collision", figure_scenes_collision, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-joints", figure_scenes_joints, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-fast", figure_scenes_fast, 12.6f, 3.2f, 0, { { 0 } } },
    { "scenes-cases", figure_scenes_cases, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-hand", figure_scenes_hand, 8.9f, 4.4f, 0, { { 0 } } },
    { "scenes-axis", figure_scenes_axis, 12.4f, 8.4f, 0, { { 0 } } },
    { "scenes-tree", figure_scenes_tree, 10.6f, 6.8f, 0, { { 0 } } },
    { "scenes-integrators", figure_scenes_integrators, 12.6f, 9.4f, 0, { { 0 } } },
    { "scenes-buoyancy", figure_scenes_buoyancy, 16.4f, 7.2f, 0, { { 0 } } },
    { "scenes-camera", figure_scenes_camera, 11.6f, 4.8f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "accuracy-choice", figure_accuracy_choice, 7.0f, 5.2f, 1, { { 6.2f, 3.0f } } },
    /* <rows of the figure table> */
    { "primer-pipeline", figure_primer_pipeline, 13.65f, 2.3f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "intro-crates", figure_intro_crates, 12.2f, 3.4f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "intro-fall", figure_intro_fall, 10.1f, 6.5f, 0, { { 0 } } },
    /* <rows of the figure table> */
    { "req-oracles", figure_req_oracles, 11.8f, 3.3f, 0, { { 0 } } },
};
const int wfFigureCount = (int)(sizeof wfFigureTable / sizeof *wfFigureTable);

/* <find a figure and draw it> */
int wfFindFigure(const char *name)
{
    for (int i = 0; i < wfFigureCount; i++)
        if (strcmp(wfFigureTable[i].name, name) == 0) return i;
    return -1;
}

void wfDrawFigure(const wfFigureRow *row, const wfFigureInput *in, wfDraw *d)
{
    wfFigureInput frozen = { .time = 0, .handleCount = row->handleCount };
    memcpy(frozen.handle, row->handle, sizeof frozen.handle);
    wfDrawReset(d);
    wfDrawView(d, 0, 0, row->width, row->height);
    row->draw(d, in ? in : &frozen);
}
