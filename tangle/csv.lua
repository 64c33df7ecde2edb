-- csv.lua: the measured data as Lua tables, for the book's tables (filter.lua) and for the verdicts (tests/evaluate/evaluate.lua).
--   local Csv = require "csv"
--   Csv.rows(text)    a list of lines, each a list of cells without blanks at their ends; empty lines and those that begin with # are left out
local Csv = {}

function Csv.cells(line)      -- a cell in quotes may hold commas; "" is a quote in it
  local cells, cell, quoted, i = {}, "", false, 1
  local function finish() cells[#cells + 1] = cell:match("^%s*(.-)%s*$"); cell = "" end
  while i <= #line do
    local c = line:sub(i, i)
    if quoted and line:sub(i, i + 1) == '""' then cell = cell .. '"'; i = i + 1
    elseif c == '"' then quoted = not quoted
    elseif c == "," and not quoted then finish()
    else cell = cell .. c end
    i = i + 1
  end
  finish()
  return cells
end

function Csv.rows(text)
  local rows = {}
  for line in text:gmatch("[^\r\n]+") do
    if not line:match("^#") and line:match("%S") then rows[#rows + 1] = Csv.cells(line) end
  end
  return rows
end

return Csv
