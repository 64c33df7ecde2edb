/* Weft: testbed/challenges.c, tangled from chapters/testbed/18-challenges.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* The table of challenges, and their judges. */
#include <math.h>
#include <string.h>
#include "testbed/challenges.h"
#include "weft/inspect.h"
#include "weft/joint.h"
#include "weft/save.h"

/* what judges ask */
static const wfBodyState *body(const wfWorld *world, int32_t i)
{
    return &wfWorldBodies(world).state[i];
}

static double speed(const wfWorld *world, int32_t i)
{
    return (double)wfLength(body(world, i)->v);
}

static bool touches(const wfWorld *world, int32_t i)
{
    int32_t count;
    const wfContact *c = wfWorldContacts(world, &count);
    for (int32_t k = 0; k < count; k++)
        if (c[k].a == i || c[k].b == i) return true;
    return false;
}

/* Has something that can be said of each step been true for so many, up to this one? */
static bool lasts(bool now, double *steps, double least)
{
    *steps = now ? *steps + 1 : 0;
    return *steps >= least;
}

/* All bodies that were added must be free ones, and no more than may be. */
static const char *why_not_free(const wfWorld *world, int32_t given, int32_t most)
{
    wfBodyView v = wfWorldBodies(world);
    int32_t added = 0;
    for (int32_t i = given; i < v.count; i++) {
        if (!v.alive[i]) continue;
        added++;
        if (v.props[i].type != WF_DYNAMIC) return "a body that cannot fall";
    }
    return added <= most ? NULL : "too many";
}

/* judges */
static void judge_floor(const wfWorld *world, wfTrial *t)
{
    double apart = (double)(body(world, 3)->p.x - body(world, 2)->p.x);
    bool still = speed(world, 2) < 0.01 && speed(world, 3) < 0.01;
    bool gone = body(world, 3)->p.y < -1;
    t->shown = apart;
    if (lasts(still, &t->kept[0], 20) || gone)
        t->verdict = fabs(apart) <= 0.05 && !gone ? WF_DONE : WF_LOST;
}

/* kept: the last speed upwards, bounces so far, the height of the ball's lower edge */
static void judge_bounce(const wfWorld *world, wfTrial *t)
{
    const wfBodyState *b = body(world, 1);
    double v = (double)b->v.y, height = (double)b->p.y - 0.25;
    if (v > 0 && t->kept[0] <= 0) t->kept[1]++, t->kept[2] = 0;
    if (height > t->kept[2] && t->kept[1] > 0) t->kept[2] = height;
    t->shown = t->kept[2];
    bool over = (v <= 0 && t->kept[0] > 0 && t->kept[1] >= 2) || wfWorldTime(world) > 8;
    t->kept[0] = v;
    bool right = t->kept[1] >= 2 && fabs(t->shown - 1) <= 0.05;
    if (over) t->verdict = right ? WF_DONE : WF_LOST;
}

static void judge_damper(const wfWorld *world, wfTrial *t)
{
    t->shown = (double)body(world, 0)->p.x;
    if (t->shown < -0.05) t->verdict = WF_LOST;
    else if (wfWorldTime(world) >= 3) t->verdict = t->shown <= 0.05 ? WF_DONE : WF_LOST;
}

/* kept: the angle before this step, passages, the time of the first and the last one */
static void judge_clock(const wfWorld *world, wfTrial *t)
{
    double now = (double)body(world, 1)->angle, was = t->kept[0], at = wfWorldTime(world);
    double step = at / (double)wfWorldSteps(world);
    t->kept[0] = now;
    if (was < 0 && now >= 0) {
        at -= step * now / (now - was);
        if (t->kept[1] == 0) t->kept[2] = at;
        t->kept[1]++;
        t->kept[3] = at;
    }
    if (t->kept[1] > 1) t->shown = (t->kept[1] - 1) / (t->kept[3] - t->kept[2]);
    if (t->kept[1] >= 5) t->verdict = fabs(t->shown - 1) <= 0.01 ? WF_DONE : WF_LOST;
    else if (at > 30) t->verdict = WF_LOST;
}

/* kept: still steps, the speed in the step before, whether it has touched anything */
static void judge_landing(const wfWorld *world, wfTrial *t)
{
    const wfBodyState *b = body(world, 2);
    double v = speed(world, 2);
    bool touch = touches(world, 2), pad = b->p.x > 3 && b->p.x < 7 && b->p.y > WF_R(1.7);
    if (touch && t->kept[1] > 3) t->verdict = WF_LOST, v = t->kept[1];
    t->shown = v;
    t->kept[1] = v;
    bool rests = lasts(touch && v < 0.02, &t->kept[0], 30);
    if (t->verdict == WF_NOT_YET && rests) t->verdict = pad ? WF_DONE : WF_LOST;
    if (b->p.y < -2) t->verdict = WF_LOST;
}

static void judge_throw(const wfWorld *world, wfTrial *t)
{
    const wfBodyState *b = body(world, 4);
    bool in = b->p.x > 4 && b->p.x < 6 && b->p.y < 1;
    t->shown = (double)b->p.x - 5;
    if (wfWorldTime(world) < 1) return;
    if (lasts(in, &t->kept[0], 60)) t->verdict = WF_DONE;
    else if (lasts(!in && speed(world, 4) < 0.05, &t->kept[1], 60) || b->p.y < -2)
        t->verdict = WF_LOST;
    else if (wfWorldTime(world) > 20) t->verdict = WF_LOST;
}

/* kept: the angle before, the turn so far, the least and the greatest distance */
static void judge_orbit(const wfWorld *world, wfTrial *t)
{
    const wfBodyState *b = body(world, 0);
    double r = (double)wfLength(b->p), angle = atan2((double)b->p.y, (double)b->p.x);
    double by = angle - t->kept[0];
    if (by > 3) by -= 2 * (double)WF_PI;
    if (by < -3) by += 2 * (double)WF_PI;
    t->kept[0] = angle;
    t->kept[1] += by;
    if (t->kept[2] == 0 || r < t->kept[2]) t->kept[2] = r;
    if (r > t->kept[3]) t->kept[3] = r;
    t->shown = t->kept[3] / t->kept[2];
    if (r < 0.5 || r > 20) t->verdict = WF_LOST;
    else if (fabs(t->kept[1]) >= 2 * (double)WF_PI)
        t->verdict = t->shown <= 1.25 ? WF_DONE : WF_LOST;
}

static void judge_tower(const wfWorld *world, wfTrial *t)
{
    bool still = !t->held;
    t->shown = 0;
    for (int32_t i = 1; i <= 5; i++) {
        double top = (double)body(world, i)->p.y + 0.5;
        if (top > t->shown) t->shown = top;
        still = still && speed(world, i) < 0.05;
    }
    if (lasts(still && t->shown > 4.9, &t->kept[0], 60)) t->verdict = WF_DONE;
}

static const char *beam_unfit(const wfWorld *world) { return why_not_free(world, 3, 1); }

static void judge_beam(const wfWorld *world, wfTrial *t)
{
    t->shown = (double)body(world, 1)->angle * 180 / (double)WF_PI;
    t->unfit = beam_unfit(world) != NULL;
    if (t->unfit || fabs(t->shown) > 60) t->verdict = WF_LOST;
    else if (wfWorldTime(world) >= 5)
        t->verdict = fabs(t->shown) <= 2 ? WF_DONE : WF_LOST;
}

static const char *bridge_unfit(const wfWorld *world)
{
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 3; i < v.count; i++) {
        if (!v.alive[i]) continue;
        if (v.props[i].shape < 0) return "a nail";
        const wfShape *s = &v.shapes[v.props[i].shape];
        bool one = v.next[v.props[i].shape] < 0 && s->count == 4;
        wfReal weight = v.state[i].invMass > 0 ? 1 / v.state[i].invMass : 0;
        if (!one || v.props[i].type != WF_DYNAMIC) return "a body that is no bar";
        if (wfShapeMaxExtent(s) > WF_R(1.45)) return "a bar longer than 2.7 m";
        if (weight > 120) return "a bar heavier than 120 kg";
    }
    for (int32_t i = 0; i < wfWorldJointPlaces(world); i++) {
        wfJoint j;
        if (wfGetJoint(world, wfJointAt(world, i), &j) == WF_OK &&
            (j.kind != wfFindJoint("revolute") || j.flags & ~WF_JOINT_BROKEN || j.a == 2 ||
             j.b == 2)) return "a joint that is no pin between bars";
    }
    return why_not_free(world, 3, 20);
}

static void judge_bridge(const wfWorld *world, wfTrial *t)
{
    t->shown = (double)body(world, 2)->p.y - 0.6;
    if (t->kept[0]++ == 0) t->unfit = bridge_unfit(world) != NULL;
    if (t->unfit || t->shown < -0.5) t->verdict = WF_LOST;
    else if (wfWorldTime(world) >= 7) t->verdict = WF_DONE;
}

#define PLACED (WF_MAY(WF_INPUT_ADD_BODY) | WF_MAY(WF_INPUT_ADD_SHAPE) | \
                WF_MAY(WF_INPUT_ADD_JOINT) | WF_MAY(WF_INPUT_REMOVE_BODY) | \
                WF_MAY(WF_INPUT_REMOVE_JOINT))      /* of Place, Bar, Pin, Delete */

const wfChallenge wfChallengeTable[] = {
    { "floor", "unknown floor", "The friction of the lower floor is yours, before time runs.",
      NULL, "%+.2f m apart", WF_MAY(WF_INPUT_MATERIAL), 0, 4, 1, 0, false, judge_floor, NULL },
    { "bounce", "up to the line", "The restitution of the ball is yours, before time runs.",
      NULL, "%.2f m high", WF_MAY(WF_INPUT_MATERIAL), 0, 2, 1, 0, false, judge_bounce, NULL },
    { "damper", "no swing", "The linear damping is yours, before time runs.",
      NULL, "%+.2f m from the line", WF_MAY(WF_INPUT_DAMPING), 0, 1, 0, 0, false,
      judge_damper, NULL },
    { "clock", "one tick a second", "The mass of the upper bob is yours, before time runs.",
      NULL, "%.3f Hz", WF_MAY(WF_INPUT_MASS), 0, 4, 3, 0, false, judge_clock, NULL },
    { "landing", "land the box", "You have three kicks, at any time.", "Kick",
      "%.1f m/s", WF_MAY(WF_INPUT_IMPULSE), WF_MAY(WF_INPUT_IMPULSE), 3, 2, 3, false,
      judge_landing, NULL },
    { "wall", "over the wall", "You have one kick, at any time.", "Kick",
      "%+.1f m from the basket",
      WF_MAY(WF_INPUT_IMPULSE), WF_MAY(WF_INPUT_IMPULSE), 5, 4, 1, false, judge_throw, NULL },
    { "orbit", "a round orbit", "You have one kick, before time runs.", "Kick",
      "farthest to nearest: %.2f", WF_MAY(WF_INPUT_IMPULSE), 0, 1, 0, 1, false, judge_orbit,
      NULL },
    { "tower", "stack all five", "You have your hand, while time runs.", "Hand",
      "%.2f m high", 0, 0, 6, -1, 0, true, judge_tower, NULL },
    { "beam", "a level beam", "You may place one body, before time runs.", "Place",
      "%+.1f degrees", WF_MAY(WF_INPUT_ADD_BODY) | WF_MAY(WF_INPUT_REMOVE_BODY), 0, 3, -1, 1,
      false, judge_beam, beam_unfit },
    { "bridge", "ten tonnes", "You have 20 bars of at most 2.7 m, before time runs.", "Bar",
      "the load is %+.2f m up", PLACED, 0, 3, -1, 20, false, judge_bridge,
      bridge_unfit },
};
const int wfChallengeCount = (int)(sizeof wfChallengeTable / sizeof *wfChallengeTable);

int wfFindChallenge(const char *name)
{
    for (int i = 0; i < wfChallengeCount; i++)
        if (strcmp(wfChallengeTable[i].name, name) == 0 ||
            strcmp(wfChallengeTable[i].scene, name) == 0) return i;
    return -1;
}

void wfJudge(const wfChallenge *challenge, const wfWorld *world, wfTrial *trial)
{
    if (trial->verdict == WF_NOT_YET) challenge->judge(world, trial);
}
