// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferTexture.h"
#include "vtkObjectFactory.h"
VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkNBufferTexture);
class vtkNBufferTexture::Internals
{
public:
  std::string Error;
};
vtkNBufferTexture::vtkNBufferTexture()
  : Implementation(new Internals)
{
}
vtkNBufferTexture::~vtkNBufferTexture() = default;
bool vtkNBufferTexture::Build(vtkOpenGLRenderWindow*, const vtkNBufferDepthSource&, int, int, int, int, int, int, vtkNBufferExtremum) { return false; }
bool vtkNBufferTexture::Download(vtkOpenGLRenderWindow*, vtkNBufferLevels&) { return false; }
int vtkNBufferTexture::GetWidth() const { return 0; }
int vtkNBufferTexture::GetHeight() const { return 0; }
int vtkNBufferTexture::GetNumberOfLevels() const { return 0; }
unsigned int vtkNBufferTexture::GetHandle() const { return 0; }
const std::string& vtkNBufferTexture::GetError() const { return this->Implementation->Error; }
double vtkNBufferTexture::GetDeviceTime() { return 0; }
void vtkNBufferTexture::ReleaseGraphicsResources(vtkWindow*) {}
void vtkNBufferTexture::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
VTK_ABI_NAMESPACE_END
