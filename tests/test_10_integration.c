#include "testing.h"
#include "weft/integrate.h"
static void t(void **s) { (void)s; assert_int_equal(wfFindIntegrator("rk4"), 3); }
int main(void) { const struct CMUnitTest tests[] = { cmocka_unit_test(t) }; return cmocka_run_group_tests(tests, NULL, NULL); }
