/* Weft: engine/step.c, tangled from chapters/engine/20-world.nw. Chapters that add to it: step,
 * sensors-and-callbacks, joints-in-a-world, continuous-collision, sleep-in-a-world, accuracy. Do
 * not edit this file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/step.h"

/* copy the states */
static wfResult copy_states(struct wfStep *s)
{
    s->count = s->b.head->bodySlots.high;
    s->state = wfTransient(&s->b, WF_REGION_NEW_STATE);
    memcpy(s->state, s->b.state, (size_t)s->count * sizeof *s->state);
    s->present = wfTransient(&s->b, WF_REGION_PRESENT);
    memcpy(s->present, s->b.alive, (size_t)s->count);
    s->all = true;
    /* say which bodies do not take part */
    s->shapeCount = s->b.head->shapeSlots.high;
    s->kept = s->b.head->kept;     /* in this chapter nothing is */
    s->view = (wfCallbackView){ .bodies = wfViewOf(&s->b, s->state),
                                .shapes = wfShapesOf(&s->b), .timeStep = s->b.head->timeStep };
    s->fine = NULL;
    if (wfResidualOf(&s->b) != NULL) s->fine = wfTransient(&s->b, WF_REGION_NEW_FINE);
    if (s->fine != NULL) memcpy(s->fine, s->b.fine, (size_t)s->count * sizeof *s->fine);
    wfLeaveOutSleeping(s);
    const wfHeader *head = s->b.head;
    size_t scratch = (size_t)(head->scratchBytes - head->offset[WF_REGION_SCRATCH]);
    return wfPoolInit(&s->scratch, scratch, wfTransient(&s->b, WF_REGION_SCRATCH));
}

/* list the forces of the step */
static wfResult list_forces(struct wfStep *s)
{
    s->forces = wfTransient(&s->b, WF_REGION_ACTIVE_FORCES);
    s->ages = wfTransient(&s->b, WF_REGION_AGES);
    s->ages[0] = 0;             /* gravity does not ask */
    s->forces[s->forceCount++] = wfGravity(s->b.head->gravity);
    /* list the registered forces */
    for (int32_t i = 0; i < s->b.head->forceSlots.high; i++) {
        if (s->b.forceSlots[i].next != WF_SLOT_LIVE) continue;
        s->ages[s->forceCount] = (wfReal)(s->b.head->time - s->b.added[i]);
        s->forces[s->forceCount++] = s->b.forces[i];
    }
    return WF_OK;
}

/* damp the states by eq:world-split */
static wfResult damp_half(struct wfStep *s)
{
    wfReal half = s->b.head->timeStep / 2;
    if (!wfHas(s->b.head, WF_MODULE_DAMPING)) return WF_OK;
    for (int32_t i = 0; i < s->count; i++) {
        const wfBodyProps *p = &s->b.props[i];
        if (s->present[i] && p->type == WF_DYNAMIC)
            wfDampVelocity(&s->state[i], p->linearDamping, p->angularDamping, half);
    }
    return WF_OK;
}

static wfResult damp_again(struct wfStep *s)
{
    bool later = false;                     /* after a solver that steps by itself */
    /* see whether the second half comes later */
    later = wfSolverIntegrates(s);
    return later ? WF_OK : damp_half(s);
}

/* integrate the step */
static void forces_on(void *context, const wfBodyState *state, int count, wfReal since,
                      wfBodyForces *out)
{
    const struct wfStep *s = (const struct wfStep *)context;   /* since: s, of this step */
    wfBodyView bodies = wfViewOf(&s->b, state);
    bodies.alive = s->present;
    bodies.step = s->b.head->timeStep;
    (void)count;
    /* add what the user applied */
    bool pushed = wfHas(s->b.head, WF_MODULE_PUSHES);
    for (int i = 0; pushed && i < count; i++) {
        if (!s->present[i]) continue;
        wfApplyForceToCentre(&out[i], s->b.applied[i].force);
        wfApplyTorque(&out[i], s->b.applied[i].torque);
    }
    for (int32_t i = 0; i < s->forceCount; i++)
        wfAccumulateForces(&s->forces[i], 1, &bodies, s->ages[i] + since, out);
}

static wfResult sum_forces(struct wfStep *s)
{
    size_t mark = wfPoolMark(&s->scratch);
    wfBodyState *middle = wfPoolPushArray(&s->scratch, s->count, wfBodyState);
    wfReal half = s->b.head->timeStep / 2;
    s->sums = wfTransient(&s->b, WF_REGION_SUMS);
    if (middle == NULL) return WF_ERROR_MEMORY;
    s->movers = s->count;       /* until the boxes are made, if they are */
    memset(s->sums, 0, (size_t)s->count * sizeof *s->sums);
    for (int32_t i = 0; i < s->count; i++) {
        middle[i] = s->state[i];
        if (!s->present[i]) continue;
        middle[i].p = wfAddScaled(middle[i].p, half, middle[i].v);
        middle[i].angle = wfWrapAngle(middle[i].angle + half * middle[i].w);
    }
    forces_on(s, middle, s->count, half, s->sums);
    wfPoolRewind(&s->scratch, mark);
    return WF_OK;
}

static wfResult integrate(struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    /* leave it to a solver that steps by itself */
    if (wfSolverIntegrates(s)) return sum_forces(s);
    wfIntegration in = { .state = s->state, .count = s->count, .time = 0,
                         .h = head->timeStep, .forces = forces_on, .context = s,
                         .scratch = &s->scratch };
    return wfIntegratorTable[head->integrator].step(&in);
}

/* check the new states */
static wfResult check_states(struct wfStep *s)
{
    for (int32_t i = 0; i < s->count; i++) {
        if (!s->present[i]) continue;
        if (!wfBodyIsFinite(&s->state[i])) return WF_ERROR_NOT_FINITE;
        /* settle the angle and the digits of body i */
        wfWrapBodyAngle(&s->state[i]);
        if (s->fine != NULL) wfSettleDigits(&s->state[i], &s->fine[i]);
    }
    /* check that contacts are finite */
    for (int32_t i = 0; i < s->contactCount; i++) {
        const wfContact *c = &s->contacts[i];
        wfReal nought = 0 * c->manifold.normal.x + 0 * c->manifold.normal.y
                      + 0 * c->rollingImpulse + 0 * c->slop + 0 * c->friction
                      + 0 * c->staticFriction + 0 * c->rollingResistance + 0 * c->tangentSpeed;
        for (int32_t k = 0; k < c->manifold.count; k++) {
            const wfContactPoint *p = &c->manifold.points[k];
            nought += 0 * p->point.x + 0 * p->point.y + 0 * p->rA.x + 0 * p->rA.y;
            nought += 0 * p->rB.x + 0 * p->rB.y + 0 * p->depth;
            nought += 0 * p->normalImpulse + 0 * p->tangentImpulse;
        }
        if (nought != 0) return WF_ERROR_NOT_FINITE;
    }
    double end = s->b.head->time + (double)s->b.head->timeStep;
    return wfIsFinite((wfReal)end) ? WF_OK : WF_ERROR_NOT_FINITE;
}

static void keep_digits(struct wfStep *s)
{
    for (int32_t i = 0; i < s->count; i++)
        s->b.fine[i] = s->present[i] ? s->fine[i] : (wfResidual){ .w = 0 };
}

/* resolve the contacts */
int32_t wfPassesOf(const wfHeader *head)
{
    return head->iterations > 0 ? head->iterations : wfUsualPasses(head->solver);
}

/* find how fast overlaps may be left */
static wfReal recovery_speed(const wfHeader *head)
{
    wfReal speed = wfRestingSpeed(head->gravity, head->timeStep, head->contactPushSpeed);
    return speed > 0 || head->contactPushSpeed == 0 ? speed : WF_HUGE;
}

static wfSolve to_solve(struct wfStep *s)
{
    const wfHeader *head = s->b.head;
    return (wfSolve){ .state = s->state, .bodyCount = s->count, .contacts = s->contacts,
        .contactCount = s->contactCount, .h = head->timeStep,
            .iterations = wfPassesOf(head),
        .restingSpeed = wfRestingSpeed(head->gravity, head->timeStep,
                                       head->restitutionThreshold),
        .positionCorrection = head->positionCorrection, .forces = s->sums,
        .substeps = head->substeps, .laws = s->laws,
        .scratch = &s->scratch, .report = &s->report,
        .present = s->all ? NULL : s->present,
        /* what else a solver is told */
        .told = s->told,
        .recoverySpeed = recovery_speed(head),
        .contactPeriod = head->contactPeriod, .contactDampingRatio = head->contactDampingRatio,
        .stackSolver = head->stackSolver, .graphColouring = head->graphColouring,
            .enableSimd = head->enableSimd,
        .work = WF_EXACT_WORK,
        .fine = s->fine,
    };
}

static wfResult solve_velocities(struct wfStep *s)
{
    wfSolve solve = to_solve(s);
    if (s->movers == 0) return WF_OK;
    if (!wfSolverIntegrates(s)) return wfSolveVelocities(s->b.head->solver, &solve);
    wfResult result = WF_OK;
    bool done = false;
    /* let islands step by themselves */
    done = wfStepsApart(s);
    if (done) result = wfStepApart(s, &solve);
    if (!done) result = wfSolverTable[s->b.head->solver].step(&solve);
    /* damp the states behind the solver */
    if (result == WF_OK) result = damp_half(s);
    return result;
}

static wfResult solve_positions(struct wfStep *s)
{
    wfSolve solve = to_solve(s);
    return wfSolverIntegrates(s) ? WF_OK : wfSolvePositions(s->b.head->solver, &solve);
}

/* commit the step */
static void copy_back(void *to, const void *from, int32_t count, size_t each)
{
    if (count > 0 && from != NULL) memcpy(to, from, (size_t)count * each);
}

static wfResult commit(struct wfStep *s)
{
    /* before the step becomes the world */
    wfHeader *head = s->b.head;
    wfKeepRest(s);
    copy_back(s->b.state, s->state, s->count, sizeof *s->state);
    /* commit what was found */
    if (wfHas(head, WF_MODULE_PUSHES))
        memset(s->b.applied, 0, (size_t)s->count * sizeof *s->b.applied);
    copy_back(s->b.bounds, s->bounds, s->shapeCount, sizeof *s->bounds);
    copy_back(s->b.flags, s->flags, s->shapeCount, sizeof *s->flags);
    int32_t pairs = s->pairs.count, at = s->kept.pairs;
    copy_back(s->b.pairs + at, s->pairs.pairs, pairs, sizeof *s->b.pairs);
    copy_back(s->b.caches + at, s->caches, pairs, sizeof *s->caches);
    copy_back(s->b.contacts + s->kept.contacts, s->contacts, s->contactCount,
              sizeof *s->contacts);
    if (s->index != NULL)
        wfCopyIndex(head->broadPhase, s->b.index, s->index, wfIndexBytes(head),
                    s->shapeCount, true);
    copy_back(s->b.touches + s->kept.touches, s->touches, s->touchCount,
              sizeof *s->touches);
    copy_back(s->b.events, s->events, s->eventTotal, sizeof *s->events);
    copy_back(s->b.hits, s->hits, s->hitCount, sizeof *s->hits);
    if (s->fine != NULL) keep_digits(s);
    /* count what was committed */
    head->time += (double)head->timeStep;
    head->steps++;
    head->kept = s->kept;
    head->pairCount = s->kept.pairs + s->pairs.count;
    head->contactCount = s->kept.contacts + s->contactCount;
    if (head->mostPairs < s->foundPairs) head->mostPairs = s->foundPairs;
    if (head->mostContacts < head->contactCount) head->mostContacts = head->contactCount;
    head->indexStale = 1;
    head->indexStale = !head->queries;
    head->touchCount = s->kept.touches + s->touchCount;
    head->hitCount = s->hitCount;
    if (head->mostPairs < head->touchCount) head->mostPairs = head->touchCount;
    if (head->mostPairs < head->hitCount) head->mostPairs = head->hitCount;
    memcpy(head->eventCount, s->eventCount, sizeof head->eventCount);
    head->report = s->report;
    head->fastCount = s->fastCount;
    head->impactCount = s->impactCount;
    head->heldCount = s->heldCount;
    head->crowd = s->fastCount > WF_CROWD && (head->crowd || s->impactCount >= WF_STEP_ROOM);
    if (s->followed || s->fastCount > 0) wfUse(&s->b, WF_MODULE_FAST);
    if (head->mostPairs < s->strikeCount) head->mostPairs = s->strikeCount;
    return WF_OK;
}

/* the table of stages */
const wfStageRow wfStageTable[] = {
    { "copy", "copy the states, so that a step that fails has changed nothing",
      "states", "new states", copy_states,
      0, 0 },
    { "forces", "list gravity and the registered forces that act",
      "forces", "active forces", list_forces,
      0, 0 },
    { "damp", "damp the velocities over the first half of the step",
      "properties", "new states", damp_half,
      WF_MODULE_DAMPING, 0 },
    { "integrate", "let the forces act: new velocities, new places",
      "active and applied forces", "new states, sums of forces", integrate,
      0, 0 },
    { "damp again", "damp the velocities over the second half",
      "properties", "new states", damp_again,
      WF_MODULE_DAMPING, 0 },
    { "check", "stop here if a number has overflowed",
      "new states", "", check_states,
      0, 0 },
    { "bounds", "put an upright box round every shape",
      "new states, shapes", "new bounds, new flags", wfBoundShapes,
      0, WF_MODULE_CONTACTS | WF_MODULE_QUERIES },
    /* stages that find pairs */
    { "broad phase", "find the pairs whose boxes overlap",
      "new bounds, new flags, index", "new pairs, new index", wfFindNewPairs,
      0, WF_MODULE_CONTACTS | WF_MODULE_QUERIES },
    { "joined pairs", "bodies that are joined do not collide",
      "new pairs, joints", "new pairs", wfLeaveOutJoined,
      WF_MODULE_JOINTS | WF_MODULE_CONTACTS, 0 },
    { "joints", "copy the joints, for the solver to keep",
      "joints", "new joints", wfTakeJoints,
      WF_MODULE_JOINTS, 0 },
    { "impacts", "follow fast bodies to what they hit (a solver that does not step)",
      "states, new states, joints", "new states, new pairs, strikes", wfContinuousBefore,
      WF_MODULE_FAST, 0 },
    { "sleepers met", "place the sleepers whose boxes somebody has met",
      "new pairs, new states", "places", wfPlaceSleeping,
      WF_MODULE_SLEEP, 0 },
    { "narrow phase", "find the pairs that touch, and where",
      "new pairs, new states, contacts", "new contacts, touches, hits", wfFindContacts,
      WF_MODULE_CONTACTS, 0 },
    /* stages that mend */
    { "velocities", "make touching bodies part",
      "new contacts, sums of forces", "new states", solve_velocities,
      0, WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS },
    { "positions", "take overlaps away",
      "new contacts", "new states", solve_positions,
      0, WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS },
    { "loads", "see what the joints bore, and which of them broke",
      "new joints", "new joints", wfBreakJoints,
      WF_MODULE_JOINTS, 0 },
    { "late impacts", "the same, behind a solver that steps",
      "states, new states, joints", "new states, strikes", wfContinuousAfter,
      WF_MODULE_FAST, 0 },
    { "strikes", "what was struck was touched, and hit",
      "strikes", "new touches, hits", wfTellImpactEvents,
      WF_MODULE_FAST, 0 },
    { "check again", "stop here if a number has overflowed",
      "new states", "", check_states,
      0, WF_MODULE_CONTACTS | WF_MODULE_SUBSTEPS },
    { "touches", "remember who touches whom",
      "new touches, new contacts", "new touches", wfKeepTouches,
      WF_MODULE_CONTACTS, 0 },
    { "events", "say what began, goes on and ended",
      "new touches, touches", "new events", wfTellEvents,
      WF_MODULE_EVENTS, 0 },
    /* stages before the end */
    { "index", "prepare the answers to queries",
      "new states, shapes", "new bounds, new index", wfPrepareIndex,
      0, WF_MODULE_QUERIES },
    { "islands", "let islands that rest fall asleep",
      "new contacts, new joints, new states", "new states, clocks of rest", wfFindIslands,
      WF_MODULE_SLEEP, 0 },
    { "commit", "what is new becomes the world",
      "all that is new", "all that is permanent", commit,
      0, 0 },
    { "keep joints", "the new joints become the world's",
      "new joints", "joints, broken joints", wfKeepJoints,
      WF_MODULE_JOINTS, 0 },
};
const int wfStageCount = (int)(sizeof wfStageTable / sizeof *wfStageTable);

/* step the world */
static wfResult run_stages(struct wfStep *step)
{
    wfResult result = WF_OK;
    for (int i = 0; i < wfStageCount && result == WF_OK; i++) {
        /* pass over a stage that nobody needs */
        if (!wfStageRuns(&wfStageTable[i], step->b.head->modules)) continue;
        const wfStepClock *clock = step->clock;
        double start = clock == NULL ? 0 : clock->now(clock->context);
        result = wfStageTable[i].run(step);
        /* take the time of a stage */
        if (clock != NULL) clock->seconds[i] += clock->now(clock->context) - start;
        /* begin anew if a stage says so */
        if (result == WF_OK && step->again) {
            int32_t restarts = step->restarts + 1;
            *step = (struct wfStep){ .b = step->b,
                /* what a step keeps that begins anew */
                .clock = step->clock,
                .hooks = step->hooks,
            };
            step->restarts = restarts;
            i = -1;
        }
    }
    return result;
}

wfResult wfStepWorld(wfWorld *world)
{
    struct wfStep step = { .count = 0 };
    wfResult result = wfChangeBlock(world, &step.b);
    return result == WF_OK ? run_stages(&step) : result;
}

wfResult wfStepWorldTimed(wfWorld *world, const wfStepClock *clock)
{
    struct wfStep step = { .clock = clock };
    wfResult result = wfChangeBlock(world, &step.b);
    if (result != WF_OK) return result;
    step.b.head->busy = clock != NULL;      /* it is the user's, as a hook is */
    result = run_stages(&step);
    step.b.head->busy = 0;
    return result;
}

/* step the world for hooks */
wfResult wfStepWorldWithCallbacks(wfWorld *world, const wfCallbacks *hooks)
{
    struct wfStep step = { .hooks = hooks };
    wfResult result = wfChangeBlock(world, &step.b);
    if (result == WF_OK && hooks != NULL)
        result = wfRequireModules(&step.b, WF_MODULE_HOOKS);
    if (result != WF_OK) return result;
    step.b.head->busy = hooks != NULL;
    result = run_stages(&step);
    step.b.head->busy = 0;
    if (result == WF_OK && hooks != NULL) wfUse(&step.b, WF_MODULE_HOOKS);
    return result;
}
