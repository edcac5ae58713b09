"""The site of pages and headers: it is made, asks no network, refuses links that lead nowhere.

    tests/docs/run.py [PROJECT]

Without Sphinx and doxygen there is nothing to make it by: exit code 77, a test that is skipped.
"""

import importlib.util
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

project = Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
project = project if project.is_dir() else project.parents[2]

broken = {
    "a page": "[a](nothing.md)",
    "a heading elsewhere": "[b](scenes.md#nothing-of-the-kind)",
    "a heading of its own": "[c](#nothing-of-the-kind)",
    "a source": "[d](../tests/nothing.cpp)",
    "a picture": "![e](../plots/gallery/nothing.png)",
}


def made(root, site):
    return subprocess.run([sys.executable, "-B", root / "src/docs/build.py", site],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def asks_for(site):
    """What a page makes a browser load from elsewhere; a link that a reader may follow is none."""
    loads = r'<(?:script|img|link|iframe)[^>]*?(?:src|href)="((?:https?:)?//[^"]*)"'
    styles = r"(?:url\(|@import)\s*['\"]?((?:https?:)?//[^)'\"]*)"
    for page in [*site.rglob("*.html"), *site.rglob("*.css")]:
        for found in re.findall(loads if page.suffix == ".html" else styles, page.read_text()):
            yield f"{page.relative_to(site)} loads {found}"


def check_site(site):
    told = made(project, site)
    assert told.returncode == 0, told.stdout
    assert not list(asks_for(site)), list(asks_for(site))
    for page in ("index.html", "cases/README.html", "headers/fmm_plan.html"):
        assert (site / page).is_file(), page
    plan = (site / "headers/fmm_plan.html").read_text()
    for promise in ("velocity_and_gradient", "u_i = sum_j gamma_j/(2 pi)", "Carrier, Greengard"):
        assert promise in plan, promise
    names = (site / "src/python/names.html").read_text()
    for name in ("Neighbors.query_ball_point", "Plan.velocity", "Simulation", "Run"):
        assert f'id="vortree.{name}"' in names, name
    index = (site / "searchindex.js").read_text()
    for word in ("quadtree", "joukowski"):
        assert word in index, word


def check_refusals(copy, site):
    for part in ("tree", "fmm", "src", "cases", "tests", "plots"):
        shutil.copytree(project / part, copy / part, ignore=shutil.ignore_patterns("__pycache__"))
    for file in project.iterdir():
        if file.is_file():
            shutil.copy(file, copy)
    with open(copy / "cases/theory.md", "a") as page:
        page.write("\n" + "\n\n".join(broken.values()) + "\n")
    (copy / "cases/left_out.md").write_text("# Left out\n")
    told = made(copy, site)
    assert told.returncode == 1, told.stdout
    for what, link in broken.items():
        target = re.search(r"\(([^)]*)\)", link)[1].rpartition("/")[2]
        assert target in told.stdout, f"{what}: not a word about {link}\n{told.stdout}"
    assert "left_out.md" in told.stdout, told.stdout


if __name__ == "__main__":
    missing = [name for name in ("sphinx", "myst_parser", "breathe", "furo")
               if not importlib.util.find_spec(name)] + ["doxygen"] * (not shutil.which("doxygen"))
    if missing:
        print(f"skipped: no {', '.join(missing)}; Debian: ./vortree docs installs what is needed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as scratch:
        check_site(Path(scratch) / "site")
        (Path(scratch) / "copy").mkdir()
        check_refusals(Path(scratch) / "copy", Path(scratch) / "refused")
    print("the site is whole")
