/* Weft: include/weft/compound.h, tangled from chapters/methods/15-compound.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* compound.h: bodies of several shapes: combined masses, outlines cut into convex pieces,
   chains. Lengths in m, masses in kg, inertia in kg m^2.
   What answers no wfResult trusts its pointers. */
#ifndef WEFT_COMPOUND_H
#define WEFT_COMPOUND_H
#include "weft/shape.h"
WF_BEGIN_C

/* Mass data of n >= 1 parts of one body taken together, centres in the same frame (eq:
   compound-inertia). A part without mass has no inertia. What overlaps counts twice. Order
   and grouping matter only to rounding. To remove a part, combine the others. out may be
   among the parts. WF_ERROR_NULL; _RANGE: n; _NOT_FINITE; _SIZE: a centre is past
   WF_MAX_SIZE; _MASS: a mass, an inertia or a sum is negative or too large, or no part
   has a mass. */
wfResult wfCombineMasses(const wfMassData *parts, int n, wfMassData *out);
/* The same for n >= 1 shapes of one density (kg/m^2). Also what wfShapeMass returns. */
wfResult wfShapesMass(const wfShape *shapes, int n, wfReal density, wfMassData *out);
/* 1 if c is to the left of the way from a to b, -1 to the right, 0 exactly on the line (eq:
   compound-orientation). Exact if each coordinate is 0 or between 1e-100 and 1e100. */
int wfOrientation(wfVec2 a, wfVec2 b, wfVec2 c);
#define WF_MAX_CORNERS 4096     /* corners of an outline; time grows with their square */

/* WF_OK if the outline is simple: no corner comes twice or is flat, no two sides meet but
   neighbours, in their corner. WF_ERROR_NULL; _TOO_FEW; _RANGE: more than WF_MAX_CORNERS
   corners; _NOT_FINITE; _SIZE; _DEGENERATE: all on one line; _DUPLICATE, _FLAT, _CROSSES:
   then where (or NULL) gets the two corners, the flat one twice, the starts of the sides */
wfResult wfCheckOutline(const wfVec2 *outline, int n, int32_t where[2]);
/* Copies the outline without corners that are repeated or (nearly) flat, by at most
   WF_HULL_TOLERANCE of its size. out has room for n. Returns the number of corners left; 0
   if fewer than 3 are, or for NULL, n > WF_MAX_CORNERS, bad numbers and bad sizes. */
int wfTidyOutline(const wfVec2 *points, int n, wfVec2 *out);

enum { WF_MESH_NONE = -1 };

typedef struct wfHalfEdge {
    int32_t from;               /* the corner where it starts; WF_MESH_NONE: taken out    */
    int32_t next, prev;         /* the half-edges after and before it round its piece     */
    int32_t twin;               /* the same edge the other way, or WF_MESH_NONE           */
} wfHalfEdge;

/* An outline cut into pieces. Corners and half-edges lie in the caller's scratch pool. */
typedef struct wfMesh {
    const wfVec2 *corners;      /* m, counter-clockwise, whatever the outline was         */
    int32_t cornerCount;
    wfHalfEdge *edges;          /* each piece runs counter-clockwise                      */
    int32_t edgeCount;
} wfMesh;
/* Checks the outline (any direction) and cuts it into n - 2 triangles; the k-th ear that
   was cut off is half-edges 3k to 3k + 2. The mesh lies in scratch, which is given back
   after an error alone. What wfCheckOutline returns; WF_ERROR_NULL, _MEMORY; _THIN:
   coordinates are so small that rounding bends the outline. */
wfResult wfCutEars(const wfVec2 *outline, int n, wfPool *scratch, wfMesh *mesh);
/* Bytes of scratch that suffice for wfCutEars and wfDecompose of n corners. */
size_t wfDecomposeScratch(int n);
/* Flips diagonals of a mesh of triangles until the smallest angle is as large as it can be.
   Returns the number of flips. */
int32_t wfFlipMesh(wfMesh *mesh);
/* Takes out diagonals as long as all pieces stay convex: at most 2r + 1 are left for r
   reflex corners (eq:compound-bound). Returns the number of pieces. Once for a mesh: a
   second call finds no more to take out, but counts what the first took out as there. */
int32_t wfMergeMesh(wfMesh *mesh);
/* The corners of the piece to the left of a half-edge, in ring, which has room for
   mesh->cornerCount. Returns their number; 0 if the half-edge was taken out, or is not
   the first of its piece. */
int32_t wfMeshRing(const wfMesh *mesh, int32_t edge, int32_t *ring);
/* Cuts a simple outline of n corners (m, either direction) into convex polygons that do not
   overlap: at most 2r + 1 + n / 14 for r reflex corners, and never more than n - 2. out has
   room for capacity shapes; *count gets their number. Same input, same shapes, same order.
   WF_ERROR_NULL; what wfCheckOutline returns; _FULL: capacity; _MEMORY: scratch is smaller
   than wfDecomposeScratch(n); _THIN, _SIZE: a piece is too thin or too small for a shape.
   After an error nothing has changed. Time: n^2, at worst n^3. */
wfResult wfDecompose(const wfVec2 *outline, int n, wfShape *out, int capacity, int *count,
                     wfPool *scratch);
/* The links of a chain through n points (m), solid from the right of their direction: n - 1
   of them, or n for a loop, whose last point is joined to its first. At the ends of an open
   chain the ghosts go straight on (eq:compound-ghost). out has room for capacity shapes,
   *count gets their number. WF_ERROR_NULL; _TOO_FEW: under 2 points, for a loop 3; _FULL;
   _FLAT: turns back on itself; what wfMakeLink returns. After an error nothing changed. */
wfResult wfMakeChain(const wfVec2 *points, int n, bool loop, wfShape *out, int capacity,
                     int *count);
WF_END_C
#endif
