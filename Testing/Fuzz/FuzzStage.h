// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file FuzzStage.h
 * @brief One window that plays scenarios, frame by frame, with the culler or without.
 */
#ifndef FuzzStage_h
#define FuzzStage_h

#include "FuzzLights.h"
#include "Scenario.h"

#include "vtkNBufferCuller.h"

#include "vtkProp.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace NBufferFuzz
{
enum class Role
{
  Reference, ///< No culler at all.
  Stock,     ///< The scenario's own, but ours: what differs now is not our fault.
  Culled
};

class Stage
{
public:
  explicit Stage(Role role)
    : Part(role)
  {
  }
  ~Stage();
  Stage(const Stage&) = delete;
  void operator=(const Stage&) = delete;

  /// Play this one from now on; the scenario must live until End(). A new window is only made
  /// where the old one cannot become like a new one.
  void Begin(const Scenario& scenario);

  /// Do what the scenario says before a frame. Returns what selections found.
  std::string Prepare(int frame);
  void Render(ShadowPasses passes = ShadowPasses::Lasting);

  /// Empty the window and keep it.
  void End();

  /// The next scenario gets a window, and with it a context, of its own.
  void DropWindow();

  vtkRenderWindow* GetWindow() const { return this->Window; }
  int GetNumberOfRenderers() const { return static_cast<int>(this->Renderers.size()); }
  vtkRenderer* GetRenderer(int i) const { return this->Renderers[i]; }
  /// nullptr while the renderer has none.
  vtkNBufferCuller* GetCuller(int renderer) const;
  const Lights& GetLights() const { return this->Lighting; }

  struct Member
  {
    const Prop* Description = nullptr;
    vtkSmartPointer<vtkProp> Object; ///< nullptr before its first frame.
    bool Present = false;
    bool Counted = false; ///< Draws of this kind of prop are announced.
    int Draws = 0;        ///< In this frame.
  };
  const std::vector<Member>& GetMembers() const { return this->Members; }

private:
  /// Props, passes and renderers that go delete their objects in the context that is current, some
  /// of VTK's without asking which it is: those of the other stage's window have the same names.
  void MakeCurrent();
  void AddRenderers();
  void AddCullers();
  void JoinAndLeave(int frame);
  void Join(Member& member, bool present);
  void Apply(const Change& change);
  void ApplyToWindow(const Change& change);
  void ApplyToCullers(const Change& change);
  void Look(const View& view);
  std::string Select();

  const Role Part;
  const Scenario* Scene = nullptr;
  vtkSmartPointer<vtkRenderWindow> Window;
  bool StencilCapable = false;
  std::vector<vtkSmartPointer<vtkRenderer>> Renderers;
  std::vector<vtkSmartPointer<vtkNBufferCuller>> Cullers; ///< One for each renderer, or the same.
  Lights Lighting;
  std::vector<Member> Members;
  std::map<int, std::size_t> Places; ///< Of props in Members, by Id.
  int Frame = 0;
};
}

#endif
