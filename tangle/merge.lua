-- merge.lua: a chapter that was woven alone, among those that were woven before.   lua merge.lua OUT WEAVE CHAPTER
-- Writes OUT/weave/db.lua, and tells those of OUT/errors that are the chapter's own.
local out, weave, chapter = arg[1], arg[2], arg[3]
local all, own = dofile(weave .. "/db.lua"), dofile(out .. "/alone/db.lua")
for key, t in pairs(own) do
  if type(t) == "table" and type(all[key]) == "table" then
    if #t > 0 then                              -- a list: entries of the plan, of which the old ones stay
      local there = {}
      for i, e in ipairs(all[key]) do if type(e) == "table" and e.name then there[e.name] = i end end
      for _, e in ipairs(t) do
        local i = type(e) == "table" and e.name and there[e.name]
        if i and e.page then all[key][i] = e elseif type(e) == "table" and e.name and not i then table.insert(all[key], e) end
      end
    else for k, v in pairs(t) do if all[key][k] == nil or type(v) ~= "table" or (v.page or ""):find(chapter:match("([%w_-]+)%.nw$"):gsub("^%w+%-", ""), 1, true) then all[key][k] = v end end end
  elseif all[key] == nil then all[key] = t end
end
local function put(f, v)
  if type(v) == "table" then
    f:write("{")
    for k, x in pairs(v) do f:write("[", type(k) == "string" and string.format("%q", k) or tostring(k), "]="); put(f, x); f:write(",\n") end
    f:write("}")
  else f:write(type(v) == "string" and string.format("%q", v) or tostring(v)) end
end
local f = assert(io.open(out .. "/weave/db.lua", "w"))
f:write("return ")
put(f, all)
f:close()
local known = {}
for _, t in pairs(all) do if type(t) == "table" then for k in pairs(t) do known[k] = true end end end
for l in io.lines(out .. "/errors") do
  local label = l:match("nothing is labelled (%S+)")
  if l:sub(1, #chapter + 1) == chapter .. ":" and not (label and known[label]) and not l:find("is defined but never used", 1, true) then print(l) end
end
