"""Runs the cells of a notebook as Jupyter does, without Jupyter."""

from __future__ import annotations

import ast
import io
import json
import re
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

# steps, times and rounding of a run differ between machines; its drawing does not
WENT = re.compile(r"<details><summary>how it went</summary>.*?</details>", re.DOTALL)
REPRESENTATIONS = {
    "text/html": "_repr_html_",
    "image/svg+xml": "_repr_svg_",
    "text/latex": "_repr_latex_",
}


def load(path: Path) -> dict[str, Any]:
    notebook: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return notebook


def save(path: Path, notebook: dict[str, Any]) -> None:
    text = json.dumps(notebook, indent=1, ensure_ascii=False)
    path.write_text(text + "\n", encoding="utf-8")


def run(notebook: dict[str, Any]) -> list[list[dict[str, Any]]]:
    """Outputs of the code cells, run in one namespace; an error ends its cell."""
    names: dict[str, Any] = {"__name__": "__main__"}
    found = []
    for number, cell in enumerate(code(notebook), 1):
        made = _cell("".join(cell["source"]), number, names)
        fails = any(output["output_type"] == "error" for output in made)
        assert fails == ("raises-exception" in cell["metadata"].get("tags", ())), made
        found.append(made)
    return found


def code(notebook: dict[str, Any]) -> list[dict[str, Any]]:
    return [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]


def _cell(source: str, number: int, names: dict[str, Any]) -> list[dict[str, Any]]:
    """What a cell prints, then its last value or its error."""
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    printed, outputs = io.StringIO(), []
    shown: list[dict[str, Any]] = []
    with redirect_stdout(printed):
        try:
            exec(compile(tree, f"cell {number}", "exec"), names)
            if last is not None:
                expression = ast.Expression(last.value)
                value = eval(compile(expression, f"cell {number}", "eval"), names)
                shown = [] if value is None else [_shown(value, number)]
        except Exception as problem:
            shown = [_error(problem)]
    if printed.getvalue():
        text = printed.getvalue().splitlines(keepends=True)
        outputs.append({"name": "stdout", "output_type": "stream", "text": text})
    return outputs + shown


def _shown(value: Any, number: int) -> dict[str, Any]:
    data: dict[str, Any] = {}
    for kind, method in REPRESENTATIONS.items():
        text = getattr(value, method)() if hasattr(value, method) else None
        if text is not None:
            data[kind] = WENT.sub("", text).splitlines(keepends=True)
    if "text/html" not in data:
        # what is drawn needs no text beside it, which may tell how long a run took
        data["text/plain"] = repr(value).splitlines(keepends=True)
    return {
        "data": data,
        "execution_count": number,
        "metadata": {},
        "output_type": "execute_result",
    }


def _error(problem: Exception) -> dict[str, Any]:
    name = type(problem).__name__
    return {
        "ename": name,
        "evalue": str(problem),
        "output_type": "error",
        "traceback": [f"{name}: {problem}"],
    }
