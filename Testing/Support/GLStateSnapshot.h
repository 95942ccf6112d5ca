// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLStateSnapshot.h
 * @brief The OpenGL state that drawing depends on, to check that something has not changed it.
 *
 *     const GLStateSnapshot before = GLStateSnapshot::Capture(window);
 *     DoSomething();
 *     EXPECT_EQ(before.GetDifference(GLStateSnapshot::Capture(window)), "");
 */
#ifndef GLStateSnapshot_h
#define GLStateSnapshot_h

#include <map>
#include <string>

class vtkOpenGLRenderWindow;

class GLStateSnapshot
{
public:
  /// Reads the state of OpenGL, and the copies of it in vtkOpenGLState. The window's context must
  /// be current.
  static GLStateSnapshot Capture(vtkOpenGLRenderWindow* window);

  /// Returns a line "name: VALUE, then VALUE OF OTHER" for each value that differs; "" if none
  /// does.
  std::string GetDifference(const GLStateSnapshot& other) const;

  /// Returns all values by name. Names of values in vtkOpenGLState begin with "vtkOpenGLState ".
  const std::map<std::string, std::string>& GetValues() const { return this->Values; }

private:
  std::map<std::string, std::string> Values;
};

/**
 * Gives all state that a full-screen pass depends on values with which it would draw nothing or
 * something wrong: a viewport and a scissor box of one pixel, blending, culling of both faces,
 * masks that are off, odd pack parameters, depth and stencil tests that never pass. vtkOpenGLState
 * does not learn these values.
 */
void SpoilGLState();

/// Gives what SpoilGLState() changes OpenGL's initial values, except for viewport and scissor box.
void UnspoilGLState();

#endif
