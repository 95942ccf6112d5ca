// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file GLStateSnapshot.h
 * @brief The OpenGL state that drawing depends on, for "is as it was" checks.
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
  /// Read the state of OpenGL, and what vtkOpenGLState has stored of it. The window's context must
  /// be current.
  static GLStateSnapshot Capture(vtkOpenGLRenderWindow* window);

  /// Lines of "name: this value, then the other's"; empty if all are equal.
  std::string GetDifference(const GLStateSnapshot& other) const;

  /// By name; "vtkOpenGLState " begins the names of what vtkOpenGLState remembers.
  const std::map<std::string, std::string>& GetValues() const { return this->Values; }

private:
  std::map<std::string, std::string> Values;
};

/**
 * Give all state that a full-screen pass has to care about values that would spoil one: a tiny
 * viewport and scissor, blending, culling of both faces, masks off, odd pack parameters, depth and
 * stencil tests that never pass. Only OpenGL gets these values, not
 * vtkOpenGLState.
 */
void SpoilGLState();

/// OpenGL's initial values for what SpoilGLState changes, except for viewport and scissor box.
void UnspoilGLState();

#endif
