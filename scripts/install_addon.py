# SPDX-License-Identifier: GPL-3.0-or-later
"""Install and enable the packaged add-on in the profile of the Blender that runs this.

blender --background --factory-startup --python-exit-code 1 --python install_addon.py -- FILE.zip

Blender 4.2 and later install it as the extension bl_ext.user_default.hull_tools, older ones as the
add-on hull_tools.
"""

import sys
from pathlib import Path

import bpy


def install_extension(package):
    bpy.ops.extensions.package_install_files(
        filepath=str(package), repo="user_default", enable_on_install=True, overwrite=True
    )
    return "bl_ext.user_default.hull_tools"


def install_legacy(package):
    bpy.ops.preferences.addon_install(filepath=str(package), overwrite=True)
    bpy.ops.preferences.addon_enable(module="hull_tools")
    return "hull_tools"


def main():
    package = Path(sys.argv[sys.argv.index("--") + 1])
    install = install_extension if bpy.app.version >= (4, 2, 0) else install_legacy
    module = install(package)
    if module not in bpy.context.preferences.addons or module not in sys.modules:
        raise RuntimeError(f"Blender did not enable {module} of {package}")
    bpy.ops.wm.save_userpref()
    print(f"installed and enabled {module} in Blender {bpy.app.version_string}")


main()
