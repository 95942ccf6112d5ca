# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""``plotter.nbuffer``: culling and shadows for every PyVista plotter.

PyVista 0.48 and later finds this module by itself. With older versions, import it once:

>>> import vtknbuffer.pyvista
"""

import functools
import importlib

import numpy as np
import pyvista

import vtknbuffer


# What vtkGlyph3DMapper and vtkPointGaussianMapper have and vtkMapper does not.
_GLYPH_SETTINGS = (
    "Scaling", "ScaleMode", "ScaleFactor", "Range", "Clamping", "Orient", "OrientationMode",
    "SourceIndexing", "UseSourceTableTree", "Masking", "ScaleArray", "ScaleArrayComponent",
    "SplatShaderCode", "Emissive", "TriangleScale")


def _rendering_core():
    return importlib.import_module(f"{vtknbuffer._vtk_package}.vtkRenderingCore")


def _color_blocks(mapper, color_of):
    """Give each block of composite data the color that color_of(its flat index) returns."""
    attributes = _rendering_core().vtkCompositeDataDisplayAttributes()
    blocks = mapper.GetInputDataObject(0, 0).NewIterator()
    blocks.InitTraversal()
    while not blocks.IsDoneWithTraversal():
        block = blocks.GetCurrentDataObject()
        attributes.SetBlockVisibility(
            block, mapper.GetBlockVisibility(blocks.GetCurrentFlatIndex()))
        attributes.SetBlockColor(block, color_of(blocks.GetCurrentFlatIndex()))
        blocks.GoToNextItem()
    mapper.SetCompositeDataDisplayAttributes(attributes)


def _copy_mapper(mapper):
    """Return a mapper that draws the same, in one color. VTK's ShallowCopy() leaves out the rest."""
    copy = mapper.NewInstance()
    copy.ShallowCopy(mapper)
    for port in range(mapper.GetNumberOfInputPorts()):
        for i in range(mapper.GetNumberOfInputConnections(port)):
            copy.AddInputConnection(port, mapper.GetInputConnection(port, i))
    for name in _GLYPH_SETTINGS:
        if hasattr(mapper, f"Set{name}") and hasattr(mapper, f"Get{name}"):
            getattr(copy, f"Set{name}")(getattr(mapper, f"Get{name}")())
    arrays = _rendering_core().vtkMapper.INPUT_ARRAYS_TO_PROCESS()
    if mapper.GetInformation().Has(arrays):
        copy.GetInformation().CopyEntry(mapper.GetInformation(), arrays)
    copy.ScalarVisibilityOff()
    return copy


class NBuffer:
    """Culling and shadows of one plotter, for all of its subplots.

    >>> plotter = pyvista.Plotter()
    >>> plotter.nbuffer.enable()
    """

    def __init__(self, plotter):
        self._plotter = plotter
        self._culler = None
        self._shadows = {}

    def _renderers(self):
        if getattr(self._plotter, "_closed", False) or self._plotter.render_window is None:
            raise RuntimeError("the plotter is closed; make a new one")
        return list(self._plotter.renderers)

    @property
    def culler(self):
        """The vtkNBufferCuller, or None before enable() and after disable()."""
        return self._culler

    def enable(self, **settings):
        """Draw only what can be seen, in all subplots. The image stays the same to the bit.

        Settings are those of ``vtknbuffer.configure()``; usually there is nothing to set. Calling
        it again changes the settings only. A subplot that has a culler already gets no other one.
        """
        self._culler = vtknbuffer._enable(self._renderers(), self._culler, settings)
        return self._culler

    def disable(self):
        """Draw everything again. Does nothing if the culler is not enabled."""
        if self._culler is not None:
            for renderer in self._renderers():
                renderer.RemoveCuller(self._culler)
            self._culler = None

    def _enabled_culler(self):
        self._renderers()
        if self._culler is None:
            raise RuntimeError("call nbuffer.enable() first")
        return self._culler

    @property
    def statistics(self):
        """Counts and times of the last frame of the active subplot, as a dict."""
        return vtknbuffer.statistics(self._enabled_culler(), self._plotter.renderer)

    def verdict(self, actor):
        """Return why an actor was drawn or not drawn in the last frame, such as "Hidden".

        ``actor`` is an actor or the name of one. If several subplots have it, the first one in
        which it was drawn or culled counts.
        """
        culler = self._enabled_culler()
        if isinstance(actor, str):
            named = [r.actors[actor] for r in self._renderers() if actor in r.actors]
            if not named:
                raise ValueError(f"the plotter has no actor of the name {actor!r}")
            actor = named[0]
        words = [vtknbuffer.verdict(culler, actor, r) for r in self._renderers()]
        return next((word for word in words if word != "Unknown"), "Unknown")

    def freeze(self, frozen=True):
        """Keep the verdicts of the last frame while the camera moves, to look at them from elsewhere.

        The image may then lack what the frozen view did not see.
        """
        self._enabled_culler().SetFreeze(frozen)

    def show_culled(self, cpos=None, color="red", drawn_color="lightgray", show=True, **options):
        """Show what the last frame of the active subplot left out in red, from a second view.

        Of composite data it shows which blocks these are.

        The second view is a plotter of its own, which is returned; it also shows the frustum of
        the camera. Its camera stands obliquely above the scene, or at ``cpos``. Further options are
        those of ``pyvista.Plotter``. With ``show=False`` the window is not opened.
        """
        culler = self._enabled_culler()
        renderer = self._plotter.renderer
        options.setdefault("off_screen", self._plotter.off_screen)
        second = pyvista.Plotter(**options)
        colors = {culled: pyvista.Color(name).float_rgb
                  for culled, name in ((True, color), (False, drawn_color))}
        core = _rendering_core()
        actors = renderer.GetActors()
        actors.InitTraversal()
        while (actor := actors.GetNextActor()) is not None:
            if (actor.GetMapper() is None or not actor.GetVisibility()
                    or not actor.GetMapper().GetNumberOfInputConnections(0)):
                continue
            def color_of(part=None, actor=actor):
                word = vtknbuffer.verdict(culler, actor, renderer, part)
                return colors[word in ("Hidden", "Outside", "Unknown")]

            mapper = _copy_mapper(actor.GetMapper())
            if (hasattr(mapper, "SetBlockColor")
                    and mapper.GetInputDataObject(0, 0).IsA("vtkCompositeDataSet")):
                _color_blocks(mapper, color_of)
            copy = core.vtkActor()
            copy.SetMapper(mapper)
            copy.SetUserMatrix(actor.GetMatrix())
            copy.GetProperty().SetColor(color_of())
            second.add_actor(copy, reset_camera=False, render=False)
        width, height = renderer.GetSize()
        second.add_mesh(self._plotter.camera.view_frustum(width / max(height, 1)),
                        style="wireframe", color="black", reset_camera=False, render=False)
        if cpos is None:
            camera = renderer.GetActiveCamera()
            second.view_vector(np.subtract(camera.GetViewUp(), camera.GetDirectionOfProjection()),
                               camera.GetViewUp())
            second.reset_camera(bounds=renderer.ComputeVisiblePropBounds())
        else:
            second.camera_position = cpos
        if show:
            second.show()
        return second

    def enable_shadows(self, **settings):
        """Draw exact hard shadows of all lights that are not headlights, in all subplots.

        Settings are those of ``vtknbuffer.configure()`` for a vtkShadowVolumeClampPass, such as
        ``mode="clamped"``. Returns the pass of the active subplot. Other passes of PyVista (SSAO,
        eye-dome lighting, PyVista's own shadows, ...) cannot be combined with it.
        """
        renderers = self._renderers()
        passes = {}
        for renderer in renderers:
            shadows = self._shadows.get(renderer) or vtknbuffer.vtkShadowVolumeClampPass()
            if renderer.GetPass() not in (None, shadows):
                raise RuntimeError(
                    f"a subplot has a render pass already ({renderer.GetPass().GetClassName()}); "
                    "disable it before you enable these shadows")
            vtknbuffer.configure(shadows, **settings)
            passes[renderer] = shadows
        for renderer, shadows in passes.items():
            renderer.SetPass(shadows)
        self._shadows = passes
        return passes[self._plotter.renderer]

    def disable_shadows(self):
        """Remove the shadows. Does nothing if they are not enabled."""
        for renderer, shadows in self._shadows.items():
            if renderer.GetPass() is shadows:
                renderer.SetPass(None)
        self._shadows = {}

    @property
    def shadow_statistics(self):
        """Counts and times of the shadows of the active subplot's last frame, as a dict."""
        self._renderers()
        if self._plotter.renderer not in self._shadows:
            raise RuntimeError("call nbuffer.enable_shadows() first")
        return vtknbuffer.statistics(self._shadows[self._plotter.renderer])

    def __plotter_close__(self):
        """PyVista calls this before it closes the plotter."""
        self.disable_shadows()
        self.disable()


def _register():
    if hasattr(pyvista, "register_plotter_component"):
        pyvista.register_plotter_component("nbuffer")(NBuffer)
        return
    # PyVista before 0.48 has no components: an attribute that is made when it is first used.
    attribute = functools.cached_property(NBuffer)
    attribute.__set_name__(pyvista.BasePlotter, "nbuffer")
    pyvista.BasePlotter.nbuffer = attribute


_register()
