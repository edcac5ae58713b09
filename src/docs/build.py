"""The pages of this project as a site: HTML by Sphinx, headers by doxygen, docstrings of Python.

    src/docs/build.py FOLDER        writes FOLDER/index.html and all behind it

Pages are read where they stand. FOLDER/.pages has a link for each of them and for what they link
to, so that their relative links hold; pages of headers are made of the table on src/README.md and
the comments of the headers. A link that leads nowhere, or a page that no list of contents has, is
an error. Nothing of the site asks the network.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

here = Path(__file__).resolve().parent
root = here.parents[1]
parts = ("tree", "fmm", "src", "cases", "tests", "plots")


def headers():
    """(path below root, what it is for), as src/README.md says."""
    table = (root / "src/README.md").read_text().split("## Headers that a user includes", 1)[1]
    found = []
    for names, meaning in re.findall(r"^\| (`.+?`) \| (.+?) \|$", table, re.M):
        folder = ""
        for name in re.findall(r"`([^`]+)`", names):
            folder = folder if "/" not in name else name.rsplit("/", 1)[0] + "/"
            path = name if "/" in name else folder + name
            found.append(path if (root / path).exists() else "src/" + path)
            yield found[-1], meaning


def link_pages(pages):
    """A tree of links to what stands in the project, without what was built."""
    for top in root.iterdir():
        if top.is_file():
            (pages / top.name).symlink_to(top)
    for part in parts:
        for folder, inside, files in os.walk(root / part):
            inside[:] = [name for name in inside if not name.startswith((".", "__"))]
            room = pages / Path(folder).relative_to(root)
            room.mkdir()
            for name in files:
                (room / name).symlink_to(Path(folder) / name)


def entities(xml):
    """(header, line, directive, name) of all that stands in the namespaces of headers."""
    for file in sorted(xml.glob("*.xml")):
        compound = ElementTree.parse(file).getroot().find("compounddef")
        if compound is None:
            continue
        if compound.get("kind") in ("class", "struct"):
            place = compound.find("location")
            yield place.get("file"), int(place.get("line")), compound.get("kind"), compound[0].text
        for member in compound.iter("memberdef") if compound.get("kind") == "namespace" else ():
            place, kind = member.find("location"), member.get("kind")
            name = f"{compound[0].text}::{member.findtext('name')}"
            if kind == "function":
                name += member.findtext("argsstring")
            yield place.get("file"), int(place.get("line")), kind, name


def outermost(found):
    names = {name for *_, name in found}
    return [one for one in found if one[3].rpartition("::")[0] not in names]


def directive(kind, name):
    members = ":members:\n:undoc-members:\n" if kind in ("class", "struct") else ""
    return f"```{{doxygen{kind}}} {name}\n{members}```\n"


def write_header_pages(pages, listed, xml):
    room = pages / "headers"
    room.mkdir()
    lines, names = [], []
    found = sorted(outermost(list(entities(xml))))
    for path, meaning in listed:
        spoken = path.removeprefix("src/")
        name = spoken.removesuffix(".hpp").replace("/", "_")
        names.append(name)
        lines.append(f"| [`{spoken}`]({name}.md) | {meaning} |")
        told = [directive(kind, what) for file, _, kind, what in found if file == path]
        if not told:
            sys.exit(f"doxygen found nothing in {path}")
        (room / f"{name}.md").write_text("\n".join(
            [f"# {spoken}", "", f"For {meaning}: `#include <vortree/{spoken}>`", "", *told]))
    toctree = "\n".join(["```{toctree}", ":hidden:", "", *names, "```"])
    (room / "index.md").write_text("\n".join(
        ["# Headers", "", "| header | for |", "|---|---|", *lines, "", toctree, ""]))


def write_python_page(pages):
    """All names that the package of Python has for its users."""
    text = (root / "src/python/vortree/__init__.py").read_text()
    names = re.findall(r'"(\w+)"', re.search(r"__all__ = \[(.*?)\]", text, re.S)[1])
    blocks = []
    for name in names:
        kind, rest = ("class", ":members:\n") if name[0].isupper() else ("function", "")
        blocks.append(f"## {name}\n\n```{{eval-rst}}\n.. auto{kind}:: vortree.{name}\n"
                      + (f"   {rest}" if rest else "") + "```\n")
    (pages / "src/python/names.md").write_text("\n".join(["# Names of the package", "", *blocks]))


def read_headers(listed, xml):
    settings = f"""
        INPUT = {" ".join(f'"{root / path}"' for path, _ in listed)}
        INPUT_FILTER = "{sys.executable} -B {here / 'as_doxygen.py'}"
        STRIP_FROM_PATH = "{root}"
        OUTPUT_DIRECTORY = "{xml.parent}"
        XML_OUTPUT = {xml.name}
        GENERATE_XML = YES
        GENERATE_HTML = NO
        GENERATE_LATEX = NO
        EXTRACT_ALL = YES
        XML_PROGRAMLISTING = NO
        MARKDOWN_SUPPORT = NO
        AUTOLINK_SUPPORT = NO
        ENABLE_PREPROCESSING = NO
        QUIET = YES
        WARN_AS_ERROR = YES
    """
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)


def main(site):
    shutil.rmtree(site, ignore_errors=True)
    pages, xml = site / ".pages", site / ".doxygen"
    pages.mkdir(parents=True)
    listed = list(headers())
    link_pages(pages)
    write_python_page(pages)
    read_headers(listed, xml)
    write_header_pages(pages, listed, xml)
    subprocess.run(
        [sys.executable, "-B", "-m", "sphinx", "-q", "-W", "--keep-going", "-j", "auto",
         "-b", "html", "-c", here, "-d", site / ".doctrees", pages, site],
        env={**os.environ, "VORTREE_DOXYGEN": str(xml)}, check=True)
    shutil.copy(site / "README.html", site / "index.html")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    try:
        main(Path(sys.argv[1]).absolute())
    except subprocess.CalledProcessError as failed:
        sys.exit(f"{failed.cmd[0]} failed: exit code {failed.returncode}")
