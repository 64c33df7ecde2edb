/* Fast bodies: thin ones that turn do not sink; houses of thin cards stand; contacts of bodies with joints are rows of the solver, so their joints
 * open no farther than without this stage, and none of them gets through a wall; a dense gas is no error; sensors see what flies through. */
#include "testing.h"
#include "world.h"
#include "weft/weft.h"

/* A rod of 10 m, nearly upright and turning, falls on the ground. Contacts may be as deep as the slop, and what is not stopped as the outer
 * layer, a quarter of the inner radius (eq:impact-inner). A copy that was shrunk towards the centroid let it sink by .14 to .56 m. */
TEST(thin_rods_do_not_sink)
{
    const double speeds[] = { 0, 5, 20, 50 }, halves[] = { 0.005, 0.02, 0.05, 0.1 }, rates[] = { 60, 240 };
    for (int v = 0; v < 4; v++)
        for (int t = 0; t < 4; t++)
            for (int r = 0; r < 2; r++) {
                wfWorldDef def = wfDefaultWorldDef();
                double half = halves[t], deepest = 0, slop = (double)def.advanced.slop * hypot(5, half);
                def.timeStep = 1 / (wfReal)rates[r];
                wfWorld w = world_with(&def);
                add(&w, floor_def());
                wfBodyDef rod = box_def(0, 12, 5, half);
                rod.angle = WF_PI / 2 - WF_R(0.3) + WF_R(0.05) * (wfReal)t;
                rod.velocity = wfV2(0, (wfReal)-speeds[v]), rod.angularVelocity = 3;
                wfBodyId id = add(&w, rod);
                for (int i = 0; i < (int)(4 * rates[r]); i++) {
                    assert_ok(wfStepWorld(&w));
                    wfBodyInfo b = info(&w, id);
                    double low = (double)b.centre.y - 5 * fabs(sin((double)b.angle)) - half * fabs(cos((double)b.angle));
                    if (fabs((double)b.centre.x) < 40) deepest = fmax(deepest, -low);
                }
                assert_true(deepest <= half / 4 + slop + 1e-4);
                wfDestroyWorld(&w);
            }
}

/* Does a house of cards of 2 mm still stand after 8 s? It begins with gaps of some millimetres, `lift` higher, and settles. */
static bool house_stands(int storeys, int rate, const char *solver, double lift)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyId id[64];
    wfVec2 at[64];
    int n = 0;
    double y = 0.18 + lift, first = 0, tilt = 25 * (double)WF_PI / 180;
    bool stands = true;
    def.timeStep = 1 / (wfReal)rate, def.solver = wfFindSolver(solver);
    wfWorld w = world_with(&def);
    wfBodyDef ground = floor_def();
    ground.friction = WF_R(0.7);
    add(&w, ground);
    for (int row = storeys; row > 0; row--, y += 0.37, first += 0.175) {
        double x = first;
        for (int i = 0; i < row; i++)
            for (int q = 0; q < 3; q++) {
                wfBodyDef card = box_def(x, y, 0.001, 0.2);
                card.friction = WF_R(0.7);
                if (q == 0 && i == row - 1) continue;
                if (q == 0) card.position = wfV2((wfReal)(x + 0.25), (wfReal)(y + 0.185)), card.angle = WF_PI / 2;
                else card.angle = (wfReal)(q == 1 ? -tilt : tilt), x += 0.175;
                at[n] = card.position;
                id[n++] = add(&w, card);
            }
    }
    for (int i = 0; i < 8 * rate; i++) assert_ok(wfStepWorld(&w));
    for (int i = 0; i < n; i++) stands = stands && wfDistance(info(&w, id[i]).centre, at[i]) < WF_R(0.1);
    wfDestroyWorld(&w);
    return stands;
}

/* Box2D's house. Since a card is fast at 6 cm/s, it was followed while it settled, and houses fell: the fifth storey at 60 Hz, with the solver "exact"
 * the third. A single house is chance: sixteen begin a hundredth of a millimetre apart. */
TEST(houses_of_cards_stand)
{
    for (int storeys = 3; storeys <= 6; storeys++)
        for (int i = 0; i < 16; i++) assert_true(house_stands(storeys, 60, "soft", 1e-5 * i));
    for (int i = 0; i < 4; i++) {
        assert_true(house_stands(5, 120, "soft", 1e-5 * i));
        assert_true(house_stands(5, 240, "soft", 1e-5 * i));
        assert_true(house_stands(4, 60, "exact", 1e-5 * i));
    }
}

/* Four bars on hinges, rods or welds fall on a floor: how far does a joint open at most? */
static double opened(const char *kind, double v, int phase, int impacts)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.maxImpacts = impacts;
    wfWorld w = world_with(&def);
    wfBodyId id[4];
    wfJoint joint[4];
    bool rods = kind[0] == 'd';
    double y = 0.27 + v * (0.5 + phase) / 180, most = 0;
    add(&w, floor_def());
    for (int i = 0; i < 4; i++) {
        wfBodyDef bar = box_def(0.1 * i * phase, y + 0.5 * i, 0.05, 0.24);
        wfVec2 pin = wfV2(bar.position.x, bar.position.y - WF_R(0.25));
        bar.velocity = wfV2((wfReal)(phase * v / 8), (wfReal)-v);
        id[i] = add(&w, bar);
        if (i == 0) continue;
        assert_ok(wfDefineJoint(&w, kind, id[i - 1], id[i], pin, rods ? bar.position : pin, wfV2(1, 0), &joint[i]));
        assert_ok(wfAddJointToWorld(&w, &joint[i], NULL));
    }
    for (int k = 0; k < 60; k++) {
        assert_ok(wfStepWorld(&w));
        for (int i = 1; i < 4; i++) {
            wfBodyInfo a = info(&w, id[i - 1]), b = info(&w, id[i]);
            wfVec2 onA = wfAdd(a.centre, wfRotate(wfRotation(a.angle), joint[i].localA));
            wfVec2 onB = wfAdd(b.centre, wfRotate(wfRotation(b.angle), joint[i].localB));
            most = fmax(most, fabs((double)wfDistance(onA, onB) - (rods ? (double)joint[i].rest : 0)));
        }
    }
    wfDestroyWorld(&w);
    return most;
}

/* No farther than without this stage. (Followed one by one, two hinged bars came 25 cm apart at
 * 32 m/s; the solver gives 4 cm.) */
TEST(joints_open_no_farther_than_without)
{
    static const char *kinds[] = { "revolute", "distance", "weld" };
    for (int k = 0; k < 3; k++)
        for (double v = 2; v < 60; v *= 2)
            for (int phase = 0; phase < 4; phase++) {
                assert_true(opened(kinds[k], v, phase, 4096) <= opened(kinds[k], v, phase, 0));
            }
}

/* Three boxes or discs, joined, fly at a thin wall: is one of them behind it afterwards? */
static bool one_gets_through(const char *kind, double rate, bool discs, bool heavy, double v, int phase)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0), def.bodyCapacity = 8, def.timeStep = 1 / (wfReal)rate;
    wfWorld w = world_with(&def);
    wfBodyDef wall = box_def(0, 0, 0.05, 20);
    wall.type = heavy ? WF_DYNAMIC : WF_STATIC, wall.density = heavy ? 100 : 1;
    wfBodyId id[3], stop = add(&w, wall);
    double x = -3 - phase * v / rate / 20;
    bool through = false;
    for (int i = 0; i < 3; i++) {
        wfBodyDef link = discs ? ball_def(x - 0.6 * i, 0.013 * i, 0.1) : box_def(x - 0.6 * i, 0.013 * i, 0.3, 0.1);
        link.velocity = wfV2((wfReal)v, (wfReal)(v / 10));
        id[i] = add(&w, link);
        if (i == 0) continue;
        wfJoint j;
        wfVec2 pin = wfV2((wfReal)(x - 0.6 * i + 0.3), (wfReal)(0.013 * i));
        assert_ok(wfDefineJoint(&w, kind, id[i - 1], id[i], kind[0] == 'd' ? wfV2(pin.x + WF_R(0.1), pin.y) : pin, pin, wfV2(1, 0), &j));
        assert_ok(wfAddJointToWorld(&w, &j, NULL));
    }
    for (int k = 0; k < 40; k++) {
        assert_ok(wfStepWorld(&w));
        wfReal edge = info(&w, stop).position.x + WF_R(0.05);
        for (int i = 0; i < 3; i++) {
            wfVec2 p = info(&w, id[i]).position;
            through = through || (p.x >= edge && fabs((double)p.y) < 19);
        }
    }
    wfDestroyWorld(&w);
    return through;
}

/* From 20 phases, at two rates, by the kinds of joint that hold points together; the wall is static or heavy. */
TEST(machines_do_not_get_through)
{
    static const char *const kinds[] = { "revolute", "distance", "weld", "wheel" };
    for (int kind = 0; kind < 4; kind++)
        for (int fine = 0; fine < 2; fine++)
            for (int way = 0; way < 4; way++)
                for (double v = 5; v < (kind == 0 && !fine ? 2e5 : 1500); v *= 4)
                    for (int phase = 0; phase < 20; phase += 1 + way / 2 + fine)
                        assert_false(one_gets_through(kinds[kind], fine ? 240 : 60, way % 2 == 1, way / 2 == 1, v, phase));
}

/* Discs, boxes, thin rods that go from a tenth of their reach to twice it in a step, and turn, fly at a thin wall from anywhere: those that are
 * followed and those that are rows of the solver. Nobody gets through, and energy never grows (a rounding each step). */
TEST(at_every_pace_nobody_gets_through)
{
    enum { FLIGHTS = 1200, STEPS = 30 };
    wfRandom r = random_stream(2611);
    for (int n = 0; n < FLIGHTS; n++) {
        static const double bounce[] = { 0, 0.3, 0.5, 1 };
        wfWorldDef def = wfDefaultWorldDef();
        double rate = n % 2 == 0 ? 60 : 240, half = n % 3 == 0 ? 0.3 : n % 3 == 1 ? 0.002 : 0.02, kinetic, potential;
        def.gravity = wfV2(0, 0), def.bodyCapacity = 4, def.timeStep = 1 / (wfReal)rate;
        wfWorld w = world_with(&def);
        wfBodyDef wall = box_def(0, 0, 0.0005, 40), body = n % 4 == 0 ? ball_def(0, 0, 0.3) : box_def(0, 0, 0.3, half);
        double pace = (double)wfRandomReal(&r, WF_R(0.1), 2), turn = (double)wfRandomReal(&r, WF_R(-0.8), WF_R(0.8));
        wall.type = n % 5 == 0 ? WF_DYNAMIC : WF_STATIC, wall.density = 1000;
        body.position = wfV2(-WF_R(0.45) - wfRandomReal(&r, 0, 1), wfRandomReal(&r, -1, 1));
        body.angle = wfRandomReal(&r, -WF_PI, WF_PI), body.restitution = (wfReal)bounce[n / 4 % 4];
        body.velocity = wfV2((wfReal)(pace * 0.3 * rate), (wfReal)(pace * 0.1 * rate)), body.angularVelocity = (wfReal)(turn * rate);
        wfBodyId stop = add(&w, wall), id = add(&w, body);
        assert_ok(wfWorldEnergy(&w, &kinetic, &potential));
        double most = kinetic * (1 + STEPS * 8 * (double)WF_EPSILON);
        for (int k = 0; k < STEPS; k++) {
            assert_ok(wfStepWorld(&w));
            wfVec2 p = info(&w, id).position;
            assert_ok(wfWorldEnergy(&w, &kinetic, &potential));
            if (p.x >= info(&w, stop).position.x && fabs((double)p.y) < 39) fail_msg("flight %d: behind the wall", n);
            if (kinetic > most) fail_msg("flight %d: energy %g of %g", n, kinetic, most);
        }
        wfDestroyWorld(&w);
    }
}

/* A packing of discs, boxes and rods, which press each other, is flung at a wall at .2 to 12 of its bodies' reaches a step: some of them are rows,
 * some are followed, some are both within one step. No centre gets to the middle of a
 * wall of 20 cm, and no energy comes (a rounding each step for each body). */
TEST(what_presses_stays_in_its_room)
{
    enum { ROOMS = 160, N = 36 };
    wfRandom r = random_stream(2711);
    for (int n = 0; n < ROOMS; n++) {
        wfWorldDef def = wfDefaultWorldDef();
        double rate = n % 2 == 0 ? 60 : 240, half = n % 3 == 0 ? 0.1 : n % 3 == 1 ? 0.05 : 0.01, kinetic, potential, before;
        def.gravity = wfV2(0, 0), def.bodyCapacity = N + 4, def.timeStep = 1 / (wfReal)rate;
        wfWorld w = world_with(&def);
        wfBodyId id[N];
        for (int i = 0; i < 4; i++) {
            wfBodyDef wall = i < 2 ? box_def(i == 0 ? -2.1 : 2.1, 0, 0.1, 2.2) : box_def(0, i == 2 ? -2.1 : 2.1, 2.2, 0.1);
            wall.type = WF_STATIC;
            add(&w, wall);
        }
        double pace = exp((double)wfRandomReal(&r, WF_R(-1.6), WF_R(2.5))), angle = (double)wfRandomReal(&r, -WF_PI, WF_PI);
        for (int i = 0; i < N; i++) {
            double x = -0.51 + 0.2 * (i % 6), y = -0.51 + (2 * half + 0.002) * (i / 6);
            wfBodyDef b = i % 4 == 0 && half > 0.09 ? ball_def(x, y, 0.1) : box_def(x, y, 0.1, half);
            b.friction = WF_R(0.5);
            id[i] = add(&w, b);
        }
        for (int i = 0; i < N; i += 6) assert_ok(wfSetBodyVelocity(&w, id[i], wfV2(WF_R(0.5), 0), 0));
        for (int k = 0; k < 6; k++) assert_ok(wfStepWorld(&w));          /* a blow from the left presses them */
        for (int i = 0; i < N; i++) {
            wfVec2 v = wfScale((wfReal)(pace * 0.1 * rate), wfV2((wfReal)cos(angle), (wfReal)sin(angle)));
            v = wfAdd(v, wfV2(wfRandomReal(&r, -1, 1), wfRandomReal(&r, -1, 1)));
            assert_ok(wfSetBodyVelocity(&w, id[i], v, wfRandomReal(&r, -3, 3)));
        }
        assert_ok(wfWorldEnergy(&w, &before, &potential));
        for (int k = 0; k < 40; k++) {
            assert_ok(wfStepWorld(&w));
            assert_ok(wfWorldEnergy(&w, &kinetic, &potential));
            if (kinetic > before * (1 + 40 * N * 8 * (double)WF_EPSILON)) fail_msg("room %d: energy %g of %g", n, kinetic, before);
            for (int i = 0; i < N; i++) {
                wfVec2 p = info(&w, id[i]).position;
                if (!(fabs((double)p.x) < 2.1 && fabs((double)p.y) < 2.1)) fail_msg("room %d, pace %g: outside", n, pace);
            }
        }
        wfDestroyWorld(&w);
    }
}

/* A gas of a thousand discs at 200 m/s in a box: more impacts than a step has room for, and no step is refused, nobody is outside, no energy comes. */
TEST(a_dense_gas_is_no_error)
{
    enum { N = 1000, ROW = 32 };
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0), def.bodyCapacity = N + 4;
    wfWorld w = world_with(&def);
    wfRandom r = random_stream(2505);
    wfBodyId id[N];
    double side = 16, before = 0, kinetic, potential;
    const double corner[5][2] = { { 0, 0 }, { side, 0 }, { side, side }, { 0, side }, { 0, 0 } };
    for (int i = 0; i < 4; i++) {
        wfBodyDef wall = wfDefaultBodyDef();
        wall.type = WF_STATIC, wall.friction = 0, wall.restitution = WF_R(0.5);
        assert_ok(wfMakeSegment(wfV2((wfReal)corner[i][0], (wfReal)corner[i][1]), wfV2((wfReal)corner[i + 1][0], (wfReal)corner[i + 1][1]), &wall.shape));
        add(&w, wall);
    }
    for (int i = 0; i < N; i++) {
        wfBodyDef disc = ball_def((i % ROW + 0.5) * side / ROW, (i / ROW + 0.5) * side / ROW, 0.1);
        wfReal angle = wfRandomReal(&r, -WF_PI, WF_PI);
        disc.friction = 0, disc.restitution = WF_R(0.5), disc.velocity = wfScale(200, wfV2(wfCos(angle), wfSin(angle)));
        id[i] = add(&w, disc);
    }
    assert_ok(wfWorldEnergy(&w, &before, &potential));
    for (int k = 0; k < 8; k++) {
        assert_ok(wfStepWorld(&w));
        assert_ok(wfWorldEnergy(&w, &kinetic, &potential));
        assert_true(kinetic < before);                                   /* e = 1/2: an overlap that nobody met adds less than bounces take */
    }
    for (int i = 0; i < N; i++) {
        wfVec2 p = info(&w, id[i]).position;
        assert_true(p.x > 0 && (double)p.x < side && p.y > 0 && (double)p.y < side);
    }
    wfDestroyWorld(&w);
}

/* ---- what flies through a sensor ---- */

enum { BARRIER, DISC, FAT_BOX, ROUNDED, SENSORS };

/* Something passes a sensor, or a sensor something, at any speed and phase: one touch begins and the same one ends, and nobody is slowed. */
static void fly_by(int solver, int kind, int sensorType, int otherType, bool sensorFlies, double speed, int phase)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    def.solver = solver, def.bodyCapacity = 4;
    wfWorld w = world_with(&def);
    wfShapeDef sensor = wfDefaultShapeDef();
    sensor.sensor = 1;
    if (kind == BARRIER) assert_ok(wfMakeSegment(wfV2(0, -2), wfV2(0, 2), &sensor.shape));
    if (kind == DISC) assert_ok(wfMakeCircle(wfV2(0, 0), WF_R(0.3), &sensor.shape));
    if (kind == FAT_BOX) assert_ok(wfMakeBox(WF_R(0.5), WF_R(0.5), &sensor.shape));
    if (kind == ROUNDED) assert_ok(wfMakeRoundedBox(WF_R(0.2), WF_R(0.2), WF_R(0.1), &sensor.shape));
    wfBodyDef on = wfDefaultBodyDef(), disc = ball_def(0, 0.1, 0.2);
    on.type = sensorType, disc.type = otherType;
    wfBodyDef *flies = sensorFlies ? &on : &disc;
    flies->velocity = wfV2((wfReal)speed, 0);
    flies->position.x = (wfReal)(-2 - speed / 60 * phase / 7);
    wfBodyId a = add(&w, on), b = add(&w, disc);
    assert_ok(wfAddShapeToBody(&w, a, &sensor, NULL));
    int32_t begun = 0, ended = 0, n;
    for (int i = 0; i < 8 + (int)(4 * 60 / speed); i++) {
        assert_ok(wfStepWorld(&w));
        wfWorldEvents(&w, WF_SENSOR_BEGIN, &n);
        begun += n;
        wfWorldEvents(&w, WF_SENSOR_END, &n);
        ended += n;
        if (ended > begun) fail_msg("more have left than came");
    }
    double left = (double)info(&w, sensorFlies ? a : b).velocity.x;
    if (begun != 1 || ended != 1 || left != (double)(wfReal)speed)
        fail_msg("%s, sensor %d on type %d, disc of type %d, %s flies at %g m/s, phase %d: %d came, %d left", wfSolverTable[solver].name,
                 kind, sensorType, otherType, sensorFlies ? "sensor" : "disc", speed, phase, (int)begun, (int)ended);
    wfDestroyWorld(&w);
}

TEST(a_sensor_sees_what_flies_through)
{
    const double speed[] = { 3, 40, 300, 5000 };
    for (int solver = 0; solver < wfSolverCount; solver++)
        for (int kind = 0; kind < SENSORS; kind++)
            for (int types = 0; types < 9; types++)
                for (int flies = 0; flies < 2; flies++)
                    for (int v = 0; v < 4; v++)
                        for (int phase = v; phase < 7; phase += 3)
                            if ((flies ? types / 3 : types % 3) != WF_STATIC && !(flies && types % 3 == WF_STATIC))
                                fly_by(solver, kind, types / 3, types % 3, flies != 0, speed[v], phase);
}

/* It flies past at the side, is struck in front of the barrier or passes it in a bounce; is joined, filtered, forbidden by a callback; or nobody
 * follows fast bodies. How often it is told. */
static bool never(void *context, const wfCallbackView *view, int32_t a, int32_t b) { (void)context, (void)view, (void)a, (void)b; return false; }

TEST(a_sensor_sees_what_it_may)
{
    static const struct { double y, wall; int joined, mask, hook, impacts, told; } row[] = {
        { 0, 0, 0, 1, 0, 64, 1 }, { 2.3, 0, 0, 1, 0, 64, 0 }, { 0, -0.5, 0, 1, 0, 64, 0 }, { 0, 1.5, 0, 1, 0, 64, 2 },
        { 0, 0, 1, 1, 0, 64, 0 }, { 0, 0, 0, 0, 0, 64, 0 }, { 0, 0, 0, 1, 1, 64, 0 }, { 0, 0, 0, 1, 0, 0, 0 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        wfWorldDef def = wfDefaultWorldDef();
        def.gravity = wfV2(0, 0);
        def.maxImpacts = row[i].impacts;
        wfWorld w = world_with(&def);
        wfBodyDef on = wfDefaultBodyDef(), wall = box_def(row[i].wall + 0.1, 0, 0.1, 9), disc = ball_def(-2, row[i].y, 0.2);
        on.type = wall.type = WF_STATIC, disc.velocity = wfV2(240, 0), disc.restitution = 1;       /* 4 m a step */
        wfShapeDef sensor = wfDefaultShapeDef();
        sensor.sensor = 1, sensor.filter.mask = row[i].mask ? UINT64_MAX : 0;
        assert_ok(wfMakeSegment(wfV2(0, -2), wfV2(0, 2), &sensor.shape));
        wfBodyId a = add(&w, on), b = add(&w, disc);
        if (row[i].wall != 0) add(&w, wall);
        assert_ok(wfAddShapeToBody(&w, a, &sensor, NULL));
        wfJoint j;
        assert_ok(wfDefineJoint(&w, "filter", a, b, wfV2(0, 0), wfV2(0, 0), wfV2(1, 0), &j));
        if (row[i].joined) assert_ok(wfAddJointToWorld(&w, &j, NULL));
        wfCallbacks hooks = { .filter = row[i].hook ? never : NULL };
        int32_t told = 0, ended = 0, n;
        for (int k = 0; k < 4; k++) {
            assert_ok(wfStepWorldWithCallbacks(&w, &hooks));
            wfWorldEvents(&w, WF_SENSOR_BEGIN, &n);
            told += n;
            wfWorldEvents(&w, WF_SENSOR_END, &n);
            ended += n;
        }
        if ((row[i].told > 0) != (told > 0) || told > row[i].told || ended != told) fail_msg("row %zu: %d came, %d left", i, (int)told, (int)ended);
        wfDestroyWorld(&w);
    }
}
