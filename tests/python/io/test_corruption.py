# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged FREE!ship files are refused in one sentence or read: no crash, no flood of memory."""

import json
import os
import subprocess
import sys
from pathlib import Path

import hull_io
import pytest

COPIES = 4 * int(os.environ.get("HULL_CORRUPTIONS", 24))  # these take less time than geometry
SECONDS = 2.0
MEMORY = 500 * 10**6
SEED = 20240311


@pytest.mark.skipif(sys.platform == "win32", reason="memory can't be limited here")
def test_damaged_copies_of_every_reference_file(freeship_files):
    worker = Path(__file__).with_name("corruption_worker.py")
    # Threads of the linear algebra library reserve address space that nothing uses.
    environment = {
        **os.environ,
        "PYTHONPATH": str(Path(hull_io.__file__).parents[1]),
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
    }
    print(f"seed {SEED}")
    refused = 0
    for number, path in enumerate(freeship_files):
        command = [sys.executable, str(worker), str(path)]
        command += [str(SEED + number), str(COPIES), str(MEMORY)]
        done = subprocess.run(command, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, f"{path.name}: {done.stderr}"
        result = json.loads(done.stdout)
        print(path.name, {key: result[key] for key in ("read", "refused", "longest", "memory")})
        assert result["failures"] == [], path.name
        assert result["read"] + result["refused"] == COPIES
        assert result["longest"] < SECONDS, path.name
        assert result["memory"] < MEMORY, path.name
        refused += result["refused"]
    assert refused > COPIES * len(freeship_files) / 4
