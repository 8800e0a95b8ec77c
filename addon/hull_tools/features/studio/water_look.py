# SPDX-License-Identifier: GPL-3.0-or-later
"""What water does to light: the colour of its depth, and how it veils what is in it.

The depth is a background; what is below the surface fades into it with the way that sight has
through the water. No ray is bent, and nothing is traced through a volume: pictures are free of that
noise, and both renderers show the same.
"""

from math import log

# The colour of deep water by the sine of the elevation to which one looks.
_DEPTH = (
    (-1.0, (0.008, 0.070, 0.115)),
    (-0.30, (0.012, 0.100, 0.155)),
    (0.0, (0.045, 0.260, 0.340)),
    (0.6, (0.14, 0.50, 0.60)),
    (1.0, (0.25, 0.65, 0.72)),
)

# What is left of the keel, seen from above by one who looks down this steeply.
_CLEAR_AT_KEEL, _STEEPNESS = 0.7, 0.15
# The same of what is one length of the hull away from an eye in the water.
_CLEAR_AT_LENGTH = 0.84

# The number of that name in materials.
DRAFT = "Draft"

# Who looks more level than this from above the water sees a drawing, without water.
LEVEL = 0.01


def depth_colour(nodes, sine):
    """The colour of deep water for a socket with the sine of the elevation one looks to."""
    return nodes.ramp(sine, _DEPTH, low=-1.0, high=1.0)


def veiled(nodes, shader, draft, length):
    """A shader of something at the hull, seen through the water where it is below the `draft`.

    The material's object has the hull's coordinates and is upright.
    """
    draft = nodes.named(DRAFT, draft)
    height = nodes.split(nodes.add("ShaderNodeTexCoord").outputs["Object"])[2]
    eye = nodes.split(nodes.eye())[2]
    towards_eye = nodes.split(nodes.add("ShaderNodeNewGeometry").outputs["Incoming"])[2]
    distance = nodes.add("ShaderNodeCameraData").outputs["View Distance"]
    depth = nodes.math("SUBTRACT", draft, height)
    is_above = nodes.math("GREATER_THAN", eye, draft)
    from_above = nodes.math("DIVIDE", depth, nodes.math("MAXIMUM", towards_eye, LEVEL))
    from_above = nodes.math("MULTIPLY", from_above, -log(_CLEAR_AT_KEEL) * _STEEPNESS)
    from_above = nodes.math("DIVIDE", from_above, draft)
    is_steep = nodes.math("GREATER_THAN", towards_eye, LEVEL)
    from_above = nodes.math("MULTIPLY", from_above, is_steep)
    from_below = nodes.math("MULTIPLY", distance, -log(_CLEAR_AT_LENGTH) / length)
    way = nodes.choose(is_above, from_below, from_above)
    way = nodes.math("MULTIPLY", way, nodes.math("GREATER_THAN", depth, 0.0))
    veil = nodes.math("SUBTRACT", 1.0, nodes.math("EXPONENT", nodes.math("MULTIPLY", way, -1.0)))
    colour = depth_colour(nodes, nodes.math("MULTIPLY", towards_eye, -1.0))
    return nodes.mix_shader(veil, shader, nodes.emission(colour))
