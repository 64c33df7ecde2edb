-- house.lua: what the house promises of its files, measured, and held against tests/house/declared.
--
--   lua house.lua DECLARED CHAPTER ...        (from the root of the repository)
--
-- declared has two kinds of lines:
--   over PATH N     the file PATH is over the limit of its kind, and has at most N lines. The list only gets shorter: a file that has
--                   become small enough and is still on it fails the test.
--   most WHAT N     there are at most N of WHAT. When a twentieth of them is gone, N has to follow.
local limits = { c = 1200, engine = 1800, chapter = 2500, header = 350, pieces = 3 }
local declared_file = table.remove(arg, 1)
local failures = 0
local function fail(...) failures = failures + 1; print(table.concat({ ... })) end

local over, most = {}, {}
local number = 0
for l in io.lines(declared_file) do
  number = number + 1
  local path, n = l:match("^over (%S+) (%d+)$")
  local what, k = l:match("^most (%S+) (%d+)$")
  if path then over[path] = { limit = tonumber(n), line = number }
  elseif what then most[what] = tonumber(k)
  elseif l ~= "" and not l:match("^#") then fail(declared_file, ":", number, ": not understood: ", l) end
end
local function size(path, lines, limit, kind)
  local d = over[path]
  if d then d.seen = true end
  if lines <= limit then
    if d then fail(declared_file, ":", d.line, ": ", path, " has ", lines, " lines, ", kind, " may have ", limit, ": take it off the list") end
  elseif not d then fail(path, ": ", lines, " lines, and ", kind, " may have ", limit, ": cut it in two")
  elseif lines > d.limit then fail(path, ": ", lines, " lines, and ", d.limit, " are declared: it has grown") end
end
local function count(what, n, text)
  local m = most[what]
  most[what] = nil
  print(("%-22s %6d  %s"):format(what, n, text))
  if not m then fail(declared_file, ": how many of ", what, " there may be is not said -- add: most ", what, " ", n)
  elseif n > m then fail(what, ": ", n, ", and ", m, " are declared: there are more")
  elseif n < m - m / 20 then fail(what, ": ", n, ", and ", m, " are declared: lower the number in ", declared_file) end
end
local function lines_of(path)
  local t = {}
  for l in io.lines(path) do t[#t + 1] = l end
  return t
end

-- The chapters: their length, which piece of a chunk each line belongs to, pieces that hold nothing but a comment, and short ones. A piece
-- of three lines or fewer has a reason if it, or another piece of its chunk, is a part's (an .only or a heading with part=), if another
-- chapter gives to the chunk or takes it, or if it is a file's or an exercise's.
local hollow, pieces_in_all = 0, 0
local short, short_in_all, parts_chunk, chapters_of = {}, 0, {}, {}
local function of_chapter(name, path) chapters_of[name] = chapters_of[name] or {}; chapters_of[name][path] = true end
local piece_of = {}                              -- piece_of[path][line]: the line where its piece begins
for _, path in ipairs(arg) do
  local lines, of = lines_of(path), {}
  piece_of[path] = of
  local engine = path:match("^chapters/engine/") ~= nil
  size(path, #lines, engine and limits.engine or limits.chapter, engine and "a chapter of the engine volume" or "a chapter")
  local body, start, name
  local divs, headings = {}, {}                  -- those that are open, and whether a part has them
  for i, l in ipairs(lines) do
    if l:match("^<<.*>>=%s*$") then body, start, name = {}, i, l:match("^<<(.*)>>=")
    elseif body and (l == "@" or l:match("^@ ")) then
      pieces_in_all = pieces_in_all + 1
      if table.concat(body, "\n"):gsub("/%*.-%*/", ""):match("^%s*$") then hollow = hollow + 1 end
      local code, parts = 0, false
      for _, b in ipairs(body) do
        if b:match("%S") then code = code + 1 end
        for used in b:gmatch("%f[@<]<<(.-)>>") do of_chapter(used, path) end
      end
      for _, open in ipairs { divs, headings } do for _, d in pairs(open) do parts = parts or d end end
      parts_chunk[name] = parts_chunk[name] or parts
      of_chapter(name, path)
      if code <= 3 then
        short_in_all = short_in_all + 1
        if not name:match("^[%w_/%-]+%.%a+$") and not path:match("^chapters/exercises/") and not path:match("^chapters/solutions/") then
          short[#short + 1] = { path = path, line = start, name = name }
        end
      end
      body = nil
    elseif not body and l:match("^#+ ") then
      local level = #l:match("^#+")
      for k = level, 6 do headings[k] = false end
      headings[level] = l:find('[ {]part="') ~= nil
    elseif not body and l:match("^:::+ *$") then divs[#divs] = nil
    elseif not body and l:match("^:::+ *%S") then divs[#divs + 1] = l:find('part="') ~= nil
    elseif body then
      body[#body + 1] = l
      of[i] = start
    end
  end
end

-- The tangled files: their length, and marks of the old kind.
local function each(command, visit)
  local p = assert(io.popen(command .. " | LC_ALL=C sort"))
  for path in p:lines() do visit(path, lines_of(path)) end
  p:close()
end
each("find src-generated -name '*.[ch]'", function(path, lines)
  if path:match("%.c$") then size(path, #lines, limits.c, "a file of C") end
  local n = 0
  for i, l in ipairs(lines) do
    if l:match("^%s*/%* <.*> %*/$") then fail(path, ":", i, ": a chunk's name in angle brackets: ", l) end
    if not l:match("^%s*$") then n = n + 1 end
  end
  if path:match("^src%-generated/include/weft/") then size(path, n, limits.header, "a public header") end
end)

-- The same files with #line, which tells from how many pieces a function is sewn.
local functions, sewn, worst, worst_pieces = 0, 0, "", 0
each("find build/lines -name '*.c'", function(path, lines)
  local file, at, head, seen
  for _, l in ipairs(lines) do
    local n, f = l:match('^#line (%d+) "([^"]+)"')
    if n then file, at = f, tonumber(n)
    else
      if l == "{" and not seen then seen = {} end
      if seen and piece_of[file] and piece_of[file][at] then seen[file .. piece_of[file][at]] = true end
      if l:match("^}") and seen then
        local pieces = 0
        for _ in pairs(seen) do pieces = pieces + 1 end
        functions = functions + 1
        if pieces > limits.pieces then sewn = sewn + 1 end
        if pieces > worst_pieces then worst, worst_pieces = path .. ": " .. head, pieces end
        seen = nil
      end
      if l:match("^%a") then head = l end
      at = at and at + 1
    end
  end
end)

count("comment-only-pieces", hollow, "of " .. pieces_in_all .. " pieces of chunks")
local needless = 0
for _, d in ipairs(short) do
  local chapters = 0
  for _ in pairs(chapters_of[d.name]) do chapters = chapters + 1 end
  if not parts_chunk[d.name] and chapters < 2 then
    needless = needless + 1
    fail(d.path, ":", d.line, ": a piece of three lines or fewer, and no other chapter or part has to do with <<", d.name, ">>: join it to the next piece, or write it where it is used")
  end
end
print(("%-22s %6d  %s"):format("short-pieces", short_in_all, "have three lines or fewer; " .. needless .. " of them without a reason"))
count("functions-sewn", sewn, "of " .. functions .. " functions have more than " .. limits.pieces .. " pieces; " .. worst_pieces .. " has " .. worst)
local files = 0
for path, d in pairs(over) do
  files = files + 1
  if not d.seen then fail(declared_file, ":", d.line, ": there is no ", path, ": take it off the list") end
end
for what in pairs(most) do fail(declared_file, ": nothing is called ", what) end
if failures > 0 then os.exit(1) end
print(("house: %d files of C, headers and chapters are declared to be too long, none without"):format(files))
