# shellcheck shell=bash disable=SC2034
# With what several tests compile the engine. One text in one order, that of the Makefile: ccache then knows what another test has compiled.
WARN_DOUBLE="-Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wfloat-conversion -Wundef -Wvla -Werror"
WARN_FLOAT=${WARN_DOUBLE/-Wfloat-conversion/-Wdouble-promotion -Wfloat-conversion}
SANITIZED="-O1 -g1 -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all"
# the compiler's name counts as well
gcc=gcc; ! cc --version 2>/dev/null | grep >/dev/null 'Free Software Foundation' || gcc=cc
