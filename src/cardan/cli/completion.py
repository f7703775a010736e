"""Completion for shells: the commands and options of the parser as a script."""

from __future__ import annotations

import argparse
from collections.abc import Mapping

SHELLS = ("bash", "zsh", "fish")

BASH = """\
# completion of cardan; in ~/.bashrc:  eval "$(cardan --completion bash)"
_cardan() {{
    local w word=${{COMP_WORDS[COMP_CWORD]}} command= options=
    for w in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        case "$w" in -*) ;; *) command=$w; break ;; esac
    done
    case "$command" in
{cases}
        *) options="{commands} {top}" ;;
    esac
    COMPREPLY=($(compgen -W "$options" -- "$word"))
    if [[ -n "$command" && "$word" != -* ]]; then
        COMPREPLY+=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _cardan cardan"""

ZSH = "autoload -U +X bashcompinit && bashcompinit\n"


def script(shell: str, top: argparse.ArgumentParser, commands: Mapping[str, str]) -> str:
    """The script of a shell.

    Args:
        shell: One of :data:`SHELLS`.
        top: The parser with all commands in it.
        commands: Name -> what it does, in one line.
    """
    chosen = next(a for a in top._actions if isinstance(a, argparse._SubParsersAction))
    options = {name: _options(parser) for name, parser in chosen.choices.items()}
    if shell == "fish":
        return _fish(options, commands, _options(top))
    cases = "\n".join(
        f'        {name}) options="{" ".join(flags)}" ;;' for name, flags in options.items()
    )
    text = BASH.format(cases=cases, commands=" ".join(commands), top=" ".join(_options(top)))
    return ZSH + text if shell == "zsh" else text


def _options(parser: argparse.ArgumentParser) -> dict[str, str]:
    """Option -> its help, the long spelling of each."""
    flags = [(a.option_strings[-1], a.help or "") for a in parser._actions if a.option_strings]
    return {name: "" if help_text == argparse.SUPPRESS else help_text for name, help_text in flags}


def _fish(
    options: Mapping[str, Mapping[str, str]], commands: Mapping[str, str], top: Mapping[str, str]
) -> str:
    """One line per command and option."""
    lines = ["# completion of cardan; in config.fish:  cardan --completion fish | source"]
    for name, help_text in commands.items():
        lines.append(
            f"complete -c cardan -n __fish_use_subcommand -a {name} -d {_quoted(help_text)}"
        )
    for option, help_text in top.items():
        lines.append(_option("__fish_use_subcommand", option, help_text))
    for name, flags in options.items():
        where = f"'__fish_seen_subcommand_from {name}'"
        lines += [_option(where, option, words) for option, words in flags.items()]
    return "\n".join(lines)


def _option(where: str, option: str, help_text: str) -> str:
    return f"complete -c cardan -n {where} -l {option.lstrip('-')} -d {_quoted(help_text)}"


def _quoted(help_text: str) -> str:
    text = help_text.replace("%%", "%").replace("\\", "\\\\").replace("'", "\\'")
    return f"'{text}'"
