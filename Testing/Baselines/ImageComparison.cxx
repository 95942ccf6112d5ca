// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageComparison.h"

#include "vtkImageDifference.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

double GetImageError(vtkImageData* first, vtkImageData* second)
{
  if (!std::equal(first->GetExtent(), first->GetExtent() + 6, second->GetExtent()))
  {
    return std::numeric_limits<double>::infinity();
  }
  vtkNew<vtkImageDifference> difference;
  difference->SetInputData(first);
  difference->SetImageData(second);
  difference->AllowShiftOff();
  difference->AveragingOff();
  difference->SetThreshold(PixelTolerance);
  difference->Update();
  return difference->GetThresholdedError();
}

vtkSmartPointer<vtkImageData> ReadPicture(const std::string& fileName)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(fileName.c_str()))
  {
    throw std::runtime_error("cannot read " + fileName);
  }
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetOutput();
}
