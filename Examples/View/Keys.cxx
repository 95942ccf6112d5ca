// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Keys.h"

#include "vtkCommand.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace NBufferView
{

void Keys::Add(const std::string& key, const std::string& help, std::function<void()> action)
{
  this->All.push_back({ key, help, std::move(action) });
}

std::string Keys::Describe() const
{
  constexpr std::size_t width = 10;
  std::string text;
  for (std::size_t i = 0; i < this->All.size();)
  {
    const std::string& help = this->All[i].Help;
    std::string names;
    for (; i < this->All.size() && this->All[i].Help == help; ++i)
    {
      names += (names.empty() ? "" : " ") + this->All[i].Name;
    }
    names.resize(std::max(names.size() + 2, width), ' ');
    text += (text.empty() ? "" : "\n") + names + help;
  }
  return text;
}

void Keys::Follow(vtkRenderWindowInteractor* interactor)
{
  this->Source = interactor;
  constexpr float first = 2.0F;
  interactor->AddObserver(vtkCommand::KeyPressEvent, this, &Keys::Press, first);
  interactor->AddObserver(vtkCommand::CharEvent, this, &Keys::Ignore, first);
}

const Keys::Key* Keys::Find(const std::string& name) const
{
  const auto found = std::find_if(
    this->All.begin(), this->All.end(), [&name](const Key& key) { return key.Name == name; });
  return found == this->All.end() ? nullptr : &*found;
}

bool Keys::Press(vtkObject*, unsigned long, void*)
{
  const char* symbol = this->Source->GetKeySym();
  const Key* key = this->Find(std::string(1, this->Source->GetKeyCode()));
  key = !key && symbol ? this->Find(symbol) : key;
  if (key)
  {
    key->Action();
  }
  return true;
}

bool Keys::Ignore(vtkObject*, unsigned long, void*)
{
  return true;
}

void Keys::Play(const std::string& script)
{
  std::istringstream words(script);
  for (std::string word; words >> word;)
  {
    if (word.size() > 1 && word[0] == '@')
    {
      this->PlayPointer(word);
    }
    else
    {
      this->PlayKey(word);
    }
  }
}

void Keys::PlayKey(const std::string& name)
{
  if (!this->Find(name))
  {
    throw std::runtime_error("there is no key " + name + "; --help lists the keys");
  }
  const char code = name.size() == 1 ? name[0] : '\0';
  this->Source->SetKeyEventInformation(0, 0, code, 1, name.c_str());
  for (const auto event :
    { vtkCommand::KeyPressEvent, vtkCommand::CharEvent, vtkCommand::KeyReleaseEvent })
  {
    this->Source->InvokeEvent(event);
  }
}

void Keys::PlayPointer(const std::string& word)
{
  int from[2];
  int to[2];
  int end = 0;
  const auto length = static_cast<int>(word.size());
  if (std::sscanf(word.c_str(), "@%d,%d%n", &from[0], &from[1], &end) == 2 && end == length)
  {
    this->Source->SetEventInformation(from[0], from[1]);
    this->Source->InvokeEvent(vtkCommand::MouseMoveEvent);
    this->Source->InvokeEvent(vtkCommand::TimerEvent); // The moment is over.
  }
  else if (std::sscanf(word.c_str(), "@%d,%d>%d,%d%n", &from[0], &from[1], &to[0], &to[1], &end) ==
      4 &&
    end == length)
  {
    this->Source->SetEventInformation(from[0], from[1]);
    this->Source->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    this->Source->SetEventInformation(to[0], to[1]);
    this->Source->InvokeEvent(vtkCommand::MouseMoveEvent);
    this->Source->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  }
  else
  {
    throw std::runtime_error(word + " is no place; places are @x,y and @x,y>x,y");
  }
}

} // namespace NBufferView
