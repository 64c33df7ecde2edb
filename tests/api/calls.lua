-- calls.lua: a C program that calls every public function with nothing: NULL for each pointer, zeros for all else.
--   lua calls.lua HEADER ...
local function read(path) local f = assert(io.open(path)); local t = f:read("a"); f:close(); return t end
local calls, seen = {}, {}
for _, path in ipairs(arg) do
  local text = read(path):gsub("#ifdef __cplusplus\nextern.-#endif", ""):gsub("#ifdef __cplusplus\n}\n#endif", ""):gsub("/%*.-%*/", " "):gsub("\\\n", " "):gsub("\n%s*#[^\n]*", "\n"):gsub("^%s*#[^\n]*", "")
  local depth, statement = 0, {}
  -- what stands outside of braces, up to each semicolon
  for c in text:gmatch(".") do
    if c == "{" then depth = depth + 1 elseif c == "}" then depth = depth - 1; if depth == 0 then statement[#statement + 1] = "{}" end
    elseif depth == 0 and c == ";" then
      local s = table.concat(statement):gsub("%s+", " ")
      statement = {}
      local name, params = s:match("^%s*[%w_ %*]-%f[%w]([%a_][%w_]*) ?%((.*)%)%s*$")
      if name and name:match("^wf") and not s:match("typedef") and not s:match("{}") and not seen[name] then
        seen[name] = true
        local args = {}
        local level, one = 0, ""
        for p in (params .. ","):gmatch(".") do
          if p == "(" then level = level + 1 elseif p == ")" then level = level - 1 end
          if p == "," and level == 0 then args[#args + 1] = one; one = "" else one = one .. p end
        end
        for i, a in ipairs(args) do
          if a:match("^%s*void%s*$") then args[i] = nil
          elseif a:match("%*") or a:match("%[") then args[i] = "NULL"
          else
            local t = a:gsub("^%s+", ""):gsub("[%w_]+%s*$", ""):gsub("^const ", "")
            if t:match("^%s*$") then t = a end
            args[i] = "(" .. t .. "){ 0 }"
          end
        end
        calls[#calls + 1] = { name = name, args = table.concat(args, ", "), header = path:match("weft/(.*)$") }
      end
    else statement[#statement + 1] = c end
  end
end
table.sort(calls, function(a, b) return a.name < b.name end)
for _, path in ipairs(arg) do if not path:match("_rows%.h$") then print('#include "weft/' .. path:match("weft/(.*)$") .. '"') end end
for _, c in ipairs(calls) do print(("static void call_%s(void) { (void)%s(%s); }"):format(c.name, c.name, c.args)) end
print("typedef struct Call { const char *name, *header; void (*call)(void); } Call;\nstatic const Call calls[] = {")
for _, c in ipairs(calls) do print(('    { "%s", "%s", call_%s },'):format(c.name, c.header, c.name)) end
print("};")
