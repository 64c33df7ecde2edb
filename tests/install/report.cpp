// What a user of the report's names writes in C++: the listing of its Appendix B as it is printed, then overloads, operators and
// default arguments. C++11 and later.
#include <cstdio>
#include <weft/report.h>

static int wrong(const char *what)
{
    std::printf("report.h in C++: %s\n", what);
    return 1;
}
static bool same(v2 a, v2 b) { return a.X == b.X && a.Y == b.Y; }
static bool close(real32 a, real32 b) { return AbsoluteValue(a - b) < WF_R(1e-5); }

static int listing()
{
    physics_world World = CreateWorld();
    poly_body Body = MakePolyBody(V2(20, 20), 0.5, 45.0f);
    poly_body Body2 = MakePolyBody(V2(10, 10), 10);
    Body2->Transform = MakeTransformDeg(V2(20, 30), 30);
    poly_body Body3 = MakePolyBody(V2(10, 10), 300);
    AddBodyToWorld(&World, &Body);
    poly_body *BodyArray[2] = {&Body2,&Body3};
    int32 NumOfBodiesInArray = 2;
    AddBodyToWorld(&World, &BodyArray, NumOfBodiesInArray);
    StepWorld(World);

    if (wfBodyCount(&World) != 3) return wrong("the listing does not make three bodies");
    if (UpdateBody(&World, &Body2) != WF_OK || !(Body2->Velocity.Y < 0)) return wrong("Body2 does not fall");
    if (!close(Body->LinearDamping, WF_R(0.35)) || !close(Body->AngularDamping, WF_R(0.9)) || !close(Body->Friction, WF_R(0.5)))
        return wrong("the defaults of MakePolyBody");
    if (StepWorld(&World) != WF_OK || wfWorldSteps(&World) != 2 || !close(wfWorldTime(&World), 2 / WF_R(30.0))) return wrong("steps of 1/30 s");
    if (RemoveBodyFromWorld(&World, &Body2) != WF_OK || UpdateBody(&World, &Body2) != WF_ERROR_STALE_ID) return wrong("RemoveBodyFromWorld");
    DestroyWorld(&World);
    return 0;
}

// Each form of an array, one body, and what is refused.
static int arrays()
{
    physics_world World = CreateWorld(WF_R(0.01)), None = CreateWorld(WF_R(33.3));
    poly_body A = MakePolyBody(V2(1, 1), 1), B = MakePolyBody(V2(1, 1), 2, 90, WF_R(0.125), WF_R(0.25));
    poly_body *Pointers[2] = { &A, &B };
    poly_body Bodies[2] = { MakePolyBody(V2(1, 1), 3), MakePolyBody(V2(1, 1), 4) };
    if (AddBodyToWorld(&World, &Pointers, 2) != WF_OK || AddBodyToWorld(&World, Pointers, 2) != WF_OK ||
        AddBodyToWorld(&World, &Bodies, 2) != WF_OK || AddBodyToWorld(&World, Bodies, 2) != WF_OK ||
        AddBodyToWorld(&World, A) != WF_OK || AddBodyToWorld(&World, &B) != WF_OK) return wrong("a form of AddBodyToWorld is refused");
    const real32 Mass[] = { 1, 2, 1, 2, 3, 4, 3, 4, 1, 2 };
    if (wfBodyCount(&World) != 10) return wrong("not ten bodies");
    wfBodyInfo Info;
    for (int32 i = 0; i < 10; i++) {
        if (wfGetBody(&World, wfBodyAt(&World, i), &Info) != WF_OK || !close(Info.mass, Mass[i])) return wrong("a body has another's mass");
    }
    if (!close(B->Transform.E21, 1) || !close(B->LinearDamping, WF_R(0.125)) || !close(B->AngularDamping, WF_R(0.25))) return wrong("MakePolyBody of five");
    *A = MakePolyBodyValue(V2(5, 6), 7);
    if (A->Mass != 7 || A->Dimensions.Y != 6) return wrong("MakePolyBodyValue");
    B->Dimensions = V2(1, -1);
    if (AddBodyToWorld(&World, &Pointers, 2) == WF_OK || wfBodyCount(&World) != 10) return wrong("an array with a bad body is added in part");
    if (StepWorld(None) != WF_ERROR_NULL || StepWorld(&None) != WF_ERROR_NULL) return wrong("a step of 33.3 s is made");
    DestroyWorld(&World);
    return 0;
}

static int numbers()
{
    v2 a = V2(3, 4), b = V2(1, -2);
    v3 c = V3(1, 2, 2), d = V3(2, 0, 1);
    v4 e = V4(1, 1, 1, 1), f = V4(1, 2, 3, 4);
    if (Inner(a, b) != -5 || Inner(c, d) != 4 || Inner(e, f) != 10) return wrong("Inner");
    if (LenSq(a) != 25 || LenSq(c) != 9 || LenSq(f) != 30 || Len_SLOW(a) != 5 || Len_SLOW(c) != 3 || Len_SLOW(e) != 2) return wrong("LenSq, Len_SLOW");
    if (!same(VectorFromTo(a, b), V2(-2, -6)) || VectorFromTo(c, d).Y != -2 || VectorFromTo(e, f).W != 3) return wrong("VectorFromTo");
    if (!close(GetUnitVector(a).Y, WF_R(0.8)) || !close(GetUnitVector(e).W, WF_R(0.5)) || DistanceSq(c, d) != 6) return wrong("GetUnitVector, DistanceSq");
    if (!same(a + b, Add(a, b)) || !same(a - b, Sub(a, b)) || !same(2 * a, Scale(2, a)) || !same(-a, V2(-3, -4))) return wrong("operators of the plane");
    if ((c + d).Z != 3 || (c - d).X != -1 || (WF_R(0.5) * f).W != 2 || (-d).Z != -1 || (e + f).E[3] != 5) return wrong("operators of space");
    mat22 m = Mat22(1, 2, 3, 4);
    mat23 n = MakeTransformDeg(V2(20, 30), 90), one = Mat23();
    if (Mat22().E11 != 1 || Mat22().E12 != 0 || one.E22 != 1 || Mat23(1, 2, 3, 4, 5, 6).E[5] != 6) return wrong("Mat22, Mat23");
    if (!same(m * V2(1, 1), V2(3, 7)) || (m * m).E11 != 7 || !close(Inverse(m).E11, -2)) return wrong("products of mat22");
    if (!close((n * V2(1, 0)).Y, 31) || !close((Inverse(n) * n).E13, 0) || !close(AddRotationDeg(n, 90).E11, -1)) return wrong("products of mat23");
    if (!close(AddRotationRad(RotationMat22Rad(1), 1).E11, WF_R(-0.416146837)) || !close(MakeTransform(n, one).E23, 30)) return wrong("AddRotationRad, MakeTransform");
    if (TranslationMat23(2, 3).E23 != 3 || TranslationMat23(a).E13 != 3 || TranslationMat23(c).E23 != 2) return wrong("TranslationMat23");
    if (AddTranslation(one, 2, 3).E13 != 2 || AddTranslation(one, a).E23 != 4 || AddTranslation(one, c).E13 != 1) return wrong("AddTranslation");
    rectangle2 r = RectMinMax(V2(1, 2), V2(5, 8));
    circle2 o = CircleCenterDiameter(V2(1, 2), 6);
    if (!same(GetCenter(r), V2(3, 5)) || !same(GetCenter(o), V2(1, 2)) || o.Radius != 3 || r.Max.Y != 8) return wrong("GetCenter");
    return IsInRectangle(r, V2(2, 7)) && !IsInCircle(o, V2(4, 4)) ? 0 : wrong("IsInRectangle, IsInCircle");
}

int main() { return listing() || arrays() || numbers(); }
