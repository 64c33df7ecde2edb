-- filter.lua: pandoc's side of the weave (pandoc >= 2.17): one chapter's Markdown to a page of HTML or a chapter of TeX.
-- Metadata: weave (directory of db.lua), base (chapter), root (of the repository), teacher, missing (draw a box for figures
-- that are not there), figures (directory with figures/ and plots/), data (directory for the page's previews).
local dir = PANDOC_SCRIPT_FILE:match("^(.*/)") or "./"
package.path = dir .. "?.lua;" .. package.path
local Code, Csv = require "weave-code", require "csv"
local html, tex = FORMAT:match("html") ~= nil, FORMAT:match("latex") ~= nil
local esc = html and Code.html or Code.tex
local db, mine, bib, here, weave, root, has_testbed, teacher, missing_allowed, figures_dir, data_dir
local stringify = pandoc.utils.stringify
local errors, previews, cited, cited_order = {}, {}, {}, {}

local function raw(s) return pandoc.RawInline(html and "html" or "latex", s) end
local function rawb(s) return pandoc.RawBlock(html and "html" or "latex", s) end
local function fail(...) errors[#errors + 1] = string.format(...) end
local function href(page, id) return Code.href(db, page, here, id) end

------------------------------------------------------------------------------------------------------ cross references
local called, paged = {}, {}                          -- volumes that this chapter has named, sections whose page it has told
local function volume_called(name) for _, v in ipairs(db.volumes) do if v.name == name then return v.short end end end
local function ref(id)
  local l = db.labels[id] or db.labels[id:sub(1, 1):lower() .. id:sub(2)]
  if not l then return nil end
  if not db.labels[id] then id = id:sub(1, 1):lower() .. id:sub(2) end
  local text = Code.ref_text(l)
  if l.gone then return raw(html and '<span title="not in this engine">' .. Code.html(text) .. "</span>" or (Code.tex(text):gsub(" ", "~", 1))) end
  if html then
    return raw(string.format('<a class="xref %s" href="%s"%s>%s</a>', l.kind, href(l.page, id),
      l.title and ' title="' .. Code.html(l.title) .. '"' or "", (Code.html(text):gsub(" ", "\u{a0}", 1))))
  end
  text = Code.tex(text):gsub(" ", "~", 1)
  if Code.far(db, l.page) then                          -- in another volume, which the first one of a chapter names
    local volume = db.volume_of[l.page]
    local first = not called[volume]
    called[volume] = true
    return raw((l.online and text or "\\wFar{" .. volume .. "}{" .. id .. "}{" .. text .. "}") .. (first and " of \\emph{" .. Code.tex(volume_called(volume)) .. "}" or ""))
  end
  -- the first volume is read on paper: the first mention of a section of another chapter tells its page (a chapter's is soon found)
  local told = l.online or not (mine.base == "glossary" or text:match("^Section")) or l.page == here or db.mine ~= db.volumes[1].name or mine.base ~= "glossary" and paged[id]
  paged[id] = true
  return raw(l.online and text or "\\hyperlink{" .. id .. "}{" .. text .. "}" .. (told and "" or "\\wOn{" .. id .. "}"))
end

local function source(id)
  if not cited[id] then cited[id] = true; cited_order[#cited_order + 1] = id end
  return bib[id] or { author = id, year = "?", key = id }
end
local function linked(id, text)
  if html then return '<a class="cite" href="' .. "#ref-" .. id .. '">' .. Code.html(text) .. "</a>" end
  return "\\hyperlink{ref-" .. id .. "}{" .. Code.tex(text) .. "}"
end
local function cite(el)
  local first = el.citations[1]
  local kind = first.id:match("^(%a+):")
  if kind and Code.kind_name[kind:lower()] then
    local r = pandoc.List {}
    for i, c in ipairs(el.citations) do
      if i > 1 then r:insert(pandoc.Str(i == #el.citations and " and " or ", ")) end
      r:extend(c.prefix)
      if #c.prefix > 0 then r:insert(pandoc.Space()) end
      r:insert(ref(c.id) or raw(esc(c.id .. "?")))
      r:extend(c.suffix)
    end
    return r
  end
  local r = pandoc.List {}
  if first.mode == "AuthorInText" and #el.citations == 1 then
    local b = source(first.id)
    r:insert(raw(linked(first.id, b.author .. " (" .. b.year)))
    if #first.suffix > 0 then r:insert(pandoc.Str(", ")); r:extend(first.suffix) end
    r:insert(raw(linked(first.id, ")")))
    return r
  end
  r:insert(pandoc.Str("("))
  for i, c in ipairs(el.citations) do
    local b = source(c.id)
    if i > 1 then r:insert(pandoc.Str("; ")) end
    r:extend(c.prefix)
    if #c.prefix > 0 then r:insert(pandoc.Space()) end
    r:insert(raw(linked(c.id, c.mode == "SuppressAuthor" and b.year or b.author .. " " .. b.year)))
    r:extend(c.suffix)
  end
  r:insert(pandoc.Str(")"))
  return r
end

------------------------------------------------------------------------------------------- code in prose, linked
local function inline_code(el)
  local text = el.text
  local c_code = el.classes:includes("c") or text:match("^[%a_][%w_]*$") or text:match("^[%a_][%w_]*%(")
  local toks = Code.lex(text)
  local line, previous = {}, nil
  for _, t in ipairs(toks) do
    local idents = c_code and t[1] == "id" and previous ~= "." and previous ~= "->" and db.idents[t[2]]
    local target = idents and idents[1]
    if target and not (target.static and #idents > 1) then
      line[#line + 1] = { "ref", t[2], target.target, target.kind .. " " .. t[2] .. ", chunk " .. target.num }
    elseif t[1] == "id" then line[#line + 1] = { "", t[2] }
    else line[#line + 1] = { "", t[2] } end
    if t[1] ~= "sp" then previous = t[2] end
  end
  if html then return raw("<code>" .. Code.line_html(db, line, here) .. "</code>") end
  local s = {}                                        -- may break after _ ( , and at lower|Upper
  for _, t in ipairs(line) do
    local x = Code.tex_code(t[2]):gsub("\\_", "\\_\\wBreak{}"):gsub("\\ ", " "):gsub("(%l%l)(%u%l)", "%1\\wBreak{}%2"):gsub("([,/%(%.])", "%1\\wBreak{}")
    s[#s + 1] = t[1] == "ref" and not Code.online(db, t[3]) and "\\wId{" .. Code.tex_id(t[3]:match("#(.*)$")) .. "}{" .. x .. "}" or x
  end
  return raw("\\wInline{" .. table.concat(s) .. "}")
end

---------------------------------------------------------------------------------------------------------------- chunks
local function chunk_link(id, named)
  local c = db.chunks[id]
  if html then
    return '<a class="cref" href="' .. href(c.page, id) .. '">' .. (named and '<span class="nm">' .. Code.name(db, c.name, "html") .. "</span> " or "") .. "<b>" .. c.num .. "</b></a>"
  end
  return (named and "\\wName{" .. Code.name(db, c.name, "tex") .. "}~" or "") .. ((c.online or Code.far(db, c.page)) and c.num or "\\wRef{" .. id .. "}{" .. c.num .. "}")
end

-- In print those that are printed in this volume: the pages have all.
local function near(ids)
  if html then return ids end
  local r = {}
  for _, id in ipairs(ids) do if not Code.far(db, db.chunks[id].page) and not db.chunks[id].online then r[#r + 1] = id end end
  return r
end
-- Where code may break over pages: for each line what is behind \wL (book.tex has their penalties). N: never; G: gladly, between two functions;
-- nothing: between two things; S: between two statements of a long function; D: deeper in it.
local function breaks(lines)
  local n, glue, state, depth, round, comment = #lines, {}, {}, 0, 0, false
  for i, line in ipairs(lines) do
    local rest, code = (line:gsub('"[^"]*"', ""):gsub("'[^']*'", "")) .. " ", ""
    repeat
      local a, b = rest:find(comment and "*/" or "/* ", 1, true)
      if not comment then code = code .. rest:sub(1, (a or 0) - 1) end
      if a then comment, rest = not comment, rest:sub(b + 1) end
    until not a
    depth = code:match("^}") and 0 or depth + select(2, code:gsub("{", "")) - select(2, code:gsub("}", ""))
    round = math.max(0, round + select(2, code:gsub("%(", "")) - select(2, code:gsub("%)", "")))
    -- what a comment, a bracket or a brace begins goes on
    state[i] = (comment or round > 0 or code:match("[{\\]%s*$") or line:match("%S") and not code:match("%S")) and "N" or depth
  end
  for i = 1, n - 1 do if lines[i + 1]:match("^%s*{?%s*$") or lines[i + 1]:match("^%s*}") then state[i] = "N" end end
  local first = 1                                       -- of the thing that line i is in
  for i = 1, n do
    if i == n or state[i] ~= "N" and state[i] <= 0 then
      local last, left = lines[i]:match("%S") and i or i - 1, 0
      for k = i - 1, first, -1 do                       -- a thing of six lines is not broken; two lines and their braces are left at the least
        if lines[k + 1]:match("^%s*[^%s}]") then left = left + 1 end
        glue[k] = (last - first < 6 or k - first < 2 or left < 2 or state[k] == "N") and "N" or state[k] <= 1 and "S" or "D"
      end
      glue[i], first = lines[i]:match("%S") and "" or "G", i + 1
    end
  end
  for i = 1, n do if i == 1 or i == 2 and n > 3 or i >= n - 2 then glue[i] = "N" end end
  return glue
end
local function chunk(k)
  local c = mine.chunks[k]
  local feet = {}
  local function list(label, ids, named, most)
    if #ids == 0 then return end
    local r = {}
    ids = near(ids)
    if #ids == 0 then return end
    for i, id in ipairs(ids) do
      if most and i > most then r[#r + 1] = "\u{2026}" break end
      r[#r + 1] = chunk_link(id, named)
    end
    feet[#feet + 1] = (html and "<span><i>" .. label .. "</i> " or label .. " ") .. table.concat(r, ", ") .. (html and "</span>" or "")
  end
  list("Continues", { c.previous })
  list("Continued in", { c.following })
  if c.part == 1 then list("Used in", c.used, true, 8) end
  if #c.eqs > 0 then
    local r = {}
    for _, id in ipairs(c.eqs) do
      local l = db.labels[id]
      r[#r + 1] = html and '<a class="xref eq" href="' .. href(l.page, id) .. '">(' .. l.num .. ")</a>" or
        (l.online or Code.far(db, l.page)) and "(" .. l.num .. ")" or "\\hyperlink{" .. id .. "}{(" .. l.num .. ")}"
    end
    feet[#feet + 1] = (html and "<span><i>Equations</i> " or "Equations ") .. table.concat(r, ", ") .. (html and "</span>" or "")
  end
  if #c.defs > 0 then
    local r = {}
    for _, d in ipairs(c.defs) do
      local users, uses = {}, near(d.uses)
      if not html then                                  -- print: by other chapters, and no more than eight names
        if #r == 8 then r[9] = "\u{2026}" break end
        local far = {}
        for _, u in ipairs(uses) do if db.chunks[u].page ~= here then far[#far + 1] = u end end
        uses = far
        if #uses == 0 then goto next end
      end
      for i, u in ipairs(uses) do
        if i > (html and 6 or 3) then users[#users + 1] = "\u{2026}" break end
        users[#users + 1] = chunk_link(u)
      end
      r[#r + 1] = (html and '<a href="#' .. d.anchor .. '"><code>' .. d.name .. "</code></a>" or "\\wId{" .. Code.tex_id(d.anchor) .. "}{\\wFootCode{" .. Code.tex(d.name):gsub("\\_", "\\_\\wBreak{}") .. "}}") ..
        (#users > 0 and " (" .. table.concat(users, " ") .. ")" or "")
      ::next::
    end
    if #r > 0 then feet[#feet + 1] = (html and "<span><i>Defines</i> " or "Defines ") .. table.concat(r, ", ") .. (html and "</span>" or "") end
  end
  if html then
    local rows = {}
    for i, l in ipairs(c.lines) do rows[i] = Code.line_html(db, l, here) end
    local uses = c.pieces > 1
    for _, l in ipairs(c.lines) do for _, t in ipairs(l) do uses = uses or t[1] == "use" end end
    local assembled = uses and ' <a class="asm" href="' .. href(db.chunks[c.first].page, c.first) .. '" title="this chunk with all its pieces, and all chunks in it opened">assembled</a>' or ""
    local whole = c.source and ' <a class="whole" href="' .. c.source .. '">whole file</a>' or ""
    local body = "<pre><code>" .. table.concat(rows, "\n") .. "\n</code></pre>"
    local head = '<figcaption><a class="num" href="#' .. c.id .. '">' .. c.num .. '</a> <span class="name">\u{27e8}' .. Code.name(db, c.name, "html") ..
      "\u{27e9}" .. (c.part > 1 and '<span class="pl">+</span>' or "") .. "\u{2261}</span>" .. (c.only and '<span class="only">only with ' .. Code.html(c.only) .. "</span>" or "") .. assembled .. whole .. '<span class="src">' .. Code.html(c.file) .. ":" .. c.line .. "</span></figcaption>"
    local foot = #feet > 0 and "<footer>" .. table.concat(feet, " ") .. "</footer>" or ""
    previews[#previews + 1] = { c.id, head .. body }
    return rawb('<figure class="chunk" id="' .. c.id .. '">' .. head .. "\n" .. body .. "\n" .. foot .. "</figure>")
  end
  local rows, last, text = {}, c.printed or #c.lines, {}
  for i = 1, last do
    local t = {}
    for k, token in ipairs(c.lines[i]) do t[k] = token[2] end
    text[i] = table.concat(t)
  end
  local glue = breaks(text)
  for i = 1, last do rows[i] = "\\wL" .. glue[i] .. "{" .. Code.line_tex(db, c.lines[i]) .. "}" end
  if c.printed then rows[#rows + 1] = "\\wMore{" .. #c.lines - last .. "}{" .. Code.tex(here) .. "}" end
  return rawb(string.format("\\wChunk{%s}{%s}{%s}{%s}{%s}{%s}%%\n%s\n\\wFoot{%s}", c.id, c.num, Code.name(db, c.name, "tex"),
    c.part > 1 and "\\wPlus" or "", (c.only and "only with \\textbf{" .. Code.tex(c.only) .. "}, " or "") .. Code.tex(c.file) .. ":" .. c.line, c.part == 1 and Code.tex(c.name:lower():gsub("[^%w ]", "")) or "",
    table.concat(rows, "\n"), table.concat(feet, ". ") .. (#feet > 0 and "." or "")))
end

------------------------------------------------------------------------------------------------------------- equations
local function inlines(list)
  local i, r = 1, pandoc.List {}
  while i <= #list do
    local m = list[i]
    if m.t == "Math" and m.mathtype == "DisplayMath" then
      local j = i + 1
      while list[j] and (list[j].t == "Space" or list[j].t == "SoftBreak") do j = j + 1 end
      local id = list[j] and list[j].t == "Str" and list[j].text:match("^{#(eq:[%w_%-]+)}$")
      local l = id and db.labels[id]
      if l then
        local users = near((db.eqs[id] or {}).chunks or {})
        local links = {}
        for k, u in ipairs(users) do
          if k > 6 then links[#links + 1] = "\u{2026}" break end
          links[#links + 1] = chunk_link(u)
        end
        if html then
          m.text = m.text:gsub("\\Big[lrm]", "\\Big"):gsub("\\Bigg[lrm]", "\\Bigg")     -- pandoc does not know all of these
          r:insert(raw('<span class="eq" id="' .. id .. '"><span class="eqm">'))
          r:insert(m)
          r:insert(raw('</span><span class="eqs"><a class="eqn" href="' .. href(l.page, id) .. '">(' .. l.num .. ")</a>" ..
            (#links > 0 and '<span class="eqc" title="chunks of code that use this equation"><i>Code</i> ' .. table.concat(links, " ") .. "</span>" or "") .. "</span></span>"))
          previews[#previews + 1] = { id, m }
        else
          local few = {}
          for k = 1, math.min(#links, 3) do few[k] = links[k] end
          r:insert(raw(((db.eqs[id] or {}).code and "\\label{" .. id .. "}" or "") .. "\\wLabel{" .. id .. "}\\begin{equation}\\tag*{\\wTag{" .. l.num .. "}{" .. table.concat(few, ", ") .. (#links > 3 and ", \u{2026}" or "") .. "}}" .. m.text .. "\\end{equation}"))
        end
        i = j + 1
      else
        if html then m.text = m.text:gsub("\\Big[lrm]", "\\Big"):gsub("\\Bigg[lrm]", "\\Bigg") end
        r:insert(tex and raw("\\[" .. m.text .. "\\]") or m)
        i = i + 1
      end
    else
      r:insert(m)
      i = i + 1
    end
  end
  return r
end

---------------------------------------------------------------------------------------------- figures, plots, data
local function command_of_csv(path)
  for l in (Code.read(root .. path) or ""):gmatch("[^\n]+") do
    local c = l:match("^#%s*command:%s*(.+)$") or l:match("^#%s*(weft%-lab run .+)$")
    if c then return (c:gsub("^weft%-lab", c:match("%-double$") and "build/double/bin/weft-lab" or "build/bin/weft-lab")) end
    if not l:match("^#") then break end
  end
end
-- On which machine, if there is a clock in it: the line that tangle/machine has written.
local function machine_of_csv(path)
  for l in (Code.read(root .. path) or ""):gmatch("[^\n]+") do
    local m = l:match("^# weft %x+; [^;]+; [^;]+; (.+)$")
    if m then return m end
    if not l:match("^#") then break end
  end
end
-- Compared with golden hashes that are others now?
local function older_than_golden(path)
  local was = (Code.read(root .. path) or ""):match("\n(# golden hashes [%d%-]+)")
  return was and was ~= io.popen(root .. "tests/golden/sum.sh 2>/dev/null"):read("l")
end
local function commands_of_plot(name)
  local list, seen, machine = {}, {}, nil
  local gp = Code.read(root .. "book/plots/" .. name .. ".gp") or Code.read(weave .. "/src/plots/" .. name .. ".gp") or ""
  local function add(c) if c and not seen[c] then seen[c] = true; list[#list + 1] = c end end
  for c in gp:gmatch("#%s*command:%s*([^\n]+)") do add(c) end
  for csv in gp:gmatch("(book/data/[%w_%-]+%.csv)") do add(command_of_csv(csv)); machine = machine or machine_of_csv(csv) end
  return list, machine
end
local function command_line(list, machine)
  if #list == 0 then return "" end
  local r = {}
  for i, c in ipairs(list) do r[i] = html and "<code>" .. Code.html(c) .. "</code>" or "\\wInline{" .. Code.tex_code(c):gsub("\\ ", " ") .. "}" end
  local on = machine and (html and " on " .. Code.html(machine) or " on " .. Code.tex(machine)) or ""
  return html and '<span class="made">Measured by ' .. table.concat(r, ", ") .. on .. "</span>" or "\\wMade{Measured by " .. table.concat(r, ", ") .. on .. "}"
end

-- gnuplot writes colours; style.gp uses only these, and the page's style sheet says what they are in the dark.
local plot_roles = { ["#1f2933"] = "line", ["#87919c"] = "faint", ["#0067a5"] = "body", ["#9c4279"] = "body2", ["#a85800"] = "accent", ["#00775a"] = "good",
  ["#c4391a"] = "bad", ["#1a202c"] = "text", ["#ffffff"] = "paper", ["#000000"] = "text" }
local function inline_svg(svg, prefix, caption)
  svg = svg:gsub("^.-(<svg)", "%1"):gsub("<!%-%-.-%-%->", ""):gsub("<%?.-%?>", ""):gsub("<!DOCTYPE.->", "")
  svg = svg:gsub("<title>.-</title>", ""):gsub("<desc>.-</desc>", "")
  local w, h = svg:match('<svg[^>]-%swidth="([%d%.]+)'), svg:match('<svg[^>]-%sheight="([%d%.]+)')
  local tag = svg:match("<svg[^>]*>")
  local new = tag:gsub('%swidth="[^"]*"', ""):gsub('%sheight="[^"]*"', "")
  if not tag:find("viewBox", 1, true) and w and h then new = new:gsub("^<svg", '<svg viewBox="0 0 ' .. w .. " " .. h .. '"') end
  new = new:gsub("^<svg", '<svg role="img" aria-label="' .. Code.html(caption):gsub("%%", "%%%%") .. '"')
  svg = svg:gsub("<svg[^>]*>", function() return new end, 1)
  svg = svg:gsub('%sid="([^"]+)"', ' id="' .. prefix .. '-%1"'):gsub("%sid='([^']+)'", " id='" .. prefix .. "-%1'")
  svg = svg:gsub("url%(#", "url(#" .. prefix .. "-"):gsub("(href=[\"'])#", "%1#" .. prefix .. "-"):gsub("url%('#", "url('#" .. prefix .. "-")
  if svg:find("gnuplot", 1, true) then
    svg = svg:gsub("rgb%(%s*(%d+),%s*(%d+),%s*(%d+)%)", function(r, g, b)
      local role = plot_roles[string.format("#%02x%02x%02x", tonumber(r), tonumber(g), tonumber(b))]
      return role and "var(--mark-" .. role .. ")"
    end)
    svg = svg:gsub("(%a+)=(['\"])(black)%2", function(a, q) return (a == "fill" or a == "stroke") and a .. "=" .. q .. "var(--mark-text)" .. q end)
    svg = svg:gsub('(%a+)="(#%x%x%x%x%x%x)"', function(a, c) local role = plot_roles[c:lower()] return role and a .. '="var(--mark-' .. role .. ')"' end)
    svg = svg:gsub('font%-family="[^"]*"', "")
  end
  return svg
end

-- Figures that move: weft-figures --live has listed them, with how many handles they have and whether time changes them.
local live
local function live_row(name)
  if not live then
    live = {}
    for n, handles, moves in (Code.read(weave .. "/live.list") or ""):gmatch("(%S+) (%d+) (%d)\n") do live[n] = { handles, moves == "1" } end
  end
  return live[name]
end
-- What the page's script must know of a figure: its row or its scene, and where its code is.
local function live_data(path)
  local name, scene = path:match("^figures/(.+)%.svg$"), path:match("^scenes/(.+)%-%d+%.svg$")
  local row = name and live_row(name)
  local code = name and db.idents["figure_" .. name:gsub("%-", "_")]
  local at = code and code[1] and code[1].target
  if scene then
    local fn = ("\n" .. (Code.read(weave .. "/scenes.list") or "")):match("\n" .. scene:lower():gsub("%-", " ") .. "|([%w_]+)")
    local built = fn and db.idents[fn]
    return ' data-scene="' .. scene:gsub("%-", " ") .. '"' .. (built and built[1] and ' data-code="' .. built[1].target .. '"' or "")
  end
  if not row then return "" end
  return ' data-live="' .. name .. '"' .. (row[2] and ' data-moves="1"' or "") .. (at and ' data-code="' .. at .. '"' or "")
end

local function figure(el)
  if #el.content ~= 1 or el.content[1].t ~= "Image" then return nil end
  local im = el.content[1]
  local path, id = im.src, im.identifier
  local l = db.labels[id]
  local width = im.attributes.width
  local plot = path:match("^plots/(.+)%.svg$")
  local commands = plot and command_line(commands_of_plot(plot)) or ""
  local file
  for _, p in ipairs { figures_dir .. path, root .. path, root .. "book/" .. path } do
    local f = io.open(p, "rb")
    if f then f:close(); file = p break end
  end
  local caption_text = stringify(im.caption)
  if not file and not missing_allowed then fail("%s: figure %s was not made -- run: make figures", mine.file, path) end
  local r = pandoc.List {}
  if html then
    local picture
    if not file then picture = '<div class="missing">' .. Code.html(path) .. " is not drawn yet</div>"
    elseif path:match("%.svg$") then picture = inline_svg(Code.read(file), (id ~= "" and id or path):gsub("[^%w]+", "-"), caption_text)
    else picture = '<img src="' .. path .. '" alt="' .. Code.html(caption_text) .. '">' end
    r:insert(rawb('<figure class="fig' .. (plot and " plot" or "") .. '"' .. live_data(path) .. (im.attributes.of and ' data-of="' .. im.attributes.of .. '"' or "") .. (id ~= "" and ' id="' .. id .. '"' or "") .. '><div class="pic"' ..
      (width and ' style="width:' .. width .. '"' or "") .. ">" .. picture .. "</div><figcaption>" .. (l and (l.online and '<b class="online">' or "<b>") .. "Figure " .. l.num .. ".</b> " or "")))
    r:insert(pandoc.Plain(im.caption))
    r:insert(rawb(commands .. "</figcaption></figure>"))
  else
    local w = width and width:match("^(%d+)%%$")
    w = w and tonumber(w) / 100 or 0.8
    local body = file and "\\includegraphics[width=" .. w .. "\\linewidth]{" .. file:gsub("%.svg$", ".pdf") .. "}" or "\\wMissing{" .. Code.tex(path) .. "}"
    im.caption:insert(1, raw("\\begin{wFigure}" .. (id ~= "" and "\\wLabel{" .. id .. "}" or "") .. body .. "\n\\wCaption{" .. (l and "Figure~" .. l.num or "") .. "}{"))
    im.caption:insert(raw(commands .. "}\\end{wFigure}"))
    r:insert(pandoc.Plain(im.caption))
  end
  return r
end

local function parse_inlines(s)
  local b = pandoc.read(s, "markdown-smart").blocks[1]
  return b and b.content or pandoc.List {}
end
-- {.data file="book/data/x.csv" columns="a,b=Heading,c" where="a=1" caption="..." #tbl:x}
local function data_table(el)
  local a = el.attributes
  local rows = Csv.rows(Code.read(root .. (a.file or "")) or "")
  if #rows == 0 then
    if not missing_allowed then fail("%s: data file %s is not there or empty -- measure it with build/bin/weft-lab", mine.file, a.file or "?") end
    return rawb(html and '<div class="missing" id="' .. el.identifier .. '">' .. Code.html(a.file or "?") .. " is not measured yet</div>" or "\\wMissing{" .. Code.tex(a.file or "?") .. "}")
  end
  local header = table.remove(rows, 1)
  local at = {}
  for i, name in ipairs(header) do at[name] = i end
  local columns = {}
  if a.columns then
    for spec in (a.columns .. ","):gmatch("%s*([^,]*),") do
      local name, title = spec:match("^(.-)%s*=%s*(.*)$")
      name = name or spec
      if not at[name] then fail("%s: %s has no column '%s' -- it has: %s", mine.file, a.file, name, table.concat(header, ", "))
      else columns[#columns + 1] = { at[name], title or name } end
    end
  else for i, name in ipairs(header) do columns[i] = { i, name } end end
  local where, value = (a.where or ""):match("^%s*(.-)%s*=%s*(.-)%s*$")
  local numeric, cells = {}, {}
  for j = 1, #columns do numeric[j] = true end
  for _, row in ipairs(rows) do
    if not where or row[at[where] or 0] == value then
      local line = {}
      for j, col in ipairs(columns) do
        local cell = row[col[1]] or ""
        if cell ~= "" and cell ~= "-" and cell ~= "\u{2013}" and not tonumber(cell) then numeric[j] = false end
        line[j] = cell
      end
      cells[#cells + 1] = line
    end
  end
  local function show(cell)                            -- 1.25e-06 as 1.25 x 10^-6
    local m, e = cell:match("^(%-?[%d%.]+)[eE]([+-]?%d+)$")
    if m and tonumber(m) == 0 then return "0" end
    if not m then
      if tonumber(cell) and cell:match("^%-") then return html and "\u{2212}" .. cell:sub(2) or "$-$" .. cell:sub(2) end
      return (esc(cell):gsub("%f[%d](%d[%d%.]*)e([+-]%d%d)%f[%D]", function(digits, power)      -- in a text, too
        power = tostring(math.tointeger(tonumber(power)))
        return html and digits .. "\u{a0}\u{b7}\u{a0}10<sup>" .. power:gsub("^%-", "\u{2212}") .. "</sup>" or "$" .. digits .. "\\cdot10^{" .. power .. "}$"
      end))
    end
    e = tostring(math.tointeger(tonumber(e)))
    if html then return Code.html(m:gsub("^%-", "\u{2212}")) .. "\u{a0}\u{b7}\u{a0}10<sup>" .. e:gsub("^%-", "\u{2212}") .. "</sup>" end
    return "\\mbox{$" .. m .. "\\cdot10^{" .. e .. "}$}"
  end
  local id, l = el.identifier, db.labels[el.identifier]
  local command, machine = command_of_csv(a.file), machine_of_csv(a.file)
  local r = pandoc.List {}
  local caption = pandoc.Plain(pandoc.List(pandoc.walk_block(pandoc.Plain(parse_inlines((a.caption or "") .. (older_than_golden(a.file) and " Measured before the last change of arithmetic or scenes." or ""))), { Cite = cite, Code = inline_code }).content))
  if html then
    local t = { '<div class="tbl"' .. (id ~= "" and ' id="' .. id .. '"' or "") .. '><table class="data"><thead><tr>' }
    for j, col in ipairs(columns) do
      local most = 0                                   -- sentences need more than a word's width
      for _, line in ipairs(cells) do most = math.max(most, utf8.len(line[j]) or #line[j]) end
      t[#t + 1] = "<th" .. (numeric[j] and ' class="n"' or most > 24 and string.format(' style="min-width:%.1fem"', math.min(13, 1.1 * math.sqrt(most))) or "") .. ">" .. Code.html(col[2]):gsub("%f[%S]%-%S+", '<span class="nw">%0</span>') .. "</th>"
    end
    t[#t + 1] = "</tr></thead><tbody>"
    for _, line in ipairs(cells) do
      t[#t + 1] = "<tr>"
      for j, cell in ipairs(line) do t[#t + 1] = "<td" .. (numeric[j] and ' class="n"' or "") .. ">" .. show(cell) .. "</td>" end
      t[#t + 1] = "</tr>"
    end
    t[#t + 1] = '</tbody></table><div class="cap">' .. (l and (l.online and '<b class="online">' or "<b>") .. "Table " .. l.num .. ".</b> " or "")
    r:insert(rawb(table.concat(t)))
    r:insert(caption)
    r:insert(rawb(command_line({ command }, machine) .. "</div></div>"))
  else
    local spec, head, body = {}, {}, {}
    -- too wide for letters of 7 pt: columns of text are as wide as their share, their lines broken, and the table may break over pages
    local most, word, all = {}, {}, 0
    for j, col in ipairs(columns) do
      most[j], word[j] = 0, 0
      for i = 0, #cells do
        local cell = i == 0 and col[2] or cells[i][j]
        if cell:match("^%-?[%d%.]+[eE]") then cell = cell .. "  " end          -- 1.2e-06 is shown as 1.2 x 10^-6
        if i > 0 then most[j] = math.max(most[j], utf8.len(cell) or #cell) end
        for w in cell:gmatch("[^%s]+") do word[j] = math.max(word[j], utf8.len(w) or #w) end
      end
      all = all + math.max(most[j], utf8.len(col[2]) or #col[2]) + 1
      most[j] = math.max(most[j], word[j])             -- a heading may be broken
    end
    local broken, broad, lines = all > 112, {}, 4
    if broken then
      local room, share = 104 - 1.4 * #columns, 0                      -- in letters of 8 pt
      for j = 1, #columns do if most[j] <= 14 then room = room - most[j] else share = share + math.sqrt(most[j]) * math.sqrt(most[j]) ^ 0.5 end end
      for j, col in ipairs(columns) do
        local w = most[j] > 14 and math.max(word[j], math.min(most[j], room * math.sqrt(most[j]) ^ 1.5 / share)) or most[j] < #col[2] and 1.12 * most[j]
        broad[j] = w or nil
      end
      local left, heads = 104 - 1.4 * #columns, 0                      -- what is left goes to the headings that are broken
      for j, col in ipairs(columns) do
        left = left - (broad[j] or most[j])
        if broad[j] and broad[j] < #col[2] then heads = heads + 1 end
      end
      for j, w in pairs(broad) do
        local head = #columns[j][2]
        if left > 0 and w < head then broad[j] = math.min(head, w + left / heads) end
        spec[j] = string.format(">{\\ragged%s\\arraybackslash}p{%.1fpt}", numeric[j] and "left" or "right", broad[j] * 3.95)
      end
    end
    for j, col in ipairs(columns) do spec[j] = spec[j] or numeric[j] and "r" or "l"; head[j] = "\\textbf{" .. Code.tex(col[2]) .. "}" end
    for i, line in ipairs(cells) do
      local t = {}
      for j, cell in ipairs(line) do t[j] = show(cell) end
      body[i] = table.concat(t, " & ") .. "\\\\"
    end
    for _, line in ipairs(cells) do
      local n = 1
      for j, w in pairs(broad) do n = math.max(n, math.ceil(1.15 * (utf8.len(line[j]) or #line[j]) / w)) end
      lines = lines + n
    end
    if not broken and #body > 40 then                  -- longer than a page: the second half beside the first
      local half = (#body + 1) // 2
      for i = 1, half do body[i] = body[i]:gsub("\\\\$", "") .. " & " .. (body[i + half] or string.rep("& ", #columns - 1) .. "\\\\") end
      for i = #body, half + 1, -1 do body[i] = nil end
      for j = 1, #columns do head[#columns + j], spec[#columns + j] = head[j], (j == 1 and "@{\\hskip24pt}" or "") .. spec[j] end
    end
    if broken and lines > 44 then
      local words = pandoc.write(pandoc.Pandoc { caption }, "latex-smart"):gsub("%s+$", "")
      return pandoc.List { rawb("\\begin{wLongTable}[14]\\fontsize{8}{9.8}\\selectfont\\setlength\\tabcolsep{2.5pt}\\begin{longtable}{@{}" .. table.concat(spec) .. "@{}}\\multicolumn{" .. #columns .. "}{@{}l@{}}{" ..
        (id ~= "" and "\\wLabel{" .. id .. "}" or "") .. "\\wTableCaption{" .. (l and "Table~" .. l.num or "") .. "}{" .. words .. command_line({ command }, machine) .. "}}\\\\[3pt]\\toprule " ..
        table.concat(head, " & ") .. "\\\\\\midrule\\noalign{}\\endfirsthead\\toprule " .. table.concat(head, " & ") .. "\\\\\\midrule\\noalign{}\\endhead\n" .. table.concat(body, "\n") .. "\n\\bottomrule\\end{longtable}\\end{wLongTable}") }
    end
    caption.content:insert(1, raw("\\begin{wTable}" .. (id ~= "" and "\\wLabel{" .. id .. "}" or "") .. (broken and "\\fontsize{8}{9.8}\\selectfont\\setlength\\tabcolsep{2.5pt}" or "") .. "\\wFit{\\begin{tabular}{" .. table.concat(spec) .. "}\\toprule " ..
      table.concat(head, " & ") .. "\\\\\\midrule\n" .. table.concat(body, "\n") .. "\n\\bottomrule\\end{tabular}}\n\\wCaption{" .. (l and "Table~" .. l.num or "") .. "}{"))
    caption.content:insert(raw(command_line({ command }, machine) .. "}\\end{wTable}"))
    r:insert(caption)
  end
  return r
end

-- columns whose dashes are all alike say nothing of widths: each gets what its words need; in print none is narrower than its longest word
local function fit_columns(el)
  local most, word, all, share, alike = {}, {}, 0, 0, true
  for j, spec in ipairs(el.colspecs) do
    if not spec[2] then return end
    alike = alike and math.abs(spec[2] - el.colspecs[1][2]) <= 1e-3
    most[j], word[j] = 4, 4
  end
  if html and not alike then return end
  local function shown(r)                               -- the words of what is TeX already: code, references
    return pandoc.Str((r.text:gsub("\\wBreak{}", ""):gsub("\\wFar{[^}]*}{[^}]*}", ""):gsub("\\w[OI][nd]{[^}]*}", ""):gsub("\\hyperlink{[^}]*}", ""):gsub("\\%a+ ?", ""):gsub("[{}\\]", "")))
  end
  local function measure(rows)
    for _, row in ipairs(rows) do
      for j, cell in ipairs(row.cells) do
        local text = pandoc.utils.stringify(pandoc.Div(cell.contents):walk { RawInline = shown })
        most[j] = math.max(most[j], utf8.len(text) or #text)
        for w in text:gmatch("%S+") do word[j] = math.max(word[j], math.min(24, 2 + (utf8.len(w) or #w))) end
      end
    end
  end
  measure(el.head.rows)
  for _, body in ipairs(el.bodies) do measure(body.body) end
  local room = 84                                      -- letters in a line
  if not alike then
    local lack, spare = 0, 0
    for j, spec in ipairs(el.colspecs) do
      most[j] = spec[2] * room
      lack, spare = lack + math.max(0, word[j] - most[j]), spare + math.max(0, most[j] - word[j])
    end
    if lack == 0 or lack > spare then return end
    for j, spec in ipairs(el.colspecs) do
      spec[2] = (most[j] < word[j] and word[j] or most[j] - (most[j] - word[j]) * lack / spare) / room
      el.colspecs[j] = spec
    end
    return
  end
  for j = 1, #most do room, share = room - word[j], share + most[j] ^ 0.75 end
  for j = 1, #most do
    most[j] = word[j] + math.max(room, 0) * most[j] ^ 0.75 / share
    all = all + most[j]
  end
  for j, spec in ipairs(el.colspecs) do el.colspecs[j] = html and { spec[1] } or { spec[1], most[j] / all } end
end

-- On a page a name in a table may break as it may in print, where there is no room for it (book.css): on a phone, and in a table whose longest
-- words leave the text beside them less than a column. Letters are some 8 px wide, a table 750, what surrounds a cell 28.
local function break_names(el)
  local longest, wide = {}, 0
  for _, body in ipairs(el.bodies) do
    for _, row in ipairs(body.body) do
      for i, cell in ipairs(row.cells) do
        cell.contents:walk {
          RawInline = function(x) for w in x.text:gsub("<[^>]*>", ""):gmatch("%S+") do longest[i] = math.max(longest[i] or 0, 8 * #w) end end,
          Str = function(x) longest[i] = math.max(longest[i] or 0, 8 * #x.text) end }
      end
    end
  end
  for i = 1, #el.colspecs do wide = wide + (longest[i] or 0) + 28 end
  return el:walk { RawInline = function(x)
    if x.text:match("^<code>") then
      return pandoc.RawInline("html", (("<wbr>" .. x.text):gsub(">([^<]*)<", function(s) return ">" .. s:gsub("(%l%l)(%u%l)", "%1<wbr>%2"):gsub("%f[%a]wf<wbr>", "wf"):gsub("([_,/(.])", "%1<wbr>") .. "<" end):sub(6)))
    end
  end }, wide > 700
end

local function table_block(el)
  fit_columns(el)
  local last = el.caption.long[#el.caption.long]
  local id
  if last then
    local ins = last.content
    local s = ins[#ins]
    id = s and s.t == "Str" and s.text:match("^{#(tbl:[%w_%-]+)}$")
    if id then
      ins:remove()
      while #ins > 0 and ins[#ins].t == "Space" do ins:remove() end
    end
  end
  local l = id and db.labels[id]
  local caption = last and last.content or pandoc.List {}
  el.caption.long = pandoc.List {}
  local r = pandoc.List {}
  if html then
    local tight
    el, tight = break_names(el)
    r:insert(rawb('<div class="tbl' .. (tight and " tight" or "") .. '"' .. (id and ' id="' .. id .. '"' or "") .. ">"))
    r:insert(el)
    r:insert(rawb('<div class="cap">' .. (l and (l.online and '<b class="online">' or "<b>") .. "Table " .. l.num .. ".</b> " or "")))
    r:insert(pandoc.Plain(caption))
    r:insert(rawb("</div></div>"))
  else
    -- the caption stands in the table's first head, so that it stays with the table and is not repeated
    if #caption > 0 then el.caption.long = pandoc.List { pandoc.Plain { pandoc.Str("WEFTCAPTION") } } end
    local text = pandoc.write(pandoc.Pandoc { el }, "latex-smart")
    local words = pandoc.write(pandoc.Pandoc { pandoc.Plain(caption) }, "latex-smart"):gsub("%s+$", "")
    text = text:gsub("\\caption{WEFTCAPTION}%s*\\tabularnewline", function()
      return "\\multicolumn{" .. #el.colspecs .. "}{@{}l@{}}{" .. (id and "\\wLabel{" .. id .. "}" or "") .. "\\wTableCaption{" .. (l and "Table~" .. l.num or "") .. "}{" .. words .. "}}\\\\[3pt]"
    end)
    r:insert(rawb("\\begin{wLongTable}" .. (#caption == 0 and id and "\\wLabel{" .. id .. "}" or "")))
    r:insert(rawb(text))
    r:insert(rawb("\\end{wLongTable}"))
  end
  return r
end

----------------------------------------------------------------------------------------------------------------- boxes
local function box(kind, title, extra, blocks, id)
  local r = pandoc.List {}
  if html then
    r:insert(rawb('<aside class="box ' .. kind .. '"' .. (id and ' id="' .. id .. '"' or "") .. '><p class="title">' .. title .. (extra and ' <span class="extra">' .. extra .. "</span>" or "") .. "</p>"))
    r:extend(blocks)
    r:insert(rawb("</aside>"))
  else
    r:insert(rawb("\\begin{wBox}{" .. kind .. "}{" .. (id and "\\wLabel{" .. id .. "}" or "") .. title .. "}{" .. (extra or "") .. "}"))
    r:extend(blocks)
    r:insert(rawb("\\end{wBox}"))
  end
  return r
end
-- ::: {.files} the files that the chapters make
local function file_list()
  local files = dofile(weave .. "/files.lua")
  if html then
    db.files = files
    return rawb(require("weave-pages").file_table(db))
  end
  local t, folder = {}, nil
  for _, f in ipairs(files) do
    local links = {}
    for i, id in ipairs(f.chunks) do links[i] = chunk_link(id) end
    t[#t + 1] = "\\wFile{" .. Code.tex(f.name):gsub("/", "/\\wBreak{}") .. "}{" .. f.lines .. "}{" .. table.concat(links, ", ") .. "}"
  end
  return rawb(table.concat(t, "\n"))
end
local dot = html and " \u{b7} " or "\\enspace\\textperiodcentered\\enspace "
-- {.listing file="tests/examples/x.c"}: the file itself, under its name
local code_block
local function listing(el)
  local file = el.attributes.file or "?"
  local text = Code.read(root .. file)
  if not text then fail("%s: the file %s of a .listing is not there -- write {.listing file=\"tests/examples/NAME.c\"}", mine.file, file); return {} end
  local kind = file:match("%.([%w]+)$")
  local classes = (kind == "c" or kind == "h" or kind == "cpp") and { "c" } or {}
  return { pandoc.Para { pandoc.Code(file), pandoc.Str ":" }, code_block(pandoc.CodeBlock(text:gsub("\n$", ""), pandoc.Attr("", classes))) }
end

-- [term]{.def}: in italics, the place that the subject index calls the first
local function span(el)
  if not el.classes:includes "def" then return nil end
  local text = stringify(el.content)
  if html then return { raw('<dfn class="term" id="' .. Code.term_id(text) .. '">'), table.unpack(el.content .. { raw("</dfn>") }) } end
  return { raw("\\wLabel{" .. Code.term_id(text) .. "}" .. Code.tex_terms(el.attributes.index or text)), pandoc.Emph(el.content) }
end
-- Where a section uses a term of the index for the first time: a mark before that paragraph.
local function mark_places(blocks)
  local here, places = nil, mine.index or {}
  local function look(list)
    for _, b in ipairs(list) do
      if b.t == "Header" and places[b.identifier] then
        here = {}
        for i, t in ipairs(places[b.identifier]) do here[i] = t end
      elseif b.t == "Header" and db.labels[b.identifier] then here = nil
      elseif b.t == "Para" and here and not (#b.content == 1 and b.content[1].t == "Image") then
        local text = " " .. stringify(b):lower():gsub("[%s%-]+", " ") .. " "
        for i = #here, 1, -1 do
          if text:find(here[i][2]:gsub("[%s%-]+", " "), 1, true) then
            b.content:insert(1, raw("\\wPlace{" .. Code.tex_term(here[i][1]) .. "}"))
            table.remove(here, i)
          end
        end
      elseif b.t == "Div" then look(b.content)
      elseif b.t == "BulletList" or b.t == "OrderedList" then for _, item in ipairs(b.content) do look(item) end end
    end
  end
  look(blocks)
end

-- ::: {.extensions} the tables that a chapter may add rows to, as EXTENDING.md tells of them. Print has of each its name, where its first
-- rows are printed, what a row keeps, what it gets, and the chunk that its functions go into.
local function extensions()
  local text = Code.read(root .. "EXTENDING.md")
  if not text then fail("%s: EXTENDING.md is not there -- type: tangle/extensions", mine.file); return {} end
  local blocks = pandoc.read(text:match("\n(## .*)"), "markdown+smart-auto_identifiers").blocks
  if html then
    for _, b in ipairs(blocks) do if b.t == "Header" then b.level = b.level + 1 end end
    return blocks
  end
  local first = {}                                      -- first[name] = { its first chunk that this volume prints, or its first; place }
  for id, c in pairs(db.chunks) do
    local place = (tonumber(id:match("%-(%d+)$")) or 1) + ((c.online or Code.far(db, c.page)) and 1000 or 0)
    if not first[c.name] or place < first[c.name][2] then first[c.name] = { id, place } end
  end
  local r, name, into = pandoc.List { rawb("\\begingroup\\fontsize{9}{10.2}\\selectfont\\wKind=1 \\parindent0pt\\parskip0.5pt plus 1pt") }, nil, nil
  for _, b in ipairs(blocks) do
    if b.t == "Header" then name, into = stringify(b), nil
    elseif b.t == "Para" then b:walk { Code = function(el) into = el.text:match("^<<(.*)>>$") or into end }
    elseif b.t == "BulletList" and first[name] then
      local id, place = table.unpack(first[name])
      local entry = pandoc.List { raw("\\hangindent1em\\wName{" .. Code.name(db, name, "tex") .. "} " .. chunk_link(id) .. (place < 1000 and ", p.~\\pageref{" .. id .. "}" or "") .. ": ") }
      for i = 1, 3, 2 do
        local said = b.content[i][1].content
        said:remove(1); said:remove(1)                    -- "A row keeps: ", "It gets: "
        if i == 3 then entry:extend { pandoc.Space(), pandoc.Emph "Gets", pandoc.Space() } end
        entry:extend(said)
      end
      if into then entry:insert(raw(" Code: \\wName{" .. Code.name(db, into, "tex") .. "}.")) end
      r:insert(pandoc.Para(entry))
      name = nil
    end
  end
  r:insert(rawb("\\par\\endgroup"))
  return r
end

local function div(el)
  local a, c = el.attributes, el.classes
  local function code(s) return html and "<code>" .. Code.html(s) .. "</code>" or "\\wInline{" .. Code.tex_code(s):gsub("\\_", "\\_\\wBreak{}") .. "}" end
  if c:includes("exercise") then
    local l = db.labels[el.identifier]
    local extra = {}
    local d = tonumber(a.difficulty or 1) or 1
    extra[#extra + 1] = html and '<span title="difficulty ' .. d .. ' of 5">' .. string.rep("\u{2605}", d) .. "</span>" or string.rep("$\\star$", d)
    if a.kind then extra[#extra + 1] = esc(a.kind) end
    if a.points then extra[#extra + 1] = esc(a.points) .. (a.points == "1" and " point" or " points") end
    if a.minutes then extra[#extra + 1] = esc(a.minutes) .. " min" end
    if a.test then extra[#extra + 1] = code(a.test) end
    if a.starter and l then extra[#extra + 1] = code("make exercise E=" .. l.num) end
    return box("exercise", "Exercise " .. (l and l.num or "?"), table.concat(extra, dot), el.content, el.identifier ~= "" and el.identifier or nil)
  elseif c:includes("solution") then
    if not teacher then return {} end
    local l = db.labels[a["for"] or ""]
    return box("solution", "Solution of " .. (l and (l.kind == "sec" and l.title or "Exercise " .. l.num) or "an exercise"), nil, el.content)
  elseif c:includes("goals") then
    local told = a.report and "the report: " .. esc(a.report) or nil
    if a.part and a.part ~= "" then
      told = (told and told .. (html and " \u{b7} " or " \\textperiodcentered{} ") or "") .. "may be left out: " .. esc(a.part)
    end
    return box("goals", "Goals", told, el.content)
  elseif c:includes("test") then
    if tex and stringify(el.content):match("^%s*$") then return {} end
    return box("test", "Test", a.file and code(a.file) or nil, el.content)
  elseif c:includes("data") then return data_table(el)
  elseif c:includes("listing") then return listing(el)
  elseif c:includes("files") then return file_list()
  elseif c:includes("only") or c:includes("web") then return el.content end
  for _, k in ipairs { "note", "warning", "history", "physics", "aside" } do
    if c:includes(k) then return box(k, a.title and Code.plain(a.title):gsub(".+", esc) or (k:gsub("^%l", string.upper)), nil, el.content, el.identifier ~= "" and el.identifier or nil) end
  end
end

function code_block(el)
  if el.classes:includes("data") then return data_table(el) end
  local is_c = el.classes:includes("c")
  local inside, rows = false, {}
  local glue = {}
  for l in (el.text .. "\n"):gmatch("(.-)\n") do glue[#glue + 1] = l end
  glue = breaks(glue)
  for l in (el.text .. "\n"):gmatch("(.-)\n") do
    local line, n = {}, #rows + 1
    if is_c then
      local toks
      toks, inside = Code.lex(l, inside)
      local previous
      for _, t in ipairs(toks) do
        local idents = t[1] == "id" and previous ~= "." and previous ~= "->" and db.idents[t[2]]
        if t[1] == "id" and Code.keywords[t[2]] then line[#line + 1] = { "kw", t[2] }
        elseif idents and not idents[1].static then line[#line + 1] = { "ref", t[2], idents[1].target, idents[1].kind .. " " .. t[2] }
        elseif t[1] == "id" then line[#line + 1] = { "", t[2] }
        else line[#line + 1] = t end
        if t[1] ~= "sp" then previous = t[2] end
      end
    else line[1] = { "", l } end
    rows[#rows + 1] = html and Code.line_html(db, line, here) or "\\wL" .. glue[n] .. "{" .. Code.line_tex(db, line) .. "}"
  end
  for l in (el.text .. "\n"):gmatch("([^\n]*)\n") do
    if (utf8.len(l) or #l) > 92 then fail("%s: a line of a block has %d columns; the book's page holds 92: %s -- break it", mine.file, utf8.len(l) or #l, l) end
  end
  if html then return rawb('<pre class="block"><code>' .. table.concat(rows, "\n") .. "</code></pre>") end
  return rawb("\\wBlock\n" .. table.concat(rows, "\n") .. "\n\\wEndBlock")
end

---------------------------------------------------------------------------------------------------------- the document
local function header(el)
  local l = db.labels[el.identifier]
  if not l then return nil end
  el.attributes.print = nil
  if html then
    el.attributes.index = nil
    el.content:insert(1, raw('<span class="secnum">' .. (el.level == 1 and Code.html(mine.exercise and "Exercise " .. l.num or Code.ref_text(l)) or l.num) .. "</span> "))
    if el.attributes.part then
      el.content:insert(raw('<span class="only">only with ' .. Code.html(el.attributes.part:gsub(" ", " and ")) .. "</span>"))
      el.attributes.part = nil
    end
    el.content:insert(raw('<a class="anchor" href="#' .. el.identifier .. '" aria-label="link to this section">\u{b6}</a>'))
    return el
  end
  local command = ({ "chapter", "section", "subsection", "subsubsection" })[el.level] or "paragraph"
  el.content:insert(1, raw("\\" .. command .. "[" .. Code.tex(l.title or "") .. "]{\\wLabel{" .. el.identifier .. "}\\label{on:" .. el.identifier .. "}" .. Code.tex_terms(el.attributes.index or "")))
  el.content:insert(raw("}"))
  return pandoc.Plain(el.content)
end

local function meta(m)
  local function get(k, default) return m[k] and stringify(m[k]) or default end
  weave = get("weave", "build/weave")
  root = get("root", "") ~= "" and get("root") .. "/" or ""
  has_testbed = m.testbed ~= nil
  teacher, missing_allowed = get("teacher") == "true", get("missing") == "true"
  figures_dir, data_dir = get("figures", "build/book/html") .. "/", get("data", nil)
  db = dofile(weave .. "/db.lua")
  mine = dofile(weave .. "/" .. get("base") .. ".lua")
  local f = loadfile(weave .. "/bib.lua")
  bib = f and f() or {}
  here = mine.base .. ".html"
  if tex then db.mine = db.volume_of[here] or db.volumes[1].name end
  local written, me, title = {}, nil, nil
  for _, e in ipairs(db.entries) do
    if not e.planned and not e.of then written[#written + 1] = e end
    if e.page == here then me = e.of or e.name; title = e.num .. " " .. Code.plain(e.title) end
  end
  local function nav(e)
    return e and pandoc.MetaMap { href = pandoc.MetaString(e.page), title = pandoc.MetaString(e.num .. " " .. Code.plain(e.title)) } or nil
  end
  for i, e in ipairs(written) do
    if e.name == me and e.page == here then m.prev, m.next = nav(written[i - 1]), nav(written[i + 1])
    elseif e.name == me then m.prev, m.next = nav(e), nav(written[i + 1]) end
  end
  m.toc = pandoc.MetaBlocks { rawb(require "contents"(db, here, (mine.base:gsub("%.%a+$", "")))) }
  m.pagetitle = pandoc.MetaString(title or mine.slides or mine.base == "glossary" and "Glossary" or "Formulas and their code")
  m.page = pandoc.MetaString(mine.base)
  return m
end

-- The page's chunks and equations as a script, so that other pages can show them, from file:// too.
local function write_previews()
  if not html or not data_dir or #mine.chunks == 0 and #previews == 0 or mine.base == "formulas" or mine.slides then return end
  local function quote(s) return '"' .. s:gsub('[\\"]', "\\%0"):gsub("\n", "\\n"):gsub("</", "<\\/") .. '"' end
  local maths, n = {}, 0
  for _, p in ipairs(previews) do if type(p[2]) ~= "string" then maths[#maths + 1] = pandoc.Para { p[2] } end end
  local rendered = {}
  if #maths > 0 then
    local text = pandoc.write(pandoc.Pandoc(maths), "html", pandoc.WriterOptions { html_math_method = "mathml" })
    for p in Code.calm_brackets(text):gmatch("<p>(.-)</p>") do rendered[#rendered + 1] = p end
  end
  local t = {}
  for _, p in ipairs(previews) do
    local s = p[2]
    if type(s) ~= "string" then
      n = n + 1
      s = '<span class="eq"><span class="eqm">' .. (rendered[n] or "") .. '</span><span class="eqn">(' .. db.labels[p[1]].num .. ")</span></span>"
    end
    t[#t + 1] = quote(p[1]) .. ":" .. quote(s)
  end
  Code.write_if_changed(data_dir .. "/" .. mine.base .. ".js", "WEFT.add(" .. quote(here) .. ",{\n" .. table.concat(t, ",\n") .. "});\n")
end

local function finish(doc)
  if html and #cited_order > 0 then
    table.sort(cited_order, function(a, b) 
      local x, y = bib[a] and bib[a].order or 1e9, bib[b] and bib[b].order or 1e9
      if x ~= y then return x < y end
      return a < b
    end)
    local t = { '<section class="sources"><h2>Sources</h2><ul>' }
    for _, id in ipairs(cited_order) do
      local b = bib[id]
      t[#t + 1] = '<li id="ref-' .. id .. '">' .. (b and b.html or Code.html(id)) .. "</li>"
    end
    t[#t + 1] = "</ul></section>"
    doc.blocks:insert(rawb(table.concat(t)))
  end
  write_previews()
  if #errors > 0 then
    table.sort(errors)
    for _, e in ipairs(errors) do io.stderr:write(e, "\n") end
    os.exit(1)
  end
  return doc
end

-- What print leaves out: a box .web and a section print="web" are one line, with how much code they have and where it is.
local function count_code(blocks)
  local n, name = 0, nil
  pandoc.walk_block(pandoc.Div(blocks), { RawBlock = function(el)
    if el.format == "weftchunk" then
      local c = mine.chunks[tonumber(el.text)]
      n, name = n + #c.lines, name or c
    end
  end })
  return n, name
end
local function web_line(text, blocks, num, id)
  local n, first = count_code(blocks)
  text = text or first and "\\wName{" .. Code.name(db, first.name, "tex") .. "}" or "More of this"
  return rawb("\\wOnline{" .. (id and "\\wLabel{" .. id .. "}\\label{on:" .. id .. "}" or "") .. text .. "}{" .. (n > 0 and n .. (n == 1 and " line" or " lines") .. " of code, " or "") .. "}{" .. Code.tex(here) ..
    (num and ", " .. num or first and ", chunk " .. first.num or "") .. "}")
end
local function leave_out(blocks)
  local r, section, inside = pandoc.List {}, nil, nil
  local flat = pandoc.List {}                         -- a box .only is no box in print
  for _, b in ipairs(blocks) do if b.t == "Div" and b.classes:includes("only") then flat:extend(b.content) else flat:insert(b) end end
  blocks = flat
  local function close()
    if not section then return end
    local l = db.labels[section.identifier]
    local counter = ({ nil, "section", "subsection" })[section.level]          -- TeX counts the sections that it has
    if counter then r:insert(rawb("\\stepcounter{" .. counter .. "}")) end
    r:insert(web_line((l and l.num .. "\\enspace " or "") .. Code.tex(l and l.title or stringify(section.content)), inside, l and "section " .. l.num, section.identifier))
    section = nil
  end
  local run
  local function is_online(b) return b.t == "RawBlock" and b.format == "weftchunk" and mine.chunks[tonumber(b.text)].online end
  local function end_run()
    if not run then return end
    local names, lines, last = {}, 0, nil
    for _, b in ipairs(run) do
      local c = mine.chunks[tonumber(b.text)]
      lines = lines + #c.lines
      names[#names + 1] = (c.name ~= last and "\\wName{" .. Code.name(db, c.name, "tex") .. "}~" or "") .. "{\\footnotesize " .. c.num .. "}"
      last = c.name
    end
    r:insert(rawb("\\wOnline{" .. table.concat(names, ", ") .. "}{" .. lines .. (lines == 1 and " line, " or " lines, ") .. "}{" .. Code.tex(here) .. "}"))
    run = nil
  end
  for _, b in ipairs(blocks) do
    if run and not (not section and is_online(b)) then end_run() end
    if b.t == "Header" and section and b.level <= section.level then close() end
    if section then inside:insert(b)
    elseif b.t == "Header" and b.attributes.print == "web" then section, inside = b, pandoc.List {}
    elseif is_online(b) then                         -- chunks that follow one another are one line
      run = run or pandoc.List {}
      run:insert(b)
    elseif b.t == "Div" and b.classes:includes("web") then r:insert(web_line(b.attributes.title and Code.tex(b.attributes.title), b.content))
    else
      if b.t == "Div" then b.content = leave_out(b.content) end
      r:insert(b)
    end
  end
  end_run()
  close()
  return r
end

-- a heading with a table or a box behind it needs more room than one with words; one with such a heading behind it needs that as well
local function keep_headings(blocks)
  local behind, lines
  for i = #blocks, 1, -1 do
    local b = blocks[i]
    if b.t == "Header" then
      lines = behind and (behind.t == "Table" and 11 or behind.t == "Div" and (behind.classes:includes("data") and 12 or 7)) or lines and lines + 3
      if lines and not (i > 1 and blocks[i - 1].t == "Header") then
        blocks:insert(i, rawb((lines > 10 and "\\wRoomBefore{" or "\\wRoom{") .. lines .. "}"))
        lines = nil
      end
      behind = nil
    else behind, lines = b, nil end
  end
end

-- A sentence that goes on behind a formula begins no paragraph; a figure that is all of its section stays in it.
local function tidy(blocks)
  local function ends_in_formula(b)
    local l = b and b.t == "Para" and b.content[#b.content]
    return l and l.t == "RawInline" and (l.text:match("\\end{equation}$") or l.text:match("\\%]$"))
  end
  for i, b in ipairs(blocks) do
    if b.t == "Para" and ends_in_formula(blocks[i - 1]) then
      local k = 1
      while b.content[k] and b.content[k].t == "RawInline" and b.content[k].text:match("^\\wPlace") do k = k + 1 end
      if b.content[k] and b.content[k].t == "Str" and b.content[k].text:match("^%l") then b.content:insert(1, raw("\\noindent ")) end
    end
  end
  return blocks
end
local function keep_figures(blocks)
  for i = #blocks - 1, 2, -1 do
    local b = blocks[i]
    if b.t == "Para" and #b.content == 1 and b.content[1].t == "Image" and blocks[i - 1].t == "Header" and blocks[i + 1].t == "Header" then
      blocks:insert(i + 1, rawb("\\wBoxedfalse"))
      blocks:insert(i, rawb("\\wBoxedtrue"))
    end
  end
end

return {
  { Meta = meta },
  { Div = function(el) if el.classes:includes "extensions" then return extensions() end end },
  { Pandoc = function(doc)
    if tex then
      doc.blocks = leave_out(doc.blocks)
      mark_places(doc.blocks)
      keep_figures(doc.blocks)
      keep_headings(doc.blocks)
    end
    return doc
  end },
  { Cite = cite },
  { Code = inline_code, CodeBlock = code_block,
    RawBlock = function(el)
      if el.format == "weftchunk" then return chunk(tonumber(el.text)) end
      if el.text:match("^%s*\\newcommand") or el.text:match("^%s*\\renewcommand") then return {} end
    end,
    Link = function(el)                                    -- one that leads out of a printed volume is its words
      if el.target:match("^testbed%.html") and (tex or not has_testbed) then return el.content end
      local l = db.labels[el.target:match("^#(.*)$") or ""]
      if l and (l.gone or tex and (l.online or Code.far(db, l.page))) then return el.content end
    end,
    Span = span, Para = figure, Div = div, Table = table_block },
  { Inlines = inlines, Header = header },
  { Blocks = tex and tidy or nil },
  { Pandoc = finish },
}
