# SPDX-License-Identifier: GPL-3.0-or-later
"""The mark one_in."""

from one_in import pytest_collection_modifyitems  # noqa: F401: a hook
