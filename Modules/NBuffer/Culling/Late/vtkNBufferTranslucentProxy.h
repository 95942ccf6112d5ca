// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferTranslucentProxy
 * @brief Represents one translucent prop, in the place of that prop in the renderer's list.
 *
 * The proxy draws its prop, or some units of it, only while it is open. It is open when the frame
 * begins, and the culler closes it when this frame's depth shows that the prop is hidden. A closed
 * proxy still says that it has translucent geometry, so that the renderer takes the same way
 * through its render passes as without the culler. README.md of this folder describes the whole
 * frame.
 */
#ifndef vtkNBufferTranslucentProxy_h
#define vtkNBufferTranslucentProxy_h

#include "vtkNBufferStandIn.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN

class vtkNBufferTranslucentProxy : public vtkNBufferStandIn
{
public:
  static vtkNBufferTranslucentProxy* New();
  vtkTypeMacro(vtkNBufferTranslucentProxy, vtkNBufferStandIn);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The proxies of one renderer. They are created once and used again in every frame.
   */
  class Pool
  {
  public:
    /// Begin a frame without proxies.
    void Clear() { this->Count = 0; }

    /// Get the next unused proxy and let it represent `prop` for one frame, without a reference.
    /// The props must be added in the order of their places.
    vtkNBufferTranslucentProxy* Add(int place, vtkProp* prop, bool open, Drawer drawer);

    /// Get the proxy of the prop in a place, or nullptr if it has none.
    vtkNBufferTranslucentProxy* Get(int place) const;

    /// Call visit(proxy) for each proxy of this frame.
    template <typename Function>
    void ForEach(const Function& visit) const
    {
      for (std::size_t n = 0; n < this->Count; ++n)
      {
        visit(this->Proxies[n].Get());
      }
    }

  private:
    std::vector<vtkSmartPointer<vtkNBufferTranslucentProxy>> Proxies;
    std::size_t Count = 0;
  };

  /// A closed proxy draws nothing in the translucent stage. Default: open.
  void SetOpen(bool open) { this->Open = open; }

  /// The place of the prop in the list of candidates.
  int GetPlace() const { return this->Place; }

  /// Whether the prop has been drawn in the translucent stage of this frame. A render pass that
  /// draws translucent props before opaque ones does so while the proxy is still open.
  bool HasDrawn() const { return this->Drawn; }

  double* GetBounds() VTK_SIZEHINT(6) override { return this->Prop->GetBounds(); }
  bool HasKeys(vtkInformation* keys) override { return this->Prop->HasKeys(keys); }
  vtkTypeBool HasOpaqueGeometry() override { return this->Prop->HasOpaqueGeometry(); }
  vtkTypeBool HasTranslucentPolygonalGeometry() override
  {
    return this->Prop->HasTranslucentPolygonalGeometry();
  }
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;

  ///@{
  /// Forwarded to the prop.
  void SetAllocatedRenderTime(double time, vtkViewport* viewport) override;
  void AddEstimatedRenderTime(double time, vtkViewport* viewport) override;
  ///@}

protected:
  vtkNBufferTranslucentProxy() = default;
  ~vtkNBufferTranslucentProxy() override = default;

  void ForEachDrawnProp(const std::function<void(vtkProp*)>& visit) override { visit(this->Prop); }

private:
  vtkNBufferTranslucentProxy(const vtkNBufferTranslucentProxy&) = delete;
  void operator=(const vtkNBufferTranslucentProxy&) = delete;

  int Place = -1;
  vtkProp* Prop = nullptr; ///< It is not counted as a reference.
  Drawer DrawProp;
  bool Open = true;
  bool Drawn = false;
};

VTK_ABI_NAMESPACE_END
#endif
