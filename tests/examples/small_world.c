/* A world on two pages: its bodies, of one shape each, fall, touch, bounce and stack. Each
 * stage is one that the book derives; the list behind them is a step. Then the engine's own
 * world does the same, and every bit is compared. */
#include <stdio.h>
#include <string.h>
#include <weft/weft.h>

#ifndef STAGES
#define STAGES 4                /* -DSTAGES=2: the world as it is after two of them */
#endif
enum { MOST = 32, PAIRS = 256 };

typedef struct Small {
    int32_t count, pairCount, contactCount, beforeCount;
    wfBodyState body[MOST];                     /* what moves */
    wfBodyProps props[MOST];                    /* what does not */
    wfShape     shape[MOST];                    /* each about its centre of mass */
    wfReal      friction, restitution, h;
    wfVec2      gravity;
    wfPair      pair[PAIRS];
    wfContact   contact[PAIRS], before[PAIRS];  /* of this step, and of the last */
    _Alignas(64) uint8_t room[1 << 16];         /* scratch of the tables' rows */
} Small;

/* Forces and integration: velocity Verlet moves all bodies by h. */
static void weigh(void *context, const wfBodyState *state, int count, wfReal since,
                  wfBodyForces *sums)
{
    Small *s = context;
    wfForce gravity = wfGravity(s->gravity);
    wfBodyView bodies = { .count = count, .state = state, .props = s->props };
    wfAccumulateForces(&gravity, 1, &bodies, since, sums);
}

static wfResult fall(Small *s, wfPool *scratch)
{
    wfIntegration in = { .state = s->body, .count = s->count, .h = s->h, .forces = weigh,
                         .context = s, .scratch = scratch };
    wfResult result = wfIntegrate(wfFindIntegrator("verlet"), &in);
    for (int32_t i = 0; i < s->count; i++) wfWrapBodyAngle(&s->body[i]);
    return result;
}

/* Broad phase: each with each, by their boxes. */
static wfResult look(Small *s, wfPool *scratch)
{
    wfRect box[MOST];
    (void)scratch;
    s->pairCount = 0;
    for (int32_t i = 0; i < s->count; i++)
        box[i] = wfShapeBounds(&s->shape[i], wfBodyTransform(&s->body[i]));
    for (int32_t a = 0; a < s->count; a++)
        for (int32_t b = a + 1; b < s->count; b++) {
            bool moves = s->body[a].invMass > 0 || s->body[b].invMass > 0;
            if (!moves || !wfRectOverlap(box[a], box[b])) continue;
            if (s->pairCount == PAIRS) return WF_ERROR_FULL;
            s->pair[s->pairCount++] = (wfPair){ a, b };
        }
    return WF_OK;
}

static const wfContact *last_contact(const Small *s, int32_t a, int32_t b)
{
    for (int32_t i = 0; i < s->beforeCount; i++)
        if (s->before[i].a == a && s->before[i].b == b) return &s->before[i];
    return NULL;
}

/* Narrow phase and contacts. Points of a pair that touched in the last step are looked for
 * up to the slop, so that they keep their impulses; those with a gap go no further. */
static wfResult touch(Small *s, wfPool *scratch)
{
    (void)scratch;
    memcpy(s->before, s->contact, sizeof s->before);
    s->beforeCount = s->contactCount, s->contactCount = 0;
    for (int32_t k = 0; k < s->pairCount; k++) {
        int32_t a = s->pair[k].a, b = s->pair[k].b, kept = 0;
        const wfShape *one = &s->shape[a], *two = &s->shape[b];
        wfTransform xa = wfBodyTransform(&s->body[a]), xb = wfBodyTransform(&s->body[b]);
        wfReal slop = WF_R(0.005) * wfMinR(wfShapeMaxExtent(one), wfShapeMaxExtent(two));
        wfReal friction = wfMixFriction(s->friction, s->friction);
        const wfContact *old = last_contact(s, a, b);
        wfContact *c = &s->contact[s->contactCount];
        wfManifold *m = &c->manifold;
        wfSeparation found;
        wfResult result = wfSeparate(wfFindNarrowPhase("sat"), one, xa, two, xb, &found);
        if (result != WF_OK) return result;
        *c = (wfContact){ .a = a, .b = b, .shapeA = a, .shapeB = b, .friction = friction,
                          .staticFriction = friction, .restitution = s->restitution,
                          .slop = slop };
        wfMakeManifoldWithin(one, xa, two, xb, &found, old != NULL ? slop : 0, m);
        if (old != NULL && m->count > 0) wfCarryImpulses(old, c);
        for (int32_t i = 0; i < m->count; i++)
            if (m->points[i].depth >= 0) m->points[kept++] = m->points[i];
        m->count = kept;
        if (kept > 0) s->contactCount++;
    }
    return WF_OK;
}

/* Sequential impulses: bodies that touch part, and overlap goes away. */
static wfResult part(Small *s, wfPool *scratch)
{
    int solver = wfFindSolver("sequential");
    wfSolve in = { .state = s->body, .bodyCount = s->count, .contacts = s->contact,
                   .contactCount = s->contactCount, .h = s->h, .iterations = 8,
                   .restingSpeed = wfRestingSpeed(s->gravity, s->h, 2),
                   .positionCorrection = WF_R(0.4), .scratch = scratch };
    wfResult result = wfSolveVelocities(solver, &in);
    if (result == WF_OK) result = wfSolvePositions(solver, &in);
    for (int32_t i = 0; i < s->count; i++) wfWrapBodyAngle(&s->body[i]);
    return result;
}

static wfResult step(Small *s)
{
    wfResult (*const stage[])(Small *, wfPool *) = { fall, look, touch, part };
    wfResult result = WF_OK;
    for (int i = 0; i < STAGES && result == WF_OK; i++) {
        wfPool scratch;
        result = wfPoolInit(&scratch, sizeof s->room, s->room);
        if (result == WF_OK) result = stage[i](s, &scratch);
    }
    return result;
}

/* The same body in both worlds. */
static wfResult add(Small *s, wfWorld *large, const wfBodyDef *def)
{
    int32_t i = s->count++;
    wfBodyId id;
    wfResult result = wfAddBodyToWorld(large, def, &id);
    if (result != WF_OK) return result;
    wfBodyView all = wfWorldBodies(large);
    s->body[i] = all.state[i], s->props[i] = all.props[i], s->shape[i] = def->shape;
    return WF_OK;
}

/* A floor, a wall of nine boxes, and three balls that fall on it. */
static wfResult fill(Small *s, wfWorld *large)
{
    wfBodyDef body = wfDefaultBodyDef();
    body.friction = s->friction, body.restitution = s->restitution;
    body.type = WF_STATIC, body.position = wfV2(0, -1);
    wfMakeBox(20, 1, &body.shape);
    wfResult result = add(s, large, &body);
    body.type = WF_DYNAMIC;
    wfMakeBox(WF_R(0.5), WF_R(0.25), &body.shape);
    for (int i = 0; i < 9 && result == WF_OK; i++) {
        wfReal row = (wfReal)(i / 3);
        body.position = wfV2((wfReal)(i % 3) + row / 4, WF_R(0.25) + row / 2);
        result = add(s, large, &body);
    }
    wfMakeCircle(wfV2(0, 0), WF_R(0.4), &body.shape);
    for (int i = 0; i < 3 && result == WF_OK; i++) {
        body.position = wfV2((wfReal)(i - 1), (wfReal)(4 + i));
        result = add(s, large, &body);
    }
    return result;
}

int main(void)
{
    static Small s;
    wfWorld large = { 0 };
    wfWorldDef def = wfDefaultWorldDef();
    def.modules = WF_MODULE_ROTATION | WF_MODULE_SHAPES;
    if (STAGES == 4) {
        def.modules |= WF_MODULE_CONTACTS | WF_MODULE_FRICTION | WF_MODULE_RESTITUTION;
        def.solver = wfFindSolver("sequential"), def.iterations = 8;
        s.friction = WF_R(0.5), s.restitution = WF_R(0.25);
    }
    def.advanced.reuseManifolds = def.advanced.graphColouring = 0;   /* quicker ways */
    s.h = def.timeStep, s.gravity = def.gravity;
    if (wfCreateWorld(&def, &large) != WF_OK || fill(&s, &large) != WF_OK) return 1;
    int32_t most = 0, pairs = 0;
    for (int n = 0; n < 600; n++) {
        if (step(&s) != WF_OK || wfStepWorld(&large) != WF_OK) return 1;
        const wfBodyState *theirs = wfWorldBodies(&large).state;
        if (memcmp(s.body, theirs, (size_t)s.count * sizeof *s.body) != 0) {
            printf("the worlds differ after step %d\n", n);
            return 1;
        }
        if (most < s.contactCount) most = s.contactCount;
        if (pairs < s.pairCount) pairs = s.pairCount;
    }
    if ((pairs > 0) != (STAGES > 1) || (most > 0) != (STAGES > 2)) return 1;
    printf("%d bodies, up to %d contacts: equal to the bit for 600 steps\n", s.count, most);
    return 0;
}
/* prints:
13 bodies, up to 18 contacts: equal to the bit for 600 steps
*/
