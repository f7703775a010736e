"""Paths of solutions as a parameter changes: folds, branch points, and branches that meet."""
