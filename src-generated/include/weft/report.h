/* Weft: include/weft/report.h, tangled from chapters/methods/22-report-interface.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_REPORT_H
#define WEFT_REPORT_H
/* The names of the report's Appendices B and C over Weft's own, for C11 (_Generic stands
 * in for overloading, variadic macros for default arguments) and C++11 (overloads and
 * operators). The book lists every difference. Units: m, kg, s; angles in degrees where a
 * name says Deg, else radians. */
#include "weft/world.h"

WF_BEGIN_C
typedef wfReal  real32;        /* double when the engine is built so */
typedef int32_t int32;
typedef wfVec2  v2;            /* X, Y or E[2] */
typedef wfVec3  v3;
typedef wfVec4  v4;
typedef wfMat22 mat22;         /* E11 .. E22 or E[4] */
typedef wfMat23 mat23;         /* E11 .. E23 or E[6] */
typedef union rectangle2 { struct { v2 Min, Max; }; wfRect Weft; } rectangle2;
typedef union circle2 { struct { v2 Center; real32 Radius; }; wfCircle2 Weft; } circle2;
static inline real32 Square(real32 A) { return wfSquare(A); }
static inline real32 DegToRadians(real32 Degrees) { return wfRadians(Degrees); }
static inline real32 SquareRoot(real32 Real32) { return wfSqrt(Real32); }
static inline real32 AbsoluteValue(real32 Real32) { return wfAbs(Real32); }
static inline real32 Sin(real32 Angle) { return wfSin(Angle); }
static inline real32 Cos(real32 Angle) { return wfCos(Angle); }
static inline real32 ArcCos(real32 Real32) { return wfArcCos(Real32); }
static inline v2 V2(real32 X, real32 Y) { return wfV2(X, Y); }
static inline v3 V3(real32 X, real32 Y, real32 Z) { return wfV3(X, Y, Z); }
static inline v4 V4(real32 X, real32 Y, real32 Z, real32 W) { return wfV4(X, Y, Z, W); }
static inline v2 PerpCW(v2 A) { return wfPerpCW(A); }
static inline v2 PerpCCW(v2 A) { return wfPerpCCW(A); }
static inline mat22 RotationMat22Rad(real32 Angle) { return wfMat22RotationRad(Angle); }
static inline mat22 RotationMat22Deg(real32 Angle) { return wfMat22RotationDeg(Angle); }
static inline mat23 RotationMat23Rad(real32 Angle) { return wfMat23RotationRad(Angle); }
static inline mat23 RotationMat23Deg(real32 Angle) { return wfMat23RotationDeg(Angle); }
static inline mat22 Transpose(mat22 A) { return wfMat22Transpose(A); }
static inline mat23 MakeMat23(mat22 A) { return wfMat23From22(A); }
static inline mat22 MakeMat22(mat23 A) { return wfMat22From23(A); }

static inline mat23 MakeTransformRad(v2 Position, real32 OrientationRad)
{
    return wfMat23TransformRad(Position, OrientationRad);
}
static inline mat23 MakeTransformDeg(v2 Position, real32 OrientationDeg)
{
    return wfMat23TransformDeg(Position, OrientationDeg);
}
/* The transform that does B first and then A. */
static inline mat23 MakeTransform(mat23 A, mat23 B) { return wfMat23Mul(A, B); }

static inline rectangle2 wfReportRect(wfRect Weft)
{
    rectangle2 Rect;
    Rect.Weft = Weft;
    return Rect;
}
static inline circle2 wfReportCircle(wfCircle2 Weft)
{
    circle2 Circle;
    Circle.Weft = Weft;
    return Circle;
}
static inline rectangle2 RectMinMax(v2 Min, v2 Max)
{
    return wfReportRect(wfRectMinMax(Min, Max));
}
static inline rectangle2 RectMinDim(v2 Min, v2 Dim)
{
    return wfReportRect(wfRectMinDim(Min, Dim));
}
static inline rectangle2 RectCenterHalfDim(v2 Center, v2 HalfDim)
{
    return wfReportRect(wfRectCenterHalfDim(Center, HalfDim));
}
static inline rectangle2 RectCenterDim(v2 Center, v2 Dim)
{
    return wfReportRect(wfRectCenterDim(Center, Dim));
}
static inline v2 GetMinCorner(rectangle2 Rect) { return Rect.Min; }
static inline v2 GetMaxCorner(rectangle2 Rect) { return Rect.Max; }
static inline real32 GetWidth(rectangle2 Rect) { return wfRectWidth(Rect.Weft); }
static inline real32 GetHeight(rectangle2 Rect) { return wfRectHeight(Rect.Weft); }
static inline bool IsInRectangle(rectangle2 Rectangle, v2 Test)
{
    return wfRectHasPoint(Rectangle.Weft, Test);
}

static inline circle2 CircleCenterRadius(v2 Center, real32 Radius)
{
    return wfReportCircle(wfCircleCenterRadius(Center, Radius));
}
static inline circle2 CircleCenterDiameter(v2 Center, real32 Diameter)
{
    return wfReportCircle(wfCircleCenterDiameter(Center, Diameter));
}
static inline real32 GetRadius(circle2 Circle) { return Circle.Radius; }
static inline bool IsInCircle(circle2 Circle, v2 Test)
{
    return wfCircleHasPoint(Circle.Weft, Test);
}
static inline v2 wfReportRectCenter(rectangle2 Rect) { return wfRectCenter(Rect.Weft); }
static inline v2 wfReportCircleCenter(circle2 Circle) { return Circle.Center; }

typedef wfWorld physics_world; /* a handle: copies of it name the same world */

/* A body in the making, and afterwards what is known of it. */
typedef struct poly_body_data {
    mat23    Transform;        /* where it is, and how it is turned */
    v2       Dimensions;       /* m, full width and height of the box */
    real32   Mass;             /* kg; 0: it never moves */
    real32   LinearDamping, AngularDamping;  /* 1/s */
    real32   Restitution, Friction;
    v2       Velocity;         /* m/s */
    real32   AngularVelocity;  /* rad/s */
    wfBodyId Id;               /* its name in the world, once it was added */
} poly_body_data;
/* An array of one, so that Body->Transform and &Body are both right. */
typedef poly_body_data poly_body[1];
/* MakePolyBody(Dimensions, Mass, Orientation = 0, LinearDamping = 0.35, AngularDamping =
 * 0.9): an initializer. Orientation is in degrees. */
#define MakePolyBody(...) { MakePolyBodyValue(__VA_ARGS__) }

/* What CreateWorld, MakePolyBody, AddBodyToWorld and StepWorld call. */
physics_world  wfReportCreateWorld(const real32 *Dt, size_t Count);
poly_body_data wfReportPolyBody(v2 Dimensions, const real32 *Numbers, size_t Count);
wfResult wfReportAddBody(physics_world *World, void *Body);
wfResult wfReportAddPointers(physics_world *World, const void *Pointers, int32 Count);
wfResult wfReportAddBodies(physics_world *World, void *Bodies, int32 Count);
wfResult wfReportStep(physics_world World);
/* Not in the report, which leaves no way to look or to end: reads Transform and
 * velocities of a body that was added; takes it out of the world; ends a world. */
wfResult wfReportUpdateBody(const physics_world *World, poly_body *Body);
static inline wfResult UpdateBody(const physics_world *World, poly_body *Body)
{
    return wfReportUpdateBody(World, Body);
}
static inline wfResult RemoveBodyFromWorld(physics_world *World, poly_body *Body)
{
    return Body == NULL ? WF_ERROR_NULL : wfRemoveBodyFromWorld(World, (*Body)->Id);
}
static inline void DestroyWorld(physics_world *World) { wfDestroyWorld(World); }
WF_END_C
#ifdef __cplusplus
#define WF_REPORT_VECTORS(v, Suffix) \
    inline real32 Inner(v A, v B) { return wfDot##Suffix(A, B); } \
    inline real32 LenSq(v A) { return wfLengthSq##Suffix(A); } \
    inline real32 Len_SLOW(v A) { return wfLength##Suffix(A); } \
    inline v VectorFromTo(v A, v B) { return wfFromTo##Suffix(A, B); } \
    inline v GetUnitVector(v A) { return wfNormalize##Suffix(A); } \
    inline real32 DistanceSq(v A, v B) { return wfDistanceSq##Suffix(A, B); } \
    inline v Add(v A, v B) { return wfAdd##Suffix(A, B); } \
    inline v Sub(v A, v B) { return wfSub##Suffix(A, B); } \
    inline v Scale(real32 S, v A) { return wfScale##Suffix(S, A); } \
    inline v operator+(v A, v B) { return wfAdd##Suffix(A, B); } \
    inline v operator-(v A, v B) { return wfSub##Suffix(A, B); } \
    inline v operator-(v A) { return wfNeg##Suffix(A); } \
    inline v operator*(real32 S, v A) { return wfScale##Suffix(S, A); }
WF_REPORT_VECTORS(v2, )
WF_REPORT_VECTORS(v3, 3)
WF_REPORT_VECTORS(v4, 4)
#undef WF_REPORT_VECTORS

inline mat22 Mat22() { return wfMat22Identity(); }
inline mat22 Mat22(real32 E11, real32 E12, real32 E21, real32 E22)
{
    return wfMat22Make(E11, E12, E21, E22);
}
inline mat23 Mat23() { return wfMat23Identity(); }
inline mat23 Mat23(real32 E11, real32 E12, real32 E13,
                   real32 E21, real32 E22, real32 E23)
{
    return wfMat23Make(E11, E12, E13, E21, E22, E23);
}
#define WF_REPORT_MATRICES(mat, Weft) \
    inline mat Inverse(mat A) { return Weft##Inverse(A); } \
    inline mat AddRotationRad(mat A, real32 Angle) \
    { return Weft##AddRotationRad(A, Angle); } \
    inline mat AddRotationDeg(mat A, real32 Angle) \
    { return Weft##AddRotationDeg(A, Angle); } \
    inline mat operator*(mat A, mat B) { return Weft##Mul(A, B); } \
    inline v2 operator*(mat A, v2 B) { return Weft##MulV(A, B); }
WF_REPORT_MATRICES(mat22, wfMat22)
WF_REPORT_MATRICES(mat23, wfMat23)
#undef WF_REPORT_MATRICES

inline mat23 TranslationMat23(v2 By) { return wfMat23Translation(By); }
inline mat23 TranslationMat23(v3 By) { return TranslationMat23(V2(By.X, By.Y)); }
inline mat23 TranslationMat23(real32 X, real32 Y) { return TranslationMat23(V2(X, Y)); }
inline mat23 AddTranslation(mat23 A, v2 By) { return wfMat23AddTranslation(A, By); }
inline mat23 AddTranslation(mat23 A, v3 By) { return AddTranslation(A, V2(By.X, By.Y)); }
inline mat23 AddTranslation(mat23 A, real32 X, real32 Y)
{
    return AddTranslation(A, V2(X, Y));
}
inline v2 GetCenter(rectangle2 Rect) { return wfReportRectCenter(Rect); }
inline v2 GetCenter(circle2 Circle) { return wfReportCircleCenter(Circle); }

inline physics_world CreateWorld() { return wfReportCreateWorld(NULL, 0); }
inline physics_world CreateWorld(real32 Dt)
{
    const real32 List[] = { 0, Dt };
    return wfReportCreateWorld(List, 1);
}
inline poly_body_data MakePolyBodyValue(v2 Dimensions, real32 Mass,
    real32 Orientation = 0, real32 LinearDamping = WF_R(0.35),
    real32 AngularDamping = WF_R(0.9))
{
    const real32 List[] = { 0, Mass, Orientation, LinearDamping, AngularDamping };
    return wfReportPolyBody(Dimensions, List, 4);
}
inline wfResult StepWorld(physics_world World) { return wfReportStep(World); }
inline wfResult StepWorld(physics_world *World) { return wfStepWorld(World); }

inline wfResult AddBodyToWorld(physics_world *World, poly_body_data *Body)
{
    return wfReportAddBody(World, Body);
}
inline wfResult AddBodyToWorld(physics_world *World, poly_body *Body)
{
    return wfReportAddBody(World, Body);
}
inline wfResult AddBodyToWorld(physics_world *World, poly_body **Pointers, int32 Count)
{
    return wfReportAddPointers(World, Pointers, Count);
}
inline wfResult AddBodyToWorld(physics_world *World, poly_body *Bodies, int32 Count)
{
    return wfReportAddBodies(World, Bodies, Count);
}
template <size_t Length>
wfResult AddBodyToWorld(physics_world *World, poly_body *(*Array)[Length], int32 Count)
{
    return wfReportAddPointers(World, *Array, Count);
}
template <size_t Length>
wfResult AddBodyToWorld(physics_world *World, poly_body (*Array)[Length], int32 Count)
{
    return wfReportAddBodies(World, *Array, Count);
}
#else
/* How many numbers were given, none included. */
#define WF_REPORT_COUNT(...) (sizeof((real32[]){ 0, __VA_ARGS__ }) / sizeof(real32) - 1)
/* The numbers after a leading 0. A negative array size stops the compiler unless there are
 * none, or least to most. */
#define WF_REPORT_LIST(least, most, ...) \
    ((real32[]){ 0, __VA_ARGS__ } + 0 * sizeof(char[ \
        WF_REPORT_COUNT(__VA_ARGS__) == 0 || (WF_REPORT_COUNT(__VA_ARGS__) >= (least) \
            && WF_REPORT_COUNT(__VA_ARGS__) <= (most)) ? 1 : -1]))
/* Two arguments for a function: the list, and how long it is. */
#define WF_REPORT_NUMBERS(least, most, ...) \
    WF_REPORT_LIST(least, most, __VA_ARGS__), WF_REPORT_COUNT(__VA_ARGS__)
/* The fourth argument: picks a macro by the number of arguments before it. */
#define WF_REPORT_FOURTH(a, b, c, d, ...) d
/* CreateWorld() or CreateWorld(dt), dt in seconds, default 1/30, at most 1. When it
 * fails, the handle is empty and every call with it returns WF_ERROR_NULL. */
#define CreateWorld(...) wfReportCreateWorld(WF_REPORT_NUMBERS(1, 1, __VA_ARGS__))
/* What MakePolyBody puts into its braces. */
#define MakePolyBodyValue(Dimensions, ...) \
    wfReportPolyBody((Dimensions), WF_REPORT_NUMBERS(1, 4, __VA_ARGS__))
/* AddBodyToWorld(&World, &Body) or AddBodyToWorld(&World, &BodyArray, NumOfBodies),
 * where BodyArray holds pointers to bodies, or bodies. All are added, or none:
 * wfAddBodyToWorld. */
#define AddBodyToWorld(...) \
    WF_REPORT_FOURTH(__VA_ARGS__, WF_REPORT_ADD_MANY, WF_REPORT_ADD_ONE, ~, ~)(__VA_ARGS__)
/* StepWorld(World) or StepWorld(&World). */
#define StepWorld(World) \
    _Generic((World), physics_world: wfReportStep, physics_world *: wfStepWorld)(World)
#define WF_REPORT_ADD_ONE(World, Body) \
    _Generic((Body), poly_body *: wfReportAddBody, poly_body_data *: wfReportAddBody) \
        ((World), (Body))
#define WF_REPORT_ADD_MANY(World, Bodies, Count) \
    _Generic((Bodies)[0], \
        poly_body **: wfReportAddPointers, poly_body_data *: wfReportAddBodies, \
        poly_body *: _Generic((Bodies), poly_body **: wfReportAddPointers, \
                              default: wfReportAddBodies))((World), (Bodies), (Count))
#define Inner(A, B)        _Generic((A), v2: wfDot, v3: wfDot3, v4: wfDot4)((A), (B))
#define LenSq(A) \
    _Generic((A), v2: wfLengthSq, v3: wfLengthSq3, v4: wfLengthSq4)(A)
#define Len_SLOW(A)        _Generic((A), v2: wfLength, v3: wfLength3, v4: wfLength4)(A)
#define VectorFromTo(A, B) \
    _Generic((A), v2: wfFromTo, v3: wfFromTo3, v4: wfFromTo4)((A), (B))
#define GetUnitVector(A) \
    _Generic((A), v2: wfNormalize, v3: wfNormalize3, v4: wfNormalize4)(A)
#define DistanceSq(A, B) \
    _Generic((A), v2: wfDistanceSq, v3: wfDistanceSq3, v4: wfDistanceSq4)((A), (B))

/* C has no operators for vectors: the report's A + B, A - B and s * A. */
#define Add(A, B)          _Generic((A), v2: wfAdd, v3: wfAdd3, v4: wfAdd4)((A), (B))
#define Sub(A, B)          _Generic((A), v2: wfSub, v3: wfSub3, v4: wfSub4)((A), (B))
#define Scale(S, A)        _Generic((A), v2: wfScale, v3: wfScale3, v4: wfScale4)((S), (A))

static inline mat22 wfReportMat22(const real32 *E, size_t Count)
{
    return Count == 0 ? wfMat22Identity() : wfMat22Make(E[1], E[2], E[3], E[4]);
}
static inline mat23 wfReportMat23(const real32 *E, size_t Count)
{
    return Count == 0 ? wfMat23Identity() : wfMat23Make(E[1], E[2], E[3], E[4], E[5], E[6]);
}
/* Mat22() is the identity, Mat22(E11, E12, E21, E22) what it says; Mat23 likewise with
 * six. */
#define Mat22(...) wfReportMat22(WF_REPORT_NUMBERS(4, 4, __VA_ARGS__))
#define Mat23(...) wfReportMat23(WF_REPORT_NUMBERS(6, 6, __VA_ARGS__))
#define Inverse(A) _Generic((A), mat22: wfMat22Inverse, mat23: wfMat23Inverse)(A)
#define AddRotationRad(A, Angle) \
    _Generic((A), mat22: wfMat22AddRotationRad, \
                  mat23: wfMat23AddRotationRad)((A), (Angle))
#define AddRotationDeg(A, Angle) \
    _Generic((A), mat22: wfMat22AddRotationDeg, \
                  mat23: wfMat23AddRotationDeg)((A), (Angle))

static inline mat23 wfReportMove(real32 X, real32 Y)
{
    return wfMat23Translation(wfV2(X, Y));
}
static inline mat23 wfReportMove2(v2 By) { return wfMat23Translation(By); }
static inline mat23 wfReportMove3(v3 By) { return wfMat23Translation(wfV2(By.X, By.Y)); }
#define WF_REPORT_MOVE_XY(X, Y) wfReportMove((X), (Y))
#define WF_REPORT_MOVE_V(V)     _Generic((V), v2: wfReportMove2, v3: wfReportMove3)(V)
/* TranslationMat23(X, Y), of a v2, or of a v3 (whose Z plays no part). */
#define TranslationMat23(...) \
    WF_REPORT_FOURTH(__VA_ARGS__, ~, WF_REPORT_MOVE_XY, WF_REPORT_MOVE_V, ~)(__VA_ARGS__)

static inline mat23 wfReportAdd(mat23 A, real32 X, real32 Y)
{
    return wfMat23AddTranslation(A, wfV2(X, Y));
}
static inline mat23 wfReportAdd2(mat23 A, v2 By) { return wfMat23AddTranslation(A, By); }
static inline mat23 wfReportAdd3(mat23 A, v3 By) { return wfReportAdd(A, By.X, By.Y); }
#define WF_REPORT_ADD_XY(A, X, Y) wfReportAdd((A), (X), (Y))
#define WF_REPORT_ADD_V(A, V) \
    _Generic((V), v2: wfReportAdd2, v3: wfReportAdd3)((A), (V))
/* AddTranslation(A, X, Y), (A, v2) or (A, v3). */
#define AddTranslation(...) \
    WF_REPORT_FOURTH(__VA_ARGS__, WF_REPORT_ADD_XY, WF_REPORT_ADD_V, ~, ~)(__VA_ARGS__)
#define GetCenter(Shape) \
    _Generic((Shape), rectangle2: wfReportRectCenter, circle2: wfReportCircleCenter)(Shape)
#endif
#endif
