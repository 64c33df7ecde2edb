-- journal.lua: every public function that may change a world is an input of the replay, or is listed with the reason why not. (A world
-- that is called `out` is made, not changed.)
--   lua journal.lua LIST REPLAY.c HEADER ...
local function read(path) local f = assert(io.open(path)); local t = f:read("a"); f:close(); return t end
local replay, why, bad, journalled = read(arg[2]), {}, false, 0
local function complain(text) print("journal: " .. text); bad = true end
for line in io.lines(arg[1]) do
  local name, reason = line:match("^(wf%w+)%s+(%S.*)$")
  if name then why[name] = reason elseif not line:match("^#") then complain("a line of " .. arg[1] .. " is no name and reason: " .. line) end
end
local changes, found = {}, 0
for i = 3, #arg do
  local text = read(arg[i]):gsub("/%*.-%*/", " "):gsub("\n%s*#[^\n]*", "\n")
  for statement in text:gmatch("[^;{}]+;") do
    local name, params = statement:match("([%w_]+)%s*(%b())%s*;$")
    if name and name:match("^wf") and not statement:match("typedef") and params:gsub("const wfWorld", ""):gsub("struct wfWorld", ""):gsub("wfWorld %*out", ""):match("wfWorld%s*%*") then changes[name] = arg[i]; found = found + 1 end
  end
end
for name, header in pairs(changes) do
  local given = replay:match("[^%w]" .. name .. "%(") ~= nil and not replay:match("\nwfResult " .. name .. "%(")
  if given then journalled = journalled + 1 end
  if given and why[name] then complain(name .. " is an input; take it off " .. arg[1]) end
  if not given and not why[name] then complain(name .. " of " .. header .. " may change a world, and is no input of " .. arg[2] .. ": give it a kind of input, or say in " .. arg[1] .. " why it needs none") end
end
for name in pairs(why) do if not changes[name] then complain(name .. " of " .. arg[1] .. " is no public function that may change a world") end end
if journalled < 30 then complain("only " .. journalled .. " inputs were found") end
if not bad then print("journal: of " .. found .. " functions that may change a world " .. journalled .. " are inputs of the replay; the others are listed, each with its reason") end
os.exit(not bad)
