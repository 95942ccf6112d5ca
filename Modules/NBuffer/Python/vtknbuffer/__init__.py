# SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
# SPDX-License-Identifier: BSD-3-Clause
"""Occlusion culling and exact hard shadows for VTK and PyVista.

``vtknbuffer.enable(renderer)`` adds a culler that draws only what can be seen; the image stays
the same to the bit. In PyVista it is ``plotter.nbuffer.enable()``, without any import.

The classes of the C++ module are here under their names, such as ``vtkNBufferCuller``.
"""

import json
import operator

from . import _backend

_module, _vtk_package = _backend.load()

vtkNBufferCuller = _module.vtkNBufferCuller
vtkNBufferDecision = _module.vtkNBufferDecision
vtkNBufferStatistics = _module.vtkNBufferStatistics
vtkNBufferTexture = _module.vtkNBufferTexture
vtkNBufferTuning = _module.vtkNBufferTuning
vtkNBufferVerdict = _module.vtkNBufferVerdict
vtkShadowStatistics = _module.vtkShadowStatistics
vtkShadowTuning = _module.vtkShadowTuning
vtkShadowVolumeClampPass = _module.vtkShadowVolumeClampPass

__all__ = [
    "configure",
    "disable",
    "enable",
    "find_culler",
    "get_settings",
    "statistics",
    "verdict",
    *(name for name in globals() if name.startswith("vtk")),
]

# The settings that are properties of the C++ classes, and the names of their values. All other
# settings are constants of the tuning (vtkNBufferTuning, vtkShadowTuning).
_PROPERTIES = {
    vtkNBufferCuller: {
        "enabled": None,
        "freeze": None,
        "backend": ("auto", "opengl", "cpu"),
        "test_slivers": None,
        "divide_props": None,
    },
    vtkShadowVolumeClampPass: {
        "mode": ("unclamped", "culled", "scissored", "clamped", "automatic"),
    },
}


def _camel_case(name):
    return "".join(word.capitalize() for word in name.split("_"))


def _snake_case(name):
    return "".join(f"_{c.lower()}" if c.isupper() else c for c in name).lstrip("_")


def _property_value(name, names, value):
    """Return the number that the C++ setter takes, or raise ValueError."""
    if names is None:
        if value not in (False, True):
            raise ValueError(f"{name} must be True or False, not {value!r}")
        return bool(value)
    if isinstance(value, str) and value.lower() in names:
        return names.index(value.lower())
    if hasattr(value, "__index__") and 0 <= operator.index(value) < len(names):
        return operator.index(value)
    raise ValueError(f"{name} must be one of {', '.join(names)}, not {value!r}")


def get_settings(target):
    """Return all settings of a culler or a shadow pass as a dict."""
    settings = {}
    for name, names in _properties(target).items():
        value = getattr(target, f"Get{_camel_case(name)}")()
        settings[name] = bool(value) if names is None else names[value]
    tuning = target.GetTuning()
    settings.update((_snake_case(name), tuning.Get(name)) for name in tuning.GetNames())
    return settings


def configure(target, **settings):
    """Change settings of a culler or a shadow pass.

    The names are those of the C++ setters and of the tuning in lower case, such as
    ``test_slivers=False`` or ``round_size=16``; ``get_settings()`` lists them. If a name or a
    value is wrong, TypeError or ValueError is raised, and no setting is changed.
    """
    properties = _properties(target)
    tuning = target.GetTuning()
    values = {}
    for name, value in settings.items():
        if name in properties:
            values[_camel_case(name)] = _property_value(name, properties[name], value)
        elif _camel_case(name) not in tuning.GetNames():
            raise TypeError(f"there is no setting {name}; there are "
                            f"{', '.join(get_settings(target))}")
        elif not -2**31 <= value < 2**31 or int(value) != value:
            raise ValueError(f"{name} must be a whole number of 32 bits, not {value!r}")
        elif not tuning.Set(_camel_case(name), int(value)):
            raise ValueError(f"{name} is a switch and must be 0 or 1, not {value!r}")
    fault = tuning.FindFault()
    if fault:
        raise ValueError(fault)
    target.SetTuning(tuning)
    for name, value in values.items():
        getattr(target, f"Set{name}")(value)


def _properties(target):
    for cls, properties in _PROPERTIES.items():
        if isinstance(target, cls):
            return properties
    raise TypeError(f"a vtkNBufferCuller or a vtkShadowVolumeClampPass is needed, not {target!r}")


def _renderers(target):
    """Return the renderers of a renderer or a render window."""
    if hasattr(target, "GetCullers"):
        return [target]
    if hasattr(target, "GetRenderers"):
        renderers = target.GetRenderers()
        return [renderers.GetItemAsObject(i) for i in range(renderers.GetNumberOfItems())]
    raise TypeError(f"a vtkRenderer or a vtkRenderWindow is needed, not {target!r}")


def find_culler(renderer):
    """Return the first vtkNBufferCuller of a renderer, or None."""
    cullers = renderer.GetCullers()
    for i in range(cullers.GetNumberOfItems()):
        culler = cullers.GetItemAsObject(i)
        if isinstance(culler, vtkNBufferCuller):
            return culler
    return None


def enable(target, **settings):
    """Add one culler to a renderer, or to all renderers that a render window has now.

    Where a renderer has a culler already, that one is used for all. Returns the culler. Settings
    are those of ``configure()``.
    """
    return _enable(_renderers(target), None, settings)


def _enable(renderers, culler, settings):
    """Do so with this culler, or with one that a renderer has or a new one if it is None."""
    cullers = [find_culler(renderer) for renderer in renderers]
    culler = culler or next(filter(None, cullers), None) or vtkNBufferCuller()
    configure(culler, **settings)
    for renderer, found in zip(renderers, cullers):
        if found is None:
            renderer.AddCuller(culler)
    return culler


def disable(target):
    """Remove the cullers of a renderer or of all renderers of a render window."""
    for renderer in _renderers(target):
        while (culler := find_culler(renderer)) is not None:
            renderer.RemoveCuller(culler)


def statistics(source, renderer=None):
    """Return the counts and times of the last frame as a dict.

    ``source`` is a vtkNBufferCuller or a vtkShadowVolumeClampPass. For a culler, ``renderer`` is
    one of its renderers; None is the one that was drawn last. The members are those of
    vtkNBufferStatistics and vtkShadowStatistics, and of their JSON.
    """
    _properties(source)
    if isinstance(source, vtkNBufferCuller):
        return json.loads(source.GetStatistics(renderer).GetAsJSON())
    if renderer is not None:
        raise TypeError("a shadow pass has the statistics of the last frame only")
    return json.loads(source.GetStatistics().GetAsJSON())


def verdict(culler, prop, renderer=None, part=None):
    """Return why a prop was drawn or not drawn in the last frame, such as "Hidden".

    The words are those of vtkNBufferVerdict. ``part`` is the number of an instance, a block, a
    triangle or a vertex of a large prop (``vtkNBufferCuller.GetVerdict``).
    """
    arguments = (renderer,) if part is None else (part, renderer)
    return vtkNBufferStatistics.GetName(culler.GetVerdict(prop, *arguments))
