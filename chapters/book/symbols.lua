-- symbols.lua -- the plain text of comments, notes and errata as HTML: `beta_{j,k}' gets its Greek
-- letter and its indices, `x^2' its exponent, `->' its arrow. Names of programs, as
-- kw_mesh_new, stay as they are: only a single letter, a Greek one or a bracket has an index.

local symbols = {}

local GREEK = { alpha = "α", beta = "β", gamma = "γ", Gamma = "Γ", delta = "δ", epsilon = "ε", eta = "η",
    theta = "θ", lambda = "λ", Lambda = "Λ", mu = "μ", pi = "π", Pi = "Π", sigma = "σ", tau = "τ",
    phi = "φ", Phi = "Φ", psi = "ψ", omega = "ω", Omega = "Ω" }

function symbols.escape(text)
    return (text:gsub("[&<>\"]", { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }))
end

-- The indices and exponents that begin at `at`, as HTML, and where they end.
local function scripts(text, at)
    local result = ""
    while true do
        local sign, inner, next = text:match("^([_^])(%b{})()", at)
        if sign then
            inner = inner:sub(2, -2)
        else
            sign, inner, next = text:match("^([_^])(%-?%w+)()", at)
        end
        if not sign then
            sign, inner, next = text:match("^([_^])([+*])()", at)
        end
        if not sign then
            sign, inner, next = text:match("^(%^)(%b())()", at)
        end
        if not sign then
            return result, at
        end
        local tag = sign == "_" and "sub" or "sup"
        result = result .. "<" .. tag .. ">" .. symbols.html(inner):gsub("%-", "−") .. "</" .. tag .. ">"
        at = next
    end
end

-- The end of the base that begins at `at`, if indices may follow it: a letter or a Greek name
-- that is no part of a longer name, any word before ^ or _{, a number before ^, a bracket.
local function base_end(text, at)
    local word, after = text:match("^(%a+)()", at)
    if word then
        local short = (GREEK[word] or #word == 1) and not text:match("^%.?%w", after)
        return (short or text:match("^%^", after) or text:match("^_{", after)) and after
    end
    return text:match("^%d+()%^", at) or text:match("^%d+()%a[_^]", at) or text:match("^[%])|]()", at)
end

-- The text as HTML.
function symbols.html(text)
    local result, at = {}, 1
    while at <= #text do
        local more
        local after = base_end(text, at)
        if after then
            local base = text:sub(at, after - 1)
            more, at = scripts(text, after)
            more = (GREEK[base] or base) .. more
        else
            after = text:match("^[%w_.]*%w()", at) or at + 1
            more, at = symbols.escape(text:sub(at, after - 1)), after
        end
        result[#result + 1] = more
    end
    return (table.concat(result):gsub("%-&gt;", "→"):gsub("&lt;=", "≤"):gsub("&gt;=", "≥")
        :gsub(" %- ", " − "):gsub(" %.%. ", " … "):gsub(", %.%.,", ", …,")
        :gsub("`(.-)'", "‘%1’"):gsub("(%a)'(%l)", "%1’%2")
        :gsub("%+%-", "±"):gsub("(%w) x %f[%d%u]", "%1 × "):gsub(" %. ", " · "):gsub("([%s({])%-(%d)", "%1−%2"))
end

return symbols
