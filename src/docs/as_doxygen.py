"""Comments of a header as doxygen reads them: a filter, from a file to standard output.

Comments have paragraphs, lists, indented formulas, and entries, a word or some and what is said of
them in a second column:

    /// error    at most tolerance
    ///          ... of the largest

Formulas stay as they are broken, entries become titled paragraphs; lines keep no numbers.
"""

import re
import sys
from pathlib import Path

entry = re.compile(r"([^\W\d][\w, :()\[\]]*?)(?: {2,}| (?=\t))(\S.*)")


def plain(text):
    """No mark of doxygen's or of HTML's is one; what stands between backticks is code."""
    text = re.sub(r"([\\@&#<>%\"$])", r"\\\1", text)
    return re.sub(r"`([^`]+)`", r"<tt>\1</tt>", text)


class Comment:
    def __init__(self):
        self.lines, self.formula, self.kind = [], [], "prose"

    def end_formula(self):
        while self.formula and not self.formula[-1].strip():
            self.formula.pop()
        if self.formula:
            self.lines += ["@verbatim", *self.formula, "@endverbatim", ""]
        self.formula = []

    def say(self, kind, *lines):
        self.end_formula()
        if kind != self.kind:
            self.lines.append("")
        self.kind = kind
        self.lines += lines

    def add(self, text):
        found = entry.fullmatch(text)
        inside = text.startswith("  ")
        if not text.strip():
            self.blank()
        elif found:
            self.say("entry", "", "@par " + plain(found[1]), plain(found[2]))
        elif inside and self.kind in ("entry", "list"):
            self.lines.append("  " + plain(text.strip()))
        elif inside:
            self.formula.append(text[2:])
        else:
            self.say("list" if text.startswith("- ") else "prose", plain(text))

    def blank(self):
        if self.formula:
            self.formula.append("")
            return
        self.lines.append("")
        if self.kind == "entry":
            self.lines += ["@par", ""]
        self.kind = "prose"

    def told(self):
        self.end_formula()
        return self.lines


def filtered(text):
    comment, margin = None, ""
    for line in text.split("\n"):
        told = re.fullmatch(r"(\s*)///(?!<) ?(.*)", line)
        if told:
            comment, margin = comment or Comment(), told[1]
            comment.add(told[2])
            continue
        if comment:
            yield from ["/**", *comment.told(), "*/"]
        comment = None
        yield line


if __name__ == "__main__":
    print("\n".join(filtered(Path(sys.argv[1]).read_text())))
