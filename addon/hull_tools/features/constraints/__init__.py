# SPDX-License-Identifier: GPL-3.0-or-later
"""What holds while points are moved: flats, the centre plane, locked and kept points."""
