/* abuse.c: sessions of abuse. Every function of the world's API is called with arguments good, bad and absurd, in any order,
   on ids alive, stale and invented; behind every call all promises that can be checked are checked:
     - a call that returned an error, or that only reads, has left every byte of the permanent chunk as it was;
     - a number that is none (NaN, infinite) was refused; so was a stale id, and a world that is none;
     - all state is finite, all ids that should be valid are, and no others; wfCheckWorld finds the block sound. */
#include "abuse.h"

Tally *tally;
int tracing;

void broken(int line, const char *what)
{
    snprintf(tally->broken, sizeof tally->broken, "abuse.c:%d: %s", line, what);
    abort();
}

/* ---- numbers ------------------------------------------------------------------------------------------------------- */
uint32_t next(Session *s)
{
    uint64_t z = (s->random += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)((z ^ (z >> 31)) >> 16);
}
static wfReal unit(Session *s) { return (wfReal)(next(s) >> 8) / (wfReal)(1 << 24); }

static wfReal tens(Session *s, int from, int to)            /* a power of ten, times 1 to 10 */
{
    double v = 1 + 9 * (double)unit(s);
    int n = from + (int)below(s, (uint32_t)(to - from + 1));
    for (; n > 0; n--) v *= 10;
    for (; n < 0; n++) v /= 10;
    return (wfReal)v;
}
static wfReal wild(Session *s)
{
    static const double special[] = { 0, -0.0, 1, -1, 0.5, 1e-38, 1e-45, 1e30, 3.4e38, -3.4e38, 1e6, 1e7, 16777217 };
    wfReal v;
    switch (below(s, 8)) {
    case 0: s->poisoned = true; v = (wfReal)(0.0 / (tracing < 0 ? 1.0 : 0.0)); return v;
    case 1: s->poisoned = true; v = WF_HUGE * 2; return below(s, 2) ? v : -v;
    case 2: v = (wfReal)special[below(s, sizeof special / sizeof *special)]; break;
    case 3: v = WF_HUGE * (1 - unit(s)); break;
    case 4: v = tens(s, 3, 37); break;
    case 5: v = tens(s, -38, -3); break;
    default: v = tens(s, -6, 6); break;
    }
    return below(s, 2) ? v : -v;
}
/* tame numbers lie within +-size */
static wfReal real(Session *s, wfReal size)
{
    if (chance(s, (uint32_t)s->wild)) return wild(s);
    return below(s, 8) ? size * (2 * unit(s) - 1) : 0;
}
static wfReal more(Session *s, wfReal size)                 /* tame ones are >= 0 */
{
    return chance(s, (uint32_t)s->wild) ? wild(s) : below(s, 8) ? size * unit(s) : 0;
}
static wfVec2 vector(Session *s, wfReal size) { wfReal x = real(s, size), y = real(s, size); return wfV2(x, y); }
static int32_t whole(Session *s, int32_t from, int32_t to)
{
    if (!chance(s, (uint32_t)s->wild)) return from + (int32_t)below(s, (uint32_t)(to - from + 1));
    static const int32_t odd[] = { -1, -2, INT32_MIN, INT32_MAX, 1 << 24, (1 << 24) + 1, 255, 256, 65536, 99 };
    return odd[below(s, sizeof odd / sizeof *odd)];
}
static int32_t yes(Session *s) { return whole(s, 0, 1); }

/* ---- handles and ids ----------------------------------------------------------------------------------------------- */
static wfWorld *handle(Session *s)
{
    static _Alignas(16) uint8_t rubbish[1 << 14];
    static wfWorld none, wrong;
    if (!s->made || (!s->inHook && below(s, 128) == 0)) {
        s->badHandle = true;
        memset(rubbish, (int)below(s, 256), sizeof rubbish);
        wrong = (wfWorld){ .memory = { rubbish, sizeof rubbish, rubbish, sizeof rubbish, 0 } };
        none = (wfWorld){ .memory = { .owned = 0 } };
        uint32_t which = below(s, 3);
        return which == 0 ? NULL : which == 1 ? &none : &wrong;
    }
    return &s->world;
}
static const Thing *pick(Session *s, const Things *t)
{
    static Thing invented;
    bool stale = chance(s, 12);
    int from = t->count ? (int)below(s, (uint32_t)t->count) : 0;
    if (stale || t->alive > 0)
        for (int k = 0; k < t->count; k++)
            if (t->list[(from + k) % t->count].alive != stale) return &t->list[(from + k) % t->count];
    invented = (Thing){ .index = chance(s, 128) ? below(s, 40) : next(s), .generation = chance(s, 128) ? below(s, 4) : next(s) };
    for (int k = 0; k < t->count; k++)              /* invented well */
        if (t->list[k].index == invented.index && t->list[k].generation == invented.generation) return &t->list[k];
    return &invented;
}
static bool stale;                                          /* the call got an id that is not valid */
#define PICK(type, which) static type pick_##which(Session *s) \
    { const Thing *t = pick(s, &s->which); stale = stale || !t->alive; type id = { t->index, t->generation }; return id; }
PICK(wfBodyId, bodies) PICK(wfShapeId, shapes) PICK(wfForceId, forces) PICK(wfJointId, joints)

/* a body's index: of one that is there, mostly */
static int32_t pick_index(Session *s)
{
    wfBodyId id = pick_bodies(s);
    return chance(s, 250) ? (int32_t)id.index - 1 : whole(s, -1, 30);
}

static void learn(Things *t, uint32_t index, uint32_t generation, int32_t a, int32_t b, uint32_t owner)
{
    int at = t->count;
    if (at >= KNOWN) for (at = 0; at < t->count && t->list[at].alive;) at++;
    if (at == MOST_KNOWN) broken(__LINE__, "more things than the session knows of");
    if (at == t->count) t->count++;
    for (int k = 0; k < t->count; k++)
        if (k != at && t->list[k].index == index) MUST(t->list[k].generation != generation);
    t->list[at] = (Thing){ index, generation, a, b, true, owner };
    t->alive++;
}
static void forget(Things *t, int k) { if (t->list[k].alive) { t->list[k].alive = false; t->alive--; } }
static int find(const Things *t, uint32_t index, uint32_t generation)
{
    for (int k = 0; k < t->count; k++)
        if (t->list[k].alive && t->list[k].index == index && t->list[k].generation == generation) return k;
    return -1;
}

/* ---- shapes -------------------------------------------------------------------------------------------------------- */
static wfShape shape(Session *s)
{
    wfShape out = { .kind = WF_SHAPE_NONE };
    wfVec2 p[9];
    bool before = s->poisoned;
    wfResult r = WF_OK;
    wfReal size = WF_R(1.0);
    switch (below(s, 9)) {
    case 0: r = wfMakeCircle(vector(s, WF_R(0.2)), WF_R(0.02) + more(s, size), &out); break;
    case 1: r = wfMakeBox(WF_R(0.02) + more(s, size), WF_R(0.02) + more(s, size), &out); break;
    case 2: r = wfMakeOrientedBox(vector(s, size), WF_R(0.1) + more(s, size), WF_R(0.1) + more(s, size), real(s, 4), &out); break;
    case 3: r = wfMakeCapsule(vector(s, size), vector(s, size), WF_R(0.05) + more(s, size), &out); break;
    case 4: r = wfMakeSegment(vector(s, size), vector(s, size), &out); break;
    case 5: r = wfMakeRoundedBox(WF_R(0.1) + more(s, size), WF_R(0.1) + more(s, size), more(s, WF_R(0.3)), &out); break;
    case 6: {
        int n = 3 + (int)below(s, 6);
        for (int i = 0; i < n; i++) p[i] = vector(s, size);
        r = wfMakePolygon(p, n, &out);
        break; }
    case 7: for (int i = 0; i < 4; i++) p[i] = wfV2((wfReal)i - 1, real(s, WF_R(0.5)));
        r = wfMakeLink(p[0], p[1], p[2], p[3], &out); break;
    default: r = wfMakeBox(WF_R(0.5), WF_R(0.5), &out); break;
    }
    if (r != WF_OK || !chance(s, (uint32_t)s->wild)) { s->poisoned = before; return out; }
    wfReal *number = &out.vertices[0].x;                    /* somebody has been at the structure */
    if (below(s, 3) == 0) out.kind = whole(s, -1, 9);
    else if (below(s, 2)) out.count = whole(s, -1, 20);
    else number[below(s, 8)] = wild(s);
    s->poisoned = before;                                   /* whether that matters depends on the kind */
    return out;
}

/* ---- results ------------------------------------------------------------------------------------------------------- */
/* What every call with a result must obey; the operation adds what is its own. */
static wfResult seen(Session *s, wfResult r, bool usesAll)
{
    MUST((int)r >= 0 && r < WF_RESULT_COUNT);
    if (s->badHandle) MUST(r != WF_OK);
    if (stale) MUST(r != WF_OK);
    if (usesAll && s->poisoned) MUST(r != WF_OK);
    bool noted = r != WF_OK && r != WF_ERROR_BUSY && !s->badHandle && !s->inHook && operations[tally->now.op].kind == CHANGES;
    if (noted) MUST(wfLastFault(&s->world)->result == r && strchr(wfLastFault(&s->world)->text, ':') != NULL);
    return r;
}
#define CALL(call) seen(s, call, true)
#define CALL_LOOSE(call) seen(s, call, false)               /* not all of its numbers are looked at */

/* ---- worlds -------------------------------------------------------------------------------------------------------- */
static wfWorldDef world_def(Session *s)
{
    wfWorldDef d = wfDefaultWorldDef();
    d.gravity = vector(s, 10);
    d.timeStep = chance(s, 200) ? WF_R(1.0) / 60 : more(s, WF_R(0.1));
    d.bodyCapacity = whole(s, 1, 20);
    d.shapeCapacity = whole(s, 0, 30);
    d.forceCapacity = whole(s, 0, 6);
    d.jointCapacity = whole(s, 0, 10);
    d.advanced.pairCapacity = chance(s, 128) ? 0 : whole(s, 1, 90);
    d.advanced.contactCapacity = chance(s, 128) ? 0 : whole(s, 1, 60);
    d.advanced.materialPairCapacity = whole(s, 0, 3);
    d.maxImpacts = whole(s, 0, 8);
    d.integrator = whole(s, 0, wfIntegratorCount - 1);
    d.advanced.broadPhase = whole(s, 0, wfBroadPhaseCount - 1);
    d.advanced.narrowPhase = whole(s, 0, wfNarrowPhaseCount - 1);
    if (chance(s, 128)) d.solver = whole(s, 0, wfSolverCount - 1);
    d.advanced.directJoints = whole(s, 0, 2);
    d.sleep = yes(s);
    d.advanced.timeToSleep = WF_R(0.01) + more(s, WF_R(0.5));
    d.substeps = whole(s, 1, 6);
    d.iterations = whole(s, 1, 2);                 /* a hopeless step of "exact" takes half a second for each, and five times that under the sanitizers */
    d.events = yes(s); d.advanced.queries = yes(s); d.advanced.reuseManifolds = yes(s); d.advanced.stackSolver = yes(s); d.advanced.graphColouring = yes(s);
    d.frictionRule = whole(s, 0, wfMixCount - 1);
    d.restitutionRule = whole(s, 0, wfMixCount - 1);
    d.advanced.rollingRule = whole(s, 0, wfMixCount - 1);
    if (chance(s, 32)) { d.advanced.restitutionThreshold = more(s, 4); d.advanced.hitThreshold = more(s, 9); d.advanced.positionCorrection = more(s, 1); d.advanced.slop = more(s, WF_R(0.1)); }
    if (chance(s, 32)) { d.advanced.contactPeriod = more(s, 20); d.advanced.contactDampingRatio = more(s, 10); d.advanced.contactPushSpeed = more(s, 50); d.advanced.directJointCost = more(s, 20); d.advanced.jointCompliance = more(s, WF_R(0.01)); }
    return d;
}

static void make_world(Session *s)
{
    for (int tries = 0; !s->made; tries++) {
        s->poisoned = s->badHandle = false;
        int wildness = s->wild;
        if (tries > 20) s->wild = 0;
        s->def = world_def(s);
        s->wild = wildness;
        if (s->def.substeps > 99 || s->def.iterations > 99) continue;
        wfResult r = wfWorldSize(&s->def, &s->size[0], &s->size[1]);
        if (r != WF_OK || s->size[0] > 1 << 22 || s->size[1] > 1 << 23) continue;
        for (int i = 0; i < 2; i++) s->chunk[i] = aligned_alloc(16, s->size[0]);
        s->transient = aligned_alloc(16, s->size[1]);
        s->shadow = malloc(s->size[0]);
        s->given = chance(s, 200);
        for (int i = 0; i < 2; i++) memset(s->chunk[i], 0xab, s->size[0]);
        memset(s->transient, 0xcd, s->size[1]);
        if (s->given) s->def.memory = (wfMemory){ s->chunk[0], s->size[0], s->transient, s->size[1], 0 };
        r = wfCreateWorld(&s->def, &s->world);
        MUST(r == WF_OK);
        s->side = 0;
        s->made = true;
        memcpy(s->shadow, s->world.memory.permanent, s->size[0]);
    }
}
static void drop_world(Session *s)
{
    wfDestroyWorld(&s->world);
    for (int i = 0; i < 2; i++) free(s->chunk[i]);
    free(s->transient);
    free(s->shadow);
    s->made = false;
    s->bodies.count = s->shapes.count = s->forces.count = s->joints.count = 0;
    s->bodies.alive = s->shapes.alive = s->forces.alive = s->joints.alive = 0;
}

/* ---- the promises about the whole -------------------------------------------------------------------------------------- */
static void check_bodies(const Session *s, const wfWorld *w)
{
    wfBodyView view = wfWorldBodies(w);
    for (int32_t i = 0; i < view.count; i++) {
        wfBodyId id = wfBodyAt(w, i);
        if (id.index == 0) continue;
        const wfBodyState *b = &view.state[i];
        MUST(wfBodyIsFinite(b) && b->invMass >= 0 && b->invInertia >= 0 && wfAbs(b->angle) <= WF_PI);
        if (view.props[i].type != WF_DYNAMIC) MUST(b->invMass == 0 && b->invInertia == 0);
        if (view.props[i].type == WF_STATIC) MUST(b->v.x == 0 && b->v.y == 0 && b->w == 0);
        MUST(wfBodyIndex(w, id) == i && find(&s->bodies, id.index, id.generation) >= 0);
    }
    for (int k = 0; k < s->bodies.count; k++) {
        const Thing *t = &s->bodies.list[k];
        wfBodyId id = { t->index, t->generation };
        MUST(wfBodyIsValid(w, id) == t->alive);
        if (!t->alive) continue;
        wfBodyInfo info;
        MUST(wfGetBody(w, id, &info) == WF_OK && wfIsFinite2(info.position) && wfIsFinite(info.mass));
        int shapes = 0;
        for (wfShapeId h = wfFirstShape(w, id); h.index != 0; h = wfNextShape(w, h)) {
            wfBodyId owner = wfShapeBody(w, h);
            MUST(owner.index == id.index && owner.generation == id.generation && ++shapes <= MOST_KNOWN);
        }
        int known = 0;
        for (int i = 0; i < s->shapes.count; i++) known += s->shapes.list[i].alive && s->shapes.list[i].owner == id.index;
        MUST(shapes == known);
    }
}
static void check_lists(const Session *s, const wfWorld *w)
{
    int32_t n = -1;
    wfShapeView shapes = wfWorldShapes(w);
    for (int k = 0; k < s->shapes.count; k++) {
        wfShapeId id = { s->shapes.list[k].index, s->shapes.list[k].generation };
        MUST(wfShapeIsValid(w, id) == s->shapes.list[k].alive);
    }
    for (int k = 0; k < s->joints.count; k++) {
        wfJoint j;
        wfJointId id = { s->joints.list[k].index, s->joints.list[k].generation };
        MUST(wfJointIsValid(w, id) == s->joints.list[k].alive && (wfGetJoint(w, id, &j) == WF_OK) == s->joints.list[k].alive);
        if (s->joints.list[k].alive) MUST(wfBodyAt(w, j.a).index != 0 && wfBodyAt(w, j.b).index != 0 && wfIsFinite(j.impulse[0]));
    }
    for (int k = 0; k < s->forces.count; k++) {
        MUST(wfForceIsValid(w, (wfForceId){ s->forces.list[k].index, s->forces.list[k].generation }) == s->forces.list[k].alive);
    }
    const wfContact *c = wfWorldContacts(w, &n);
    for (int32_t i = 0; i < n; i++) {
        MUST(c[i].shapeA >= 0 && c[i].shapeB < shapes.count && c[i].shapeA < c[i].shapeB);
        MUST(shapes.bodyOfShape[c[i].shapeA] == c[i].a && shapes.bodyOfShape[c[i].shapeB] == c[i].b);
        for (int p = 0; p < c[i].manifold.count; p++)
            MUST(wfIsFinite2(c[i].manifold.points[p].point) && wfIsFinite(c[i].manifold.points[p].normalImpulse));
    }
    const wfPair *pairs = wfWorldPairs(w, &n);
    for (int32_t i = 0; i < n; i++) MUST(pairs[i].a >= 0 && pairs[i].a < pairs[i].b && pairs[i].b < shapes.count);
}
static void check_counts(const Session *s, const wfWorld *w)
{
    MUST(wfBodyCount(w) == s->bodies.alive && wfBodyCount(w) <= s->def.bodyCapacity);
    MUST(wfShapeCount(w) == s->shapes.alive);
    MUST(wfForceCount(w) == s->forces.alive && wfForceCount(w) <= s->def.forceCapacity);
    MUST(wfJointCount(w) == s->joints.alive && wfJointCount(w) <= s->def.jointCapacity);
}
static void check_all(Session *s)
{
    check_bodies(s, &s->world);
    check_lists(s, &s->world);
#ifdef WEFT_SAVE_H
    wfFault fault;
    wfResult r = wfCheckWorld(&s->world, &fault);
    if (r != WF_OK) {
        if (tracing > 0) { wfShape g = wfWorldShapes(&s->world).shapes[fault.element < wfWorldShapes(&s->world).count ? fault.element : 0];
            printf("shape kind %d count %d radius %.9g: %s\n", g.kind, g.count, (double)g.radius, wfResultName(wfCheckShape(&g)));
            for (int k = 0; k < g.count; k++) printf("  %.9g %.9g\n", (double)g.vertices[k].x, (double)g.vertices[k].y); }
        snprintf(tally->broken, sizeof tally->broken, "wfCheckWorld: %s[%lld]: %s", fault.region, (long long)fault.element, fault.rule);
        abort();
    }
#endif
}

static wfResult run_operation(Session *s, const Operation *op);
#include "operations.h"

/* Which array of the block is not what it was? */
static void tell_difference(const Session *s, wfResult r)
{
    static wfRegion list[MOST_ARRAYS];
    const uint8_t *now = s->world.memory.permanent;
    size_t at = 0;
    while (now[at] == s->shadow[at]) at++;
    const char *name = "?";
    size_t each = 1, from = 0;
    if (wfWorldRegions(&s->def, list) == WF_OK)
        for (int i = 0; i < wfRegionCount; i++)
            if (list[i].chunk == 0 && list[i].offset <= at && at < list[i].offset + list[i].count * list[i].each) { name = list[i].name; each = list[i].each; from = list[i].offset; }
    snprintf(tally->broken, sizeof tally->broken, "%s returned %s and changed \"%s\" in element %zu, byte %zu",
        operations[tally->now.op].name, wfResultName(r), name, (at - from) / each, (at - from) % each);
    abort();
}

/* ---- a call ------------------------------------------------------------------------------------------------------------ */
void begin_session(Session *s, uint64_t seed)
{
    static const int wildness[] = { 0, 1, 4, 20, 60 };
    memset(s, 0, sizeof *s);
    s->random = seed;
    s->wild = wildness[below(s, 5)];
    make_world(s);
    tally->sessions++;
}
void end_session(Session *s) { if (s->made) { check_all(s); drop_world(s); } }

uint32_t choose(uint64_t *random)
{
    static int total;
    if (total == 0) for (int i = 0; i < operationCount; i++) total += operations[i].weight;
    Session s = { .random = *random };
    int at = (int)(next(&s) % (uint32_t)total);
    *random = s.random;
    for (int i = 0; i < operationCount; i++)
        if ((at -= operations[i].weight) < 0) return (uint32_t)i;
    return 0;
}

static wfResult run_operation(Session *s, const Operation *op)
{
    s->poisoned = s->badHandle = false;
    stale = false;
    return op->run(s);
}

void do_call(Session *s, Call call)
{
    const Operation *op = &operations[call.op % (uint32_t)operationCount];
    s->random = call.seed;
    if (!s->made) make_world(s);
    s->changed = false;
    if (chance(s, 16) && s->made) memset(s->world.memory.transient, (int)below(s, 256), s->size[1]);    /* it is scratch paper */
    wfResult r = run_operation(s, op);
    tally->calls[call.op][op->silent ? WF_RESULT_COUNT : r]++;
    tally->done++;
    if (tracing > 1 && s->made) {
        int32_t n;
        const wfPair *pairs = wfWorldPairs(&s->world, &n);
        wfBodyView v = wfWorldBodies(&s->world);
        for (int32_t i = 0; i < n; i++) printf("     pair %d %d\n", pairs[i].a, pairs[i].b);
        for (int32_t i = 0; i < v.count; i++)
            printf("     body %d type %d awake %d at %g %g, v %g %g\n", i, v.props[i].type, wfBodyIsAwake(&s->world, wfBodyAt(&s->world, i)), (double)v.state[i].p.x,
                (double)v.state[i].p.y, (double)v.state[i].v.x, (double)v.state[i].v.y);
    }
    if (tracing > 0) printf("  %-28s %s\n", op->name, op->silent ? "" : wfResultName(r));
    if (!s->made) return;
    bool same = memcmp(s->world.memory.permanent, s->shadow, s->size[0]) == 0;
    if (op->kind == READS || r != WF_OK) if (!same) tell_difference(s, r);
    check_counts(s, &s->world);
    if (!same) memcpy(s->shadow, s->world.memory.permanent, s->size[0]);
    bool stepped = op->group[0] == 's' && op->group[1] == 't';
    if (++s->sinceCheck >= 12 || (stepped && r == WF_OK)) { s->sinceCheck = 0; check_all(s); }
}
