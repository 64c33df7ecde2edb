-- links.lua: every link of every page leads to a page and an anchor that are there, and no page uses an id twice.
--   lua links.lua DIR
-- It reads the search index, too. Links to other sites are only counted.
local dir = arg[1]
local function read(path)
  local f = io.open(path, "rb")
  if not f then return nil end
  local s = f:read("a")
  f:close()
  return s
end
local pages, ids, errors = {}, {}, {}
local p = assert(io.popen("ls '" .. dir .. "'"))
for name in p:lines() do if name:match("%.html$") then pages[#pages + 1] = name end end
p:close()
local function decode(s) return (s:gsub("&amp;", "&"):gsub("&#39;", "'"):gsub("%%(%x%x)", function(h) return string.char(tonumber(h, 16)) end)) end
for _, name in ipairs(pages) do
  ids[name] = {}
  for id in read(dir .. "/" .. name):gmatch('%sid="([^"]+)"') do
    id = decode(id)
    if ids[name][id] then errors[#errors + 1] = name .. ": id " .. id .. " is used twice" end
    ids[name][id] = true
  end
end
local count, outside = 0, 0
local printed = io.popen("ls '" .. dir .. "'/../*.pdf 2>/dev/null"):read("l")      -- pages that were made without the PDFs lead to none
local function check(from, href)
  href = decode(href)
  if href:match("^%a+:") and not href:match("^%a+:[%w%-]+$") then outside = outside + 1 return end
  local page, id = href:match("^([^#]*)#?(.*)$")
  page = page:gsub("%?.*$", "")
  count = count + 1
  if page == "" then page = from end
  if not printed and page:match("^%.%./%w+%.pdf$") then return end
  if not ids[page] then
    if not read(dir .. "/" .. page) then errors[#errors + 1] = from .. ": no page " .. page end
  elseif id ~= "" and page ~= "testbed.html" and not ids[page][id] then errors[#errors + 1] = from .. ": nothing at " .. page .. "#" .. id end
end
for _, name in ipairs(pages) do
  local text = read(dir .. "/" .. name)
  for href in text:gmatch('%shref="([^"]*)"') do check(name, href) end
  for src in text:gmatch('<[^>]-%ssrc="([^"]*)"') do check(name, src) end
  if text:match('<script[^>]-src="https?:') or text:match('<link[^>]-href="https?:') or text:match('<img[^>]-src="https?:') then
    errors[#errors + 1] = name .. ": loads something from another site"
  end
end
local index = read(dir .. "/data/search.js")
if index then
  local names = {}
  for n in index:match("%[(.-)%]"):gmatch('"([^"]*)"') do names[#names + 1] = n end
  for kind, number, id in index:gmatch('\n%["(%a+)",".-",(%d+),"([^"]*)"') do check("search index", names[tonumber(number) + 1] .. (id ~= "" and "#" .. id or "")) end
end
for i, e in ipairs(errors) do if i <= 40 then print(e) end end
print(string.format("%d pages, %d links, %d to other sites, %d errors", #pages, count, outside, #errors))
os.exit(#errors == 0)
