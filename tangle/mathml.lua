-- mathml.lua: the last touch to a page's formulas.  lua mathml.lua < page > page
-- Brackets that need not stretch do not (see weave-code.lua); the rest are signs that pandoc writes in a way that browsers
-- set badly: a norm's bars, an upright d, dots above a letter, a minus that is a sign and not a difference.
package.path = (arg[0]:match("^(.*/)") or "./") .. "?.lua;" .. package.path
local s = (require "weave-code").calm_brackets(io.read("a"))
s = s:gsub("\u{2225}", "\u{2016}")
s = s:gsub('<mstyle mathvariant="normal"><mi>([^<]*)</mi></mstyle>', '<mi mathvariant="normal">%1</mi>')
s = s:gsub('<mstyle mathvariant="normal">(.-)</mstyle>', function(unit)      -- browsers slant a single letter unless it says itself that it is upright
  return unit:find("<mstyle", 1, true) and nil or (unit:gsub("<mi>([^<]*)</mi>", '<mi mathvariant="normal">%1</mi>'))
end)
s = s:gsub('(<mo accent="true">)\u{307}(</mo>)', "%1\u{2d9}%2")
s = s:gsub('(<mo accent="true">)\u{308}(</mo>)', "%1\u{a8}%2")
s = s:gsub('(form="prefix">[^<]*</mo>)<mo>\u{2212}</mo>', '%1<mo form="prefix">\u{2212}</mo>')
s = s:gsub('(<mo>[,=\u{2190}\u{2261}]+</mo>)<mo>\u{2212}</mo>', '%1<mo form="prefix">\u{2212}</mo>')
-- a browser may break a line between a formula and the comma behind it
s = s:gsub('(<math display="inline".-</math>)([^<%s]*)', function(formula, text)
  local sign = text:match("^[%.,;:!?%)]+")
  return sign and '<span class="nw">' .. formula .. sign .. "</span>" .. text:sub(#sign + 1)
end)
io.write(s)
