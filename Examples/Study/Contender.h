// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Contender.h
 * @brief Ways to find which boxes of a frame are hidden, all behind one interface.
 *
 *     family    a DepthStructure
 *     position  the module's levels alone, and the place that keeps a box visible
 *     module    the test of vtkNBufferCuller with the same settings, which builds only the levels
 *               that it needs, with or without the second test of the pixels
 *     pixels    each pixel in the outline of the box, as by a hardware occlusion query
 */
#ifndef Contender_h
#define Contender_h

#include "DepthFrame.h"
#include "DepthStructure.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace NBufferStudy
{

struct ContestCounts
{
  long long Queries = 0; ///< Rectangles that were tested.
  long long Lookups = 0; ///< Texels and pixels that were read.
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

  /// Builds the structure from the depth of a frame.
  virtual void Build(const DepthFrame& frame) = 0;
  /// Returns whether a box of the frame is found hidden, and adds the work to `counts`.
  virtual bool IsHidden(const DepthFrame& frame, const DepthBox& box, ContestCounts& counts) = 0;

  ///@{
  /// Return the size of the structure that was built, in texels and in bytes.
  virtual std::size_t GetNumberOfTexels() const = 0;
  virtual std::size_t GetMemory() const = 0;
  ///@}

  /// Returns the number of pixels that are tested for the rectangle of a box, or 0 where that has
  /// no meaning.
  virtual long long GetCoveredArea(const DepthBox& /*box*/) const { return 0; }

private:
  std::string Name;
};

using ContenderPointer = std::unique_ptr<Contender>;

///@{
/// Make a contender of each kind.
ContenderPointer MakeFamilyContender(const DepthFamily& family);
ContenderPointer MakePositionContender(int factor);
ContenderPointer MakeModuleContender(int factor, bool testPixels);
ContenderPointer MakePixelContender();
///@}

/// Returns the name of the contender that has vtkNBufferCuller's default settings.
std::string GetDefaultName();

/// Makes all contenders of the study except those that need more than `megabytes` for a frame of
/// this size.
std::vector<ContenderPointer> MakeContenders(int width, int height, double megabytes);

} // namespace NBufferStudy

#endif
