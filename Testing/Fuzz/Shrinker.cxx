// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shrinker.h"

#include <string>
#include <vector>

namespace TestScene
{
namespace
{
/// Way from the root to a value: names of members, or places in arrays.
struct Step
{
  std::string Name;
  Json::ArrayIndex Index = 0;
};
using Path = std::vector<Step>;

Json::Value& Find(Json::Value& root, const Path& path)
{
  Json::Value* value = &root;
  for (const Step& step : path)
  {
    value = step.Name.empty() ? &(*value)[step.Index] : &(*value)[step.Name];
  }
  return *value;
}

class Shrinker
{
public:
  Shrinker(const Json::Value& value, const Oracle& fails, int budget)
    : Fails(fails)
    , Budget(budget)
  {
    this->Result.Value = value;
  }

  ShrinkResult Run()
  {
    // What one kind of step cannot take out may go after another one did.
    bool changed = true;
    while (changed && this->HasBudget())
    {
      changed = this->ShrinkValue({});
      // Fewer frames: any number of steps, while nothing else depends on it.
      changed = this->LowerFrames() || changed;
    }
    return this->Result;
  }

private:
  bool HasBudget() const { return this->Result.Questions < this->Budget; }

  bool Try(const Json::Value& candidate)
  {
    if (!this->HasBudget())
    {
      return false;
    }
    ++this->Result.Questions;
    if (!this->Fails(candidate))
    {
      return false;
    }
    this->Result.Value = candidate;
    return true;
  }

  bool ShrinkValue(const Path& path)
  {
    const Json::Value value = Find(this->Result.Value, path);
    // Numbers of an array are a point or a matrix, of which nothing can be left out.
    if (value.isArray() && !value.empty() && value[0].isObject())
    {
      bool changed = this->Thin(path);
      Path element = path;
      element.emplace_back();
      for (Json::ArrayIndex i = 0; i < Find(this->Result.Value, path).size(); ++i)
      {
        element.back().Index = i;
        changed = this->ShrinkValue(element) || changed;
      }
      return changed;
    }
    return value.isObject() && this->ShrinkMembers(path);
  }

  bool ShrinkMembers(const Path& path)
  {
    bool changed = false;
    for (const std::string& name : Find(this->Result.Value, path).getMemberNames())
    {
      Path member = path;
      member.push_back({ name, 0 });
      // The large things first, from inside: without all props nothing fails.
      const Json::Value& value = Find(this->Result.Value, member);
      const bool large = value.isArray() && !value.empty() && value[0].isObject();
      changed = (large && this->ShrinkValue(member)) || changed;
      // What changes refer to, and how long it takes.
      if (name == "id" || (path.empty() && (name == "frames" || name == "seed")))
      {
        continue;
      }
      Json::Value candidate = this->Result.Value;
      Find(candidate, path).removeMember(name);
      if (this->Try(candidate))
      {
        changed = true;
      }
      else if (!large)
      {
        changed = this->ShrinkValue(member) || changed;
      }
    }
    return changed;
  }

  /// Leave out ever smaller parts of an array.
  bool Thin(const Path& path)
  {
    bool changed = false;
    auto size = static_cast<Json::ArrayIndex>(Find(this->Result.Value, path).size());
    for (Json::ArrayIndex part = (size + 1) / 2; part > 0; part = part > 1 ? (part + 1) / 2 : 0)
    {
      for (Json::ArrayIndex begin = 0; begin < Find(this->Result.Value, path).size();)
      {
        Json::Value candidate = this->Result.Value;
        Json::Value& array = Find(candidate, path);
        Json::Value rest(Json::arrayValue);
        for (Json::ArrayIndex i = 0; i < array.size(); ++i)
        {
          if (i < begin || i >= begin + part)
          {
            rest.append(array[i]);
          }
        }
        array = rest;
        if (this->Try(candidate))
        {
          changed = true;
        }
        else
        {
          begin += part;
        }
      }
    }
    return changed;
  }

  /// Everything one frame earlier, as often as it still fails.
  bool LowerFrames()
  {
    bool changed = false;
    for (int frame = 0; frame < this->Result.Value.get("frames", 1).asInt();)
    {
      Json::Value candidate = this->Result.Value;
      candidate["frames"] = candidate.get("frames", 1).asInt() - 1;
      for (const auto& [list, member] :
        { std::make_pair("views", "frame"), std::make_pair("changes", "frame"),
          std::make_pair("props", "from"), std::make_pair("props", "until") })
      {
        if (!candidate.isMember(list))
        {
          continue;
        }
        for (Json::Value& element : candidate[list])
        {
          const int at = element.get(member, 0).asInt();
          if (at > frame)
          {
            element[member] = at - 1;
          }
        }
      }
      if (candidate["frames"].asInt() > 0 && this->Try(candidate))
      {
        changed = true;
      }
      else
      {
        ++frame;
      }
    }
    return changed;
  }

  const Oracle& Fails;
  int Budget;
  ShrinkResult Result;
};
}

ShrinkResult Shrink(const Json::Value& value, const Oracle& fails, int budget)
{
  return Shrinker(value, fails, budget).Run();
}
}
