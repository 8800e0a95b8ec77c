# SPDX-License-Identifier: GPL-3.0-or-later
"""A process that ends with the one that started it, however that ended."""

import multiprocessing
import os
import threading
from multiprocessing.connection import wait


def end_with_parent():
    """To be called in a process of multiprocessing: as soon as its parent is gone it ends, whatever
    it does. Workers of a pool else wait for work for ever when their parent was killed."""
    parent = multiprocessing.parent_process()
    if parent is None:
        return

    def watch():
        wait([parent.sentinel])
        os._exit(1)

    threading.Thread(target=watch, daemon=True).start()
