# SPDX-License-Identifier: GPL-3.0-or-later
"""What is saved with the file."""

from .hull_settings import register, unregister

__all__ = ["register", "unregister"]
