/* Weft: testbed/raster.c, tangled from chapters/testbed/03-drawing-pixels.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "weft/math.h"
#include "testbed/raster.h"

/* begin and clear a row of coverage */
void wfCoverBegin(wfCoverRow *row, int32_t y, int32_t x0, int32_t width)
{
    row->y = y;
    row->x0 = x0;
    row->width = width < 0 ? 0 : width > WF_COVER_WIDTH ? WF_COVER_WIDTH : width;
    row->low = 0;
    row->high = row->width;
    wfCoverClear(row);
}

void wfCoverClear(wfCoverRow *row)
{
    if (row->high > row->low)
        memset(row->at + row->low, 0, sizeof *row->at * (size_t)(row->high - row->low));
    row->low = row->width;
    row->high = 0;
    row->fullLow = row->fullHigh = 0;
}

static void touch(wfCoverRow *row, int32_t low, int32_t high)
{
    if (low < row->low) row->low = low;
    if (high > row->high) row->high = high;
}

/* These cells are full. The longest such run is remembered. */
static void fill_run(wfCoverRow *row, int32_t low, int32_t high)
{
    for (int32_t i = low; i < high; i++) row->at[i] = 1;
    if (high - low <= row->fullHigh - row->fullLow) return;
    row->fullLow = low;
    row->fullHigh = high;
}

static float clamp01(float x)
{
    float above = x > 0 ? x : 0;
    return above < 1 ? above : 1;
}

/* The integer part of x, kept within low..high; x may be any number but NaN. */
static int32_t floor_within(float x, int32_t low, int32_t high)
{
    if (x <= (float)low) return low;
    if (x >= (float)high) return high;
    int32_t i = (int32_t)x;
    return (float)i > x ? i - 1 : i;
}

/* From (x, y) by (dx, dy), in pixels; slope is dx / dy, and u the direction of a line. */
typedef struct side { double x, y, dx, dy, slope; float ux, uy; } side;

static side make_side(const float from[2], const float to[2], bool line)
{
    side s = { .x = (double)from[0], .y = (double)from[1] };
    s.dx = (double)to[0] - s.x;
    s.dy = (double)to[1] - s.y;
    if (s.dy != 0) s.slope = s.dx / s.dy;
    if (!line) return s;
    float dx = (float)s.dx, dy = (float)s.dy, length = (float)wfLength(wfV2(dx, dy));
    if (length > 0) s.ux = dx / length, s.uy = dy / length;
    return s;
}

/* A piece of an edge from pixel xa to xb, both within the row, dy high. */
static void cover_piece(wfCoverRow *row, float xa, float xb, float dy)
{
    int32_t step = xb >= xa ? 1 : -1;
    int32_t i = floor_within(xa, 0, row->width), last = floor_within(xb, 0, row->width);
    float slope = xb != xa ? dy / (xb - xa) : 0, x = xa;
    touch(row, i < last ? i : last, (i > last ? i : last) + 2);
    for (;; i += step) {
        float next = i == last ? xb : (float)(step > 0 ? i + 1 : i);
        float part = xb != xa ? slope * (next - x) : dy;
        float right = 0.5f * (x + next) - (float)i;         /* eq:draw-edge */
        row->at[i] += part * (1 - right);
        row->at[i + 1] += part * right;
        if (i == last) break;
        x = next;
    }
}

static double within(double x, double low, double high)
{
    return x < low ? low : x > high ? high : x;
}

/* An edge's part in the row, dy high, from xa to xb, which may lie outside the row. */
static void cover_edge(wfCoverRow *row, double xa, double xb, double dy)
{
    double limit = row->width, ca = within(xa, 0, limit), cb = within(xb, 0, limit);
    double low = xa < xb ? xa : xb, high = xa < xb ? xb : xa;
    if (high >= limit) touch(row, row->width, row->width);
    if (low >= limit) return;
    double left = high <= 0 ? 1 : low < 0 ? -low / (high - low) : 0;
    double kept = ca < cb ? cb - ca : ca - cb;
    double inside = high <= 0 ? 0 : kept < high - low ? kept / (high - low) : 1;
    if (left > 0) {
        row->at[0] += (float)(dy * left);
        touch(row, 0, 1);
    }
    if (inside > 0) cover_piece(row, (float)ca, (float)cb, (float)(dy * inside));
}

static void add_up(wfCoverRow *row)
{
    float sum = 0;
    for (int32_t i = row->low; i < row->high; i++) {
        sum += row->at[i];
        row->at[i] = clamp01(sum > -sum ? sum : -sum);      /* eq:draw-sum */
        if (row->at[i] < 1 - 1e-6f) continue;
        int32_t end = i + 1;
        while (end < row->high && row->at[end] == 0) end++;
        fill_run(row, i + 1, end);
        i = end - 1;
    }
    if (row->high > row->width) row->high = row->width;
    if (row->fullHigh > row->width) row->fullHigh = row->width;
}

static void cover_side(wfCoverRow *row, const side *s)
{
    double top = row->y, bottom = top + 1, x = s->x - row->x0;
    double ya = within(s->y, top, bottom), yb = within(s->y + s->dy, top, bottom);
    if (ya != yb)
        cover_edge(row, x + (ya - s->y) * s->slope, x + (yb - s->y) * s->slope, yb - ya);
}

void wfCoverPolygon(wfCoverRow *row, wfPixelMap map, const float *xy, int count)
{
    for (int i = 0, j = count - 1; i < count; j = i++) {
        side s = make_side((float[2]){ wfPixelX(map, xy[2 * j]),
                                       wfPixelY(map, xy[2 * j + 1]) },
                           (float[2]){ wfPixelX(map, xy[2 * i]),
                                       wfPixelY(map, xy[2 * i + 1]) }, false);
        cover_side(row, &s);
    }
    add_up(row);
}

/* cover a line */
static float at_most_1(float x) { return x > 1 ? 1 : x; }

static float band(float distance, float half)             /* eq:draw-band */
{
    float hole = half < 0.5f ? clamp01(0.5f - half - distance) : 0;
    return at_most_1(0.5f + half - distance) - hole;
}

static void greater(wfCoverRow *row, int32_t i, float cover)
{
    float there = row->at[i];
    row->at[i] = cover > there ? cover : there;
}

/* The range of t for which p + t d lies within low..high; false when there is none. */
static bool clip_range(double p, double d, double low, double high, double *t0, double *t1)
{
    if (d == 0) return p >= low && p <= high;
    double a = (low - p) / d, b = (high - p) / d;  /* eq:draw-clip */
    double first = a < b ? a : b, last = a < b ? b : a;
    if (first > *t0) *t0 = first;
    if (last < *t1) *t1 = last;
    return *t0 <= *t1;
}

/* The part of a side within reach of the row: its ends a, b from the row's first centre. */
static bool near_row(const wfCoverRow *row, const side *s, double reach, float a[2],
                     float b[2])
{
    double x = s->x - row->x0 - 0.5, y = s->y - row->y - 0.5, t0 = 0, t1 = 1;
    double ya = within(y, -reach, reach), yb = within(y + s->dy, -reach, reach);
    if (ya == yb && (s->dy != 0 || y != ya)) return false;
    double xa = x + (ya - y) * s->slope, dx = s->dy != 0 ? (yb - ya) * s->slope : s->dx;
    double high = row->width + reach, xb = xa + dx, dy = yb - ya;
    if (xa < -reach || xb < -reach || xa > high || xb > high) {
        if (!clip_range(xa, dx, -reach, high, &t0, &t1)) return false;
        xb = xa + t1 * dx, yb = ya + t1 * dy;
        xa += t0 * dx, ya += t0 * dy;
    }
    a[0] = (float)xa, a[1] = (float)ya;
    b[0] = (float)xb, b[1] = (float)yb;
    return true;
}

static void cover_stroke(wfCoverRow *row, const side *s, float half)
{
    float a[2], b[2], reach = half + 0.5f, ux = s->ux, uy = s->uy;
    if (!near_row(row, s, (double)reach, a, b)) return;
    float low = (a[0] < b[0] ? a[0] : b[0]) - reach;
    float high = (a[0] < b[0] ? b[0] : a[0]) + reach;
    int32_t first = floor_within(low, 0, row->width);
    int32_t last = floor_within(high + 1, 0, row->width);
    float length = (b[0] - a[0]) * ux + (b[1] - a[1]) * uy;
    touch(row, first, last);
    for (int32_t i = first; i < last; i++) {
        /* find the distance from the line by eq:draw-nearest */
        float along = ((float)i - a[0]) * ux - a[1] * uy;
        along = along > 0 ? along : 0;
        along = along < length ? along : length;
        float x = (float)i - a[0] - along * ux, y = -a[1] - along * uy;
        greater(row, i, band((float)wfSqrt(x * x + y * y), half));
    }
}

void wfCoverLine(wfCoverRow *row, const float from[2], const float to[2], float half)
{
    side s = make_side(from, to, true);
    cover_stroke(row, &s, half);
}

/* The pixels of the row whose centres are at most reach from (x, y): first to last - 1. */
static bool reach_range(const wfCoverRow *row, float x, float y, float reach,
                        int32_t *first, int32_t *last)
{
    float dy = (float)row->y + 0.5f - y;
    if (!(dy * dy < reach * reach)) return false;
    float half = (float)wfSqrt(reach * reach - dy * dy), middle = x - (float)row->x0 - 0.5f;
    *first = floor_within(middle - half, 0, row->width);
    *last = floor_within(middle + half + 1, 0, row->width);
    return *first < *last;
}

static float distance_to(const wfCoverRow *row, int32_t i, float x, float y)
{
    float dx = (float)(row->x0 + i) + 0.5f - x, dy = (float)row->y + 0.5f - y;
    return (float)wfSqrt(dx * dx + dy * dy);
}

/* The run of pixels whose centres are nearer than reach; at last when there is none. */
static void inner_range(const wfCoverRow *row, float x, float y, float reach, int32_t last,
                        int32_t inner[2])
{
    bool any = reach > 0 && reach_range(row, x, y, reach, &inner[0], &inner[1]);
    if (any) inner[0]++;
    if (!any || inner[0] >= inner[1]) inner[0] = inner[1] = last;
}

static int32_t next_outside(int32_t i, const int32_t inner[2])
{
    return i + 1 == inner[0] ? inner[1] : i + 1;
}

void wfCoverDisc(wfCoverRow *row, float x, float y, float radius)
{
    int32_t first, last, inner[2];
    float squared = radius * radius;
    bool large = squared > 1.0f / 3;                        /* eq:draw-disc */
    float edge = large ? (float)wfSqrt(squared - 1.0f / 12) : 0.5f;
    float strength = large ? 1 : 3 * squared;
    if (!reach_range(row, x, y, edge + 0.5f, &first, &last)) return;
    inner_range(row, x, y, edge - 0.5f, last, inner);
    touch(row, first, last);
    fill_run(row, inner[0], inner[1]);
    for (int32_t i = first; i < last; i = next_outside(i, inner))
        greater(row, i, strength * clamp01(0.5f + edge - distance_to(row, i, x, y)));
}

void wfCoverRing(wfCoverRow *row, float x, float y, float radius, float half)
{
    int32_t first, last, inner[2];
    if (!reach_range(row, x, y, radius + half + 0.5f, &first, &last)) return;
    inner_range(row, x, y, radius - half - 0.5f, last, inner);
    touch(row, first, last);
    for (int32_t i = first; i < last; i = next_outside(i, inner)) {
        float off = distance_to(row, i, x, y) - radius;
        greater(row, i, band(off > -off ? off : -off, half));
    }
}

/* The light of one ink, laid over a pixel; share is 0..1. */
typedef struct ink_light { float light[3], alpha; } ink_light;

static ink_light light_of(wfInk ink)
{
    float r = (float)ink.r, g = (float)ink.g, b = (float)ink.b;
    return (ink_light){ { r * r, g * g, b * b }, (float)ink.a / 255 };
}

static uint8_t mixed(float old, float new_light, float share)
{
    float light = old * old + share * (new_light - old * old);     /* eq:draw-blend */
    return (uint8_t)(int32_t)((float)WF_NATIVE_SQRT(light) + 0.5f);
}

static void lay_over(uint8_t pixel[4], const ink_light *ink, float share)
{
    share *= ink->alpha;
    pixel[0] = mixed((float)pixel[0], ink->light[0], share);
    pixel[1] = mixed((float)pixel[1], ink->light[1], share);
    pixel[2] = mixed((float)pixel[2], ink->light[2], share);
    pixel[3] = 255;
}

void wfBlend(uint8_t pixel[4], wfInk ink, float share)
{
    ink_light light = light_of(ink);
    lay_over(pixel, &light, clamp01(share));
}

void wfBlendLetter(uint8_t pixel[4], wfInk ink, float share)
{
    const uint8_t above[3] = { ink.r, ink.g, ink.b };
    share = clamp01(share) * (float)ink.a / 255;
    for (int k = 0; k < 3; k++) {
        float old = (float)pixel[k];
        float mixed = old + share * ((float)above[k] - old);  /* eq:draw-letter */
        pixel[k] = (uint8_t)(mixed + 0.5f);
    }
    pixel[3] = 255;
}

static uint32_t word_of(wfInk ink)                      /* the pixel, opaque */
{
    const uint8_t bytes[4] = { ink.r, ink.g, ink.b, 255 };
    uint32_t word;
    memcpy(&word, bytes, sizeof word);
    return word;
}

static void blend_cells(uint32_t *pixel, const wfCoverRow *row, int32_t i, int32_t end,
                        const ink_light *ink, uint32_t full)
{
    for (; i < end; i++) {
        float share = row->at[i];
        if (share < 1.0f / 512) continue;
        if (share > 511.0f / 512 && ink->alpha == 1) pixel[i] = full;
        else lay_over((uint8_t *)(pixel + i), ink, share);
    }
}

static void blend_row(frame_buffer *target, const wfCoverRow *row, const ink_light *ink,
                      uint32_t full)
{
    uint32_t *pixel = target->pixels + (size_t)row->y * (size_t)target->pitch
                    + (size_t)row->x0;
    int32_t low = row->fullLow, high = row->fullHigh;
    if (low >= high || ink->alpha != 1) low = high = row->high;
    blend_cells(pixel, row, row->low, low, ink, full);
    for (int32_t i = low; i < high; i++) pixel[i] = full;
    blend_cells(pixel, row, high, row->high, ink, full);
}

/* Rows top to bottom - 1 of a picture: what one thread paints. */
typedef struct strip { frame_buffer *of; int32_t top, bottom; } strip;

/* What one row after another is asked to cover. */
typedef struct stencil {
    enum { FILL, STROKE, DISC, RING } kind;
    wfPixelMap map;
    const float *xy;       /* points, brought to pixels by the map */
    int count;
    bool closed;           /* STROKE: back to the first point */
    float radius, half;    /* px */
} stencil;

enum { MOST_SIDES = 64 };

static side side_of(const stencil *s, int i)            /* from point i to the next */
{
    const float *a = s->xy + 2 * i, *b = i + 1 < s->count ? a + 2 : s->xy;
    float from[2] = { wfPixelX(s->map, a[0]), wfPixelY(s->map, a[1]) };
    float to[2] = { wfPixelX(s->map, b[0]), wfPixelY(s->map, b[1]) };
    return make_side(from, to, s->kind == STROKE);
}

static void cover(wfCoverRow *row, const stencil *s, const side *ready, int sides)
{
    if (sides == 0) {
        float x = wfPixelX(s->map, s->xy[0]), y = wfPixelY(s->map, s->xy[1]);
        if (s->kind == DISC) wfCoverDisc(row, x, y, s->radius);
        else wfCoverRing(row, x, y, s->radius, s->half);
    }
    for (int i = 0; i < sides; i++) {
        side made;
        const side *p = ready + i;
        if (sides > MOST_SIDES) made = side_of(s, i), p = &made;
        if (s->kind == FILL) cover_side(row, p);
        else cover_stroke(row, p, s->half);
    }
    if (s->kind == FILL) add_up(row);
}

/* The pixels that a stencil may touch, cut to the strip: x0, y0, x1, y1. */
static void stencil_box(const stencil *s, const strip *target, int32_t box[4])
{
    float low[2] = { 1e30f, 1e30f }, high[2] = { -1e30f, -1e30f };
    for (int i = 0; i < s->count; i++) {
        float p[2] = { wfPixelX(s->map, s->xy[2 * i]), wfPixelY(s->map, s->xy[2 * i + 1]) };
        for (int k = 0; k < 2; k++) {
            if (p[k] < low[k]) low[k] = p[k];
            if (p[k] > high[k]) high[k] = p[k];
        }
    }
    float reach = s->radius + s->half + 1;
    for (int k = 0; k < 2; k++) {
        int32_t first = k == 0 ? 0 : target->top;
        int32_t end = k == 0 ? target->of->width : target->bottom;
        box[k] = floor_within(low[k] - reach, first, end);
        box[k + 2] = floor_within(high[k] + reach + 1, first, end);
    }
}

/* Rows above rows[0] and below rows[1] are all alike; none but in an upright rectangle. */
static void rows_alike(const stencil *s, const side *p, int sides, float rows[2])
{
    bool upright = sides == 4 && s->count == 4;
    for (int i = 0; i < 4 && upright; i++) upright = p[i].dx == 0 || p[i].dy == 0;
    float a = upright ? (float)p[0].y : 0;
    float b = upright ? (float)p[p[1].dy != 0 ? 2 : 1].y : 0;
    rows[0] = (a < b ? a : b) + s->half + 2;
    rows[1] = (a < b ? b : a) - s->half - 2;
}

static void paint(const strip *target, const stencil *s, wfInk ink)
{
    wfCoverRow row;
    side ready[MOST_SIDES];
    int32_t box[4];
    float alike[2];
    ink_light light = light_of(ink);
    uint32_t full = word_of(ink);
    bool round = s->kind == DISC || s->kind == RING, open = s->kind == STROKE && !s->closed;
    int sides = round ? 0 : s->count - open;
    stencil_box(s, target, box);
    if (box[0] >= box[2] || box[1] >= box[3]) return;
    for (int i = 0; i < sides && sides <= MOST_SIDES; i++) ready[i] = side_of(s, i);
    rows_alike(s, ready, sides, alike);
    for (int32_t x = box[0]; x < box[2]; x += WF_COVER_WIDTH) {
        wfCoverBegin(&row, 0, x, box[2] - x);
        for (row.y = box[1]; row.y < box[3]; row.y++) {
            float y = (float)row.y;
            if (row.y == box[1] || y <= alike[0] || y >= alike[1]) {
                wfCoverClear(&row);
                cover(&row, s, ready, sides);
            }
            blend_row(target->of, &row, &light, full);
        }
    }
}

static void paint_arrow(const strip *target, const stencil *shaft, wfInk ink)
{
    const float *xy = shaft->xy;
    wfPixelMap m = shaft->map, same = { 1, 0, 0 };
    float x0 = wfPixelX(m, xy[0]), y0 = wfPixelY(m, xy[1]);
    wfArrow a = wfMakeArrow(x0, y0, wfPixelX(m, xy[2]), wfPixelY(m, xy[3]),
                            2 * shaft->half);
    float line[4] = { x0, -y0, a.endX, -a.endY };
    float head[6] = { a.head[0], -a.head[1], a.head[2], -a.head[3], a.head[4], -a.head[5] };
    paint(target, &(stencil){ .kind = STROKE, .map = same, .xy = line, .count = 2,
                              .half = shaft->half }, ink);
    paint(target, &(stencil){ .kind = FILL, .map = same, .xy = head, .count = 3 }, ink);
}

enum { MOST_DASHES = 2000 };

static void paint_dashes(const strip *target, const stencil *s, wfInk ink, float unit)
{
    float x0 = wfPixelX(s->map, s->xy[0]), y0 = wfPixelY(s->map, s->xy[1]);
    float dx = wfPixelX(s->map, s->xy[2]) - x0, dy = wfPixelY(s->map, s->xy[3]) - y0;
    double t0 = 0, t1 = 1;
    if (!clip_range((double)x0, (double)dx, -16, target->of->width + 16, &t0, &t1)) return;
    if (!clip_range((double)y0, (double)dy, -16, target->of->height + 16, &t0, &t1)) return;
    float length = (float)wfLength(wfV2(dx, dy)), dash = 6 * unit, period = 11 * unit;
    float first = period * (float)wfFloor((wfReal)((float)t0 * length / period));
    for (int i = 0; i < MOST_DASHES; i++) {
        float from = first + (float)i * period, to = from + dash;
        if (!(from < (float)t1 * length)) break;
        if (to > length) to = length;
        float a = from / length, b = to / length;
        float part[4] = { x0 + a * dx, -(y0 + a * dy), x0 + b * dx, -(y0 + b * dy) };
        paint(target, &(stencil){ .kind = STROKE, .map = { 1, 0, 0 }, .xy = part,
                                  .count = 2,
                                  .half = s->half }, ink);
    }
}

/* draw text into the picture */
static float cover_of(const wfFont *font, const wfGlyph *g, int32_t x, int32_t y)
{
    if (x < 0 || y < 0 || x >= g->width || y >= g->height) return 0;
    return font->cover[(size_t)(g->y + y) * (size_t)font->width + (size_t)(g->x + x)];
}

/* Between four pixels of the glyph. */
static float cover_at(const wfFont *font, const wfGlyph *g, float u, float v)
{
    int32_t x = floor_within(u, -1, g->width), y = floor_within(v, -1, g->height);
    float a = u - (float)x, b = v - (float)y, near = cover_of(font, g, x, y);
    if (a == 0 && b == 0) return near;
    near += a * (cover_of(font, g, x + 1, y) - near);
    float far = cover_of(font, g, x, y + 1);
    far += a * (cover_of(font, g, x + 1, y + 1) - far);
    return near + b * (far - near);
}

static void paint_glyph(const strip *target, const wfFont *font, const wfGlyph *g,
                        float left, float top, float scale, wfInk ink)
{
    const frame_buffer *of = target->of;
    float half = 0.5f * scale;                      /* beyond its edge it fades */
    int32_t x0 = floor_within(left - half, 0, of->width);
    int32_t y0 = floor_within(top - half, target->top, target->bottom);
    int32_t x1 = floor_within(left + scale * (float)g->width + half, -1, of->width - 1);
    int32_t y1 = floor_within(top + scale * (float)g->height + half, target->top - 1,
                              target->bottom - 1);
    for (int32_t y = y0; y <= y1; y++) {
        float v = ((float)y + 0.5f - top) / scale - 0.5f;
        uint8_t *pixel = (uint8_t *)(of->pixels
                         + (size_t)y * (size_t)of->pitch + (size_t)x0);
        for (int32_t x = x0; x <= x1; x++, pixel += 4) {
            float cover = scale == 1
                ? cover_of(font, g, x - (int32_t)left, y - (int32_t)top)
                : cover_at(font, g, ((float)x + 0.5f - left) / scale - 0.5f, v);
            if (cover > 0) wfBlendLetter(pixel, ink, cover / 255);
        }
    }
}

static void paint_text(const strip *target, const wfFont *font, float x, float y, float px,
                       int anchor, const char *text, wfInk ink)
{
    if (font == NULL || font->sizeCount < 1 || font->glyphCount < 1) return;
    float scale = wfLetterScale(font, px);
    x -= 0.5f * (float)(anchor + 1) * wfTextWidth(font, px, text);
    for (uint32_t letter; (letter = wfNextLetter(&text)) != 0; ) {
        const wfGlyph *g = wfFindGlyph(font, px, letter);
        float left = (float)floor_within(x + 0.5f, -32768, 32767) + scale * (float)g->left;
        float top = (float)floor_within(y + 0.5f, -32768, 32767) - scale * (float)g->top;
        paint_glyph(target, font, g, left, top, scale, ink);
        x += scale * g->advance;
    }
}

/* draw a list into the picture */
static void draw_command(const strip *target, wfPixelMap map, const wfDraw *list,
                         const wfDrawCommand *c, const wfFont *font, const wfPalette *p,
                         float unit)
{
    stencil s = { .map = map, .xy = wfDrawPoints(list, c), .count = c->count,
                  .half = 0.5f * unit * c->size, .kind = STROKE };
    float x = wfPixelX(map, s.xy[0]), y = wfPixelY(map, s.xy[1]);
    wfInk mark = p->mark[c->line >= 0 ? c->line : c->fill >= 0 ? c->fill : WF_INK_LINE];
    wfInk area = p->area[c->fill >= 0 ? c->fill : WF_INK_PAPER];
    bool line = c->line >= 0 && c->size > 0, fill = c->fill >= 0;
    switch (c->kind) {
    case WF_DRAW_POINT:
        if (!fill) break;
        s.kind = DISC;
        s.radius = s.half;
        s.half = 0;
        paint(target, &s, mark);
        break;
    case WF_DRAW_LINE: case WF_DRAW_POLYLINE:
        if (line) paint(target, &s, mark);
        break;
    case WF_DRAW_ARROW:
        if (line) paint_arrow(target, &s, mark);
        break;
    case WF_DRAW_DASHED:
        if (line) paint_dashes(target, &s, mark, unit);
        break;
    case WF_DRAW_TEXT:
        if (fill) paint_text(target, font, x, y, unit * c->size, c->anchor,
                             wfDrawString(list, c), mark);
        break;
    case WF_DRAW_CIRCLE:
        s.radius = map.scale * c->radius;
        s.kind = DISC;
        if (fill) paint(target, &s, area);
        s.kind = RING;
        if (line) paint(target, &s, mark);
        break;
    case WF_DRAW_POLYGON:
        s.closed = true;
        s.kind = FILL;
        if (fill) paint(target, &s, area);
        s.kind = STROKE;
        if (line) paint(target, &s, mark);
        break;
    default: break;
    }
}

static bool usable(const frame_buffer *t)
{
    return t != NULL && t->pixels != NULL && t->width > 0 && t->height > 0
        && t->pitch >= t->width && t->width <= 32768 && t->height <= 32768;
}

void wfClearFrame(frame_buffer *target, wfInk ink)
{
    if (!usable(target)) return;
    uint32_t word = word_of(ink), *first = target->pixels;
    size_t pitch = (size_t)target->pitch, bytes = (size_t)target->width * sizeof word;
    for (int32_t x = 0; x < target->width; x++) first[x] = word;
    for (int32_t y = 1; y < target->height; y++)
        memcpy(first + (size_t)y * pitch, first, bytes);
}

wfPixelMap wfFrameMap(const float view[4], const frame_buffer *target)
{
    return wfMapView(view, (float)target->width, (float)target->height);
}

/* A list on its way into a picture, in so many strips. */
typedef struct drawing {
    const wfDraw *list;
    const wfFont *font;
    const wfPalette *palette;
    frame_buffer *of;
    int32_t strips;
} drawing;

static void draw_strip(void *context, int32_t i)
{
    const drawing *d = context;
    float scale = d->of->scale, unit = scale >= 0.25f && scale <= 16 ? scale : 1;
    int32_t rows = d->of->height;
    strip target = { d->of, rows * i / d->strips, rows * (i + 1) / d->strips };
    wfPixelMap map = wfFrameMap(d->list->view, d->of);
    for (int k = 0; k < d->list->count; k++)
        draw_command(&target, map, d->list, wfDrawAt(d->list, k), d->font, d->palette,
                     unit);
}

enum { STRIPS = 4, WORTH_SHARING = 200 };       /* commands */

void wfRenderShared(const wfDraw *list, const wfFont *font, const wfPalette *palette,
                    frame_buffer *target, wfWorkers by)
{
    if (list == NULL || palette == NULL || !usable(target)) return;
    drawing d = { list, font, palette, target, STRIPS };
    if (by.run && list->count >= WORTH_SHARING) by.run(by.user, STRIPS, draw_strip, &d);
    else d.strips = 1, draw_strip(&d, 0);
}

void wfRenderList(const wfDraw *list, const wfFont *font, const wfPalette *palette,
                  frame_buffer *target)
{
    wfRenderShared(list, font, palette, target, (wfWorkers){ .run = NULL });
}
