// The engine in two files, in a C++ program: make amalgam, then compile weft.c and this.
#include <cstdio>
#include "weft.h"

int main()
{
    wfWorldDef def = wfDefaultWorldDef();
    wfWorld world;
    if (wfCreateWorld(&def, &world) != WF_OK) return 1;
    wfBodyDef ball = wfDefaultBodyDef();
    ball.position = wfV2(0, 100);
    wfBodyId id;
    wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape);
    if (wfAddBodyToWorld(&world, &ball, &id) != WF_OK) return 2;
    for (int i = 0; i < 60; i++) wfStepWorld(&world);
    wfBodyInfo info;
    wfGetBody(&world, id, &info);
    double fallen = 100 - static_cast<double>(info.position.y);
    std::printf("after a second it has fallen %.1f m\n", fallen);
    wfDestroyWorld(&world);
}
/* prints:
after a second it has fallen 4.9 m
*/
