/* Collision alone: shapes, no world, no bodies. Links libweft-collision.a, nothing else. */
#include <stdio.h>
#include <weft/collision.h>

int main(void)
{
    wfShape box, ball;
    wfMakeBox(1, 1, &box);                                  /* 2 m by 2 m */
    wfMakeCircle(wfV2(0, 0), WF_R(0.5), &ball);
    wfTransform at = wfTransformIdentity(), above = wfMakeTransform(wfV2(0, WF_R(1.25)), 0);

    wfManifold touch;                                       /* do they touch, and where? */
    int points = wfCollide(&box, at, &ball, above, &touch);
    printf("%d point, %g m deep, normal (%g, %g)\n", points, (double)touch.points[0].depth,
           (double)touch.normal.x, (double)touch.normal.y);

    wfRay ray = { wfV2(-5, 0), wfV2(10, 0) };               /* what does a ray hit? */
    wfRayHit hit;
    if (wfRayShape(&box, at, ray, &hit) != WF_OK) return 1;
    printf("the ray hits after %g of its way\n", (double)hit.fraction);

    wfCast cast;                                            /* how far may the ball go? */
    wfTransform high = wfMakeTransform(wfV2(0, 5), 0);
    if (wfCastShape(&ball, high, wfV2(0, -8), &box, at, &cast) != WF_OK) return 1;
    printf("the ball falls %.2f m\n", 8 * (double)cast.fraction);
    return 0;
}
/* prints:
1 point, 0.25 m deep, normal (0, 1)
the ray hits after 0.4 of its way
the ball falls 3.50 m
*/
