-- weave-bib.lua: a pandoc filter that runs after citeproc and writes the bibliography as a Lua table:
--   [key] = { author = "Baraff", year = "1994", order = n, html = "...", tex = "..." }
local dir = PANDOC_SCRIPT_FILE:match("^(.*/)") or "./"
package.path = dir .. "?.lua;" .. package.path
local Code = require "weave-code"
function Pandoc(doc)
  local bib, order, authors = {}, 0, {}
  -- pages show single entries, so "---. 2011." becomes the author's name again
  local function named(format, s)
    local author = s:match("^(.-)%.%s+%d%d%d%d") or s:match("^(.-)%.%s+n%.d")
    if author and not author:match("^\u{2014}") and not author:match("^%-%-") then authors[format] = author
    elseif author and authors[format] then s = authors[format] .. s:sub(#author + 1) end
    return s
  end
  pandoc.walk_block(pandoc.Div(doc.blocks), { Div = function(d)
    local key = d.identifier:match("^key%-(.+)$")
    if key then
      local s = pandoc.utils.stringify(d)
      local author, year = s:match("^(.-)%s*%(([^%(%)]*)%)%s*$")
      bib[key] = bib[key] or {}
      bib[key].author, bib[key].year = author or s, year or "n.d."
    end
    key = d.identifier:match("^ref%-(.+)$")
    if key then
      order = order + 1
      bib[key] = bib[key] or {}
      local b = bib[key]
      b.order = order
      b.html = pandoc.write(pandoc.Pandoc { pandoc.Plain(pandoc.utils.blocks_to_inlines(d.content)) }, "html"):gsub("%s+$", "")
      b.html = named("html", b.html)
      b.tex = pandoc.write(pandoc.Pandoc { pandoc.Plain(pandoc.utils.blocks_to_inlines(d.content)) }, "latex"):gsub("%s+$", "")
      b.tex = named("tex", b.tex)
    end
  end })
  Code.write_if_changed(pandoc.utils.stringify(doc.meta.out), "return " .. Code.serialise(bib) .. "\n")
  return pandoc.Pandoc {}
end
