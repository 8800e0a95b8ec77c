# SPDX-License-Identifier: GPL-3.0-or-later
"""What the process that reads STEP and IGES files is refused for, it tells in a sentence."""

import numpy as np
import pytest
from hull_native import cad_process


def nothing(path, **_):
    return {"curves": [], "faces": [], "points": np.zeros((0, 3))}


def without_memory(path, **_):
    raise MemoryError


@pytest.mark.parametrize(
    "read, folder, told",
    [
        (without_memory, ".", "there is not enough memory"),
        (nothing, "missing", "No such file or directory"),
    ],
)
def test_what_ends_it_is_told_in_a_sentence(read, folder, told, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(cad_process, "read_cad_geometry", read, raising=False)
    monkeypatch.setattr(cad_process, "np", np, raising=False)
    with pytest.raises(SystemExit) as ended:
        cad_process.main("hull.step", str(tmp_path / folder / "found.npz"), "0.001")
    assert ended.value.code == cad_process.REFUSED
    assert told in capsys.readouterr().err
