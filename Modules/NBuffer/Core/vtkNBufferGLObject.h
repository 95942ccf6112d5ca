// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkNBufferGLObject.h
 * @brief Owners of OpenGL objects.
 *
 * An owner is moved, never copied, and deletes its object when it is destroyed or assigned to. The
 * context of the object must be current then. If that context does not exist any more, neither does
 * the object: Delete(Context::Gone) forgets the name without a call of OpenGL.
 *
 * The module uses VTK's own classes where VTK itself uses the objects (the shadow masks are
 * vtkTextureObjects, because mappers sample them). In VTK 9.1 to 9.7 they are not sufficient here:
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
  Current, ///< It is the current context.
  Gone     ///< It does not exist any more.
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
 *     |                 |  the largest height so far
 *     +---------+       |
 *     |  image  |       |  An image may fill only the lower left part.
 *     +---------+-------+
 *       the largest width so far
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

  /// As Reserve(), for a colour format, and with a framebuffer that draws into the texture.
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

/// Set the parameters of the texture bound to `target` so that texelFetch() can read its level 0.
VTKNBUFFER_EXPORT void SetPlainSampling(unsigned int target);

}
VTK_ABI_NAMESPACE_END
#endif
