/* Weft: engine/joints.c, tangled from chapters/methods/05-joints-in-a-world.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/joints.h"
#include "engine/step.h"

/* open a joint */
static wfResult open_joint(const wfWorld *world, wfJointId id, wfBlock *b, wfJoints *j,
                           int32_t *index)
{
    wfResult result = wfOpenBlock(world, b);
    if (result != WF_OK) return result;
    *j = wfJointsOf(b);
    *index = wfFindSlot(&b->head->jointSlots, j->slots, id.index, id.generation);
    return *index < 0 ? WF_ERROR_STALE_ID : WF_OK;
}

static wfResult change_joint(const wfWorld *world, wfJointId id, wfBlock *b, wfJoints *j,
                             int32_t *index)
{
    wfResult result = open_joint(world, id, b, j, index);
    return result == WF_OK && b->head->busy ? WF_ERROR_BUSY : result;
}

static wfResult check_world_joint(const wfBlock *b, const wfJoint *j)
{
    wfResult result = wfCheckJoint(j);
    if (result != WF_OK) return result;
    int32_t high = b->head->bodySlots.high;
    if (j->a >= high || j->b >= high) return WF_ERROR_STALE_ID;
    if (!b->alive[j->a] || !b->alive[j->b]) return WF_ERROR_STALE_ID;
    bool steps = wfSolverTable[b->head->solver].step != NULL;
    return steps ? WF_OK : WF_ERROR_SOLVER;
}

/* join two bodies */
wfResult wfJoinBodies(const wfWorld *world, const char *kind, wfBodyId a, wfBodyId b,
                      wfVec2 anchorA, wfVec2 anchorB, wfVec2 axis, wfJoint *out)
{
    wfBlock block;
    if (kind == NULL || out == NULL) return WF_ERROR_NULL;
    wfResult result = wfOpenBlock(world, &block);
    if (result != WF_OK) return result;
    int32_t i = wfBodyIndex(world, a), k = wfBodyIndex(world, b);
    if (i < 0 || k < 0) return WF_ERROR_STALE_ID;
    if (wfFindJoint(kind) < 0) return WF_ERROR_UNKNOWN;
    if (!wfIsFinite2(anchorA) || !wfIsFinite2(anchorB) || !wfIsFinite2(axis))
        return WF_ERROR_NOT_FINITE;
    if (i == k || !(wfLength(axis) > 0)) return WF_ERROR_RANGE;
    wfJoint made = wfMakeJoint(kind, i, &block.state[i], k, &block.state[k], anchorA,
                               anchorB, axis);
    result = wfCheckJoint(&made);
    if (result == WF_OK) *out = made;
    return result;
}

/* add, change and remove joints */
wfResult wfAddJointToWorld(wfWorld *world, const wfJoint *joint, wfJointId *out)
{
    wfBlock b;
    if (joint == NULL) return WF_ERROR_NULL;
    wfResult result = wfChangeBlock(world, &b);
    if (result == WF_OK) result = wfDemand(&b, WF_NEED_JOINTS);
    if (result == WF_OK) result = check_world_joint(&b, joint);
    if (result != WF_OK) return result;
    wfJoints j = wfJointsOf(&b);
    int32_t i = wfSlotTake(&b.head->jointSlots, j.slots);
    if (i < 0) return WF_ERROR_FULL;
    j.joints[i] = *joint;
    wfUse(&b, WF_NEED_JOINTS);
    wfDisturbEnds(&b, joint->a, joint->b);
    if (out != NULL) *out = (wfJointId){ (uint32_t)i + 1, j.slots[i].generation };
    return WF_OK;
}

wfResult wfRemoveJointFromWorld(wfWorld *world, wfJointId id)
{
    wfBlock b;
    wfJoints j;
    int32_t i;
    wfResult result = change_joint(world, id, &b, &j, &i);
    if (result != WF_OK) return result;
    wfDisturbEnds(&b, j.joints[i].a, j.joints[i].b);
    memset(&j.joints[i], 0, sizeof j.joints[i]);
    return wfSlotGive(&b.head->jointSlots, j.slots, i, id.generation);
}

wfResult wfGetJoint(const wfWorld *world, wfJointId id, wfJoint *out)
{
    wfBlock b;
    wfJoints j;
    int32_t i;
    wfResult result = out == NULL ? WF_ERROR_NULL : open_joint(world, id, &b, &j, &i);
    if (result == WF_OK) *out = j.joints[i];
    return result;
}

wfResult wfSetJoint(wfWorld *world, wfJointId id, const wfJoint *joint)
{
    wfBlock b;
    wfJoints j;
    int32_t i;
    if (joint == NULL) return WF_ERROR_NULL;
    wfResult result = change_joint(world, id, &b, &j, &i);
    if (result == WF_OK) result = check_world_joint(&b, joint);
    if (result != WF_OK) return result;
    wfDisturbEnds(&b, j.joints[i].a, j.joints[i].b);
    j.joints[i] = *joint;
    wfDisturbEnds(&b, joint->a, joint->b);
    return WF_OK;
}

wfResult wfGetJointLoad(const wfWorld *world, wfJointId id, wfVec2 *force, wfReal *torque)
{
    wfBlock b;
    wfJoints j;
    int32_t i;
    wfResult result = open_joint(world, id, &b, &j, &i);
    if (result != WF_OK) return result;
    if (force != NULL) *force = j.joints[i].load;
    if (torque != NULL) *torque = j.joints[i].twist;
    return WF_OK;
}

wfResult wfGetJointPeak(const wfWorld *world, wfJointId id, wfReal *force, wfReal *torque)
{
    wfBlock b;
    wfJoints j;
    int32_t i;
    wfResult result = open_joint(world, id, &b, &j, &i);
    if (result != WF_OK) return result;
    if (force != NULL) *force = j.joints[i].peakForce;
    if (torque != NULL) *torque = j.joints[i].peakTorque;
    return WF_OK;
}

/* look at the joints of a world */
int32_t wfWorldJointPlaces(const wfWorld *world)
{
    wfBlock b;
    return wfOpenBlock(world, &b) == WF_OK ? b.head->jointSlots.high : 0;
}

wfJointId wfJointAt(const wfWorld *world, int32_t i)
{
    wfBlock b;
    wfJointId none = { 0, 0 };
    if (wfOpenBlock(world, &b) != WF_OK) return none;
    wfJoints j = wfJointsOf(&b);
    if (i < 0 || i >= b.head->jointSlots.high || !wfJointIsLive(&j, i)) return none;
    return (wfJointId){ (uint32_t)i + 1, j.slots[i].generation };
}

int32_t wfJointCount(const wfWorld *world)
{
    int32_t count = 0;
    for (int32_t i = 0; i < wfWorldJointPlaces(world); i++)
        if (wfJointAt(world, i).index != 0) count++;
    return count;
}

bool wfJointsSolvedTogether(const wfWorld *world)
{
    wfBlock b;
    if (wfOpenBlock(world, &b) != WF_OK || b.head->together == 0) return false;
    return b.head->together == wfJointCount(world);
}

int32_t wfJointsTogether(const wfWorld *world)
{
    wfBlock b;
    return wfOpenBlock(world, &b) == WF_OK ? b.head->together : 0;
}

int32_t wfUnsolvedSubsteps(const wfWorld *world)
{
    wfBlock b;
    return wfOpenBlock(world, &b) == WF_OK ? b.head->unsolved : 0;
}


const wfJointId *wfBrokenJoints(const wfWorld *world, int32_t *count)
{
    wfBlock b;
    if (count != NULL) *count = 0;
    if (wfOpenBlock(world, &b) != WF_OK) return NULL;
    if (count != NULL) *count = b.head->brokenCount;
    return wfJointsOf(&b).broken;
}

/* drop the joints of a body */
void wfDropJoints(wfBlock *b, int32_t body)
{
    wfJoints j = wfJointsOf(b);
    for (int32_t i = 0; i < b->head->jointSlots.high; i++) {
        if (!wfJointIsLive(&j, i)) continue;
        if (j.joints[i].a != body && j.joints[i].b != body) continue;
        wfDisturbEnds(b, j.joints[i].a, j.joints[i].b);
        wfSlotGive(&b->head->jointSlots, j.slots, i, j.slots[i].generation);
        memset(&j.joints[i], 0, sizeof j.joints[i]);
    }
}

bool wfJointsCanMove(const wfBlock *b, wfVec2 by)
{
    wfJoints j = wfJointsOf(b);
    for (int32_t i = 0; i < b->head->jointSlots.high; i++) {
        wfJoint moved = j.joints[i];
        if (!wfJointIsLive(&j, i)) continue;
        wfMoveJoint(&moved, by);
        if (wfCheckJoint(&moved) != WF_OK) return false;
    }
    return true;
}

void wfMoveJoints(wfBlock *b, wfVec2 by)
{
    wfJoints j = wfJointsOf(b);
    for (int32_t i = 0; i < b->head->jointSlots.high; i++)
        if (wfJointIsLive(&j, i)) wfMoveJoint(&j.joints[i], by);
}

/* leave out pairs that are joined */
static bool comes_before(wfPair a, wfPair b)
{
    return a.a != b.a ? a.a < b.a : a.b < b.b;
}

/* sorted; -1: no memory */
static int32_t list_joined(struct wfStep *s, wfPair *out)
{
    int32_t count = 0;
    wfJoints j = wfJointsOf(&s->b);
    for (int32_t i = 0; i < s->b.head->jointSlots.high; i++) {
        if (!wfJointIsLive(&j, i)) continue;
        if (j.joints[i].flags & (WF_JOINT_COLLIDE | WF_JOINT_BROKEN)) continue;
        int32_t a = j.joints[i].a, b = j.joints[i].b;
        out[count++] = (wfPair){ a < b ? a : b, a < b ? b : a };
    }
    wfPairList list = { .pairs = out, .count = count, .capacity = count };
    return wfSortPairs(&list, s->count, &s->scratch) == WF_OK ? count : -1;
}

static bool is_joined(const wfPair *list, int32_t count, wfPair pair)
{
    int32_t low = 0, high = count;
    while (low < high) {
        int32_t middle = low + (high - low) / 2;
        if (comes_before(list[middle], pair)) low = middle + 1;
        else high = middle;
    }
    return low < count && !comes_before(pair, list[low]);
}

wfResult wfLeaveOutJoined(struct wfStep *s)
{
    wfPair *list = wfTransient(&s->b, WF_REGION_JOINED);
    int32_t count = list_joined(s, list), kept = 0;
    if (count < 0) return WF_ERROR_MEMORY;
    for (int32_t i = 0; count > 0 && i < s->pairs.count; i++) {
        wfPair p = s->pairs.pairs[i];
        int32_t a = s->b.owners[p.a], b = s->b.owners[p.b];
        wfPair owners = { a < b ? a : b, a < b ? b : a };
        if (!is_joined(list, count, owners)) s->pairs.pairs[kept++] = p;
    }
    if (count > 0) s->pairs.count = kept;
    s->joinedCount = count;
    return WF_OK;
}

bool wfIsJoined(const struct wfStep *s, int32_t a, int32_t b)
{
    wfPair owners = { a < b ? a : b, a < b ? b : a };
    return is_joined(wfTransient(&s->b, WF_REGION_JOINED), s->joinedCount, owners);
}

/* A number for who is joined to whom and who can move; never 0. */
static uint64_t fingerprint(const struct wfStep *s)
{
    uint64_t sum = 1;
    for (int32_t i = 0; i < s->jointSet.count; i++) {
        const wfJoint *j = &s->jointSet.joints[i];
        const wfBodyState *a = &s->state[j->a], *b = &s->state[j->b];
        uint64_t who = (uint64_t)j->a << 32 | (uint64_t)j->b;
        uint64_t how = (j->flags & WF_JOINT_BROKEN ? 1u : 0u)
                     | (a->invMass > 0 || a->invInertia > 0 ? 2u : 0u)
                     | (b->invMass > 0 || b->invInertia > 0 ? 4u : 0u);
        sum = (sum ^ who) * 0x9E3779B97F4A7C15u;
        sum = ((sum ^ sum >> 29) + how) * 0xBF58476D1CE4E5B9u;
        sum ^= sum >> 32;
    }
    return sum | 1;
}

static wfResult solve_machines(struct wfStep *s)
{
    const wfHeader *h = s->b.head;
    wfSolve states = { .state = s->state, .bodyCount = s->count };
    uint8_t *alone = wfTransient(&s->b, WF_REGION_NEW_ALONE);
    const uint8_t *before = s->b.alone;
    wfPool pool;
    wfResult result = wfPoolInit(&pool, wfExactScratch(h->bodyCapacity, h->jointCapacity),
                                 wfTransient(&s->b, WF_REGION_EXACT));
    if (result != WF_OK) return result;
    s->machines = fingerprint(s);
    bool known = s->machines == h->machines;
    if (known) memcpy(alone, before, (size_t)s->jointSet.count);
    return wfExactMachines(&s->jointSet, &states,
                           h->exactJoints == WF_JOINTS_AUTO ? h->exactCost : -1, alone,
                           known, &pool);
}

wfResult wfTakeJoints(struct wfStep *s)
{
    wfJoint *copy = wfTransient(&s->b, WF_REGION_NEW_JOINTS);
    wfJoints j = wfJointsOf(&s->b);
    int32_t count = 0;
    s->jointPlaces = wfTransient(&s->b, WF_REGION_JOINT_PLACES);
    for (int32_t i = 0; i < s->b.head->jointSlots.high; i++) {
        if (!wfJointIsLive(&j, i)) continue;
        if (!s->present[j.joints[i].a] || !s->present[j.joints[i].b]) continue;
        s->jointPlaces[count] = i;
        copy[count++] = j.joints[i];
    }
    s->jointSet = (wfJointSet){ .joints = copy, .count = count,
                                .period = WF_JOINT_PERIOD, .damping = WF_JOINT_DAMPING };
    if (count == 0) return WF_OK;
    if (!wfSolverSteps(s)) return WF_ERROR_SOLVER;
    wfPool pool;
    size_t bytes = wfJointScratch(s->b.head->bodyCapacity, s->b.head->jointCapacity);
    wfResult result = wfPoolInit(&pool, bytes, wfTransient(&s->b, WF_REGION_JOINT_WORK));
    if (result == WF_OK) result = wfBeginJoints(&s->jointSet, s->count, &pool,
                                                  &s->jointLaws);
    if (result == WF_OK) s->laws = &s->jointLaws;
    /* see the direct solver */
    s->jointSet.give = s->b.head->jointGive;
    if (result == WF_OK && s->b.head->exactJoints) result = solve_machines(s);
    return result;
}

wfResult wfJudgeJoints(struct wfStep *s)
{
    wfSolve done = { .state = s->state, .h = s->b.head->dt,
                     .substeps = s->b.head->substeps };
    if (s->laws == NULL) return WF_OK;
    wfEndJoints(&s->jointSet, &done);
    for (int32_t i = 0; i < s->jointSet.count; i++) {
        const wfJoint *j = &s->jointSet.joints[i];
        const wfReal told[] = { j->load.x, j->load.y, j->twist, j->peakForce,
                                j->peakTorque };
        if (!wfAllFinite(j->impulse, WF_JOINT_ROWS) || !wfAllFinite(j->given, 3)
            || !wfAllFinite(told, 5)) return WF_ERROR_NOT_FINITE;
    }
    return WF_OK;
}

wfResult wfKeepJoints(struct wfStep *s)
{
    wfHeader *head = s->b.head;
    wfJoints j = wfJointsOf(&s->b);
    head->brokenCount = 0;
    /* where some may be */
    head->together = 0;
    head->unsolved = s->jointSet.unsolved;
    for (int32_t i = 0; s->jointSet.together != NULL && i < s->jointSet.count; i++)
        head->together += !s->jointSet.alone[i];
    if (head->exactJoints && s->jointSet.count > 0 && head->machines != s->machines) {
        memcpy(s->b.alone, s->jointSet.alone, (size_t)s->jointSet.count);
        head->machines = s->machines;
    }
    for (int32_t at = 0; at < s->jointSet.count; at++) {
        int32_t i = s->jointPlaces[at];
        const wfJoint *now = &s->jointSet.joints[at];
        if ((now->flags & WF_JOINT_BROKEN) && !(j.joints[i].flags & WF_JOINT_BROKEN))
            j.broken[head->brokenCount++] =
                (wfJointId){ (uint32_t)i + 1, j.slots[i].generation };
        j.joints[i] = *now;
    }
    return WF_OK;
}
