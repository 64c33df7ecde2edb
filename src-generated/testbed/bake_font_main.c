/* Weft: testbed/bake_font_main.c, tangled from chapters/testbed/03-drawing-pixels.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
/* bake-font FONT.ttf SIZE ... : writes the font's letters at these sizes as a C file. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb_truetype.h>

static const struct { int first, last; } ranges[] = {
    { 0x20, 0x7e }, { 0xa0, 0xb1 }, { 0xb2, 0xb2 }, { 0xb3, 0xff },         /* Latin */
    { 0x391, 0x3a9 }, { 0x3b1, 0x3c9 },      /* Greek */
    { 0x2013, 0x2014 }, { 0x2018, 0x201d }, { 0x2022, 0x2022 }, { 0x2026, 0x2026 },
    { 0x2032, 0x2033 }, { 0x2070, 0x2070 }, { 0x2074, 0x208e },  /* primes, small digits */
    { 0x20ac, 0x20ac },
    { 0x2190, 0x2193 }, { 0x2202, 0x2202 }, { 0x2206, 0x2207 }, { 0x2211, 0x2212 },
    { 0x221a, 0x221a }, { 0x221e, 0x221e }, { 0x2225, 0x2225 }, { 0x222b, 0x222b },
    { 0x2248, 0x2248 }, { 0x2260, 0x2260 }, { 0x2264, 0x2265 }, { 0x22a5, 0x22a5 },
    { 0x25b6, 0x25b6 }, { 0x25bc, 0x25bc }, { 0x2713, 0x2713 }, { 0xfffd, 0xfffd },
};
static int range_count = sizeof ranges / sizeof *ranges, few, shades = 256;

static int is_left_out(int r)           /* of a page: all but ASCII, a square, U+FFFD */
{
    return few && r != 0 && r != 2 && r != range_count - 1;
}
enum { ATLAS_WIDTH = 1024, ATLAS_HEIGHT = 2048 };
static unsigned char atlas[ATLAS_WIDTH * ATLAS_HEIGHT];
typedef struct shelf { int x, y, height; } shelf;

static int place(shelf *s, int w, int h, int *x, int *y)
{
    if (s->x + w + 1 > ATLAS_WIDTH) {
        s->y += s->height + 1;
        s->x = s->height = 0;
    }
    if (s->y + h + 1 > ATLAS_HEIGHT) return 0;
    *x = s->x;
    *y = s->y;
    s->x += w + 1;
    if (h > s->height) s->height = h;
    return 1;
}

static unsigned char *read_file(const char *path)
{
    FILE *in = fopen(path, "rb");
    if (!in) return NULL;
    fseek(in, 0, SEEK_END);
    long size = ftell(in);
    rewind(in);
    unsigned char *bytes = size > 0 ? malloc((size_t)size) : NULL;
    if (bytes && fread(bytes, 1, (size_t)size, in) != (size_t)size) {
        free(bytes);
        bytes = NULL;
    }
    fclose(in);
    return bytes;
}

static int bake(const stbtt_fontinfo *font, float scale, int letter, shelf *s)
{
    int x0, y0, x1, y1, advance, bearing, x = 0, y = 0;
    stbtt_GetCodepointHMetrics(font, letter, &advance, &bearing);
    stbtt_GetCodepointBitmapBox(font, letter, scale, scale, &x0, &y0, &x1, &y1);
    int w = x1 - x0, h = y1 - y0;
    if (!place(s, w, h, &x, &y)) return 0;
    if (w > 0 && h > 0)
        stbtt_MakeCodepointBitmap(font, atlas + y * ATLAS_WIDTH + x, w, h, ATLAS_WIDTH,
                                  scale, scale, letter);
    printf("{0x%x,%d,%d,%d,%d,%d,%d,%.3ff},\n", (unsigned)letter, x, y, w, h, x0, -y0,
           (double)((float)advance * scale));
    return 1;
}

static void write_atlas(int rows)
{
    printf("static const uint8_t cover[] = {\n");
    for (int i = 0; i < rows * ATLAS_WIDTH; i++)
        printf("%d,%s", (atlas[i] * (shades - 1) + 127) / 255 * 255 / (shades - 1),
               i % 64 == 63 ? "\n" : "");
    printf("};\n");
}

static void write_sizes(const stbtt_fontinfo *font, int count, char **sizes)
{
    int ascent, descent, gap;
    stbtt_GetFontVMetrics(font, &ascent, &descent, &gap);
    printf("static const wfFontSize sizes[] = {\n");
    for (int i = 0; i < count; i++) {
        float px = (float)atof(sizes[i]), scale = stbtt_ScaleForMappingEmToPixels(font, px);
        printf("{%.3ff,%.3ff,%.3ff},\n", (double)px, (double)((float)ascent * scale),
               (double)(-(float)descent * scale));
    }
    printf("};\n");
}

int main(int argc, char **argv)
{
    stbtt_fontinfo font;
    shelf s = { 0, 0, 0 };
    int letters = 0;
    if (argc > 1 && strcmp(argv[1], "--ascii") == 0) {
        few = 1;
        shades = 16;
        argc--, argv++;
    }
    unsigned char *bytes = argc > 2 ? read_file(argv[1]) : NULL;
    if (!bytes || !stbtt_InitFont(&font, bytes, 0)) {
        fprintf(stderr, "use: bake-font [--ascii] FONT.ttf SIZE ... > font_atlas.c\n");
        free(bytes);
        return 2;
    }
    printf("/* Made by bake-font. */\n#include \"testbed/font.h\"\n");
    printf("static const wfGlyph glyphs[] = {\n");
    for (int size = 2; size < argc; size++) {
        float scale = stbtt_ScaleForMappingEmToPixels(&font, (float)atof(argv[size]));
        letters = 0;
        for (int r = 0; r < range_count; r++)
            for (int letter = ranges[r].first;
                 !is_left_out(r) && letter <= ranges[r].last; letter++, letters++)
                if (!bake(&font, scale, letter, &s)) {
                    fprintf(stderr, "bake-font: the atlas is full -- bake fewer sizes\n");
                    free(bytes);
                    return 1;
                }
    }
    printf("};\n");
    write_sizes(&font, argc - 2, argv + 2);
    int rows = s.y + s.height + 1;
    write_atlas(rows);
    printf("const wfFont wfBakedFont = { cover, %d, %d, sizes, %d, glyphs, %d };\n",
           ATLAS_WIDTH, rows, argc - 2, letters);
    free(bytes);
    return 0;
}
