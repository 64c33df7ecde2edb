-- class.lua: is the class's list what tests/course/class.sh wants?   lua class.lua grades.csv want [WHO]
package.path = "tangle/?.lua;" .. package.path
local Csv = require "csv"
local function read(path) local f = assert(io.open(path, "rb")); local s = f:read("a"); f:close(); return s end
local rows = Csv.rows(read(arg[1]))
local raw, n = {}, 0
for l in read(arg[1]):gmatch("[^\n]+") do n = n + 1; raw[n] = l end
local head = table.remove(rows, 1)
table.remove(raw, 1)
local at = {}
for i, name in ipairs(head) do at[name] = i end
if arg[3] then                              -- the folder of somebody's submission
  for _, r in ipairs(rows) do if r[at.student] == arg[3] and r[at.folder] ~= "" then print(r[at.folder]) os.exit(0) end end
  os.exit(1)
end
local bad = 0
local function complain(...) bad = bad + 1; print("  " .. string.format(...)) end
if #raw ~= #rows then complain("%d lines, %d rows", #raw, #rows) end
for i, r in ipairs(rows) do
  if #r ~= #head then complain("line %d has %d cells, not %d: %s", i + 1, #r, #head, raw[i]) end
  for _, cell in ipairs(r) do if cell:match("^[=@|]") or cell:match("^[+%-]") and not tonumber(cell) or cell:match("%c") then complain("line %d: a cell that a spreadsheet obeys: %s", i + 1, cell) end end
end
for l in read(arg[2]):gmatch("[^\n]+") do
  local who, exercise, earned, pattern = l:match("^(.-)\t(.-)\t(.-)\t(.*)$")
  local found, first = false, nil
  for i, r in ipairs(rows) do
    if r[at.student] == who and r[at.exercise] == exercise then
      first = first or raw[i]
      for p in (pattern .. "\\|"):gmatch("(.-)\\|") do if r[at.earned] == earned and (raw[i]:find(p) or raw[i]:find(p, 1, true)) then found = true end end
    end
  end
  if not found then complain("%s, %s: not %s points and \"%s\" but: %s", who, exercise, earned, pattern, first or "no row") end
end
os.exit(bad == 0 and 0 or 1)
