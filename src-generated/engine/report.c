/* Weft: engine/report.c, tangled from chapters/methods/22-report-interface.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include "weft/report.h"

/* create the report's world */
physics_world wfReportCreateWorld(const real32 *Dt, size_t Count)
{
    physics_world World = { .memory = { .owned = 0 } };
    wfWorldDef Def = wfDefaultWorldDef();
    Def.timeStep = Count == 0 ? WF_R(1.0) / 30 : Dt[1];
    Def.bodyCapacity = 1024;
    if (Def.timeStep <= 1) wfCreateWorld(&Def, &World); /* above: milliseconds were meant */
    return World;
}

/* make the report's body */
poly_body_data wfReportPolyBody(v2 Dimensions, const real32 *Numbers, size_t Count)
{
    static const real32 None[2] = { 0 };
    if (Numbers == NULL || Count == 0) Numbers = None, Count = 0; /* no mass: refused */
    real32 Orientation = Count >= 2 ? Numbers[2] : 0;
    return (poly_body_data){
        .Transform = MakeTransformDeg(V2(0, 0), Orientation), .Dimensions = Dimensions,
        .Mass = Numbers[1], .LinearDamping = Count >= 3 ? Numbers[3] : WF_R(0.35),
        .AngularDamping = Count >= 4 ? Numbers[4] : WF_R(0.9), .Friction = WF_R(0.5) };
}

/* turn the report's body into a definition */
static wfResult define(const poly_body_data *Body, wfBodyDef *Out)
{
    mat23 T = Body->Transform;
    for (int i = 0; i < 6; i++)
        if (!wfIsFinite(T.E[i])) return WF_ERROR_NOT_FINITE;
    if (!wfIsFinite(Body->Mass)) return WF_ERROR_NOT_FINITE;
    *Out = wfDefaultBodyDef();
    /* refuse a transform that is no rotation */
    const real32 Loose = WF_R(0.001);
    real32 Along = T.E11 * T.E11 + T.E21 * T.E21;
    bool Unit = Along > 1 - Loose && Along < 1 + Loose;
    bool Turned = wfAbs(T.E11 - T.E22) < Loose && wfAbs(T.E12 + T.E21) < Loose;
    if (!Unit || !Turned) return WF_ERROR_RANGE;
    Out->type = Body->Mass == 0 ? WF_STATIC : WF_DYNAMIC;
    Out->position = V2(T.E13, T.E23);
    Out->angle = wfAtan2(T.E21, T.E11);
    Out->mass = Body->Mass;
    Out->velocity = Body->Velocity;
    Out->angularVelocity = Body->AngularVelocity;
    Out->linearDamping = Body->LinearDamping;
    Out->angularDamping = Body->AngularDamping;
    Out->restitution = Body->Restitution;
    Out->friction = Body->Friction;
    return wfMakeBox(Body->Dimensions.X / 2, Body->Dimensions.Y / 2, &Out->shape);
}

/* add the report's bodies */
wfResult wfReportAddBody(physics_world *World, void *Body)
{
    poly_body_data *Given = Body;
    wfBodyDef Def;
    if (World == NULL || Given == NULL) return WF_ERROR_NULL;
    wfResult Result = define(Given, &Def);
    return Result == WF_OK ? wfAddBodyToWorld(World, &Def, &Given->Id) : Result;
}

static poly_body_data *pick(poly_body *const *List, poly_body_data *Row, int32 i)
{
    if (List == NULL) return &Row[i];
    return List[i] == NULL ? NULL : *List[i];
}

static wfResult add_all(physics_world *World, poly_body *const *List, poly_body_data *Row,
                        int32 Count)
{
    wfResult Result = Count < 0 ? WF_ERROR_RANGE : WF_OK;
    if (List == NULL && Row == NULL) return WF_ERROR_NULL;
    int32 Added = 0;
    while (Result == WF_OK && Added < Count) {
        Result = wfReportAddBody(World, pick(List, Row, Added));
        if (Result == WF_OK) Added++;
    }
    while (Result != WF_OK && Added > 0) {  /* all or none */
        poly_body_data *Body = pick(List, Row, --Added);
        wfRemoveBodyFromWorld(World, Body->Id);
        Body->Id = (wfBodyId){ 0, 0 };
    }
    return Result;
}

wfResult wfReportAddPointers(physics_world *World, const void *Pointers, int32 Count)
{
    return add_all(World, Pointers, NULL, Count);
}

wfResult wfReportAddBodies(physics_world *World, void *Bodies, int32 Count)
{
    return add_all(World, NULL, Bodies, Count);
}

/* step and end the report's world */
wfResult wfReportStep(physics_world World) { return wfStepWorld(&World); }

wfResult wfReportUpdateBody(const physics_world *World, poly_body *Body)
{
    wfBodyInfo Info;
    if (Body == NULL) return WF_ERROR_NULL;
    poly_body_data *Data = *Body;
    wfResult Result = wfGetBody(World, Data->Id, &Info);
    if (Result != WF_OK) return Result;
    Data->Transform = MakeTransformRad(Info.position, Info.angle);
    Data->Velocity = Info.velocity;
    Data->AngularVelocity = Info.angularVelocity;
    return WF_OK;
}
