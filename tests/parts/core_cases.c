/* core_cases.c: the report's cases TC01 to TC08, done with the engine "core". All come out as expected but TC06: it is about the nodes of
   the quad tree, which stands in a volume of methods. The numbers are printed; run.sh holds the list against what is said here. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "lab/cases.h"

int main(void)
{
    int wrong = 0;
    for (int32_t i = 0; i < labCaseCount; i++) {
        const labCase *c = &labCases[i];
        double worst = c->worst(c->tries / 10);
        int out_of_reach = strcmp(c->id, "TC06") == 0;
        int good = out_of_reach ? isinf(worst) : worst <= c->bound;
        printf("%s %s: ", c->id, out_of_reach && good ? "out of reach (core has no quad tree)" : good ? "as expected" : "NOT as expected");
        if (out_of_reach) printf("nothing measured\n");
        else printf("off by %.2g %s, allowed %.2g\n", worst, c->unit, c->bound);
        wrong += !good;
    }
    return wrong != 0 || labCaseCount != 8;
}
