// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolumeClampPass
 * @brief Exact hard shadows by stencil shadow volumes, drawn only where a receiver can be seen.
 *
 * Every switched-on light that is not a headlight casts: directional lights, spots (with VTK's cone
 * and exponent) and point lights. What the camera does not see casts all the same. Shadows have the
 * edges that a ray from every pixel to the light would find, at any distance, in windows of any
 * shape; there is no map whose resolution shows.
 *
 * As the pass of a renderer it draws everything, with the usual stages for camera, lights,
 * translucent props, volumes and overlays (GetSteps() has them):
 *
 *     vtkNew<vtkShadowVolumeClampPass> shadows;
 *     renderer->SetPass(shadows);
 *
 * In a sequence of passes it is the opaque stage, in the place of vtkOpaquePass:
 *
 *     vtkNew<vtkRenderPassCollection> passes;
 *     passes->AddItem(vtkSmartPointer<vtkLightsPass>::New());
 *     passes->AddItem(shadows);
 *     passes->AddItem(vtkSmartPointer<vtkTranslucentPass>::New());
 *     sequence->SetPasses(passes);
 *     cameraPass->SetDelegatePass(sequence);
 *     renderer->SetPass(cameraPass);
 *
 * ## How
 *
 * The opaque props are drawn into depth alone, then for each light the shadow volumes of the
 * casters into the stencil buffer, from which a mask with one channel for each light is made; then
 * the opaque props are drawn once, with shaders (Phong and PBR) that take from each light what its
 * mask does not let through: ShadowAttenuation of it. What is lit by all lights has, to the bit,
 * the colour that it has without the pass.
 *
 * Mode says how much of the volumes is drawn. The depth of the receivers is scattered into a litmap
 * for each light (X. Decoret, "N-Buffers for efficient depth map query", Computer Graphics Forum
 * 24(3), 2005, section 3.3; vtkShadowReceivers.h says what differs): from it Scissored knows which
 * casters have no receiver, and the box of pixels of those that have; Clamped, also the depths at
 * which they lie. vtkShadowPlan.h has the rules.
 *
 * With multisampling masks have the samples of the framebuffer that is drawn, and so has the depth
 * of the receivers. A fragment gets the mean of the mask over the samples in which it is seen,
 * as if each of them had been shaded by itself. (OpenGL before 4.0 without ARB_gpu_shader5 does not
 * say which it covers: then those of its depth are used.)
 *
 * ## Limits
 *
 * Casters are opaque surfaces of data sets or composites of polydata; GetStatistics() counts what
 * is not, by reason. Wireframes, points and glyphs cast nothing; textures with alpha and what
 * shaders displace cast as if they did not. Volumes of a point light are clamped if their caster
 * lies in one face of the cube around it. Needs OpenGL 3.2 with depth and stencil in one texture;
 * where anything is refused the frame is drawn without shadows, with one warning.
 *
 * Cost: two draws of the opaque props, a read-back of the depth (where litmaps are made), and the
 * volumes.
 */
#ifndef vtkShadowVolumeClampPass_h
#define vtkShadowVolumeClampPass_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferRenderPassTraits.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkShadowStatistics.h"
#include "vtkShadowTuning.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkInformation;
class vtkLight;
class vtkRenderStepsPass;

class VTKNBUFFER_EXPORT vtkShadowVolumeClampPass
  : public vtkOpenGLRenderPass
  , public vtkNBufferRenderPassTraits
{
public:
  static vtkShadowVolumeClampPass* New();
  vtkTypeMacro(vtkShadowVolumeClampPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Modes
  {
    Unclamped = int(vtkShadowMode::Unclamped),
    Culled = int(vtkShadowMode::Culled),
    Scissored = int(vtkShadowMode::Scissored),
    Clamped = int(vtkShadowMode::Clamped),
    Automatic = int(vtkShadowMode::Automatic)
  };

  ///@{
  /**
   * Mode says how much of the shadow volumes is drawn.
   *
   *  - Unclamped: all of every caster's volume.
   *  - Culled: the volumes of casters that have a visible receiver.
   *  - Scissored: these, inside boxes of pixels around their receivers. The picture is the one of
   *    Unclamped to the bit, as with Culled.
   *  - Clamped: slabs of these volumes around the receivers. Samples within 1/256 of a pixel of a
   *    shadow's edge may differ.
   *  - Automatic, the default: Scissored for lights where that is likely to take less time
   *    (vtkShadowCostModel.h), Unclamped for the others.
   */
  vtkSetClampMacro(Mode, int, Unclamped, Automatic);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * The constants that measurements and tests vary, in one call; see vtkShadowTuning. A value that
   * is out of its range is an error, and the tuning stays as it was.
   */
  void SetTuning(const vtkShadowTuning& tuning);
  const vtkShadowTuning& GetTuning() const { return this->Tuning; }
  ///@}

  enum DebugViews
  {
    NoDebugView = int(vtkShadowPicture::None),
    Litmaps = int(vtkShadowPicture::Litmaps),
    Extents = int(vtkShadowPicture::Extents),
    Volumes = int(vtkShadowPicture::Volumes),
    Counts = int(vtkShadowPicture::Counts)
  };

  ///@{
  /**
   * The debug view is drawn over the opaque props and shows what the shadows of one light cost.
   * `light` is that light, which is not owned; nullptr means the first one that casts. NoDebugView,
   * the default, costs nothing.
   *
   *  - Litmaps: squares for nearest and farthest receiver (bright: near to the light) and occupied
   *    bins of each lexel; a row for each of the six litmaps of a point light. Nothing where
   *    there are none (Unclamped).
   *  - Extents: the boxes of pixels into which volumes are drawn, and in how many a pixel is.
   *  - Volumes: the edges of the volumes' triangles in these boxes, blue where they are counted by
   *    z-pass, orange by z-fail.
   *  - Counts: how many fragments volumes have in each pixel, whatever the depth test says of them.
   *
   * Numbers are colours from blue (1) over cyan (4), green (16) and yellow (64) to red (255 and
   * more). Costs a few full-screen images on the host each time that masks are made.
   */
  void SetDebugView(int view, vtkLight* light = nullptr);
  vtkGetMacro(DebugView, int);
  vtkLight* GetDebugLight();
  ///@}

  ///@{
  /**
   * Whether a light casts, if it is of a kind that can; all do by default. nullptr is ignored.
   */
  void SetLightCasts(vtkLight* light, bool casts);
  bool GetLightCasts(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * Only props whose property keys (vtkProp::SetPropertyKeys) hold these keys cast; nullptr, the
   * default: all.
   */
  void SetCasterKeys(vtkInformation* keys);
  vtkInformation* GetCasterKeys();
  ///@}

  /// The stages of the pass where it is the renderer's own: camera, lights, translucent, ...
  vtkRenderStepsPass* GetSteps();

  ///@{
  /// See vtkNBufferRenderPassTraits. The opaque props are drawn for their depth and for the image.
  std::vector<vtkRenderPass*> GetDelegatePasses() override;
  bool DrawsOpaquePropsTwice() const override { return true; }
  ///@}

  /// Of the last frame.
  const vtkShadowStatistics& GetStatistics() const;

  /**
   * The mask of a light of the last frame: one value for each pixel of the viewport, row by row,
   * the lowest first; 0 lit or nothing opaque seen, 255 in shadow (also what the light does not
   * reach). With multisampling the mean of the
   * pixel's samples, or one of them: `sample` from 0 to less than vtkShadowStatistics::Samples.
   * Empty, and `width` and `height` 0, if the light did not cast or there is no such sample. Reads
   * it back; the window's context must be current.
   */
  std::vector<unsigned char> GetMask(vtkLight* light, int& width, int& height, int sample = -1);

  /**
   * The debug view of the last frame: red, green, blue and opacity of each pixel of the viewport,
   * row by row, the lowest first; all 0 where it shows nothing. Empty, and `width` and `height` 0,
   * if there is none.
   */
  std::vector<unsigned char> GetDebugImage(int& width, int& height) const;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /// Called by mappers.
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override;
  ///@}

protected:
  vtkShadowVolumeClampPass();
  ~vtkShadowVolumeClampPass() override;

private:
  vtkShadowVolumeClampPass(const vtkShadowVolumeClampPass&) = delete;
  void operator=(const vtkShadowVolumeClampPass&) = delete;

  class Internals;
  class OpaqueStage;
  void RenderOpaque(const vtkRenderState* s);

  int Mode = Automatic;
  vtkShadowTuning Tuning;
  int DebugView = NoDebugView;
  std::unique_ptr<Internals> Implementation;
};

VTK_ABI_NAMESPACE_END
#endif
