-- count.lua: lines of code and words of prose of each part of the engine (parts.lua), from noweb's markup.
--
--   lua count.lua < stream        one line a part, in the order of the book: name, needs, lines, words; "-" for what is in every engine
package.path = (arg[0]:match("^(.*/)") or "./") .. "?.lua;" .. package.path
local Book, Parts = require "book", require "parts"
local book = Book.read(io.stdin)
local whole = Parts.reached(book, Parts.choose(book, {}))      -- the testbed and the lab are not the engine
local lines, words = {}, {}
local function add(t, part, n) t[part] = (t[part] or 0) + n end
for i, c in ipairs(book.chunks) do
  if whole[i] then
    local n, text = 0, false
    for _, it in ipairs(c.items) do
      if it.kind == "nl" then
        if text then n = n + 1 end
        text = false
      elseif it.kind == "text" and it.text:match("%S") then text = true end
    end
    add(lines, Parts.owner(book, c.with), n)
  end
end
for _, ch in ipairs(book.chapters) do
  for _, p in ipairs(ch.prose or {}) do
    local part = Parts.owner(book, p.only)
    if part ~= "" then add(words, part, p.words) end
  end
end
local list = {}
for _, p in pairs(book.parts) do list[#list + 1] = p end
table.sort(list, function(a, b) return a.order < b.order end)
print(string.format("-||%d|0", lines[""] or 0))
for _, p in ipairs(list) do
  print(string.format("%s|%s|%d|%d", p.name, table.concat(p.needs, " "), lines[p.name] or 0, words[p.name] or 0))
end
