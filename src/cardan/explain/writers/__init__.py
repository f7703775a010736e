"""The languages of pages: each writes a document as text."""

from __future__ import annotations

from . import html, latex, markdown

# ending of the file -> writer
WRITERS = {".html": html, ".tex": latex, ".md": markdown}
