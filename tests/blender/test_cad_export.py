# SPDX-License-Identifier: GPL-3.0-or-later
"""STEP and IGES files: what they hold, by the patches that were reported; whole or not at all."""

import resource
import signal
import sys
import threading
import time
from contextlib import contextmanager

import bpy
import pytest
from addon_under_test import DEPTH, HALF_BREADTH, LENGTH, add_hull, lined_hull, part, state_of

EXPORTS = [("STEP", "box.step"), ("IGES", "box.igs")]
OLD = b"what was there before"

# Of the port half: side, ends and bottom.
AREA = LENGTH * DEPTH + 2 * HALF_BREADTH * DEPTH + LENGTH * HALF_BREADTH


def export(file_format):
    return getattr(bpy.ops.hull, f"export_{file_format.lower()}")


def read_back(path):
    return part("bridge.native").require().read_cad_report(str(path))


def written(file_format, path, **settings):
    """What is read back of a file written by these settings."""
    hull = bpy.context.object
    for name, value in settings.items():
        setattr(hull.hull.export, name, value)
    assert export(file_format)(filepath=str(path)) == {"FINISHED"}
    return read_back(path)


@pytest.fixture(autouse=True)
def nothing_left():
    yield
    part("features.conversion.conversions").stop()


@pytest.fixture
def old_file(tmp_path):
    """A file that is to be replaced, but by a whole one only."""
    path = tmp_path / "box.step"
    path.write_bytes(OLD)
    yield path
    assert path.read_bytes() == OLD
    assert [one.name for one in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("file_format, name", EXPORTS)
def test_both_sides_are_one_valid_shell(tmp_path, file_format, name):
    hull = add_hull()
    report = written(file_format, tmp_path / name)
    assert report["valid"] and report["shells"] == 1 and report["format"].startswith(file_format)
    assert report["area"] == pytest.approx(2 * AREA, rel=1e-6)
    # The open deck is the only border.
    assert report["free_edge_length"] == pytest.approx(2 * (LENGTH + 2 * HALF_BREADTH), rel=1e-6)
    assert state_of(hull).ship.surface is not None
    assert [path.name for path in tmp_path.iterdir()] == [name]


@pytest.mark.parametrize("file_format, name", EXPORTS)
def test_extent_and_unit(tmp_path, file_format, name):
    add_hull()
    half = written(file_format, tmp_path / name, extent="HALF", unit="mm")
    assert half["area"] == pytest.approx(AREA, rel=1e-6) and half["unit"] == "mm"
    solid = written(file_format, tmp_path / name, extent="SOLID", unit="ft")
    assert solid["closed"] and solid["unit"] == "ft"
    volume = LENGTH * HALF_BREADTH * DEPTH
    assert solid["volume"] == pytest.approx(2 * volume, rel=1e-6)
    closed_half = written(file_format, tmp_path / name, extent="HALF_SOLID", unit="m")
    assert closed_half["closed"] and closed_half["volume"] == pytest.approx(volume, rel=1e-6)


def test_schema(tmp_path):
    add_hull()
    for schema in ("AP214", "AP242"):
        report = written("STEP", tmp_path / "box.step", schema=schema)
        assert report["format"] == f"STEP {schema}"


def test_a_hull_of_both_sides_is_not_mirrored(tmp_path):
    hull = add_hull()
    hull.hull.half = False
    report = written("STEP", tmp_path / "box.step")
    assert report["area"] == pytest.approx(AREA, rel=1e-6)


def test_lines_are_curves_on_layers(tmp_path):
    settings = lined_hull().hull.lines
    path = tmp_path / "box.step"
    without = written("STEP", path)
    assert without["curves"] == 0
    lined = written("STEP", path, with_sections=True)
    kinds = ["buttocks", "design waterline", "diagonals", "planes", "stations", "waterlines"]
    assert set(kinds) <= set(lined["layers"]) and lined["curves"] > 0
    assert "knuckles and borders" not in lined["layers"]
    assert lined["area"] == pytest.approx(without["area"])
    settings.show_stations = settings.show_planes = False
    bpy.context.view_layer.update()
    fewer = written("STEP", path, with_features=True)
    assert "stations" not in fewer["layers"] and "planes" not in fewer["layers"]
    assert "knuckles and borders" in fewer["layers"]


def test_curves_are_on_the_surface():
    import numpy as np

    bpy.ops.hull.load_sample(name="coaster")
    hull, curves = bpy.context.object, part("features.exchange.cad_curves")
    hull.hull.export.with_sections = hull.hull.export.with_features = True
    state = state_of(hull)
    surface, shares = state.ship.source.new_surface(), []
    wanted = curves.wanted(hull, bpy.context.scene, state.ship.surface)
    found = curves.curves(surface, wanted, shares.append)
    assert shares == sorted(shares) and 0.0 <= shares[0] and shares[-1] <= 1.0
    native = part("bridge.native").require()
    tree, size = native.SurfaceTree(surface), part("features.lines.lines").size_of(surface)
    evaluate = part("features.lines.line_curves")._de_boor
    for name, layer, knots, points in found:
        assert len(knots) == len(points) + 4 and layer
        at = np.linspace(knots[3], knots[-4], 50)
        on_curve = evaluate(np.asarray(knots), np.asarray(points), 3, at)
        distances = np.linalg.norm(tree.closest_points(on_curve).points - on_curve, axis=1)
        assert distances.max() < 3e-6 * size, name
    assert {"stations", "waterlines", "knuckles and borders"} <= {layer for _, layer, *_ in found}


def test_chains_of_cubics_become_splines():
    """A chain that is C2, then C1, then has a kink: the same curve, with few knots."""
    import numpy as np

    curves, random = part("features.exchange.cad_curves"), np.random.default_rng(3)
    first = random.normal(size=(4, 3))
    chain = [first]
    for order in (2, 1, 0):  # so many derivatives go on
        before, after = chain[-1], random.normal(size=(4, 3))
        after[0] = before[3]
        if order >= 1:
            after[1] = 2.0 * before[3] - before[2]
        if order >= 2:
            after[2] = after[1] * 2.0 - after[0] + (before[3] - 2.0 * before[2] + before[1])
        chain.append(after)
    knots, points = curves._spline(np.array(chain))
    assert knots.tolist() == [0] * 4 + [1] + [2] * 2 + [3] * 3 + [4] * 4
    at = np.linspace(0.0, 4.0, 41)
    found = part("features.lines.line_curves")._de_boor(knots, points, 3, at)
    for t, point in zip(at, found):
        piece = min(int(t), 3)
        u = t - piece
        weights = [(1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u * u * (1 - u), u**3]
        assert point == pytest.approx(weights @ chain[piece], abs=1e-12)


@pytest.mark.parametrize("file_format", ["STEP", "IGES"])
def test_lines_of_a_ship_with_kinks_are_read_back(freeship_folder, tmp_path, file_format):
    bpy.ops.hull.import_hull(filepath=str(freeship_folder / "FREE!ship demo 6.fbm"))
    report = written(file_format, tmp_path / "ship.x", with_sections=True, with_features=True)
    assert {"flats", "knuckles and borders", "stations"} <= set(report["layers"])


def test_a_ship(freeship_folder, tmp_path):
    bpy.ops.hull.import_hull(filepath=str(freeship_folder / "FREE!ship demo 6.fbm"))
    report = written("STEP", tmp_path / "ship.step")
    assert report["valid"] and report["shells"] == 1


def test_the_patches_of_the_report_are_written(tmp_path, monkeypatch):
    hull = add_hull()
    assert bpy.ops.hull.convert() == {"FINISHED"}
    outcome = part("features.conversion.conversions").last_outcome(hull)[0]
    patches = part("features.conversion.patches")
    monkeypatch.setattr(patches, "convert", None)  # would be told of as an error
    files = part("features.exchange.cad_files")
    for file_format, name in EXPORTS:
        found = files.export(hull, bpy.context.scene, str(tmp_path / name), file_format)
        assert found.converted is outcome.converted and found.report["valid"]


def test_a_file_is_of_the_hull_as_it_was(tmp_path):
    hull, files = add_hull(), part("features.exchange.cad_files")
    path = str(tmp_path / "before.step")
    task = files.Export(hull, bpy.context.scene, path, "STEP")
    for vertex in hull.data.vertices:
        vertex.co.z *= 2.0
    hull.data.update_tag()
    bpy.context.view_layer.update()
    bpy.data.objects.remove(hull)
    assert task.result().report["area"] == pytest.approx(2 * AREA, rel=1e-6)
    assert read_back(path)["valid"]


@pytest.mark.parametrize("file_format, name", EXPORTS)
def test_a_folder_that_is_not_there(tmp_path, file_format, name):
    add_hull()
    with pytest.raises(RuntimeError) as caught:
        export(file_format)(filepath=str(tmp_path / "nowhere" / name))
    assert "nowhere" in str(caught.value) and "Traceback" not in str(caught.value)
    assert not list(tmp_path.iterdir())


def test_a_folder_that_cannot_be_written_to(tmp_path):
    add_hull()
    folder = "/sys/kernel"  # of which that is true for root as well
    for file_format, name in EXPORTS:
        with pytest.raises(RuntimeError) as caught:
            export(file_format)(filepath=f"{folder}/{name}")
        assert folder in str(caught.value) and "Traceback" not in str(caught.value)


def test_a_path_that_is_a_folder(tmp_path):
    add_hull()
    (tmp_path / "box.step").mkdir()
    with pytest.raises(RuntimeError) as caught:
        bpy.ops.hull.export_step(filepath=str(tmp_path / "box.step"))
    assert "Traceback" not in str(caught.value)
    assert [path.name for path in tmp_path.iterdir()] == ["box.step"]


@contextmanager
def full_disk(most=2000):
    """No file can grow beyond so many bytes, which fails as it does on a full disk. Nor can a log
    that the tests are written to, so that this must be over before they are."""
    sys.stdout.flush()
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    handler = signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (most, limits[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
        signal.signal(signal.SIGXFSZ, handler)


@pytest.mark.parametrize("file_format", ["STEP", "IGES"])
def test_a_full_disk(old_file, file_format):
    add_hull()
    with pytest.raises(RuntimeError) as caught, full_disk():
        export(file_format)(filepath=str(old_file))
    assert "box.step" in str(caught.value) and "Traceback" not in str(caught.value)


@pytest.mark.parametrize("file_format", ["STEP", "IGES"])
def test_a_cancelled_export_leaves_the_old_file(old_file, monkeypatch, file_format):
    """Cancelled while the file is written, at the first word of its progress."""
    hull, files = add_hull(), part("features.exchange.cad_files")
    native = part("bridge.native").require()
    name = f"write_{file_format.lower()}"
    write, begun = getattr(native, name), threading.Event()

    def slow_write(*arguments, progress, **options):
        begun.set()
        until = time.monotonic() + 30.0
        while time.monotonic() < until:
            progress(0.0)
            time.sleep(0.005)

    def cancelled_within(*arguments, progress, **options):
        def tell(share):
            task.cancel()
            progress(share)

        begun.wait(30.0)
        return write(*arguments, progress=tell, **options)

    for stand_in in (slow_write, cancelled_within):
        begun.clear()
        monkeypatch.setattr(native, name, stand_in)
        task = files.Export(hull, bpy.context.scene, str(old_file), file_format)
        if stand_in is slow_write:
            assert begun.wait(30.0)
            with pytest.raises(ValueError, match="under way"):
                files.Export(hull, bpy.context.scene, str(old_file), file_format)
            with pytest.raises(RuntimeError, match="under way"):
                hull.hull.export.tolerance = 1e-7
                bpy.ops.hull.convert()
            assert bpy.ops.hull.cancel_task() == {"FINISHED"}
        begun.set()
        with pytest.raises(part("bridge.background.jobs").Cancelled):
            task.result()
    assert part("features.conversion.conversions").running(hull) is None


def test_a_hull_without_a_surface_is_a_message(old_file):
    hull = add_hull()
    hull.scale = (2.0, 1.0, 1.0)
    bpy.context.view_layer.update()
    assert not bpy.ops.hull.export_step.poll()
    with pytest.raises(ValueError, match="scale"):
        part("features.exchange.cad_files").Export(hull, bpy.context.scene, str(old_file), "STEP")
