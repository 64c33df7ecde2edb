/* Exercise impulses-row. Oracles: Newton's rule for two balls; the same result in every order. */
#include "course.h"
#include "weft/resolve.h"
static wfBodyState state[4];
static wfContact contacts[4];
static wfSolve problem(int bodies, int n, int passes, wfPool *pool)
{
    return (wfSolve){ .state = state, .bodyCount = bodies, .contacts = contacts, .contactCount = n, .h = WF_R(0.016), .iterations = passes, .substeps = 1,
                      .positionCorrection = WF_R(0.2), .scratch = pool };
}
static void solve(int bodies, int n, int passes)
{
    int row = asked(wfFindSolver("impulse-jacobi"));
    if (row < 0) course_fail("the row in the table of solvers", "impulse-jacobi", "no row of that name");
    wfPool pool = course_pool(asked(wfSolverTable[row].scratch(bodies, n)) + 64);
    wfSolve in = problem(bodies, n, passes, &pool);
    expect_result("solving", asked_and(wfSolveVelocities(row, &in), left(state)), WF_OK);
}
static wfContact touch(int a, int b, double nx, double ny, double x, double y, double e)
{
    wfContact c = { .a = a, .b = b, .restitution = (wfReal)e };
    c.manifold.normal = wfV2((wfReal)nx, (wfReal)ny);
    c.manifold.count = 1;
    c.manifold.points[0].point = wfV2((wfReal)x, (wfReal)y);
    c.manifold.points[0].rA = wfSub(c.manifold.points[0].point, state[a].p);
    c.manifold.points[0].rB = wfSub(c.manifold.points[0].point, state[b].p);
    return c;
}
static void ball(int i, double x, double y, double vx, double vy, double m)
{
    state[i] = (wfBodyState){ .p = { { (wfReal)x, (wfReal)y } }, .v = { { (wfReal)vx, (wfReal)vy } }, .invMass = m > 0 ? (wfReal)(1 / m) : 0, .invInertia = m > 0 ? (wfReal)(2 / m) : 0 };
}
static void bounce(void)
{
    ball(0, 0, 0, 4, 0, 3), ball(1, 2, 0, -2, 0, 1);
    contacts[0] = touch(0, 1, 1, 0, 1, 0, 0.5);
    solve(2, 1, 1);
    expect_near("velocity of B seen from A after a bounce with e = 0.5 at 6 m/s", (double)(state[1].v.x - state[0].v.x), 3, 1e-5);
    expect_near("momentum", 3 * (double)state[0].v.x + (double)state[1].v.x, 10, 1e-5);
    ball(0, 0, 0, -1, 0, 1), ball(1, 2, 0, 1, 0, 1);
    solve(2, 1, 3);
    expect_near("velocity of a ball that parts already", (double)state[1].v.x, 1, 0);
}
static void order(void)
{
    wfBodyState first[4];
    for (int turn = 0; turn < 2; turn++) {
        ball(0, 0, 0, 0, 0, 0), ball(1, 0, 1, 1, -3, 1), ball(2, 1, 2, -2, -2, 2), ball(3, -1, 2, 1, 1, 1);
        wfContact list[3] = { touch(0, 1, 0, 1, 0, 0.5, 0), touch(1, 2, 0.6, 0.8, 0.4, 1.5, 0), touch(1, 3, -0.6, 0.8, -0.4, 1.5, 0.3) };
        for (int i = 0; i < 3; i++) contacts[i] = list[turn ? 2 - i : i];
        solve(4, 3, 4);
        if (!turn) memcpy(first, state, sizeof first);
    }
    for (int i = 1; i < 4; i++) expect_v2(say("velocity of body %d with the list turned round", i), state[i].v, (double)first[i].v.x, (double)first[i].v.y, 1e-5);
    expect_at_least("speed at which the third ball, which parted, goes on upwards", (double)state[3].v.y, 0.9);
}
static void stop(void)
{
    ball(0, 0, 0, 0, 0, 0), ball(1, 0, 1, 0, -5, 2);
    contacts[0] = touch(0, 1, 0, 1, -1, 0.5, 0);
    contacts[0].manifold.count = 2;
    contacts[0].manifold.points[1] = contacts[0].manifold.points[0];
    contacts[0].manifold.points[1].point = wfV2(1, WF_R(0.5));
    contacts[0].manifold.points[1].rA = wfV2(1, WF_R(0.5)), contacts[0].manifold.points[1].rB = wfV2(1, -WF_R(0.5));
    solve(2, 1, 60);
    expect_v2("velocity of a box that fell flat on the floor", state[1].v, 0, 0, 1e-4);
    expect_near("its spin", (double)state[1].w, 0, 1e-4);
}
CRITERIA("jacobi",
    { "bounce", 1, "jacobi: resolve one point", "two balls bounce by Newton's rule and keep their momentum", bounce, 0 },
    { "order", 2, "jacobi: resolve one point", "the order of the contacts does not matter", order, 0 },
    { "stop", 1, "jacobi: resolve one point", "a box that falls flat is stopped", stop, 0 })
