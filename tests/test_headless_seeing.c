/* Overlays that look into a step, curves, and worlds compared. */
#include "play.h"
#include "testbed/overlays.h"
#include "testbed/platform.h"
#include "testbed/plots.h"
#include "testbed/raster.h"
#include "testbed/scene.h"
#include "weft/save.h"

/* ---- worlds ---- */
static wfWorld open(const char *scene, int steps)
{
    wfWorld world;
    const wfScene *row = wfSceneAt(wfFindScene(scene));
    assert_int_equal(wfOpenScene(row, NULL, &world), WF_OK);
    for (int i = 0; i < steps; i++) {
        wfSceneInput in = wfSceneInputAt(row, i);
        assert_int_equal(wfStepScene(row, &world, &in), WF_OK);
    }
    return world;
}

static wfPool pool(size_t bytes)
{
    wfPool out;
    wfPoolInit(&out, bytes, aligned_alloc(64, bytes));
    return out;
}

/* The pair at a place is the nearest shape, and the one nearest to that: asked again, of all, one by one. */
TEST(the_pair_is_the_nearest)
{
    wfWorld w = open("shapes", 60);
    wfShapeView s = wfWorldShapes(&w);
    wfBodyView v = wfWorldBodies(&w);
    for (int n = 0; n < 40; n++) {
        wfVec2 at = wfV2((wfReal)(n % 8) - 4, (wfReal)(n / 8));
        int32_t a, b;
        assert_true(wfPairAt(&w, at, &a, &b));
        assert_true(s.bodyOfShape[a] != s.bodyOfShape[b]);
        wfShape point;
        assert_int_equal(wfMakeCircle(at, WF_R(1e-4), &point), WF_OK);
        wfTransform here = { wfV2(0, 0), wfRotation(0) }, xa = wfBodyTransform(&v.state[s.bodyOfShape[a]]);
        wfDistanceResult best, other;
        assert_int_equal(wfShapeDistance(&point, here, &s.shapes[a], xa, &best), WF_OK);
        for (int32_t k = 0; k < s.count; k++) {
            if (s.bodyOfShape[k] < 0) continue;
            wfTransform xk = wfBodyTransform(&v.state[s.bodyOfShape[k]]);
            assert_int_equal(wfShapeDistance(&point, here, &s.shapes[k], xk, &other), WF_OK);
            assert_true(other.distance >= best.distance - WF_R(2e-4));
        }
    }
    wfDestroyWorld(&w);
    w = open("spring and orbit", 0);            /* particles have no shape */
    int32_t a, b;
    if (wfShapeCount(&w) < 2) assert_false(wfPairAt(&w, wfV2(0, 0), &a, &b));
    wfDestroyWorld(&w);
}

/* The last cut leaves the points of the manifold that the engine makes of the same pair. */
TEST(the_last_cut_is_the_manifold)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld w;
    wfBodyId id[2];
    wfRandom random = random_stream(7);
    int same = 0;
    for (int n = 0; n < 400; n++) {
        def.memory = (wfMemory){ 0 };
        assert_int_equal(wfCreateWorld(&def, &w), WF_OK);
        for (int i = 0; i < 2; i++) {
            wfBodyDef body = wfDefaultBodyDef();
            wfReal size = WF_R(0.5) + wfRandomReal(&random, 0, 1) / 2;
            assert_int_equal(wfMakeBox(size, size, &body.shape), WF_OK);
            body.angle = 6 * wfRandomReal(&random, 0, 1) - 3;
            body.position = wfV2((wfReal)i * (1 + WF_R(0.4) * wfRandomReal(&random, 0, 1)), wfRandomReal(&random, 0, 1) / 2);
            assert_int_equal(wfAddBodyToWorld(&w, &body, &id[i]), WF_OK);
        }
        wfShapeView s = wfWorldShapes(&w);
        wfBodyView v = wfWorldBodies(&w);
        wfTransform xa = wfBodyTransform(&v.state[0]), xb = wfBodyTransform(&v.state[1]);
        wfLook look = { .shapeA = 0, .shapeB = 1 };
        wfManifold m;
        wfClipView c;
        int points = wfCollide(&s.shapes[0], xa, &s.shapes[1], xb, &m);
        if (points > 0 && wfClipAt(&w, &look, 4, &c)) {
            assert_int_equal(c.count, points);
            for (int p = 0; p < points; p++) {  /* the engine's point is half the depth further out */
                wfReal best = WF_HUGE;
                for (int k = 0; k < points; k++) {
                    wfVec2 mid = wfAddScaled(c.kept[k], m.points[p].depth / 2, c.normal);
                    best = wfMinR(best, wfLength(wfSub(mid, m.points[p].point)));
                }
                assert_true(best < WF_R(1e-5));
            }
            same++;
        }
        wfDestroyWorld(&w);
    }
    assert_true(same > 100);
}

static uint64_t hash_after(const char *scene, int steps, const char *solver, int iterations, int part_substep, int part_pass)
{
    wfWorld w = open(scene, steps), part;
    wfWorldDef def;
    wfPool scratch = pool(16 << 20);
    assert_int_equal(wfGetWorldDef(&w, &def), WF_OK);
    def.solver = wfFindSolver(solver);
    if (part_pass < 0) def.iterations = iterations;
    assert_int_equal(wfSetWorldDef(&w, &def), WF_OK);
    uint64_t hash;
    if (part_pass < 0) {
        assert_int_equal(wfStepWorld(&w), WF_OK);
        hash = wfHashWorld(&w);
    } else {
        uint64_t before = wfHashWorld(&w);
        assert_int_equal(wfPartOfStep(&w, part_substep, part_pass, &scratch, &part), WF_OK);
        hash = wfHashWorld(&part);
        assert_true(wfHashWorld(&w) == before);                 /* the world itself is left alone */
    }
    wfDestroyWorld(&w);
    free(scratch.base);
    return hash;
}

/* All substeps and passes of a part are the step; a part of k passes is a step of k passes. */
TEST(a_whole_part_is_the_step)
{
    wfWorldDef def = wfDefaultWorldDef();
    static const char *const solvers[] = { "soft", "sequential", "impulse" };
    for (int i = 0; i < 3; i++) {
        def.solver = wfFindSolver(solvers[i]);
        assert_true(def.solver >= 0);
        int32_t s = wfStepSubsteps(&def), p = wfStepPasses(&def);
        assert_true(hash_after("tower", 20, solvers[i], p, s, p) == hash_after("tower", 20, solvers[i], p, -1, -1));
    }
    for (int k = 1; k < 8; k++)
        assert_true(hash_after("tower", 20, "sequential", k, 1, k) == hash_after("tower", 20, "sequential", k, -1, -1));
    assert_true(hash_after("tower", 20, "sequential", 1, 1, 1) != hash_after("tower", 20, "sequential", 8, -1, -1));
}

/* A part that has no room says so. */
TEST(no_room_is_an_error)
{
    wfWorld w = open("tower", 2), part;
    wfPool scratch = pool(4096);
    assert_int_equal(wfPartOfStep(&w, 1, 1, &scratch, &part), WF_ERROR_MEMORY);
    wfDestroyWorld(&w);
    free(scratch.base);
}

/* ---- curves ---- */
TEST(axes_are_nice)
{
    wfRandom random = random_stream(3);
    for (int n = 0; n < 4000; n++) {
        double size = pow(10, 12 * (double)wfRandomReal(&random, 0, 1) - 6), a = size * (2 * (double)wfRandomReal(&random, 0, 1) - 1);
        double b = a + size * ((double)wfRandomReal(&random, 0, 1) + 0.01), from, to;
        double step = wfNiceAxis(a, b, 4, &from, &to);
        assert_true(from <= a + step * 1e-9 && to >= b - step * 1e-9);
        assert_true(from > a - step * 1.000001 && to < b + step * 1.000001);
        double f = step / pow(10, floor(log10(step) + 1e-9));
        assert_true(fabs(f - 1) < 1e-6 || fabs(f - 2) < 1e-6 || fabs(f - 5) < 1e-6);
        double count = (b - a) / step;
        assert_true(count > 4 / 1.6 && count < 4 * 1.6);
        assert_true(fabs(from / step - round(from / step)) < 1e-6);
    }
    double from, to, step = wfNiceAxis(5, 5, 4, &from, &to);        /* flat */
    assert_true(step > 0 && from < 5 && to > 5);
    step = wfNiceAxis(0, 0, 4, &from, &to);
    assert_true(step > 0 && from < 0 && to > 0);
    step = wfNiceAxis(100, 100.00001, 4, &from, &to);               /* rounding does not fill the window */
    assert_true(to - from >= 100 / 1000.0);
}

TEST(curves_are_the_worlds_numbers)
{
    static wfPlots plots;
    wfWorld w = open("cradle", 40), other = open("cradle", 10);
    double kinetic, potential, p[2], l;
    wfPlotInput in = { &w, &other, 1, 0.002, 0.016, NULL, true, false, { 0, 0 } };
    for (int i = 0; i < WF_PLOT_SAMPLES + 5; i++) wfPlotSample(&plots, &in);
    assert_int_equal(plots.count, WF_PLOT_SAMPLES);
    assert_int_equal(plots.next, 5);
    wfWorldEnergy(&w, &kinetic, &potential);
    wfWorldMomentum(&w, p, &l);
    assert_near(plots.value[0][4][0], kinetic, 1e-6 * kinetic + 1e-9);
    assert_near(plots.value[0][4][2], kinetic + potential, 1e-5 * fabs(kinetic + potential));
    assert_near(plots.value[1][4][0], p[0], 1e-6 * fabs(p[0]) + 1e-9);
    assert_near(plots.value[2][4][0], l, 1e-6 * fabs(l) + 1e-9);
    assert_near(plots.value[5][4][0], 2, 1e-6);
    assert_string_equal(wfPlotTable[WF_PLOT_ERROR].name, "error");
    wfBodyView a = wfWorldBodies(&w), b = wfWorldBodies(&other);
    double most = 0;
    for (int i = 0; i < a.count; i++) most = fmax(most, hypot((double)(a.state[i].p.x - b.state[i].p.x), (double)(a.state[i].p.y - b.state[i].p.y)));
    assert_true(most > 0.01);
    assert_near(plots.value[WF_PLOT_ERROR][4][0], most, 1e-5 * most);
    wfDestroyWorld(&w);
    wfDestroyWorld(&other);
}

/* ---- the game ---- */
enum { W = 1100, H = 700 };

static void frame(play *p, int steps)
{
    p->in.steps = steps;
    game_update_and_render(&p->memory, &p->in, &p->buffer);
    p->in.pressed = p->in.released = 0;
    p->in.key_count = 0;
    p->in.scene[0] = 0;
    game_describe(&p->memory, p->text, sizeof p->text);
}

static void begin(play *p, const char *scene)
{
    *p = play_open(W, H, 1);
    p->in.seconds = 1 / 60.0;
    snprintf(p->in.scene, sizeof p->in.scene, "%s", scene);
    frame(p, 0);
}

static void run(play *p, int steps) { for (int i = 0; i < steps; i++) frame(p, 1); }

static void key(play *p, int k)
{
    p->in.keys[0] = k;
    p->in.key_count = 1;
    frame(p, 0);
}

/* The last widget of that name: a panel's, if the list has one of the same. */
static void point_at(play *p, const char *widget)
{
    char want[64];
    const char *at = p->text, *hit = NULL;
    snprintf(want, sizeof want, "widget %s pixel ", widget);
    while ((at = strstr(at, want)) != NULL) hit = at, at++;
    if (!hit) fail_msg("there is no widget %s", widget);
    assert_int_equal(sscanf(hit + strlen(want), "%f %f", &p->in.mouse_x, &p->in.mouse_y), 2);
    frame(p, 0);
}

static void click(play *p, const char *widget)
{
    point_at(p, widget);
    p->in.pressed = p->in.held = GAME_BUTTON_LEFT;
    frame(p, 0);
    p->in.held = 0;
    p->in.released = GAME_BUTTON_LEFT;
    frame(p, 0);
}

static void drag(play *p, const char *widget, float x)
{
    point_at(p, widget);
    p->in.pressed = p->in.held = GAME_BUTTON_LEFT;
    frame(p, 0);
    p->in.mouse_x += x;
    frame(p, 0);
    p->in.held = 0;
    p->in.released = GAME_BUTTON_LEFT;
    frame(p, 0);
}

static const char *said(const play *p, const char *word)
{
    static char value[64];
    char want[40];
    snprintf(want, sizeof want, "\n%s ", word);
    const char *at = strstr(p->text, want);
    assert_non_null(at);
    assert_int_equal(sscanf(at + strlen(want), "%63[^\n]", value), 1);
    return value;
}

/* ---- pictures, with a perceptual tolerance: means of light over squares, like looking through half-closed eyes ---- */
enum { PW = 528, PH = 336, COLUMNS = 44, ROWS = 28 };
static uint32_t seen[PW * PH];

static void squint(double grid[ROWS][COLUMNS][3])
{
    for (int r = 0; r < ROWS; r++)
        for (int c = 0; c < COLUMNS; c++) {
            double sum[3] = { 0 };
            for (int y = r * PH / ROWS; y < (r + 1) * PH / ROWS; y++)
                for (int x = c * PW / COLUMNS; x < (c + 1) * PW / COLUMNS; x++)
                    for (int k = 0; k < 3; k++) sum[k] += ((const uint8_t *)&seen[y * PW + x])[k];
            for (int k = 0; k < 3; k++) grid[r][c][k] = sum[k] / (PW / COLUMNS) / (PH / ROWS);
        }
}

static const char *pictures = "tests/pictures/seeing.txt";
static FILE *written;

/* The picture must look like the one recorded under this name: no square's mean may differ by more than 16 of 255 steps
 * of any colour, and the mean difference must be below 0.5. WEFT_PICTURES=write records anew: look at them first, as
 * WEFT_PICTURES_DIR=... has them written as files. */
static void looks_like(const char *name)
{
    static double grid[ROWS][COLUMNS][3];
    static char line[COLUMNS * 6 + 8];
    char word[64], path[200];
    const char *look_in = getenv("WEFT_PICTURES_DIR"), *mode = getenv("WEFT_PICTURES");
    if (sizeof(wfReal) != 4) return;        /* recorded with floats: in doubles contacts begin at other steps */
    squint(grid);
    if (look_in) {
        snprintf(path, sizeof path, "%s/%s.ppm", look_in, name);
        FILE *ppm = fopen(path, "wb");
        fprintf(ppm, "P6 %d %d 255\n", PW, PH);
        for (int i = 0; i < PW * PH; i++) fwrite(&seen[i], 1, 3, ppm);
        fclose(ppm);
    }
    if (!written && mode && strcmp(mode, "write") == 0) written = fopen(pictures, "w");
    if (written) {
        fprintf(written, "%s\n", name);
        for (int r = 0; r < ROWS; r++, fputc('\n', written))
            for (int c = 0; c < COLUMNS; c++)
                for (int k = 0; k < 3; k++) fprintf(written, "%02x", (unsigned)(grid[r][c][k] + 0.5));
        return;
    }
    FILE *f = fopen(pictures, "r");
    assert_non_null(f);
    bool found = false;
    while (!found && fgets(line, sizeof line, f)) found = sscanf(line, "%63s", word) == 1 && strcmp(word, name) == 0;
    if (!found) fail_msg("no picture %s was recorded", name);
    double sum = 0;
    for (int r = 0; r < ROWS; r++) {
        assert_non_null(fgets(line, sizeof line, f));
        for (int i = 0; i < COLUMNS * 3; i++) {
            unsigned want;
            assert_int_equal(sscanf(line + 2 * i, "%2x", &want), 1);
            double off = fabs(grid[r][i / 3][i % 3] - want);
            if (off > 16) fail_msg("%s: at column %d, row %d the picture looks different (%.0f and %u)", name, i / 3, r, grid[r][i / 3][i % 3], want);
            sum += off;
        }
    }
    fclose(f);
    assert_true(sum / (COLUMNS * ROWS * 3) < 0.5);
}

static void begin_list(wfDraw *d, float x, float y, float high)
{
    static _Alignas(16) unsigned char memory[1 << 22];
    wfDrawInit(d, memory, sizeof memory);
    wfDrawView(d, x - high * PW / PH / 2, y - high / 2, x + high * PW / PH / 2, y + high / 2);
}

static void render(const wfDraw *d)
{
    frame_buffer f = { seen, PW, PH, PW, 1 };
    wfClearFrame(&f, wfLightPalette.area[WF_INK_PAPER]);
    wfRenderList(d, &wfBakedFont, &wfLightPalette, &f);
}

TEST(each_overlay_has_its_picture)
{
    static const struct { const char *file, *scene; int steps; uint32_t show; float x, y, high; int gjk, clip, substep, pass; } rows[] = {
        { "axis", "stack of boxes", 30, WF_SHOW_AXIS, 0, 4, 5, 0, 0, 0, 0 }, { "axis-gap", "shapes", 0, WF_SHOW_AXIS, 0, 6, 5, 0, 0, 0, 0 },
        { "gjk-1", "shapes", 0, WF_SHOW_GJK, 0, 6, 5, 0, 0, 0, 0 }, { "gjk-3", "shapes", 0, WF_SHOW_GJK, 0, 6, 5, 2, 0, 0, 0 },
        { "epa", "stack of boxes", 30, WF_SHOW_GJK, 0, 4, 5, 99, 0, 0, 0 },
        { "clip-1", "pyramid", 10, WF_SHOW_CLIPPING, 0, 4, 4, 0, 0, 0, 0 }, { "clip-2", "pyramid", 10, WF_SHOW_CLIPPING, 0, 4, 4, 0, 1, 0, 0 },
        { "clip-3", "pyramid", 10, WF_SHOW_CLIPPING, 0, 4, 4, 0, 2, 0, 0 }, { "clip-4", "pyramid", 10, WF_SHOW_CLIPPING, 0, 4, 4, 0, 3, 0, 0 },
        { "clip-5", "pyramid", 10, WF_SHOW_CLIPPING, 0, 4, 4, 0, 4, 0, 0 },
        { "features", "stack of boxes", 30, WF_SHOW_FEATURES, 0, 3, 6, 0, 0, 0, 0 }, { "forces", "tower", 30, WF_SHOW_PRESSURES, 0, 10, 20, 0, 0, 0, 0 },
        { "loads", "bridge", 30, WF_SHOW_LOADS | WF_SHOW_JOINTS, 0, 2, 8, 0, 0, 0, 0 }, { "colours", "pyramid", 10, WF_SHOW_COLOURS, 0, 4, 9, 0, 0, 0, 0 },
        { "inertia", "shapes", 0, WF_SHOW_INERTIA, 0, 6, 7, 0, 0, 0, 0 }, { "nodes", "TC06 quad tree", 5, WF_SHOW_NODES, 0, 4, 9, 0, 0, 0, 0 },
        { "passes-1", "solver sequential", 0, WF_SHOW_PASSES, 0, 4, 9, 0, 0, 1, 1 }, { "passes", "tower", 5, WF_SHOW_PASSES, 0, 10, 20, 0, 0, 2, 1 },
    };
    static _Alignas(16) unsigned char other[1 << 22];
    wfPool scratch = pool(16 << 20);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        if (wfFindScene(rows[i].scene) < 0) continue;
        wfWorld w = open(rows[i].scene, rows[i].steps);
        wfLook look = { .gjk = rows[i].gjk, .clip = rows[i].clip, .substep = rows[i].substep, .pass = rows[i].pass };
        wfDraw d, without;
        wfPairAt(&w, wfV2((wfReal)rows[i].x, (wfReal)rows[i].y), &look.shapeA, &look.shapeB);
        begin_list(&d, rows[i].x, rows[i].y, rows[i].high);
        wfShowWorld(&w, rows[i].show, &scratch, &d);
        int plain = d.count;
        wfDrawLook(&w, rows[i].show, &look, &scratch, &d);
        assert_true(d.count > plain);
        assert_true(d.refused == 0 && d.overflow == 0);
        wfDrawInit(&without, other, sizeof other);      /* nothing asked, nothing drawn */
        wfDrawLook(&w, 0, &look, &scratch, &without);
        assert_int_equal(without.count, 0);
        render(&d);
        looks_like(rows[i].file);
        wfDestroyWorld(&w);
    }
    free(scratch.base);
}

TEST(a_plot_has_its_picture)
{
    static wfPlots plots;
    const wfScene *row = wfSceneAt(wfFindScene("cradle"));
    wfWorld w = open("cradle", 0);
    for (int i = 0; i < 240; i++) {
        wfSceneInput in = wfSceneInputAt(row, i);
        assert_int_equal(wfStepScene(row, &w, &in), WF_OK);
        wfPlotInput ask = { &w, NULL, 0, 0, 0, NULL, false, false, { 0, 0 } };
        wfPlotSample(&plots, &ask);
    }
    wfDraw d;
    begin_list(&d, PW / 2, PH / 2, PH);
    wfDrawPlot(&d, 0, &plots, 4, 170, 260, 160);
    wfDrawPlot(&d, 1, &plots, 268, 170, 256, 160);
    wfDrawPlot(&d, 4, &plots, 4, 4, 520, 160);
    render(&d);
    looks_like("plots");
    wfDestroyWorld(&w);
}

static float letters(const char *text) { return fmaxf(6.2f * (float)strlen(text), wfTextWidth(&wfBakedFont, 13, text)); }

/* In the head of a box no word lies on another, whatever letters there are. What can't be had has no axes. */
TEST(a_plots_words_have_room)
{
    static wfPlots plots;
    wfWorld w = open("cradle", 3), others[3] = { w, w, w };
    static double stage[64] = { 0.001 };
    wfPlotInput ask = { &w, others, 3, 0.001, 0.016, stage, true, false, { 1, 0 } };
    for (int run = 0; run < 4; run++) {
        int timed = run % 2, low = run / 2;
        ask.stage = timed ? stage : NULL;
        ask.hooked = !timed;
        wfPlotSample(&plots, &ask);
        for (int row = 0; row < wfPlotCount; row++) {
            wfDraw d;
            begin_list(&d, PW / 2, PH / 2, PH);
            wfDrawPlot(&d, row, &plots, 4, 170, 268, low ? 80 : 120);
            int names = 0, lines = 0;
            for (int i = 0; i < d.count; i++) {
                const wfDrawCommand *c = wfDrawAt(&d, i);
                lines += c->kind == WF_DRAW_LINE;
                if (c->kind != WF_DRAW_TEXT || c->anchor == 0 || wfDrawPoints(&d, c)[1] < 170 + (low ? 80 : 120) - 40) continue;
                float x = wfDrawPoints(&d, c)[0], wide = letters(wfDrawString(&d, c)), from = c->anchor > 0 ? x - wide : x;
                assert_true(from >= 4 && from + wide <= 4 + 268);
                for (int k = 0; k < i; k++) {
                    const wfDrawCommand *o = wfDrawAt(&d, k);
                    if (o->kind != WF_DRAW_TEXT || fabs((double)(wfDrawPoints(&d, o)[1] - wfDrawPoints(&d, c)[1])) > 8) continue;
                    float ox = wfDrawPoints(&d, o)[0], owide = letters(wfDrawString(&d, o)), ofrom = o->anchor > 0 ? ox - owide : ox;
                    if (from < ofrom + owide && ofrom < from + wide)
                        fail_msg("%s: `%s' lies on `%s'", wfPlotTable[row].name, wfDrawString(&d, c), wfDrawString(&d, o));
                }
                names++;
            }
            if (timed || row != WF_PLOT_STAGES) assert_true(names >= 2 && lines > 4);
            else assert_int_equal(lines, 0);
        }
    }
    wfDestroyWorld(&w);
}

static int differing(const play *p, const uint32_t *before)
{
    int n = 0;
    for (int k = 0; k < W * H; k++) n += k % W > 220 && k % W < 800 && before[k] != p->buffer.pixels[k];
    return n;
}

static bool count_box(void *context, const wfIndexBox *box)
{
    (void)box;
    ++*(int *)context;
    return true;
}

/* The overlay "tree" draws as many boxes as the broad phase in use has, whichever it is; where there are none it says so. */
TEST(the_tree_is_the_one_in_use)
{
    wfPool scratch = pool(16 << 20);
    wfWorld w = open("TC06 quad tree", 5);
    wfWorldDef def;
    assert_int_equal(wfGetWorldDef(&w, &def), WF_OK);
    assert_string_equal(wfBroadPhaseTable[def.advanced.broadPhase].name, "quad-tree");
    for (int row = 0; row < wfBroadPhaseCount; row++) {
        wfDraw d;
        int boxes = 0;
        assert_int_equal(wfSetMethods(&w, -1, row, -1, -1), WF_OK);
        assert_int_equal(wfWorldIndexBoxes(&w, &scratch, count_box, &boxes), WF_OK);
        begin_list(&d, 0, 5, 30);
        wfShowWorld(&w, 0, &scratch, &d);
        int plain = d.count;
        wfShowWorld(&w, WF_SHOW_TREE, &scratch, &d);
        assert_true(wfBroadPhaseTable[row].update ? boxes > 10 : boxes == 0);
        assert_int_equal(d.count - 2 * plain, boxes > 0 ? boxes : 1);
        assert_int_equal(scratch.used, 0);
    }
    wfDestroyWorld(&w);
    free(scratch.base);
}

/* Every overlay that looks into a step has a check box that changes the picture. */
TEST(each_overlay_is_seen)
{
    static const struct { const char *overlay, *scene; int steps; } rows[] = {
        { "axis", "stack of boxes", 30 }, { "GJK", "stack of boxes", 30 }, { "clipping", "stack of boxes", 30 },
        { "features", "stack of boxes", 30 }, { "forces", "tower", 30 }, { "loads", "bridge", 30 }, { "colours", "pyramid", 10 },
        { "inertia", "shapes", 5 }, { "nodes", "TC06 quad tree", 5 }, { "passes", "tower", 5 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        static play p;
        if (wfFindScene(rows[i].scene) < 0) fail_msg("no scene %s", rows[i].scene);
        begin(&p, rows[i].scene);
        run(&p, rows[i].steps);
        key(&p, 'p');
        key(&p, 's');
        click(&p, "See");
        p.in.mouse_x = 509;
        p.in.mouse_y = 250;
        frame(&p, 0);
        uint32_t *before = malloc(W * H * 4);
        memcpy(before, p.buffer.pixels, W * H * 4);
        click(&p, rows[i].overlay);
        p.in.mouse_x = 509;
        p.in.mouse_y = 250;
        frame(&p, 0);
        int differ = differing(&p, before);
        free(before);
        if (differ < 60) fail_msg("%s shows nothing (%d pixels)", rows[i].overlay, differ);
        play_end(&p);
    }
}

/* The sliders of the panel: other steps are other pictures, and holding on keeps the pair. */
TEST(the_sliders_lead_through_the_steps)
{
    static play p;
    begin(&p, "stack of boxes");
    run(&p, 30);
    key(&p, 'p');
    key(&p, 's');
    click(&p, "See");
    click(&p, "GJK");
    click(&p, "clipping");
    p.in.mouse_x = 509;
    p.in.mouse_y = 250;
    frame(&p, 0);
    char pair[64];
    snprintf(pair, sizeof pair, "%s", said(&p, "pair"));
    point_at(&p, "Hold on to this pair");               /* over the panel the pair stays ... */
    assert_string_equal(said(&p, "pair"), pair);
    click(&p, "Hold on to this pair");
    p.in.mouse_x = 509;
    p.in.mouse_y = 480;
    frame(&p, 0);
    assert_string_equal(said(&p, "pair"), pair);        /* ... and held, anywhere */
    uint32_t *before = malloc(W * H * 4);
    static const char *const sliders[] = { "Cut", "GJK step" };
    for (int i = 0; i < 2; i++) {
        point_at(&p, sliders[i]);
        memcpy(before, p.buffer.pixels, W * H * 4);
        drag(&p, sliders[i], 60);
        int differ = differing(&p, before);
        assert_true(differ > 30);
    }
    free(before);
    play_end(&p);
}

/* Pixels in which the left half of what the camera has differs from the right half. */
static int panes_differ(const play *p)
{
    int n = 0;
    for (int y = 200; y < 600; y++)
        for (int x = 220; x < 500; x++) n += p->buffer.pixels[y * W + x] != p->buffer.pixels[y * W + x + 301];
    return n;
}

/* A world that is compared with itself stays with it, bit for bit, and the scene's world does not notice. */
TEST(comparing_changes_nothing)
{
    static play alone, both;
    begin(&alone, "tower");
    run(&alone, 90);
    begin(&both, "tower");
    key(&both, 's');
    click(&both, "Compare");
    click(&both, "Two");
    both.in.mouse_x = both.in.mouse_y = 0;
    key(&both, 'r');
    run(&both, 90);
    assert_string_equal(said(&both, "worlds"), "2");
    char hash[64];
    snprintf(hash, sizeof hash, "%s", said(&alone, "hash"));
    assert_string_equal(said(&both, "hash"), hash);
    assert_true(atof(said(&both, "apart 2")) > 0.01);   /* another solver: the tower goes otherwise */
    assert_true(panes_differ(&both) > 400);
    uint32_t *before = malloc(W * H * 4);
    memcpy(before, both.buffer.pixels, W * H * 4);
    click(&both, "curve: error");
    assert_true(differing(&both, before) > 300);
    memcpy(before, both.buffer.pixels, W * H * 4);
    click(&both, "Over each other");
    assert_true(differing(&both, before) > 300);
    free(before);
    play_end(&both);

    begin(&both, "tower");                              /* the same setting: nothing parts them */
    key(&both, 's');
    click(&both, "Compare");
    click(&both, "Two");
    point_at(&both, "World 2");
    click(&both, "World 2");
    click(&both, "gravity");
    run(&both, 60);
    assert_string_equal(said(&both, "apart 2"), "0");
    click(&both, "Four");
    run(&both, 30);
    assert_string_equal(said(&both, "worlds"), "4");
    assert_true(atof(said(&both, "apart 3")) >= 0);
    click(&both, "One world");
    run(&both, 3);
    assert_string_equal(said(&both, "worlds"), "1");
    play_end(&both);
    play_end(&alone);
}

/* Through every scene with four worlds, and all curves and overlays on: nothing fails, and nothing is written that isn't finite. */
TEST(all_scenes_can_be_compared)
{
    static play p;
    begin(&p, "free fall");
    key(&p, 's');
    click(&p, "Compare");
    click(&p, "Four");
    for (int i = 0; i < wfPlotCount; i++) {
        char name[64];
        snprintf(name, sizeof name, "curve: %s", wfPlotTable[i].name);
        click(&p, name);
    }
    click(&p, "See");
    for (int i = 0; i < wfOverlayCount; i++) click(&p, wfOverlayTable[i].name);
    for (int i = 0; i < wfSceneCount(); i++) {
        snprintf(p.in.scene, sizeof p.in.scene, "%s", wfSceneAt(i)->name);
        frame(&p, 1);
        frame(&p, 2);
        assert_true(strstr(p.text, wfSceneAt(i)->name) != NULL);
        assert_true(strstr(p.text, "nan") == NULL && strstr(p.text, "inf") == NULL);
    }
    play_end(&p);
}
