// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LegacyCheck.h"

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
/// The bytes of a number in a binary file, by the name of its type.
const std::map<std::string, int> LegacySizes = { { "char", 1 }, { "unsigned_char", 1 },
  { "short", 2 }, { "unsigned_short", 2 }, { "int", 4 }, { "unsigned_int", 4 }, { "vtkidtype", 4 },
  { "float", 4 }, { "long", 8 }, { "unsigned_long", 8 }, { "vtktypeint64", 8 }, { "double", 8 } };
/// The sections that hold cells.
const std::set<std::string> CellSections = { "CELLS", "VERTICES", "LINES", "POLYGONS",
  "TRIANGLE_STRIPS" };

class Checker
{
public:
  explicit Checker(const std::string& path)
    : File(path, std::ios::binary)
  {
    std::string line;
    std::getline(this->File, line); // # vtk DataFile Version 5.1
    const std::size_t dot = line.find('.');
    const char major = dot != std::string::npos && dot > 0 ? line[dot - 1] : '0';
    this->HasOffsets = major >= '5';
    std::getline(this->File, line); // The title.
    std::string format;
    this->File >> format;
    this->IsBinary = format == "BINARY";
  }

  void Check()
  {
    std::string line;
    while (std::getline(this->File, line))
    {
      std::istringstream words(line);
      std::string section;
      std::string type;
      long long count = 0;
      long long size = 0;
      words >> section >> count;
      if (section == "POINTS")
      {
        words >> type;
        this->Skip(section, 3 * count, type);
      }
      else if (CellSections.count(section) > 0)
      {
        words >> size;
        this->SkipCells(section, count, size);
      }
      else if (section == "POINT_DATA" || section == "CELL_DATA" || section == "FIELD")
      {
        return;
      }
    }
  }

private:
  /// Up to version 4 cells are `size` numbers. Since version 5 they are two lists, of offsets and
  /// of points, each with a line for the type of its numbers.
  void SkipCells(const std::string& section, long long count, long long size)
  {
    if (!this->HasOffsets)
    {
      this->Skip(section, size, "int");
      return;
    }
    for (const long long numbers : { count, size })
    {
      std::string name;
      std::string type;
      this->File >> name >> type;
      std::string rest;
      std::getline(this->File, rest);
      this->Skip(section, numbers, type);
    }
  }

  void Skip(const std::string& section, long long numbers, const std::string& type)
  {
    if (this->IsBinary)
    {
      const auto size = LegacySizes.find(type);
      const long long bytes = size == LegacySizes.end() ? 0 : numbers * size->second;
      if (this->File.ignore(bytes).gcount() < bytes)
      {
        this->File.setstate(std::ios::failbit);
      }
    }
    else
    {
      std::string number;
      for (long long i = 0; i < numbers && this->File >> number; ++i)
      {
      }
    }
    if (this->File.fail())
    {
      throw std::runtime_error("it ends in its section " + section);
    }
    if (this->File.peek() == '\n')
    {
      this->File.get();
    }
  }

  std::ifstream File;
  bool HasOffsets = false;
  bool IsBinary = false;
};
}

void CheckLegacy(const std::string& path)
{
  Checker(path).Check();
}

} // namespace NBufferExamples
