# SPDX-License-Identifier: GPL-3.0-or-later
"""Several files written, or none: what stands where they are to be, their modes, and that they are
on the disk before the first gets its name."""

import os
import stat
from pathlib import Path

import hull_native as hn
import pytest

ROOT = Path(__file__).resolve().parents[2]


def write(targets):
    with hn.FolderBeside(targets) as folder:
        made = [folder / f"made-{k}" for k in range(len(targets))]
        for k, one in enumerate(made):
            one.write_text(f"new {k}")
        folder.hand_over(made)


def test_files_get_their_names(tmp_path):
    targets = [tmp_path / "a", tmp_path / "b"]
    targets[1].write_text("before")
    os.chmod(targets[1], 0o640)
    write(targets)
    assert [one.read_text() for one in targets] == ["new 0", "new 1"]
    assert stat.S_IMODE(targets[1].stat().st_mode) == 0o640
    assert sorted(os.listdir(tmp_path)) == ["a", "b"]


def test_what_is_not_handed_over_is_gone(tmp_path):
    (tmp_path / "a").write_text("before")
    with pytest.raises(KeyError), hn.FolderBeside([tmp_path / "a"]) as folder:
        (folder / "a").write_text("half")
        raise KeyError
    assert os.listdir(tmp_path) == ["a"] and (tmp_path / "a").read_text() == "before"


def test_links_stay_links(tmp_path):
    """Also into another folder, which may be on another disk: the file is brought there first."""
    far = tmp_path / "far"
    far.mkdir()
    (far / "file").write_text("before")
    (tmp_path / "link").symlink_to("far/file")
    write([tmp_path / "a", tmp_path / "link"])
    assert (tmp_path / "link").is_symlink() and (far / "file").read_text() == "new 1"
    assert sorted(os.listdir(tmp_path)) == ["a", "far", "link"] and os.listdir(far) == ["file"]


@pytest.mark.skipif(not os.path.isdir("/dev/shm"), reason="there is no other disk")
def test_links_to_another_disk(tmp_path):
    other = Path("/dev/shm") / f"hull-{os.getpid()}"
    (tmp_path / "link").symlink_to(other)
    try:
        write([tmp_path / "a", tmp_path / "link"])
        assert other.read_text() == "new 1"
    finally:
        other.unlink(missing_ok=True)


def test_what_is_no_file_is_refused(tmp_path):
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    before = sorted(os.listdir(tmp_path))
    for name, words in (
        ("folder", "it is a folder; give a file name"),
        ("pipe", "device or pipe and no file"),
        ("two\nlines", "line breaks or control characters; give it another"),
        ("a" * 300, "too long; shorten it"),
        ("none/a", "Nothing can be written to the folder"),
    ):
        with pytest.raises(OSError, match=words):
            write([tmp_path / name, tmp_path / "good"])
    assert sorted(os.listdir(tmp_path)) == before


def test_the_same_file_twice_or_none_is_refused(tmp_path):
    (tmp_path / "a").write_text("before")
    (tmp_path / "link").symlink_to("a")
    for names in (("a", "a"), ("a", "b", "link")):
        with pytest.raises(OSError, match="it is given twice; give another name"):
            write([tmp_path / name for name in names])
    with pytest.raises(ValueError, match="no file to be written"):
        write([])
    assert sorted(os.listdir(tmp_path)) == ["a", "link"]
    assert (tmp_path / "a").read_text() == "before"


def test_all_are_on_the_disk_before_the_first_has_its_name(tmp_path, monkeypatch):
    told = []
    fsync, replace = os.fsync, os.replace
    monkeypatch.setattr(os, "fsync", lambda handle: (told.append("disk"), fsync(handle)))
    monkeypatch.setattr(os, "replace", lambda *pair: (told.append("name"), replace(*pair)))
    write([tmp_path / "a", tmp_path / "b"])
    assert told == ["disk", "disk", "name", "name"]


def test_nothing_else_makes_folders_for_it():
    """Two places put files beside their names: bytes for plain Python, and this for what writes
    itself."""
    homes = {
        path.relative_to(ROOT).as_posix()
        for folder in ("addon", "python", "native/bindings/hull_native")
        for path in (ROOT / folder).rglob("*.py")
        if "os.replace(" in path.read_text(encoding="utf-8")
    }
    assert homes == {
        "native/bindings/hull_native/folder_beside.py",
        "python/hull_io/bytes_on_disk.py",
    }
