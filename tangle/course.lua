-- course.lua: exercises, from the chapters to points. tangle/course calls it; `tangle/course help` lists the commands.
--
-- An exercise is a box {.exercise #ex:label points= difficulty= minutes= kind=} in a chapter; its number is its chapter's and its place in
-- it. One that is to be programmed says starter=NAME and has, under that name:
--   chapters/exercises/heun.nw   the starter: a chapter with undefined chunks, the holes
--   chapters/solutions/heun.nw   the holes, defined
--   tests/course/heun.c          the criteria, with points (tests/course/course.h)
--   tests/course/heun.wrong      what wrong solutions change in the right one, and which criteria they must lose
local here = arg[0]:match("^(.*/)") or "./"
local B = os.getenv("BUILD") or "build"
local CC = os.getenv("CC") or "cc"
local STARTERS, SOLUTIONS, TESTS = "chapters/exercises", "chapters/solutions", "tests/course"
local ASAN = "ASAN_OPTIONS=detect_leaks=0:symbolize=0:allocator_may_return_null=1:detect_stack_use_after_return=1 UBSAN_OPTIONS=symbolize=0"
package.path = here .. "?.lua;" .. package.path
local Refuse = require "refuse"
local Course = {}

----------------------------------------------------------------------------------------------------------------- small things
local function read(path) local f = io.open(path, "rb"); if not f then return nil end local s = f:read("a"); f:close(); return s end
local function write(path, s) local f = assert(io.open(path, "wb")); f:write(s); f:close() end
local function quote(s) return "'" .. s:gsub("'", "'\\''") .. "'" end
local function out_of(command) local p = io.popen(command); local s = p:read("a"); p:close(); return s end
local function ok(command) local a, _, c = os.execute(command); return a == true or a == 0, c end
local function lines(s) return ((s or "") .. "\n"):gmatch("(.-)\r?\n") end
local function text_lines(path) local t = {} for l in lines(read(path)) do t[#t + 1] = l end return t end
local function base_of(path) return (path:match("([^/]+)%.nw$")) end
local function die(...) io.stderr:write("course: ", string.format(...), "\n"); os.exit(2) end
local function list(dir, ext) local t = {} for l in lines(out_of("ls " .. quote(dir) .. " 2>/dev/null")) do if l:match("%." .. ext .. "$") then t[#t + 1] = l:sub(1, -#ext - 2) end end return t end
local function points_text(p) return (string.format("%.2f", p):gsub("%.?0+$", "")) end

-- An exercise of a chapter that EXTRA names, or that was put straight into chapters/, stands in that chapter: <<exercises/NAME.nw>>, .solution,
-- .c, .wrong. noweb takes them out.
local extra = { files = {}, elsewhere = os.getenv("EXTRA") or "" }
for file in (extra.elsewhere .. " " .. out_of("ls chapters/*.nw 2>/dev/null"):gsub("\n", " ")):gmatch("%S+") do
  extra.files[#extra.files + 1] = file
  for l in lines(read(file)) do
    local name = l:match("^<<exercises/([%w_%-]+%.%a+)>>=%s*$")
    if name and not extra[name] then
      extra[name] = B .. "/course/extra/" .. name
      os.execute("mkdir -p " .. quote(B .. "/course/extra") .. "; notangle -R'exercises/" .. name .. "' " .. quote(file) .. " > " .. quote(extra[name]))
    end
  end
end
local function starter_file(base) return extra[base .. ".nw"] or STARTERS .. "/" .. base .. ".nw" end
local function solution_file(base) return extra[base .. ".solution"] or SOLUTIONS .. "/" .. base .. ".nw" end
local function test_file(base, kind) return extra[base .. "." .. kind] or TESTS .. "/" .. base .. "." .. kind end

------------------------------------------------------------------------------------------------------- exercises in the chapters
-- All of them in the order of the book: { number, chapter, title, label, points, minutes, difficulty, kind, file, line, base }
local function exercises()
  local all, rows = {}, {}
  for l in lines(out_of("tangle/chapters --plan")) do
    local name, volume, number, part = l:match("^(.-)\t(.-)\t(.-)\t(.-)\t")
    if name then rows[name] = { volume = volume, number = number, part = part } end
  end
  for file in lines(out_of("tangle/chapters") .. extra.elsewhere:gsub("%s+", "\n")) do
    local name = (file:match("([^/]+)%.nw$") or ""):gsub("^%w+%-", "", 1)
    local row = rows[name]
    for _, f in ipairs(extra.files) do if f == file then row = { volume = "extra", number = file:match("([^/-]+)[^/]*%.nw$"), part = "Extra" } end end
    local chapter = row and row.number
    local k, n, title = 0, 0, nil
    for l in lines(row and read(file)) do
      n = n + 1
      title = title or l:match("^# (.-)%s*{#") or l:match("^# (.*)$")
      local attributes = l:match("^:::+ *{%.exercise (.-)}")
      if attributes and chapter then
        k = k + 1
        local e = { chapter = chapter, volume = row.volume, part = row.part, number = chapter .. "." .. k, file = file, line = n, title = title }
        e.label = attributes:match("#ex:([%w_%-]+)")
        for key, v in attributes:gmatch('([%a]+)=(["%w%-%./]+)') do e[key] = v:gsub('"', "") end
        for _, key in ipairs { "points", "minutes", "difficulty" } do e[key] = tonumber(e[key]) end
        e.base = e.starter and read(starter_file(e.starter)) and e.starter
        all[#all + 1] = e
      end
    end
  end
  return all
end
Course.exercises = exercises

local function find(all, id)
  for _, e in ipairs(all) do if e.number == id or e.label == id or e.base == id or "ex:" .. (e.label or "") == id then return e end end
end
-- what E= names: one or several, by number or label; every one must be an exercise that can be programmed
local function chosen(all, ids)
  local t = {}
  for id in ids:gmatch("[^%s,]+") do
    local e = find(all, id)
    if not e then die("there is no exercise %s -- `make progress` lists them; say E=10.2, E=heun or E=int-heun", id) end
    if not e.base then die("exercise %s (%s, kind %s) has no starter: it is solved on paper or by trying -- `make progress` marks those with a starter by *", e.number, e.label, e.kind) end
    t[#t + 1] = e
  end
  if #t == 0 then die("which exercise? -- say E=10.2") end
  return t
end

----------------------------------------------------------------------------------------------- a chapter's chunks and their lines
local function chunks_of(path)
  local t, n, inside = { list = {}, defined = {}, used = {}, first = {} }, 0, nil
  for l in lines(read(path)) do
    n = n + 1
    local name = l:match("^<<(.-)>>=%s*$")
    if name then
      if inside then inside.open = n end
      inside = { name = name, from = n }
      t.list[#t.list + 1] = inside
      t.defined[name] = t.defined[name] or n
    elseif inside and (l == "@" or l:match("^@ ")) then inside.to = n; inside = nil
    elseif inside then
      inside.to = n
      local u = l:match("^%s*<<(.-)>>%s*$")
      if u and not t.used[u] then t.used[u] = n; t.first[#t.first + 1] = u end
      inside[#inside + 1] = l:gsub("%s+$", "")
    end
  end
  if inside then inside.open = n end
  return t
end
local function chunk_at(chunks, line)
  for _, c in ipairs(chunks.list) do if line >= c.from and line <= (c.to or line) then return c.name end end
end
local function holes_of(path)             -- used and not defined here: with a starter, the holes
  local c, t = chunks_of(path), {}
  for _, u in ipairs(c.first) do if not c.defined[u] then t[#t + 1] = u end end
  return t, c
end

-- Chunks of somebody's chapter that neither it uses nor the starter has: a hole's name copied wrongly is among them.
local function strays_of(chunks, base)
  local given, t = chunks_of(starter_file(base)), {}
  for _, c in ipairs(chunks.list) do if not chunks.used[c.name] and not given.defined[c.name] then t[#t + 1] = c.name end end
  return t
end
-- What is told of a chapter's chunks before it is built: chunks without an end, what is given and was changed (that is refused), holes that
-- are defined more than once.
local function oddities(file, chunks, base)
  local given, open, changed, twice, lines_of, seen = chunks_of(starter_file(base)), {}, {}, {}, {}, {}
  for _, c in ipairs(chunks.list) do
    if c.open then open[#open + 1] = string.format("%s:%d: the chunk <<%s>> has no end: all that stands behind this line is taken for code -- end it by a line with @ alone", file, c.from, c.name) end
    lines_of[c.name] = lines_of[c.name] or {}
    for _, l in ipairs(c) do if l ~= "" then table.insert(lines_of[c.name], l) end end
    if not given.defined[c.name] and chunks.used[c.name] then
      if seen[c.name] then twice[#twice + 1] = string.format("%s:%d: <<%s>> is defined here, and in line %d: both stand in the program, one behind the other", file, c.from, c.name, seen[c.name]) end
      seen[c.name] = seen[c.name] or c.from
    end
  end
  local at = {}
  for _, c in ipairs(given.list) do
    local mine = lines_of[c.name] or {}
    for _, l in ipairs(c) do
      if l ~= "" and #changed == 0 then
        local k = (at[c.name] or 0) + 1
        while mine[k] and mine[k] ~= l do k = k + 1 end
        if mine[k] then at[c.name] = k
        else changed[1] = string.format("%s:%d: a line of <<%s>> that is given was changed or taken out: \"%s\" -- put it back; your code goes into the holes", file, chunks.defined[c.name] or 1, c.name, l:gsub("^%s+", "")) end
      end
    end
  end
  return open, changed, twice
end
-- The name that shares the most pairs of neighbouring letters with another one, at least half of them.
local function nearest(name, names)
  local function pairs_of(s) local t, n = {}, 0 for i = 1, #s - 1 do t[s:sub(i, i + 1):lower()] = true end for _ in pairs(t) do n = n + 1 end return t, n end
  local a, na = pairs_of(name)
  local best, most = nil, 0.5
  for _, other in ipairs(names) do
    local b, nb = pairs_of(other)
    local shared = 0
    for k in pairs(a) do if b[k] then shared = shared + 1 end end
    if 2 * shared / (na + nb) > most then best, most = other, 2 * shared / (na + nb) end
  end
  return best
end

-- The criteria as the test's source lists them: { name, points, hole, text }
local function criteria_of(base)
  local s = read(test_file(base, "c")) or ""
  local body = s:match("CRITERIA%(.*$")
  local t = {}
  for name, points, hole, text in (body or ""):gmatch('{%s*"([^"]*)",%s*([%d%.]+),%s*"([^"]*)",%s*"([^"]*)"') do
    t[#t + 1] = { name = name, points = tonumber(points), hole = hole, text = text }
  end
  return t
end

--------------------------------------------------------------------------------------------------- from a file to its results
local STD = "-std=gnu11 " .. io.popen("tangle/std --bits"):read("l")
local function compile_line(out, plain) return CC .. " " .. STD .. " " .. (os.getenv("COURSE_CFLAGS") or plain and "-O0 -gdwarf-4" or "-O1 -gdwarf-4") .. " -fno-pie -I" .. quote(out .. "/lines/include") .. " -I" .. quote(out .. "/lines") end

local function refuse(r, what, list_of)
  r.refused = what
  r.messages = list_of or {}
  return r
end

-- What a compiler or the loom says of the student's file, each with its chunk. Other messages come behind.
local function header_of(said, l)
  local name = l:match("declaration of function [^%w_]*([%w_]+)") or l:match("[^%w_]([%a_][%w_]*)[^%w_]+ undeclared") or l:match("unknown type name [^%w_]*([%w_]+)")
  if not name then return nil end
  if name:match("^[Ww][Ff]") then
    local header = out_of("grep -lE '" .. ("^[A-Za-z].*[ *]NAME\\(|^} NAME;|^typedef .* NAME;|^#define NAME\\b|^ *NAME( *=|,|$)"):gsub("NAME", name) .. "' " .. quote(B .. "/lines/include") .. "/weft/*.h 2>/dev/null"):match("/(weft/[%w_]+%.h)\n")
    return header and '"' .. header .. '"'
  end
  local behind = said:sub((said:find(l, 1, true)))
  for n in lines(behind) do
    local h = (n:match("[^%w_]" .. name .. "[^%w_]") and (n:match("include [^%w<]*(<[%w_/]+%.h>)") or n:match("header [^%w<]*(<[%w_/]+%.h>)")))
    if h then return h end
  end
end
local function told(said, file, chunks, base)
  local mine, others, given = {}, {}, {}
  for l in lines(said) do
    local line = l:sub(1, #file + 1) == file .. ":" and tonumber(l:sub(#file + 2):match("^(%d+)"))
    if line and (l:match("error") or l:match("%-%- ") or l:match("warning")) then
      local c = chunk_at(chunks, line)
      local header = header_of(said, l)
      local advice = header and string.format("\n    write #include %s into the chunk <<%s: helpers>>", header, (holes_of(starter_file(base))[1] or base):match("^[^:]*"))
        or l:match("implicit declaration") and "\n    no function of that name is known here -- appendices B and C list them, and the book's index of identifiers" or ""
      if given[advice] then advice = "" else given[advice] = true end
      mine[#mine + 1] = l .. (c and "\n    in the chunk <<" .. c .. ">>" or "") .. advice
    elseif l:match("error") or l:match("undefined reference") or l:match("multiple definition") or l:match("%-%- ") then others[#others + 1] = l end
  end
  for _, l in ipairs(others) do if #mine < 12 then mine[#mine + 1] = l end end
  return mine
end

local function differing(out, like)         -- files of the tangled tree that the engine does not have so; of a variant: those of its solution
  local t = {}
  if like and read(like .. "/differing") then
    for l in lines(read(like .. "/differing")) do if l ~= "" then t[#t + 1] = l end end
    return t
  end
  if read(out .. "/alone") then
    for l in lines(out_of("cd " .. quote(out .. "/lines") .. " && find . -type f | sed 's|^\\./||' | sort")) do if l ~= "" then t[#t + 1] = l end end
  else
    for l in lines(out_of("cd " .. quote(out .. "/lines") .. " && find . -type f | sed 's|^\\./||' | sort")) do
      if l ~= "" and read(out .. "/lines/" .. l) ~= read(B .. "/lines/" .. l) then t[#t + 1] = l end
    end
  end
  write(out .. "/differing", table.concat(t, "\n") .. "\n")
  return t
end

-- What is refused before it runs (refuse.lua): messages with line and chunk, or nil.
local function refusals(found, file, chunks)
  local t = {}
  table.sort(found, function(x, y) return (x[1] or 1e9) < (y[1] or 1e9) end)
  for _, f in ipairs(found) do
    local c = f[1] and chunk_at(chunks, f[1])
    t[#t + 1] = file .. ":" .. (f[1] or 1) .. ": " .. f[2] .. (c and "\n    in the chunk <<" .. c .. ">>" or "")
  end
  return #t > 0 and t or nil
end
local NOT_NEEDED = "it has what no exercise needs"

-- The names of all chunks of the book, and the words of its C; only asked when somebody defines one.
local function book_chunks()
  local t = {}
  for l in lines(out_of("grep -rhoE --include='*.nw' '^<<.*>>=' chapters 2>/dev/null")) do local name = l:match("^<<(.-)>>=") if name then t[name] = true end end
  return t
end
setmetatable(Refuse, { __index = function(t, key)
  if key ~= "known" then return nil end
  local known = {}
  for w in ("auto break case char const continue default do double else enum extern float for goto if inline int long register restrict return short signed sizeof static struct " ..
    "switch typedef union unsigned void volatile while bool true false NULL"):gmatch("%S+") do known[w] = true end
  for l in lines(out_of("grep -rhoE --include='*.[ch]' '\\b[A-Za-z_][A-Za-z0-9_]*' " .. quote(B .. "/lines") .. " tests/course | sort -u")) do known[l] = true end
  rawset(t, "known", known)
  return known
end })

local SANITIZE = " -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
local WRAP = " -Wl,--wrap=wfPoolPush,--wrap=wfPoolPushMany,--wrap=wfPoolReset,--wrap=wfPoolRewind"
local function names_of(command) local t = {} for l in lines(out_of(command .. " 2>/dev/null")) do local n = l:match("(%S+)$") if n then t[n] = true end end return t end

-- The test itself: compiled once, unless it includes a header of the exercise's own. NAME.o, and NAME.san.o with the sanitizers, not optimized.
function Course.test_object(base, out, flags, kind)
  local source, log = test_file(base, "c"), out .. "/log"
  local own = out_of("grep -ohE '\"(lab|course)/[a-z0-9_]+\\.h\"' " .. quote(source) .. " 2>/dev/null") ~= ""
  local test = B .. "/course/tests/" .. base .. kind
  if not own and read(test) then return test end
  local o = own and out .. "/test" .. kind or test .. "." .. tostring({}):match("0x(%x+)") .. ".o"
  os.execute("mkdir -p " .. quote(B .. "/course/tests"))
  local command = compile_line(out, kind == ".san.o") .. flags .. " -I" .. quote(B .. "/lines/include") .. " -I" .. quote(B .. "/lines") .. " -I" .. TESTS .. " -Wall -Wextra -Wno-unused-function -c " .. quote(source) .. " -o " .. quote(o)
  if not ok(command .. " >>" .. quote(log) .. " 2>&1") then return nil end
  if own then return o end
  os.execute("mv " .. quote(o) .. " " .. quote(test))
  return test
end

-- Builds FILE against the engine: { base, file, criteria = {...}, refused, program, sanitized }.
-- like: where a solution of the same exercise has passed the loom; this is a variant of it: tangled without its checks, compiled without optimization.
-- sanitize: a second program, with the address and undefined sanitizers.
function Course.build(file, base, out, like, sanitize)
  local r = { base = base, file = file, criteria = criteria_of(base), earned = 0, max = 0, out = out, chunks = { list = {}, defined = {}, used = {}, first = {} } }
  for _, c in ipairs(r.criteria) do
    r.max = r.max + c.points
    c.earned, c.status, c.line = 0, "not run", 1
  end
  local unfit = Refuse.size(file)
  if unfit then return refuse(r, unfit) end
  local chunks = chunks_of(file)
  r.chunks = chunks
  for _, c in ipairs(r.criteria) do c.line = chunks.defined[c.hole] or chunks.used[c.hole] end
  os.execute("rm -rf " .. quote(out) .. " && mkdir -p " .. quote(out))
  local holes, wanted, given = {}, holes_of(starter_file(base))
  local strays = strays_of(chunks, base)
  for _, hole in ipairs(wanted) do
    if not chunks.defined[hole] then
      local near = nearest(hole, strays)
      holes[#holes + 1] = near and string.format("%s:%d: nothing uses <<%s>> -- is it meant to be <<%s>>? The name is copied exactly", file, chunks.defined[near], near, hole)
        or string.format("%s:%d: the hole <<%s>> is empty -- write it: a line <<%s>>= , the code, and a line with @ alone", file, chunks.used[hole] or 1, hole, hole)
    end
  end
  local odd, changed, twice = oddities(file, chunks, base)
  table.move(twice, 1, #twice, #odd + 1, odd)
  if #changed > 0 then return refuse(r, "what is given was changed", changed) end
  local refused = refuse
  local function refuse(result, what, messages) messages = messages or {}; return refused(result, what, table.move(messages, 1, #messages, #odd + 1, odd)) end
  if #holes > 0 then return refuse(r, #holes == 1 and "a hole is empty" or #holes .. " holes are empty", holes) end
  local found = refusals(Refuse.text(file, chunks, given, book_chunks), file, chunks)
  if found then return refuse(r, NOT_NEEDED, found) end
  local log = out .. "/log"
  local function tangle(chapters)
    return ok("tangle/tangle --lines " .. (like and "--unchecked " or "") .. quote(out .. "/lines") .. " " .. chapters .. quote(file) .. " >" .. quote(log) .. " 2>&1")
  end
  local alone = not (like and not read(like .. "/alone")) and tangle("")
  if alone then write(out .. "/alone", "")
  elseif not tangle("$(tangle/chapters) ") then
    return refuse(r, "the loom refuses the chapter", told(read(log), file, chunks, base))
  end
  local include = " -I" .. quote(B .. "/lines/include") .. " -I" .. quote(B .. "/lines")
  local test = Course.test_object(base, out, "", ".o")
  if not test then return refuse(r, "the test does not compile with the chapter", told(read(log), file, chunks, base)) end
  -- The submission's objects. Only names that the test asks for, or that the engine's own object gives, leave them; what else they
  -- define is nobody's but theirs.
  local wants = names_of(Refuse.nm .. " -u " .. quote(test))
  local engine
  local given_lines = {}
  for l in lines(read(starter_file(base))) do
    local plain = l:gsub("%s+", "")
    given_lines[plain] = true
    for call in plain:gmatch("[%w_]+%->[%w_]+%(") do given_lines[#given_lines + 1] = call end          -- m->step( may be called elsewhere, too
  end
  local function of_book(path) return not alone and path:match("^chapters/%w+/[^/]+%.nw$") and path ~= file end
  local objects, sanitized = {}, {}
  for _, f in ipairs(differing(out, like)) do
    if f:match("%.c$") and not f:match("_main%.c$") then
      local o, source = out .. "/" .. f:gsub("[/%.]", "_") .. ".o", quote(out .. "/lines/" .. f)
      local compile = compile_line(out, like) .. (alone and include or "") .. " -Wall -Wextra -Werror=implicit-function-declaration -Werror=override-init -Werror=return-type -fno-jump-tables "
      found = refusals(Refuse.preprocessed(out_of(compile .. "-E " .. source .. " 2>/dev/null"), file, of_book), file, chunks)
      if found then return refuse(r, NOT_NEEDED, found) end
      if not ok(compile .. "-c " .. source .. " -o " .. quote(o) .. " >>" .. quote(log) .. " 2>&1") then
        return refuse(r, "the compiler refuses the code", told(read(log), file, chunks, base))
      end
      local bad = {}
      if not engine then
        engine = {}
        for l in lines(read(B .. "/course/engine.names") or out_of("nm -g --defined-only " .. B .. "/lib/*.a 2>/dev/null")) do local n = l:match("(%S+)$"); if n then engine[n] = true end end
      end
      local theirs = B .. "/obj/" .. f:gsub("%.c$", ".o")
      local base_wants = names_of(Refuse.nm .. " -u " .. quote(theirs))
      local more, gives = Refuse.object(out_of, quote(o), function(name) return name:match("^wf") and engine[name] or engine[name] and base_wants[name] or base_wants[name] end)
      for _, m in ipairs(more) do
        local word = m[2]:match("use of (%S+)$")
        if word then for n, l in pairs(text_lines(file)) do if l:find("%f[%w_]" .. word:gsub("%p", "%%%0") .. "%f[^%w_]") then m[1] = math.min(n, m[1] or n) end end end
        bad[#bad + 1] = m
      end
      for _, m in ipairs(Refuse.instructions(out_of, quote(o), file, given_lines, of_book)) do bad[#bad + 1] = m end
      local keep, engines = {}, names_of(Refuse.nm .. " -g --defined-only " .. quote(theirs))
      for _, name in ipairs(gives) do
        if (engine[name] or Refuse.functions[name]) and not engines[name] then bad[#bad + 1] = { nil, "a function " .. name .. " of its own, where there is one of that name" } end
      end
      found = refusals(bad, file, chunks)
      if found then return refuse(r, NOT_NEEDED, found) end
      for _, name in ipairs(gives) do if wants[name] and name:match("^ex%u") or engines[name] then keep[#keep + 1] = name end end
      write(o .. ".keep", table.concat(keep, "\n") .. "\n")
      local function keep_names(object) return ok("objcopy --keep-global-symbols=" .. quote(o .. ".keep") .. " " .. quote(object) .. " >>" .. quote(log) .. " 2>&1") end
      if not keep_names(o) then return refuse(r, "the object's names cannot be kept apart") end
      objects[#objects + 1] = quote(o)
      if sanitize then
        local s = o:gsub("%.o$", ".san.o")
        if ok(compile .. SANITIZE .. " -w -c " .. source .. " -o " .. quote(s) .. " >>" .. quote(log) .. " 2>&1") and keep_names(s) then sanitized[#sanitized + 1] = quote(s) end
      end
    end
  end
  r.warnings = table.move(told(read(log), file, chunks, base), 1, 99, #odd + 1, odd)
  local json = read(B .. "/lib/libweft-json.a") and quote(B .. "/lib/libweft-json.a") .. " " or ""
  local libraries = quote(B .. "/lib/libweft-extra.a") .. " " .. json .. quote(B .. "/lib/libweft.a") .. " " ..
    (json ~= "" and out_of("pkg-config --libs libcjson 2>/dev/null"):gsub("\n", "") or "")
  local function link(program, flags, first, rest)
    return ok(CC .. " -g -no-pie -Wl,-z,relro,-z,now " .. flags .. " " .. quote(first) .. " " .. table.concat(rest, " ") .. " " .. libraries .. " -lm -o " .. quote(program) .. " >>" .. quote(log) .. " 2>&1")
  end
  if not link(out .. "/program", "", test, objects) then
    return refuse(r, "the program does not link", told(read(log), file, chunks, base))
  end
  r.program = out .. "/program"
  function r.bare() return link(out .. "/bare", "-Wl,--unresolved-symbols=ignore-all", test, {}) and out .. "/bare" end
  local safe = sanitize and #sanitized == #objects and Course.test_object(base, out, SANITIZE, ".san.o")
  if safe and link(out .. "/sanitized", SANITIZE .. WRAP, safe, sanitized) then r.sanitized = out .. "/sanitized" end
  return r
end

-- The program's line for a criterion: a list of fields. Nothing of it is believed but its first two words, and the count behind "pass".
local function verdict_of(text, name)
  local f = {}
  text = (text or ""):sub(1, 4096):match("^[^\n]*")
  for x in (text .. "\t"):gmatch("(.-)\t") do f[#f + 1] = x:gsub("[%c\127]", " "):sub(1, 400) end
  return f[1] == name and f or { name }
end
local function bare(base) return (base:gsub("^%w+%.%d+%-", "")) end
-- How many expectations a criterion meets from its beginning to its end, as the solution does: tests/course/expectations.csv.
local expectations
local function expected_of(base, criterion)
  if not expectations then
    expectations = {}
    for l in lines(read(TESTS .. "/expectations.csv")) do
      local b, c, n = l:match("^([^,]+),([^,]+),(%d+)$")
      if b then expectations[b .. "," .. c] = tonumber(n) end
    end
  end
  return expectations[bare(base) .. "," .. criterion]
end

-- Runs the criteria. launch(program, criterion) returns what the judge wrote; place(program, addresses) returns addr2line's lines.
function Course.run(r, launch, place, tell)
  if r.refused then return r end
  local function line_of(program, f, from)
    local at = {}
    for i = from, #f do if f[i]:match("^%x+$") then at[#at + 1] = "0x" .. f[i] end end
    for l in lines(#at > 0 and place(program, at) or "") do
      local path, line = l:match("^(.*):(%d+)")
      if path and (path == r.file or path:sub(-#r.file - 1) == "/" .. r.file) then return tonumber(line) end
    end
  end
  local signals = { ["11"] = "a bad address (segmentation fault)", ["8"] = "a division by zero", ["6"] = "abort", ["4"] = "an illegal instruction", ["7"] = "a bad address (bus error)" }
  local slow                                  -- a criterion has not ended: the line, or true; those behind it get less time
  for _, c in ipairs(r.criteria) do
    local want = expected_of(r.base, c.name)
    local function judge(program, again)
      local f = verdict_of(launch(program, c.name, slow, again), c.name)
      local word, line = f[2], nil
      c.met = nil
      if word == "pass" then
        c.met = tonumber(f[3]) or 0
        if want and c.met ~= want then
          c.status, c.what, c.expected, c.got = "unfinished", "expectations that were met before its end", tostring(want), tostring(c.met)
        else c.status = "ok" end
      elseif word == "fail" then c.status, c.what, c.expected, c.got = "failed", f[3], f[4], f[5]
      elseif word == "time" then
        c.status, c.what, c.expected, c.got = "too long", "the time of this criterion", "an end", "none: an endless loop, or too slow"
        line = line_of(program, f, 4)
        if slow then c.what, c.got = nil, slow == line and "it does not end, as above" or "it does not end either, in the shorter time that is left to it" end
        slow = slow or line or true
      elseif word == "crash" then
        c.status, c.what, c.expected, c.got = "crashed", "the program", "no crash", signals[f[3]] or "it ended by itself"
        line = line_of(program, f, 4)
      elseif word == "call" then
        c.status, c.what, c.expected, c.got = "refused", "calls of the system", "none but for memory and time", "number " .. (f[3] or "?")
        line = line_of(program, f, 4)
      elseif word == "memory" then
        c.status, c.what, c.expected, c.got = "memory", "the address sanitizer", "no access beyond what is there, or was pushed into the pool", f[3]
        line = line_of(program, f, 4)
      elseif word == "undefined" then
        c.status, c.what, c.expected, c.got = "undefined", "the undefined-behaviour sanitizer", "nothing undefined", f[3]
        local path, at = (f[4] or ""):match("^(.*):(%d+)$")
        if path and (path == r.file or path:sub(-#r.file - 1) == "/" .. r.file) then line = tonumber(at) end
      else c.status, c.got = "not reached", "the program ended before this criterion was looked at" end
      if line then c.line, c.exact, c.hole = line, true, chunk_at(r.chunks, line) or c.hole end
    end
    judge(r.program)
    local met = c.met
    if c.status == "ok" and r.sanitized then judge(r.sanitized, true) end
    c.met = met
    c.earned = c.status == "ok" and c.points or 0
    r.earned = r.earned + c.earned
    if r.said then c.said = r.said(c) end
    if tell then tell(c) end
  end
  return r
end

-- At home: on this machine, with limits, and with the plots' data. In a class the programs run in a room (tangle/room).
function Course.try(file, base, out, like, begin, keep)
  local r = Course.build(file, base, out, like, not like)
  local tell = begin and begin(r)
  local output = out .. "/output"
  function r.said(c)                          -- what the student's code printed: twenty lines
    local f, t = io.open(output .. ".of." .. c.name, "rb"), {}
    if not f then return nil end
    for l in lines(f:read(65536)) do if l ~= "" or t[1] then t[#t + 1] = l:sub(1, 200):gsub("[%c\127]", " ") end end
    f:close()
    if t[#t] == "" then t[#t] = nil end
    return t
  end
  return Course.run(r, function(program, criterion, slow, again)
    ok("( ulimit -f 65536 -c 0 2>/dev/null; exec timeout -k 2 180 env " .. (slow and "COURSE_SECONDS=2 " or "") .. (keep and not again and "COURSE_KEEP=" .. quote(keep .. criterion) .. " " or "") .. ASAN .. " " .. quote(program) .. " " .. quote(out) .. " " .. quote(criterion) .. " ) >" .. quote(out .. "/verdict") ..
      " 2>" .. quote(output .. (again and "" or ".of." .. criterion)) .. " </dev/null")
    return read(out .. "/verdict")
  end, function(program, at) return out_of("addr2line -e " .. quote(program) .. " " .. table.concat(at, " ") .. " 2>/dev/null") end, tell)
end

------------------------------------------------------------------------------------------------------------------------ reports
local function plot(r, c, say)              -- the data that a criterion left, as a picture and in the terminal
  for l in lines(out_of("ls " .. quote(r.out) .. "/*.plot 2>/dev/null")) do
    local name = l:match("([^/]+)%.plot$")
    if name == c.name then
      local head = (read(l) or ""):match("^# (.-)\n") or ""
      local title, x, y, log = (head .. "\t\t\t"):match("^(.-)\t(.-)\t(.-)\t(.-)\t")
      title, x, y, log = title or name, x or "", y or "", log or ""
      local curves, seen = {}, {}
      for row in lines(read(l)) do
        local curve = not row:match("^#") and row:match("^(.-),")
        if curve and not seen[curve] then seen[curve] = true; curves[#curves + 1] = curve end
      end
      local plots = {}
      for _, k in ipairs(curves) do
        plots[#plots + 1] = string.format("\"< grep -F '%s,' '%s'\" using 2:3 with linespoints title '%s'", k:gsub("['\"]", ""), l, k:gsub("['\"]", ""))
      end
      if #plots == 0 then return end
      local style = string.format("set datafile separator ','; set title '%s'; set xlabel '%s'; set ylabel '%s'; set key outside; %s; plot %s", title:gsub("'", ""), x:gsub("'", ""),
        y:gsub("'", ""), log ~= "" and "set logscale " .. log or "unset logscale", table.concat(plots, ", "))
      local svg = r.out .. "/" .. name .. ".svg"
      write(r.out .. "/" .. name .. ".gp", "set terminal svg size 720,420 font 'DejaVu Sans,12' background rgb 'white'\nset output '" .. svg .. "'\n" .. style:gsub("; ", "\n") .. "\n")
      if ok("gnuplot " .. quote(r.out .. "/" .. name .. ".gp") .. " >/dev/null 2>&1") then say("             picture: " .. svg) end
      write(r.out .. "/" .. name .. ".txt.gp", "set terminal dumb 96 22\n" .. style:gsub("; ", "\n") .. "\n")
      local text = out_of("gnuplot " .. quote(r.out .. "/" .. name .. ".txt.gp") .. " 2>/dev/null")
      for row in lines(text) do if row:match("%S") then say("             " .. row) end end
    end
  end
end

-- A table in three parts, so that a result is told as soon as it is there: what stands above, a criterion, what stands below.
local MOST_SAID = 20
function Course.head(r, e, say)
  say(string.format("%s  %s%s", e.number, e.name_of or e.label, r.student and "  (" .. r.student .. ")" or ""))
  if r.refused then say("  " .. r.refused .. ":") end
  for i, m in ipairs(r.refused and r.messages or r.warnings or {}) do if i <= 200 then say("    " .. m) end end
end
function Course.criterion(r, c, say, plots)
  say(string.format("  %-9s %4s  %s", c.status == "ok" and "ok" or c.status:upper(), points_text(c.points), c.text))
  for i, l in ipairs(c.said or {}) do
    if i <= MOST_SAID then say("             | " .. l) elseif i == MOST_SAID + 1 then say(string.format("             | ... it printed %d lines", #c.said)) end
  end
  if c.status ~= "ok" then
    if c.what then say(string.format("             %s: expected %s, got %s", c.what, c.expected, c.got)) elseif c.got then say("             " .. c.got) end
    say(string.format("             chunk <<%s>>, %s:%d", c.hole, r.file, c.line or 1))
    if plots then plot(r, c, say) end
  end
end
function Course.sum(r, say) say(string.format("  %s of %s points", points_text(r.earned), points_text(r.max))) end
function Course.table(r, e, say, plots)
  Course.head(r, e, say)
  for _, c in ipairs(r.refused and {} or r.criteria) do Course.criterion(r, c, say, plots) end
  Course.sum(r, say)
end

local function json_string(s) return '"' .. tostring(s):gsub('[%c"\\]', function(c) return string.format("\\u%04x", c:byte()) end) .. '"' end
function Course.json(results)
  local t = {}
  for _, r in ipairs(results) do
    local cs = {}
    for _, c in ipairs(r.criteria) do
      local fields = { '"name": ' .. json_string(c.name), '"text": ' .. json_string(c.text), '"points": ' .. points_text(c.points), '"earned": ' .. points_text(c.earned),
        '"status": ' .. json_string(c.status), '"chunk": ' .. json_string(c.hole) }
      for _, k in ipairs { "what", "expected", "got" } do if c[k] then fields[#fields + 1] = json_string(k) .. ": " .. json_string(c[k]) end end
      if c.line then fields[#fields + 1] = '"line": ' .. c.line end
      cs[#cs + 1] = "      { " .. table.concat(fields, ", ") .. " }"
    end
    t[#t + 1] = string.format('  { "exercise": %s, "label": %s, "student": %s, "file": %s, "earned": %s, "points": %s, "refused": %s,\n    "criteria": [\n%s\n    ] }', json_string(r.e.number),
      json_string(r.e.label), json_string(r.student or ""), json_string(r.file), points_text(r.earned), points_text(r.max), r.refused and json_string(r.refused) or "null", table.concat(cs, ",\n"))
  end
  return "[\n" .. table.concat(t, ",\n") .. "\n]\n"
end
local function xml(s) return (tostring(s):gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }):gsub("[%z\1-\8\11\12\14-\31]", "?")) end
function Course.junit(results)
  local t = { '<?xml version="1.0" encoding="UTF-8"?>', "<testsuites>" }
  for _, r in ipairs(results) do
    local failed = 0
    for _, c in ipairs(r.criteria) do if c.status ~= "ok" then failed = failed + 1 end end
    t[#t + 1] = string.format('  <testsuite name="%s" tests="%d" failures="%d">', xml(r.e.number .. " " .. r.e.label), #r.criteria, failed)
    t[#t + 1] = string.format('    <properties><property name="points" value="%s"/><property name="max" value="%s"/></properties>', points_text(r.earned), points_text(r.max))
    for _, c in ipairs(r.criteria) do
      local name = string.format('    <testcase classname="%s" name="%s (%s points)"', xml(r.e.number), xml(c.text), points_text(c.points))
      if c.status == "ok" then t[#t + 1] = name .. "/>"
      else
        local what = r.refused and r.refused .. ": " .. (r.messages[1] or "") or c.what and string.format("%s: expected %s, got %s", c.what, c.expected, c.got) or c.got or c.status
        t[#t + 1] = name .. string.format('><failure message="%s">%s:%d: chunk %s</failure></testcase>', xml(what), xml(r.file), c.line or 1, xml(c.hole))
      end
    end
    t[#t + 1] = "  </testsuite>"
  end
  t[#t + 1] = "</testsuites>\n"
  return table.concat(t, "\n")
end

---------------------------------------------------------------------------------------------- starter and solution, and wrong ones
local function trim_end(s) return (s:gsub("%s+$", "")) .. "\n" end
function Course.compose(base, solution)
  local a = read(starter_file(base))
  local b = solution or read(solution_file(base))
  if not a or not b then return nil end
  local _, count = trim_end(a):gsub("\n", "\n")
  return trim_end(a) .. "\n### Solution\n\n" .. b, count
end

-- The wrong solutions: { name, lose = {criteria}, text }. Each replaces lines of the right one; what is replaced must be there once.
function Course.wrong(base)
  local t, right, errors = {}, read(solution_file(base)) or "", {}
  local path = test_file(base, "wrong")
  local w, n = nil, 0
  local function close(old, new)
    if not w or #old == 0 then return end
    local pattern = {}
    for _, l in ipairs(old) do pattern[#pattern + 1] = "[ \t]*" .. l:gsub("^%s+", ""):gsub("%s+$", ""):gsub("%p", "%%%0") .. "[ \t]*" end
    local p = "\n" .. table.concat(pattern, "\n") .. "\n"
    local _, hits = ("\n" .. w.text):gsub(p, "%0")
    if hits ~= 1 then errors[#errors + 1] = string.format("%s:%d: these lines are %d times in the solution, not once: %s", path, n, hits, old[1]) return end
    local new_text = "\n" .. table.concat(new, "\n") .. "\n"
    w.text = ("\n" .. w.text):gsub(p, function() return new_text end):sub(2)
  end
  local old, new = {}, {}
  for l in lines((read(path) or "") .. "\n") do
    n = n + 1
    local name, lose = l:match("^wrong (.-): *(.-)%s*$")
    local minus, plus = l:match("^%- ?(.*)$"), l:match("^%+ ?(.*)$")
    if minus and #new > 0 then close(old, new); old, new = {}, {} end
    if minus then old[#old + 1] = minus elseif plus then new[#new + 1] = plus
    else close(old, new); old, new = {}, {} end
    if name then
      w = { name = name, lose = {}, text = right, line = n }
      for c in lose:gmatch("%S+") do w.lose[#w.lose + 1] = c end
      t[#t + 1] = w
    end
  end
  return t, errors
end

-- CI: the solution has full points, the starter has not, every wrong one loses what it says.
function Course.prove(e, say)
  local base, good = e.base, true
  local function bad(...) good = false; say("  " .. string.format(...)) end
  local dir = B .. "/course/prove/" .. base
  os.execute("rm -rf " .. quote(dir) .. "; mkdir -p " .. quote(dir))
  local kept = dir .. "/answers."
  local function try(name, text, like)
    os.execute("mkdir -p " .. quote(dir .. "/" .. name))
    local file = dir .. "/" .. name .. "/" .. base .. ".nw"
    write(file, text)
    return Course.try(file, base, dir .. "/" .. name .. "/out", like and dir .. "/" .. like .. "/out", nil, name == "solution" and kept)
  end
  local total = 0
  for _, c in ipairs(criteria_of(base)) do total = total + c.points end
  if math.abs(total - (e.points or 0)) > 1e-9 then bad("%s.c: its criteria are worth %s points, the chapter says %s", base, points_text(total), points_text(e.points or 0)) end
  local r = try("starter", read(starter_file(base)))
  if r.earned >= r.max then bad("the starter has full points") end
  local text = Course.compose(base)
  if not text then bad("there is no solution %s/%s.nw", SOLUTIONS, base) return false end
  r = try("solution", text)
  if not r.refused and not r.sanitized then bad("the solution was not built with the sanitizers") end
  local passed = {}
  for _, c in ipairs(r.criteria) do
    local want = expected_of(base, c.name)
    if c.met and want ~= c.met and not extra[base .. ".c"] then bad("criterion %s meets %d expectations, %s/expectations.csv says %s -- type: tangle/course expectations", c.name, c.met, TESTS, want or "nothing") end
    passed[c.name] = c.met
  end
  if r.refused or r.earned < r.max or r.max == 0 then bad("the solution has %s of %s points:", points_text(r.earned), points_text(r.max)); Course.table(r, e, function(l) say("    " .. l) end) end
  for _, w in ipairs(r.warnings or {}) do bad("the solution: %s", w) end
  -- who judges needs no code of a submission: a program without any comes to the same, given what the solution has answered
  local bare = r.program and r.bare()
  for _, c in ipairs(bare and r.criteria or {}) do
    local f = verdict_of(out_of("COURSE_GIVEN=" .. quote(kept .. c.name) .. " " .. quote(bare) .. " '' " .. c.name .. " 2>/dev/null"), c.name)
    if f[2] ~= "pass" or tonumber(f[3]) ~= passed[c.name] then bad("criterion %s cannot be judged without the solution's code: %s %s %s %s -- each call of it goes through asked or done (tests/course/course.h)", c.name, f[2] or "", f[3] or "", f[4] or "", f[5] or "") end
  end
  os.execute("rm -f " .. quote(kept) .. "*")
  local wrong, errors = Course.wrong(base)
  for _, m in ipairs(errors) do bad("%s", m) end
  if #wrong < 2 then bad("%d wrong solutions are planted, two is the least", #wrong) end
  for i, w in ipairs(wrong) do
    local r2 = try("wrong" .. i, (Course.compose(base, w.text)), "solution")
    local lost = {}
    for _, c in ipairs(r2.criteria) do
      if c.status ~= "ok" then lost[c.name] = true end
      if c.met and passed[c.name] and c.met ~= passed[c.name] then bad("criterion %s meets %d expectations of wrong solution \"%s\", %d of the right one: the number may not depend on the code", c.name, c.met, w.name, passed[c.name]) end
    end
    if r2.refused then bad("wrong solution \"%s\" does not build: %s; %s", w.name, r2.refused, r2.messages[1] or "") end
    if r2.earned >= r2.max then bad("wrong solution \"%s\" has full points", w.name) end
    for _, c in ipairs(w.lose) do if not lost[c] then bad("wrong solution \"%s\" should lose %s, and does not", w.name, c) end end
    if #w.lose == 0 then bad("wrong solution \"%s\" says nothing of what it loses", w.name) end
  end
  say(string.format("%s %-22s %s points, %d criteria, %d wrong solutions%s", good and "ok  " or "FAIL", base, points_text(total), #criteria_of(base), #wrong, good and "" or "  <---"))
  return good
end

function Course.csv(all)
  local t = { "number,exercise,points,minutes" }
  for _, e in ipairs(all) do
    if e.base and e.volume ~= "extra" then t[#t + 1] = string.format("%s,%s,%s,%d", e.number, (read(starter_file(e.base)):match("^# (.-)%s*{#"):gsub(",", "")), points_text(e.points), e.minutes) end
  end
  return table.concat(t, "\n") .. "\n"
end

-- What the chapters' lists must have, and that nothing of a set of files is missing.
function Course.lint(all)
  local errors, by, numbered = {}, {}, {}
  local function bad(e, ...) errors[#errors + 1] = (type(e) == "table" and e.file .. ":" .. e.line or e) .. ": " .. string.format(...) end
  local kinds = { understand = 0, derive = 0, program = 0, explore = 0 }
  for _, e in ipairs(all) do
    if not e.label then bad(e, "an exercise has no label -- write #ex:name") end
    local same = numbered[e.number]
    if same then bad(e, "exercise %s is in %s:%d, too -- give one of the two files another number", e.number, same.file, same.line) end
    numbered[e.number] = e
    for _, k in ipairs { "points", "minutes", "difficulty" } do if not e[k] then bad(e, "the exercise has no %s= -- write {.exercise #ex:name points=2 difficulty=1 minutes=20 kind=derive}", k) end end
    if not kinds[e.kind or ""] then bad(e, "kind=%s -- one of understand, derive, program, explore", tostring(e.kind)) else kinds[e.kind] = kinds[e.kind] + 1 end
    local c = by[e.chapter] or { file = e.file, volume = e.volume, part = e.part, n = 0, starters = 0 }
    by[e.chapter] = c
    c.n = c.n + 1
    c[e.kind or ""] = (c[e.kind or ""] or 0) + 1
    if e.base then
      c.starters = c.starters + 1
      if e.kind ~= "program" then bad(e, "exercise %s has a starter, so it is of the kind program", e.number) end
      local text = read(starter_file(e.base))
      if not text:find("@ex:" .. e.label, 1, true) then bad(e, "the starter %s does not name @ex:%s -- name it there, or give this exercise a starter of its own", starter_file(e.base), e.label) end
      e.name_of = text:match("^# (.-)%s*{#")
      for _, h in ipairs(criteria_of(e.base)) do if not text:find("<<" .. h.hole .. ">>", 1, true) then bad(TESTS .. "/" .. e.base .. ".c:1", "criterion %s names the chunk <<%s>>, which the starter does not have", h.name, h.hole) end end
      for i, f in ipairs { test_file(e.base, "c"), solution_file(e.base), test_file(e.base, "wrong") } do
        if (i == 1 or #list(SOLUTIONS, "nw") > 0) and not read(f) then      -- what a class gets has no solutions
          local ends = ({ "c", "solution", "wrong" })[i]
          bad(e, "%s of exercise %s are missing -- write %s, or <<exercises/%s.%s>> in this chapter", ({ "the criteria", "the solution's chunks", "the wrong solutions" })[i], e.base, f, e.base, ends)
        end
      end
      if not extra[e.base .. ".nw"] and #list(SOLUTIONS, "nw") > 0 and #Course.rubric(e.base) == 0 then bad(e, "what a good explanation says is missing -- add lines for %s to %s/rubrics.tsv", e.base, SOLUTIONS) end
    elseif e.starter then bad(e, "starter=%s, but there is no %s/%s.nw -- write it, or <<exercises/%s.nw>> in this chapter", e.starter, STARTERS, e.starter, e.starter) end
  end
  for _, e in ipairs(all) do
    for _, c in ipairs(e.base and criteria_of(e.base) or {}) do if c.points % 1 ~= 0 then bad(TESTS .. "/" .. e.base .. ".c:1", "criterion %s has %g points -- points are whole numbers", c.name, c.points) end end
  end
  for _, b in ipairs(list(STARTERS, "nw")) do if not find(all, b) then bad(STARTERS .. "/" .. b .. ".nw:1", "belongs to no exercise -- one of them must say starter=%s", b) end end
  if #list(SOLUTIONS, "nw") > 0 and read("book/data/exercises.csv") ~= Course.csv(all) then bad("book/data/exercises.csv:1", "is not what the chapters say -- type: tangle/course csv") end
  -- every derivation has a worked answer, and every implementation chapter a scene to play at its end; what a class gets has no answers
  local answers = read(SOLUTIONS .. "/answers.nw")
  for _, e in ipairs(answers and all or {}) do
    if e.kind == "derive" and e.label and not answers:find('for="ex:' .. e.label .. '"', 1, true) then
      bad(e, "exercise %s is to be derived, and has no worked answer -- write it in %s/answers.nw, in a box {.solution for=\"ex:%s\"}", e.number, SOLUTIONS, e.label) end
  end
  for label in (answers or ""):gmatch('for="ex:([%w_%-]+)"') do
    if not find(all, label) then bad(SOLUTIONS .. "/answers.nw", "answers ex:%s, which no chapter asks", label) end
  end
  for _, c in pairs(by) do
    if c.part ~= "Implementation" and c.volume ~= "methods" and c.volume ~= "testbed" then goto next end
    local try = (read(c.file):match("\n## What you can build now[^\n]*\n(.-)\n## "))
    if not (try and try:find("](scenes/", 1, true)) then bad(c.file, "has no section \"What you can build now\" with a scene to play, ![...](scenes/NAME-STEPS.svg)") end
    if c.n < 4 then bad(c.file, "has %d exercises, four is the least", c.n)
    else for _, k in ipairs { "understand", "derive", "program", "explore" } do if not c[k] then bad(c.file, "has no exercise of the kind %s", k) end end end
    ::next::
  end
  table.sort(errors)
  return errors, by
end

------------------------------------------------------------------------------------------------------------------------ commands
local commands = {}
local function with_names(all) for _, e in ipairs(all) do if e.base then e.name_of = (read(starter_file(e.base)) or ""):match("^# (.-)%s*{#") or (read(starter_file(e.base)) or ""):match("^# (.-)\n") end end return all end
local function where(student, e) return "coursework/" .. student .. "/" .. e.base .. ".nw" end
local function student_of(name)
  name = name or os.getenv("NAME")
  if not name or name == "" then name = "me" end
  if not name:match("^[%w_%-%.]+$") or name:match("^%.") then die("NAME=%s -- a name has letters, digits, - and _", name) end
  return name
end

-- Where what is added to a table of the book is seen at once.
local SHOWN = {
  ["rows of the integrator table"] = "in the testbed's scene \"integrators\" (the first six rows) and in Settings; weft-lab run integrators-order, integrators-slopes, integrators-energy",
  ["rows of the broad phase table"] = "in the testbed's Settings; weft-lab run broad-pairs, broad-time",
  ["rows of the solver table"] = "in the testbed's scene \"solvers\" and in Settings; weft-lab run impulses-stack",
  ["rows of the mixing table"] = "in the testbed's Settings, and by its name in scene files",
  ["rows of the force table"] = "by its name in scene files (kind)",
}
local function shown(base)
  for _, c in ipairs(chunks_of(starter_file(base)).list) do
    if c.name:match("^rows of the ") then return SHOWN[c.name] or "as a row of the table" end
  end
end
Course.shown = shown

function commands.exercise(ids)
  local student = student_of()
  for _, e in ipairs(chosen(with_names(exercises()), ids)) do
    local file = where(student, e)
    if read(file) then print(file .. " is there already; it is left as it is.")
    else
      os.execute("mkdir -p coursework/" .. student)
      write(file, read(starter_file(e.base)))
      print("made: " .. file)
    end
    print(string.format("  Exercise %s, %s: %s points, about %d minutes. It belongs to %s.", e.number, e.name_of, points_text(e.points), e.minutes, e.file))
    print("  Write these chunks at its end, each with the prose that explains it:")
    for _, h in ipairs((holes_of(starter_file(e.base)))) do print("      <<" .. h .. ">>=") end
    print("  What counts:")
    for _, c in ipairs(criteria_of(e.base)) do print(string.format("    %4s  %s", points_text(c.points), c.text)) end
    local name = student == "me" and "" or " NAME=" .. student
    print(string.format("  make try E=%s%s     builds and tests it, as often as you like", e.number, name))
    print(string.format("  make weave E=%s%s   makes a page and a PDF of it", e.number, name))
    if shown(e.base) then print(string.format("  make EXTRA=%s programs   builds the testbed and the lab with it; it is seen\n      %s", file, shown(e.base))) end
  end
end

local function save(results, stem)
  os.execute("mkdir -p " .. quote(stem:match("^(.*)/")))
  write(stem .. ".json", Course.json(results))
  write(stem .. ".xml", Course.junit(results))
end

local function grade(ids, plots)
  local student, all, results = student_of(), with_names(exercises()), {}
  local which
  if ids ~= "" then which = chosen(all, ids)
  else
    which = {}
    for _, e in ipairs(all) do if e.base and read(where(student, e)) then which[#which + 1] = e end end
    if #which == 0 then die("coursework/%s has no exercise -- begin with: make exercise E=10.2%s", student, student == "me" and "" or " NAME=" .. student) end
  end
  local full = true
  for _, e in ipairs(which) do
    local file = where(student, e)
    if not read(file) then die("%s is not there -- make it with: make exercise E=%s%s", file, e.number, student == "me" and "" or " NAME=" .. student) end
    io.stdout:setvbuf("line")
    local r = Course.try(file, e.base, B .. "/course/" .. student .. "/" .. e.base, nil, function(begun)
      begun.student = student
      Course.head(begun, e, print)
      return function(c) Course.criterion(begun, c, print, plots) end
    end)
    r.e = e
    results[#results + 1] = r
    Course.sum(r, print)
    full = full and r.earned == r.max
    save({ r }, B .. "/course/" .. student .. "/" .. e.base .. "/result")
  end
  return results, full, student
end
function commands.try(ids) grade(ids, true) end
function commands.grade(ids)
  local results, _, student = grade(ids, false)
  local earned, max = 0, 0
  print(string.format("\n%-8s %-24s %7s %7s", "", "", "points", "of"))
  for _, r in ipairs(results) do
    print(string.format("%-8s %-24s %7s %7s%s", r.e.number, r.e.label, points_text(r.earned), points_text(r.max), r.refused and "   " .. r.refused or ""))
    earned, max = earned + r.earned, max + r.max
  end
  print(string.format("%-8s %-24s %7s %7s", "sum", "", points_text(earned), points_text(max)))
  local stem = B .. "/course/" .. student .. "/grade"
  save(results, stem)
  print("written: " .. stem .. ".json, " .. stem .. ".xml (JUnit)")
end

function commands.lint()
  local all = exercises()
  local errors, by = Course.lint(all)
  for _, m in ipairs(errors) do io.stderr:write(m, "\n") end
  local programs, n = 0, 0
  for _, e in ipairs(all) do n = n + 1; if e.base then programs = programs + 1 end end
  print(string.format("%d exercises, %d of them with starter, solution and tests; %d complaints", n, programs, #errors))
  os.exit(#errors == 0 and 0 or 1)
end
function commands.csv() write("book/data/exercises.csv", Course.csv(exercises())) end
function commands.list() for _, e in ipairs(exercises()) do if e.base then print(e.base) end end end
function commands.prove(base)
  local e = find(with_names(exercises()), base)
  local t = {}
  local good = Course.prove(e, function(l) t[#t + 1] = l end)
  io.write(table.concat(t, "\n"), "\n")
  os.exit(good and 0 or 1)
end
-- Rows of tests/course/expectations.csv, from the solution.
function commands.expectations(base)
  local dir = B .. "/course/expectations/" .. base
  os.execute("mkdir -p " .. quote(dir))
  write(dir .. "/" .. base .. ".nw", (Course.compose(base)))
  expectations = {}
  local r = Course.try(dir .. "/" .. base .. ".nw", base, dir .. "/out", dir)
  if r.refused then die("%s: %s; %s", base, r.refused, r.messages[1] or "") end
  for _, c in ipairs(r.criteria) do
    if not c.met then die("%s: its solution does not meet the criterion %s", base, c.name) end
    print(string.format("%s,%s,%d", bare(base), c.name, c.met))
  end
end
-- has somebody's last grading this criterion? for graders that ask one thing at a time
function commands.passed(id, name)
  local e = chosen(exercises(), id)[1]
  local j = read(B .. "/course/" .. student_of() .. "/" .. e.base .. "/result.json") or ""
  local status = j:match('"name": "' .. name:gsub("%p", "%%%0") .. '".-"status": "(.-)"') or "not graded"
  print(name .. ": " .. status)
  os.exit(status == "ok" and 0 or 1)
end
function commands.assignment(to, ids)       -- what a class gets beside the book's tree
  local t, tests, runners, results = {}, {}, {}, {}
  os.execute("mkdir -p " .. quote(to .. "/coursework/me") .. " " .. quote(to .. "/.github/workflows"))
  for _, e in ipairs(chosen(with_names(exercises()), ids)) do
    t[#t + 1] = string.format("| %s | %s | %s | %d | `coursework/me/%s.nw` |\n", e.number, e.name_of, points_text(e.points), e.minutes, e.base)
    for _, c in ipairs(criteria_of(e.base)) do
      local id = "c" .. #runners + 1
      runners[#runners + 1] = id
      results[#results + 1] = string.format("          %s_RESULTS: '${{ steps.%s.outputs.result }}'\n", id:upper(), id)
      tests[#tests + 1] = string.format("      - id: %s\n        uses: classroom-resources/autograding-command-grader@v1\n        with:\n          test-name: %s\n          command: %s\n          max-score: %s\n", id,
        json_string(e.number .. " " .. c.text), json_string("teacher/tangle/course passed " .. e.base .. " " .. c.name), points_text(c.points))
    end
    write(to .. "/coursework/me/" .. e.base .. ".nw", read(starter_file(e.base)))
  end
  write(to .. "/ASSIGNMENT.md", "# Assignment\n\n| exercise | | points | minutes | write in |\n|---|---|---|---|---|\n" .. table.concat(t) ..
    "\nRead the appendix on coursework (`chapters/engine/E-coursework.nw`), then:\n\n    tangle/install check          # once: what is missing, and the command that installs it\n    make try E=" ..
    ids:match("[^%s,]+") .. "            # builds and tests one exercise, and says what failed and where\n    make grade                  # all of them, with points\n\nHand in by committing `coursework/me/`.\n")
  -- Both take the grader, the tests and the starters from the teacher's repository (named in the variable WEFT_TEACHER), and from the student's
  -- the files of coursework/me alone. tests/course/ci.sh runs them.
  local fill = { INSTALL = "apt-get update && SUDO apt-get install -y --no-install-recommends gcc libc6-dev make noweb lua5.4 pkg-config libcjson-dev libstb-dev fonts-dejavu-core gnuplot-nox",
    TESTS = table.concat(tests), RESULTS = table.concat(results), RUNNERS = table.concat(runners, ",") }
  local function filled(text, sudo) return (text:gsub("%f[%u]%u+%f[^%u_]", fill):gsub("SUDO ", sudo)) end
  write(to .. "/.github/workflows/classroom.yml", filled([[
name: Grade
on: [push, workflow_dispatch]
permissions: { checks: write, actions: read, contents: read }
jobs:
  grade:
    runs-on: ubuntu-latest
    steps:
      - uses: actions/checkout@v4
        with: { path: student }
      - uses: actions/checkout@v4
        with: { path: teacher, repository: '${{ vars.WEFT_TEACHER }}', token: '${{ secrets.WEFT_TOKEN }}' }
      - run: SUDO INSTALL
      - run: teacher/tangle/course from student
TESTS      - uses: classroom-resources/autograding-grading-reporter@v1
        env:
RESULTS        with: { runners: 'RUNNERS' }
      - uses: actions/upload-artifact@v4
        if: always()
        with: { name: grade, path: teacher/build/course/me/grade.* }
]], "sudo "))
  write(to .. "/.gitlab-ci.yml", filled([[
grade:
  image: debian:stable-slim
  variables: { GIT_STRATEGY: clone }
  script:
    - INSTALL git ca-certificates
    - rm -rf teacher && git clone --depth 1 "$WEFT_TEACHER" teacher
    - teacher/tangle/course from .
  artifacts:
    when: always
    paths: [teacher/build/course/me/grade.json]
    reports:
      junit: teacher/build/course/me/grade.xml
]], ""))
end
function commands.composed(base, to) write(to, (Course.compose(base))) end
function commands.tests(base)              -- both of an exercise's test objects, so that they are there in a room
  local out = B .. "/course/ready/" .. base
  os.execute("mkdir -p " .. quote(out))
  Course.test_object(base, out, "", ".o")
  Course.test_object(base, out, SANITIZE, ".san.o")
end
function commands.progress()
  local student, all, solved = student_of(), with_names(exercises()), {}
  local done = read("coursework/" .. student .. "/done.txt") or ""
  local earned, sum = 0, 0
  local chapter
  for _, e in ipairs(all) do
    if e.chapter ~= chapter then
      chapter = e.chapter
      local built = read(B .. "/upto/" .. chapter .. "/lib/libweft.a") and "built and tested (make upto CHAPTER=" .. chapter .. ")" or e.part ~= "Appendices" and "make upto CHAPTER=" .. chapter or ""
      print(string.format("%-3s %s%s", chapter, e.title:gsub("%s*{.*", ""), built ~= "" and "   -- " .. built or ""))
    end
    local state = "    "
    if e.base then
      local j = read(B .. "/course/" .. student .. "/" .. e.base .. "/result.json")
      local got = j and j:match('"earned": ([%d%.]+)')
      if got then state = tonumber(got) >= e.points and "done" or "part"; earned = earned + tonumber(got)
      elseif read(where(student, e)) then state = "open" end
    elseif (" " .. done:gsub("%s", " ") .. " "):find(" " .. e.number .. " ", 1, true) then state = "done"; earned = earned + e.points end
    sum = sum + e.points
    print(string.format("    %s %s %-6s %-26s %-11s %2d points %4d min", state, e.base and "*" or " ", e.number, e.label, e.kind, e.points, e.minutes))
  end
  print(string.format("%s of %s points.  * has a starter: make exercise E=its number. What is solved on paper you tick yourself: echo 10.1 >> coursework/%s/done.txt", points_text(earned), points_text(sum), student))
end
function commands.number(id) local e = find(exercises(), id); print(e and e.number or "0") end
function commands.find(id) local e = find(exercises(), id); if e and e.base then print(e.base) else os.exit(1) end end
function commands.holes(file) for _, h in ipairs((holes_of(file))) do print(h) end end
function commands.points(base) local m = 0 for _, c in ipairs(criteria_of(base)) do m = m + c.points end print(points_text(m)) end

require "class"(Course, commands, { read = read, write = write, quote = quote, out_of = out_of, ok = ok, lines = lines, points_text = points_text, die = die, B = B, bare = bare, chosen = chosen, find = find,
  with_names = with_names, criteria_of = criteria_of, chunks_of = chunks_of, Refuse = Refuse })

local command = table.remove(arg, 1)
if not commands[command or ""] then die("no command %s", tostring(command)) end
commands[command](table.unpack(arg))
return Course
