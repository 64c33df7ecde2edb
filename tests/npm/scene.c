/* The scene of scene.mjs and of tests/python/test_weft.py, in C: prints its hash after 300 steps. */
#include <stdio.h>
#include <weft/weft.h>

static wfWorld world;
static wfBodyId body(int type, wfReal x, wfReal y, wfReal halfWidth, wfReal halfHeight)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfShapeDef shape = wfDefaultShapeDef();
    wfBodyId id = { 0, 0 };
    def.type = type;
    def.position = wfV2(x, y);
    if (wfAddBodyToWorld(&world, &def, &id) != WF_OK) return id;
    if (halfHeight > 0) wfMakeBox(halfWidth, halfHeight, &shape.shape);
    else wfMakeCircle(wfV2(0, 0), halfWidth, &shape.shape);
    wfAddShapeToBody(&world, id, &shape, NULL);
    return id;
}
static wfResult hinge(wfBodyId a, wfBodyId b, wfReal x, wfReal y, wfReal speed, wfReal torque)
{
    wfJoint j;
    wfResult r = wfDefineJoint(&world, "revolute", a, b, wfV2(x, y), wfV2(x, y), wfV2(1, 0), &j);
    if (torque > 0) { j.flags |= WF_JOINT_MOTOR; j.motorSpeed = speed; j.motorForce = torque; }
    return r != WF_OK ? r : wfAddJointToWorld(&world, &j, NULL);
}
int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, -10);
    if (wfCreateWorld(&def, &world) != WF_OK) return 1;
    wfBodyId ground = body(WF_STATIC, 0, 0, 12, WF_R(0.5)), last = ground, arm;
    for (int row = 0; row < 8; row++)
        for (int k = 0; k <= row; k++) body(WF_DYNAMIC, (wfReal)k - WF_R(0.5) * (wfReal)row, (wfReal)(8 - row), WF_R(0.45), WF_R(0.45));
    arm = body(WF_DYNAMIC, -7, 5, 2, WF_R(0.25));
    if (hinge(ground, arm, -7, 5, 2, 500) != WF_OK) return 2;
    for (int k = 0; k < 10; k++) {
        wfBodyId next = body(WF_DYNAMIC, 6 + WF_R(0.5) * (wfReal)k, 9, WF_R(0.25), 0);
        if (hinge(last, next, WF_R(5.75) + WF_R(0.5) * (wfReal)k, 9, 0, 0) != WF_OK) return 3;
        last = next;
    }
    for (int k = 0; k < 300; k++) if (wfStepWorld(&world) != WF_OK) return 4;
    printf("%llu\n", (unsigned long long)wfHashWorld(&world));
    return wfDestroyWorld(&world) != WF_OK;
}
