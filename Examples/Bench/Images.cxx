// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Images.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <filesystem>
#include <stdexcept>

namespace NBufferBench
{

vtkSmartPointer<vtkImageData> MakeImage(vtkUnsignedCharArray* rgba, int width, int height)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<unsigned char*>(image->GetScalarPointer());
  const unsigned char* from = rgba->GetPointer(0);
  const vtkIdType pixels = static_cast<vtkIdType>(width) * height;
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      to[3 * i + c] = from[4 * i + c];
    }
  }
  return image;
}

void WritePNG(vtkImageData* image, const std::string& fileName)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw std::runtime_error("cannot write " + fileName);
  }
}

void MakeFolder(const std::string& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
  {
    throw std::runtime_error("cannot make the folder " + folder + ": " + error.message());
  }
}

} // namespace NBufferBench
