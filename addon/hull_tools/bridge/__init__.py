# SPDX-License-Identifier: GPL-3.0-or-later
"""Between Blender's data and the native module's arrays: the only code that knows both.

Everything here can be called from a script as well as from an operator. What a user can get wrong
raises ValueError with a message to show.
"""
