-- looks.lua: each look at a submission, alone. In a class one of them refuses what another one would have let pass; here each has its
-- own bait, so that none is there in vain.   lua tests/course/looks.lua SCRATCH
local dir = arg[1]
arg = { [0] = "tangle/course.lua", "number", "none" }
local said = print
print = function() end
local Course = dofile("tangle/course.lua")
print = said
local Refuse = require "refuse"
local bad = 0
local function write(path, s) local f = assert(io.open(path, "wb")); f:write(s); f:close() end
local function run(command) local p = io.popen(command); local s = p:read("a"); p:close(); return s end
local function check(what, list, wanted)
  for _, m in ipairs(list) do if m[2]:find(wanted, 1, true) then return end end
  bad = bad + 1
  said(string.format("  %s: \"%s\" is not refused", what, wanted))
end
local n = 0
local function object(text, flags)
  n = n + 1
  local c = dir .. "/bait" .. n .. ".c"
  write(c, text)
  assert(os.execute("cc -std=gnu11 -O1 -gdwarf-4 -fno-pie " .. (flags or "") .. " -w -c " .. c .. " -o " .. c .. ".o"), "a bait does not compile")
  return c .. ".o", c
end
local function nobody() return false end
local function all() return true end
for section, text in pairs { [".init_array"] = "int k; static void f(void) __attribute__((constructor)); static void f(void) { k = 1; }", [".fini_array"] = "int k; static void f(void) __attribute__((destructor)); static void f(void) { k = 1; }",
    [".ctors"] = 'static void (*h)(void) __attribute__((section(".ctors"), used)) = 0;', [".mine"] = 'int h __attribute__((section(".mine"))) = 1;' } do
  check("sections", Refuse.object(run, (object(text)), nobody), "the section " .. section)
end
check("weak", Refuse.object(run, (object("int f(void) __attribute__((weak)); int f(void) { return 1; }")), nobody), "the symbol f is weak")
check("chosen at load", Refuse.object(run, (object("static int g(void) { return 1; } static void *c(void) { return g; } int f(void) __attribute__((ifunc(\"c\")));")), nobody), "the symbol f is weak")
check("wants", Refuse.object(run, (object("int system(const char *); int f(void) { return system(\"x\"); }")), nobody), "a call or use of system")
check("wants data", Refuse.object(run, (object("extern char **environ; char **f(void) { return environ; }")), nobody), "a call or use of environ")
check("stack", Refuse.object(run, (object("int a(int (*f)(int)); int n(int k) { int h(int i) { return i + k; } return a(h); }")), all), "code on the stack")
for word, text in pairs { syscall = 'void f(void) { __asm__ volatile ("syscall"); }', int = 'void f(void) { __asm__ volatile ("int $0x80"); }', ldmxcsr = 'unsigned m; void f(void) { __asm__ volatile ("ldmxcsr %0" : : "m" (m)); }' } do
  if run("uname -m"):match("x86_64") then local o, c = object(text); check("instructions", Refuse.instructions(run, o, c, {}, nobody), "the instruction " .. word) end
end
local o, c = object("int (*p)(int); int f(void) { return p(1) + 1; } int g(void) { return p(2); }")
check("pointers", Refuse.instructions(run, o, c, {}, nobody), "a call through a pointer")
check("pointers, elsewhere", Refuse.instructions(run, (object('#line 9 "other.c"\nint (*p)(int); int f(void) { return p(1) + 1; }')), c, {}, nobody), "a call through a pointer")
for word, text in pairs { asm = 'asm("nop");', ["__asm__"] = '__asm__("nop");', ["__attribute__"] = "__attribute__((used)) int x;", ["goto by an address"] = "goto *p;", ["an attribute, [[...]]"] = "[[noreturn]] void f(void);",
    ["__builtin_return_address"] = "__builtin_return_address(0);", ["#pragma or another directive"] = "#pragma GCC optimize 0", typeof = "typeof(1) x;" } do
  check("words", Refuse.preprocessed('# 5 "mine.nw"\n' .. text .. "\n", "mine.nw", nobody), word)
  check("words of a line that lies", Refuse.preprocessed('# 1 "mine.c"\n# 5 "mine.nw"\n# 1 "other.c"\n' .. text .. "\n", "mine.nw", nobody), word)
end
assert(#Refuse.preprocessed('# 1 "mine.c"\n# 1 "/usr/include/x.h" 1 3\nextern int f(void) __asm__("g") __attribute__((x));\n# 2 "mine.c" 2\n# 5 "mine.nw"\nint x;\n', "mine.nw", nobody) == 0, "a header's words are taken for the submission's")

-- the judge's line: whatever stands in it, nothing is believed but a count that is the solution's, for the criterion that was asked for
local function graded(line)
  local r = { base = "still", file = "still.nw", program = "p", chunks = { list = {} }, earned = 0, criteria = { { name = "rest", points = 1, hole = "x" } } }
  Course.run(r, function() return line end, function(_, at) for _, a in ipairs(at) do assert(a:match("^0x%x+$"), "an address that is none goes into a shell") end return "" end)
  local c = r.criteria[1]
  for _, k in ipairs { "what", "expected", "got" } do
    if c[k] and (#c[k] > 400 or c[k]:match("%c")) then bad = bad + 1; said("  a field of the verdict is not bounded and clean") end
  end
  return r.earned, c
end
local want = tonumber(run("grep '^still,rest,' tests/course/expectations.csv"):match("(%d+)%s*$"))
assert(graded("rest\tpass\t" .. want .. "\n") == 1, "a verdict that is right has no points")
for _, line in ipairs { "", "\n", "rest", "rest\tpass", "rest\tpass\t", "rest\tpass\t1", "rest\tpass\t" .. want + 1, "rest\tPASS\t" .. want, "none\tpass\t" .. want, "x\nrest\tpass\t" .. want, "rest\tfail\t" .. ("x"):rep(100000),
    "rest\tfail\ta\27[2J\tb\1\tc\127", "rest\tcrash\t11\t$(touch escaped)\t;ls", "rest\tcall\t1\tff;id", "rest\tundefined\tx\t../../etc/passwd:1", "rest\tmemory\t" .. ("\0"):rep(9000), "rest\tpass\t0x" .. string.format("%x", want + 1), "rest\tpass\tnan", ("rest"):rep(5000) } do
  if graded(line) ~= 0 then bad = bad + 1; said("  points for the line " .. line:sub(1, 60)) end
end
os.exit(bad == 0 and 0 or 1)
