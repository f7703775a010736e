"""Sphinx for the pages that ``build_site.py`` collects: no network, no script but Sphinx's own."""

from __future__ import annotations

from typing import Any

import latex2mathml.converter
from docutils import nodes
from sphinx.application import Sphinx

import cardan

project = "cardan"
author = "the authors of cardan"
version = release = cardan.__version__
extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx_design"]
exclude_patterns: list[str] = []
html_theme = "furo"
html_title = "cardan"
html_css_files = ["site.css"]
html_copy_source = html_show_sourcelink = html_show_copyright = False
html_math_renderer = "mathml"
templates_path: list[str] = []

myst_enable_extensions = ["dollarmath", "colon_fence", "deflist", "attrs_inline"]
myst_heading_anchors = 4
nb_execution_mode = "auto"  # stored outputs are shown, others are made
nb_execution_timeout = 60
nb_execution_raise_on_error = True
nb_execution_show_tb = True

autodoc_typehints = "none"
autodoc_class_signature = "mixed"
napoleon_use_rtype = False
napoleon_custom_sections = ["Source"]


def _mathml(self: Any, node: nodes.Element, display: str) -> None:
    """Formulas as MathML, which browsers set without a script."""
    self.body.append(latex2mathml.converter.convert(node.astext(), display=display))
    raise nodes.SkipNode


def _untyped(
    app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]
) -> None:
    """Docstrings of properties as they are: what stands before a colon is no type."""
    types = [line for line in lines if line.startswith(":type: ")]
    if what in ("attribute", "property") and types:
        lines[:] = [
            f"{types[0].removeprefix(':type: ')}: {' '.join(lines).partition(':type: ')[0]}",
            "",
        ]


def setup(app: Sphinx) -> None:
    app.connect("autodoc-process-docstring", _untyped, priority=900)
    app.add_html_math_renderer(
        "mathml",
        inline_renderers=(lambda self, node: _mathml(self, node, "inline"), None),
        block_renderers=(lambda self, node: _mathml(self, node, "block"), None),
    )
