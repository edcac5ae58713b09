"""Settings of Sphinx: the pages of this project, and the headers that a user includes.

Called by build.py of this folder, which says where doxygen has left its XML.
"""

import os
from pathlib import Path

here = Path(__file__).resolve().parent

project = "vortree"
author = copyright = "the authors of vortree"
root_doc = "README"
extensions = ["myst_parser", "breathe"]
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4
highlight_language = "none"
smartquotes = False

breathe_projects = {"vortree": os.environ.get("VORTREE_DOXYGEN", "")}
breathe_default_project = "vortree"
breathe_show_include = False
primary_domain = "cpp"

html_theme = "furo"
html_title = "vortree"
html_show_sphinx = html_show_copyright = html_copy_source = False
html_static_path = [str(here / "static")]
html_css_files = ["wide.css"]


def setup(app):
    """The first page carries the list of all others, which is none of its text."""
    contents = (here / "contents").read_text()

    def append(app, name, source):
        if name == root_doc:
            source[0] += "\n\n" + contents

    app.connect("source-read", append)
