-- mutants.lua: lists the mutants of a C file, or writes the file with one mutant planted.
--   lua mutants.lua list  FILE              one line a mutant: number TAB chapter:line TAB operator TAB original TAB mutant
--   lua mutants.lua plant FILE NUMBER OUT
-- The file comes from the tree with #line directives, so that a mutant is named by its place in the chapter.
-- Operators: + and - exchanged, * and / exchanged, a unary minus dropped, comparisons turned round or their equality changed,
-- && and || exchanged, a literal doubled (or 0 made 1, 1 made 2), += and -= exchanged, wfAdd/wfSub, wfMinR/wfMaxR, sin/cos,
-- wfPerpCW/wfPerpCCW, wfRotate/wfRotateInv, wfApply/wfApplyInv, .x and .y exchanged. Lengths of arrays are left alone.
local mode, file, number, out = arg[1], arg[2], tonumber(arg[3]), arg[4]
local f = assert(io.open(file)); local text = f:read("a"); f:close()

local NAMES = { wfAdd = "wfSub", wfSub = "wfAdd", wfMinR = "wfMaxR", wfMaxR = "wfMinR", wfMin2 = "wfMax2", wfMax2 = "wfMin2",
  wfSin = "wfCos", wfCos = "wfSin", wfPerpCW = "wfPerpCCW", wfPerpCCW = "wfPerpCW", wfRotate = "wfRotateInv",
  wfRotateInv = "wfRotate", wfApply = "wfApplyInv", wfApplyInv = "wfApply" }
local SWAP = { ["+"] = "-", ["-"] = "+", ["*"] = "/", ["/"] = "*", ["+="] = "-=", ["-="] = "+=", ["*="] = "/=",
  ["<"] = ">=", [">"] = "<=", ["<="] = "<", [">="] = ">", ["=="] = "!=", ["!="] = "==", ["&&"] = "||", ["||"] = "&&" }
local TYPES = {}
for w in ("int wfReal float double char void wfVec2 size_t uint8_t uint32_t int32_t uint64_t const return sizeof case"):gmatch("%S+") do TYPES[w] = true end

-- Tokens with their places; comments, strings and preprocessor lines are kept out.
local tokens, i, line, chapter = {}, 1, 1, file
while i <= #text do
  local a, b = text:find("^[ \t]+", i)
  if a then i = b + 1 goto next end
  if text:sub(i, i) == "\n" then i = i + 1; line = line + 1 goto next end
  a, b = text:find("^/%*.-%*/", i)
  if not a then a, b = text:find("^//[^\n]*", i) end
  if a then
    for _ in text:sub(a, b):gmatch("\n") do line = line + 1 end
    i = b + 1 goto next
  end
  a, b = text:find("^#[^\n]*", i)
  if a then
    local l, c = text:sub(a, b):match('^#line (%d+) "(.-)"')
    if l then line, chapter = tonumber(l) - 1, c end
    while text:sub(b, b) == "\\" do                                  -- a macro of several lines
      local c2, d = text:find("^\n[^\n]*", b + 1); if not c2 then break end
      line = line + 1; b = d
    end
    i = b + 1 goto next
  end
  a, b = text:find('^"[^"\n]*"', i)
  if a then
    while text:sub(b - 1, b - 1) == "\\" do local _, e = text:find('^[^"\n]*"', b + 1); if not e then break end b = e end
    i = b + 1 goto next
  end
  a, b = text:find("^'\\?[^\n]'", i)
  if a then i = b + 1 goto next end
  local kind = "op"
  a, b = text:find("^[%a_][%w_]*", i)
  if a then kind = "id" else
    a, b = text:find("^%.?%d[%w%.]*", i)
    if a and text:sub(a, b):match("[eE]$") then local _, e = text:find("^[%+%-]%d+%a*", b + 1); if e then b = e end end
    if a then kind = "num" else
      a, b = text:find("^[%+%-%*/<>=!&|]=?[&|<>%+%-]?", i)
      if a then
        local s = text:sub(a, b)
        for _, op in ipairs { "<<", ">>", "->", "++", "--", "&&", "||", "<=", ">=", "==", "!=", "+=", "-=", "*=", "/=", "&=", "|=" } do
          if s:sub(1, 2) == op then s = op; goto got end
        end
        s = s:sub(1, 1)
        ::got::
        b = a + #s - 1
      else a, b = i, i end
    end
  end
  tokens[#tokens + 1] = { s = text:sub(a, b), kind = kind, a = a, b = b, line = line, chapter = chapter }
  i = b + 1
  ::next::
end

local mutants = {}
local function add(t, operator, new, a, b)
  mutants[#mutants + 1] = { t = t, operator = operator, old = text:sub(a or t.a, b or t.b), new = new, a = a or t.a, b = b or t.b }
end
local depth_brace = 0
for k, t in ipairs(tokens) do
  local p, n = tokens[k - 1], tokens[k + 1]
  if t.s == "{" then depth_brace = depth_brace + 1 elseif t.s == "}" then depth_brace = depth_brace - 1 end
  if depth_brace > 0 and p and n then
    local binary = (p.kind == "num" or p.s == ")" or p.s == "]" or (p.kind == "id" and not TYPES[p.s]))
    local cast = p.s == ")" and tokens[k - 2] and TYPES[tokens[k - 2].s]
    if t.s == "-" and not binary then
      add(t, "drop minus", "", t.a, t.b)
    elseif SWAP[t.s] and binary and not cast then
      if t.s == "*" and (n.s == "*" or TYPES[p.s] or p.s:match("^wf[A-Z]%w*$") and n.kind == "id" and tokens[k + 2] and tokens[k + 2].s:match("^[=;,%)]$") and p.a + #p.s + 1 == t.a and n.a == t.b + 1) then
        -- a declaration of a pointer, not a product
      else add(t, "exchange", SWAP[t.s]) end
    elseif t.kind == "num" and p.s == "[" and n.s == "]" and tokens[k - 3] and tokens[k - 3].kind == "id" then
      -- the length of an array where it is declared: one place more is never looked at
    elseif t.kind == "num" then
      local v = t.s
      if v:match("^%d+$") then add(t, "literal", v == "0" and "1" or tostring(tonumber(v) + 1))
      elseif v:match("^[%d%.]+f?$") and p.s ~= "." then add(t, "literal", "(" .. v .. "*2)") end
    elseif t.kind == "id" and NAMES[t.s] and n.s == "(" then
      add(t, "exchange name", NAMES[t.s])
    elseif t.kind == "id" and (t.s == "x" or t.s == "y") and p.s == "." and k % 3 == 0 then
      add(t, "exchange axis", t.s == "x" and "y" or "x")
    end
  end
end

if mode == "list" then
  for k, m in ipairs(mutants) do
    print(table.concat({ k, m.t.chapter .. ":" .. m.t.line, m.operator, m.old, m.new == "" and "(nothing)" or m.new }, "\t"))
  end
elseif mode == "plant" then
  local m = assert(mutants[number], "no such mutant")
  local o = assert(io.open(out, "w"))
  o:write(text:sub(1, m.a - 1), m.new, text:sub(m.b + 1)); o:close()
end
