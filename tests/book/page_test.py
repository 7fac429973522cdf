#!/usr/bin/python3
"""page_test.py PAGE ... -- woven pages in a real browser: nothing is requested, nothing is missing,
nothing overflows, everything can be read. Prints `ok - ...' or `not ok - ...' for each
question about each page; exits 1 if something is not ok."""

import os
import sys

sys.dont_write_bytecode = True  # no folder of compiled files beside the sources
from devtools import Browser

WIDTHS = (360, 768, 1440)
WIDE = 1440

# Asked once. Each script gives a list of what is wrong.
ONCE = {
    "no script is in the page": "[...document.scripts].map(s => s.outerHTML.slice(0, 80))",
    "the page has a title and a language":
        "document.title && document.documentElement.lang ? [] : ['title or lang is missing']",
    "no address is there twice": """
        [...document.querySelectorAll('[id]')].map(e => e.id)
            .filter((id, i, all) => all.indexOf(id) != i)""",
    "every link leads into the page or out to the web": """
        [...document.querySelectorAll('a[href]')].map(a => a.getAttribute('href'))
            .filter(h => h[0] == '#' ? !document.getElementById(decodeURIComponent(h.slice(1)))
                                     : !h.startsWith('https://'))""",
    "every picture is there and says what it shows": """
        [...document.images].filter(i => !i.complete || !i.naturalWidth || !i.alt.trim())
            .map(i => `${i.alt || 'no alt'} ${i.src.slice(0, 60)}`)""",
    "every heading has an address and links to it": """
        [...document.querySelectorAll('h2, h3, h4')]
            .filter(h => !h.id || !h.querySelector(`a[href="#${CSS.escape(h.id)}"], a[href="#${h.id}"]`))
            .map(h => h.textContent)""",
    "nothing of the sources' own marks is left": """(() => {
        const marks = /\\]\\{[.#]|:::|!\\[|\\[@|\\bundefined\\b|\\bnil\\b|\\$\\$|\\*\\*/, found = [];
        const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
        while (texts.nextNode()) {
            const text = texts.currentNode;
            if (!text.parentElement.closest('pre, code, annotation') && marks.test(text.data))
                found.push(text.data.slice(0, 80));
        }
        return found;
    })()""",
}

# Asked at each width, with all answers unfolded.
EVERY_WIDTH = {
    "nothing is wider than the page": """(() => {
        const page = document.documentElement, wide = page.clientWidth;
        const scrolls = e => e && e != document.body &&
            (['auto', 'scroll'].includes(getComputedStyle(e).overflowX) || scrolls(e.parentElement));
        const out = [...document.querySelectorAll('main *, nav *')].filter(e => e.checkVisibility() &&
            e.getBoundingClientRect().right > wide + 1 && !scrolls(e.parentElement));
        const names = out.map(e => `${e.tagName} ${e.textContent.trim().slice(0, 40)}`);
        return page.scrollWidth > wide ? [`${page.scrollWidth} pixels`, ...names] : names;
    })()""",
    "every formula has a height and a width": """
        [...document.querySelectorAll('math')].filter(m => {
            const box = m.getBoundingClientRect();
            return m.checkVisibility() && (box.height < 6 || box.width < 3);
        }).map(m => m.textContent.slice(0, 40))""",
    "no letter of the text is smaller than 12 pixels": """
        [...document.querySelectorAll('main *')].filter(e => !e.closest('math, sup, sub') &&
            e.checkVisibility() && parseFloat(getComputedStyle(e).fontSize) < 12)
            .map(e => e.textContent.slice(0, 40))""",
}

# The contrast of text against what is behind it, by the formula of WCAG 2; at least 4.5.
CONTRAST = """(() => {
    const canvas = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
    const known = {};
    const rgba = color => known[color] = known[color] || (() => {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = color;
        canvas.fillRect(0, 0, 1, 1);
        return [...canvas.getImageData(0, 0, 1, 1).data];
    })();
    const light = c => c.slice(0, 3).map(v => v / 255)
        .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4)
        .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
    const ground = e => {
        for (; e; e = e.parentElement) {
            const c = rgba(getComputedStyle(e).backgroundColor);
            if (c[3] == 255) return c;
        }
        return %s;
    };
    const bad = [];
    for (const e of document.querySelectorAll('body *')) {
        const text = [...e.childNodes].some(n => n.nodeType == 3 && n.data.trim());
        if (!text || !e.checkVisibility()) continue;
        const [a, b] = [light(rgba(getComputedStyle(e).color)), light(ground(e))];
        const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (ratio < 4.5) bad.push(`${ratio.toFixed(1)}: ${e.textContent.trim().slice(0, 40)}`);
    }
    return bad;
})()"""

DARK = """(() => {
    const [r, g, b] = getComputedStyle(document.body).backgroundColor.match(/[\\d.]+/g);
    return +r + +g + +b < 200 ? [] : ['the paper is light'];
})()"""

# On a wide screen: lines of a length that reads well, and contents that stay.
LINES = """(() => {
    const long = [...document.querySelectorAll('main > p')].filter(p => {
        const range = document.createRange();
        range.selectNodeContents(p);
        const lines = new Set([...range.getClientRects()].map(r => Math.round(r.bottom / 9))).size;
        return lines > 3 && !p.querySelector('math') && p.textContent.length / lines > 85;
    });
    return long.map(p => p.textContent.slice(0, 40));
})()"""

STAYS = """(() => {
    scrollTo(0, document.documentElement.scrollHeight / 2);
    const nav = document.querySelector('nav'), box = nav && nav.getBoundingClientRect();
    return box && box.top >= -1 && box.bottom <= innerHeight + 1 && box.width > 100 ?
        [] : ['the contents scroll away'];
})()"""

UNFOLD = "document.querySelectorAll('details').forEach(d => d.open = true)"


class Test:
    """The questions about one page."""

    def __init__(self, browser, page):
        self.browser, self.page, self.failed = browser, page, False

    def result(self, name, wrong):
        """One line: what was asked, and the first things that are wrong."""
        self.failed |= bool(wrong)
        some = "; ".join(" ".join(str(w).split()) for w in wrong[:5])
        more = f" and {len(wrong) - 5} more" if len(wrong) > 5 else ""
        print(f"ok - {self.page}: {name}" if not wrong else f"not ok - {self.page}: {name}: {some}{more}")

    def ask(self, name, script):
        self.result(name, self.browser.evaluate(script))

    def events(self, *methods):
        return [e["params"] for e in self.browser.events if e.get("method") in methods]

    def check_silence(self):
        """What the page asked for and what it said while it was opened and used."""
        own = "file://" + os.path.abspath(self.page)
        urls = [e["request"]["url"] for e in self.events("Network.requestWillBeSent")]
        self.result("no request leaves the page",
                    [u[:100] for u in urls if u != own and not u.startswith("data:")])
        said = [e["entry"]["text"] for e in self.events("Log.entryAdded")]
        said += [str(e["args"]) for e in self.events("Runtime.consoleAPICalled")]
        said += [e["exceptionDetails"]["text"] for e in self.events("Runtime.exceptionThrown")]
        self.result("the console is silent", said)

    def run(self):
        self.browser.view(WIDE)
        self.browser.open(self.page)
        self.browser.evaluate(UNFOLD)
        for name, script in ONCE.items():
            self.ask(name, script)
        for width in WIDTHS:
            self.browser.view(width)
            for name, script in EVERY_WIDTH.items():
                self.ask(f"{name}, {width} pixels", script)
        self.ask("lines are not too long", LINES)
        self.ask("the contents stay in view on a wide screen", STAYS)
        self.ask("contrast is enough in the light", CONTRAST % "[255, 255, 255, 255]")
        self.browser.view(WIDE, dark=True)
        self.ask("dark mode is dark", DARK)
        self.ask("contrast is enough in the dark", CONTRAST % "[18, 18, 18, 255]")
        self.check_silence()


def main():
    browser, failed = Browser(), False
    for page in sys.argv[1:]:
        test = Test(browser, page)
        test.run()
        failed |= test.failed
    browser.close()
    sys.exit(failed)


main()
