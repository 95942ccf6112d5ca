# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""plotter.nbuffer: the image is the same with all that PyVista can draw."""

import importlib.metadata
import itertools
import pathlib
import subprocess
import sys

import numpy as np
import pytest

pyvista = pytest.importorskip("pyvista", reason="SKIPPED: PyVista is not installed")

import vtknbuffer.pyvista  # noqa: E402
from conftest import check_that_all_end, differing, rendering, run_python  # noqa: E402

HAS_COMPONENTS = hasattr(pyvista, "register_plotter_component")


def cubes(walls=3, side=4):
    """Cubes of some walls, one behind the other."""
    for i in range(walls * side * side):
        yield pyvista.Cube(center=(i % side, i // side % side, i // side // side * -2),
                           x_length=0.95, y_length=0.95)


def add_cubes(plotter, **options):
    for i, cube in enumerate(cubes()):
        plotter.add_mesh(cube, **{"color": (i % 7 / 7, i % 5 / 5, 0.8), **options})


def look(plotter, i):
    plotter.camera.position = (1.5 + 0.5 * i, 2 + 0.2 * i, 8)
    plotter.camera.focal_point = (1.5, 1.5, 0)
    plotter.camera.up = (0, 1, 0)
    plotter.renderer.ResetCameraClippingRange()


def frames(plotter, views, scale):
    images = []
    for i in range(views):
        look(plotter, i)
        plotter.render()
        images.append(plotter.screenshot(None, return_img=True, scale=scale))
    return images


def check_same(build, hidden=1, views=2, scale=None, **options):
    """Draw views with the culler and then without it. Return the statistics of the last view."""
    plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120), **options)
    build(plotter)
    # Few props are enough for a test here, in every frame.
    plotter.nbuffer.enable(minimum_number_of_candidates=1, back_off=0)
    plotter.show(auto_close=False)
    ours = frames(plotter, views, scale)
    found = plotter.nbuffer.statistics
    plotter.nbuffer.disable()
    stock = frames(plotter, views, scale)
    plotter.close()
    assert [differing(a, b) for a, b in zip(stock, ours)] == [0] * views
    assert max(image.std() for image in stock) > 0, "the picture is empty"
    assert found["verdicts"]["Hidden"] >= hidden, found
    return found


def test_component_is_found_without_an_import():
    names = {point.name for point in importlib.metadata.entry_points(
        group="pyvista.plotter_components")}
    if "nbuffer" not in names or not HAS_COMPONENTS:
        pytest.skip("SKIPPED: the package is not installed by pip, or PyVista is older than 0.48")
    assert run_python("""
import pyvista, sys
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(pyvista.Cube())
assert "vtknbuffer" not in sys.modules
plotter.nbuffer.enable()
plotter.show(auto_close=False)
print(plotter.nbuffer.statistics["props"])
plotter.close()
""").strip() == "1"


def test_camera_moves():
    check_same(add_cubes, hidden=10, views=8)


def test_subplots_have_one_culler():
    def build(plotter):
        for i in range(2):
            plotter.subplot(0, i)
            add_cubes(plotter)
        plotter.link_views()
    check_same(build, hidden=5, shape=(1, 2))
    plotter = pyvista.Plotter(off_screen=True, shape=(2, 2))
    culler = plotter.nbuffer.enable()
    assert all(vtknbuffer.find_culler(renderer) is culler for renderer in plotter.renderers)
    plotter.close()


def test_screenshots_at_a_scale():
    check_same(add_cubes, scale=2)


# Every option of add_mesh() that changes how a mesh is drawn.
MESH_OPTIONS = {
    "style-wireframe": dict(style="wireframe"),
    "style-points": dict(style="points", point_size=4),
    "style-points_gaussian": dict(style="points_gaussian", point_size=6),
    "points-as-spheres": dict(style="points", render_points_as_spheres=True, point_size=8),
    "edges": dict(show_edges=True, edge_color="red", line_width=2),
    "edge-opacity": dict(show_edges=True, edge_opacity=0.5),
    "vertices": dict(show_vertices=True),
    "lines-as-tubes": dict(style="wireframe", render_lines_as_tubes=True, line_width=4),
    "opacity": dict(opacity=0.4),
    "smooth": dict(smooth_shading=True),
    "smooth-split": dict(smooth_shading=True, split_sharp_edges=True),
    "gouraud": dict(interpolation="gouraud"),
    "pbr": dict(pbr=True, metallic=0.6, roughness=0.4),
    "lighting-off": dict(lighting=False),
    "cull-front": dict(culling="front"),
    "cull-back": dict(culling="back"),
    "backface": dict(backface_params={"color": "blue"}),
    "silhouette": dict(silhouette=True),
    "specular": dict(specular=0.8, specular_power=20, ambient=0.2, diffuse=0.7),
    "emissive": dict(emissive=True, style="points_gaussian"),
    "force-opaque": dict(opacity=0.999),
    "not-pickable": dict(pickable=False),
    "user-matrix": dict(user_matrix=np.diag((1.1, 0.9, 1.0, 1.0))),
}


@pytest.mark.parametrize("options", MESH_OPTIONS.values(), ids=MESH_OPTIONS.keys())
def test_options_of_add_mesh(options):
    # One wall as always, which hides, and the others with the option.
    def build(plotter):
        for i, cube in enumerate(cubes()):
            plotter.add_mesh(cube, color=(i % 7 / 7, 0.5, 0.8), **(options if i >= 16 else {}))
    check_same(build, hidden=0)


# Ways to colour by data.
SCALAR_OPTIONS = {
    "points": dict(scalars="p"),
    "cells": dict(scalars="c"),
    "component": dict(scalars="v", component=1),
    "rgb": dict(scalars="rgb", rgb=True),
    "log": dict(scalars="p", log_scale=True, clim=(1, 20)),
    "limits": dict(scalars="p", clim=(3, 6), below_color="blue", above_color="red"),
    "colors": dict(scalars="c", cmap="viridis", n_colors=4),
    "no-interpolation": dict(scalars="p", interpolate_before_map=False),
    "nan": dict(scalars="n", nan_color="green", nan_opacity=1.0),
    "opacity-by-data": dict(scalars="p", opacity="linear"),
    "categories": dict(scalars="c", categories=True),
    "preference": dict(scalars="p", preference="point", flip_scalars=True),
    "shown-bar": dict(scalars="p", show_scalar_bar=True),
}


@pytest.mark.parametrize("options", SCALAR_OPTIONS.values(), ids=SCALAR_OPTIONS.keys())
def test_colours_by_data(options):
    def build(plotter):
        for i, cube in enumerate(cubes()):
            cube["p"] = np.arange(cube.n_points) + 1.0
            cube["n"] = np.where(np.arange(cube.n_points) % 3, cube["p"], np.nan)
            cube["v"] = np.column_stack([cube["p"]] * 3)
            cube.cell_data["c"] = np.arange(cube.n_cells) % 4
            cube.cell_data["rgb"] = np.full((cube.n_cells, 3), i % 250, np.uint8)
            plotter.add_mesh(cube, **{"show_scalar_bar": False, **options})
    check_same(build, hidden=0)


def test_textures():
    texture = pyvista.numpy_to_texture(
        np.random.default_rng(1).integers(0, 255, (16, 16, 3), np.uint8))

    def build(plotter):
        for i in range(20):
            plane = pyvista.Plane(center=(1.5, 1.5, -i), i_size=5, j_size=5)
            plotter.add_mesh(plane, texture=texture)
    check_same(build)


def test_multiblock():
    def build(plotter):
        for half in range(2):
            blocks = pyvista.MultiBlock(list(itertools.islice(cubes(), 24 * half, 24 * half + 24)))
            plotter.add_mesh(blocks, color="tan")
            if hasattr(plotter, "add_composite"):
                plotter.add_composite(blocks, color="white", opacity=0.5)
        add_cubes(plotter)
    check_same(build, hidden=0)


def test_glyphs_volumes_labels_and_widgets():
    def build(plotter):
        add_cubes(plotter)
        sphere = pyvista.Sphere(radius=1, center=(1.5, 1.5, 2), theta_resolution=8,
                                phi_resolution=8)
        sphere["normals"] = sphere.point_normals
        plotter.add_mesh(sphere.glyph(orient="normals", factor=0.3), color="red")
        grid = pyvista.ImageData(dimensions=(8, 8, 8), origin=(-2, -2, -12))
        grid["data"] = np.arange(grid.n_points) % 255
        plotter.add_volume(grid, cmap="viridis", opacity="linear", show_scalar_bar=False)
        plotter.add_point_labels([(0, 0, 1), (3, 3, 1)], ["one", "two"])
        plotter.add_text("text")
        plotter.add_axes()
        plotter.show_bounds()
        plotter.add_mesh(pyvista.Line((0, 0, 2), (3, 3, 2)), color="black", line_width=3)
    check_same(build)


PLOTTER_OPTIONS = {
    "ssaa": lambda p: p.enable_anti_aliasing("ssaa"),
    "fxaa": lambda p: p.enable_anti_aliasing("fxaa"),
    "msaa": lambda p: p.enable_anti_aliasing("msaa"),
    "depth-peeling": lambda p: p.enable_depth_peeling(),
    "parallel": lambda p: p.enable_parallel_projection(),
    "gradient": lambda p: p.set_background("white", top="blue"),
    "hidden-lines": lambda p: p.enable_hidden_line_removal(),
    "ssao": lambda p: p.enable_ssao(),
    "eye-dome": lambda p: p.enable_eye_dome_lighting(),
    "stereo": lambda p: p.enable_stereo_render(),
    "shadows": lambda p: p.enable_shadows(),
}


@pytest.mark.parametrize("change", PLOTTER_OPTIONS.values(), ids=PLOTTER_OPTIONS.keys())
def test_options_of_the_plotter(change):
    def build(plotter):
        add_cubes(plotter)
        plotter.add_mesh(pyvista.Plane(center=(1.5, 1.5, 2), i_size=2, j_size=2), opacity=0.5)
        change(plotter)
    check_same(build, hidden=0)


@pytest.mark.parametrize("ending, export", [
    ("obj", "export_obj"), ("gltf", "export_gltf"), ("wrl", "export_vrml"), ("svg", "save_graphic")])
def test_exports_hold_all_props(tmp_path, ending, export):
    texts = []
    for enabled in (False, True):
        plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
        add_cubes(plotter)
        if enabled:
            plotter.nbuffer.enable(minimum_number_of_candidates=1, back_off=0)
        plotter.show(auto_close=False)
        for i in range(3):
            look(plotter, i)
            plotter.render()
        folder = tmp_path / str(enabled)
        folder.mkdir()
        try:
            getattr(plotter, export)(str(folder / f"scene.{ending}"))
        except ImportError as error:
            pytest.skip(f"SKIPPED: this VTK lacks an exporter ({str(error).splitlines()[0]})")
        texts.append((folder / f"scene.{ending}").read_bytes())
        plotter.close()
    assert len(texts[0]) == len(texts[1])
    if len(texts[0]) < 1000:
        pytest.skip("SKIPPED: this VTK writes nothing here, with and without the culler")


def check_what_is_culled(plotter):
    """Some of the scene is shown in red, and some in gray."""
    second = plotter.nbuffer.show_culled(show=False, window_size=(160, 120))
    picture = second.screenshot(None, return_img=True).astype(int)
    second.close()
    red = (picture[..., 0] > 60) & (picture[..., 1] < picture[..., 0] // 3)
    gray = (picture.max(axis=2) - picture.min(axis=2) < 30) & (picture.max(axis=2) < 250)
    assert red.mean() > 0.01 and gray.mean() > 0.01


def test_verdicts_freeze_and_what_is_culled():
    plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
    actors = [plotter.add_mesh(cube, color="white", name=str(i)) for i, cube in enumerate(cubes(8))]
    plotter.nbuffer.enable(minimum_number_of_candidates=1)
    plotter.show(auto_close=False)
    for i in range(10):  # Where nothing was hidden, only every eighth frame is tested.
        look(plotter, 0.01 * i)
        plotter.render()
    assert plotter.nbuffer.verdict(actors[5]) == "Visible"
    hidden = [name for name in plotter.actors if plotter.nbuffer.verdict(name) == "Hidden"]
    assert len(hidden) == plotter.nbuffer.statistics["verdicts"]["Hidden"] > 20
    with pytest.raises(ValueError, match="no actor of the name 'x'"):
        plotter.nbuffer.verdict("x")
    check_what_is_culled(plotter)
    plotter.nbuffer.freeze()
    look(plotter, 9)
    plotter.render()
    assert plotter.nbuffer.statistics["decision"] == "Frozen"
    assert [plotter.nbuffer.verdict(name) for name in hidden] == ["Hidden"] * len(hidden)
    plotter.nbuffer.freeze(False)
    plotter.render()
    assert plotter.nbuffer.statistics["decision"] == "Culled"
    plotter.close()


def test_what_is_culled_of_composite_data():
    plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
    if not hasattr(plotter, "add_composite"):
        pytest.skip("SKIPPED: this PyVista has no add_composite()")
    wall = pyvista.Cube(center=(2, 2, 2), x_length=6, y_length=6)
    plotter.add_composite(pyvista.MultiBlock([wall, *cubes(8)]), color="white")
    plotter.nbuffer.enable(minimum_number_of_candidates=1, minimum_number_of_primitives=100,
                           divide_after=0, divide_in_background=0, back_off=0)
    plotter.show(auto_close=False)
    for i in range(10):
        look(plotter, 0.01 * i)
        plotter.render()
    statistics = plotter.nbuffer.statistics
    if statistics["units"] == 0:
        pytest.skip("SKIPPED: this VTK's composite data is drawn whole")
    assert statistics["units_hidden"] > 20
    check_what_is_culled(plotter)
    before = plotter.screenshot(None, return_img=True)
    assert not ((before[..., 0] > 60) & (before[..., 1] < before[..., 0] // 3)).any()
    plotter.close()


def test_glyphs_and_plain_data_of_a_composite_mapper_look_the_same_in_the_second_view():
    package = vtknbuffer._vtk_package
    core = importlib.import_module(f"{package}.vtkRenderingCore")
    points = pyvista.PolyData(np.array([(i % 4, i // 4, 0.0) for i in range(16)]))
    points["size"] = np.linspace(0.2, 1.0, 16)
    source = core.vtkGlyph3DMapper()
    source.SetInputData(points)
    source.SetSourceData(pyvista.Cube())
    source.SetScaleFactor(0.6)
    source.SetScaleModeToScaleByMagnitude()
    source.SetScaleArray("size")
    plain = core.vtkCompositePolyDataMapper()
    plain.SetInputDataObject(pyvista.Cube(center=(1.5, -1.5, 0)))
    plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
    for mapper in (source, plain):
        mapper.ScalarVisibilityOff()
        actor = core.vtkActor()
        actor.SetMapper(mapper)
        plotter.add_actor(actor)
    plotter.nbuffer.enable()
    plotter.show(auto_close=False)
    look(plotter, 0)
    plotter.render()
    images = [plotter.screenshot(None, return_img=True).astype(int)]
    second = plotter.nbuffer.show_culled(cpos=plotter.camera_position, drawn_color="white",
                                         show=False, window_size=(160, 120))
    images.append(second.screenshot(None, return_img=True).astype(int))
    # The frustum of the camera is a black line around the image.
    drawn = [(abs(image - image[10, 10]).max(axis=2) > 10)[4:-4, 4:-4] for image in images]
    assert drawn[0].mean() > 0.05
    assert (drawn[0] != drawn[1]).mean() < 0.002
    second.close()
    plotter.close()


def test_shadows():
    plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120), lighting="none")
    add_cubes(plotter)
    plotter.add_mesh(pyvista.Plane(center=(1.5, 1.5, -6), i_size=40, j_size=40), color="white")
    plotter.add_light(pyvista.Light(position=(20, 30, 40), focal_point=(1.5, 1.5, -6),
                                    light_type="scene light"))
    plotter.nbuffer.enable(minimum_number_of_candidates=1, back_off=0)
    plotter.show(auto_close=False)
    plotter.camera.position = (-10, 8, 20)
    plotter.render()
    bright = plotter.screenshot(None, return_img=True).astype(int)
    shadows = plotter.nbuffer.enable_shadows(mode="clamped")
    assert plotter.nbuffer.enable_shadows(mode="scissored") is shadows
    plotter.render()
    dark = plotter.screenshot(None, return_img=True).astype(int)
    assert (dark < bright).any() and not (dark > bright).any()
    assert plotter.nbuffer.shadow_statistics["decision"] == "Drawn"
    assert plotter.nbuffer.statistics["decision"] == "Culled"
    plotter.nbuffer.disable_shadows()
    plotter.render()
    assert differing(plotter.screenshot(None, return_img=True).astype(int), bright) == 0
    plotter.close()


def test_errors():
    plotter = pyvista.Plotter(off_screen=True)
    for call in (lambda: plotter.nbuffer.statistics, lambda: plotter.nbuffer.verdict("a"),
                 plotter.nbuffer.freeze, plotter.nbuffer.show_culled):
        with pytest.raises(RuntimeError, match="call nbuffer.enable"):
            call()
    with pytest.raises(RuntimeError, match="call nbuffer.enable_shadows"):
        plotter.nbuffer.shadow_statistics
    with pytest.raises(TypeError, match="no setting speed"):
        plotter.nbuffer.enable(speed=11)
    assert plotter.nbuffer.culler is None
    plotter.enable_eye_dome_lighting()
    with pytest.raises(RuntimeError, match="a render pass already"):
        plotter.nbuffer.enable_shadows()
    plotter.nbuffer.disable()
    culler = plotter.nbuffer.enable()
    assert plotter.nbuffer.enable() is culler
    plotter.close()
    with pytest.raises(RuntimeError, match="the plotter is closed"):
        plotter.nbuffer.enable()


def test_a_renderer_gets_one_culler():
    plotter = pyvista.Plotter(off_screen=True, shape=(1, 2))
    culler = vtknbuffer.enable(plotter.renderers[1])
    assert plotter.nbuffer.enable() is culler
    assert vtknbuffer.enable(plotter.render_window) is culler
    for renderer in plotter.renderers:
        assert vtknbuffer.find_culler(renderer) is culler
        vtknbuffer.disable(renderer)
    assert plotter.nbuffer.enable() is culler
    plotter.nbuffer.disable()
    assert not any(map(vtknbuffer.find_culler, plotter.renderers))
    plotter.close()


def test_many_actors_cost_no_loop():
    """enable() makes as many calls for 20,000 actors as for none."""
    import sys

    def calls(actors):
        plotter = pyvista.Plotter(off_screen=True)
        for _ in range(actors):
            plotter.renderer.AddActor(rendering.vtkActor())
        plotter.nbuffer
        count = 0

        def trace(frame, event, argument):
            nonlocal count
            count += 1
        sys.setprofile(trace)
        try:
            plotter.nbuffer.enable()
        finally:
            sys.setprofile(None)
        plotter.close()
        return count
    assert calls(20000) == calls(0)


def test_objects_are_dropped_in_every_order():
    check_that_all_end("import pyvista, vtknbuffer.pyvista", {
        f"{'closed, ' if close else ''}{'-'.join(order)}": f"""
plotter = pyvista.Plotter(off_screen=True, window_size=(160, 120))
actors = [plotter.add_mesh(pyvista.Cube(center=(0, 0, -i))) for i in range(10)]
culler = plotter.nbuffer.enable(minimum_number_of_candidates=1)
plotter.nbuffer.enable_shadows()
plotter.show(auto_close=False)
objects = dict(plotter=plotter, culler=culler, actor=actors)
if {close}:
    plotter.close()
del plotter, actors, culler
for name in {order!r}:
    del objects[name]
""" for order in itertools.permutations(("plotter", "culler", "actor")) for close in (False, True)})


@pytest.mark.skipif(vtknbuffer._vtk_package != "vtkmodules", reason="scripts import vtkmodules")
def test_scripts_of_others_are_compared(tmp_path):
    """compare_scripts.py compares plotters, and finds a script that changes with the pass."""
    script = tmp_path / "liar.py"
    script.write_text("""
import pyvista
plotter = pyvista.Plotter(window_size=(160, 120))
plotter.add_mesh(pyvista.Cube())
plotter.renderer.AddObserver("StartEvent", lambda renderer, event: renderer.SetBackground(
    float(bool(renderer.GetPass())), 0.0, 0.0))
plotter.show()
""")
    compare = [sys.executable, pathlib.Path(__file__).with_name("compare_scripts.py"), script]
    done = subprocess.run(compare, capture_output=True, text=True)
    assert done.returncode == 0 and "16 frames, 0 frames that differ" in done.stdout
    done = subprocess.run([*compare, "--shadows"], capture_output=True, text=True)
    assert done.returncode == 1 and "liar.py: 4 of 4 frames differ" in done.stdout
