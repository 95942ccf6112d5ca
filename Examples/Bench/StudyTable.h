// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Table
 * @brief A table of Markdown, and numbers as its cells have them.
 */
#ifndef StudyTable_h
#define StudyTable_h

#include "vtk_jsoncpp.h"

#include <sstream>
#include <string>
#include <vector>

namespace NBufferBench
{

using Cells = std::vector<std::string>;

/// Three digits, thousands apart.
std::string Print(double value);

/// Of a percentage; empty if it is negative, which stands for none.
std::string PrintShare(double percent);

/// What a scene of the report is called in a table: those of the city by their paths alone.
std::string GetTitle(const Json::Value& scene);

class Table
{
public:
  explicit Table(const Cells& head)
  {
    this->Add(head);
    this->Add(Cells(head.size(), "---"));
  }

  void Add(const Cells& cells)
  {
    this->Text << "|";
    for (const std::string& cell : cells)
    {
      this->Text << " " << cell << " |";
    }
    this->Text << "\n";
  }

  std::string Get() const { return this->Text.str(); }

private:
  std::ostringstream Text;
};

} // namespace NBufferBench

#endif
