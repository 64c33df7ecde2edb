-- book.lua: reads noweb's markup stream into a model of the book that every other tool of the loom shares.
-- The stream is line based ("@begin code 3", "@defn name", "@text ...", "@use name", "@nl", "@end code 3").
--
--   local Book = require "book"
--   local book = Book.read(io.stdin)
--   book.chapters[i]  { file, name ("soft"), label (what its file says of its number), of ("soft", if it is soft.figures or soft.lab) }
--   book.chunks[i]    { name, chapter (index), file, line, part, items = { {kind="text"|"use"|"nl", text, line} } }
--   book.names[name]  { parts = {chunk indices}, uses = { {chunk, line} } }
--   book.parts[word]  { needs = {words}, file, line }   what may be left out of an engine (parts.lua); chunk.only = {words}
--
-- Every message has the form  file:line: what is wrong -- what to do  and is collected, so that one run tells all.
local Parts = require "parts"
local Book = {}
Book.__index = Book
local home = os.getenv "WEFT_ROOT" or (arg[0]:match("^(.*/)") or "./") .. ".."

function Book.is_root(name) return name:match("^[%w_%-%./]+%.%a+$") ~= nil and name:find("/") ~= nil end

-- A chapter's file is NN-NAME.nw (an appendix: a capital letter for NN), an exercise that somebody solved NAME.nw. The name is what it is known
-- by, the number is for listings; book/plan.tsv says which number is printed. NAME.figures and NAME.lab belong to the chapter NAME.
function Book.name_of(file)
  local base = file:match("([^/]+)%.nw$") or file
  local label, name = base:match("^(%d+)%-(.+)$")
  if not name then label, name = base:match("^(%u)%-(.+)$") end
  if not name then label, name = base:match("^(%u?%d+%.%d+)%-(.+)$") end
  name = name or base
  return name, label, name:match("^(.+)%.figures$") or name:match("^(.+)%.lab$")
end

function Book:complain(file, line, what, remedy)
  self.errors[#self.errors + 1] = string.format("%s:%d: %s -- %s", file, line, what, remedy)
end

function Book:finish()          -- print what was collected, stop when there was anything
  if #self.errors == 0 then return end
  for _, e in ipairs(self.errors) do io.stderr:write(e, "\n") end
  io.stderr:write(string.format("%d error%s in the chapters.\n", #self.errors, #self.errors == 1 and "" or "s"))
  os.exit(1)
end

function Book.read(stream)
  local self = setmetatable({ chapters = {}, chunks = {}, names = {}, errors = {}, parts = {}, part_uses = {} }, Book)
  local chapter, chunk, line, kind, open
  local reader, said                       -- of the marks in the documentation, and its line so far
  for l in stream:lines() do
    local key, rest = l:match("^@(%S+) ?(.*)$")
    if key == "file" then
      local name, label, of = Book.name_of(rest)
      chapter = { file = rest, name = name, label = label or "X" .. #self.chapters + 1, of = of, index = #self.chapters + 1 }
      self.chapters[chapter.index] = chapter
      line, open = 1, nil
      reader, said = Parts.reader(self, chapter), ""
    elseif key == "begin" then
      kind = rest:match("^%a+")
      said = ""
      if kind == "code" then
        if open then                        -- code follows code with no word of documentation: the @ between them is missing
          self:complain(chapter.file, line, "a chunk begins here, but <<" .. open .. ">> was not ended",
            "write a line with @ alone where its code ends; what stands below it is taken for code until then")
        end
        chunk = { chapter = chapter.index, file = chapter.file, line = line, items = {}, index = #self.chunks + 1, only = reader.here(), absent = reader.absent() }
        self.chunks[chunk.index] = chunk
      end
    elseif key == "defn" and kind == "code" then
      chunk.name = rest
      local name = self.names[rest] or { parts = {}, uses = {} }
      self.names[rest] = name
      name.parts[#name.parts + 1] = chunk.index
      chunk.part = #name.parts
    elseif key == "use" and kind == "code" then
      chunk.items[#chunk.items + 1] = { kind = "use", text = rest, line = line }
      local name = self.names[rest] or { parts = {}, uses = {} }
      self.names[rest] = name
      name.uses[#name.uses + 1] = { chunk = chunk.index, line = line }
    elseif key == "text" and kind == "code" then
      chunk.items[#chunk.items + 1] = { kind = "text", text = rest, line = line }
    elseif kind == "docs" and (key == "text" or key == "use") then said = said .. rest
    elseif key == "nl" then
      if kind == "docs" then
        reader.line(line, said)
        said = ""
      end
      if kind == "code" then chunk.items[#chunk.items + 1] = { kind = "nl", line = line } end
      line = line + 1
    elseif key == "index" and rest:match("^nl") then
      line = line + 1
    elseif key == "fatal" then
      self:complain(chapter and chapter.file or "?", line or 1, "noweb cannot read this line: " .. rest,
        "in prose write [[code]] around double angle brackets, or put an @ before them")
    elseif key == "end" then
      open = kind == "code" and chunk.name or nil
      kind = nil
    end
  end
  self:group()
  Parts.close(self)
  return self
end

-- A chapter that has + before its name in the plan is read together with the one above it: until a part of the engine can stand without the
-- other, each may use what the other defines. chapter.last is the last file of the group.
function Book:group()
  local plan, joined = io.open(home .. "/book/plan.tsv"), {}
  if plan then
    for l in plan:lines() do
      local name = l:match("^%+([^\t]+)")
      if name then joined[name] = true end
    end
    plan:close()
  end
  local last = #self.chapters
  for i = #self.chapters, 1, -1 do
    local c = self.chapters[i]
    c.last = last
    if not c.of and not joined[c.name] then last = i - 1 end
  end
end

------------------------------------------------------------------------------------------------------------- checks
-- Undefined, unused, recursive chunks, and chunks that are used before the chapter that defines them.
function Book:check_chunks()
  local solved = {}
  for _, c in ipairs(self.chapters) do
    local other = solved[c.name]
    if other then
      self:complain(c.file, 1, "a chapter " .. c.name .. " is here and in " .. other, "give one of the two another name; of an exercise's starter, somebody's chapter and the solution take one")
    end
    solved[c.name] = c.file
  end
  for name, n in pairs(self.names) do
    if #n.parts == 0 then
      for _, u in ipairs(n.uses) do
        if not self:is_later(name, u) then self:complain(self.chunks[u.chunk].file, u.line, "chunk <<" .. name .. ">> is used but nowhere defined",
          "define it with <<" .. name .. ">>=, mend its spelling" .. (self:nearest(name)) ..
          ", or, if a shift was meant, write @<< and @>>") end
      end
    elseif Book.is_root(name) and (name:match("^/") or ("/" .. name .. "/"):find("/../", 1, true)) then
      local c = self.chunks[n.parts[1]]
      self:complain(c.file, c.line, "the file <<" .. name .. ">> lies outside of the tree", "name a file below the tree that is tangled, such as lab/name.c")
    elseif #n.uses == 0 and not Book.is_root(name) then
      local c = self.chunks[n.parts[1]]
      self:complain(c.file, c.line, "chunk <<" .. name .. ">> is defined but never used",
        "use it in a chunk, delete it, or name it as a file (dir/name.c)")
    else
      local defined = self.chunks[n.parts[1]].chapter
      for _, u in ipairs(n.uses) do
        local c = self.chunks[u.chunk]
        if self.chapters[c.chapter].last < defined and not Parts.is_place(self, n, c) then
          self:complain(c.file, u.line, "chunk <<" .. name .. ">> is used here but first defined later, in " ..
            self.chapters[defined].file, "define its first part in this chapter or an earlier one, or move the use")
        end
      end
    end
  end
  self:check_cycles()
  self:check_lines()
  Parts.check(self)
  table.sort(self.errors)
end

-- Is it a chunk of a chapter of the book that was not read, since the program is made up to an earlier one? A solution's is none.
local later
function Book:is_later(name, use)
  if not later then
    later = {}
    local p = io.popen("ls '" .. home .. "'/chapters/*/*.nw 2>/dev/null")
    for file in p:lines() do
      if not file:match("/solutions/") and not file:match("/exercises/") then
        later[file:match("[^/]+$")] = true
        for l in io.lines(file) do later[l:match("^<<.*>>=") or ""] = true end
      end
    end
    p:close()
  end
  return later["<<" .. name .. ">>="] and later[self.chunks[use.chunk].file:match("[^/]+$")]
end

-- A chunk reference must stand alone on its line: the generated files put the chunk's name there as a comment.
function Book:check_lines()
  for _, c in ipairs(self.chunks) do
    local line_has_text, line_has_use = false, false
    for _, it in ipairs(c.items) do
      if it.kind == "nl" then line_has_text, line_has_use = false, false
      elseif it.kind == "use" then
        if line_has_text or line_has_use then self:alone(c, it) end
        line_has_use = true
      elseif it.text:match("%S") then
        if line_has_use then self:alone(c, it) end
        line_has_text = true
      end
    end
  end
end

-- Has a chunk a piece (of those in keep; nil: of all)? A line that uses one without is not tangled.
function Book:is_empty(name, keep)
  for _, p in ipairs(self.names[name].parts) do
    if not keep or keep[p] then return false end
  end
  return true
end

function Book:alone(c, it)
  self:complain(c.file, it.line, "a chunk reference shares its line with other text",
    "put the reference on a line of its own; if a shift was meant, write @<< and @>>")
end

function Book:check_cycles()
  local state = {}
  local function visit(name, trail)
    if state[name] == "done" then return end
    local n = self.names[name]
    if #n.parts == 0 then return end
    if state[name] == "open" then
      local c = self.chunks[n.parts[1]]
      self:complain(c.file, c.line, "chunk <<" .. name .. ">> contains itself: " .. table.concat(trail, " -> ") .. " -> " .. name,
        "break the circle: one of these chunks must not use the next")
      return
    end
    state[name] = "open"
    for _, p in ipairs(n.parts) do
      for _, it in ipairs(self.chunks[p].items) do
        if it.kind == "use" then
          trail[#trail + 1] = name
          visit(it.text, trail)
          trail[#trail] = nil
        end
      end
    end
    state[name] = "done"
  end
  local names = {}
  for name in pairs(self.names) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do visit(name, {}) end
end

-- The defined chunk whose name is closest to a misspelled one, as a hint for the message.
function Book:nearest(name)
  local best, best_score = nil, 0
  local words = {}
  for w in name:lower():gmatch("%w+") do words[w] = true end
  for other, n in pairs(self.names) do
    if #n.parts > 0 then
      local hit, all = 0, 0
      for w in other:lower():gmatch("%w+") do all = all + 1; if words[w] then hit = hit + 1 end end
      local score = hit / (all + 1)
      if hit > 0 and (score > best_score or (score == best_score and best and other < best)) then best, best_score = other, score end
    end
  end
  return best and best_score >= 0.4 and " (did you mean <<" .. best .. ">>?)" or ""
end

return Book
