# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands where a file is to be written: links are followed, devices and pipes left alone, full
disks and folders that can't be written to told with what to do."""

import os
import resource
import signal
import stat
import subprocess
import sys

import hull_io
import hull_native as hn
import numpy as np
import pytest
from hull_io.bytes_on_disk import write_bytes, write_files

TRIANGLE = np.eye(3), np.array([[0, 1, 2]])


def write_stl(path):
    hull_io.write_stl(path, *TRIANGLE)


def write_dxf(path):
    hn.write_curves_dxf([("LINES", [0, 0, 0, 0, 1, 1, 1, 1], np.eye(4, 3))], str(path))


writers = pytest.mark.parametrize("write", [write_stl, write_dxf])


@writers
def test_pipes_are_left_alone(tmp_path, write):
    pipe, link = tmp_path / "pipe", tmp_path / "link"
    os.mkfifo(pipe)
    link.symlink_to("pipe")
    for path in (pipe, link):
        with pytest.raises((ValueError, OSError), match="device or pipe and no file; give another"):
            write(path)
    assert stat.S_ISFIFO(pipe.stat().st_mode) and link.is_symlink()
    assert sorted(os.listdir(tmp_path)) == ["link", "pipe"]


@pytest.mark.skipif(os.geteuid() != 0, reason="only root makes devices")
@writers
def test_devices_are_left_alone(tmp_path, write):
    """A node of its own, of the device that takes all and keeps nothing."""
    node = tmp_path / "null"
    try:
        os.mknod(node, stat.S_IFCHR | 0o600, os.makedev(1, 3))
    except PermissionError:
        pytest.skip("no devices can be made here")
    with pytest.raises((ValueError, OSError), match="device or pipe and no file"):
        write(node)
    assert stat.S_ISCHR(node.stat().st_mode)


@writers
def test_links_stay_links(tmp_path, write):
    (tmp_path / "far").mkdir()
    kept = tmp_path / "far" / "kept"
    kept.write_text("old")
    for name, target in (("link", "far/kept"), ("new", "second"), ("second", "far/new")):
        (tmp_path / name).symlink_to(target)
    for name, target in (("link", "kept"), ("new", "new")):
        write(tmp_path / name)
        assert (tmp_path / name).is_symlink()
        assert (tmp_path / "far" / target).stat().st_size > 80
    assert (tmp_path / "second").is_symlink()
    assert sorted(os.listdir(tmp_path / "far")) == ["kept", "new"]


@writers
def test_links_that_lead_nowhere(tmp_path, write):
    (tmp_path / "ring").symlink_to("ring")
    (tmp_path / "lost").symlink_to("no/folder")
    for name in ("ring", "lost"):
        with pytest.raises((ValueError, OSError), match=name):
            write(tmp_path / name)
        assert (tmp_path / name).is_symlink()


def test_a_folder_is_no_file(tmp_path):
    (tmp_path / "taken").mkdir()
    with pytest.raises(hull_io.HullFileError, match="taken: it is a folder; give a file name"):
        write_stl(tmp_path / "taken")
    # Of several files none is written.
    with pytest.raises(hull_io.HullFileError, match="taken"):
        write_files({tmp_path / "first": b"1", tmp_path / "taken": b"2"})
    assert os.listdir(tmp_path) == ["taken"]


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write to any folder")
@writers
def test_a_folder_that_is_read_only(tmp_path, write):
    folder = tmp_path / "kept"
    folder.mkdir(mode=0o500)
    with pytest.raises((ValueError, OSError), match="your rights|may write to"):
        write(folder / "file")


AS_NOBODY = """
import os, sys
from pathlib import Path
import hull_native as hn, numpy as np
from hull_io.bytes_on_disk import write_bytes
curves = [("LINES", [0, 0, 0, 0, 1, 1, 1, 1], np.eye(4, 3))]
writers = (lambda p: write_bytes(p, b"x"), lambda p: hn.write_curves_dxf(curves, str(p)))
for write in writers:  # nobody may not be let in to what is imported by the first call
    write(Path("before"))
os.chdir(sys.argv[1])
os.setuid(65534)
for write in writers:
    try:
        write(Path("file"))
        print("written")
    except (ValueError, OSError) as error:
        print(error)
"""


def test_a_read_only_folder_as_another_user(tmp_path):
    """Root writes anywhere: as nobody, by a process of its own, from a place that may be root's
    alone (so may be that of temporary files: DXF begins in one)."""
    if os.geteuid() != 0:
        pytest.skip("the test above does it")
    folder = tmp_path / "kept"
    folder.mkdir(mode=0o500)
    told = subprocess.run(
        [sys.executable, "-c", AS_NOBODY, folder],
        cwd=tmp_path,
        env={
            **os.environ,
            "PYTHONPATH": os.pathsep.join(map(os.path.abspath, sys.path)),
            "TMPDIR": "/tmp",
        },
        capture_output=True,
        text=True,
        check=True,
    ).stdout.splitlines()
    assert len(told) == 2, told
    assert "your rights to it" in told[0]
    assert "choose a folder that you may write to" in told[1]
    assert os.listdir(folder) == []


FULL = """
import resource, signal, sys
import hull_native as hn, numpy as np
curves = [("LINES", [0, 0, 0, 0, 1, 1, 1, 1], np.eye(4, 3) + k) for k in range(200)]
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
try:
    hn.write_curves_dxf(curves, sys.argv[1])
except OSError as error:
    print(error)
"""


def test_a_full_disk_has_its_reason_and_remedy(tmp_path):
    """A limit on the size of files stands for it."""
    (tmp_path / "kept.dxf").write_text("old")
    told = subprocess.run(
        [sys.executable, "-c", FULL, tmp_path / "kept.dxf"],
        capture_output=True, text=True, check=True, env={**os.environ, "TMPDIR": str(tmp_path)},
    ).stdout  # fmt: skip
    assert f'Cannot write "{tmp_path / "kept.dxf"}": the folder of temporary files' in told
    assert f"{tmp_path}, takes no more; free some space there, or set TMPDIR to another" in told
    assert os.listdir(tmp_path) == ["kept.dxf"]
    assert (tmp_path / "kept.dxf").read_text() == "old"


def test_a_full_disk_for_python_s_writers(tmp_path):
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, limits[1]))
    try:
        with pytest.raises(hull_io.HullFileError, match="free space"):
            write_bytes(tmp_path / "file", b"x" * 10000)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, handler)
    assert os.listdir(tmp_path) == []
