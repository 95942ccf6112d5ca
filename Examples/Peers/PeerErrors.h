// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PeerErrors.h
 * @brief Exceptions for what the device cannot do, and for errors of OpenGL.
 */
#ifndef PeerErrors_h
#define PeerErrors_h

#include "vtkNBufferGL.h"

#include <stdexcept>
#include <string>

namespace NBufferPeers
{

/// Throws std::runtime_error with this cause, if `done` is false.
inline void ThrowUnless(bool done, const std::string& why)
{
  if (!done)
  {
    throw std::runtime_error(why);
  }
}

/// Throws std::runtime_error if OpenGL has reported an error since vtkNBufferGL::ClearErrors().
inline void ThrowOnErrors(const char* where)
{
  std::string why;
  ThrowUnless(vtkNBufferGL::CheckErrors(where, why), why);
}

} // namespace NBufferPeers

#endif
