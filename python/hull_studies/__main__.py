# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 -m hull_studies STUDY.json --table TABLE.csv"""

from .command import main

if __name__ == "__main__":
    main()
