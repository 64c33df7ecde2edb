/* The report's listing compiles and runs; every name of its Appendices B and C is there and
 * does what the appendix says. */
#include "testing.h"
#include "weft/report.h"
#include "weft/inspect.h"

/* ------------------------------------------------------------------------------ Appendix B, line by line */

TEST(appendix_b_runs_as_it_is_printed)
{
    /* B.1 */
    physics_world World = CreateWorld();
    /* B.2 */
    poly_body Body = MakePolyBody(V2(20, 20), 0.5, 45.0f);
    poly_body Body2 = MakePolyBody(V2(10, 10), 10);
    Body2->Transform = MakeTransformDeg(V2(20, 30), 30);
    poly_body Body3 = MakePolyBody(V2(10, 10), 300);
    /* B.3 */
    AddBodyToWorld(&World, &Body);
    //Create an array that contains Body2 and Body3
    poly_body *BodyArray[2] = {&Body2,&Body3};
    int32 NumOfBodiesInArray = 2;
    AddBodyToWorld(&World, &BodyArray, NumOfBodiesInArray);
    /* B.4 */
    StepWorld(World);

    /* What the appendix says of them. */
    assert_int_equal(wfBodyCount(&World), 3);
    assert_near(wfWorldTime(&World), 1.0 / 30, 1e-8);
    wfBodyInfo Info;
    assert_ok(wfGetBody(&World, Body->Id, &Info));
    assert_ulps(Info.mass, 0.5, 1, 1);
    assert_ulps(Info.inertia, 0.5 * (20 * 20 + 20 * 20) / 12, 32, 34);   /* full width and height */
    assert_ok(wfGetBody(&World, Body2->Id, &Info));
    assert_ulps(Info.mass, 10, 1, 10);
    assert_ok(wfGetBody(&World, Body3->Id, &Info));
    assert_ulps(Info.mass, 300, 1, 300);
    DestroyWorld(&World);
    assert_null(World.memory.permanent);
}

TEST(the_bodies_are_where_the_appendix_puts_them)
{
    physics_world World = CreateWorld();
    poly_body Body = MakePolyBody(V2(20, 20), 0.5, 45.0f);
    poly_body Body2 = MakePolyBody(V2(10, 10), 10);
    Body2->Transform = MakeTransformDeg(V2(20, 30), 30);
    assert_ok(AddBodyToWorld(&World, &Body));
    assert_ok(AddBodyToWorld(&World, &Body2));
    wfBodyInfo Info;
    assert_ok(wfGetBody(&World, Body->Id, &Info));
    assert_near2(Info.position, V2(0, 0), 0);
    assert_ulps(Info.angle, 0.78539816339744831, 4, 1);
    assert_ulps(Info.linearDamping, 0.35, 1, 1);
    assert_ulps(Info.angularDamping, 0.9, 1, 1);
    assert_ok(wfGetBody(&World, Body2->Id, &Info));
    assert_near2(Info.position, V2(20, 30), 0);
    assert_ulps(Info.angle, 0.52359877559829887, 4, 1);
    DestroyWorld(&World);
}

TEST(a_body_falls_and_is_read_back)
{
    physics_world World = CreateWorld((real32)0.01);
    poly_body Body = MakePolyBody(V2(1, 1), 2, 0, 0, 0);       /* no damping: the parabola */
    Body->Transform = MakeTransformDeg(V2(3, 100), 90);
    Body->Velocity = V2(1, 2);
    Body->AngularVelocity = (real32)0.5;
    assert_ok(AddBodyToWorld(&World, &Body));
    for (int i = 0; i < 100; i++) assert_ok(i % 2 == 0 ? StepWorld(World) : StepWorld(&World));
    assert_int_equal(wfWorldSteps(&World), 100);
    assert_ok(UpdateBody(&World, &Body));
    /* after 1 s; 100 steps of a few roundings of numbers about 100 */
    assert_near(Body->Transform.E13, 3 + 1, 100 * 4 * 4 * (double)WF_EPSILON);
    assert_near(Body->Transform.E23, 100 + 2 - 9.81 / 2, 100 * 4 * 100 * (double)WF_EPSILON);
    assert_near(Body->Velocity.Y, 2 - 9.81, 100 * 4 * 10 * (double)WF_EPSILON);
    assert_near(Body->Transform.E11, cos(1.5707963267948966 + 0.5), 1e-4);
    assert_near(Body->Transform.E21, sin(1.5707963267948966 + 0.5), 1e-4);
    assert_near(Body->AngularVelocity, 0.5, 0);
    assert_ok(RemoveBodyFromWorld(&World, &Body));
    assert_result(WF_ERROR_STALE_ID, UpdateBody(&World, &Body));
    assert_result(WF_ERROR_STALE_ID, RemoveBodyFromWorld(&World, &Body));
    DestroyWorld(&World);
}

TEST(default_arguments_and_their_replacements)
{
    poly_body A = MakePolyBody(V2(1, 2), 3);
    poly_body B = MakePolyBody(V2(1, 2), 3, 90);
    poly_body C = MakePolyBody(V2(1, 2), 3, 90, (real32)0.125);
    poly_body D = MakePolyBody(V2(1, 2), 3, 90, (real32)0.125, (real32)0.25);
    assert_true(A->Mass == 3 && A->Dimensions.X == 1 && A->Dimensions.Y == 2);
    for (int i = 0; i < 6; i++) assert_true(A->Transform.E[i] == Mat23().E[i]);
    assert_true(A->LinearDamping == WF_R(0.35) && A->AngularDamping == WF_R(0.9));
    assert_near(B->Transform.E21, 1, 1e-7);
    assert_true(B->LinearDamping == WF_R(0.35) && B->AngularDamping == WF_R(0.9));
    assert_true(C->LinearDamping == WF_R(0.125) && C->AngularDamping == WF_R(0.9));
    assert_true(D->LinearDamping == WF_R(0.125) && D->AngularDamping == WF_R(0.25));
    *A = MakePolyBodyValue(V2(5, 6), 7);                        /* an array cannot be assigned; what it holds can */
    assert_true(A->Mass == 7 && (&A)[0]->Dimensions.X == 5 && A[0].Dimensions.Y == 6);
}

TEST(bodies_come_in_four_kinds_of_array)
{
    physics_world World = CreateWorld();
    poly_body A = MakePolyBody(V2(1, 1), 1), B = MakePolyBody(V2(1, 1), 2);
    poly_body *Pointers[2] = { &A, &B };
    poly_body Bodies[2] = { MakePolyBody(V2(1, 1), 3), MakePolyBody(V2(1, 1), 4) };
    assert_ok(AddBodyToWorld(&World, &Pointers, 2));
    assert_ok(AddBodyToWorld(&World, Pointers, 2));
    assert_ok(AddBodyToWorld(&World, &Bodies, 2));
    assert_ok(AddBodyToWorld(&World, Bodies, 2));
    assert_ok(AddBodyToWorld(&World, Bodies, 0));
    assert_ok(AddBodyToWorld(&World, A));
    const double mass[] = { 1, 2, 1, 2, 3, 4, 3, 4, 1 };
    assert_int_equal(wfBodyCount(&World), 9);
    for (int i = 0; i < 9; i++) assert_near(wfWorldBodies(&World).props[i].mass, mass[i], 0);
    DestroyWorld(&World);
}

TEST(all_of_an_array_or_none)
{
    physics_world World = CreateWorld();
    poly_body A = MakePolyBody(V2(1, 1), 1), B = MakePolyBody(V2(1, -1), 2);
    poly_body *Pointers[3] = { &A, &B, NULL };
    uint64_t Before = wfHashWorld(&World);
    assert_int_not_equal(AddBodyToWorld(&World, &Pointers, 2), WF_OK);
    assert_int_equal(wfBodyCount(&World), 0);
    assert_int_equal(A->Id.index, 0);
    assert_true(wfHashWorld(&World) == Before);
    B->Dimensions = V2(1, 1);
    assert_result(WF_ERROR_NULL, AddBodyToWorld(&World, &Pointers, 3));
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Pointers, -1));
    assert_int_equal(wfBodyCount(&World), 0);
    assert_ok(AddBodyToWorld(&World, &Pointers, 2));
    DestroyWorld(&World);
}

TEST(what_the_report_leaves_open)
{
    /* 33.3 is milliseconds: refused, not simulated as half a minute a step */
    physics_world Wrong = CreateWorld((real32)33.3);
    assert_null(Wrong.memory.permanent);
    assert_result(WF_ERROR_NULL, StepWorld(Wrong));
    assert_result(WF_ERROR_NULL, StepWorld(&Wrong));
    poly_body Body = MakePolyBody(V2(1, 1), 1);
    assert_result(WF_ERROR_NULL, AddBodyToWorld(&Wrong, &Body));
    const real32 Bad[] = { 0, -1, (real32)NAN, (real32)INFINITY };
    for (int i = 0; i < 4; i++) {
        physics_world None = CreateWorld(Bad[i]);
        assert_null(None.memory.permanent);
        DestroyWorld(&None);
    }
    physics_world Slow = CreateWorld(1);                        /* a whole second is allowed */
    assert_non_null(Slow.memory.permanent);
    DestroyWorld(&Slow);
    physics_world World = CreateWorld();
    poly_body Wall = MakePolyBody(V2(1, 1), 0);                 /* mass 0: never moves */
    assert_ok(AddBodyToWorld(&World, &Wall));
    for (int i = 0; i < 10; i++) assert_ok(StepWorld(World));
    assert_ok(UpdateBody(&World, &Wall));
    assert_true(Wall->Transform.E13 == 0 && Wall->Transform.E23 == 0);
    DestroyWorld(&World);
    DestroyWorld(&World);
}

TEST(bad_bodies_are_refused)
{
    physics_world World = CreateWorld();
    for (int field = 0; field < 15; field++)
        for (int b = 0; b < BAD_REAL_COUNT; b++) {
            poly_body Body = MakePolyBody(V2(1, 1), 1);
            real32 *Place[] = { &Body->Transform.E11, &Body->Transform.E12, &Body->Transform.E13, &Body->Transform.E21,
                &Body->Transform.E22, &Body->Transform.E23, &Body->Dimensions.X, &Body->Dimensions.Y, &Body->Mass,
                &Body->LinearDamping, &Body->AngularDamping, &Body->Restitution, &Body->Velocity.X, &Body->Velocity.Y,
                &Body->AngularVelocity };
            *Place[field] = BAD_REALS[b];
            assert_int_not_equal(AddBodyToWorld(&World, &Body), WF_OK);
        }
    poly_body Scaled = MakePolyBody(V2(1, 1), 1);
    Scaled->Transform = Mat23(2, 0, 0, 0, 2, 0);                /* no rotation: a scaling */
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Scaled));
    Scaled->Transform = Mat23(1, 0, 0, 0, -1, 0);               /* nor a mirror */
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Scaled));
    Scaled->Transform = Mat23(1, 1, 0, 0, 1, 0);                /* nor a shear */
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Scaled));
    Scaled->Transform = Mat23(WF_R(0.95), 0, 0, 0, WF_R(0.95), 0);
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Scaled));
    Scaled->Transform = Mat23(WF_R(1.05), 0, 0, 0, WF_R(1.05), 0);
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Scaled));
    poly_body Light = MakePolyBody(V2(1, 1), -1);
    assert_int_not_equal(AddBodyToWorld(&World, &Light), WF_OK);
    poly_body Grows = MakePolyBody(V2(1, 1), 1, 0, -1);
    assert_result(WF_ERROR_RANGE, AddBodyToWorld(&World, &Grows));
    assert_result(WF_ERROR_NULL, AddBodyToWorld(&World, (poly_body *)NULL));
    assert_result(WF_ERROR_NULL, AddBodyToWorld((physics_world *)NULL, &Scaled));
    assert_result(WF_ERROR_NULL, AddBodyToWorld(&World, (poly_body **)NULL, 2));
    assert_result(WF_ERROR_NULL, UpdateBody(&World, NULL));
    assert_result(WF_ERROR_NULL, RemoveBodyFromWorld(&World, NULL));
    assert_int_equal(wfBodyCount(&World), 0);
    DestroyWorld(&World);
}

/* ------------------------------------------------------------------------------ Appendix C */

TEST(math_operations)
{
    assert_true(Square(3) == 9);
    assert_ulps(DegToRadians(180), 3.14159265358979324, 1, 4);
    assert_true(SquareRoot(16) == 4);
    assert_true(AbsoluteValue(-2) == 2);
    assert_ulps(Sin(1), 0.84147098480789651, 1, 1);
    assert_ulps(Cos(1), 0.54030230586813972, 1, 1);
    assert_ulps(ArcCos(0), 1.5707963267948966, 2, 2);
}

TEST(vectors)
{
    v2 a = V2(3, 4), b = V2(1, -2);
    v3 c = V3(1, 2, 2), d = V3(2, 0, 1);
    v4 e = V4(1, 1, 1, 1), f = V4(1, 2, 3, 4);
    assert_true(a.X == 3 && a.Y == 4 && a.E[0] == 3 && a.E[1] == 4);
    assert_true(f.X == 1 && f.E[3] == 4);
    assert_true(PerpCW(a).X == 4 && PerpCW(a).Y == -3 && PerpCCW(a).X == -4 && PerpCCW(a).Y == 3);
    assert_true(Inner(a, b) == -5 && Inner(c, d) == 4 && Inner(e, f) == 10);
    assert_true(LenSq(a) == 25 && LenSq(c) == 9 && LenSq(f) == 30);
    assert_true(Len_SLOW(a) == 5 && Len_SLOW(c) == 3 && Len_SLOW(e) == 2);
    assert_true(VectorFromTo(a, b).X == -2 && VectorFromTo(a, b).Y == -6);
    assert_true(VectorFromTo(c, d).X == 1 && VectorFromTo(c, d).Y == -2 && VectorFromTo(c, d).Z == -1);
    assert_true(VectorFromTo(e, f).W == 3);
    assert_near2(GetUnitVector(a), V2(WF_R(0.6), WF_R(0.8)), WF_EPSILON);
    assert_near(GetUnitVector(c).Z, 2.0 / 3, WF_EPSILON);
    assert_near(GetUnitVector(e).W, 0.5, WF_EPSILON);
    assert_true(DistanceSq(a, b) == 40 && DistanceSq(c, d) == 6 && DistanceSq(e, f) == 14);
    assert_true(Add(a, b).X == 4 && Sub(a, b).Y == 6 && Scale(2, a).Y == 8 && Add(c, d).Z == 3 && Sub(e, f).W == -3);
}

TEST(matrices)
{
    mat22 one = Mat22(), m = Mat22(1, 2, 3, 4);
    assert_true(one.E11 == 1 && one.E12 == 0 && one.E21 == 0 && one.E22 == 1);
    assert_true(m.E11 == 1 && m.E12 == 2 && m.E21 == 3 && m.E22 == 4 && m.E[2] == 3);
    assert_near(RotationMat22Deg(30).E21, 0.5, WF_EPSILON);
    assert_near(RotationMat22Deg(30).E12, -0.5, WF_EPSILON);
    assert_near(RotationMat22Rad(1).E11, 0.5403023058681398, WF_EPSILON);
    assert_near(AddRotationDeg(RotationMat22Deg(30), 60).E21, 1, 2 * WF_EPSILON);
    assert_near(AddRotationRad(RotationMat22Rad(1), 1).E11, -0.41614683654714241, 2 * WF_EPSILON);
    assert_near(Inverse(m).E11, -2, 8 * WF_EPSILON);
    assert_near(Inverse(m).E21, 1.5, 8 * WF_EPSILON);
    assert_true(Transpose(m).E12 == 3 && Transpose(m).E21 == 2);
    mat23 id = Mat23(), n = Mat23(1, 2, 3, 4, 5, 6);
    assert_true(id.E11 == 1 && id.E22 == 1 && id.E13 == 0 && id.E23 == 0 && id.E12 == 0 && id.E21 == 0);
    assert_true(n.E13 == 3 && n.E21 == 4 && n.E23 == 6 && n.E[5] == 6);
    assert_near(RotationMat23Deg(30).E21, 0.5, WF_EPSILON);
    assert_near(RotationMat23Rad(1).E11, 0.5403023058681398, WF_EPSILON);
    assert_near(AddRotationDeg(RotationMat23Deg(30), 60).E21, 1, 2 * WF_EPSILON);
    assert_near(AddRotationRad(RotationMat23Rad(1), 1).E11, -0.41614683654714241, 2 * WF_EPSILON);
    assert_true(MakeMat23(m).E21 == 3 && MakeMat23(m).E13 == 0 && MakeMat22(n).E21 == 4 && MakeMat22(n).E12 == 2);
}

TEST(transforms)
{
    assert_true(TranslationMat23(2, 3).E13 == 2 && TranslationMat23(2, 3).E23 == 3 && TranslationMat23(2, 3).E11 == 1);
    assert_true(TranslationMat23(V2(4, 5)).E13 == 4 && TranslationMat23(V2(4, 5)).E23 == 5);
    assert_true(TranslationMat23(V3(6, 7, 8)).E13 == 6 && TranslationMat23(V3(6, 7, 8)).E23 == 7);
    mat23 t = TranslationMat23(1, 1);
    assert_true(AddTranslation(t, 2, 3).E13 == 3 && AddTranslation(t, 2, 3).E23 == 4);
    assert_true(AddTranslation(t, V2(2, 3)).E13 == 3 && AddTranslation(t, V2(2, 3)).E23 == 4);
    assert_true(AddTranslation(t, V3(2, 3, 9)).E13 == 3 && AddTranslation(t, V3(2, 3, 9)).E23 == 4);
    mat23 a = MakeTransformDeg(V2(20, 30), 90), b = MakeTransformRad(V2(1, 0), 1);
    assert_true(a.E13 == 20 && a.E23 == 30);
    assert_near(a.E21, 1, WF_EPSILON);
    assert_near(b.E21, 0.84147098480789651, WF_EPSILON);
    mat23 ab = MakeTransform(a, b);                             /* (1,0) turned by a: (0,1); moved: (20,31) */
    assert_near(ab.E13, 20, 1e-5);
    assert_near(ab.E23, 31, 1e-5);
    mat23 back = MakeTransform(Inverse(a), a);
    for (int i = 0; i < 6; i++) assert_near(back.E[i], Mat23().E[i], 1e-5);
}

TEST(rectangles_and_circles)
{
    rectangle2 r = RectMinMax(V2(1, 2), V2(5, 8));
    assert_true(r.Min.X == 1 && r.Min.Y == 2 && r.Max.X == 5 && r.Max.Y == 8);
    assert_true(GetMinCorner(r).Y == 2 && GetMaxCorner(r).X == 5 && GetWidth(r) == 4 && GetHeight(r) == 6);
    assert_true(GetCenter(r).X == 3 && GetCenter(r).Y == 5);
    rectangle2 same[] = { RectMinDim(V2(1, 2), V2(4, 6)), RectCenterHalfDim(V2(3, 5), V2(2, 3)), RectCenterDim(V2(3, 5), V2(4, 6)) };
    for (int i = 0; i < 3; i++) assert_memory_equal(&same[i], &r, sizeof r);
    assert_true(IsInRectangle(r, V2(2, 7)) && !IsInRectangle(r, V2(0, 7)) && !IsInRectangle(r, V2(2, 9)));
    circle2 c = CircleCenterRadius(V2(1, 2), 3), d = CircleCenterDiameter(V2(1, 2), 6);
    assert_true(c.Center.X == 1 && c.Center.Y == 2 && c.Radius == 3 && GetRadius(d) == 3);
    assert_true(GetCenter(c).X == 1 && GetCenter(d).Y == 2);
    assert_true(IsInCircle(c, V2(3, 3)) && !IsInCircle(c, V2(4, 4)));
}
