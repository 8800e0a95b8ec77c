# SPDX-License-Identifier: GPL-3.0-or-later
"""Names that no file can have, folders that can't be written to and folders in the file's place are
told in a sentence by every function that writes, and nothing is left."""

import re

import all_writers
import pytest
from all_writers import CASES, CUBE, WRITERS

cases = pytest.mark.parametrize("name, ending", CASES)


def refused(name, path):
    with pytest.raises((ValueError, OSError)) as told:
        WRITERS[name].write(path, CUBE)
    text = str(told.value)
    assert "Errno" not in text and not re.search(r"/\.hull-|\.part", text), text
    return text


def test_all_that_write_are_tried():
    assert all_writers.writers_there_are() == {name.split(",")[0] for name in WRITERS}


@cases
def test_names_that_no_file_can_have(name, ending, tmp_path):
    assert "the name is too long; shorten it" in refused(name, tmp_path / ("n" * 300 + ending))
    assert "line breaks" in refused(name, tmp_path / f"two\nlines{ending}")
    if WRITERS[name].part:  # the path's own name is not too long
        longest = "n" * (255 - len(ending))
        assert "too long" in refused(name, tmp_path / f"{longest}{ending}")
    assert not list(tmp_path.iterdir())


@cases
def test_the_longest_name(name, ending, tmp_path):
    stem = "n" * (255 - len(all_writers.made_first(name, "", ending)))
    WRITERS[name].write(tmp_path / f"{stem}{ending}", CUBE)
    made = {found.name for found in tmp_path.iterdir()}
    assert all_writers.made_first(name, stem, ending) in made


@cases
def test_a_folder_has_the_name(name, ending, tmp_path):
    taken = tmp_path / all_writers.made_first(name, "taken", ending)
    taken.mkdir()
    assert "it is a folder; give a file name" in refused(name, tmp_path / f"taken{ending}")
    assert list(tmp_path.iterdir()) == [taken] and not list(taken.iterdir())


@cases
def test_a_folder_that_is_read_only(name, ending, tmp_path, monkeypatch):
    """Parts of a drawing may be made among the temporary files, where all may write."""
    monkeypatch.setenv("TMPDIR", "/tmp")
    WRITERS[name].write(tmp_path / f"before{ending}", CUBE)  # what is imported late is
    folder = tmp_path / "kept"
    folder.mkdir()
    with all_writers.as_nobody(folder):
        text = refused(name, all_writers.Path(f"file{ending}"))
    assert re.search("your rights to it|you may write to", text)
    assert not list(folder.iterdir())
