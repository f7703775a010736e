"""Systems in finite-element coordinates: large sparse matrices of small blocks."""
