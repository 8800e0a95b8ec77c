# SPDX-License-Identifier: GPL-3.0-or-later
"""A study from a command line: how it is carried out, and what is written of it."""

import argparse
import sys
import time
from pathlib import Path

import hull_native as hn
from hull_io.bytes_on_disk import target_of

from .engines import Dask, Processes, Serial
from .evaluation import task_of
from .fronts import SENSES, front_plot
from .hull_set import hull_set
from .runs import run_study
from .study import read_study
from .tables import Table, write_csv, write_parquet

_PICTURES = (".svg", ".pdf", ".png")
ENGINES = ("processes", "dask", "serial")


def add_arguments(parser):
    """What every study's command takes."""
    parser.add_argument("--engine", choices=ENGINES, default="processes")
    parser.add_argument("--workers", type=int, default=0, help="of all processors where not said")
    parser.add_argument("--address", default="", help="of a Dask cluster, such as tcp://host:8786")
    parser.add_argument(
        "--journal", type=Path, help="keeps rows as they come; what is in it is not made again"
    )
    parser.add_argument("--table", type=Path, required=True, help="written as CSV")
    parser.add_argument("--parquet", type=Path, help="the table, where pandas writes it")
    parser.add_argument("--front", type=Path, help="a picture: .svg, .pdf or .png")
    parser.add_argument("--x", default="displaced_volume", help="a column of the table")
    parser.add_argument("--y", default="wetted_surface")
    parser.add_argument("--best", nargs=2, choices=SENSES, default=("most", "least"))
    parser.add_argument("--quiet", action="store_true")


def engine_of(arguments):
    if arguments.engine == "serial":
        return Serial()
    if arguments.engine == "dask":
        return Dask(arguments.address, arguments.workers)
    return Processes(arguments.workers)


def carry_out(study, arguments, **plot):
    """Runs a Study as the arguments say, and writes what they name. plot: for front_plot."""
    begun = time.monotonic()
    _check_files(arguments)
    hulls = hull_set(study)
    if arguments.front:
        empty = Table(study, task_of(study, hulls).columns, [])
        for name in (arguments.x, arguments.y):
            empty.column(name)
    tell = None if arguments.quiet else _tell
    table = run_study(study, arguments.journal, engine_of(arguments), hulls=hulls, progress=tell)
    write_csv(table, arguments.table)
    if arguments.front:
        names = (arguments.x, arguments.y)
        picture, _ = front_plot(table, *names, tuple(arguments.best), **plot)
        hn.write_plot(picture, arguments.front)
    if arguments.parquet:
        write_parquet(table, arguments.parquet)
    if not arguments.quiet:
        told = ", ".join(f"{count} {status}" for status, count in table.counts().items())
        print(f"\n{told}; {time.monotonic() - begun:.1f} s in all", file=sys.stderr)
    return table


def _check_files(arguments):
    """What can be told of files before the study is run, whose rows would be lost else."""
    for path in filter(None, (arguments.table, arguments.parquet, arguments.front)):
        folder = target_of(path).parent
        if not folder.is_dir():
            raise ValueError(f"{path}: there is no folder {folder}; make it first.")
    if arguments.front and arguments.front.suffix.lower() not in _PICTURES:
        raise ValueError(f"{arguments.front}: the name of a picture ends in .svg, .pdf or .png.")


def _tell(progress):
    seconds = f", {progress.per_second:.1f} a second" if progress.per_second else ""
    resumed = f", {progress.resumed} from the journal" if progress.resumed else ""
    text = f"{progress.done} of {progress.total} variants{resumed}{seconds}"
    print(f"\r{text:<70}", end="", file=sys.stderr, flush=True)


def main(words=None):
    """Of `python3 -m hull_studies STUDY.json`."""
    parser = argparse.ArgumentParser(prog="hull_studies", description="Carries out a study.")
    parser.add_argument("study", type=Path, help="a JSON file: see docs/studies.md")
    add_arguments(parser)
    arguments = parser.parse_args(words)
    try:
        carry_out(read_study(arguments.study), arguments)
    except (ValueError, OSError, RuntimeError) as error:
        parser.exit(1, f"\n{error}\n")
    except KeyboardInterrupt:
        parser.exit(130, "\nStopped. What is done is in the journal.\n")
