"""Messages in the words of the command line: ``limits='stop'`` is typed ``--limits stop``."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable

# an argument of a Python function, with a text, a truth value or nothing as its value
_ARGUMENT = re.compile(r"(?<![\w.'\"<-])([a-z_]+)=(?:'([\w.-]*)'|(True|False)\b|(?=[\s,;.)]|$))")


def speller(parser: argparse.ArgumentParser) -> Callable[[str], str]:
    """The function that rewrites a message for those who typed a command.

    Arguments that the command has no option for stay as they are.

    Args:
        parser: Of the command, with its options.
    """
    options = {
        flag.removeprefix("--").replace("-", "_"): action
        for action in parser._actions
        for flag in action.option_strings
        if flag.startswith("--")
    }

    def typed(match: re.Match[str]) -> str:
        name, text, boolean = match.groups()
        # a switch has no value: --friction is friction=True, --no-snap is snap=False
        option = options.get(f"no_{name}" if boolean == "False" else name)
        if option is None or (option.nargs == 0) is not bool(boolean):
            return match.group()
        flag = option.option_strings[-1]
        return f"{flag} {text}" if text else flag

    return lambda message: _ARGUMENT.sub(typed, message)


def spelled(message: str, options: argparse.Namespace) -> str:
    """A message in the words of the command whose options these are."""
    return speller(options.parser)(message)
