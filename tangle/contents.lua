-- contents.lua: the contents beside a page. A volume is open where its page is read; chapters of the course have the number of their week.
local Code = require "weave-code"
local h = Code.html
return function(db, here, name)
  local t = {}
  local function chapter(e)
    if e.planned then t[#t + 1] = '<li class="planned" title="planned"><span class="n">' .. e.num .. "</span> " .. h(e.title) .. "</li>" return end
    local is_here = e.page == here or e.name == name
    t[#t + 1] = '<li class="' .. (e.week and "track" or "") .. (is_here and " here" or "") .. '"><a href="' .. e.page .. '"><span class="n">' .. e.num .. "</span> " .. h(Code.plain(e.title)) ..
      (e.week and '<i class="wk" title="read in week ' .. e.week .. ' of the course">' .. e.week .. "</i>" or "") .. "</a>"
    if is_here then
      t[#t + 1] = "<ol>"
      for _, x in ipairs(db.heads) do
        if x.page == e.page and x.level == 2 then t[#t + 1] = '<li><a href="' .. Code.href(db, x.page, here, x.id) .. '"><span class="n">' .. x.num .. "</span> " .. h(Code.plain(x.title)) .. "</a></li>" end
      end
      for _, x in ipairs(db.entries) do
        if x.of == e.name then t[#t + 1] = '<li' .. (x.page == here and ' class="here"' or "") .. '><a href="' .. x.page .. '"><span class="n">' .. x.num .. "</span> " .. h(Code.plain(x.title)) .. "</a></li>" end
      end
      t[#t + 1] = "</ol>"
    end
    t[#t + 1] = "</li>"
  end
  for i, v in ipairs(db.volumes) do
    local mine, open, weeks = {}, i == 1, nil
    for _, e in ipairs(db.entries) do
      if not e.of and (e.volume or db.volumes[1].name) == v.name then mine[#mine + 1] = e; weeks = weeks or e.week end
    end
    if db.volume_of[here] then open = db.volume_of[here] == v.name end
    if #mine > 0 then
      t[#t + 1] = "<details" .. (open and " open" or "") .. "><summary>" .. (#db.volumes > 1 and "<b>" .. i .. "</b> " or "") .. h(v.title) .. "</summary>"
      if weeks and db.labels["sec:coursework-weeks"] then
        t[#t + 1] = '<p class="legend"><i class="wk">1</i> to be read in that week of <a href="' .. db.labels["sec:coursework-weeks"].page .. '#sec:coursework-weeks">the course</a></p>'
      end
      local part, many = nil, {}
      for _, e in ipairs(mine) do many[e.part] = (many[e.part] or 0) + 1 end
      for _, e in ipairs(mine) do
        if e.part ~= part then
          if part then t[#t + 1] = "</ol>" end
          part = e.part
          t[#t + 1] = (part ~= v.title and many[part] > 1 and '<p class="part">' .. h(part) .. "</p>" or "") .. "<ol>"
        end
        chapter(e)
      end
      t[#t + 1] = "</ol></details>"
    end
  end
  return table.concat(t)
end
