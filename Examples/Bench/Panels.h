// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Panels.h
 * @brief Pictures that consist of several images.
 */
#ifndef Panels_h
#define Panels_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace NBufferBench
{

struct Panel
{
  vtkSmartPointer<vtkImageData> Picture;
  std::string Caption;
};

/// Returns images of one size in a row on white, each drawn `scale` times its size with
/// its caption below.
vtkSmartPointer<vtkImageData> ComposePanels(const std::vector<Panel>& panels, double scale);

} // namespace NBufferBench

#endif
