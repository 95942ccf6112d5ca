// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Compressed.h
 * @brief Reads whole files, plain or compressed by gzip.
 */
#ifndef Compressed_h
#define Compressed_h

#include <string>

namespace NBufferExamples
{

/// Returns the contents of a file, or their first `limit` bytes, decompressed if the file is a gzip
/// file. Throws std::runtime_error, with the name of the file and the cause, if it is missing,
/// unreadable or damaged.
std::string ReadMaybeCompressed(const std::string& fileName, std::size_t limit = std::string::npos);

} // namespace NBufferExamples

#endif
