// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SizeOption.h
 * @brief The option --size of all programs. It includes CLI11, which takes long to compile.
 */
#ifndef SizeOption_h
#define SizeOption_h

#include <CLI/CLI.hpp>

#include <array>
#include <string>

namespace NBufferExamples
{

/// Adds --size, whose default is the former content of `size`, which must outlive the parser.
inline void AddSizeOption(CLI::App& app, std::array<int, 2>& size, const std::string& help)
{
  // Where the height is missing, CLI11 takes the next option for it.
  const auto check = [range = CLI::Range(1, 16384)](const std::string& pixels)
  {
    return range(pixels).empty()
      ? std::string()
      : "a size is WxH, of numbers from 1 to 16384 such as 640x480, and not " + pixels;
  };
  app.add_option("--size", size, help)
    ->delimiter('x')
    ->check(check)
    ->type_name("WxH")
    ->default_str(std::to_string(size[0]) + "x" + std::to_string(size[1]));
}

} // namespace NBufferExamples

#endif
