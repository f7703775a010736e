"""Build the package: pip install .   or   python setup.py build_ext --inplace"""

from pathlib import Path

from Cython.Build import cythonize
from setuptools import Extension, setup

SOURCES = sorted(path.name for path in Path(__file__).parent.glob("*.c"))
FLAGS = ["-std=c99", "-O2", "-fno-math-errno", "-ffp-contract=on"]
EXTENSION = Extension(
    "foot_linkage", ["foot_linkage.pyx", *SOURCES], include_dirs=["."], extra_compile_args=FLAGS
)

setup(ext_modules=cythonize([EXTENSION], build_dir="build"))
