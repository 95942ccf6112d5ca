// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGLObject.h
 * @brief Owners of OpenGL objects.
 *
 * An owner is moved, never copied, and deletes its object when it is destroyed or assigned to: the
 * context of the object must be current then. Where that context is already gone, the object has
 * gone with it: Delete(Context::Gone) gives the name up without a call of OpenGL.
 *
 * VTK's own classes serve where their objects are handed on to VTK (the shadow masks are
 * vtkTextureObjects, because mappers sample them). They do not serve here, from VTK 9.1 to 9.7:
 *
 *     vtkTextureObject            prints errors instead of returning them, takes texture units,
 *                                 and cannot allocate empty array textures before VTK 9.3
 *     vtkOpenGLFramebufferObject  attaches no layer of an array, and no depth with stencil in 9.1
 *     vtkOpenGLBufferObject       knows no GL_PIXEL_PACK_BUFFER
 */
#ifndef vtkNBufferGLObject_h
#define vtkNBufferGLObject_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace vtkNBufferGL
{
/// The state of the context to which objects belong.
enum class Context
{
  Current,
  Gone
};

enum class ObjectType
{
  Buffer,
  Framebuffer,
  Query,
  Texture,
  VertexArray
};

/**
 * The owner of one OpenGL object.
 */
class VTKNBUFFER_EXPORT Object
{
public:
  ~Object() { this->Delete(); }
  Object(Object&& other) noexcept;
  Object& operator=(Object&& other) noexcept;

  /// The object's name; the first call generates it.
  unsigned int Create();

  /// The object's name; 0 before Create().
  unsigned int GetName() const { return this->Name; }

  /// Delete the object, if there is one.
  void Delete(Context context = Context::Current);

protected:
  explicit Object(ObjectType type)
    : Type(type)
  {
  }

private:
  ObjectType Type;
  unsigned int Name = 0;
};

template <ObjectType type>
class TypedObject : public Object
{
public:
  TypedObject()
    : Object(type)
  {
  }
};
using Buffer = TypedObject<ObjectType::Buffer>;
using Framebuffer = TypedObject<ObjectType::Framebuffer>;
using Query = TypedObject<ObjectType::Query>;
using Texture = TypedObject<ObjectType::Texture>;
using VertexArray = TypedObject<ObjectType::VertexArray>;

/**
 * A GL_TEXTURE_2D with a single level, whose texels shaders fetch one by one. It grows and never
 * shrinks, and what it holds is undefined after it has grown:
 *
 *     +-----------------+
 *     |                 |  GetHeight()
 *     +---------+       |
 *     |  image  |       |  An image may fill the lower left part only.
 *     +---------+-------+
 *       GetWidth()
 */
class VTKNBUFFER_EXPORT GrowingTexture
{
public:
  /**
   * Make room for width x height texels of a sized format (GL_R32F, GL_DEPTH_COMPONENT24, ...).
   * Returns false, with the cause in `why`, if OpenGL refuses; the texture has no texels then. The
   * texture bound to the active unit stays bound.
   */
  bool Reserve(unsigned int format, int width, int height, std::string& why);

  /// As Reserve(), for a format of colours, and with a framebuffer that draws into the texture.
  bool ReserveTarget(unsigned int format, int width, int height, std::string& why);

  /// The name of the texture; 0 before Reserve().
  unsigned int GetName() const { return this->Texture.GetName(); }

  /// The name of a framebuffer whose only attachment is the texture; 0 before ReserveTarget().
  unsigned int GetFramebuffer() const { return this->Framebuffer.GetName(); }

  /// How often memory was requested from OpenGL since construction.
  int GetNumberOfAllocations() const { return this->Allocations; }

  /// Delete the objects.
  void Delete(Context context = Context::Current);

private:
  vtkNBufferGL::Texture Texture;
  vtkNBufferGL::Framebuffer Framebuffer;
  unsigned int Format = 0;
  int Width = 0;
  int Height = 0;
  int Allocations = 0;
};

/// Set the parameters of the texture bound to `target` with which texelFetch() reads its level 0.
VTKNBUFFER_EXPORT void SetPlainSampling(unsigned int target);

}
VTK_ABI_NAMESPACE_END
#endif
// VTK-HeaderTest-Exclude: vtkNBufferGLObject.h
