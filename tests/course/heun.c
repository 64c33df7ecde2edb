/* Exercise int-heun: an integrator of second order. Oracles: closed solutions; the determinant of the step's map. */
#include "course.h"
#include "integrators.h"

static void order(void)
{
    double got[4];
    int row = find_row("heun");
    Rig *once = spring_rig();
    rig_step(once, row, 0.1);
    expect_int("looks at the forces in a step", once->evaluations, 2);
    FILE *plot = course_plot("order", "error against the step", "step h (s)", "error", "xy");
    for (int i = 0; i < 4; i++) got[i] = measured_order(row, &MOTIONS[i], plot);
    course_plotted(plot);
    for (int i = 0; i < 4; i++) expect_near(say("order of convergence, %s", MOTIONS[i].name), got[i], 2, 0.1);
}

/* The columns of the map of one step on a spring of omega h = 0.4: determinant 1 + (omega h)^4 / 4. */
static void determinant(void)
{
    double m[2][2], h = 0.4;
    for (int j = 0; j < 2; j++) {
        Rig *rig = spring_rig();
        rig->state[0].p = wfV2(j == 0, 0);
        rig->state[0].v = wfV2(j == 1, 0);
        rig_step(rig, find_row("heun"), h);
        m[0][j] = (double)rig->state[0].p.x, m[1][j] = (double)rig->state[0].v.x;
    }
    expect_near("determinant of a step on a spring, h omega = 0.4", m[0][0] * m[1][1] - m[0][1] * m[1][0], 1 + pow(h, 4) / 4, 1e-5);
}

/* A spring that pulls at the rim: the torque depends on the angle. */
static void angle(void)
{
    Rig *rig = new_rig(1);
    int row = find_row("heun");
    rig->state[0].w = 1;
    rig->forces[rig->forceCount++] = wfSpringToPoint(0, wfV2(1, 0), wfV2(3, 0), 0, 1, 0);
    double coarse, fine;
    for (int k = 0; k < 32; k++) rig_step(rig, row, 1.0 / 32);
    coarse = (double)rig->state[0].angle;
    rig = new_rig(1);
    rig->state[0].w = 1;
    rig->forces[rig->forceCount++] = wfSpringToPoint(0, wfV2(1, 0), wfV2(3, 0), 0, 1, 0);
    for (int k = 0; k < 1024; k++) rig_step(rig, wfFindIntegrator("rk4"), 1.0 / 1024);
    fine = (double)rig->state[0].angle;
    expect_near("angle of a pendulum after 1 s, 32 steps, against 1024 of RK4", coarse, fine, 2e-3);
}

CRITERIA("heun",
    { "order", 2, "heun: step body [[i]] by the means", "the order of convergence is 2 +- 0.1 on four problems", order, 0 },
    { "determinant", 1, "heun: try an Euler step of body [[i]]", "one step on a spring has the determinant 1 + (h omega)^4 / 4", determinant, 0 },
    { "angle", 1, "heun: step body [[i]] by the means", "the angle is treated as the place", angle, 0 })
