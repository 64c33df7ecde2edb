/* Thirty boxes on circular orbits round a turning planet: Chipmunk's demo "Planet", in units of 10 px = 1 m.
 * Checked: lone boxes come round in Kepler's period, 2 pi sqrt(r^3 / mu), and stay on their radius. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

enum { BOXES = 30 };
static const float mu = 5.0e3f;                         /* m^3/s^2 */
static wfWorld world;
static void must(int ok, const char *what) { if (!ok) { printf("planet: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }

static wfBodyId add_box(wfVec2 at)
{
    wfBodyDef def = wfDefaultBodyDef();
    wfBodyId id;
    def.position = at;
    def.angularVelocity = sqrtf(mu / wfLength(at)) / wfLength(at);
    def.velocity = wfScale(def.angularVelocity, wfV2(-at.y, at.x));
    def.angle = atan2f(at.y, at.x);
    def.friction = 0.7f;
    def.mass = 1;
    wfMakeBox(1, 1, &def.shape);
    must(wfAddBodyToWorld(&world, &def, &id) == WF_OK, "a box");
    return id;
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.gravity = wfV2(0, 0);
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    wfForce pull = wfPointGravity(wfV2(0, 0), mu, 0);
    must(wfAddForceToWorld(&world, &pull, NULL) == WF_OK, "gravity");
    wfBodyDef planet = wfDefaultBodyDef();
    planet.type = WF_KINEMATIC;
    planet.angularVelocity = 0.2f;
    planet.restitution = planet.friction = 1;
    wfMakeCircle(wfV2(0, 0), 7, &planet.shape);
    must(wfAddBodyToWorld(&world, &planet, NULL) == WF_OK, "the planet");

    /* A box on each of two rings that none of the others crosses; these lie between, and meet. */
    wfBodyId inner = add_box(wfV2(9.5f, 0)), outer = add_box(wfV2(0, 40));
    srand(1);
    for (int i = 2; i < BOXES; i++) {
        float r = 13 + 22 * (float)rand() / (float)RAND_MAX, a = 6.28f * (float)rand() / (float)RAND_MAX;
        add_box(wfV2(r * cosf(a), r * sinf(a)));
    }
    wfBodyId lone[] = { inner, outer };
    double turned[2] = { 0, 0 }, before[2] = { 0, 1.570796 }, period[2] = { 0, 0 };
    wfBodyInfo info;
    while (period[1] == 0) {
        must(wfStepWorld(&world) == WF_OK, "a step");
        for (int i = 0; i < 2; i++) {
            must(wfGetBody(&world, lone[i], &info) == WF_OK, "a box is lost");
            double angle = atan2(info.position.y, info.position.x), by = angle - before[i];
            if (by < -3.14159) by += 6.2831853;
            if (turned[i] + by >= 6.2831853 && period[i] == 0) period[i] = wfWorldTime(&world) - (turned[i] + by - 6.2831853) / (60 * by);
            turned[i] += by;
            before[i] = angle;
            /* w dt is 0.04 on the inner ring: a step of the second order is off by that squared. Later others come by. */
            double r = i == 0 ? 9.5 : 40;
            must(period[i] > 0 || fabs(wfLength(info.position) / r - 1) < 2e-3, "an orbit is no circle");
        }
        must(wfWorldTime(&world) < 30, "the outer box never comes round");
    }
    for (int i = 0; i < 2; i++) {
        double r = i == 0 ? 9.5 : 40, kepler = 6.2831853 * sqrt(r * r * r / mu);
        printf("planet: at %.1f m round in %.3f s, by Kepler %.3f s\n", r, period[i], kepler);
        must(fabs(period[i] / kepler - 1) < 2e-3, "the period is not Kepler's");
    }
    return wfDestroyWorld(&world);
}
