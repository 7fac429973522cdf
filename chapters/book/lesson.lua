-- lesson.lua -- one chapter.md becomes a part of the page: numbers from the ledger, functions
-- and figures by name, references as links. Whatever refers to nothing is reported.

local source, ledger, symbols = require("source"), require("ledger"), require("symbols")
local lesson = {}

-- What lesson.weave needs to know, set once by book.lua: claims by id, drivers (name -> path),
-- items and errata by name, shown (figures by driver), and problem(place, text).
local book

function lesson.use(known)
    book = known
end

local function html(text)
    return pandoc.RawInline("html", text)
end

-- --- numbers ---

local NOUN = { Figure = "Fig", Figures = "Fig", figure = "Fig", figures = "Fig",
    Definition = "Def", Definitions = "Def", definition = "Def", definitions = "Def",
    Remark = "Rem", Remarks = "Rem", remark = "Rem", remarks = "Rem",
    equation = "Eq", Equation = "Eq", equations = "Eq", Equations = "Eq" }

-- Is the word at `i` a number of the book's: Figure 12, equation (22), Definitions 10 and 11?
local function kind_before(words, i)
    local before = words[i - 2] and words[i - 2].t == "Str" and words[i - 2].text
    if before == "and" or before == "to" then
        return kind_before(words, i - 4)
    end
    return before and NOUN[before:match("^%p*(%a+)$")]
end

-- Does a formula state a result: is it a number, or does it end in one? The constants of a formula
-- with letters in it, as in (1 + 25 x^2), are part of what it says.
local function states_number(formula)
    local text = formula:gsub("\\[lg]eq?%f[%A]", "="):gsub("\\approx%f[%A]", "="):gsub("\\%a+", "")
    return text:match("%d%d") and
        (not text:match("%a") or text:match("[=<>]%s*[%d.]*%d%d[%d.]*[%s.,]*$"))
end

-- Reports the numbers of two digits and more that are typed by hand, in running text or as formulas.
local function check_numbers(words, place)
    for i, word in ipairs(words) do
        if word.t == "Math" and states_number(word.text) then
            book.problem(place, "types a number by hand, in a formula: " .. word.text)
        elseif word.t == "Str" then
            local text = word.text:gsub("ER%-%d+", "")
            if not kind_before(words, i) and text:gsub("%a[%w_]*", ""):match("%d%d") then
                book.problem(place, "types a number by hand: " .. word.text)
            end
        elseif word.t == "Image" then
            check_numbers(word.caption, place)
        elseif word.content and word.t ~= "Cite" and not (word.t == "Span" and #word.classes > 0) then
            check_numbers(word.content, place)
        end
    end
end

-- A number from the ledger, linked to its line there; with a word for it, which says that it is zero.
local function from_ledger(span, column, place, word)
    local id = pandoc.utils.stringify(span)
    local claim = book.claims[id]
    if not claim then
        book.problem(place, "takes a number from claim " .. id .. ", which is not in the ledger")
        return span
    end
    if claim.kind == "none" or claim[column] == "-" then
        book.problem(place, "takes the " .. column .. " number of claim " .. id .. ", which has none")
        return span
    end
    if column == "ours" and not claim.driver then
        book.problem(place, "takes a number from claim " .. id .. ", which no driver reports")
    end
    if word and claim[column] ~= "0" then
        book.problem(place, "says `" .. word .. "' of claim " .. id .. ", which is " .. claim[column])
    end
    local title = "printed in the book"
    if column == "ours" then
        title = "computed by " .. (claim.driver or "nobody")
    end
    return html(('<a class="%s" href="#claim-%s" title="%s: %s">%s</a>'):format(column, id, id,
        title, word or ledger.value(claim[column])))
end

local ZERO = { no = true, none = true }

local function replace_span(span, place)
    local class = span.classes[1]
    if class == "ours" or class == "printed" then
        return from_ledger(span, class, place)
    elseif ZERO[class] then
        return from_ledger(span, "ours", place, class)
    elseif class and class ~= "chosen" then
        book.problem(place, "has a span of the unknown class " .. class)
    end
    return span
end

-- --- references ---

-- `fig09.c', `lib/mesh.h' and `ex_span' lead to the program.
local function replace_code(code, place)
    local name = code.text
    local path = book.drivers[name:gsub("%.c$", "")] or book.files[name]
    if path then
        return pandoc.Link(code, "#" .. path)
    elseif name:match("^[%w_/-]+%.[ch]$") then
        book.problem(place, "names " .. name .. ", which is not there")
    end
    return code
end

-- ER-07 leads to the erratum, Figure 9 to the figure, Definition 3 to its line of the map. What
-- stands before the link, the link, and what stands behind; nil if there is nothing to link.
local function link_word(words, i, place)
    local text = words[i].text
    local before, name, after = text:match("^(.-)(ER%-%d+)(.*)$")
    if name then
        if not book.errata[name] then
            book.problem(place, "names " .. name .. ", which is no erratum")
        end
        return before, pandoc.Link(name, "#" .. name), after
    end
    local number
    number, after = text:match("^(%(%d+%))(.*)$")
    if not number then
        number, after = text:match("^(%d+)(.*)$")
    end
    local kind = number and kind_before(words, i)
    local item = kind and book.items[kind .. " " .. number:match("%d+")]
    if item then
        local target = kind == "Fig" and book.shown[("fig%02d"):format(item.number)] or "#" .. item.id
        return "", pandoc.Link(number, target), after
    end
end

-- The links of a text; `Figure' or `equation' before a number is part of the link.
local function link_words(words, place)
    local result = pandoc.List()
    for i, word in ipairs(words) do
        local before, link, after
        if word.t == "Str" then
            before, link, after = link_word(words, i, place)
        end
        if link then
            local last = words[i - 2]
            local open, noun = (last and last.t == "Str" and last.text or ""):match("^(%p*)(%a+)$")
            if before == "" and NOUN[noun] then
                link.content:insert(1, result:remove())
                link.content:insert(1, pandoc.Str(noun))
                result[#result] = pandoc.Str(open)
            end
            result:extend({ pandoc.Str(before), link, pandoc.Str(after) })
        else
            result:insert(word)
        end
    end
    return result
end

-- A formula and the comma behind it stay on one line, and so does a word like B-spline.
local function keep_together(words)
    local result = pandoc.List()
    for _, word in ipairs(words) do
        local last = result[#result]
        if last and last.t == "Math" and word.t == "Str" and word.text:match("^[,.;:)?!]") then
            result[#result] = pandoc.Span({ last, word }, { class = "together" })
        elseif word.t == "Str" and word.text:match("B%-spline") then
            result:insert(pandoc.Span({ word }, { class = "together" }))
        else
            result:insert(word)
        end
    end
    return result
end

-- pandoc takes \ell for an operator, with space around it; the letter itself is a letter.
local function formula(math)
    math.text = math.text:gsub("\\ell%f[%A]", "ℓ")
    return math.mathtype == "DisplayMath" and pandoc.Span({ math }, { class = "display" }) or math
end

-- --- blocks ---

local function listing(div, place)
    local path, name = div.attributes.file, div.attributes["function"]
    local first, last = 1
    if name then
        first, last = source.find(path, name)
    elseif source.lines(path) then
        last = #source.lines(path)
    else
        first, last = nil, path .. " is not there"
    end
    if not first then
        book.problem(place, "pulls in a function: " .. last)
        return {}
    end
    if not book.files[path] then
        book.problem(place, "pulls " .. path .. ", which is neither in lib/ nor in a lesson")
    end
    local what = name and "<code>" .. name .. "</code>, " or ""
    local where = ('%s<a href="#%s">%s</a>, lines %d to %d'):format(what, path, path, first, last)
    local style = pandoc.Attr("", { "c", "numberLines" }, { startFrom = tostring(first) })
    return { pandoc.RawBlock("html", '<div class="listing"><p class="where">' .. where .. "</p>"),
        pandoc.CodeBlock(table.concat(source.lines(path), "\n", first, last), style),
        pandoc.RawBlock("html", "</div>") }
end

local function see(text)
    return pandoc.RawBlock("html", '<p class="see"><b>What to see:</b> ' .. symbols.html(text) .. "</p>")
end

local function figure(image, place)
    local name = image.src:match("figures/([%w_]+)%.svg$")
    local path = name and book.drivers[name]
    if not path then
        book.problem(place, "shows " .. image.src .. ", which is the figure of no driver")
        return {}
    end
    local head = source.head(path)
    if not head.title or not head.see then
        book.problem(path, "has no title or does not say what to see")
        return {}
    end
    if #image.caption == 0 then
        book.problem(place, "shows " .. name .. " without a caption")
    end
    local label = pandoc.Strong(pandoc.Link(head.name .. ".", "#" .. name))
    local program = pandoc.Link(name .. ".c", "#" .. path, "", { class = "program" })
    local caption = pandoc.List({ label, pandoc.Space() })
    caption:extend(image.caption)
    caption:extend({ pandoc.Space(), program })
    return { pandoc.RawBlock("html", ('<figure id="%s"><div class="scroll">'):format(name)),
        pandoc.Plain({ pandoc.Image({ pandoc.Str(head.title) }, "figures/" .. name .. ".svg") }),
        pandoc.RawBlock("html", "</div><figcaption>"), pandoc.Para(caption), see(head.see),
        pandoc.RawBlock("html", "</figcaption></figure>") }
end

local function is_figure(block)
    return block.t == "Para" and #block.content == 1 and block.content[1].t == "Image"
end

-- A table is as wide as what is in it, and scrolls if that is too wide. (pandoc gives columns a
-- share of the page if a line of their source is long.)
local function wide_table(block)
    for i, column in ipairs(block.colspecs) do
        block.colspecs[i] = { column[1], nil }
    end
    return pandoc.Div({ block }, { class = "scroll" })
end

local function replace_div(div, place, at)
    local class = div.classes[1]
    if class == "code" then
        return listing(div, place)
    elseif class == "answer" then
        local open = '<details class="answer"><summary>Answer</summary>'
        div.content:insert(1, pandoc.RawBlock("html", open))
        div.content:insert(pandoc.RawBlock("html", "</details>"))
        return div.content
    end
    local part = at.part and at.part(class)
    if not part then
        book.problem(place, "has a block of the unknown class " .. class)
    end
    return part
end

-- The address of a section: its lesson's folder and its own words; on the front page as written.
local function section_id(header, at)
    if not at.slug then
        return header.identifier
    end
    return header.level == 1 and at.slug or at.slug .. "-" .. header.identifier
end

-- Headings go down one level, as the page has the title; each links to itself.
local function heading(header, at)
    local text = header:walk({ Link = function(link) return link.content end }).content
    local slug, class = section_id(header, at), {}
    if header.level == 1 and at.number then
        local number = pandoc.Span(at.number, { class = "number" })
        text, class = pandoc.List({ number, pandoc.Space() }) .. text, { "lesson" }
    end
    return pandoc.Header(header.level + 1, { pandoc.Link(text, "#" .. slug) }, pandoc.Attr(slug, class))
end

-- Where an item, a claim or a driver is spoken of: notes the section, once each.
local function note(kind, name, section)
    local list = book.seen[kind][name] or {}
    book.seen[kind][name] = list
    if list[#list] ~= section then
        list[#list + 1] = section
    end
end

-- Goes through the lesson before anything is replaced: which section speaks of what.
local function survey(blocks, at)
    local section, count = nil, 0
    for _, block in ipairs(blocks) do
        if block.t == "Header" then
            count = count + 1
            local title = pandoc.utils.stringify(block)
            local aside = title:match("^Where we differ: ") or title:match("^Exercise: ")
            section = { id = section_id(block, at), title = title, lesson = at.number,
                overview = count <= 2 or aside, place = at.number * 1000 + count }
        end
        block:walk({
            Inlines = function(words)
                for i, word in ipairs(words) do
                    local number = word.t == "Str" and word.text:match("^%(?(%d+)")
                    local kind = number and kind_before(words, i)
                    if not kind and number and word.text:match("^%(%d+%)") then
                        kind = "Eq"
                    end
                    if kind then
                        note("item", kind .. " " .. number, section)
                    end
                end
            end,
            Span = function(span)
                note("claim", pandoc.utils.stringify(span), section)
            end,
            Code = function(code)
                note("driver", (code.text:gsub("%.c$", "")), section)
            end,
            Image = function(image)
                local name = image.src:match("([%w_]+)%.svg$")
                if name then
                    book.shown[name] = "#" .. name
                    note("driver", name, section)
                end
            end,
        })
    end
end

-- Every lesson has a program, a figure and an exercise with its answer. The contents list all
-- headings, so no two lessons have one in common.
local function check_parts(at)
    local found = {}
    pandoc.Div(at.blocks):walk({
        Header = function(header)
            local text = pandoc.utils.stringify(header)
            found.exercise = found.exercise or text:match("^Exercise: ")
            if book.headings[text] and header.level == 2 then
                book.problem(at.path, "has the heading `" .. text .. "', as has " .. book.headings[text])
            end
            book.headings[text] = at.path
        end,
        Div = function(div) found[div.classes[1] or ""] = true end,
        Image = function() found.figure = true end,
    })
    for _, part in ipairs({ "code", "figure", "exercise", "answer" }) do
        if not found[part] then
            book.problem(at.path, "lacks what every lesson has: " .. part)
        end
    end
end

-- Reads chapters/N-name/chapter.md.
function lesson.read(path)
    local file = io.open(path, "r")
    local text = file:read("a")
    file:close()
    local number, slug = path:match("(%d+)%-([^/]+)/chapter%.md$")
    local read = { path = path, number = number, slug = slug,
        blocks = pandoc.read(text, "markdown").blocks }
    survey(read.blocks, read)
    check_parts(read)
    read.title = read.blocks[1] and pandoc.utils.stringify(read.blocks[1])
    return read
end

-- The blocks of the page for a lesson that was read, or for the front page, whose at.part gives
-- the blocks that take the place of a named one. A place is the path and the last heading.
function lesson.weave(at)
    local result, place = pandoc.List(), at.path
    for _, block in ipairs(at.blocks) do
        if block.t == "Header" then
            place = at.path .. ", " .. pandoc.utils.stringify(block)
        end
        local words = function(b) check_numbers(b.content, place) end
        pandoc.Div({ block }):walk({ Para = words, Plain = words, Header = words })
        local woven = pandoc.Div({ block }):walk({
            Span = function(span) return replace_span(span, place) end,
            Code = function(code) return replace_code(code, place) end,
            Math = formula,
        }):walk({
            Inlines = function(list) return keep_together(link_words(list, place)) end,
        }):walk({
            Para = function(para)
                return is_figure(para) and figure(para.content[1], place) or nil
            end,
            Table = wide_table,
            Div = function(div) return #div.classes > 0 and replace_div(div, place, at) or nil end,
            Header = function(header) return heading(header, at) end,
        })
        result:extend(woven.content)
    end
    return result
end

return lesson
