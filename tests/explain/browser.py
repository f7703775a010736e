"""Looks at pages with a real browser: what is wider than its box, what visible text says."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from html import unescape
from pathlib import Path
from typing import Any

BROWSER = next(
    (name for name in ("chromium", "chromium-browser", "google-chrome") if shutil.which(name)), None
)
# pages are measured in frames of the width of a desk and of a telephone
WIDTHS = (1280, 400)

# boxes that scroll by design: none so far
SCRIPT = r"""
function named(e) { return e.tagName.toLowerCase() + (e.className ? "." + e.className : ""); }
function measured(frame, width) {
  const doc = frame.contentDocument, found = [];
  doc.querySelectorAll("details").forEach(d => d.open = true);
  const say = (e, why) => found.push(named(e) + ": " + why + ": " + e.textContent.slice(0, 60));
  const whole = doc.documentElement.scrollWidth;
  if (whole > width) found.push("page: " + whole);
  for (const e of doc.body.querySelectorAll("*")) {
    const box = e.getBoundingClientRect();
    if (box.width === 0) continue;
    const html = e.namespaceURI.endsWith("xhtml");
    if (html && e.clientWidth && e.scrollWidth > e.clientWidth + 1)
      say(e, e.scrollWidth + " > " + e.clientWidth);
    if (e.namespaceURI.endsWith("svg") && e.tagName !== "svg") continue;
    // what is on a page lies within the box it stands in, and within the measure
    let outer = e.parentElement;
    while (outer && outer.namespaceURI.endsWith("xhtml") && outer.clientWidth === 0)
      outer = outer.parentElement;
    const around = outer.getBoundingClientRect();
    if (box.right > around.right + 2 || box.left < around.left - 2)
      say(e, Math.round(box.left) + ".." + Math.round(box.right) + " in " + named(outer) + " "
             + Math.round(around.left) + ".." + Math.round(around.right));
    if (box.right > width + 1) say(e, "ends at " + Math.round(box.right));
  }
  return { wide: found, text: doc.body.innerText, math: doc.querySelectorAll("math").length };
}
window.onload = () => {
  const all = {};
  for (const frame of document.querySelectorAll("iframe"))
    all[frame.title] = measured(frame, parseInt(frame.width));
  document.getElementById("found").textContent = JSON.stringify(all);
};
"""


def look(pages: dict[str, str], folder: Path) -> dict[str, dict[str, Any]]:
    """Every page in every width: ``"name 400"`` -> ``wide`` (what sticks out), ``text``, ``math``.

    Args:
        pages: Name -> HTML.
        folder: Where the page that shows them all may lie.
    """
    from html import escape

    frames = "\n".join(
        f'<iframe title="{escape(name)} {width}" width="{width}" height="900" frameborder="0" '
        f'srcdoc="{escape(_unguarded(text))}"></iframe>'
        for name, text in pages.items()
        for width in WIDTHS
    )
    file = folder / "all.html"
    file.write_text(
        f'<!DOCTYPE html><meta charset="utf-8"><pre id="found"></pre>{frames}'
        f"<script>{SCRIPT}</script>",
        "utf-8",
    )
    command = [str(BROWSER), "--headless=new", "--no-sandbox", "--disable-gpu", "--dump-dom",
               f"--user-data-dir={folder / 'profile'}", "--window-size=1400,1000",
               "--virtual-time-budget=10000", file.as_uri()]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    (found,) = re.findall(r'<pre id="found">(.*?)</pre>', done.stdout, re.S)
    made: dict[str, dict[str, Any]] = json.loads(unescape(found))
    assert len(made) == len(pages) * len(WIDTHS)
    return made


def _unguarded(text: str) -> str:
    """A copy that may be measured: the page's own policy allows no script to look at it."""
    return re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", text)
