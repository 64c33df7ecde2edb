-- weeks.lua: the weeks of the course, from the table in the chapter coursework, and the slides of each, from the chapters that it reads.
--   | week | @sec:a to @sec:b, @sec:c without @sec:d | @ex:one, @ex:two, *@ex:three* | words, with a `scene` |
-- A row has three exercises, one of them a program, of chapters that are read by then, and a scene. Nothing of a slide is written for
-- it: it has a section's heading, its first figures, and the formulas that the code uses.
local Code = require "weave-code"
local FEW, MOST = 3, 20                        -- exercises and slides of a week

-- The blocks of a chapter's text, from one empty line to the next, each under its heading: id -> list. Chunks and fences are left out.
local function blocks(text)
  local list, here, block, fence = {}, "", {}, nil
  local function close()
    if #block > 0 then list[here] = list[here] or {}; table.insert(list[here], table.concat(block, "\n")) end
    block = {}
  end
  for l in (text .. "\n\n"):gmatch("([^\n]*)\n") do
    local f = l:match("^%s*(```+)")
    if fence then if f and #f >= #fence then fence = nil end
    elseif f then close(); fence = f
    elseif l:match("^#+ ") then close(); here = l:match("{#([^%s}]+)") or here
    elseif l:match("%S") and not l:match("^:::") then block[#block + 1] = l
    else close() end
  end
  return list
end

-- What a section could show: its first picture with a formula, two formulas at a time, the other pictures.
local function candidates(db, list, chapter)
  local pictures, formulas, units = {}, {}, {}
  for _, b in ipairs(list or {}) do
    local path = b:match("^!%[.*%]%((%S+)%)%s*{[^}]*}$")
    if path then pictures[#pictures + 1] = { (path:match("^scenes/") and 4) or (path:match("^figures/") and 3) or 2, (b:gsub("}$", " of=" .. chapter .. "}")), path }
    else
      local at = 1
      while true do
        local a, z, body = b:find("%$%$(.-)%$%$", at)
        if not a then break end
        local id = b:match("^%s*{#(eq:[^}]+)}", z + 1)
        if id and db.eqs[id] and #(db.eqs[id].chunks or {}) > 0 then formulas[#formulas + 1] = "$$" .. body .. "$$ {#" .. id .. "}" end
        at = z + 1
      end
    end
  end
  local function unit(picture, ...)
    local t = { ... }
    local score = (picture and picture[1] or 0) + 1.5 * #t - #units / 2
    t[#t + 1] = picture and picture[2]
    if #t > 0 then units[#units + 1] = { score = score, text = table.concat(t, "\n\n"), path = picture and picture[3] } end
  end
  if #pictures > 0 then unit(pictures[1], formulas[1]) end
  for i = #pictures > 0 and 2 or 1, #formulas, 2 do unit(nil, formulas[i], formulas[i + 1]) end
  for i = 2, #pictures do unit(pictures[i]) end
  return units
end

local function slides(book, db, week, sections, out)
  local text, all, fixed = {}, {}, {}
  for _, c in ipairs(book.chapters) do text[c.entry.page] = c.md and { c.name, table.concat(c.md) } end
  local parsed = {}
  for _, h in ipairs(sections) do
    if h.web then goto next end
    local chapter, source = table.unpack(text[h.page])
    parsed[h.page] = parsed[h.page] or blocks(source)
    local title = "## [" .. h.num .. " " .. h.title .. "](" .. h.page .. "#" .. h.id .. ")\n\n"
    local mine = parsed[h.page][h.id]
    if h.level == 1 then
      local goals = source:match("\n:::+ *{%.goals[^\n]*\n(.-)\n:::")
      if goals then all[#all + 1] = { score = 99, text = title .. goals } end
    end
    for _, u in ipairs(candidates(db, mine, chapter)) do u.text = title .. u.text; all[#all + 1] = u end
    ::next::
  end
  local rank = {}
  for i, u in ipairs(all) do u.place = i; rank[i] = u end
  table.sort(rank, function(a, b) if a.score ~= b.score then return a.score > b.score end return a.place < b.place end)
  local t, uses, base = {}, {}, "slides-" .. week.n
  local function slide(s) t[#t + 1] = "::: {.slide}\n" .. s .. "\n:::\n\n" end
  for i = 1, math.min(#rank, MOST - 2) do rank[i].taken = true end
  slide("# Week " .. week.n .. "\n\n" .. week.title .. "\n\nRead: " .. week.read .. ".\n\nAt its end: " .. week.ends .. ".")
  for _, u in ipairs(all) do
    if u.taken then slide(u.text); uses[#uses + 1] = u.path end
  end
  slide("## Exercises of week " .. week.n .. "\n\n- " .. week.exercises:gsub(", ", "\n- "))
  Code.write_if_changed(out .. "/" .. base .. ".md", table.concat(t))
  Code.write_if_changed(out .. "/" .. base .. ".lua", 'return {["base"]="' .. base .. '",["chunks"]={},["slides"]="Week ' .. week.n .. '",["file"]="chapters/engine/E-coursework.nw"}\n')
  Code.write_if_changed(out .. "/" .. base .. ".uses", table.concat(uses, "\n") .. "\n")
end

return function(book, db, out, scenes)
  local weeks, course = {}, nil
  for _, c in ipairs(book.chapters) do if c.name == "coursework" and db.labels["sec:coursework-weeks"] then course = c end end
  if not course then return weeks end
  local heads, at, entry = {}, {}, {}           -- the first volume's headings, as they are printed
  for _, e in ipairs(db.entries) do
    if not e.of and not e.planned and db.volume_of[e.page] == db.volumes[1].name then
      entry[e.page] = e
      for _, h in ipairs(db.heads) do if h.page == e.page then heads[#heads + 1] = h; at[h.id] = #heads end end
    end
  end
  local rows = table.concat(course.md)
  for at_row, n, read, exercises, ends in rows:gmatch("\n()| *(%d+) *|([^|\n]*@sec:[^|\n]*)|([^|\n]*)|([^|\n]*)|") do
    local _, line = rows:sub(1, at_row):gsub("\n", "")
    local function bad(what, remedy) book:complain(course.file, line + 1, "week " .. n .. " of the course " .. what, remedy) end
    local function trim(s) return s:match("^%s*(.-)%s*$") end
    local week = { n = n, read = trim(read), exercises = trim(exercises), ends = trim(ends), title = "", chapters = {}, spans = {} }
    local inside, last, without = {}, nil, false
    for between, id in read:gmatch("(.-)@(sec:[%w_%-]*%w)") do
      without = without or between:match("without") ~= nil
      local a = at[id]
      if not a then bad("reads " .. id .. ", which is not in the first volume", "name one of its sections")
      else
        local z = a                             -- with what is below it
        while heads[z + 1] and heads[z + 1].level > heads[a].level do z = z + 1 end
        for k = between == " to " and last or a, z do inside[k] = not without end
        last = z + 1
      end
    end
    local sections = {}
    for k = 1, #heads + 1 do                    -- spans: from one heading to before another
      if inside[k] and not inside[k - 1] then week.spans[#week.spans + 1] = { heads[k].id } end
      if not inside[k] and inside[k - 1] then week.spans[#week.spans][2] = heads[k] and heads[k].id end
      if inside[k] then
        local h, e = heads[k], entry[heads[k].page]
        sections[#sections + 1] = h
        if week.chapters[#week.chapters] ~= e.name then
          week.chapters[#week.chapters + 1] = e.name
          e.week = e.week or n
          week.title = week.title .. (week.title == "" and "" or ", ") .. e.num .. " " .. Code.plain(e.title)
          week.page = week.page or h.page .. (h.level > 1 and "#" .. h.id or "")
        end
      end
    end
    local count, program = 0, false
    for id in exercises:gmatch("@(ex:[%w_%-]*%w)") do
      local l = db.labels[id]
      if l then
        count, program = count + 1, program or l.exercise == "program"
        local e = entry[l.page]
        if l.page ~= course.entry.page and not (e and e.week) then bad("has " .. id .. ", of a chapter that is read later", "choose another") end
      end
    end
    if count < FEW or not program then bad("has " .. count .. " exercises" .. (program and "" or ", and no program among them"), "name three in its row, one of the kind program") end
    local runs = false
    for s in ends:gmatch("`([^`]+)`") do runs = runs or scenes[s:lower()] ~= nil end
    if not runs then bad("ends with nothing that runs", "name a scene in backticks at the end of its row") end
    if week.page then
      weeks[#weeks + 1] = week
      slides(book, db, week, sections, out)
    end
  end
  return weeks
end
