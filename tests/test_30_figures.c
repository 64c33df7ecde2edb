/* The classic scenes of chapter 30. Oracles: the schoolbook's distances, angles and periods; the theory of the arch against its
 * continuous limit; what must stand stands, and what must fall falls. Each bound says where it comes from. */
#include "testing.h"
#include "testbed/classics.h"
#include "weft/weft.h"

static double with_defaults(const char *name)
{
    wfWorldDef how = wfDefaultWorldDef();
    return wfRunClassic(name, &how);
}

static wfWorld room_for(int bodies)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    def.bodyCapacity = bodies;
    assert_ok(wfCreateWorld(&def, &world));
    return world;
}

/* How far any body has gone after so many steps, m; ends the world. */
static double strayed(wfWorld world, int steps)
{
    static wfVec2 start[512];
    wfBodyView v = wfWorldBodies(&world);
    double most = 0;
    assert_true(v.count <= 512);
    for (int i = 0; i < v.count; i++) start[i] = v.state[i].p;
    for (int i = 0; i < steps; i++) assert_ok(wfStepWorld(&world));
    v = wfWorldBodies(&world);
    for (int i = 0; i < v.count; i++) most = fmax(most, (double)wfDistance(start[i], v.state[i].p));
    wfDestroyWorld(&world);
    return most;
}

/* What the issue asks for, in percent, degrees, mm/s. */
static void sliding_slipping_creeping_rolling(void **unused)
{
    (void)unused;
    assert_near(with_defaults("slide"), 0, 0.05);
    assert_near(with_defaults("slip"), 0, 0.01);
    assert_near(with_defaults("creep"), 0, 1e-4);         /* 10^-4 mm/s: rounding of places of a metre, a thousandth a second */
    assert_near(with_defaults("roll"), 0, 0.1);
}

static void a_pendulum_keeps_its_energy_and_its_time(void **unused)
{
    (void)unused;
    assert_near(with_defaults("energy"), 0, 0.5);
    assert_near(with_defaults("period"), 0, 0.1);
}

static void a_cradle_hands_the_speed_on(void **unused)
{
    (void)unused;
    assert_near(with_defaults("cradle"), 0, 100 * 20 * (double)WF_EPSILON);       /* %: a few roundings in each of four collisions */
}

static void no_bullet_passes(void **unused)
{
    (void)unused;
    assert_true(with_defaults("bullet-static") == 0);
    assert_true(with_defaults("bullet-dynamic") == 0);
}

/* Milankovitch's limit for many stones; and stones that are few can only do better. */
static void the_theory_of_the_arch(void **unused)
{
    (void)unused;
    for (int stones = 20; stones <= 1280; stones *= 4) {
        double low = 0.05, high = 0.2;
        for (int i = 0; i < 30; i++) {
            double middle = (low + high) / 2;
            if (wfArchCanStand(stones, middle)) high = middle;
            else low = middle;
        }
        assert_true(high < 0.1076);
        assert_near(high, 0.10745, stones == 20 ? 2e-4 : 5e-5);
    }
    assert_true(wfArchCanStand(20, 0.5) && !wfArchCanStand(20, 0.01));
}

static void an_arch_stands_and_a_thinner_one_falls(void **unused)
{
    (void)unused;
    wfWorld world = room_for(32);
    assert_ok(wfBuildArch(&world, 20, 0.12));
    assert_near(strayed(world, 600), 0, 0.25);
    world = room_for(32);
    assert_ok(wfBuildArch(&world, 20, 0.1));              /* under the limit: lies on the ground */
    assert_true(strayed(world, 1200) > 2);
}

static void an_overhang_stands_and_a_wider_one_falls(void **unused)
{
    (void)unused;
    wfWorld world = room_for(32);
    assert_ok(wfBuildOverhang(&world, 10, WF_R(0.9)));
    assert_near(strayed(world, 600), 0, 0.1);
    world = room_for(32);
    assert_ok(wfBuildOverhang(&world, 10, WF_R(1.01)));
    assert_true(strayed(world, 600) > 1);
}

static void a_card_house_of_five_storeys_stands(void **unused)
{
    (void)unused;
    for (uint32_t seed = 1; seed <= 3; seed++) {
        wfWorld world = room_for(64);
        assert_ok(wfBuildCardHouse(&world, 5, WF_R(0.001), seed));
        assert_near(strayed(world, 600), 0, 0.1);
    }
}

static void towers_and_loads_stand(void **unused)
{
    (void)unused;
    wfWorld world = room_for(64);
    assert_ok(wfBuildTower(&world, 20, 1));
    assert_near(strayed(world, 1200), 0, 0.5);
    world = room_for(4);
    assert_ok(wfBuildHeavyOnLight(&world, 100));
    assert_near(strayed(world, 1200), 0, 0.1);
}

/* Whatever their speed: in the end none overlaps its neighbour by more than what its weight presses in. */
static void boxes_born_in_one_place_come_apart(void **unused)
{
    (void)unused;
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    int32_t count;
    def.pairCapacity = def.contactCapacity = 1300;
    assert_ok(wfCreateWorld(&def, &world));
    assert_ok(wfBuildCoincident(&world, 50));
    for (int i = 0; i < 900; i++) assert_ok(wfStepWorld(&world));
    const wfContact *c = wfWorldContacts(&world, &count);
    for (int32_t i = 0; i < count; i++)
        for (int32_t k = 0; k < c[i].manifold.count; k++) assert_true(c[i].manifold.points[k].depth < WF_R(0.01));
    wfDestroyWorld(&world);
}

static void experiments_have_names(void **unused)
{
    (void)unused;
    wfWorldDef how = wfDefaultWorldDef();
    for (int i = 0; i < wfClassicCount; i++) assert_true(wfClassicTable[i].name[0] && wfClassicTable[i].what[0] && wfClassicTable[i].aim[0]);
    assert_true(isnan(wfRunClassic("no such thing", &how)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sliding_slipping_creeping_rolling), cmocka_unit_test(a_pendulum_keeps_its_energy_and_its_time),
        cmocka_unit_test(a_cradle_hands_the_speed_on), cmocka_unit_test(no_bullet_passes), cmocka_unit_test(the_theory_of_the_arch),
        cmocka_unit_test(an_arch_stands_and_a_thinner_one_falls), cmocka_unit_test(an_overhang_stands_and_a_wider_one_falls),
        cmocka_unit_test(a_card_house_of_five_storeys_stands), cmocka_unit_test(towers_and_loads_stand),
        cmocka_unit_test(boxes_born_in_one_place_come_apart), cmocka_unit_test(experiments_have_names),
    };
    return cmocka_run_group_tests_name("30 the classics", tests, NULL, NULL);
}
