// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "KicadBoard.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <stdexcept>

namespace NBufferExamples
{
namespace
{
/// A word, or a list of expressions in parentheses.
struct Expression
{
  std::string Word;
  std::vector<Expression> List;

  /// Returns the list whose first word is `name`, or nullptr if there is none.
  const Expression* Find(const std::string& name) const
  {
    const auto found = std::find_if(this->List.begin(), this->List.end(),
      [&name](const Expression& entry) { return entry.IsList(name); });
    return found == this->List.end() ? nullptr : &*found;
  }

  bool IsList(const std::string& name) const
  {
    return !this->List.empty() && this->List.front().Word == name;
  }

  std::string GetWord(std::size_t place) const
  {
    return place < this->List.size() ? this->List[place].Word : std::string();
  }

  bool HasNumber(std::size_t place) const
  {
    const std::string word = this->GetWord(place);
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    return !word.empty() && *end == '\0' && std::isfinite(value);
  }

  double GetNumber(std::size_t place) const
  {
    if (!this->HasNumber(place))
    {
      throw std::runtime_error("no board: (" + this->GetWord(0) + " ...) lacks its number " +
        std::to_string(place) + ", or it is none");
    }
    return std::strtod(this->GetWord(place).c_str(), nullptr);
  }
};

class Parser
{
public:
  explicit Parser(const std::string& text)
    : Text(text)
  {
  }

  Expression Parse()
  {
    if (this->SkipSpace() != '(')
    {
      this->Fail("no parenthesis opens");
    }
    return this->ParseList(0);
  }

private:
  [[noreturn]] void Fail(const std::string& what) const
  {
    throw std::runtime_error("no board: " + what + " at byte " + std::to_string(this->At));
  }

  /// Moves to a place that find() returned: the end if nothing was found.
  void MoveTo(std::size_t place) { this->At = std::min(place, this->Text.size()); }

  /// Moves to the next character that is no space, and returns it; 0 at the end.
  char SkipSpace()
  {
    this->MoveTo(this->Text.find_first_not_of(Space, this->At));
    return this->At < this->Text.size() ? this->Text[this->At] : '\0';
  }

  Expression ParseList(int depth)
  {
    constexpr int deepest = 100;
    if (depth > deepest)
    {
      this->Fail("parentheses are nested too deeply");
    }
    Expression list;
    ++this->At;
    for (char c = this->SkipSpace(); c != ')'; c = this->SkipSpace())
    {
      if (this->At == this->Text.size())
      {
        this->Fail("a parenthesis is not closed");
      }
      list.List.push_back(c == '('
          ? this->ParseList(depth + 1)
          : Expression{ c == '"' ? this->ParseQuoted() : this->ParseWord(), {} });
    }
    ++this->At;
    return list;
  }

  std::string ParseQuoted()
  {
    std::string word;
    for (++this->At; this->At < this->Text.size(); ++this->At)
    {
      if (this->Text[this->At] == '"')
      {
        ++this->At;
        return word;
      }
      if (this->Text[this->At] == '\\' && this->At + 1 < this->Text.size())
      {
        ++this->At;
      }
      word += this->Text[this->At];
    }
    this->Fail("a quotation is not closed");
  }

  std::string ParseWord()
  {
    const std::size_t begin = this->At;
    this->MoveTo(this->Text.find_first_of(std::string(Space) + "()", begin));
    return this->Text.substr(begin, this->At - begin);
  }

  static constexpr const char* Space = " \t\n\v\f\r";
  const std::string& Text;
  std::size_t At = 0;
};

/// Reads (name (xyz 1 2 3)) into `vector`, which stays as it is if there is no such list.
void TakeVector(const Expression& model, const std::string& name, double factor, double vector[3])
{
  const Expression* list = model.Find(name);
  const Expression* xyz = list ? list->Find("xyz") : nullptr;
  for (std::size_t i = 0; xyz && i < 3; ++i)
  {
    vector[i] = factor * xyz->GetNumber(i + 1);
  }
}

void TakeParts(const Expression& footprint, KicadBoard& board)
{
  KicadPart part;
  const Expression* at = footprint.Find("at");
  if (!at)
  {
    throw std::runtime_error("no board: the part " + footprint.GetWord(1) + " has no place");
  }
  part.X = at->GetNumber(1);
  part.Y = at->GetNumber(2);
  part.Angle = at->HasNumber(3) ? at->GetNumber(3) : 0.0;
  const Expression* layer = footprint.Find("layer");
  part.IsBelow = layer && layer->GetWord(1) == "B.Cu";
  bool bare = true;
  for (const Expression& model : footprint.List)
  {
    if (!model.IsList("model"))
    {
      continue;
    }
    bare = false;
    KicadPart placed = part;
    placed.Model = model.GetWord(1);
    constexpr double inch = 25.4;
    TakeVector(model, "at", inch, placed.Offset); // Before KiCad 5.
    TakeVector(model, "offset", 1.0, placed.Offset);
    TakeVector(model, "scale", 1.0, placed.Scale);
    TakeVector(model, "rotate", 1.0, placed.Rotation);
    board.Parts.push_back(placed);
  }
  board.Bare += bare ? 1 : 0;
}
}

KicadBoard ReadKicadBoard(const std::string& text)
{
  const Expression file = Parser(text).Parse();
  if (!file.IsList("kicad_pcb"))
  {
    throw std::runtime_error("no board: it does not begin with (kicad_pcb");
  }
  KicadBoard board;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  board.Low[0] = board.Low[1] = infinity;
  board.High[0] = board.High[1] = -infinity;
  for (const Expression& entry : file.List)
  {
    if (entry.IsList("footprint") || entry.IsList("module"))
    {
      TakeParts(entry, board);
    }
    if (entry.IsList("general"))
    {
      const Expression* thickness = entry.Find("thickness");
      board.Thickness = thickness ? thickness->GetNumber(1) : board.Thickness;
    }
    const Expression* layer = entry.Find("layer");
    if (layer && layer->GetWord(1) == "Edge.Cuts")
    {
      for (const char* name : { "start", "mid", "end" })
      {
        const Expression* point = entry.Find(name);
        for (std::size_t i = 0; point && i < 2; ++i)
        {
          board.Low[i] = std::min(board.Low[i], point->GetNumber(i + 1));
          board.High[i] = std::max(board.High[i], point->GetNumber(i + 1));
        }
      }
    }
  }
  if (board.Low[0] >= board.High[0] || board.Low[1] >= board.High[1])
  {
    throw std::runtime_error("no board: it has no outline on Edge.Cuts");
  }
  return board;
}

} // namespace NBufferExamples
