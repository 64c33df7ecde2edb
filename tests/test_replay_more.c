/* What can be set of a body, a shape or a joint between two steps is an input: given to one world and played again in another, it makes
 * the same bytes. */
#include "testing.h"
#include "world.h"
#include "weft/save.h"

typedef struct Yard { wfWorld world; wfBodyId ball, lift; wfShapeId shape; wfJointId rope; } Yard;

static Yard yard(void)
{
    Yard y;
    wfWorldDef def = wfDefaultWorldDef();
    wfJoint j;
    assert_ok(wfCreateWorld(&def, &y.world));
    add(&y.world, floor_def());
    y.ball = add(&y.world, ball_def(0, 5, 0.5));
    wfBodyDef lift = ball_def(4, 5, 0.5);
    lift.type = WF_KINEMATIC;
    y.lift = add(&y.world, lift);
    y.shape = wfFirstShape(&y.world, y.ball);
    assert_ok(wfDefineJoint(&y.world, "distance", y.ball, y.lift, wfV2(0, 5), wfV2(4, 5), wfV2(1, 0), &j));
    assert_ok(wfAddJointToWorld(&y.world, &j, &y.rope));
    return y;
}

static void give(Yard *y, wfJournal *j, wfInput in, wfBodyId id)
{
    in.index = id.index, in.generation = id.generation;
    assert_ok(wfGiveInput(&y->world, j, &in, NULL));
}

static wfInput with(int kind, wfVec2 at, wfReal x, wfReal y, int32_t number)
{
    wfInput in = { .kind = kind };
    in.with.at = at, in.with.x = x, in.with.y = y, in.with.number = number;
    return in;
}

static wfInput data(int kind, uint64_t userData)
{
    wfInput in = { .kind = kind };
    in.userData = userData;
    return in;
}

TEST(what_is_set_is_played_again)
{
    static uint8_t bytes[1 << 14];
    Yard played = yard(), shown = yard();
    wfBodyId shape = { played.shape.index, played.shape.generation }, rope = { played.rope.index, played.rope.generation };
    wfJournal j;
    assert_ok(wfJournalInit(&j, bytes, sizeof bytes, 1));
    give(&played, &j, data(WF_INPUT_BODY_DATA, UINT64_MAX), played.ball);
    give(&played, &j, data(WF_INPUT_SHAPE_DATA, 1ull << 40), shape);
    give(&played, &j, data(WF_INPUT_JOINT_DATA, 77), rope);
    give(&played, &j, with(WF_INPUT_MASS_DATA, wfV2(WF_R(0.25), 0), 3, 2, 0), played.ball);
    wfBodyInfo b = info(&played.world, played.ball);
    assert_true(b.mass == 3 && b.inertia == 2 && b.centre.x - b.position.x == WF_R(0.25));
    for (int i = 0; i < 120; i++) {
        give(&played, &j, with(WF_INPUT_TARGET, wfV2(4, 5 + (wfReal)i / 64), 1, WF_R(1.0) / 60, 0), played.lift);
        if (i == 20) give(&played, &j, with(WF_INPUT_GRAVITY_SCALE, wfV2(0, 0), -2, 0, 0), played.ball);
        if (i == 40) give(&played, &j, with(WF_INPUT_FIXED_ROTATION, wfV2(0, 0), 0, 0, 1), played.ball);
        assert_ok(wfStepNoted(&played.world, &j, NULL));
    }
    b = info(&played.world, played.ball);
    assert_true(b.gravityScale == -2 && b.inertia == 0 && b.userData == UINT64_MAX);
    wfReplay r = { .journal = &j };
    int32_t stepped = 1;
    while (stepped) assert_ok(wfReplayStep(&r, &shown.world, NULL, &stepped));
    assert_ok(wfCompareWorlds(&played.world, &shown.world, NULL));
    wfShapeDef s;
    wfJoint rod;
    assert_ok(wfGetShape(&shown.world, shown.shape, &s));
    assert_ok(wfGetJoint(&shown.world, shown.rope, &rod));
    assert_true(s.userData == 1ull << 40 && rod.userData == 77 && info(&shown.world, shown.ball).userData == UINT64_MAX);
    wfDestroyWorld(&played.world);
    wfDestroyWorld(&shown.world);
}

TEST(data_of_a_joint_that_is_gone_is_refused)
{
    Yard y = yard();
    assert_ok(wfSetJointUserData(&y.world, y.rope, 5));
    assert_ok(wfRemoveJointFromWorld(&y.world, y.rope));
    assert_result(WF_ERROR_STALE_ID, wfSetJointUserData(&y.world, y.rope, 5));
    wfDestroyWorld(&y.world);
}
