// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDrawPass
 * @brief A render pass in the property keys of large props, which their mappers call before they
 * draw.
 *
 * A mapper makes its shaders anew if the passes of an actor are not those of the last draw. Actors
 * that share a mapper share its shaders as well, and what they see depends on when these are made.
 * Therefore all large props of a renderer have the same pass, and so has an actor that begins to
 * share the mapper of one of them. They keep it while they are in the renderer, whether they can be
 * divided at the moment or not.
 */
#ifndef vtkNBufferDrawPass_h
#define vtkNBufferDrawPass_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN
#include "vtkOpenGLRenderPass.h"

#include <functional>
#include <utility>

class vtkProp;

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferDrawPass : public vtkOpenGLRenderPass
{
public:
  static vtkNBufferDrawPass* New();
  vtkTypeMacro(vtkNBufferDrawPass, vtkOpenGLRenderPass);

  ///@{
  /// Add the pass to the property keys of a prop, or remove it.
  void Attach(vtkProp* prop);
  void Detach(vtkProp* prop);
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
  ~vtkNBufferDrawPass() override = default;

private:
  vtkNBufferDrawPass(const vtkNBufferDrawPass&) = delete;
  void operator=(const vtkNBufferDrawPass&) = delete;

  std::function<void(vtkAbstractMapper*, vtkProp*)> Callback;
};

VTK_ABI_NAMESPACE_END
#endif
