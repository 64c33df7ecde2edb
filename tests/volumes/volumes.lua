-- volumes.lua: what the printed volumes promise, read from what was made.
--   lua volumes.lua BUILD BOUNDS [--record]
-- Pages of each volume (BOUNDS: "name pages" a line, numbers that only fall) and of each week of the course; sizes of letters in tables and code;
-- references to other volumes: they lead to a place that is there, have that volume's letter, and the first of a chapter names the volume;
-- references that tell a page.
local build, bounds, record = arg[1], arg[2], arg[3] == "--record"
local function read(path) local f = io.open(path, "rb") if not f then return nil end local s = f:read("a") f:close() return s end
local function run(command) local p = io.popen(command) local s = p:read("a") p:close() return s end
local errors = {}
local function bad(...) errors[#errors + 1] = string.format(...) end
local db = assert(loadfile(build .. "/weave/db.lua"))()
local GOAL = { engine = 500 }

---------------------------------------------------------------------------------------------------------------- pages
local limit, pages, order = {}, {}, {}
for name, n in (read(bounds) or ""):gsub("#[^\n]*", ""):gmatch("(%w+) (%d+)") do limit[name] = tonumber(n) end
for _, v in ipairs(db.volumes) do
  local n = tonumber(run("pdfinfo '" .. build .. "/book/" .. v.name .. ".pdf' 2>/dev/null"):match("Pages: +(%d+)"))
  if not n then bad("%s/book/%s.pdf is not there -- make pdf", build, v.name)
  else
    pages[v.name], order[#order + 1] = n, v.name
    if record then limit[v.name] = math.min(limit[v.name] or n, n) end
    if not limit[v.name] then bad("%s has no bound in %s -- add one", v.name, bounds)
    elseif n > limit[v.name] then bad("%s.pdf has %d pages, %d more than it may -- shorten a chapter, or put a section on the pages alone (print=\"web\")", v.name, n, n - limit[v.name])
    elseif n < limit[v.name] then print(v.name .. ".pdf has fewer pages than its bound: tests/volumes/run.sh --record") end
  end
end
if record then
  local head, t = (read(bounds) or ""):match("^(#.-\n)[^#]") or "", {}
  for _, v in ipairs(order) do t[#t + 1] = v .. " " .. limit[v] .. "\n" end
  local f = assert(io.open(bounds, "w"))
  f:write(head, table.concat(t))
  f:close()
end
for i, v in ipairs(order) do
  order[i] = v .. " " .. pages[v] .. (GOAL[v] and pages[v] > GOAL[v] and " (" .. pages[v] - GOAL[v] .. " above its goal of " .. GOAL[v] .. ")" or "")
end
print("pages: " .. table.concat(order, ", "))

----------------------------------------------------------------------------------------------- the weeks of the course
-- A week reads from one heading to before another; where these stand is in the PDF, to the line. TOP, FOOT: of a page's text (book/book.tex).
local MOST, TOP, FOOT = 40, 635, 65
do
  local first, place, said = db.volumes[1].name, {}, {}
  for page, y, id in run("pdfinfo -dests '" .. build .. "/book/" .. first .. ".pdf' 2>/dev/null"):gmatch('(%d+) %[ XYZ +%-?%d+ +(%-?%d+) null *%] "(sec:[^"\n]+)"') do
    place[id] = tonumber(page) + math.max(0, math.min(1, (TOP - tonumber(y)) / (TOP - FOOT)))
  end
  for _, h in ipairs(db.heads) do if h.level == 1 and place[h.id] then place[h.id] = math.floor(place[h.id]) end end     -- a chapter begins a page
  if #db.weeks ~= 12 then bad("the course has %d weeks, not 12 -- see the table of the chapter coursework", #db.weeks) end
  for i, w in ipairs(db.weeks) do
    local n = 0
    if tonumber(w.n) ~= i then bad("week %s of the course stands in place %d", w.n, i) end
    for _, span in ipairs(w.spans) do
      if place[span[1]] and place[span[2]] then n = n + place[span[2]] - place[span[1]]
      else bad("week %s: %s or %s is not in %s.pdf", w.n, span[1], span[2] or "its end", first) end
    end
    if n > MOST then bad("week %s reads %.1f pages, more than %d -- leave out a section, or move one to another week (coursework)", w.n, n, MOST) end
    if n < MOST / 4 then bad("week %s reads %.1f pages: is its row right?", w.n, n) end
    said[i] = string.format("%.1f", n)
  end
  print("weeks: " .. table.concat(said, " ") .. " pages")
end

---------------------------------------------------------------------------- letters: TeX has counted those that it has shipped
-- kind font size count page; kind 1: tables, 2: chunks and blocks of code. Formulas are apart, for their indices are small.
local least = {}
for _, v in ipairs(db.volumes) do
  local text = read(build .. "/tex/" .. v.name .. ".sizes") or bad("%s/tex/%s.sizes is not there", build, v.name) or ""
  for kind, font, size, count, page in text:gmatch("(%d) (%S+) (%S+) (%d+) (%d+)\n") do
    size = tonumber(size)
    local what = font:match("^JetBrains") and (kind == "1" and "table" or "code") or kind == "1" and not font:match("Math") and "table"
    if what then
      least[what] = math.min(least[what] or 99, size)
      if size < (what == "code" and 7.6 or 7) - 0.005 then bad("%s.pdf has %s letters of a %s in %s %s pt, first on page %s", v.name, count, what, font, size, page) end
    end
  end
  local turned = (read(build .. "/tex/" .. v.name .. ".log") or ""):match("wFit: turned, (%S+)")
  if turned then bad("%s.pdf has a table that is too wide at 7 pt (%s) -- leave out a column, or shorten its text", v.name, turned) end
end
print(string.format("least letters: %s pt in tables, %s pt in code", least.table or "none", least.code or "none"))

--------------------------------------------------------------------------------------------- references across volumes
local there, count = {}, 0
for _, v in ipairs(db.volumes) do
  there[v.name] = { letter = v.letter, short = v.short }
  for name in run("pdfinfo -dests '" .. build .. "/book/" .. v.name .. ".pdf' 2>/dev/null"):gmatch('"([^"\n]+)"') do there[v.name][name] = true end
end
for _, e in ipairs(db.entries) do
  local text = e.page and not e.of and read(build .. "/tex/ch/" .. e.name .. ".tex")
  local named = {}
  for volume, id, words, behind in (text or ""):gmatch("\\wFar{(%w+)}{([^}]*)}{([^}]*)}()") do
    count = count + 1
    if not there[volume] then bad("%s refers to a volume %s", e.name, volume)
    else
      if not there[volume][id] then bad("%s: %s (%s) is not in %s.pdf", e.name, words, id, volume) end
      if (words:match("~%(?(%u?)%d") or "") ~= there[volume].letter then bad("%s: %s has not the letter of %s", e.name, words, volume) end
      if not named[volume] and text:sub(behind, behind + 9) ~= " of \\emph{" then bad("%s: the first reference to %s, %s, does not name it", e.name, volume, words) end
    end
    named[volume] = true
  end
end
-- In the first volume the first mention of a section of another chapter tells its page: each that is asked for is printed, with the page where it is.
do
  local first = db.volumes[1].name
  local page, before, n = {}, nil, 0
  for p, id in run("pdfinfo -dests '" .. build .. "/book/" .. first .. ".pdf' 2>/dev/null"):gmatch('(%d+) %[[^%]\n]*%] "(sec:[^"\n]+)"') do page[id] = tonumber(p) end
  for _, h in ipairs(db.heads) do before = before or h.level == 1 and page[h.id] end      -- its pages before the first chapter have numbers of their own
  local text = run("pdftotext '" .. build .. "/book/" .. first .. ".pdf' - 2>/dev/null"):gsub("%s+", " ")
  local all = { { name = "glossary", page = "glossary.html" } }
  for _, e in ipairs(db.entries) do all[#all + 1] = e end
  for _, e in ipairs(all) do
    local seen, source = {}, (e.name == "glossary" or db.volume_of[e.page or ""] == first and not e.of) and read(build .. "/tex/ch/" .. e.name .. ".tex") or ""
    source = source:gsub("\\hyperlink{sec:[^}]*}{Section\\ [^}]*}", "")      -- in a comment of the code
    for id, words, on in source:gmatch("\\hyperlink{(sec:[^}]*)}{([^}]*)}(%S*)") do
      local told = on:match("^\\wOn{([^}]*)}")
      local elsewhere = e.name == "glossary" or words:match("^Section") and db.labels[id] and db.labels[id].page ~= e.page and not seen[id]
      seen[id] = true
      if elsewhere and told ~= id then bad("%s: %s is in another chapter, and its first mention does not tell the page", e.name, words) end
      if told then
        local name, number, here, at = words:gsub("~", " "), tostring(page[id] and page[id] - before + 1 or "?"), false, 0
        n = n + 1
        repeat                                         -- a page's end may stand between the two
          at = text:find(name, at + 1, true)
          here = here or at and text:sub(at + #name, at + #name + 160):match("^%W?.-%f[%w]page " .. number .. "%f[%D]") ~= nil
        until here or not at
        if not here then bad("%s.pdf has nowhere '%s on page %s', which %s says", first, name, number, e.name) end
      end
    end
  end
  if n < 50 then bad("only %d references tell their page", n) end
  print(n .. " references tell their page")
end
if count < 100 then bad("only %d references to other volumes were found", count) end
print(count .. " references to other volumes")

------------------------------------------------------------------- the tables that a chapter may add rows to: print has each, with its place
do
  local first, n = db.volumes[1].name, 0
  local text = run("pdftotext -raw '" .. build .. "/book/" .. first .. ".pdf' - 2>/dev/null"):gsub("\u{ad}", ""):gsub("%s+", " "):match("A chapter may add rows to any of these tables(.*)") or ""
  for l in io.lines("book/extensions.tsv") do
    local name = l:match("^([^#\t][^\t]*)\t")
    if name then
      n = n + 1
      local place = text:match("\u{27e8}" .. name:gsub("%p", "%%%0") .. "\u{27e9} (%u?%d+%.%d+[^:]*):")
      if not place then bad("%s.pdf does not list the table '%s' among those that a chapter may add rows to -- tangle/extensions", first, name)
      elseif place:find("?", 1, true) then bad("%s.pdf: the table '%s' is on page ??", first, name) end
    end
  end
  print(n .. " tables that a chapter may add rows to")
end

------------------------------------------------------------------------------------------- the glossary: its words are used
do
  local text = run("pdftotext '" .. build .. "/book/" .. db.volumes[1].name .. ".pdf' - 2>/dev/null"):gsub("\u{ad}", ""):gsub("-\n", "-"):gsub("%s+", " ")
  local at, from = nil, 1                              -- the glossary itself is behind the last chapter
  repeat at, from = from, (text:find("Glossary AABB", from, true) or #text + 1) + 1 until from > #text
  text = text:sub(1, at - 1):lower()
  local last
  for _, g in ipairs(db.glossary) do
    local term, n, i = g.term:lower(), 0, 0
    while true do
      i = text:find(term, i + 1, true)
      if not i then break end
      if not text:sub(i - 1, i - 1):match("%a") then n = n + 1 end
    end
    if n == 0 then bad("the glossary explains '%s', and the first volume has not the word -- use it, or take it out of book/glossary.tsv", g.term) end
    if last and term < last then bad("the glossary has '%s' behind '%s' -- sort it", g.term, last) end
    last = term
    if db.volume_of[db.labels[g.id].page] ~= db.volumes[1].name or db.labels[g.id].online then bad("the glossary sends the reader of '%s' out of the volume", g.term) end
  end
  if #db.glossary < 30 then bad("the glossary has %d words", #db.glossary) end
  print(#db.glossary .. " words in the glossary")
end

--------------------------------------- one letter, one thing: p is a place, g the acceleration of gravity, s a gap (the table of symbols)
do
  local n = 0
  for path in io.popen("ls chapters/" .. db.volumes[1].name .. "/*.nw"):lines() do
    local code = false
    for line in io.lines(path) do
      if line:match("^<<.*>>=%s*$") then code = true elseif line:match("^@%s") or line == "@" then code = false end
      for formula in (code and "" or line):gsub("%$%$", "$"):gmatch("%$([^$]+)%$") do
        local bare = formula:gsub("\\vec%s*{?%s*%a}?", ""):gsub("\\%a+%s*{[%a ]*}", ""):gsub("\\%a+", " ")
        n = n + 1
        if (bare .. " "):find("%f[%a]p[^%a_]") and not path:find("/20-") then bad("%s: p is a place and no number, in $%s$", path, formula) end
        if bare:find("%f[%a]g_") then bad("%s: g is the acceleration of gravity alone, in $%s$", path, formula) end
      end
    end
  end
  if n < 1000 then bad("only %d formulas were read", n) end
  print(n .. " formulas keep to the table of symbols")
end

--------------------------------------------------- the subject index and the list of formulas: of the volumes as they are printed
do
  local said = {}
  for i, v in ipairs(db.volumes) do
    local index = read(build .. "/tex/" .. v.name .. ".ind") or ""
    local terms, n = {}, 0
    for term, pages in ("\n" .. index):gmatch("\n\\par ([^\n]-)\\enspace ([^\n]*)") do
      terms[term], n = true, n + 1
      if not pages:match("%d") then bad("%s.pdf: the index has no page for '%s'", v.name, term) end
    end
    said[i] = n
    if n < (i == 1 and 150 or 10) then bad("the index of %s.pdf has %d terms", v.name, n) end
    if i == 1 then for _, g in ipairs(db.glossary) do if not terms[g.term] then bad("the glossary's word '%s' is not in the index of %s.pdf", g.term, v.name) end end end
  end
  local first, list, n = db.volumes[1].name, {}, 0
  for id, num, name, code in (read(build .. "/weave/formulas-" .. first .. ".tex") or ""):gmatch("\\wFormula{(.-)}{(.-)}{(.-)}{(.-)}\n") do
    list[id], n = true, n + 1
    if name == "" or code == "" then bad("the list of formulas has no name or no function for (%s)", num) end
  end
  local text = run("pdftotext '" .. build .. "/book/" .. first .. ".pdf' - 2>/dev/null"):match("The numbered formulas that code(.*)") or ""
  for id, e in pairs(db.eqs) do
    if db.volume_of[e.page] == first and #(e.chunks or {}) > 0 and not db.labels[id].online then
      if not list[id] then bad("code computes (%s), %s, and the list of formulas has it not", e.num, id)
      elseif not text:find("(" .. e.num .. ")", 1, true) then bad("the printed list of formulas lacks (%s)", e.num) end
    end
  end
  if n < 150 then bad("the list of formulas has %d", n) end
  print("index: " .. table.concat(said, ", ") .. " terms; " .. n .. " formulas with their code")
end

for i, e in ipairs(errors) do if i <= 30 then print("FAIL  " .. e) end end
os.exit(#errors == 0)
