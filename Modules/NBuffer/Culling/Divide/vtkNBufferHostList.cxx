// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferHostList.h"

#include "vtkNBufferGL.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
namespace
{
using Range = vtkNBufferUnits::Range;

/// While it lives, a buffer is in the memory of the host. The last buffer that was bound to
/// GL_ARRAY_BUFFER stays bound.
class Mapping
{
public:
  /// `access` is that of glMapBufferRange(). `bytes` must not be 0.
  Mapping(unsigned int buffer, std::size_t bytes, GLbitfield access)
    : Buffer(buffer)
  {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    if (access & GL_MAP_WRITE_BIT)
    {
      glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_DRAW);
    }
    this->Words = static_cast<std::uint32_t*>(
      glMapBufferRange(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), access));
  }
  ~Mapping() { this->End(); }
  Mapping(const Mapping&) = delete;
  void operator=(const Mapping&) = delete;

  std::uint32_t* GetWords() const { return this->Words; }

  /// Returns false if OpenGL has lost what was written, or if the buffer was not mapped.
  bool End()
  {
    const bool isMapped = std::exchange(this->Words, nullptr);
    if (isMapped)
    {
      glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
    }
    return isMapped && glUnmapBuffer(GL_ARRAY_BUFFER) == GL_TRUE;
  }

private:
  unsigned int Buffer;
  std::uint32_t* Words;
};

/// Copy `count` of `size` records. If there is no source, a record is the number of a primitive.
bool Copy(const std::vector<Range>& ranges, std::size_t size, std::size_t count,
  const vtkNBufferUnitDevice::Records& records)
{
  const std::size_t bytes = records.Words * sizeof(std::uint32_t);
  Mapping target(records.Target, count * bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  std::optional<Mapping> source;
  if (records.Source != 0)
  {
    source.emplace(records.Source, size * bytes, GL_MAP_READ_BIT);
  }
  std::uint32_t* to = target.GetWords();
  if (!to || (source && !source->GetWords()))
  {
    return false;
  }
  for (const Range& range : ranges)
  {
    if (source)
    {
      to = std::copy(source->GetWords() + range.Begin * records.Words,
        source->GetWords() + range.End * records.Words, to);
      continue;
    }
    std::uint32_t* const begin = std::exchange(to, to + (range.End - range.Begin));
    std::iota(begin, to, static_cast<std::uint32_t>(range.Begin));
  }
  return target.End();
}
}

std::optional<std::size_t> vtkNBufferHostList::Copy(const std::vector<Range>& ranges,
  const Range& part, const std::vector<vtkNBufferUnitDevice::Records>& records)
{
  const std::vector<Range> clipped = vtkNBufferUnits::Clip(ranges, part);
  std::size_t count = 0;
  for (const Range& range : clipped)
  {
    count += range.End - range.Begin;
  }
  if (count == 0)
  {
    return 0;
  }
  const int bound = vtkNBufferGL::GetInteger(GL_ARRAY_BUFFER_BINDING);
  const bool isCopied = std::all_of(records.begin(), records.end(),
    [&](const vtkNBufferUnitDevice::Records& record)
    { return ::Copy(clipped, part.End - part.Begin, count, record); });
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(bound));
  return isCopied ? std::optional<std::size_t>(count) : std::nullopt;
}
VTK_ABI_NAMESPACE_END
