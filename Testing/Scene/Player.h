// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Player.h
 * @brief A stage that plays scenarios, frame by frame, with the culler or without.
 */
#ifndef Player_h
#define Player_h

#include "LightRig.h"
#include "Scenario.h"
#include "Stage.h"

#include <map>
#include <string>
#include <vector>

namespace TestScene
{
enum class Role
{
  Reference, ///< No culler at all.
  Stock,     ///< The scenario's own, but ours: what differs now is not our fault.
  Culled
};

class Player : public Stage
{
public:
  explicit Player(Role role)
    : Part(role)
  {
  }
  ~Player();
  Player(const Player&) = delete;
  void operator=(const Player&) = delete;

  /// Play this one from now on; the scenario must live until End(). A new window is only made
  /// where the old one cannot become like a new one.
  void Begin(const Scenario& scenario);

  /// Do what the scenario says before a frame. Returns what selections found.
  std::string Prepare(int frame);
  /// Which passes draw the next frame; to be called before each.
  void UsePasses(ShadowPasses passes = ShadowPasses::Lasting);

  /// Empty the window and keep it.
  void End();

  /// The next scenario gets a window, and with it a context, of its own.
  void DropWindow();

  const LightRig& GetLights() const { return this->Lighting; }

  /// The scenario that is played; nullptr before Begin() and after End().
  const Scenario* GetScenario() const { return this->Scene; }

private:
  void AddRenderers();
  void AddCullers();
  void JoinAndLeave(int frame);
  void Join(int prop, bool present);
  /// @name Changes of other kinds leave these as they are
  ///@{
  void ApplyToRenderer(const Change& change);
  void ApplyToWindow(const Change& change);
  void ApplyToCullers(const Change& change);
  void ApplyToProp(const Change& change);
  ///@}
  void Look(const View& view);
  std::string Select();

  const Role Part;
  const Scenario* Scene = nullptr;
  std::vector<vtkSmartPointer<vtkNBufferCuller>> Cullers; ///< One for each renderer, or the same.
  LightRig Lighting;
  std::vector<bool> Present; ///< Whether each prop is in its renderer.
  std::map<int, int> Places; ///< The index of each prop, by Id.
  int Frame = 0;
};
}

#endif
