// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Panels.h
 * @brief Pictures beside each other, each with a line of text.
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
  vtkSmartPointer<vtkImageData> Image;
  std::string Caption;
};

/// All images have the size of the first; each is drawn `scale` times its size, with its caption
/// below.
vtkSmartPointer<vtkImageData> ComposePanels(const std::vector<Panel>& panels, double scale);

} // namespace NBufferBench

#endif
