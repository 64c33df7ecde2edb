/* needs: keyed */
/* Sorted by a key, equal keys keep their order; the middle one is found without sorting. */
#include "part.h"

PART(keyed)
{
    wfKeyed a[5] = { { 3, 0 }, { 1, 1 }, { 2, 2 }, { 1, 3 }, { 0, 4 } }, b[5], spare[5];
    for (int i = 0; i < 5; i++) b[i] = a[i];
    wfSortKeyed(a, spare, 5);
    CHECK(a[0].index == 4 && a[1].index == 1 && a[2].index == 3 && a[3].index == 2 && a[4].index == 0);
    wfSelectKeyed(b, 5, 2);
    CHECK(b[2].key <= 1 && b[2].key >= 1);
    return 0;
}
