/* A jointed figure of eleven bones falls from 25 m: Box2D's sample "Ragdoll" and the figure of its samples.
 * Checked: it falls freely, as a whole; at rest no joint is open and none is turned beyond its limits; it falls asleep, all of it. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

static wfWorld world;
static void must(int ok, const char *what) { if (!ok) { printf("ragdoll: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

/* A capsule from low to high about y, on a bone from which it may turn from lower to upper; lengths in m, angles in turns of pi. */
typedef struct Bone { int parent; float y, low, high, radius, pivot, lower, upper, friction, bent; int foot; } Bone;
enum { HIP, TORSO, HEAD, LEG_A, SHIN_A, LEG_B, SHIN_B, ARM_A, FOREARM_A, ARM_B, FOREARM_B, BONES };
static const Bone bone[BONES] = {
    [HIP] = { -1, 0.95f, -0.02f, 0.02f, 0.095f, 0, 0, 0, 1, 0, 0 },
    [TORSO] = { HIP, 1.2f, -0.135f, 0.135f, 0.09f, 1.0f, -0.25f, 0, 0.5f, 0, 0 },
    [HEAD] = { TORSO, 1.475f, -0.038f, 0.039f, 0.075f, 1.4f, -0.3f, 0.1f, 0.25f, 0, 0 },
    [LEG_A] = { HIP, 0.775f, -0.125f, 0.125f, 0.06f, 0.9f, -0.05f, 0.4f, 1, 0, 0 },
    [SHIN_A] = { LEG_A, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0.5f, 0, 1 },
    [LEG_B] = { HIP, 0.775f, -0.125f, 0.125f, 0.06f, 0.9f, -0.05f, 0.4f, 1, 0, 0 },
    [SHIN_B] = { LEG_B, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0.5f, 0, 1 },
    [ARM_A] = { TORSO, 1.225f, -0.125f, 0.125f, 0.035f, 1.35f, -0.1f, 0.8f, 0.5f, 0, 0 },
    [FOREARM_A] = { ARM_A, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, 0 },
    [ARM_B] = { TORSO, 1.225f, -0.125f, 0.125f, 0.035f, 1.35f, -0.1f, 0.8f, 0.5f, 0, 0 },
    [FOREARM_B] = { ARM_B, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, 0 },
};

static void make_figure(wfVec2 at, wfBodyId *id, wfJointId *joint)
{
    wfVec2 sole[4] = { WF_V2(-0.03f, -0.185f), WF_V2(0.11f, -0.185f), WF_V2(0.11f, -0.16f), WF_V2(-0.03f, -0.14f) };
    for (int i = 0; i < BONES; i++) {
        const Bone *b = &bone[i];
        wfBodyDef def = wfDefaultBodyDef();
        wfShapeDef part = wfDefaultShapeDef();
        def.position = wfAdd(at, wfV2(0, b->y));
        part.friction = 0.2f;
        part.filter = (wfFilter){ .category = 2, .mask = 1 | 2, .group = -1 };      /* bones of a figure do not meet */
        must(wfMakeCapsule(wfV2(0, b->low), wfV2(0, b->high), b->radius, &part.shape) == WF_OK, "a capsule");
        must(wfAddBodyToWorld(&world, &def, &id[i]) == WF_OK && wfAddShapeToBody(&world, id[i], &part, NULL) == WF_OK, "a bone");
        part.friction = 0.05f;
        must(wfMakeRoundedPolygon(sole, 4, 0.015f, &part.shape) == WF_OK, "a sole");
        if (b->foot) must(wfAddShapeToBody(&world, id[i], &part, NULL) == WF_OK, "a foot");
        if (b->parent < 0) continue;
        wfJoint j;
        wfVec2 pivot = wfAdd(at, wfV2(0, b->pivot));
        must(wfDefineJoint(&world, "revolute", id[b->parent], id[i], pivot, pivot, wfV2(0, 0), &j) == WF_OK, "a joint");
        must(wfTuneJointSpring(&world, &j, 5, 0.5f) == WF_OK, "its spring");
        j.flags |= WF_JOINT_LIMITS | WF_JOINT_MOTOR;
        j.rest = b->bent * WF_PI;
        j.lower = (b->lower + b->bent) * WF_PI;
        j.upper = (b->upper + b->bent) * WF_PI;
        j.motorForce = 0.03f * b->friction;
        must(wfAddJointToWorld(&world, &j, &joint[i]) == WF_OK, "a joint");
    }
}

static float middle(const wfBodyId *id)      /* the height of the centre of mass */
{
    wfBodyInfo info;
    float mass = 0, sum = 0;
    for (int i = 0; i < BONES; i++) {
        must(wfGetBody(&world, id[i], &info) == WF_OK, "a bone");
        mass += info.mass;
        sum += info.mass * info.centre.y;
    }
    return sum / mass;
}

static void measure(void *widest, wfVec2 from, wfVec2 to) { *(float *)widest = fmaxf(*(float *)widest, wfDistance(from, to)); }

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef floor = wfDefaultBodyDef();
    wfBodyId id[BONES];
    wfJointId joint[BONES];
    def.sleep = 1;
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    floor.type = WF_STATIC;
    must(wfMakeSegment(wfV2(-20, 0), wfV2(20, 0), &floor.shape) == WF_OK && wfAddBodyToWorld(&world, &floor, NULL) == WF_OK, "the floor");
    make_figure(wfV2(0, 25), id, joint);
    float start = middle(id);
    for (int i = 0; i < 90; i++) must(wfStepWorld(&world) == WF_OK, "a step");
    float fell = start - middle(id), gap = 0;
    must(fabsf(fell - 9.81f * 1.5f * 1.5f / 2) < 9.81f * 1.5f / 240, "it falls otherwise than freely");      /* a substep late or early */
    while (wfBodyIsAwake(&world, id[0])) must(wfWorldTime(&world) < 10 && wfStepWorld(&world) == WF_OK, "it never sleeps");
    wfDrawCallbacks draw = { .context = &gap, .joint = measure };
    must(wfDrawWorld(&world, &draw) == WF_OK && gap < 0.002f, "a joint is open");
    for (int i = 1; i < BONES; i++) {
        wfJoint j;
        float turn;
        must(wfGetJoint(&world, joint[i], &j) == WF_OK && wfGetJointMotion(&world, joint[i], &turn, NULL) == WF_OK, "a joint");
        must(turn > j.lower - 0.02f && turn < j.upper + 0.02f, "a joint is turned too far");
        must(!wfBodyIsAwake(&world, id[i]), "a bone is awake");
    }
    printf("ragdoll: fell %.3f m in 1.5 s; asleep after %.2f s; the widest joint is open by %.2g m\n", fell, wfWorldTime(&world), gap);
    return wfDestroyWorld(&world);
}
