/* Weft: lab/peers/peer.h, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef LAB_PEER_H
#define LAB_PEER_H
/* What adapters of other engines share. Metres, kilograms, seconds, radians. */
#ifdef __cplusplus
extern "C" {
#endif

/* what a peer is told */
enum { PEER_STATIC, PEER_KINEMATIC, PEER_DYNAMIC };
enum { PEER_REVOLUTE, PEER_DISTANCE, PEER_WELD };
typedef struct peerShape {
    int    corners;             /* 0: a circle; else at most 8, counter-clockwise */
    double centre[2], radius;   /* of the circle, in the body's frame */
    double corner[8][2];        /* in the body's frame */
    double density, friction, restitution;
    unsigned category, mask;    /* 16 bits */
    int    doubtful;            /* 1: nobody promises that the corners are a polygon */
} peerShape;
typedef struct peerBody {
    int    type, fixedRotation, firstShape, shapes;
    double position[2], angle;  /* of its origin */
    double velocity[2], spin;   /* of its centre of mass */
    double centre[2];           /* of mass, in its frame */
} peerBody;
typedef struct peerJoint {
    int    kind, a, b, collide;
    double anchorA[2], anchorB[2];  /* in the bodies' frames */
    double rest;                    /* of a distance */
} peerJoint;

typedef struct peerScene {
    peerBody  *body;
    peerShape *shape;
    peerJoint *joint;
    int        bodies, shapes, joints;
    double     gravity[2], dt, origin[2];       /* origin: in all positions already */
    int        oneFriction, oneRestitution;     /* 1: all shapes have the same */
    int        geometricFriction, greatestRestitution; /* 1: how the scene mixes others */
    const char *file;
} peerScene;
typedef struct peerOptions {
    int    steps, every, substeps, iterations;  /* 0: the engine's default */
    int    fast, sleep, noBodies, sets;
    double dt;
    const char *set[16];                        /* "solver=exact" */
    const char *spoil;                          /* "radius=nan"; NULL: nothing is bad */
    double badStep;                             /* s, for one step more, if badSteps is 1 */
    int    badSteps;
} peerOptions;
/* Says why not on stderr, and ends the program with status 3. */
void peerRefuse(const char *what, ...);
/* Reads a scene; ends the program if it cannot be read (1) or is refused (3). */
void peerRead(const char *file, peerScene *out);

/* what a peer tells */
enum { PEER_CAN_ITERATE = 1, PEER_OWN_SUBSTEPS = 2, PEER_CAN_SWEEP = 4, PEER_CAN_SLEEP = 8,
       PEER_MIXES_FRICTION = 16, PEER_MIXES_RESTITUTION = 32, PEER_HAS_SETTINGS = 64 };
typedef struct peerEngine {
    const char *name, *real;    /* with its version; "float" or "double" */
    unsigned    can;
    int         joints;         /* bits: 1 << PEER_REVOLUTE and so on */
    void (*build)(const peerScene *scene, const peerOptions *options);
    void (*step)(double dt);
    void (*read)(int body, double state[6]);    /* x, y, angle, vx, vy, spin */
    void (*count)(int *pairs, int *points);     /* that touch */
} peerEngine;
int peerMain(const peerEngine *engine, int argc, char **argv);
#ifdef __cplusplus
}
#endif
#endif
