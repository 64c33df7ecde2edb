/* Weft: lab/save_and_replay.c, tangled from chapters/methods/29-save-and-replay.lab.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include <math.h>
#include <string.h>
#include <stdlib.h>
#include <time.h>
#include "engine/image.h"
#include "weft/save.h"
#include "weft/json.h"
#include "lab/bench.h"

static void save_wall(wfWorld *world, wfReal x, wfReal y, wfReal halfWidth,
                      wfReal halfHeight)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    d.position = wfV2(x, y);
    wfMakeBox(halfWidth, halfHeight, &d.shape);
    wfAddBodyToWorld(world, &d, NULL);
}

/* n boxes that fall between two walls, or n balls that roll on a floor. */
static wfResult save_scene(int n, bool spread, bool sleep, wfWorld *out)
{
    wfWorldDef def = wfDefaultWorldDef();
    int wide = spread ? n : (int)wfSqrt((wfReal)n);
    wfReal half = WF_R(0.45) * (wfReal)wide + 1;
    def.bodyCapacity = n + 3;
    def.sleep = sleep;
    wfResult result = wfCreateWorld(&def, out);
    if (result != WF_OK) return result;
    save_wall(out, 0, -1, half + 2, 1);
    save_wall(out, -half - 1, half, 1, 2 * half);
    save_wall(out, half + 1, half, 1, 2 * half);
    for (int i = 0; i < n && result == WF_OK; i++) {
        wfBodyDef d = wfDefaultBodyDef();
        wfReal shift = (wfReal)(i / wide % 2) * WF_R(0.3);
        d.position = wfV2(WF_R(0.9) * ((wfReal)(i % wide) - (wfReal)(wide - 1) / 2) + shift,
                          WF_R(0.4) + WF_R(0.9) * (wfReal)(i / wide));
        d.velocity = wfV2(spread ? (wfReal)(i % 7 - 3) : 0, 0);
        if (spread) wfMakeCircle(wfV2(0, 0), WF_R(0.4), &d.shape);
        else wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape);
        result = wfAddBodyToWorld(out, &d, NULL);
    }
    return result;
}
static size_t save_changed(const wfWorld *a, const wfWorld *b)
{
    wfBlock one, two;
    wfImage before, now;
    size_t blocks = 0;
    if (wfOpenBlock(a, &one) != WF_OK || wfOpenBlock(b, &two) != WF_OK) return 0;
    if (wfImageOfBlock(&one, &before) != WF_OK) return 0;
    if (wfImageOfBlock(&two, &now) != WF_OK) return 0;
    for (int i = 0; i < WF_REGION_KEPT; i++)
        for (size_t at = 0; at < now.bytes[i]; at += 64) {
            size_t size = now.bytes[i] - at < 64 ? now.bytes[i] - at : 64;
            bool same = at + size <= before.bytes[i]
                     && memcmp(before.at[i] + at, now.at[i] + at, size) == 0;
            blocks += !same;
        }
    return blocks;
}
static int measure_save_rewind(FILE *out)
{
    static const struct { const char *name; int steps; bool spread, sleep; } row[] = {
        { "pile that falls", 60, false, false },
        { "pile at rest (awake)", 900, false, false },
        { "pile asleep", 1500, false, true },
        { "balls that roll", 60, true, false } };
    fprintf(out, "scene,whole,blocks,every60\n");
    for (int k = 0; k < 4; k++) {
        wfWorld world, before;
        size_t whole = 0, changed = 0;
        enum { STEPS = 10 };
        if (save_scene(1000, row[k].spread, row[k].sleep, &world) != WF_OK) return 1;
        for (int i = 0; i < row[k].steps; i++)
            if (wfStepWorld(&world) != WF_OK) return 1;
        /* count what ten steps change */
        for (int i = 0; i < STEPS; i++) {
            if (wfCloneWorld(&world, NULL, &before) != WF_OK) return 1;
            if (wfStepWorld(&world) != WF_OK) return 1;
            whole += wfSnapshotSize(&world);
            changed += 72 * save_changed(&before, &world);
            wfDestroyWorld(&before);
        }
        fprintf(out, "%s,%zu,%zu,%zu\n", row[k].name, whole / STEPS, changed / STEPS,
                whole / STEPS / 60);
        wfDestroyWorld(&world);
    }
    return 0;
}

typedef struct SaveTimes {
    double copy, snapshot, restore, clone, compare, save;
    double freshCopy, freshClone;      /* into memory that was allocated for it */
} SaveTimes;

static double save_seconds(clock_t from)
{
    return (double)(clock() - from) / CLOCKS_PER_SEC;
}

static void keep_least(double *least, double seconds)
{
    if (*least <= 0 || seconds < *least) *least = seconds;
}
static void save_round(wfWorld *world, wfWorld *twin, uint8_t *bytes, uint8_t *copy,
                       size_t size, int times, SaveTimes *t)
{
    size_t got;
    const wfMemory memory = twin->memory;
    void *(*volatile copier)(void *, const void *, size_t) = memcpy;
    clock_t start = clock();
    for (int i = 0; i < times; i++) copier(copy, bytes, size);
    keep_least(&t->copy, save_seconds(start));
    start = clock();
    for (int i = 0; i < times; i++) wfSnapshotWorld(world, bytes, size, &got);
    keep_least(&t->snapshot, save_seconds(start));
    start = clock();
    for (int i = 0; i < times; i++) wfRestoreWorld(twin, bytes, size);
    keep_least(&t->restore, save_seconds(start));
    start = clock();
    for (int i = 0; i < times; i++) wfCloneWorld(world, &memory, twin);
    keep_least(&t->clone, save_seconds(start));
    start = clock();
    /* time what is more than a copy */
    for (int i = 0; i < times; i++) wfCompareWorlds(world, twin, NULL);
    keep_least(&t->compare, save_seconds(start));
    start = clock();
    size_t room = wfSaveSize(world);
    for (int i = 0; i < times / 16 + 1; i++) wfSaveToBytes(world, bytes, room, &got);
    keep_least(&t->save, save_seconds(start) * times / (times / 16 + 1));
}
static bool save_fresh_round(wfWorld *world, const uint8_t *bytes, size_t size, int times,
                             SaveTimes *t)
{
    void *(*volatile copier)(void *, const void *, size_t) = memcpy;
    const wfMemory *m = &world->memory;
    bool good = true;
    clock_t start = clock();
    for (int i = 0; i < times && good; i++) {
        wfMemory fresh;
        good = wfAllocateMemory(&fresh, m->permanentSize, m->transientSize) == WF_OK;
        if (good) copier(fresh.permanent, bytes, size), wfFreeMemory(&fresh);
    }
    keep_least(&t->freshCopy, save_seconds(start));
    start = clock();
    for (int i = 0; i < times && good; i++) {
        wfWorld clone;
        good = wfCloneWorld(world, NULL, &clone) == WF_OK;
        if (good) wfDestroyWorld(&clone);
    }
    keep_least(&t->freshClone, save_seconds(start));
    return good;
}

static int measure_snapshot_time(FILE *out)
{
    fprintf(out, "bodies,bytes,memcpy,us,snapshot,restore,clone,compare,save,room,fresh\n");
    for (int n = 10; n <= 10000; n *= 10) {
        wfWorld world, twin;
        SaveTimes t = { .copy = 0 };
        if (save_scene(n, false, false, &world) != WF_OK) return 1;
        for (int i = 0; i < 60; i++)
            if (wfStepWorld(&world) != WF_OK) return 1;
        size_t size = wfSnapshotSize(&world), room = wfSaveSize(&world) + 64;
        uint8_t *bytes = calloc(1, room), *copy = calloc(1, room);
        if (!bytes || !copy || wfCloneWorld(&world, NULL, &twin) != WF_OK) return 1;
        int times = (int)(4000000 / size) + 1;
        for (int round = 0; round < 40; round++) {
            save_round(&world, &twin, bytes, copy, size, times, &t);
            if (!save_fresh_round(&world, bytes, size, times, &t)) return 1;
        }
        /* write how each compares with memcpy */
        fprintf(out, "%d,%zu,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%.2f,%zu,%.2f\n", n, size,
                (double)size * times / t.copy * 1e-9, 1e6 * t.snapshot / times,
                t.copy / t.snapshot, t.copy / t.restore, t.copy / t.clone,
                t.copy / t.compare, t.copy / t.save,
                world.memory.permanentSize + world.memory.transientSize,
                t.freshCopy / t.freshClone);
        free(bytes);
        free(copy);
        wfDestroyWorld(&world);
        wfDestroyWorld(&twin);
    }
    return 0;
}
static int measure_rollback_time(FILE *out)
{
    enum { FRAMES = 8, ROUNDS = 31 };
    /* the scenes that are gone back in */
    static const struct { const char *name; int steps; bool spread; int columns; } row[] = {
        { "balls that roll", 60, true, -1 },
        { "columns of one loop at most", 60, true, 2 },
        { "columns without loops", 60, true, 1 },
        { "no columns", 60, true, 0 },
        { "pile that falls", 30, false, -1 },
        { "pile at rest (awake)", 900, false, -1 } };
    fprintf(out, "scene,restore,steps,share\n");
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        wfWorldDef def;
        wfWorld world;
        double back[ROUNDS], again[ROUNDS];
        if (save_scene(1000, row[k].spread, false, &world) != WF_OK) return 1;
        if (wfGetWorldDef(&world, &def) != WF_OK) return 1;
        if (row[k].columns >= 0) def.advanced.stackSolver = row[k].columns;
        if (wfSetWorldDef(&world, &def) != WF_OK) return 1;
        for (int i = 0; i < row[k].steps; i++) wfStepWorld(&world);
        size_t size = wfSnapshotSize(&world);
        void *bytes = malloc(size);
        if (bytes == NULL || wfSnapshotWorld(&world, bytes, size, &size) != WF_OK) return 1;
        /* go back and make the steps again, many times */
        for (int round = 0; round < ROUNDS; round++) {
            clock_t start = clock();
            if (wfRestoreWorld(&world, bytes, size) != WF_OK) return 1;
            back[round] = save_seconds(start);
            for (int i = 0; i < FRAMES; i++)
                if (wfStepWorld(&world) != WF_OK) return 1;
            again[round] = save_seconds(start) - back[round];
        }
        qsort(back, ROUNDS, sizeof *back, labByValue);
        qsort(again, ROUNDS, sizeof *again, labByValue);
        double ms = 1e3 * back[ROUNDS / 2], steps = 1e3 * again[ROUNDS / 2];
        fprintf(out, "%s,%.3f,%.2f,%.0f\n", row[k].name, ms, steps, (ms + steps) * 6);
        free(bytes);
        wfDestroyWorld(&world);
    }
    return 0;
}
#ifndef WF_NO_JSON
enum { DRIFT_BODIES = 40 };

static bool drift_add(wfWorld *world, int32_t type, double x, double y, double size,
                      bool round)
{
    wfBodyDef d = wfDefaultBodyDef();
    d.type = type;
    d.position = wfV2((wfReal)x, (wfReal)y);
    wfResult made = round ? wfMakeCircle(wfV2(0, 0), (wfReal)size, &d.shape)
        : wfMakeBox((wfReal)size, type == WF_STATIC ? 1 : (wfReal)size, &d.shape);
    return made == WF_OK && wfAddBodyToWorld(world, &d, NULL) == WF_OK;
}

static bool drift_hang(wfWorld *world, int32_t i)
{
    wfJoint j;
    wfBodyId a = wfBodyAt(world, i), b = wfBodyAt(world, i + 1);
    wfVec2 at = wfV2((wfReal)i, 10);
    return wfDefineJoint(world, "revolute", a, b, at, at, wfV2(1, 0), &j) == WF_OK
        && wfAddJointToWorld(world, &j, NULL) == WF_OK;
}

static bool drift_build(int kind, wfWorld *world)
{
    wfWorldDef def = wfDefaultWorldDef();
    if (wfCreateWorld(&def, world) != WF_OK) return false;
    bool good = true;
    if (kind == 0) good = drift_add(world, WF_STATIC, 0, 10, 0.1, true);
    else good = drift_add(world, WF_STATIC, 0, -1, 20, false);
    for (int i = 0; kind == 0 && i < 8 && good; i++)
        good = drift_add(world, WF_DYNAMIC, i + 1, 10, 0.2, true) && drift_hang(world, i);
    for (int i = 0; kind == 1 && i < 8 && good; i++)
        good = drift_add(world, WF_DYNAMIC, 0, 0.5 + i, 0.5, false);
    for (int i = 0; kind > 1 && i < DRIFT_BODIES && good; i++)
        good = drift_add(world, WF_DYNAMIC, 1.05 * (i % 5) + 0.1 * (i / 5),
                         (kind == 2 ? 0.5 : 4) + 1.1 * (i / 5), 0.5, kind == 2);
    for (int i = 0; i < 120 && good; i++) good = wfStepWorld(world) == WF_OK;
    return good;
}

static double drift_between(const wfWorld *one, const wfWorld *two)
{
    wfBodyView a = wfWorldBodies(one), b = wfWorldBodies(two);
    double most = 0;
    for (int32_t i = 0; i < a.count; i++) {
        double d = (double)wfLength(wfSub(a.state[i].p, b.state[i].p));
        if (d > most) most = d;
    }
    return most;
}

static bool drift_row(FILE *out, const char *name, int kind)
{
    static const int after[] = { 0, 1, 10, 100, 600 };
    wfWorld one, two;
    char *text = NULL;
    int32_t contacts, made = 0;
    bool good = drift_build(kind, &one) && wfWriteScene(&one, NULL, &text) == WF_OK
             && wfReadScene(text, strlen(text), NULL, &two, NULL, NULL) == WF_OK;
    if (!good) return false;
    wfWorldContacts(&one, &contacts);
    fprintf(out, "%s,%d,%.1f", name, (int)contacts, (double)strlen(text) / 1000);
    for (size_t i = 0; i < sizeof after / sizeof *after; i++) {
        for (; made < after[i] && good; made++)
            good = wfStepWorld(&one) == WF_OK && wfStepWorld(&two) == WF_OK;
        fprintf(out, ",%.2g", 1000 * drift_between(&one, &two));
    }
    fprintf(out, "\n");
    wfFreeText(text);
    wfDestroyWorld(&one);
    wfDestroyWorld(&two);
    return good;
}
#endif
static int measure_text_drift(FILE *out)
{
#ifdef WF_NO_JSON
    (void)out;
    return 1;
#else
    fprintf(out, "world,contacts,text (KB),0 steps (mm),1 step,10 steps,100 steps,"
                 "600 steps\n");
    return !(drift_row(out, "a chain swings", 0)
          && drift_row(out, "a tower stands", 1)
          && drift_row(out, "forty discs roll apart", 2)
          && drift_row(out, "forty boxes tumble", 3));
#endif
}

static const wfMeasureRow rows[] = {
    { "save-rewind", "bytes for a step of the past: whole, differences, every 60th",
      measure_save_rewind },
    { "snapshot-time", "snapshot, restore, clone, compare and save against memcpy",
      measure_snapshot_time },
    { "rollback-time", "going back by eight frames and simulating them again",
      measure_rollback_time },
    { "text-drift", "a world and what is read from its text, so many steps later",
      measure_text_drift },
};
const wfMeasureSet save_and_replay_measurements = WF_ROWS(rows);
