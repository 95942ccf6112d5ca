// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNBufferSharedState
 * @brief Which props share an object in which VTK leaves something from one draw to the next.
 *
 *     object            what VTK leaves in it              two actors use it in the same way with
 *
 *     mapper            the shaders of the first actor     equal settings that select the shaders
 *     lookup table      the range that was set last        the same range, or none to set
 *     array of points   the first mapper's vertex buffer   the same shift of coordinates
 *
 * If all actors use an object in the same way, the order of drawing does not matter. If not, the
 * image depends on the order of drawing and on which actors are drawn at all. Therefore none of the
 * actors that use the object may be held back or left out. If the object is a mapper, no other prop
 * may be held back either in a frame in which one of these actors has changed: an actor that is
 * drawn once more for equal depth would find other shaders.
 *
 * A mapper draws an actor by the shaders of another one, but sets only the parameters that the
 * actor's own settings need: textures, or those of edges. What the shaders read otherwise is what
 * any prop drawn before has left, because texture units and programs belong to the window and all
 * mappers use them. If the actors of a mapper differ in the parameters that they set, no prop of
 * the renderer may be held back or left out.
 */
#ifndef vtkNBufferSharedState_h
#define vtkNBufferSharedState_h

#include "vtkNBufferModule.h" // For export macro
#include "vtkNBufferVTKVersion.h"

#include <array>
#include <cstddef>
#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkInformationDoubleKey;
class vtkMapper;

class VTKNBUFFER_EXPORT vtkNBufferSharedState
{
public:
  /// How an actor uses an object, which may have been deleted if the actor has changed since.
  struct Use
  {
    const void* Object = nullptr; ///< nullptr if the actor uses no such object.
    std::size_t Way = 0;          ///< Equal numbers mean that it is used in the same way.
    bool operator==(const Use& other) const
    {
      return this->Object == other.Object && this->Way == other.Way;
    }
  };

  ///@{
  /// What one actor uses: its mapper twice, the lookup table of its scalars, an array of points,
  /// and the lookup table of a texture. Actors that use the mapper in different ways by the first
  /// number do so by the second one, too.
  static constexpr std::size_t Parameters = 0; ///< Which parameters of the shaders are set.
  static constexpr std::size_t Shaders = 1;    ///< Which shaders are needed.
  static constexpr std::size_t LookupTable = 2;
  static constexpr std::size_t Points = 3;
  static constexpr std::size_t TextureTable = 4;
  using Uses = std::array<Use, 5>;
  ///@}

  /// The uses of an actor whose pipeline is up to date.
  static Uses GetUses(vtkActor* actor);

  ///@{
  /// Collect what all actors use: first call Add() for all actors, and then AddCommon() for all of
  /// them again. Only after the first pass is it known for which objects the second one has to find
  /// out whether they are also used in the common way.
  void Add(const Uses& uses);
  void AddCommon(const Uses& uses);
  ///@}

  ///@{
  /// Whether one of these objects, any of them, or any but the mapper is used in several ways.
  bool IsMixed(const Uses& uses, std::size_t place) const;
  bool IsMixed(const Uses& uses) const;
  bool HasMixedData(const Uses& uses) const;
  ///@}

  /// Whether a mapper may draw by shaders that were made for another way of using it, by `Shaders`
  /// or by `Parameters` (`place`). That is so if its actors use it in several ways (`isMixed`),
  /// which marks the mapper, and afterwards until it has made all its shaders anew.
  static bool HasOtherShaders(vtkMapper* mapper, std::size_t place, bool isMixed);

  /// Whether a mapper with a mark has made all its shaders since its actors use it in the same way.
  /// Not known, and false, for composite data and glyphs.
  static bool HasNewShaders(vtkMapper* mapper);

  /// Mark the mapper of an actor if it goes on with its shaders although the actor no longer sets
  /// all parameters that it set `before`. That is so if the actor has lost its texture or has got
  /// a property that was last modified before the shaders were made. Does nothing for composite
  /// data.
  static void MarkIfShadersStay(vtkActor* actor, const Uses& before);

private:
  ///@{
  /// In the information of a marked mapper: since when it is used in the same way.
  static vtkInformationDoubleKey* OTHER_PARAMETERS();
  static vtkInformationDoubleKey* OTHER_SHADERS();
  ///@}

  struct Entry
  {
    std::size_t Way;
    bool IsMixed;
  };

  /// Textures and scalars share one kind of object.
  static constexpr std::size_t GetKind(std::size_t place)
  {
    return place == TextureTable ? LookupTable : place;
  }

  /// The first use of each kind of object. Its way is the common one: most actors use their mapper
  /// (or table, or points) in this way. `Uncommon` holds the objects that are used in other ways.
  Uses Common;
  std::array<std::unordered_map<const void*, Entry>, std::tuple_size<Uses>::value> Uncommon;
};

VTK_ABI_NAMESPACE_END
#endif
