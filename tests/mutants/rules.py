"""The rules by which a small fault is made: each finds places in masked code and says what stands there instead.

They count on the layout that clang-format gives: a comparison has blanks about it, a template's brackets have none.
"""

import re
from typing import NamedTuple

from code import closing


class Change(NamedTuple):
    start: int
    end: int
    new: str  # what text[start:end] becomes; ORIGINAL stands for what it was


ORIGINAL = "\0"


def _operators(code, table):
    symbols = "|".join(re.escape(symbol) for symbol in sorted(table, key=len, reverse=True))
    for match in re.finditer(rf"(?<=[\w)\]\"'])\s({symbols})(?=\s)", code):
        if code[max(0, match.start() - 8) : match.start()] in ("template", "operator"):
            continue
        for new in table[match.group(1)]:
            yield Change(match.start(1), match.end(1), new)


def boundary(code):
    return _operators(code, {"<": ["<="], "<=": ["<"], ">": [">="], ">=": [">"]})


def reversal(code):
    return _operators(code, {"<": [">="], "<=": [">"], ">": ["<="], ">=": ["<"], "==": ["!="], "!=": ["=="]})


def logic(code):
    return _operators(code, {"&&": ["||"], "||": ["&&"]})


def arithmetic(code):
    return _operators(code, {"+": ["-"], "-": ["+"], "*": ["/"], "/": ["*"], "+=": ["-="], "-=": ["+="],
                             "*=": ["/="], "/=": ["*="]})


def sign(code):
    """A minus or a negation that is forgotten."""
    for match in re.finditer(r"(?:[(,=\[{?:]\s?|\breturn )(-)(?=[\w(])", code):
        yield Change(match.start(1), match.end(1), "")
    for match in re.finditer(r"(?:[(,=?:]\s?|\breturn |(?:&&|\|\|) )(!)(?=[\w(])", code):
        yield Change(match.start(1), match.end(1), "")


def constant(code):
    """Off by one, twice or ten times as large."""
    for match in re.finditer(r"(?<![\w.'])(\d[\d']*(?:\.\d*)?(?:e[-+]?\d+)?)([uz]*)(?![\w.'])", code):
        number, suffix = match.groups()
        around = code[max(0, match.start() - 1) : match.end() + 1]
        if around[0] == "<" or around[-1] == ">":  # an argument of a template
            continue
        place = match.start(), match.end()
        if re.fullmatch(r"[\d']+", number):
            value = int(number.replace("'", ""))
            yield Change(*place, f"{value + 1}{suffix}")
            if value > 1:
                yield Change(*place, f"{value - 1}{suffix}")
        if float(number.replace("'", "")) != 0 and not suffix:
            yield Change(*place, f"({ORIGINAL} * 2)")
            yield Change(*place, f"({ORIGINAL} * 10)")


def extremes(code):
    """The smaller one for the larger one."""
    pairs = [("min", "max"), ("min_element", "max_element"), ("minCoeff", "maxCoeff"), ("cwiseMin", "cwiseMax"),
             ("lower_bound", "upper_bound"), ("floor", "ceil"), ("any_of", "all_of"), ("sin", "cos")]
    table = {a: b for pair in pairs for a, b in (pair, pair[::-1])}
    for match in re.finditer(r"(?<=::|.\.)(" + "|".join(table) + r")(?=\()", code):
        yield Change(match.start(1), match.end(1), table[match.group(1)])


def truth(code):
    for match in re.finditer(r"\b(true|false)\b", code):
        yield Change(match.start(), match.end(), "false" if match.group() == "true" else "true")


def guard(code):
    """What a condition guards is never done; where the condition acts, its answer is ignored."""
    for match in re.finditer(r"\bif \(", code):
        end = closing(code, match.end() - 1)
        if ";" not in code[match.end() : end]:
            yield Change(match.end(), end, f"({ORIGINAL}) && false")


_NO_STATEMENT = re.compile(r"(?:return\b.|throw|using|typedef|case|default|goto|emit$|public|private|protected|friend)")
_HEADER = re.compile(r"\s*(?:else\s+)?(?:if|for|while)\b(?: constexpr)? ?\(|\s*else\b")


def _only_ends(code):
    """The code with those semicolons alone that end a statement: a comma for each in the head of a loop."""
    characters, open_brackets = list(code), []
    for i, character in enumerate(code):
        if character in "({":
            open_brackets.append(character)
        elif character in ")}" and open_brackets:
            open_brackets.pop()
        elif character == ";" and open_brackets and open_brackets[-1] == "(":
            characters[i] = ","
    return "".join(characters)


def dropped(code):
    """A statement that is not there: a call, an assignment, a jump; no declaration."""
    code = _only_ends(code)
    for match in re.finditer(r"[^;{}]+;", code):
        start, end = match.span()
        while header := _HEADER.match(code, start, end):
            start = header.end()
            if code[start - 1] == "(":
                start = closing(code, start - 1) + 1
        while start < end and code[start].isspace():
            start += 1
        statement = code[start : end - 1]
        if not statement or _NO_STATEMENT.match(statement) or statement.count("(") != statement.count(")"):
            continue
        assigned = re.match(r"[\w.\->\[\]():*]+ (?:=|[-+*/|&]=) ", statement)
        called = re.match(r"[\w.\->\[\]():<>*]+\(", statement) and statement.endswith(")")
        stepped = re.fullmatch(r"(?:\+\+|--)[\w.\->\[\]]+|break|continue|return", statement)
        if assigned or called or stepped:
            yield Change(start, end, "{}")


def answer(code):
    """A function that answers with the default of its type."""
    for match in re.finditer(r"\breturn ([^;]+);", code):
        if match.group(1).strip() not in ("{}", "*this", "0", "false", "nullptr", "std::nullopt"):
            yield Change(match.start(1), match.end(1), "{}")


RULES = [boundary, reversal, logic, arithmetic, sign, constant, extremes, truth, guard, dropped, answer]
