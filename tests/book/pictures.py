"""pictures.py PAGE FOLDER [PART ...] -- pictures of a woven page for looking at: every part at 360, 768 and
1440 pixels, light and dark, cut into pieces of 1600 pixels. Not a test."""

import os
import sys

sys.dont_write_bytecode = True  # no folder of compiled files beside the sources
from devtools import Browser

PARTS = "[...document.querySelectorAll('main > h2, main > header')].map(h => " \
        "[h.id, h.getBoundingClientRect().top + scrollY])"
HEIGHT = 1600


def main():
    page, folder = sys.argv[1:3]
    wanted = sys.argv[3:]
    os.makedirs(folder, exist_ok=True)
    browser = Browser()
    browser.open(page)
    for width in (360, 768, 1440):
        for dark in (False, True):
            browser.view(width, HEIGHT, dark)
            browser.evaluate("document.querySelectorAll('.answer').forEach(d => d.open = true)")
            end = browser.evaluate("document.documentElement.scrollHeight")
            parts = browser.evaluate(PARTS)
            for (name, top), (_, bottom) in zip(parts, parts[1:] + [["", end]]):
                if wanted and name not in wanted:
                    continue
                for i, y in enumerate(range(int(top), int(bottom), HEIGHT)):
                    shade = "dark" if dark else "light"
                    browser.evaluate(f"scrollTo(0, {y})")
                    browser.picture(f"{folder}/{width}-{shade}-{name}-{i:02}.png")
    browser.close()


main()
