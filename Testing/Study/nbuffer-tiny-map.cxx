// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nbuffer-tiny-map.cxx
 * @brief nbuffer-tiny-map FILE [lie]: writes the map of TinyMap.h; as a lie with a table by which
 * nobody sees anything.
 */
#include "TinyMap.h"

#include <fstream>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "nbuffer-tiny-map FILE [lie]\n";
    return 1;
  }
  std::vector<std::string> lumps = StudyTest::MakeLumps();
  if (argc > 2)
  {
    lumps[16] = StudyTest::Bytes().Int(2).Int(1).Skip(2).Text;
  }
  std::ofstream file(argv[1], std::ios::binary);
  file << StudyTest::Join(lumps);
  return file.flush() ? 0 : 1;
}
