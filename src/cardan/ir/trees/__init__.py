"""Functions of long trees: tables, the kernels that loop over them, and these as expressions."""
