-- mathml.lua: the last touch to a page: brackets that need not stretch do not (see weave-code.lua).  lua mathml.lua < page > page
package.path = (arg[0]:match("^(.*/)") or "./") .. "?.lua;" .. package.path
io.write((require "weave-code").calm_brackets(io.read("a")))
