/* Weft: figures/headless.c, tangled from chapters/testbed/16-headless.figures.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "testbed/hand.h"
#include "testbed/scene.h"
#include "testbed/view.h"
#include "testbed/layout.h"
#include "testbed/camera.h"
#include "figures/kit.h"

/* by the testbed's own calls: if a scene changes, its picture does */
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
    wfShowWorld(&world, show, &scratch, d);
    if (scene->draw) scene->draw(&world, d, &in);
    wfDestroyWorld(&world);
}

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

static void figure_scenes_solvers(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -2.6f, -8.2f, 17.6f, 5.8f);
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

/* those test cases that can be told from a still picture */
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
static void figure_scenes_window(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    static const char *const button[] = {
        "List", "Tools", "Pause", "Step", "Reset", "Previous", "Next", "Home", "Dark",
        "Keys", "Settings", "Hand", "Place", "Draw", "Pin", "Connect", "Lasso", "Delete",
        "Probe" };
    const wfScene *s = wfSceneAt(wfFindScene("shapes"));
    camera c = { (float)s->viewX, (float)s->viewY, (float)s->viewHeight, LIST_WIDTH, HEAD,
                 1100 - LIST_WIDTH, 700 - HEAD - FOOT - TIME_BAR, 0 };
    float view[4];
    camera_window(&c, 1100, 700, view);
    wfDrawView(d, view[0], view[1], view[2], view[3]);
    draw_scene(d, s->name, 100, 0);
    window_box(d, &c, -2, -2, 1104, HEAD, WF_INK_PAPER);
    window_box(d, &c, -2, 700 - FOOT + 2, 1104, FOOT, WF_INK_PAPER);
    window_list(d, &c, s->name);
    /* draw the buttons of the bar */
    for (int i = 0; i < 19; i++) {
        float x = 224 + 62 * (float)(i % 11), y = 10 + BAR_ROW * (float)(i / 11);
        window_box(d, &c, x, y, 56, 24, WF_INK_PAPER);
        window_text(d, &c, x + 28, y + 17, WF_INK_TEXT, 0, button[i]);
    }
    window_text(d, &c, 224, HEAD - 32, WF_INK_TEXT, -1, s->name);
    window_text(d, &c, 224, HEAD - 12, WF_INK_TEXT, -1, s->text);
    window_text(d, &c, 224, 675, WF_INK_TEXT, -1, "running, step 100, 1.67 s, ...");
    window_box(d, &c, 1, 1, 1098, 698, WF_INK_NONE);
    /* mark the parts of the window by letters */
    static const struct { const char *letter; float x, y; } mark[] = {
        { "A", 170, 200 }, { "B", 188, 582 }, { "C", 922, 22 }, { "D", 680, 96 },
        { "E", 650, 180 }, { "F", 470, 674 }
    };
    for (int i = 0; i < 6; i++)
        window_mark(d, &c, mark[i].x, mark[i].y, mark[i].letter);
}
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

static void figure_scenes_camera(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    camera c = { 2.7f, 2.4f, 2, 1, 0.5f, 4, 2.5f, 0 };
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

/* eq:hand-velocity with 1 + 2 zeta w h + w^2 h^2 below the line */
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
static void figure_scenes_hand(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    wfDrawView(d, -0.2f, 0, 8.9f, 4.4f);
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

static void tape_box(wfDraw *d, float x, float y, float w, int fill, const char *name)
{
    float xy[] = { x, y, x + w, y, x + w, y + 0.7f, x, y + 0.7f };
    wfDrawPolygon(d, xy, 4, 1.5f, WF_INK_LINE, fill);
    wfDrawText(d, x + w / 2, y + 0.25f, 13, WF_INK_TEXT, 0, name);
}

static void figure_scenes_tape(wfDraw *d, const wfFigureInput *in)
{
    (void)in;
    /* what the journal of the figure holds */
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
static const wfFigureRow rows[] = {
    { "scenes-tape", figure_scenes_tape, 10, 3.5f, 0, { { 0 } } },
    { "scenes-wall", figure_scenes_wall, 18, 6.6f, 0, { { 0 } } },
    { "scenes-window", figure_scenes_window, 11, 7, 0, { { 0 } } },
    { "scenes-motion", figure_scenes_motion, 8.4f, 3.2f, 0, { { 0 } } },
    { "scenes-forces", figure_scenes_forces, 8.4f, 6.4f, 0, { { 0 } } },
    { "scenes-classics", figure_scenes_classics, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-solvers", figure_scenes_solvers, 20.2f, 14.0f, 0, { { 0 } } },
    { "scenes-collision", figure_scenes_collision, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-joints", figure_scenes_joints, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-fast", figure_scenes_fast, 12.6f, 3.2f, 0, { { 0 } } },
    { "scenes-cases", figure_scenes_cases, 8.4f, 9.6f, 0, { { 0 } } },
    { "scenes-hand", figure_scenes_hand, 9.1f, 4.4f, 0, { { 0 } } },
    { "scenes-axis", figure_scenes_axis, 12.4f, 8.4f, 0, { { 0 } } },
    { "scenes-tree", figure_scenes_tree, 10.6f, 6.8f, 0, { { 0 } } },
    { "scenes-integrators", figure_scenes_integrators, 12.6f, 9.4f, 0, { { 0 } } },
    { "scenes-buoyancy", figure_scenes_buoyancy, 16.4f, 7.2f, 0, { { 0 } } },
    { "scenes-camera", figure_scenes_camera, 11.6f, 4.8f, 0, { { 0 } } },
};
const wfFigureSet headless_figures = WF_ROWS(rows);
