# SPDX-License-Identifier: GPL-3.0-or-later
"""Node trees of materials and worlds, written as formulas of sockets and numbers."""


class Nodes:
    """The node tree of a material or a world, emptied."""

    def __init__(self, owner):
        owner.use_nodes = True
        self._tree = owner.node_tree
        self._tree.nodes.clear()

    def add(self, kind, **inputs):
        """A node; inputs by the names of its sockets, with _ for blanks: numbers, colours or
        sockets of other nodes."""
        node = self._tree.nodes.new(kind)
        for name, value in inputs.items():
            self.put(value, node.inputs[name.replace("_", " ")])
        return node

    def put(self, value, socket):
        """Gives an input socket a number, a colour or what another node's socket gives."""
        if hasattr(value, "is_output"):
            self._tree.links.new(value, socket)
        else:
            socket.default_value = value

    def _fed(self, kind, values, **settings):
        """The output of a node whose inputs are given in their order."""
        node = self._tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        for value, socket in zip(values, node.inputs):
            self.put(value, socket)
        return node.outputs[0]

    def named(self, name, value):
        """A number that set_named changes later."""
        node = self._tree.nodes.get(name)
        if node is None:
            node = self._tree.nodes.new("ShaderNodeValue")
            node.name = node.label = name
        node.outputs[0].default_value = value
        return node.outputs[0]

    def math(self, operation, *values):
        return self._fed("ShaderNodeMath", values, operation=operation)

    def choose(self, condition, if_not, if_so):
        """Of two numbers the second where a condition is 1, the first where it is 0."""
        difference = self.math("SUBTRACT", if_so, if_not)
        return self.math("MULTIPLY_ADD", condition, difference, if_not)

    def smooth(self, value, low, high):
        """0 at `low` to 1 at `high`, without kinks."""
        node = self.add("ShaderNodeMapRange", Value=value, From_Min=low, From_Max=high)
        node.interpolation_type = "SMOOTHSTEP"
        return node.outputs[0]

    def split(self, vector):
        """(x, y, z) of a vector's socket."""
        return tuple(self.add("ShaderNodeSeparateXYZ", Vector=vector).outputs)

    def eye(self):
        """Where the camera is, in the object's coordinates."""
        node = self._tree.nodes.new("ShaderNodeVectorTransform")
        node.vector_type, node.convert_from, node.convert_to = "POINT", "CAMERA", "OBJECT"
        node.inputs[0].default_value = (0.0, 0.0, 0.0)
        return node.outputs[0]

    def vector_math(self, operation, *values):
        return self._fed("ShaderNodeVectorMath", values, operation=operation)

    def ramp(self, value, stops, low=0.0, high=1.0, steps=False):
        """The colour at a value: stops are pairs (value, colour), from `low` to `high`."""
        part = self.add("ShaderNodeMapRange", Value=value, From_Min=low, From_Max=high)
        node = self.add("ShaderNodeValToRGB", Fac=part.outputs[0])
        ramp = node.color_ramp
        ramp.interpolation = "CONSTANT" if steps else "LINEAR"
        elements = ramp.elements
        while len(elements) > 1:
            elements.remove(elements[-1])
        for index, (place, colour) in enumerate(stops):
            position = (place - low) / (high - low)
            element = elements.new(position) if index else elements[0]
            element.position, element.color = position, rgba(colour)
        return node.outputs[0]

    def mix_colour(self, part, first, second):
        return self._fed("ShaderNodeMixRGB", (part, first, second))

    def mix_shader(self, part, first, second):
        return self._fed("ShaderNodeMixShader", (part, first, second))

    def emission(self, colour):
        return self.add("ShaderNodeEmission", Color=colour).outputs[0]

    def finish(self, shader, kind="ShaderNodeOutputMaterial"):
        self.add(kind, Surface=shader)


def rgba(colour):
    return (*colour[:3], 1.0)


def set_named(material, name, value):
    """Changes a number that Nodes.named has put into a material; one that is not there stays so."""
    node = material.node_tree.nodes.get(name) if material.use_nodes else None
    if node is not None:
        node.outputs[0].default_value = value
