"""Which characters of a C++ file are code."""

import re

_OPAQUE = re.compile(
    r"""//[^\n]*
      | /\*.*?\*/
      | R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)"
      | "(?:[^"\\\n]|\\.)*"
      | (?<![0-9A-Za-z_])'(?:[^'\\\n]|\\.)+'
      | ^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*
      """,
    re.VERBOSE | re.DOTALL | re.MULTILINE,
)
_ASSERTION = re.compile(r"\b(?:assert|static_assert|Q_ASSERT|Q_ASSERT_X)\s*\(")


def closing(text, opening):
    """The index of the bracket that closes the one at `opening`; the end of the text where none does."""
    pairs = {"(": ")", "[": "]", "{": "}"}
    waiting = []
    for i in range(opening, len(text)):
        if text[i] in pairs:
            waiting.append(pairs[text[i]])
        elif waiting and text[i] == waiting[-1]:
            waiting.pop()
            if not waiting:
                return i
    return len(text)


def _blank(text):
    return re.sub(r"[^\n]", " ", text)


def _hidden(match):
    text = match.group()
    quote = text.find('"') if text[0] in 'R"' else 0 if text[0] == "'" else -1
    return _blank(text) if quote < 0 else text[0] + "_" * (len(text) - 2) + text[-1]


def masked(text):
    """As long as `text`, with only code left: comments, preprocessor lines and assertions are blanks, and
    the insides of strings and characters are underscores."""
    code = _OPAQUE.sub(lambda m: re.sub(r"[^\n]", "_", _hidden(m)) if "\n" in m.group() and m.group()[0] == "R"
                       else _hidden(m), text)
    for match in list(_ASSERTION.finditer(code)):
        end = closing(code, match.end() - 1) + 1
        code = code[: match.start()] + _blank(code[match.start() : end]) + code[end:]
    return code


def lines_of_code(text):
    return sum(1 for line in masked(text).split("\n") if line.strip())
