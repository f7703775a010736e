"""Speed against error as one self-contained page: the picture, the advice, the table."""

from __future__ import annotations

import io
from html import escape

from ..api.results import Precision

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #1c2733; background: #fff;
       max-width: 60rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.1rem; margin: 2rem 0 .5rem; }
table { border-collapse: collapse; font-size: .9rem; }
th { text-align: left; border-bottom: 1px solid #9ab; }
th, td { padding: .15rem 1.2rem .15rem 0; }
td.number { text-align: right; font-variant-numeric: tabular-nums; }
svg { max-width: 100%; height: auto; }
"""


def page(precision: Precision) -> str:
    """The page; every name in it is the user's and is escaped."""
    title = escape(f"{precision.model}: speed against error")
    heads = ("method", "setting", "error", "ms", "steps", "evaluations")
    rows = "\n".join(
        f"<tr><td>{escape(p.method)}</td><td>{p.setting} {p.value:.2g}</td>"
        f'<td class="number">{f"{p.error:.1e}" if p.status == "finished" else p.status}</td>'
        f'<td class="number">{p.milliseconds:.3g}</td><td class="number">{p.steps}</td>'
        f'<td class="number">{p.evaluations}</td></tr>'
        for p in precision.points
    )
    advice = "".join(f"<p>{escape(line)}</p>" for line in precision.recommendation.splitlines())
    drawn = "" if precision.still else picture(precision)
    head = "".join(f"<th>{name}</th>" for name in heads)
    left = "".join(f"<p>{escape(f'{k}: {why}')}</p>" for k, why in precision.left_out.items())
    left += "".join(f"<p>{escape(line)}</p>" for line in precision.undetermined)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta http-equiv="Content-Security-Policy" '
        "content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
        f"<title>{title}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
        f"<p>{precision.span[0]:g} s to {precision.span[1]:g} s; errors from "
        f"{escape(precision.reference)}</p>\n"
        f"{drawn}\n<h2>Which method</h2>\n{advice}\n<h2>What was measured</h2>\n"
        f"<table><tr>{head}</tr>\n{rows}\n</table>\n{left}\n"
        "</body>\n</html>\n"
    )


def picture(precision: Precision) -> str:
    """The picture as SVG in the page.

    Raises:
        ModuleNotFoundError: Matplotlib is not installed.
    """
    text = io.StringIO()
    precision.plot().savefig(text, format="svg", metadata={"Date": None})
    drawn = text.getvalue()
    return drawn[drawn.index("<svg") :]
