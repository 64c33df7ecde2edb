-- woven.lua: what the book of an engine prints is what that engine is tangled from, line by line, both ways.
-- (WF_ABSENT rows are no code of it: they tell what it lacks.)
--   lua woven.lua WEAVE SRC       the directory of the woven chapters, the tangled tree
local weave, src = arg[1], arg[2]
local function read(path) local f = assert(io.open(path, "rb")) local s = f:read("a") f:close() return s end
-- a label in a comment, its number on the page and in the tangled tree (eq:sag, Eq. (7.3), Section 7.3) count as the same
local function trim(s)
  s = s:gsub("@?%f[%a]sec:[%w_%-]*%w", "Section 0"):gsub("@?%f[%a]eq:[%w_%-]*%w", "Section 0"):gsub("Eq%. %b()", "Section 0")
  return (s:gsub("Section %u?%d[%d%.]*%f[^%d]", "Section 0"):gsub("Section %u%.[%d%.]*%d", "Section 0"):gsub("Chapter %u?%d+", "Section 0"):gsub("Appendix %u", "Section 0"):gsub("^%s+", ""):gsub("%s+$", ""))
end
local woven, n = {}, 0
for base in read(weave .. "/bases"):gmatch("[^\n]+") do
  local mine = dofile(weave .. "/" .. base .. ".lua")
  for k in read(weave .. "/" .. base .. ".md"):gmatch("```{=weftchunk}\n(%d+)\n") do
    for _, row in ipairs((mine.chunks[tonumber(k)] or error(base .. " prints a chunk " .. k .. " that it has not")).lines) do
      local t, use = {}, false
      for i, token in ipairs(row) do t[i] = token[2]; use = use or token[1] == "use" end
      local s = trim(table.concat(t))
      if s ~= "" and not use then woven[s] = base; n = n + 1 end
    end
  end
end
local there, bad = {}, 0
for name in io.popen("find '" .. src .. "' -name '*.[ch]'"):lines() do
  local absent, head = false, true                                    -- the loom's own comment, as far as the first line that ends it
  for l in read(name):gmatch("[^\n]+") do
    local s = trim(l)
    there[s] = true
    absent = s:match("^WF_ABSENT%(") or absent and not absent:match("%)$") and s
    if not head and s ~= "" and not absent and not woven[s] and not s:match("^/%*.*%*/$") then
      bad = bad + 1
      if bad <= 5 then print(name .. " has a line that no page shows: " .. s) end
    end
    if s:match("%*/$") then head = false end
  end
end
for s, base in pairs(woven) do
  if not there[s] and not s:match("^/%*") and not s:match("^%*") then
    bad = bad + 1
    if bad <= 10 then print(base .. " shows a line that the engine has not: " .. s) end
  end
end
if n < 500 then bad = bad + 1 print("only " .. n .. " lines of code were found on the pages") end
os.exit(bad == 0)
