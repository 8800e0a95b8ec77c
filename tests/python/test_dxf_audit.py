# SPDX-License-Identifier: GPL-3.0-or-later
"""Every function that writes DXF writes files in which ezdxf's audit finds nothing; and it would
find it."""

import all_writers
import pytest
from all_writers import CASES, CUBE, WRITERS
from dxf_audit import assert_audited


@pytest.mark.parametrize("name", [name for name, ending in CASES if ending == ".dxf"])
def test_all_writers_of_dxf(name, tmp_path):
    pytest.importorskip("ezdxf")
    WRITERS[name].write(tmp_path / "file.dxf", CUBE)
    document = assert_audited(tmp_path / all_writers.made_first(name, "file", ".dxf"))
    assert len(document.modelspace())


def test_what_is_wrong_is_found(tmp_path):
    """A layer whose name can be none."""
    pytest.importorskip("ezdxf")
    path = tmp_path / "file.dxf"
    WRITERS["hull_native.ShopDrawing.write"].write(path, CUBE)
    path.write_text(path.read_text().replace("OUTLINE", "OUT*LINE"))
    with pytest.raises(AssertionError):
        assert_audited(path)
