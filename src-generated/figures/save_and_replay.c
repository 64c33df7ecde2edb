/* Weft: figures/save_and_replay.c, tangled from chapters/methods/29-save-and-replay.figures.nw. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include "engine/image.h"
#include "weft/save.h"
#include "figures/kit.h"

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

/* regions under 20 kB would have no width: not drawn, but in the sum */
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
        /* draw a region and what of it counts */
        float full = 6.2e-6f * (float)room, part = 6.2e-6f * (float)image.bytes[i];
        figBar(d, 2.2f, y, full, 0.34f, WF_INK_NONE);
        if (part > 0) figBar(d, 2.2f, y, part, 0.34f, WF_INK_BODY);
        wfDrawText(d, 2.05f, y + 0.1f, 12, WF_INK_TEXT, 1, wfRegionTable[i].name);
        wfDrawTextf(d, 2.35f + full, y + 0.1f, 11, WF_INK_TEXT, -1, "%d of %d kB",
                    (int)(image.bytes[i] / 1000), (int)(room / 1000));
        y -= 0.47f;
    }
    wfDrawTextf(d, 9.8f, 0.15f, 13, WF_INK_TEXT, 1, "all: %d of %d kB",
                (int)(counts / 1000), (int)(all / 1000));
    wfDestroyWorld(&world);
}

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
    figBar(d, 0.3f, 1.2f, 9.4f, 0.8f, WF_INK_NONE);
    /* let a world grow and keep it at each step */
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
        /* draw the newest snapshot of the ring and go one back */
        float scale = 9.4f / (float)sizeof bytes, x = 0.3f + scale * (float)walk.newest;
        size_t size;
        bool first = newest == LAST, last = oldest == newest;
        if (wfRewindTo(&walk, &world, newest) != WF_OK) break;
        size = wfSnapshotSize(&world);
        figBar(d, x, 1.2f, scale * (float)size, 0.8f, first ? WF_INK_ACCENT : WF_INK_BODY);
        wfDrawTextf(d, x + scale * (float)size / 2, 1.52f, 12, WF_INK_TEXT, 0, "%d", (int)newest);
        if (first) wfDrawText(d, x, 0.75f, 12, WF_INK_TEXT, -1, "newest");
        if (last) wfDrawText(d, x, 2.25f, 12, WF_INK_TEXT, -1, "oldest");
        if (last || newest == 0 || wfRewindTo(&walk, &world, newest - 1) != WF_OK) break;
    }
    wfDestroyWorld(&world);
}
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

static void figure_save_journal(wfDraw *d, const wfFigureInput *in)
{
    static _Alignas(16) uint8_t bytes[4096];
    /* what the player of the figure does */
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
    /* draw the entries of the journal */
    float scale = 5.4f / (float)end[1];
    for (int i = 0; i < ROWS; i++) {
        float y = 3.5f - 0.5f * (float)i, w = scale * (float)(end[i + 1] - end[i]);
        figBar(d, 2.4f, y, w, 0.36f, row[i].ink);
        wfDrawText(d, 2.2f, y + 0.1f, 13, WF_INK_TEXT, 1, row[i].name);
        wfDrawTextf(d, 2.55f + w, y + 0.1f, 13, WF_INK_TEXT, -1, "%d bytes",
                    (int)(end[i + 1] - end[i]));
    }
    wfDrawTextf(d, 9.8f, 0.5f, 13, WF_INK_TEXT, 1, "all: %d bytes", (int)j.used);
    wfDestroyWorld(&world);
}
static float ruler_x(double value) { return 0.4f + 9.2f * (float)((value - 1000) / 6e-4); }

static void ruler_ticks(wfDraw *d, double step, float y, float length)
{
    wfDrawLine(d, 0.3f, y, 9.7f, y, 1, WF_INK_LINE);
    for (int i = 0; i * step <= 6.001e-4; i++) {
        float x = ruler_x(1000 + i * step);
        wfDrawLine(d, x, y - length / 2, x, y + length / 2, 1.2f, WF_INK_LINE);
    }
}

/* The nearest decimal: so many units above 1000.
   24 binary digits, nine before the point: floats near 1000 are 2^(9-23) apart. */
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
        /* join a float to its two decimals */
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
static const wfFigureRow rows[] = {
    { "save-used", figure_save_used, 10.0f, 5.4f, 0, {{0}} },
    { "save-ring", figure_save_ring, 10.0f, 2.7f, 0, {{0}} },
    { "save-journal", figure_save_journal, 10.0f, 4.2f, 0, {{0}} },
    { "save-digits", figure_save_digits, 10.0f, 3.5f, 0, {{0}} },
};
const wfFigureSet save_and_replay_figures = WF_ROWS(rows);
