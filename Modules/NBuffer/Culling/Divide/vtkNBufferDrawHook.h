// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferDrawHook
 * @brief Lets a mapper draw only some of the primitives of an actor, from its own vertex buffers.
 *
 * vtkOpenGLPolyDataMapper calls SetShaderParameters() of the render passes in an actor's property
 * keys just before it binds its index buffer and draws (vtkNBufferDrawPass). The hook then draws
 * with another index buffer in the place of the mapper (vtkNBufferOwnDraw). Program, vertex buffers
 * and uniforms stay the same, so that each primitive has the same fragments, to the bit. No
 * subclass of a mapper is needed, and no shader is changed. What a mapper draws by one call of
 * OpenGL is called a stream here: a vtkOpenGLHelper, with an index buffer, a program and a vertex
 * array.
 *
 * If a mesh has scalars or normals of cells, the shader needs the number of each primitive. Ranges
 * of the mapper's own index buffer are then drawn instead.
 *
 * A prop is drawn whole while it changes; if it has strips or lines as well as polygons; if its
 * mapper is neither vtkPolyDataMapper nor vtkDataSetMapper nor vtkGlyph3DMapper nor
 * vtkPointGaussianMapper (vtkNBufferSplatStream) nor a mapper of composite data; and for some
 * frames if next to none of its units is hidden.
 *
 * Composite data may have strips and lines, because only whole blocks of it are left out.
 *
 * The hook works only while one of its own draws is running (the class Draw). All other draws of
 * the actor, by hardware selectors, other renderers or the application, draw the whole actor.
 */
#ifndef vtkNBufferDrawHook_h
#define vtkNBufferDrawHook_h

#include "vtkNBufferBlockStream.h"
#include "vtkNBufferInstanceStream.h"
#include "vtkNBufferOwnDraw.h"
#include "vtkNBufferResourceCallback.h"
#include "vtkNBufferUnitDevice.h"
#include "vtkNBufferUnits.h"

#include "vtkNew.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkNBufferDrawPass;
class vtkOpenGLGlyph3DHelper;
class vtkOpenGLHelper;
class vtkOpenGLPolyDataMapper;
class vtkOpenGLRenderWindow;
class vtkProp;
class vtkRenderer;
class vtkWindow;

class vtkNBufferDrawHook
{
public:
  /// `pass` must be in the property keys of the props that it draws.
  explicit vtkNBufferDrawHook(vtkNBufferDrawPass* pass);
  ~vtkNBufferDrawHook();
  vtkNBufferDrawHook(const vtkNBufferDrawHook&) = delete;
  void operator=(const vtkNBufferDrawHook&) = delete;

  /// What a mapper draws. Two draws with equal sources draw the same primitives in the same order.
  struct Source
  {
    const vtkObjectBase* Mapper = nullptr; ///< Only compared, never dereferenced.
    const vtkObjectBase* Data = nullptr;   ///< Only compared, never dereferenced.
    vtkMTimeType DataTime = 0;
    std::size_t IndexCount = 0;
    /// 3 for triangles, 1 for points, 2 for the boxes of instances (vtkNBufferInstanceStream) or
    /// blocks (vtkNBufferBlockStream), 0 for what cannot be divided.
    std::size_t Corners = 0;
    bool AreInstances = false; ///< Corners of boxes are those of instances.
    /// Whether the shader reads values by the numbers of primitives, for example values of cells.
    /// This depends on the shader alone, and operator== does not compare it.
    bool IsNumbered = false;
    bool HasIndices = true; ///< Whether VTK's draw has an index buffer. Not compared.

    bool HasBlocks() const { return this->Corners == 2 && !this->AreInstances; }

    bool operator==(const Source& other) const
    {
      return this->Mapper == other.Mapper && this->Data == other.Data &&
        this->DataTime == other.DataTime && this->IndexCount == other.IndexCount &&
        this->Corners == other.Corners;
    }
  };

  /// What a draw draws.
  enum List
  {
    Drawn, ///< The units that have been drawn in this frame.
    Fresh, ///< The units that are drawn next.
    Whole, ///< Everything; the draw may only read what is drawn.
    NumberOfLists = Whole
  };

  /// Begin a frame of a window. The buffers of the hook are released with its context. `device` is
  /// nullptr, or makes lists and tests units on the graphics device.
  void BeginFrame(vtkOpenGLRenderWindow* window, vtkNBufferUnitDevice* device);

  /// Let the next draw read what it draws, for GetSource() and TakeMesh().
  void ReadNext();

  ///@{
  /// What the last draw with ReadNext() has read. The source has no corners if the mapper draws
  /// something that cannot be divided, and no mapper if it has drawn nothing yet.
  const Source& GetSource() const { return this->Read; }
  vtkNBufferUnits::Mesh TakeMesh() { return std::move(this->Mesh); }
  const vtkNBufferInstanceStream& GetInstances() const { return this->Instances; }
  const vtkNBufferBlockStream& GetBlocks() const { return this->Blocks; }
  ///@}

  /// The device given to BeginFrame(), and what it keeps of the units.
  vtkNBufferUnitDevice* GetDevice() const { return this->Device; }
  vtkNBufferUnitDevice::Buffers& GetBuffersOnDevice() { return this->OnDevice; }

  /// Let draws of this list draw the primitives of the units that are marked. `units`, which are
  /// those of the mesh that was read last, must outlive the draws.
  void SetList(List list, const vtkNBufferUnits& units, const std::vector<unsigned char>& marked);

  /// While an object of this class exists, draws of the actor draw only a list, provided that they
  /// have the source that was read last. Otherwise they draw everything.
  class Draw
  {
  public:
    Draw(vtkNBufferDrawHook* hook, vtkActor* actor, List list);
    ~Draw();
    Draw(const Draw&) = delete;
    void operator=(const Draw&) = delete;

  private:
    vtkNBufferDrawHook* Hook;
  };

  /// Draw the actor. To be called while a Draw exists.
  int Render(vtkActor* actor, vtkRenderer* renderer);

  /// Whether a draw of a list drew everything, because the source has changed.
  bool IsStale() const { return this->Stale; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Buffer
  {
    vtkNew<vtkOpenGLIndexBufferObject> Object;
    vtkNBufferUnitDevice::List Draw;
    std::vector<unsigned char> Marked; ///< The units of which the list consists.
    /// The list, if primitives are numbered, or what the host makes it from.
    std::vector<vtkNBufferUnits::Range> Ranges;
    const vtkNBufferUnits* Units = nullptr; ///< All units of the mesh.
    bool IsOnDevice = false;                ///< Whether the device makes the list.
    bool IsPending = false;                 ///< Whether the next draw makes the list.
  };

  void BeforeDraw(vtkAbstractMapper* mapper, vtkProp* prop);
  void SetBlocks(vtkAbstractMapper* mapper);
  void SetInstances(vtkOpenGLGlyph3DHelper* mapper);
  void SetStream(vtkAbstractMapper* mapper);
  void ReadSource(vtkOpenGLPolyDataMapper* mapper, vtkOpenGLHelper* stream, const Source& source);
  bool IsAsRead(const Source& source);
  bool CanListOnDevice() const;
  /// See vtkNBufferInstanceStream::Maker.
  bool MakeList(const Buffer& buffer, const vtkNBufferUnits::Range& part,
    const std::vector<vtkNBufferUnitDevice::Records>& records, std::size_t indices,
    vtkNBufferUnitDevice::List& list);
  bool DrawIndices(Buffer& buffer, vtkOpenGLHelper* stream);
  void Restore();

  using Callback = vtkOpenGLResourceFreeCallback<vtkNBufferDrawHook>;
  vtkSmartPointer<vtkNBufferDrawPass> Pass;
  std::unique_ptr<Callback> Resources;
  std::array<Buffer, NumberOfLists> Buffers;
  vtkActor* Actor = nullptr; ///< Only compared; set while a Draw exists.
  List Current = Drawn;
  bool Reads = false;
  bool Stale = false;
  Source Read;
  vtkNBufferUnits::Mesh Mesh;
  vtkNBufferInstanceStream Instances;
  vtkNBufferBlockStream Blocks;
  vtkNBufferOwnDraw Own;
  vtkOpenGLRenderWindow* Window = nullptr;
  void* Context = nullptr; ///< A GLsync, which no context but that of the window knows.
  vtkNBufferUnitDevice* Device = nullptr;
  vtkNBufferUnitDevice::Buffers OnDevice;
};

VTK_ABI_NAMESPACE_END
#endif
