#!/usr/bin/env bash
# The loom's messages: small broken books, each of which must be refused with the right file, line and a remedy;
# and a small whole book whose numbers must agree in HTML and TeX. All of it works in a directory of its own.
set -uo pipefail
cd "$(dirname "$0")/../.."
repo=$PWD
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
passed=0 failed=0
ok() { passed=$((passed + 1)); echo "ok   $1"; }
bad() { failed=$((failed + 1)); echo "FAIL $1"; sed 's/^/       /' "$work/log" | head -12; }

# A book in a directory of its own: book NAME, then chapters by  chapter FILE < text
book() {
  dir=$work/$1; rm -rf "$dir"; mkdir -p "$dir/chapters" "$dir/book/plots" "$dir/book/data"
  cp book/macros.tex book/page.html "$dir/book/"
  printf '=engine\t\tThe engine\none\tengine\tIntroduction\tOne\t1\ntwo\tengine\tImplementation\tTwo\t2\nthree\tengine\tImplementation\tThree\t3\nprimer\tengine\tAppendices\tPrimer\tA\n' > "$dir/book/plan.tsv"
  printf '@book{newton1687, author={Newton, Isaac}, title={Principia}, year={1687}, publisher={Streater}, address={London}}\n' > "$dir/book/refs.bib"
}
chapter() { cat > "$dir/chapters/$1"; }
line() { grep -n -- "$2" "$dir/chapters/$1" | head -1 | cut -d: -f1; }      # the line that holds a mark
weave() { (cd "$dir" && WEFT_ROOT=$dir/ "$repo/tangle/weave" "$@" --html out/html out/weave chapters/*.nw) >"$work/log" 2>&1; }
# refuse WHAT FILE LINE words remedy-words: the weave fails with  FILE:LINE: ...words... -- ...remedy...
refuse() {
  if weave ${strict:-}; then bad "$1: was accepted"; return; fi
  if grep -qE "^chapters/$2:$3: .*$4.* -- .*$5" "$work/log"; then ok "$1"; else bad "$1: no message for chapters/$2:$3"; fi
}
# the same for the tangler
refuse_tangle() {
  if (cd "$dir" && "$repo/tangle/tangle" out/src chapters/*.nw) >"$work/log" 2>&1; then bad "$1: was tangled"; return; fi
  if grep -qE "^chapters/$2:$3: .*$4.* -- .*$5" "$work/log"; then ok "$1 (tangle)"; else bad "$1 (tangle): no message for chapters/$2:$3"; fi
}

# ---- chunks
book undefined; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
int a;
<<count the sheep>>
@
<<count the sheeps>>=
int sheep;
@
X
refuse "an undefined chunk" 01-one.nw 5 'count the sheep.* nowhere defined' 'count the sheeps'
refuse_tangle "an undefined chunk" 01-one.nw 5 'count the sheep.* nowhere defined' 'did you mean'
refuse "an unused chunk" 01-one.nw 7 'count the sheeps.* never used' 'use it'

book cycle; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
<<hen>>
@
<<hen>>=
<<egg>>
@
<<egg>>=
<<hen>>
@
X
refuse "a chunk cycle" 01-one.nw '[69]' 'contains itself: .*egg' 'break the circle'
refuse_tangle "a chunk cycle" 01-one.nw '[69]' 'contains itself' 'break the circle'

book shift; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
int a(int b) { return b << 2 | b >> 3; }
@
X
refuse "a shift read as a chunk" 01-one.nw 4 'shares its line|nowhere defined' '@<<'
refuse_tangle "a shift read as a chunk" 01-one.nw 4 'shares its line|nowhere defined' '@<<'

book prose; chapter 01-one.nw <<'X'
# One {#sec:one}

In C, 1 << 4 is sixteen.

<<core/a.c>>=
int a;
@
X
refuse "a shift in prose" 01-one.nw 3 '<< in prose' 'write @<<'
refuse_tangle "a shift in prose" 01-one.nw 3 '<< in prose' 'write @<<'

book open; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
int a;

Here the at sign was forgotten.

<<core/b.c>>=
int b;
@
X
refuse "a chunk that is not ended" 01-one.nw 8 'core/a.c>> was not ended' '@ alone'
refuse_tangle "a chunk that is not ended" 01-one.nw 8 'core/a.c>> was not ended' '@ alone'

book later; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
<<parts that come later>>
@
X
chapter 02-two.nw <<'X'
# Two {#sec:two}

<<parts that come later>>=
int late;
@
X
refuse "a chunk used before its chapter" 01-one.nw 4 'first defined later, in chapters/02-two.nw' 'define its first part'
refuse_tangle "a chunk used before its chapter" 01-one.nw 4 'first defined later' 'define its first part'

# ---- identifiers: what a later chapter defines
book identifiers; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
<<functions of a>>
@
<<functions of a>>=
static int early(void) { return 1; }
int a(void)
{
    return early() + wfLate(2);
}
@
X
chapter 02-two.nw <<'X'
# Two {#sec:two}

<<core/b.c>>=
int wfLate(int n);
int wfLate(int n) { return n; }
static int hidden(void) { return 1; }
@
X
refuse "an identifier used before its chapter" 01-one.nw 10 'wfLate is used here but first declared later, in chapters/02-two.nw' 'move'
sed -i 's/wfLate(2)/hidden/; s/int a(void)/int a(int hidden)/' "$dir/chapters/01-one.nw"
if weave; then ok "a parameter may have the name of another file's static"; else bad "a parameter was taken for another file's static"; fi
sed -i 's/int a(int hidden)/int a(void)/; s/+ hidden/+ 2/' "$dir/chapters/01-one.nw"
sed -i 's/^int wfLate(int n);/#define LATE(early) ((early) + 1)/' "$dir/chapters/02-two.nw"
if weave; then ok "statics are their own file's affair"; else bad "statics are their own file's affair"; fi

# a chunk that stands in two files defines its names once
book twice; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
<<counting>>
int a(void) { return count(); }
@
<<core/b.c>>=
<<counting>>
int b(void) { return count(); }
@
<<counting>>=
static int count(void) { return 1; }
@
X
if weave && [ "$(grep -o '"d-count[^"]*"' "$dir/out/weave/one.lua" | sort -u | wc -l)" -eq 1 ]; then ok "a chunk in two files defines once"; else bad "a chunk in two files defines once"; fi

# ---- parts that may be left out
book parts; chapter 01-one.nw <<'X'
# One {#sec:one}

::: {.goals report="1" parts="bells; whistles: bells"}
- make noise
:::

<<core/a.c>>=
<<headers of a>>
int a(void)
{
    int loud = 0;
    <<make noise>>
    return loud;
}
@
X
chapter 02-two.nw <<'X'
# Two {#sec:two}

## Bells {#sec:two-bells part="bells"}

<<make noise>>=
loud += wfRing();
@
<<headers of a>>=
int wfRing(void);
@
<<core/bell.c>>=
int wfRing(void) { return <<how loud>> 1; }
@

## Not only bells {#sec:two-other}

::: {.only part="whistles"}
<<make noise>>=
loud += wfPlay() + wfRing();
@
<<headers of a>>=
int wfPlay(void);
@
<<core/whistle.c>>=
int wfPlay(void) { return 2; }
@
:::
X
sed -i 's/<<how loud>> //' "$dir/chapters/02-two.nw"
parts_tangle() { (cd "$dir" && "$repo/tangle/tangle" "$@" out/parts chapters/*.nw) >"$work/log" 2>&1; }
noise() { parts_tangle "$@" && (cd "$dir/out/parts" && ls core | tr '\n' ' '; grep -c 'loud +=' core/a.c; tr '\n' ' ' < parts) > "$work/got" 2>&1; tr '\n' ' ' < "$work/got"; }
expect_parts() { if [ "$2" = "$3" ]; then ok "$1"; else echo "expected: $3|got: $2|" > "$work/log"; bad "$1"; fi; }
if weave; then ok "a book with parts"; else bad "a book with parts"; fi
expect_parts "no part" "$(noise --only '')" "a.c 0 "
expect_parts "a part with what it needs" "$(noise --only whistles)" "a.c bell.c whistle.c 2 bells whistles "
expect_parts "one part alone" "$(noise --only bells)" "a.c bell.c 1 bells "
expect_parts "without a part, and without what needs it" "$(noise --without bells)" "a.c 0 "
expect_parts "without one that nobody needs" "$(noise --without whistles)" "a.c bell.c 1 bells "
noise --only '' >/dev/null
expect_parts "a place without a piece leaves no line" "$(sed '1,/int a/d' "$dir/out/parts/core/a.c")" "$(printf '{\n    int loud = 0;\n    return loud;\n}')"
parts_tangle --lines --only '' && (cd "$dir/out/parts/core" && sed 's/return loud/return lout/' a.c | gcc -c -x c -o /dev/null -) 2>"$work/got"
expect_parts "nor does it move the lines behind it" "$(grep -o '^chapters/01-one.nw:[0-9]*:[0-9]*: error' "$work/got")" "chapters/01-one.nw:$(line 01-one.nw 'return loud'):12: error"
mv "$dir/chapters/02-two.nw" "$dir/"
refuse "a place that no chapter fills" 01-one.nw 8 'headers of a>> is used but nowhere defined' 'mend its spelling'
mkdir "$dir/chapters/engine" && cp "$dir/02-two.nw" "$dir/chapters/engine/"
refuse "a place in somebody's own chapter" 01-one.nw 8 'headers of a>> is used but nowhere defined' 'mend its spelling'
cp "$dir/chapters/01-one.nw" "$dir/chapters/engine/"
if weave; then ok "a place that a later chapter fills, in the book up to here"; else bad "a place that a later chapter fills, in the book up to here"; fi
rm -r "$dir/chapters/engine"; mv "$dir/02-two.nw" "$dir/chapters/"
if parts_tangle --only bell; then bad "an unknown part was tangled"; elif grep -q 'no part is called bell (did you mean bells?) -- the parts are bells, whistles' "$work/log"; then ok "an unknown part"; else bad "an unknown part: no message"; fi
grep -q '"only"\]="whistles"' "$dir/out/weave/two.lua" && ok "the margin says with what" || bad "the margin should say: whistles"
sed -i 's/part="bells"/part="bell"/' "$dir/chapters/02-two.nw"
refuse "a section of an unknown part" 02-two.nw 3 'no part is called bell' 'the parts are bells, whistles'
refuse_tangle "a section of an unknown part" 02-two.nw 3 'no part is called bell' 'the parts are bells, whistles'
book lost-part; chapter 01-one.nw <<'X'
# One {#sec:one}

::: {.goals report="1" parts="bells; whistles: flutes; drums"}
- make noise
:::

## Bells {#sec:one-bells part="bells"}

<<core/bell.c>>=
int wfRing(void);
int wfRing(void) { return 1; }
@
<<make noise>>=
wfRing();
@

## All {#sec:one-all}

<<core/a.c>>=
int a(void)
{
    <<make noise>>
    return wfRing();
}
@

::: {.only}
:::
X
refuse "a need that is no part" 01-one.nw 3 'part whistles needs flutes' 'declare it'
refuse "an identifier that may have no definition" 01-one.nw 23 'wfRing is used here, but is defined only with bells' 'mark this code'
refuse "a box that does not say with what" 01-one.nw 27 'does not say with what' 'part='

# ---- labels, references, citations
book labels; chapter 01-one.nw <<'X'
# One {#sec:one}

As @eq:momentum says, and @sec:nowhere, and [@leibniz1686].

$$ p = m v $$ {#eq:momentun .theory}

## Again {#sec:one}

See [here](#lost-place). A mail@example.org is no citation, nor is `@code`.
X
refuse "a broken reference, with a hint" 01-one.nw 3 'nothing is labelled eq:momentum' 'did you mean @eq:momentun'
refuse "a broken section reference" 01-one.nw 3 'nothing is labelled sec:nowhere' 'label it'
refuse "a missing source" 01-one.nw 3 'no source @leibniz1686' 'refs.bib'
refuse "a label defined twice" 01-one.nw 7 'sec:one is defined twice, first at chapters/01-one.nw:1' 'another id'
refuse "a broken link" 01-one.nw 9 'nothing is labelled lost-place' 'label it'
[ "$(grep -c '^chapters/' "$work/log")" -eq 5 ] && ok "all in one run, and nothing else" || bad "there should be five messages"

book code-reference; chapter 01-one.nw <<'X'
# One {#sec:one}

<<core/a.c>>=
int a; /* eq:lost */
<<go by @eq:gone>>
@
<<go by @eq:gone>>=
int b;
@
X
refuse "a broken reference in a comment" 01-one.nw 4 'nothing is labelled eq:lost' 'reference in the code'
refuse "a broken reference in a chunk's name" 01-one.nw 7 'nothing is labelled eq:gone' 'label it'

book equations; chapter 01-one.nw <<'X'
# One {#sec:one}

$$ a = b $$ {#eq:lonely}

$$ a = c $$ {#eq:thought .theory}

$$ a = d $$ {#eq:used name="used"}

<<core/a.c>>=
int a; /* eq:used */
@
X
if weave && grep -qE '^chapters/01-one.nw:3: warning: no code refers to equation eq:lonely -- .*theory' "$work/log" &&
   [ "$(grep -c warning "$work/log")" -eq 1 ]; then ok "an equation without code is a warning"; else bad "an equation without code should be a warning"; fi
strict=--strict refuse "an equation without code, strictly" 01-one.nw 3 'no code refers to equation eq:lonely' 'theory'

# ---- pictures, data
book pictures; chapter 01-one.nw <<'X'
# One {#sec:one}

<<figures/one.c>>=
static const wfFigureRow rows[] = {
    { "known", 0 },
};
const wfFigureSet one_figures = WF_ROWS(rows);
@

![Known.](figures/known.svg){#fig:known}

![A caption
of two lines.](figures/unknown.svg){#fig:unknown}

![A plot.](plots/slope.svg){#fig:slope}

![A photograph.](book/photo.png){#fig:photo}

```{.data file="book/data/nothing.csv" caption="None." #tbl:nothing}
```
X
refuse "a figure that nothing draws" 01-one.nw 13 'no function draws figures/unknown.svg' 'rows of figures/CHAPTER.c'
refuse "a plot without a script" 01-one.nw 15 'no script plots plots/slope.svg' 'book/plots/slope.gp'
refuse "a picture that is not there" 01-one.nw 17 'no file book/photo.png' 'put the file there'
refuse "data that is not there" 01-one.nw 19 'data file book/data/nothing.csv is not there' 'weft-lab run nothing'
grep -q known.svg "$work/log" | grep -v unknown && bad "a drawn figure was refused" || ok "a drawn figure is accepted"

# ---- slips in the prose
book slips; chapter 01-one.nw <<'X'
# One {#sec:one}

Include <stdio.h> here; `<stdlib.h>` is well, and so is $a<b$, and <https://example.org>.

::: {.nota title="x"}
Text.
:::

:::

# Two titles

    indented code with <tags> is well

<<core/a.c>>=
int wfLongNamesThatGoOnAndOn(int first, int second, int third, int fourth, int fifth, int sixth);
@

::: {.note}
Never closed.

$$ a = b {#eq:open}
X
refuse "HTML by accident" 01-one.nw 3 '<stdio.h> in prose' 'backticks'
refuse "an unknown box" 01-one.nw 5 'no box is called .nota' '.note'
refuse "a ::: too many" 01-one.nw 9 'closes nothing' 'delete'
refuse "a second title" 01-one.nw 11 'second heading of level 1' '##'
refuse "code that is too wide" 01-one.nw 16 'has 97 columns' 'break it'
refuse "a box that stays open" 01-one.nw 19 'never closed' ':::'
refuse "an equation that stays open" 01-one.nw 22 'never closed' 'close it'
refuse "a label without its equation" 01-one.nw 22 'does not follow a closing' 'on the line that ends'
[ "$(grep -c '^chapters/.*<' "$work/log")" -eq 1 ] && ok "code, math and addresses are left alone" || bad "only <stdio.h> is an accident"

book fences; chapter 01-one.nw <<'X'
# One {#sec:one}

```
int a;

<<core/a.c>>=
int a;
@
X
refuse "a fence that stays open" 01-one.nw 3 'still open' 'close it'
book untitled; chapter 01-one.nw <<'X'
Just text.
X
refuse "a chapter without a title" 01-one.nw 1 'no title' '# Title'
book twins; printf '# One {#sec:one}\n' | chapter 60-mine.nw; printf '# Two {#sec:two}\n' | chapter 60-yours.nw
refuse "two chapters with one number" 60-yours.nw 1 'number 60 is taken by chapters/60-mine.nw' 'another number'
book names; printf '# One {#sec:one}\n' | chapter 01-one.nw; printf '# Two {#sec:two}\n' | chapter 02-one.nw
refuse "two chapters with one name" 02-one.nw 1 'chapter one is here and in chapters/01-one.nw' 'another name'
book reserved; printf '# Index {#sec:index}\n' | chapter 60-index.nw
refuse "a chapter with the name of a page" 60-index.nw 1 'no chapter can be called index' 'another name'

book terms; chapter 01-one.nw <<'X'
# One {#sec:one index="thing"}

A [thing]{.def} is one.
X
refuse "a term that is marked twice" 01-one.nw 3 "the term 'thing' is marked twice, first at chapters/01-one.nw:1" 'leave one mark'
book nameless; chapter 01-one.nw <<'X'
# One {#sec:one}

$$ y = 2 x $$ {#eq:twice}

<<core/a.c>>=
int wfTwice(int x) { return 2 * x; } /* eq:twice */
@
X
strict=--strict refuse "a formula of the first volume without a name" 01-one.nw 3 'equation eq:twice has no name' 'name='

# ---- a whole small book: numbers agree in HTML and TeX, links lead somewhere
book whole; chapter 02-two.nw <<'X'
# Two *things* {#sec:two}

::: {.goals report="5.1"}
- see @eq:twice in @sec:two-code
:::

Twice a thing is its [double]{.def index="double; pair, same"}. A double is even.

$$ y = 2 x $$ {#eq:twice name="what a double is"}

## Code {#sec:two-code index="code"}

The double of a double is two doubles more than a double. The same pair is a code.

<<core/two.c>>=
<<double by @eq:twice>>
@
<<double by @eq:twice>>=
int wfDouble(int x) { return 2 * x; } /* eq:twice */
@
<<double by @eq:twice>>=
int wfQuadruple(int x) { return wfDouble(wfDouble(x)); }
@
### Deep {#sec:two-deep}

: Numbers. {#tbl:numbers}

| a | b |
|---|---|
| 1 | 2 |

```{.data file="book/data/x.csv" columns="n=Count,e=Error" caption="Measured." #tbl:measured}
```

```{.data file="book/data/old.csv" caption="Compared." #tbl:compared}
```

```{.data file="book/data/new.csv" caption="Compared again." #tbl:new}
```

::: {.exercise #ex:first points=2 difficulty=1 minutes=5 kind=program}
Use [[wfQuadruple(3)]].
:::

::: {.solution for="ex:first"}
Secret answer.
:::
X
printf '# command: build/bin/weft-lab run x\nn,e\n1,2.5e-06\n2,-0.25\n' > "$dir/book/data/x.csv"
mkdir -p "$dir/tests/golden"; cp tests/golden/sum.sh "$dir/tests/golden/"; printf 'heap,9,0123456789abcdef\n' | tee "$dir/tests/golden/scenes.csv" > "$dir/tests/golden/scenes-double.csv"
printf '# command: make portability\n# golden hashes 1-1\nn\n1\n' > "$dir/book/data/old.csv"
printf '# command: make portability\n%s\nn\n1\n' "$("$dir/tests/golden/sum.sh")" > "$dir/book/data/new.csv"
chapter A-primer.nw <<'X'
# Primer {#sec:primer}

By @Eq:twice, @tbl:measured, @tbl:compared, @tbl:new, @ex:first, @sec:two-deep and @sec:two; [@newton1687, law II]. [[wfDouble]] is in C.

$$ a = 1 $$ {#eq:a .theory}

<<core/primer.c>>=
int wfPrimer(void) { return wfDouble(1); }
@
X
if weave && cp book/macros.tex "$dir/book/" && BIB=$dir/book/refs.bib tangle/bib "$dir/out/weave" && weave; then ok "a whole book is accepted"; else bad "a whole book is accepted"; fi
for b in two primer; do
  WEFT_ROOT=$dir tangle/page html $b "$dir/out/weave" "$dir/out/html/$b.html" >>"$work/log" 2>&1 || bad "page $b"
  WEFT_ROOT=$dir tangle/page latex $b "$dir/out/weave" "$dir/out/$b.tex" >>"$work/log" 2>&1 || bad "TeX $b"
done
WEFT_ROOT=$dir tangle/page html formulas "$dir/out/weave" "$dir/out/html/formulas.html" >>"$work/log" 2>&1
html=$dir/out/html/two.html tex=$dir/out/two.tex
has() { if grep -qF -- "$2" "$1"; then ok "$3"; else echo "looked for: $2" > "$work/log"; bad "$3"; fi; }
hasnt() { if grep -qF -- "$2" "$1"; then echo "found: $2" > "$work/log"; bad "$3"; else ok "$3"; fi; }
has "$html" '>(2.1)</a>' "equation number in HTML";           has "$tex" '\wTag{2.1}' "the same in TeX"
has "$html" '<b>Table 2.1.</b>' "table number in HTML";        has "$tex" 'Table~2.1' "the same in TeX"
has "$html" '<b>Table 2.2.</b>' "data table number in HTML";   has "$tex" 'Table~2.2' "the same in TeX"
has "$html" 'Exercise 2.1' "exercise number in HTML";          has "$tex" 'Exercise 2.1' "the same in TeX"
has "$html" '>2.1.1</span>' "subsection number in HTML"
for k in 1 2 3; do has "$html" ">2.$k</a> <span class=\"name\"" "chunk 2.$k in HTML"; has "$tex" "}{2.$k}{" "chunk 2.$k in TeX"; done
has "$html" 'Measured by <code>build/bin/weft-lab run x</code>' "the command under the table"; has "$tex" 'Measured by' "the same in TeX"
for f in "$html" "$tex"; do has "$f" 'Compared. Measured before the last change of arithmetic' "a table older than the golden hashes"; hasnt "$f" 'Compared again. Measured before' "a table as old as they are"; done
has "$html" '10<sup>' "powers of ten"; has "$html" '>Count</th>' "a column's heading"
has "$html" 'Code</i> <a class="cref" href="#c-double-by-eq-twice"><b>2.2</b></a> <a class="cref" href="#c-double-by-eq-twice-2"><b>2.3</b></a>' "an equation leads to its code"
has "$html" 'Equations</i> <a class="xref eq" href="#eq:twice">(2.1)</a>' "code leads back to its equation"
has "$html" '<dfn id="d-wfDouble">' "a definition has an anchor"
has "$html" 'href="#d-wfDouble"' "a use leads to the definition"
has "$dir/out/html/primer.html" 'href="two.html#d-wfDouble"' "across chapters, too"
has "$dir/out/html/primer.html" '>Eq. (2.1)</a>' "a reference says the number"
has "$dir/out/html/primer.html" '>Appendix A</span>' "appendices are called so"
has "$dir/out/html/primer.html" 'id="ref-newton1687"' "the source is listed on the page"
hasnt "$html" 'Secret answer' "solutions stay away from readers"
has "$dir/out/html/index.html" '<li class="planned"><span class="n">3</span> Three' "a planned chapter is listed without a link"
has "$dir/out/html/formulas.html" 'two.html#c-double-by-eq-twice' "the list of formulas leads to the code"
has "$dir/out/html/formulas.html" 'What a double is' "and has the formula's name"; has "$dir/out/html/formulas.html" '#d-wfDouble' "and the function that computes it"
has "$dir/out/weave/formulas-engine.tex" '\wFormula{eq:twice}{2.1}{what a double is}{wf\wBreak{}Double' "the same for print"
has "$html" '<dfn class="term" id="t-double">double</dfn>' "a marked term has an anchor"; has "$tex" '\wTerm{double}\wTerm{pair, same}\emph{double}' "and its page in print"
has "$tex" '\wTerm{code}Code}' "a heading is in the index, too"; has "$tex" '\wPlace{double}The double of' "another place in print"
has "$dir/out/html/subjects.html" '<li>double <b><a href="two.html#t-double" title="Two things">2</a></b> <span class="uses"><a href="two.html#sec:two-code" title="Code">2.1</a></span></li>' "the subject index leads to a term and to where more is said of it"
has "$dir/out/html/source-core-two-c.html" 'two.html#c-double-by-eq-twice' "assembled lines lead to their chunk"
has "$dir/out/weave/chapters-engine.tex" '\wPlanned{3}{Three}' "planned in the PDF's contents, too"
WEFT_ROOT=$dir tangle/page html two "$dir/out/weave" "$dir/out/teacher.html" -M teacher=true >"$work/log" 2>&1
has "$dir/out/teacher.html" 'Secret answer' "solutions are there for teachers"
cp book/book.css book/book.js book/live.js "$dir/out/html/"
if $(tangle/lua) tests/loom/links.lua "$dir/out/html" >"$work/log" 2>&1; then ok "every link of the small book leads somewhere: $(tail -1 "$work/log")"; else bad "broken links"; fi
sed -i 's/id="d-wfDouble"/id="gone"/' "$html"
if $(tangle/lua) tests/loom/links.lua "$dir/out/html" >"$work/log" 2>&1; then bad "the link checker sees nothing"; else ok "the link checker sees a lost anchor"; fi

# ---- what belongs to a chapter: NAME.figures.nw and NAME.lab.nw have pages of their own, and are not printed
book beside; chapter 01-one.nw <<'X'
# One {#sec:one}

The picture is made in @sec:one-drawn, chunk by chunk.

<<core/a.c>>=
int wfOne(void) { return 1; }
@
X
chapter 01-one.figures.nw <<'X'
# How it is drawn {#sec:one-drawn}

## A line {#sec:one-line}

<<lab/b.c>>=
int wfTwo(void) { return 2 * wfOne(); }
@
X
printf '<<lab/c.c>>=\nint c;\n@\n' | chapter 01-one.lab.nw
order() { (cd "$dir" && WEFT_ROOT=$dir "$repo/tangle/chapters" | tr '\n' ' '); }
[ "$(order)" = "chapters/01-one.nw chapters/01-one.figures.nw chapters/01-one.lab.nw " ] && ok "the order of what belongs to a chapter" || { order > "$work/log"; bad "the order of what belongs to a chapter"; }
if (cd "$dir" && WEFT_ROOT=$dir/ "$repo/tangle/weave" --html out/html out/weave $(order)) >"$work/log" 2>&1; then ok "a chapter with figures and measurements"; else bad "a chapter with figures and measurements"; fi
for b in one one.figures one.lab; do WEFT_ROOT=$dir tangle/page html $b "$dir/out/weave" "$dir/out/html/$b.html" >>"$work/log" 2>&1 || bad "page $b"; done
WEFT_ROOT=$dir tangle/page latex one "$dir/out/weave" "$dir/out/one.tex" >>"$work/log" 2>&1 || bad "TeX one"
has "$dir/out/html/one.html" 'href="one.figures.html"' "the chapter leads to its figures"
has "$dir/out/html/one.figures.html" '>1.F.1</span>' "its sections are numbered by it"
hasnt "$dir/out/weave/chapters-engine.tex" 'one.figures' "they are not printed"
hasnt "$dir/out/one.tex" 'hyperlink{sec:one-drawn}' "print has no link to what is not printed"

# ---- what only the pages have: a box, a section; print says how much code it is and where
book web; chapter 01-one.nw <<'X'
# One {#sec:one}

## Shown {#sec:one-shown}

As @sec:one-hidden and @sec:one-deep say, with [[wfHidden()]].

<<core/a.c>>=
<<functions of a>>
@

::: {.web title="Checks of the arguments"}
Words of the box.

<<functions of a>>=
static int boxed(void)
{
    return 1;
}
@
:::

## Hidden {#sec:one-hidden print="web"}

Words of the section.

<<functions of a>>=
int wfHidden(void) { return boxed(); }
@

### Deep {#sec:one-deep}

Words below it.

## Shown again {#sec:one-again}

<<core/b.c>>=
int wfAgain(void) { return wfHidden(); }
@

<<core/b.c>>=
/* A comment
 * of two lines. */
int wfSummed(int n)
{
    int sum = 0;
    for (int i = 0; i < n; i++) {
        sum += i;
        sum += 2 * i;
        sum += 3 * i;
    }
    sum = sum + plus(1,
                     2);
    sum++;
    return sum;
}

int wfFirst(void) { return wfSummed(1); }
int wfSecond(void) { return wfSummed(2); }
int wfThird(void) { return wfSummed(3); }
int wfFourth(void) { return wfSummed(4); }
@
X
if weave; then ok "a book with parts that print leaves out"; else bad "a book with parts that print leaves out"; fi
WEFT_ROOT=$dir tangle/page html one "$dir/out/weave" "$dir/out/html/one.html" >>"$work/log" 2>&1 || bad "page one"
WEFT_ROOT=$dir tangle/page latex one "$dir/out/weave" "$dir/out/one.tex" >>"$work/log" 2>&1 || bad "TeX one"
for w in 'Words of the box' 'Words of the section' 'Words below it' 'static'; do has "$dir/out/html/one.html" "$w" "the page has: $w"; hasnt "$dir/out/one.tex" "$w" "print has not: $w"; done
has "$dir/out/one.tex" '\wOnline{Checks of the arguments}{4 lines of code, }{one.html, chunk 1.2}' "a box in a line"
has "$dir/out/one.tex" '\wOnline{\wLabel{sec:one-hidden}\label{on:sec:one-hidden}1.2\enspace Hidden}{1 line of code, }{one.html, section 1.2}' "a section in a line"
[[ $(grep -oE '^\\wL[A-Z]*\{' "$dir/out/one.tex" | sed 's/^.wL//' | tr -d '\n') == *"N{N{N{N{S{N{D{D{N{S{N{S{N{N{N{G{{N{N{N{"* ]] && ok "where a page may end in code" || bad "where a page may end in code"
hasnt "$dir/out/one.tex" 'wId{d-wfHidden}' "print has no link to what it leaves out"
hasnt "$dir/out/one.tex" 'hyperlink{sec:one-deep}' "nor to its sections"
has "$dir/out/html/one.html" 'class="asm" href="#c-functions-of-a"' "a chunk can be shown assembled"
has "$dir/out/html/data/pieces.js" '"c-functions-of-a":["one.html","one.html"]' "its pieces are known"
hasnt "$dir/out/html/one.html" 'print="web"' "the mark is not on the page"
$(tangle/lua) tests/loom/agree.lua "$dir/out/weave" "$dir/out/html" "$dir/out" >"$work/log" 2>&1 && ok "the numbers agree where print leaves out a section" || bad "the numbers agree where print leaves out a section"
sed -i 's/print="web"/print="wed"/' "$dir/chapters/01-one.nw"
refuse "a mark that says nothing" 01-one.nw 22 'print="wed" says nothing' 'print="web"'

# ---- two volumes: print leads from one to the other, names it once in a chapter, and lists what stands in its own volume
book volumes
printf '=engine\t\tThe engine\tThe engine\tAll of it\n=methods\tM\tMethods for the curious\tMethods\tMore\none\tengine\tImplementation\tOne\t1\nmore\tmethods\tMethods\tMore\t2\ncoursework\tengine\tAppendices\tCoursework\t3\n' > "$dir/book/plan.tsv"
chapter 01-one.nw <<'X'
# One {#sec:one}

See @sec:more-code and @sec:more.

<<include/weft/one.h>>=
<<types of one>>
<<declarations of one>>
@
<<types of one>>=
typedef int wfOne;
@
<<declarations of one>>=
int wfFirst(void);
@
<<declarations of one>>=
int wfSecond(void);     /* of two */
@
<<core/one.c>>=
<<functions of one>>
static const int rows[] = {
    <<rows of the table>>
};
@
<<functions of one>>=
int wfFirst(void) { return 1; }
@
<<rows of the table>>=
1,
2,
3,
4,
5,
6,
7,
8,
@
<<lab/one.c>>=
int lab = 1;
<<rows of the scene table>>
@
<<rows of the scene table>>=
/* { .category = "Motion", .name = "Fall", .build = wfFirst }, */
@

## Read {#sec:one-read}

$$ a = 1 $$ {#eq:one-a}

![A fall.](scenes/fall-10.svg){#fig:one-fall}

<<functions of one>>=
int wfThird(void) { return 3; }  /* eq:one-a */
@

## Tried {#sec:one-tried print="code"}

<<lab/two.c>>=
int bench = 1;
@

## Left out {#sec:one-deep}

![Another.](scenes/fall-20.svg){#fig:one-deep}

## Exercises {#sec:one-exercises}

::: {.exercise #ex:a kind=derive}
One.
:::

::: {.exercise #ex:b kind=derive}
Two.
:::

::: {.exercise #ex:c kind=program}
Three.
:::
X
chapter 02-more.nw <<'X'
# More {#sec:more}

## Code {#sec:more-code}

As in @sec:one.

<<functions of one>>=
int wfSecond(void) { return wfFirst() + 1; }
@
X
chapter A-coursework.nw <<'X'
# Coursework {#sec:coursework}

## Weeks {#sec:coursework-weeks}

| week | read | exercises | at its end |
|---|---|---|---|
| 1 | @sec:one without @sec:one-deep | @ex:a, @ex:b, *@ex:c* | it runs: `fall` |
X
if weave; then ok "a book of two volumes"; else bad "a book of two volumes"; fi
for b in one more; do WEFT_ROOT=$dir tangle/page latex $b "$dir/out/weave" "$dir/out/$b.tex" -M missing=true >>"$work/log" 2>&1 || bad "TeX $b"; done
WEFT_ROOT=$dir tangle/page html more "$dir/out/weave" "$dir/out/html/more.html" >>"$work/log" 2>&1
has "$dir/out/one.tex" '\wFar{methods}{sec:more-code}{Section~M1.1} of \emph{Methods}' "the first reference names the volume"
has "$dir/out/one.tex" '\wFar{methods}{sec:more}{Chapter~M1}.' "the next has its letter"
has "$dir/out/more.tex" '\wFar{engine}{sec:one}{Chapter~1} of \emph{The engine}' "and back"
hasnt "$dir/out/more.tex" 'wId{d-wfFirst}' "print has no link to another volume's code"
has "$dir/out/weave/chapters-engine.tex" 'ch/one' "a volume has its chapters"; hasnt "$dir/out/weave/chapters-engine.tex" 'ch/more' "and no others"
has "$dir/out/weave/chapters-methods.tex" 'ch/more' "which are in theirs"
has "$dir/out/one.tex" '{declarations of one}' "a volume prints its first declaration of a function"
hasnt "$dir/out/one.tex" 'wfSecond' "the others are on the pages"
has "$dir/out/one.tex" 'wfOne' "types are printed"
hasnt "$dir/out/one.tex" '{lab}' "programs of another volume are not"
has "$dir/out/one.tex" '{bench}' "unless their section says so"
has "$dir/out/one.tex" '\wMore{3}{one.html}' "of a long table print has five rows"
has "$dir/out/html/index.html" '<div class="door"><h2><small>Volume 2</small> <a href="more.html">Methods for the curious</a>' "the front page has a door for each volume"
has "$dir/out/html/index.html" '<a href="one.html" title="1 One">1</a>' "and one for the course"
has "$dir/out/html/more.html" '<i class="wk" title="read in week 1 of the course">1</i>' "a chapter of the course has its week beside it"
has "$dir/out/html/more.html" '<details open><summary><b>2</b> Methods' "the volume that is read is open"
slides=$dir/out/weave/slides-1.md
has "$slides" '## [1.1 Read](one.html#sec:one-read)' "a week's slides have its sections"; has "$slides" '$$ a = 1 $$ {#eq:one-a}' "their formulas"
has "$slides" '![A fall.](scenes/fall-10.svg){#fig:one-fall of=one}' "and their figures"; hasnt "$slides" 'fall-20' "and nothing of what is left out"
row='^| 1 |.*'
week() { sed -i "s/$row/| 1 | $1 |/" "$dir/chapters/A-coursework.nw"; }
week '@sec:one | @ex:a, *@ex:c* | it runs: `fall`'; refuse "a week with two exercises" A-coursework.nw 7 'week 1 of the course has 2 exercises' 'name three'
week '@sec:one | @ex:a, @ex:b, @ex:a | it runs: `fall`'; refuse "a week without a program" A-coursework.nw 7 'no program among them' 'one of the kind program'
week '@sec:one | @ex:a, @ex:b, *@ex:c* | it runs: `fell`'; refuse "a week that ends with nothing" A-coursework.nw 7 'ends with nothing that runs' 'name a scene'
week '@sec:more | @ex:a, @ex:b, *@ex:c* | it runs: `fall`'; refuse "a week that reads another volume" A-coursework.nw 7 'reads sec:more, which is not in the first volume' 'name one of its sections'
week '@sec:coursework | @ex:a, @ex:b, *@ex:c* | it runs: `fall`'; refuse "an exercise before its chapter" A-coursework.nw 7 'has ex:a, of a chapter that is read later' 'choose another'

# ---- the book of a smaller engine
book smaller; chapter 01-one.nw <<'X'
# One {#sec:one}

::: {.goals parts="extra:"}
- a goal, see @sec:one-extra
:::

<<core/one.c>>=
int wfAlways(void) { return 1; }
<<more of one>>
@

## Extra {#sec:one-extra part="extra"}

Words of the extra part.

<<more of one>>=
int wfExtra(void) { return wfAlways(); }
@

## Behind {#sec:one-behind}

::: {.only part="extra"}
Words in a box.
:::

Words for all.
X
chapter 02-two.nw <<'X'
# Two {#sec:two}

::: {.goals part="extra"}
- a goal
:::

<<core/two.c>>=
int wfTwo(void) { return 2; }
@
X
if weave --only "" --called "for least"; then ok "the book of an engine without parts"; else bad "the book of an engine without parts"; fi
WEFT_ROOT=$dir tangle/page html one "$dir/out/weave" "$dir/out/html/one.html" >>"$work/log" 2>&1 || bad "its page"
for w in 'Words of the extra' wfExtra 'Words in a box' 'href="#sec:one-extra"'; do hasnt "$dir/out/html/one.html" "$w" "it has not: $w"; done
for w in 'Words for all' wfAlways 'Section 1.1</span>' '1.2</span>'; do has "$dir/out/html/one.html" "$w" "it has: $w"; done
[ "$(tr '\n' ' ' < "$dir/out/weave/bases")" = "this-engine one " ] && ok "its chapters" || { cp "$dir/out/weave/bases" "$work/log"; bad "its chapters"; }
has "$dir/out/weave/this-engine.md" 'the book of an engine for least' "its first chapter tells what for"
rm -rf "$dir/out"
if weave --only extra --called more; then ok "the same with a part"; else bad "the same with a part"; fi
[ "$(tr '\n' ' ' < "$dir/out/weave/bases")" = "this-engine one two " ] && ok "its chapters" || { cp "$dir/out/weave/bases" "$work/log"; bad "its chapters"; }

# ---- a formula that cannot be set
book formula; chapter 01-one.nw <<'X'
# One {#sec:one}

Text.

$$ x = \unknowncommand{2} $$ {#eq:x .theory}
X
weave
if WEFT_ROOT=$dir tangle/page html one "$dir/out/weave" "$dir/out/html/one.html" >"$work/log" 2>&1; then bad "an impossible formula was set"
elif grep -qE '^chapters/01-one.nw:5: this formula cannot become MathML.* -- ' "$work/log"; then ok "an impossible formula"; else bad "an impossible formula: no message for line 5"; fi

echo "loom: $passed passed, $failed failed"
[ $failed -eq 0 ]
