"""Functions of long trees: numbers of every body, and the tables of kernels that assemble them."""
