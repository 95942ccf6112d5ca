// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ShadowExample.h
 * @brief What the programs that show shadows share: options, a window, pictures.
 */
#ifndef ShadowExample_h
#define ShadowExample_h

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
class vtkPolyData;
class vtkShadowVolumeClampPass;

// CLI11 takes longer to compile than all that an example does: ShadowExample.cxx alone includes it.
namespace CLI
{
class App;
}

namespace NBufferExamples
{

class ShadowExample
{
public:
  /// A program with the options --out, --size and --no-shadows.
  explicit ShadowExample(const std::string& description);
  ~ShadowExample();

  ///@{
  /// Add an option of the program's own: a number between `lowest` and `highest` that Run() writes
  /// to `value`, which must outlive the example. What `value` holds before is the default.
  void AddOption(
    const std::string& name, double& value, const std::string& help, double lowest, double highest);
  void AddOption(
    const std::string& name, int& value, const std::string& help, int lowest, int highest);
  ///@}

  /// Parses the options, then calls `show`. Returns what main has to: not 0 for options that cannot
  /// be understood and for exceptions of `show`, whose text is written to stderr.
  int Run(int argc, char* argv[], const std::function<void()>& show);

  /// Where the scene goes. It has no light but what is added.
  vtkRenderer* GetRenderer() { return this->Renderer; }

  /// False after --no-shadows, which draws what the shadows are to be compared with.
  bool HasShadows() const { return this->Shadows; }

  using Triple = std::array<double, 3>;
  using Boxes = std::vector<std::pair<Triple, Triple>>; ///< Centres and sizes.

  ///@{
  /// Add an actor with an ambient part of 0.25; colours from 0 to 1.
  vtkActor* AddMesh(vtkPolyData* mesh, const Triple& color);
  vtkActor* AddBox(const Triple& centre, const Triple& size, const Triple& color);
  vtkActor* AddBall(const Triple& centre, double radius, const Triple& color);
  ///@}

  /// Add boxes of one colour, all of them turned about the z axis (degrees), then moved to (x, y).
  void AddBoxes(
    const Triple& color, const Boxes& boxes, double x = 0.0, double y = 0.0, double turn = 0.0);

  /// Add a weak light from the eye, which casts no shadow, so that shadows are not black.
  void AddFill(double intensity);

  /**
   * With --out, write OUT/`picture`.png and print the statistics of the pass. Without it, open a
   * window, until the user closes it. Throws std::runtime_error if the picture cannot be written or
   * lacks the shadows that were asked for.
   */
  void Show(const std::string& picture, vtkShadowVolumeClampPass* pass);

private:
  std::unique_ptr<CLI::App> App;
  std::string Out;
  int Size[2] = { 960, 720 };
  bool Shadows = true;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

} // namespace NBufferExamples

#endif
