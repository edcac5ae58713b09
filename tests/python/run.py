"""The Python package against what it promises: all of tests/python by pytest, in one process.

    PYTHONPATH=build/python VORTREE_PROGRAM=build/bin/vortree tests/python/run.py [words for pytest]

Without numpy, scipy, h5py or pytest there is nothing to run it by: exit code 77, a test that is
skipped.
"""

import sys
from pathlib import Path

try:
    import h5py, numpy, pytest, scipy  # noqa: E401, F401
except ImportError as missing:
    print(f"skipped: {missing}; Debian: ./vortree python installs what is needed")
    sys.exit(77)

if __name__ == "__main__":
    here = str(Path(__file__).resolve().parent)
    sys.exit(pytest.main(["-q", "-p", "no:cacheprovider", "-W", "error", *sys.argv[1:], here]))
