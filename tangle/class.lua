-- class.lua: a class is collected, graded and listed. course.lua calls it; `make grade-all DIR=...` is how it begins.
-- Everything that comes from a submission is text of a bounded length: file names, messages, verdicts. Points are counted here, from
-- the criteria of this tree.
return function(Course, commands, H)
  local read, write, quote, out_of, ok, lines, points_text = H.read, H.write, H.quote, H.out_of, H.ok, H.lines, H.points_text
  local MOST_BYTES, MOST_FILES = 262144, 200          -- of a submission; of one student's that are looked at
  local CLASS = H.B .. "/course/class"
  local Class = {}

  --------------------------------------------------------------------------------------------------------------- clean text
  -- One line that a terminal, a spreadsheet and an XML reader take as text: UTF-8, without controls and without marks of direction.
  local function clean(s, most)
    s = s:sub(1, 4000)
    local t, i = {}, 1
    while i <= #s do
      local c = s:match("^[\32-\126]+", i) or s:match("^[\xC2-\xF4][\x80-\xBF]+", i)
      if c and (c:byte() < 0x80 or utf8.len(c)) then
        if c:byte() >= 0x80 then
          for _, p in utf8.codes(c) do
            if p < 0xA0 or p >= 0x200B and p <= 0x200F or p >= 0x2028 and p <= 0x202E or p >= 0x2066 and p <= 0x2069 or p == 0xFEFF or p >= 0xFFFE and p <= 0xFFFF then t[#t + 1] = " " else t[#t + 1] = utf8.char(p) end
          end
        else t[#t + 1] = c end
        i = i + #c
      else t[#t + 1] = s:byte(i) < 32 and " " or "?"; i = i + 1 end
    end
    s = table.concat(t)
    if most and utf8.len(s) > most then s = s:sub(1, utf8.offset(s, most) - 1) .. "..." end
    return s
  end
  Class.clean = clean
  -- A field of a CSV file. What a spreadsheet would take for a formula gets an apostrophe.
  local function field(s)
    s = clean(tostring(s or ""))
    if s:match("^%s*[=+@|%-]") and not tonumber(s) then s = "'" .. s end
    if s:find('[",;]') or s:match("^%s") or s:match("%s$") then s = '"' .. s:gsub('"', '""') .. '"' end
    return s
  end
  local function csv_rows(text)
    local rows, row, i = {}, {}, 1
    text = (text or ""):gsub("^\xEF\xBB\xBF", ""):gsub("\r\n?", "\n")
    local comma = text:match("^[^\n]*;") and not text:match("^[^\n]*,") and ";" or ","
    while i <= #text do
      local value
      if text:sub(i, i) == '"' then
        local parts = {}
        i = i + 1
        while true do
          local at = text:find('"', i, true)
          parts[#parts + 1] = text:sub(i, (at or #text + 1) - 1)
          i = (at or #text) + 1
          if text:sub(i, i) ~= '"' then break end
          parts[#parts + 1] = '"'
          i = i + 1
        end
        value = table.concat(parts) .. text:match("^[^" .. comma .. "\n]*", i)
        i = i + #text:match("^[^" .. comma .. "\n]*", i)
      else
        value = text:match("^[^" .. comma .. "\n]*", i)
        i = i + #value
      end
      row[#row + 1] = value
      local c = text:sub(i, i)
      i = i + 1
      if c ~= comma then if #row > 1 or row[1] ~= "" then rows[#rows + 1] = row end row = {} end
    end
    if #row > 0 then rows[#rows + 1] = row end
    return rows
  end
  Class.csv_rows = csv_rows

  ----------------------------------------------------------------------------------------------------------- names of people
  -- Letters with marks as the plain ones, whether the mark is in the letter or behind it: file systems do not agree.
  local PLAIN = {}
  for plain, marked in ([[a=àáâãäåāăą c=çćĉċč d=ďđð e=èéêëēĕėęě g=ĝğġģ h=ĥħ i=ìíîïĩīĭįı j=ĵ k=ķ l=ĺļľŀł n=ñńņňŉ o=òóôõöøōŏő r=ŕŗř
    s=śŝşš t=ţťŧ u=ùúûüũūŭůűų w=ŵ y=ýÿŷ z=źżž a=ÀÁÂÃÄÅĀĂĄ c=ÇĆĈĊČ d=ĎĐÐ e=ÈÉÊËĒĔĖĘĚ g=ĜĞĠĢ h=ĤĦ i=ÌÍÎÏĨĪĬĮİ j=Ĵ k=Ķ l=ĹĻĽĿŁ n=ÑŃŅŇ o=ÒÓÔÕÖØŌŎŐ r=ŔŖŘ
    s=ŚŜŞŠ t=ŢŤŦ u=ÙÚÛÜŨŪŬŮŰŲ w=Ŵ y=ÝŶŸ z=ŹŻŽ]]):gmatch("(%a)=(%S+)") do for _, p in utf8.codes(marked) do PLAIN[utf8.char(p)] = plain end end
  local function fold(s)
    s = clean(s):gsub("[\xCC\xCD][\x80-\xBF]", function(c) local p = utf8.codepoint(c); return p >= 0x300 and p < 0x370 and "" or nil end)
    s = s:gsub("[\xC3-\xC5][\x80-\xBF]", PLAIN):lower():gsub("[%p%s]+", " "):gsub("^ ", ""):gsub(" $", "")
    local words = {}
    for w in s:gmatch("%S+") do words[#words + 1] = w end
    table.sort(words)                                -- "Lovelace, Ada" is Ada Lovelace
    return table.concat(words, " ")
  end
  Class.fold = fold
  local function roster(path)
    local people = {}
    if not path or path == "" then return nil end
    local text = read(path)
    if not text then H.die("ROSTER=%s: there is no such file", path) end
    local name_at, id_at = 1, 2
    for i, row in ipairs(csv_rows(text)) do
      local head = i == 1 and fold(row[1]):match("^name") or i == 1 and fold(row[2] or ""):match("^name") or i == 1 and fold(row[1]) == "id"
      if head then for k, cell in ipairs(row) do local w = fold(cell); if w:match("name") then name_at = k elseif w:match("id") or w:match("number") then id_at = k end end
      else people[#people + 1] = { name = clean(row[name_at] or "", 80), id = clean(row[id_at] or "", 40), on_roster = true, files = {} } end
    end
    return people
  end

  ------------------------------------------------------------------------------------------------------------- names of files
  -- Which exercise is that? By its name, with or without the number that it once had, however often it was downloaded; else by the
  -- label that its goals name.
  local function by_names(all)
    local t = { label = {} }
    for _, e in ipairs(all) do
      if e.base then
        t[e.base:lower()], t[H.bare(e.base):lower()] = e, e
        if e.label then t.label[e.label] = e end
      end
    end
    return t
  end
  local function recognise(names, file, path)
    local s = file:lower():gsub("%.nw%.txt$", ".nw")
    local copy = 0
    if not s:match("%.nw$") then return nil end
    s = s:gsub("%.nw$", "")
    for _ = 1, 4 do
      local n = s:match("%s*%((%d+)%)$")
      if n then copy = math.max(copy, tonumber(n:sub(1, 6))) end
      s = s:gsub("%s*%(%d+%)$", ""):gsub("%s*%-?%s*copy%s*%d*$", ""):gsub("^copy of%s+", ""):gsub("%s+$", ""):gsub("^%s+", "")
    end
    s = s:gsub("[%s_]+", "-")
    local e = names[s] or names[s:gsub("^%w+%.%d+%-", "")] or names[s:gsub("^.-(%w+%.%d+%-)", "%1")]
    if not e and path then
      local f = io.open(path, "rb")
      local text = f and f:read(8192) or ""
      if f then f:close() end
      e = names.label[text:match("{%.goals.-@ex:([%w_%-]+)") or ""]
    end
    return e, copy
  end
  Class.recognise = function(name) return recognise(by_names(Course.exercises()), name) end
  -- "Ada Lovelace_12345_assignsubmission_file_": Moodle's folders, and the files of its flat archives.
  local function of_moodle(s) return s:match("^(.-)_(%d+)_assignsubmission_%a+_?(.*)$") end

  -------------------------------------------------------------------------------------------------------------------- collect
  local function serialised(v)
    if type(v) == "table" then
      local t = {}
      for k, x in pairs(v) do if type(x) ~= "function" then t[#t + 1] = "[" .. serialised(k) .. "]=" .. serialised(x) end end
      return "{" .. table.concat(t, ",") .. "}"
    end
    return type(v) == "string" and string.format("%q", v):gsub("\\\n", "\\n") or tostring(v)
  end
  local function load_table(path) local s = read(path); local f = s and load("return " .. s, path, "t", {}); return f and f() end

  -- What an archiver or a desktop leaves; everything else has a row.
  local JUNK = { ["__MACOSX"] = true, [".git"] = true, [".svn"] = true, [".DS_Store"] = true, ["Thumbs.db"] = true, ["desktop.ini"] = true, [".vscode"] = true, [".idea"] = true }
  local function junk(path)
    for part in path:gmatch("[^/]+") do if JUNK[part] or part:match("^%._") then return true end end
  end
  -- find's list becomes the class's plan: people, their newest file of each exercise, and what nobody knows. Prints the jobs.
  function commands.collect(dir, list_file, roster_file, ids)
    local all = H.with_names(Course.exercises())
    local names = by_names(all)
    local people, by = roster(roster_file), {}
    local listed = people ~= nil
    people = people or {}
    local same = {}
    for _, p in ipairs(people) do local f = fold(p.name); same[f] = (same[f] or 0) + 1 end
    for _, p in ipairs(people) do
      if same[fold(p.name)] == 1 then by["name " .. fold(p.name)] = p end
      if p.id ~= "" then by["id " .. fold(p.id)] = p end
    end
    -- Somebody's folder. Two folders are two people, whoever has given himself the other's name, unless they have one number of Moodle's.
    local function person(who)
      if by["folder " .. who] then return by["folder " .. who] end
      local name, number = of_moodle(who)
      local p = number and by["moodle " .. number] or by["name " .. fold(name or who)] or by["id " .. fold(name or who)] or number and by["id " .. number]
      if not p and not name then
        for part in who:gmatch("[^_]+") do p = p or by["id " .. fold(part)] end
      end
      local twin
      if p and p.folder and not (number and p.moodle == number) then p, twin, p.twin = nil, true, true end
      if not p then
        p = { name = clean(name or who, 80), id = number or "", files = {}, stranger = listed, twin = twin }
        people[#people + 1] = p
      end
      p.folder, p.moodle = who, number
      by["folder " .. who] = p
      if number then by["moodle " .. number] = p end
      return p
    end
    local wanted
    if ids ~= "" then wanted = {}; for _, e in ipairs(H.chosen(all, ids)) do wanted[e.base] = e end end
    local count, loose = {}, {}
    local text = read(list_file) or ""
    for record in text:gmatch("([^%z]*)%z") do
      local kind, size, time, path = record:match("^(%a)\t(%d+)\t(%-?[%d%.]+)\t(.*)$")
      local inner = path and path:sub(#dir + 2) or ""
      local who, rest = inner:match("^([^/]*)/(.*)$")
      local file = inner:match("([^/]*)$")
      if not who then
        local name, number, tail = of_moodle(inner)
        if name and tail ~= "" then who, rest, file = name .. "_" .. number .. "_assignsubmission_file_", tail, tail end
      elseif of_moodle(file) then file = select(3, of_moodle(file)) end
      local _, deep = inner:gsub("/", "")
      if kind == "d" and deep < 11 then
        if deep == 0 and not JUNK[inner] then person(inner) end
      elseif not junk(inner) then
        local p = who and person(who) or loose
        count[p] = (count[p] or 0) + 1
        p.files = p.files or {}
        if count[p] <= MOST_FILES then
          local regular = kind == "f"
          local small = tonumber(size) <= MOST_BYTES
          local e, copy = recognise(names, file, regular and small and path)
          if wanted and e and not wanted[e.base] then e = nil end
          p.files[#p.files + 1] = { path = path, name = clean(rest or inner, 120), base = e and e.base, copy = copy or 0, time = math.max(0, math.min(tonumber(time), 4e9)), size = tonumber(size),
            fit = regular and small, why = not regular and ({ d = "a folder too deep", l = "a link", p = "a pipe", s = "a socket", b = "a device", c = "a device" })[kind] or not small and "larger than " .. MOST_BYTES .. " bytes" or nil }
        end
      end
    end
    if loose.files then people[#people + 1] = { name = "(in no student's folder)", id = "", files = loose.files, nobody = true } end
    local jobs, there = {}, {}
    for _, p in ipairs(people) do
      p.handed, p.unknown = {}, {}
      p.more = math.max(0, (count[p.nobody and loose or p] or 0) - MOST_FILES)
      local groups = {}
      for _, f in ipairs(p.files) do
        if f.base and not p.nobody then groups[f.base] = groups[f.base] or {}; table.insert(groups[f.base], f); there[f.base] = true
        else p.unknown[#p.unknown + 1] = f.name .. (f.why and " (" .. f.why .. ")" or "") end
      end
      for base, g in pairs(groups) do
        -- the newest; what has its date by less than a minute, as files have that were unpacked without their dates, is as new
        local newest = -math.huge
        for _, f in ipairs(g) do if f.fit then newest = math.max(newest, f.time) end end
        for _, f in ipairs(g) do f.new = f.time >= newest - 60 end
        table.sort(g, function(a, b)
          if a.fit ~= b.fit then return a.fit end
          if a.new ~= b.new then return a.new end
          if not a.new and a.time ~= b.time then return a.time > b.time end
          if a.copy ~= b.copy then return a.copy > b.copy end
          local _, da = a.path:gsub("/", ""); local _, db = b.path:gsub("/", "")
          if da ~= db then return da < db end
          return a.path < b.path
        end)
        local h = { base = base, file = g[1].path, name = g[1].name, time = g[1].time, attempts = #g, others = {} }
        for i = 2, #g do h.others[#h.others + 1] = g[i].name .. (g[i].why and " (" .. g[i].why .. ")" or "") end
        if g[1].fit then
          h.number = #jobs + 1
          jobs[h.number] = h
        else h.refused = g[1].why end
        p.handed[base] = h
      end
      p.files = nil
    end
    local order = {}
    for _, e in ipairs(all) do if e.base and (wanted and wanted[e.base] or not wanted and there[e.base]) then order[#order + 1] = e.base end end
    write(CLASS .. "/plan.lua", serialised { people = people, exercises = order, listed = listed })
    for i, h in ipairs(jobs) do io.write(i, "\0", h.base, "\0", h.file, "\0") end
    write(CLASS .. "/exercises", table.concat(order, "\n") .. "\n")
  end

  ---------------------------------------------------------------------------------------------------------------------- grade
  -- In the room: builds, and lets the report and the programs out by descriptors 3, 4 and 5.
  function commands.build(file, base, out)
    local r = Course.build(file, base, out, nil, true)
    local t = { r.refused and "refused\t" .. clean(r.refused, 200) or "built" }
    for i, m in ipairs(r.refused and r.messages or r.warnings or {}) do
      for l in lines(m) do if i <= 200 then t[#t + 1] = "message\t" .. clean(l, 300) end end
    end
    write(out .. "/report", table.concat(t, "\n") .. "\n")
    ok("cat " .. quote(out .. "/report") .. " >&3")
    if not r.refused then
      ok("cat " .. quote(r.program) .. " >&4")
      if r.sanitized then ok("cat " .. quote(r.sanitized) .. " >&5") end
    end
  end
  local function bounded(path, most) local f = io.open(path, "rb"); local s = f and f:read(most) or ""; if f then f:close() end return s end

  -- Fingerprints of what the student wrote: eight words in a row, names and numbers all alike, and of each four neighbours the least.
  local function fingerprints(chunks, base, file)
    local given, mine, text = H.chunks_of("chapters/exercises/" .. base .. ".nw"), {}, {}
    for l in lines(read(file)) do text[#text + 1] = l end
    local tokens = {}
    for _, c in ipairs(chunks.list) do
      if not given.defined[c.name] then
        for n = c.from + 1, math.min(c.to or c.from, #text) do
          H.Refuse.words(text[n]:gsub("/%*.-%*/", " "):gsub("//.*", ""), n, function(w)
            tokens[#tokens + 1] = w:match("^[%a_]") and not w:match("^if$") and not w:match("^for$") and not w:match("^while$") and not w:match("^return$") and not w:match("^wf") and "n" or w
          end)
        end
      end
    end
    local hashes = {}
    for i = 1, #tokens - 7 do
      local h = 5381
      for k = i, i + 7 do for j = 1, #tokens[k] do h = (h * 33 + tokens[k]:byte(j)) % 4294967291 end h = h * 33 % 4294967291 end
      hashes[i] = h
    end
    for i = 1, math.max(1, #hashes - 3) do
      local least
      for k = i, math.min(i + 3, #hashes) do if not least or hashes[k] < least then least = hashes[k] end end
      if least then mine[least] = true end
    end
    local list = {}
    for h in pairs(mine) do list[#list + 1] = h end
    table.sort(list)
    return table.move(list, 1, math.min(#list, 4000), 1, {})          -- nobody's length is paid by those who are compared with him
  end

  function commands.graded(number, base, file)
    local dir = CLASS .. "/" .. number
    local out = dir .. "/out"
    local copy = dir .. "/" .. base .. ".nw"
    os.execute("rm -rf " .. quote(dir) .. " && mkdir -p " .. quote(out))
    -- a copy, of a file that is still no link, without Windows' marks at its beginning and its lines' ends
    if ok("[ -f " .. quote(file) .. " ] && [ ! -L " .. quote(file) .. " ]") then
      write(copy, (bounded(file, MOST_BYTES + 1):gsub("^\xEF\xBB\xBF", ""):gsub("\r\n", "\n")))
    end
    ok("chmod a+r " .. quote(copy))
    local row = { number = number, base = base, criteria = {}, look = {}, earned = 0, max = 0 }
    local r = { base = base, file = "/hand/" .. base .. ".nw", criteria = H.criteria_of(base), earned = 0, max = 0, messages = {}, warnings = {}, out = out, chunks = { list = {}, defined = {}, used = {}, first = {} } }
    for _, c in ipairs(r.criteria) do r.max = r.max + c.points; c.earned, c.status, c.line = 0, "not run", 1 end
    local unfit = H.Refuse.size(copy)
    if unfit then r.refused = unfit
    else
      r.chunks = H.chunks_of(copy)
      for _, c in ipairs(r.criteria) do c.line = r.chunks.defined[c.hole] or r.chunks.used[c.hole] end
      local _, code = ok("tangle/room build " .. quote(CLASS .. "/../room") .. " " .. quote(copy) .. " " .. quote(base) .. " " .. quote(out) .. " " .. number)
      local report = bounded(out .. "/report", 65536)
      r.refused = report:match("^refused\t([^\n]*)") or not report:match("^built\n") and (code == 124 or code == 137 and "stopped: its compilation takes too long") or nil
      if r.refused == true or not r.refused and not report:match("^built\n") then r.refused = code == 124 and "stopped: its compilation takes too long" or "stopped: it does not compile within the limits" end
      for m in report:gmatch("\nmessage\t([^\n]*)") do table.insert(r.refused and r.messages or r.warnings, clean(m, 300)) end
      r.program = out .. "/program"
      r.sanitized = #bounded(out .. "/sanitized", 4) == 4 and out .. "/sanitized" or nil
      ok("chmod a+rx " .. quote(out .. "/program") .. " " .. quote(out .. "/sanitized"))
      row.marks = fingerprints(r.chunks, base, copy)
    end
    Course.run(r, function(program, criterion)
      ok("tangle/room run " .. quote(program) .. " " .. quote(criterion) .. " " .. quote(out) .. " " .. number)
      return bounded(out .. "/verdict", 4096)
    end, function(program, at) return out_of("tangle/room place " .. quote(program) .. " " .. number .. " " .. table.concat(at, " ")) end)
    row.max, row.earned, row.refused = r.max, r.earned, r.refused and clean(r.refused, 200)
    for _, m in ipairs(r.refused and r.messages or {}) do if #row.look < 4 and not m:match("^%s+in the chunk") then row.look[#row.look + 1] = clean((m:gsub("^/hand/", "")), 120) end end
    for _, c in ipairs(r.criteria) do
      row.criteria[#row.criteria + 1] = { name = c.name, text = c.text, points = c.points, earned = c.earned, status = c.status, what = c.what and clean(c.what, 200), expected = c.expected and clean(c.expected, 100), got = c.got and clean(c.got, 200), line = c.line }
      if c.status == "refused" or c.status == "unfinished" then row.look[#row.look + 1] = c.name .. ": " .. clean(c.what .. ", " .. c.got, 120) end
    end
    r.e = H.find(H.with_names(Course.exercises()), base)
    local told = {}
    Course.table(r, r.e, function(l) told[#told + 1] = clean(l, 400) end)
    write(dir .. "/told", table.concat(told, "\n") .. "\n")
    write(dir .. "/row.lua", serialised(row))
    os.execute("rm -rf " .. quote(out))
  end

  ----------------------------------------------------------------------------------------------------------------------- list
  local function similar(rows)
    local function number(set) local n = 0 for _ in pairs(set) do n = n + 1 end return n end
    for i, a in ipairs(rows) do
      a.set = {}
      for _, h in ipairs(a.marks or {}) do a.set[h] = true end
      a.size = number(a.set)
    end
    for i, a in ipairs(rows) do
      for k = i + 1, #rows do
        local b, both = rows[k], 0
        for h in pairs(a.set) do if b.set[h] then both = both + 1 end end
        local share = both / math.max(1, math.min(a.size, b.size))
        if both >= 6 and share >= 0.6 then
          a.like, b.like = a.like or {}, b.like or {}
          a.like[#a.like + 1] = { share, b.who }
          b.like[#b.like + 1] = { share, a.who }
        end
      end
    end
  end
  local function time_of(text)            -- DUE=2026-11-20 or 2026-11-20 18:00
    local y, m, d, h, min = (text or ""):match("^(%d+)%-(%d+)%-(%d+)[ T]?(%d*):?(%d*)")
    return y and os.time { year = y, month = m, day = d, hour = tonumber(h) or 23, min = tonumber(min) or (h == "" and 59 or 0) }
  end

  function commands.listed(due_text)
    local plan, rows, columns, seen = load_table(CLASS .. "/plan.lua"), {}, {}, {}
    local all = H.with_names(Course.exercises())
    local due = time_of(due_text)
    if due_text ~= "" and not due then H.die("DUE=%s -- write DUE=2026-11-20, or DUE=\"2026-11-20 18:00\"", due_text) end
    -- marks of the prose that somebody has entered into the last list stay
    local prose, head = {}, {}
    for i, old in ipairs(csv_rows(read(H.B .. "/course/grades.before.csv"))) do
      if i == 1 then for k, name in ipairs(old) do head[name] = k end
      else
        for _, k in ipairs { "prose", "comment" } do
          if head[k] and (old[head[k]] or "") ~= "" then prose[k .. "\n" .. (old[head.student] or "") .. "\n" .. (old[head.id] or "") .. "\n" .. (old[head.exercise] or "")] = old[head[k]] end
        end
      end
    end
    for _, base in ipairs(plan.exercises) do
      local group = {}
      for _, p in ipairs(plan.people) do
        local h = p.handed[base]
        local e = H.find(all, base)
        if h then
          local row = h.number and load_table(CLASS .. "/" .. h.number .. "/row.lua") or { criteria = {}, look = {}, earned = 0 }
          row.h, row.p, row.who, row.e = h, p, p.name, e
          row.max = e.points
          row.status = h.refused and "not recognised: " .. h.name .. " (" .. h.refused .. ")" or row.refused and "refused: " .. row.refused or row.base and "graded" or "stopped: no result"
          if h.number and row.refused and row.refused:match("^stopped") then row.status = row.refused end
          group[#group + 1] = row
          rows[#rows + 1] = row
        elseif not p.nobody then rows[#rows + 1] = { p = p, e = e, criteria = {}, look = {}, earned = 0, max = e.points, status = "not handed in" } end
      end
      similar(group)
      for _, c in ipairs(H.criteria_of(base)) do columns[#columns + 1] = { base, c.name } end
    end
    for _, p in ipairs(plan.people) do
      for i, name in ipairs(p.unknown) do if i <= 20 then rows[#rows + 1] = { p = p, criteria = {}, look = {}, status = "not recognised: " .. name } end end
      if #p.unknown > 20 or p.more > 0 then rows[#rows + 1] = { p = p, criteria = {}, look = {}, status = "not recognised: " .. math.max(0, #p.unknown - 20) + p.more .. " more files" } end
      if #plan.exercises == 0 and #p.unknown == 0 then rows[#rows + 1] = { p = p, criteria = {}, look = {}, status = "not handed in" } end
    end
    local order = {}
    for i, r in ipairs(rows) do order[r] = i end
    table.sort(rows, function(a, b) if a.p.name ~= b.p.name then return a.p.name < b.p.name end if a.p.id ~= b.p.id then return a.p.id < b.p.id end return order[a] < order[b] end)
    local t = { "student,id,exercise,earned,points,status,look,prose,attempts,handed_in,late_hours,other_files,similar,comment,folder" }
    for _, c in ipairs(columns) do t[1] = t[1] .. "," .. field(H.bare(c[1]) .. ": " .. c[2]) end
    local results = {}
    for _, r in ipairs(rows) do
      local h, e = r.h, r.e
      if r.p.twin then table.insert(r.look, 1, "two folders have this name") end
      if r.p.stranger then table.insert(r.look, 1, "not on the roster") end
      local like = {}
      table.sort(r.like or {}, function(a, b) return a[1] > b[1] end)
      for i, l in ipairs(r.like or {}) do if i <= 3 then like[i] = string.format("%s %d%%", l[2], math.floor(100 * l[1])) end end
      local exercise = e and H.bare(e.base) or ""
      local cells = { r.p.name, r.p.id, exercise, e and points_text(r.earned) or "", e and points_text(r.max) or "", r.status, table.concat(r.look, "; "), prose["prose\n" .. r.p.name .. "\n" .. r.p.id .. "\n" .. exercise] or "",
        h and h.attempts or "", h and os.date("%Y-%m-%d %H:%M", math.floor(h.time)) or "", h and due and (h.time > due and string.format("%.1f", (h.time - due) / 3600) or "0") or "",
        h and table.concat(h.others, "; ") or "", table.concat(like, "; "), prose["comment\n" .. r.p.name .. "\n" .. r.p.id .. "\n" .. exercise] or "", h and h.number or "" }
      for i, c in ipairs(cells) do cells[i] = field(c) end
      for _, c in ipairs(columns) do
        local earned = ""
        if e and c[1] == e.base then
          earned = "0"
          for _, k in ipairs(r.criteria) do if k.name == c[2] then earned = points_text(k.earned) end end
        end
        cells[#cells + 1] = earned
      end
      t[#t + 1] = table.concat(cells, ",")
      if e then
        local cs = #r.criteria > 0 and r.criteria or H.criteria_of(e.base)
        for _, c in ipairs(cs) do c.hole, c.status, c.got = c.hole or "", c.status or "not run", c.got or r.status end
        results[#results + 1] = { e = { number = r.p.name, label = exercise }, criteria = cs, earned = r.earned, max = r.max, file = h and h.name or "", refused = r.status ~= "graded" and r.status or nil, messages = r.look }
      end
      print(string.format("%-24s %-16s %5s %5s  %s%s", clean(r.p.name, 24), exercise, e and points_text(r.earned) or "", e and points_text(r.max) or "", clean(r.status, 60), #r.look > 0 and "  LOOK: " .. clean(table.concat(r.look, "; "), 100) or ""))
    end
    write(CLASS .. "/grades.csv", table.concat(t, "\n") .. "\n")
    write(CLASS .. "/grades.xml", Course.junit(results))
  end

  ------------------------------------------------------------------------------------------- from the list to pages and to an LMS
  -- Rows of the list by student, with marks of the prose and of the criteria: { name, id, rows = { { exercise = ..., ... } } }
  local function people()
    local list, by, head = {}, {}, nil
    for i, row in ipairs(csv_rows(read(CLASS .. "/grades.csv"))) do
      if i == 1 then head = row
      else
        local r = { criteria = {} }
        for k, name in ipairs(head) do
          local base, criterion = name:match("^(.-): (.*)$")
          if not base then r[name] = row[k] or "" elseif base == r.exercise then r.criteria[#r.criteria + 1] = { criterion, row[k] } end
        end
        local key = r.student .. "\n" .. r.id
        if not by[key] then by[key] = { name = r.student, id = r.id, rows = {} }; list[#list + 1] = by[key] end
        if r.exercise ~= "" then table.insert(by[key].rows, r) end
      end
    end
    if not head then H.die("there is no list yet -- make grade-all DIR=submissions/") end
    return list
  end
  function Course.rubric(base)
    local t = {}
    for l in lines(read("chapters/solutions/rubrics.tsv")) do
      local b, marks, what = l:match("^([^#\t]+)\t([%d%.]+)\t(.+)$")
      if b == base then t[#t + 1] = { tonumber(marks), what } end
    end
    return t
  end
  local function marks(r) return tonumber((r.prose:gsub(",", "."):match("^%s*(%d*%.?%d+)"))) or 0 end
  local function sums(base)
    local m = 0
    for _, c in ipairs(H.criteria_of(base)) do m = m + c.points end
    local q = 0
    for _, k in ipairs(Course.rubric(base)) do q = q + k[1] end
    return m, q
  end
  function commands.feedback()                -- a page for each student, and the points as Moodle and Canvas read them
    local all, list, bases, seen = H.with_names(Course.exercises()), people(), {}, {}
    for _, p in ipairs(list) do for _, r in ipairs(p.rows) do if not seen[r.exercise] then seen[r.exercise] = true; bases[#bases + 1] = r.exercise end end end
    table.sort(bases)
    os.execute("rm -rf " .. quote(CLASS .. "/feedback") .. "; mkdir -p " .. quote(CLASS .. "/feedback"))
    local function plain(s) return (clean(s):gsub("[\\`*_{}%[%]<>#|$]", "\\%0")) end     -- no mark of Markdown's comes from a submission
    local moodle, canvas = { "Full name,ID number" }, { "Student,ID,SIS User ID,SIS Login ID,Section", "    Points Possible,,,," }
    for _, b in ipairs(bases) do
      local e, m, q = H.find(all, b), sums(b)
      local name = field(e.number .. " " .. e.name_of)
      moodle[1], canvas[1] = moodle[1] .. "," .. name .. "," .. field(e.number .. " comment"), canvas[1] .. "," .. name
      canvas[2] = canvas[2] .. "," .. points_text(m + q)
    end
    for n, p in ipairs(list) do
      local t, cells, of = { "# " .. plain(p.name) .. "\n" }, { field(p.name), field(p.id) }, {}
      local row = { field(p.name), "", field(p.id), "", "" }
      for _, r in ipairs(p.rows) do
        local e, m, q = H.find(all, r.exercise), sums(r.exercise)
        of[r.exercise] = r
        t[#t + 1] = string.format("## %s %s\n\n%s of %s points for the program, %s of %s for the explanation. %s\n\n| criterion | points |\n|---|---|", e.number, plain(e.name_of), r.earned, points_text(m), points_text(marks(r)), points_text(q), r.status == "graded" and "" or plain(r.status))
        for i, c in ipairs(H.criteria_of(r.exercise)) do t[#t + 1] = string.format("| %s | %s of %s |", plain(c.text), (r.criteria[i] or {})[2] or "0", points_text(c.points)) end
        t[#t + 1] = "\nA good explanation says:\n"
        for _, k in ipairs(Course.rubric(r.exercise)) do t[#t + 1] = string.format("- %s (%s)", k[2], points_text(k[1])) end
        if r.comment ~= "" then t[#t + 1] = "\n> " .. plain(r.comment) end
        local said = r.folder ~= "" and read(CLASS .. "/" .. r.folder .. "/told")
        if said then t[#t + 1] = "\n" .. clean("What the tests said:") .. "\n\n    " .. said:gsub("%s+$", ""):gsub("\n", "\n    ") end
        t[#t + 1] = ""
      end
      write(string.format("%s/feedback/%d.md", CLASS, n), table.concat(t, "\n"))
      for _, b in ipairs(bases) do
        local r = of[b]
        local points = r and points_text(tonumber(r.earned) + marks(r)) or ""
        cells[#cells + 1], row[#row + 1] = points, points
        cells[#cells + 1] = field(r and r.comment or "")
      end
      moodle[#moodle + 1], canvas[#canvas + 1] = table.concat(cells, ","), table.concat(row, ",")
    end
    write(CLASS .. "/moodle.csv", table.concat(moodle, "\n") .. "\n")
    write(CLASS .. "/canvas.csv", table.concat(canvas, "\n") .. "\n")
    print(string.format("%d pages: %s/feedback/, made of grades.csv with its columns prose and comment; for Moodle %s/moodle.csv, for Canvas %s/canvas.csv", #list, CLASS, CLASS, CLASS))
  end
  return Class
end
