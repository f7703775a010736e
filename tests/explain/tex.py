"""Reads LaTeX closely enough to see what would not compile: braces, environments, dollar signs."""

from __future__ import annotations

import re

from cardan.equations.reading.notation import GREEK

# what our pages may use; anything else is a name that got out
_COMMANDS = """
    documentclass usepackage ifPDFTeX fi setlength parindent parskip emergencystretch newcommand
    formula share par medskip raggedright hangindent hangafter leftskip parbox small itshape hspace
    title author date begin end maketitle section subsection item toprule midrule bottomrule endhead
    arraybackslash linewidth draw node scriptsize quad allowbreak ensuremath texttt text
    textquotedbl textquotesingle textasciigrave textless textgreater textbar textbackslash
    textasciicircum textasciitilde textperiodcentered ldots displaystyle frac dot ddot mathrm
    operatorname left right sin cos tan tanh sqrt pi le ge ne cdot sum backslash hat sim log exp
    textsuperscript neq cot widetilde bar
"""
COMMANDS = frozenset(_COMMANDS.split()) | GREEK


def problems(text: str) -> list[str]:
    """What is wrong with a file."""
    found: list[str] = []
    found += [f"not ASCII or Latin: {c!r}" for c in sorted(set(text)) if ord(c) >= 0x180]
    commands = set(re.findall(r"\\([A-Za-z]+)", text))
    found += [f"unknown command: {name}" for name in sorted(commands - COMMANDS)]
    # comments and escaped signs say nothing about the structure; \\ is a line break
    plain = re.sub(r"%\n", "", text.replace("\\\\", ""))
    plain = re.sub(r"\\[{}$&#%_\[\]]", "", plain)
    found += _braces(plain)
    opened: list[str] = []
    for kind, name in re.findall(r"\\(begin|end)\{([^{}]*)\}", plain):
        if kind == "begin":
            opened.append(name)
        elif not opened or opened.pop() != name:
            found.append(f"\\end{{{name}}} closes nothing")
    found += [f"\\begin{{{name}}} stays open" for name in opened]
    for number, paragraph in enumerate(plain.split("\n")):
        if paragraph.count("$") % 2:
            found.append(f"line {number}: a dollar sign is alone: {paragraph[:80]}")
        if len(re.findall(r"\\left\b", paragraph)) != len(re.findall(r"\\right\b", paragraph)):
            found.append(f"line {number}: \\left without \\right")
    body = plain.split(r"\begin{document}")[-1]
    outside = re.sub(r"\$[^$]*\$", "", body)
    # & belongs to tables, # and ^ and _ to formulas
    outside = re.sub(r"\\begin\{longtable\}.*?\\end\{longtable\}", "", outside, flags=re.S)
    found += [f"{c} outside of formulas and tables" for c in "&#^~%" if c in outside]
    return found


def _braces(text: str) -> list[str]:
    depth = 0
    for c in text:
        depth += (c == "{") - (c == "}")
        if depth < 0:
            return ["a brace closes nothing"]
    return ["a brace stays open"] if depth else []
