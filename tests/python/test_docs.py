import doctest
import inspect
from pathlib import Path

import pytest
import vortree
from vortree import _arrays, _core, _flow, _neighbors, _plan, _quadtree, _runs, _simulation

FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("module", [_arrays, _neighbors, _plan, _quadtree, _runs, _simulation])
def test_examples_of_docstrings_run(module):
    found = doctest.testmod(module, optionflags=FLAGS)
    assert found.attempted > 0 and found.failed == 0


@pytest.mark.parametrize("page", ["README.md", "src/python/README.md"])
def test_examples_of_the_pages_run(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = doctest.testfile(str(ROOT / page), module_relative=False, optionflags=FLAGS)
    assert found.attempted > 2 and found.failed == 0


def test_what_is_public_has_a_docstring():
    for name in vortree.__all__:
        thing = getattr(vortree, name)
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing):
            for method, part in vars(thing).items():
                if not method.startswith("_"):
                    assert inspect.getdoc(part) or method == "rule", f"{name}.{method}"


def public(kind):
    return {part for part in vars(kind) if not part.startswith("_")}


@pytest.mark.parametrize("module", [_core, _flow])
def test_the_stub_names_what_the_compiled_module_has(module):
    name = module.__name__.rsplit(".", 1)[1] + ".pyi"
    stub = {}
    exec(compile((Path(vortree.__file__).parent / name).read_text(), name, "exec"), stub)
    classes = [thing for thing in vars(module) if inspect.isclass(getattr(module, thing))]
    assert classes
    for kind in classes:
        assert public(stub[kind]) == public(getattr(module, kind))
