// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CityFile.h"

#include "Compressed.h"

#include <stdexcept>

namespace NBufferExamples
{
namespace
{
constexpr char Magic[] = "NBufferCity\n";
constexpr std::size_t MagicSize = sizeof(Magic) - 1;
constexpr std::uint64_t Version = 1;

class Reader
{
public:
  Reader(const std::string& bytes, const std::string& fileName)
    : Bytes(bytes)
    , FileName(fileName)
    , Position(MagicSize)
  {
  }

  std::uint64_t Unsigned()
  {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7)
    {
      if (this->Position >= this->Bytes.size())
      {
        this->Fail("it ends too early");
      }
      const auto byte = static_cast<unsigned char>(this->Bytes[this->Position++]);
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if (byte < 0x80)
      {
        return value;
      }
    }
    this->Fail("a number is too long");
  }
  std::int64_t Signed()
  {
    const std::uint64_t folded = this->Unsigned();
    return static_cast<std::int64_t>(folded >> 1) ^ -static_cast<std::int64_t>(folded & 1);
  }
  /// A count of things that take at least `bytesEach`: a damaged one must not exhaust memory.
  std::size_t Count(std::size_t atLeast, std::size_t bytesEach)
  {
    const std::uint64_t count = this->Unsigned();
    if (count < atLeast || count > (this->Bytes.size() - this->Position) / bytesEach)
    {
      this->Fail("a count is impossible");
    }
    return static_cast<std::size_t>(count);
  }
  std::string String()
  {
    const std::size_t size = this->Count(0, 1);
    const std::string text = this->Bytes.substr(this->Position, size);
    this->Position += size;
    return text;
  }
  std::vector<CityPoint> Points(std::size_t atLeast)
  {
    std::vector<CityPoint> points(this->Count(atLeast, 2));
    for (CityPoint& point : points)
    {
      this->Last.X = this->Coordinate(this->Last.X);
      this->Last.Y = this->Coordinate(this->Last.Y);
      point = this->Last;
    }
    return points;
  }
  [[noreturn]] void Fail(const std::string& cause) const
  {
    throw std::runtime_error(this->FileName + " is damaged: " + cause);
  }
  bool IsAtEnd() const { return this->Position == this->Bytes.size(); }

private:
  std::int32_t Coordinate(std::int32_t before)
  {
    const std::int64_t step = this->Signed();
    // 1,000 km either way is no city; the bound keeps the sum and the result in range.
    constexpr std::int64_t bound = 100000000;
    if (step < -2 * bound || step > 2 * bound || before + step < -bound || before + step > bound)
    {
      this->Fail("a coordinate is out of range");
    }
    return static_cast<std::int32_t>(before + step);
  }

  const std::string& Bytes;
  const std::string& FileName;
  std::size_t Position;
  CityPoint Last;
};
}

bool IsCityFile(const std::string& fileName)
{
  try
  {
    return ReadMaybeCompressed(fileName, MagicSize) == Magic;
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

City ReadCity(const std::string& fileName)
{
  const std::string bytes = ReadMaybeCompressed(fileName);
  if (bytes.compare(0, MagicSize, Magic) != 0)
  {
    throw std::runtime_error(
      fileName + " is no city file; Scripts/make-city.py makes one from OpenStreetMap data");
  }
  Reader reader(bytes, fileName);
  const std::uint64_t version = reader.Unsigned();
  if (version != Version)
  {
    throw std::runtime_error(fileName + " has version " + std::to_string(version) +
      " of the city format, this program reads version " + std::to_string(Version) +
      "; make it anew with Scripts/make-city.py");
  }
  City city;
  reader.String(); // The attribution.
  reader.Signed(); // The latitude of the centre.
  reader.Signed(); // The longitude of the centre.
  city.StreetKinds.resize(reader.Count(0, 1));
  for (std::string& kind : city.StreetKinds)
  {
    kind = reader.String();
  }
  city.Buildings.resize(reader.Count(0, 10));
  for (CityBuilding& building : city.Buildings)
  {
    reader.Unsigned(); // Where the height comes from.
    const std::uint64_t height = reader.Unsigned();
    if (height > 1000000)
    {
      reader.Fail("a height is out of range");
    }
    building.Height = static_cast<std::int32_t>(height);
    building.Rings.resize(reader.Count(1, 7));
    for (CityRing& ring : building.Rings)
    {
      ring = reader.Points(3);
    }
  }
  city.Streets.resize(reader.Count(0, 6));
  for (CityStreet& street : city.Streets)
  {
    const std::uint64_t kind = reader.Unsigned();
    if (kind >= city.StreetKinds.size())
    {
      reader.Fail("a street has no kind");
    }
    street.Kind = static_cast<int>(kind);
    street.Points = reader.Points(2);
  }
  if (!reader.IsAtEnd())
  {
    reader.Fail("bytes are left over");
  }
  return city;
}

} // namespace NBufferExamples
