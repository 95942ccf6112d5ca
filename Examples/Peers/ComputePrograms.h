// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class ComputePrograms
 * @brief A compute shader, compiled once for each set of definitions. VTK's shader cache has no
 * compute shaders.
 */
#ifndef ComputePrograms_h
#define ComputePrograms_h

#include <map>
#include <string>

namespace NBufferPeers
{

class ComputePrograms
{
public:
  /// The text of the shader, which must outlive this object.
  explicit ComputePrograms(const char* text)
    : Text(text)
  {
  }

  /// Returns why the current context has no compute shaders, or an empty text if it has.
  static std::string WhyNot();

  /// Makes a program the current one and returns its name; `definitions` replace
  /// "//VTK::NBuffer::Dec" in the shader's text. Returns 0, with the cause in `why`, if the program
  /// does not compile.
  unsigned int Use(std::string& why, const std::string& definitions = {});

  /// Deletes the programs.
  void Delete();

private:
  const char* Text;
  std::map<std::string, unsigned int> Programs; ///< By their definitions.
};

} // namespace NBufferPeers

#endif
