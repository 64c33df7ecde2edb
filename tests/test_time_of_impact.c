/* Time of impact. Oracles: closed forms (circles, walls, the spinning rod); a dense sampling of the true distance in
   double, with refined minima, that knows neither bounds nor axes; and symmetries. */
#include "testing.h"
#include "shapes.h"
#include "motion.h"

typedef struct Tally { long kinds[4], steps; int most; } Tally;

/* What must hold of every answer. Returns it. */
static wfImpact check_impact(const Pair *p, int samples, Tally *tally)
{
    wfImpact r;
    double eta = noise_of(p);
    assert_ok(wfTimeOfImpact(&p->a, p->sa, &p->b, p->sb, &r));
    assert_true(r.t >= 0 && r.t <= 1 && r.steps >= 1 && r.steps <= WF_IMPACT_STEPS);
    double d = distance_at(p, (double)r.t), near = (double)r.touching;
    assert_near(r.distance, d, eta);
    if (r.kind == WF_IMPACT_OVERLAP) {
        assert_true(r.t == 0 && d <= eta);
    } else {
        assert_near(wfLength(r.normal), 1, 8 * (double)WF_EPSILON);
        assert_true(least_before(p, (double)r.t, samples) >= fmin(near / 2 - eta, distance_at(p, 0) - eta));
    }
    if (r.kind == WF_IMPACT_TOUCH) assert_true(d <= near + eta);
    if (r.kind == WF_IMPACT_APART) assert_true(r.t == 1 && d > near - eta);
    if (r.kind == WF_IMPACT_UNFINISHED) assert_true(r.steps == WF_IMPACT_STEPS);
    if (tally) {
        tally->kinds[r.kind]++;
        tally->steps += r.steps;
        if (r.steps > tally->most) tally->most = r.steps;
    }
    return r;
}

static void scale_pair(Pair *p, double by)
{
    p->a = scaled(p->a, by);
    p->b = scaled(p->b, by);
    wfVec2 *all[4] = { &p->sa.from, &p->sa.to, &p->sb.from, &p->sb.to };
    for (int i = 0; i < 4; i++) *all[i] = wfScale((wfReal)by, *all[i]);
}


/* ---- sweeps ---- */

TEST(test_a_sweep_keeps_its_ends)
{
    wfRandom r = random_stream(2100);
    for (int i = 0; i < 200; i++) {
        wfSweep s;
        s.from = random_v2(&r, -1000, 1000);
        s.to = random_v2(&r, -1000, 1000);
        s.angleFrom = wfRandomReal(&r, -50, 50);
        s.angleTo = wfRandomReal(&r, -50, 50);
        wfTransform a = wfSweepAt(s, 0), b = wfSweepAt(s, 1), m = wfSweepAt(s, WF_R(0.25));
        wfTransform wantA = wfMakeTransform(s.from, s.angleFrom), wantB = wfMakeTransform(s.to, s.angleTo);
        assert_memory_equal(&a, &wantA, sizeof a);
        assert_memory_equal(&b, &wantB, sizeof b);
        assert_ulps(m.p.x, 0.75 * (double)s.from.x + 0.25 * (double)s.to.x, 2, 1000);
        assert_ulps(m.p.y, 0.75 * (double)s.from.y + 0.25 * (double)s.to.y, 2, 1000);
        assert_ulps(m.q.c, cos(0.75 * (double)s.angleFrom + 0.25 * (double)s.angleTo), 2, 50);
        wfSweep first = wfSweepUntil(s, WF_R(0.5));
        wfTransform end = wfSweepAt(first, 1), half = wfSweepAt(s, WF_R(0.5)), quarter = wfSweepAt(first, WF_R(0.5));
        assert_memory_equal(&end, &half, sizeof end);
        assert_true(first.angleFrom == s.angleFrom && first.from.x == s.from.x && first.from.y == s.from.y);
        assert_ulps2(quarter.p, m.p, 2, 1000);
        assert_ulps(quarter.q.s, m.q.s, 2, 50);
    }
    wfSweep still = wfSweepStill(wfV2(3, 4), 5);
    wfTransform want = wfMakeTransform(wfV2(3, 4), 5);
    for (int k = 0; k < 3; k++) {
        wfTransform got = wfSweepAt(still, WF_R(0.5) * (wfReal)k);
        assert_memory_equal(&got, &want, sizeof got);
    }
}

/* ---- random flights against the sampled distance ---- */

TEST(test_random_sweeps)
{
    wfRandom r = random_stream(2101);
    Tally tally = { { 0 }, 0, 0 };
    for (int i = 0; i < 1800; i++) {
        Pair p = random_pair(&r, i % 3 == 0 ? 3 : i % 3 == 1 ? 6 : 30, i % 4 == 0 ? 0 : i % 4 == 1 ? 0.3 : i % 4 == 2 ? 3 : 12);
        if (i % 5 == 0) scale_pair(&p, 1e-3);
        if (i % 5 == 1) scale_pair(&p, 1e3);
        check_impact(&p, 200, &tally);
    }
    for (int k = 0; k < 3; k++) assert_true(tally.kinds[k] > 80);
    assert_int_equal(tally.kinds[WF_IMPACT_UNFINISHED], 0);
    assert_true(tally.steps < 1800 * 4 && tally.most < 60);
}

/* rods and needles that meet end-on, side-on, in parallel, with equal angular speeds, and marbles beside mountains */
TEST(test_degenerate_sweeps)
{
    wfRandom r = random_stream(2102);
    Tally tally = { { 0 }, 0, 0 };
    for (int i = 0; i < 800; i++) {
        Pair p = random_pair(&r, 3, 2);
        double thin = i % 2 ? 0.01 : 0.2;
        p.a = box(1, thin);
        if (i % 4 < 2) p.b = box(i % 3 ? 1 : 0.3, thin);
        if (i % 8 == 5) p.b = scaled(p.b, 1e-3);
        if (i % 8 == 6) p.b = scaled(p.b, 1e2);
        if (i % 5 == 0) p.sa.angleFrom = p.sa.angleTo = p.sb.angleFrom = p.sb.angleTo = 0;
        if (i % 5 == 1) p.sb.angleTo = p.sb.angleFrom + (p.sa.angleTo - p.sa.angleFrom);
        if (i % 5 == 2) p.sb.from = p.sb.to, p.sa.from = p.sa.to;                  /* both only turn */
        if (i % 5 == 3) p.sa.from.y = p.sa.to.y = p.sb.from.y = p.sb.to.y = 0;     /* head-on */
        check_impact(&p, 300, &tally);
    }
    for (int k = 0; k < 3; k++) assert_true(tally.kinds[k] > 40);
    assert_true(tally.kinds[WF_IMPACT_UNFINISHED] <= 4);
}

/* a body in many places at once: what one bound allows, the others must not contradict */
TEST(test_every_bound_is_conservative)
{
    wfRandom r = random_stream(2103);
    long steps[WF_ADVANCE_KINDS] = { 0 };
    for (int i = 0; i < 600; i++) {
        Pair p = random_pair(&r, 4, i % 3 == 0 ? 0.5 : i % 3 == 1 ? 3 : 20);
        double eta = noise_of(&p);
        wfImpact hit[WF_ADVANCE_KINDS], plain;
        wfImpactTrace t;
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &plain));
        for (int how = 0; how < WF_ADVANCE_KINDS; how++) {
            memset(&hit[how], 0, sizeof hit[how]);
            assert_ok(wfTraceImpact(&p.a, p.sa, &p.b, p.sb, how, &hit[how], &t));
            if (hit[how].kind == WF_IMPACT_OVERLAP) continue;
            steps[how] += hit[how].steps;
            assert_int_equal(t.count, hit[how].steps);
            assert_true(t.steps[0].t == 0 && t.steps[t.count - 1].t == hit[how].t);
            assert_true(t.steps[t.count - 1].distance == hit[how].distance && t.steps[t.count - 1].by == 0);
            for (int k = 0; k < t.count; k++) {
                assert_near(t.steps[k].distance, distance_at(&p, (double)t.steps[k].t), eta);
                assert_near(wfLength(t.steps[k].normal), 1, 8 * (double)WF_EPSILON);
                if (k == 0) continue;
                assert_true(t.steps[k].t > t.steps[k - 1].t);
                wfReal to = t.steps[k - 1].t + t.steps[k - 1].by;
                assert_true(t.steps[k].t == (to < 1 ? to : 1));
            }
            double least = least_before(&p, (double)hit[how].t, 150);
            assert_true(least >= fmin((double)hit[how].touching / 2 - eta, (double)hit[how].distance - eta));
            int kind = hit[how].kind;
            if (kind != WF_IMPACT_UNFINISHED && plain.kind != WF_IMPACT_UNFINISHED) assert_int_equal(kind, plain.kind);
        }
        assert_memory_equal(&hit[WF_ADVANCE_CURVE], &plain, sizeof plain);
    }
    for (int how = 1; how < WF_ADVANCE_KINDS; how++) assert_true((double)steps[how] < 0.9 * (double)steps[how - 1]);
}

/* ---- the bounds, number by number ---- */

typedef struct Bounds { double plain, along, disc, curve; } Bounds;

static double root_of_time(double room, double rate) { return room <= 0 ? 0 : rate <= 0 ? 1e300 : room / rate; }

/* The first steps that eq:impact-plain to eq:impact-curve allow, in double; the curve's by bisection on the least parabola. */
static Bounds bounds_of(const Pair *p, P n, double room)
{
    const wfShape *s[2] = { &p->a, &p->b };
    const wfSweep m[2] = { p->sa, p->sb };
    double at[2][WF_MAX_VERTICES], rate[2][WF_MAX_VERTICES], top[2], extent[2] = { 0, 0 }, spin[2], bend = 0;
    int count[2];
    for (int k = 0; k < 2; k++) {
        P axis = k == 0 ? n : (P){ -n.x, -n.y };
        double turn = (double)m[k].angleTo - (double)m[k].angleFrom;
        Outline o = outline_at(s[k], m[k], 0, (P){ (double)m[k].from.x, (double)m[k].from.y });
        count[k] = o.n;
        top[k] = -1e300;
        for (int i = 0; i < o.n; i++) {
            at[k][i] = dot(axis, o.v[i]);
            rate[k][i] = turn * dot(axis, (P){ -o.v[i].y, o.v[i].x });
            top[k] = fmax(top[k], at[k][i]);
            extent[k] = fmax(extent[k], size(o.v[i]));
        }
        spin[k] = fabs(turn) * extent[k];
        bend += turn * turn * extent[k];
    }
    P v = { (double)p->sb.to.x - (double)p->sb.from.x - ((double)p->sa.to.x - (double)p->sa.from.x),
            (double)p->sb.to.y - (double)p->sb.from.y - ((double)p->sa.to.y - (double)p->sa.from.y) };
    double u = -dot(n, v), dA = extent[0] - top[0], dB = extent[1] - top[1];
    Bounds b;
    b.plain = root_of_time(room, size(v) + spin[0] + spin[1]);
    b.along = root_of_time(room, u + spin[0] + spin[1]);
    b.disc = fmax(fmax(b.along, root_of_time(room - dA, u + spin[1])),
                  fmax(root_of_time(room - dB, u + spin[0]), root_of_time(room - dA - dB, u)));
    double lo = 0, hi = 1;
    for (int k = 0; k < 80; k++) {
        double mid = (lo + hi) / 2, a = -1e300, c = -1e300;
        for (int i = 0; i < count[0]; i++) a = fmax(a, at[0][i] + mid * rate[0][i] - top[0]);
        for (int i = 0; i < count[1]; i++) c = fmax(c, at[1][i] + mid * rate[1][i] - top[1]);
        if (room - a - c - u * mid - bend * mid * mid / 2 >= 0) lo = mid; else hi = mid;
    }
    b.curve = fmax(b.disc, room > 0 && bend > 0 ? lo : 0);
    return b;
}

TEST(test_first_steps_are_what_the_bounds_allow)
{
    wfRandom r = random_stream(2104);
    long better = 0, disc = 0, tried = 0;
    for (int i = 0; i < 3000; i++) {
        Pair p = random_pair(&r, i % 2 ? 4 : 2.5, i % 3 == 0 ? 0.3 : i % 3 == 1 ? 2 : 40);
        if (i % 7 == 0) p.sa.angleTo = p.sa.angleFrom;
        if (i % 11 == 0) p.sb.angleTo = p.sb.angleFrom;
        wfImpact hit;
        wfImpactTrace t;
        double got[WF_ADVANCE_KINDS];
        bool moves = true;
        for (int how = 0; how < WF_ADVANCE_KINDS && moves; how++) {
            assert_ok(wfTraceImpact(&p.a, p.sa, &p.b, p.sb, how, &hit, &t));
            moves = t.count > 1;
            got[how] = fmin((double)t.steps[0].by, 1);
        }
        if (!moves) continue;
        double eta = noise_of(&p), room = (double)t.steps[0].distance - (double)hit.touching / 2;
        P n = { (double)t.steps[0].normal.x, (double)t.steps[0].normal.y };
        Bounds lo = bounds_of(&p, n, room - 2 * eta), hi = bounds_of(&p, n, room + 2 * eta);
        double want[WF_ADVANCE_KINDS][2] = { { lo.plain, hi.plain }, { lo.along, hi.along }, { lo.disc, hi.disc }, { lo.curve, hi.curve } };
        for (int how = 0; how < WF_ADVANCE_KINDS; how++) {
            double slack = 64 * (double)WF_EPSILON * (1 + fmin(want[how][1], 1));
            assert_true(got[how] >= fmin(want[how][0], 1) * (1 - 1e-4) - slack);
            assert_true(got[how] <= fmin(want[how][1], 1) * (1 + 1e-4) + slack);
        }
        tried++;
        disc += lo.disc > hi.along * 1.01;
        better += lo.curve > hi.disc * 1.01;
    }
    assert_true(tried > 2000 && disc > 200 && better > 200);
}

/* ---- closed forms ---- */

static void assert_between(double got, double lo, double hi)
{
    if (got >= lo && got <= hi) return;
    print_error("%.17g is not in [%.17g, %.17g]\n", got, lo, hi);
    fail();
}

TEST(test_circle_against_wall)
{
    static const double speeds[] = { 1, 30, 1e3, 1e5 };
    static const double walls[] = { 0.001, 0.01, 1 };
    for (int i = 0; i < 4; i++) for (int k = 0; k < 3; k++) for (int far = 0; far < 2; far++) {
        double v = speeds[i] / 60, w = walls[k], rad = 0.01, x0 = far ? 5000 : 0;
        Pair p = { .a = circle(0, 0, rad), .b = box(w / 2, 2) };
        double from = x0 - w / 2 - rad - 0.4 * v;
        p.sa = (wfSweep){ wfV2((wfReal)from, WF_R(0.3)), wfV2((wfReal)(from + v + w), WF_R(0.3)), 0, 700 };
        p.sb = wfSweepStill(wfV2((wfReal)x0, 0), 0);
        wfImpact hit = check_impact(&p, 100, NULL);
        double eta = noise_of(&p), near = (double)hit.touching;
        double travel = (double)p.sa.to.x - (double)p.sa.from.x;
        double gap0 = (double)p.sb.from.x - (double)p.sa.from.x - (double)p.b.vertices[1].x - (double)p.a.radius;
        assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
        assert_between((double)hit.t, (gap0 - near - eta) / travel, (gap0 - near / 2 + eta) / travel);
        assert_true(hit.steps <= 3);
        assert_near2(hit.normal, wfV2(1, 0), 1e-5);
        assert_near(hit.point.x, (double)p.sb.from.x - w / 2 - (double)hit.distance / 2, 2 * eta + 8 * (double)WF_EPSILON * fabs(x0));
        assert_near(hit.point.y, 0.3, 2 * eta);
        assert_near(near, fmin(fmax(0.01 / 256, 4 * eta), fmax(gap0 / 2, 4 * eta)), 1e-5 * near + 1e-3 * eta);
    }
}

/* |c + s v| = R, the smaller root in double; -1: none */
static double circles_meet(P c, P v, double R)
{
    double a = dot(v, v), b = dot(c, v), q = dot(c, c) - R * R, root = b * b - a * q;
    return root < 0 ? -1 : (-b - sqrt(root)) / a;
}

TEST(test_two_circles)
{
    wfRandom r = random_stream(2105);
    long touched = 0, grazed = 0;
    for (int i = 0; i < 4000; i++) {
        Pair p = random_pair(&r, 4, 30);
        p.a = circle(0, 0, (double)wfRandomReal(&r, WF_R(0.05), 1));
        p.b = circle(0, 0, (double)wfRandomReal(&r, WF_R(0.05), 1));
        if (i % 3 == 0) scale_pair(&p, i % 2 ? 1e-3 : 1e3);
        P c = { (double)p.sb.from.x - (double)p.sa.from.x, (double)p.sb.from.y - (double)p.sa.from.y };
        P e = { (double)p.sb.to.x - (double)p.sa.to.x, (double)p.sb.to.y - (double)p.sa.to.y };
        P v = sub(e, c);
        double R = (double)p.a.radius + (double)p.b.radius, eta = noise_of(&p);
        if (size(c) < R + 5 * eta) continue;
        wfImpact hit;
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &hit));
        double near = (double)hit.touching;
        double early = circles_meet(c, v, R + near + eta), late = circles_meet(c, v, R + near / 2 - eta);
        bool may = early >= 0 && early <= 1, must = late >= 0 && late <= 1;
        assert_true(hit.kind == WF_IMPACT_TOUCH || hit.kind == WF_IMPACT_APART);
        if (must) assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
        if (!may && size(c) > R + near + eta) assert_int_equal(hit.kind, WF_IMPACT_APART);
        grazed += may && !must;
        if (hit.kind != WF_IMPACT_TOUCH) continue;
        touched++;
        assert_between((double)hit.t, early - 1e-5, must ? late + 1e-5 : 1);
        P at = { c.x + (double)hit.t * v.x, c.y + (double)hit.t * v.y };
        assert_near(hit.normal.x, at.x / size(at), 4 * eta / R + 1e-5);
        assert_near(hit.normal.y, at.y / size(at), 4 * eta / R + 1e-5);
    }
    assert_true(touched > 400 && grazed < 40);
}

/* A rod of half length L and half thickness h turns about its middle; a peg stands at R. They touch where the rod's middle line
   is asin((h + rho) / R) before the peg's direction. */
TEST(test_spinning_rod)
{
    wfRandom r = random_stream(2106);
    for (int i = 0; i < 500; i++) {
        double h = (double)wfRandomReal(&r, WF_R(0.01), WF_R(0.1)), rho = (double)wfRandomReal(&r, WF_R(0.01), WF_R(0.1));
        double R = (double)wfRandomReal(&r, WF_R(0.4), WF_R(0.85)), peg = (double)random_angle(&r);
        Pair p = { .a = box(1, h), .b = circle(0, 0, rho) };
        double turn = (i % 2 ? 1 : -1) * (i % 4 < 2 ? 3.2 : i % 8 < 6 ? 20 : 300), start = (double)random_angle(&r);
        wfVec2 place = wfV2(3, (wfReal)(i % 3));
        p.sa = (wfSweep){ place, place, (wfReal)start, (wfReal)(start + turn) };
        p.sb = wfSweepStill(wfAdd(place, wfV2((wfReal)(R * cos(peg)), (wfReal)(R * sin(peg)))), 1);
        wfImpact hit = check_impact(&p, 200, NULL);
        double eta = noise_of(&p), near = (double)hit.touching;
        double way = fmod((peg - start) * (turn > 0 ? 1 : -1) + 20 * 3.14159265358979, 3.14159265358979);
        double half = asin((h + rho + near / 2 - eta) / R), wide = asin((h + rho + near + eta) / R);
        if (hit.t <= 0 || way < wide || way > 3.14159265358979 - wide) continue;     /* begins at the peg */
        double angle = (double)hit.t * fabs(turn), slip = 1e-4;
        assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
        assert_between(angle, way - wide - slip, way - half + slip);
    }
}

/* A rod that reaches its peg nowhere is done by the circle that it stays in; one that spins hundreds of times, too. */
TEST(test_many_turns)
{
    static const double turns[] = { 1, 7, 100, 5000 };
    for (int i = 0; i < 4; i++) {
        Pair p = { .a = box(1, 0.1), .b = box(2, 0.5) };
        wfImpact hit;
        p.sa = (wfSweep){ wfV2(-1, WF_R(1.7)), wfV2(1, WF_R(1.7)), WF_R(0.4), (wfReal)(0.4 + turns[i]) };   /* reach 1.005 < 1.2 */
        p.sb = wfSweepStill(wfV2(0, 0), 0);
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &hit));
        assert_int_equal(hit.kind, WF_IMPACT_APART);
        assert_int_equal(hit.steps, 2);
        p.sa.to.y = WF_R(1.2);                     /* comes down: the tip must be stopped at the first pass below 1.5 */
        check_impact(&p, 2000, NULL);
        p.sa.from.y = p.sa.to.y = WF_R(1.45);      /* within reach from the beginning: stopped in the first half turn */
        p.sa.angleFrom = 0;
        hit = check_impact(&p, 2000, NULL);
        if (turns[i] > 3.2) assert_true(hit.kind == WF_IMPACT_TOUCH && (double)hit.t * turns[i] < 3.2);
    }
}

TEST(test_bullets_do_not_tunnel)
{
    wfRandom r = random_stream(2107);
    Tally tally = { { 0 }, 0, 0 };
    for (int i = 0; i < 600; i++) {
        double travel = pow(10, 1 + 2.2 * (i % 11) / 10), wall = 0.005;     /* up to 1585 m in a step: 95 km/s at 60 Hz */
        Pair p = { .b = box(wall, 3) };
        p.a = i % 3 == 0 ? circle(0, 0, 0.01) : i % 3 == 1 ? box(0.02, 0.01) : scaled(random_shape(&r), 0.02);
        double share = 0.1 + 0.8 * (wfRandomU32(&r) * 0x1p-32), slope = (i % 5) * 0.2 - 0.4, reach = 0.1;
        double way = travel / sqrt(1 + slope * slope), x0 = -share * way - reach;
        p.sa.from = wfV2((wfReal)x0, (wfReal)(slope * x0));
        p.sa.to = wfV2((wfReal)(x0 + way + 2 * reach), (wfReal)(slope * (x0 + way + 2 * reach)));
        p.sa.angleFrom = random_angle(&r);
        p.sa.angleTo = p.sa.angleFrom + (i % 4 == 0 ? 0 : i % 4 == 1 ? 1 : i % 4 == 2 ? 30 : 600);
        p.sb = wfSweepStill(wfV2(0, 0), 0);
        wfImpact hit = check_impact(&p, 50, &tally);
        double eta = noise_of(&p);
        assert_true(hit.kind != WF_IMPACT_APART);
        Outline o = outline_at(&p.a, p.sa, (double)hit.t, (P){ 0, 0 });
        for (int k = 0; k < o.n; k++) assert_true(o.v[k].x + o.radius < -wall + eta);       /* all of it is before the wall */
        assert_true(hit.kind == WF_IMPACT_UNFINISHED || (double)hit.distance <= fmax(0.05 / 256, 4 * eta) + eta);
    }
    assert_true(tally.kinds[WF_IMPACT_TOUCH] > 590);
}

/* Two rods that spin many times and miss each other: the search gives up, says so, and what it says is true. */
TEST(test_unfinished_is_honest)
{
    wfRandom r = random_stream(2111);
    long open = 0, touched = 0;
    for (int i = 0; i < 1500; i++) {
        Pair p = random_pair(&r, 3, 200);
        p.a = p.b = box(1, 0.05);
        wfImpact hit, next;
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &hit));
        if (hit.kind != WF_IMPACT_UNFINISHED) continue;
        open++;
        assert_true(hit.t > 0 && hit.t < 1 && hit.steps == WF_IMPACT_STEPS);
        check_impact(&p, 4000, NULL);
        for (int k = 0; k < 40 && hit.kind == WF_IMPACT_UNFINISHED; k++) {      /* asked again from there, it goes on */
            Pair q = p;
            q.sa.from = wfSweepAt(p.sa, hit.t).p, q.sb.from = wfSweepAt(p.sb, hit.t).p;
            q.sa.angleFrom += hit.t * (p.sa.angleTo - p.sa.angleFrom), q.sb.angleFrom += hit.t * (p.sb.angleTo - p.sb.angleFrom);
            assert_ok(wfTimeOfImpact(&q.a, q.sa, &q.b, q.sb, &next));
            assert_true(next.kind != WF_IMPACT_OVERLAP && next.t > 0);
            p = q;
            hit = next;
        }
        assert_true(hit.kind == WF_IMPACT_TOUCH || hit.kind == WF_IMPACT_APART);
        touched += hit.kind == WF_IMPACT_TOUCH;
    }
    assert_true(open > 10 && touched > 5);
}

/* ---- the beginning of the motion ---- */

TEST(test_overlap_at_the_beginning)
{
    wfShape a = box(1, 1), b = circle(0, 0, 0.5), c = box(0.2, 0.2);
    wfSweep still = wfSweepStill(wfV2(0, 0), 0);
    wfSweep deep = { wfV2(WF_R(1.2), 0), wfV2(9, 0), 0, 3 }, inside = { wfV2(0, 0), wfV2(9, 0), 0, 3 };
    wfImpact hit;
    assert_ok(wfTimeOfImpact(&a, still, &b, deep, &hit));
    assert_true(hit.kind == WF_IMPACT_OVERLAP && hit.t == 0 && hit.distance == 0 && hit.steps == 1);
    assert_near2(hit.normal, wfV2(0, 0), 0);
    assert_true(wfShapeContains(&a, wfSweepAt(still, 0), hit.point));
    assert_ok(wfTimeOfImpact(&a, still, &c, inside, &hit));
    assert_true(hit.kind == WF_IMPACT_OVERLAP && hit.t == 0);
    wfSweep touching = { wfV2(WF_R(1.5), 0), wfV2(9, 0), 0, 0 };
    assert_ok(wfTimeOfImpact(&a, still, &b, touching, &hit));
    assert_true(hit.kind == WF_IMPACT_OVERLAP || hit.kind == WF_IMPACT_TOUCH);
    assert_true(hit.t == 0);
}

TEST(test_near_bodies_may_move)
{
    wfShape floor = box(10, 1), crate = box(0.5, 0.5), ball = circle(0, 0, 0.5);
    wfSweep still = wfSweepStill(wfV2(0, -1), 0);
    wfImpact hit;
    for (int i = 0; i < 12; i++) {
        double gap = 0.5 * pow(2, -8 - i);                          /* from the wanted gap down to 0.5 micrometres */
        Pair p = { .a = floor, .b = i % 2 ? crate : ball, .sa = still };
        wfReal y = (wfReal)(0.5 + gap);
        p.sb = (wfSweep){ wfV2(-5, y), wfV2(5, y), 0, 0 };          /* slides */
        double eta = noise_of(&p), d0 = (double)y - 0.5;
        if (d0 < 5 * eta) break;
        hit = check_impact(&p, 50, NULL);
        assert_int_equal(hit.kind, WF_IMPACT_APART);
        assert_near(hit.touching, fmin(d0 / 2, (double)wfShapeMaxExtent(&p.b) / 256), 2 * eta);
        p.sb.to.y = y + 1;                                          /* leaves */
        hit = check_impact(&p, 50, NULL);
        assert_int_equal(hit.kind, WF_IMPACT_APART);
        p.sb.to.y = y - 1;                                          /* comes: until half of the gap is used up */
        hit = check_impact(&p, 50, NULL);
        assert_true(hit.kind == WF_IMPACT_TOUCH && hit.t > 0);
        assert_between((double)hit.t, d0 - (double)hit.touching - eta, d0 - (double)hit.touching / 2 + eta);
    }
}

TEST(test_grazing)
{
    wfShape wall = box(1, 1), ball = circle(0, 0, 0.5);
    wfSweep still = wfSweepStill(wfV2(0, 0), 0);
    for (int i = -20; i <= 20; i++) {
        double near = 0.5 / 256, height = 1.5 + near * (0.75 + 0.05 * i);
        Pair p = { .a = wall, .b = ball, .sa = still };
        p.sb = (wfSweep){ wfV2(-4, (wfReal)height), wfV2(4, (wfReal)height), 0, 9 };
        wfImpact hit = check_impact(&p, 100, NULL);
        if (i >= 6) assert_int_equal(hit.kind, WF_IMPACT_APART);
        if (i <= -6) assert_int_equal(hit.kind, WF_IMPACT_TOUCH);
        if (hit.kind == WF_IMPACT_TOUCH) assert_true(hit.t > WF_R(0.3) && hit.t < WF_R(0.5));
    }
}

/* ---- symmetries ---- */

static Pair swapped(Pair p) { return (Pair){ p.b, p.a, p.sb, p.sa }; }

TEST(test_symmetries)
{
    wfRandom r = random_stream(2108);
    long same = 0, all = 0;
    for (int i = 0; i < 500; i++) {
        Pair p = random_pair(&r, 4, i % 2 ? 0.5 : 4);
        wfImpact hit = check_impact(&p, 60, NULL), again, other;
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &again));
        assert_memory_equal(&hit, &again, sizeof hit);              /* the same bits */
        Pair q = swapped(p);
        other = check_impact(&q, 60, NULL);
        assert_int_equal(other.kind, hit.kind);
        all++;
        if (fabs((double)other.t - (double)hit.t) < 1e-4) {
            same++;
            if (hit.kind != WF_IMPACT_OVERLAP && hit.distance > WF_R(1e-3))
                assert_near(wfDot(other.normal, hit.normal), -1, 1e-2);
        }
        wfVec2 train = random_v2(&r, -10, 10);                      /* both ride on it */
        Pair g = p;
        g.sa.to = wfAdd(g.sa.to, train);
        g.sb.to = wfAdd(g.sb.to, train);
        other = check_impact(&g, 60, NULL);
        assert_int_equal(other.kind, hit.kind);
        same += fabs((double)other.t - (double)hit.t) < 1e-4;
        Pair far = p;                                               /* whole binary steps: nothing is rounded away */
        scale_pair(&far, 1024);
        other = check_impact(&far, 60, NULL);
        assert_int_equal(other.kind, hit.kind);
        same += fabs((double)other.t - (double)hit.t) < 1e-5;
        assert_int_equal(other.steps, hit.steps);
    }
    assert_true((double)same > 2.95 * (double)all);
}

static wfVec2 on_grid(wfVec2 v) { return wfV2(wfFloor(v.x * 512) / 512, wfFloor(v.y * 512) / 512); }

/* 8 km from the origin all digits of the answer are the same: places on a grid that floats still hold out there */
TEST(test_far_from_the_origin)
{
    wfRandom r = random_stream(2112);
    wfVec2 offset = wfV2(8192, -4096);
    for (int i = 0; i < 300; i++) {
        Pair p = random_pair(&r, 5, 2), far;
        wfVec2 *near[4] = { &p.sa.from, &p.sa.to, &p.sb.from, &p.sb.to };
        for (int k = 0; k < 4; k++) *near[k] = on_grid(*near[k]);
        far = p;
        wfVec2 *moved[4] = { &far.sa.from, &far.sa.to, &far.sb.from, &far.sb.to };
        for (int k = 0; k < 4; k++) *moved[k] = wfAdd(*near[k], offset);
        wfImpact a, b;
        assert_ok(wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &a));
        assert_ok(wfTimeOfImpact(&far.a, far.sa, &far.b, far.sb, &b));
        assert_ulps2(b.point, wfAdd(a.point, offset), 4, 8192);
        b.point = a.point;
        assert_memory_equal(&a, &b, sizeof a);
    }
}

/* Played backwards, a flight that touches nothing still touches nothing, and one through a body stops on the other side. */
TEST(test_time_reversal)
{
    wfRandom r = random_stream(2109);
    for (int i = 0; i < 400; i++) {
        Pair p = random_pair(&r, 5, 2), back = p;
        back.sa = (wfSweep){ p.sa.to, p.sa.from, p.sa.angleTo, p.sa.angleFrom };
        back.sb = (wfSweep){ p.sb.to, p.sb.from, p.sb.angleTo, p.sb.angleFrom };
        wfImpact hit = check_impact(&p, 60, NULL), rev = check_impact(&back, 60, NULL);
        if (hit.kind == WF_IMPACT_APART && distance_at(&p, 1) > 0.02) assert_int_equal(rev.kind, WF_IMPACT_APART);
        if (hit.kind == WF_IMPACT_TOUCH && rev.kind == WF_IMPACT_TOUCH) assert_true((double)hit.t <= 1 - (double)rev.t + 1e-3);
    }
    Pair p = { .a = circle(0, 0, 1), .b = box(1, 1) };              /* a flight that is its own mirror image */
    p.sa = (wfSweep){ wfV2(-4, WF_R(1.9)), wfV2(4, WF_R(1.9)), 0, 0 };
    p.sb = wfSweepStill(wfV2(0, 0), 0);
    wfImpact hit = check_impact(&p, 60, NULL), rev;
    p.sa = (wfSweep){ wfV2(4, WF_R(1.9)), wfV2(-4, WF_R(1.9)), 0, 0 };
    rev = check_impact(&p, 60, NULL);
    assert_near(rev.t, hit.t, 1e-6);
    assert_near(rev.normal.x, -hit.normal.x, 1e-5);
    assert_near(rev.normal.y, hit.normal.y, 1e-5);
}

/* ---- particles, links, segments ---- */

TEST(test_particles_and_links)
{
    wfShape none, ball = circle(0, 0, 0.25), link, segment;
    memset(&none, 0, sizeof none);
    wfImpact hit;
    wfSweep still = wfSweepStill(wfV2(0, 0), 0), down = { wfV2(0, 2), wfV2(0, -2), 0, 0 }, up = { wfV2(0, -2), wfV2(0, 2), 0, 0 };
    assert_ok(wfTimeOfImpact(&none, still, &ball, down, &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.t == 1 && hit.steps == 1);
    assert_near(hit.distance, 1.75, 1e-6);
    assert_ok(wfTimeOfImpact(&ball, down, &none, still, &hit));
    assert_true(hit.kind == WF_IMPACT_APART && hit.t == 1);
    assert_ok(wfMakeLink(wfV2(3, 0), wfV2(1, 0), wfV2(-1, 0), wfV2(-3, 0), &link));     /* from right to left: up is outside */
    assert_ok(wfMakeSegment(wfV2(1, 0), wfV2(-1, 0), &segment));
    for (int k = 0; k < 4; k++) {
        const wfShape *line = k % 2 ? &segment : &link;
        bool fromAbove = k < 2, open = line == &link && !fromAbove;
        wfSweep way = fromAbove ? down : up;
        wfReal half = WF_PI / 2;                                                        /* the same, turned and moved */
        wfSweep side = { wfV2(fromAbove ? 8 : 12, 5), wfV2(fromAbove ? 12 : 8, 5), 0, 1 }, turned = wfSweepStill(wfV2(10, 5), half);
        wfImpact hits[4];
        assert_ok(wfTimeOfImpact(line, still, &ball, way, &hits[0]));
        assert_ok(wfTimeOfImpact(&ball, way, line, still, &hits[1]));
        assert_ok(wfTimeOfImpact(line, turned, &ball, side, &hits[2]));
        assert_ok(wfTimeOfImpact(&ball, side, line, turned, &hits[3]));
        for (int h = 0; h < 4; h++) {
            assert_int_equal(hits[h].kind, open ? WF_IMPACT_APART : WF_IMPACT_TOUCH);
            if (open) assert_true(hits[h].t == 1 && hits[h].steps == 1);
            else assert_near(hits[h].t, 1.75 / 4, 2e-3);
        }
    }
}

/* Which side a shape is on is told by its centre, at the beginning, also close to the line and for links far from their body's origin. */
TEST(test_sides_of_a_link)
{
    wfShape link, ball = circle(0.5, 0, 0.1);
    assert_ok(wfMakeLink(wfV2(4, 3), wfV2(2, 3), wfV2(-2, 3), wfV2(-4, 3), &link));         /* outside is +y */
    for (int k = 0; k < 8; k++) {
        double angle = k / 2 * 1.5707963267948966, side = k % 2 ? 1 : -1, c = cos(angle), s = sin(angle);
        double x = 7, y = -2, off = 0.15 * side, ox = -s * (3 + off) - 0.5, oy = c * (3 + off);  /* the ball's centre is 0.15 off the line */
        wfSweep at_ = wfSweepStill(wfV2((wfReal)x, (wfReal)y), (wfReal)angle);
        wfSweep move = { wfV2((wfReal)(x + ox), (wfReal)(y + oy)), wfV2((wfReal)(x + ox + s * 2 * side), (wfReal)(y + oy - c * 2 * side)), 0, 0 };
        wfImpact hit[2];
        assert_ok(wfTimeOfImpact(&link, at_, &ball, move, &hit[0]));
        assert_ok(wfTimeOfImpact(&ball, move, &link, at_, &hit[1]));
        for (int h = 0; h < 2; h++) {
            assert_int_equal(hit[h].kind, side > 0 ? WF_IMPACT_TOUCH : WF_IMPACT_APART);
            if (side > 0) assert_near(2 * (double)hit[h].t, 0.05, 1e-3);
        }
    }
}

/* ---- bad input ---- */

#define UNCHANGED(result, call) do { wfImpact out_, before_; memset(&out_, 0x5a, sizeof out_); before_ = out_; wfImpact *out = &out_; \
    assert_result(result, call); assert_memory_equal(&out_, &before_, sizeof out_); } while (0)

TEST(test_bad_input)
{
    wfShape a = box(1, 1), b = circle(0, 0, 1), bad = a;
    wfSweep s = { wfV2(0, 0), wfV2(1, 0), 0, 1 }, t = { wfV2(5, 0), wfV2(4, 0), 0, 1 };
    wfImpactTrace trace;
    UNCHANGED(WF_ERROR_NULL, wfTimeOfImpact(NULL, s, &b, t, out));
    UNCHANGED(WF_ERROR_NULL, wfTimeOfImpact(&a, s, NULL, t, out));
    assert_result(WF_ERROR_NULL, wfTimeOfImpact(&a, s, &b, t, NULL));
    UNCHANGED(WF_ERROR_NULL, wfTraceImpact(NULL, s, &b, t, 0, out, &trace));
    UNCHANGED(WF_ERROR_NULL, wfTraceImpact(&a, s, NULL, t, 0, out, &trace));
    UNCHANGED(WF_ERROR_NULL, wfTraceImpact(&a, s, &b, t, 0, out, NULL));
    assert_result(WF_ERROR_NULL, wfTraceImpact(&a, s, &b, t, 0, NULL, &trace));
    UNCHANGED(WF_ERROR_RANGE, wfTraceImpact(&a, s, &b, t, -1, out, &trace));
    UNCHANGED(WF_ERROR_RANGE, wfTraceImpact(&a, s, &b, t, WF_ADVANCE_KINDS, out, &trace));
    for (int i = 0; i < BAD_REAL_COUNT; i++) for (int k = 0; k < 6; k++) {
        wfSweep w = s;
        wfReal *fields[6] = { &w.from.x, &w.from.y, &w.to.x, &w.to.y, &w.angleFrom, &w.angleTo };
        *fields[k] = BAD_REALS[i];
        UNCHANGED(WF_ERROR_NOT_FINITE, wfTimeOfImpact(&a, w, &b, t, out));
        UNCHANGED(WF_ERROR_NOT_FINITE, wfTimeOfImpact(&a, t, &b, w, out));
    }
    static const int32_t kinds[] = { -1, WF_SHAPE_KINDS, 1000 };
    for (int i = 0; i < 3; i++) {
        bad.kind = kinds[i];
        UNCHANGED(WF_ERROR_UNKNOWN, wfTimeOfImpact(&bad, s, &b, t, out));
        UNCHANGED(WF_ERROR_UNKNOWN, wfTimeOfImpact(&b, s, &bad, t, out));
    }
    wfReal over = WF_MAX_ANGLE * WF_R(1.001), ok = WF_MAX_ANGLE;
    for (int k = 0; k < 4; k++) {
        wfSweep w = s;
        wfReal *angle = k % 2 ? &w.angleTo : &w.angleFrom;
        *angle = k < 2 ? over : -over;
        UNCHANGED(WF_ERROR_RANGE, wfTimeOfImpact(&a, w, &b, t, out));
        UNCHANGED(WF_ERROR_RANGE, wfTimeOfImpact(&a, t, &b, w, out));
        *angle = k < 2 ? ok : -ok;
        wfImpact hit;
        assert_ok(wfTimeOfImpact(&a, w, &b, t, &hit));
    }
    wfImpact hit;
    for (int k = 0; k < 2; k++) {
        wfSweep w = t;
        wfVec2 *end = k ? &w.to : &w.from;
        *end = wfV2(0, WF_IMPACT_FAR * WF_R(1.001));
        UNCHANGED(WF_ERROR_RANGE, wfTimeOfImpact(&a, s, &b, w, out));
        *end = wfV2(0, WF_IMPACT_FAR * WF_R(0.999));
        assert_ok(wfTimeOfImpact(&a, s, &b, w, &hit));
        assert_true(wfIsFinite(hit.t) && wfIsFinite(hit.distance) && wfIsFinite2(hit.normal) && wfIsFinite2(hit.point));
    }
    wfSweep left = wfSweepStill(wfV2(-WF_HUGE, 0), 0), right = wfSweepStill(wfV2(WF_HUGE, 0), 0);
    UNCHANGED(WF_ERROR_NOT_FINITE, wfTimeOfImpact(&a, left, &b, right, out));
    left.from = right.from;                                         /* beside each other first, then apart too far */
    UNCHANGED(WF_ERROR_NOT_FINITE, wfTimeOfImpact(&a, left, &b, right, out));
}

/* Whatever finite motion is asked for, the answer is finite, and an error leaves nothing behind. */
TEST(test_wild_numbers)
{
    wfRandom r = random_stream(2110);
    long fine = 0;
    for (int i = 0; i < 20000; i++) {
        Pair p = random_pair(&r, 1, 1);
        wfReal *fields[12] = { &p.sa.from.x, &p.sa.from.y, &p.sa.to.x, &p.sa.to.y, &p.sa.angleFrom, &p.sa.angleTo,
                               &p.sb.from.x, &p.sb.from.y, &p.sb.to.x, &p.sb.to.y, &p.sb.angleFrom, &p.sb.angleTo };
        for (int k = 0; k < 12; k++) if (wfRandomBelow(&r, 3) == 0) *fields[k] = random_wide(&r, k % 6 < 4 ? 120 : 19);
        if (i % 3 == 0) for (int k = 0; k < 12; k++) *fields[k] = random_wide(&r, 20);
        wfImpact hit, before;
        memset(&hit, 0x5a, sizeof hit);
        before = hit;
        wfResult result = wfTimeOfImpact(&p.a, p.sa, &p.b, p.sb, &hit);
        if (result != WF_OK) {
            assert_memory_equal(&hit, &before, sizeof hit);
            assert_true(result == WF_ERROR_RANGE || result == WF_ERROR_NOT_FINITE);
            continue;
        }
        fine++;
        assert_true(hit.t >= 0 && hit.t <= 1 && hit.distance >= 0 && hit.touching > 0 && hit.steps >= 1 && hit.steps <= WF_IMPACT_STEPS);
        assert_true(wfIsFinite(hit.distance) && wfIsFinite(hit.touching) && wfIsFinite2(hit.normal) && wfIsFinite2(hit.point));
    }
    assert_true(fine > 5000);
}
