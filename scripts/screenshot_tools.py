# SPDX-License-Identifier: GPL-3.0-or-later
"""What the docs' pictures are made with: Blender's window as the tests drive it, its themes, chosen
panels in the sidebar, and parts of the window as PNG files."""

import struct
import zlib
from pathlib import Path

import bpy
import numpy as np
from enabled_addon import part

# In dots: what the frame of a region takes, and what is left around panels. Right of them are tabs.
_EDGE, _MARGIN = 4, 6
_PANELS_WIDTH = 0.85


def use_theme(name):
    """Blender's own "dark" or "light" one."""
    if name == "dark":
        bpy.ops.preferences.reset_default_theme()
        return
    for folder in bpy.utils.preset_paths("interface_theme"):
        for path in Path(folder).glob("*ight.xml"):
            bpy.ops.script.execute_preset(
                filepath=str(path), menu_idname="USERPREF_MT_interface_theme_presets"
            )


class Panels:
    """The panels of the sidebar's tab Hull, of which some may be left away."""

    def __init__(self):
        classes = part("panels")._CLASSES
        self._all = [cls for cls in classes if getattr(cls, "bl_category", "") == "Hull"]
        self._options = [getattr(cls, "bl_options", None) for cls in self._all]
        self._there = list(self._all)

    def show_only(self, names):
        """Leaves these alone, each of them open, in a sidebar that is drawn for the first time."""
        wanted = [cls for cls in self._all if cls.__name__ in names]
        missing = set(names) - {cls.__name__ for cls in wanted}
        if missing:
            raise ValueError(f"there are no panels {', '.join(sorted(missing))}")
        self._replace([(cls, set()) for cls in wanted])

    def restore(self):
        self._replace(list(zip(self._all, self._options)))

    def _replace(self, wanted):
        for cls in reversed(self._there):
            bpy.utils.unregister_class(cls)
        self._there = [cls for cls, _ in wanted]
        for cls, options in wanted:
            cls.bl_options = options or set()
            bpy.utils.register_class(cls)


def save_window(window, path, box=None, is_trimmed=False):
    """Writes the window, or the box (x, y, width, height) of it, as PNG.

    is_trimmed: without what is of one colour at the bottom.
    """
    path = str(path)
    window.screenshot(path)
    pixels = _pixels_of(path)
    if box is not None:
        x, y, width, height = box
        pixels = pixels[y : y + height, x : x + width]
    if is_trimmed:
        pixels = _trimmed(pixels)
    _write(pixels, path)


def save_smaller(path, times):
    """Writes a PNG file anew, each dot the mean of so many squared."""
    pixels = _pixels_of(path)
    height, width = (size // times for size in pixels.shape[:2])
    parts = pixels[: height * times, : width * times].reshape(height, times, width, times, 4)
    _write(parts.mean(axis=(1, 3)), path)


def _pixels_of(path):
    """(height, width, 4) from the bottom up."""
    image = bpy.data.images.load(path)
    width, height = image.size
    pixels = np.empty(width * height * 4, dtype=np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)


def _trimmed(pixels):
    """Without the rows at the bottom that are all of one colour, but for a margin."""
    body = pixels[_EDGE:, _EDGE : int(_PANELS_WIDTH * pixels.shape[1])]
    differs = np.abs(body - body[:1, :1]).max(axis=(1, 2)) > 0.02
    first = int(np.argmax(differs)) if differs.any() else 0
    return pixels[max(0, first + _EDGE - _MARGIN) :]


def _write(pixels, path):
    """Writes pixels (height, width, 4) from the bottom up as a small PNG file without transparency.

    A row is kept as its difference from the pixels to the left or above, whichever is smaller.
    """
    rows = np.round(255.0 * pixels[::-1, :, :3]).astype(np.uint8)
    height, width, _ = rows.shape
    left, above = rows.copy(), rows.copy()
    left[:, 1:] -= rows[:, :-1]
    above[1:] -= rows[:-1]
    filtered = np.stack([left.reshape(height, -1), above.reshape(height, -1)])
    sizes = np.abs(filtered.view(np.int8).astype(np.int32)).sum(axis=2)
    chosen = sizes.argmin(axis=0)
    best = filtered[chosen, np.arange(height)]
    # PNG's numbers of these two filters are 1 and 2.
    lines = np.concatenate([(chosen + 1).astype(np.uint8)[:, None], best], axis=1)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in (
            (b"IHDR", header),
            (b"IDAT", zlib.compress(lines.tobytes(), 9)),
            (b"IEND", b""),
        ):
            check = zlib.crc32(kind + data)
            file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check))
