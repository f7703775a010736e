"""What people read is plain English: messages, help texts, docstrings and pages."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from architecture.sources import PACKAGE, ROOT, modules, tree

LONGEST = 35  # words of a sentence
PAGES = [*sorted((ROOT / "docs").glob("*.md")), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
REFUSED = {
    # "is no link": "is not a link"
    "is no": re.compile(
        r"(?<![Tt]here )\b(?:is|are|was|were) no "
        r"(?!longer|more|less|other|such|need|matter|one\b)[a-z]\w*"
    ),
    # the kinematic loop, which only the graph, its matrix and names in the code call a circuit
    "circuit": re.compile(r"(?<!graph\.)\b[Cc]ircuits?\b(?! matrix|:)"),
    "1 bodies": re.compile(
        r"(?<![\w.,^{-])1 (?:bodies|beams|joints|loops|modes|nodes|rows|runs|speeds|steps|values)\b"
    ),
}
CODE = re.compile(r"`[^`\n]+`")
OPENING = re.compile(r"(What|How|Whether|Where|Which|Of)\b")
MESSAGES = re.compile(r"Error$|Warning$|^warn$|^error$|^refuse|message|^print$|^add_argument$")


def sentences(text: str) -> Iterator[str]:
    """Sentences of a page or text, code as one word each."""
    text = re.sub(r"```.*?```|<!--.*?-->", " ", text, flags=re.S)
    text = re.sub(r"^\s*\|.*$|^ {4,}\S.*$", "", text, flags=re.M)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*[-*#\d])", text):
        yield from re.split(r"(?<=[.!?:;])\s+(?=[A-Z`*\"'(])", " ".join(paragraph.split()))


def words(sentence: str) -> int:
    return len(re.findall(r"[A-Za-z][\w'-]*", re.sub(r"`[^`]*`|'[^' ]*'", "X", sentence)))


def constant(node: ast.AST) -> str | None:
    """The text of a string, with X for what is filled in."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(constant(part) or "X" for part in node.values)
    return None


def messages(path: Path) -> Iterator[tuple[int, str]]:
    """Texts that a file gives to errors, warnings, help and the screen."""
    for node in ast.walk(tree(path)):
        if not isinstance(node, ast.Call):
            continue
        name = getattr(node.func, "attr", getattr(node.func, "id", ""))
        if MESSAGES.search(name):
            for argument in [*node.args, *(word.value for word in node.keywords)]:
                text = constant(argument)
                if text is not None and " " in text:
                    yield node.lineno, text


def docstrings(path: Path) -> Iterator[tuple[int, str]]:
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            text = ast.get_docstring(node)
            if text:
                yield getattr(node, "lineno", 1), text


def said(path: Path) -> Iterator[tuple[int, str]]:
    yield from messages(path)
    yield from docstrings(path)


@pytest.mark.parametrize("name", REFUSED)
def test_constructions_that_no_engineer_writes(name: str) -> None:
    found = [
        f"{path.relative_to(PACKAGE)}:{line}: {match[0]}"
        for path in modules().values()
        for line, text in said(path)
        for match in REFUSED[name].finditer(text)
    ]
    found += [
        f"{page.name}: {match[0]}"
        for page in PAGES
        for match in REFUSED[name].finditer(CODE.sub("X", page.read_text("utf-8")))
    ]
    assert not found, "\n".join(found)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_sentences_of_pages_are_short(page: Path) -> None:
    long = [one for one in sentences(page.read_text("utf-8")) if words(one) > LONGEST]
    assert not long, "\n".join(long)


def test_sentences_of_messages_are_short() -> None:
    long = [
        f"{path.relative_to(PACKAGE)}:{line}: {one}"
        for path in modules().values()
        for line, text in messages(path)
        for one in sentences(text)
        if words(one) > LONGEST
    ]
    assert not long, "\n".join(long)


def test_docstrings_open_with_the_thing_or_the_act() -> None:
    texts = [text for path in modules().values() for _, text in docstrings(path)]
    assert sum(bool(OPENING.match(text)) for text in texts) <= 0.02 * len(texts)


def test_what_is_refused() -> None:
    assert REFUSED["is no"].search("'a' is no link")
    assert not REFUSED["is no"].search("there is no link 'a'")
    assert REFUSED["1 bodies"].search("a scene of 1 bodies")
    assert not REFUSED["1 bodies"].search("a scene of 11 bodies")
    assert list(sentences("One. Two `x.y` three.\n\n- four")) == [
        "One.",
        "Two `x.y` three.",
        "- four",
    ]
    assert words("Two `a b c` three 'd'") == 4
