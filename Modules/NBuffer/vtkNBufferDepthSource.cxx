// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDepthSource.h"
VTK_ABI_NAMESPACE_BEGIN
bool vtkNBufferDepthSource::Inspect(vtkOpenGLRenderWindow*, std::string&) { return false; }
bool vtkNBufferDepthSource::Read(vtkOpenGLRenderWindow*, int, int, int, int, std::vector<float>&, std::string&) const { return false; }
VTK_ABI_NAMESPACE_END
