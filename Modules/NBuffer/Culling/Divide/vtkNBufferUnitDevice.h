// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferUnitDevice
 * @brief Compute shaders for large props: test their units, and make the lists of what is drawn.
 *
 * Both take the host long: a test of 40,000 units takes some 10 ms, and a list of a million
 * triangles has 12 MB to upload. Here 2 bits for each node of the units are read back, and one bit
 * for each unit is uploaded. What that gains has not been measured on a device.
 *
 * What is drawn is the same as with the lists of the host: the units that the host would find
 * visible (vtkNBufferUnitCS.glsl computes what vtkNBufferProjection computes), and their primitives
 * in the order of drawing (vtkNBufferListCS.glsl).
 *
 * All other functions require that Begin() has returned true in the current context. They restore
 * the state of OpenGL that they change.
 */
#ifndef vtkNBufferUnitDevice_h
#define vtkNBufferUnitDevice_h

#include "vtkNBufferBackend.h"
#include "vtkNBufferBox.h"
#include "vtkNBufferComputePrograms.h"
#include "vtkNBufferGLObject.h"
#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferProjection.h"
#include "vtkNBufferResourceCallback.h"
#include "vtkNBufferUnitAnswers.h"
#include "vtkNBufferUnits.h"

#include "vtkType.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkNBufferLevels;
class vtkNBufferTexture;
class vtkOpenGLRenderWindow;
class vtkWindow;

class VTKNBUFFER_EXPORT vtkNBufferUnitDevice
{
public:
  /// What the device keeps of the units of one prop, and buffers that are used again and again. To
  /// be deleted when the units change.
  struct Buffers
  {
    vtkNBufferGL::Buffer Boxes;   ///< Of the nodes that are tested.
    vtkNBufferGL::Buffer Answers; ///< See vtkNBufferUnitAnswers.
    vtkNBufferGL::Buffer Table;   ///< The unit of each primitive, if the units are groups in space.
    vtkNBufferGL::Buffer Marks;   ///< One bit for each unit.
    vtkNBufferGL::Buffer Sums;    ///< One number for each work group.

    void Delete();
  };

  vtkNBufferUnitDevice();
  ~vtkNBufferUnitDevice();
  vtkNBufferUnitDevice(const vtkNBufferUnitDevice&) = delete;
  void operator=(const vtkNBufferUnitDevice&) = delete;

  /// Begin a frame of a window, whose context must be current. Returns whether the device is to do
  /// what this class does: not with the CPU back-end, nor with Auto on a software renderer. If it
  /// cannot, GetError() says why.
  bool Begin(vtkOpenGLRenderWindow* window, vtkNBufferBackend::Kind backend);
  const std::string& GetError() const { return this->Error; }

  /// Whether the device can test so many units.
  bool CanTest(std::size_t units) const { return units <= this->LargestNumberOfUnits; }

  /**
   * Test the nodes of all levels that have answers. `texture` has the same texels as `levels`,
   * which are those of the viewport of `projection`. Of `rounding` only Origin, Magnitude and
   * Margin are used; those of all boxes are the same. `sampleDistance` is that of
   * vtkNBufferOcclusionTest. Waits for the device.
   */
  void Test(const vtkNBufferUnits& units, Buffers& buffers, const vtkNBufferProjection& projection,
    const vtkNBufferBox& rounding, const vtkNBufferTexture* texture, const vtkNBufferLevels& levels,
    double sampleDistance, vtkNBufferUnitAnswers& answers);

  /// What glDrawElementsIndirect() draws.
  struct Command
  {
    std::uint32_t Count = 0;
    std::uint32_t Instances = 1;
    std::uint32_t FirstIndex = 0;
    std::uint32_t BaseVertex = 0;
    std::uint32_t BaseInstance = 0;
  };

  /// How a list of primitives is drawn.
  struct List
  {
    vtkNBufferGL::Buffer Object; ///< A Command, if the device has made the list.
    Command OfHost;              ///< If the host has made it.

    /// Whether there may be anything to draw; only the device knows whether a list that it has made
    /// has any primitives.
    bool MayDraw() const
    {
      return this->Object.GetName() != 0 || (this->OfHost.Count > 0 && this->OfHost.Instances > 0);
    }

    /// Draw the list, when everything else has been bound for glDrawElements().
    void Draw(unsigned int mode) const;

    /// Draw what this command says from now on.
    void SetCommand(const Command& command)
    {
      this->Object.Delete();
      this->OfHost = command;
    }
  };

  /// A buffer with a record for each primitive, and the one to which those of the list are copied.
  struct Records
  {
    unsigned int Source;
    unsigned int Target;
    unsigned int Words; ///< The number of 32-bit words of a record.
  };

  ///@{
  /// Whether answers of the device have been compared with those of the host, which is done once
  /// for each context, and whether they were the same. (Mesa 22.3 rounds some doubles wrongly.)
  bool IsChecked() const { return this->Checked; }
  bool IsRight() const { return this->Right; }
  void SetChecked(bool isRight)
  {
    this->Checked = true;
    this->Right = isRight;
  }
  ///@}

  /// Whether the device can copy records from a buffer of so many bytes.
  bool CanCopy(std::size_t bytes) const { return bytes <= this->LargestBuffer; }

  /// Make a list of the primitives in `part` whose units are marked by 1. Each of them is drawn by
  /// so many indices, as an instance if `areInstances` is true. A buffer of Records has one record
  /// for each primitive of the part.
  void MakeList(const vtkNBufferUnits& units, const std::vector<unsigned char>& marked,
    Buffers& buffers, const vtkNBufferUnits::Range& part, const std::vector<Records>& records,
    std::size_t indices, bool areInstances, List& list);

private:
  void Prepare();
  void ReleaseGraphicsResources(vtkWindow* window);

  using Callback = vtkOpenGLResourceFreeCallback<vtkNBufferUnitDevice>;
  std::unique_ptr<Callback> Resources;
  vtkNBufferGL::ComputePrograms Tests;
  vtkNBufferGL::ComputePrograms Lists;
  vtkMTimeType ContextTime = 0; ///< The context of which the members below tell.
  bool IsSoftware = false;      ///< Found out once, so that Begin() calls no OpenGL later.
  bool Prepared = false;        ///< Whether Error has been found.
  std::string Error;
  std::size_t LargestBuffer = 0; ///< In bytes.
  std::size_t LargestNumberOfUnits = 0;
  bool Checked = false;
  bool Right = true;
};

VTK_ABI_NAMESPACE_END
#endif
