// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferDrawOrder.h"

#include "vtkNBufferProtectedMembers.h"
#include "vtkNBufferScalars.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkMapper.h"
#include "vtkMapper2D.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPointGaussianMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkSelectVisiblePoints.h"
#include "vtkShaderProperty.h"
#include "vtkSkybox.h"
#include "vtkTextActor3D.h"
#include "vtkTexture.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
/// Whether the colors of a texture have an alpha below 1. VTK does not look at those that it maps,
/// to which the table's own alpha is applied, and at the border.
bool IsFaint(vtkTexture* texture)
{
  vtkScalarsToColors* table = texture ? texture->GetLookupTable() : nullptr;
  return texture &&
    (texture->IsTranslucent() || (table && (!table->IsOpaque() || table->GetAlpha() < 1.0)) ||
      (texture->GetWrap() == vtkTexture::ClampToBorder && texture->GetBorderColor()[3] < 1.0F));
}

/// Whether textures of a property, which VTK does not look at, may make fragments translucent.
bool HasFaintTextures(vtkProperty* property)
{
  const char* const names[] = { "normalTex", "materialTex", "brdfTex", "emissiveTex",
    "anisotropyTex", "coatNormalTex" };
  const std::map<std::string, vtkTexture*>& textures = property->GetAllTextures();
  return std::any_of(textures.begin(), textures.end(),
    [&](const auto& item)
    {
      const auto& [name, texture] = item;
      const bool isColor = name == "albedoTex"
        ? property->GetInterpolation() == VTK_PBR
        : std::find(std::begin(names), std::end(names), name) == std::end(names);
      return isColor && IsFaint(texture);
    });
}

/// Whether an actor that is opaque (vtkActor::HasOpaqueGeometry()), which may be by force, has
/// colors with an alpha below 1. VTK does not look at back faces, and at the color of selected
/// cells.
bool HasFaintColors(vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  vtkProperty* back = actor->GetBackfaceProperty();
  vtkMapper* mapper = actor->GetMapper();
  const bool isForced = actor->GetForceOpaque() &&
    (property->GetOpacity() < 1.0 || (mapper && mapper->HasTranslucentPolygonalGeometry()));
  const bool isSelected =
    mapper && property->GetSelectionColor()[3] < 1.0 && vtkNBufferDrawOrder::DrawsSelection(mapper);
  return isForced || isSelected || (back && back->GetOpacity() < 1.0) ||
    IsFaint(actor->GetTexture()) || HasFaintTextures(property) ||
    (mapper && vtkNBufferScalars::AreFaint(mapper));
}

/// Whether shader code of the application may set the opacity of fragments. Code may put a name
/// together from parts (# and \\).
bool SetsOpacity(const std::string& code)
{
  const char* const names[] = { "opacity", "FragData", "fragOutput", "#", "\\" };
  return std::any_of(std::begin(names), std::end(names),
    [&code](const char* name) { return code.find(name) != std::string::npos; });
}

/// Whether shader code of the application may make the fragments of an actor translucent.
bool HasShadersWithOpacity(vtkActor* actor)
{
  vtkShaderProperty* shaders = vtkNBufferProtectedMembers::GetShaderProperty(actor);
  bool setsOpacity = shaders && shaders->HasFragmentShaderCode();
  for (int i = 0; shaders && i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    std::string name;
    std::string code;
    bool isFirst;
    bool isForAll;
    shaders->GetNthShaderReplacement(i, name, isFirst, code, isForAll);
    setsOpacity = setsOpacity ||
      (shaders->GetNthShaderReplacementTypeAsString(i) == "Fragment" && SetsOpacity(code));
  }
  return setsOpacity;
}

/// Whether an actor draws splats that blend. Without code of the application, the opacity of a
/// splat falls with the distance from its middle.
bool DrawsFaintSplats(vtkActor* actor)
{
  const auto hasText = [](const char* text) { return text && *text != '\0'; };
  auto* mapper = vtkPointGaussianMapper::SafeDownCast(actor->GetMapper());
  if (!mapper)
  {
    return false;
  }
  const char* code = mapper->GetSplatShaderCode();
  const bool isFaint = mapper->GetScaleFactor() != 0.0 && (!hasText(code) || SetsOpacity(code));
  return mapper->GetEmissive() || hasText(mapper->GetOpacityArray()) || isFaint;
}

/// Whether a mapper draws glyphs of composite data with blocks of an opacity, which VTK does not
/// look at.
bool DrawsFaintGlyphs(vtkMapper* mapper)
{
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  auto* attributes = glyphs && !mapper->GetInput() ? glyphs->GetBlockAttributes() : nullptr;
  return attributes && attributes->HasBlockOpacities();
}

/// Whether an actor is the floor of a skybox, which fades out towards the horizon.
bool IsFadingFloor(vtkActor* actor)
{
  auto* skybox = vtkSkybox::SafeDownCast(actor);
  return skybox && skybox->GetProjection() == vtkSkybox::Floor;
}

/// Whether a mapper draws labels, colors with the alpha of a volume, or translucent actors of a
/// graph.
bool Blends(vtkMapper* mapper)
{
  const char* const names[] = { "vtkLabeledContourMapper", "vtkFastLabeledDataMapper",
    "vtkOpenGLSurfaceProbeVolumeMapper", "vtkGraphMapper" };
  return mapper &&
    std::any_of(std::begin(names), std::end(names),
      [mapper](const char* name) { return mapper->IsA(name) != 0; });
}

/// Whether all colors of a slice are opaque. Lookup tables and other mappers may make an alpha.
bool HasOpaqueColors(vtkImageSlice* slice)
{
  auto* mapper = vtkImageSliceMapper::SafeDownCast(slice->GetMapper());
  vtkImageProperty* property = slice->GetProperty();
  if (!mapper || !mapper->GetInput() || property->GetOpacity() < 1.0 || property->GetLookupTable())
  {
    return false;
  }
  slice->Update();
  const int components = mapper->GetInput()->GetNumberOfScalarComponents();
  return components == 1 || components == 3;
}

/// Whether vtkSelectVisiblePoints is among the filters that lead to an algorithm.
bool SelectsVisiblePoints(vtkAlgorithm* algorithm)
{
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* producer = algorithm->GetInputAlgorithm(port, i);
      if (producer &&
        (vtkSelectVisiblePoints::SafeDownCast(producer) || SelectsVisiblePoints(producer)))
      {
        return true;
      }
    }
  }
  return false;
}
}

bool vtkNBufferDrawOrder::MattersTo(vtkProp* prop)
{
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    if (actor->IsA("vtkFlagpoleLabel"))
    {
      // This forces the actors in it. The label itself has a translucent texture and is not forced.
      return actor->GetForceOpaque();
    }
    return actor->HasOpaqueGeometry() &&
      (HasFaintColors(actor) || HasShadersWithOpacity(actor) || DrawsFaintSplats(actor) ||
        DrawsFaintGlyphs(actor->GetMapper()) || IsFadingFloor(actor) || Blends(actor->GetMapper()));
  }
  // Their labels are no props of the renderer.
  if (prop->IsA("vtkGridAxesActor3D") || prop->IsA("vtkGridAxesActor2D"))
  {
    return true;
  }
  if (auto* slice = vtkImageSlice::SafeDownCast(prop))
  {
    return !slice->HasTranslucentPolygonalGeometry() && !HasOpaqueColors(slice);
  }
  if (auto* text = vtkTextActor3D::SafeDownCast(prop))
  {
    return text->GetForceOpaque();
  }
  if (auto* text = vtkBillboardTextActor3D::SafeDownCast(prop))
  {
    return text->GetForceOpaque();
  }
  auto* label = vtkActor2D::SafeDownCast(prop);
  vtkMapper2D* mapper = label ? label->GetMapper() : nullptr;
  return mapper &&
    (mapper->IsA("vtkBatchedLabeledDataMapper") ||
      (mapper->IsA("vtkLabeledDataMapper") && SelectsVisiblePoints(mapper)));
}

bool vtkNBufferDrawOrder::DrawsSelection(vtkMapper* mapper)
{
  auto* drawn = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  return mapper->GetSelection() || (drawn && vtkNBufferProtectedMembers::DrawsSelection(drawn));
}
VTK_ABI_NAMESPACE_END
