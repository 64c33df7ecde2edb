-- circles.lua: no circle of files, by what the linker sees.
--
--   lua circles.lua DIRECTORY-OF-OBJECTS FOLDER ...
--
-- In each folder a file that uses a function or a table of another file depends on it. Those arrows must not lead back: the files
-- lie on floors. The first circle of each folder is told with the names that close it, and fails the test.
local dir = arg[1]
local failed, told = false, {}
for k = 2, #arg do
  local folder = arg[k]
  local owner, needs, files = {}, {}, {}
  local pipe = assert(io.popen("nm -A -P " .. dir .. "/" .. folder .. "/*.o"))
  for l in pipe:lines() do
    local file, name, kind = l:match("([^/]+)%.o: (%S+) (%a)")
    if file then
      if not needs[file] then needs[file] = {}; files[#files + 1] = file end
      if kind == "U" then needs[file][#needs[file] + 1] = name
      elseif kind:match("[A-Z]") then owner[name] = file end
    end
  end
  assert(pipe:close(), "circles: nm fails on " .. dir .. "/" .. folder)
  assert(#files > 0, "circles: no objects in " .. dir .. "/" .. folder)
  table.sort(files)
  local arrows, count = {}, 0                      -- arrows[a][b]: a symbol of b that a uses
  for _, f in ipairs(files) do
    arrows[f] = {}
    table.sort(needs[f])
    for _, name in ipairs(needs[f]) do
      local to = owner[name]
      if to and to ~= f and not arrows[f][to] then arrows[f][to] = name; count = count + 1 end
    end
  end
  -- the shortest way from one file back to itself, over all files: breadth first
  local best
  for _, start in ipairs(files) do
    local from, queue, head = {}, { start }, 1
    while queue[head] do
      local at = queue[head]
      head = head + 1
      local ends = {}
      for to in pairs(arrows[at]) do ends[#ends + 1] = to end
      table.sort(ends)
      for _, to in ipairs(ends) do
        if not from[to] then from[to] = at; queue[#queue + 1] = to end
      end
      if from[start] then break end
    end
    if from[start] then
      local way, at = { start }, from[start]
      while at ~= start do table.insert(way, 1, at); at = from[at] end
      table.insert(way, 1, start)
      if not best or #way < #best then best = way end
    end
  end
  if best then
    failed = true
    local t = {}
    for i = 1, #best - 1 do t[#t + 1] = best[i] .. ".c needs " .. arrows[best[i]][best[i + 1]] .. " of " .. best[i + 1] .. ".c" end
    print("circle in " .. folder .. "/: " .. table.concat(t, ", and "))
  else
    told[#told + 1] = folder .. " " .. #files .. " files, " .. count .. " arrows"
  end
end
if failed then
  print("circles: move what both need to a file below the two")
  os.exit(1)
end
print("no circle: " .. table.concat(told, "; "))
