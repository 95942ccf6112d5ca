// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file TinyMap.h
 * @brief Makes the bytes of a small map (BspMap.h) of two rooms.
 */
#ifndef TinyMap_h
#define TinyMap_h

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace StudyTest
{

/// Appends numbers, little-endian, to the bytes of a lump. (A lump is a section of the file.)
class Bytes
{
public:
  Bytes& Int(int value)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->Text += static_cast<char>(static_cast<std::uint32_t>(value) >> (8 * i) & 255u);
    }
    return *this;
  }
  Bytes& Float(float value)
  {
    int bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    return this->Int(bits);
  }
  Bytes& Skip(std::size_t count)
  {
    this->Text.append(count, '\0');
    return *this;
  }
  std::string Text;
};

constexpr int Lumps = 17;

/**
 * Returns the lumps of a map. Its two rooms, which do not see each other, are on both sides of an
 * opaque leaf, -1 < x < 1, which is not drawn. One room has a quad at x = 500, the other a patch of
 * one piece at x = -500, whose middle point is at x = 300. Both are 2000 units wide and high. There
 * are also a door in no leaf, and a flare. A player starts at x = 100.
 */
inline std::vector<std::string> MakeLumps()
{
  std::vector<std::string> lumps(Lumps);
  lumps[0] = "{\n\"classname\" \"info_player_start\"\n\"origin\" \"100 8 9\"\n}\n"
             "{\n\"origin\" \"1 2 3\"\n\"classname\" \"light\"\n}\n";
  Bytes planes;
  for (float distance : { 1.0f, -1.0f })
  {
    planes.Float(1.0f).Float(0.0f).Float(0.0f).Float(distance);
  }
  lumps[2] = planes.Text;
  // Right of 1: leaf 0; left of -1: leaf 2; between them leaf 1.
  lumps[3] = Bytes().Int(0).Int(-1).Int(1).Skip(24).Int(1).Int(-2).Int(-3).Skip(24).Text;
  Bytes leaves;
  const int clusters[] = { 0, -1, 1 };
  const int faces[][2] = { { 0, 1 }, { 1, 0 }, { 1, 2 } };
  for (std::size_t i = 0; i < 3; ++i)
  {
    leaves.Int(clusters[i]).Skip(28).Int(faces[i][0]).Int(faces[i][1]).Skip(8);
  }
  lumps[4] = leaves.Text;
  lumps[5] = Bytes().Int(0).Int(1).Int(1).Text;
  lumps[7] = Bytes().Skip(24).Int(0).Int(2).Skip(8).Text;
  Bytes vertices;
  const auto add = [&vertices](float x, float y, float z)
  { vertices.Float(x).Float(y).Float(z).Skip(32); };
  for (const auto& corner : { std::pair<float, float>{ -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } })
  {
    add(500.0f, 1000.0f * corner.first, 1000.0f * corner.second);
  }
  for (int i = 0; i < 9; ++i)
  {
    add(i == 4 ? 300.0f : -500.0f, 1000.0f * static_cast<float>(i % 3 - 1),
      1000.0f * static_cast<float>(i / 3 - 1));
  }
  lumps[10] = vertices.Text;
  Bytes indices;
  for (int index : { 0, 1, 2, 0, 2, 3 })
  {
    indices.Int(index);
  }
  lumps[11] = indices.Text;
  Bytes surfaces;
  const int kinds[][7] = { { 1, 0, 4, 0, 6, 0, 0 }, { 2, 4, 9, 0, 0, 3, 3 },
    { 3, 0, 4, 0, 3, 0, 0 }, { 4, 0, 0, 0, 0, 0, 0 } };
  for (const int* kind : kinds)
  {
    surfaces.Skip(8).Int(kind[0]).Int(kind[1]).Int(kind[2]).Int(kind[3]).Int(kind[4]).Skip(68);
    surfaces.Int(kind[5]).Int(kind[6]);
  }
  lumps[13] = surfaces.Text;
  lumps[16] = Bytes().Int(2).Int(1).Text + "\x01\x02";
  return lumps;
}

/// Returns the file that consists of these lumps.
inline std::string Join(const std::vector<std::string>& lumps, int version = 46)
{
  Bytes file;
  file.Text = "IBSP";
  file.Int(version);
  std::size_t offset = 8 + 8 * lumps.size();
  for (const std::string& lump : lumps)
  {
    file.Int(static_cast<int>(offset)).Int(static_cast<int>(lump.size()));
    offset += lump.size();
  }
  for (const std::string& lump : lumps)
  {
    file.Text += lump;
  }
  return file.Text;
}

} // namespace StudyTest

#endif
