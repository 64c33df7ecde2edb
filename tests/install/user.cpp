// What a user of the installed engine writes in C++: all headers, and a ball that falls for a second.
#include <cstdio>
#include <cstring>
#include <weft/accuracy.h>
#include <weft/draw.h>
#include <weft/json.h>
#include <weft/save.h>
#include <weft/weft.h>

int main()
{
    char version[32];
    std::snprintf(version, sizeof version, "%d.%d.%d", WF_VERSION_MAJOR, WF_VERSION_MINOR, WF_VERSION_PATCH);
    if (std::strcmp(version, wfVersion()) != 0) return 1;
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, -10);
    def.timeStep = 1 / wfReal(64);
    wfWorld world;
    if (wfCreateWorld(&def, &world) != WF_OK) return 2;
    wfBodyDef ball = wfDefaultBodyDef();
    ball.type = WF_DYNAMIC;
    ball.position = wfV2(0, 100);
    wfBodyId id;
    if (wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball.shape) != WF_OK || wfAddBodyToWorld(&world, &ball, &id) != WF_OK) return 3;
    for (int i = 0; i < 64; i++)
        if (wfStepWorld(&world) != WF_OK) return 4;
    wfBodyInfo info;
    if (wfGetBody(&world, id, &info) != WF_OK) return 5;
    std::printf("weft %s in C++: height after one second: %.4f m\n", wfVersion(), double(info.position.y));
    wfDestroyWorld(&world);
    return info.position.y > WF_R(94.999) && info.position.y < WF_R(95.001) ? 0 : 6;
}
