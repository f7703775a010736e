"""Builds and runs the C++ loop over Pinocchio, where its headers and Eigen are installed."""

from __future__ import annotations

import importlib.metadata
import shutil
import subprocess
from pathlib import Path
from typing import Any

SOURCE = Path(__file__).with_name("pinocchio_aba.cpp")
# Boost's lists are too short for Pinocchio's joints unless told
BOOST = ("-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_LIMIT_VECTOR_SIZE=30")
FLAGS = (
    "-std=c++17", "-O3", "-march=native", "-DNDEBUG", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS",
    *BOOST,
)  # fmt: skip


def prefix() -> Path | None:
    """Where the wheels of Pinocchio keep headers and libraries."""
    for entry in importlib.metadata.files("libpinocchio") or ():
        path = Path(str(entry.locate()))
        if path.name == "aba.hpp" and path.parent.name == "algorithm":
            return path.resolve().parents[3]
    return None


def missing() -> str:
    """What keeps the program from being built, "" where nothing does."""
    if not shutil.which("c++"):
        return "no C++ compiler"
    try:
        root = prefix()
    except importlib.metadata.PackageNotFoundError:
        root = None
    if root is None:
        return "no headers of Pinocchio: pip install pin"
    if not (root / "include" / "eigen3").is_dir():
        return "no headers of Eigen: pip install cmeel-eigen"
    return ""


def build(folder: Path) -> Path:
    """Compile the loop.

    Raises:
        subprocess.CalledProcessError: it does not compile.
    """
    root, program = prefix(), folder / "pinocchio_aba"
    assert root is not None
    include, lib = root / "include", root / "lib"
    command = [
        "c++", *FLAGS, f"-isystem{include}", f"-isystem{include / 'eigen3'}", str(SOURCE),
        "-o", str(program), f"-L{lib}", f"-Wl,-rpath,{lib}", "-lpinocchio_default",
        "-lboost_serialization",
    ]  # fmt: skip
    subprocess.run(command, check=True, capture_output=True)
    return program


def time(program: Path, model: Any, folder: Path) -> float:
    """Seconds per call of a Pinocchio model made in Python."""
    path = folder / "model.txt"
    model.saveToText(str(path))
    command = [str(program), str(path), "200", "50"]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return float(done.stdout.split()[0])
