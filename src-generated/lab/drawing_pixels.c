/* Weft: lab/drawing_pixels.c, tangled from chapters/testbed/03-drawing-pixels.lab.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "testbed/raster.h"
#include "lab/bench.h"

/* The ink of shape k, moved by (x, y), in a picture of 32 x 32 pixels. */
static double drawing_ink(int k, float size, float x, float y, bool jagged)
{
    static wfCoverRow row;
    double sum = 0;
    const float from[2] = { 6 + x, 9 + y }, to[2] = { 22 + x, 17 + y };
    const float s = size / 10;
    const float triangle[6] = { 6 + x, -(6 + y), 6 + x + 18 * s, -(9 + y),
                                6 + x + 7 * s, -(6 + y + 17 * s) };
    wfCoverBegin(&row, 0, 0, 32);
    for (row.y = 0; row.y < 32; row.y++) {
        if (k == 0) wfCoverLine(&row, from, to, 0.5f * size);
        if (k == 1) wfCoverDisc(&row, 14 + x, 14 + y, size);
        if (k == 2) wfCoverRing(&row, 14 + x, 14 + y, 10, 0.5f * size);
        if (k == 3) wfCoverPolygon(&row, (wfPixelMap){ 1, 0, 0 }, triangle, 3);
        for (int32_t i = row.low; i < row.high; i++)
            sum += jagged ? (row.at[i] >= 0.5f) : (double)row.at[i];
        wfCoverClear(&row);
    }
    return sum;
}

static double drawing_area(int k, double size)
{
    const double pi = 3.14159265358979;
    double s = size / 10, length = 17.88854382;
    switch (k) {
    case 0: return size * length + pi * size * size / 4;
    case 1: return pi * size * size;
    case 2: return 2 * pi * 10 * size;
    default: return 0.5 * (18 * s * 17 * s - 7 * s * 3);
    }
}

static int measure_drawing_coverage(FILE *out)
{
    static const struct { const char *name; int kind; float size; } shape[] = {
        { "line", 0, 1 }, { "line", 0, 2 }, { "disc", 1, 1 }, { "disc", 1, 5 },
        { "ring", 2, 1 }, { "ring", 2, 2 }, { "triangle", 3, 5 }, { "triangle", 3, 10 },
    };
    fprintf(out, "shape,size,area,mean,off,jagged\n");
    for (size_t n = 0; n < sizeof shape / sizeof *shape; n++) {
        double area = drawing_area(shape[n].kind, (double)shape[n].size);
        double mean = 0, off = 0, jagged = 0;
        for (int place = 0; place < 256; place++) {
            float x = (float)(place % 16) / 16, y = (float)(place / 16) / 16;
            double smooth = drawing_ink(shape[n].kind, shape[n].size, x, y, false);
            double rough = drawing_ink(shape[n].kind, shape[n].size, x, y, true);
            mean += smooth / 256;
            /* keep the largest distance from the area */
            double a = smooth > area ? smooth - area : area - smooth;
            double b = rough > area ? rough - area : area - rough;
            off = a > off ? a : off;
            jagged = b > jagged ? b : jagged;
        }
        fprintf(out, "%s,%g,%.2f,%.2f,%.2f,%.2f\n", shape[n].name, (double)shape[n].size,
                area, mean, off, jagged);
    }
    return 0;
}
/* n boxes and n circles of a given half size (px) in even rows. */
static void drawing_bodies(wfDraw *d, int n, float half)
{
    wfDrawReset(d);
    wfDrawView(d, 0, 0, 1280, 720);
    for (int i = 0; i < n; i++) {
        float x = 10 + (float)(i % 40) * 31.3f, y = 10 + (float)(i / 40) * 13.7f, h = half;
        float box[8] = { x - h, y - 0.8f * h, x + 0.9f * h, y - h,
                         x + h, y + 0.8f * h, x - 0.9f * h, y + h };
        wfDrawPolygon(d, box, 4, 1.5f, WF_INK_BODY, WF_INK_BODY);
        wfDrawCircle(d, x + 15.3f, y, h, 1.5f, WF_INK_BODY2, WF_INK_BODY2);
    }
}

static int measure_drawing_time(FILE *out)
{
    enum { WIDE = 1280, HIGH = 720, FRAMES = 20 };
    _Alignas(8) static unsigned char memory[1 << 20];
    static uint32_t pixels[WIDE * HIGH];
    frame_buffer picture = { pixels, WIDE, HIGH, WIDE, 1 };
    wfDraw d;
    wfDrawInit(&d, memory, sizeof memory);
    fprintf(out, "bodies,half,ms\n");
    for (int n = 0; n <= 2000; n = n == 0 ? 500 : 2 * n)
        for (int half = 4; half <= 8; half += 4) {
            double least = 1;
            drawing_bodies(&d, n / 2, (float)half);
            for (int frame = 0; frame < FRAMES; frame++) {
                double start = labSeconds();
                wfClearFrame(&picture, wfLightPalette.mark[WF_INK_PAPER]);
                wfRenderList(&d, NULL, &wfLightPalette, &picture);
                double seconds = labSeconds() - start;
                if (seconds < least) least = seconds;
            }
            fprintf(out, "%d,%d,%.3f\n", n, half, 1000 * least);
        }
    return d.overflow + d.refused;
}

static const wfMeasureRow rows[] = {
    { "drawing-coverage", "ink against area, smooth and jagged", measure_drawing_coverage },
    { "drawing-time", "milliseconds to draw a frame of 1280 x 720", measure_drawing_time },
};
const wfMeasureSet drawing_pixels_measurements = WF_ROWS(rows);
