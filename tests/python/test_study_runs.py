# SPDX-License-Identifier: GPL-3.0-or-later
"""Studies carried out: the same table bit by bit, whatever the engine, the order, and however often
the run was killed on the way; nothing lost, nothing made twice."""

import importlib.util
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest
from coaster_study import described
from hull_studies import Dask, Processes, Serial, hull_set, run_study, study_from
from hull_studies.command import main
from hull_studies.evaluation import evaluate
from hull_studies.tables import csv_bytes, write_csv, write_parquet

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "coaster_study.py"
SEED, COUNT = 20261124, 60
WAIT = 120.0  # s: a machine that does much else

HAS_DASK = importlib.util.find_spec("distributed") is not None
needs_dask = pytest.mark.skipif(not HAS_DASK, reason="python3-distributed is not installed")
ENGINES = [
    pytest.param(Processes(2), id="processes"),
    pytest.param(Dask(workers=2), id="dask", marks=needs_dask),
]


@dataclass
class Counting:
    """Serial, in an order of its own, that counts the variants it makes."""

    step: int = 1
    made: list = field(default_factory=list)

    def finished(self, task, batches):
        for number in sorted(range(len(batches)), key=lambda k: (k * self.step) % len(batches)):
            self.made += batches[number]
            yield number, evaluate(task, batches[number])


@pytest.fixture(scope="module")
def study():
    return study_from(described(COUNT, SEED), ROOT / "samples")


@pytest.fixture(scope="module")
def hulls(study):
    return hull_set(study)


@pytest.fixture(scope="module")
def expected(study, hulls):
    return csv_bytes(run_study(study, engine=Serial(), hulls=hulls))


def journal_keys(path):
    """Of the whole rows, in their order."""
    *whole, _ = path.read_bytes().split(b"\n")
    return [json.loads(line)["key"] for line in whole[1:]]


@pytest.mark.parametrize("engine", ENGINES)
def test_engines_give_the_same_table(engine, study, hulls, expected, tmp_path):
    path = tmp_path / "study.jsonl"
    table = run_study(study, path, engine, hulls=hulls)
    assert csv_bytes(table) == expected
    assert len(journal_keys(path)) == len(set(journal_keys(path))) == COUNT
    assert table.counts()["made"] == COUNT


def test_the_order_in_which_rows_come_does_not_matter(study, hulls, expected):
    counting = Counting(step=3)
    assert csv_bytes(run_study(study, engine=counting, hulls=hulls)) == expected
    assert counting.made != study.variants and sorted(counting.made) == sorted(study.variants)


def test_equal_variants_are_made_once(hulls):
    rows = study_from(described(3, SEED), ROOT / "samples").variants
    description = described(1, 1)
    description["sampling"] = {"kind": "list", "rows": [rows[0], rows[1], rows[0], rows[0]]}
    counting = Counting()
    table = run_study(study_from(description, ROOT / "samples"), engine=counting, hulls=hulls)
    assert counting.made == [rows[0], rows[1]]
    assert table.rows[0] == table.rows[2] == table.rows[3] != table.rows[1]


def children(pid):
    """Processes below a process, by /proc."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                status = (entry / "stat").read_text().rpartition(")")[2].split()
            except OSError:
                continue
            if int(status[1]) == pid and status[0] != "Z":
                found += [int(entry.name), *children(int(entry.name))]
    return found


def is_running(pid):
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def wait_until(holds):
    end = time.monotonic() + WAIT
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.02)


def killed_in_the_middle(engine, path, rows):
    """Starts the script and kills it with SIGKILL when the journal has so many rows; all of its
    processes are gone then."""
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    words = ["--variants", COUNT, "--seed", SEED, "--engine", engine, "--workers", 2]
    words += ["--journal", path, "--table", path.with_suffix(".csv"), "--quiet"]
    run = subprocess.Popen([sys.executable, SCRIPT, *map(str, words)], env=environment)
    try:
        wait_until(lambda: run.poll() is not None or _has_rows(path, rows))
        assert run.poll() is None, "it ended before it could be killed"
        below = children(run.pid)
    finally:
        run.send_signal(signal.SIGKILL)
        run.wait()
    assert below
    wait_until(lambda: not any(map(is_running, below)))
    assert not path.with_suffix(".csv").exists()


def _has_rows(path, rows):
    return path.exists() and path.read_bytes().count(b"\n") > rows


@pytest.mark.parametrize("engine", ["processes", pytest.param("dask", marks=needs_dask)])
def test_killed_and_resumed_nothing_is_lost_or_made_twice(engine, study, hulls, expected, tmp_path):
    path = tmp_path / "study.jsonl"
    killed_in_the_middle(engine, path, 8)
    kept = journal_keys(path)
    assert 8 <= len(kept) < COUNT
    with open(path, "ab") as file:  # as if it had been killed while it wrote a row, too
        file.write(b'{"key":"0123')
    counting = Counting()
    table = run_study(study, path, counting, hulls=hulls)
    assert csv_bytes(table) == expected
    assert len(counting.made) == COUNT - len(kept)
    keys = journal_keys(path)
    assert keys[: len(kept)] == kept and len(keys) == len(set(keys)) == COUNT
    again = Counting()
    assert csv_bytes(run_study(study, path, again, hulls=hulls)) == expected
    assert again.made == []


def test_a_changed_study_beside_an_old_journal_is_refused(study, hulls, tmp_path):
    path = tmp_path / "study.jsonl"
    first = study_from(described(8, SEED), ROOT / "samples")
    run_study(first, path, Serial(), hulls=hulls)
    data = path.read_bytes()
    with pytest.raises(ValueError, match=r"rows are of another study \(sampling differ\)"):
        run_study(study, path, Serial(), hulls=hulls)
    assert path.read_bytes() == data


@pytest.mark.parametrize("engine", [Serial(), Processes(1)], ids=["serial", "processes"])
def test_other_hulls_have_rows_of_their_own(engine, hulls, tmp_path):
    few = study_from(described(2, SEED), ROOT / "samples")
    wider = replace(hulls, parents=hulls.parents * [1.0, 1.001, 1.0])
    first = csv_bytes(run_study(few, engine=engine, hulls=hulls))
    second = csv_bytes(run_study(few, engine=engine, hulls=wider))
    assert second != first
    assert csv_bytes(run_study(few, engine=engine, hulls=hulls)) == first
    path = tmp_path / "study.jsonl"
    run_study(few, path, engine, hulls=hulls)
    data = path.read_bytes()
    with pytest.raises(ValueError, match=r"rows are of another study \(arrays of hulls differ\)"):
        run_study(few, path, engine, hulls=wider)
    assert path.read_bytes() == data
    run_study(few, path, engine, hulls=replace(hulls))


def test_progress_is_told_and_ends_a_run(study, hulls, expected, tmp_path):
    path = tmp_path / "study.jsonl"
    told = []

    def stop(progress):
        told.append(progress)
        if progress.done >= 16:
            raise KeyboardInterrupt

    class Slow(Counting):
        def finished(self, task, batches):
            for found in super().finished(task, batches):
                time.sleep(0.6)
                yield found

    with pytest.raises(KeyboardInterrupt):
        run_study(study, path, Slow(), hulls=hulls, progress=stop)
    kept = len(journal_keys(path))
    assert 16 <= kept < COUNT and told[-1].done == kept and told[-1].per_second > 0.0
    table = run_study(study, path, Serial(), hulls=hulls, progress=told.append)
    assert csv_bytes(table) == expected
    assert (told[-1].done, told[-1].total, told[-1].resumed) == (COUNT, COUNT, kept)


def test_a_worker_that_ends_before_its_time_is_told(study, hulls, tmp_path):
    path = tmp_path / "study.jsonl"

    def kill_one(progress):
        if progress.done:
            workers = [pid for pid in children(os.getpid()) if b"spawn_main" in _command(pid)]
            os.kill(workers[0], signal.SIGKILL)

    with pytest.raises(RuntimeError, match="A worker ended before its time.*same journal"):
        long = study_from(described(2000, SEED), ROOT / "samples")
        run_study(long, path, Processes(2), hulls=hulls, progress=kill_one)
    assert len(journal_keys(path)) >= 8


@needs_dask
def test_a_cluster_elsewhere_whose_workers_have_threads(study, hulls, expected):
    import distributed

    with distributed.LocalCluster(
        n_workers=1, threads_per_worker=3, processes=True, dashboard_address=None
    ) as cluster:
        table = run_study(study, engine=Dask(cluster.scheduler_address), hulls=hulls)
    assert csv_bytes(table) == expected


@needs_dask
def test_a_worker_of_dask_that_ends_is_replaced(study, hulls, expected, tmp_path):
    killed = []

    def kill_one(progress):
        workers = [pid for pid in children(os.getpid()) if b"spawn_main" in _command(pid)]
        if progress.done >= 16 and not killed:
            killed.append(workers[0])
            os.kill(killed[0], signal.SIGKILL)

    class Told(Dask):
        def finished(self, task, batches):
            for number, rows in super().finished(task, batches):
                time.sleep(0.2)  # so that progress is told on the way
                yield number, rows

    table = run_study(
        study, tmp_path / "study.jsonl", Told(workers=2), hulls=hulls, progress=kill_one
    )
    assert killed and csv_bytes(table) == expected
    assert len(set(journal_keys(tmp_path / "study.jsonl"))) == COUNT


def _command(pid):
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return b""


def test_tables_are_written_whole(study, hulls, expected, tmp_path):
    table = run_study(study, engine=Serial(), hulls=hulls)
    write_csv(table, tmp_path / "study.csv")
    assert (tmp_path / "study.csv").read_bytes() == expected
    assert list(table.column("$volume")) == [values[3] for values in study.variants]
    with pytest.raises(ValueError, match="no numbers 'reason'"):
        table.column("reason")
    if importlib.util.find_spec("pandas") is None:
        with pytest.raises(ValueError, match="no pandas here"):
            write_parquet(table, tmp_path / "study.parquet")
    elif not any(map(importlib.util.find_spec, ("pyarrow", "fastparquet"))):
        with pytest.raises(ValueError, match="can't write Parquet: install pyarrow or fastparquet"):
            write_parquet(table, tmp_path / "study.parquet")
    assert list(tmp_path.iterdir()) == [tmp_path / "study.csv"]


def test_parquet_is_the_same_table(study, hulls, expected, tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    table = run_study(study, engine=Serial(), hulls=hulls)
    write_parquet(table, tmp_path / "study.parquet")
    frame = pandas.read_parquet(tmp_path / "study.parquet")
    assert list(frame.columns) == table.names
    assert frame["displaced_volume"].tolist() == table.column("displaced_volume").tolist()
    assert frame["status"].tolist() == [row.status for row in table.rows]


def test_a_study_in_a_file_is_run_from_the_command_line(tmp_path, capsys):
    description = described(6, SEED)
    description["hulls"][0] = str(ROOT / "samples" / "coaster.hull.json")
    path, table = tmp_path / "study.json", tmp_path / "table.csv"
    path.write_text(json.dumps(description))
    words = [path, "--engine", "serial", "--table", table, "--front", tmp_path / "front.svg"]
    main(list(map(str, words)))
    assert "6 made, 0 missed, 0 refused" in capsys.readouterr().err
    assert table.read_bytes().count(b"\n") == 7 and (tmp_path / "front.svg").stat().st_size > 1000
    path.write_text("{}")
    with pytest.raises(SystemExit):
        main(list(map(str, words)))
    assert "study.json: hulls: NoneType is no list" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words, said",
    [
        (["--table", "none/table.csv"], "none/table.csv: there is no folder"),
        (["--front", "none/front.svg"], "none/front.svg: there is no folder"),
        (["--parquet", "none/table.parquet"], "none/table.parquet: there is no folder"),
        (["--table", "."], "it is a folder; give a file name"),
        (["--front", "front.jpg"], "front.jpg: the name of a picture ends in .svg, .pdf or .png"),
        (["--front", "front.svg", "--x", "volume"], "The table has no numbers 'volume'"),
        (["--front", "front.svg", "--y", "reason"], "The table has no numbers 'reason'"),
    ],
)
def test_what_can_t_be_written_is_told_before_the_run(words, said, tmp_path, monkeypatch, capsys):
    description = described(6, SEED)
    description["hulls"][0] = str(ROOT / "samples" / "coaster.hull.json")
    (tmp_path / "study.json").write_text(json.dumps(description))
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit):
        main(["study.json", "--engine", "serial", "--table", "table.csv", *words, "--journal", "j"])
    told = capsys.readouterr().err
    assert said in told and "of 6 variants" not in told
    assert not (tmp_path / "j").exists() and not (tmp_path / "table.csv").exists()
