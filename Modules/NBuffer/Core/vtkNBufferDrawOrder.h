// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferDrawOrder.h
 * @brief Whether a prop needs the opaque stage to draw in the order of the renderer's list.
 *
 * A prop that is drawn late is missing from what the props after it in the list find. The image
 * shows that if one of them
 *
 *  - blends in the opaque stage. Actors and texts do if the application forces them to be opaque,
 *    and opaque actors with translucent back faces, selected cells, textures or scalars that VTK
 *    takes for opaque (vtkNBufferScalars::AreFaint()), or with shader code that sets the opacity of
 *    fragments. So do splats of vtkPointGaussianMapper that are emissive, less opaque at their
 *    borders, or have an array of opacities. VTK draws there slices of images, whatever their
 *    opacity (vtkImageSlice::HasTranslucentPolygonalGeometry()), the floor of a vtkSkybox, which
 *    fades out towards the horizon, surfaces of vtkOpenGLSurfaceProbeVolumeMapper, which may have
 *    the alpha of a volume, graphs, glyphs of composite data, whatever the opacity of a block, and
 *    the labels of vtkLabeledContourMapper, vtkFastLabeledDataMapper, vtkBatchedLabeledDataMapper
 *    and grid axes;
 *  - reads the depth there. vtkLabeledDataMapper updates its pipeline while it is drawn, and
 *    vtkSelectVisiblePoints in that pipeline compares points with what the window has drawn so far.
 */
#ifndef vtkNBufferDrawOrder_h
#define vtkNBufferDrawOrder_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

VTK_ABI_NAMESPACE_BEGIN
class vtkMapper;
class vtkProp;

namespace vtkNBufferDrawOrder
{
/// Whether a prop itself does one of these. The parts of an assembly are not looked at.
bool MattersTo(vtkProp* prop);

/// Whether a mapper has a selection, or still draws one.
bool DrawsSelection(vtkMapper* mapper);
}

VTK_ABI_NAMESPACE_END
#endif
