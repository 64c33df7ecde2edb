/* The page of stages is true: what a stage changes in a world's two chunks it has declared, what it declares some scene shows, and
 * of what it does not declare to read every byte may be another. Every scene is stepped with every solver, and some of the steps are
 * taken stage by stage, as run_stages does, with the chunks compared before and after. Such a step takes each stage twice: once as it
 * is, and once more from the same bytes, but with garbage in every array that the stage does not declare to read. */
#include <signal.h>
#include <unistd.h>
#include "testing.h"
#include "engine/step.h"
#include "testbed/scene.h"

enum { MOST_STAGES = 64, GARBAGE = 0xEE, LARGE = 4000000 };
static const char *const PAGE_NAME[] = { "the solver moves the bodies", "the stages move the bodies" };

/* ---- the declarations ---- */
static int page_of(const struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    return wfHas(head, WF_MODULE_SUBSTEPS) && wfSolverTable[head->solver].step != NULL ? 0 : 1;
}

static bool is_in(wfArrays set, int array)
{
    return array < WF_REGION_KEPT ? set.kept >> array & 1 : set.fresh >> (array - WF_REGION_KEPT) & 1;
}

/* Is this array scratch to a stage? The last one is to all; those that are filled after a solver that moves the bodies are to it. */
static bool is_scratch(int stage, int page, int a)
{
    bool solves = page == 0 && strcmp(wfStageTable[stage].name, "velocities") == 0;
    return a == WF_REGION_SCRATCH || (solves && a >= WF_REGION_LATE);
}

/* All rows of a stage on a page, taken together. Whoever writes may have to look at the header first. */
static void declared(int stage, int page, bool reads[WF_REGION_COUNT], bool writes[WF_REGION_COUNT])
{
    for (int a = 0; a < WF_REGION_COUNT; a++) reads[a] = a == WF_REGION_HEADER, writes[a] = is_scratch(stage, page, a);
    for (int i = 0; i < wfFlowCount; i++) {
        const wfFlowRow *row = &wfFlowTable[i];
        if (strcmp(row->stage, wfStageTable[stage].name) != 0 || !(row->pages & 1 << page)) continue;
        for (int a = 0; a < WF_REGION_COUNT; a++) {
            reads[a] = reads[a] || is_in(row->reads, a);
            writes[a] = writes[a] || is_in(row->writes, a);
        }
    }
}

/* ---- a world's chunks, and copies of them ---- */
typedef struct Chunks { uint8_t *of[2]; size_t size[2]; } Chunks;
static Chunks now, before, after;
static size_t offset[WF_REGION_COUNT], length[WF_REGION_COUNT];

static void copy_chunks(Chunks *to, const Chunks *from)
{
    for (int c = 0; c < 2; c++) memcpy(to->of[c], from->of[c], from->size[c]);
}

static uint8_t *array_in(const Chunks *in, int a) { return in->of[wfRegionTable[a].chunk] + offset[a]; }

static bool differs(const Chunks *x, const Chunks *y, int a)
{
    return length[a] > 0 && memcmp(array_in(x, a), array_in(y, a), length[a]) != 0;
}

static void look_at(const wfWorld *world, const wfBlock *b)
{
    wfRegion region[WF_REGION_COUNT];
    wfWorldDef def = wfSettings(b->head);
    assert_ok(wfWorldRegions(&def, region));
    now = (Chunks){ { world->memory.permanent, world->memory.transient },
                    { (size_t)b->head->bytes, (size_t)b->head->scratchBytes } };
    for (int a = 0; a < WF_REGION_COUNT; a++) {
        offset[a] = (size_t)b->head->offset[a];
        length[a] = region[a].count * region[a].each;
    }
    length[WF_REGION_SCRATCH] = now.size[1] - offset[WF_REGION_SCRATCH];
    for (int c = 0; c < 2; c++) {
        before.of[c] = realloc(before.of[c], before.size[c] = now.size[c]);
        after.of[c] = realloc(after.of[c], after.size[c] = now.size[c]);
        assert_non_null(before.of[c]);
        assert_non_null(after.of[c]);
    }
    copy_chunks(&before, &now);
}

/* ---- one stage, twice ---- */
static bool seen[2][MOST_STAGES][WF_REGION_COUNT], ran[2][MOST_STAGES];
static int untrue;                          /* how many arrays are declared wrongly, each told once */
static char where[256];                     /* for a stage that reads garbage and does not come back */

static void crashed(int number)
{
    static const char text[] = "a stage has read what it does not declare to read, and crashed: ";
    (void)!write(STDERR_FILENO, text, sizeof text - 1);
    (void)!write(STDERR_FILENO, where, strlen(where));
    (void)!write(STDERR_FILENO, "\n", 1);
    _exit(128 + number);
}

static void tell(bool *told, const char *what, int array)
{
    if (!*told) print_error("%s %s \"%s\"\n", where, what, wfRegionTable[array].name), untrue++;
    *told = true;
}

/* `after` holds what the stage has made of `before`. Now it is to make the same of garbage. */
static void run_on_garbage(struct wfStep *step, const struct wfStep *start, int i, wfResult result, const bool reads[],
                           const bool writes[])
{
    int page = page_of(start);
    static bool told[2][MOST_STAGES][WF_REGION_COUNT];
    struct wfStep end = *step;
    copy_chunks(&now, &before);
    for (int a = 0; a < WF_REGION_COUNT; a++)
        if (!reads[a] && length[a] > 0) memset(array_in(&now, a), GARBAGE, length[a]);
    *step = *start;
    wfResult again = wfStageTable[i].run(step);
    memcpy(&step->view, &end.view, sizeof end.view);            /* pointers, and holes between them */
    if (again != result || memcmp(&end, step, sizeof end) != 0)
        tell(&told[page][i][WF_REGION_HEADER], "ends otherwise with garbage in what it does not declare to read, for all it may read, as the", WF_REGION_HEADER);
    for (int a = 0; a < WF_REGION_COUNT; a++) {
        const uint8_t *got = array_in(&now, a), *want = array_in(&after, a), *was = array_in(&before, a);
        bool kept = !differs(&after, &before, a);
        if (is_scratch(i, page, a) || length[a] == 0 || (reads[a] && !differs(&now, &after, a))) continue;
        if (!reads[a] && kept && got[0] == GARBAGE && memcmp(got, got + 1, length[a] - 1) == 0) continue;   /* all of it */
        for (size_t k = 0; k < length[a]; k++) {
            bool same = got[k] == want[k], left = !reads[a] && got[k] == GARBAGE && want[k] == was[k];
            if (!same && !left)
                tell(&told[page][i][a], "takes from an array that it does not declare to read what it writes to", a);
            if (!left && !reads[a] && writes[a]) seen[page][i][a] = true;
        }
    }
    copy_chunks(&now, &after);
    *step = end;
}

static wfResult run_watched(struct wfStep *step, int i, bool twice)
{
    static bool told[2][MOST_STAGES][WF_REGION_COUNT];
    bool reads[WF_REGION_COUNT], writes[WF_REGION_COUNT];
    struct wfStep start = *step;
    int page = page_of(step);
    declared(i, page, reads, writes);
    ran[page][i] = true;
    wfResult result = wfStageTable[i].run(step);
    for (int a = 0; a < WF_REGION_COUNT; a++) {
        if (!differs(&now, &before, a)) continue;
        if (!writes[a]) tell(&told[page][i][a], "writes, and does not declare it,", a);
        seen[page][i][a] = true;
    }
    if (twice && now.size[0] + now.size[1] < LARGE) {
        copy_chunks(&after, &now);
        run_on_garbage(step, &start, i, result, reads, writes);
    }
    copy_chunks(&before, &now);
    return result;
}

/* A step as run_stages of engine/step.c makes it. */
static wfResult step_watched(wfWorld *world, const char *name, const wfCallbacks *hooks, bool twice)
{
    struct wfStep step = { .hooks = hooks };
    wfResult result = wfChangeBlock(world, &step.b);
    if (result == WF_OK) look_at(world, &step.b);
    for (int i = 0; i < wfStageCount && result == WF_OK; i++) {
        if (!wfStageRuns(&wfStageTable[i], step.b.head->modules)) continue;
        snprintf(where, sizeof where, "%s, %s: the stage \"%s\" (%s)", name, wfSolverTable[step.b.head->solver].name,
                 wfStageTable[i].name, PAGE_NAME[page_of(&step)]);
        result = run_watched(&step, i, twice);
        if (result == WF_OK && step.again) {
            step = (struct wfStep){ .b = step.b, .hooks = hooks, .restarts = step.restarts + 1 };
            i = -1;
        }
    }
    return result;
}

/* ---- every scene, with every solver ---- */
enum { OWN_STEPS = 96, OTHER_STEPS = 24 };

/* The settings of a scene, with room for what it needs and hardly more: small chunks are compared quickly. */
static bool small_world(const wfScene *s, wfWorldDef *def)
{
    wfWorld world;
    wfWorldDef usual = wfDefaultWorldDef();
    if (s->define) s->define(&usual);
    assert_ok(wfOpenScene(s, NULL, &world));
    for (int k = 0; k < OWN_STEPS; k++) {
        wfSceneInput in = wfSceneInputAt(s, k);
        assert_ok(wfStepScene(s, &world, &in));
    }
    assert_ok(wfInferModules(&world, (s->hooks != NULL ? WF_MODULE_HOOKS : 0) | s->asks, def));
    wfDestroyWorld(&world);
    def->modules = usual.modules;
    def->advanced.pairCapacity = 2 * def->advanced.pairCapacity + 64;
    def->advanced.contactCapacity = 2 * def->advanced.contactCapacity + 64;
    return true;
}

/* Half of the bodies are damped, and a step has something to tell of every stage. */
static void damp_some(const wfWorld *world)
{
    wfBlock b;
    assert_ok(wfOpenBlock(world, &b));
    for (int32_t i = 0; i < b.head->bodySlots.high; i += 2) b.props[i].linearDamping = b.props[i].angularDamping = (wfReal)0.1;
}

/* How many steps went well. */
static int watch(const wfScene *s, const wfWorldDef *def, bool own)
{
    wfWorld world;
    int good = 0, steps = own ? OWN_STEPS : OTHER_STEPS;
    if (wfCreateWorld(def, &world) != WF_OK) return 0;
    wfResult result = s->build(&world);
    if (result == WF_OK && !own) damp_some(&world);
    for (int k = 0; k < steps && result == WF_OK; k++, good += result == WF_OK) {
        wfSceneInput in = wfSceneInputAt(s, k);
        bool look = k < 2 || k % 12 == 11;
        if (s->update) s->update(&world, &in);
        if (look) result = step_watched(&world, s->name, s->hooks, s->hooks == NULL);   /* a hook reads what it likes */
        else result = wfStepWorldWithCallbacks(&world, s->hooks);
    }
    wfDestroyWorld(&world);
    return good;
}

static void nothing_is_declared_in_vain(void)
{
    for (int i = 0; i < wfFlowCount; i++) {
        const wfFlowRow *row = &wfFlowTable[i];
        int stage = 0;
        while (stage < wfStageCount && strcmp(wfStageTable[stage].name, row->stage) != 0) stage++;
        if (stage == wfStageCount) fail_msg("row %d of wfFlowTable: no stage is called \"%s\"", i, row->stage);
        for (int a = 0; a < WF_REGION_COUNT; a++) {
            bool shown = ((row->pages & 1) && seen[0][stage][a]) || ((row->pages & 2) && seen[1][stage][a]);
            bool no_digits = sizeof(wfReal) == sizeof(double) && a == WF_REGION_NEW_FINE;      /* a sum of doubles loses nothing here */
            if (is_in(row->writes, a) && !shown && row->seldom == NULL && !no_digits)
                print_error("\"%s\" declares to write \"%s\" (pages %d), and in no scene does\n", row->stage, wfRegionTable[a].name,
                            (int)row->pages), untrue++;
            if (is_in(row->writes, a) && shown && row->seldom != NULL)
                print_error("\"%s\" writes \"%s\" not so seldom: no reason is needed\n", row->stage, wfRegionTable[a].name), untrue++;
        }
    }
}

TEST(the_page_of_stages_is_true)
{
    assert_true(wfStageCount <= MOST_STAGES);
    signal(SIGSEGV, crashed);
    signal(SIGBUS, crashed);
    int worlds = 0, steps = 0;
    for (int i = 0; i < wfSceneCount(); i++) {
        const wfScene *s = wfSceneAt(i);
        wfWorldDef def;
        if (s->build == NULL || !small_world(s, &def)) continue;
        assert_int_equal(watch(s, &def, true), OWN_STEPS);
        for (int k = 0; k < wfSolverCount; k++) {
            wfWorldDef other = def;
            other.solver = k;
            other.sleep = 1;
            other.advanced.timeToSleep = (wfReal)0.1;
            other.advanced.compensatedSums = k % 2;
            int good = watch(s, &other, false);
            worlds += good > 0;
            steps += good;
        }
    }
    print_message("%d worlds, %d steps\n", worlds, steps);
    for (int page = 0; page < 2; page++)
        for (int i = 0; i < wfStageCount; i++)
            if (!ran[page][i]) fail_msg("%s: the stage \"%s\" has never run", PAGE_NAME[page], wfStageTable[i].name);
    nothing_is_declared_in_vain();
    assert_int_equal(untrue, 0);
}
