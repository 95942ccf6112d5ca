// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkShadowVolumeClampPass
 * @brief Exact hard shadows by stencil shadow volumes, drawn only where a receiver can be seen.
 *
 * Every light that is switched on, has an intensity above 0 and is not a headlight casts shadows:
 * directional lights, spots (with VTK's cone and exponent) and point lights. Props that the camera
 * does not see cast shadows, too. Shadows have the edges that a ray from every pixel to the light
 * would find, at any distance, in windows of any shape; there is no shadow map, whose resolution
 * would show.
 *
 * As the pass of a renderer it draws everything, and the stages after the opaque one as the
 * renderer does without a pass: with order-independent transparency or depth peeling, and FXAA.
 * (GetSteps() returns the stages. Ambient occlusion and the removal of hidden lines, which VTK
 * draws in the opaque stage, are left out.)
 *
 *     vtkNew<vtkShadowVolumeClampPass> shadows;
 *     renderer->SetPass(shadows);
 *
 * In a sequence of passes it draws the opaque props only, in the place of vtkOpaquePass:
 *
 *     vtkNew<vtkRenderPassCollection> passes;
 *     passes->AddItem(vtkSmartPointer<vtkLightsPass>::New());
 *     passes->AddItem(shadows);
 *     passes->AddItem(shadows->GetSteps()->GetTranslucentPass());
 *     sequence->SetPasses(passes);
 *     cameraPass->SetDelegatePass(sequence);
 *     renderer->SetPass(cameraPass);
 *
 * ## How
 *
 * The pass first draws only the depth of the opaque props. Then, for each light, it draws the
 * shadow volumes of the casters into the stencil buffer, and turns the stencil into one channel of
 * a mask. Then it draws the opaque props for the image. Their shaders (Phong and PBR) multiply each
 * light by 1 - vtkLight::GetShadowAttenuation() where its mask says that the light does not shine.
 * Where all lights shine, the colour is, to the bit, the one without the pass.
 *
 * Mode says how much of the volumes is drawn. A receiver is a sample of the image on which a shadow
 * may fall. For each light, the pass scatters the depths of the receivers into a litmap, an image
 * of the receivers as the light sees them (X. Decoret, "N-Buffers for efficient depth map query",
 * Computer Graphics Forum 24(3), 2005, section 3.3; vtkShadowLitmap.h says what differs). From the
 * litmap the pass knows which casters have no receiver. For the others it knows the boxes of pixels
 * of their receivers (mode Scissored) and the depths of their receivers, seen from the light (mode
 * Clamped). vtkShadowPlan.h has the rules.
 *
 * With multisampling, the masks and the depth of the receivers have the same samples as the
 * framebuffer that is drawn. A fragment gets the mean of the mask over the samples in which it is
 * seen, as if each of them had been shaded separately. (OpenGL before 4.0 without ARB_gpu_shader5
 * does not tell a shader which samples a fragment covers. All samples of the pixel that have the
 * depth of the fragment are used then.)
 *
 * ## Limits
 *
 * Casters are opaque surfaces of data sets, the blocks of composites of polydata, and the instances
 * of a vtkGlyph3DMapper with one source; GetStatistics() counts the other props by reason.
 * Wireframes and points cast no shadows. Surfaces cast shadows as if their textures had no alpha
 * and their shaders displaced no vertex. In mode Clamped the volumes of a point light are clamped
 * only if their caster lies in one face of the cube around the light. The pass needs OpenGL 3.2
 * with depth and stencil in one texture. If the shadows cannot be drawn, for example because an
 * OpenGL call fails, the frame is drawn without them, and the first such frame prints a warning
 * with the cause.
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
   *  - Unclamped: the whole volumes of all casters.
   *  - Culled: the whole volumes of casters that have a visible receiver. The image is the same, to
   *    the bit, as with Unclamped.
   *  - Scissored: the same volumes, inside boxes of pixels around their receivers only. The image
   *    is the same, to the bit, as with Unclamped.
   *  - Clamped: only the parts of these volumes in slabs, which are the ranges of light depth that
   *    have receivers. Samples within 1/256 of a pixel of a shadow's edge may differ.
   *  - Automatic, the default: Scissored for lights where that is likely to take less time
   *    (vtkShadowCostModel.h), Unclamped for the others. For a spot it then leaves out the casters
   *    that shadow nothing near its cone.
   */
  vtkSetClampMacro(Mode, int, Unclamped, Automatic);
  vtkGetMacro(Mode, int);
  ///@}

  ///@{
  /**
   * The constants that measurements and tests vary; see vtkShadowTuning. If a value is out of its
   * range, SetTuning() reports an error and changes nothing.
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
   *  - Litmaps: the litmap of the light as three squares, which show the nearest and the farthest
   *    receiver (bright: near to the light) and the number of occupied bins of each lexel. A point
   *    light has one row for each of its six litmaps. Nothing is shown if the light has no litmap
   *    (in mode Unclamped, and often in mode Automatic).
   *  - Extents: the boxes of pixels into which volumes are drawn, and for each pixel the number of
   *    boxes that contain it.
   *  - Volumes: the edges of the volumes' triangles in these boxes, blue where they are counted by
   *    z-pass, orange where they are counted by z-fail.
   *  - Counts: the number of fragments that volumes have in each pixel, whether or not the
   *    fragments pass the depth test.
   *
   * Numbers are shown as colours from blue (1) over cyan (4), green (16) and yellow (64) to red
   * (255 and more). A debug view costs a few full-screen images on the host each time that masks
   * are made.
   */
  void SetDebugView(int view, vtkLight* light = nullptr);
  vtkGetMacro(DebugView, int);
  vtkLight* GetDebugLight();
  ///@}

  ///@{
  /**
   * Whether a light casts shadows, if it is of a kind that can. Default: true for every light.
   * SetLightCasts() ignores nullptr.
   */
  void SetLightCasts(vtkLight* light, bool casts);
  bool GetLightCasts(vtkLight* light) const;
  ///@}

  ///@{
  /**
   * Only props whose property keys (vtkProp::SetPropertyKeys()) contain all of these keys cast
   * shadows. With nullptr, the default, all props do.
   */
  void SetCasterKeys(vtkInformation* keys);
  vtkInformation* GetCasterKeys();
  ///@}

  /// The stages (camera, lights, translucent props, ...) that the pass runs if it is the pass of a
  /// renderer and not a part of another pass. Its opaque stage is this pass itself.
  vtkRenderStepsPass* GetSteps();

  ///@{
  /// See vtkNBufferRenderPassTraits. The opaque props are drawn for their depth and for the image.
  std::vector<vtkRenderPass*> GetDelegatePasses() override;
  bool DrawsOpaquePropsTwice() const override { return true; }
  ///@}

  /// Counts and times of the last frame.
  const vtkShadowStatistics& GetStatistics() const;

  /**
   * Read back the mask of a light of the last frame: one value for each pixel of the viewport, row
   * by row, the lowest row first. 0 means that the sample is lit or that no opaque prop is seen
   * there; 255 means that it is in shadow. Where the light does not shine even without shadows (on
   * a surface that faces away from it, or outside of a spot's cone), the value may be either. With
   * multisampling, `sample` is a number below vtkShadowStatistics::Samples, or -1 for the mean over
   * the samples of each pixel. The result is empty, and `width` and `height` are 0, if the frame
   * was drawn without shadows of this light or there is no such sample. The window's context must
   * be current.
   */
  std::vector<unsigned char> GetMask(vtkLight* light, int& width, int& height, int sample = -1);

  /**
   * The debug view of the last frame: red, green, blue and opacity (0 to 255) of each pixel of the
   * viewport, row by row, the lowest row first; all four are 0 where it shows nothing. If there is
   * no debug view, the result is empty, and `width` and `height` are 0.
   */
  std::vector<unsigned char> GetDebugImage(int& width, int& height) const;

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /// Called by the mappers of the opaque props while this pass draws them.
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
