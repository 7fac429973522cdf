-- book.lua -- the filter of pandoc that makes the page out of front.md: the lessons, and all
-- that is computed from the ledger, take the place of the blocks `::: {.map}' and so on.
-- Problems are collected and shown together; one is enough to stop.

package.path = PANDOC_SCRIPT_FILE:match("^(.*)/") .. "/?.lua;" .. package.path
local source, ledger, lesson = require("source"), require("ledger"), require("lesson")
local tables = require("tables")

local problems = {}
local function problem(place, text)
    problems[#problems + 1] = "weave: " .. place .. ": " .. text
end

local function stop_on_problems()
    for _, text in ipairs(problems) do
        io.stderr:write(text .. "\n")
    end
    if #problems > 0 then
        os.exit(1)
    end
end

-- All that the parts of the page know of each other.
local function gather()
    local book = { problem = problem, drivers = {}, files = {}, items = {}, errata = {}, shown = {}, lessons = {},
        headings = {},
        seen = { item = {}, claim = {}, driver = {} } }
    local names = {}
    book.programs = source.files("chapters/*.h chapters/[0-9]*/*.[ch]")
    book.lib = source.files("lib/*.[ch]")
    for _, path in ipairs(book.programs) do
        local name = path:match("([%w_]+)%.c$")
        if name then
            book.drivers[name] = path
            names[#names + 1] = name
        end
    end
    for _, list in ipairs({ book.programs, book.lib }) do
        for _, path in ipairs(list) do
            local name = path:match("[^/]+$")
            book.files[path] = path
            book.files[name] = book.files[name] == nil and path -- false if two have this name
        end
    end
    book.list, book.claims = ledger.claims("chapters/claims.tsv")
    book.reported = ledger.read_reports(book.claims, os.getenv("REPORTS"), names)
    book.errata_list = ledger.errata("chapters/ERRATA.md", book.claims)
    for _, erratum in ipairs(book.errata_list) do
        book.errata[erratum.name] = erratum
    end
    book.item_list = ledger.items("tests/items.txt")
    for _, item in ipairs(book.item_list) do
        item.id = item.name:gsub(" ", "-")
        book.items[item.name] = item
        ledger.judge(item, book.list, function(driver)
            return source.head(book.drivers[driver]).chosen
        end)
        if #item.claims == 0 then
            problem("tests/items.txt", item.name .. " has no line in the ledger")
        end
    end
    return book
end

-- One section a lesson, in the order of their numbers.
local function weave_lessons(lessons)
    local blocks = pandoc.List()
    for _, at in ipairs(lessons) do
        blocks:extend(lesson.weave(at))
    end
    return blocks
end

function Pandoc(doc)
    local book = gather()
    stop_on_problems()
    lesson.use(book)
    for _, path in ipairs(source.files("chapters/[0-9]*/chapter.md")) do
        table.insert(book.lessons, lesson.read(path))
    end
    doc.blocks = lesson.weave({ path = "chapters/book/front.md", blocks = doc.blocks,
        part = function(name)
            if name == "lessons" then
                return weave_lessons(book.lessons)
            end
            return tables[name] and tables[name](book)
        end })
    stop_on_problems()
    return doc
end
