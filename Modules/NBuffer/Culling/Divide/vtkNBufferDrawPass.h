// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDrawPass
 * @brief A render pass in the property keys of large props, which their mappers call before they
 * draw.
 *
 * A mapper makes its shaders anew if the passes of an actor are not those of the last draw. What
 * its actors look like depends on when the shaders are made, and without the culler they would not
 * be made anew. Therefore:
 *
 * - Where the pass is added or removed, it is added to or removed from what the mapper knows of its
 *   last draws as well, so that it sees no difference: the pass changes no shader. (This is not
 *   possible for composite data and glyphs, whose internal mappers cannot be reached.)
 * - All large props of a window have the same pass, and so has an actor that begins to share the
 *   mapper of one of them. They keep it while they are in a renderer of the window and show the
 *   same mapper, whether they can be divided at the moment or not. Once actors use a mapper in
 *   several ways (KeepWhole()), its actors neither get the pass nor lose it.
 */
#ifndef vtkNBufferDrawPass_h
#define vtkNBufferDrawPass_h

#include "vtkMapper.h"
#include "vtkNBufferModule.h"     // For export macro
#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <map>
#include <memory>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkInformationIntegerKey;
class vtkProp;
class vtkWindow;

class VTKNBUFFER_EXPORT vtkNBufferDrawPass : public vtkOpenGLRenderPass
{
public:
  static vtkNBufferDrawPass* New();
  vtkTypeMacro(vtkNBufferDrawPass, vtkOpenGLRenderPass);

  /// The pass of a window, which is created if no other code holds a reference to it.
  static vtkSmartPointer<vtkNBufferDrawPass> Get(vtkWindow* window);

  ///@{
  /// Add the pass to the property keys of an actor, or remove it after as many calls of Detach() as
  /// of Attach(): an actor may be in several renderers of the window. Detach() does nothing if the
  /// mapper is kept whole, because the pass that goes is a reason to make shaders anew as well.
  void Attach(vtkActor* actor);
  void Detach(vtkActor* actor);
  ///@}

  /// Add the pass again to the property keys of an attached actor if the application has replaced
  /// or cleared them. Returns whether it was missing.
  bool AttachAgain(vtkActor* actor);

  /// Whether an attached actor shows another mapper than when it got the pass. It should be
  /// detached then, and attached again where it is still large.
  bool HasOtherMapper(vtkActor* actor) const;

  /// Give the pass of a window to those of the props that have begun to share the mapper of an
  /// actor that has it. For frames in which nothing looks for large props. They are attached
  /// later, or lose the pass when no attached actor has their mapper any more (Detach()).
  static void Follow(vtkWindow* window, vtkProp** props, int count);

  /// Whether the pass is attached to an actor with this mapper, or was when the mapper drew last:
  /// then the mapper would make its shaders anew if it drew without the pass. The last draw is not
  /// known for composite data and glyphs.
  bool IsUsedBy(vtkMapper* mapper) const;

  ///@{
  /// Mark a mapper that must not get a reason to make its shaders anew: that of an actor whose uses
  /// are mixed (vtkNBufferSharedState), or which has this mapper in common with a part of an
  /// assembly (VTK gives the parts the property keys of the assembly, so that they cannot have the
  /// pass). The mark stays when the other actor is hidden or uses the object in the same way,
  /// because VTK goes on with the shaders that the mapper has made.
  static void KeepWhole(vtkMapper* mapper);
  static bool IsKeptWhole(vtkMapper* mapper);
  ///@}

  /// Set what to do before a mapper draws a prop, or nullptr.
  void SetCallback(std::function<void(vtkAbstractMapper*, vtkProp*)> callback)
  {
    this->Callback = std::move(callback);
  }

  /// Called by a mapper just before it draws.
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO) override;

  /// A pass in a prop's property keys is never rendered itself.
  void Render(const vtkRenderState*) override {}

protected:
  vtkNBufferDrawPass() = default;
  ~vtkNBufferDrawPass() override;

private:
  vtkNBufferDrawPass(const vtkNBufferDrawPass&) = delete;
  void operator=(const vtkNBufferDrawPass&) = delete;

  static vtkInformationIntegerKey* KEPT_WHOLE(); ///< In the information of a marked mapper.

  struct User
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkWeakPointer<vtkMapper> Mapper; ///< Its mapper when it got the pass.
    int Count = 0; ///< How often it is attached. 0 for an actor that Follow() has found.
  };

  struct Registry;
  static const std::shared_ptr<Registry>& GetRegistry();

  /// The actor's entry, new and with the pass in the actor's keys if there was none, or if it is
  /// for another mapper.
  User& AddUser(vtkActor* actor);
  /// Remove the pass from the keys of an actor that is no user any more, and, if no user has got
  /// the pass with the same mapper, from what this mapper knows of its last draws.
  void RemoveFrom(const User& user);
  /// Remove the pass from the actors that Follow() has found, except where an attached actor has
  /// the same mapper, or the mapper is kept whole.
  void RemoveFromFollowers();

  std::shared_ptr<Registry> Owner; ///< The passes of all windows, kept until the last pass ends.
  vtkWindow* Window = nullptr;     ///< The key of this pass in the registry.
  std::function<void(vtkAbstractMapper*, vtkProp*)> Callback;
  std::map<vtkActor*, User> Users; ///< If an actor has been deleted, its User::Actor is null.
  bool HasFollowers = false;       ///< Whether Follow() may have found some of them.
  std::size_t UsersToCheck = 16;   ///< From this number on, deleted actors are removed.
};

VTK_ABI_NAMESPACE_END
#endif
