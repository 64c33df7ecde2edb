#include "testing.h"
#include "weft/force.h"
static void t(void **s) { (void)s; assert_ok(wfCheckForce(&(wfForce){ .kind = 0, .a = -1, .b = -1 })); }
int main(void) { const struct CMUnitTest tests[] = { cmocka_unit_test(t) }; return cmocka_run_group_tests(tests, NULL, NULL); }
