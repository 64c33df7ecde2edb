-- this-engine.lua: the first chapter of the book of a smaller engine (make book FOR=, ONLY=, WITHOUT=), as Markdown: its parts, its page of
-- stages, its interface, its price. All of it is read from what was tangled.
local Parts = require "parts"
local function plain(s) return (s:gsub("%s+", " "):gsub("[\\`%*_<>%$@%[%]{}|#~%^]", "\\%0")) end
local function code(s) return "`" .. s:gsub("%s+", " "):gsub("`", "") .. "`{.c}" end

-- What a header declares: { declaration, first sentence of the comment above it }
local function declarations(text)
  local list, comment, i = {}, nil, 1
  text = text:gsub("\\\n", " "):gsub("\n[ \t]*#[^\n]*", "\n"):gsub("^#[^\n]*", ""):gsub('extern%s+"C"%s*{', ""):gsub("WF_BEGIN_C", ""):gsub("WF_END_C", ""):gsub("_Pragma%b()", ""):gsub("__attribute__%s*%b()", "")
  text = text:gsub("(;[ \t]*)/%*.-%*/", "%1")                       -- what stands behind a declaration
  while i <= #text do
    local a, b, c = text:find("^%s*/%*(.-)%*/", i)
    if a then comment, i = c:gsub("\n%s*%*?", " "):gsub("^%s+", ""), b + 1 goto next end
    a, b = text:find("^\n%s*\n", i)
    if a then comment, i = nil, b goto next end
    a, b, c = text:find("^%s*([%a_][^;{}/]-)%s*;", i)                -- a declaration
    if a then
      if c:match("%)%s*[%u_]*$") and not c:match("^typedef") and not c:match("=") then
        list[#list + 1] = { c, comment and (comment:match("^(.-[%.%?])%s+%u") or comment):gsub("%s+$", ""):gsub("([^%.%?])$", "%1.") }
      end
      i = b + 1
      goto next
    end
    a, b = text:find("^%s*[^;{}]*%b{}[^;\n]*;?", i)                   -- a type, or a function that stands in the header
    if a then i = b + 1 else i = i + 1 end
    ::next::
  end
  return list
end

return function(book, chosen, keep, roots, called, bytes)
  local t = { "# This engine {#sec:this-engine}\n\n" }
  local function put(...) t[#t + 1] = string.format(...) end
  local files, lines, folders = 0, 0, {}
  for _, r in ipairs(roots) do
    local n = 0
    for _, l in ipairs(r.lines) do if l.text:match("%S") then n = n + 1 end end
    local dir = r.name:match("^(.-)/")
    if not folders[dir] then folders[dir] = { 0, 0 }; folders[#folders + 1] = dir end
    folders[dir][1], folders[dir][2] = folders[dir][1] + 1, folders[dir][2] + n
    files, lines = files + 1, lines + n
  end
  local parts = Parts.list(chosen)
  put("This is the book of %s. It has the chapters of which that engine contains code, without the sections of parts that it lacks; their numbers are those of the whole book, so a number that no page here has is of a chapter that this engine does without.\n\n", called and "an engine " .. plain(called) or "one engine")
  put(#parts > 0 and "Its parts are %s.\n\n" or "It has none of the parts that can be left out.%s\n\n", #parts > 0 and (#parts > 1 and table.concat(parts, ", ", 1, #parts - 1) .. " and " or "") .. parts[#parts] or "")
  put("## A step {#sec:this-step}\n\n")
  local step, stages = roots["engine/step.c"], {}
  if step then
    local text, inside = {}, false
    for _, l in ipairs(step.lines) do
      if l.text:match("wfStageTable%[%]%s*=") then inside = true
      elseif inside and l.text:match("^};") then break
      elseif inside then text[#text + 1] = l.text end
    end
    for name, what, run in table.concat(text, "\n"):gmatch('{%s*"([^"]*)",%s*"([^"]*)",%s*([%w_]+)') do stages[#stages + 1] = { name, what, run } end
  end
  if #stages > 0 then
    put("A step goes through these %d stages, in this order. One that nothing asks for in a step is passed over.\n\n| stage | what it does | function |\n|-----|------------|-------|\n", #stages)
    for _, s in ipairs(stages) do put("| %s | %s | %s |\n", plain(s[1]), plain(s[2]), code(s[3])) end
  else put("It has no world, and so no step: its functions are called one by one.\n") end
  put("\n## Its interface {#sec:this-interface}\n\n")
  local count, api = 0, {}
  for _, r in ipairs(roots) do
    if r.name:match("^include/.*%.h$") then
      local text = {}
      for i, l in ipairs(r.lines) do text[i] = l.text end
      local list = declarations(table.concat(text, "\n"):gsub("^/%*.-%*/", "") .. "\n")
      if #list > 0 then
        api[#api + 1] = "### " .. code((r.name:gsub("^include/", ""))) .. " {#sec:this-" .. r.name:gsub("[^%w]+", "-") .. "}\n\n"
        for _, d in ipairs(list) do api[#api + 1] = "- " .. code(d[1]) .. (d[2] and ": " .. plain(d[2]) or "") .. "\n" end
        api[#api + 1] = "\n"
        count = count + #list
      end
    end
  end
  put("%d functions. Types and constants stand in the chapters.\n\n", count)
  t[#t + 1] = table.concat(api)
  put("## Its price {#sec:this-price}\n\n%d files with %d lines of C that are not blank%s.\n\n| folder | files | lines |\n|---|--:|--:|\n", files, lines, bytes and "; compiled, " .. plain(bytes) or "")
  table.sort(folders)
  for _, d in ipairs(folders) do put("| `%s/` | %d | %d |\n", d, folders[d][1], folders[d][2]) end
  local by = {}
  for i, c in ipairs(book.chunks) do
    if keep[i] then
      local owner, n, text = Parts.owner(book, c.with), 0, false
      for _, it in ipairs(c.items) do
        if it.kind == "nl" then n, text = n + (text and 1 or 0), false
        elseif it.kind == "text" and it.text:match("%S") then text = true end
      end
      by[owner] = (by[owner] or 0) + n
    end
  end
  put("\n| part | lines |\n|---|--:|\n| in every engine | %d |\n", by[""] or 0)
  for _, p in ipairs(parts) do if by[p] and by[p] > 0 then put("| %s | %d |\n", p, by[p]) end end
  return table.concat(t)
end
