#!/usr/bin/env bash
# The package for Python: its tests, with floats and with doubles, against the installed library; its layouts against the compiler's; the example.
set -euo pipefail
cd "$(dirname "$0")/../.."
for python in python3 /usr/bin/python3; do $python -c 'import pytest, numpy' 2>/dev/null && break; python=; done
[ -n "$python" ] || { echo "python: no pytest or numpy here -- tangle/install python"; exit 77; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
make --no-print-directory engine python >/dev/null
make --no-print-directory install PREFIX="$work/one" >/dev/null
make --no-print-directory BUILD=build/check/real64 engine CFLAGS="-O2 -DWF_DOUBLE" WARN= >/dev/null
cp -r build/python "$work/python" && export PYTHONPATH="$work/python" PYTHONDONTWRITEBYTECODE=1
for kind in float double; do
  flags= lib=$work/one/lib/libweft.so archive=$work/one/lib/libweft.a
  [ $kind = float ] || { flags=-DWF_DOUBLE lib=$PWD/build/check/real64/lib/libweft.so archive=build/check/real64/lib/libweft.a; }
  export WEFT_LIBRARY=$lib
  cc -std=c11 $flags -Isrc-generated/include tests/npm/scene.c "$archive" -lm -o "$work/scene"
  HASH=$("$work/scene") $python -m pytest -q -p no:cacheprovider tests/python >"$work/log" 2>&1 || { tail -40 "$work/log"; exit 1; }
  echo "python, $kind: $(tail -1 "$work/log")"
  # every structure has the size, and every field the place, that the compiler gives it
  { echo '#include <stddef.h>'; echo '#include <weft/weft.h>'
    $python -c '
import ctypes, weft
for name, t in vars(weft.api).items():
    if name.startswith("wf") and isinstance(t, type) and issubclass(t, (ctypes.Structure, ctypes.Union)):
        print(f"_Static_assert(sizeof({name}) == {ctypes.sizeof(t)}, \"{name}\");")
        for field, *_ in t._fields_:
            if not field.startswith("_"): print(f"_Static_assert(offsetof({name}, {field}) == {getattr(t, field).offset}, \"{name}.{field}\");")'
  } >"$work/layout.c"
  cc -std=c11 $flags -Isrc-generated/include -fsyntax-only "$work/layout.c"
  [ "$(grep -c sizeof "$work/layout.c")" -gt 60 ]
  echo "python, $kind: $(grep -c sizeof "$work/layout.c") structures lie as the compiler lays them"
done
export WEFT_LIBRARY=$work/one/lib/libweft.so
if $python -c 'import matplotlib' 2>/dev/null; then
  (cd "$work" && $python python/energy.py picture.png) && [ "$(wc -c < "$work/picture.png")" -gt 10000 ] && echo "python: the energy curve is drawn"
else echo "python: no matplotlib here, the energy curve is left out"; fi
