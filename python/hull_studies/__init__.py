# SPDX-License-Identifier: GPL-3.0-or-later
"""Design studies: thousands of variants of a hull by one description, in a table. docs/studies.md.

  study           what is varied, and how, as plain data: Study, study_from
  changes         the changes that make a variant, as the description has them, checked
  fields          shape fields among these
  sampling        which values the variables take
  hull_set        the hulls of a study, of one topology, as arrays
  making          a variant's form, change by change
  evaluation      one variant's row: evaluate, a function of plain data
  parent_death    a process that ends with the one that started it
  engines         the variants spread over processes or a Dask cluster
  journal         rows kept as they come, that survive whatever ends the run
  runs            a study carried out, or on: run_study
  tables          rows as CSV and Parquet
  fronts          the variants that none surpasses in two numbers, drawn
  command         all of it from a command line
"""

from .engines import Dask, Processes, Serial
from .fronts import front_plot, pareto_front
from .hull_set import hull_set
from .runs import run_study
from .study import Study, read_study, study_from
from .tables import Table, write_csv, write_parquet

__all__ = [
    "Dask",
    "Processes",
    "Serial",
    "Study",
    "Table",
    "front_plot",
    "hull_set",
    "pareto_front",
    "read_study",
    "run_study",
    "study_from",
    "write_csv",
    "write_parquet",
]
