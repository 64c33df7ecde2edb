/* What a user of the installed engine writes: a ball falls for a second, and Galileo is asked. */
#include <stdio.h>
#include <weft/weft.h>

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, -10);
    def.timeStep = 1 / (wfReal)64;
    wfWorld world;
    wfResult result = wfCreateWorld(&def, &world);
    if (result != WF_OK) { fprintf(stderr, "%s\n", wfResultText(result)); return 1; }

    wfBodyDef ball = wfDefaultBodyDef();
    ball.type = WF_DYNAMIC;
    ball.position = wfV2(0, 100);
    wfMakeCircle(wfV2(0, 0), 0.5f, &ball.shape);
    wfBodyId id;
    if (wfAddBodyToWorld(&world, &ball, &id) != WF_OK) return 2;
    for (int i = 0; i < 64; i++)
        if (wfStepWorld(&world) != WF_OK) return 3;

    wfBodyInfo info;
    if (wfGetBody(&world, id, &info) != WF_OK) return 4;
    printf("height after one second: %.4f m\n", (double)info.position.y);
    wfDestroyWorld(&world);
    return info.position.y > 94.999f && info.position.y < 95.001f ? 0 : 5;
}
