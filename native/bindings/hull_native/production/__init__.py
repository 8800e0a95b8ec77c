# SPDX-License-Identifier: GPL-3.0-or-later
"""What is built of a hull: seams and butts of its shell by rules of strakes, lists and drawings of
plates, templates, frames and developable shells; the closed hull in named parts."""
