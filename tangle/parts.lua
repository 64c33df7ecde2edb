-- parts.lua: the parts of the engine, which may be left out when tangling.
--
-- A part is a word. A chapter declares parts in the attributes of its goals:
--   ::: {.goals part="joints" needs="contacts"}       all of the chapter belongs to the part "joints", which needs "contacts";
--                                                     a later chapter that says part="joints" without needs belongs to it, too
--   ::: {.goals parts="sensors: contacts; hooks"}     the parts "sensors" and "hooks" have pieces in it
-- and code belongs to a part by the chapter, section or box in which it stands:
--   ### Sensors {#sec:world-sensors part="sensors"}   all chunks of this section
--   ::: {.only part="joints sleep"}  ...  :::         the chunks in this box; two words: only with both
-- A chunk that is used by chunks of a part alone belongs to that part too, without a mark.
--   ::: {.only part="hooks" absent="WF_ABSENT"}       rows, WF_ANY(...), that stay as WF_ABSENT(...) in an engine without the part
--
-- The testbed, the lab and the figures are made of all parts and belong to none.
-- Promises that are checked on the whole book, so that they hold for every choice of parts:
--   every part that is named is declared; a file is there in every engine in which it is used (a chunk without a piece is empty);
--   no identifier is used where the part that defines it may be absent (weave.lua).
local M = {}

local function words(s)
  local t = {}
  for w in (s or ""):gmatch("[%w_%-]+") do t[#t + 1] = w end
  return t
end
local function attribute(l, name) return l:match("[%s{]" .. name .. '="([^"]*)"') or l:match("[%s{]" .. name .. "=([%w_%-]+)") end

function M.list(set)
  local t = {}
  for w in pairs(set) do t[#t + 1] = w end
  table.sort(t)
  return t
end
function M.say(set) return table.concat(M.list(set), " and ") end

------------------------------------------------------------------------------------------------- reading the marks
local function declare(book, chapter, line, name, needs)
  local old = book.parts[name]
  if old then
    book:complain(chapter.file, line, "part " .. name .. " is declared twice, first at " .. old.file .. ":" .. old.line, "declare it in one chapter")
    return
  end
  book.part_count = (book.part_count or 0) + 1
  book.parts[name] = { name = name, needs = needs, file = chapter.file, line = line, order = book.part_count }
end

-- Follows the documentation of one chapter: reader.line(number, text), and reader.here() says where one is.
function M.reader(book, chapter)
  local sections, boxes, fence = {}, {}, nil
  local whole = {}
  local reader = {}
  local function named(line, list)
    for _, w in ipairs(list) do book.part_uses[#book.part_uses + 1] = { chapter.file, line, w } end
    return list
  end
  local function goals(line, l)
    local own = words(attribute(l, "part"))
    local needs = attribute(l, "needs")
    if #own == 1 and (needs or not book.parts[own[1]]) then declare(book, chapter, line, own[1], words(needs))
    elseif #own == 0 and attribute(l, "needs") then
      book:complain(chapter.file, line, "needs= without part=", 'say which part this chapter is: part="word"')
    end
    whole = named(line, own)
    chapter.whole = {}
    for _, w in ipairs(own) do chapter.whole[w] = true end
    for entry in (attribute(l, "parts") or ""):gmatch("[^;]+") do
      local name, needs = entry:match("^%s*([%w_%-]+)%s*:?(.*)$")
      if name then declare(book, chapter, line, name, words(needs)) end
    end
  end
  function reader.line(line, l)
    local _, count = l:gsub("%S+", "")
    if count > 0 then chapter.prose = chapter.prose or {}; table.insert(chapter.prose, { only = reader.here(), words = count }) end
    local tick = l:match("^%s*(```+)") or l:match("^%s*(~~~+)")
    if fence then
      if tick and #tick >= #fence and l:match("^%s*[`~]+%s*$") then fence = nil end
      return
    end
    if tick then fence = tick return end
    local marks = l:match("^(#+)%s")
    if marks then
      for level in pairs(sections) do if level >= #marks then sections[level] = nil end end
      local part = attribute(l:match("{[^}]*}%s*$") or "", "part")
      if part then sections[#marks] = named(line, words(part)) end
    elseif l:match("^:::+%s*$") then boxes[#boxes] = nil
    elseif l:match("^:::") then
      boxes[#boxes + 1] = {}
      if l:match("{[^}]*%.goals") then goals(line, l)
      elseif l:match("{[^}]*%.only") then
        local part = attribute(l, "part")
        if part then boxes[#boxes] = named(line, words(part)); boxes[#boxes].absent = attribute(l, "absent")
        else book:complain(chapter.file, line, "a box .only that does not say with what", 'write ::: {.only part="word"}') end
      end
    end
  end
  function reader.absent() return #boxes > 0 and boxes[#boxes].absent or nil end
  function reader.here()
    local set = {}
    for _, w in ipairs(whole) do set[w] = true end
    for _, list in pairs(sections) do for _, w in ipairs(list) do set[w] = true end end
    for _, list in ipairs(boxes) do for _, w in ipairs(list) do set[w] = true end end
    return set
  end
  return reader
end

---------------------------------------------------------------------------------------------------------- closures
function M.closure(book, set)
  local all = {}
  local function visit(w)
    if all[w] then return end
    all[w] = true
    for _, need in ipairs(book.parts[w] and book.parts[w].needs or {}) do visit(need) end
  end
  for w in pairs(set) do visit(w) end
  return all
end

local function is_root(name) return name:match("^[%w_%-%./]+%.%a+$") ~= nil and name:find("/") ~= nil end
-- The testbed, the lab, the figures, the bindings and the small world are made of all parts; what is left out is left out of the engine.
local function is_program(name) return is_root(name) and (name:match("^testbed/") or name:match("^lab/") or name:match("^figures/") or name:match("^bindings/") or name:match("^small/")) ~= nil end

-- What a chunk is part of: its own marks, and what all its users have in common.
function M.close(book)
  local of_name = {}
  local with
  local function of_users(name)
    if of_name[name] then return of_name[name] end
    of_name[name] = {}                                   -- of a circle, which is told elsewhere
    local common
    for _, u in ipairs(is_root(name) and {} or book.names[name].uses) do
      local set = with(book.chunks[u.chunk])
      if not common then
        common = {}
        for w in pairs(set) do common[w] = true end
      else
        for w in pairs(common) do if not set[w] then common[w] = nil end end
      end
    end
    of_name[name] = common or {}
    return of_name[name]
  end
  function with(c)
    if c.with then return c.with end
    local set = {}
    for w in pairs(c.only) do set[w] = true end
    for w in pairs(c.name and of_users(c.name) or {}) do set[w] = true end
    if is_program(c.name or "") then for w in pairs(book.parts) do set[w] = true end end
    c.with = M.closure(book, set)
    return c.with
  end
  for _, c in ipairs(book.chunks) do with(c) end
end

-- The words of a chunk without those that follow from others: for messages and margins.
function M.short(book, set)
  local t = {}
  for w in pairs(set) do
    local implied = false
    for other in pairs(set) do
      if other ~= w and M.closure(book, { [other] = true })[w] then implied = true end
    end
    if not implied then t[w] = true end
  end
  return t
end

-- What the margin says of a chunk: the parts it needs beyond those of its whole chapter.
function M.margin(book, c)
  local engine = not c.roots                                   -- the testbed and the lab have all parts
  for root in pairs(c.roots or {}) do engine = engine or not is_program(root) end
  if not engine then return nil end
  local set, beyond = M.short(book, c.with), {}
  local known = M.closure(book, book.chapters[c.chapter].whole or {})
  for w in pairs(set) do if not known[w] then beyond[w] = true end end
  return next(beyond) and M.say(beyond) or nil
end

function M.within(a, b)
  for w in pairs(a) do if not b[w] then return false end end
  return true
end

-- A place for parts: each piece of the chunk belongs to a part that may be absent where it is used. There the place is empty.
function M.is_place(book, n, user)
  for _, k in ipairs(n.parts) do if M.within(book.chunks[k].only, user.with) then return false end end
  return true
end

------------------------------------------------------------------------------------------------------------ checks
local function known(book) return "the parts are " .. table.concat(M.list(book.parts), ", ") end

function M.check(book)
  for _, u in ipairs(book.part_uses) do
    if not book.parts[u[3]] then
      book:complain(u[1], u[2], "no part is called " .. u[3], "mend the word or declare it in a chapter's goals; " .. known(book))
    end
  end
  for _, name in ipairs(M.list(book.parts)) do
    local p = book.parts[name]
    for _, need in ipairs(p.needs) do
      if not book.parts[need] then
        book:complain(p.file, p.line, "part " .. name .. " needs " .. need .. ", and no part is called so",
          "mend the word or declare it in a chapter's goals; " .. known(book))
      elseif M.closure(book, { [need] = true })[name] then
        book:complain(p.file, p.line, "part " .. name .. " needs itself, by way of " .. need, "one of the two must do without the other")
      end
    end
  end
  M.check_includes(book)
  M.check_core(book)
end

-- The engine of its own volume: the part "core" is no code, but the parts that the chapters of chapters/engine/ have. Nothing that is in it may
-- stand in a volume of methods, with one exception: the elementary functions, which the engine uses by their contract.
local beside_core = { ["elementary-functions"] = true }
function M.check_core(book)
  if not book.parts.core then return end
  for k in pairs(M.reached(book, M.closure(book, { core = true }))) do
    local c = book.chunks[k]
    if c.file:match("chapters/methods/") and not beside_core[book.chapters[c.chapter].name] then
      book:complain(c.file, c.line, "<<" .. c.name .. ">> belongs to the engine without other parts (core), and stands in a volume of methods",
        "mark it as code of a part (part=), or move it to chapters/engine/")
    end
  end
end

-- A file that is included must be there wherever the line that includes it is.
function M.check_includes(book)
  for _, c in ipairs(book.chunks) do
    for _, it in ipairs(c.items) do
      local path = it.kind == "text" and it.text:match('^%s*#%s*include%s*"([^"]+)"')
      local n = path and (book.names[path] or book.names["include/" .. path])
      if n and #n.parts > 0 then
        local missing, found
        for _, k in ipairs(n.parts) do
          local with = book.chunks[k].with
          if M.within(with, c.with) then found = true end
          missing = missing or with
        end
        if not found then
          local beyond = {}
          for w in pairs(missing) do if not c.with[w] then beyond[w] = true end end
          book:complain(c.file, it.line, path .. " is included here, but is there only with " .. M.say(M.short(book, beyond)),
            "mark the line as part of it, or let a piece of the file belong to all engines that include it")
        end
      end
    end
  end
end

-- To which part a set of marks is counted: the one that was declared last, when features meet; "" for what is in every engine.
function M.owner(book, set)
  local best
  for w in pairs(M.short(book, set)) do
    local p = book.parts[w]
    if p and (not best or p.order > best.order) then best = p end
  end
  return best and best.name or ""
end

-------------------------------------------------------------------------------------------------------- a selection
-- how = { only = "words", without = "words" } (either or none). Returns the set of parts that the engine has.
function M.choose(book, how)
  local function checked(list)
    local set = {}
    for _, w in ipairs(words(list)) do
      if not book.parts[w] then
        local near = ""
        for other in pairs(book.parts) do if other:sub(1, 3) == w:sub(1, 3) then near = " (did you mean " .. other .. "?)" end end
        io.stderr:write("tangle: no part is called ", w, near, " -- ", known(book), "\n")
        os.exit(1)
      end
      set[w] = true
    end
    return set
  end
  local chosen = {}
  if how.only then chosen = M.closure(book, checked(how.only))
  else for w in pairs(book.parts) do chosen[w] = true end end
  local absent = checked(how.without)
  for w in pairs(chosen) do                              -- what needs an absent part is absent, too
    for need in pairs(M.closure(book, { [w] = true })) do
      if absent[need] then chosen[w] = nil end
    end
  end
  return chosen
end

-- The chunks of an engine with these parts: marked as present, and reached from a file of the engine.
function M.reached(book, chosen)
  local keep = {}
  local function walk(name)
    for _, k in ipairs(book.names[name].parts) do
      local c = book.chunks[k]
      if not keep[k] and M.within(c.only, chosen) then
        keep[k] = true
        for _, it in ipairs(c.items) do if it.kind == "use" then walk(it.text) end end
      end
    end
  end
  for name in pairs(book.names) do
    if is_root(name) and not is_program(name) then walk(name) end
  end
  return keep
end

return M
