// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferUnitDevice.h"

#include "vtkNBufferListCS.h"
#include "vtkNBufferTexture.h"
#include "vtkNBufferUnitCS.h"

#include "vtkOpenGLRenderWindow.h"

#include <algorithm>
#include <cstddef>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
// What a work group of the shaders has.
constexpr std::size_t NodesPerGroup = NBUFFER_GROUP;
constexpr std::size_t PrimitivesPerGroup = NBUFFER_GROUP * NBUFFER_OF_EACH;

/// The largest number of work groups that OpenGL guarantees.
constexpr std::size_t LargestNumberOfGroups = 65535;

// The numbers of the buffers in the shaders.
enum TestBuffer : unsigned int
{
  BoxBuffer,
  AnswerBuffer
};
enum ListBuffer : unsigned int
{
  MarkBuffer,
  TableBuffer,
  SumBuffer,
  SourceBuffer,
  TargetBuffer,
  CommandBuffer = SourceBuffer
};

const std::string CountDefinition = "#define NBUFFER_COUNT\n";
const std::string AddDefinition = "#define NBUFFER_ADD\n";
const std::string CopyDefinition = "#define NBUFFER_COPY\n";
const std::string RunsDefinition = "#define NBUFFER_RUNS\n";

void SetUnsigned(unsigned int program, const char* name, std::size_t value)
{
  glUniform1ui(glGetUniformLocation(program, name), static_cast<GLuint>(value));
}

void SetInteger(unsigned int program, const char* name, int value)
{
  glUniform1i(glGetUniformLocation(program, name), value);
}

void SetVector(unsigned int program, const char* name, const glm::dvec3& value)
{
  glUniform3dv(glGetUniformLocation(program, name), 1, glm::value_ptr(value));
}

void Dispatch(std::size_t size, std::size_t perGroup)
{
  glDispatchCompute(static_cast<GLuint>((size + perGroup - 1) / perGroup), 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

std::vector<std::uint32_t> GetBits(const std::vector<unsigned char>& marked)
{
  std::vector<std::uint32_t> bits((marked.size() + 31) / 32);
  for (std::size_t i = 0; i < marked.size(); ++i)
  {
    bits[i / 32] |= static_cast<std::uint32_t>(marked[i] != 0) << (i % 32);
  }
  return bits;
}
}

void vtkNBufferUnitDevice::Buffers::Delete()
{
  for (vtkNBufferGL::Buffer* buffer :
    { &this->Boxes, &this->Answers, &this->Table, &this->Marks, &this->Sums })
  {
    buffer->Delete();
  }
}

vtkNBufferUnitDevice::vtkNBufferUnitDevice()
  : Resources(new Callback(this, &vtkNBufferUnitDevice::ReleaseGraphicsResources))
  , Tests(vtkNBufferUnitCS)
  , Lists(vtkNBufferListCS)
{
}

vtkNBufferUnitDevice::~vtkNBufferUnitDevice()
{
  this->Resources->Release();
}

bool vtkNBufferUnitDevice::Begin(vtkOpenGLRenderWindow* window, vtkNBufferBackend::Kind backend)
{
  if (this->ContextTime != window->GetContextCreationTime())
  {
    this->Tests.Delete(vtkNBufferGL::Context::Gone);
    this->Lists.Delete(vtkNBufferGL::Context::Gone);
    this->ContextTime = window->GetContextCreationTime();
    this->IsSoftware = vtkNBufferGL::GetSoftwareRenderer() != nullptr;
    this->Prepared = this->Checked = false;
    this->Right = true;
  }
  if (backend == vtkNBufferBackend::CPU || (backend == vtkNBufferBackend::Auto && this->IsSoftware))
  {
    return false;
  }
  if (!this->Prepared)
  {
    this->Resources->RegisterGraphicsResources(window);
    this->Prepared = true;
    this->Prepare();
  }
  return this->Error.empty();
}

void vtkNBufferUnitDevice::Prepare()
{
  this->Error = vtkNBufferGL::ComputePrograms::WhyNot();
  if (this->Error.empty() && !vtkNBufferGL::HasFeature(4, 0, "GL_ARB_gpu_shader_fp64"))
  {
    this->Error = "tests of units need OpenGL 4.0 or GL_ARB_gpu_shader_fp64";
  }
  if (this->Error.empty() && !vtkNBufferGL::ComputesDoubles())
  {
    this->Error = "Mesa's softpipe computes with doubles wrongly";
  }
  if (!this->Error.empty())
  {
    return;
  }
  // If one of the programs does not compile, Error says so.
  const vtkNBufferGL::ScopedCompute scope;
  this->Tests.Use(this->Error);
  this->Lists.Use(this->Error, AddDefinition);
  for (const std::string& kind : { std::string(), RunsDefinition })
  {
    this->Lists.Use(this->Error, CountDefinition + kind);
    this->Lists.Use(this->Error, CopyDefinition + kind);
  }
  // A record has at least 4 bytes. Units and the nodes above them have a box each.
  this->LargestBuffer = std::min(vtkNBufferGL::GetLargestStorage(),
    LargestNumberOfGroups * PrimitivesPerGroup * sizeof(std::uint32_t));
  this->LargestNumberOfUnits = std::min(LargestNumberOfGroups * NodesPerGroup,
    vtkNBufferGL::GetLargestStorage() / (2 * sizeof(vtkNBufferUnits::Box)));
}

void vtkNBufferUnitDevice::ReleaseGraphicsResources(vtkWindow*)
{
  this->Tests.Delete();
  this->Lists.Delete();
  this->ContextTime = 0;
}

void vtkNBufferUnitDevice::Test(const vtkNBufferUnits& units, Buffers& buffers,
  const vtkNBufferProjection& projection, const vtkNBufferBox& rounding,
  const vtkNBufferTexture* texture, const vtkNBufferLevels& levels, double sampleDistance,
  vtkNBufferUnitAnswers& answers)
{
  const vtkNBufferGL::ScopedCompute scope;
  const auto& nodes = units.GetLevels();
  const std::size_t numberOfLevels =
    std::min(vtkNBufferUnitAnswers::HighestLevel + 1, nodes.size());
  answers.FirstOfLevel.assign(numberOfLevels, 0);
  for (std::size_t level = 1; level < numberOfLevels; ++level)
  {
    answers.FirstOfLevel[level] = answers.FirstOfLevel[level - 1] + nodes[level - 1].size();
  }
  const std::size_t size = answers.FirstOfLevel.back() + nodes[numberOfLevels - 1].size();
  answers.Words.resize((NBUFFER_ANSWER_BITS * size + 31) / 32);
  const std::size_t bytes = answers.Words.size() * sizeof(std::uint32_t);
  if (buffers.Boxes.GetName() == 0)
  {
    std::vector<vtkNBufferUnits::Box> boxes;
    boxes.reserve(size);
    std::for_each(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(numberOfLevels),
      [&boxes](const auto& level) { boxes.insert(boxes.end(), level.begin(), level.end()); });
    vtkNBufferGL::AllocateStorage(
      buffers.Boxes.Create(), size * sizeof(vtkNBufferUnits::Box), boxes.data());
    vtkNBufferGL::AllocateStorage(buffers.Answers.Create(), bytes);
  }
  vtkNBufferGL::BindStorage(BoxBuffer, buffers.Boxes.GetName());
  vtkNBufferGL::BindStorage(AnswerBuffer, buffers.Answers.GetName());
  glClearBufferData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);

  const unsigned int program = this->Tests.Use(this->Error);
  const vtkNBufferBoxError& errors = projection.GetError();
  const vtkNBufferDepthFormat& format = errors.GetFormat();
  glm::dvec4 ofRows;
  for (int i = 0; i < 4; ++i)
  {
    ofRows[i] = vtkNBufferBoxError::GetVertexError(projection.GetWorldToClip()[i], rounding);
  }
  glUniform4dv(
    glGetUniformLocation(program, "rows"), 4, glm::value_ptr(projection.GetWorldToClip().front()));
  glUniform4dv(glGetUniformLocation(program, "errors"), 1, glm::value_ptr(ofRows));
  glUniform2d(glGetUniformLocation(program, "borders"), errors.GetBorder(rounding, true),
    errors.GetBorder(rounding, false));
  SetVector(program, "order", { format.Scale, format.Offset, format.Farthest });
  SetVector(
    program, "slack", { format.Slack, format.RelativeSlack, errors.GetInterpolationSlack(1.0) });
  glUniform2i(
    glGetUniformLocation(program, "viewport"), projection.GetWidth(), projection.GetHeight());
  SetInteger(program, "samplesAreMiddles", !(sampleDistance > 0.0));
  glUniform2i(
    glGetUniformLocation(program, "shape.size"), levels.GetPixelWidth(), levels.GetPixelHeight());
  SetInteger(program, "shape.factor", levels.GetFactor());
  SetInteger(program, "shape.levels", texture->GetNumberOfLevels());
  SetInteger(program, "shape.minima", 0);
  const char* const names[] = { "even", "odd" };
  for (int i = 0; i < 2; ++i)
  {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture->GetHandle(i));
    SetInteger(program, names[i], i);
  }
  for (std::size_t level = numberOfLevels; level-- > 0;)
  {
    const bool hasParents = level + 1 < numberOfLevels;
    SetUnsigned(program, "first", answers.FirstOfLevel[level]);
    SetUnsigned(program, "size", nodes[level].size());
    SetUnsigned(program, "parents", hasParents ? answers.FirstOfLevel[level + 1] : 0);
    SetInteger(program, "hasParents", hasParents);
    Dispatch(nodes[level].size(), NodesPerGroup);
  }
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetBufferSubData(
    GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), answers.Words.data());
}

void vtkNBufferUnitDevice::List::Draw(unsigned int mode) const
{
  if (this->Object.GetName() == 0)
  {
    glDrawElementsInstanced(mode, static_cast<GLsizei>(this->OfHost.Count), GL_UNSIGNED_INT,
      nullptr, static_cast<GLsizei>(this->OfHost.Instances));
    return;
  }
  const int bound = vtkNBufferGL::GetInteger(GL_DRAW_INDIRECT_BUFFER_BINDING);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, this->Object.GetName());
  glDrawElementsIndirect(mode, GL_UNSIGNED_INT, nullptr);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, static_cast<GLuint>(bound));
}

void vtkNBufferUnitDevice::MakeList(const vtkNBufferUnits& units,
  const std::vector<unsigned char>& marked, Buffers& buffers, const vtkNBufferUnits::Range& part,
  const std::vector<Records>& records, std::size_t indices, bool areInstances, List& list)
{
  const vtkNBufferGL::ScopedCompute scope;
  const std::size_t size = part.End - part.Begin;
  const std::vector<std::uint32_t> bits = GetBits(marked);
  vtkNBufferGL::AllocateStorage(
    buffers.Marks.Create(), bits.size() * sizeof(std::uint32_t), bits.data());
  if (units.AreSpatial() && buffers.Table.GetName() == 0)
  {
    const std::vector<std::uint32_t> table = units.GetUnitsOfPrimitives();
    vtkNBufferGL::AllocateStorage(
      buffers.Table.Create(), table.size() * sizeof(std::uint32_t), table.data());
  }
  const std::size_t groups = (size + PrimitivesPerGroup - 1) / PrimitivesPerGroup;
  vtkNBufferGL::AllocateStorage(buffers.Sums.Create(), groups * sizeof(std::uint32_t));
  Command command; // The device multiplies one of its fields by the number of primitives.
  command.Count = static_cast<std::uint32_t>(indices);
  vtkNBufferGL::AllocateStorage(list.Object.Create(), sizeof(Command), &command);
  // The length of the list is known to the device alone, but not what it is at most.
  const auto count = std::count(marked.begin(), marked.end(), 1);
  const std::size_t most = std::min(size, units.GetUnitSize() * static_cast<std::size_t>(count));

  vtkNBufferGL::BindStorage(MarkBuffer, buffers.Marks.GetName());
  vtkNBufferGL::BindStorage(TableBuffer, buffers.Table.GetName());
  vtkNBufferGL::BindStorage(SumBuffer, buffers.Sums.GetName());
  const std::string kind = units.AreSpatial() ? "" : RunsDefinition;
  const auto use = [&](const std::string& pass)
  {
    const unsigned int program = this->Lists.Use(this->Error, pass + kind);
    SetUnsigned(program, "unitSize", units.GetUnitSize());
    SetUnsigned(program, "first", part.Begin);
    SetUnsigned(program, "size", size);
    return program;
  };
  use(CountDefinition);
  Dispatch(size, PrimitivesPerGroup);
  unsigned int program = this->Lists.Use(this->Error, AddDefinition);
  vtkNBufferGL::BindStorage(CommandBuffer, list.Object.GetName());
  SetUnsigned(program, "groups", groups);
  SetUnsigned(program, "field", areInstances ? 1 : 0);
  Dispatch(1, 1);
  program = use(CopyDefinition);
  for (const Records& record : records)
  {
    vtkNBufferGL::AllocateStorage(record.Target, most * record.Words * sizeof(std::uint32_t));
    vtkNBufferGL::BindStorage(SourceBuffer, record.Source);
    vtkNBufferGL::BindStorage(TargetBuffer, record.Target);
    SetUnsigned(program, "words", record.Words);
    Dispatch(size, PrimitivesPerGroup);
  }
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT |
    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}
VTK_ABI_NAMESPACE_END
