-- plain.lua: a chapter by somebody who is not trusted. It goes before filter.lua, and leaves text, code, formulas, links and the
-- book's own pictures and data. Raw TeX and HTML, attributes that a browser obeys, and whatever lies elsewhere become their own text.
local MATH = {}
for w in ([[ abs alpha approx arccos arcsin arctan arctanh arg backslash bar begin beta big Big bigl bigr Bigl Bigr bigm Bigm bigg Bigg binom bmod bullet cap cases cdot cdots chi
  circ cos cosh cot cup dd ddot ddots Delta delta det dfrac displaystyle div dot dots ell emptyset end epsilon equiv eta exists exp forall frac Gamma gamma ge geq gg hat iff iint
  implies in inf infty int iota kappa Lambda lambda langle lceil ldots le left leftarrow Leftarrow leftrightarrow Leftrightarrow leq lfloor lim limits ll ln lnot log longrightarrow Longrightarrow
  lVert lvert mapsto mathbb mathbf mathbin mathcal mathit mathop mathrel mathrm mathsf max min mod mp mu nabla ne neg neq nolimits norm not notin nu odot oint Omega omega operatorname oplus otimes
  overbrace overline overrightarrow partial perp perpccw phantom Phi phi Pi pi pm prime prod propto Psi psi qquad quad rangle rceil Re rfloor rho right rightarrow Rightarrow rVert rvert
  sgn Sigma sigma sim simeq sin sinh sqrt star subset subseteq sum sup tan tanh tau text textbf textit textrm textstyle texttt tfrac Theta theta tilde times to top Uparrow uparrow
  underbrace underline Upsilon upsilon varepsilon varphi varrho vartheta vdots vec vee Vert vert wedge widehat widetilde Xi xi zeta ]]):gmatch("%a+") do MATH[w] = true end
local ENVIRONMENTS = {}
for w in ("aligned alignedat array bmatrix cases gathered matrix pmatrix smallmatrix split vmatrix Vmatrix"):gmatch("%a+") do ENVIRONMENTS[w] = true end
local function harmless(s)
  if s:find("^^", 1, true) or s:gsub("\\[^%a]", ""):find("[%%#%z\1-\8\11-\31]") then return false end
  for w in s:gmatch("\\([%a@]+)") do if not MATH[w] then return false end end
  for w in s:gmatch("\\begin%s*{?([^}]*)") do if not ENVIRONMENTS[w] then return false end end
  for w in s:gmatch("\\end%s*{?([^}]*)") do if not ENVIRONMENTS[w] then return false end end
  return true
end
local KEYS = { file = "^book/data/[%w_%-]+%.csv$", columns = "^[%w_%-,=%.%(%)/ ²³°µ]*$", where = "^[%w_%-=%. ]*$", caption = "^[^\\`<>$@%[%]{}]*$", points = "^%d+$", minutes = "^%d+$", difficulty = "^%d$",
  kind = "^%a+$", starter = "^[%w%-]+$", report = "^[%w%., ]*$", part = "^[%w%- ]*$", title = "^[^\\`<>$\"{}]*$", width = "^%d+%%$", ["for"] = "^[%w:_%-]+$", test = "^[%w_/%.%-]+$", c = "^$" }
local CLASSES = {}
for w in ("goals exercise solution test data note warning history physics aside only theory c sh text unnumbered"):gmatch("%a+") do CLASSES[w] = true end
local function attributes(el)
  if not el.identifier:match("^[%w:_%-%.]*$") then el.identifier = "" end
  local classes = {}
  for _, c in ipairs(el.classes) do if CLASSES[c] then classes[#classes + 1] = c end end
  el.classes = classes
  local kept = {}
  for k, v in pairs(el.attributes) do if KEYS[k] and v:match(KEYS[k]) and not (k == "file" and el.classes:includes("test")) then kept[k] = v end end
  el.attributes = kept
  return el
end
local function within(el, pattern) return el.src:match(pattern) and not el.src:find("..", 1, true) end
return { {
  RawBlock = function(el) if el.format ~= "weftchunk" or not el.text:match("^%d+$") then return el.text:match("^%s*\\newcommand") and el.format == "tex" and {} or pandoc.CodeBlock(el.text) end end,
  RawInline = function(el) return pandoc.Code(el.text) end,
  Math = function(el) if not harmless(el.text) then return pandoc.Code(el.text) end end,
  Image = function(el)
    if not within(el, "^figures/[%w_%-]+%.svg$") and not within(el, "^plots/[%w_%-]+%.svg$") and not within(el, "^scenes/[%w_%-]+%.svg$") then return pandoc.Code(el.src) end
    return attributes(el)
  end,
  Link = function(el)
    if not el.target:match("^https?://[%w]") and not el.target:match("^#[%w:_%-]+$") then return el.content end
    el.title = ""
    return attributes(el)
  end,
  Div = attributes, Span = attributes, Header = attributes, Code = attributes, CodeBlock = attributes,
} }
