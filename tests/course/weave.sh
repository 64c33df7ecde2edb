#!/usr/bin/env bash
# A chapter that would like to run TeX, HTML and Lua where it is woven, and to show what lies elsewhere.
#   tests/course/weave.sh
set -uo pipefail
cd "$(dirname "$0")/../.." || exit 1
fail() { echo "course: $1"; exit 1; }
page=build/course/weaver/still-page
trap 'rm -rf coursework/weaver' EXIT
rm -rf coursework/weaver build/course/weaver; mkdir -p coursework/weaver
echo the-secret-of-others > build/course/secret.txt
{ cat chapters/exercises/still.nw; cat <<'NW'

---
header-includes: <script>document.title='by-metadata'</script>
css: http://evil.example/x.css
---

## Mine, with $\omega \times r$ and *prose* {onclick="by-attribute()"}

```{=html}
<script>document.title='by-block'</script>
```

```{=latex}
\directlua{local f=io.open("by-block","w") f:write("x") f:close()}
```

<script>document.title='by-tag'</script> <img src=x onerror="by-tag()">

<div onclick="by-div()">in a division</div>

Inline `\directlua{by-inline}`{=latex} and `<b onclick="by-inline()">`{=html}, $\directlua{by-math} x$, $x^^5cinput{by-caret}$, \input{by-command}, \immediate\write18{by-write18}.

$$ \input{by-display} \frac{1}{2} $$

\newcommand{\evil}{\directlua{by-macro}} $\evil$

[a link](javascript:by-link()) and [a good link](https://example.org/page), ![a picture](http://evil.example/by-picture.png), ![another](/etc/passwd), ![a third](../../../secret.txt)

[a span]{style="background:url(http://evil.example/by-style)" onclick="by-span()"}

::: {.data file="build/course/secret.txt" caption="`<script>by-caption</script>`{=html}"}
:::

::: {.listing file="/etc/passwd"}
:::

::: {.note title="<script>by-title</script>" onclick="by-note()"}
A note.
:::

@<<still: find a point@>> is a name.

<<still: find the point>>=
<<a helper <script>byname()</script> >>
return false; /* <script>by-code</script> */
@

<<a helper <script>byname()</script> >>=
(void)s; (void)out;
@
NW
} > coursework/weaver/still.nw
NAME=weaver COURSE_READY=1 tangle/course weave 8.4 > build/course/weave.log 2>&1 || { tail -20 build/course/weave.log; fail "a chapter of coursework is not woven"; }
html=$page/html/still.html
[ -s $html ] || fail "there is no page"
grep -q 'a good link' $html && grep -q 'https://example.org/page' $html && grep -q '<math' $html && grep -q 'A note' $html || fail "text, formulas, links or notes are lost"
# nothing that a browser runs or fetches, but the book's own
scripts=$(grep -o '<script[^>]*>' $html | sort -u)
[ "$(printf '%s\n' "$scripts" | grep -vcE '^<script( defer src="(book|live)\.js")?>$')" = 0 ] && [ "$(grep -o '<script>' $html | wc -l)" = 1 ] || { echo "$scripts"; fail "the page has a script of its author"; }
grep -oE '<[a-zA-Z][^>]*>' $html | grep -nE ' on[a-z]+=|javascript:|evil\.example|src="?[/x]|srcdoc|<iframe|<object' && fail "the page has something that a browser obeys"
grep -q 'the-secret-of-others\|root:x:0' $html && fail "the page shows a file from elsewhere"
# TeX has only written what it was given as text
for f in by-block by-inline by-math by-display by-macro by-write18; do [ -z "$(find . -maxdepth 1 -name "$f*" -newer build/course/secret.txt; find build/course -name "$f*" 2>/dev/null)" ] || fail "TeX has written $f"; done
if command -v lualatex >/dev/null; then
  [ -s $page/still.pdf ] || { cat build/course/weave.log; fail "there is no PDF: something of the text has reached TeX as a command"; }
  ! command -v pdftotext >/dev/null || { pdftotext $page/still.pdf - | tr -d '\n' | grep >/dev/null 'the-secret-of-others\|root:x:0' && fail "the PDF shows a file from elsewhere"; }
fi
echo "a chapter with TeX, HTML and files of others is woven as the text that it is"
