// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file compare-images.cxx
 * @brief `nbuffer-compare-images BASELINE PICTURE [OTHER]`: PNG files.
 *
 * Succeeds if the picture is like the baseline, and the other, where there is one, is not.
 */
#include "ImageComparison.h"

#include <exception>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3 && argc != 4)
  {
    std::cerr << "usage: nbuffer-compare-images BASELINE PICTURE [OTHER]\n";
    return 2;
  }
  try
  {
    const vtkSmartPointer<vtkImageData> baseline = ReadPicture(argv[1]);
    bool passed = true;
    for (int i = 2; i < argc; ++i)
    {
      const double error = GetImageError(baseline, ReadPicture(argv[i]));
      const bool alike = error <= LargestImageError;
      std::cout << argv[i] << ": error " << error << (alike ? ", like " : ", unlike ") << argv[1]
                << "\n";
      passed = passed && alike == (i == 2);
    }
    return passed ? 0 : 1;
  }
  catch (const std::exception& error)
  {
    std::cerr << "nbuffer-compare-images: " << error.what() << "\n";
    return 2;
  }
}
