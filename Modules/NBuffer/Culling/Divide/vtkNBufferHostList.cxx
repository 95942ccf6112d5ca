// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNBufferHostList.h"

#include "vtkNBufferGL.h"

#include <algorithm>
#include <cstdint>
#include <numeric>

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
  ~Mapping()
  {
    if (this->Words)
    {
      glBindBuffer(GL_ARRAY_BUFFER, this->Buffer);
      glUnmapBuffer(GL_ARRAY_BUFFER);
    }
  }
  Mapping(const Mapping&) = delete;
  void operator=(const Mapping&) = delete;

  std::uint32_t* GetWords() const { return this->Words; }

private:
  unsigned int Buffer;
  std::uint32_t* Words;
};

/// `words` is the number of 32-bit words of a record.
void CopyRanges(const std::vector<Range>& ranges, std::size_t words, const std::uint32_t* source,
  std::uint32_t* target)
{
  for (const Range& range : ranges)
  {
    target = std::copy(source + range.Begin * words, source + range.End * words, target);
  }
}

void CopyNumbers(const std::vector<Range>& ranges, std::uint32_t* target)
{
  for (const Range& range : ranges)
  {
    std::uint32_t* const begin = target;
    target += range.End - range.Begin;
    std::iota(begin, target, static_cast<std::uint32_t>(range.Begin));
  }
}

/// Copy `count` of `size` records.
bool Copy(const std::vector<Range>& ranges, std::size_t size, std::size_t count,
  const vtkNBufferUnitDevice::Records& records)
{
  const std::size_t bytes = records.Words * sizeof(std::uint32_t);
  const Mapping target(
    records.Target, count * bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (records.Source == 0)
  {
    if (target.GetWords())
    {
      CopyNumbers(ranges, target.GetWords());
    }
    return target.GetWords() != nullptr;
  }
  const Mapping source(records.Source, size * bytes, GL_MAP_READ_BIT);
  const bool isMapped = source.GetWords() && target.GetWords();
  if (isMapped)
  {
    CopyRanges(ranges, records.Words, source.GetWords(), target.GetWords());
  }
  return isMapped;
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
