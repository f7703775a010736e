"""WebAssembly: modules as bytes, and models as modules that work on the memory of the kernels."""
