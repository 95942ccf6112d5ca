// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FileCheck.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace NBufferExamples
{
namespace
{
/// Skips bytes. The stream fails if it has fewer of them.
void SkipBytes(std::istream& file, std::streamsize bytes)
{
  if (file.ignore(bytes).gcount() < bytes)
  {
    file.setstate(std::ios::failbit);
  }
}

/// The bytes of a number in a .ply file, by the name of its type.
const std::map<std::string, int> PlySizes = { { "char", 1 }, { "uchar", 1 }, { "int8", 1 },
  { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 }, { "int", 4 },
  { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 }, { "double", 8 },
  { "float64", 8 } };

struct PlyProperty
{
  int CountSize = 0; ///< The bytes of the number of values in front of a list; 0: one value.
  int Size = 0;      ///< The bytes of a value.
};

struct PlyElement
{
  std::string Name;
  long long Count = 0;
  std::vector<PlyProperty> Properties;
};

struct PlyHeader
{
  std::string Format;
  std::vector<PlyElement> Elements;
};

/// Reads the header. Returns false if it is not understood.
bool ReadHeader(std::istream& file, PlyHeader& header)
{
  std::string line;
  if (!std::getline(file, line) || line.compare(0, 3, "ply") != 0)
  {
    return false;
  }
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "end_header")
    {
      return true;
    }
    if (word == "format")
    {
      words >> header.Format;
    }
    else if (word == "element")
    {
      PlyElement element;
      words >> element.Name >> element.Count;
      header.Elements.push_back(element);
    }
    else if (word == "property")
    {
      std::string type;
      std::string countType;
      words >> type;
      if (type == "list")
      {
        words >> countType >> type;
      }
      const auto size = PlySizes.find(type);
      const auto countSize = PlySizes.find(countType);
      const bool isKnown =
        size != PlySizes.end() && (countType.empty() || countSize != PlySizes.end());
      if (!isKnown || header.Elements.empty())
      {
        return false;
      }
      header.Elements.back().Properties.push_back(
        { countType.empty() ? 0 : countSize->second, size->second });
    }
  }
  throw std::runtime_error("it ends in its header");
}

/// Returns the number of values of a list, as its bytes in the file say.
std::uint64_t ReadCount(std::istream& file, int size, bool isBig)
{
  std::uint64_t count = 0;
  for (int i = 0; i < size; ++i)
  {
    const auto byte = static_cast<std::uint64_t>(static_cast<unsigned char>(file.get()));
    count = isBig ? count << 8 | byte : count | byte << (8 * i);
  }
  return count;
}

void SkipElement(std::istream& file, const PlyElement& element, const std::string& format)
{
  if (format == "ascii")
  {
    std::string line;
    while (std::getline(file, line) && line.find_first_not_of(" \t\r") == std::string::npos)
    {
    }
    return;
  }
  for (const PlyProperty& property : element.Properties)
  {
    const std::uint64_t count = property.CountSize == 0
      ? 1
      : ReadCount(file, property.CountSize, format == "binary_big_endian");
    SkipBytes(
      file, static_cast<std::streamsize>(count * static_cast<std::uint64_t>(property.Size)));
  }
}

/// The same in a binary .vtk file.
const std::map<std::string, int> LegacySizes = { { "char", 1 }, { "unsigned_char", 1 },
  { "short", 2 }, { "unsigned_short", 2 }, { "int", 4 }, { "unsigned_int", 4 }, { "vtkidtype", 4 },
  { "float", 4 }, { "long", 8 }, { "unsigned_long", 8 }, { "vtktypeint64", 8 }, { "double", 8 } };
/// The sections that hold cells.
const std::set<std::string> CellSections = { "CELLS", "VERTICES", "LINES", "POLYGONS",
  "TRIANGLE_STRIPS" };

/// Reads a .vtk file as far as its points and cells go.
class LegacyChecker
{
public:
  explicit LegacyChecker(const std::string& path)
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
      SkipBytes(this->File, size == LegacySizes.end() ? 0 : numbers * size->second);
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

void CheckPly(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  PlyHeader header;
  if (!ReadHeader(file, header))
  {
    return;
  }
  for (const PlyElement& element : header.Elements)
  {
    for (long long i = 0; i < element.Count; ++i)
    {
      SkipElement(file, element, header.Format);
      if (file.fail())
      {
        throw std::runtime_error("it ends after " + std::to_string(i) + " of " +
          std::to_string(element.Count) + " elements " + element.Name);
      }
    }
  }
}

void CheckLegacy(const std::string& path)
{
  LegacyChecker(path).Check();
}

} // namespace NBufferExamples
