# SPDX-License-Identifier: GPL-3.0-or-later
"""Surface, lines, hydrostatics and plots follow the control mesh and its settings."""

import bpy
from bpy.app.handlers import persistent

from ..bridge.objects import appendages, curve_lines, hull_objects, unrecorded
from ..features import studio
from ..features.analyses import live_analyses
from ..features.area_curves import live_target
from ..features.conversion import conversions
from ..features.fields import before, preview, seen
from ..features.hull import hull_state, late_joining, live_normals
from ..features.morphing import members, pair_lines
from ..features.networks import following as networks
from ..features.surface import colour_views
from ..features.targets import rows as targets
from ..features.variants import following

# Bringing a hull up to date changes its surface and lines, and Blender reports that in turn.
_is_following = False


def forget_all():
    live_analyses.stop()
    following.stop()
    live_normals.stop()
    late_joining.stop()
    studio.stop()
    conversions.stop()
    networks.forget_all()
    hull_state.forget_all()


def _follow(hulls, scene, view_layer, is_by_hand=True):
    global _is_following
    if _is_following:
        return
    _is_following = True
    try:
        for hull in hulls:
            _follow_one(hull, scene, is_by_hand)
        # What was kept in its place for one hull has moved in all that share its mesh.
        for hull in hull_state.with_shared_mesh(hulls, view_layer):
            hull_state.refresh(hull, scene)
            preview.notice_moves(hull)
        studio.ask(hulls, scene)
        following.ask(live_analyses.show_plots_of_active)
        live_analyses.show_plots(hull_objects.hull_of(view_layer.objects.active), scene)
    finally:
        _is_following = False


def _follow_one(hull, scene, is_by_hand):
    """In the order of the data; see docs/architecture.md."""
    members.follow(hull, scene)
    with curve_lines.read_once():
        state = hull_state.follow_edit(
            hull, scene, is_by_hand, late_joining.can_wait(hull), preview.placed
        )
        later_subjects(hull, scene)
    if state.ship.waits:
        late_joining.ask()
    if state.shown.may_move(hull):
        live_normals.ask()


def later_subjects(hull, scene):
    """What these show of a hull whose state is up to date."""
    before.follow(hull, scene)
    seen.follow(hull, scene)
    pair_lines.follow(hull, scene)
    live_target.follow(hull, scene)
    targets.follow(hull, scene)


def _follow_all(is_by_hand=True):
    """Each in its own scene, whose unit it is measured by. The scene at hand comes last: plots, and
    hulls that are in several scenes, are as it has them."""
    at_hand = bpy.context.scene
    for scene in (*(other for other in bpy.data.scenes if other != at_hand), at_hand):
        _follow(hull_objects.hulls(scene.objects), scene, _view_layer_of(scene), is_by_hand)


def _view_layer_of(scene):
    """The one at hand, or a scene's first."""
    return bpy.context.view_layer if scene == bpy.context.scene else scene.view_layers[0]


def _place_all():
    """A file has the places that were computed when it was written; what hulls hang on may not be
    in it."""
    for scene in bpy.data.scenes:
        if hull_objects.hulls(scene.objects):
            _view_layer_of(scene).update()


def _updates_of_objects(depsgraph):
    return (one for one in depsgraph.updates if isinstance(one.id, bpy.types.Object))


def _going_by(changed, view_layer):
    """The hulls that go by curves and appendages among changed objects."""
    hulls = preview.concerned(changed, view_layer)
    return hulls + list(filter(None, map(appendages.hull_of, changed)))


@persistent
def after_update(scene, depsgraph):
    if unrecorded.is_undoing():
        return  # after_undo() follows all
    unrecorded.after_update()
    updates = list(_updates_of_objects(depsgraph))
    changed = {
        update.id.original
        for update in updates
        if update.is_updated_geometry or update.is_updated_transform
    }
    if depsgraph.id_type_updated("SCENE"):
        # What was hidden may be seen again. Of shape keys that come by joining to some that are
        # there, nothing else is said.
        changed.update(obj for obj in depsgraph.view_layer.objects if obj.mode == "EDIT")
        changed.update(hull_state.with_other_refusal(depsgraph.view_layer))
    if depsgraph.id_type_updated("KEY"):
        # Of shape keys that come by joining, nothing is said of their object; of those that go, it
        # is.
        changed.update(filter(hull_objects.has_shape_keys, depsgraph.view_layer.objects))
    hull_state.forget_deleted()
    hulls = hull_objects.hulls(changed) + hull_state.with_foreign_surface(changed)
    # That a surface is not sculpted any longer is no change of its geometry.
    hulls += hull_state.with_unknown_surface({update.id.original for update in updates} - changed)
    hulls += _going_by(changed, depsgraph.view_layer)
    if depsgraph.id_type_updated("SCENE"):
        hulls += hull_state.with_other_appendages(depsgraph.view_layer)
    _follow(list(dict.fromkeys(hulls)), scene, depsgraph.view_layer)
    seen.follow_curves(changed, scene, depsgraph.view_layer)
    has_others = depsgraph.id_type_updated("SCENE") or depsgraph.id_type_updated("COLLECTION")
    networks.after_changes(changed, scene, has_others)


@persistent
def after_frame(scene, depsgraph):
    """Another frame changes what is animated, which may be settings alone; another scene comes with
    a frame of its own."""
    if unrecorded.is_undoing():
        return
    changed = {update.id.original for update in _updates_of_objects(depsgraph)}
    hulls = hull_objects.hulls(changed) + _going_by(changed, depsgraph.view_layer)
    _follow(list(dict.fromkeys(hulls)), scene, depsgraph.view_layer)
    seen.follow_curves(changed, scene, depsgraph.view_layer)
    networks.after_changes(changed, scene, has_other_members=False)


@persistent
def before_undo(*unused):
    unrecorded.before_undo()


@persistent
def after_undo(*unused):
    """Undo restores shown objects from another moment than what was computed last."""
    unrecorded.after_undo()
    hull_state.forget_deleted()
    hull_state.forget_shown()
    studio.forget()
    for hull in hull_objects.hulls(bpy.context.view_layer.objects):
        preview.take_up(hull)
    _follow_all(is_by_hand=False)
    networks.follow_all()
    colour_views.follow()


@persistent
def before_load(*unused):
    forget_all()
    unrecorded.forget()
    colour_views.forget()


@persistent
def after_load(*unused):
    forget_all()
    _place_all()
    begin()


def begin():
    """Brings all hulls of the file up to date, of which nothing is known yet."""
    live_analyses.start()
    _follow_all()
    networks.follow_all()
    colour_views.follow()


@persistent
def before_picture(scene, *unused):
    studio.before_picture(scene)
