-- ledger.lua -- what is in chapters/claims.tsv, chapters/ERRATA.md, tests/items.txt and the
-- drivers' reports, and what follows from it: who computes a claim, where print and
-- construction differ, the verdict on each numbered item of the book.

local ledger = {}

local function lines(path)
    local file = io.open(path, "r")
    if not file then
        io.stderr:write("weave: cannot read " .. path .. "\n")
        os.exit(1)
    end
    local list = {}
    for line in file:lines() do
        list[#list + 1] = line
    end
    file:close()
    return list
end
ledger.lines = lines

-- The fields of a line that are separated by tabs.
local function fields(line)
    local list = {}
    for field in (line .. "\t"):gmatch("(.-)\t") do
        list[#list + 1] = field
    end
    return list
end

-- The words of a list that is separated by commas.
function ledger.words(list)
    local result = {}
    for word in list:gmatch("[^,]+") do
        result[#result + 1] = word:match("^%s*(.-)%s*$")
    end
    return result
end

-- The claims in the order of the ledger: id, kind, printed, ours, tol, where, note; and by id.
function ledger.claims(path)
    local list, by_id = {}, {}
    for _, line in ipairs(lines(path)) do
        if line ~= "" and line:sub(1, 1) ~= "#" then
            local f = fields(line)
            local claim = { id = f[1], kind = f[2], printed = f[3], ours = f[4], tol = f[5],
                where = ledger.words(f[6]), note = f[7] }
            list[#list + 1] = claim
            by_id[claim.id] = claim
        end
    end
    return list, by_id
end

-- Notes with each claim the driver that reports it; how many claims each driver reports.
function ledger.read_reports(by_id, folder, drivers)
    local reported = {}
    for _, driver in ipairs(drivers) do
        reported[driver] = 0
        for _, line in ipairs(lines(folder .. "/" .. driver .. ".tsv")) do
            local claim = by_id[fields(line)[1]]
            if claim then
                claim.driver = driver
                reported[driver] = reported[driver] + 1
            end
        end
    end
    return reported
end

-- The errata in the order of the file: name, title, ids of their claims. Each claim learns
-- the errata that name it.
function ledger.errata(path, by_id)
    local list = {}
    for _, line in ipairs(lines(path)) do
        local name, title = line:match("^## (ER%-%d+)%. (.*)")
        if name then
            list[#list + 1] = { name = name, title = title }
        elseif line:match("^%- Ledger:") then
            for _, id in ipairs(ledger.words(line:match(":(.*)"))) do
                local claim = by_id[id]
                if claim then
                    claim.errata = claim.errata or {}
                    table.insert(claim.errata, list[#list].name)
                end
            end
        end
    end
    return list
end

-- The numbered items of the book: kind and number.
function ledger.items(path)
    local list = {}
    for _, line in ipairs(lines(path)) do
        local kind, first, last = line:match("^(%a+) (%d+) (%d+)$")
        for number = tonumber(first or 1), tonumber(last or 0) do
            list[#list + 1] = { kind = kind, number = number, name = kind .. " " .. number }
        end
    end
    return list
end

-- Does what the book prints differ from what the construction gives? As in tests/ledger.c.
function ledger.differs(claim)
    if claim.printed == "-" or claim.printed == claim.ours or claim.kind == "none" then
        return false
    end
    local printed, ours = tonumber(claim.printed), tonumber(claim.ours)
    if not printed then
        return true
    end
    local low, high = claim.ours:match("^(.-)%.%.(.*)$")
    if claim.kind == "range" and low then
        return printed < tonumber(low) or printed > tonumber(high)
    end
    if not ours then
        return true
    end
    if claim.kind == "max" then
        return printed > ours
    end
    return printed ~= ours
end

local function has(list, value)
    for _, v in ipairs(list) do
        if v == value then
            return true
        end
    end
    return false
end

-- What became of an item: its claims, the drivers that compute them, the errata of those that
-- differ, and one of four verdicts. `chosen` tells whether a driver chose what the book does
-- not print.
function ledger.judge(item, claims, chosen)
    local computed, open, choice = 0, 0, false
    item.claims, item.drivers, item.errata = {}, {}, {}
    for _, claim in ipairs(claims) do
        if has(claim.where, item.name) then
            table.insert(item.claims, claim)
            if claim.kind == "none" then
                open = open + 1
            else
                computed = computed + 1
            end
            if claim.driver and not has(item.drivers, claim.driver) then
                table.insert(item.drivers, claim.driver)
                choice = choice or (item.kind == "Fig" and chosen(claim.driver))
            end
            for _, name in ipairs(ledger.differs(claim) and claim.errata or {}) do
                if not has(item.errata, name) then
                    table.insert(item.errata, name)
                end
            end
        end
    end
    table.sort(item.errata)
    if computed == 0 then
        item.verdict = "not computable"
    elseif #item.errata > 0 then
        item.verdict = "corrected"
    elseif open > 0 or choice then
        item.verdict = "reproduced under a stated reading"
    else
        item.verdict = "reproduced"
    end
end

-- --- numbers, as they are read ---

-- Digits in groups of three, from five digits on, parted by narrow blanks that do not break.
local function grouped(digits)
    if #digits < 5 then
        return digits
    end
    local first = #digits % 3
    local rest = digits:sub(first + 1):gsub("%d%d%d", "\u{202f}%0")
    return (digits:sub(1, first) .. rest):gsub("^\u{202f}", "")
end

-- A number of the ledger: a true minus, powers of ten, no more digits than are read.
local function number(text)
    local mantissa, exponent = text:match("^(.-)[eE]([-+]?%d+)$")
    if mantissa then
        local power = "10<sup>" .. exponent:gsub("^%+", ""):gsub("%-0*", "−") .. "</sup>"
        return mantissa == "1" and power or number(mantissa) .. "·" .. power
    end
    local digits = text:gsub("^%-", ""):gsub("%.", ""):gsub("^0+", "")
    if text:find("%.") and #digits > 6 then
        local value = tonumber(text)
        text = string.format(math.abs(value) < 1e4 and "%.4g" or "%.0f", value)
    end
    return (text:gsub("^%-", "−"):gsub("^(%D*)(%d+)$", function(sign, all)
        return sign .. grouped(all)
    end))
end

-- The text of a value, a number, a range or a word.
function ledger.value(text)
    local low, high = text:match("^(.-)%.%.(.*)$")
    if low then
        return low == high and number(low) or number(low) .. " to " .. number(high)
    end
    return tonumber(text) and number(text) or text
end

return ledger
