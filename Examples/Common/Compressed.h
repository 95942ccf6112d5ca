// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Compressed.h
 * @brief Whole files through gzip. Reading takes plain files as they are.
 */
#ifndef Compressed_h
#define Compressed_h

#include <string>

namespace NBufferExamples
{

/// The contents of a file, or its first `limit` bytes, decompressed if it is gzipped. Throws
/// std::runtime_error with the name and the cause: missing, unreadable, damaged.
std::string ReadMaybeCompressed(const std::string& fileName, std::size_t limit = std::string::npos);

/// Write a gzip file that depends on `contents` alone (no time stamp, no name).
void WriteCompressed(const std::string& fileName, const std::string& contents);

} // namespace NBufferExamples

#endif
