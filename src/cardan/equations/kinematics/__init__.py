"""Motion of a tree, its inertia and its loads."""
