/* needs: makers */
/* A chain is hung on the ground in one call, or not at all; a mass on a spring of 1 Hz is back after a second. */
#include "part.h"
#include "weft/chain.h"
#include "weft/spring.h"

PART(makers)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef body = wfDefaultBodyDef();
    wfBodyId ground, mass;
    const wfVec2 hill[] = { wfV2(9, 0), wfV2(0, 1), wfV2(-9, 0), wfV2(-9, 0) };
    wfShapeDef like = wfDefaultShapeDef();
    wfJoint spring;
    def.gravity = wfV2(0, 0);
    OK(wfCreateWorld(&def, &world));
    body.type = WF_STATIC;
    OK(wfAddBodyToWorld(&world, &body, &ground));
    CHECK(wfAddChainToBody(&world, ground, hill, 4, false, &like, NULL) != WF_OK && wfShapeCount(&world) == 0);
    OK(wfAddChainToBody(&world, ground, hill, 3, false, &like, NULL));
    CHECK(wfShapeCount(&world) == 2);
    body.type = WF_DYNAMIC, body.position = wfV2(3, 5), body.mass = 7;
    OK(wfAddBodyToWorld(&world, &body, &mass));
    OK(wfDefineJoint(&world, "distance", ground, mass, wfV2(0, 5), wfV2(3, 5), wfV2(0, 0), &spring));
    OK(wfTuneJointSpring(&world, &spring, 1, 0));
    OK(wfAddJointToWorld(&world, &spring, NULL));
    OK(wfSetBodyVelocity(&world, mass, wfV2(1, 0), 0));
    for (int i = 0; i < 60; i++) OK(wfStepWorld(&world));
    wfBodyInfo now;
    OK(wfGetBody(&world, mass, &now));
    NEAR(now.position.x, 3, WF_R(0.02));
    wfDestroyWorld(&world);
    return 0;
}
