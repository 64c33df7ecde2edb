-- weave-code.lua: what weave.lua and filter.lua share: a lexer for C, and code, names and links as HTML and as TeX.
local M = {}

M.keywords = {}
for w in ([[auto break case char const continue default do double else enum extern float for goto if inline int long register
  restrict return short signed sizeof static struct switch typedef union unsigned void volatile while bool true false NULL
  _Static_assert _Alignas _Alignof _Bool _Generic _Noreturn]]):gmatch("%S+") do M.keywords[w] = true end

M.kind_name = { eq = "Eq.", fig = "Figure", tbl = "Table", sec = "Section", ex = "Exercise" }

function M.read(path)
  local f = io.open(path, "rb")
  if not f then return nil end
  local s = f:read("a")
  f:close()
  return s
end

function M.write_if_changed(path, text)
  if M.read(path) == text then return false end
  local f = assert(io.open(path, "wb"))
  f:write(text)
  f:close()
  return true
end

-- A Lua value as text, with sorted keys, so that the same value always gives the same bytes.
local quoted = {}
local function quote(s)
  local q = quoted[s]
  if not q then
    q = string.format("%q", s)
    if q:find("\n", 1, true) then q = q:gsub("\\\n", "\\n") end
    quoted[s] = q
  end
  return q
end
local function put(out, v)
  local kind = type(v)
  if kind == "string" then out[#out + 1] = quote(v)
  elseif kind == "table" then
    local n = #v
    out[#out + 1] = "{"
    for i = 1, n do
      put(out, v[i])
      out[#out + 1] = ","
    end
    local all = 0
    for _ in pairs(v) do all = all + 1 end
    if all > n then                                      -- what is beside the list
      local keys = {}
      for k in pairs(v) do
        if not (math.type(k) == "integer" and k >= 1 and k <= n) then keys[#keys + 1] = k end
      end
      table.sort(keys, function(a, b) return tostring(a) < tostring(b) end)
      for _, k in ipairs(keys) do
        out[#out + 1] = "[" .. (type(k) == "number" and tostring(k) or quote(k)) .. "]="
        put(out, v[k])
        out[#out + 1] = "\n,"
      end
    end
    out[#out + 1] = "}"
  else out[#out + 1] = tostring(v) end
end
function M.serialise(v)
  local out = {}
  put(out, v)
  return table.concat(out)
end

------------------------------------------------------------------------------------------------------------- lexer
-- Splits one line of C into { class, text }; `inside` says that the line begins within a comment.
-- Classes: "" (other), "sp", "id", "nu", "st", "co", "pp". Returns the tokens and whether the line ends in a comment.
function M.lex(s, inside)
  local out, i, n = {}, 1, #s
  local function put(class, a, b) out[#out + 1] = { class, s:sub(a, b) }; i = b + 1 end
  if inside then
    local _, b = s:find("*/", 1, true)
    if not b then
      if n > 0 then put("co", 1, n) end
      return out, true
    end
    put("co", 1, b)
  end
  local directive = s:match("^%s*#%s*(%a+)")
  while i <= n do
    local _, b = s:find("^%s+", i)
    if b then put("sp", i, b) goto next end
    if s:sub(i, i + 1) == "/*" then
      _, b = s:find("*/", i + 2, true)
      if not b then put("co", i, n) return out, true end
      put("co", i, b) goto next
    end
    if s:sub(i, i + 1) == "//" then put("co", i, n) goto next end
    local c = s:sub(i, i)
    if c == '"' or c == "'" then
      local j = i + 1
      while j <= n and s:sub(j, j) ~= c do j = j + (s:sub(j, j) == "\\" and 2 or 1) end
      put("st", i, math.min(j, n)) goto next
    end
    if c == "<" and directive == "include" then
      _, b = s:find("^<[^>]*>", i)
      if b then put("st", i, b) goto next end
    end
    _, b = s:find("^#%s*%a+", i)
    if b and s:sub(1, i - 1):match("^%s*$") then put("pp", i, b) goto next end
    _, b = s:find("^%.?%d[%w%.]*", i)
    if b then
      while s:sub(b, b):match("[eEpP]") and s:sub(b + 1, b + 1):match("[+-]") do
        local _, e = s:find("^%d*%a*", b + 2)
        b = e
      end
      put("nu", i, b) goto next
    end
    _, b = s:find("^[%a_][%w_]*", i)
    if b then put("id", i, b) goto next end
    _, b = s:find("^%->", i)
    put("", i, b or i)
    ::next::
  end
  return out, false
end

----------------------------------------------------------------------------------------------------------- escapes
function M.term_id(text) return "t-" .. text:lower():gsub("[^%w]+", "-") end
-- What makeindex sorts and TeX writes: its own signs have a quote before them.
function M.tex_term(term) return (M.tex(term):gsub('[!@|"]', '"%0')) end
function M.tex_terms(list) return (list:gsub("%s*([^;]*[^;%s]);?", function(term) return "\\wTerm{" .. M.tex_term(term) .. "}" end)) end
function M.tex_id(id) return (id:gsub("_", "=")) end
function M.html(s) return (s:gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" })) end

local tex_map = { ["\\"] = "\\textbackslash{}", ["{"] = "\\{", ["}"] = "\\}", ["#"] = "\\#", ["$"] = "\\$", ["%"] = "\\%",
  ["&"] = "\\&", ["_"] = "\\_", ["^"] = "\\textasciicircum{}", ["~"] = "\\textasciitilde{}" }
function M.tex(s) return (s:gsub("[\\{}#%$%%&_%^~]", tex_map)) end
local code_map = { ["`"] = "\\textasciigrave{}", ["'"] = "\\textquotesingle{}", ['"'] = "\\textquotedbl{}", ["-"] = "{-}", ["<"] = "{<}", [">"] = "{>}", [" "] = "\\ " }
for k, v in pairs(tex_map) do code_map[k] = v end
function M.tex_code(s) return (s:gsub("[\\{}#%$%%&_%^~`'\"%-<> ]", code_map)) end

-- A formula within a line as plain signs, without TeX.
local signs = {}
for w, sign in ([[cdot · times × le ≤ leq ≤ ge ≥ geq ≥ ne ≠ neq ≠ approx ≈ sim ~ infty ∞ pm ± mp ∓ to → rightarrow → Rightarrow ⇒ sum Σ int ∫ partial ∂ sqrt √ in ∈ ll ≪ gg ≫ propto ∝ circ ° ldots … dots …
  alpha α beta β gamma γ delta δ epsilon ε varepsilon ε zeta ζ eta η theta θ kappa κ lambda λ mu μ nu ν xi ξ pi π rho ρ sigma σ tau τ phi φ varphi φ chi χ psi ψ omega ω Gamma Γ Delta Δ Theta Θ Lambda Λ
  Pi Π Sigma Σ Phi Φ Psi Ψ Omega Ω perp ⊥ perpccw ⊥ top T lVert ‖ rVert ‖ Vert ‖ lvert | rvert | langle ⟨ rangle ⟩ cross ×]]):gmatch("(%a+) (%S+)") do signs[w] = sign end
local powers = { ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶", ["7"] = "⁷", ["8"] = "⁸", ["9"] = "⁹", ["-"] = "⁻" }
local function plain_math(m)
  local function raised(p) return p:match("^[%d%-]+$") and p:gsub(".", powers) or (#p == 1 and "^" .. p or "^(" .. p .. ")") end
  for _ = 1, 3 do m = m:gsub("\\[dt]?frac%s*(%b{})%s*(%b{})", function(a, b) return a:sub(2, -2) .. "/" .. b:sub(2, -2) end):gsub("\\[dt]?frac(%d)(%d)", "%1/%2") end
  m = m:gsub("%^(%b{})", function(p) return raised(p:sub(2, -2)) end):gsub("%^(%d)", raised)
  m = m:gsub("\\[,;:! ]", " "):gsub("\\([{}%%#&_$])", "%1"):gsub("\\q?quad", " "):gsub("\\(%a+)", function(w)
    return signs[w] or (w:match("^math") or w:match("^text") or w:match("^operatorname") or w:match("^[lr]?e?[fi]?[gf]?h?t$") or w:match("^[bB]igg?[lrm]?$") or w:match("^[dh]?d?[oa]t$") or
      w:match("^bar$") or w:match("^vec$") or w:match("^tilde$") or w:match("^over") or w:match("^under") or w:match("style$")) and "" or w
  end)
  return (m:gsub("[{}\\]", ""):gsub("%s+", " "):gsub("^ ", ""):gsub(" $", ""))
end

-- Markdown as plain words: for titles, tooltips, the search index.
function M.plain(s)
  s = s:gsub("%[([^%[%]]+)%]{%.def[^}]*}", "%1"):gsub("%[%[(.-)%]%]", "%1"):gsub("`([^`]*)`{[^}]*}", "%1"):gsub("!?%[([^%]]*)%]%b()", "%1"):gsub("%s*{[#%.][^}]*}", "")
  s = s:gsub("%$(.-)%$", plain_math)
  s = s:gsub("%*%*?([^%*]+)%*%*?", "%1"):gsub("[`\\]", ""):gsub("%-%-%-", "\u{2014}"):gsub("%-%-", "\u{2013}")
  return s
end

-------------------------------------------------------------------------------------------------------- references
-- "Eq. (7.3)", "Section 7.2", "Chapter 7", "Appendix A"
function M.ref_text(label)
  if label.kind == "eq" then return "Eq. (" .. label.num .. ")" end
  if label.kind == "sec" and not label.num:find(".", 1, true) then                -- 7, M1, A
    return (label.num:match("^%u$") and "Appendix " or "Chapter ") .. label.num
  end
  return M.kind_name[label.kind] .. " " .. label.num
end

-- The name of a chunk (Markdown: [[code]], `code`, $math$, @eq:x) as HTML or TeX; db.labels gives the numbers.
function M.name(db, name, format)
  local esc = format == "html" and M.html or M.tex
  if name:match("^[%w_%-%./]+%.%a+$") and name:find("/") then
    return format == "html" and "<code>" .. esc(name) .. "</code>" or "\\wNameCode{" .. esc(name) .. "}"
  end
  local out, i = {}, 1
  while i <= #name do
    local a, b, x = name:find("^%[%[(.-)%]%]", i)
    if not a then a, b, x = name:find("^`(.-)`", i) end
    if a then out[#out + 1] = format == "html" and "<code>" .. esc(x) .. "</code>" or "\\wNameCode{" .. esc(x) .. "}" goto next end
    a, b, x = name:find("^%$(.-)%$", i)
    if a then out[#out + 1] = format == "html" and "<i>" .. esc(M.plain("$" .. x .. "$")) .. "</i>" or "$" .. x .. "$" goto next end
    a, b, x = name:find("^@(%a+:[%w_%-]*%w)", i)
    if a then
      local l = db.labels[x:sub(1, 1):lower() .. x:sub(2)]
      local text = l and M.ref_text(l) or x
      out[#out + 1] = format == "html" and esc(text):gsub(" ", "\u{a0}") or esc(text):gsub(" ", "~")
      goto next
    end
    a, b, x = name:find("^%*([^%*]+)%*", i)
    if a then out[#out + 1] = format == "html" and "<em>" .. esc(x) .. "</em>" or "\\emph{" .. esc(x) .. "}" goto next end
    a, b = name:find("^[^%[`%$@%*]+", i)
    if not a then a, b = i, i end
    out[#out + 1] = esc(name:sub(a, b))
    ::next::
    i = b + 1
  end
  return table.concat(out)
end

function M.href(db, page, here, id) return (page == here and "" or db.up .. page) .. (id and "#" .. id or "") end

-- MathML by pandoc marks every bracket as stretchy; Chromium sets those with wide gaps. Only brackets around tall things keep it.
function M.calm_brackets(s)
  s = s:gsub('minsize="([%d%.]+)" maxsize="[%d%.]+" stretchy="false"', function(size)     -- \\big and its kin
    if tonumber(size) < 1.5 then return 'stretchy="false"' end
    return 'minsize="' .. size .. 'em" maxsize="' .. size .. 'em" stretchy="true" symmetric="true"'
  end)
  local tall = { "<mfrac", "<mtable", "<munder", "<mover", "<msqrt", "<mroot", "<mo>\u{2211}", "<mo>\u{222b}" }
  local open = '<mo stretchy="true" form="prefix">'
  local close = '<mo stretchy="true" form="postfix">'
  local stack, marks, i = {}, {}, 1
  while true do
    local a, b = s:find('<mo stretchy="true" form="p%a+">', i)
    local m = s:find("</math>", i, true)
    if m and (not a or m < a) then stack = {} end
    if not a then break end
    if s:sub(a, b) == open then stack[#stack + 1] = a
    else
      local from = table.remove(stack)
      if from then
        local inner, is_tall = s:sub(from, a), false
        for _, t in ipairs(tall) do is_tall = is_tall or inner:find(t, 1, true) ~= nil end
        if not is_tall then marks[from] = true; marks[a] = true end
      end
    end
    i = b + 1
  end
  local out, last = {}, 1
  local list = {}
  for k in pairs(marks) do list[#list + 1] = k end
  table.sort(list)
  for _, k in ipairs(list) do
    out[#out + 1] = s:sub(last, k - 1) .. '<mo stretchy="false"'
    last = k + #'<mo stretchy="true"'
  end
  out[#out + 1] = s:sub(last)
  return table.concat(out)
end

------------------------------------------------------------------------------------------------------ code, rendered
-- A line is a list of tokens: { class, text [, target, title] } where class is one of the lexer's, or
--   "kw" keyword, "ref" an identifier (target "page#anchor"), "def" the place that defines it (target = anchor),
--   "eq" a reference in a comment (target = label), "use" a chunk reference (text = its name).
function M.line_html(db, line, here, tokens_only)
  local out = {}
  for _, t in ipairs(line) do
    local class, text = t[1], M.html(t[2])
    if class == "" or class == "sp" or class == "id" then out[#out + 1] = text
    elseif class == "ref" then
      local page, id = t[3]:match("^(.-)#(.*)$")
      out[#out + 1] = '<a class="id" href="' .. M.href(db, page, here, id) .. '"' .. (t[4] and ' title="' .. M.html(t[4]) .. '"' or "") .. ">" .. text .. "</a>"
    elseif class == "def" then
      out[#out + 1] = tokens_only and "<dfn>" .. text .. "</dfn>" or '<dfn id="' .. t[3] .. '">' .. text .. "</dfn>"
    elseif class == "eq" then
      local l = db.labels[t[3]]
      out[#out + 1] = '<a class="co" href="' .. M.href(db, l.page, here, t[3]) .. '">' .. M.html(M.ref_text(l)) .. "</a>"
    elseif class == "use" then
      local n = db.names[t[2]]
      if n and n.id then
        out[#out + 1] = '<a class="use" href="' .. M.href(db, n.page, here, n.id) .. '">\u{27e8}' .. M.name(db, t[2], "html") .. " <b>" .. n.num .. "</b>\u{27e9}</a>"
      else
        out[#out + 1] = '<span class="use lost">\u{27e8}' .. M.name(db, t[2], "html") .. " ?\u{27e9}</span>"
      end
    else out[#out + 1] = '<span class="' .. class .. '">' .. text .. "</span>" end
  end
  return table.concat(out)
end

-- Does a link of a printed volume (db.mine) to "page#anchor" lead out of it: to another volume, or to what the web edition alone has?
function M.far(db, page) return db.mine and (db.volume_of[page] or db.mine) ~= db.mine end
function M.online(db, target)
  local page = target:match("^(.-)#")
  return db.online[page] or db.online[target:match("#(.*)$")] or M.far(db, page)
end

local tex_class = { co = "wCo", st = "wSt", pp = "wPp", nu = "wNu", kw = "wKw" }
function M.line_tex(db, line, index)
  local out = {}
  for _, t in ipairs(line) do
    local class, text = t[1], M.tex_code(t[2])
    if tex_class[class] then out[#out + 1] = "\\" .. tex_class[class] .. "{" .. text .. "}"
    elseif class == "ref" and M.online(db, t[3]) then out[#out + 1] = (index and index(t[2], false) or "") .. text
    elseif class == "ref" then
      out[#out + 1] = (index and index(t[2], false) or "") .. "\\wId{" .. M.tex_id(t[3]:match("#(.*)$")) .. "}{" .. text .. "}"
    elseif class == "def" then
      out[#out + 1] = (index and index(t[2], true) or "") .. "\\wDef{" .. M.tex_id(t[3]) .. "}{" .. text .. "}"
    elseif class == "eq" then
      local l, text = db.labels[t[3]], M.tex_code(M.ref_text(db.labels[t[3]]))
      out[#out + 1] = "\\wCo{" .. ((l.online or M.far(db, l.page)) and text or "\\hyperlink{" .. t[3] .. "}{" .. text .. "}") .. "}"
    elseif class == "use" then
      local n = db.names[t[2]]
      out[#out + 1] = n and (n.online or M.far(db, n.page)) and "\\wUseOnline{" .. n.num .. "}{" .. M.name(db, t[2], "tex") .. "}" or
        "\\wUse{" .. (n and n.id or "") .. "}{" .. (n and n.num or "?") .. "}{" .. M.name(db, t[2], "tex") .. "}"
    else out[#out + 1] = text end
  end
  return table.concat(out)
end

return M
