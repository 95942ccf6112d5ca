// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferPropList
 * @brief Follows a renderer's list of props, and keeps what is known of each prop in its place.
 *
 * A renderer has the same props in the same order in most frames. The list is therefore compared
 * with the last one pointer by pointer, and only a difference costs look-ups. Props are compared as
 * addresses and never dereferenced. This class mistakes a new prop at the address of a deleted one
 * for the old prop; vtkNBufferPropWatch notices the newer modification time.
 *
 * An item, of type T, is what the owner of the list knows of one prop. When the list changes, items
 * move with their props. The item of a new prop is T(prop) or, if there is no such constructor,
 * T(). The items lie side by side in one vector. An owner that keeps more vectors with one element
 * for each prop passes them to Synchronize().
 */
#ifndef vtkNBufferPropList_h
#define vtkNBufferPropList_h

#include "vtkNBufferVTKVersion.h" // For VTK_ABI_NAMESPACE_BEGIN

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;

template <typename T>
class vtkNBufferPropList
{
public:
  /**
   * Follow the renderer: the list becomes `props`, each of which occurs once. Returns whether it
   * differs from the last one. `others` are vectors of the owner with one element for each prop of
   * the last list. They are rearranged like the items of this list.
   */
  template <typename... Others>
  bool Synchronize(vtkProp* const* props, std::size_t count, std::vector<Others>&... others)
  {
    if (this->Props.size() == count && std::equal(this->Props.begin(), this->Props.end(), props))
    {
      return false;
    }
    this->FillPlaces();
    std::vector<int> oldPlaces(count);
    std::transform(
      props, props + count, oldPlaces.begin(), [this](vtkProp* prop) { return this->Find(prop); });
    this->Props.assign(props, props + count);
    this->Places.clear();
    this->Rearrange(oldPlaces, this->Items);
    (this->Rearrange(oldPlaces, others), ...);
    return true;
  }

  std::size_t GetSize() const { return this->Props.size(); }
  const std::vector<vtkProp*>& GetProps() const { return this->Props; }
  vtkProp* GetProp(std::size_t place) const { return this->Props[place]; }

  ///@{
  /// The items, in the order of the list.
  const std::vector<T>& GetItems() const { return this->Items; }
  T& operator[](std::size_t place) { return this->Items[place]; }
  const T& operator[](std::size_t place) const { return this->Items[place]; }
  ///@}

  /// The place of a prop in the list, or -1. Costs one hash look-up; the first one after a change
  /// of the list fills the table.
  int Find(vtkProp* prop) const
  {
    this->FillPlaces();
    const auto found = this->Places.find(prop);
    return found == this->Places.end() ? -1 : found->second;
  }

private:
  void FillPlaces() const
  {
    if (this->Places.empty())
    {
      this->Places.reserve(this->Props.size());
      for (std::size_t i = 0; i < this->Props.size(); ++i)
      {
        this->Places.emplace(this->Props[i], static_cast<int>(i));
      }
    }
  }

  template <typename Item>
  void Rearrange(const std::vector<int>& oldPlaces, std::vector<Item>& items) const
  {
    std::vector<Item> result;
    result.reserve(oldPlaces.size());
    for (std::size_t i = 0; i < oldPlaces.size(); ++i)
    {
      if (oldPlaces[i] >= 0)
      {
        result.push_back(std::move(items[static_cast<std::size_t>(oldPlaces[i])]));
      }
      else if constexpr (std::is_constructible_v<Item, vtkProp*>)
      {
        result.emplace_back(this->Props[i]);
      }
      else
      {
        result.emplace_back();
      }
    }
    items = std::move(result);
  }

  std::vector<vtkProp*> Props;
  std::vector<T> Items;
  mutable std::unordered_map<vtkProp*, int> Places;
};

VTK_ABI_NAMESPACE_END
#endif
