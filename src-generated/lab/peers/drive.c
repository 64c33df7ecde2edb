/* Weft: lab/peers/drive.c, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* The loop of the adapters in C and C++. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "peer.h"

/* the peers' clock */
static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;     /* ms */
}

/* ms of 100,000 turns of the logistic map: the best of ten, or `least` */
static double kernel(double least)
{
    volatile double sink;
    for (int k = 0; k < 10; k++) {
        double x = 0.3, start = now();
        for (int i = 0; i < 100000; i++) x = 3.9 * x * (1 - x);
        sink = x;
        double time = now() - start;
        if (time < least) least = time;
    }
    (void)sink;
    return least;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* the peers' options */
static double value_of(int argc, char **argv, int *i)
{
    char *end;
    double value = *i + 1 < argc ? strtod(argv[++*i], &end) : NAN;
    if (!(value >= 0) || *end != '\0') {
        fprintf(stderr, "error: %s: a number should follow\n", argv[*i]);
        exit(1);
    }
    return value;
}

static const char *read_options(int argc, char **argv, peerOptions *o)
{
    const char *file = NULL;
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i];
        if (strcmp(a, "--steps") == 0) o->steps = (int)value_of(argc, argv, &i);
        else if (strcmp(a, "--every") == 0) o->every = (int)value_of(argc, argv, &i);
        else if (strcmp(a, "--substeps") == 0) o->substeps = (int)value_of(argc, argv, &i);
        else if (strcmp(a, "--iterations") == 0)
            o->iterations = (int)value_of(argc, argv, &i);
        else if (strcmp(a, "--dt") == 0) o->dt = value_of(argc, argv, &i);
        else if (strcmp(a, "--fast") == 0) o->fast = 1;
        else if (strcmp(a, "--sleep") == 0) o->sleep = 1;
        else if (strcmp(a, "--bodies") == 0 && i + 1 < argc)
            o->noBodies = strcmp(argv[++i], "none") == 0;
        else if (strcmp(a, "--set") == 0 && i + 1 < argc && o->sets < 16)
            o->set[o->sets++] = argv[++i];
        else if (strcmp(a, "--spoil") == 0 && i + 1 < argc) o->spoil = argv[++i];
        else if (a[0] == '-' || file != NULL) peerRefuse("option %s", a);
        else file = a;
    }
    return file;
}

/* what an engine cannot do, it refuses */
static void compare_with(const peerEngine *e, const peerScene *s, const peerOptions *o)
{
    static const char *const joints[] = { "hinge", "rigid distance", "weld" };
    if (o->iterations > 0 && !(e->can & PEER_CAN_ITERATE))
        peerRefuse("%s: --iterations: it has no such number", e->name);
    if (o->sets > 0 && !(e->can & PEER_HAS_SETTINGS))
        peerRefuse("%s: --set %s", e->name, o->set[0]);
    if (o->fast && !(e->can & PEER_CAN_SWEEP))
        peerRefuse("%s: --fast: it does not sweep bodies", e->name);
    if (o->sleep && !(e->can & PEER_CAN_SLEEP)) peerRefuse("%s: --sleep", e->name);
    if (!s->oneFriction && !(e->can & PEER_MIXES_FRICTION && s->geometricFriction))
        peerRefuse("%s: shapes of different friction, so mixed", e->name);
    if (!s->oneRestitution && !(e->can & PEER_MIXES_RESTITUTION && s->greatestRestitution))
        peerRefuse("%s: shapes of different restitution, so mixed", e->name);
    for (int i = 0; i < s->joints; i++)
        if (!(e->joints & 1 << s->joint[i].kind))
            peerRefuse("%s: joints[%d]: a %s joint", e->name, i, joints[s->joint[i].kind]);
}

/* the peers' bad inputs */
static void spoil_corners(peerShape *s, const char *how)
{
    if (strcmp(how, "two") == 0) s->corners = 2;
    if (strcmp(how, "flat") == 0)
        for (int i = 0; i < s->corners; i++) s->corner[i][1] = 0;
    if (strcmp(how, "concave") == 0)            /* a notch where the third corner was */
        for (int k = 0; k < 2; k++) s->corner[2][k] *= -0.5;
    for (int i = 0; i < s->corners / 2 && strcmp(how, "turned") == 0; i++)
        for (int k = 0; k < 2; k++) {
            double *a = &s->corner[i][k], *b = &s->corner[s->corners - 1 - i][k], c = *a;
            *a = *b;
            *b = c;
        }
}

static void spoil(peerScene *s, peerOptions *o)
{
    peerBody *b = &s->body[s->bodies > 0 ? s->bodies - 1 : 0];
    peerShape *p = &s->shape[s->shapes > 0 ? s->shapes - 1 : 0];
    const struct { const char *name; double *field; } fields[] = {
        { "position", &b->position[0] }, { "velocity", &b->velocity[0] },
        { "spin", &b->spin }, { "density", &p->density }, { "radius", &p->radius },
        { "friction", &p->friction }, { "restitution", &p->restitution },
        { "gravity", &s->gravity[1] }, { "step", &o->badStep },
    };
    const char *value = strchr(o->spoil, '=');
    char key[16] = "";
    if (value != NULL && value - o->spoil < 16)
        memcpy(key, o->spoil, (size_t)(value++ - o->spoil));
    o->badSteps = strcmp(key, "step") == 0;
    for (size_t i = 0; i < sizeof fields / sizeof *fields; i++)
        if (strcmp(key, fields[i].name) == 0) {
            *fields[i].field = strtod(value, NULL);
            return;
        }
    if (strcmp(key, "corners") != 0) peerRefuse("option --spoil %s", o->spoil);
    p->doubtful = 1;
    spoil_corners(p, value);
}

/* the peers' rows */
static void print_head(const peerEngine *e, const peerScene *s, const peerOptions *o)
{
    printf("# %s, %s; dt=%.9g substeps=%d iterations=%d (0: its default)\n", e->name,
           e->real, o->dt, o->substeps, o->iterations);
    printf("step,time,pairs,points,mean,top");
    for (int i = 0; i < s->bodies && !o->noBodies; i++)
        printf(",x%d,y%d,a%d,vx%d,vy%d,w%d", i, i, i, i, i, i);
    printf("\n");
}

static void print_row(const peerEngine *e, const peerScene *s, const peerOptions *o,
                      int step)
{
    double state[6], mean = 0, top = -INFINITY;
    int pairs = 0, points = 0, moving = 0;
    for (int i = 0; i < s->bodies; i++) {
        if (s->body[i].type != PEER_DYNAMIC) continue;
        e->read(i, state);
        mean += state[1];
        if (state[1] > top) top = state[1];
        moving++;
    }
    e->count(&pairs, &points);
    printf("%d,%.17g,%d,%d,%.9g,%.9g", step, step * o->dt, pairs, points,
           moving > 0 ? mean / moving : 0, moving > 0 ? top : 0);
    for (int i = 0; i < s->bodies && !o->noBodies; i++) {
        e->read(i, state);
        for (int k = 0; k < 6; k++) printf(",%.17g", state[k]);
    }
    printf("\n");
}

/* play a scene */
static void play(const peerEngine *e, const peerScene *s, const peerOptions *o)
{
    double *times = calloc((size_t)o->steps + 1, sizeof *times), sum = 0, best;
    int parts = o->substeps > 1 && !(e->can & PEER_OWN_SUBSTEPS) ? o->substeps : 1;
    if (times == NULL) exit(1);
    best = kernel(INFINITY);
    e->build(s, o);
    print_head(e, s, o);
    print_row(e, s, o, 0);
    for (int i = 1; i <= o->steps; i++) {
        double start = now();
        for (int k = 0; k < parts; k++) e->step(o->dt / parts);
        times[i - 1] = now() - start;
        sum += times[i - 1];
        if (o->badSteps && i == o->steps / 4) e->step(o->badStep);
        if (i % o->every == 0 || i == o->steps) print_row(e, s, o, i);
    }
    best = kernel(best);
    qsort(times, (size_t)o->steps, sizeof *times, by_size);
    if (o->steps > 0)
        printf("# clock: median=%.6g mean=%.6g least=%.6g most=%.6g kernel=%.6g ms\n",
               times[o->steps / 2], sum / o->steps, times[0], times[o->steps - 1], best);
    free(times);
}

int peerMain(const peerEngine *engine, int argc, char **argv)
{
    peerScene scene;
    peerOptions o = { .every = 0 };
    const char *file;
    if (argc == 2 && strcmp(argv[1], "--version") == 0) {
        printf("%s, %s\n", engine->name, engine->real);
        return 0;
    }
    file = read_options(argc, argv, &o);
    if (file == NULL) {
        fprintf(stderr, "use: %s SCENE.json --steps N [options]\n", argv[0]);
        return 1;
    }
    peerRead(file, &scene);
    if (o.dt == 0) o.dt = scene.dt;
    if (o.every < 1) o.every = 1;
    compare_with(engine, &scene, &o);
    if (o.spoil != NULL) spoil(&scene, &o);
    play(engine, &scene, &o);
    return fflush(stdout) != 0;
}
