// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PlyCheck.h"

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace NBufferExamples
{
namespace
{
/// The bytes of a number, by the name of its type.
const std::map<std::string, int> PlySizes = { { "char", 1 }, { "uchar", 1 }, { "int8", 1 },
  { "uint8", 1 }, { "short", 2 }, { "ushort", 2 }, { "int16", 2 }, { "uint16", 2 }, { "int", 4 },
  { "uint", 4 }, { "int32", 4 }, { "uint32", 4 }, { "float", 4 }, { "float32", 4 }, { "double", 8 },
  { "float64", 8 } };

struct Property
{
  int CountSize = 0; ///< The bytes of the number of values in front of a list; 0: one value.
  int Size = 0;      ///< The bytes of a value.
};

struct Element
{
  std::string Name;
  long long Count = 0;
  std::vector<Property> Properties;
};

struct Header
{
  std::string Format;
  std::vector<Element> Elements;
};

/// Reads the header. Returns false if it is not understood.
bool ReadHeader(std::istream& file, Header& header)
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
      Element element;
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

void SkipElement(std::istream& file, const Element& element, const std::string& format)
{
  if (format == "ascii")
  {
    std::string line;
    while (std::getline(file, line) && line.find_first_not_of(" \t\r") == std::string::npos)
    {
    }
    return;
  }
  for (const Property& property : element.Properties)
  {
    const std::uint64_t count = property.CountSize == 0
      ? 1
      : ReadCount(file, property.CountSize, format == "binary_big_endian");
    const auto bytes =
      static_cast<std::streamsize>(count * static_cast<std::uint64_t>(property.Size));
    if (file.ignore(bytes).gcount() < bytes)
    {
      file.setstate(std::ios::failbit);
    }
  }
}
}

void CheckPly(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  Header header;
  if (!ReadHeader(file, header))
  {
    return;
  }
  for (const Element& element : header.Elements)
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

} // namespace NBufferExamples
