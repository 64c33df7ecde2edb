# one.awk: the sources of an engine as one text, which a compiler reads in a tenth of the time of ninety.
#   cd TREE && awk -f one.awk SOURCE.c ... > one.c
# Headers come first, but for lists of rows, which have no guard. A name that two of the sources have for themselves gets the
# source's number in front; macros of a source end with it.
FNR == 1 { n++; file[n] = FILENAME }
function mine(name) { if (name != "" && !((name, n) in has)) { has[name, n] = 1; times[name]++ } }
/^#define [A-Za-z_]/ { name = $2; sub(/\(.*/, "", name); macros[n] = macros[n] "#undef " name "\n"; next }
/^#include "/ { if ($2 !~ /_rows\.h|report\.h/ && !($2 in seen)) { seen[$2] = 1; first = first $0 "\n" } next }
/^(static|typedef|struct|union|enum|})/ {
  text = $0
  if (match(text, /^(typedef )?(struct|union|enum) [A-Za-z_0-9]+/)) { name = substr(text, RSTART, RLENGTH); sub(/.* /, "", name); mine(name) }
  if (text ~ /^(typedef )?enum/ || text ~ /^static const|^typedef/) { while (match(text, /[A-Z][A-Z_0-9]+/)) { mine(substr(text, RSTART, RLENGTH)); text = substr(text, RSTART + RLENGTH) } text = $0 }
  if (text ~ /^static/) { sub(/[(=;[].*/, "", text); sub(/ +$/, "", text) } else sub(/;.*/, "", text)
  sub(/.*[ *}]/, "", text); if (text ~ /^[A-Za-z_][A-Za-z_0-9]*$/) mine(text)
}
END {
  printf "%s", first
  for (i = 1; i <= n; i++) {
    for (name in times) if (times[name] > 1 && (name, i) in has) printf "#define %s s%d_%s\n", name, i, name
    printf "#include \"%s\"\n%s", file[i], macros[i]
    for (name in times) if (times[name] > 1 && (name, i) in has) print "#undef " name
  }
}
