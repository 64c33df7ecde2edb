-- weave.lua: from noweb's markup to what the pages are made of.
--
--   lua weave.lua OUT [--tolerant] [--strict] [--html DIR] [--only WORDS] [--without WORDS] [--called NAME] [--bytes TEXT] < stream
--
-- OUT/db.lua      what every page needs: numbers of labels, names of chunks, definitions of identifiers, contents
-- OUT/BASE.md     one chapter as pandoc Markdown, each chunk replaced by a marker
-- OUT/BASE.lua    its chunks, lexed, each identifier resolved
-- OUT/chapters.tex, OUT/pages.list, and in DIR the pages that need no pandoc (index, lists, assembled sources, search index)
-- All are written only when they change, so that make remakes only the pages that must change.
-- With --strict, a numbered equation that no code refers to is an error, not a warning.
-- With --tolerant, errors are told but what can be woven is woven.
-- With --only or --without (as tangle.lua), the book of an engine that has some parts alone: the chapters that have a chunk of it, without the
-- sections and boxes of other parts; numbers are those of the whole book. OUT/bases lists its pages; the first tells of the engine.
local here = arg[0]:match("^(.*/)") or "./"
package.path = here .. "?.lua;" .. package.path
local Book, Code, Parts = require "book", require "weave-code", require "parts"

local out, tolerant, strict, html_dir
local how, called, bytes = nil, nil, nil      -- which parts, the name of what they were chosen for, how large that engine is
do
  local i = 1
  while arg[i] do
    if arg[i] == "--tolerant" then tolerant = true
    elseif arg[i] == "--strict" then strict = true
    elseif arg[i] == "--html" then i = i + 1; html_dir = arg[i]
    elseif arg[i] == "--only" or arg[i] == "--without" then how = how or {}; how[arg[i]:sub(3)] = arg[i + 1]; i = i + 1
    elseif arg[i] == "--called" then i = i + 1; called = arg[i]
    elseif arg[i] == "--bytes" then i = i + 1; bytes = arg[i]
    else out = arg[i] end
    i = i + 1
  end
  assert(out, "usage: lua weave.lua OUT [--tolerant] [--strict] [--html DIR] < stream")
end
local root = os.getenv("WEFT_ROOT") or here:gsub("[^/]+/$", "")
if root == "" then root = "./" end

local stream = io.read("a")
local tmp = assert(io.tmpfile())
tmp:write(stream)
tmp:seek("set")
local book = Book.read(tmp)
tmp:close()
book:check_chunks()
local chunks_good = #book.errors == 0
-- The book of a smaller engine: its chunks, of a name the pieces that it has; sections in which it has no code (by file and line).
local chosen, keep, gone_at = nil, nil, {}
if how then
  chosen = Parts.choose(book, how)
  keep = Parts.reached(book, chosen)
  for i, c in ipairs(book.chunks) do if not keep[i] then c.gone = true end end
  local stack, ci, line, code, index, fence = {}, 0, 1, false, 0, false
  for l in stream:gmatch("([^\n]*)\n") do
    local key, rest = l:match("^@(%S+) ?(.*)$")
    if key == "file" then ci, line, stack, fence = ci + 1, 1, {}, false
    elseif key == "begin" then code = rest:match("^code") ~= nil
    elseif key == "defn" then
      index = index + 1
      for _, s in pairs(stack) do s.all = s.all + 1; s.kept = s.kept + (keep[index] and 1 or 0) end
    elseif key == "text" and not code then
      if rest:match("^```") or rest:match("^~~~") then fence = not fence end
      local marks = not fence and rest:match("^(##+)%s")
      if marks then
        for level in pairs(stack) do if level >= #marks then stack[level] = nil end end
        stack[#marks] = { all = 0, kept = 0 }
        gone_at[ci .. ":" .. line] = stack[#marks]
      end
    elseif key == "nl" or key == "index" and rest:match("^nl") then line = line + 1 end
  end
  for _, n in pairs(book.names) do
    local parts, uses = {}, {}
    for _, p in ipairs(n.parts) do if keep[p] then parts[#parts + 1] = p; book.chunks[p].part = #parts end end
    for _, u in ipairs(n.uses) do if keep[u.chunk] then uses[#uses + 1] = u end end
    n.parts, n.uses = parts, uses
  end
  for _, c in ipairs(book.chapters) do c.gone = true end
  for i, c in ipairs(book.chunks) do if keep[i] then book.chapters[c.chapter].gone = nil end end
end
local warnings = {}
local function warn(file, line, what, remedy)
  if how then return end
  if strict then book:complain(file, line, what, remedy) return end
  warnings[#warnings + 1] = string.format("%s:%d: warning: %s -- %s", file, line, what, remedy)
end

----------------------------------------------------------------------------------- the plan: every chapter, written or not
-- entries: of the contents, volume by volume; entry_of[name]; what belongs to a chapter (e.of) and solved exercises come behind.
local entries, entry_of, volumes = {}, {}, {}
local function sh(s) return "'" .. s:gsub("'", "'\\''") .. "'" end
local function plan(what)
  local p = io.popen("WEFT_ROOT=" .. sh(root) .. " " .. sh(here .. "chapters") .. " --" .. what)
  local text = p:read("a")
  p:close()
  return text:gmatch("([^\n]+)")
end
do
  local parts, list = {}, {}
  for l in plan "volumes" do
    local name, letter, title, short, what = (l .. "\t\t\t"):match("^(.-)\t(.-)\t(.-)\t(.-)\t(.-)\t")
    volumes[#volumes + 1] = { name = name, letter = letter, title = title, short = short ~= "" and short or title, what = what }
    volumes[name] = { order = #volumes, title = title }
  end
  for l in plan "plan" do
    local name, volume, num, part, title, report = l:match("^(.-)\t(.-)\t(.-)\t(.-)\t(.-)\t(.*)$")
    local v = volumes[volume] or { order = 50, title = volume }
    local e = { name = name, num = num, volume = volume, part = (volume == volumes[1].name or part == "Appendices") and part or v.title, title = title, report = report, planned = true }
    e.appendix = part == "Appendices" or nil
    e.order = (e.appendix and 99 or v.order) * 1000 + #list
    if volume == volumes[1].name and not e.appendix then      -- the engine has parts, as the report; each other volume is one
      if not parts[part] then parts[#parts + 1] = part; parts[part] = #parts end
      e.part_number = parts[part]
    end
    list[#list + 1] = e
    entry_of[name] = e
  end
  table.sort(list, function(x, y) return x.order < y.order end)
  for i, e in ipairs(list) do e.order = nil; entries[i] = e end
  if how then
    for i = #volumes, 2, -1 do volumes[i] = nil end
    volumes[1].title, volumes[1].short = "An engine " .. (called or "of some parts"), "this book"
    volumes[1].what = "The chapters of what it contains"
  end
end
local exercise_number = {}                 -- by the name of its starter
do
  local chapter, k, ci = nil, 0, 0
  for l in stream:gmatch("([^\n]*)\n") do
    if l:match("^@file ") then ci = ci + 1; chapter, k = book.chapters[ci], 0
    elseif l:match("^@text :::+ *{%.exercise ") then
      k = k + 1
      local starter = l:match("starter=([%w_%-]+)")
      if starter and entry_of[chapter.name] then exercise_number[starter] = entry_of[chapter.name].num .. "." .. k end
    end
  end
end
local volume_of = {}                       -- a page's volume; what is not in the plan goes to the first
local reserved = { index = 1, subjects = 1, glossary = 1, formulas = 1, chunks = 1, identifiers = 1, sources = 1, bibliography = 1, gallery = 1, testbed = 1 }
local online = {}                          -- pages and anchors that the print has not
local taken = {}                           -- a printed number: the file of its chapter
for _, e in ipairs(entries) do taken[e.num] = "book/plan.tsv" end
for _, c in ipairs(book.chapters) do
  local e = entry_of[c.name]
  local chapter = c.of and entry_of[c.of]
  if reserved[c.name] or c.name:match("^slides%-%d+$") then book:complain(c.file, 1, "no chapter can be called " .. c.name .. ", for a page of the book is", "give its file another name") end
  if chapter and not e then                                         -- NAME.figures, NAME.lab
    local kind = c.name:match("%.(%a+)$")
    e = { name = c.name, of = c.of, volume = chapter.volume, part = chapter.part, num = chapter.num .. "." .. kind:sub(1, 1):upper(),
      title = kind == "lab" and "Measurements: the code" or "Figures: the code" }
    c.online = true
    entry_of[c.name] = e
    entries[#entries + 1] = e
  elseif not e then                                                 -- not in the plan: a student's chapter, or a solved exercise
    local number = exercise_number[c.name]
    local num = number or c.label:gsub("^0+(%d)", "%1")
    if taken[num] then
      book:complain(c.file, 1, "chapter number " .. num .. " is taken by " .. taken[num], "give this file another number")
    end
    taken[num] = c.file
    e = { name = c.name, num = num, part = (number or c.label:match("%.")) and "Exercises" or "Chapters of your own", title = c.name, exercise = number and true or nil }
    entries[#entries + 1] = e
    entry_of[c.name] = e
  end
  e.planned = nil
  if how then e.volume, e.gone = volumes[1].name, c.gone end
  c.entry, c.num = e, e.num
  e.file, e.page = c.file, c.name .. ".html"
  volume_of[e.page] = e.volume or volumes[1].name
  if c.online then online[e.page] = true end
end

local labels, heads, where = {}, {}, {}      -- labels by id; headings in order; where[id] = "file:line"
local db = { up = "", labels = labels, heads = heads, names = {}, chunks = {}, idents = {}, entries = entries, eqs = {}, online = online, volumes = {}, volume_of = volume_of }
for i, v in ipairs(volumes) do db.volumes[i] = v end

------------------------------------------------------------------------------------------------- chunks: numbers, ids
local function slug(s)
  s = Code.plain(s):lower():gsub("[^%w]+", "-"):gsub("^%-+", ""):gsub("%-+$", "")
  return s == "" and "chunk" or s
end
do
  local taken, count = {}, {}
  for _, c in ipairs(book.chunks) do
    local chapter = book.chapters[c.chapter]
    count[c.chapter] = (count[c.chapter] or 0) + 1
    c.k = count[c.chapter]
    c.num = chapter.num .. "." .. c.k
    c.page = chapter.entry.page
    c.name = c.name or "?"
    local n = book.names[c.name]
    if not n.slug then
      local s = "c-" .. slug(c.name)
      while taken[s] do s = s .. "-x" end
      taken[s] = true
      n.slug = s
    end
    c.id = n.slug .. (c.part > 1 and "-" .. c.part or "")
    if c.gone then c.id = n.slug .. "-gone" else db.chunks[c.id] = { num = c.num, page = c.page, name = c.name, part = c.part, online = chapter.online } end
  end
  for name, n in pairs(book.names) do
    local first = n.parts[1] and book.chunks[n.parts[1]]
    if first then db.names[name] = { id = first.id, num = first.num, page = first.page, online = book.chapters[first.chapter].online } end
  end
end

------------------------------------------------------------------------------------- documentation: text, labels, checks
local bib_keys = {}
for key in (Code.read(root .. "book/refs.bib") or ""):gmatch("@%a+%s*{%s*([^,%s]+)%s*,") do bib_keys[key] = true end
local refs_seen = {}                         -- { file, line, id } of every cross reference
local images = {}                            -- { file, line, path }
local search = {}                            -- { kind, title, page, id, text }
local cited, cited_in = {}, {}               -- sources; in each volume

local function add_label(chapter, line, id, kind, num, title)
  if labels[id] then
    book:complain(chapter.file, line, "label " .. id .. " is defined twice, first at " .. where[id], "give one of the two another id")
    return
  end
  where[id] = chapter.file .. ":" .. line
  labels[id] = { kind = kind, num = num, page = chapter.entry.page, title = title, online = chapter.online or chapter.web or nil, gone = how and chapter.dropped or nil }
  return labels[id]
end

local function count_label(chapter, line, id)
  local kind = id:match("^(%a+):")
  chapter.count[kind] = (chapter.count[kind] or 0) + 1
  local l = add_label(chapter, line, id, kind, chapter.num .. "." .. chapter.count[kind])
  return l
end

-- The subject index. A term is marked once, where it is explained: [term]{.def} in the text, where it stands in italics then, or index="term; term"
-- at a heading; [text]{.def index="term"} if the index has it otherwise ("joint, rope"). The index finds the other places itself.
local terms = {}                             -- in the book's order; terms[term]
local function add_term(chapter, line, list, id, anchor)
  if how and chapter.dropped then return end
  for t in list:gmatch "%s*([^;]*[^;%s])" do
    if terms[t] then
      book:complain(chapter.file, line, "the term '" .. t .. "' is marked twice, first at " .. terms[t].where, "leave one mark: where the term is explained")
    else
      terms[t] = { term = t, id = id, anchor = anchor or id, page = chapter.entry.page, where = chapter.file .. ":" .. line, online = chapter.online or chapter.web }
      terms[#terms + 1] = terms[t]
    end
  end
end
local function mark_terms(chapter, line, l)
  for text, rest in l:gmatch("%[([^%[%]]+)%]{%.def([^}]*)}") do
    text = Code.plain(text)
    add_term(chapter, line, rest:match('index="([^"]*)"') or text, chapter.here, Code.term_id(text))
  end
end

-- The first volume prints the engine that it describes, "core" (parts.lua); code and sections of other parts stand on the pages.
local core = not how and book.parts.core and Parts.closure(book, { core = true })
local in_core = core and Parts.reached(book, core)
local function beyond_core(chapter, part)
  if not core or not part or chapter.online or chapter.entry.volume ~= volumes[1].name then return false end
  for w in part:gmatch("[%w_%-]+") do if not core[w] then return true end end
  return false
end
local function heading(chapter, line, level, text)
  local id = text:match("{#([^%s}]+)")
  local title = text:gsub("%s*{[^}]*}%s*$", "")
  local num
  if level == 1 then
    if chapter.title then
      book:complain(chapter.file, line, "a second heading of level 1", "a chapter has one title; write ## for a section")
      return
    end
    chapter.title = title
    num = chapter.num
  elseif level <= 3 then
    chapter.sec = chapter.sec or { 0, 0 }
    chapter.sec[level - 1] = chapter.sec[level - 1] + 1
    if level == 2 then chapter.sec[2] = 0 end
    num = chapter.num .. "." .. chapter.sec[1] .. (level == 3 and "." .. chapter.sec[2] or "")
  else return text end
  if not id then
    id = "s-" .. slug(chapter.name) .. "-" .. slug(title)
    while labels[id] do id = id .. "-x" end
    text = title .. " {#" .. id .. "}"
  end
  if chapter.web_level and level <= chapter.web_level then chapter.web_level = nil; chapter.web = chapter.web_boxes > 0 or nil end
  local l = add_label(chapter, line, id, "sec", num, Code.plain(title))
  if not l then return text end
  local print = text:match('print="?([%w_%-]*)')
  if not print and level > 1 and beyond_core(chapter, text:match('part="([^"]*)"')) then
    print = "web"
    text = text:gsub("}%s*$", ' print="web"}')
  end
  if chapter.code_level and level <= chapter.code_level then chapter.code_level = nil end
  if print == "web" then chapter.web_level = chapter.web_level or level; chapter.web = true      -- print has its title alone
  elseif print == "code" then chapter.code_level = level      -- print has its code, too, whatever program it is of
  elseif print then book:complain(chapter.file, line, 'print="' .. print .. '" says nothing', 'write print="web" at a section that only the pages have') end
  chapter.here = id
  local h = { level = level, num = num, id = id, title = title, page = chapter.entry.page, web = chapter.web }
  if level == 1 then
    chapter.entry.id = id
    chapter.entry.title = title
  end
  if how and chapter.dropped then return text end
  heads[#heads + 1] = h
  add_term(chapter, line, text:match('index="([^"]*)"') or "", id)
  search[#search + 1] = { kind = "sec", title = num .. " " .. Code.plain(title), page = h.page, id = id }
  return text
end

-- Without code, math and attributes: what is left is prose, in which references, citations and stray HTML are looked for.
local function bare(l)
  return (l:gsub("``.-``", " "):gsub("`[^`]*`", " "):gsub("%$%$.-%$%$", " "):gsub("%$[^%$]*%$", " "):gsub("\\.", " "))
end

local function check_prose(chapter, line, l)
  local text = bare(l)
  for before, key in (" " .. text):gmatch("([^%w@])@([%a][%w_:%-%./]*)") do
    key = key:gsub("[%.:%-/]+$", "")
    local kind, id = key:match("^(%a+):(.+)$")
    if kind and Code.kind_name[kind:lower()] then
      refs_seen[#refs_seen + 1] = { chapter.file, line, kind:lower() .. ":" .. id }
    elseif before:match("[%s%[%(;%-]") then
      cited[key] = true
      local volume = volume_of[chapter.entry.page]
      if not chapter.online then cited_in[volume] = cited_in[volume] or {}; cited_in[volume][key] = true end
      if not bib_keys[key] then
        book:complain(chapter.file, line, "no source @" .. key .. " in book/refs.bib",
          "add the source to book/refs.bib, mend the key, or put an @ that is no citation in backticks")
      end
    end
  end
  for id in text:gmatch("%]%(#([^%)]+)%)") do refs_seen[#refs_seen + 1] = { chapter.file, line, id } end
  for tag in text:gmatch("<(/?%a[^>]*)>") do
    if not tag:match("^https?:") and not tag:match("^mailto:") then
      book:complain(chapter.file, line, "<" .. tag .. "> in prose reads as HTML and would vanish from the page", "put it in backticks")
    end
  end
  for path in text:gmatch("%]%(([^%)%s]+%.%a+)%)%s*{") do
    chapter.assets = chapter.assets or {}
    chapter.assets[#chapter.assets + 1] = path
    images[#images + 1] = { chapter.file, line, path }
  end
end

local boxes = {}
for b in ("goals note warning history physics aside test exercise solution data files extensions columns only listing web"):gmatch("%a+") do boxes[b] = true end

local function check_data(chapter, line, l)
  local file = l:match('file="([^"]*)"')
  if not file then
    book:complain(chapter.file, line, "a .data block without a file", 'write {.data file="book/data/NAME.csv"}')
    return
  end
  chapter.assets = chapter.assets or {}
  chapter.assets[#chapter.assets + 1] = file
  if not Code.read(root .. file) then
    book:complain(chapter.file, line, "data file " .. file .. " is not there", "measure it: build/bin/weft-lab run " ..
      (file:match("([^/]+)%.csv$") or "NAME") .. " > " .. file)
  end
end

-- One line of documentation. Keeps the state of the chapter: fences, paragraphs, counters. Returns the line to emit.
local function doc_line(chapter, line, l)
  local fence = l:match("^%s*(```+)") or l:match("^%s*(~~~+)")
  if chapter.fence then
    if fence and #fence >= #chapter.fence and l:match("^%s*[`~]+%s*$") then chapter.fence = nil end
    return l
  end
  if fence then
    chapter.fence, chapter.fence_line = fence, line
    for id in l:gmatch("#(tbl:[%w_%-]+)") do count_label(chapter, line, id) end
    if l:match("{[^}]*%.data") then check_data(chapter, line, l) end
    return l
  end
  -- a block of code that is only indented: after an empty line, outside a list
  local blank = not l:match("%S")
  if l:match("^    ") and (chapter.indented or chapter.blank and not chapter.in_list) and not chapter.display then
    chapter.indented = true
    return l
  end
  if not blank then
    chapter.indented = false
    if l:match("^%s*[%-%*%+]%s") or l:match("^%s*%d+[%.%)]%s") then chapter.in_list = true
    elseif l:match("^%S") and chapter.blank then chapter.in_list = false end
  end
  chapter.blank = blank
  local display = chapter.display
  local _, dollars = l:gsub("`[^`]*`", ""):gsub("%$%$", "")
  if dollars % 2 == 1 then chapter.display = not display and line or nil end
  local marks, title = l:match("^(#+)%s+(.*)$")
  if marks and not display then l = marks .. " " .. (heading(chapter, line, #marks, title) or title) end
  for id, rest in l:gmatch("{#(eq:[%w_%-]+)([^}]*)}") do
    local e = count_label(chapter, line, id)
    if e then
      e.theory = rest:match("%.theory") and true or nil
      db.eqs[id] = { page = chapter.entry.page, num = e.num, name = rest:match('name="([^"]*)"') }
      chapter.eq_lines = chapter.eq_lines or {}
      search[#search + 1] = { kind = "eq", title = "Eq. (" .. e.num .. ")", page = chapter.entry.page, id = id, text = id:sub(4):gsub("%-", " ") .. " " .. (chapter.title and Code.plain(chapter.title) or "") }
    end
    if not l:match("%$%$%s*{#eq:") then
      book:complain(chapter.file, line, "label " .. id .. " does not follow a closing $$", "write the label on the line that ends the equation: $$ ... $$ {#" .. id .. "}")
    end
  end
  l = l:gsub("(%$%$)%s*{#(eq:[%w_%-]+)[^}]*}", "%1 {#%2}")
  for id in l:gmatch("{[^}]*#(fig:[%w_%-]+)") do
    count_label(chapter, line, id)
    local cap = ((chapter.para and chapter.para .. " " or "") .. l):match(".*!%[(.-)%]%(")
    if labels[id] then search[#search + 1] = { kind = "fig", title = "Figure " .. labels[id].num, page = chapter.entry.page, id = id, text = Code.plain(cap or "") } end
  end
  for id in l:gmatch("{[^}]*#(tbl:[%w_%-]+)") do count_label(chapter, line, id) end
  if l:match("^:::") then
    chapter.divs = chapter.divs or {}
    if l:match("^:::+%s*$") then
      if #chapter.divs == 0 then book:complain(chapter.file, line, "this ::: closes nothing", "delete it, or open a box with ::: {.note}")
      else
        table.remove(chapter.divs)
        if chapter.web_divs[#chapter.divs + 1] then chapter.web_divs[#chapter.divs + 1] = nil; chapter.web_boxes = chapter.web_boxes - 1 end
      end
    else
      chapter.divs[#chapter.divs + 1] = line
      if l:match("^:::+%s*{[^}]*%.web%f[^%w_%-]") then chapter.web_divs[#chapter.divs] = true; chapter.web_boxes = chapter.web_boxes + 1 end
    end
    chapter.web = (chapter.web_level or chapter.web_boxes > 0) and true or nil
    if l:match("^:::+%s*{[^}]*%.data") then check_data(chapter, line, l) end
    local class = l:match("^:::+%s*{%s*%.([%w_%-]+)")
    if class and not boxes[class] then
      book:complain(chapter.file, line, "no box is called ." .. class, "use one of .goals .note .warning .history .physics .aside .test .exercise .solution .data .files .extensions .only .web")
    end
    local solved = l:match("%.solution.-for=[\"']?([%w:_%-]+)")
    if solved then refs_seen[#refs_seen + 1] = { chapter.file, line, solved } end
    for id in l:gmatch("#(ex:[%w_%-]+)") do
      local label = count_label(chapter, line, id)
      if label then label.exercise = l:match("kind=(%a+)") end
      if labels[id] then search[#search + 1] = { kind = "ex", title = "Exercise " .. labels[id].num, page = chapter.entry.page, id = id } end
    end
  end
  if not display then mark_terms(chapter, line, l) end
  if not display and dollars == 0 then check_prose(chapter, line, l) end
  -- the search index: paragraphs, each under the heading that it stands below
  if l:match("%S") and not display and not marks and not l:match("^:::") and not l:match("^%$%$") then
    if l:match("^[%s|:%-]+$") then return l end       -- a table's rule
    chapter.para = (chapter.para and chapter.para .. " " or "") .. l
  elseif chapter.para then
    search[#search + 1] = { kind = "text", title = "", page = chapter.entry.page, id = chapter.here, text = Code.plain(chapter.para):gsub("%s+", " ") }
    chapter.para = nil
  end
  return l
end

-- A chunk that print leaves out: of a box .web, of a section print="web". Links to it have nowhere to lead in print.
local chunk_at = {}
for _, c in ipairs(book.chunks) do chunk_at[c.chapter .. "." .. c.k] = c end
local function web_chunk(ci, k)
  local c = chunk_at[ci .. "." .. k]
  if c.gone then return end
  c.web = true
  online[c.id] = true
  db.chunks[c.id].online = true
  if c.part == 1 then db.names[c.name].online = true end
end
do
  local chapter, kind, line, k
  local text, quote = "", nil
  local ci = 0
  local marks                                  -- which part the prose belongs to: only in the book of a smaller engine
  local function c_gone(c) return how and c.gone or nil end
  local function emit(c, i, at, t)
    if not how then c.md[#c.md + 1] = doc_line(c, at, t) .. "\n" return end
    local before = Parts.within(marks.here(), chosen)
    marks.line(at, t)
    local here = Parts.within(marks.here(), chosen)
    local level = #(t:match("^(#+)%s") or "")
    local section = gone_at[i .. ":" .. at]
    if c.fence or c.display then level, section = 0, nil end
    if level > 0 and c.drop_level and level <= c.drop_level then c.drop_level = nil end
    if section and section.all > 0 and section.kept == 0 then c.drop_level = c.drop_level or level end
    if t:match("^:::+%s*$") then here = before end
    c.dropped = c.gone or c.drop_level or not here or nil
    local found = #search
    local l = doc_line(c, at, t)
    if not c.dropped then c.md[#c.md + 1] = l .. "\n" return end
    c.para = nil
    for j = #search, found + 1, -1 do search[j] = nil end
  end
  for l in stream:gmatch("([^\n]*)\n") do
    local key, rest = l:match("^@(%S+) ?(.*)$")
    if key == "file" then
      if chapter and chapter.para then doc_line(chapter, line, "") end
      ci = ci + 1
      chapter = book.chapters[ci]
      chapter.count, chapter.md, line, k = {}, {}, 1, 0
      chapter.web_boxes, chapter.web_divs = 0, {}
      chapter.dropped = c_gone(chapter)
      marks = how and Parts.reader({ parts = {}, part_uses = {}, complain = function() end }, { file = chapter.file })
    elseif key == "begin" then
      kind = rest:match("^%a+")
      text, quote = "", nil
      if kind == "code" then
        k = k + 1
        if chapter.web then web_chunk(ci, k) elseif chapter.code_level then chunk_at[ci .. "." .. k].kept = true end
        if chapter.fence then
          book:complain(chapter.file, chapter.fence_line, "this fence is still open where a chunk begins", "close it with " .. chapter.fence)
          chapter.fence = nil
        end
        if chapter.display then
          book:complain(chapter.file, chapter.display, "this display equation is still open where a chunk begins", "close it with $$")
          chapter.display = nil
        end
      end
    elseif kind ~= "code" and key == "text" then
      if quote then quote = quote .. rest else text = text .. rest end
    elseif kind ~= "code" and key == "use" then quote = (quote or "") .. "<<" .. rest .. ">>"
    elseif key == "quote" then quote = ""
    elseif key == "endquote" then
      local _, ticks = text:gsub("`", "")
      if chapter.fence or ticks % 2 == 1 then text = text .. "[[" .. quote .. "]]"
      else text = text .. "`" .. quote .. "`{.c}" end
      quote = nil
    elseif key == "nl" then
      if kind ~= "code" and kind then
        if quote then quote = quote .. " "
        else
          emit(chapter, ci, line, text)
          text = ""
        end
      end
      line = line + 1
    elseif key == "index" and rest:match("^nl") then line = line + 1
    elseif key == "end" then
      if kind == "code" then
        if chapter.para then doc_line(chapter, line, "") end
        if not chunk_at[ci .. "." .. k].gone then chapter.md[#chapter.md + 1] = "\n```{=weftchunk}\n" .. k .. "\n```\n\n" end
      elseif text ~= "" then
        emit(chapter, ci, line, text)
        text = ""
      end
      kind = nil
    end
  end
  if chapter and chapter.para then doc_line(chapter, line, "") end
end
for _, c in ipairs(book.chapters) do
  if not c.title and c.of then                                      -- it needs no title of its own
    local id = "sec:" .. c.name:gsub("%.", "-") .. "-code"
    c.title = c.entry.title
    add_label(c, 1, id, "sec", c.num, c.title)
    c.entry.id = id
    table.insert(c.md, 1, "# " .. c.title .. " {#" .. id .. "}\n\n")
  elseif not c.title then
    book:complain(c.file, 1, "the chapter has no title", "begin it with  # Title {#sec:name}")
    c.entry.title, c.entry.id = c.name, "top"
  end
  for _, at in ipairs(c.divs or {}) do book:complain(c.file, at, "this box is never closed", "close it with ::: on a line of its own") end
  if c.display then book:complain(c.file, c.display, "this display equation is never closed", "close it with $$") end
  if c.fence then book:complain(c.file, c.fence_line, "this fence is never closed", "close it with " .. c.fence) end
end
for _, r in ipairs(refs_seen) do
  if not labels[r[3]] then
    local best, score = nil, 0.5                                 -- a hint: the label of its kind that shares most pairs of letters
    local kind, stem = r[3]:match("^(%a+):(.*)")
    for id in pairs(labels) do
      if kind and kind == id:match("^(%a+):") then
        local s, pairs_of, hit = id:match(":(.*)"), {}, 0
        for i = 1, #s - 1 do pairs_of[s:sub(i, i + 1)] = true end
        for i = 1, #stem - 1 do if pairs_of[stem:sub(i, i + 1)] then hit = hit + 1 end end
        local near = 2 * hit / (#s + #stem - 2)
        if near > score or (near == score and best and id < best) then best, score = id, near end
      end
    end
    book:complain(r[1], r[2], "nothing is labelled " .. r[3], "label it {#" .. r[3] .. "} or mend the reference" ..
      (best and " (did you mean @" .. best .. "?)" or ""))
  end
end

---------------------------------------------------------------------------------------- images: who makes them?
local scenes = {}                                      -- scene -> the function that builds it
do
  local drawn = {}
  for _, c in ipairs(book.chunks) do
    if c.name:match("^rows of ") then
      local rows = {}
      for _, it in ipairs(c.items) do if it.kind == "text" then rows[#rows + 1] = it.text end end
      for row in table.concat(rows, "\n"):gmatch("%b{}") do
        local name = row:match('%.name%s*=%s*"([^"]+)"')
        if name and row:find(".category", 1, true) then scenes[name:lower()] = row:match("%.build%s*=%s*([%w_]+)") or "" end
      end
    end
    if c.name:match("^figures/[%w_]+%.c$") then
      local rows
      for _, it in ipairs(c.items) do
        if it.kind == "text" then rows = (rows or it.text:match("wfFigureRow rows")) and it.text ~= "};" end
        if rows and it.kind == "text" then for name in it.text:gmatch('{%s*"([%w_%-]+)"') do drawn[name] = true end end
      end
    end
  end
  for _, im in ipairs(images) do
    local file, line, path = im[1], im[2], im[3]
    local name = path:match("^figures/([%w_%-]+)%.svg$")
    local plot = path:match("^plots/([%w_%-]+)%.svg$")
    local scene = path:match("^scenes/([%w_%-]+)%-%d+%.svg$")
    if scene then
      if not scenes[scene:gsub("%-", " "):lower()] then
        book:complain(file, line, "no scene is called " .. scene, "a frozen scene is scenes/NAME-STEPS.svg, with - for blanks; build/bin/weft-headless --list names them")
      end
    elseif name then
      if not drawn[name] then
        book:complain(file, line, "no function draws " .. path, 'add a row { "' .. name .. '", ... } to the rows of figures/CHAPTER.c or mend the name')
      end
    elseif plot then
      if not Code.read(root .. "book/plots/" .. plot .. ".gp") and not book.names["plots/" .. plot .. ".gp"] then
        book:complain(file, line, "no script plots " .. path, "write book/plots/" .. plot .. ".gp or mend the name")
      end
    elseif not path:match("^https?:") and not Code.read(root .. path) and not Code.read(root .. "book/" .. path) then
      book:complain(file, line, "no file " .. path, "draw it as figures/NAME.svg, plot it as plots/NAME.svg, or put the file there")
    end
  end
end

------------------------------------------------------------------------- the assembled files, and where each line came from
local function lines_of(c)                    -- a chunk's lines: { line = n, text = ..., use = name }
  if c.lines then return c.lines end
  local lines, cur = {}, nil
  for _, it in ipairs(c.items) do
    if it.kind == "nl" then
      if cur then lines[#lines + 1] = cur end
      cur = { line = it.line + 1, text = "" }
    elseif cur then
      if it.kind == "use" then cur.use, cur.indent = it.text, cur.text else cur.text = cur.text .. it.text end
    end
  end
  if cur and (cur.text ~= "" or cur.use) then lines[#lines + 1] = cur end
  c.lines = lines
  return lines
end

local roots, root_names = {}, {}
for name, n in pairs(book.names) do
  if #n.parts > 0 and Book.is_root(name) then root_names[#root_names + 1] = name end
end
table.sort(root_names)
local function expand(name)
  local result, depth = {}, 0
  local function walk(chunk_name, indent)
    depth = depth + 1
    local n = book.names[chunk_name]
    if depth < 60 and n then
      for _, p in ipairs(n.parts) do
        local c = book.chunks[p]
        for _, l in ipairs(lines_of(c)) do
          if l.use then walk(l.use, indent .. l.indent:gsub("%S", " "))
          else result[#result + 1] = { text = (l.text ~= "" and indent or "") .. l.text, chunk = p, line = l.line } end
        end
      end
    end
    depth = depth - 1
  end
  walk(name, "")
  return result
end

local src = out .. "/src"
local function make_directories()
  local seen, list = {}, { "mkdir -p", sh(src) }
  for _, name in ipairs(root_names) do
    local d = src .. "/" .. name:match("^(.*)/")
    if not seen[d] then seen[d] = true; list[#list + 1] = sh(d) end
  end
  os.execute(table.concat(list, " "))
end
local function tangled()                       -- the same files as src-generated/, comments and all, from the same stream
  local lua, lib = os.getenv("WEFT_LUA"), os.getenv("NOWEB_LIB")
  if not (lua and lib and Code.read(out .. "/stream") == stream) then return false end
  make_directories()
  return os.execute(lua .. " " .. sh(here .. "tangle.lua") .. " plain " .. sh(out .. "/roots") .. (how and " " .. sh(out .. "/parts") .. (how.only and " only " .. sh(how.only) or "") .. (how.without and " without " .. sh(how.without) or "") or "") .. " < " .. sh(out .. "/stream") .. " > " .. sh(out .. "/annotated") ..
    " && cd " .. sh(src) .. " && " .. sh(lib .. "/mnt") .. " -all < ../annotated 2> ../tangle.log && find . -type f | sed 's|^./||' | sort > ../there && sort -u ../roots > ../roots.sorted" ..
    " && comm -23 ../there ../roots.sorted | xargs -r rm -f")
end
local use_tangled = chunks_good and tangled()
if not use_tangled then
  os.execute("rm -rf " .. sh(src))
  make_directories()
end
for _, name in ipairs(root_names) do
  local expected = expand(name)
  local r = { name = name, lines = {} }
  if use_tangled then
    local i = 1
    for text in (Code.read(src .. "/" .. name) or ""):gmatch("([^\n]*)\n?") do
      local e = expected[i]
      if e and (e.text == text or e.text:gsub("%s+$", "") == text:gsub("%s+$", "")) then
        r.lines[#r.lines + 1] = { text = text, chunk = e.chunk, line = e.line }
        i = i + 1
      else
        r.lines[#r.lines + 1] = { text = text, chunk = e and e.chunk, comment = true }
      end
    end
    while #r.lines > 0 and r.lines[#r.lines].text == "" and r.lines[#r.lines].comment do r.lines[#r.lines] = nil end
    if i <= #expected then
      io.stderr:write(string.format("weave: %s: line %d of the assembled source is not where it should be (%s)\n", name, i, expected[i].text))
      os.exit(1)
    end
  else
    local t = {}
    for i, e in ipairs(expected) do r.lines[i] = e; t[i] = e.text end
    local f = assert(io.open(src .. "/" .. name, "w"))
    f:write(table.concat(t, "\n"), "\n")
    f:close()
  end
  roots[#roots + 1] = r
  roots[name] = r
  r.id = "f-" .. name:gsub("[^%w]+", "-")
  r.page = "source-" .. name:gsub("[^%w]+", "-") .. ".html"
  for i, l in ipairs(r.lines) do                -- each chunk line: where it ends up
    if l.chunk and not l.comment then
      local c = book.chunks[l.chunk]
      c.at = c.at or {}
      c.at[l.line] = c.at[l.line] or { r, i }
      c.roots = c.roots or {}
      c.roots[name] = true
    end
  end
end

---------------------------------------------------------------------------------------------- what print leaves out by itself
-- Of chunks the declarations of functions, beyond the first piece of a volume (the reference has them all), the code of programs that
-- belong to another volume, in the first volume what is not in core, and rows of a table beyond the first five. Print has one line in their
-- place; the pages have everything.
local FEW_ROWS = 5
local function only_declares(c)
  local any = false
  local text, depth = {}, 0
  for _, l in ipairs(lines_of(c)) do
    if l.use then return false end
    text[#text + 1] = l.text
  end
  local code = table.concat(text, "\n"):gsub("/%*.-%*/", ""):gsub("\n#[^\n]*", "")
  for statement in (code:gsub("^#[^\n]*", "")):gmatch("[^;]+") do
    if statement:match("%S") then
      if statement:match("[{}=]") or statement:match("typedef") or statement:match("^%s*WF_[%u_]+%(") or not statement:match("%)%s*[%u_]*$") then return false end
      any = true
    end
  end
  return any
end
do
  local shown = {}
  for index, c in ipairs(book.chunks) do
    local chapter = book.chapters[c.chapter]
    local volume = volume_of[chapter.entry.page]
    if not c.web and not c.kept and not chapter.online and chapter.entry.volume and next(c.roots or {}) then
      local headers, foreign, small = true, true, false
      for root in pairs(c.roots) do
        headers = headers and root:match("%.h$") ~= nil
        local program = root:match("^(%a+)/")
        small = small or program == "small"
        foreign = foreign and (program == "figures" or (program == "lab" or program == "testbed") and volume ~= program)
      end
      if foreign or in_core and not in_core[index] and not small and volume == volumes[1].name then web_chunk(c.chapter, c.k)
      elseif headers and only_declares(c) then
        if shown[volume] then web_chunk(c.chapter, c.k) end
        shown[volume] = true
      elseif c.name:match("^rows of ") then
        local lines, rows, first = lines_of(c), 0, nil
        for i, l in ipairs(lines) do
          local indent = #(l.use and l.indent or l.text):match("^ *")
          first = first or indent
          if indent <= first and (l.text ~= "" or l.use) then
            rows = rows + 1
            if rows == FEW_ROWS + 1 and #lines - i > 1 then c.printed = i - 1 end
          end
        end
      end
    end
  end
  -- how many lines of the described engine's C the first volume prints: {core-lines} and {core-printed} in a chapter's text
  local all, printed = 0, 0
  for index, c in ipairs(book.chunks) do
    if not c.gone and c.roots and (not in_core or in_core[index]) then
      for i, l in ipairs(lines_of(c)) do
        if not l.use and l.text:match("%S") then
          all = all + 1
          if not c.web and i <= (c.printed or i) and volume_of[book.chapters[c.chapter].entry.page] == volumes[1].name then printed = printed + 1 end
        end
      end
    end
  end
  local count = { ["{core-lines}"] = all, ["{core-printed}"] = printed }
  local function fill(text) return (text:gsub("{core%-%a+}", function(k) return count[k] and (tostring(count[k]):gsub("^(%d+)(%d%d%d)$", "%1,%2")) end)) end
  for _, c in ipairs(book.chapters) do for i, l in ipairs(c.md) do c.md[i] = fill(l) end end
  for _, e in ipairs(search) do if e.text then e.text = fill(e.text) end end
end

------------------------------------------------------------------------------------ identifiers, found by universal-ctags
local tags, locals = {}, {}                    -- tags[name] = { definitions }; locals[file][line] = set of names
local inside_of = {}                           -- inside_of[file][line] = the function that the line is in
local priority = { f = 1, d = 2, s = 3, u = 3, g = 3, t = 4, e = 5, v = 6, p = 8, x = 9 }
local kind_text = { f = "function", d = "macro", s = "struct", u = "union", g = "enum", t = "type", e = "constant", v = "variable", p = "prototype", x = "declaration" }
do
  local p = assert(io.popen("cd " .. sh(src) .. " && ctags --options=NONE --languages=C --langmap=C:.c.h --kinds-C=defgpstuvxlz --fields=+nKe-k " ..
    "--fields=+k-K --excmd=number --sort=no -f - -R . 2>" .. "/dev/null"))
  local functions = {}
  local pending = {}
  for l in p:lines() do
    local name, file, line, kind, rest = l:match("^([^\t]+)\t([^\t]+)\t(%d+);\"\t(%a)(.*)$")
    if name and not name:match("^__anon") then
      file = file:gsub("^%./", "")
      line = tonumber(line)
      if kind == "l" or kind == "z" then
        pending[#pending + 1] = { file, line, name, rest:match("function:([%w_]+)") }
      elseif priority[kind] then
        local r = roots[file]
        local src_line = r and r.lines[line]
        if kind == "f" then
          local last = tonumber(rest:match("end:(%d+)")) or line
          functions[file .. ":" .. name] = { line, last }
          inside_of[file] = inside_of[file] or {}
          for i = line, last do inside_of[file][i] = name end
        end
        local guard = kind == "d" and name:match("_H$") and file:match("%.h$")
        if src_line and src_line.chunk and not src_line.comment and not guard then
          tags[name] = tags[name] or {}
          local same                            -- a chunk that stands in two files defines its names once
          for _, t in ipairs(tags[name]) do
            if t.chunk == src_line.chunk and t.line == src_line.line and t.kind == kind then same = t end
          end
          if same then same.files[file] = true
          else table.insert(tags[name], { files = { [file] = true }, name = name, kind = kind, file = file, chunk = src_line.chunk, line = src_line.line, static =
            (rest:match("\tfile:") and not file:match("%.h$")) and true or nil, within = src_line.text:match("^static") and (file:match("^(testbed/).*%.h$") or file:match("^(lab/).*%.h$")) or nil,
            order = #tags[name] }) end
        end
      end
    end
  end
  p:close()
  for _, x in ipairs(pending) do                -- a local name hides the global one within its function
    local f = x[4] and functions[x[1] .. ":" .. x[4]]
    if f then
      locals[x[1]] = locals[x[1]] or {}
      for i = f[1], f[2] do
        locals[x[1]][i] = locals[x[1]][i] or {}
        locals[x[1]][i][x[3]] = true
      end
    end
  end
  for name, list in pairs(tags) do
    table.sort(list, function(a, b)
      if priority[a.kind] ~= priority[b.kind] then return priority[a.kind] < priority[b.kind] end
      return a.order < b.order
    end)
  end
end
local function is_definition(t) return priority[t.kind] < 8 end
-- an anchor for every definition; names that several files define for themselves get the file's name added
for name, list in pairs(tags) do
  local n, first = 0, {}
  for _, t in ipairs(list) do
    if is_definition(t) and not first[t.file] then
      n = n + 1
      t.anchor = n == 1 and "d-" .. name or "d-" .. name .. "-" .. n
      first[t.file] = t
      t.main = true
    end
  end
  for _, t in ipairs(list) do
    if not is_definition(t) then list.header = list.header or (t.file:match("%.h$") and t.file) end
  end
end
-- the definition that a name means in a file, and the earliest chapter from which it may be used
-- (a static function in a header of the testbed or of the lab is known only there)
local function seen_in(t, file) return t.files[file] or not t.static and (not t.within or (file or ""):find(t.within, 1, true) == 1) end
local function resolve(name, file)
  local list = tags[name]
  if not list then return nil end
  local own, global, earliest
  for _, t in ipairs(list) do
    if seen_in(t, file) then
      local c = book.chunks[t.chunk].chapter
      earliest = math.min(earliest or c, c)
      if t.main then
        if t.files[file] then own = own or t elseif not t.static then global = global or t end
      end
    end
  end
  return own or global, earliest, list
end

-- The parts without which a name has no definition where it is used in chunk c: nil if it has one (parts.lua).
local function lacks(name, file, c, list)
  local made, best = false, nil
  for _, t in ipairs(list or {}) do made = made or (t.main and t.kind == "f" and seen_in(t, file)) end
  for _, t in ipairs(list or {}) do
    if seen_in(t, file) and (not made or t.main) then
      local with, missing = book.chunks[t.chunk].with, {}
      if Parts.within(with, c.with) then return nil end
      for w in pairs(with) do if not c.with[w] then missing[w] = true end end
      best = best or missing
    end
  end
  return best
end

----------------------------------------------------------------------------------- chunks: lexed, resolved, cross referenced
local uses_of = {}                             -- uses_of[definition] = list of chunk indices
local eq_users = {}                            -- eq_users[label] = list of chunk indices
local eq_names = {}                            -- eq_names[label] = what computes it: functions, macros
local function add_once(list, x) if list[#list] ~= x then list[#list + 1] = x end end
local told = {}
local defined_at = {}                          -- what a chunk's line defines
for name, list in pairs(tags) do
  for _, t in ipairs(list) do
    local k = t.chunk .. ":" .. t.line
    if t.main and (not defined_at[k] or name < defined_at[k]) then defined_at[k] = name end
  end
end
local pointers = {}                            -- tokens and the definitions that they point at
for index, c in ipairs(book.chunks) do
  c.tokens, c.defs, c.eqs = {}, {}, {}
  local root_name = c.roots and next(c.roots)
  -- What computes it: the function in which the line stands, or what is defined there or on the `far` lines below it.
  local function user(id, line, far)
    local names = eq_names[id] or {}
    local place, found = c.at and c.at[line], nil
    if place then
      local in_file = inside_of[place[1].name] or {}
      found = in_file[place[2]]
      for i = place[2], place[2] + far do found = found or (place[1].lines[i] and place[1].lines[i].chunk == index and (in_file[i] or defined_at[index .. ":" .. place[1].lines[i].line])) or nil end
    end
    if found and not names[found] then names[found] = true; names[#names + 1] = found end
    eq_names[id] = names
  end
  local function eq_use(id, line, far)
    if labels[id] and not labels[id].gone then user(id, line, far) end
    if labels[id] and not labels[id].gone and not c.eqs[id] then
      c.eqs[id] = true
      c.eqs[#c.eqs + 1] = id
      eq_users[id] = eq_users[id] or {}
      add_once(eq_users[id], index)
    end
  end
  local function ref_in_code(id, line, at, far)
    id = id:sub(1, 1):lower() .. id:sub(2):gsub("[%-_]+$", "")
    if not labels[id] then
      local key = c.file .. line .. id
      if not told[key] then
        told[key] = true
        book:complain(c.file, line, "nothing is labelled " .. id, "label it {#" .. id .. "} or mend the reference in the code")
      end
      return
    end
    if id:match("^eq:") then eq_use(id, at or line, far or 3) end
  end
  for id in c.name:gmatch("@(%a+:[%w_%-]+)") do
    if Code.kind_name[id:match("^%a+"):lower()] then ref_in_code(id, c.line, lines_of(c)[1] and lines_of(c)[1].line, 60) end
  end
  local inside = false
  for _, l in ipairs(c.gone and {} or lines_of(c)) do
    if how and l.use and book:is_empty(l.use) then goto next_line end       -- not tangled, so not woven
    local row = {}
    local code = l.use and l.indent or l.text
    local columns = utf8.len(l.text) or #l.text
    if not l.use and columns > 92 then
      book:complain(c.file, l.line, "this line of code has " .. columns .. " columns; the book's page holds 92", "break it")
    end
    local toks
    toks, inside = Code.lex(code, inside)
    local place = c.at and c.at[l.line]
    local hidden = place and locals[place[1].name] and locals[place[1].name][place[2]]
    local previous
    for _, t in ipairs(toks) do
      local class, text = t[1], t[2]
      if class == "id" then
        if Code.keywords[text] then row[#row + 1] = { "kw", text }
        elseif previous == "." or previous == "->" or (hidden and hidden[text]) then row[#row + 1] = { "", text }
        else
          local target, earliest, list = resolve(text, place and place[1].name)
          local mine
          for _, d in ipairs(list or {}) do
            if d.main and d.chunk == index and d.line == l.line then mine = d end
          end
          if mine and not mine.placed then
            mine.placed = true
            if c.web then online[mine.anchor] = true end
            row[#row + 1] = { "def", text, mine.anchor }
            c.defs[#c.defs + 1] = mine
          elseif target then
            local tc = book.chunks[target.chunk]
            if mine or (target.chunk == index and target.line == l.line) then row[#row + 1] = { "", text }
            else
              local header = list.header
              row[#row + 1] = { "ref", text, tc.page .. "#" .. target.anchor,
                kind_text[target.kind] .. " " .. text .. ", chunk " .. tc.num .. (header and header ~= target.file and ", declared in " .. header:gsub("^include/", "") or "") }
              pointers[#pointers + 1] = { row[#row], target, tc }
              uses_of[target] = uses_of[target] or {}
              if target.chunk ~= index then add_once(uses_of[target], index) end
            end
          else row[#row + 1] = { "", text } end
          if earliest and earliest > book.chapters[c.chapter].last and not told[c.file .. text] then
            told[c.file .. text] = true
            book:complain(c.file, l.line, text .. " is used here but first declared later, in " .. book.chapters[earliest].file,
              "move its declaration to this chapter or an earlier one, or move the use")
          end
          local missing = not how and c.roots and not mine and lacks(text, place and place[1].name, c, list)
          if missing and not told[c.file .. text .. l.line] then
            told[c.file .. text .. l.line] = true
            book:complain(c.file, l.line, text .. " is used here, but is defined only with " .. Parts.say(Parts.short(book, missing)),
              "mark this code as belonging to that part, too (a section or a box with part=), or put the call into a chunk that the part adds to")
          end
        end
      elseif class == "co" then                 -- /* eq:x, sec:y */ become links that show the numbers
        local i = 1
        while true do
          local a, b, id = text:find("@?%f[%a](%l+:[%w_%-]*%w)", i)
          while a and not id:match("^eq:") and not id:match("^sec:") do a, b, id = text:find("@?%f[%a](%l+:[%w_%-]*%w)", b + 1) end
          if not a then break end
          if a > i then row[#row + 1] = { "co", text:sub(i, a - 1) } end
          ref_in_code(id, l.line)
          local l = labels[id]
          row[#row + 1] = l and (l.gone and { "co", Code.ref_text(l) } or { "eq", id, id }) or { "co", id }
          i = b + 1
        end
        if i <= #text then row[#row + 1] = { "co", text:sub(i) } end
      else row[#row + 1] = { class, text } end
      if class ~= "sp" then previous = text end
    end
    if l.use then row[#row + 1] = { "use", l.use } end
    local short = {}                            -- neighbours that are shown alike become one
    for _, t in ipairs(row) do
      local last = short[#short]
      if (t[1] == "" or t[1] == "sp") and last and last[1] == "" then last[2] = last[2] .. t[2]
      else short[#short + 1] = t[1] == "sp" and { "", t[2] } or t end
    end
    row = short
    c.tokens[#c.tokens + 1] = row
    c.row_at = c.row_at or {}
    c.row_at[l.line] = row
    ::next_line::
  end
end
for _, p in ipairs(pointers) do                -- a definition that a macro makes has no place: its chunk is as near as can be
  if not p[2].placed then p[1][3] = p[3].page .. "#" .. p[3].id end
end
for id, e in pairs(db.eqs) do
  local l = labels[id]
  if l.gone then db.eqs[id] = nil goto next_eq end
  e.chunks = {}
  for _, k in ipairs(eq_users[id] or {}) do e.chunks[#e.chunks + 1] = book.chunks[k].id end
  e.code = { table.unpack(eq_names[id] or {}) }
  if #e.chunks > 0 and not e.name and not l.online and volume_of[e.page] == volumes[1].name and taken[l.num:match("^[^.]+")] == "book/plan.tsv" then
    local file, line = where[id]:match("^(.*):(%d+)$")
    warn(file, tonumber(line), "equation " .. id .. " has no name for the list of formulas", 'write {#' .. id .. ' name="..."}')
  end
  if #e.chunks == 0 and not l.theory then
    local file, line = where[id]:match("^(.*):(%d+)$")
    warn(file, tonumber(line), "no code refers to equation " .. id,
      "write @" .. id .. " in a chunk's name or " .. id .. " in a comment of the code, or mark it {#" .. id .. " .theory}")
  end
  ::next_eq::
end
for name, list in pairs(tags) do
  local shown = {}
  for _, t in ipairs(list) do
    if t.main then
      local c = book.chunks[t.chunk]
      if not t.placed then t.anchor = c.id end
      shown[#shown + 1] = { target = c.page .. "#" .. t.anchor, num = c.num, kind = kind_text[t.kind], file = t.file, static = t.static }
    end
  end
  if #shown > 0 then
    shown.header = list.header
    db.idents[name] = shown
  end
end

--------------------------------------------------------------------------- the glossary: book/glossary.tsv, a page and print's last pages
local glossary = {}
if not how then
  local n, t = 0, {}
  for l in (Code.read(root .. "book/glossary.tsv") or ""):gmatch("([^\n]*)\n") do
    n = n + 1
    local term, meaning, id = l:match("^([^#\t]+)\t(.+)\t(%S+)$")
    if term and not labels[id] then book:complain("book/glossary.tsv", n, "nothing is labelled " .. id, "name a label of the section that explains it")
    elseif term then
      glossary[#glossary + 1] = { term = term, id = id }
      local at = "g-" .. term:gsub("%W+", "-")
      t[#t + 1] = '`<dfn id="' .. at .. '">`{=html}**' .. term .. "**`</dfn>`{=html}: " .. meaning .. " (@" .. id .. ").\n\n"
      search[#search + 1] = { kind = "gloss", title = term, page = "glossary.html", id = at, text = meaning }
    elseif l:match("^[^#]") then book:complain("book/glossary.tsv", n, "this is no row", "write term, meaning and label, parted by tabs") end
  end
  os.execute("mkdir -p " .. sh(out))
  Code.write_if_changed(out .. "/glossary.md", "# Glossary {.unnumbered}\n\n" .. table.concat(t))
  Code.write_if_changed(out .. "/glossary.lua", 'return {["base"]="glossary",["chunks"]={},["file"]="book/glossary.tsv"}\n')
end
db.glossary = glossary

---------------------------------------------------------------- the subject index: where else a term has something to say about it
-- Sections that have it in their title, and the three that use it most, at least three times; in each volume.
local index_in = {}                            -- index_in[section] = { terms }
do
  local said, order, title = {}, {}, {}
  local dull = { ["exercises"] = 1, ["notes"] = 1, ["notes and sources"] = 1, ["how it is tested"] = 1, ["what you can build now"] = 1, ["the files"] = 1 }
  for _, h in ipairs(heads) do
    title[h.id] = " " .. Code.plain(h.title):lower() .. " "
    if not dull[Code.plain(h.title):lower()] and not online[h.page] then order[#order + 1] = h.id; said[h.id] = {} end
  end
  for _, s in ipairs(search) do if s.kind == "text" and said[s.id] then table.insert(said[s.id], s.text:lower()) end end
  for id, t in pairs(said) do said[id] = " " .. table.concat(t, " ") .. " " end
  for _, t in ipairs(terms) do
    local first, second = t.term:match("^(.-), (.*)$")
    local words = (first and second .. " " .. first or t.term):lower()
    local pattern = "%f[%w]" .. words:gsub("[^%w]", "%%%0"):gsub("[%- ]+", "[%%-%%s]") .. "e?s?%f[^%w]"
    pattern = pattern:gsub("%%%[", "["):gsub("ye%?s%?", "[yi]e?s?")
    t.more = {}
    local found = {}
    for i, id in ipairs(order) do
      if id ~= t.id and labels[id] then
        local _, n = said[id]:gsub(pattern, "")
        local titled = title[id]:find(pattern) ~= nil
        if titled or n >= 3 then found[#found + 1] = { id = id, n = n + (titled and 1000 or 0), i = i, volume = volume_of[labels[id].page] } end
      end
    end
    table.sort(found, function(a, b) if a.n ~= b.n then return a.n > b.n end return a.i < b.i end)
    local count, chosen = {}, {}
    for _, f in ipairs(found) do
      count[f.volume] = (count[f.volume] or 0) + 1
      if count[f.volume] <= 3 then chosen[#chosen + 1] = f end
    end
    table.sort(chosen, function(a, b) return a.i < b.i end)
    for _, f in ipairs(chosen) do
      t.more[#t.more + 1] = f.id
      index_in[f.id] = index_in[f.id] or {}
      table.insert(index_in[f.id], { t.term, (words:gsub("y$", "")) })
    end
  end
  if not how then
    for _, g in ipairs(glossary) do
      if #terms > 0 and not terms[g.term] then book:complain("book/glossary.tsv", 1, "the glossary's word '" .. g.term .. "' is not in the subject index", "mark it where it is explained: [" .. g.term .. "]{.def}, or index=\"" .. g.term .. "\" at a heading") end
    end
  end
end

---------------------------------------------------------------------------------- the book of a smaller engine: what it is about
if how then
  for i = #entries, 1, -1 do if entries[i].gone or entries[i].planned then table.remove(entries, i) end end
  local text = require "this-engine"(book, chosen, keep, roots, called, bytes)
  local e = { name = "this-engine", page = "this-engine.html", num = "0", title = "This engine", id = "sec:this-engine", volume = volumes[1].name, part = "What it is" }
  table.insert(entries, 1, e)
  volume_of[e.page] = e.volume
  local second, third = 0, 0
  for marks, title, id in text:gmatch("(#+) ([^\n]-) {#([^}]*)}") do
    if #marks == 2 then second, third = second + 1, 0 elseif #marks == 3 then third = third + 1 end
    local num = "0" .. (#marks > 1 and "." .. second or "") .. (#marks > 2 and "." .. third or "")
    labels[id] = { kind = "sec", num = num, page = e.page, title = Code.plain(title) }
    heads[#heads + 1] = { level = #marks, num = num, id = id, title = title, page = e.page }
  end
  os.execute("mkdir -p " .. sh(out))
  Code.write_if_changed(out .. "/this-engine.md", text)
  Code.write_if_changed(out .. "/this-engine.lua", 'return {["base"]="this-engine",["chunks"]={},["num"]="0",["file"]="this-engine.md"}\n')
  local names = {}
  for i, x in ipairs(entries) do names[i] = x.name end
  Code.write_if_changed(out .. "/bases", table.concat(names, "\n") .. "\n")
end

--------------------------------------------------------------------------------------------------- what is handed on
local function keyed(list)                     -- chunk indices as ids, without repeats
  local r, seen = {}, {}
  for _, k in ipairs(list or {}) do
    local id = book.chunks[k].id
    if not seen[id] then seen[id] = true; r[#r + 1] = id end
  end
  return r
end
os.execute("mkdir -p " .. sh(out))
local scene_lines = {}
for name, fn in pairs(scenes) do scene_lines[#scene_lines + 1] = name .. "|" .. fn end
table.sort(scene_lines)
Code.write_if_changed(out .. "/scenes.list", table.concat(scene_lines, "\n") .. "\n")

for i, ch in ipairs(book.chapters) do
  if ch.gone then goto next_chapter end
  local mine = { file = ch.file, base = ch.name, num = ch.num, exercise = ch.entry.exercise, chunks = {}, index = {} }
  for _, h in ipairs(heads) do if h.page == ch.entry.page then mine.index[h.id] = index_in[h.id] end end
  for index, c in ipairs(book.chunks) do
    if c.chapter == i and c.gone then mine.chunks[c.k] = false
    elseif c.chapter == i then
      local n = book.names[c.name]
      local users = {}
      for _, u in ipairs(n.uses) do users[#users + 1] = u.chunk end
      local defs = {}
      for _, d in ipairs(c.defs) do
        defs[#defs + 1] = { name = d.name, anchor = d.anchor, kind = kind_text[d.kind], uses = keyed(uses_of[d]) }
      end
      local files = {}
      if Book.is_root(c.name) then files[1] = c.name end
      mine.chunks[c.k] = { num = c.num, id = c.id, name = c.name, part = c.part, only = Parts.margin(book, c), online = c.web, printed = c.printed, file = c.file, line = c.line, lines = c.tokens, defs = defs,
        eqs = { table.unpack(c.eqs) }, used = keyed(users), first = book.chunks[n.parts[1]].id, pieces = #n.parts, previous = c.part > 1 and book.chunks[n.parts[c.part - 1]].id or nil,
        following = c.part < #n.parts and book.chunks[n.parts[c.part + 1]].id or nil, source = files[1] and roots[files[1]].page or nil }
    end
  end
  Code.write_if_changed(out .. "/" .. ch.name .. ".lua", "return " .. Code.serialise(mine) .. "\n")
  Code.write_if_changed(out .. "/" .. ch.name .. ".md", table.concat(ch.md))
  Code.write_if_changed(out .. "/" .. ch.name .. ".uses", table.concat(ch.assets or {}, "\n") .. "\n")
  ::next_chapter::
end
db.weeks = how and {} or require "weeks"(book, db, out, scenes)
db.cited = {}
for k in pairs(cited) do db.cited[#db.cited + 1] = k end
table.sort(db.cited)
db.cited_in = cited_in
Code.write_if_changed(out .. "/db.lua", "return " .. Code.serialise(db) .. "\n")

local Pages = require "weave-pages"
Pages.write { book = book, db = db, out = out, html = html_dir, root = root, roots = roots, tags = tags, uses_of = uses_of, keyed = keyed,
  search = search, terms = terms, labels = labels, kind_text = kind_text, images = images, resolve = resolve, locals = locals }

table.sort(warnings)
for _, w in ipairs(warnings) do io.stderr:write(w, "\n") end
if #book.errors > 0 then
  table.sort(book.errors)
  for _, e in ipairs(book.errors) do io.stderr:write(e, "\n") end
  io.stderr:write(string.format("%d error%s in the chapters.\n", #book.errors, #book.errors == 1 and "" or "s"))
  if not tolerant then os.exit(1) end
end
