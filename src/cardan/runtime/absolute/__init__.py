"""Models in finite-element coordinates: elements in tables, sparse matrices."""
