"""Parts of a model that comparisons with other programs read.

Adapters in ``peers`` import this and nothing below it: geometry and motion of the joints, the
tables of functions, and the compile cache that builds their C.
"""

from __future__ import annotations

from ..analyses.conversion.coordinates import SIZES, Convention, Coordinates, Pair, Sizes, paired
from ..analyses.conversion.programs import MUJOCO, PINOCCHIO
from ..ir.interpreter import evaluate
from ..ir.serialize import from_dict
from ..runtime.build import toolchain
from ..runtime.build.cache import build
from ..runtime.calls import samples
from ..runtime.calls.batch import one_by_one
from ..runtime.calls.lanes import States
from ..runtime.calls.loaded_function import LoadedFunction
from ..runtime.models.derivatives import Derivative
from ..runtime.trajectory.joint_poses import KindNumbers, pose_of
from ..runtime.verification.flat_scene import scene_of
from ..runtime.verification.joint_motion import cross, joint_data, joint_motions, times
from ..runtime.verification.loop_constraints import Moving, frames
from ..runtime.verification.newton_euler import Scene, joint_rows
from ..runtime.verification.rotations import PARAMETERS
from ..schema import kernel_files
from ..schema.blocks import ORDER, SLOT
from ..schema.mechanism import CutRow
from .compiled_model import CompiledModel
from .faces import face
from .scene_file import load

__all__ = [
    "MUJOCO",
    "ORDER",
    "PARAMETERS",
    "PINOCCHIO",
    "SIZES",
    "SLOT",
    "CompiledModel",
    "Convention",
    "Coordinates",
    "CutRow",
    "Derivative",
    "KindNumbers",
    "LoadedFunction",
    "Moving",
    "Pair",
    "Scene",
    "Sizes",
    "States",
    "build",
    "cross",
    "evaluate",
    "face",
    "frames",
    "from_dict",
    "joint_data",
    "joint_motions",
    "joint_rows",
    "kernel_files",
    "load",
    "one_by_one",
    "paired",
    "pose_of",
    "samples",
    "scene_of",
    "times",
    "toolchain",
]
