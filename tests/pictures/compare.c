/* Pictures of the testbed, made by scripted input, compared with those that were looked at once (the PNG files beside this one).
 *   compare LIST [NAME ...]           compares; a difference is told with its place and drawn in build/pictures/NAME.png
 *   compare --write LIST [NAME ...]   records anew: look at them first, --full DIR has them in full size
 *   compare --self LIST               small changes that anybody would see must be noticed, and those that nobody would must not
 * A line of the list: NAME WIDTH HEIGHT SCALE | an input script of the chapter platform, its lines parted by `;'; `@Widget' clicks a widget,
 * `~Widget' rests over it.
 * Perceptual tolerance: a picture is kept in a quarter of its size, which is what blurs; then no square of 3 x 3 of these pixels
 * may differ by more than 9 of 255 steps in the mean of any colour. Letters may move by a third of a pixel and edges may change
 * their grey; a row that moves by its height, a colour, a word may not. */
#define OWN_MAIN
#include "../play.h"
#include <stdio.h>
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb_image_write.h>

enum { SMALLER = 4, MOST_OFF = 9, MOST_SCRIPT = 4000 };
typedef struct small { int w, h; unsigned char *rgb; } small;

static small reduce(const frame_buffer *b)
{
    int by = SMALLER * (int)b->scale;
    small s = { b->width / by, b->height / by, NULL };
    s.rgb = malloc((size_t)(3 * s.w * s.h));
    for (int y = 0; y < s.h; y++)
        for (int x = 0; x < s.w; x++)
            for (int k = 0; k < 3; k++) {
                int sum = 0;
                for (int j = 0; j < by; j++)
                    for (int i = 0; i < by; i++)
                        sum += ((const unsigned char *)(b->pixels + (y * by + j) * b->pitch + x * by + i))[k];
                s.rgb[3 * (y * s.w + x) + k] = (unsigned char)((sum + by * by / 2) / (by * by));
            }
    return s;
}

/* The largest mean difference of a square, and where: its middle. */
static int worst(const small *a, const small *b, int *at_x, int *at_y)
{
    int most = 0;
    for (int y = 1; y + 1 < a->h; y++)
        for (int x = 1; x + 1 < a->w; x++)
            for (int k = 0; k < 3; k++) {
                int sum = 0;
                for (int j = -1; j <= 1; j++)
                    for (int i = -1; i <= 1; i++) {
                        int n = 3 * ((y + j) * a->w + x + i) + k;
                        sum += a->rgb[n] - b->rgb[n];
                    }
                sum = abs(sum) / 9;
                if (sum > most) most = sum, *at_x = x, *at_y = y;
            }
    return most;
}

/* What was recorded, what came, and where they differ (red), under each other. */
static void write_difference(const char *name, const small *a, const small *b)
{
    char path[300];
    int n = a->w * a->h;
    unsigned char *three = malloc((size_t)(9 * n));
    memcpy(three, a->rgb, (size_t)(3 * n));
    memcpy(three + 3 * n, b->rgb, (size_t)(3 * n));
    for (int i = 0; i < n; i++) {
        int off = 0;
        for (int k = 0; k < 3; k++) off = abs(a->rgb[3 * i + k] - b->rgb[3 * i + k]) > off ? abs(a->rgb[3 * i + k] - b->rgb[3 * i + k]) : off;
        unsigned char grey = (unsigned char)(200 + a->rgb[3 * i + 1] / 5), *p = three + 6 * n + 3 * i;
        p[0] = grey, p[1] = p[2] = (unsigned char)(off > 4 ? 0 : grey);
    }
    snprintf(path, sizeof path, "build/pictures/%s.png", name);
    stbi_write_png(path, a->w, 3 * a->h, 3, three, 3 * a->w);
    free(three);
}

static void play_part(play *p, char *part)
{
    char script[400];
    while (*part == ' ') part++;
    for (size_t n = strlen(part); n && (part[n - 1] == ' ' || part[n - 1] == '\n'); ) part[--n] = 0;
    if (*part == '@') play_click(p, part + 1);
    else if (*part == '~') {
        char label[80];
        snprintf(label, sizeof label, "widget %s pixel", part + 1);
        snprintf(script, sizeof script, "steps 0\nseconds 0.02\nmove %g %g\nwait 50\n", play_fact(p, label, 0), play_fact(p, label, 1));
        play_run(p, script);
    } else if (*part) {
        snprintf(script, sizeof script, "%s\n", part);
        play_run(p, script);
    }
}

/* Plays a line of the list; false for a remark. */
static bool play_row(char *line, char name[64], play *p)
{
    int width, height;
    float scale;
    char *script = strchr(line, '|');
    if (line[0] == '#' || !script || sscanf(line, "%63s %d %d %f", name, &width, &height, &scale) != 4) return false;
    *p = play_open((int)((float)width * scale), (int)((float)height * scale), scale);
    char whole[MOST_SCRIPT] = "";                   /* words before clicks go in one piece: an input script keeps what it said */
    for (char *part = strtok(script + 1, ";"); part; part = strtok(NULL, ";")) {
        while (*part == ' ') part++;
        if (*part != '@' && *part != '~') {
            strncat(whole, part, sizeof whole - strlen(whole) - 2);
            strcat(whole, "\n");
            continue;
        }
        if (whole[0]) play_run(p, whole);
        whole[0] = 0;
        play_part(p, part);
    }
    if (whole[0]) play_run(p, whole);
    return true;
}

static const char *folder = "tests/pictures";

static int compare(const char *name, const small *now)
{
    char path[300];
    int w = 0, h = 0, n = 0, x = 0, y = 0;
    snprintf(path, sizeof path, "%s/%s.png", folder, name);
    unsigned char *rgb = stbi_load(path, &w, &h, &n, 3);
    if (!rgb) { printf("%s: no picture was recorded -- look at it (make pictures FULL=DIR), then make pictures\n", name); return 1; }
    small was = { w, h, rgb };
    int off = w == now->w && h == now->h ? worst(&was, now, &x, &y) : 255;
    if (off > MOST_OFF) {
        if (w == now->w && h == now->h) write_difference(name, &was, now);
        printf("%s: looks different by %d of 255 about (%d, %d) of the window -- see build/pictures/%s.png: recorded, now, where\n",
               name, off, SMALLER * x + SMALLER / 2, SMALLER * y + SMALLER / 2, name);
    }
    stbi_image_free(rgb);
    return off > MOST_OFF;
}

/* ---- can it fail? ---- */
static uint32_t *copy_of(const frame_buffer *b)
{
    size_t bytes = (size_t)(b->pitch * b->height) * 4;
    uint32_t *copy = malloc(bytes);
    memcpy(copy, b->pixels, bytes);
    return copy;
}

/* Moves a part of the picture down. */
static void move_down(frame_buffer *b, int x, int y, int w, int h, int by)
{
    for (int row = y + h - 1; row >= y + by; row--) memcpy(b->pixels + row * b->pitch + x, b->pixels + (row - by) * b->pitch + x, (size_t)w * 4);
}

static void paint_over(frame_buffer *b, int x, int y, int w, int h, int red, int green, int blue)
{
    for (int j = y; j < y + h; j++)
        for (int i = x; i < x + w; i++) b->pixels[j * b->pitch + i] = (uint32_t)(red | green << 8 | blue << 16) | 0xff000000u;
}

static int told(const char *what, bool noticed, bool wanted)
{
    printf("  %-52s %s\n", what, noticed == wanted ? noticed ? "noticed" : "borne" : noticed ? "NOTICED" : "NOT NOTICED");
    return noticed != wanted;
}

static int self(char *line)
{
    play p;
    char name[64];
    int x, y, bad = 0;
    if (!play_row(line, name, &p)) return 1;
    frame_buffer b = p.buffer;
    const uint32_t *as_was = copy_of(&b);
    small was = reduce(&b), now;
    int left = b.width - 280, bx = (int)play_fact(&p, "widget solver pixel", 0), by = (int)play_fact(&p, "widget solver pixel", 1);
    for (int trial = 0; trial < 7; trial++) {
        static const char *const what[] = { "a panel's rows 6 pixels lower", "a field in another colour", "a word that is missing",
                                            "the panel away", "the whole a little warmer, as another palette",
                                            "each pixel off by up to 3 steps", "all edges a little softer" };
        memcpy(b.pixels, as_was, (size_t)(b.pitch * b.height) * 4);
        if (trial == 0) move_down(&b, left, 180, 280, 400, 6);
        if (trial == 1) paint_over(&b, bx + 60, by - 8, 70, 16, 0xfb, 0xe0, 0xbd);
        if (trial == 2) paint_over(&b, left, by - 9, 44, 18, 255, 255, 255);
        if (trial == 3) paint_over(&b, left, 130, 280, 500, 255, 255, 255);
        for (int i = 0; i < b.width * b.height && trial >= 4; i++) {
            unsigned char *c = (unsigned char *)(b.pixels + i);
            if (trial == 4) c[2] = (unsigned char)(c[2] > 14 ? c[2] - 14 : 0);
            if (trial == 5) c[i % 3] = (unsigned char)(c[i % 3] > 250 ? c[i % 3] - i % 4 : c[i % 3] + i % 4);
            const unsigned char *before = (const unsigned char *)(as_was + (i ? i - 1 : 0));
            if (trial == 6) for (int k = 0; k < 3; k++) c[k] = (unsigned char)((2 * c[k] + before[k]) / 3);
        }
        now = reduce(&b);
        bad += told(what[trial], worst(&was, &now, &x, &y) > MOST_OFF, trial < 5);
    }
    return bad;
}

int main(int argc, char **argv)
{
    bool write = false, prove = false;
    const char *full = NULL;
    int at = 1, pictures = 0, failed = 0;
    for (; at < argc && argv[at][0] == '-'; at++) {
        if (strcmp(argv[at], "--write") == 0) write = true;
        else if (strcmp(argv[at], "--self") == 0) prove = true;
        else if (strcmp(argv[at], "--full") == 0 && at + 1 < argc) full = argv[++at];
        else return 2;
    }
    FILE *list = at < argc ? fopen(argv[at++], "r") : NULL;
    if (!list) { fprintf(stderr, "use: compare [--write | --self] [--full DIR] LIST [NAME ...]\n"); return 2; }
    static char line[MOST_SCRIPT], path[300];
    while (fgets(line, sizeof line, list)) {
        char name[64] = "";
        play p;
        bool wanted = at >= argc;
        sscanf(line, "%63s", name);
        for (int i = at; i < argc; i++) wanted |= strcmp(argv[i], name) == 0;
        if (prove) wanted = strcmp(name, "panel-world") == 0;
        if (!wanted || name[0] == '#') continue;
        if (prove) { failed = self(line); pictures = 1; break; }
        if (!play_row(line, name, &p)) continue;
        pictures++;
        if (full) {
            snprintf(path, sizeof path, "%s/%s.png", full, name);
            stbi_write_png(path, p.buffer.width, p.buffer.height, 4, p.buffer.pixels, 4 * p.buffer.pitch);
        }
        small now = reduce(&p.buffer);
        if (write) {
            snprintf(path, sizeof path, "%s/%s.png", folder, name);
            stbi_write_png_compression_level = 9;
            failed += stbi_write_png(path, now.w, now.h, 3, now.rgb, 3 * now.w) == 0;
        } else if (!full) failed += compare(name, &now);
        free(now.rgb);
        play_end(&p);
    }
    fclose(list);
    printf(prove ? "%d changes were judged wrongly\n" : write ? "%d pictures recorded\n" : "%d pictures", prove ? failed : pictures);
    if (!prove && !write) printf(", %d look different\n", failed);
    return failed != 0 || pictures == 0;
}
