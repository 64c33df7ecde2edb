-- amalgam.lua: the engine as two files, weft.h and weft.c, made from the tangled chapters.
--   tangle/amalgam SRC OUT        SRC: a tangled tree without #line (src-generated); OUT: where the two files go
-- weft.h is every public header but report.h (the report's names) and draw.h (the pen of the book's figures), each once, those first that others include. weft.c is every source of the five
-- components behind it. Names that are static in two of the sources get the source's name in front.
local src, out = arg[1], arg[2]
local function fail(text) io.stderr:write("amalgam: " .. text .. "\n"); os.exit(1) end
if not out then fail("usage: tangle/amalgam SRC OUT") end

local function read(name)
  local f = io.open(src .. "/" .. name) or fail(src .. "/" .. name .. " cannot be read -- type: make tangle")
  local text = f:read("a"); f:close()
  return text
end
local function list(pattern)
  local names, p = {}, io.popen("cd '" .. src .. "' && ls " .. pattern .. " 2>/dev/null")
  for name in p:lines() do names[#names + 1] = name end
  p:close()
  return names
end

-- ---- what stands in for #include ------------------------------------------------------------------------------------------
-- A header of Weft's is put where it is first asked for; one without a guard (a list of rows) wherever it is asked for. A
-- header that every compiler has goes to the top of the file; others stay where they are, under their conditions.
local done, system, first = {}, {}, {}
-- Every function that a source defines. Those that only private headers declare become static, but for what the reader of scenes calls (WF_FOR_SCENES).
local defined = {}
for _, part in ipairs { "core", "math", "collision", "dynamics", "engine" } do
  for _, name in ipairs(list(part .. "/*.c")) do
    if name ~= "engine/report.c" and name ~= "core/draw.c" then
      for f in ("\n" .. read(name)):gmatch("\n%a[%w_ %*]-([%w_]+)%([^;{]-%)\n{") do defined[f] = true end
    end
  end
end
local free = { ["<stdbool.h>"] = true, ["<stddef.h>"] = true, ["<stdint.h>"] = true, ["<float.h>"] = true, ["<string.h>"] = true }
local function find(name)
  local f = io.open(src .. "/include/" .. name)
  if f then f:close(); return "include/" .. name end
  return name
end
local function inline(name, sink)
  local text = read(name)
  local guard = text:match("#ifndef (WEFT_[%w_]+_H)\n#define %1")
  if guard and done[name] then return end
  done[name] = true
  local private = guard and not name:match("^include/")
  for line in (text .. "\n"):gmatch("(.-)\n") do
    local own, theirs = line:match('^#include "([^"]+)"'), line:match("^#include (<[^>]+>)")
    if own then inline(find(own), sink)
    elseif line:match("^%s*#define _%u[%u_]+ ") then  -- what asks system headers for more
      local name = line:match("#define (%S+)")
      first[#first + 1] = "#ifndef " .. name .. "\n" .. line .. "\n#endif"
    elseif theirs and free[theirs] then system[theirs] = true
    else
      local f = private and line:match("^%a[%w_ %*]-([%w_]+)%(")
      local is_open = line:match("^static") or line:match("^WF_FOR_SCENES")
      sink[#sink + 1] = f and defined[f] and not is_open and "WF_PRIVATE " .. line or line
    end
  end
end
local function drop_heads(lines)        -- the tangled file's own head: two or more lines that say where it comes from
  local text = table.concat(lines, "\n")
  text = text:gsub("/%* Weft: ([%w_/%.]+), tangled from chapters/([%w%-%./]+)%.nw%..-%*/", "/* ---- %1 (chapter %2) ---- */")
  return text:gsub("\n\n\n+", "\n\n")
end

-- ---- names -----------------------------------------------------------------------------------------------------------------
-- File-scope names of a source: its static functions and arrays, its types, its macros.
local function own_names(text)
  local names = {}
  for line in text:gmatch("[^\n]+") do
    local head = line:match("^static (.+)")
    local name = head and (head:match("([%a_][%w_]*)%s*%(") or head:match("([%a_][%w_]*)%s*%[") or head:match("([%a_][%w_]*)%s*[=;]"))
    name = name or line:match("^typedef struct ([%a_][%w_]*) {") or line:match("^struct ([%a_][%w_]*) {") or line:match("^} ([%a_][%w_]*);")
      or line:match("^#define ([%a_][%w_]*)")
    if name then names[name] = true end
    local list = line:match("^enum {(.-)}")
    for constant in ("," .. (list or "")):gmatch(",%s*([%a_][%w_]*)") do names[constant] = true end
  end
  return names
end
-- The text with the names of a table replaced: not in strings and comments, not members behind . and ->.
local function rename(text, names)
  local inside = {}                     -- the bodies of structs: what is declared there are members
  for from, to in text:gmatch("struct%s*[%w_]*%s*()%b{}()") do inside[#inside + 1] = { from, to } end
  local function is_member(from, to)
    if text:sub(from - 2, from - 1) == "(*" and text:sub(to + 1, to + 2) == ")(" then return true end
    if not text:sub(to + 1, to + 1):match("[;,%[]") then return false end
    for _, range in ipairs(inside) do if range[1] < from and to < range[2] then return true end end
    return false
  end
  local parts, at, before = {}, 1, ""
  while at <= #text do
    local from, to = text:find("^/%*.-%*/", at)
    if not from then from, to = text:find('^"[^"\n]*"', at) end
    if not from then from, to = text:find("^'\\?.'", at) end
    if from then parts[#parts + 1] = text:sub(from, to)
    else
      from, to = text:find("^[%a_][%w_]*", at)
      if from then
        local word = text:sub(from, to)
        parts[#parts + 1] = names[word] and not before:match("[%.>]$") and not is_member(from, to) and names[word] or word
        before = word
      else
        to = at
        local c = text:sub(at, at)
        if c == ">" and before ~= "-" then before = " " elseif c ~= " " then before = c == "." and "." or c end
        parts[#parts + 1] = c
      end
    end
    at = to + 1
  end
  return table.concat(parts)
end

-- ---- what C++ asks for ---------------------------------------------------------------------------------------------------------
-- C turns a void pointer into any other by itself, C++ wants to be told. WF_ANY_POINTER(p) is p in C, and in C++ something that turns
-- into any pointer. It is put round calls of functions that return void pointers, casts to them, and variables that hold them.
local returns_void = { WF_NATIVE_ALLOC = true }
local void_members = {}
local function void_functions(text)
  for name in text:gmatch("\n    [ ]*c?o?n?s?t?[ ]*void[ ]+%*([%a_][%w_]*);") do void_members[name] = true end
  for name in text:gmatch("void %*([%a_][%w_]*)%(") do returns_void[name] = true end
end
local function cast(text)
  local void = {}
  for name in pairs(void_members) do void[name] = true end
  for name in text:gmatch("void %*const ([%a_][%w_]*)") do void[name] = true end
  for name in text:gmatch("void %*([%a_][%w_]*)[,;%)%s]") do void[name] = true end
  local lines = {}
  for line in (text .. "\n"):gmatch("(.-)\n") do
    if line:match("^%s") then           -- inside a function
      local function wrap(part)
        return (part:gsub("%f[%w_]([%a_][%w_]*)(%b())", function(name, list)
          list = "(" .. wrap(list:sub(2, -2)) .. ")"
          return returns_void[name] and not line:match("^%s*void %*") and "WF_ANY_POINTER(" .. name .. list .. ")" or name .. list end))
      end
      line = wrap(line)
      line = line:gsub("^(%s+[%w_ ]-%*?[%w_%.%->]+ = )([%w_%.%->]-)([%a_][%w_]*);$", function(left, path, name)
        return void[name] and not left:match("void %*") and left .. "WF_ANY_POINTER(" .. path .. name .. ");" or nil end)
    end
    line = line:gsub("(%.[%w_]+ = )([%w_%.%->]-)%.([%a_][%w_]*)([, ])", function(left, path, name, after)
      return void[name] and left .. "WF_ANY_POINTER(" .. path .. "." .. name .. ")" .. after or nil end)
    line = line:gsub("(%.[%w_]+ = )([%a_][%w_]*)([, ])", function(left, name, after)
      return void[name] and left .. "WF_ANY_POINTER(" .. name .. ")" .. after or nil end)
    lines[#lines + 1] = line
  end
  return (table.concat(lines, "\n", 1, #lines - 1):gsub("%(const void %*%)(%b())", "WF_ANY_POINTER%1"):gsub("%(void %*%)(%b())", "WF_ANY_POINTER%1"))
end
-- Fields that are named in an initialiser must come in the order of the struct.
local orders = {}                       -- of a struct: the place and the type of each field
local function learn(text)
  text = text:gsub("/%*.-%*/", "")
  local function fields(body, into)
    body = body:gsub("%f[%w_](%a+) (%b{})(%s*[%w_]*%s*;)", function(kind, inner, name)
      if kind ~= "struct" and kind ~= "union" then return nil end
      if name:match("^%s*;") then local flat = {}; return inner:sub(2, -2) end
      return "nested" .. name end)
    for declaration in body:gmatch("([^;]+);") do
      local type = declaration:match("^%s*const ([%w_]+)") or declaration:match("^%s*struct ([%w_]+)") or declaration:match("^%s*([%w_]+)")
      local function note(name) if name then into[0] = into[0] + 1; into[name] = { into[0], type } end end
      if declaration:match("%(%*") then note(declaration:match("%(%*([%w_]+)"))
      else for part in declaration:gsub("%b[]", ""):gsub("%b()", ""):gmatch("[^,]+") do note(part:match("([%a_][%w_]*)%s*$")) end end
    end
  end
  local function take(name, body) orders[name] = { [0] = 0 }; fields(body:sub(2, -2), orders[name]) end
  for body, name in text:gmatch("typedef struct [%w_]* ?(%b{}) ([%w_]+);") do take(name, body) end
  for body, name in text:gmatch("typedef struct (%b{}) ([%w_]+);") do take(name, body) end
  for name, body in text:gmatch("\nstruct ([%w_]+) (%b{});") do take(name, body) end
end
local function split(list)              -- at commas that are in no brackets
  local items, depth, from = {}, 0, 1
  for at = 1, #list do
    local c = list:sub(at, at)
    if c:match("[%(%[{]") then depth = depth + 1 elseif c:match("[%)%]}]") then depth = depth - 1
    elseif c == "," and depth == 0 then items[#items + 1] = list:sub(from, at - 1); from = at + 1 end
  end
  local last = list:sub(from)
  if last:match("%S") then items[#items + 1] = last end
  return items
end
local order
local function arrange(type, braces)    -- "{ ... }" of that struct
  local inner = order(braces:sub(2, -2))
  local fields, items = orders[type], split((inner:gsub("/%*.-%*/", "")))
  local places, sorted, nested = {}, true, false
  for i, item in ipairs(items) do
    local name, value = item:match("^%s*%.([%a_][%w_]*) = (.*)$")
    if not name or not fields[name] then return "{" .. inner .. "}" end
    if orders[fields[name][2]] and value:match("^{") then
      local new = value:gsub("^%b{}", function(b) return arrange(fields[name][2], b) end)
      if new ~= value then item = " ." .. name .. " = " .. new; nested = true end
    end
    places[i] = { fields[name][1], (item:gsub("^%s+", ""):gsub("%s+$", "")) }
    if i > 1 and places[i][1] < places[i - 1][1] then sorted = false end
  end
  if sorted and not nested then return "{" .. inner .. "}" end
  table.sort(places, function(a, b) return a[1] < b[1] end)
  for i, place in ipairs(places) do places[i] = place[2] end
  return "{ " .. table.concat(places, ",\n        ") .. " }"
end
order = function(text)
  text = text:gsub("%(([%w_]+)%)(%b{})", function(type, braces) return orders[type] and "(" .. type .. ")" .. arrange(type, braces) or nil end)
  return (text:gsub("([%w_]+) ([%w_]+) = (%b{})", function(type, name, braces)
    return orders[type] and type .. " " .. name .. " = " .. arrange(type, braces) or nil end))
end
-- Rows with a place, "[NAME] = { ... }": C++ has none. A table of a function becomes assignments; others list all their rows.
local places = {}
local function count_enums(text)
  for list in text:gsub("/%*.-%*/", ""):gmatch("enum [%w_]* ?(%b{})") do
    local place = 0
    -- an enum that is made of a list of rows: #define ROW(NAME, ...) PREFIX_##NAME, and then ROW(ONE, ...) ROW(TWO, ...)
    for row, prefix in list:gmatch("#define ([%w_]+)%([^)]*%)%s*([%w_]+)##[%w_]+,") do
      list = list:gsub("\n" .. row .. "(%b())", function(b) return "\n" .. prefix .. b:match("^%(([%w_]+)") .. "," end)
    end
    list = list:gsub("#[^\n]*", "")
    for name, value in list:gmatch("([%a_][%w_]*)%s*(=?)") do
      if value == "=" then break end
      places[name] = place
      place = place + 1
    end
  end
end
local function undesignate(text)
  text = text:gsub("\n([ ]+)(const )([%w_]+) ([%w_]+)%[([%w_]+)%] = {\n(.-)\n%1};", function(spaces, const, type, name, size, rows)
    if not rows:match("^%s*%[") then return nil end
    rows = (rows .. "\n"):gsub("(%s*)%[([%w_]+)%]%s*= (%b{}),?(%s*)", function(before, place, row, after)
      return before .. name .. "[" .. place .. "] = (" .. type .. ")" .. row .. ";" .. after end)
    return "\n" .. spaces .. type .. " " .. name .. "[" .. size .. "];\n" .. spaces .. "memset(" .. name .. ", 0, sizeof " .. name .. ");\n" .. rows:gsub("\n$", "")
  end)
  return (text:gsub("= (%b{})", function(rows)
    if not rows:match("^{%s*%[WF_") and not rows:match("^{%s*/%*.-%*/%s*%[WF_") then return nil end
    local next = 0
    local function place_of(name) return places[name] or fail("which number is " .. name .. ", the place of a row? -- write it in an enum that counts from 0") end
    -- Rows with a place may stand in any order: chapters add theirs where they need them. Rows without one follow the last, if that has the highest place.
    local entries, highest = {}, 0
    local head, tail = rows:sub(2, -2):gsub("/%*.-%*/", ""):match("^(.*%[WF_[%w_]+%]%s*= %b{},?)(.*)$")
    local other = (head or "?"):gsub("%[(WF_[%w_]+)%]%s*= (%b{}),?", function(name, row)
      entries[#entries + 1] = { place_of(name), row }
      highest = math.max(highest, place_of(name))
      return "" end)
    if not other:find("%S") and (not tail:find("%S") or entries[#entries][1] == highest) then
      table.sort(entries, function(a, b) return a[1] < b[1] end)
      local all = {}
      for _, e in ipairs(entries) do
        for _ = next, e[1] - 1 do all[#all + 1] = "{ 0 }" end
        all[#all + 1], next = e[2], e[1] + 1
      end
      if tail:find("%S") then all[#all + 1] = tail:gsub("^%s+", ""):gsub("[,%s]+$", "") end
      return "= {\n    " .. table.concat(all, ",\n    ") .. "\n}"
    end
    return "= " .. rows:gsub("%[(WF_[%w_]+)%]%s*= ", function(name)
      local place = place_of(name)
      local gap = place - next
      if gap < 0 then fail("the row of " .. name .. " comes too late in its table -- put the rows in the order of their enum") end
      next = place + 1
      return ("{ 0 },\n        "):rep(gap)
    end)
  end))
end
local keywords = {}
for word in ("new delete class this template typename try catch throw operator private public protected virtual using namespace and or not xor friend export mutable"):gmatch("%a+") do
  keywords[word] = word .. "_"
end
local libc = {}
for word in ("link unlink open close read write index rename remove access pipe dup select sync y0 y1 j0 j1 gamma div signal"):gmatch("%w+") do
  libc[word] = true                     -- functions of system headers, should a source have a name like theirs
end

-- ---- weft.h ------------------------------------------------------------------------------------------------------------------
local flags = io.popen("tangle/std --line"):read("l")
local version = read("include/weft/core.h"):gsub(".*WF_VERSION_MAJOR (%d+).*WF_VERSION_MINOR (%d+).*WF_VERSION_PATCH (%d+).*", "%1.%2.%3")
local function banner(name, text)
  return "/* " .. name .. ": Weft " .. version .. ", a 2D rigid-body physics engine, " .. text .. "\n   Made by `make amalgam` from the chapters "
    .. "of the book: do not edit it. MIT licence.\n"
end
local header = {}
inline("include/weft/core.h", header)
for _, name in ipairs(list("include/weft/*.h")) do
  if not name:match("report%.h$") and not name:match("draw%.h$") and not name:match("_rows%.h$") and not name:match("math_own%.h$") then inline(name, header) end
end
local function includes()
  local names = {}
  for name in pairs(system) do names[#names + 1] = "#include " .. name end
  table.sort(names)
  system = {}
  return table.concat(names, "\n")
end
local public = drop_heads(header)
local h = banner("weft.h", "in two files: this one and weft.c.") .. [[
   C11, or C++11 (weft.c as C++: C++17, gcc and clang). -DWF_DOUBLE: reals are doubles. -DWF_FREESTANDING: nothing of a C library is used. */
#ifndef WEFT_IN_TWO_FILES_H
#define WEFT_IN_TWO_FILES_H
]] .. includes() .. [[

]] .. public .. [[

#endif
]]

-- ---- weft.c ------------------------------------------------------------------------------------------------------------------
local files, owners = {}, {}
for _, part in ipairs { "core", "math", "collision", "dynamics", "engine" } do
  for _, name in ipairs(list(part .. "/*.c")) do if name ~= "engine/report.c" and name ~= "core/draw.c" then
    local sink = {}
    inline(name, sink)
    files[#files + 1] = { name = name, text = drop_heads(sink), stem = name:match("([%w_]+)%.c$") }
    for word in pairs(own_names(read(name))) do owners[word] = owners[word] or {}; table.insert(owners[word], name) end
  end end
end
local sources = {}
void_functions(public)
learn(public)
count_enums(public)
for _, file in ipairs(files) do void_functions(file.text); learn(file.text) end
for _, file in ipairs(files) do
  local names = {}
  for word, other in pairs(keywords) do names[word] = other end
  for word in pairs(own_names(read(file.name))) do
    if #owners[word] > 1 or libc[word] then names[word] = word:match("^%u[%u%d_]+$") and word .. "_IN_" .. file.stem:upper() or word .. "_in_" .. file.stem end
  end
  local text = rename(file.text, names)
  sources[#sources + 1] = undesignate(order(cast(text)))
end
system["<string.h>"] = nil
local c = banner("weft.c", "in two files: this one and weft.h.") .. [[
]] .. "   " .. flags .. "\n" .. [[
   (the -f switches keep the same bits on every machine. gcc and clang are asked for them here as well, so that a forgotten one
   changes nothing; what can't be mended so, such as -ffast-math, wfCreateWorld refuses by name) */
#if defined __clang__
#pragma STDC FP_CONTRACT OFF
#elif defined __GNUC__
#pragma GCC optimize("fp-contract=off", "no-math-errno", "no-tree-vectorize")
#endif
]] .. table.concat(first, "\n") .. [[

#define WF_IN_ONE_FILE
#include "weft.h"
]] .. includes() .. [[

#ifdef WF_FREESTANDING             /* whoever links must have these: gcc and clang call them in any case */
#ifdef __cplusplus
extern "C" {
#endif
void *memcpy(void *to, const void *from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
int memcmp(const void *a, const void *b, size_t size);
#ifdef __cplusplus
}
#endif
static inline int wfTextOrder(const char *a, const char *b)
{
    while (*a != 0 && *a == *b) { a++; b++; }
    return (unsigned char)*a - (unsigned char)*b;
}
static inline size_t wfTextLength(const char *a)
{
    size_t n = 0;
    while (a[n] != 0) n++;
    return n;
}
#ifndef WF_NO_FILES
#define WF_NO_FILES
#endif
#define strcmp wfTextOrder
#define strlen wfTextLength
#else
#include <string.h>
#endif

/* Functions that only the engine's own sources call. They are one file here, so nobody else has to see them. */
#ifdef __GNUC__
#define WF_PRIVATE __attribute__((unused)) static
#else
#define WF_PRIVATE static
#endif

#undef near                        /* windows.h, if it was included before, has given these words away */
#undef far

#ifdef __cplusplus                 /* what C does by itself */
#ifdef __GNUC__
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
struct wfAny {
    void *p;
    explicit wfAny(const void *to) : p(const_cast<void *>(to)) {}
    template <class T> operator T *() const { return static_cast<T *>(p); }
};
#define WF_ANY_POINTER(pointer) (wfAny(pointer))
#else
#define WF_ANY_POINTER(pointer) ((void *)(pointer))
#endif

]] .. table.concat(sources, "\n") .. "\n"

local function write(name, text)
  local f = io.open(out .. "/" .. name, "w") or fail(out .. "/" .. name .. " cannot be written")
  f:write(text); f:close()
end
os.execute("mkdir -p '" .. out .. "'")
write("weft.h", h)
write("weft.c", c)
