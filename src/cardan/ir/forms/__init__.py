"""Expressions in forms for people: Fourier sums, nested products, SymPy."""
