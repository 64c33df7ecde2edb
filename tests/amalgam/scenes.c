/* scenes.c: three scenes, and the hash of each after 300 steps. Compiled with the library and with the two files of `make
   amalgam`, as C and as C++: the numbers must be the same. */
#include <stdio.h>
#include <stdlib.h>
#include WEFT_HEADER

static void must(wfResult result, const char *what)
{
    if (result == WF_OK) return;
    fprintf(stderr, "%s: %s\n", what, wfResultText(result));
    exit(1);
}

static wfBodyId add(wfWorld *world, int type, wfReal x, wfReal y, const wfShape *shape)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.type = type;
    def.position = wfV2(x, y);
    def.shape = *shape;
    must(wfAddBodyToWorld(world, &def, &id), "add");
    return id;
}

/* a pyramid of boxes that a ball runs into, with sleep */
static void pyramid(wfWorld *world)
{
    wfShape floor, box, ball;
    must(wfMakeBox(20, 1, &floor), "floor");
    must(wfMakeBox(WF_R(0.5), WF_R(0.5), &box), "box");
    must(wfMakeCircle(wfV2(0, 0), WF_R(0.4), &ball), "ball");
    add(world, WF_STATIC, 0, -1, &floor);
    for (int row = 0; row < 8; row++)
        for (int i = 0; i < 8 - row; i++)
            add(world, WF_DYNAMIC, (wfReal)i + WF_R(0.5) * (wfReal)row - 4, (wfReal)row + WF_R(0.5), &box);
    wfBodyId thrown = add(world, WF_DYNAMIC, -15, 2, &ball);
    must(wfSetBodyVelocity(world, thrown, wfV2(30, 0), 5), "throw");
}

/* a chain of hinges that swings, a motor, a spring */
static void machine(wfWorld *world)
{
    wfShape link, hub;
    wfJoint joint;
    must(wfMakeBox(WF_R(0.4), WF_R(0.1), &link), "link");
    must(wfMakeCircle(wfV2(0, 0), WF_R(0.3), &hub), "hub");
    wfBodyId last = add(world, WF_STATIC, 0, 10, &hub);
    for (int i = 0; i < 12; i++) {
        wfBodyId next = add(world, WF_DYNAMIC, WF_R(0.9) * (wfReal)i + WF_R(0.5), 10, &link);
        wfVec2 at = wfV2(WF_R(0.9) * (wfReal)i + WF_R(0.05), 10);
        must(wfDefineJoint(world, "revolute", last, next, at, at, wfV2(1, 0), &joint), "join");
        if (i == 0) { joint.flags |= WF_JOINT_MOTOR; joint.motorSpeed = 1; joint.motorForce = 50; }
        must(wfAddJointToWorld(world, &joint, NULL), "hinge");
        last = next;
    }
    wfForce spring = wfSpringToPoint(wfBodyIndex(world, last), wfV2(0, 0), wfV2(5, 0), 1, 20, 1);
    must(wfAddForceToWorld(world, &spring, NULL), "spring");
}

/* bullets through a box that floats, a belt, a sensor */
static void fast(wfWorld *world)
{
    wfShape wall, bullet, crate;
    must(wfMakeBox(WF_R(0.05), 5, &wall), "wall");
    must(wfMakeCircle(wfV2(0, 0), WF_R(0.05), &bullet), "bullet");
    must(wfMakeBox(1, 1, &crate), "crate");
    add(world, WF_STATIC, 20, 0, &wall);
    wfBodyId held = add(world, WF_DYNAMIC, 5, 0, &crate);
    wfShapeDef more = wfDefaultShapeDef();
    must(wfMakeOrientedBox(wfV2(0, WF_R(1.5)), WF_R(0.2), WF_R(0.5), WF_R(0.3), &more.shape), "mast");
    must(wfAddShapeToBody(world, held, &more, NULL), "mast");
    more.sensor = 1;
    must(wfMakeCircle(wfV2(-2, 0), 1, &more.shape), "eye");
    must(wfAddShapeToBody(world, held, &more, NULL), "eye");
    wfForce water = wfBuoyancy(0, 2, WF_R(9.81), 1), air = wfDrag(WF_R(0.01), WF_R(0.001));
    must(wfAddForceToWorld(world, &water, NULL), "water");
    must(wfAddForceToWorld(world, &air, NULL), "air");
    for (int i = 0; i < 10; i++) {
        wfBodyId shot = add(world, WF_DYNAMIC, -5 - 3 * (wfReal)i, WF_R(0.2) * (wfReal)i, &bullet);
        must(wfSetBodyVelocity(world, shot, wfV2(400, 1), 0), "shoot");
    }
}

int main(void)
{
    void (*const scenes[])(wfWorld *) = { pyramid, machine, fast };
    static const char *const names[] = { "pyramid", "machine", "fast" };
    for (int i = 0; i < 3; i++) {
        wfWorldDef def = wfDefaultWorldDef();
        wfWorld world;
        def.sleep = 1;
        must(wfCreateWorld(&def, &world), "create");
        scenes[i](&world);
        for (int step = 0; step < 300; step++) must(wfStepWorld(&world), "step");
        printf("%s %016llx\n", names[i], (unsigned long long)wfHashWorld(&world));
        wfDestroyWorld(&world);
    }
    return 0;
}
