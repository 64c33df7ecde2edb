/* Both back ends of the pen. Coverage is compared with areas known from geometry; the tolerances are derived
 * in the comments. Pixel positions and blended values are exact. */
#include "testing.h"
#include "weft/draw.h"
#include "testbed/raster.h"
#include "testbed/svg.h"
#include "testbed/workers.h"

static const wfPixelMap SAME = { 1, 0, 0 };  /* y is flipped: a point (x, -y) is the pixel (x, y) */
static _Alignas(8) unsigned char list_memory[1 << 18];
enum { W = 96, H = 64, GUARD = 16, PITCH = W + 2 * GUARD };
static uint32_t pixels[(H + 2 * GUARD) * PITCH];
#define GUARD_VALUE 0x12345678u

static wfDraw new_list(void)
{
    wfDraw d;
    wfDrawInit(&d, list_memory, sizeof list_memory);
    wfDrawView(&d, 0, 0, W, H);  /* one world unit is one pixel */
    return d;
}

/* A picture with guards all around, so that a pixel written outside shows. */
static frame_buffer new_frame(void)
{
    for (size_t i = 0; i < sizeof pixels / sizeof *pixels; i++) pixels[i] = GUARD_VALUE;
    frame_buffer f = { pixels + GUARD * PITCH + GUARD, W, H, PITCH, 1 };
    wfClearFrame(&f, wfLightPalette.mark[WF_INK_PAPER]);
    return f;
}

static const char *svg_of(const wfDraw *d, int width)
{
    static char text[2][16384];
    static int turn;
    char *t = text[turn ^= 1];
    FILE *out = tmpfile();
    assert_non_null(out);
    assert_int_equal(wfWriteSvg(d, width, out), 0);
    rewind(out);
    t[fread(t, 1, sizeof text[0] - 1, out)] = 0;
    fclose(out);
    return t;
}
#define assert_says(text, part) do { if (!strstr(text, part)) fail_msg("no %s in\n%s", part, text); } while (0)

static void assert_guards(void)
{
    for (int y = 0; y < H + 2 * GUARD; y++)
        for (int x = 0; x < PITCH; x++)
            if (x < GUARD || x >= GUARD + W || y < GUARD || y >= GUARD + H)
                assert_int_equal(pixels[y * PITCH + x], GUARD_VALUE);
}

static const uint8_t *at(const frame_buffer *f, int x, int y)
{
    return (const uint8_t *)(f->pixels + y * f->pitch + x);
}

static void assert_ink(const frame_buffer *f, int x, int y, wfInk ink)
{
    const uint8_t *p = at(f, x, y);
    if (p[0] != ink.r || p[1] != ink.g || p[2] != ink.b || p[3] != 255)
        fail_msg("pixel (%d, %d) is %d %d %d %d, not %d %d %d 255", x, y, p[0], p[1], p[2], p[3], ink.r, ink.g, ink.b);
}
#define MARK(role) (wfLightPalette.mark[role])
#define AREA(role) (wfLightPalette.area[role])
#define PAPER MARK(WF_INK_PAPER)

static void render(const wfDraw *d, frame_buffer *f) { wfRenderList(d, NULL, &wfLightPalette, f); }

/* ---- what the back ends share ---- */

TEST(the_view_is_fitted_and_flipped)
{
    const float view[4] = { -2, 1, 6, 5 };       /* 8 by 4 */
    wfPixelMap m = wfMapView(view, 800, 600);    /* scale 100; 200 px left over in y */
    assert_near(m.scale, 100, 0);
    assert_near(wfPixelX(m, -2), 0, 1e-4);
    assert_near(wfPixelX(m, 6), 800, 1e-4);
    assert_near(wfPixelY(m, 5), 100, 1e-4);      /* the top of the world is the smaller y */
    assert_near(wfPixelY(m, 1), 500, 1e-4);
    m = wfMapView(view, 800, 200);               /* the height decides: scale 50, 400 px left over in x */
    assert_near(m.scale, 50, 0);
    assert_near(wfPixelX(m, -2), 200, 1e-4);
    assert_near(wfPixelX(m, 6), 600, 1e-4);
    assert_near(wfPixelY(m, 5), 0, 1e-4);
    assert_near(wfPixelY(m, 1), 200, 1e-4);
    assert_near(wfWorldX(m, wfPixelX(m, 1.25f)), 1.25f, 1e-6);
    assert_near(wfWorldY(m, wfPixelY(m, 3.75f)), 3.75f, 1e-6);
}

TEST(arrows_have_a_tip_and_two_barbs)
{
    wfArrow a = wfMakeArrow(10, 20, 110, 20, 2);  /* head: 6 + 2.5 * 2 = 11 */
    assert_near(a.head[0], 110, 0);
    assert_near(a.head[1], 20, 0);
    assert_near(a.head[2], 99, 1e-4);
    assert_near(a.head[4], 99, 1e-4);
    assert_near(a.head[3] - 20, 4.4, 1e-4);
    assert_near(20 - a.head[5], 4.4, 1e-4);
    assert_near(a.endX, 110 - 0.8 * 11, 1e-4);
    assert_near(a.endY, 20, 1e-4);
    wfRandom r = random_stream(28);
    for (int i = 0; i < 200; i++) {
        float x0 = (float)wfRandomReal(&r, -50, 50), y0 = (float)wfRandomReal(&r, -50, 50);
        float x1 = (float)wfRandomReal(&r, -50, 50), y1 = (float)wfRandomReal(&r, -50, 50);
        a = wfMakeArrow(x0, y0, x1, y1, 1);
        double length = hypot((double)(x1 - x0), (double)(y1 - y0)), head = length < 8.5 ? length : 8.5;
        double mx = 0.5 * ((double)a.head[2] + (double)a.head[4]), my = 0.5 * ((double)a.head[3] + (double)a.head[5]);
        double ux = length > 0 ? (double)(x1 - x0) / length : 0, uy = length > 0 ? (double)(y1 - y0) / length : 0;
        assert_near(mx, (double)x1 - head * ux, 1e-3);
        assert_near(my, (double)y1 - head * uy, 1e-3);
        assert_near(a.endX, (double)x1 - 0.8 * head * ux, 1e-3);
        assert_near(a.endY, (double)y1 - 0.8 * head * uy, 1e-3);
        assert_near(hypot((double)(a.head[2] - a.head[4]), (double)(a.head[3] - a.head[5])), 0.8 * head, 1e-3);
        double across = (double)(a.head[2] - a.head[4]) * (double)(x1 - x0) + (double)(a.head[3] - a.head[5]) * (double)(y1 - y0);
        assert_near(across / (length + 1), 0, 1e-3);
    }
    a = wfMakeArrow(-1e19f, 5, 1e19f, 5, 2);  /* the square of its length is no float; its barbs are 0.4 * 11 from it */
    assert_near(a.head[3], 5 + 4.4, 1e-5);
    assert_near(a.head[5], 5 - 4.4, 1e-5);
    a = wfMakeArrow(3, 4, 3.5f, 4, 1);  /* half a pixel long: all of it is head */
    assert_near(a.head[2], 3, 1e-6);
    assert_near(a.head[3], 4 + 0.4 * 0.5, 1e-6);
    a = wfMakeArrow(3, 4, 3, 4, 1);  /* no direction: a head of no size, and no NaN */
    for (int i = 0; i < 6; i++) assert_near(a.head[i], i % 2 ? 4 : 3, 0);
}

TEST(utf8_is_read_and_bad_bytes_are_replaced)
{
    static const struct { const char *text; uint32_t letters[6]; } cases[] = {
        { "aZ", { 'a', 'Z', 0 } },
        { "\xc3\xa9\xe2\x8a\xa5\xf0\x9f\x98\x80", { 0xe9, 0x22a5, 0x1f600, 0 } },
        { "\x80x", { 0xfffd, 'x', 0 } },                    /* a continuation byte alone */
        { "\xc3", { 0xfffd, 0 } },                          /* cut off */
        { "\xe2\x8aq", { 0xfffd, 'q', 0 } },
        { "\xc0\xaf", { 0xfffd, 0 } },                      /* longer than need be */
        { "\xe0\x80\xaf", { 0xfffd, 0 } },
        { "\xed\xa0\x80", { 0xfffd, 0 } },                  /* half of a UTF-16 pair */
        { "\xf4\x90\x80\x80", { 0xfffd, 0 } },              /* beyond U+10FFFF */
        { "\xff" "a", { 0xfffd, 'a', 0 } },
        { "\x80\x80", { 0xfffd, 0xfffd, 0 } },
        { "\xf8\x80\x80\x80", { 0xfffd, 0xfffd, 0xfffd, 0xfffd, 0 } },
        { "\xef\xbf\xbf\xf4\x8f\xbf\xbf", { 0xffff, 0x10ffff, 0 } },
        { "\xc2\x80\xe0\xa0\x80\xf0\x90\x80\x80", { 0x80, 0x800, 0x10000, 0 } },
        { "\xee\x80\x80\xed\x9f\xbf", { 0xe000, 0xd7ff, 0 } },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const char *s = cases[i].text;
        for (int k = 0; k == 0 || cases[i].letters[k - 1] != 0; k++)
            if (wfNextLetter(&s) != cases[i].letters[k]) fail_msg("case %zu, letter %d", i, k);
    }
    char noise[33] = { 0 };
    wfRandom r = random_stream(5);
    for (int trial = 0; trial < 2000; trial++) {      /* any bytes: it ends, and within the text */
        for (int i = 0; i < 32; i++) noise[i] = (char)(wfRandomU32(&r) & 255);
        const char *s = noise;
        while (wfNextLetter(&s) != 0) assert_true(s <= noise + 32);
        assert_true(s <= noise + 32 && *s == 0);
    }
}

static double light(wfInk c)  /* relative luminance, Web Content Accessibility Guidelines 2.1 */
{
    const uint8_t v[3] = { c.r, c.g, c.b };
    const double weight[3] = { 0.2126, 0.7152, 0.0722 };
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        double s = v[k] / 255.0;
        sum += weight[k] * (s <= 0.03928 ? s / 12.92 : pow((s + 0.055) / 1.055, 2.4));
    }
    return sum;
}

static double contrast(wfInk a, wfInk b)
{
    double la = light(a), lb = light(b);
    return la > lb ? (la + 0.05) / (lb + 0.05) : (lb + 0.05) / (la + 0.05);
}

/* The guidelines ask 4.5 for text and 3 for lines. */
TEST(inks_stand_out_from_the_paper)
{
    const wfPalette *palettes[2] = { &wfLightPalette, &wfDarkPalette };
    for (int i = 0; i < 2; i++) {
        const wfPalette *p = palettes[i];
        for (int role = 0; role < WF_INK_PAPER; role++) {
            double paper = contrast(p->mark[role], p->mark[WF_INK_PAPER]);
            if (paper < (role == WF_INK_FAINT ? 3 : 4.5)) fail_msg("palette %d, %s: %.2f", i, wfInkName(role), paper);
            if (role != WF_INK_LINE && role != WF_INK_TEXT) {
                double label = contrast(p->mark[WF_INK_TEXT], p->area[role]);
                if (label < 4.5) fail_msg("palette %d, text on %s: %.2f", i, wfInkName(role), label);
                if (role != WF_INK_FAINT && contrast(p->mark[role], p->area[role]) < 3)
                    fail_msg("palette %d, %s on itself: %.2f", i, wfInkName(role), contrast(p->mark[role], p->area[role]));
            }
        }
    }
}

/* ---- coverage ---- */

typedef void cover_fn(wfCoverRow *row, const float *p);
static wfCoverRow row;

/* The sum of a shape's coverage over a window from (0, 0) to (64, 64). */
static double total(cover_fn *cover, const float *p)
{
    double sum = 0;
    wfCoverBegin(&row, 0, 0, 64);
    for (row.y = 0; row.y < 64; row.y++) {
        cover(&row, p);
        for (int i = 0; i < 64; i++) {
            assert_true(row.at[i] >= 0 && row.at[i] <= 1);
            sum += (double)row.at[i];
        }
        wfCoverClear(&row);
        for (int i = 0; i < WF_COVER_WIDTH + 2; i++)
            if (row.at[i] != 0 && i < 66) fail_msg("pixel %d of the row was not cleared", i);
    }
    return sum;
}

/* The same, averaged over m x m places of the grid of pixels under the shape. */
static double average_total(cover_fn *cover, const float *p, int points, int m)
{
    double sum = 0;
    for (int a = 0; a < m; a++)
        for (int b = 0; b < m; b++) {
            float moved[6];
            memcpy(moved, p, sizeof moved);
            for (int k = 0; k < points; k++) {
                moved[2 * k] += ((float)a + 0.5f) / (float)m;
                moved[2 * k + 1] += ((float)b + 0.5f) / (float)m;
            }
            sum += total(cover, moved);
        }
    return sum / (m * m);
}

static double polygon_area(const double *xy, int n)
{
    double sum = 0;
    for (int i = 0, j = n - 1; i < n; j = i++) sum += xy[2 * j] * xy[2 * i + 1] - xy[2 * i] * xy[2 * j + 1];
    return fabs(0.5 * sum);
}

/* Keeps the part of a polygon with sign * (coordinate k - limit) <= 0. */
static int clip(const double *in, int n, double *out, int k, double limit, double sign)
{
    int m = 0;
    for (int i = 0, j = n - 1; i < n; j = i++) {
        double dj = sign * (in[2 * j + k] - limit), di = sign * (in[2 * i + k] - limit);
        if ((dj <= 0) != (di <= 0)) {
            double t = dj / (dj - di);
            out[2 * m] = in[2 * j] + t * (in[2 * i] - in[2 * j]);
            out[2 * m + 1] = in[2 * j + 1] + t * (in[2 * i + 1] - in[2 * j + 1]);
            m++;
        }
        if (di <= 0) {
            out[2 * m] = in[2 * i];
            out[2 * m + 1] = in[2 * i + 1];
            m++;
        }
    }
    return m;
}

/* The exact share of a pixel that a polygon covers, by clipping the polygon to the pixel. */
static double exact_share(const double *xy, int n, int x, int y)
{
    double a[64], b[64];
    int m = clip(xy, n, a, 0, x, -1);
    m = clip(a, m, b, 0, x + 1, 1);
    m = clip(b, m, a, 1, y, -1);
    m = clip(a, m, b, 1, y + 1, 1);
    return m < 3 ? 0 : polygon_area(b, m);
}

/* A convex polygon with up to 9 corners on an ellipse; xy for the pen (y up), px for the oracle (y down). */
static int random_polygon(wfRandom *r, float *xy, double *px, double size)
{
    int n = 3 + (int)(wfRandomU32(r) % 7), forward = (int)(wfRandomU32(r) & 1);
    double cx = (double)wfRandomReal(r, -5, 45), cy = (double)wfRandomReal(r, -5, 45);
    double rx = size * (double)wfRandomReal(r, (wfReal)0.1, 1), ry = size * (double)wfRandomReal(r, (wfReal)0.1, 1);
    double angle = 0;
    for (int i = 0; i < n; i++) {
        int k = forward ? i : n - 1 - i;
        angle += 6.28 / n * (double)wfRandomReal(r, (wfReal)0.5, 1);
        xy[2 * k] = (float)(cx + rx * cos(angle));
        xy[2 * k + 1] = -(float)(cy + ry * sin(angle));
    }
    for (int i = 0; i < n; i++) {
        px[2 * i] = (double)xy[2 * i];
        px[2 * i + 1] = -(double)xy[2 * i + 1];
    }
    return n;
}

/* An edge's x below 40 is rounded to a float: 1.9e-6 at most. A flat edge leaves two numbers in each of 40 pixels, which
 * are rounded when they are made, added and summed up, each time by 2^-24 at most: 120 * 6e-8 = 7.2e-6. Together 1e-5. */
TEST(polygons_are_covered_exactly)
{
    wfRandom r = random_stream(2801);
    for (int trial = 0; trial < 400; trial++) {
        float xy[32];
        double px[32];
        int n = random_polygon(&r, xy, px, trial % 4 == 0 ? 2 : 30);
        wfCoverBegin(&row, 0, 0, 40);
        for (row.y = 0; row.y < 40; row.y++) {
            wfCoverPolygon(&row, SAME, xy, n);
            for (int x = 0; x < 40; x++) assert_near(row.at[x], exact_share(px, n, x, row.y), 1e-5);
            wfCoverClear(&row);
        }
    }
}

/* An area that ends exactly at the end of a row, begins exactly at its beginning, or does both is full to its end. */
TEST(areas_may_end_where_the_row_ends)
{
    for (int k = 0; k < 9; k++) {
        float left = (float)(k % 3) * 5 - 5, right = 35 + (float)(k / 3) * 5;
        const float xy[8] = { left, 0, right, 0, right, -9, left, -9 };
        wfCoverBegin(&row, 3, 0, 40);
        wfCoverPolygon(&row, SAME, xy, 4);
        for (int i = 0; i < 40; i++) assert_near(row.at[i], (float)i >= left && (float)i < right, 0);
        for (int i = row.fullLow; i < row.fullHigh; i++) assert_near(row.at[i], 1, 0);
        assert_true(row.fullHigh - row.fullLow >= 15);
        wfCoverClear(&row);
        for (int i = 0; i < 40; i++) assert_near(row.at[i], 0, 0);
        assert_int_equal(row.fullHigh, row.fullLow);
    }
}

/* What a row calls full is full, for all shapes; a polyline of more sides than are kept ready has the coverage of its parts. */
TEST(full_runs_are_full_and_long_lines_are_whole)
{
    wfRandom r = random_stream(2811);
    for (int trial = 0; trial < 200; trial++) {
        float x = (float)wfRandomReal(&r, -10, 50), y = (float)wfRandomReal(&r, -10, 50), radius = (float)wfRandomReal(&r, 0, 30);
        for (int line = 0; line < 40; line += 3) {
            wfCoverBegin(&row, line, 0, 40);
            if (trial % 2) wfCoverDisc(&row, x, y, radius);
            else wfCoverRing(&row, x, y, radius, 2);
            for (int i = 0; i < 40; i++) {
                double d = hypot((double)x - i - 0.5, (double)y - line - 0.5), R = (double)radius;
                if (trial % 2 && R > 2 && d < R - 1) assert_near(row.at[i], 1, 0);
                if (trial % 2 == 0 && d < R - 2.6) assert_near(row.at[i], 0, 0);
                if (i >= row.fullLow && i < row.fullHigh) assert_near(row.at[i], 1, 0);
            }
        }
    }
    float zig[2 * 200];
    for (int i = 0; i < 200; i++) zig[2 * i] = 4 + 0.4f * (float)i, zig[2 * i + 1] = 30 + (i % 2 ? 9.0f : -9.0f);
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfDrawPolyline(&d, zig, 200, 1, WF_INK_BODY);
    render(&d, &f);
    for (int y = 0; y < H; y++) {
        wfCoverBegin(&row, y, 0, W);
        for (int i = 0; i + 1 < 200; i++) {
            float from[2] = { zig[2 * i], H - zig[2 * i + 1] }, to[2] = { zig[2 * i + 2], H - zig[2 * i + 3] };
            wfCoverLine(&row, from, to, 0.5f);
        }
        for (int x = 0; x < W; x++) {
            uint8_t want[4] = { 255, 255, 255, 255 };
            wfBlend(want, MARK(WF_INK_BODY), row.at[x]);
            for (int k = 0; k < 3; k++) assert_near(at(&f, x, y)[k], want[k], 2);
        }
    }
}

TEST(rows_may_begin_anywhere)
{
    static wfCoverRow part;
    wfRandom r = random_stream(2802);
    for (int trial = 0; trial < 100; trial++) {
        float xy[32];
        double px[32];
        int n = random_polygon(&r, xy, px, 40), start = (int)(wfRandomU32(&r) % 40), y = (int)(wfRandomU32(&r) % 40);
        float a[2] = { xy[0], -xy[1] }, b[2] = { xy[4], -xy[5] };
        for (int kind = 0; kind < 4; kind++) {
            wfCoverBegin(&row, y, 0, 60);
            wfCoverBegin(&part, y, start, 20);
            wfCoverRow *both[2] = { &row, &part };
            for (int k = 0; k < 2; k++) {
                if (kind == 0) wfCoverPolygon(both[k], SAME, xy, n);
                if (kind == 1) wfCoverLine(both[k], a, b, 2);
                if (kind == 2) wfCoverDisc(both[k], a[0], a[1], 15);
                if (kind == 3) wfCoverRing(both[k], a[0], a[1], 15, 2);
            }
            for (int i = 0; i < 20; i++) assert_near(part.at[i], row.at[start + i], 2e-5);
        }
    }
}

static void cover_line(wfCoverRow *w, const float *p) { wfCoverLine(w, p, p + 2, p[4]); }
static void cover_disc(wfCoverRow *w, const float *p) { wfCoverDisc(w, p[0], p[1], p[2]); }
static void cover_ring(wfCoverRow *w, const float *p) { wfCoverRing(w, p[0], p[1], p[2], p[3]); }

/* Averaged over all places of the grid, the sum of the samples is the integral of the coverage, exactly. Averaging over
 * m x m places leaves the error of a midpoint rule. The coverage has slope at most 1 and is linear but for kinks along
 * curves of total length about 4 L: error at most 4 L / m^2, with L the outline's length. */
TEST(lines_have_their_area)
{
    const double pi = 3.14159265358979;
    wfRandom r = random_stream(2803);
    for (int trial = 0; trial < 10; trial++) {
        const float halves[5] = { 0.1f, 0.4f, 0.5f, 1, 3 };
        float p[6] = { 10, 10, (float)wfRandomReal(&r, 8, 30), (float)wfRandomReal(&r, 8, 30), halves[trial % 5], 0 };
        double h = (double)p[4], length = hypot((double)p[2] - 10, (double)p[3] - 10);
        double caps = h >= 0.5 ? pi * (h * h + 1 / 12.0) : pi * (h / 2 + 2 * h * h * h / 3);
        double outline = 2 * length + 2 * pi * (h + 0.5);
        assert_near(average_total(cover_line, p, 2, 16), 2 * h * length + caps, 4 * outline / (16 * 16));
    }
}

TEST(discs_and_rings_have_their_area)
{
    const double pi = 3.14159265358979;
    const float radii[7] = { 0.1f, 0.4f, 0.57735f, 0.6f, 1, 4, 15 };
    for (int i = 0; i < 7; i++) {
        float p[6] = { 20, 20, radii[i], 0, 0, 0 };
        double r = (double)radii[i];
        assert_near(average_total(cover_disc, p, 1, 16), pi * r * r, 4 * 2 * pi * (r + 0.5) / (16 * 16));
        /* The kinks are two circles, so the errors of the cells on them have both signs and nearly cancel: held to 0.3 %,
         * less than half of what the correction by 1/12 would change if it were 1/13. */
        if (radii[i] >= 0.57f && radii[i] <= 1) assert_near(average_total(cover_disc, p, 1, 32) / (pi * r * r), 1, 0.003);
        assert_near(average_total(cover_disc, p, 1, 16) / (pi * r * r), 1, 0.02);
    }
    float ring[6] = { 20, 20, 12, 1.5f, 0, 0 }, thin[6] = { 20, 20, 12, 0.2f, 0, 0 };
    assert_near(average_total(cover_ring, ring, 1, 16), 2 * pi * 12 * 3, 4 * 4 * pi * 12 / (16 * 16));
    assert_near(average_total(cover_ring, thin, 1, 16), 2 * pi * 12 * 0.4, 4 * 4 * pi * 12 / (16 * 16));
}

/* The largest difference of coverage by distance from exact coverage, for lines of all directions of half width h. */
static double worst_line_cover(double h)
{
    double worst = 0;
    for (int k = 0; k <= 36; k++) {
        double angle = k * 3.14159265358979 / 36, c = cos(angle), s = sin(angle), far = 200;
        double mx = 20.3, my = 20.1 + 0.03 * k;
        float xy[8], from[2] = { (float)(mx - far * c), (float)(my - far * s) }, to[2] = { (float)(mx + far * c), (float)(my + far * s) };
        const double end[4] = { -far, far, far, -far }, side[4] = { -h, -h, h, h };
        for (int i = 0; i < 4; i++) {
            xy[2 * i] = (float)(mx + end[i] * c - side[i] * s);
            xy[2 * i + 1] = -(float)(my + end[i] * s + side[i] * c);
        }
        for (int y = 0; y < 40; y++) {
            static wfCoverRow exact;
            wfCoverBegin(&row, y, 0, 40);
            wfCoverBegin(&exact, y, 0, 40);
            wfCoverLine(&row, from, to, (float)h);
            wfCoverPolygon(&exact, SAME, xy, 4);
            for (int x = 0; x < 40; x++) {
                double off = fabs((double)row.at[x] - (double)exact.at[x]);
                if (off > worst) worst = off;
            }
        }
    }
    return worst;
}

/* Never off by more than (sqrt(2) - 1)^2 / 4 = 0.0429 (eq:draw-error), which is reached for an edge at 45 degrees; by no more
 * than twice that where both borders of a thin line pass through a pixel. */
TEST(distance_is_nearly_area)
{
    assert_true(worst_line_cover(4) <= 0.0429 + 1e-4);
    assert_true(worst_line_cover(4) >= 0.041);
    for (int k = 1; k <= 6; k++) assert_true(worst_line_cover(k / 8.0) <= 2 * 0.0429 + 1e-4);
}

TEST(upright_lines_are_exact)
{
    const float from[2] = { 10.25f, -20 }, to[2] = { 10.25f, 90 };
    const float halves[3] = { 0.125f, 0.5f, 1.5f };
    for (int k = 0; k < 3; k++) {
        wfCoverBegin(&row, 30, 0, 40);
        wfCoverLine(&row, from, to, halves[k]);
        double sum = 0;
        for (int i = 0; i < 40; i++) {
            double left = 10.25 - (double)halves[k], right = 10.25 + (double)halves[k];
            double a = left > i ? left : i, b = right < i + 1 ? right : i + 1;
            if (halves[k] >= 0.5f) assert_near(row.at[i], b > a ? b - a : 0, 1e-6);
            sum += (double)row.at[i];
        }
        assert_near(sum, 2 * (double)halves[k], 1e-6);
    }
}

TEST(far_away_ends_do_no_harm)
{
    const float from[2] = { -1e9f, 10.5f }, to[2] = { 1e9f, 10.5f };
    wfCoverBegin(&row, 10, 0, 40);
    wfCoverLine(&row, from, to, 1);
    for (int i = 0; i < 40; i++) assert_near(row.at[i], 1, 1e-6);
    wfCoverBegin(&row, 14, 0, 40);
    wfCoverLine(&row, from, to, 1);
    for (int i = 0; i < 40; i++) assert_near(row.at[i], 0, 0);
    const float ground[8] = { -1e9f, -10.5f, 1e9f, -10.5f, 1e9f, -1e9f, -1e9f, -1e9f };
    wfCoverBegin(&row, 10, 0, 40);
    wfCoverPolygon(&row, SAME, ground, 4);
    for (int i = 0; i < 40; i++) assert_near(row.at[i], 0.5, 1e-6);
    const float point[2] = { 12.5f, 10.5f };  /* a line without a length is a dot */
    wfCoverBegin(&row, 10, 0, 40);
    wfCoverLine(&row, point, point, 1);
    assert_near(row.at[12], 1, 0);
    assert_near(row.at[13], 0.5, 1e-6);
    assert_near(row.at[11], 0.5, 1e-6);
    assert_near(row.at[14], 0, 0);
}

/* ---- blending ---- */

TEST(blending_keeps_its_identities)
{
    wfRandom r = random_stream(2804);
    for (int i = 0; i < 5000; i++) {
        uint32_t bits = wfRandomU32(&r);
        wfInk ink = { (uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16), 255 };
        bits = wfRandomU32(&r);
        const uint8_t below[4] = { (uint8_t)bits, (uint8_t)(bits >> 8), (uint8_t)(bits >> 16), 255 };
        float share = (float)wfRandomReal(&r, 0, 1);
        for (int letters = 0; letters < 2; letters++) {
            void (*blend)(uint8_t *, wfInk, float) = letters ? wfBlendLetter : wfBlend;
            uint8_t p[4], q[4];
            memcpy(p, below, 4); blend(p, ink, 0); assert_memory_equal(p, below, 4);
            memcpy(p, below, 4); blend(p, ink, 1);
            assert_true(p[0] == ink.r && p[1] == ink.g && p[2] == ink.b && p[3] == 255);
            memcpy(p, below, 4); blend(p, ink, -3); assert_memory_equal(p, below, 4);
            memcpy(q, below, 4); blend(q, ink, 7);
            assert_true(q[0] == ink.r && q[1] == ink.g && q[2] == ink.b);
            uint8_t own[4] = { ink.r, ink.g, ink.b, 255 };
            blend(own, ink, share);
            assert_true(own[0] == ink.r && own[1] == ink.g && own[2] == ink.b);
            wfInk clear = ink; clear.a = 0;
            memcpy(p, below, 4); blend(p, clear, share); assert_memory_equal(p, below, 4);
            memcpy(p, below, 4); blend(p, ink, share); memcpy(q, below, 4); blend(q, ink, share + (1 - share) / 2);
            for (int k = 0; k < 3; k++) {  /* between the two, and nearer to the ink with a greater share */
                int to = k == 0 ? ink.r : k == 1 ? ink.g : ink.b;
                assert_true(abs(to - q[k]) <= abs(to - p[k]) && abs(to - p[k]) <= abs(to - below[k]));
            }
        }
    }
}

TEST(half_the_light_is_not_half_the_byte)
{
    const wfInk white = { 255, 255, 255, 255 }, half = { 255, 255, 255, 128 };
    uint8_t a[4] = { 0, 0, 0, 0 }, b[4] = { 0, 0, 0, 0 }, c[4] = { 0, 0, 0, 0 };
    wfBlend(a, white, 0.5f);
    wfBlendLetter(b, white, 0.5f);
    wfBlend(c, half, 1);
    assert_int_equal(a[0], 180);  /* 255 / sqrt 2 = 180.3 */
    assert_int_equal(a[3], 255);
    assert_int_equal(b[1], 128);
    assert_int_equal(c[2], 181);  /* 255 * sqrt(128 / 255) = 180.7 */
}

/* ---- the frame buffer's back end ---- */

TEST(every_command_leaves_its_ink)
{
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    const float tri[6] = { 60, 4, 90, 4, 75, 30 }, zig[6] = { 4, 40, 20, 40, 20, 60 };
    wfDrawLine(&d, 4, 10.5f, 40, 10.5f, 3, WF_INK_GOOD);
    wfDrawArrow(&d, 4, 20.5f, 40, 20.5f, 3, WF_INK_BAD);
    wfDrawDashed(&d, 4, 30.5f, 48, 30.5f, 3, WF_INK_ACCENT);
    wfDrawCircle(&d, 60, 48, 10, 3, WF_INK_BODY, WF_INK_BODY2);
    wfDrawPolygon(&d, tri, 3, 3, WF_INK_FAINT, WF_INK_GOOD);
    wfDrawPolyline(&d, zig, 3, 3, WF_INK_TEXT);
    wfDrawPoint(&d, 85.5f, 55.5f, 6, WF_INK_BAD);
    render(&d, &f);
    assert_guards();
    assert_ink(&f, 20, H - 11, MARK(WF_INK_GOOD));
    assert_ink(&f, 20, H - 13, PAPER);
    assert_ink(&f, 20, H - 9, PAPER);
    assert_ink(&f, 10, H - 21, MARK(WF_INK_BAD));
    assert_ink(&f, 30, H - 21, MARK(WF_INK_BAD));   /* in the head, which is 13.5 long and 10.8 wide at x = 26.5 */
    assert_ink(&f, 28, H - 24, MARK(WF_INK_BAD));
    assert_ink(&f, 28, H - 18, MARK(WF_INK_BAD));
    assert_ink(&f, 41, H - 21, PAPER);
    assert_ink(&f, 7, H - 31, MARK(WF_INK_ACCENT)); /* dashes of 6 with round ends, gaps of 5: 4..10, 15..21 ... */
    assert_ink(&f, 12, H - 31, PAPER);
    assert_ink(&f, 18, H - 31, MARK(WF_INK_ACCENT));
    assert_ink(&f, 23, H - 31, PAPER);
    assert_ink(&f, 60, H - 48, AREA(WF_INK_BODY2));
    assert_ink(&f, 69, H - 49, MARK(WF_INK_BODY));
    assert_ink(&f, 60, H - 39, MARK(WF_INK_BODY));
    assert_ink(&f, 72, H - 48, PAPER);
    assert_ink(&f, 75, H - 15, AREA(WF_INK_GOOD));
    assert_ink(&f, 75, H - 5, MARK(WF_INK_FAINT));  /* the outline is on top of the area */
    assert_ink(&f, 60, H - 20, PAPER);
    assert_ink(&f, 10, H - 41, MARK(WF_INK_TEXT));
    assert_ink(&f, 20, H - 50, MARK(WF_INK_TEXT));
    assert_ink(&f, 10, H - 55, PAPER);              /* a polyline isn't closed */
    assert_ink(&f, 85, H - 56, MARK(WF_INK_BAD));
    assert_ink(&f, 87, H - 56, MARK(WF_INK_BAD));
    assert_ink(&f, 85, H - 61, PAPER);
}

/* Two pictures of the same thing, drawn in two ways: no byte differs by more than `most'. */
static void assert_same_picture(const frame_buffer *a, const uint32_t *other, int most)
{
    int drawn = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const uint8_t *p = at(a, x, y), *q = (const uint8_t *)(other + y * PITCH + x);
            for (int k = 0; k < 4; k++)
                if (abs(p[k] - q[k]) > most) fail_msg("pixel (%d, %d) differs: %d and %d", x, y, p[k], q[k]);
            if (p[0] != PAPER.r) drawn++;
        }
    assert_true(drawn > 50);
}

static uint32_t kept[H * PITCH];
static void keep_picture(const frame_buffer *f) { memcpy(kept, f->pixels, ((H - 1) * PITCH + W) * sizeof *kept); }

/* An arrow is its shaft and its head: drawn as a line and a polygon in the same ink it gives the same picture. */
TEST(arrows_are_shaft_and_head)
{
    wfPalette one = wfLightPalette;
    memcpy(one.area, one.mark, sizeof one.area);
    const float ends[4][4] = { { 10, 10, 60, 50 }, { 70, 12, 30, 40 }, { 80, 50, 20, 47 }, { 40, 55, 44, 9 } };
    for (int i = 0; i < 4; i++) {
        const float *e = ends[i];
        wfDraw d = new_list();
        frame_buffer f = new_frame();
        wfDrawArrow(&d, e[0], e[1], e[2], e[3], 4, WF_INK_BAD);
        wfRenderList(&d, NULL, &one, &f);
        keep_picture(&f);
        d = new_list();
        f = new_frame();
        wfArrow a = wfMakeArrow(e[0], H - e[1], e[2], H - e[3], 4);
        float head[6];
        for (int k = 0; k < 6; k++) head[k] = k % 2 ? H - a.head[k] : a.head[k];
        wfDrawLine(&d, e[0], e[1], a.endX, H - a.endY, 4, WF_INK_BAD);
        wfDrawPolygon(&d, head, 3, 0, WF_INK_NONE, WF_INK_BAD);
        wfRenderList(&d, NULL, &one, &f);
        assert_same_picture(&f, kept, 1);
    }
}

/* A dashed line is lines of 6 pixels with gaps of 5 from its start on, also when it starts outside of the picture. */
TEST(dashes_are_short_lines)
{
    const float ends[5][4] = { { 10, 10, 80, 55 }, { 80, 52, 12, 8 }, { 30, 60, 30, 3 }, { -300, -160, 300, 210 }, { 50, 900, 20, -700 } };
    for (int i = 0; i < 10; i++) {
        const float *e = ends[i / 2];
        float unit = i % 2 ? 2 : 1;
        wfDraw d = new_list();
        frame_buffer f = new_frame();
        f.scale = unit;
        wfDrawDashed(&d, e[0], e[1], e[2], e[3], 2, WF_INK_BAD);
        render(&d, &f);
        keep_picture(&f);
        d = new_list();
        f = new_frame();
        f.scale = unit;
        double length = hypot((double)(e[2] - e[0]), (double)(e[3] - e[1]));
        double ux = (double)(e[2] - e[0]) / length, uy = (double)(e[3] - e[1]) / length;
        for (double from = 0; from < length; from += 11 * (double)unit) {
            double to = from + 6 * (double)unit < length ? from + 6 * (double)unit : length;
            wfDrawLine(&d, (float)((double)e[0] + from * ux), (float)((double)e[1] + from * uy),
                       (float)((double)e[0] + to * ux), (float)((double)e[1] + to * uy), 2, WF_INK_BAD);
        }
        render(&d, &f);
        assert_same_picture(&f, kept, 3);  /* places up to 1000 in floats: 6e-5 px, times a slope of the root in mixing */
    }
}

/* What is covered in part is mixed in part; a transparent ink is mixed even where it covers all. */
TEST(shares_are_mixed)
{
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfPalette glass = wfLightPalette;
    glass.area[WF_INK_BAD].a = 128;
    const float box[8] = { 10.25f, 10, 30.5f, 10, 30.5f, 30, 10.25f, 30 };
    wfDrawPolygon(&d, box, 4, 0, WF_INK_NONE, WF_INK_BAD);
    for (int k = 0; k < 2; k++) {
        const wfPalette *p = k ? &glass : &wfLightPalette;
        wfClearFrame(&f, PAPER);
        wfRenderList(&d, NULL, p, &f);
        const float shares[4] = { 0.75f, 1, 0.5f, 0 };
        const int columns[4] = { 10, 20, 30, 31 };
        for (int i = 0; i < 4; i++) {
            uint8_t want[4] = { PAPER.r, PAPER.g, PAPER.b, 255 };
            wfBlend(want, p->area[WF_INK_BAD], shares[i]);
            const uint8_t *got = at(&f, columns[i], 40);
            for (int c = 0; c < 4; c++) assert_true(abs(got[c] - want[c]) <= 1);
        }
    }
    uint8_t half[4] = { PAPER.r, PAPER.g, PAPER.b, 255 };
    wfBlend(half, AREA(WF_INK_BAD), 128.0f / 255);
    assert_memory_equal(at(&f, 20, 40), half, 4);
}

TEST(closed_outlines_are_closed)
{
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    const float box[8] = { 10, 10.5f, 30, 10.5f, 30, 30.5f, 10, 30.5f };
    wfDrawPolygon(&d, box, 4, 3, WF_INK_LINE, WF_INK_NONE);
    render(&d, &f);
    for (int x = 10; x < 30; x++) {
        assert_ink(&f, x, H - 11, MARK(WF_INK_LINE));
        assert_ink(&f, x, H - 31, MARK(WF_INK_LINE));
    }
    for (int y = 10; y < 30; y++) {
        assert_ink(&f, 10, H - 1 - y, MARK(WF_INK_LINE));
        assert_ink(&f, 29, H - 1 - y, MARK(WF_INK_LINE));
    }
    assert_ink(&f, 20, H - 21, PAPER);
}

/* The rows of an upright rectangle are covered once. With a fifth corner in a flat side it is drawn row by row, to the same picture: also where it begins
 * above the picture or left of it, lies on its head, or has hardly any rows. */
TEST(upright_rectangles_are_drawn_row_by_row)
{
    const float boxes[7][4] = { { 10, 10, 60, 50 }, { 20.3f, 30.7f, 70.6f, H + 30 }, { -20, -20, 50.2f, 40.9f }, { 10, 50, 60, 12.4f },
                                { 30, 20, 80, 26.5f }, { 30, 20, 80, 23.1f }, { 10.5f, -300, 70.4f, 300 } };
    for (int i = 0; i < 7; i++)
        for (int wide = 0; wide < 9; wide += 4) {
            const float *e = boxes[i], middle = (e[0] + e[2]) / 2;
            const float xy[10] = { e[0], e[1], e[0], e[3], e[2], e[3], e[2], e[1], middle, e[1] };
            for (int corners = 4; corners <= 5; corners++) {
                wfDraw d = new_list();
                frame_buffer f = new_frame();
                wfDrawPolygon(&d, xy, corners, (float)wide, WF_INK_BAD, WF_INK_GOOD);
                render(&d, &f);
                assert_guards();
                if (corners == 4) keep_picture(&f);
                else assert_same_picture(&f, kept, 0);
            }
        }
}

TEST(roles_of_none_draw_nothing)
{
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    const float box[8] = { 10, 10, 30, 10, 30, 30, 10, 30 };
    wfDrawPolygon(&d, box, 4, 3, WF_INK_NONE, WF_INK_NONE);
    wfDrawPolygon(&d, box, 4, 0, WF_INK_LINE, WF_INK_NONE);
    wfDrawCircle(&d, 60, 30, 10, 0, WF_INK_LINE, WF_INK_NONE);
    wfDrawLine(&d, 0, 0, 60, 60, 0, WF_INK_LINE);
    wfDrawLine(&d, 0, 0, 60, 60, 3, WF_INK_NONE);
    wfDrawPoint(&d, 5, 5, 9, WF_INK_NONE);
    wfDrawText(&d, 5, 5, 9, WF_INK_NONE, 0, "none");
    wfDrawArrow(&d, 0, 0, 60, 60, 0, WF_INK_LINE);
    wfDrawDashed(&d, 0, 0, 60, 60, 0, WF_INK_LINE);
    assert_int_equal(d.count, 9);
    render(&d, &f);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) assert_ink(&f, x, y, PAPER);
    const char *s = svg_of(&d, 96);  /* nor does SVG: there is nothing between its first and its last line */
    assert_string_equal(strchr(s, '\n'), "\n</svg>\n");
    d = new_list();
    wfDrawPolygon(&d, box, 4, 1, WF_INK_LINE, WF_INK_LINE);  /* but the first of the roles is one */
    wfDrawPoint(&d, 5, 5, 9, WF_INK_LINE);
    s = svg_of(&d, 96);
    assert_says(s, "<polygon class=\"s-line f-line\" fill=\"#1f2933\" stroke=\"#1f2933\" stroke-width=\"1\"");
    assert_says(s, "<circle class=\"t-line\" fill=\"#1f2933\"");
}

TEST(later_commands_lie_on_top)
{
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfDrawCircle(&d, 40, 30, 10, 0, WF_INK_NONE, WF_INK_BODY);
    wfDrawCircle(&d, 40, 30, 5, 0, WF_INK_NONE, WF_INK_BAD);
    render(&d, &f);
    assert_ink(&f, 40, 34, AREA(WF_INK_BAD));
    assert_ink(&f, 47, 34, AREA(WF_INK_BODY));
    wfRenderList(&d, NULL, &wfDarkPalette, &f);
    assert_ink(&f, 40, 34, wfDarkPalette.area[WF_INK_BAD]);
}

/* On a dense screen everything measured in pixels is twice as large; world units follow the view. */
TEST(dense_screens_get_wider_lines)
{
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfDrawLine(&d, 0, 32, 96, 32, 4, WF_INK_LINE);
    f.scale = 2;
    render(&d, &f);
    assert_ink(&f, 50, 28, MARK(WF_INK_LINE));
    assert_ink(&f, 50, 35, MARK(WF_INK_LINE));
    assert_ink(&f, 50, 27, PAPER);
    assert_ink(&f, 50, 36, PAPER);
    f = new_frame();
    f.scale = NAN;  /* no scale is as good as 1 */
    render(&d, &f);
    assert_ink(&f, 50, 30, MARK(WF_INK_LINE));
    assert_ink(&f, 50, 29, PAPER);
    assert_ink(&f, 50, 33, MARK(WF_INK_LINE));
    assert_ink(&f, 50, 34, PAPER);
}

TEST(wide_pictures_are_drawn_in_strips)
{
    enum { WIDE = 2 * WF_COVER_WIDTH + 100 };
    static uint32_t wide[WIDE * 8];
    frame_buffer f = { wide, WIDE, 8, WIDE, 1 };
    wfDraw d = new_list();
    wfDrawView(&d, 0, 0, WIDE, 8);
    const float all[8] = { -5, 2, WIDE + 5, 2, WIDE + 5, 6, -5, 6 };
    wfClearFrame(&f, PAPER);
    wfDrawPolygon(&d, all, 4, 0, WF_INK_NONE, WF_INK_GOOD);
    wfDrawLine(&d, 0, 4, WIDE, 4, 2, WF_INK_BAD);
    render(&d, &f);
    for (int x = 0; x < WIDE; x++) {
        assert_ink(&f, x, 1, PAPER);
        assert_ink(&f, x, 2, AREA(WF_INK_GOOD));
        assert_ink(&f, x, 3, MARK(WF_INK_BAD));
        assert_ink(&f, x, 4, MARK(WF_INK_BAD));
        assert_ink(&f, x, 5, AREA(WF_INK_GOOD));
        assert_ink(&f, x, 6, PAPER);
    }
}

/* Random drawing, most of it outside: the sanitizer and the guards watch. */
static void draw_anything(wfDraw *d, wfRandom *r, int count, wfReal far)
{
    for (int i = 0; i < count; i++) {
        float p[12];
        for (int k = 0; k < 12; k++) p[k] = (float)wfRandomReal(r, -far, far);
        float wide = (float)wfRandomReal(r, 0, 12), radius = (float)wfRandomReal(r, 0, far);
        int role = (int)(wfRandomU32(r) % WF_INK_COUNT);
        switch (wfRandomU32(r) % 8) {
        case 0: wfDrawPoint(d, p[0], p[1], wide, role); break;
        case 1: wfDrawLine(d, p[0], p[1], p[2], p[3], wide, role); break;
        case 2: wfDrawArrow(d, p[0], p[1], p[2], p[3], wide, role); break;
        case 3: wfDrawDashed(d, p[0], p[1], p[2], p[3], wide, role); break;
        case 4: wfDrawCircle(d, p[0], p[1], radius, wide, role, role); break;
        case 5: wfDrawPolygon(d, p, 6, wide, role, role); break;
        case 6: wfDrawPolyline(d, p, 6, wide, role); break;
        default: wfDrawText(d, p[0], p[1], wide * 3, role, 0, "Weft \xe2\x8a\xa5"); break;
        }
    }
}

TEST(nothing_is_drawn_outside)
{
    wfRandom r = random_stream(2805);
    for (int trial = 0; trial < 150; trial++) {
        wfDraw d = new_list();
        frame_buffer f = new_frame();
        wfReal far = trial % 3 == 0 ? (wfReal)1e9 : trial % 3 == 1 ? 1000 : 100;
        draw_anything(&d, &r, 12, far);
        assert_int_equal(d.refused + d.overflow, 0);
        if (trial % 5 == 0) wfDrawView(&d, -WF_DRAW_LIMIT, -WF_DRAW_LIMIT, WF_DRAW_LIMIT, WF_DRAW_LIMIT);
        if (trial % 5 == 1) wfDrawView(&d, 0, 0, WF_DRAW_SMALLEST, WF_DRAW_SMALLEST);
        wfRenderList(&d, &wfBakedFont, &wfDarkPalette, &f);
        assert_guards();
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) assert_int_equal(at(&f, x, y)[3], 255);
        FILE *out = tmpfile();
        assert_int_equal(wfWriteSvg(&d, 300, out), 0);
        fclose(out);
    }
}

static void backwards(void *user, int32_t parts, wfPartFn *work, void *context)
{
    *(int32_t *)user = parts;
    while (parts > 0) work(context, --parts);
}

TEST(threads_share_the_rows_of_a_picture)
{
    static uint32_t alone[sizeof pixels / sizeof *pixels];
    static const float units[] = { 1, 2.5f };
    wfRandom r = random_stream(2911);
    work_pool *pool = work_pool_open(3);
    int32_t parts = 0;
    for (int trial = 0; trial < 60; trial++) {
        wfDraw d = new_list();
        draw_anything(&d, &r, 250, trial % 2 ? 100 : 1000);
        for (int way = 0; way < 3; way++) {
            frame_buffer f = new_frame();
            f.scale = units[trial % 4 > 1];
            f.height = H - trial % 7;           /* strips of unequal heights */
            wfWorkers by = way == 0 ? (wfWorkers){ .run = NULL } : way == 1 ? (wfWorkers){ backwards, &parts } : work_pool_lend(pool);
            wfRenderShared(&d, &wfBakedFont, &wfDarkPalette, &f, by);
            if (way == 0) memcpy(alone, pixels, sizeof pixels);
            assert_memory_equal(alone, pixels, sizeof pixels);
        }
    }
    assert_true(parts > 1);
    work_pool_close(pool);
}

TEST(bad_pictures_are_left_alone)
{
    wfDraw d = new_list();
    wfDrawCircle(&d, 40, 30, 200, 1, WF_INK_LINE, WF_INK_BODY);
    frame_buffer good = new_frame();
    frame_buffer bad[6] = { good, good, good, good, good, good };
    bad[0].pixels = NULL;
    bad[1].width = 0;
    bad[2].height = -1;
    bad[3].pitch = W - 1;
    bad[4].width = bad[4].pitch = 40000;
    bad[5].height = 40000;
    for (int i = 0; i < 6; i++) {
        wfClearFrame(&bad[i], MARK(WF_INK_BAD));
        render(&d, &bad[i]);
    }
    wfRenderList(NULL, NULL, &wfLightPalette, &good);
    wfRenderList(&d, NULL, NULL, &good);
    wfRenderList(&d, NULL, &wfLightPalette, NULL);
    wfClearFrame(NULL, PAPER);
    assert_guards();
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) assert_ink(&good, x, y, PAPER);
}

TEST(the_same_list_gives_the_same_pixels)
{
    static uint32_t first[sizeof pixels / sizeof *pixels];
    for (int k = 0; k < 2; k++) {
        wfDraw d = new_list();
        frame_buffer f = new_frame();
        wfDrawCircle(&d, 40, 30, 12.3f, 1.5f, WF_INK_LINE, WF_INK_BODY);
        wfDrawLine(&d, 3, 5, 80, 44, 1.5f, WF_INK_ACCENT);
        render(&d, &f);
        if (k == 0) memcpy(first, pixels, sizeof pixels);
    }
    assert_memory_equal(first, pixels, sizeof pixels);
}

/* ---- letters ---- */

/* A font with two sizes and three letters. At 10 px: A is 4 x 6 and full, B is 2 x 2, the last is U+FFFD, 3 x 3. */
static uint8_t atlas[16 * 16];
static const wfFontSize SIZES[2] = { { 10, 8, 2 }, { 20, 16, 4 } };
static const wfGlyph GLYPHS[6] = {
    { 'A', 0, 0, 4, 6, 1, 6, 5 },  { 'B', 4, 0, 2, 2, 0, 2, 3.25f },  { 0xfffd, 8, 0, 3, 3, 0, 3, 4 },
    { 'A', 0, 8, 8, 8, 1, 8, 10 }, { 'B', 8, 8, 4, 4, 0, 4, 6.5f },   { 0xfffd, 12, 8, 3, 3, 0, 3, 8 },
};
static const wfFont FONT = { atlas, 16, 16, SIZES, 2, GLYPHS, 3 };

TEST(glyphs_are_found)
{
    assert_int_equal(wfNearestSize(&FONT, 1), 0);
    assert_int_equal(wfNearestSize(&FONT, 14.9f), 0);
    assert_int_equal(wfNearestSize(&FONT, 15.1f), 1);
    assert_int_equal(wfNearestSize(&FONT, 1000), 1);
    assert_ptr_equal(wfFindGlyph(&FONT, 10, 'A'), &GLYPHS[0]);
    assert_ptr_equal(wfFindGlyph(&FONT, 10, 'B'), &GLYPHS[1]);
    assert_ptr_equal(wfFindGlyph(&FONT, 20, 'B'), &GLYPHS[4]);
    assert_ptr_equal(wfFindGlyph(&FONT, 10, 'C'), &GLYPHS[2]);
    assert_ptr_equal(wfFindGlyph(&FONT, 10, 1), &GLYPHS[2]);
    assert_ptr_equal(wfFindGlyph(&FONT, 20, 0x10ffff), &GLYPHS[5]);
    assert_near(wfTextWidth(&FONT, 10, "AB?"), 5 + 3.25 + 4, 0);
    assert_near(wfTextWidth(&FONT, 10, ""), 0, 0);
    assert_near(wfTextWidth(NULL, 10, "A"), 0, 0);
    const wfFont none = { 0 };
    assert_int_equal(wfNearestSize(&none, 10), -1);
    assert_null(wfFindGlyph(&none, 10, 'A'));
    assert_near(wfTextWidth(&none, 10, "A"), 0, 0);
    wfFont empty = FONT;  /* sizes, but no letters */
    empty.glyphCount = 0;
    assert_null(wfFindGlyph(&empty, 10, 'A'));
    assert_near(wfTextWidth(&empty, 10, "A"), 0, 0);
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfDrawText(&d, 20, 30, 10, WF_INK_TEXT, -1, "A");
    wfRenderList(&d, &empty, &wfLightPalette, &f);
    wfRenderList(&d, &none, &wfLightPalette, &f);
    assert_ink(&f, 22, 30, PAPER);
}

TEST(letters_stand_on_their_point)
{
    memset(atlas, 255, sizeof atlas);
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfDrawText(&d, 20, 30, 10, WF_INK_TEXT, -1, "A");
    wfRenderList(&d, &FONT, &wfLightPalette, &f);
    /* the pen is at pixel (20, 34); the picture begins 1 right of it and 6 above, and ends above it */
    for (int y = 20; y < 40; y++)
        for (int x = 10; x < 40; x++)
            assert_ink(&f, x, y, x >= 21 && x < 25 && y >= 28 && y < 34 ? MARK(WF_INK_TEXT) : PAPER);
    const int first[3] = { 21, 16, 11 };  /* "AA" is 10 wide: starts at, centred on, ends at 20 */
    for (int anchor = -1; anchor <= 1; anchor++) {
        d = new_list();
        f = new_frame();
        wfDrawText(&d, 20, 30, 10, WF_INK_BAD, anchor, "AA");
        wfRenderList(&d, &FONT, &wfLightPalette, &f);
        int x0 = first[anchor + 1];
        assert_ink(&f, x0 - 1, 30, PAPER);
        assert_ink(&f, x0, 30, MARK(WF_INK_BAD));
        assert_ink(&f, x0 + 3, 30, MARK(WF_INK_BAD));
        assert_ink(&f, x0 + 4, 30, PAPER);
        assert_ink(&f, x0 + 5, 30, MARK(WF_INK_BAD));
        assert_ink(&f, x0 + 8, 30, MARK(WF_INK_BAD));
        assert_ink(&f, x0 + 9, 30, PAPER);
    }
}

/* The first role has the number 0, which is a role like any other; so has a width below 1 pixel. */
TEST(the_first_role_and_thin_lines_are_drawn)
{
    const float box[8] = { 10, 10, 20, 10, 20, 20, 10, 20 };
    wfDraw d = new_list();
    frame_buffer f = new_frame();
    wfDrawPolygon(&d, box, 4, 0, WF_INK_NONE, 0);
    wfDrawLine(&d, 30, 10.5f, 40, 10.5f, 1, 0);
    wfDrawLine(&d, 50, 10.5f, 60, 10.5f, 0.5f, 0);
    wfRenderList(&d, NULL, &wfLightPalette, &f);
    assert_ink(&f, 15, H - 16, AREA(0));
    assert_ink(&f, 35, H - 11, MARK(0));
    assert_int_not_equal(f.pixels[(H - 11) * f.pitch + 55], f.pixels[0]);
}

TEST(letters_are_cut_at_the_border)
{
    memset(atlas, 255, sizeof atlas);
    const float places[6][2] = { { -3, 30 }, { 93, 30 }, { 40, -4 }, { 40, 60 }, { -40, -40 }, { 1e9f, 1e9f } };
    for (int i = 0; i < 6; i++) {
        wfDraw d = new_list();
        frame_buffer f = new_frame();
        wfDrawText(&d, places[i][0], places[i][1], 20, WF_INK_TEXT, -1, "A");
        wfRenderList(&d, &FONT, &wfLightPalette, &f);
        assert_guards();
        if (i == 0) assert_ink(&f, 0, H - 33, MARK(WF_INK_TEXT));
        if (i == 1) assert_ink(&f, W - 1, H - 33, MARK(WF_INK_TEXT));
        if (i == 2) assert_ink(&f, 43, H - 1, MARK(WF_INK_TEXT));
        if (i == 3) assert_ink(&f, 43, 0, MARK(WF_INK_TEXT));
    }
    wfDraw d = new_list();  /* the pen at -3.3 goes to the nearest pixel, -3: the letter covers -2 to 1 */
    frame_buffer f = new_frame();
    wfDrawText(&d, -3.3f, 30, 10, WF_INK_TEXT, -1, "A");
    wfRenderList(&d, &FONT, &wfLightPalette, &f);
    for (int x = 0; x < 4; x++) assert_ink(&f, x, H - 32, x < 2 ? MARK(WF_INK_TEXT) : PAPER);
}

TEST(the_baked_font_is_sound)
{
    const wfFont *f = &wfBakedFont;
    if (f->sizeCount == 0) skip();  /* built without stb or without DejaVu */
    for (int s = 0; s < f->sizeCount; s++) {
        const wfGlyph *g = f->glyphs + s * f->glyphCount;
        if (s > 0) assert_true(f->sizes[s].px > f->sizes[s - 1].px);
        assert_true(f->sizes[s].ascent > 0 && f->sizes[s].descent > 0);
        assert_int_equal(g[f->glyphCount - 1].letter, 0xfffd);
        for (int i = 0; i < f->glyphCount; i++) {
            if (i > 0) assert_true(g[i].letter > g[i - 1].letter);
            assert_true(g[i].x >= 0 && g[i].y >= 0 && g[i].x + g[i].width <= f->width && g[i].y + g[i].height <= f->height);
            assert_true(g[i].advance > 0 && g[i].advance < 2 * f->sizes[s].px);
        }
        for (uint32_t c = 33; c < 127; c++) {  /* every ASCII letter has ink */
            const wfGlyph *a = wfFindGlyph(f, f->sizes[s].px, c);
            int ink = 0;
            assert_int_equal(a->letter, c);
            for (int y = 0; y < a->height; y++)
                for (int x = 0; x < a->width; x++) ink += f->cover[(a->y + y) * f->width + a->x + x];
            assert_true(ink > 255);
        }
    }
}

/* ---- the page's back end ---- */

TEST(svg_says_the_same_as_the_pixels)
{
    wfDraw d = new_list();
    const float tri[6] = { 60, 4, 90, 4, 75, 30.5f };
    wfDrawView(&d, 0, 0, 96, 64);
    wfDrawLine(&d, 4, 10.5f, 40, 10.25f, 3, WF_INK_GOOD);
    wfDrawArrow(&d, 4, 20, 40, 20, 2, WF_INK_BAD);
    wfDrawDashed(&d, 4, 30, 48, 30, 1.5f, WF_INK_ACCENT);
    wfDrawCircle(&d, 60, 48, 10, 3, WF_INK_BODY, WF_INK_BODY2);
    wfDrawCircle(&d, 61, 48, 10, 0, WF_INK_BODY, WF_INK_FAINT);
    wfDrawPolygon(&d, tri, 3, 3, WF_INK_FAINT, WF_INK_NONE);
    wfDrawPolyline(&d, tri, 2, 3, WF_INK_TEXT);
    wfDrawPoint(&d, 85.5f, 55.5f, 6, WF_INK_BAD);
    wfDrawText(&d, 1, 2, 13, WF_INK_TEXT, 0, "a<b & \xe2\x8a\xa5 \x01");
    wfDrawText(&d, 1, 2, 13, WF_INK_TEXT, -1, "\t~\x7f\xef\xbf\xbe\xef\xbf\xbf\x1f\n\xc2\x80>");
    const char *s = svg_of(&d, 192);
    assert_says(s, "viewBox=\"0 0 192 128\" width=\"192\" height=\"128\"");
    assert_says(s, "<line class=\"s-good\" stroke=\"#00775a\" stroke-width=\"3\" x1=\"8\" y1=\"107\" x2=\"80\" y2=\"107.5\"/>");
    assert_says(s, "<line class=\"s-bad\" stroke=\"#c4391a\" stroke-width=\"2\" x1=\"8\" y1=\"88\" x2=\"71.2\" y2=\"88\"/>");
    assert_says(s, "<polygon class=\"t-bad\" fill=\"#c4391a\" points=\"80,88 69,92.4 69,83.6\"/>");
    assert_says(s, "<line class=\"s-accent\" stroke=\"#a85800\" stroke-width=\"1.5\" stroke-dasharray=\"6 5\"");
    assert_says(s, "<circle class=\"s-body f-body2\" fill=\"#f3d9e8\" stroke=\"#0067a5\" stroke-width=\"3\" cx=\"120\" cy=\"32\" r=\"20\"/>");
    assert_says(s, "<circle class=\"f-faint\" fill=\"#e9edf1\" cx=\"122\" cy=\"32\" r=\"20\"/>");
    assert_says(s, "<polygon class=\"s-faint\" stroke=\"#87919c\" stroke-width=\"3\" points=\"120,120 180,120 150,67\"/>");
    assert_says(s, "<polyline class=\"s-text\" stroke=\"#1a202c\" stroke-width=\"3\" points=\"120,120 180,120\"/>");
    assert_says(s, "<circle class=\"t-bad\" fill=\"#c4391a\" cx=\"171\" cy=\"17\" r=\"3\"/>");
    assert_says(s, "<text class=\"t-text\" fill=\"#1a202c\" x=\"2\" y=\"124\" font-size=\"13\" text-anchor=\"middle\">a&#60;b &#38; &#8869; &#65533;</text>");
    assert_says(s, "text-anchor=\"start\"> ~&#65533;&#65533;&#65533;&#65533; &#128;&#62;</text>");
    assert_string_equal(s + strlen(s) - 7, "</svg>\n");
    assert_string_equal(s, svg_of(&d, 192));
    for (const char *c = s; *c; c++) assert_true(*c == '\n' || (*c >= 32 && *c < 127));
}

TEST(svg_numbers_are_short)
{
    static const struct { float x; const char *text; } cases[] = {
        { 0, "x1=\"0\"" }, { 1, "x1=\"1\"" }, { 0.5f, "x1=\"0.5\"" }, { 0.25f, "x1=\"0.25\"" }, { 0.126f, "x1=\"0.13\"" },
        { -0.126f, "x1=\"-0.13\"" }, { -0.001f, "x1=\"0\"" }, { 1.999f, "x1=\"2\"" }, { 0.05f, "x1=\"0.05\"" },
        { -7.1f, "x1=\"-7.1\"" }, { 1e9f, "x1=\"10000000\"" }, { -1e9f, "x1=\"-10000000\"" }, { 96.04f, "x1=\"96.04\"" },
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        wfDraw d = new_list();
        wfDrawLine(&d, cases[i].x, 0, 1, 1, 1, WF_INK_LINE);
        assert_says(svg_of(&d, 96), cases[i].text);
    }
}

TEST(svg_refuses_bad_widths)
{
    wfDraw d = new_list();
    FILE *out = tmpfile();
    assert_int_equal(wfWriteSvg(&d, 0, out), -1);
    assert_int_equal(wfWriteSvg(&d, -5, out), -1);
    assert_int_equal(wfWriteSvg(&d, 16385, out), -1);
    assert_int_equal(ftell(out), 0);
    assert_int_equal(wfWriteSvg(&d, 16384, out), 0);
    fclose(out);
}

TEST(svg_fits_any_view)
{
    wfDraw d = new_list();
    wfDrawView(&d, -2, 1, 6, 5);
    wfDrawLine(&d, -2, 1, 6, 5, 1, WF_INK_LINE);
    const char *s = svg_of(&d, 800);
    assert_says(s, "viewBox=\"0 0 800 400\"");
    assert_says(s, "x1=\"0\" y1=\"400\" x2=\"800\" y2=\"0\"");
}

TEST(a_full_disk_is_told)
{
    FILE *full = fopen("/dev/full", "w");
    if (full == NULL) skip();  /* only some systems have it */
    setvbuf(full, NULL, _IONBF, 0);
    wfDraw d = new_list();
    assert_int_equal(wfWriteSvg(&d, 100, full), -1);
    assert_int_equal(wfWriteSvgStyle(full), -1);
    fclose(full);
}

TEST(the_style_sheet_knows_every_role)
{
    char text[16384], part[64];
    FILE *out = tmpfile();
    assert_int_equal(wfWriteSvgStyle(out), 0);
    rewind(out);
    text[fread(text, 1, sizeof text - 1, out)] = 0;
    fclose(out);
    for (int role = 0; role < WF_INK_COUNT; role++) {
        const char *n = wfInkName(role);
        wfInk m = wfLightPalette.mark[role], a = wfDarkPalette.area[role];
        snprintf(part, sizeof part, ".s-%s { stroke: var(--mark-%s); }", n, n);
        assert_says(text, part);
        snprintf(part, sizeof part, ".f-%s { fill: var(--area-%s); }", n, n);
        assert_says(text, part);
        snprintf(part, sizeof part, ".t-%s { fill: var(--mark-%s); }", n, n);
        assert_says(text, part);
        snprintf(part, sizeof part, "--mark-%s: #%02x%02x%02x;", n, m.r, m.g, m.b);
        assert_says(text, part);
        snprintf(part, sizeof part, "--area-%s: #%02x%02x%02x;", n, a.r, a.g, a.b);
        assert_says(text, part);
    }
}
