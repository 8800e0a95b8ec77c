# SPDX-License-Identifier: GPL-3.0-or-later
"""The renderers, set so that the picture is clean and does not take long."""

from ...bridge.blender import blender_versions
from . import scene_settings

WIDTH, HEIGHT = 1600, 900

_CYCLES = {
    "cycles.samples": 96,
    "cycles.use_adaptive_sampling": True,
    "cycles.adaptive_threshold": 0.01,
    # Water and sky are without noise: left to itself, Cycles takes some fifty samples of them too.
    "cycles.adaptive_min_samples": 16,
    "cycles.max_bounces": 3,
    "cycles.transparent_max_bounces": 8,
    "cycles.caustics_reflective": False,
    "cycles.caustics_refractive": False,
    "cycles.sample_clamp_indirect": 3.0,
}
_EEVEE = {
    "eevee.taa_render_samples": 64,
    "eevee.use_gtao": True,
    "eevee.use_soft_shadows": True,
    "eevee.shadow_pool_size": "1024",
    "eevee.shadow_resolution_scale": 0.5,
}


def set_renderer(scene, engine):
    """Chooses "CYCLES" or "EEVEE" and sets both for the studio; without Cycles, EEVEE."""
    if engine == "CYCLES" and hasattr(scene, "cycles"):
        scene.render.engine = "CYCLES"
    else:
        scene.render.engine = blender_versions.eevee()
    settings = {
        "render.resolution_x": WIDTH,
        "render.resolution_y": HEIGHT,
        "render.resolution_percentage": 100,
        "render.pixel_aspect_x": 1.0,
        "render.pixel_aspect_y": 1.0,
        "render.film_transparent": False,
        "view_settings.look": "None",
        "view_settings.view_transform": "Standard",
        "view_settings.exposure": 0.0,
        "view_settings.gamma": 1.0,
        "cycles.use_denoising": can_denoise(),
        **_CYCLES,
        **_EEVEE,
    }
    for path, value in settings.items():
        scene_settings.write(scene, path, value)


def can_denoise():
    """Whether this Blender was built with the denoiser that runs on all machines."""
    try:
        import _cycles
    except ImportError:
        return False
    return bool(getattr(_cycles, "with_openimagedenoise", False))
