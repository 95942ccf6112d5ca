# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package with plain VTK."""

import inspect
import itertools
import json
import pathlib
import re
import subprocess
import sys

import pytest

import vtknbuffer
from conftest import (check_that_all_end, differing, image, look, make_window, renderers_of,
                      rendering, vtk)


@pytest.mark.parametrize("renderers", [1, 3])
def test_image_is_the_same_to_the_byte(renderers):
    stock, ours = make_window(renderers), make_window(renderers)
    culler = vtknbuffer.enable(ours)
    for i in range(12):
        look(stock, i)
        look(ours, i)
        assert differing(image(stock), image(ours)) == 0
        for renderer in renderers_of(ours):
            assert vtknbuffer.statistics(culler, renderer)["verdicts"]["Hidden"] > 100


def test_one_renderer_alone(window):
    renderer = renderers_of(window)[0]
    culler = vtknbuffer.enable(renderer)
    look(window, 0)
    assert culler.GetDecision() == "Culled"
    assert culler.GetNumberOfHiddenProps() > 100


def test_enabling_twice_adds_one_culler(window):
    renderer = renderers_of(window)[0]
    before = renderer.GetCullers().GetNumberOfItems()
    culler = vtknbuffer.enable(window)
    assert vtknbuffer.enable(window) is culler
    assert vtknbuffer.enable(renderer, round_size=8) is culler
    assert renderer.GetCullers().GetNumberOfItems() == before + 1
    assert culler.GetTuning().Get("RoundSize") == 8
    vtknbuffer.disable(window)
    vtknbuffer.disable(window)
    assert vtknbuffer.find_culler(renderer) is None
    assert renderer.GetCullers().GetNumberOfItems() == before


def test_statistics_are_those_of_json(window):
    culler = vtknbuffer.enable(window)
    look(window, 0)
    look(window, 1)
    counts = vtknbuffer.statistics(culler)
    assert counts == json.loads(culler.GetStatisticsAsJSON())
    assert counts["props"] == 576
    assert counts["props"] == sum(counts["verdicts"].values())
    assert counts["drawn"] == culler.GetNumberOfPropsDrawn()
    shadows = vtknbuffer.vtkShadowVolumeClampPass()
    assert vtknbuffer.statistics(shadows)["decision"] == "None"
    with pytest.raises(TypeError):
        vtknbuffer.statistics(window)
    with pytest.raises(TypeError):
        vtknbuffer.statistics(shadows, renderers_of(window)[0])


def test_verdicts(window):
    renderer = renderers_of(window)[0]
    culler = vtknbuffer.enable(window)
    actors = renderer.GetActors()
    assert vtknbuffer.verdict(culler, actors.GetItemAsObject(0)) == "Unknown"
    look(window, 0)
    front, back = (actors.GetItemAsObject(i) for i in (60, 575 - 60))
    assert vtknbuffer.verdict(culler, front) == "Visible"
    pixels = [0, 0, 0, 0]
    assert culler.GetVisiblePixels(front, pixels)
    assert pixels[0] < pixels[2] and pixels[1] < pixels[3]
    assert not culler.GetVisiblePixels(back, pixels)
    assert pixels == [0, 0, 0, 0]
    assert vtknbuffer.verdict(culler, back) == "Hidden"
    assert culler.GetVerdict(back) == vtknbuffer.vtkNBufferVerdict.Hidden
    assert vtknbuffer.verdict(culler, back, part=0) == "Hidden"
    assert culler.GetVerdict(back, None) == vtknbuffer.vtkNBufferVerdict.Hidden
    assert culler.GetVerdict(back, 0) == vtknbuffer.vtkNBufferVerdict.Hidden
    assert culler.GetVerdict(back, 0, renderer) == vtknbuffer.vtkNBufferVerdict.Hidden


@pytest.mark.parametrize("target", [vtknbuffer.vtkNBufferCuller(),
                                    vtknbuffer.vtkShadowVolumeClampPass()],
                         ids=lambda target: target.GetClassName())
def test_settings_are_set_by_the_names_that_are_listed(target):
    settings = vtknbuffer.get_settings(target)
    assert len(settings) >= 6
    vtknbuffer.configure(target, **settings)
    assert vtknbuffer.get_settings(target) == settings


def test_every_property_of_the_culler_is_a_setting():
    culler = vtknbuffer.vtkNBufferCuller()
    own = set(dir(culler)) - set(dir(rendering.vtkCuller))
    names = {name[3:] for name in own if name.startswith("Set") and f"Get{name[3:]}" in own}
    settings = vtknbuffer.get_settings(culler)
    assert {vtknbuffer._snake_case(name) for name in names - {"Tuning", "DepthExchange"}} \
        <= set(settings)


@pytest.mark.parametrize("settings, error, text", [
    ({"round_sise": 1}, TypeError, "no setting round_sise; there are enabled"),
    ({"round_size": 0}, ValueError, "RoundSize must be 1 to"),
    ({"base_factor": 3}, ValueError, "BaseFactor must be 1, 2, 4 or 8, not 3"),
    ({"round_size": 1.5}, ValueError, "whole number"),
    ({"round_size": 2**40}, ValueError, "whole number"),
    ({"round_size": float("inf")}, ValueError, "whole number"),
    ({"back_off": 2}, ValueError, "0 or 1"),
    ({"backend": "gpu"}, ValueError, "one of auto, opengl, cpu"),
    ({"backend": 3}, ValueError, "one of auto, opengl, cpu"),
    ({"test_slivers": "never"}, ValueError, "True or False"),
])
def test_wrong_settings_are_refused_and_change_nothing(settings, error, text):
    culler = vtknbuffer.vtkNBufferCuller()
    before = vtknbuffer.get_settings(culler)
    with pytest.raises(error, match=re.escape(text)):
        vtknbuffer.configure(culler, freeze=True, hierarchy_size=7, **settings)
    assert vtknbuffer.get_settings(culler) == before


class One:
    """A whole number of another library, such as numpy.int64(1)."""

    def __index__(self):
        return 1


@pytest.mark.parametrize("value", [1, "OpenGL", One()])
def test_names_and_their_numbers_are_settings(value):
    culler = vtknbuffer.vtkNBufferCuller()
    vtknbuffer.configure(culler, backend=value)
    assert vtknbuffer.get_settings(culler)["backend"] == "opengl"


@pytest.mark.parametrize("target", [None, 1, "renderer"])
def test_only_renderers_and_windows_are_enabled(target):
    with pytest.raises(TypeError, match="a vtkRenderer or a vtkRenderWindow is needed"):
        vtknbuffer.enable(target)


def test_wrong_settings_add_no_culler(window):
    with pytest.raises(TypeError):
        vtknbuffer.enable(window, speed=11)
    assert vtknbuffer.find_culler(renderers_of(window)[0]) is None


def test_culler_is_a_culler_of_the_vtk_in_use():
    assert isinstance(vtknbuffer.vtkNBufferCuller(), rendering.vtkCuller)
    assert isinstance(vtknbuffer.vtkShadowVolumeClampPass(),
                      vtk("vtkRenderingOpenGL2").vtkOpenGLRenderPass)


def test_documentation_and_names():
    assert "to the bit" in vtknbuffer.vtkNBufferCuller.__doc__
    assert "nullptr" in vtknbuffer.vtkNBufferCuller.GetVerdict.__doc__
    assert [name for name in dir(vtknbuffer._module) if name.isupper()] == []
    for name in vtknbuffer.__all__:
        assert hasattr(vtknbuffer, name)
        assert name.startswith("vtk") or inspect.getdoc(getattr(vtknbuffer, name))


def test_mask_of_a_light(window):
    renderer = renderers_of(window)[0]
    light = rendering.vtkLight()
    light.SetLightTypeToSceneLight()
    light.SetPosition(30, 40, 60)
    renderer.AddLight(light)
    shadows = vtknbuffer.vtkShadowVolumeClampPass()
    renderer.SetPass(shadows)
    vtknbuffer.enable(window)
    look(window, 0)
    width, height = reference(), reference()
    mask = shadows.GetMask(light, width, height)
    assert (width.get(), height.get()) == window.GetSize()
    assert len(mask) == width.get() * height.get()
    assert 0 < sum(1 for value in mask if value) < len(mask)
    assert vtknbuffer.statistics(shadows)["lights"] == 1


def reference():
    """A number that C++ can change."""
    return vtk("vtkCommonCore").reference(0)


@pytest.mark.parametrize("picker", ["vtkPropPicker", "vtkCellPicker", "vtkPointPicker",
                                    "vtkAreaPicker"])
def test_pickers_find_the_same(picker):
    found = []
    for enabled in (False, True):
        window = make_window(shared=False)
        renderer = renderers_of(window)[0]
        if enabled:
            vtknbuffer.enable(window)
        for i in range(3):
            look(window, i)
        pick = getattr(rendering, picker)()
        if picker == "vtkAreaPicker":
            pick.AreaPick(20, 20, 180, 140, renderer)
            props = pick.GetProp3Ds()
        else:
            pick.Pick(100, 80, 0, renderer)
            props = pick.GetProp3Ds() if hasattr(pick, "GetProp3Ds") else [pick.GetViewProp()]
        found.append(sorted(prop.GetPosition() for prop in props if prop))
    assert found[0] == found[1]
    assert found[0]


def test_hardware_selection_finds_hidden_props_too():
    found = []
    for enabled in (False, True):
        window = make_window()
        renderer = renderers_of(window)[0]
        if enabled:
            vtknbuffer.enable(window)
        for i in range(3):
            look(window, i)
        selector = rendering.vtkHardwareSelector()
        selector.SetRenderer(renderer)
        selector.SetArea(0, 0, 199, 159)
        selection = selector.Select()
        prop = vtk("vtkCommonDataModel").vtkSelectionNode.PROP()
        found.append(sorted(selection.GetNode(i).GetProperties().Get(prop).GetPosition()
                            for i in range(selection.GetNumberOfNodes())))
    assert found[0] == found[1]
    assert len(found[0]) > 50


def add_pane_that_shows_a_volume(renderer):
    """A pane before the walls whose colors have the alpha of a volume."""
    data, volumes = vtk("vtkCommonDataModel"), vtk("vtkRenderingVolumeOpenGL2")
    volume = data.vtkImageData()
    volume.SetDimensions(8, 8, 8)
    volume.SetSpacing(2.0, 2.0, 2.0)
    volume.AllocateScalars(vtk("vtkCommonCore").VTK_UNSIGNED_CHAR, 4)
    values = vtk("util.numpy_support").vtk_to_numpy(volume.GetPointData().GetScalars())
    values[:] = [[200, 80, 40, 100]]
    pane = vtk("vtkFiltersSources").vtkPlaneSource()
    pane.SetOrigin(0.0, 0.0, 2.5)
    pane.SetPoint1(9.0, 0.0, 2.5)
    pane.SetPoint2(0.0, 9.0, 2.5)
    mapper = volumes.vtkOpenGLSurfaceProbeVolumeMapper()
    mapper.SetInputConnection(pane.GetOutputPort())
    mapper.SetSourceData(volume)
    actor = rendering.vtkActor()
    actor.SetMapper(mapper)
    renderer.AddActor(actor)


# Hazard: what is drawn late is missing behind an actor that blends in the opaque stage.
@pytest.mark.skipif(
    vtknbuffer._vtk_package != "vtkmodules" or
    not hasattr(vtk("vtkRenderingVolumeOpenGL2"), "vtkOpenGLSurfaceProbeVolumeMapper"),
    reason="this VTK has no such mapper")
def test_surfaces_that_show_a_volume_keep_their_place():
    stock, ours = make_window(), make_window()
    for window in (stock, ours):
        look(window, 0)
        without = image(window)
        add_pane_that_shows_a_volume(renderers_of(window)[0])
        look(window, 0)
        assert differing(without, image(window)) > 1000
    vtknbuffer.enable(ours)
    for i in range(6):
        look(stock, i)
        look(ours, i)
        assert differing(image(stock), image(ours)) == 0


# Hazard: a crash when the interpreter ends, or when one object outlives another.
def test_objects_are_dropped_in_every_order():
    begin = """
window = make_window()
renderer = renderers_of(window)[0]
culler = vtknbuffer.enable(window)
look(window, 0)
look(window, 1)
"""
    programs = {"-".join(order): f"""{begin}
objects = dict(culler=culler, renderer=renderer, window=window)
del culler, renderer, window
for name in {order!r}:
    del objects[name]
""" for order in itertools.permutations(("culler", "renderer", "window"))}
    programs["nothing is dropped"] = f"{begin}\nshadows = vtknbuffer.vtkShadowVolumeClampPass()"
    check_that_all_end("import vtknbuffer\nfrom conftest import look, make_window, renderers_of",
                       programs)


@pytest.mark.skipif(vtknbuffer._vtk_package != "vtkmodules", reason="scripts import vtkmodules")
def test_scripts_of_others_are_compared(tmp_path):
    """compare_scripts.py finds no difference in an example, and one where there is one."""
    source = pathlib.Path(__file__).resolve().parents[2]
    text = (source / "Examples/Python/plain_vtk.py").read_text().replace("range(10000)", "range(99)")
    honest, liar, shadow_liar = (tmp_path / name for name in ("honest.py", "liar.py", "other.py"))
    honest.write_text(text)
    for script, lie in (liar, "culler.GetEnabled()"), (shadow_liar, "bool(renderer.GetPass())"):
        script.write_text(text.replace("window.Render()", f"""
renderer.AddObserver(
    "StartEvent", lambda *_: renderer.SetBackground(float({lie}), 0.0, 0.0))
window.Render()
"""))
    compare = [sys.executable, source / "Testing/Python/compare_scripts.py"]
    done = subprocess.run([*compare, honest], capture_output=True, text=True)
    assert done.returncode == 0 and "16 frames, 0 frames that differ" in done.stdout
    done = subprocess.run([*compare, honest, liar], capture_output=True, text=True)
    assert done.returncode == 1 and "liar.py: 16 of 16 frames differ" in done.stdout
    done = subprocess.run([*compare, "--shadows", honest], capture_output=True, text=True)
    assert done.returncode == 0
    assert "4 frames, 0 frames that differ, 4 frames with shadows" in done.stdout
    done = subprocess.run([*compare, "--shadows", shadow_liar], capture_output=True, text=True)
    assert done.returncode == 1 and "other.py: 4 of 4 frames differ" in done.stdout
