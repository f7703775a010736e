"""Exports as WebAssembly in a browser: the page of the README, served, and its bits.

Needs Chromium and the package playwright (``make browser`` installs the latter).
"""

from __future__ import annotations

import json
import re
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from codegen.bindings import unit, wrist
from view.test_browser import CHROMIUM, OPTIONS, sync_api


class Quiet(SimpleHTTPRequestHandler):
    """Says nothing."""

    def log_message(self, *_: Any) -> None:
        pass


def test_a_page_has_the_bits_of_a_native_build(tmp_path: Path) -> None:
    folder = cd.derive(wrist()).export(tmp_path / "wrist", ["forward_dynamics"], language="wasm")
    html = re.findall(r"```html\n(.*?)```", (folder / "README.md").read_text("utf-8"), re.DOTALL)
    (folder / "page.html").write_text(f"<!doctype html><body>{html[0]}", "utf-8")
    model = cd.compile(wrist(), reproducible=True)
    q, u = unit(np.array([0.9, 0.1, -0.2, 0.3, 0.4]), (0,)), np.full(4, 0.3)
    at = json.dumps({"q": q.tolist(), "u": u.tolist()})
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Quiet, directory=str(folder)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    complaints: list[str] = []
    try:
        with sync_api.sync_playwright() as started:
            chromium = started.chromium.launch(executable_path=CHROMIUM, args=OPTIONS)
            page = chromium.new_page()
            page.on("pageerror", lambda error: complaints.append(str(error)))
            page.goto(f"http://127.0.0.1:{server.server_port}/page.html")
            page.wait_for_function("document.body.innerText.includes(',')", timeout=60000)
            text = page.inner_text("body")
            found = page.evaluate(
                "async () => { const { load } = await import('./wrist.mjs');"
                f"return [...(await load()).forward_dynamics({at})]; }}"
            )
            chromium.close()
    finally:
        server.shutdown()
        server.server_close()
        thread.join()
    assert complaints == []
    # the page shows the start
    q0 = np.array([1.0, 0, 0, 0, 0])
    shown = np.array([float(x) for x in text.split(",")])
    np.testing.assert_array_equal(shown, model.forward_dynamics(q0, np.zeros(4)))
    np.testing.assert_array_equal(found, model.forward_dynamics(q, u))
