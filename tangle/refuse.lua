-- refuse.lua: what no exercise needs. A submission runs in the same program as the criteria, so four looks are taken at it before it
-- runs: at its text, at its words after the preprocessor, at the names that its object wants and gives, and at its instructions.
-- Each look returns a list of { line, what }; the line is that of the submission, or nil.
local Refuse = {}
local MOST_BYTES, MOST_COLUMNS = 262144, 4000

local function set(words) local t = {} for w in words:gmatch("%S+") do t[w] = true end return t end
-- What an object may want besides the engine's names and those of its own exercise.
local FUNCTIONS = set [[
  memcpy memmove memset memcmp strlen strcmp strncmp strchr abs labs llabs
  malloc calloc realloc free printf puts putchar fprintf fputs fputc putc fwrite snprintf sprintf vsnprintf stdout stderr
  __assert_fail __errno_location __stack_chk_fail _GLOBAL_OFFSET_TABLE_
  __printf_chk __fprintf_chk __snprintf_chk __sprintf_chk __memcpy_chk __memmove_chk __memset_chk ]]
for w in ([[ acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh erf erfc exp exp2 expm1 fabs fdim floor fma fmax fmin fmod
  frexp hypot ilogb ldexp lgamma llrint llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter nexttoward pow
  remainder remquo rint round scalbln scalbn sin sincos sinh sqrt tan tanh tgamma trunc ]]):gmatch("%S+") do
  FUNCTIONS[w], FUNCTIONS[w .. "f"], FUNCTIONS[w .. "l"] = true, true, true
end
Refuse.functions = FUNCTIONS
-- Words with two underscores, or one and a capital, that the headers' macros make.
local RESERVED = set [[ _Bool _Static_assert _Alignas _Alignof _Generic _Noreturn _Thread_local __func__ __LINE__ __extension__
  __PRETTY_FUNCTION__ __assert_fail __FILE__ __builtin_offsetof __builtin_expect __builtin_nan __builtin_nanf __builtin_inf __builtin_inff
  __builtin_huge_val __builtin_huge_valf __builtin_isnan __builtin_isinf __builtin_isinf_sign __builtin_isfinite __builtin_isnormal
  __builtin_signbit __builtin_fpclassify __builtin_isgreater __builtin_isgreaterequal __builtin_isless __builtin_islessequal
  __builtin_islessgreater __builtin_isunordered __builtin_va_arg __builtin_va_start __builtin_va_end __builtin_va_list __errno_location
  __restrict __inline __const ]]
local HEADERS = set [[ assert.h float.h inttypes.h limits.h math.h stdalign.h stdbool.h stddef.h stdint.h stdio.h stdlib.h string.h tgmath.h ]]
local DIRECTIVES = set [[ include define if ifdef ifndef elif else endif error ]]

local function read(path) local f = io.open(path, "rb"); if not f then return nil end local s = f:read("a"); f:close(); return s end
local function lines(s) return ((s or "") .. "\n"):gmatch("(.-)\r?\n") end

-- Is it a text that may be looked at line by line? Before anything else: the other looks are not made for what takes hours to read.
function Refuse.size(path)
  local f = io.open(path, "rb")
  if not f then return "it cannot be read" end
  local s = f:read(MOST_BYTES + 1) or ""
  f:close()
  if #s > MOST_BYTES then return string.format("it is larger than %d bytes", MOST_BYTES) end
  if s:find("\0", 1, true) then return "it is not a text: there is a zero byte in it" end
  for l in (s .. "\n"):gmatch("([^\n]*)\n") do if #l > MOST_COLUMNS then return string.format("a line has more than %d characters", MOST_COLUMNS) end end
end

-- Its text. chunks: what the loom's reader found in it; given: the same of the starter; book(): the names of all chunks of the book.
function Refuse.text(path, chunks, given, book)
  local t = {}
  local function bad(n, ...) t[#t + 1] = { n, string.format(...) } end
  local of_book
  for _, c in ipairs(chunks.list) do
    if not given.defined[c.name] and not given.used[c.name] then
      of_book = of_book or book()
      if of_book[c.name] then bad(c.from, "<<%s>> is a chunk of the book, and this exercise does not add to it", c.name)
      elseif c.name:match("%.[ch]p*$") or c.name:match("/") then bad(c.from, "<<%s>> is a file that this exercise does not have", c.name) end
    end
  end
  local n, inside, before, from = 0, false, "", nil
  local function directive_in(plain)
    local directive = plain:match("^%s*#%s*([^%s<\"(]*)")
    if not directive then return false end
    if not DIRECTIVES[directive] then bad(from, "#%s", directive:sub(1, 20)) end
    if directive == "include" then
      local bare = plain:gsub("%s+//.*$", "")
      local system, own = bare:match("^%s*#%s*include%s*<([^>]*)>%s*$"), bare:match('^%s*#%s*include%s*"([^"]*)"%s*$')
      if not (system and HEADERS[system]) and not (own and own:match("^[%w_]+/[%w_]+%.h$")) then bad(from, "#include of something else than <math.h> and its like, or the book's headers") end
    elseif directive == "define" then
      local name = plain:match("define%s+([%w_]+)")
      if not name or Refuse.known[name] then bad(from, "#define %s, which has a meaning already", name or "?") end
      if plain:find("##", 1, true) then bad(from, "## in a macro") end
    end
    if plain:match("%f[%w_]__%w") then bad(from, "a word with two underscores in a directive") end
    return true
  end
  local function close() if inside and before ~= "" then bad(from, "a chunk that ends in a backslash: what stands behind it would be swallowed") end before = "" end
  for l in lines(read(path)) do
    n = n + 1
    if l:match("^<<.->>=%s*$") then close(); inside = true
    elseif l == "@" or l:match("^@ ") then close(); inside = false
    elseif inside then
      from = before == "" and n or from
      local whole = before .. l
      before = ""
      if l:match("%f[%w_][uUL]?8?R\"") then bad(n, "a raw string: it may hold lines that look like a directive's") end
      if l:match("\\%s*$") then
        before = whole:gsub("\\%s*$", "")
        if before == "" then before = " " end
      else
        -- a directive, even if a comment stands before its sign, or seems to: nothing is won by a better reading
        local plain = whole:gsub("/%*.-%*/", " "):gsub("%%:", "#"):gsub("%?%?=", "#")
        if not directive_in(plain) then directive_in((plain:gsub("^.*%*/", ""))) end
        local uses = whole:gsub("@<<", ""):gsub("@>>", "")
        local alone = uses:match("^%s*<<(.-)>>%s*$")
        if uses:match("<<.->>") and not (alone and not alone:find("<<", 1, true) and not alone:find(">>", 1, true)) then bad(from, "a chunk is used beside other text -- give it a line of its own") end
      end
    end
  end
  close()
  return t
end

-- Words of C from text: calls word(text, line) for each.
local function words(text, line, word)
  local i = 1
  while i <= #text do
    local w = text:match("^[%a_$][%w_$]*", i)
    if w then word(w, line); i = i + #w
    else
      local c = text:sub(i, i)
      if c == '"' or c == "'" then
        i = i + 1
        while i <= #text and text:sub(i, i) ~= c do i = i + (text:sub(i, i) == "\\" and 2 or 1) end
        i = i + 1
      else
        local number = text:match("^%.?%d[%w_%.]*", i)
        if number then i = i + #number
        else
          local two = text:sub(i, i + 1)
          if two == "<:" or two == "%:" or two == "&&" then word(two == "<:" and "[" or two == "%:" and "#" or two, line); i = i + 2
          else
            if not c:match("%s") then word(c, line) end
            i = i + 1
          end
        end
      end
    end
  end
end
Refuse.words = words

-- What the preprocessor made of it: the lines that come from the submission, and all others that no header gave. The second holds even
-- if a line has got through that says where it comes from and lies; own(path): is that a file of the book's?
function Refuse.preprocessed(text, file, own)
  local t, mine, n, seen, depth = {}, false, 0, {}, 0
  local previous
  local function bad(line, what) if not seen[what .. (line or "")] then seen[what .. (line or "")] = true; t[#t + 1] = { line, what } end end
  local function word(w, line)
    if w == "asm" or w == "typeof" then bad(line, w)
    elseif (w:match("^__") or w:match("^_%u")) and not RESERVED[w] then bad(line, w)
    elseif w == "[" and previous == "[" then bad(line, "an attribute, [[...]]")
    elseif w == "*" and previous == "goto" then bad(line, "goto by an address")
    end
    previous = w
  end
  for l in lines(text) do
    local at, path, flags = l:match('^# (%d+) "(.-)"(.*)')
    if at then
      depth = math.max(0, depth + (flags:match("^ 1") and 1 or flags:match("^ 2") and -1 or 0))
      n, mine = tonumber(at) - 1, path == file or depth == 0 and not path:match("^<") and not own(path)
      if path ~= file then n = nil end
    else
      n = n and n + 1
      if mine and l:match("^%s*#") then bad(n, "#pragma or another directive")
      elseif mine then words(l, n, word) end
    end
  end
  return t
end

-- nm, told what it reads: else it first loads whatever plugin is there for objects of other kinds, which takes ten times as long.
local linux = io.open("/lib64/ld-linux-x86-64.so.2")
Refuse.nm = linux and linux:close() and "nm --target=elf64-x86-64" or "nm"

-- An object's names and sections. allowed(name): may it want that? Returns the list, and the names that it gives.
function Refuse.object(run, object, allowed)
  local t, gives = {}, {}
  local function bad(...) t[#t + 1] = { nil, string.format(...) } end
  for l in lines(run(Refuse.nm .. " " .. object)) do
    local kind, name = l:match("%s(%a)%s(%S+)$")
    if kind == "U" then if not FUNCTIONS[name] and not allowed(name) then bad("a call or use of %s", name) end
    elseif kind and ("iuwvWV"):find(kind, 1, true) then bad("the symbol %s is weak, unique or chosen as it is loaded", name)
    elseif kind and kind:match("%u") and kind ~= "N" then gives[#gives + 1] = name end
  end
  for l in lines(run("readelf -SW " .. object)) do
    local name, flags = l:match("^%s*%[%s*%d+%]%s+(%S+)"), l:match("%s([WAXMSILOGTCxoEDlpyz]*)%s+%d+%s+%d+%s+%d+$")
    if name and name:match("^%.") then
      local plain = name:gsub("^%.rela", "")
      if not (plain:match("^%.text") and not plain:match("startup") or plain:match("^%.rodata") or plain:match("^%.data") or plain:match("^%.bss") or plain:match("^%.tbss") or
              plain:match("^%.tdata") or plain:match("^%.debug") or plain:match("^%.eh_frame") or plain:match("^%.note") or plain:match("^%.group") or
              ({ [".comment"] = 1, [".symtab"] = 1, [".strtab"] = 1, [".shstrtab"] = 1, [".symtab_shndx"] = 1 })[plain]) then
        bad("the section %s", name) end
      if name == ".note.GNU-stack" and flags and flags:find("X") then bad("code on the stack") end
    end
  end
  return t, gives
end

-- Its instructions: none that asks the system or changes how numbers are rounded; and no call or jump through a pointer, in a line that
-- the starter does not have, but for its own such calls. own(path): is that a file of the book's?
local NEVER = set "syscall sysenter int int3 into sysret ldmxcsr fldcw fldenv frstor fxrstor xrstor wrpkru wrfsbase wrgsbase svc hvc msr brk"
function Refuse.instructions(run, object, file, given, own)
  local t, seen = {}, {}
  local mine, line
  local text = {}
  for l in lines(read(file)) do text[#text + 1] = l end
  for l in lines(run("objdump -d -l --no-show-raw-insn " .. object)) do
    local path, at = l:match("^(/?[^%s].-):(%d+)")
    local word = l:match("^%s+%x+:%s+(%S+)")
    if path and not l:match("^%s") then
      local here = path == file or path:sub(-#file - 1) == "/" .. file
      mine, line = here or not own(path:match("chapters/.*") or path), here and tonumber(at)
    elseif word and NEVER[word] then t[#t + 1] = { line or nil, "the instruction " .. word }
    elseif mine and (l:match("%f[%a]call[q]?%s+%*") or l:match("%f[%a]jmp[q]?%s+%*") or l:match("%sblr%s") or l:match("%sbr%s+x")) then
      local words_there = (text[line] or ""):gsub("%s+", "")
      local known = line and given[words_there]
      for _, call in ipairs(given) do known = known or words_there:find(call, 1, true) end
      if not known and not seen[line or 0] then seen[line or 0] = true; t[#t + 1] = { line or nil, "a call through a pointer" } end
    end
  end
  return t
end
return Refuse
