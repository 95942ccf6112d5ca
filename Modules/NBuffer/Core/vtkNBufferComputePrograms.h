// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferComputePrograms.h
 * @brief Compiles compute shaders, and restores the state that they need. VTK's shader cache has no
 * compute shaders.
 */
#ifndef vtkNBufferComputePrograms_h
#define vtkNBufferComputePrograms_h

#include "vtkNBufferGL.h"
#include "vtkNBufferGLObject.h"
#include "vtkNBufferModule.h" // For export macro

#include <cstddef>
#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
/// A compute shader, compiled once for each set of definitions.
class VTKNBUFFER_EXPORT ComputePrograms
{
public:
  /// The text of the shader, which must outlive this object.
  explicit ComputePrograms(const char* text)
    : Text(text)
  {
  }

  /// Returns why the current context has no compute shaders, or an empty text if it has.
  static std::string WhyNot();

  /**
   * Make a program the current one and return its name. `definitions` replace
   * "//VTK::NBuffer::Dec" in the shader's text, vtkNBufferShared.h "//VTK::NBuffer::Shared" and
   * vtkNBufferQuery.glsl "//VTK::NBuffer::Query".
   * Returns 0, with the cause in `why`, if the program does not compile. To be used within a
   * ScopedPass or a ScopedCompute.
   */
  unsigned int Use(std::string& why, const std::string& definitions = {});

  /// Delete the programs.
  void Delete(Context context = Context::Current);

private:
  const char* Text;
  std::map<std::string, unsigned int> Programs; ///< By their definitions.
};

/// While it lives, code may use compute shaders, bind buffers as shader storage (the first
/// `NumberOfBuffers` numbers), and bind array textures to the first two units.
class VTKNBUFFER_EXPORT ScopedCompute : public Scope
{
public:
  static constexpr unsigned int NumberOfBuffers = 5;

  ScopedCompute();
};

/// Bind a buffer as shader storage of this number.
VTKNBUFFER_EXPORT void BindStorage(unsigned int number, unsigned int buffer);

/// Give a buffer at least `bytes` bytes, copied from `data` unless that is nullptr. A buffer that
/// has them keeps its memory.
VTKNBUFFER_EXPORT void AllocateStorage(
  unsigned int buffer, std::size_t bytes, const void* data = nullptr);

/// The bytes of the largest buffer that shaders can use as a whole.
VTKNBUFFER_EXPORT std::size_t GetLargestStorage();
}
VTK_ABI_NAMESPACE_END
#endif
