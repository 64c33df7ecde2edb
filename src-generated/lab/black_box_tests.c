/* Weft: lab/black_box_tests.c, tangled from chapters/engine/24-black-box-tests.lab.nw. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include "lab/cases.h"
#include "lab/bench.h"

static int measure_cases(FILE *out)
{
    fprintf(out, "id,purpose,input,expected,tries,worst,bound,unit,verdict\n");
    for (int32_t i = 0; i < labCaseCount; i++) {
        const labCase *c = &labCases[i];
        double worst = c->worst(c->tries);
        fprintf(out, "%s,\"%s\",\"%s\",\"%s\",%d,%.2g,%.2g,%s,%s\n", c->id, c->purpose,
                c->input, c->expected, (int)c->tries, worst, c->bound, c->unit,
                worst <= c->bound ? "as expected" : "not as expected");
    }
    return 0;
}

static const wfMeasureRow rows[] = {
    { "cases", "the report's black-box tests TC01 to TC08, with numbers", measure_cases },
};
const wfMeasureSet black_box_tests_measurements = WF_ROWS(rows);
