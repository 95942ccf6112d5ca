// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Player.h
 * @brief A stage that plays scenarios, frame by frame, with or without the culler.
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
  Reference, ///< Draws without any culler.
  Stock,     ///< Draws with VTK's own culler if the scenario keeps it, and without the culler under
             ///< test, which is then not to blame for differences from Reference.
  Culled     ///< Draws as Stock, and with the culler under test (vtkNBufferCuller).
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

  /// Begins a scenario, which must live until End(). Uses the window of the scenario before unless
  /// its settings cannot be changed to those of this scenario.
  void Begin(const Scenario& scenario);

  /// Applies the changes before a frame. Returns what its selections found, as text.
  std::string Prepare(int frame);
  /// Sets the shadow passes that draw the next frame. Must be called before each frame.
  void UsePasses(ShadowPasses passes = ShadowPasses::Lasting);

  /// Ends the scenario: empties the window and keeps it.
  void End();

  /// Ends the scenario, and destroys the window with its context.
  void DropWindow();

  const LightRig& GetLights() const { return this->Lighting; }

  /// Returns the scenario that is played; nullptr before Begin() and after End().
  const Scenario* GetScenario() const { return this->Scene; }

private:
  void AddRenderers();
  void AddCullers();
  void JoinAndLeave(int frame);
  void Join(int prop, bool present);
  /// @name Apply a change of their kind, and ignore other changes
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
  std::map<int, int> Places; ///< The index of each prop in Scenario::Props, by its Id.
  int Frame = 0;
};
}

#endif
