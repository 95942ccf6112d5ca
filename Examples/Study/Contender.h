// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contender.h
 * @brief Ways of finding out which boxes of a frame are hidden, all behind one interface.
 *
 *     family    a DepthStructure; long boxes in up to `pieces` pieces (vtkNBufferSplitBox.h)
 *     position  PositionedLevels, which also say which pixel keeps a box visible
 *     module    what vtkNBufferCuller does with the same settings, level by level as needed,
 *               with or without the second look at the pixels
 *     pixels    every box by its outline, pixel by pixel: what a query of the hardware finds
 */
#ifndef Contender_h
#define Contender_h

#include "DepthFamily.h"
#include "DepthFrame.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace NBufferStudy
{

struct ContestCounts
{
  long long Queries = 0; ///< Rectangles queried.
  long long Lookups = 0; ///< Texels and pixels read.
};

class Contender
{
public:
  explicit Contender(const std::string& name)
    : Name(name)
  {
  }
  virtual ~Contender() = default;

  const std::string& GetName() const { return this->Name; }

  virtual void Build(const DepthFrame& frame) = 0;
  virtual bool IsHidden(const DepthFrame& frame, const DepthBox& box, ContestCounts& counts) = 0;

  ///@{
  /// After Build().
  virtual std::size_t GetNumberOfTexels() const = 0;
  virtual std::size_t GetMemory() const = 0;
  ///@}

  /// Pixels that the rectangle of a box is answered by; 0 where that has no meaning.
  virtual long long GetCoveredArea(const DepthBox& /*box*/) const { return 0; }

private:
  std::string Name;
};

using ContenderPointer = std::unique_ptr<Contender>;

ContenderPointer MakeFamilyContender(const DepthFamily& family, int pieces);
ContenderPointer MakePositionContender(int factor, int pieces);
ContenderPointer MakeModuleContender(int factor, int pieces, bool testPixels);
ContenderPointer MakePixelContender();

/// The name of the contender that has vtkNBufferCuller's default settings.
std::string GetDefaultName();

/// All that the study compares; none that needs more than `megabytes` for a frame of this size.
std::vector<ContenderPointer> MakeContenders(int width, int height, double megabytes);

} // namespace NBufferStudy

#endif
