-- tables.lua -- the parts of the page that nobody writes: the state of the ledger, the map of
-- the book, the errata, how to cite, the ledger and the programs. Each function takes what
-- book.lua gathered and gives blocks.

local source, ledger, symbols = require("source"), require("ledger"), require("symbols")
local escape = symbols.escape
local tables = {}

local function raw(text)
    return pandoc.RawBlock("html", text)
end

local function link(target, text)
    return ('<a href="#%s">%s</a>'):format(target, escape(text))
end

-- --- the front page ---

-- How many claims there are, and how many of them differ from the print.
function tables.status(book)
    local computed, printed, differ = 0, 0, 0
    for _, claim in ipairs(book.list) do
        if claim.kind ~= "none" then
            computed = computed + 1
            printed = printed + (claim.printed ~= "-" and 1 or 0)
            differ = differ + (ledger.differs(claim) and 1 or 0)
        end
    end
    return { raw(([[<p>The ledger holds <b>%d</b> claims: <b>%d</b> are computed, by <b>%d</b> programs,
and for the other <b>%d</b> it says why not. For <b>%d</b> of the computed ones the book prints a
number or makes a statement that can be true or false; in <b>%d</b> of these the construction gives
something else, for reasons that <b>%d</b> errata explain.</p>]]):format(#book.list, computed,
        #source.files("chapters/[0-9]*/*.c"), #book.list - computed, printed, differ,
        #book.errata_list)) }
end

-- What the programs of a lesson come to; by their paths, which begin with its folder.
local function size_of(book, folder)
    local size = { programs = 0, lines = 0, claims = 0, pictures = 0 }
    for name, path in pairs(book.drivers) do
        if path:sub(1, #folder) == folder then
            size.programs = size.programs + 1
            size.lines = size.lines + #source.lines(path)
            size.claims = size.claims + book.reported[name]
            size.pictures = size.pictures + (book.shown[name] and 1 or 0)
        end
    end
    return size
end

-- How much work each lesson is, in numbers that are the same on every machine.
function tables.size(book)
    local row = "<tr><th scope=\"row\">%s</th><td>%d</td><td>%d</td><td>%d</td><td>%d</td></tr>\n"
    local rows = {}
    for _, lesson in ipairs(book.lessons) do
        local size = size_of(book, lesson.path:match("^(.*/)"))
        rows[#rows + 1] = row:format(lesson.number .. " " .. link(lesson.slug, lesson.title),
            size.programs, size.lines, size.claims, size.pictures)
    end
    return { raw([[<div class="scroll"><table class="size">
<thead><tr><th scope="col">Lesson</th><th scope="col">Programs</th><th scope="col">Lines</th>
<th scope="col">Claims</th><th scope="col">Pictures</th></tr></thead>
<tbody>
]] .. table.concat(rows) .. "</tbody></table></div>") }
end

local KIND = { Def = "Definition %d", Rem = "Remark %d", Eq = "Equation (%d)", Fig = "Figure %d",
    List = "List %d" }

-- The sections that speak of an item, in their order: by its name or by one of its claims; if
-- there is none, those that speak of a program that computes it. What a lesson says in its
-- overview, on the print or in its exercise counts only if nothing else does.
local function explained(book, item)
    local found, overview, known = {}, {}, {}
    local function add(sections)
        for _, section in ipairs(sections or {}) do
            if not known[section.id] then
                known[section.id] = true
                table.insert(section.overview and overview or found, section)
            end
        end
    end
    add(book.seen.item[item.name])
    for _, claim in ipairs(item.claims) do
        add(book.seen.claim[claim.id])
    end
    for _, driver in ipairs(#found + #overview == 0 and item.drivers or {}) do
        add(book.seen.driver[driver])
    end
    found = #found > 0 and found or overview
    table.sort(found, function(a, b) return a.place < b.place end)
    return found
end

local function joined(list, format)
    local words = {}
    for _, value in ipairs(list) do
        words[#words + 1] = format(value)
    end
    return table.concat(words, ", ")
end

local function map_row(book, item)
    local sections = explained(book, item)
    if #sections == 0 then
        book.problem("chapters", item.name .. " of the book is explained in no lesson")
    end
    local name = KIND[item.kind]:format(item.number)
    local figure = item.kind == "Fig" and book.shown[("fig%02d"):format(item.number)]
    local verdict = item.verdict
    if #item.errata > 0 then
        verdict = verdict .. ": " .. joined(item.errata, function(e) return link(e, e) end)
    elseif #item.drivers == 0 then
        verdict = ('<a href="#claim-%s">%s</a>'):format(item.claims[1].id, verdict)
    end
    local row = '<tr id="%s"><th scope="row">%s</th><td>%s</td><td>%s</td><td class="%s">%s</td></tr>\n'
    return row:format(item.id, figure and link(figure:sub(2), name) or name,
        joined(sections, function(s) return s.lesson .. " " .. link(s.id, s.title) end),
        joined(item.drivers, function(d) return link(book.drivers[d], d .. ".c") end),
        item.verdict:match("%a+"), verdict)
end

function tables.map(book)
    local count, rows = {}, {}
    for _, item in ipairs(book.item_list) do
        count[item.verdict] = (count[item.verdict] or 0) + 1
        rows[#rows + 1] = map_row(book, item)
    end
    local verdicts = {}
    for _, verdict in ipairs({ "reproduced", "reproduced under a stated reading", "corrected",
        "not computable" }) do
        verdicts[#verdicts + 1] = ("<b>%d</b> %s"):format(count[verdict] or 0, verdict)
    end
    return { raw("<p>" .. table.concat(verdicts, ", ") .. [[.</p>
<div class="scroll"><table class="map">
<thead><tr><th scope="col">In the book</th><th scope="col">Explained in</th>
<th scope="col">Computed by</th><th scope="col">Verdict</th></tr></thead>
<tbody>
]] .. table.concat(rows) .. "</tbody></table></div>") }
end

tables["errata-list"] = function(book)
    local rows = {}
    for _, erratum in ipairs(book.errata_list) do
        local name = link(erratum.name, erratum.name)
        rows[#rows + 1] = ("<li>%s %s</li>\n"):format(name, symbols.html(erratum.title))
    end
    return { raw('<ul class="plain">\n' .. table.concat(rows) .. "</ul>") }
end

-- The names of the authors of a part of CITATION.cff.
local function authors(list)
    local text = pandoc.utils.stringify
    return joined(list, function(a)
        return escape(a.name and text(a.name) or text(a["given-names"]) .. " " .. text(a["family-names"]))
    end)
end

function tables.cite()
    local function text(value)
        return escape(pandoc.utils.stringify(value))
    end
    local cff = table.concat(ledger.lines("CITATION.cff"), "\n")
    local meta = pandoc.read("---\n" .. cff .. "\n---\n", "markdown-smart").meta
    local blocks = { raw("<p>" .. text(meta.message) .. "</p>"),
        raw(("<p>%s. <i>%s</i>. Licenses: %s; the texts and the pictures are under the latter.</p>"):format(
            authors(meta.authors), text(meta.title), joined(meta.license, text))) }
    for _, r in ipairs(meta.references) do
        local place = ("%s, %s, pages %s–%s"):format(text(r.publisher.name), text(r.year),
            text(r.start), text(r["end"]))
        local doi = ('<a href="https://doi.org/%s">doi:%s</a>'):format(text(r.doi), text(r.doi))
        blocks[#blocks + 1] = raw(("<p>%s. <q>%s</q>. In: <i>%s</i>. %s. %s</p>"):format(
            authors(r.authors), text(r.title), text(r["collection-title"]), place, doi))
    end
    return blocks
end

-- --- the appendices ---

-- The words of an erratum: claims and programs as links, the rest in symbols.
local function with_symbols(book, words)
    local result, text = pandoc.List(), ""
    local function flush()
        result:insert(pandoc.RawInline("html", symbols.html(text)))
        text = ""
    end
    for _, word in ipairs(words) do
        local open, name, rest = (word.text or ""):match("^(%(?)([%w_.+-]+)([,.)]*)$")
        local target = name and (book.claims[name] and "claim-" .. name or book.drivers[name])
        if target then
            text = text .. open
            flush()
            result:insert(pandoc.Link(name, "#" .. target))
            text = rest
        elseif word.t == "Str" then
            text = text .. word.text
        elseif word.t == "Space" or word.t == "SoftBreak" then
            text = text .. " "
        else
            flush()
            result:insert(word)
        end
    end
    flush()
    return result
end

-- ERRATA.md, each erratum with its address.
function tables.errata(book)
    local text = table.concat(ledger.lines("chapters/ERRATA.md"), "\n"):gsub("^# [^\n]*\n", "")
    return pandoc.Div(pandoc.read(text, "commonmark").blocks):walk({
        Emph = function(emph)
            local words = pandoc.utils.stringify(emph)
            book.problem("chapters/ERRATA.md", "sets `" .. words .. "' in italics by accident")
        end,
        Code = function(code)
            if code.text:match("'") or code.text:match("%s$") then
                book.problem("chapters/ERRATA.md", "sets `" .. code.text .. "' as code by accident")
            end
        end,
        Header = function(header)
            local name = pandoc.utils.stringify(header):match("^ER%-%d+")
            return pandoc.Header(3, { pandoc.Link(with_symbols(book, header.content), "#" .. name) },
                pandoc.Attr(name, { "unlisted", "unnumbered" }))
        end,
        Para = function(para) return pandoc.Para(with_symbols(book, para.content)) end,
        Plain = function(plain) return pandoc.Plain(with_symbols(book, plain.content)) end,
    }).content
end

-- What a claim's numbers are: ours, with the bound or the tolerance that its kind asks for, and
-- what is printed.
local function numbers(claim)
    if claim.kind == "none" then
        return "not computed"
    end
    local ours = (claim.kind == "max" and "at most " or "") .. "<b>" .. ledger.value(claim.ours) .. "</b>"
    if claim.kind == "real" and claim.tol ~= "0" then
        ours = ours .. ", relative error at most " .. ledger.value(claim.tol)
    end
    return ours .. (claim.printed ~= "-" and "; printed " .. ledger.value(claim.printed) or "")
end

local function claim_entry(book, claim)
    local by = { claim.driver and link(book.drivers[claim.driver], claim.driver .. ".c") }
    for _, name in ipairs(claim.errata or {}) do
        by[#by + 1] = link(name, name)
    end
    return ([[<dt id="claim-%s"><code>%s</code> %s</dt>
<dd>%s</dd>
<dd class="numbers">%s: %s. %s</dd>
]]):format(claim.id, claim.id, table.concat(claim.where, ", "), symbols.html(claim.note),
        claim.kind, numbers(claim), table.concat(by, ", "))
end

function tables.ledger(book)
    local rows = {}
    for _, claim in ipairs(book.list) do
        rows[#rows + 1] = claim_entry(book, claim)
    end
    return { raw('<dl class="ledger">\n' .. table.concat(rows) .. "</dl>") }
end

local function program(book, path)
    local lines, name = source.lines(path), path:match("([%w_]+)%.c$")
    local size = ("%d lines"):format(#lines)
    if book.drivers[name] == path then
        local claims = book.reported[name]
        size = ("%s, %d %s"):format(size, claims, claims == 1 and "claim" or "claims")
    end
    return ([[<details class="program" id="%s"><summary>%s <span class="size">%s</span></summary><pre><code>%s
</code></pre></details>
]]):format(path, path, size, escape(table.concat(lines, "\n")))
end

function tables.programs(book)
    local html = {}
    for _, list in ipairs({ book.programs, book.lib }) do
        for _, path in ipairs(list) do
            html[#html + 1] = program(book, path)
        end
    end
    return { raw(table.concat(html)) }
end

return tables
