# SPDX-License-Identifier: GPL-3.0-or-later
"""Hulls that exist, as mesh objects or files, made control meshes.

  sources  what a hull is made of, and how it is understood before anything is made
  making   the task that makes the hull, and its report
"""
