"""Draw faults, put each into one function of one scene, and count who finds it.

Run with ``python -m mutation.run --faults 1000 --seed 1`` from the folder of the tests.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import tempfile
import warnings
from collections import Counter
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from cardan.errors import CardanError
from cardan.schema.request import reads

from . import elements, rewrites
from .faults import Fault, harmed, harmed_text, lines, sites
from .judging import (
    OFF,
    States,
    by_laws,
    by_ledger,
    by_verify,
    changes,
    compiled,
    results,
    states_of,
)
from .scenes import SCENES, Loaded, expressions, loaded, with_fault, without_compiler

LAYERS, SHARES = ("IR", "rewrites", "C"), (0.5, 0.2, 0.3)
# lines of C that a fault is compiled in within a moment
LONGEST = 6000
DYNAMICS = ("rhs", "energy", "power")
# functions that others are compared with: all of them are asked when these have a fault
ASKED_BY_OTHERS = ("applied_forces", "dependents")


@dataclass(frozen=True)
class Result:
    """One fault and who found it.

    Attributes:
        scene, layer, function: Where it is.
        kind, where: What it is.
        differs: Whether results change by more than rounding.
        verify, laws, ledger: Who found it.
        said: What the verification said.
    """

    scene: str
    layer: str
    function: str
    kind: str
    where: str
    differs: bool
    verify: bool
    laws: bool
    ledger: bool
    said: str = ""


class Run:
    """Faults by a seed.

    Args:
        seed: Of everything that is drawn.
        folder: Where the scenes are written.
        scenes: Names.
    """

    def __init__(self, seed: int, folder: Path, scenes: tuple[str, ...] = SCENES) -> None:
        self.rng = np.random.default_rng(seed)
        self.folder, self.scenes = folder, scenes
        self.states = cache(lambda name: states_of(loaded(name, folder)))

    def one(self) -> Result | None:
        """The next fault; None where it is nothing that can be built."""
        name = self.scenes[self.rng.integers(len(self.scenes))]
        base = loaded(name, self.folder)
        layer = str(self.rng.choice(LAYERS, p=SHARES))
        symbol = self._function(base)
        text = base.texts[symbol]
        if layer == "rewrites" and base.keys:
            found = rewrites.harmed(base, self.rng)
            if found is None:
                return None
            key, new, fault = found
            return self._judged(base, layer, base.symbol(key), new, fault)
        if layer == "C":
            return self._in_c(base, symbol)
        new, fault = harmed(text, int(self.rng.integers(sites(text))), self.rng)
        return self._judged(base, "IR", symbol, new, fault)

    def _function(self, base: Loaded) -> str:
        """A function by the number of its nodes and assignments."""
        symbols = [base.symbol(key) for key in base.keys] or list(base.texts)
        weights = np.array([sites(base.texts[s]) for s in symbols], dtype=float)
        return symbols[self.rng.choice(len(symbols), p=weights / weights.sum())]

    def _judged(
        self, base: Loaded, layer: str, symbol: str, text: dict[str, Any], fault: Fault
    ) -> Result | None:
        """A fault in expressions."""
        try:
            code = expressions(base, symbol, text)
        except (ValueError, CardanError):
            return None
        told = (base.name, layer, symbol, fault.kind, fault.where)
        if not base.keys:
            differs, said = elements.judged(base, symbol, text, code)
            return Result(*told, differs, bool(said), False, False, said)
        at: States = self.states(base.name)
        name = symbol.partition("__")[0]
        blocks = at.off if name in OFF else at.on
        try:
            differs = changes(results(base.texts[symbol], blocks), results(text, blocks))
        except CardanError:
            differs = True
        if not differs:
            return Result(*told, False, False, False, False)
        model = with_fault(base, symbol, text, code)
        said = self._said(base, symbol, model)
        laws = by_laws(base, name, text, at)
        ledger = name in DYNAMICS and by_ledger(model)
        return Result(*told, True, bool(said), laws, ledger, said)

    def _said(self, base: Loaded, symbol: str, model: Any) -> str:
        key = next(k for k in base.keys if base.symbol(k) == symbol)
        found = by_verify(model, [key])
        if not found and key[0] in ASKED_BY_OTHERS:
            found = by_verify(model, base.keys)
        return found

    def _in_c(self, base: Loaded, symbol: str) -> Result | None:
        """A fault in C; whether it differs is seen by what it gives."""
        path = base.model.directory / f"{symbol}.c"
        text = path.read_text(encoding="utf-8")
        places = lines(text)
        if not places or len(text.splitlines()) > LONGEST:
            return None
        layout = base.model._layout
        sizes = {k: len(layout.names(k)) for k in ("q", "u", "udot", "tau", "r", "z")}
        at = places[self.rng.integers(len(places))]
        new, fault = harmed_text(text, at, self.rng, sizes)
        try:
            code, whole = (compiled(base, symbol, x) for x in (new, text))
        except subprocess.CalledProcessError:
            return None
        told = (base.name, "C", symbol, fault.kind, fault.where)
        if not base.keys:
            differs, said = elements.judged(base, symbol, None, code, whole)
            return Result(*told, differs, bool(said), False, False, said)
        model, right = (with_fault(base, symbol, None, c) for c in (code, whole))
        key = next(k for k in base.keys if base.symbol(k) == symbol)
        values = [self._values(m, key) for m in (right, model)]
        if not changes(*values):
            return Result(*told, False, False, False, False)
        said = self._said(base, symbol, model)
        ledger = key[0] in DYNAMICS and by_ledger(model)
        return Result(*told, True, bool(said), False, ledger, said)

    def _values(self, model: Any, key: Any) -> list[Any]:
        """Results of a loaded function at the states."""
        at = self.states(self._name(model))
        blocks = at.off if key[0] in OFF else at.on
        values: list[Any] = []
        for letter in reads(*key):
            if letter == "x":
                values.append(np.concatenate([blocks[k] for k in "quz"], axis=-1))
            elif letter == "t":
                values.append(blocks["t"][:, 0])
            elif letter == "wrench":
                values.append(blocks["wrench"].reshape(len(blocks["q"]), -1, 6))
            else:
                values.append(blocks[letter])
        n = len(blocks["q"]) if values else 1
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            return [np.asarray(model._function(*key).caller(None, *values)).reshape(n, -1)]

    def _name(self, model: Any) -> str:
        return next(
            n for n in self.scenes if loaded(n, self.folder).model.directory == model.directory
        )


def summary(found: list[Result], seed: object) -> str:
    """Shares in words, and everything that was not found."""
    real = [r for r in found if r.differs]
    n = max(1, len(real))
    same = len(found) - len(real)
    out = [f"seed {seed}: {len(found)} faults, {same} change nothing by more than rounding"]
    for layer in LAYERS:
        some = [r for r in real if r.layer == layer]
        if some:
            share = sum(r.verify for r in some) / len(some)
            out.append(f"  {layer}: {len(some)} faults, verify() finds {share:.2%}")
    verified, anyone = (
        sum(r.verify for r in real),
        sum(r.verify or r.laws or r.ledger for r in real),
    )
    laws, ledger = (sum(getattr(r, who) for r in real) / n for who in ("laws", "ledger"))
    out.append(f"verify() finds {verified} of {len(real)}: {verified / n:.2%}")
    out.append(f"laws {laws:.2%}, ledger {ledger:.2%}; verify, laws or ledger: {anyone / n:.2%}")
    out += [
        f"  not found: {r.scene} {r.layer} {r.function}: {r.kind}: {r.where}"
        for r in real
        if not r.verify
    ]
    kinds = Counter(r.kind for r in real)
    out.append("kinds: " + ", ".join(f"{k} {v}" for k, v in kinds.most_common()))
    return "\n".join(out)


def main() -> None:
    """The run that the page of the project shows."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--faults", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=Path)
    given = parser.parse_args()
    without_compiler()
    with tempfile.TemporaryDirectory() as folder:
        run, found = Run(given.seed, Path(folder)), list[Result]()
        while len(found) < given.faults:
            result = run.one()
            if result is None:
                continue
            found.append(result)
            if given.out:
                with given.out.open("a") as file:
                    file.write(json.dumps(asdict(result)) + "\n")
            if result.differs and not result.verify:
                print("not found:", result, flush=True)
    print(summary(found, given.seed))


if __name__ == "__main__":
    main()
