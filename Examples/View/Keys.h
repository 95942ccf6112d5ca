// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class Keys
 * @brief The keys of a program: what each does, in one list from which the help is made, too.
 *
 * No key that is pressed reaches VTK's interactor styles, whose own keys would surprise.
 */
#ifndef Keys_h
#define Keys_h

#include <functional>
#include <string>
#include <vector>

class vtkObject;
class vtkRenderWindowInteractor;

namespace NBufferView
{

class Keys
{
public:
  /// Adds a key by its character or, for keys without one, by its name in X, such as Left. Keys in
  /// sequence with the same help share a line of it.
  void Add(const std::string& key, const std::string& help, std::function<void()> action);

  /// Returns a line for each key or group of keys: the keys and what they do.
  std::string Describe() const;

  /// From now on the keys that an interactor reports are obeyed.
  void Follow(vtkRenderWindowInteractor* interactor);

  /**
   * Sends events to the interactor as a window system would. The words of a script are
   *
   *     a key                  its character or name
   *     @x,y                   the pointer moves there and stays for a moment
   *     @x,y>x,y               the left button is pressed here, the pointer moves there, and the
   *                            button is released
   *
   * Throws std::runtime_error for a word that is none of these.
   */
  void Play(const std::string& script);

private:
  struct Key
  {
    std::string Name;
    std::string Help;
    std::function<void()> Action;
  };
  const Key* Find(const std::string& name) const;
  bool Press(vtkObject* caller, unsigned long event, void* data);
  bool Ignore(vtkObject* caller, unsigned long event, void* data);
  void PlayKey(const std::string& name);
  void PlayPointer(const std::string& word);

  std::vector<Key> All;
  vtkRenderWindowInteractor* Source = nullptr;
};

} // namespace NBufferView

#endif
