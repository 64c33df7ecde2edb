-- bindings.lua: what other languages must know of the public headers, read from the headers themselves.
--
--   tangle/bindings SRC js TEMPLATE      the layout and the signatures of the calls that TEMPLATE makes (C.wfName), for wasm32, put at its /*API*/
--   tangle/bindings SRC exports TEMPLATE the names of these calls, one a line
--   tangle/bindings SRC types TEMPLATE   its types: what stands behind //: in it, with the comments above, and the definitions that it names in <...>
--   tangle/bindings SRC python           every structure, constant and call with its comment, for ctypes
-- SRC is a tangled tree (src-generated). The compiler's preprocessor opens the lists of rows and counts the arrays.
local src, what, template = arg[1], arg[2], arg[3]
local cc = os.getenv("CC") or "cc"

-- ---- the text: what comes from weft/, without the system's headers; comments stay
local lines, ours = {}, false
local p = assert(io.popen(cc .. " -E -CC -I" .. src .. "/include " .. src .. "/include/weft/weft.h"))
for l in p:lines() do
  local file = l:match('^# %d+ "([^"]*)"')
  if file then ours = file:match("/weft/[%w_]+%.h$")
  elseif ours and not l:match("^#") then lines[#lines + 1] = l end
end
p:close()
local text = table.concat(lines, "\n")

-- ---- words, with comments as words of their own
local words, at = {}, 1
while at <= #text do
  local from, to = text:find("^%s+", at)
  if from then at = to + 1
  else
    from, to = text:find("^/%*.-%*/", at)
    if not from then from, to = text:find("^[%a_][%w_]*", at) end
    if not from then from, to = text:find("^%d[%w%.]*", at) end
    if not from then from, to = text:find('^"[^"]*"', at) end
    if not from then from, to = at, at end
    words[#words + 1] = text:sub(from, to)
    at = to + 1
  end
end
local function plain(comment)
  return (comment:gsub("^/%*%s*", ""):gsub("%s*%*/$", ""):gsub("\n%s*%*? ?", " "):gsub("%s+", " ")) end
local i = 1
local function comment() local c; while words[i] and words[i]:match("^/%*") do c = plain(words[i]); i = i + 1 end return c end
local function skip(open, close)                 -- words[i] is the open bracket; behind its partner
  local depth = 0
  repeat
    assert(words[i], "bindings: a bracket is not closed")
    if words[i] == open then depth = depth + 1 elseif words[i] == close then depth = depth - 1 end
    i = i + 1
  until depth == 0
end

-- ---- declarations
local structs, order, enums, values, calls = {}, {}, {}, {}, {}
local sizes = { int = 4, int32_t = 4, uint32_t = 4, wfReal = 4, float = 4, double = 8, int64_t = 8, uint64_t = 8, size_t = 4, bool = 1, _Bool = 1, uint8_t = 1, uint16_t = 2, int16_t = 2, int8_t = 1, char = 1, pointer = 4 }
local function number(list)                      -- a constant expression
  local t = {}
  for _, w in ipairs(list) do t[#t + 1] = values[w] and ("(" .. values[w] .. ")") or w:gsub("^(0[xX]%x+)[uU]$", "%1"):gsub("^(%d+)[uU]$", "%1") end
  local f = load("return " .. table.concat(t, " "):gsub("< <", "<<"):gsub("> >", ">>"))
  local ok, n = pcall(f or error)
  return ok and math.tointeger(n) or nil
end
local function enum()                            -- words[i] is "{"
  i = i + 1
  local next, last = 0, nil
  while words[i] ~= "}" do
    local doc = comment()
    if words[i] == "}" then if last and doc and not last.doc then last.doc = doc end break end
    if doc and last and not last.doc then last.doc = doc; doc = nil end
    local name, expression = words[i], {}
    i = i + 1
    if words[i] == "=" then
      i = i + 1
      while words[i] ~= "," and words[i] ~= "}" and not words[i]:match("^/%*") do expression[#expression + 1] = words[i]; i = i + 1 end
      next = number(expression) or error("bindings: what is the value of " .. name .. "?")
    end
    last = { name = name, value = next, doc = doc }
    values[name] = next
    enums[#enums + 1] = last
    next = next + 1
    last.doc = last.doc or comment()
    if words[i] == "," then i = i + 1 end
  end
  i = i + 1
end
local function type_of(list)                     -- words before a name, to a type
  local pointer, kind = false, nil
  for n, w in ipairs(list) do
    if w == "*" or w == "[" then pointer = true
    elseif w ~= "const" and w ~= "struct" and w ~= "union" and w ~= "volatile" and w ~= "unsigned" and w ~= "static" and w ~= "extern" then kind = kind or w end
  end
  if pointer then return kind == "char" and "text" or "pointer", kind end
  return kind
end
local fields
local function field(into, before)               -- one declaration in a structure
  local list = {}
  if (words[i] == "struct" or words[i] == "union") and (words[i + 1] == "{" or words[i + 2] == "{") then
    local inner = { union = words[i] == "union", fields = {} }
    while words[i] ~= "{" do i = i + 1 end
    fields(inner)
    local name
    if words[i] ~= ";" then name = words[i]; i = i + 1 end
    i = i + 1
    local doc, first, same = before or comment(), inner.fields[1], inner.union and not name
    for _, f in ipairs(inner.fields) do same = same and f.type == first.type and not f.count end
    if same then first.doc = doc; into.fields[#into.fields + 1] = first       -- two names for one number
    else into.fields[#into.fields + 1] = { name = name, type = inner, doc = doc } end
    return
  end
  while words[i] ~= ";" do
    if words[i] == "(" and words[i + 1] == "*" then                                   -- a pointer to a function
      list = { "void", "*", words[i + 2] }
      while words[i] ~= ";" do i = i + 1 end
      break
    end
    list[#list + 1] = words[i]; i = i + 1
    local inner = comment()
    before = before or inner
  end
  i = i + 1
  local doc, base, parts, part = comment() or before, {}, {}, {}
  for _, w in ipairs(list) do if w == "," then parts[#parts + 1] = part; part = {} else part[#part + 1] = w end end
  parts[#parts + 1] = part
  for n, one in ipairs(parts) do
    local count
    for k, w in ipairs(one) do
      if w == "[" then
        local size = {}
        for m = k + 1, #one - 1 do size[#size + 1] = one[m] end
        count = number(size)
        for m = #one, k, -1 do one[m] = nil end
        break
      end
    end
    local name = table.remove(one)
    if n == 1 then base = one end
    into.fields[#into.fields + 1] = { name = name, type = type_of(n == 1 and base or { base[1] == "const" and base[2] or base[1], table.unpack(one) }), count = count, doc = doc }
  end
end
fields = function(into)
  i = i + 1
  while true do
    local doc = comment()
    if words[i] == "}" then i = i + 1 return end
    field(into, doc)
  end
end

local doc, fresh
while i <= #words do
  if words[i]:match("^/%*") then doc, fresh = comment(), true end
  local w = words[i]
  if not w then break end
  if w == ";" then i = i + 1
  elseif w == "enum" or (w == "typedef" and words[i + 1] == "enum") then
    while words[i] ~= "{" do i = i + 1 end
    enum()
    local name = words[i]
    if name ~= ";" then sizes[name] = 4; structs[name] = { enum = true } end
    while words[i] ~= ";" do i = i + 1 end
  elseif w == "_Static_assert" then i = i + 1; skip("(", ")")
  elseif w == "typedef" and (words[i + 1] == "struct" or words[i + 1] == "union") then
    local union, from = words[i + 1] == "union", i
    while words[i] ~= "{" and words[i] ~= ";" do i = i + 1 end
    if words[i] == "{" then
      local s = { union = union, fields = {}, doc = fresh and doc or nil }
      fields(s)
      local name = words[i]
      if name:match("^wfVec%d$") then            -- a union of names for the same; by value it goes like its first
        s.union, s.fields = false, {}
        for letter in ("xyzw"):sub(1, tonumber(name:sub(-1))):gmatch(".") do s.fields[#s.fields + 1] = { name = letter, type = "wfReal" } end
      end
      s.name = name
      structs[name] = s; order[#order + 1] = s
    end
    while words[i] ~= ";" do i = i + 1 end
    doc, fresh = nil, false
  else                                           -- a type of functions, a table, a function
    local head = {}
    while words[i] ~= "(" and words[i] ~= ";" and words[i] ~= "{" and words[i] ~= "=" do
      if not words[i]:match("^/%*") then head[#head + 1] = words[i] end
      i = i + 1
    end
    if words[i] == "(" and head[1] ~= "typedef" then
      local name = table.remove(head)
      local from = i
      skip("(", ")")
      local to = i - 2
      comment()
      local parameters, one, depth = {}, {}, 0
      for k = from + 1, to do
        local v = words[k]
        if v == "," and depth == 0 then parameters[#parameters + 1] = one; one = {} elseif not v:match("^/%*") then one[#one + 1] = v end
      end
      if #one > 0 then parameters[#parameters + 1] = one end
      if words[i] == "{" then skip("{", "}")     -- inline: the language does it by itself
      elseif words[i] == ";" then
        local call = { name = name, doc = nil, result = type_of(head), parameters = {} }
        call.returns = table.concat(head, " ")
        for _, q in ipairs(parameters) do
          if not (#q == 1 and q[1] == "void") then
            local kind, pointed = type_of(q)
            local label = q[#q]
            for _, v in ipairs(q) do if v == "[" then break end label = v:match("^[%a_]") and v or label end
            call.parameters[#call.parameters + 1] = { name = label, type = kind, pointed = pointed, const = q[1] == "const", text = table.concat(q, " ") }
          end
        end
        i = i + 1
        local behind = comment()                 -- of the same line, or of what follows
        call.doc, fresh = doc, false
        calls[#calls + 1] = call
        calls[name] = call
        if behind then doc, fresh = behind, true end
      end
    else
      local depth = 0
      while words[i] ~= ";" or depth > 0 do
        if words[i] == "{" then depth = depth + 1 elseif words[i] == "}" then depth = depth - 1 end
        i = i + 1
      end
      doc = nil
    end
  end
end

-- what a setting means stands in its row, the kinds of joints in their table
local function read(path) local f = assert(io.open(path)); local t = f:read("a"); f:close(); return t end
local rows = {}
for row in read(src .. "/include/weft/setting_rows.h"):gsub("\nWF_", "\0WF_"):gmatch("%zWF_([^%z]*)") do rows[row:match("^%u+%([%w_]+, ([%w_]+),")] = row end
for _, type in ipairs { "wfWorldDef", "wfAdvancedDef" } do
  for _, f in ipairs(structs[type].fields) do
    local row = rows[f.name]
    if row then
      local unit = row:match('%.unit = "([^"]*)"')
      f.doc = row:match('"([^"]*)"', row:find(',%s*"') or 1) .. (unit and ", " .. unit or "")
    end
  end
end
local function kinds() local all = {}
  local f = io.popen("cat " .. src .. "/dynamics/*.c")
  for name in f:read("a"):match("wfJointTable%[%] = (%b{})"):gmatch('{ "([%w%-]+)"') do all[#all + 1] = "'" .. name .. "'" end
  f:close()
  return all
end

-- ---- wasm32: sizes and places
local function measure(type)
  if type == "text" then type = "pointer" end
  local s = structs[type] or (_G.type(type) == "table" and type)
  if not s or s.enum then local n = sizes[type] or 4; return n, n end
  if s.size then return s.size, s.align end
  local at, most, align = 0, 0, 1
  for _, f in ipairs(s.fields) do
    local n, a = measure(f.type)
    n = n * (f.count or 1)
    at = (at + a - 1) // a * a
    f.offset = at
    align = math.max(align, a)
    most = math.max(most, n)
    if not s.union then at = at + n end
  end
  s.align, s.size = align, ((s.union and most or at) + align - 1) // align * align
  return s.size, align
end
local letters = { int = "i", int32_t = "i", uint32_t = "u", wfReal = "f", float = "f", double = "d", uint64_t = "U", int64_t = "U", size_t = "u", bool = "b", _Bool = "b", uint8_t = "b", char = "b", pointer = "u", text = "t", void = "v" }
local function letter(type)
  local s = structs[type]
  if s then return s.enum and "i" or type end
  return letters[type] or "u"
end

local function used(text, also)
  local names, seen = {}, {}
  for object, name in text:gmatch("%f[%w_](%w+)%.(wf%w+)") do
    if object ~= "C" and not (also and object == "wasm") then goto next end
    if not seen[name] then
      if not calls[name] then io.stderr:write(template .. ":1: no header declares " .. name .. " -- its name may have changed\n"); os.exit(1) end
      seen[name] = true; names[#names + 1] = name
    end
    ::next::
  end
  table.sort(names)
  return names
end

if what == "exports" then
  for _, name in ipairs(used(read(template), true)) do print(name) end
elseif what == "js" then
  local text = read(template)
  local out, need, seen = {}, {}, {}
  local function want(type)
    local s = structs[type]
    if not s or s.enum or seen[type] then return end
    seen[type] = true; need[#need + 1] = type
    measure(type)
    local function inner(t) for _, f in ipairs(t.fields) do if _G.type(f.type) == "table" then inner(f.type) else want(f.type) end end end
    inner(s)
  end
  out[#out + 1] = "const calls = {"
  for _, name in ipairs(used(text)) do
    local c, signature = calls[name], {}
    want(c.result)
    for _, q in ipairs(c.parameters) do signature[#signature + 1] = q.type == "pointer" and q.pointed == "wfWorld" and "w" or letter(q.type); want(q.type) end
    out[#out + 1] = ("  %s: '%s %s',"):format(name, c.result == "wfResult" and "!" or letter(c.result), table.concat(signature, " "))
  end
  for name in text:gmatch("'(wf%u%w+)'") do want(name) end
  out[#out + 1] = "};\nconst structs = {"
  local function describe(s, base, list)
    for _, f in ipairs(s.fields) do
      if _G.type(f.type) == "table" then describe(f.type, base + f.offset, list)
      else list[#list + 1] = f.name .. ":" .. base + f.offset .. ":" .. letter(f.type) .. (f.count and ":" .. f.count or "") end
    end
    return list
  end
  for _, type in ipairs(need) do out[#out + 1] = ("  %s: [%d, '%s'],"):format(type, structs[type].size, table.concat(describe(structs[type], 0, {}), " ")) end
  out[#out + 1] = "};\nconst constants = {"
  for _, e in ipairs(enums) do
    if text:find("K%." .. e.name .. "%f[^%w_]") then out[#out + 1] = ("  %s: %d,"):format(e.name, e.value) end
  end
  out[#out + 1] = "};"
  io.write((text:gsub("/%*API%*/", function() return table.concat(out, "\n") end)))
elseif what == "types" then
  local text = read(template)
  local function ts(f)
    local t = f.type
    local one = t == "wfVec2" and "Vec" or (t == "wfFilter" or t == "wfShape" or t == "wfRay") and t:sub(3) or (t == "uint64_t" and "bigint | number") or (structs[t] and not structs[t].enum and "object") or "number"
    return one .. (f.count and "[]" or "")
  end
  local function list(name, optional, from, to)
    local out, on = {}, not from
    for _, f in ipairs(structs[name].fields) do
      if f.name == from then on = true end
      if on and f.name and _G.type(f.type) ~= "table" and f.type ~= "pointer" and f.type ~= "text" and f.name ~= "shape" and f.name ~= "type" and f.name ~= "kind" and f.name ~= "memory" and f.name ~= "advanced" then
        out[#out + 1] = (f.doc and "  /** " .. f.doc .. " */\n" or "") .. "  " .. f.name .. (optional and "?" or "") .. ": " .. ts(f) .. ";"
      end
      if f.name == to then on = false end
    end
    return table.concat(out, "\n")
  end
  local out, doc = {}, {}
  local inside
  for l in (text .. "\n"):gmatch("(.-)\n") do
    local t = l:match("^%s*//: ?(.*)$")
    if l:match("^%s*/%*%*") then doc = { l } elseif #doc > 0 and not doc[#doc]:match("%*/%s*$") then doc[#doc + 1] = l
    elseif t then
      for _, d in ipairs(doc) do out[#out + 1] = d end
      doc = {}
      if t:match("^<") then local name, optional, from, to = t:match("^<(wf%w+)(%??) ?(%w*)%.*(%w*)>"); t = list(name, optional == "?", from ~= "" and from, to) else
        t = t:gsub("<joints>", function() return table.concat(kinds(), " | ") end)
        t = ((t:match("^[}%a]+ ?[%w ]*{?$") or t:match("^export") or t:match("^}")) and "" or "  ") .. t end
      out[#out + 1] = t
    elseif l:match("%S") then doc = {} end
  end
  io.write(table.concat(out, "\n"), "\n")
elseif what == "python" then
  local names = { int = "c_int", int32_t = "c_int32", uint32_t = "c_uint32", int64_t = "c_int64", uint64_t = "c_uint64", double = "c_double", float = "c_float", bool = "c_bool", _Bool = "c_bool", size_t = "c_size_t",
    uint8_t = "c_uint8", uint16_t = "c_uint16", int16_t = "c_int16", int8_t = "c_int8", char = "c_char", pointer = "c_void_p", text = "c_char_p", void = "None", wfReal = "Real" }
  local function python(type) return names[type] or (structs[type] and (structs[type].enum and "c_int" or type)) or "c_void_p" end
  local function quote(s) return '"""' .. s:gsub("\\", "\\\\"):gsub('"', '\\"') .. '"""' end
  local out, hidden = {}, 0
  local function put(...) out[#out + 1] = string.format(...) end
  local function structure(name, s)
    local list, anonymous, docs = {}, {}, {}
    for _, f in ipairs(s.fields) do
      local t = f.type
      if _G.type(t) == "table" then hidden = hidden + 1; t = "_Part" .. hidden; structure(t, f.type) else t = python(t) end
      local label = f.name or ("_part" .. #list)
      if not f.name then anonymous[#anonymous + 1] = "'" .. label .. "'" end
      list[#list + 1] = ("('%s', %s)"):format(label, f.count and t .. " * " .. f.count or t)
      if f.name and f.doc then docs[#docs + 1] = "    " .. f.name .. ": " .. f.doc end
    end
    put("class %s(%s):\n    %s", name, s.union and "_Union" or "_Structure", quote((s.doc or "") .. (#docs > 0 and "\n\n" .. table.concat(docs, "\n") .. "\n    " or "")))
    if #anonymous > 0 then put("    _anonymous_ = (%s,)", table.concat(anonymous, ", ")) end
    put("    _fields_ = [%s]", table.concat(list, ", "))
  end
  for _, s in ipairs(order) do structure(s.name, s) end
  for _, e in ipairs(enums) do put("%s = %d", e.name, e.value) end
  for _, c in ipairs(calls) do
    local types, labels = {}, {}
    for _, q in ipairs(c.parameters) do types[#types + 1] = python(q.type); labels[#labels + 1] = q.text end
    put("_call('%s', %s, [%s], %s)", c.name, c.result == "wfResult" and "'result'" or python(c.result), table.concat(types, ", "),
      quote(c.returns .. " " .. c.name .. "(" .. table.concat(labels, ", "):gsub("%* ", "*") .. ")\n\n" .. (c.doc or "")))
  end
  io.write(table.concat(out, "\n"), "\n")
end
