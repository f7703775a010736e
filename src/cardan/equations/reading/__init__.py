"""Equations for people: SymPy, LaTeX, MathML, counts, conserved quantities."""
