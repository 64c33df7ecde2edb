-- Judges each requirement of book/evaluation.tsv by what the last run of tests/run found and by measured data; prints CSV.
-- A line of that file: number, requirement, the report's own verdict, tests, a figure in words, a condition.
--   tests: names of unit tests (test_narrow_phase) and of steps of tests/run (step:install)
--   figure and condition may hold {file|column=value|column}: a cell of book/data/file.csv; {file|#}: how many rows it has;
--   {file|#column=value&column=value}: how many of them; {file|max|column}, {file|min|column}, {file|sum|column}: of the numbers of a column;
--   {exact}: how many exact measurements there are
-- It reads data by tangle/csv.lua; TANGLE names that directory to who runs it elsewhere.
package.path = (os.getenv("TANGLE") or "tangle") .. "/?.lua;" .. package.path
local Csv = require "csv"
local bad = 0
local function complain(line, text) io.stderr:write(("book/evaluation.tsv:%d: %s\n"):format(line, text)); bad = bad + 1 end
local function read(path) local f = io.open(path, "rb"); if not f then return nil end; local s = f:read("a"); f:close(); return s end

local tables = {}
local function data(file, line)
  if tables[file] then return tables[file] end
  local text, t = read("book/data/" .. file .. ".csv"), { rows = {}, at = {} }
  if not text then complain(line, "there is no book/data/" .. file .. ".csv -- measure it: build/bin/weft-lab run " .. file) return nil end
  for k, row in ipairs(Csv.rows(text)) do
    if k == 1 then for i, name in ipairs(row) do t.at[name] = i end else t.rows[k - 1] = row end
  end
  tables[file] = t
  return t
end

local function look(key, line)
  if key == "exact" then
    local n = (read("build/check/data.log") or ""):match("(%d+) exact measurements give")
    if not n then complain(line, "the step data has not passed -- type: tests/run data") end
    return n
  end
  local file, what, column = key:match("^([^|]+)|([^|]+)|?(.*)$")
  local t = file and data(file, line)
  if not t then return nil end
  local function col(name)
    if not t.at[name] then complain(line, ("book/data/%s.csv has no column '%s'"):format(file, name)) end
    return t.at[name] or 1
  end
  local name, value = what:match("^#?(.-)=(.*)$")
  if what:match("^#") then
    local n = 0
    for _, row in ipairs(t.rows) do
      local all = true
      for k, v in what:sub(2):gmatch("([^=&]+)=([^&]*)") do all = all and row[col(k)] == v end
      if all then n = n + 1 end
    end
    return tostring(n)
  end
  local best, sum
  for _, row in ipairs(t.rows) do
    local cell = row[col(column)]
    if name then if row[col(name)] == value then return cell end
    else
      local n = tonumber(cell)
      if n then sum = (sum or 0) + n end
      if n and (not best or (what == "max" and n > best) or (what == "min" and n < best)) then best = n end
    end
  end
  if what == "sum" and sum then return ("%.0f"):format(sum) end
  if best then return ("%.4g"):format(best) end
  complain(line, ("no row for {%s}"):format(key))
end
local function fill(text, line) return (text:gsub("{(.-)}", function(key) return look(key, line) or "?" end)) end

-- Did the tests pass? A unit test counts if it passed in every build that has run.
local logs = {}
for _, build in ipairs { "gcc", "sanitized", "double" } do logs[#logs + 1] = read("build/check/unit_" .. build .. ".log") end
local function passed(test, line)
  local step = test:match("^step:(.*)$")
  if step then
    local r = read("build/check/" .. step .. ".result")
    if not r then complain(line, "the step " .. step .. " has not run -- type: tests/run " .. step) return false end
    if r:match("^skip") then complain(line, "the step " .. step .. " was skipped, which proves nothing -- build/check/" .. step .. ".log says what it lacks") end
    return r:match("^ok") ~= nil
  end
  if #logs == 0 then complain(line, "no unit tests have run -- type: tests/run unit_gcc") return false end
  local seen = false
  for _, log in ipairs(logs) do
    if log:find("FAIL  %S*" .. test .. "%f[%s]") then return false end
    seen = seen or log:find("ok    " .. test .. ":", 1, true) ~= nil
  end
  if not seen then complain(line, "no test called " .. test .. " has run -- mend the name, or type: tests/run unit_gcc") end
  return seen
end

print("# command: make evaluation")
print("number,kind,requirement,report,verdict,figure,tests")
local line = 0
for l in io.lines("book/evaluation.tsv") do
  line = line + 1
  if l:match("%S") and not l:match("^#") then
    local f = {}
    for cell in (l .. "\t"):gmatch("([^\t]*)\t") do f[#f + 1] = cell end
    if #f ~= 6 then complain(line, ("six fields are wanted, there are %d"):format(#f))
    else
      local good, names = true, {}
      for test in f[4]:gmatch("%S+") do
        good = passed(test, line) and good
        names[#names + 1] = (test:gsub("^step:", "tests/run "))
      end
      local condition, why = load("return " .. fill(f[6], line))
      if not condition then complain(line, "the condition cannot be read: " .. why) end
      local kept = condition and condition()
      local verdict = not good and "not achieved: a test fails" or kept and "achieved" or "achieved in part"
      print(('%s,%s,"%s",%s,%s,"%s","%s"'):format(f[1], f[1]:match("^%a+"), f[2], f[3], verdict, fill(f[5], line), table.concat(names, ", ")))
    end
  end
end
os.exit(bad == 0 and 0 or 1)
