"""Settings of Sphinx: the pages of this project, and the headers that a user includes.

Called by build.py of this folder, which says where doxygen has left its XML.
"""

import os
import re
import sys
from pathlib import Path

here = Path(__file__).resolve().parent
sys.path.insert(0, str(here.parent / "python"))

project = "vortree"
author = copyright = "the authors of vortree"
root_doc = "README"
extensions = ["myst_parser", "breathe", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4
highlight_language = "none"
smartquotes = False

breathe_projects = {"vortree": os.environ.get("VORTREE_DOXYGEN", "")}
breathe_default_project = "vortree"
breathe_show_include = False

# Docstrings alone are read: neither what is compiled nor numpy has to be there.
autodoc_mock_imports = ["numpy", "vortree._core", "vortree._flow"]
autodoc_member_order = "bysource"
autodoc_typehints = "none"
napoleon_use_rtype = False

html_theme = "furo"
html_title = "vortree"
html_show_sphinx = html_show_copyright = html_copy_source = False
html_static_path = [str(here / "static")]
html_css_files = ["wide.css"]


def escape(app, what, name, thing, options, lines):
    """Bars and stars of a docstring are mathematics, but in formulas set apart and in examples."""
    formula = None  # how far the line before one is indented
    for at, line in enumerate(lines):
        indent = len(line) - len(line.lstrip())
        if formula is not None and line.strip() and indent <= formula:
            formula = None
        if formula is None and not line.lstrip().startswith((">>>", "...")):
            lines[at] = re.sub(r"([|*])", r"\\\1", line)
        if line.endswith("::"):
            formula = indent


def setup(app):
    """The first page carries the list of all others, which is none of its text."""
    contents = (here / "contents").read_text()

    def append(app, name, source):
        if name == root_doc:
            source[0] += "\n\n" + contents

    app.connect("source-read", append)
    app.connect("autodoc-process-docstring", escape, priority=400)  # before napoleon reads them
