// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Compressed.h
 * @brief Reads whole files, plain or compressed by gzip.
 */
#ifndef Compressed_h
#define Compressed_h

#include <stdexcept>
#include <string>

namespace NBufferExamples
{

/// Returns the contents of a file, or their first `limit` bytes, decompressed if the file is a gzip
/// file. Throws std::runtime_error, with the name of the file and the cause, if it is missing,
/// unreadable or damaged.
std::string ReadMaybeCompressed(const std::string& fileName, std::size_t limit = std::string::npos);

/// Returns parse(contents of a file). If parse() throws a std::runtime_error, the name of the file
/// is put before its text.
template <typename Parse>
auto ParseFile(const std::string& fileName, Parse&& parse)
{
  const std::string contents = ReadMaybeCompressed(fileName);
  try
  {
    return parse(contents);
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error(fileName + ": " + error.what());
  }
}

} // namespace NBufferExamples

#endif
