-- source.lua -- the C of the project, found by name: whole functions, whole files, and what
-- the head comment of a driver says. Nothing in the C is marked for this.

local source = {}

-- The names of the files that match a pattern of the shell, in the order of the alphabet.
function source.files(pattern)
    local list = {}
    local pipe = io.popen("ls -1d " .. pattern .. " 2>/dev/null")
    for line in pipe:lines() do
        list[#list + 1] = line
    end
    pipe:close()
    return list
end

local kept = {}

-- The lines of a file, nil if it is not there.
function source.lines(path)
    if kept[path] == nil then
        local file = io.open(path, "r")
        local list = file and {}
        for line in file and file:lines() or function() end do
            list[#list + 1] = line
        end
        if file then
            file:close()
        end
        kept[path] = list or false
    end
    return kept[path] or nil
end

-- Where the comment begins that stands directly above a line, or the line itself.
local function with_comment(lines, first)
    local i = first - 1
    if i < 1 or not lines[i]:match("%*/%s*$") then
        return first
    end
    while i >= 1 and not lines[i]:match("^/%*") do
        i = i - 1
    end
    return i >= 1 and i or first
end

-- The last line of the definition whose name stands on line `first`; nil if this is a
-- declaration or a call. A body begins with `{' and ends with `}', each the first of its line.
local function body_end(lines, first)
    local i = first
    while lines[i] and lines[i] ~= "{" do
        if lines[i]:match(";%s*$") or lines[i]:match("^}") then
            return nil
        end
        i = i + 1
    end
    while lines[i] and lines[i] ~= "}" do
        i = i + 1
    end
    return lines[i] and i
end

-- The first and last line of a function of a file, its comment among them; nil and why not.
function source.find(path, name)
    local lines = source.lines(path)
    if not lines then
        return nil, path .. " is not there"
    end
    for i, line in ipairs(lines) do
        local last = line:match("^[%a_].*%f[%w_]" .. name .. "%(") and body_end(lines, i)
        if last then
            return with_comment(lines, i), last
        end
    end
    return nil, name .. " is not defined in " .. path
end

-- A paragraph of a comment as one line, from `Name:' to a blank line or the next such name.
local function paragraph(text, name)
    local words
    for line in (text .. "\n"):gmatch("%s*(.-)%s*\n") do
        if words and (line == "" or line:match("^%u[%a ]*:")) then
            break
        end
        words = words and words .. " " .. line or line:match("^" .. name .. ":%s*(.*)")
    end
    return words
end

-- The head comment of a driver: its name and title (`Figure 4 -- A cubic B-spline'), and the
-- paragraphs What to see and Chosen here, nil if it has none.
function source.head(path)
    local text = table.concat(source.lines(path), "\n"):match("^/%*(.-)%*/") or ""
    local first = text:gsub("\n%s*\n.*", ""):gsub("%s+", " ")
    local name, title = first:match("^ ?(.-) %-%- (.-)%.? ?$")
    return { name = name, title = title, see = paragraph(text, "What to see"),
        chosen = paragraph(text, "Chosen here") }
end

return source
