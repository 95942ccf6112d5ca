// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Viridis.h
 * @brief The colours of images of numbers.
 */
#ifndef Viridis_h
#define Viridis_h

#include "vtkColorTransferFunction.h"
#include "vtkSmartPointer.h"

namespace NBufferBench
{

/// Samples of the map "viridis" over [0, 1], from dark to light.
vtkSmartPointer<vtkColorTransferFunction> MakeViridis();

} // namespace NBufferBench

#endif
