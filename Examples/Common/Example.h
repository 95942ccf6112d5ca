// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Example.h
 * @brief What the programs of the examples share: options, a window, pictures.
 */
#ifndef Example_h
#define Example_h

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkActor;
class vtkNBufferCuller;
class vtkPolyData;
class vtkShadowVolumeClampPass;

// CLI11 takes longer to compile than all that an example does: Example.cxx alone includes it.
namespace CLI
{
class App;
}

namespace NBufferExamples
{

class Example
{
public:
  /// Makes a program with the options --out, --size and --no-FEATURE, such as --no-shadows.
  Example(const std::string& description, const std::string& feature);
  ~Example();

  /// Adds an option of the program's own: a number (int or double) between `lowest` and `highest`
  /// that Run() writes to `value`, which must outlive the example. The former content of `value` is
  /// the default.
  template <typename Number>
  void AddOption(
    const std::string& name, Number& value, const std::string& help, Number lowest, Number highest);

  /// Parses the options, calls `show`, and returns the result of main(): not 0 for wrong options
  /// and for exceptions of `show`, whose text is written to stderr.
  int Run(int argc, char* argv[], const std::function<void()>& show);

  /// Returns the renderer of the scene. It has only the lights that are added.
  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// Returns false after --no-FEATURE, which draws the scene to compare with.
  bool IsOn() const { return this->On; }

  using Triple = std::array<double, 3>;
  using Boxes = std::vector<std::pair<Triple, Triple>>; ///< Centres and sizes.

  ///@{
  /// Add an actor with an ambient part of 0.25; colours from 0 to 1.
  vtkActor* AddMesh(vtkPolyData* mesh, const Triple& color);
  vtkActor* AddCuboid(const Triple& centre, const Triple& size, const Triple& color);
  vtkActor* AddGlobe(const Triple& centre, double radius, const Triple& color);
  ///@}

  /// Adds boxes of one colour. All of them together are turned about the z axis by `turn` degrees,
  /// then moved by (x, y).
  void AddCuboids(
    const Triple& color, const Boxes& boxes, double x = 0.0, double y = 0.0, double turn = 0.0);

  /// Adds a weak light from the eye, which casts no shadow, so that shadows are not black.
  void AddFill(double intensity);

  /**
   * With --out, writes OUT/`picture`.png; without it, opens a window until the user closes it.
   * Throws std::runtime_error if the picture cannot be written. Given a pass, it also prints the
   * statistics of the pass and throws if the picture lacks the shadows that it should have.
   */
  void Show(const std::string& picture, vtkShadowVolumeClampPass* pass = nullptr);

  /**
   * Draws frames with and without a culler of the renderer, by turns, once the culler has divided a
   * large prop. `setCamera` is called with the number of each frame. Prints the milliseconds and
   * the units of each frame, the medians, and how many bytes of the images differ. Throws
   * std::runtime_error if any do. After --no-FEATURE it draws each frame twice without the culler.
   */
  void Compare(vtkNBufferCuller* culler, int frames, const std::function<void(int)>& setCamera);

private:
  void PrepareWindow(const std::string& name);

  std::unique_ptr<CLI::App> App;
  std::string Out;
  std::array<int, 2> Size = { 960, 720 };
  bool On = true;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

} // namespace NBufferExamples

#endif
