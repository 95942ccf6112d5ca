// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Imported.h
 * @brief The actors of VTK's importers.
 */
#ifndef Imported_h
#define Imported_h

#include "vtkActor.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkImporter;

namespace NBufferExamples
{

/// What an importer that knows its file reads; empty if it reads nothing.
std::vector<vtkSmartPointer<vtkActor>> ImportActors(vtkImporter* importer);

} // namespace NBufferExamples

#endif
