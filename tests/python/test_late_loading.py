# SPDX-License-Identifier: GPL-3.0-or-later
"""Late modules run at their first use: once, whoever uses them, and whatever they use."""

import importlib.util
import sys
import threading
from pathlib import Path

import pytest

FILE = Path(__file__).resolve().parents[2] / "addon" / "hull_tools" / "late_loading.py"
SLOW = "import time\nfrom . import other\ntime.sleep(0.2)\nVALUE = other.ONE + 1\n"
OTHER = "from . import slow\nONE = 1\n\n\ndef of_slow():\n    return slow.VALUE\n"


@pytest.fixture
def package(tmp_path, monkeypatch):
    """The name of a late package of slow, other and broken."""
    spec = importlib.util.spec_from_file_location("late_loading", FILE)
    late_loading = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(late_loading)
    folder = tmp_path / "late_parts"
    folder.mkdir()
    files = {"__init__": '"""Parts."""\nNAME = "parts"\n', "slow": SLOW, "other": OTHER}
    for name, text in {**files, "broken": "raise OSError('broken')\n"}.items():
        (folder / f"{name}.py").write_text(text)
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.setattr(sys, "meta_path", list(sys.meta_path))
    late_loading.install("late_parts")
    yield "late_parts"
    for name in [one for one in sys.modules if one.split(".")[0] == "late_parts"]:
        del sys.modules[name]


def test_modules_run_at_their_first_use(package):
    from late_parts import other, slow

    assert "VALUE" not in vars(slow) and "ONE" not in vars(other)
    assert other.ONE == 1
    assert "VALUE" not in vars(slow)  # other only holds it
    assert other.of_slow() == slow.VALUE == 2


def test_names_of_a_package_and_its_modules(package):
    from late_parts import NAME, slow

    assert NAME == "parts"
    assert slow.VALUE == 2
    with pytest.raises(AttributeError, match="nothing"):
        slow.nothing


def test_threads_wait_for_one_that_runs_a_module(package):
    from late_parts import other, slow

    found = []
    threads = [
        threading.Thread(target=lambda use=use: found.append(use()))
        for use in 4 * (lambda: slow.VALUE, lambda: other.of_slow())
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(10.0)
    assert found == [2] * 8


def test_what_fails_fails_again(package):
    from late_parts import broken

    for _ in range(2):
        with pytest.raises(OSError, match="broken"):
            broken.VALUE
