# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance and propulsion by Holtrop and Mennen, by Savitsky, by the Delft series and by Michell,
over speeds as tables and diagrams; the water, and the waves behind."""
