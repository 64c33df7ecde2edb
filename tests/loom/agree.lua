-- agree.lua: the numbers that weave.lua gave are the numbers on the pages and in the TeX, and every definition has its anchor.
--   lua agree.lua WEAVE HTML TEX
local weave, html, tex = arg[1], arg[2], arg[3]
local db = dofile(weave .. "/db.lua")
local function read(path)
  local f = io.open(path, "rb")
  if not f then return "" end
  local s = f:read("a")
  f:close()
  return s
end
local pages, texts = {}, {}
local function page(name) pages[name] = pages[name] or read(html .. "/" .. name) return pages[name] end
local function text(name)
  local base = name:gsub("%.html$", "")
  texts[base] = texts[base] or read(tex .. "/" .. base .. ".tex")
  return texts[base]
end
local errors, counts = {}, {}
local function want(kind, where, haystack, needle)
  counts[kind] = (counts[kind] or 0) + 1
  if not haystack:find(needle, 1, true) then errors[#errors + 1] = where .. ": not found: " .. needle end
end
for id, c in pairs(db.chunks) do
  want("chunks", c.page, page(c.page), 'id="' .. id .. '"><figcaption><a class="num" href="#' .. id .. '">' .. c.num .. "</a>")
  if not c.online then want("chunks", c.page .. " (TeX)", text(c.page), "\\wChunk{" .. id .. "}{" .. c.num .. "}") end
end
for id, l in pairs(db.labels) do
  local h, t = page(l.page), text(l.page)
  local want, b = want, "<b>"
  if l.online then                                    -- print has not got it
    local all = want
    want = function(kind, where, ...) if not where:match("TeX") then all(kind, where, ...) end end
    b = '<b class="online">'
  end
  if l.kind == "eq" then
    want("equations", l.page, h, '<a class="eqn" href="#' .. id .. '">(' .. l.num .. ")</a>")
    want("equations", l.page .. " (TeX)", t, "\\wLabel{" .. id .. "}\\begin{equation}\\tag*{\\wTag{" .. l.num .. "}")
  elseif l.kind == "fig" then
    want("figures", l.page, h, 'id="' .. id .. '"'); want("figures", l.page, h, b .. "Figure " .. l.num .. ".</b>")
    want("figures", l.page .. " (TeX)", t, "\\wLabel{" .. id .. "}"); want("figures", l.page .. " (TeX)", t, "\\wCaption{Figure~" .. l.num .. "}")
  elseif l.kind == "tbl" then
    want("tables", l.page, h, 'id="' .. id .. '"'); want("tables", l.page, h, b .. "Table " .. l.num .. ".</b>")
    want("tables", l.page .. " (TeX)", t, "\\wLabel{" .. id .. "}"); want("tables", l.page .. " (TeX)", t, "{Table~" .. l.num .. "}")
  elseif l.kind == "ex" then
    want("exercises", l.page, h, 'id="' .. id .. '"><p class="title">Exercise ' .. l.num)
    want("exercises", l.page .. " (TeX)", t, "\\wLabel{" .. id .. "}Exercise " .. l.num .. "}")
  elseif l.num:find(".", 1, true) then
    local alone = l.num:match("%.[FL]$") and "Section " or ""      -- the figures or the lab of a chapter: a page of its own
    want("sections", l.page, h, 'id="' .. id .. '"><span class="secnum">' .. alone .. l.num .. "</span>")
  end
end
-- LaTeX counts sections by itself: its counts must come out the same
for _, e in ipairs(db.entries) do
  if e.page then
    local s, ss = 0, 0
    local got = {}
    for command, id in text(e.page):gsub("\\stepcounter{(%a*section)}", "\\%1[]{\\wLabel{}"):gmatch("\\(%a*section)%b[]{\\wLabel{([^}]*)}") do
      if command == "section" then s, ss = s + 1, 0 elseif command == "subsection" then ss = ss + 1 end
      if id ~= "" then got[id] = e.num .. "." .. s .. (command == "subsection" and "." .. ss or "") end
    end
    for id, num in pairs(got) do
      counts.sections = (counts.sections or 0) + 1
      local l = db.labels[id]
      if l and l.num ~= num then errors[#errors + 1] = e.page .. ": section " .. id .. " is " .. l.num .. " in HTML and " .. num .. " in TeX" end
    end
  end
end
for name, list in pairs(db.idents) do
  for _, d in ipairs(list) do
    local p, id = d.target:match("^(.-)#(.*)$")
    want("definitions", p, page(p), 'id="' .. id .. '"')
  end
end
for i, e in ipairs(errors) do if i <= 30 then print(e) end end
local list = {}
for k, n in pairs(counts) do list[#list + 1] = n .. " " .. k end
table.sort(list)
print("compared: " .. table.concat(list, ", ") .. "; " .. #errors .. " errors")
os.exit(#errors == 0)
