/* needs: hooks */
/* A hook that says no lets a ball fall through the floor. */
#include "part.h"

static bool never(void *context, const wfCallbackView *view, int32_t a, int32_t b)
{
    (void)view, (void)a, (void)b;
    ++*(int *)context;
    return false;
}

PART(hooks)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    wfBodyDef ground = wfDefaultBodyDef(), ball = wfDefaultBodyDef();
    wfBodyId id;
    int asked = 0;
    wfCallbacks hooks = { .context = &asked, .filter = never };
    OK(wfCreateWorld(&def, &world));
    ground.type = WF_STATIC;
    OK(wfMakeBox(10, WF_R(0.5), &ground.shape));
    OK(wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape));
    ball.position = wfV2(0, 2);
    OK(wfAddBodyToWorld(&world, &ground, NULL));
    OK(wfAddBodyToWorld(&world, &ball, &id));
    for (int i = 0; i < 90; i++) OK(wfStepWorldWithCallbacks(&world, &hooks));
    CHECK(asked > 0);
    CHECK(part_place(&world, id).y < -5);
    wfDestroyWorld(&world);
    return 0;
}
