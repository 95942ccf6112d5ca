// SPDX-FileCopyrightText: Copyright (c) The VTKNBuffer authors
// SPDX-License-Identifier: BSD-3-Clause

// Changes of props; see ChangeKind.
#include "SceneProps.h"

#include "CompositeMapper.h"
#include "LightRig.h"
#include "Shapes.h"

#include "vtkActor.h"
#include "vtkIdTypeArray.h"
#include "vtkMatrix4x4.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkTransformFilter.h"

#include <algorithm>

namespace TestScene
{
namespace
{
/// The data whose points ChangeKind::MovePoints moves, or null.
vtkPolyData* GetData(vtkMapper* mapper)
{
  auto* filter =
    mapper ? vtkTransformFilter::SafeDownCast(mapper->GetInputAlgorithm(0, 0)) : nullptr;
  vtkAlgorithm* user = filter ? static_cast<vtkAlgorithm*>(filter) : mapper;
  vtkDataObject* data = user ? user->GetInputDataObject(0, 0) : nullptr;
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  return vtkPolyData::SafeDownCast(
    blocks ? blocks->GetBlock(std::min(1u, blocks->GetNumberOfBlocks() - 1)) : data);
}

void MovePoints(vtkMapper* mapper, const Change& change)
{
  vtkPolyData* data = GetData(mapper);
  vtkPoints* points = data ? data->GetPoints() : nullptr;
  if (!points)
  {
    return;
  }
  if (GetValue(change, 4) != 0.0)
  {
    points->RemoveAllObservers();
  }
  TestScene::MovePoints(
    points, { GetValue(change, 0), GetValue(change, 1), GetValue(change, 2) }, GetValue(change, 3));
}

void MarkCells(vtkMapper* mapper, int count)
{
  vtkNew<vtkIdTypeArray> ids;
  for (int i = 0; i < count; ++i)
  {
    ids->InsertNextValue(i);
  }
  vtkNew<vtkSelectionNode> node;
  node->SetContentType(vtkSelectionNode::INDICES);
  node->SetFieldType(vtkSelectionNode::CELL);
  node->SetSelectionList(ids);
  vtkNew<vtkSelection> selection;
  selection->AddNode(node);
  mapper->SetSelection(count > 0 ? selection.Get() : nullptr);
}

void ReplaceData(vtkMapper* mapper, const Prop& description, const Change& change)
{
  auto* plain = vtkPolyDataMapper::SafeDownCast(mapper);
  if (plain && description.Kind != PropKind::Composite)
  {
    Prop other = description;
    other.Shape.Size = { GetValue(change, 0), GetValue(change, 1), GetValue(change, 2) };
    SetInput(plain, other, GetValue(change, 3) != 0.0);
  }
}

void ChangeActor(vtkActor* actor, const Prop& description, const Change& change)
{
  vtkProperty* property = actor->GetProperty();
  vtkMapper* mapper = actor->GetMapper();
  const double value = GetValue(change, 0);
  switch (change.Kind)
  {
    case ChangeKind::Color:
      property->SetColor(value, GetValue(change, 1), GetValue(change, 2));
      break;
    case ChangeKind::Opacity:
      property->SetOpacity(value);
      break;
    case ChangeKind::Representation:
      property->SetRepresentation(static_cast<int>(value));
      break;
    case ChangeKind::LineWidth:
      property->SetLineWidth(static_cast<float>(value));
      property->SetPointSize(static_cast<float>(value));
      break;
    case ChangeKind::Edges:
      property->SetEdgeVisibility(value != 0.0);
      break;
    case ChangeKind::MovePoints:
      if (description.Kind == PropKind::Actor || description.Kind == PropKind::Piped ||
        description.Kind == PropKind::Glyphs || description.Kind == PropKind::Composite)
      {
        MovePoints(mapper, change);
      }
      break;
    case ChangeKind::ReplaceData:
      ReplaceData(mapper, description, change);
      break;
    case ChangeKind::BlockVisible:
      if (auto* composite = CompositeMapper::SafeDownCast(mapper))
      {
        composite->SetBlockVisibility(2, value != 0.0);
      }
      break;
    case ChangeKind::BlockOpacity:
      if (auto* composite = CompositeMapper::SafeDownCast(mapper))
      {
        composite->SetBlockOpacity(2, value);
      }
      break;
    case ChangeKind::CulledFaces:
      property->SetFrontfaceCulling(value == 1.0);
      property->SetBackfaceCulling(value == 2.0);
      break;
    case ChangeKind::MarkedCells:
      if (mapper)
      {
        MarkCells(mapper, static_cast<int>(value));
        property->SetSelectionColor(1.0, 0.0, 0.0, 1.0 - GetValue(change, 1));
      }
      break;
    case ChangeKind::ClippingPlane:
      if (mapper && mapper->GetClippingPlanes())
      {
        mapper->GetClippingPlanes()->GetItem(0)->SetOrigin(
          value, GetValue(change, 1), GetValue(change, 2));
      }
      break;
    default:
      break;
  }
}
}

void ChangeProp(vtkProp* prop, const Prop& description, const Change& change)
{
  double values[3] = { GetValue(change, 0), GetValue(change, 1), GetValue(change, 2) };
  if (change.Kind == ChangeKind::Visible)
  {
    prop->SetVisibility(values[0] != 0.0);
  }
  else if (change.Kind == ChangeKind::Casts)
  {
    LightRig::SetCasts(prop, values[0] != 0.0);
  }
  else if (auto* prop3D = vtkProp3D::SafeDownCast(prop))
  {
    switch (change.Kind)
    {
      case ChangeKind::Position:
        prop3D->SetPosition(values);
        break;
      case ChangeKind::Orientation:
        prop3D->SetOrientation(values);
        break;
      case ChangeKind::Scale:
        prop3D->SetScale(values);
        break;
      case ChangeKind::UserMatrix:
        // In place, if there is one: the actor is not modified then.
        if (prop3D->GetUserMatrix() && change.Values.size() == 16)
        {
          prop3D->GetUserMatrix()->DeepCopy(change.Values.data());
        }
        else
        {
          SetMatrix(prop3D, change.Values);
        }
        break;
      default:
        if (auto* actor = vtkActor::SafeDownCast(prop))
        {
          ChangeActor(actor, description, change);
        }
        break;
    }
  }
}
}
