-- weave-pages.lua: the pages that need no pandoc: index, lists, bibliography, assembled sources, search index; and what TeX needs
-- to put the chapters together.
local Code, contents = require "weave-code", require "contents"
local Pages = {}
local h = Code.html

-- pandoc's template language, as much of it as book/page.html uses
local function fill(template, values)
  local s = template:gsub("%$if%((%w+)%)%$(.-)%$endif%$", function(k, body) return values[k] and body or "" end)
  return (s:gsub("%$(%w+)%.?(%w*)%$", function(k, f)
    local v = values[k]
    if f ~= "" then v = v and v[f] end
    return v or ""
  end))
end

local lists = { { "subjects.html", "Subject index" }, { "glossary.html", "Glossary" }, { "formulas.html", "Formulas and their code" }, { "chunks.html", "List of chunks" }, { "identifiers.html", "Index of identifiers" },
  { "sources.html", "Assembled sources" }, { "bibliography.html", "Bibliography" } }
local function list_links(db)
  local t = {}
  for i, l in ipairs(lists) do if i > 2 or i == 1 and db.indexed or i == 2 and #db.glossary > 0 then t[#t + 1] = '<li><a href="' .. l[1] .. '">' .. l[2] .. "</a></li>" end end
  return "<ul>" .. table.concat(t) .. "</ul>"
end

function Pages.write(w)
  local db, book, html_dir = w.db, w.book, w.html
  local template = Code.read(w.root .. "book/page.html") or "$body$"
  db.indexed = #w.terms > 0
  local toc = contents(db, "")
  local testbed                                        -- has this book scenes, and so a testbed's page and a gallery?
  for _, e in ipairs(db.entries) do if e.volume == "testbed" and not e.planned then testbed = "yes" end end
  local function page(name, title, body, extra)
    if not html_dir then return end
    local v = { pagetitle = h(title), toc = toc, body = body, page = "", testbed = testbed }
    for k, x in pairs(extra or {}) do v[k] = x end
    Code.write_if_changed(html_dir .. "/" .. name, fill(template, v))
  end
  local in_order = {}                                  -- all chunks, chapter by chapter as the contents have them
  for _, e in ipairs(db.entries) do for _, c in ipairs(book.chunks) do if book.chapters[c.chapter].entry == e and not c.gone then in_order[#in_order + 1] = c end end end
  local function chunk_link(id) local c = db.chunks[id] return '<a class="cref" href="' .. c.page .. "#" .. id .. '"><b>' .. c.num .. "</b></a>" end

  ---------------------------------------------------------------------------------------------------------- index page
  do
    local t, part = {}, nil
    local cover = Code.read(w.root .. "book/cover.svg")
    t[#t + 1] = '<header class="cover">' .. (cover and '<div class="coverpic">' .. cover:gsub("^.-(<svg)", "%1") .. "</div>" or "") ..
      '<h1 class="booktitle">Weft</h1><p class="subtitle">A textbook that builds into a rigid-body physics engine</p></header>'
    t[#t + 1] = '<section class="doors">'               -- a door for each volume, and one for the course
    local function chapters_of(v)
      local r = {}
      for _, e in ipairs(db.entries) do if not e.of and (e.volume or db.volumes[1].name) == v.name then r[#r + 1] = e end end
      return r
    end
    for i, v in ipairs(db.volumes) do
      local written = {}
      for _, e in ipairs(chapters_of(v)) do if not e.planned then written[#written + 1] = e end end
      if #written > 0 then
        t[#t + 1] = '<div class="door"><h2>' .. (#db.volumes > 1 and "<small>Volume " .. i .. "</small> " or "") .. '<a href="' .. written[1].page .. '">' .. h(v.title) .. "</a></h2><p>" .. h(v.what) .. "</p><p><a href=\"#v-" .. v.name .. '">' ..
          #written .. (#written == 1 and " chapter" or " chapters") .. '</a> <a class="pdf" href="../' .. v.name .. '.pdf">PDF</a></p></div>'
      end
    end
    if #db.weeks > 0 then
      local weeks = {}
      for i, k in ipairs(db.weeks) do weeks[i] = '<a href="' .. k.page .. '" title="' .. h(k.title) .. '">' .. k.n .. "</a>" end
      t[#t + 1] = '<div class="door course"><h2><small>The course</small> <a href="' .. db.labels["sec:coursework-weeks"].page .. '#sec:coursework-weeks">' .. (#weeks == 12 and "Twelve" or #weeks) ..
        " weeks</a></h2><p>A way through the first volume, with exercises. Each week ends with something that runs.</p><p>Week " .. table.concat(weeks, " ") .. "</p></div>"
    end
    t[#t + 1] = "</section>"
    t[#t + 1] = '<section class="how"><p>Each chapter interleaves the physics, its derivation and the C code. The code that you read is the code that runs: it is taken from these pages and compiled.</p><ul>' ..
      "<li>Code comes in named, numbered chunks. Click a \u{27e8}chunk\u{27e9} to go to it, rest on it to see it, click with Shift to open it in place, with all its pieces. <i>Assembled</i>, above a chunk, shows it whole, as the compiler sees it.</li>" ..
      "<li>Every identifier leads to its definition. Every chunk says where it is used and in which line of which file it stands.</li>" ..
      "<li>Beside each numbered equation stand the chunks that compute it; <a href=\"formulas.html\">Formulas and their code</a> lists them all.</li>" ..
      "<li>Press <kbd>/</kbd> to search: headings, text, equations, chunks and identifiers.</li></ul></section>"
    t[#t + 1] = '<section class="contents">'
    for i, v in ipairs(db.volumes) do
      local list = chapters_of(v)
      if #list > 0 then t[#t + 1] = '<h2 id="v-' .. v.name .. '">' .. (#db.volumes > 1 and i .. " " or "") .. h(v.title) .. "</h2>" end
      part = nil
      for _, e in ipairs(list) do
        if e.part ~= part then
          if part then t[#t + 1] = "</ol>" end
          part = e.part
          t[#t + 1] = (part ~= v.title and "<h3>" .. (e.part_number and "Part " .. e.part_number .. ": " or "") .. h(part) .. "</h3>" or "") .. "<ol>"
        end
        if e.planned then t[#t + 1] = '<li class="planned"><span class="n">' .. e.num .. "</span> " .. h(e.title) .. " <small>planned</small></li>"
        else
          t[#t + 1] = '<li><a href="' .. e.page .. '"><span class="n">' .. e.num .. "</span> " .. h(Code.plain(e.title)) .. "</a>"
          local s = {}
          for _, x in ipairs(db.heads) do
            if x.page == e.page and x.level == 2 then s[#s + 1] = '<a href="' .. x.page .. "#" .. x.id .. '">' .. h(Code.plain(x.title)) .. "</a>" end
          end
          for _, x in ipairs(db.entries) do
            if x.of == e.name then s[#s + 1] = '<a href="' .. x.page .. '">' .. h(Code.plain(x.title)) .. "</a>" end
          end
          t[#t + 1] = (#s > 0 and '<p class="secs">' .. table.concat(s, " \u{b7} ") .. "</p>" or "") .. "</li>"
        end
      end
      if part then t[#t + 1] = "</ol>" end
    end
    t[#t + 1] = "<h2>Lists</h2>" .. list_links(db) .. "</section>"
    t[#t + 1] = '<p class="licence">The code is free under the MIT licence, the text and the figures under <a href="https://creativecommons.org/licenses/by/4.0/">CC BY 4.0</a>.</p>'
    page("index.html", "Weft", table.concat(t))
  end

  ---------------------------------------------------------------------------------------------------- list of chunks
  do
    local t, chapter = { "<h1>List of chunks</h1><p>In the order of the book; continued chunks give the numbers of all their parts.</p>" }, nil
    for _, c in ipairs(in_order) do
      if c.part == 1 then
        if c.chapter ~= chapter then
          if chapter then t[#t + 1] = "</ul>" end
          chapter = c.chapter
          local e = book.chapters[chapter].entry
          t[#t + 1] = "<h2>" .. e.num .. " " .. h(Code.plain(e.title)) .. '</h2><ul class="plainlist">'
        end
        local parts = {}
        for _, p in ipairs(book.names[c.name].parts) do parts[#parts + 1] = chunk_link(book.chunks[p].id) end
        t[#t + 1] = '<li>\u{27e8}' .. Code.name(db, c.name, "html") .. "\u{27e9} " .. table.concat(parts, " ") .. "</li>"
      end
    end
    t[#t + 1] = "</ul>"
    page("chunks.html", "List of chunks", table.concat(t))
  end

  ------------------------------------------------------------------------------------------------------ subject index
  do
    local list = { table.unpack(w.terms) }
    table.sort(list, function(a, b)
      local x, y = a.term:lower():gsub("[^%w]+", " "), b.term:lower():gsub("[^%w]+", " ")
      if x ~= y then return x < y end
      return a.term < b.term
    end)
    local t, letter, letters = {}, nil, {}
    local function place(id, anchor)
      local l = db.labels[id]
      return l and '<a href="' .. l.page .. "#" .. (anchor or id) .. '" title="' .. h(l.title or "") .. '">' .. l.num .. "</a>" or ""
    end
    for _, x in ipairs(list) do
      local l = x.term:sub(1, 1):upper()
      if l ~= letter then
        letter = l
        letters[#letters + 1] = '<a href="#' .. l .. '">' .. l .. "</a>"
        t[#t + 1] = '<li class="letter" id="' .. l .. '">' .. h(l) .. "</li>"
      end
      local more = {}
      for _, id in ipairs(x.more) do more[#more + 1] = place(id) end
      t[#t + 1] = "<li>" .. h(x.term) .. " <b>" .. place(x.id, x.anchor) .. "</b>" .. (#more > 0 and ' <span class="uses">' .. table.concat(more, " ") .. "</span>" or "") .. "</li>"
    end
    if #list > 0 then
      page("subjects.html", "Subject index", '<h1>Subject index</h1><p>Bold: the section that explains the term; then sections that say more of it. Names of the code are in the <a href="identifiers.html">index of identifiers</a>.</p><p class="abc">' ..
        table.concat(letters, " ") .. '</p><ul class="plainlist idx">' .. table.concat(t) .. "</ul>")
    end
  end

  ---------------------------------------------------------------------------------------------- index of identifiers
  do
    local names = {}
    for name in pairs(db.idents) do if not name:match("_H$") then names[#names + 1] = name end end
    local function sort_key(n) return (n:gsub("^wf", ""):gsub("^WF_", ""):lower()) end
    table.sort(names, function(a, b)
      local x, y = sort_key(a), sort_key(b)
      if x ~= y then return x < y end
      return a < b
    end)
    local t, letter = { '<h1>Index of identifiers</h1><p>Sorted without the prefix <code>wf</code>. Bold: the chunk that defines it; then the chunks that use it.</p><ul class="plainlist idx">' }, nil
    for _, name in ipairs(names) do
      local l = sort_key(name):sub(1, 1):upper()
      if l ~= letter then letter = l; t[#t + 1] = '<li class="letter">' .. h(l) .. "</li>" end
      for _, d in ipairs(db.idents[name]) do
        local uses = {}
        for _, tag in ipairs(w.tags[name]) do
          if tag.main and book.chunks[tag.chunk].page .. "#" .. tag.anchor == d.target then
            for _, id in ipairs(w.keyed(w.uses_of[tag])) do uses[#uses + 1] = chunk_link(id) end
          end
        end
        t[#t + 1] = '<li><code><a href="' .. d.target .. '">' .. h(name) .. "</a></code> <small>" .. d.kind .. (d.static and " in " .. h(d.file) or "") .. "</small> <b>" .. d.num .. "</b>" ..
          (#uses > 0 and ' <span class="uses">' .. table.concat(uses, " ") .. "</span>" or "") .. "</li>"
      end
    end
    t[#t + 1] = "</ul>"
    page("identifiers.html", "Index of identifiers", table.concat(t))
  end

  -------------------------------------------------------------------------------------------------- assembled sources
  local function line_html(l, r)                -- the line as its chunk has it, moved in
    if l.comment or not l.chunk then return '<span class="co">' .. h(l.text) .. "</span>" end
    local c = book.chunks[l.chunk]
    local row = c.row_at[l.line]
    local indent = #l.text:match("^ *") - #(row[1] and row[1][1] == "" and row[1][2]:match("^ *") or "")
    return string.rep(" ", indent) .. Code.line_html(db, row, r.page, true)
  end
  local files = {}
  for _, r in ipairs(w.roots) do
    local t = { '<h1><code>' .. h(r.name) .. "</code></h1><p>" .. #r.lines .. " lines, as in <code>src-generated/" .. h(r.name) ..
      '</code>. The number before a line leads to the chunk that it comes from.</p><pre class="assembled"><code>' }
    local last, chunks = nil, {}
    for i, l in ipairs(r.lines) do
      local c = l.chunk and book.chunks[l.chunk]
      local mark = ""
      if c then
        if not chunks[c.id] then chunks[c.id] = true; chunks[#chunks + 1] = c.id end
        local shown = c.id ~= last
        mark = '<a class="ln' .. (shown and " first" or "") .. '" href="' .. c.page .. "#" .. c.id .. '" title="chunk ' .. c.num .. " \u{27e8}" .. h(Code.plain(c.name)) .. '\u{27e9}"><i>' .. c.num .. "</i>" .. i .. "</a>"
        last = c.id
      else mark = '<span class="ln">' .. i .. "</span>" end
      t[#t + 1] = '<span class="row" id="L' .. i .. '">' .. mark .. line_html(l, r) .. "\n</span>"
    end
    t[#t + 1] = "</code></pre>"
    page(r.page, r.name, table.concat(t))
    files[#files + 1] = { name = r.name, page = r.page, lines = #r.lines, chunks = chunks }
  end
  db.files = files
  do
    local t, folder = { "<h1>Assembled sources</h1><p>Every file that the chapters make, in full, each line linked to its chunk.</p>" }, nil
    t[#t + 1] = Pages.file_table(db)
    page("sources.html", "Assembled sources", table.concat(t))
  end
  Code.write_if_changed(w.out .. "/files.lua", "return " .. Code.serialise(files) .. "\n")

  -------------------------------------------------------------------------------------------------------- bibliography
  do
    local f = loadfile(w.out .. "/bib.lua")
    local bib = f and f() or {}
    local keys = {}
    for _, k in ipairs(db.cited) do if bib[k] and bib[k].order then keys[#keys + 1] = k end end
    table.sort(keys, function(a, b) return bib[a].order < bib[b].order end)
    local t = { '<h1>Bibliography</h1><ul class="plainlist refs">' }
    for _, k in ipairs(keys) do t[#t + 1] = '<li id="ref-' .. k .. '">' .. bib[k].html .. "</li>" end
    t[#t + 1] = "</ul>"
    page("bibliography.html", "Bibliography", table.concat(t))
    for _, v in ipairs(db.volumes) do                  -- in print each volume has its own sources
      local x, mine = {}, db.cited_in[v.name] or {}
      for _, k in ipairs(keys) do if mine[k] then x[#x + 1] = "\\wSource{ref-" .. k .. "}{" .. bib[k].tex .. "}" end end
      Code.write_if_changed(w.out .. "/bibliography-" .. v.name .. ".tex", table.concat(x, "\n") .. "\n")
    end
  end

  -------------------------------------------------------------------------------- formulas: made by pandoc from Markdown
  do
    local t = { "# Formulas and their code\n\nEvery numbered equation of the book, with the chunks of code that compute it. An equation without a chunk is a step of a derivation.\n\n" }
    for _, e in ipairs(db.entries) do
      local ch = { md = {} }
      for _, c in ipairs(book.chapters) do if c.entry == e then ch = c end end
      local text = table.concat(ch.md)
      local any
      for math, id in text:gmatch("%$%$(.-)%$%$ {#(eq:[%w_%-]+)}") do
        if not any then t[#t + 1] = "\n## " .. ch.num .. " " .. ch.title .. "\n\n"; any = true end
        local q, code = db.eqs[id] or {}, {}
        for i, name in ipairs(q.code or {}) do code[i] = "`" .. name .. "`" end
        if q.name or #code > 0 then t[#t + 1] = (q.name and q.name:gsub("^%l", string.upper) or "Code") .. (#code > 0 and ": " .. table.concat(code, ", ") or "") .. "\n\n" end
        t[#t + 1] = "$$" .. math .. "$$ {#" .. id .. "}\n\n"
      end
    end
    Code.write_if_changed(w.out .. "/formulas.md", table.concat(t))
    -- in print: what code uses, with its name, its page and who computes it
    for i, v in ipairs(db.volumes) do
      local x = {}
      for _, e in ipairs(db.entries) do
        local mine = {}
        for id, q in pairs(db.eqs) do
          if e.page == q.page and db.volume_of[q.page] == v.name and q.name and #(q.chunks or {}) > 0 and not db.labels[id].online then mine[#mine + 1] = { tonumber(q.num:match("%d+$")), id, q } end
        end
        table.sort(mine, function(a, b) return a[1] < b[1] end)
        for _, m in ipairs(mine) do
          local code = {}
          for k, name in ipairs(m[3].code) do if k <= 2 then code[k] = Code.tex_code(name):gsub("\\_", "\\_\\wBreak{}"):gsub("(%l%l)(%u%l)", "%1\\wBreak{}%2") end end
          if #code == 0 then code[1] = "\\normalfont chunk " .. db.chunks[m[3].chunks[1]].num end
          x[#x + 1] = "\\wFormula{" .. m[2] .. "}{" .. m[3].num .. "}{" .. Code.tex(m[3].name) .. "}{" .. table.concat(code, ", ") .. "}"
        end
      end
      Code.write_if_changed(w.out .. "/formulas-" .. v.name .. ".tex", table.concat(x, "\n") .. "\n")
    end
    Code.write_if_changed(w.out .. "/formulas.lua", 'return {["base"]="formulas",["chunks"]={},["file"]="formulas.md"}\n')
  end

  -------------------------------------------------------------------------------------------------------- search index
  if html_dir then
    local function q(s) return '"' .. s:gsub('[\\"]', "\\%0"):gsub("[\n\r\t]", " "):gsub("</", "<\\/") .. '"' end
    local pages, number, t = {}, {}, {}
    local function page_number(p)
      if not number[p] then pages[#pages + 1] = q(p); number[p] = #pages - 1 end
      return number[p]
    end
    local function add(kind, title, p, id, text) t[#t + 1] = "[" .. q(kind) .. "," .. q(title) .. "," .. page_number(p) .. "," .. q(id or "") .. (text and "," .. q(text) or "") .. "]" end
    local function readable(text)                 -- numbers for references, no marks of citations and tables
      if not text then return nil end
      text = text:gsub("@(%a+:[%w_%-]*%w)", function(id)
        local l = w.labels[id:sub(1, 1):lower() .. id:sub(2)]
        return l and Code.ref_text(l)
      end)
      return (text:gsub("%[@([%w_%-]+)", "[%1"):gsub("%s*|[%s|:%-]*", " \u{b7} "))
    end
    for _, s in ipairs(w.search) do add(s.kind, s.title, s.page, s.id, readable(s.text)) end
    for _, c in ipairs(book.chunks) do if c.part == 1 and not c.gone then add("chunk", c.num .. " \u{27e8}" .. Code.plain(c.name):gsub("@(%a+:[%w_%-]+)", function(id) return w.labels[id] and Code.ref_text(w.labels[id]) or id end) .. "\u{27e9}", c.page, c.id) end end
    local names = {}
    for name in pairs(db.idents) do if not name:match("_H$") then names[#names + 1] = name end end
    table.sort(names)
    for _, name in ipairs(names) do
      for _, d in ipairs(db.idents[name]) do
        local p, id = d.target:match("^(.-)#(.*)$")
        add((d.static or not name:lower():match("^wf")) and "private" or "ident", name, p, id, d.kind .. ", chunk " .. d.num)
      end
    end
    for _, f in ipairs(files) do add("file", f.name, f.page, "", f.lines .. " lines") end
    os.execute("mkdir -p '" .. html_dir .. "/data'")
    Code.write_if_changed(html_dir .. "/data/search.js", "WEFT.index([" .. table.concat(pages, ",") .. "],[\n" .. table.concat(t, ",\n") .. "]);\n")
  end

  -- the pieces of chunks that have several, for the view of all of them: the page of each, by the id of the first
  if html_dir then
    local t = {}
    for _, n in pairs(book.names) do
      if #n.parts > 1 then
        local pages = {}
        for i, p in ipairs(n.parts) do pages[i] = '"' .. book.chunks[p].page .. '"' end
        t[#t + 1] = '"' .. book.chunks[n.parts[1]].id .. '":[' .. table.concat(pages, ",") .. "]"
      end
    end
    table.sort(t)
    Code.write_if_changed(html_dir .. "/data/pieces.js", "WEFT.pieces({\n" .. table.concat(t, ",\n") .. "});\n")
  end

  ------------------------------------------------------------- pages of chapters and files that are no more must not stay
  if html_dir then
    local keep = { ["formulas.html"] = true, ["index.html"] = true, ["testbed.html"] = true, ["gallery.html"] = true }
    for _, l in ipairs(lists) do keep[l[1]] = true end
    for _, e in ipairs(db.entries) do if e.page then keep[e.page] = true end end
    for _, f in ipairs(files) do keep[f.page] = true end
    local p = io.popen("cd '" .. html_dir .. "' && ls *.html 2>/dev/null")
    for name in p:lines() do if not keep[name] and not name:match("^slides%-%d+%.html$") then os.remove(html_dir .. "/" .. name) end end
    p:close()
  end

  --------------------------------------------------------------------------- the frame for TeX: the chapters of each volume
  for i, v in ipairs(db.volumes) do
    local t, part, written = {}, nil, {}
    local function mine(e) return not e.of and (e.volume or db.volumes[1].name) == v.name end
    for _, e in ipairs(db.entries) do if mine(e) and not e.planned then written[e.part] = (written[e.part] or 0) + 1 end end
    for _, e in ipairs(db.entries) do                 -- a part has a page of its own when it has several chapters
      if not mine(e) then goto next end
      if e.part ~= part then
        part = e.part
        local page = e.appendix or (written[part] or 0) > 1
        if e.appendix then t[#t + 1] = "\\wAppendices"
        elseif part ~= v.title then t[#t + 1] = "\\w" .. (page and "Part" or "QuietPart") .. "{" .. (e.part_number or "") .. "}{" .. Code.tex(part) .. "}" end
      end
      if e.planned then t[#t + 1] = "\\wPlanned{" .. e.num .. "}{" .. Code.tex(e.title) .. "}"
      else t[#t + 1] = "\\wNumber{" .. e.num .. "}\n\\include{ch/" .. e.name .. "}" end
      ::next::
    end
    Code.write_if_changed(w.out .. "/chapters-" .. v.name .. ".tex", table.concat(t, "\n") .. "\n")
    local others = {}
    for j, o in ipairs(db.volumes) do
      if j ~= i then others[#others + 1] = (o.letter == "" and "one without a letter is of" or "\\textsf{" .. o.letter .. "} means") .. " \\emph{" .. Code.tex(o.title) .. "}" end
    end
    Code.write_if_changed(w.out .. "/volume-" .. v.name .. ".tex", "\\renewcommand\\wVolume{" .. (#db.volumes > 1 and "Volume " .. i .. " of " .. #db.volumes or "") .. "}\\renewcommand\\wVolumeTitle{" .. Code.tex(v.title) .. "}\\renewcommand\\wVolumeWhat{" ..
      Code.tex(v.what) .. "}\\renewcommand\\wVolumeOthers{" .. (#others > 0 and "A number with another letter before it is of another volume: " .. table.concat(others, ", ") or "A number that no page here has is of the whole book") .. "}\n" .. (i == 1 and #db.glossary > 0 and "\\renewcommand\\wGlossary{\\input{ch/glossary.tex}}\n" or "") .. (i == 1 and #others > 0 and "\\wFormulastrue\n" or "") .. "\\hypersetup{pdftitle={Weft" .. (#others > 0 and " " .. i or "") .. ": " .. Code.tex(v.title) .. "}}\n")
  end
end

-- The files of the program by component, with their length and their chapters: for sources.html and for Appendix D.
function Pages.file_table(db)
  local t, folder = {}, nil
  for _, f in ipairs(db.files) do
    local dir = f.name:match("^(.*)/")
    if dir ~= folder then
      if folder then t[#t + 1] = "</tbody></table>" end
      folder = dir
      t[#t + 1] = "<h3><code>" .. h(dir) .. '/</code></h3><table class="files"><tbody>'
    end
    t[#t + 1] = '<tr><td><a href="' .. f.page .. '"><code>' .. h(f.name:match("[^/]+$")) .. '</code></a></td><td class="n">' .. f.lines .. " lines</td><td>"
    for i, id in ipairs(f.chunks) do
      local c = db.chunks[id]
      t[#t + 1] = '<a class="cref" href="' .. c.page .. "#" .. id .. '"><b>' .. c.num .. "</b></a> "
    end
    t[#t + 1] = "</td></tr>"
  end
  if folder then t[#t + 1] = "</tbody></table>" end
  return table.concat(t)
end

return Pages
