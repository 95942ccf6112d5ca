// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Compressed.h"

#include "vtk_zlib.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>

namespace NBufferExamples
{
std::string ReadMaybeCompressed(const std::string& fileName, std::size_t limit)
{
  if (std::filesystem::is_directory(fileName))
  {
    throw std::runtime_error(fileName + " is a folder, not a file");
  }
  errno = 0;
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(fileName.c_str(), "rb"), gzclose);
  if (!file)
  {
    throw std::runtime_error("cannot open " + fileName + ": " + std::strerror(errno));
  }
  std::string contents;
  while (contents.size() < limit)
  {
    const std::size_t size = contents.size();
    const std::size_t step = std::min<std::size_t>(limit - size, 1 << 20);
    contents.resize(size + step);
    const int count = gzread(file.get(), &contents[size], static_cast<unsigned int>(step));
    contents.resize(size + static_cast<std::size_t>(std::max(count, 0)));
    int code = Z_OK;
    const char* cause = gzerror(file.get(), &code);
    // A file that was cut off only shows as Z_BUF_ERROR beside the bytes before the cut.
    if (count < 0 || (code != Z_OK && code != Z_STREAM_END))
    {
      throw std::runtime_error("damaged file " + std::string(cause)); // It names the file.
    }
    if (count == 0)
    {
      break;
    }
  }
  return contents;
}

} // namespace NBufferExamples
